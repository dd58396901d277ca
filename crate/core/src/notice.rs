//! Notices: assumptions, repairs and warnings of the reader and the methods.

use std::borrow::Cow;
use std::fmt;

use serde::{Deserialize, Serialize};

/// Location in a file; lines and columns count from 1, columns in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Location {
    /// Line number.
    pub line: usize,
    /// Column of the first character.
    pub column: usize,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// Subject of a [`Notice`]; its JSON form is the kebab-case name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Code {
    /// The file does not begin with `HIERARCHY`.
    MissingHierarchy,
    /// A joint has no name.
    MissingName,
    /// A joint has no `OFFSET`, or more than one.
    Offset,
    /// An end site has channels or joints; it was read as a joint.
    EndSite,
    /// Joint names are neither UTF-8 nor UTF-16; their encoding was guessed.
    NameEncoding,
    /// Scale channels were read and are not used.
    ScaleChannels,
    /// `CHANNELS` states a number that differs from the channels listed.
    ChannelCount,
    /// Several joints share a name.
    DuplicateName,
    /// The file contains more than one skeleton.
    SeveralRoots,
    /// Another BVH file, or another motion, follows the first; it was left out.
    SeveralMotions,
    /// Position channels are added to the offsets instead of replacing them.
    AddedPositions,
    /// `Frames:` is missing, unreadable or differs from the number of rows.
    FrameCount,
    /// `Frame Time:` is missing, unreadable or implausible.
    FrameTime,
    /// The file has no motion; the clip is a rest pose.
    NoMotion,
    /// A row has more numbers than channels.
    LongRow,
    /// Rows are wrapped over several lines.
    WrappedRow,
    /// The last row is incomplete.
    IncompleteRow,
    /// Lines after the motion section were left out.
    TrailingMatter,
    /// Numbers use decimal commas.
    DecimalComma,
    /// A value that is not a number was replaced by the value of the previous frame.
    HeldValue,
    /// No feet were found.
    NoFeet,
    /// The skeleton has no toe joint; another joint replaces it.
    NoToe,
    /// The feet were found by the structure of the skeleton and not by names.
    DoubtfulRole,
    /// The skeleton has four legs, of which the hind ones are measured.
    Quadruped,
    /// The motion does not show for certain which axis points up.
    UpAxis,
    /// The unit of length is uncertain.
    Unit,
    /// Frames at the start or end that do not belong to the motion were left out.
    Trimmed,
    /// The motion jumps within the clip.
    Teleport,
    /// The clip has too few frames to cluster or segment.
    ShortClip,
    /// The character stands still; every frame is contact.
    StandingStill,
    /// Movements of the feet are too slow and too short for steps and count as contact.
    CaptureNoise,
    /// Planted feet move at one velocity while the hips stay: a treadmill is assumed.
    Belt,
    /// The hips never move: the ground is where the lower foot is.
    FixedHips,
    /// A foot moves along the ground: it is dragged and not planted.
    Dragged,
    /// The skeleton lacks joints that a method measures.
    MissingJoints,
    /// The feet are implausibly fast or slow: the frame rate may be wrong.
    ImplausibleRate,
    /// A foot, or the whole character, is in the air implausibly long.
    ImplausibleAirborne,
    /// The hips jump to another place and back; they are interpolated there.
    Spike,
    /// Corrections of a person were applied to similar motion.
    Corrections,
    /// Clean-up left some plants unchanged.
    Unconstrained,
    /// Clean-up cannot move the hips because their joint has no position channels.
    FixedRoot,
    /// No foot is planted; there is no foot skate to remove.
    NothingPlanted,
}

impl Code {
    /// Returns the name, as in `frame-count`.
    pub fn name(self) -> String {
        match serde_json::to_value(self) {
            Ok(serde_json::Value::String(name)) => name,
            _ => unreachable!("a code is written as its name"),
        }
    }
}

/// Information for the user about a clip or a result.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Notice {
    /// Subject.
    pub code: Code,
    /// Location in the file, if any.
    #[serde(flatten)]
    pub location: Option<Location>,
    /// Finding and action taken, in one sentence.
    pub text: String,
}

impl Notice {
    /// Creates a notice without a location.
    pub fn new(code: Code, text: impl Into<String>) -> Notice {
        Notice { code, location: None, text: text.into() }
    }
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(location) = self.location {
            write!(f, "{location}: ")?;
        }
        f.write_str(&self.text)
    }
}

/// Number of characters of a name in a notice.
const NAME_CHARS: usize = 60;

/// Number of names that a notice lists.
const LISTED_NAMES: usize = 20;

/// Returns a name for a text: its beginning if it is long.
pub(crate) fn shortened(name: &str) -> Cow<'_, str> {
    match name.char_indices().nth(NAME_CHARS) {
        Some((end, _)) => Cow::Owned(format!("{}…", &name[..end])),
        None => Cow::Borrowed(name),
    }
}

/// Returns the first names as a list, with the number of others.
pub(crate) fn list(names: &[&str]) -> String {
    let shown: Vec<_> = names.iter().take(LISTED_NAMES).map(|name| shortened(name)).collect();
    match names.len() - shown.len() {
        0 => shown.join(", "),
        more => format!("{} and {more} more", shown.join(", ")),
    }
}
