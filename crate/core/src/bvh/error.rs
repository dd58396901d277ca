//! Errors of the reader: what is wrong, where, and what to do.

use crate::notice::Location;

/// Kind of an error.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ErrorKind {
    /// The file has no bytes, or only blanks.
    #[error("the file is empty")]
    Empty,
    /// The file is not BVH; it looks like another format.
    #[error("this is not a BVH file: it looks like {0}")]
    NotBvh(&'static str),
    /// The file contains an unexpected token.
    #[error("expected {expected}, found {found:?}")]
    Unexpected {
        /// Tokens that the format allows.
        expected: &'static str,
        /// Text in the file.
        found: String,
    },
    /// A channel is not a position, rotation or scale.
    #[error("unknown channel {0:?}")]
    UnknownChannel(String),
    /// The file ends within the hierarchy.
    #[error("the hierarchy is incomplete: {}", open_braces(*.open))]
    UnclosedBraces {
        /// Number of braces that were not closed.
        open: usize,
    },
    /// There is no `ROOT` after `HIERARCHY`.
    #[error("the file has no joints")]
    NoJoints,
    /// A value of the motion is not a number.
    #[error("expected a number, found {found:?} (frame {frame}, channel {channel})")]
    BadValue {
        /// Text in the file.
        found: String,
        /// Frame, from 0.
        frame: usize,
        /// Joint and channel, as in `LeftFoot Zrotation`.
        channel: String,
    },
    /// A value is larger than [`Limits::value`](crate::bvh::Limits::value).
    #[error("the value {found} is beyond the limit of ±{limit:e} ({place})")]
    LargeValue {
        /// Text in the file.
        found: String,
        /// The limit.
        limit: f64,
        /// Frame from 0 and channel, as in `frame 3, channel LeftFoot Zrotation`, or `OFFSET`.
        place: String,
    },
    /// Lines do not form complete frames.
    #[error("a frame has {expected} numbers, but the lines from here have {found} (frame {frame})")]
    RaggedRow {
        /// Number of channels.
        expected: usize,
        /// Total count of numbers on the lines.
        found: usize,
        /// Frame, from 0.
        frame: usize,
    },
    /// Each row begins with a number that is not a channel: of the frame, or its time.
    #[error(
        "each row has {expected} numbers for {channels} channels and seems to begin with {column}",
        expected = channels + 1
    )]
    ExtraColumn {
        /// Number of channels.
        channels: usize,
        /// Content of the column.
        column: &'static str,
    },
    /// The file has both decimal commas and decimal points.
    #[error("the file mixes decimal commas and decimal points")]
    MixedDecimals,
    /// The file is larger than [`Limits::bytes`](crate::bvh::Limits::bytes).
    #[error("the file is larger than the limit of {0} bytes")]
    TooLarge(u64),
    /// A line is longer than [`Limits::line_bytes`](crate::bvh::Limits::line_bytes).
    #[error("the line is longer than the limit of {0} bytes")]
    LineTooLong(usize),
    /// The file has more joints than [`Limits::joints`](crate::bvh::Limits::joints).
    #[error("the skeleton has more than {0} joints")]
    TooManyJoints(usize),
    /// The hierarchy is deeper than [`Limits::depth`](crate::bvh::Limits::depth).
    #[error("the hierarchy is more than {0} joints deep")]
    TooDeep(usize),
}

