//! Writer of changed clips that preserves the text of the file.

use std::ops::Range;
use std::sync::Arc;

use crate::bvh::encoding::Decoder;
use crate::bvh::layout::Layout;
use crate::bvh::number;
use crate::bvh::reader::position_rule;
use crate::bvh::writer::offset_shift;
use crate::bvh::{Channel, Clip};
use crate::numeric::sort;

/// Bytes of a file in memory that are rewritten at a time; the text of a chunk is copied.
const CHUNK_BYTES: usize = 1 << 20;
/// Decimal places of changed numbers in a file that has integers only.
const DEFAULT_DECIMALS: u8 = 6;
/// Maximum number of decimal places of changed numbers; a double has about as many significant digits.
const MAX_DECIMALS: u8 = 17;

/// Writes a clip that was read from a file and changed, chunk by chunk.
///
/// The bytes of the file are copied: names in any encoding, comments, blanks, line ends and all
/// numbers that read as the value to be written. Other numbers get as many decimals as the file has
/// for positions or rotations. Values that were not numbers are replaced by those that were read.
///
/// Writes either all frames and what follows them, or a range of the frames without it; `Frames:`
/// then states their number.
#[derive(Debug)]
pub struct Rewriter {
    layout: Arc<Layout>,
    clip: Arc<Clip>,
    frames: Range<usize>,
    decoder: Decoder,
    /// Decoded text that has not been written.
    text: Vec<u8>,
    /// Byte index of `text` in the whole text.
    start: u64,
    /// Next frame of the file; `None` within the header.
    next: Option<usize>,
    /// Decimal places of changed numbers, by channel.
    decimals: Vec<u8>,
    /// Values to add to the channels, by channel.
    shift: Vec<f64>,
}

/// Error: a changed clip is written from another file than it was read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the file is shorter than the one that the clip was read from; pass the same bytes")]
pub struct OtherFile;

/// Writes a clip that was read from the file `bytes` and changed; see [`Rewriter`].
///
/// # Panics
/// See [`Rewriter::new`]; also if `bytes` are those of a shorter file.
pub fn rewrite(bytes: &[u8], layout: &Arc<Layout>, clip: &Arc<Clip>, frames: Range<usize>) -> Vec<u8> {
    let mut rewriter = Rewriter::new(layout.clone(), clip.clone(), frames);
    let mut written = Vec::with_capacity(bytes.len());
    for chunk in bytes.chunks(CHUNK_BYTES) {
        written.append(&mut rewriter.push(chunk));
    }
    written.append(&mut rewriter.finish().expect("the bytes are those of the layout"));
    written
}

impl Rewriter {
    /// Creates a writer of the frames `frames` of `clip`, whose skeleton and number of frames are those
    /// of the file with the layout `layout`.
    ///
    /// # Panics
    /// If `clip` has another number of frames or channels than the file, or fewer than `frames`.
    pub fn new(layout: Arc<Layout>, clip: Arc<Clip>, frames: Range<usize>) -> Rewriter {
        assert_eq!(clip.frame_count(), layout.frames.len(), "frames of the clip and of the file");
        assert_eq!(clip.channel_count(), layout.decimals.len(), "channels of the clip and of the file");
        assert!(
            frames.start <= frames.end && frames.end <= clip.frame_count(),
            "{frames:?} exceeds the clip"
        );
        // The file is read with the rule that its values suggest.
        let shift = match position_rule(&clip) == clip.position_rule() {
            true => vec![0.0; clip.channel_count()],
            false => offset_shift(&clip),
        };
        let decimals = decimals_by_channel(&clip, &layout);
        Rewriter {
            layout,
            clip,
            frames,
            decoder: Decoder::default(),
            text: Vec::new(),
            start: 0,
            next: None,
            decimals,
            shift,
        }
    }

    /// Reads the next chunk of the file and returns the next part of the result.
    pub fn push(&mut self, chunk: &[u8]) -> Vec<u8> {
        self.text.extend_from_slice(self.decoder.decode(chunk));
        self.write(false)
    }

