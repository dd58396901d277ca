//! The `MOTION` section: frame count, frame time and rows of values.

use crate::bvh::error::location;
use crate::bvh::number::Decimals;
use crate::bvh::{Error, ErrorKind, Joint, Options, fast_row, number};
use crate::notice::{Code, Location, Notice};

/// Frame time if the file states none or an implausible one, in seconds.
const DEFAULT_FRAME_TIME: f64 = 1.0 / 30.0;

/// Accepted frame times, in seconds: 10 kHz to 1 Hz.
const PLAUSIBLE_FRAME_TIME: std::ops::RangeInclusive<f64> = 1e-4..=1.0;

/// Builds the rows from lines of text.
#[derive(Debug)]
pub(crate) struct MotionSection {
    options: Options,
    /// Joint and channel names, for messages.
    channels: Vec<String>,
    header: Header,
    pub values: Vec<f64>,
    /// Buffer for the row being read.
    row: Vec<f64>,
    frames: usize,
    /// Start of a frame whose numbers are not complete.
    partial: Option<Partial>,
    decimals: Decimals,
    repairs: Vec<Repair>,
    pub notices: Vec<Notice>,
}

#[derive(Debug, Default)]
struct Header {
    declared: Option<usize>,
    frame_time: Option<f64>,
    /// True after the first row.
    done: bool,
}

#[derive(Debug)]
struct Partial {
    line: usize,
    text: Vec<u8>,
    at: usize,
}

/// Repair that may occur on many lines and is reported once.
#[derive(Debug)]
struct Repair {
    code: Code,
    location: Location,
    lines: usize,
}

/// Byte index of a value that cannot be read.
struct BadValue(usize);

impl MotionSection {
    pub fn new(options: Options, joints: &[Joint], decimals: Decimals) -> MotionSection {
        let channels: Vec<String> = joints
            .iter()
            .flat_map(|joint| {
                joint.channels.iter().map(|channel| format!("{} {}", joint.name, channel.name()))
            })
            .collect();
        MotionSection {
            options,
            row: vec![0.0; channels.len()],
            channels,
            header: Header::default(),
            values: Vec::new(),
            frames: 0,
            partial: None,
            decimals,
            repairs: Vec::new(),
            notices: Vec::new(),
        }
    }

    /// Reads the ordinary rows at the beginning of `text`, advances it past them, and returns their
    /// count.
    pub fn read_fast_rows(&mut self, text: &mut &[u8]) -> usize {
        let has_commas = self.decimals.commas.is_some();
        if !self.header.done || self.row.is_empty() || self.partial.is_some() || has_commas {
            return 0;
        }
        let before = self.frames;
        let mut points = self.decimals.points;
        while let Some(len) = fast_row::read_row(text, &mut self.row, &mut points) {
            *text = &text[len..];
            self.decimals.points = points;
            self.values.extend_from_slice(&self.row);
            self.frames += 1;
        }
        self.frames - before
    }

    /// Reads one line.
    pub fn line(&mut self, line: usize, text: &[u8]) -> Result<(), Error> {
        let mut at = number::skip_blanks(text, 0);
        if !self.header.done {
            at = self.header(line, text, at);
        }
        if at == text.len() {
            return Ok(());
        }
        if !self.header.done {
            self.header.done = true;
            self.reserve_frames();
        }
        self.row(line, text, at)
    }

    /// Reserves memory for the stated number of frames, limited to those that fit into the file.
    /// Growing step by step would need twice the memory.
    fn reserve_frames(&mut self) {
        let stated = self.header.declared.unwrap_or(0).saturating_mul(self.row.len());
        // A value takes at least a digit and a blank.
        let max = usize::try_from(self.options.expected_bytes / 2).unwrap_or(usize::MAX);
        // If the reservation fails, the actual rows may still fit.
        let _ = self.values.try_reserve_exact(stated.min(max));
    }

    /// Reads a line that ends with the file and ignores an incomplete number at its end.
    pub fn last_line(&mut self, line: usize, text: &[u8]) -> Result<(), Error> {
        let last = text.len() - text.iter().rev().take_while(|&&byte| !number::is_blank(byte)).count();
        let word = &text[last..];
        let is_incomplete_number = number::parse_leading(word).is_none()
            && word.iter().all(|byte| b"+-.,eE0123456789".contains(byte));
        self.line(line, if is_incomplete_number { &text[..last] } else { text })
    }

    /// Reports repairs and returns the frame time, after the last line.
    pub fn finish(&mut self) -> f64 {
        if let Some(partial) = self.partial.take() {
            self.values.truncate(self.frames * self.channels.len());
            self.notices.push(Notice {
                code: Code::IncompleteRow,
                location: Some(location(partial.line, &partial.text, partial.at)),
                text: "The last row is incomplete and was left out.".into(),
            });
        }
        self.values.shrink_to_fit();
        self.report_repairs();
        if let Some(first) = self.decimals.commas {
            self.notices.push(Notice {
                code: Code::DecimalComma,
                location: Some(first),
                text: "Decimal commas were read as decimal points.".into(),
            });
        }
        match self.header.declared {
            Some(declared) if declared != self.frames => self.notices.push(Notice::new(
                Code::FrameCount,
                format!(
                    "The file states {declared} frames and has {}; the frames present are used.",
                    self.frames
                ),
            )),
            None if self.frames > 0 => self.notices.push(Notice::new(
                Code::FrameCount,
                format!("The file does not state the number of frames; it has {}.", self.frames),
            )),
            _ => {}
        }
        self.frame_time()
    }

