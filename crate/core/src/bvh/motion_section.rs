//! The `MOTION` section: frame count, frame time and the rows of values.

use crate::bvh::error::place;
use crate::bvh::number::Decimals;
use crate::bvh::{Error, Joint, Options, Problem, fast_row, number};
use crate::notice::{Code, Notice, Place};

/// The frame time taken where the file's own is missing or absurd, in seconds.
const DEFAULT_FRAME_TIME: f64 = 1.0 / 30.0;

/// Frame times from 10 kHz to one frame a second are believed.
const PLAUSIBLE_FRAME_TIME: std::ops::RangeInclusive<f64> = 1e-4..=1.0;

/// Builds the rows from lines.
#[derive(Debug)]
pub(crate) struct Rows {
    options: Options,
    /// Joint and channel names, for messages.
    channels: Vec<String>,
    header: Header,
    pub values: Vec<f64>,
    /// Room for the row that is being read.
    row: Vec<f64>,
    frames: usize,
    /// Where a frame began whose numbers have not all come yet.
    partial: Option<Partial>,
    decimals: Decimals,
    repairs: Vec<Repair>,
    pub notices: Vec<Notice>,
}

#[derive(Debug, Default)]
struct Header {
    declared: Option<usize>,
    frame_time: Option<f64>,
    /// The rows have begun.
    done: bool,
}

#[derive(Debug)]
struct Partial {
    line: usize,
    text: Vec<u8>,
    at: usize,
}

/// A repair that may occur on many lines and is reported once.
#[derive(Debug)]
struct Repair {
    code: Code,
    place: Place,
    lines: usize,
}

/// A row of which something could not be read, at this byte.
struct BadValue(usize);

impl Rows {
    pub fn new(options: Options, joints: &[Joint], decimals: Decimals) -> Rows {
        let channels: Vec<String> = joints
            .iter()
            .flat_map(|joint| {
                joint.channels.iter().map(|channel| format!("{} {}", joint.name, channel.name()))
            })
            .collect();
        Rows {
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

    /// Takes the plain rows that `text` begins with, leaves in it what follows them, and counts them.
    pub fn plain(&mut self, text: &mut &[u8]) -> usize {
        let has_commas = self.decimals.commas.is_some();
        if !self.header.done || self.row.is_empty() || self.partial.is_some() || has_commas {
            return 0;
        }
        let before = self.frames;
        let mut points = self.decimals.points;
        while let Some(len) = fast_row::row(text, &mut self.row, &mut points) {
            *text = &text[len..];
            self.decimals.points = points;
            self.values.extend_from_slice(&self.row);
            self.frames += 1;
        }
        self.frames - before
    }

    /// Takes one line.
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
            self.make_room();
        }
        self.row(line, text, at)
    }

    /// Makes room for the frames stated, as far as the file can hold them: growing step
    /// by step would take twice the memory in the end.
    fn make_room(&mut self) {
        let stated = self.header.declared.unwrap_or(0).saturating_mul(self.row.len());
        // A value takes a digit and a blank.
        let most = usize::try_from(self.options.expected_bytes / 2).unwrap_or(usize::MAX);
        // Where there is no such room, there may yet be for what comes.
        let _ = self.values.try_reserve_exact(stated.min(most));
    }

    /// Takes a line that ends with the file: the beginning of a number is left out.
    pub fn last_line(&mut self, line: usize, text: &[u8]) -> Result<(), Error> {
        let last = text.len() - text.iter().rev().take_while(|&&byte| !number::is_blank(byte)).count();
        let word = &text[last..];
        let is_begun =
            number::leading(word).is_none() && word.iter().all(|byte| b"+-.,eE0123456789".contains(byte));
        self.line(line, if is_begun { &text[..last] } else { text })
    }

    /// The frame time, once all lines were taken.
    pub fn finish(&mut self) -> f64 {
        if let Some(partial) = self.partial.take() {
            self.values.truncate(self.frames * self.channels.len());
            self.notices.push(Notice {
                code: Code::IncompleteRow,
                place: Some(place(partial.line, &partial.text, partial.at)),
                text: "The last row breaks off and was left out.".into(),
            });
        }
        self.values.shrink_to_fit();
        self.report_repairs();
        if let Some(first) = self.decimals.commas {
            self.notices.push(Notice {
                code: Code::DecimalComma,
                place: Some(first),
                text: "Decimal commas were read as decimal points.".into(),
            });
        }
        match self.header.declared {
            Some(declared) if declared != self.frames => self.notices.push(Notice::new(
                Code::FrameCount,
                format!(
                    "The file states {declared} frames and has {}: those present are taken.",
                    self.frames
                ),
            )),
            None if self.frames > 0 => self.notices.push(Notice::new(
                Code::FrameCount,
                format!("The file does not state its number of frames: it has {}.", self.frames),
            )),
            _ => {}
        }
        self.frame_time()
    }