    /// Ends the file and returns the last part of the result.
    ///
    /// # Errors
    /// If the file is shorter than that of the layout. Another file of the same length or longer is not
    /// noticed, and its result is meaningless.
    pub fn finish(mut self) -> Result<Vec<u8>, OtherFile> {
        let rest = self.decoder.finish().to_vec();
        self.text.extend_from_slice(&rest);
        let end = self.start + self.text.len() as u64;
        let Layout { frames, frames_end, .. } = &*self.layout;
        if frames.last().max(frames_end.as_ref()).is_some_and(|&last| end < last) {
            return Err(OtherFile);
        }
        Ok(self.write(true))
    }

    /// Writes all complete frames of the text, or all of it at the end of the file.
    fn write(&mut self, is_end: bool) -> Vec<u8> {
        let mut written = Vec::with_capacity(self.text.len());
        let mut bytes = Vec::new();
        let end = self.start + self.text.len() as u64;
        let mut at = self.start;
        if self.next.is_none() {
            let header_end = self.layout.frames.first().copied().unwrap_or(end);
            if (header_end > end || self.layout.frames.is_empty()) && !is_end {
                return Vec::new();
            }
            self.decoder.encode_bom(&mut bytes);
            self.write_header(&self.text[..(header_end - at) as usize], &mut written);
            at = header_end;
            self.next = Some(0);
        }
        while let Some(frame) = self.next.filter(|&frame| frame < self.layout.frames.len()) {
            let frame_end =
                self.layout.frames.get(frame + 1).copied().or(self.layout.frames_end).unwrap_or(end);
            if frame_end > end {
                break;
            }
            if self.frames.contains(&frame) {
                let text = &self.text[(at - self.start) as usize..(frame_end - self.start) as usize];
                self.write_frame(text, frame, &mut written);
            }
            at = frame_end;
            self.next = Some(frame + 1);
        }
        if self.next == Some(self.layout.frames.len()) {
            if self.is_whole() {
                written.extend_from_slice(&self.text[(at - self.start) as usize..]);
            }
            at = end;
        }
        self.text.drain(..(at - self.start) as usize);
        self.start = at;
        self.decoder.encode(&written, &mut bytes);
        bytes
    }

    /// True if all frames are written.
    fn is_whole(&self) -> bool {
        self.frames == (0..self.layout.frames.len())
    }

    /// Writes the text before the first frame, with the number of frames and the frame time.
    fn write_header(&self, text: &[u8], written: &mut Vec<u8>) {
        let Layout { frame_count, frame_time_text, .. } = &*self.layout;
        let count = frame_count.clone().filter(|_| !self.is_whole());
        let count = count.map(|range| (range, self.frames.len().to_string()));
        let time = (self.clip.frame_time() != self.layout.frame_time)
            .then(|| self.with_decimal_mark(self.clip.frame_time().to_string()));
        let line_end = || match text {
            [.., b'\r', b'\n'] => "\r\n",
            [.., b'\r'] => "\r",
            _ => "\n",
        };
        let time = time.map(|time| match frame_time_text {
            Some(range) => (range.clone(), time),
            None => (text.len() as u64..text.len() as u64, format!("Frame Time: {time}{}", line_end())),
        });
        let changes: Vec<(Range<u64>, String)> = count.into_iter().chain(time).collect();
        let changes = sort::sort_by_frames(changes, |(range, _)| (range.start as usize, 0));
        let mut copied = 0;
        for (range, number) in changes {
            written.extend_from_slice(&text[copied..range.start as usize]);
            written.extend_from_slice(number.as_bytes());
            copied = range.end as usize;
        }
        written.extend_from_slice(&text[copied..]);
    }

    /// Writes the lines of a frame.
    fn write_frame(&self, text: &[u8], frame: usize, written: &mut Vec<u8>) {
        let mut values = self.clip.row(frame).iter().zip(&self.shift).map(|(value, shift)| value + shift);
        let mut decimals = self.decimals.iter();
        let mut copied = 0;
        let mut line_start = 0;
        while line_start < text.len() {
            let is_line_end = |&byte: &u8| matches!(byte, b'\n' | b'\r');
            let line_end =
                text[line_start..].iter().position(is_line_end).map_or(text.len(), |len| line_start + len);
            let line = &text[..line_end];
            let mut at = number::skip_blanks(line, line_start);
            while at < line_end && !number::is_comment(&line[at..]) {
                let (Some(value), Some(&decimals)) = (values.next(), decimals.next()) else { break };
                let number = number::parse_leading(&line[at..]);
                let len = number.map_or_else(|| number::word(&line[at..]).len(), |number| number.len);
                if number.is_none_or(|number| number.value != value) {
                    let new = format!("{value:.*}", decimals.into());
                    // The same number with other digits preserves its text.
                    if number.is_none_or(|number| new.parse() != Ok(number.value)) {
                        written.extend_from_slice(&text[copied..at]);
                        let follows_number = at > line_start && !number::is_blank(line[at - 1]);
                        if follows_number && !new.starts_with('-') {
                            written.push(b' ');
                        }
                        written.extend_from_slice(self.with_decimal_mark(new).as_bytes());
                        copied = at + len;
                    }
                }
                at = number::skip_blanks(line, at + len);
            }
            line_start = line_end + 1;
        }
        written.extend_from_slice(&text[copied..]);
    }

