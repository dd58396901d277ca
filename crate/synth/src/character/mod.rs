//! Who moves, and how their skeleton is written down.

mod build;
mod cast;
mod naming;
mod rig;

pub use build::Build;
pub use cast::{CAST, character};
pub use naming::Naming;
pub(crate) use rig::outward;
pub use rig::{BONE_COUNT, Bone, Rig, RigJoint};

use plantigrade::bvh::Axis;

use crate::noise::Noise;

/// A performer: body, file conventions and the quality of the recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Character {
    /// A short name.
    pub name: &'static str,
    /// The body.
    pub build: Build,
    /// What the joints are called.
    pub naming: Naming,
    /// Joints in the spine: 2 or 3.
    pub spine_joints: usize,
    /// The unit of length of the file.
    pub unit: Unit,
    /// The axis that points up in the file.
    pub up: Up,
    /// The order in which rotation channels are written.
    pub rotation_order: [Axis; 3],
    /// Which joints have position channels.
    pub positions: Positions,
    /// How many decimals are written.
    pub decimals: Decimals,
    /// Noise of this character's feet.
    pub noise: Noise,
}

/// The unit of length of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Metre.
    Metre,
    /// Centimetre.
    Centimetre,
    /// Inch.
    Inch,
    /// The unit of the CMU database's ASF files, 0.0564 m.
    Asf,
}

impl Unit {
    /// File units in one metre.
    pub fn per_metre(self) -> f64 {
        match self {
            Unit::Metre => 1.0,
            Unit::Centimetre => 100.0,
            Unit::Inch => 1.0 / 0.0254,
            Unit::Asf => 1.0 / 0.0564,
        }
    }
}

/// Decimals of the numbers in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimals {
    /// As many as resolve about a hundredth of a millimetre: small files.
    Enough,
    /// Six, as recording software writes them.
    Six,
}

impl Decimals {
    /// Of lengths in `unit`.
    pub fn of_lengths(self, unit: Unit) -> usize {
        match (self, unit) {
            (Decimals::Six, _) => 6,
            (Decimals::Enough, Unit::Metre) => 5,
            (Decimals::Enough, Unit::Asf) => 4,
            (Decimals::Enough, Unit::Centimetre | Unit::Inch) => 3,
        }
    }

    /// Of angles in degrees.
    pub fn of_angles(self) -> usize {
        match self {
            Decimals::Enough => 4,
            Decimals::Six => 6,
        }
    }
}

/// The axis that points up in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// Y up, Z forward.
    Y,
    /// Z up, −Y forward.
    Z,
}

/// Which joints of a file have position channels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Positions {
    /// The root alone.
    Root,
    /// All joints; they repeat their offsets in every frame.
    All,
}
