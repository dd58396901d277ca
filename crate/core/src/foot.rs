//! The feet and their parts.

use serde::{Deserialize, Serialize};

/// Left or right, as the person who moves would say it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// The left foot.
    Left,
    /// The right foot.
    Right,
}

impl Side {
    /// Both sides, left first.
    pub const BOTH: [Side; 2] = [Side::Left, Side::Right];

    /// The side's name: `left` or `right`.
    pub fn name(self) -> &'static str {
        match self {
            Side::Left => "left",
            Side::Right => "right",
        }
    }
}

/// What of the foot a label speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Part {
    /// Any part of the sole carries weight.
    Contact,
    /// The toe is down and still: the paper's foot plant.
    Toe,
    /// The heel is down and still.
    Heel,
}

impl Part {
    /// All parts, contact first.
    pub const ALL: [Part; 3] = [Part::Contact, Part::Toe, Part::Heel];

    /// The part's name: `contact`, `toe` or `heel`.
    pub fn name(self) -> &'static str {
        match self {
            Part::Contact => "contact",
            Part::Toe => "toe",
            Part::Heel => "heel",
        }
    }
}
