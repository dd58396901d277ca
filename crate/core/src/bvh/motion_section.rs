//! The `MOTION` section: frame count, frame time and rows of values.

use crate::bvh::error::location;
use crate::bvh::frame_time::StatedFrameTime;
use crate::bvh::hierarchy::{HierarchySection, JointLocations};
use crate::bvh::layout::Layout;
use crate::bvh::lines::Line;
use crate::bvh::number::{DecimalMark, Decimals};
use crate::bvh::repairs::{Repair, Repairs};
use crate::bvh::{Error, ErrorKind, Joint, Options, fast_row, number};
use crate::notice::{Code, Location, Notice, shortened};

/// Frame time if the file states none or an implausible one, in seconds.
const DEFAULT_FRAME_TIME: f64 = 1.0 / 30.0;

/// Accepted frame times, in seconds: 10 kHz to 1 Hz.
const PLAUSIBLE_FRAME_TIME: std::ops::RangeInclusive<f64> = 1e-4..=1.0;

/// Builds the rows from lines of text.
#[derive(Debug)]
pub(crate) struct MotionSection {
    options: Options,
    pub joints: Vec<Joint>,
    header: Header,
    pub values: Vec<f64>,
    /// Buffer for the row being read.
    row: Vec<f64>,
    frames: usize,
    /// Start of a frame whose numbers are not complete.
    partial: Option<Partial>,
    decimals: Decimals,
    /// First number of the previous row if the row has one or two numbers more than there are channels.
    extra_number: Option<ExtraNumber>,
    /// Error of the first line after all declared frames that is not a row.
    trailing: Option<Error>,
    /// What follows the motion.
    followers: Option<Followers>,
    pub locations: JointLocations,
    pub layout: Layout,
    repairs: Repairs,
    /// Notices of the hierarchy and, after [`finish`](MotionSection::finish), of the motion.
    pub notices: Vec<Notice>,
}

#[derive(Debug, Default)]
struct Header {
    declared: Option<usize>,
    /// Text from which `declared` was read.
    frames: Option<Statement>,
    frame_time: Option<f64>,
    /// Text from which `frame_time` was read.
    time: Option<Statement>,
    /// True after the first row.
    done: bool,
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

/// Number or word that cannot be a value.
struct BadValue {
    /// Byte index in the line.
    at: usize,
    reason: BadReason,
}

enum BadReason {
    NotNumber,
    Large,
    MixedDecimals,
}

/// First number of a row that has more numbers than there are channels.
#[derive(Clone, Copy, Debug)]
struct ExtraNumber {
    value: f64,
    /// Difference from the row before, if that has such a number, too.
    step: Option<f64>,
    /// Number of rows in succession with the same difference.
    equal_steps: usize,
}

/// Number of rows with the same step larger than 1, from which a column of integers counts frames.
const COUNTED_ROWS: usize = 3;

/// Relative difference between the step of a column and the frame time, at which the column is the time.
const TIME_TOLERANCE: f64 = 0.05;

/// Hierarchies and motions that follow the first motion in the file.
#[derive(Debug)]
struct Followers {
    first: Location,
    hierarchies: usize,
    motions: usize,
}

#[derive(Debug)]
struct Partial {
    line: usize,
    text: Vec<u8>,
    at: usize,
}

impl MotionSection {
    pub fn new(options: Options, hierarchy: HierarchySection) -> MotionSection {
        let HierarchySection { joints, name_encoding, decimals, locations, notices } = hierarchy;
        let width = joints.iter().map(|joint| joint.channels.len()).sum();
        MotionSection {
            options,
            joints,
            row: vec![0.0; width],
            header: Header::default(),
            values: Vec::new(),
            frames: 0,
            partial: None,
            decimals,
            extra_number: None,
            trailing: None,
            followers: None,
            locations,
            layout: Layout { decimals: vec![0; width], name_encoding, ..Layout::default() },
            repairs: Repairs::default(),
            notices,
        }
    }