    fn frame_time(&mut self) -> f64 {
        let statement = match self.header.frame_time {
            Some(time) if PLAUSIBLE_FRAME_TIME.contains(&time) => return time,
            Some(time) => format!("states a frame time of {time} s"),
            None => "does not state a frame time".into(),
        };
        if self.frames > 0 {
            self.notices.push(Notice::new(
                Code::FrameTime,
                format!(
                    "The file {statement}; 30 frames per second are used. Set the frame rate if you know it."
                ),
            ));
        }
        DEFAULT_FRAME_TIME
    }

    fn report_repairs(&mut self) {
        let width = self.channels.len();
        for Repair { code, location, lines } in self.repairs.drain(..) {
            let times = if lines == 1 { "1 line".into() } else { format!("{lines} lines") };
            let text = match code {
                Code::LongRow => {
                    format!("{times} with more than {width} numbers: the extra numbers were left out.")
                }
                Code::WrappedRow => format!("Frames are wrapped over several lines ({times} more)."),
                Code::TrailingMatter => format!("{times} after the last frame were left out."),
                _ => format!(
                    "{times} with values that are not numbers: the values of the previous frame were repeated."
                ),
            };
            self.notices.push(Notice { code, location: Some(location), text });
        }
    }

    /// Reads `Frames:` and `Frame Time:` and returns the byte index after them.
    fn header(&mut self, line: usize, text: &[u8], mut at: usize) -> usize {
        while at < text.len() {
            let rest = &text[at..];
            let (is_time, len) = match (match_words(rest, &["frame", "time"]), match_words(rest, &["frames"]))
            {
                (Some(len), _) => (true, len),
                (None, Some(len)) => (false, len),
                (None, None) => break,
            };
            at = number::skip_blanks(text, at + len);
            let number = number::parse_leading(&text[at..]);
            if let Some(number) = number {
                self.decimals.record(number.mark, line, text, at);
            }
            let value = number.map(|number| number.value);
            if is_time {
                self.header.frame_time = value;
            } else {
                self.header.declared = value.filter(|&count| count >= 0.0).map(|count| count as usize);
            }
            at += number.map_or_else(|| number::word(&text[at..]).len(), |number| number.len);
            at = number::skip_blanks(text, at);
        }
        at
    }

    fn row(&mut self, line: usize, text: &[u8], at: usize) -> Result<(), Error> {
        let width = self.channels.len();
        if width == 0 {
            self.repair(Code::TrailingMatter, line, text, at);
            return Ok(());
        }
        let start = self.frames * width;
        let before = self.values.len() - start;
        let complete = self.header.declared.is_some_and(|declared| self.frames >= declared);
        let found = match self.numbers(line, text, at, width - before) {
            Ok(found) => before + found,
            // After all declared frames, a line that is not a row is not motion.
            Err(_) if complete => 0,
            Err(BadValue(at)) => return Err(self.bad_value(line, text, at)),
        };
        if found >= width && (before == 0 || found == width) {
            if found > width {
                self.repair(Code::LongRow, line, text, at);
            }
            if self.partial.take().is_some() {
                self.repair(Code::WrappedRow, line, text, at);
            }
            self.frames += 1;
        } else if complete && before == 0 {
            self.values.truncate(start);
            self.repair(Code::TrailingMatter, line, text, at);
        } else if found > width {
            let Partial { line, text, at } = self.partial.take().expect("a frame has begun");
            let kind = ErrorKind::RaggedRow { expected: width, found, frame: self.frames };
            return Err(Error::at(kind, line, &text, at));
        } else if before == 0 {
            self.partial = Some(Partial { line, text: text.to_vec(), at });
        } else {
            self.repair(Code::WrappedRow, line, text, at);
        }
        if self.decimals.are_mixed() {
            return Err(Error::at(ErrorKind::MixedDecimals, line, text, at));
        }
        Ok(())
    }

    /// Appends at most `wanted` numbers of the line and returns the count of all numbers.
    fn numbers(&mut self, line: usize, text: &[u8], mut at: usize, wanted: usize) -> Result<usize, BadValue> {
        let mut found = 0;
        while at < text.len() {
            let (value, len) = match number::parse_leading(&text[at..]) {
                Some(number) => {
                    self.decimals.record(number.mark, line, text, at);
                    (number.value, number.len)
                }
                None if self.options.lenient => {
                    self.repair(Code::HeldValue, line, text, at);
                    (self.previous_value(), number::word(&text[at..]).len())
                }
                None => return Err(BadValue(at)),
            };
            if found < wanted {
                self.values.push(value);
            }
            found += 1;
            at = number::skip_blanks(text, at + len);
        }
        Ok(found)
    }

    /// Returns the value of the next channel in the previous frame; 0 in the first frame.
    fn previous_value(&self) -> f64 {
        let width = self.channels.len();
        self.values
            .len()
            .checked_sub(width)
            .map_or(0.0, |index| self.values.get(index).copied().unwrap_or(0.0))
    }

    fn bad_value(&self, line: usize, text: &[u8], at: usize) -> Error {
        let next = self.values.len() - self.frames * self.channels.len();
        let kind = ErrorKind::BadValue {
            found: String::from_utf8_lossy(number::word(&text[at..])).chars().take(40).collect(),
            frame: self.frames,
            channel: self.channels.get(next).cloned().unwrap_or_else(|| "beyond the last".into()),
        };
        Error::at(kind, line, text, at)
    }

    fn repair(&mut self, code: Code, line: usize, text: &[u8], at: usize) {
        match self.repairs.iter_mut().find(|repair| repair.code == code) {
            Some(repair) => repair.lines += 1,
            None => self.repairs.push(Repair { code, location: location(line, text, at), lines: 1 }),
        }
    }
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
