//! Header of the `MOTION` section: frame count and frame time.

use crate::bvh::error::location;
use crate::bvh::frame_time::StatedFrameTime;
use crate::bvh::layout::Layout;
use crate::bvh::lines::Line;
use crate::bvh::number::{DecimalMark, Decimals};
use crate::bvh::repairs::{Repair, Repairs};
use crate::bvh::{Error, number};
use crate::notice::{Code, Location, Notice, shortened};

/// Frame time if the file states none or an implausible one, in seconds.
const DEFAULT_FRAME_TIME: f64 = 1.0 / 30.0;

/// Accepted frame times, in seconds: 10 kHz to 1 Hz.
const PLAUSIBLE_FRAME_TIME: std::ops::RangeInclusive<f64> = 1e-4..=1.0;

/// Frame count and frame time as stated in the file.
#[derive(Debug, Default)]
pub(super) struct MotionHeader {
    /// Number of frames, if it is a whole number.
    pub frames: Option<usize>,
    /// Text from which `frames` was read.
    frames_text: Option<Statement>,
    /// Frame time, in seconds, plausible or not.
    pub frame_time: Option<f64>,
    /// Text from which `frame_time` was read.
    frame_time_text: Option<Statement>,
}

/// What reading the header changes as well.
pub(super) struct HeaderContext<'a> {
    pub decimals: &'a mut Decimals,
    pub layout: &'a mut Layout,
    pub repairs: &'a mut Repairs,
}

/// Text after `Frames:` or `Frame Time:`, which may be empty.
#[derive(Debug)]
struct Statement {
    text: String,
    /// Location of the first such statement on the line.
    location: Location,
}

impl Statement {
    /// Replaces the statement `old` by the `len` bytes at `at`.
    fn replace(old: &mut Option<Statement>, line: usize, text: &[u8], at: usize, len: usize) {
        // Locating each of many statements on one line would take quadratic time.
        let location = match old {
            Some(old) if old.location.line == line => old.location,
            _ => location(line, text, at),
        };
        let stated = String::from_utf8_lossy(&text[at..at + len]);
        *old = Some(Statement { text: shortened(&stated).into_owned(), location });
    }
}

impl MotionHeader {
    /// Reads `Frames:` and `Frame Time:` and returns the byte index after them.
    pub fn read(
        &mut self,
        line: Line<'_>,
        mut at: usize,
        context: &mut HeaderContext<'_>,
    ) -> Result<usize, Error> {
        let text = line.text;
        while let Some((code, len)) = keyword(&text[at..]) {
            at = number::skip_blanks(text, at + len);
            let len = match code {
                Code::FrameTime => self.read_frame_time(line, at, context)?,
                _ => self.read_frames(line, at, context),
            };
            at = number::skip_blanks(text, at + len);
            at += unused_text(line, at, code, context.repairs);
        }
        Ok(at)
    }

    /// Reads the number after `Frames:` and returns its length.
    fn read_frames(
        &mut self,
        Line { number: line, start, text }: Line<'_>,
        at: usize,
        context: &mut HeaderContext<'_>,
    ) -> usize {
        let number = number::parse_leading(&text[at..]);
        let len = number.map_or_else(|| number::word(&text[at..]).len(), |number| number.len);
        // A comma separates thousands.
        let is_count = |number: &number::Number| {
            number.value >= 0.0 && number.value.fract() == 0.0 && number.mark != DecimalMark::Comma
        };
        let count = number.filter(is_count).map(|number| number.value as usize);
        if self.frames_text.is_some() && count != self.frames {
            let repair = Repair::SecondStatement { code: Code::FrameCount };
            context.repairs.add(repair, || location(line, text, at));
        }
        self.frames = count;
        Statement::replace(&mut self.frames_text, line, text, at, len);
        let start = start + at as u64;
        context.layout.frame_count = number.map(|_| start..start + len as u64);
        len
    }

