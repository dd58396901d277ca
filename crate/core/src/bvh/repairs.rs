//! Repairs and assumptions of the reader that may occur many times in a file.

use crate::bvh::Joint;
use crate::notice::{Code, Location, Notice, shortened};

/// One kind of repair, with the details of its first occurrence.
#[derive(Clone, Debug)]
pub(crate) enum Repair {
    MissingHierarchy,
    MissingName,
    MissingOffset {
        joint: usize,
    },
    SecondOffset {
        joint: usize,
    },
    ChannelCount {
        joint: usize,
        declared: usize,
        listed: usize,
    },
    EndSite,
    ScaleChannel,
    /// A frame time with a unit or as a fraction.
    FrameTimeUnit {
        found: String,
        seconds: f64,
    },
    /// Another number of frames or another frame time than stated before.
    SecondStatement {
        code: Code,
    },
    /// Text after a statement of the header.
    UnusedText {
        found: String,
        code: Code,
    },
    LongRow {
        channels: usize,
    },
    WrappedRow,
    TrailingMatter,
    HeldValue,
}

/// Repairs in the order of their first occurrence.
///
/// Memory and time do not grow with the number of occurrences.
#[derive(Debug, Default)]
pub(crate) struct Repairs(Vec<Occurrences>);

/// Occurrences of one kind of repair.
#[derive(Debug)]
struct Occurrences {
    repair: Repair,
    first: Location,
    count: usize,
}

impl Repairs {
    /// Adds an occurrence; `location` is evaluated for the first one only.
    pub fn add(&mut self, repair: Repair, location: impl FnOnce() -> Location) {
        let kind = |repair: &Repair| (std::mem::discriminant(repair), repair.code());
        let same = kind(&repair);
        match self.0.iter_mut().find(|other| kind(&other.repair) == same) {
            Some(occurrences) => occurrences.count += 1,
            None => self.0.push(Occurrences { repair, first: location(), count: 1 }),
        }
    }

    /// Removes all repairs and returns one notice for each kind.
    pub fn take_notices(&mut self, joints: &[Joint]) -> Vec<Notice> {
        self.0.drain(..).map(|occurrences| occurrences.notice(joints)).collect()
    }
}

impl Occurrences {
    fn notice(&self, joints: &[Joint]) -> Notice {
        let text = self.repair.text(self.count, joints);
        Notice { code: self.repair.code(), location: Some(self.first), text }
    }
}

impl Repair {
    fn code(&self) -> Code {
        match self {
            Repair::MissingHierarchy => Code::MissingHierarchy,
            Repair::MissingName => Code::MissingName,
            Repair::MissingOffset { .. } | Repair::SecondOffset { .. } => Code::Offset,
            Repair::ChannelCount { .. } => Code::ChannelCount,
            Repair::EndSite => Code::EndSite,
            Repair::ScaleChannel => Code::ScaleChannels,
            Repair::FrameTimeUnit { .. } => Code::FrameTime,
            Repair::UnusedText { code, .. } | Repair::SecondStatement { code } => *code,
            Repair::LongRow { .. } => Code::LongRow,
            Repair::WrappedRow => Code::WrappedRow,
            Repair::TrailingMatter => Code::TrailingMatter,
            Repair::HeldValue => Code::HeldValue,
        }
    }

    fn text(&self, count: usize, joints: &[Joint]) -> String {
        let name = |joint: usize| shortened(&joints[joint].name);
        let lines = if count == 1 { "1 line".into() } else { format!("{count} lines") };
        // The details are those of the first occurrence.
        let first = |text: String| match count {
            1 => text,
            2 => format!("{text} The same occurs once more."),
            _ => format!("{text} The same occurs {} more times.", count - 1),
        };
        match self {
            Repair::MissingHierarchy => "The file does not begin with HIERARCHY.".into(),
            Repair::MissingName => first("A joint has no name.".into()),
            &Repair::MissingOffset { joint } => {
                first(format!("{} has no OFFSET; zero is used.", name(joint)))
            }
            &Repair::SecondOffset { joint } => {
                first(format!("{} has a second OFFSET; the last one is used.", name(joint)))
            }
            &Repair::ChannelCount { joint, declared, listed } => first(format!(
                "{} states {declared} channels and lists {listed}; the listed channels are used.",
                name(joint)
            )),
            Repair::EndSite => first("An end site has channels or joints; it was read as a joint.".into()),
            Repair::ScaleChannel => {
                format!("{count} scale channels were read and are not used; joints keep their size.")
            }
            Repair::FrameTimeUnit { found, seconds } => {
                first(format!("The frame time is stated as {found:?} and was read as {seconds:.6} s."))
            }
            Repair::SecondStatement { code } => {
                let what = if *code == Code::FrameTime { "Frame Time:" } else { "Frames:" };
                first(format!("The file has a second {what:?}; the last one is used."))
            }
            Repair::UnusedText { found, .. } => first(format!("The text {found:?} was ignored.")),
            Repair::LongRow { channels } => {
                format!("{lines} with more than {channels} numbers: the extra numbers were left out.")
            }
            Repair::WrappedRow => format!("Frames are wrapped over several lines ({lines} more)."),
            Repair::TrailingMatter => format!("{lines} after the last frame were left out."),
            Repair::HeldValue => {
                let values = if count == 1 { "1 value".into() } else { format!("{count} values") };
                format!("{values} that cannot be read: the values of the previous frame were repeated.")
            }
        }
    }
}
