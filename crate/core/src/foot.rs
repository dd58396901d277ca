//! Sides of the body and parts of a foot.

use serde::{Deserialize, Serialize};

/// Side of the body, from the character's own view.
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

    /// Returns the name: `left` or `right`.
    pub fn name(self) -> &'static str {
        match self {
            Side::Left => "left",
            Side::Right => "right",
        }
    }
}

/// Part of a foot that a label describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Part {
    /// Any part of the foot bears on the ground.
    Contact,
    /// The toe is on the ground and still: the foot plant of the paper.
    Toe,
    /// The heel is on the ground and still.
    Heel,
}

impl Part {
    /// All parts, contact first.
    pub const ALL: [Part; 3] = [Part::Contact, Part::Toe, Part::Heel];

    /// Returns the name: `contact`, `toe` or `heel`.
    pub fn name(self) -> &'static str {
        match self {
            Part::Contact => "contact",
            Part::Toe => "toe",
            Part::Heel => "heel",
        }
    }
}
