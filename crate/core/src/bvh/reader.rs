//! Reader of BVH files in chunks.

use std::sync::Arc;

use crate::bvh::encoding::Decoder;
use crate::bvh::hierarchy::{Hierarchy, JointLocations, Progress};
use crate::bvh::layout::Layout;
use crate::bvh::lines::{Line, Lines};
use crate::bvh::motion_section::MotionSection;
use crate::bvh::{Channel, Clip, Error, ErrorKind, Options, PositionRule, error, number};
use crate::notice::{self, Code, Location, Notice};

/// Result of reading a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Parsed {
    /// The clip; its frame time is always positive and its values are finite.
    pub clip: Clip,
    /// Repairs and assumptions, in file order.
    pub notices: Vec<Notice>,
    /// Layout of the file, with which [`Rewriter`](crate::bvh::Rewriter) preserves its text.
    pub layout: Arc<Layout>,
}

/// Reads a file that is in memory; see [`Reader`].
///
/// ```
/// let text = b"HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 1 Yposition }
/// MOTION
/// Frames: 2
/// Frame Time: 0.5
/// 1.0
/// 2.0";
/// let parsed = plantigrade::bvh::parse(text, Default::default())?;
/// assert_eq!(parsed.clip.frame_count(), 2);
/// assert_eq!(parsed.clip.row(1), [2.0]);
/// # Ok::<(), plantigrade::bvh::Error>(())
/// ```
///
/// # Errors
/// If the file cannot be read as BVH or exceeds a limit.
pub fn parse(bytes: &[u8], options: Options) -> Result<Parsed, Error> {
    let mut reader = Reader::new(Options { expected_bytes: bytes.len() as u64, ..options });
    reader.push(bytes)?;
    reader.finish()
}

/// Reads a file chunk by chunk.
///
/// The result does not depend on the chunks. Memory grows with the values read or with the expected
/// size, never with a number stated in the file.
#[derive(Debug)]
pub struct Reader {
    options: Options,
    bytes: u64,
    decoder: Decoder,
    lines: Lines,
    section: Section,
}

#[derive(Debug)]
enum Section {
    Hierarchy(Box<Hierarchy>),
    Motion(Box<MotionSection>),
}

impl Reader {
    /// Creates a reader at the beginning of a file.
    pub fn new(options: Options) -> Reader {
        Reader {
            options,
            bytes: 0,
            decoder: Decoder::default(),
            lines: Lines::default(),
            section: Section::Hierarchy(Box::new(Hierarchy::new(&options))),
        }
    }

    /// Reads the next chunk of the file.
    ///
    /// # Errors
    /// If the file cannot be read so far. The reader must not be used afterwards.
    pub fn push(&mut self, chunk: &[u8]) -> Result<(), Error> {
        self.bytes += chunk.len() as u64;
        if self.bytes > self.options.limits.bytes {
            return Err(Error::in_file(ErrorKind::TooLarge(self.options.limits.bytes)));
        }
        let text = self.decoder.decode(chunk);
        self.section.text(self.options, &mut self.lines, text)
    }

    /// Ends the file and returns the clip.
    ///
    /// # Errors
    /// If the file as a whole cannot be read.
    pub fn finish(mut self) -> Result<Parsed, Error> {
        let rest = self.decoder.finish().to_vec();
        self.section.text(self.options, &mut self.lines, &rest)?;
        if let Some(line) = self.lines.finish() {
            self.section.last_line(self.options, line)?;
        }
        self.section.finish(self.options, self.lines.start())
    }
}

impl Section {
    /// Reads a chunk of text.
    fn text(&mut self, options: Options, lines: &mut Lines, mut text: &[u8]) -> Result<(), Error> {
        let limit = options.limits.line_bytes;
        let line_too_long = |line| Error::at(ErrorKind::LineTooLong(limit), line, b"", 0);
        loop {
            if let Section::Motion(rows) = self
                && lines.at_start()
            {
                let before = text.len();
                let rows = rows.read_fast_rows(&mut text, lines.start(), limit);
                lines.skip(rows, before - text.len());
            }
            let Some(line) = lines.next(&mut text) else { break };
            if line.text.len() > limit {
                return Err(line_too_long(line.number));
            }
            self.line(options, line)?;
        }
        lines.carry(text, limit).map_err(line_too_long)
    }

    fn line(&mut self, options: Options, line: Line<'_>) -> Result<(), Error> {
        match self {
            Section::Motion(rows) => rows.line(line),
            Section::Hierarchy(hierarchy) => match hierarchy.line(line.number, line.text)? {
                Progress::Hierarchy => Ok(()),
                Progress::Motion(rest) => {
                    self.begin_motion(options);
                    let (start, text) = (line.start + rest as u64, &line.text[rest..]);
                    self.line(options, Line { start, text, ..line })
                }
            },
        }
    }