    /// Returns the number of channels.
    fn width(&self) -> usize {
        self.row.len()
    }

    /// Reads the ordinary rows at the beginning of `text`, which begins at byte `start` of the whole
    /// text, advances it past them, and returns their count.
    pub fn read_fast_rows(&mut self, text: &mut &[u8], mut start: u64, line_bytes: usize) -> usize {
        let has_commas = self.decimals.commas.is_some();
        let reads_rows = self.header.done && self.followers.is_none() && self.trailing.is_none();
        if !reads_rows || self.row.is_empty() || self.partial.is_some() || has_commas {
            return 0;
        }
        let before = self.frames;
        let mut points = self.decimals.points;
        let decimals = &mut self.layout.decimals;
        let limit = self.options.limits.value;
        while let Some(len) = fast_row::read_row(text, &mut self.row, decimals, &mut points, limit)
            .filter(|&len| len <= line_bytes)
        {
            *text = &text[len..];
            self.decimals.points = points;
            self.values.extend_from_slice(&self.row);
            self.layout.frames.push(start);
            start += len as u64;
            self.layout.frames_end = Some(start);
            self.frames += 1;
        }
        if self.frames > before {
            self.extra_number = None;
        }
        self.frames - before
    }

    /// Reads one line.
    pub fn line(&mut self, line: Line<'_>) -> Result<(), Error> {
        if self.frames > 0 && self.partial.is_none() {
            self.layout.frames_end.get_or_insert(line.start);
        }
        let mut at = number::skip_blanks(line.text, 0);
        if self.is_follower(line, at) {
            return Ok(());
        }
        if !self.header.done {
            at = self.header(line, at)?;
        }
        if at == line.text.len() || number::is_comment(&line.text[at..]) {
            return Ok(());
        }
        if self.frames == 0 && self.width() > 0 && !self.is_complete() && is_statement(&line.text[at..]) {
            let found = String::from_utf8_lossy(number::word(&line.text[at..])).chars().take(40).collect();
            let expected = "Frames:, Frame Time: or the numbers of a frame";
            return Err(Error::at(ErrorKind::Unexpected { expected, found }, line.number, line.text, at));
        }
        if !self.header.done {
            self.header.done = true;
            self.reserve_frames();
        }
        self.row(line, at)
    }

    /// True if the line belongs to another hierarchy or motion that follows the first motion.
    fn is_follower(&mut self, Line { number, text, .. }: Line<'_>, at: usize) -> bool {
        let begins = |keyword: &str| number::word(&text[at..]).eq_ignore_ascii_case(keyword.as_bytes());
        let hierarchies = usize::from(begins("HIERARCHY"));
        // Before the first row, the keyword is a repetition and no other motion.
        let motions = usize::from(begins("MOTION") && (self.header.done || self.followers.is_some()));
        // A word such as "Root" may begin a remark.
        let begins_here = hierarchies + motions > 0 || number::word(&text[at..]) == b"ROOT";
        if self.followers.is_none() && !begins_here {
            return false;
        }
        let followers = self.followers.get_or_insert_with(|| Followers {
            first: location(number, text, at),
            hierarchies: 0,
            motions: 0,
        });
        followers.hierarchies += hierarchies;
        followers.motions += motions;
        true
    }

    /// Reserves memory for the stated number of frames, limited to those that fit into the file.
    /// Growing step by step would need twice the memory.
    fn reserve_frames(&mut self) {
        let stated = self.header.declared.unwrap_or(0).saturating_mul(self.row.len());
        // A value takes at least a digit and a blank.
        let max = usize::try_from(self.options.expected_bytes / 2).unwrap_or(usize::MAX);
        // If the reservation fails, the actual rows may still fit.
        if self.values.try_reserve_exact(stated.min(max)).is_ok() {
            let frames = self.values.capacity() / self.row.len().max(1);
            let _ = self.layout.frames.try_reserve_exact(frames);
        }
    }

