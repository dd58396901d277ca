//! Notices: what was repaired, assumed or doubted on the way, so that nothing happens silently.

use std::fmt;

use serde::Deserialize;
use serde::Serialize;

/// A place in a file, counted from 1; columns count characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// Line number.
    pub line: usize,
    /// Column of the first character meant.
    pub column: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// What a [`Notice`] is about; its JSON form is the kebab-case name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Code {
    /// The file does not begin with `HIERARCHY`.
    MissingHierarchy,
    /// A joint has no name.
    MissingName,
    /// A joint has no `OFFSET`, or more than one.
    Offset,
    /// `CHANNELS` states another number than it names.
    ChannelCount,
    /// Several joints share a name.
    DuplicateName,
    /// The file holds more than one skeleton.
    SeveralRoots,
    /// Position channels are added to offsets instead of replacing them.
    AddedPositions,
    /// `Frames:` is missing or unreadable, or is not the number of rows.
    FrameCount,
    /// `Frame Time:` is missing, unreadable or absurd.
    FrameTime,
    /// There is no motion: the clip is a rest pose.
    NoMotion,
    /// A row has more numbers than channels.
    LongRow,
    /// Rows are wrapped over several lines.
    WrappedRow,
    /// The last row breaks off.
    IncompleteRow,
    /// Lines after the motion are not part of it.
    TrailingMatter,
    /// Decimal commas.
    DecimalComma,
    /// A value that is no number was replaced by the previous frame's.
    HeldValue,
    /// Feet were not found.
    NoFeet,
    /// The skeleton has no toe joint; another joint stands in.
    NoToe,
    /// The up axis could not be told from the motion.
    UpAxis,
    /// Leading or trailing frames that do not belong to the motion were left out.
    Trimmed,
    /// The motion jumps in mid-clip.
    Teleport,
    /// Too few frames to cluster, or to cut.
    ShortClip,
    /// The clip stands still: every frame is contact.
    StandingStill,
    /// A foot moves along the ground: it is dragged, not planted.
    Dragged,
    /// The skeleton lacks joints that a method would measure.
    MissingJoints,
    /// The feet are implausibly fast or slow: the stated rate may be wrong.
    ImplausibleRate,
    /// The labels leave a foot or the person in the air implausibly long.
    ImplausibleAirborne,
    /// Plants that clean-up left as they are.
    Unconstrained,
    /// Clean-up cannot move the hips: their joint has no position channels.
    FixedRoot,
    /// Nothing is planted: there is no foot skate to clean up.
    NothingPlanted,
}

impl Code {
    /// The code's name, as in `frame-count`.
    pub fn name(self) -> String {
        match serde_json::to_value(self) {
            Ok(serde_json::Value::String(name)) => name,
            _ => unreachable!("a code is written as its name"),
        }
    }
}

/// One thing that a person should know about a clip or its labels.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Notice {
    /// What it is about.
    pub code: Code,
    /// Where in the file, if anywhere.
    #[serde(flatten)]
    pub place: Option<Place>,
    /// What was found and what was done, in a sentence.
    pub text: String,
}

impl Notice {
    /// A notice that belongs to no line of the file.
    pub fn new(code: Code, text: impl Into<String>) -> Notice {
        Notice { code, place: None, text: text.into() }
    }
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = self.place {
            write!(f, "{place}: ")?;
        }
        f.write_str(&self.text)
    }
}