    fn with_decimal_mark(&self, number: String) -> String {
        if self.layout.has_decimal_commas { number.replace('.', ",") } else { number }
    }
}

/// Returns the decimal places of changed numbers: as many as any position, rotation or scale of the
/// file has. Kinds with integers only have as many as the others.
fn decimals_by_channel(clip: &Clip, layout: &Layout) -> Vec<u8> {
    let kind = |channel: &Channel| match channel {
        Channel::Position(_) => 0,
        Channel::Rotation(_) => 1,
        Channel::Scale(_) => 2,
    };
    let channels = || clip.joints().iter().flat_map(|joint| joint.channels.iter().map(kind));
    let mut by_kind = [0; 3];
    for (kind, &decimals) in channels().zip(&layout.decimals) {
        by_kind[kind] = decimals.max(by_kind[kind]);
    }
    let largest = by_kind.into_iter().max().filter(|&decimals| decimals > 0).unwrap_or(DEFAULT_DECIMALS);
    let by_kind = by_kind.map(|decimals| if decimals > 0 { decimals } else { largest }.min(MAX_DECIMALS));
    channels().map(|kind| by_kind[kind]).collect()
}

#[cfg(test)]
mod tests {
    use encoding_rs::{EUC_KR, Encoding, GBK, SHIFT_JIS, UTF_8, WINDOWS_1252};
    use proptest::prelude::*;
    use proptest::sample::{Index, select};

    use super::*;
    use crate::bvh::{Options, Parsed, Reader, parse};

    fn read(bytes: &[u8]) -> Parsed {
        parse(bytes, Options::default())
            .unwrap_or_else(|error| panic!("{error}\n{}", String::from_utf8_lossy(bytes)))
    }

    /// Returns the clip with other values.
    fn with_values(clip: &Clip, values: Vec<f64>) -> Arc<Clip> {
        let changed = Clip::new(clip.joints().to_vec(), clip.frame_time(), values);
        Arc::new(changed.with_position_rule(clip.position_rule()))
    }

    /// Rewrites a file after one value of it, given by its text, has been changed.
    fn replace(file: &str, from: f64, to: f64) -> String {
        let Parsed { clip, layout, .. } = read(file.as_bytes());
        let values = clip.values().iter().map(|&value| if value == from { to } else { value }).collect();
        let frames = 0..clip.frame_count();
        String::from_utf8(rewrite(file.as_bytes(), &layout, &with_values(&clip, values), frames)).unwrap()
    }

    const HEAD: &str =
        "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 4 Xposition Yposition Zrotation Xrotation\n}\nMOTION\n";

    #[test]
    fn changed_numbers_have_the_decimals_of_their_kind() {
        for (row, to, expected) in [
            ("1.5 2 3.0000 77", 0.123456, "1.5 2 3.0000 0.1235"),
            ("1.5 77 3.0000 4", -2.0, "1.5 -2.0 3.0000 4"),
            ("1 77 3.25 4", 0.123456, "1 0.12 3.25 4"),
            ("1 2 3 77", 0.5, "1 2 3 0.500000"),
            ("1.5e-3 77 3 4", 0.123456, "1.5e-3 0.1235 3 4"),
            ("1.5 2.5 77.0 4.0", 77.04, "1.5 2.5 77.0 4.0"),
            ("1.5 2.5-77.0 4.0", 3.0, "1.5 2.5-77.0 4.0"),
            ("1,5 2 3,25 77", 0.5, "1,5 2 3,25 0,50"),
        ] {
            let file = format!("{HEAD}Frames: 1\nFrame Time: 1\n{row}\n");
            assert_eq!(replace(&file, 77.0, to), file.replace(row, expected));
        }
    }