    /// Reads a line that ends with the file and ignores an incomplete number at its end.
    pub fn last_line(&mut self, line: Line<'_>) -> Result<(), Error> {
        let text = line.text;
        let last = text.len() - text.iter().rev().take_while(|&&byte| !number::is_blank(byte)).count();
        let word = &text[last..];
        let is_incomplete_number =
            number::parse_leading(word).is_none() && number::parse_leading(&[word, b"0"].concat()).is_some();
        self.line(Line { text: if is_incomplete_number { &text[..last] } else { text }, ..line })
    }

    /// Reports repairs and returns the frame time, after the last line; the text has `end` bytes.
    pub fn finish(&mut self, end: u64) -> f64 {
        if let Some(partial) = self.partial.take() {
            self.values.truncate(self.frames * self.width());
            self.layout.frames_end = self.layout.frames.pop();
            self.notices.push(Notice {
                code: Code::IncompleteRow,
                location: Some(location(partial.line, &partial.text, partial.at)),
                text: "The last row is incomplete and was left out.".into(),
            });
        }
        self.values.shrink_to_fit();
        self.layout.frames.shrink_to_fit();
        self.layout.frames_end.get_or_insert(end);
        self.layout.has_decimal_commas = self.decimals.commas.is_some();
        let mut repairs = self.repairs.take_notices(&self.joints);
        self.notices.append(&mut repairs);
        self.report_followers();
        if let Some(first) = self.decimals.commas {
            self.notices.push(Notice {
                code: Code::DecimalComma,
                location: Some(first),
                text: "Decimal commas were read as decimal points.".into(),
            });
        }
        self.report_frame_count();
        self.layout.frame_time = self.frame_time();
        self.layout.frame_time
    }

    fn report_frame_count(&mut self) {
        let frames = self.frames;
        let stated = self.header.frames.as_ref();
        let text = match (self.header.declared, stated.map(|stated| stated.text.as_str())) {
            (Some(declared), _) if declared == frames => return,
            (None, _) if frames == 0 => return,
            (Some(_), Some(text)) => {
                format!("The file states {text} frames and has {frames}; the frames present are used.")
            }
            (_, None | Some("")) => format!("The file does not state the number of frames; it has {frames}."),
            (None, Some(text)) => {
                format!("The number of frames is stated as {text:?}; the file has {frames}.")
            }
        };
        let location = stated.map(|stated| stated.location);
        self.notices.push(Notice { code: Code::FrameCount, location, text });
    }

    fn report_followers(&mut self) {
        let Some(Followers { first, hierarchies, motions }) = self.followers else { return };
        let count = |count: usize, one: &str, many: &str| match count {
            0 => None,
            1 => Some(format!("one more {one}")),
            count => Some(format!("{count} more {many}")),
        };
        let counts = [count(hierarchies, "hierarchy", "hierarchies"), count(motions, "motion", "motions")];
        let counts: Vec<String> = counts.into_iter().flatten().collect();
        let what = if counts.is_empty() { "another hierarchy".into() } else { counts.join(" and ") };
        let advice = if hierarchies > 0 || motions == 0 {
            "save each of the others as a file of its own"
        } else {
            "save each of the others as a file of its own, after a copy of the hierarchy"
        };
        let line = first.line;
        let text = format!(
            "The file contains several motions: {what} from line {line} on. Only the first motion was read and the \
             others were left out; to open them, {advice}."
        );
        self.notices.push(Notice { code: Code::SeveralMotions, location: Some(first), text });
    }

    fn frame_time(&mut self) -> f64 {
        if let Some(time) = self.header.frame_time
            && PLAUSIBLE_FRAME_TIME.contains(&time)
        {
            return time;
        }
        let stated = self.header.time.as_ref();
        let finding = match stated.map(|stated| stated.text.as_str()) {
            None | Some("") => "The file does not state a frame time".into(),
            Some(text) => format!("The stated frame time {text:?} is not plausible"),
        };
        if self.frames > 0 {
            let text =
                format!("{finding}; 30 frames per second are used. Set the frame rate if you know it.");
            let location = stated.map(|stated| stated.location);
            self.notices.push(Notice { code: Code::FrameTime, location, text });
        }
        DEFAULT_FRAME_TIME
    }

