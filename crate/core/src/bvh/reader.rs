//! The reader: bytes, in chunks, to a clip with notices.

use crate::bvh::encoding::Decoder;
use crate::bvh::hierarchy::{Hierarchy, Progress};
use crate::bvh::lines::Lines;
use crate::bvh::motion_section::Rows;
use crate::bvh::{Channel, Clip, Error, Joint, PositionRule, Problem};
use crate::notice::{Code, Notice};

/// How large a file may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of the file; default 1 GiB.
    pub bytes: u64,
    /// Bytes of a line; default 16 MiB.
    pub line_bytes: usize,
    /// Joints and end sites; default 10,000.
    pub joints: usize,
    /// Joints from a root to a tip; default 1,000.
    pub depth: usize,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { bytes: 1 << 30, line_bytes: 16 << 20, joints: 10_000, depth: 1_000 }
    }
}

/// How a file is read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Hold the previous frame's value where one is no number, instead of refusing the file.
    pub lenient: bool,
    /// How large the file may be.
    pub limits: Limits,
    /// Bytes that the file probably has: room for the frames it states is made at once if
    /// so many bytes can hold them, and bit by bit otherwise; default 0.
    pub expected_bytes: u64,
}

/// A clip as it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Parsed {
    /// The clip; its frame time is always positive and its values are finite.
    pub clip: Clip,
    /// What was repaired or assumed, in file order.
    pub notices: Vec<Notice>,
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
/// The result does not depend on how the file is cut. Memory grows with the
/// values that were read, or with what was expected, never with a number that
/// the file states.
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
    Hierarchy(Hierarchy),
    Motion { joints: Vec<Joint>, notices: Vec<Notice>, rows: Rows },
}

impl Reader {
    /// A reader at the beginning of a file.
    pub fn new(options: Options) -> Reader {
        Reader {
            options,
            bytes: 0,
            decoder: Decoder::default(),
            lines: Lines::default(),
            section: Section::Hierarchy(Hierarchy::new(options.limits)),
        }
    }

    /// Takes the next chunk of the file.
    ///
    /// # Errors
    /// If what came so far cannot be read; the reader is then of no further use.
    pub fn push(&mut self, chunk: &[u8]) -> Result<(), Error> {
        self.bytes += chunk.len() as u64;
        if self.bytes > self.options.limits.bytes {
            return Err(Error::whole(Problem::TooLarge(self.options.limits.bytes)));
        }
        let text = self.decoder.decode(chunk);
        let limit = self.options.limits.line_bytes;
        self.section.text(self.options, &mut self.lines, text, limit)
    }

    /// Ends the file.
    ///
    /// # Errors
    /// If the file as a whole cannot be read.
    pub fn finish(mut self) -> Result<Parsed, Error> {
        let rest = self.decoder.finish().to_vec();
        self.section.text(self.options, &mut self.lines, &rest, usize::MAX)?;
        if let Some((line, text)) = self.lines.finish() {
            self.section.last_line(self.options, line, &text)?;
        }
        self.section.finish(self.options)
    }
}

impl Section {
    /// Takes a chunk of text; a line without an end may come to `limit` bytes.
    fn text(
        &mut self,
        options: Options,
        lines: &mut Lines,
        mut text: &[u8],
        limit: usize,
    ) -> Result<(), Error> {
        loop {
            if let Section::Motion { rows, .. } = self
                && lines.at_start()
            {
                lines.skip(rows.plain(&mut text));
            }
            let Some((line, text)) = lines.next(&mut text) else { break };
            self.line(options, line, text)?;
        }
        lines.hold(text, limit).map_err(|line| Error::at(Problem::LineTooLong(limit), line, b"", 0))
    }

    fn line(&mut self, options: Options, line: usize, text: &[u8]) -> Result<(), Error> {
        match self {
            Section::Motion { rows, .. } => rows.line(line, text),
            Section::Hierarchy(hierarchy) => match hierarchy.line(line, text)? {
                Progress::Hierarchy => Ok(()),
                Progress::Motion(rest) => {
                    self.begin_motion(options);
                    self.line(options, line, &text[rest..])
                }
            },
        }
    }

    /// Takes a line that ends with the file, perhaps in the middle of a word.
    fn last_line(&mut self, options: Options, line: usize, text: &[u8]) -> Result<(), Error> {
        match self {
            Section::Motion { rows, .. } => rows.last_line(line, text),
            Section::Hierarchy(_) => self.line(options, line, text).map_err(|error| match self {
                // With braces open, what is wrong is that the file was cut.
                Section::Hierarchy(hierarchy) if hierarchy.is_open() => {
                    hierarchy.finish().err().unwrap_or(error)
                }
                _ => error,
            }),
        }
    }

    fn begin_motion(&mut self, options: Options) {
        if let Section::Hierarchy(hierarchy) = self {
            let rows = Rows::new(options, &hierarchy.joints, hierarchy.decimals);
            let joints = std::mem::take(&mut hierarchy.joints);
            let notices = std::mem::take(&mut hierarchy.notices);
            *self = Section::Motion { joints, notices, rows };
        }
    }

    fn finish(mut self, options: Options) -> Result<Parsed, Error> {
        if let Section::Hierarchy(hierarchy) = &self {
            hierarchy.finish()?;
            self.begin_motion(options);
        }
        let Section::Motion { joints, mut notices, mut rows } = self else {
            unreachable!("the motion has begun");
        };
        let frame_time = rows.finish();
        notices.append(&mut rows.notices);
        let clip = Clip::new(joints, frame_time, rows.values);
        notices.extend(remarks(&clip));
        let rule = position_rule(&clip);
        if rule == PositionRule::Add {
            notices.push(Notice::new(
                Code::AddedPositions,
                "Position channels stay near zero while offsets do not: they are added to the offsets.",
            ));
        }
        Ok(Parsed { clip: clip.with_position_rule(rule), notices })
    }
}

/// Notices about the clip as a whole.
fn remarks(clip: &Clip) -> Vec<Notice> {
    let mut notices = Vec::new();
    let roots: Vec<&str> = clip.roots().map(|root| clip.joints()[root].name.as_str()).collect();
    if roots.len() > 1 {
        let text = format!("The file holds {} skeletons: {}.", roots.len(), roots.join(", "));
        notices.push(Notice::new(Code::SeveralRoots, text));
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
        let text = format!("Several joints share a name: {}.", shared.join(", "));
        notices.push(Notice::new(Code::DuplicateName, text));
    }
    if clip.frame_count() == 0 {
        notices.push(Notice::new(Code::NoMotion, "The file has no motion: its rest pose is shown."));
    }
    notices
}

/// Position channels replace the offset, unless those below the roots are all
/// about zero where the offset is not.
fn position_rule(clip: &Clip) -> PositionRule {
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
    // An offset that is left out would collapse the bone; a millesimal of it is rounding.
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