impl ErrorKind {
    /// Returns advice on how to fix the file.
    pub fn hint(&self) -> &'static str {
        match self {
            ErrorKind::Empty => {
                "Export the file again, or check whether the copy or download was incomplete."
            }
            ErrorKind::NotBvh(_) => "Open the motion in the program that wrote it and export it as BVH.",
            ErrorKind::Unexpected { .. } => {
                "Compare the line with a file that works, or export the file again."
            }
            ErrorKind::UnknownChannel(_) => {
                "BVH has the channels Xposition, Yposition, Zposition, Xrotation, Yrotation and Zrotation."
            }
            ErrorKind::UnclosedBraces { .. } => {
                "The file was probably cut off while it was written or copied. Export it again."
            }
            ErrorKind::NoJoints => {
                "A BVH file needs a ROOT after HIERARCHY. Export the motion with its skeleton."
            }
            ErrorKind::BadValue { .. } => {
                "Correct the value, or read the file leniently to repeat the value of the previous frame."
            }
            ErrorKind::LargeValue { .. } => {
                "No motion has such values: the file is damaged or has another unit. Read it leniently to repeat \
                 the value of the previous frame."
            }
            ErrorKind::RaggedRow { .. } => {
                "Numbers are missing or superfluous here, or the CHANNELS lines belong to another motion."
            }
            ErrorKind::ExtraColumn { .. } => {
                "Remove the first number of each row, or export the motion without numbered frames."
            }
            ErrorKind::MixedDecimals => "Replace all decimal commas by points.",
            ErrorKind::TooLarge(_) | ErrorKind::LineTooLong(_) => "Split the motion into shorter files.",
            ErrorKind::TooManyJoints(_) | ErrorKind::TooDeep(_) => {
                "No character needs that many joints. The file is probably damaged."
            }
        }
    }

    /// True if the file exceeds a limit rather than being malformed.
    pub fn is_limit(&self) -> bool {
        matches!(
            self,
            ErrorKind::TooLarge(_)
                | ErrorKind::LineTooLong(_)
                | ErrorKind::TooManyJoints(_)
                | ErrorKind::TooDeep(_)
        )
    }
}

fn open_braces(count: usize) -> String {
    match count {
        0 => "the file ends before a brace".into(),
        1 => "1 brace is not closed".into(),
        _ => format!("{count} braces are not closed"),
    }
}

/// Error of the reader.
///
/// Displays as `412:17: expected a number, found "abc" (...)`. Prepend the file name and a colon.
#[derive(Clone, Debug, PartialEq)]
pub struct Error {
    /// Kind of the error.
    pub kind: ErrorKind,
    /// Location; `None` if the error concerns the whole file.
    pub location: Option<Location>,
    /// The line at the location, shortened if it is long.
    pub excerpt: Option<Excerpt>,
}

/// Part of a line that contains an error.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excerpt {
    /// Text of at most 80 characters.
    pub text: String,
    /// Column of the error in `text`, from 0.
    pub caret: usize,
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if let Some(location) = self.location {
            write!(f, "{location}: ")?;
        }
        self.kind.fmt(f)
    }
}

impl std::error::Error for Error {}

impl Error {
    /// Creates an error that concerns the whole file.
    pub(crate) fn in_file(kind: ErrorKind) -> Error {
        Error { kind, location: None, excerpt: None }
    }

    /// Creates an error at byte `at` of line number `line` with the text `text`.
    pub(crate) fn at(kind: ErrorKind, line: usize, text: &[u8], at: usize) -> Error {
        let location = location(line, text, at);
        Error { kind, location: Some(location), excerpt: Some(Excerpt::around(text, location.column - 1)) }
    }
}

/// Returns the location of byte `at` in line number `line` with the text `text`.
pub(crate) fn location(line: usize, text: &[u8], at: usize) -> Location {
    Location { line, column: String::from_utf8_lossy(&text[..at.min(text.len())]).chars().count() + 1 }
}

impl Excerpt {
    const WIDTH: usize = 80;

    fn around(line: &[u8], caret: usize) -> Excerpt {
        let from = if caret < Excerpt::WIDTH - 20 { 0 } else { caret - Excerpt::WIDTH / 2 };
        let text = String::from_utf8_lossy(line)
            .chars()
            .skip(from)
            .take(Excerpt::WIDTH)
            .map(|c| if c.is_control() { ' ' } else { c })
            .collect();
        Excerpt { text, caret: caret - from }
    }
}
