//! Why a file cannot be read: what, where and what to do.

use crate::notice::Place;

/// What is wrong with a file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// No bytes, or nothing but blanks.
    #[error("the file is empty")]
    Empty,
    /// Something else than BVH, and what it looks like.
    #[error("this is not a BVH file: it looks like {0}")]
    NotBvh(&'static str),
    /// One thing stands where another must.
    #[error("expected {expected}, found {found:?}")]
    Unexpected {
        /// What BVH has in this place.
        expected: &'static str,
        /// What the file has.
        found: String,
    },
    /// A channel that is neither a position nor a rotation.
    #[error("unknown channel {0:?}")]
    UnknownChannel(String),
    /// The hierarchy breaks off.
    #[error("the hierarchy breaks off: {open} of its braces are still open")]
    OpenBraces {
        /// Number of braces that were not closed.
        open: usize,
    },
    /// `HIERARCHY` without a `ROOT`.
    #[error("the file has no joints")]
    NoJoints,
    /// A value of the motion that is no number.
    #[error("expected a number, found {found:?} (frame {frame}, channel {channel})")]
    BadValue {
        /// What the file has.
        found: String,
        /// The frame, from 0.
        frame: usize,
        /// Joint and channel, as in `LeftFoot Zrotation`.
        channel: String,
    },
    /// Lines that do not make whole frames.
    #[error("a frame has {expected} numbers, but the lines from here on make {found} (frame {frame})")]
    RaggedRow {
        /// Channels of the hierarchy.
        expected: usize,
        /// Numbers that the lines make together.
        found: usize,
        /// The frame, from 0.
        frame: usize,
    },
    /// Decimal commas and decimal points in one file.
    #[error("the file mixes decimal commas and decimal points")]
    MixedDecimals,
    /// More bytes than [`Limits::bytes`](crate::bvh::Limits::bytes).
    #[error("the file is larger than the limit of {0} bytes")]
    TooLarge(u64),
    /// A line longer than [`Limits::line_bytes`](crate::bvh::Limits::line_bytes).
    #[error("the line is longer than the limit of {0} bytes")]
    LineTooLong(usize),
    /// More joints than [`Limits::joints`](crate::bvh::Limits::joints).
    #[error("the skeleton has more than {0} joints")]
    TooManyJoints(usize),
    /// A deeper hierarchy than [`Limits::depth`](crate::bvh::Limits::depth).
    #[error("the hierarchy is more than {0} joints deep")]
    TooDeep(usize),
}

impl Problem {
    /// What the person who has the file can do about it.
    pub fn hint(&self) -> &'static str {
        match self {
            Problem::Empty => "Export the file again, or see whether the copy or download was cut off.",
            Problem::NotBvh(_) => "Open the motion in the program that wrote it and export it as BVH.",
            Problem::Unexpected { .. } => {
                "Compare the line with a file that works, or export the file again."
            }
            Problem::UnknownChannel(_) => {
                "BVH knows Xposition, Yposition, Zposition, Xrotation, Yrotation and Zrotation."
            }
            Problem::OpenBraces { .. } => {
                "The file was probably cut off while it was written or copied: export it again."
            }
            Problem::NoJoints => "A BVH file needs a ROOT under HIERARCHY: export it with its skeleton.",
            Problem::BadValue { .. } => {
                "Correct the value, or read the file leniently to hold the previous frame's value."
            }
            Problem::RaggedRow { .. } => {
                "Values are missing or superfluous here, or the CHANNELS lines do not belong to this motion."
            }
            Problem::MixedDecimals => "Replace the commas by points throughout the file.",
            Problem::TooLarge(_) | Problem::LineTooLong(_) => "Cut the motion into shorter files.",
            Problem::TooManyJoints(_) | Problem::TooDeep(_) => {
                "No figure needs that many joints: the file is probably damaged."
            }
        }
    }

    /// Whether a limit was exceeded, rather than the file being wrong.
    pub fn is_limit(&self) -> bool {
        matches!(
            self,
            Problem::TooLarge(_) | Problem::LineTooLong(_) | Problem::TooManyJoints(_) | Problem::TooDeep(_)
        )
    }
}

/// Why a file cannot be read.
///
/// Displays as `412:17: expected a number, found "abc" (...)`; put the file's
/// name and a colon before it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// What is wrong.
    pub problem: Problem,
    /// Where, unless it is about the file as a whole.
    pub place: Option<Place>,
    /// The line in question, shortened around the place if it is long.
    pub excerpt: Option<Excerpt>,
}

/// A piece of the offending line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excerpt {
    /// The text, at most 80 characters.
    pub text: String,
    /// The column in `text`, from 0, to put a caret under.
    pub caret: usize,
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if let Some(place) = self.place {
            write!(f, "{place}: ")?;
        }
        self.problem.fmt(f)
    }
}

impl std::error::Error for Error {}

impl Error {
    /// An error about the file as a whole.
    pub(crate) fn whole(problem: Problem) -> Error {
        Error { problem, place: None, excerpt: None }
    }

    /// An error at byte `at` of line number `line` whose text is `text`.
    pub(crate) fn at(problem: Problem, line: usize, text: &[u8], at: usize) -> Error {
        let place = place(line, text, at);
        Error { problem, place: Some(place), excerpt: Some(Excerpt::around(text, place.column - 1)) }
    }
}

/// The place of byte `at` in line number `line` whose text is `text`.
pub(crate) fn place(line: usize, text: &[u8], at: usize) -> Place {
    Place { line, column: String::from_utf8_lossy(&text[..at.min(text.len())]).chars().count() + 1 }
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