    /// Reads the frame time and its unit, and returns their length.
    fn read_frame_time(
        &mut self,
        Line { number: line, start, text }: Line<'_>,
        at: usize,
        context: &mut HeaderContext<'_>,
    ) -> Result<usize, Error> {
        let stated = StatedFrameTime::parse(&text[at..]);
        let seconds = stated.map(|stated| stated.seconds);
        let len = stated.map_or_else(|| number::word(&text[at..]).len(), |stated| stated.len);
        if self.frame_time_text.is_some() && seconds != self.frame_time {
            let repair = Repair::SecondStatement { code: Code::FrameTime };
            context.repairs.add(repair, || location(line, text, at));
        }
        self.frame_time = seconds;
        Statement::replace(&mut self.frame_time_text, line, text, at, len);
        let Some(stated) = stated else { return Ok(len) };
        context.decimals.record(stated.mark, line, text, at)?;
        if stated.has_unit && PLAUSIBLE_FRAME_TIME.contains(&stated.seconds) {
            let found = String::from_utf8_lossy(&text[at..at + stated.len]).into_owned();
            let repair = Repair::FrameTimeUnit { found, seconds: stated.seconds };
            context.repairs.add(repair, || location(line, text, at));
        }
        let start = start + at as u64;
        context.layout.frame_time_text = Some(start..start + len as u64);
        Ok(len)
    }

    /// Returns a notice if the file states another number of frames than it has, or none.
    pub fn frame_count_notice(&self, frames: usize) -> Option<Notice> {
        let stated = self.frames_text.as_ref();
        let text = match (self.frames, stated.map(|stated| stated.text.as_str())) {
            (Some(declared), _) if declared == frames => return None,
            (None, _) if frames == 0 => return None,
            (Some(_), Some(text)) => {
                format!("The file states {text} frames and has {frames}; the frames present are used.")
            }
            (_, None | Some("")) => format!("The file does not state the number of frames; it has {frames}."),
            (None, Some(text)) => {
                format!("The number of frames is stated as {text:?}; the file has {frames}.")
            }
        };
        Some(Notice { code: Code::FrameCount, location: stated.map(|stated| stated.location), text })
    }

    /// Returns the frame time, in seconds, and a notice if it is not the stated one.
    pub fn used_frame_time(&self) -> (f64, Option<Notice>) {
        if let Some(time) = self.frame_time
            && PLAUSIBLE_FRAME_TIME.contains(&time)
        {
            return (time, None);
        }
        let stated = self.frame_time_text.as_ref();
        let finding = match stated.map(|stated| stated.text.as_str()) {
            None | Some("") => "The file does not state a frame time".into(),
            Some(text) => format!("The stated frame time {text:?} is not plausible"),
        };
        let text = format!("{finding}; 30 frames per second are used. Set the frame rate if you know it.");
        let location = stated.map(|stated| stated.location);
        (DEFAULT_FRAME_TIME, Some(Notice { code: Code::FrameTime, location, text }))
    }
}

/// Returns the quantity that `text` begins to state, and the length of the keyword.
fn keyword(text: &[u8]) -> Option<(Code, usize)> {
    let time = match_words(text, &["frame", "time"]).map(|len| (Code::FrameTime, len));
    time.or_else(|| match_words(text, &["frames"]).map(|len| (Code::FrameCount, len)))
}

/// Returns the length of text in the header that is neither a number nor a statement nor a comment, and
/// adds a notice about it.
fn unused_text(
    Line { number: line, text, .. }: Line<'_>,
    at: usize,
    code: Code,
    repairs: &mut Repairs,
) -> usize {
    let rest = &text[at..];
    let is_used = rest.is_empty()
        || number::is_comment(rest)
        || number::parse_leading(rest).is_some()
        || keyword(rest).is_some();
    if is_used {
        return 0;
    }
    let found: String = String::from_utf8_lossy(rest).trim_end().chars().take(40).collect();
    repairs.add(Repair::UnusedText { found, code }, || location(line, text, at));
    rest.len()
}

/// True if a line before the first frame is a misspelled or unknown statement, such as `Frame: 2`.
pub(super) fn is_statement(text: &[u8]) -> bool {
    let word = number::word(text).to_ascii_lowercase();
    let is_keyword = b"frames".starts_with(&word[..]) || word.starts_with(b"frame") || word == b"motion";
    let is_assignment = text.iter().any(|&byte| byte == b':' || byte == b'=');
    is_keyword || is_assignment && word[0].is_ascii_alphabetic()
}

/// Returns the length of `words`, in any case and separated by blanks, and a following colon, if
/// `text` begins with them.
fn match_words(text: &[u8], words: &[&str]) -> Option<usize> {
    let mut at = 0;
    for word in words {
        at = number::skip_blanks(text, at);
        let end = at + word.len();
        if !text.get(at..end)?.eq_ignore_ascii_case(word.as_bytes()) {
            return None;
        }
        at = end;
    }
    let colon = number::skip_blanks(text, at);
    if text.get(colon) == Some(&b':') { Some(colon + 1) } else { (colon > at).then_some(colon) }
}
