//! The `MOTION` section: rows of values, after a header.

use crate::bvh::error::location;
use crate::bvh::extra_column::ExtraColumn;
use crate::bvh::hierarchy::{HierarchySection, JointLocations};
use crate::bvh::layout::Layout;
use crate::bvh::lines::Line;
use crate::bvh::motion_header::{HeaderContext, MotionHeader, is_statement};
use crate::bvh::number::Decimals;
use crate::bvh::repairs::{Repair, Repairs};
use crate::bvh::{Error, ErrorKind, Joint, Options, fast_row, number};
use crate::notice::{Code, Location, Notice, shortened};

/// Builds the rows from lines of text.
#[derive(Debug)]
pub(crate) struct MotionSection {
    options: Options,
    pub joints: Vec<Joint>,
    header: MotionHeader,
    /// True after the first row.
    has_rows: bool,
    pub values: Vec<f64>,
    /// Buffer for the row being read.
    row: Vec<f64>,
    frames: usize,
    /// Start of a frame whose numbers are not complete.
    partial: Option<Partial>,
    decimals: Decimals,
    extra_column: ExtraColumn,
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
            header: MotionHeader::default(),
            has_rows: false,
            values: Vec::new(),
            frames: 0,
            partial: None,
            decimals,
            extra_column: ExtraColumn::default(),
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
        let reads_rows = self.has_rows && self.followers.is_none() && self.trailing.is_none();
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
            self.extra_column = ExtraColumn::default();
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
        if !self.has_rows {
            let (decimals, layout, repairs) = (&mut self.decimals, &mut self.layout, &mut self.repairs);
            at = self.header.read(line, at, &mut HeaderContext { decimals, layout, repairs })?;
        }
        if at == line.text.len() || number::is_comment(&line.text[at..]) {
            return Ok(());
        }
        if self.frames == 0 && self.width() > 0 && !self.is_complete() && is_statement(&line.text[at..]) {
            let found = String::from_utf8_lossy(number::word(&line.text[at..])).chars().take(40).collect();
            let expected = "Frames:, Frame Time: or the numbers of a frame";
            return Err(Error::at(ErrorKind::Unexpected { expected, found }, line.number, line.text, at));
        }
        if !self.has_rows {
            self.has_rows = true;
            self.reserve_frames();
        }
        self.row(line, at)
    }

    /// True if the line belongs to another hierarchy or motion that follows the first motion.
    fn is_follower(&mut self, Line { number, text, .. }: Line<'_>, at: usize) -> bool {
        let begins = |keyword: &str| number::word(&text[at..]).eq_ignore_ascii_case(keyword.as_bytes());
        let hierarchies = usize::from(begins("HIERARCHY"));
        // Before the first row, the keyword is a repetition and no other motion.
        let motions = usize::from(begins("MOTION") && (self.has_rows || self.followers.is_some()));
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
        let stated = self.header.frames.unwrap_or(0).saturating_mul(self.row.len());
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
        self.notices.extend(self.header.frame_count_notice(self.frames));
        let (frame_time, notice) = self.header.used_frame_time();
        self.notices.extend(notice.filter(|_| self.frames > 0));
        self.layout.frame_time = frame_time;
        frame_time
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
            Err(error) if complete => {
                self.trailing.get_or_insert(error);
                0
            }
            Err(error) => return Err(error),
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
            self.check_extra_column(found, line, text, at)?;
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
        self.header.frames.is_some_and(|declared| self.frames >= declared)
    }

    /// Appends at most `wanted` numbers of the line and returns the count of all numbers.
    fn numbers(
        &mut self,
        line: usize,
        text: &[u8],
        mut at: usize,
        wanted: usize,
        lenient: bool,
    ) -> Result<usize, Error> {
        let mut found = 0;
        let channel = self.width() - wanted;
        while at < text.len() && !number::is_comment(&text[at..]) {
            let limit = self.options.limits.value;
            let number = number::parse_leading(&text[at..]);
            let is_large = number.is_some_and(|number| number.value.abs() > limit);
            let (value, len) = match number.filter(|_| !is_large) {
                Some(number) => {
                    self.decimals.record(number.mark, line, text, at)?;
                    if let Some(decimals) = self.layout.decimals.get_mut(channel + found) {
                        *decimals = number.decimals.max(*decimals);
                    }
                    (number.value, number.len)
                }
                None if lenient => {
                    self.repairs.add(Repair::HeldValue, || location(line, text, at));
                    (self.previous_value(), number::word(&text[at..]).len())
                }
                None => return Err(self.bad_value(line, text, at, is_large)),
            };
            if found < wanted {
                self.values.push(value);
            }
            found += 1;
            at = number::skip_blanks(text, at + len);
        }
        Ok(found)
    }

    /// Checks that the complete row, of `found` numbers, does not begin with a number or time of its frame.
    fn check_extra_column(&mut self, found: usize, line: usize, text: &[u8], at: usize) -> Result<(), Error> {
        let channels = self.width();
        let has_extra = (1..=2).any(|extra| found == channels + extra);
        let first = has_extra.then(|| self.values[self.frames * channels]);
        match self.extra_column.add(first, self.header.frame_time) {
            Some(column) => Err(Error::at(ErrorKind::ExtraColumn { channels, column }, line, text, at)),
            None => Ok(()),
        }
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

    /// Returns the error of a word that is not a number, or of one beyond the limit.
    fn bad_value(&self, line: usize, text: &[u8], at: usize, is_large: bool) -> Error {
        let found = String::from_utf8_lossy(number::word(&text[at..])).chars().take(40).collect();
        let frame = self.frames;
        let next = self.values.len() - self.frames * self.width();
        let channel = self.channel_name(next).unwrap_or_else(|| "beyond the last".into());
        let kind = if is_large {
            let place = format!("frame {frame}, channel {channel}");
            ErrorKind::LargeValue { found, limit: self.options.limits.value, place }
        } else {
            ErrorKind::BadValue { found, frame, channel }
        };
        Error::at(kind, line, text, at)
    }
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