    #[test]
    fn numbers_run_together_stay_apart() {
        let file = format!("{HEAD}Frames: 1\nFrame Time: 1\n1.5-77.0-2.5 3.0\n");
        assert_eq!(replace(&file, -77.0, 4.0), file.replace("-77.0", " 4.0"));
        assert_eq!(replace(&file, -77.0, -4.0), file.replace("-77.0", "-4.0"));
    }

    #[test]
    fn values_that_were_held_are_written() {
        let file = format!("{HEAD}Frames: 2\nFrame Time: 1\n1 2.5 3 4\n1 nan 3 4\n");
        let Parsed { clip, layout, .. } =
            parse(file.as_bytes(), Options { lenient: true, ..Options::default() }).unwrap();
        let written = rewrite(file.as_bytes(), &layout, &Arc::new(clip), 0..2);
        assert_eq!(String::from_utf8(written).unwrap(), file.replace("nan", "2.5"));
    }

    #[test]
    fn a_range_of_frames_has_the_header_and_their_lines() {
        let header = format!("\u{feff}# mine\r\n{HEAD}Frames:\t3 # all\r\nFrame Time: 0.04 s\r\n");
        let rows = ["1 2 3 4\r\n", "# second\r\n", "  5.50 6\r\n7 8\r\n", " 9 10 11 12 13\r\n"];
        let file = format!("{header}{}\r\nend\r\n", rows.concat());
        let Parsed { clip, layout, .. } = read(file.as_bytes());
        let clip = Arc::new(clip);
        let write = |frames| String::from_utf8(rewrite(file.as_bytes(), &layout, &clip, frames)).unwrap();
        assert_eq!(write(0..3), file);
        let header = |count: &str| header.replace("3 # all", &format!("{count} # all"));
        assert_eq!(write(0..1), header("1") + rows[0] + rows[1]);
        assert_eq!(write(1..3), header("2") + rows[2] + rows[3]);
        assert_eq!(write(1..1), header("0"));
    }

    #[test]
    fn another_frame_time_is_written() {
        for (time, expected) in [
            ("Frame Time: 0.04\r\n", "Frame Time: 0.025\r\n"),
            ("Frame Time:\t25 fps # rate\r\n", "Frame Time:\t0.025 # rate\r\n"),
            ("", "Frame Time: 0.025\r\n"),
        ] {
            let file = format!("{HEAD}{time}Frames: 1\r\n1 2 3 4");
            let Parsed { mut clip, layout, .. } = read(file.as_bytes());
            let same = rewrite(file.as_bytes(), &layout, &Arc::new(clip.clone()), 0..1);
            assert_eq!(same, file.as_bytes());
            clip.set_frame_time(0.025);
            let written =
                String::from_utf8(rewrite(file.as_bytes(), &layout, &Arc::new(clip), 0..1)).unwrap();
            let expected = match time {
                "" => format!("{HEAD}Frames: 1\r\n{expected}1 2 3 4"),
                _ => file.replace(time, expected),
            };
            assert_eq!(written, expected);
        }
    }