    /// Reads a line that ends with the file, possibly within a word.
    fn last_line(&mut self, options: Options, line: Line<'_>) -> Result<(), Error> {
        match self {
            Section::Motion(rows) => rows.last_line(line),
            Section::Hierarchy(_) => self.line(options, line).map_err(|error| match self {
                // If braces are open, an error of the last word is that the file is incomplete.
                Section::Hierarchy(hierarchy)
                    if hierarchy.is_open() && error.location >= Some(last_word(line)) =>
                {
                    hierarchy.finish().err().unwrap_or(error)
                }
                _ => error,
            }),
        }
    }

    fn begin_motion(&mut self, options: Options) {
        if let Section::Hierarchy(hierarchy) = self {
            *self = Section::Motion(Box::new(MotionSection::new(options, hierarchy.take())));
        }
    }

    fn finish(mut self, options: Options, end: u64) -> Result<Parsed, Error> {
        if let Section::Hierarchy(hierarchy) = &self {
            hierarchy.finish()?;
            self.begin_motion(options);
        }
        let Section::Motion(mut rows) = self else { unreachable!("the motion has begun") };
        let frame_time = rows.finish(end);
        let mut notices = rows.notices;
        let clip = Clip::new(rows.joints, frame_time, rows.values);
        notices.extend(clip_notices(&clip, rows.locations));
        let rule = position_rule(&clip);
        if rule == PositionRule::Add {
            notices.push(Notice::new(
                Code::AddedPositions,
                "Position channels stay near zero although offsets do not; they are added to the offsets.",
            ));
        }
        Ok(Parsed { clip: clip.with_position_rule(rule), notices, layout: Arc::new(rows.layout) })
    }
}

/// Returns the location of the last word of a line.
fn last_word(line: Line<'_>) -> Location {
    let text = line.text.trim_ascii_end();
    let word = text.iter().rev().take_while(|&&byte| !number::is_blank(byte)).count();
    error::location(line.number, text, text.len() - word)
}

/// Returns the notices about the clip as a whole.
fn clip_notices(clip: &Clip, locations: JointLocations) -> Vec<Notice> {
    let mut notices = Vec::new();
    let roots: Vec<&str> = clip.roots().map(|root| clip.joints()[root].name.as_str()).collect();
    if roots.len() > 1 {
        let text = format!("The file contains {} skeletons: {}.", roots.len(), notice::list(&roots));
        notices.push(Notice { code: Code::SeveralRoots, location: locations.second_root, text });
    }
    let mut names: Vec<&str> = clip
        .joints()
        .iter()
        .filter(|joint| joint.kind != crate::bvh::JointKind::EndSite)
        .map(|joint| joint.name.as_str())
        .collect();
    names.sort_unstable();
    let mut shared: Vec<&str> =
        names.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]).collect();
    shared.dedup();
    if !shared.is_empty() {
        let text = format!("Several joints share a name: {}.", notice::list(&shared));
        notices.push(Notice { code: Code::DuplicateName, location: locations.duplicate, text });
    }
    if clip.frame_count() == 0 {
        notices.push(Notice::new(Code::NoMotion, "The file has no motion; its rest pose is shown."));
    }
    notices
}

/// Returns [`PositionRule::Add`] if all position channels below the roots are about zero although
/// the offsets are not.
pub(crate) fn position_rule(clip: &Clip) -> PositionRule {
    let is_position = |channel: &Channel| matches!(channel, Channel::Position(_));
    let (mut slots, mut largest_offset) = (Vec::new(), 0.0_f64);
    for (index, joint) in clip.joints().iter().enumerate() {
        if joint.parent.is_none() || !joint.channels.iter().any(is_position) {
            continue;
        }
        largest_offset = largest_offset.max(joint.offset.amax());
        let channels = clip.channel_range(index).zip(&joint.channels);
        slots.extend(channels.filter(|(_, channel)| is_position(channel)).map(|(slot, _)| slot));
    }
    // Replacing an offset by zero would collapse the bone; a thousandth of it is rounding.
    let is_small = |value: f64| value.abs() < 1e-3 * largest_offset;
    let mut rows = (0..clip.frame_count()).map(|frame| clip.row(frame));
    if !slots.is_empty()
        && clip.frame_count() > 0
        && rows.all(|row| slots.iter().all(|&slot| is_small(row[slot])))
    {
        PositionRule::Add
    } else {
        PositionRule::Replace
    }
}