    /// Reads `Frames:` and `Frame Time:` and returns the byte index after them.
    fn header(&mut self, line: Line<'_>, mut at: usize) -> Result<usize, Error> {
        let Line { number, text, .. } = line;
        while at < text.len() {
            let rest = &text[at..];
            let (is_time, len) = match (match_words(rest, &["frame", "time"]), match_words(rest, &["frames"]))
            {
                (Some(len), _) => (true, len),
                (None, Some(len)) => (false, len),
                (None, None) => break,
            };
            at = number::skip_blanks(text, at + len);
            let len = if is_time { self.stated_frame_time(line, at)? } else { self.stated_frames(line, at) };
            at = number::skip_blanks(text, at + len);
            at +=
                self.unused_text(number, text, at, if is_time { Code::FrameTime } else { Code::FrameCount });
        }
        Ok(at)
    }

    /// Reads the number after `Frames:` and returns its length.
    fn stated_frames(&mut self, Line { number: line, start, text }: Line<'_>, at: usize) -> usize {
        let number = number::parse_leading(&text[at..]);
        let len = number.map_or_else(|| number::word(&text[at..]).len(), |number| number.len);
        // A comma separates thousands.
        let is_count = |number: &number::Number| {
            number.value >= 0.0 && number.value.fract() == 0.0 && number.mark != DecimalMark::Comma
        };
        let count = number.filter(is_count).map(|number| number.value as usize);
        if self.header.frames.is_some() && count != self.header.declared {
            self.repairs.add(Repair::SecondStatement { code: Code::FrameCount }, || location(line, text, at));
        }
        self.header.declared = count;
        Statement::replace(&mut self.header.frames, line, text, at, len);
        let start = start + at as u64;
        self.layout.frame_count = number.map(|_| start..start + len as u64);
        len
    }

    /// Reads the frame time and its unit, and returns their length.
    fn stated_frame_time(
        &mut self,
        Line { number: line, start, text }: Line<'_>,
        at: usize,
    ) -> Result<usize, Error> {
        let stated = StatedFrameTime::parse(&text[at..]);
        let seconds = stated.map(|stated| stated.seconds);
        let len = stated.map_or_else(|| number::word(&text[at..]).len(), |stated| stated.len);
        if self.header.time.is_some() && seconds != self.header.frame_time {
            self.repairs.add(Repair::SecondStatement { code: Code::FrameTime }, || location(line, text, at));
        }
        self.header.frame_time = seconds;
        Statement::replace(&mut self.header.time, line, text, at, len);
        let Some(stated) = stated else { return Ok(len) };
        self.decimals.record(stated.mark, line, text, at)?;
        if stated.has_unit && PLAUSIBLE_FRAME_TIME.contains(&stated.seconds) {
            let found = String::from_utf8_lossy(&text[at..at + stated.len]).into_owned();
            let repair = Repair::FrameTimeUnit { found, seconds: stated.seconds };
            self.repairs.add(repair, || location(line, text, at));
        }
        let start = start + at as u64;
        self.layout.frame_time_text = Some(start..start + len as u64);
        Ok(len)
    }

    /// Returns the length of text in the header that is neither a number nor a statement nor a
    /// comment, and adds a notice about it.
    fn unused_text(&mut self, line: usize, text: &[u8], at: usize, code: Code) -> usize {
        let rest = &text[at..];
        let is_used = rest.is_empty()
            || number::is_comment(rest)
            || number::parse_leading(rest).is_some()
            || match_words(rest, &["frame", "time"]).or(match_words(rest, &["frames"])).is_some();
        if is_used {
            return 0;
        }
        let found: String = String::from_utf8_lossy(rest).trim_end().chars().take(40).collect();
        self.repairs.add(Repair::UnusedText { found, code }, || location(line, text, at));
        rest.len()
    }