    fn frame_time(&mut self) -> f64 {
        let found = match self.header.frame_time {
            Some(time) if PLAUSIBLE_FRAME_TIME.contains(&time) => return time,
            Some(time) => format!("states a frame time of {time} s"),
            None => "does not state a frame time".into(),
        };
        if self.frames > 0 {
            self.notices.push(Notice::new(
                Code::FrameTime,
                format!(
                    "The file {found}: 30 frames per second are taken. Set the true rate if you know it."
                ),
            ));
        }
        DEFAULT_FRAME_TIME
    }

    fn report_repairs(&mut self) {
        let width = self.channels.len();
        for Repair { code, place, lines } in self.repairs.drain(..) {
            let times = if lines == 1 { "1 line".into() } else { format!("{lines} lines") };
            let text = match code {
                Code::LongRow => format!("{times} with more than {width} numbers: the rest was left out."),
                Code::WrappedRow => format!("Frames are wrapped over several lines ({times} more)."),
                Code::TrailingMatter => format!("{times} after the last frame were left out."),
                _ => format!("{times} with values that are no numbers: the previous frame's were held."),
            };
            self.notices.push(Notice { code, place: Some(place), text });
        }
    }

    /// Takes `Frames:` and `Frame Time:` and tells where what follows them begins.
    fn header(&mut self, line: usize, text: &[u8], mut at: usize) -> usize {
        while at < text.len() {
            let rest = &text[at..];
            let (is_time, len) = match (after(rest, &["frame", "time"]), after(rest, &["frames"])) {
                (Some(len), _) => (true, len),
                (None, Some(len)) => (false, len),
                (None, None) => break,
            };
            at = number::skip_blanks(text, at + len);
            let number = number::leading(&text[at..]);
            if let Some(number) = number {
                self.decimals.note(number.mark, line, text, at);
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
            // Once all declared frames are there, what is no row is no motion.
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
            let problem = Problem::RaggedRow { expected: width, found, frame: self.frames };
            return Err(Error::at(problem, line, &text, at));
        } else if before == 0 {
            self.partial = Some(Partial { line, text: text.to_vec(), at });
        } else {
            self.repair(Code::WrappedRow, line, text, at);
        }
        if self.decimals.mixed() {
            return Err(Error::at(Problem::MixedDecimals, line, text, at));
        }
        Ok(())
    }

    /// Appends the line's numbers, at most `wanted`, and counts them all.
    fn numbers(&mut self, line: usize, text: &[u8], mut at: usize, wanted: usize) -> Result<usize, BadValue> {
        let mut found = 0;
        while at < text.len() {
            let (value, len) = match number::leading(&text[at..]) {
                Some(number) => {
                    self.decimals.note(number.mark, line, text, at);
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

    /// The previous frame's value of the channel that comes next; 0 in the first frame.
    fn previous_value(&self) -> f64 {
        let width = self.channels.len();
        self.values
            .len()
            .checked_sub(width)
            .map_or(0.0, |index| self.values.get(index).copied().unwrap_or(0.0))
    }

    fn bad_value(&self, line: usize, text: &[u8], at: usize) -> Error {
        let next = self.values.len() - self.frames * self.channels.len();
        let problem = Problem::BadValue {
            found: String::from_utf8_lossy(number::word(&text[at..])).chars().take(40).collect(),
            frame: self.frames,
            channel: self.channels.get(next).cloned().unwrap_or_else(|| "beyond the last".into()),
        };
        Error::at(problem, line, text, at)
    }

    fn repair(&mut self, code: Code, line: usize, text: &[u8], at: usize) {
        match self.repairs.iter_mut().find(|repair| repair.code == code) {
            Some(repair) => repair.lines += 1,
            None => self.repairs.push(Repair { code, place: place(line, text, at), lines: 1 }),
        }
    }
}

/// Length of `words`, in any case and with blanks between, and of a colon
/// after them, where `text` begins so.
fn after(text: &[u8], words: &[&str]) -> Option<usize> {
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