    #[test]
    fn added_positions_become_part_of_the_channels_once_they_are_large() {
        let file = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 0\nJOINT b\n{\nOFFSET 0 5 0\nCHANNELS 3 Xposition \
                    Yposition Zposition\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.01\n0.0 0.001 0.0\n";
        assert_eq!(replace(file, 0.001, 0.0), file.replace("0.001", "0.000"));
        assert_eq!(replace(file, 0.001, 1.0), file.replace("0.001", "6.000"));
    }

    /// One part of a file.
    #[derive(Clone, Debug)]
    enum Piece {
        Bytes(Vec<u8>),
        /// A channel value as written.
        Value(String),
    }

    #[derive(Clone, Debug)]
    struct TestFile {
        pieces: Vec<Piece>,
        /// Frames that the file has; each has two positions and three rotations.
        frames: usize,
        utf16: Option<(bool, bool)>,
    }

    impl TestFile {
        /// Returns the bytes with the values replaced for which `value` returns another text.
        fn bytes(&self, value: impl Fn(usize, &str) -> Option<String>) -> Vec<u8> {
            let mut index = 0;
            let mut bytes = Vec::new();
            for piece in &self.pieces {
                match piece {
                    Piece::Bytes(piece) => bytes.extend_from_slice(piece),
                    Piece::Value(text) => {
                        let text = value(index, text).unwrap_or_else(|| text.clone());
                        bytes.extend_from_slice(text.as_bytes());
                        index += 1;
                    }
                }
            }
            let Some((big_endian, bom)) = self.utf16 else { return bytes };
            let text = String::from_utf8(bytes).unwrap();
            let units = bom.then_some(0xfeff).into_iter().chain(text.encode_utf16());
            units
                .flat_map(|unit: u16| if big_endian { unit.to_be_bytes() } else { unit.to_le_bytes() })
                .collect()
        }

        fn values(&self) -> Vec<&str> {
            let values = self.pieces.iter().filter_map(|piece| match piece {
                Piece::Value(text) => Some(text.as_str()),
                Piece::Bytes(_) => None,
            });
            values.collect()
        }
    }

    /// Generates files in all encodings with varied spacing, comments, line ends, decimals and wrapped rows.
    fn any_file() -> impl Strategy<Value = TestFile> {
        const NAMES: &[(&Encoding, &[&str])] = &[
            (UTF_8, &["Hips", "左足", "Hüfte", "Finger #2", "mixamorig:Left Foot"]),
            (SHIFT_JIS, &["ボーン", "左足", "センター"]),
            (GBK, &["骨盆", "左脚趾"]),
            (EUC_KR, &["골반", "왼쪽발"]),
            (WINDOWS_1252, &["Hüfte", "Fuß_links"]),
        ];
        let names = select(NAMES)
            .prop_flat_map(|(encoding, names)| (Just(encoding), prop::array::uniform3(select(names))));
        let blank = || select(&[" ", "  ", "\t", " \t "][..]);
        let end =
            || select(&["\n", "\r\n", "\r", " \n", "\n\n", " # note\n", "\t// 1 2 3\r\n", "\n# 4 5 6\n"][..]);
        let format = (0_usize..8, 0_usize..8, select(&["fixed", "short", "exponent"][..]));
        let frame = (
            prop::array::uniform5(-500.0..500.0_f64),
            prop::option::weighted(0.2, 1_usize..5),
            blank(),
            end(),
        );
        let frames = prop::collection::vec(frame, 0..6);
        let tail = select(&["", "\n", "end of file", "7 8\n", "HIERARCHY\nROOT again\n{\n}\n"][..]);
        let utf16 = prop::option::weighted(0.2, any::<(bool, bool)>());
        let spacing = (prop::array::uniform4(blank()), prop::array::uniform9(end()), any::<bool>());
        (names, spacing, format, frames, tail, utf16).prop_map(
            |(names, spacing, format, frames, tail, utf16)| {
                let (blanks, ends, has_time) = spacing;
                let (positions, rotations, style) = format;
                let mut header = Vec::new();
                let mut add = |text: &[&[u8]]| header.extend(text.concat());
                let [b0, b1, b2, b3] = blanks.map(str::as_bytes);
                let [e0, e1, e2, e3, e4, e5, e6, e7, e8] = ends.map(str::as_bytes);
                // UTF-16 is converted from UTF-8.
                let (encoding, names) = names;
                let encoding = if utf16.is_some() { UTF_8 } else { encoding };
                let names = names.map(|name| encoding.encode(name).0);
                add(&[b"HIERARCHY", e0, b"ROOT", b0, &names[0], e1, b"{", e2, b1, b"OFFSET 0.10 1.0 0", e3]);
                add(&[b"CHANNELS", b2, b"5 Xposition Yposition Zrotation Xrotation Yrotation", e4]);
                add(&[b1, b"JOINT", b3, &names[1], e5, b"{", e3, b"OFFSET 1 2 3", e6, b"CHANNELS 0", e1]);
                add(&[b"End Site", b0, &names[2], e2, b"{ OFFSET 0 0 0 } }", e6, b"}", e4, b"MOTION", e7]);
                add(&[b"Frames:", b3, frames.len().to_string().as_bytes(), e8]);
                if has_time {
                    add(&[b"Frame Time:", b2, b"0.0333", e0]);
                }
                let mut pieces = vec![Piece::Bytes(header)];
                for (values, wrapped, blank, end) in &frames {
                    for (channel, value) in values.iter().enumerate() {
                        if channel > 0 {
                            let separator = if Some(channel) == *wrapped { end } else { blank };
                            pieces.push(Piece::Bytes(separator.as_bytes().to_vec()));
                        }
                        let decimals = if channel < 2 { positions } else { rotations };
                        let text = match style {
                            "fixed" => format!("{value:.decimals$}"),
                            "short" => format!("{value:.decimals$}").parse::<f64>().unwrap().to_string(),
                            _ => format!("{value:.decimals$e}"),
                        };
                        pieces.push(Piece::Value(text));
                    }
                    pieces.push(Piece::Bytes(end.as_bytes().to_vec()));
                }
                pieces.push(Piece::Bytes(tail.as_bytes().to_vec()));
                TestFile { pieces, frames: frames.len(), utf16 }
            },
        )
    }

    proptest! {
        #[test]
        fn unchanged_clips_keep_every_byte(file in any_file(), chunk in 1_usize..200) {
            let bytes = file.bytes(|_, _| None);
            let Parsed { clip, layout, .. } = read(&bytes);
            prop_assert_eq!(clip.frame_count(), file.frames);
            let clip = Arc::new(clip);
            prop_assert_eq!(&rewrite(&bytes, &layout, &clip, 0..file.frames), &bytes);
            let mut reader = Reader::new(Options::default());
            let mut rewriter = Rewriter::new(layout.clone(), clip, 0..file.frames);
            let mut written = Vec::new();
            for chunk in bytes.chunks(chunk) {
                reader.push(chunk).unwrap();
                written.append(&mut rewriter.push(chunk));
            }
            prop_assert_eq!(reader.finish().unwrap().layout, layout);
            written.append(&mut rewriter.finish().unwrap());
            prop_assert_eq!(&written, &bytes);
        }

        #[test]
        fn only_changed_numbers_change(
            file in any_file(),
            changes in prop::collection::vec((any::<Index>(), -500.0..500.0_f64), 0..9),
        ) {
            let bytes = file.bytes(|_, _| None);
            let Parsed { clip, layout, .. } = read(&bytes);
            let texts = file.values();
            let mut values = clip.values().to_vec();
            for (index, value) in changes.iter().filter(|_| !texts.is_empty()) {
                values[index.index(texts.len())] = *value;
            }
            let decimals_of = |text: &str| {
                let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
                let places = mantissa.split_once('.').map_or(0, |(_, places)| places.len()) as i64;
                (places - power.parse::<i64>().unwrap()).max(0) as usize
            };
            let is_position = |index: usize| index % 5 < 2;
            let max = |of: &dyn Fn(usize) -> bool| {
                let places = texts.iter().enumerate().filter(|(index, _)| of(*index));
                places.map(|(_, text)| decimals_of(text)).max().filter(|&places| places > 0)
            };
            let expected = file.bytes(|index, text| {
                let of_kind = max(&|other| is_position(other) == is_position(index));
                let places = of_kind.or_else(|| max(&|_| true)).unwrap_or(6);
                let value = values[index];
                let new = format!("{value:.places$}");
                (value != text.parse::<f64>().unwrap() && new.parse::<f64>() != text.parse()).then_some(new)
            });
            let changed = with_values(&clip, values);
            let written = rewrite(&bytes, &layout, &changed, 0..file.frames);
            prop_assert_eq!(String::from_utf8_lossy(&written), String::from_utf8_lossy(&expected));
            prop_assert_eq!(&written, &expected);
            let back = read(&written).clip;
            prop_assert_eq!(back.joints(), clip.joints());
        }

        #[test]
        fn ranges_read_back(file in any_file(), ends in any::<[Index; 2]>()) {
            let bytes = file.bytes(|_, _| None);
            let Parsed { clip, layout, .. } = read(&bytes);
            let [a, b] = ends.map(|end| end.index(file.frames + 1));
            let frames = a.min(b)..a.max(b);
            let slice = clip.slice(frames.clone());
            let written = rewrite(&bytes, &layout, &Arc::new(clip), frames);
            prop_assert_eq!(read(&written).clip, slice);
        }
    }
}