    fn row(
        &mut self,
        Line { number: line, start: line_start, text }: Line<'_>,
        at: usize,
    ) -> Result<(), Error> {
        let width = self.width();
        if width == 0 {
            self.repairs.add(Repair::TrailingMatter, || location(line, text, at));
            return Ok(());
        }
        let start = self.frames * width;
        let before = self.values.len() - start;
        let complete = self.is_complete();
        let decimals = self.decimals;
        // After all declared frames, a line without numbers is not motion.
        let lenient = self.options.lenient && !(complete && is_text(&text[at..]));
        let found = match self.numbers(line, text, at, width - before, lenient) {
            Ok(found) => before + found,
            // Likewise, a line that is not a row.
            Err(bad) if complete => {
                if self.trailing.is_none() {
                    self.trailing = Some(self.bad_value(line, text, bad));
                }
                0
            }
            Err(bad) => return Err(self.bad_value(line, text, bad)),
        };
        if before == 0 && found > 0 {
            let is_first = text[..at].iter().all(|&byte| number::is_blank(byte));
            self.layout.frames.push(line_start + if is_first { 0 } else { at as u64 });
        }
        if found >= width && (before == 0 || found == width) {
            // The motion continues, so that the lines left out belong to it.
            if let Some(error) = self.trailing.take() {
                return Err(error);
            }
            self.check_extra_number(found, line, text, at)?;
            if found > width {
                self.repairs.add(Repair::LongRow { channels: width }, || location(line, text, at));
            }
            self.layout.frames_end = None;
            if self.partial.take().is_some() {
                self.repairs.add(Repair::WrappedRow, || location(line, text, at));
            }
            self.frames += 1;
        } else if complete && before == 0 {
            self.values.truncate(start);
            self.decimals = decimals;
            let kind = ErrorKind::RaggedRow { expected: width, found, frame: self.frames };
            self.trailing.get_or_insert_with(|| Error::at(kind, line, text, at));
            if found > 0 {
                self.layout.frames.pop();
            }
            self.repairs.add(Repair::TrailingMatter, || location(line, text, at));
        } else if found > width {
            let Partial { line, text, at } = self.partial.take().expect("a frame has begun");
            let kind = ErrorKind::RaggedRow { expected: width, found, frame: self.frames };
            return Err(Error::at(kind, line, &text, at));
        } else if before == 0 {
            self.partial = Some(Partial { line, text: text.to_vec(), at });
        } else {
            self.repairs.add(Repair::WrappedRow, || location(line, text, at));
        }
        Ok(())
    }

    /// True if all declared frames have been read.
    fn is_complete(&self) -> bool {
        self.header.declared.is_some_and(|declared| self.frames >= declared)
    }

    /// Appends at most `wanted` numbers of the line and returns the count of all numbers.
    fn numbers(
        &mut self,
        line: usize,
        text: &[u8],
        mut at: usize,
        wanted: usize,
        lenient: bool,
    ) -> Result<usize, BadValue> {
        let mut found = 0;
        let channel = self.width() - wanted;
        while at < text.len() && !number::is_comment(&text[at..]) {
            let limit = self.options.limits.value;
            let number = number::parse_leading(&text[at..]);
            let is_large = number.is_some_and(|number| number.value.abs() > limit);
            let (value, len) = match number.filter(|_| !is_large) {
                Some(number) => {
                    if self.decimals.record(number.mark, line, text, at).is_err() {
                        return Err(BadValue { at, reason: BadReason::MixedDecimals });
                    }
                    if let Some(decimals) = self.layout.decimals.get_mut(channel + found) {
                        *decimals = number.decimals.max(*decimals);
                    }
                    (number.value, number.len)
                }
                None if lenient => {
                    self.repairs.add(Repair::HeldValue, || location(line, text, at));
                    (self.previous_value(), number::word(&text[at..]).len())
                }
                None if is_large => return Err(BadValue { at, reason: BadReason::Large }),
                None => return Err(BadValue { at, reason: BadReason::NotNumber }),
            };
            if found < wanted {
                self.values.push(value);
            }
            found += 1;
            at = number::skip_blanks(text, at + len);
        }
        Ok(found)
    }

    /// Checks that the complete row does not begin with a number or time of its frame: with one or two
    /// numbers more than there are channels, the first of which increases by a constant step.
    fn check_extra_number(&mut self, found: usize, line: usize, text: &[u8], at: usize) -> Result<(), Error> {
        let channels = self.width();
        let has_extra = (1..=2).any(|extra| found == channels + extra);
        let first = has_extra.then(|| self.values[self.frames * channels]);
        let previous = self.extra_number.take();
        let step = first.zip(previous).map(|(first, previous)| first - previous.value);
        let equal_steps =
            previous.filter(|previous| previous.step == step).map_or(1, |previous| previous.equal_steps + 1);
        self.extra_number = first.map(|value| ExtraNumber { value, step, equal_steps });
        let Some((first, step)) = first.zip(step) else { return Ok(()) };
        let is_time = |time: f64| (step / time - 1.0).abs() < TIME_TOLERANCE;
        let is_count = step == 1.0 || step > 1.0 && equal_steps >= COUNTED_ROWS;
        let column = if first.fract() == 0.0 && is_count {
            "the number of the frame"
        } else if self.header.frame_time.is_some_and(|time| is_time(time) || is_time(1e3 * time)) {
            "the time of the frame"
        } else {
            return Ok(());
        };
        Err(Error::at(ErrorKind::ExtraColumn { channels, column }, line, text, at))
    }

    /// Returns the value of the next channel in the previous frame; 0 in the first frame.
    fn previous_value(&self) -> f64 {
        let width = self.width();
        self.values
            .len()
            .checked_sub(width)
            .map_or(0.0, |index| self.values.get(index).copied().unwrap_or(0.0))
    }

    /// Returns the name of a channel of the row, as in `LeftFoot Zrotation`.
    fn channel_name(&self, channel: usize) -> Option<String> {
        let mut channels =
            self.joints.iter().flat_map(|joint| joint.channels.iter().map(move |channel| (joint, channel)));
        let (joint, channel) = channels.nth(channel)?;
        Some(format!("{} {}", shortened(&joint.name), channel.name()))
    }

    fn bad_value(&self, line: usize, text: &[u8], BadValue { at, reason }: BadValue) -> Error {
        let found = String::from_utf8_lossy(number::word(&text[at..])).chars().take(40).collect();
        let frame = self.frames;
        let next = self.values.len() - self.frames * self.width();
        let channel = self.channel_name(next).unwrap_or_else(|| "beyond the last".into());
        let kind = match reason {
            BadReason::NotNumber => ErrorKind::BadValue { found, frame, channel },
            BadReason::Large => {
                let place = format!("frame {frame}, channel {channel}");
                ErrorKind::LargeValue { found, limit: self.options.limits.value, place }
            }
            BadReason::MixedDecimals => ErrorKind::MixedDecimals,
        };
        Error::at(kind, line, text, at)
    }
}

/// True if a line before the first frame is a misspelled or unknown statement, such as `Frame: 2`.
fn is_statement(text: &[u8]) -> bool {
    let word = number::word(text).to_ascii_lowercase();
    let is_keyword = b"frames".starts_with(&word[..]) || word.starts_with(b"frame") || word == b"motion";
    let is_assignment = text.iter().any(|&byte| byte == b':' || byte == b'=');
    is_keyword || is_assignment && word[0].is_ascii_alphabetic()
}

/// True if no word of a line is a number or stands for one, such as `NaN`.
fn is_text(text: &[u8]) -> bool {
    let is_special = |word: &[u8]| {
        let word = word.strip_prefix(b"-").unwrap_or(word).to_ascii_lowercase();
        matches!(&word[..], b"nan" | b"inf" | b"infinity")
    };
    let mut words = text.split(|&byte| number::is_blank(byte));
    words.all(|word| number::parse_leading(word).is_none() && !is_special(word))
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
