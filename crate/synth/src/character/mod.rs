//! Characters: body proportions, skeleton and file conventions.

mod naming;
mod presets;
mod proportions;
mod rig;

pub use naming::Naming;
pub use presets::{CHARACTER_NAMES, character};
pub use proportions::Proportions;
pub(crate) use rig::lateral_sign;
pub use rig::{BONE_COUNT, Bone, Rig, RigJoint};

use plantigrade::bvh::Axis;

use crate::noise::Noise;

/// A character: body, file conventions and quality of the recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Character {
    /// Short name.
    pub name: &'static str,
    /// Body proportions.
    pub proportions: Proportions,
    /// Joint naming convention.
    pub naming: Naming,
    /// Number of spine joints: 2 or 3.
    pub spine_joints: usize,
    /// Length unit of the file.
    pub unit: Unit,
    /// Up axis of the file.
    pub up: Up,
    /// Order of the rotation channels.
    pub rotation_order: [Axis; 3],
    /// Joints with position channels.
    pub position_channels: PositionChannels,
    /// Number of decimals in the file.
    pub decimals: Decimals,
    /// Noise of the feet.
    pub noise: Noise,
}

/// Length unit of a file.
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
    /// Returns the number of file units per metre.
    pub fn per_metre(self) -> f64 {
        match self {
            Unit::Metre => 1.0,
            Unit::Centimetre => 100.0,
            Unit::Inch => 1.0 / 0.0254,
            Unit::Asf => 1.0 / 0.0564,
        }
    }
}

/// Number of decimals in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimals {
    /// Compact: a resolution of about 0.01 mm, for small files.
    Compact,
    /// Six, as written by recording software.
    Six,
}

impl Decimals {
    /// Returns the number of decimals of lengths in `unit`.
    pub fn for_lengths(self, unit: Unit) -> usize {
        match (self, unit) {
            (Decimals::Six, _) => 6,
            (Decimals::Compact, Unit::Metre) => 5,
            (Decimals::Compact, Unit::Asf) => 4,
            (Decimals::Compact, Unit::Centimetre | Unit::Inch) => 3,
        }
    }

    /// Returns the number of decimals of angles in degrees.
    pub fn for_angles(self) -> usize {
        match self {
            Decimals::Compact => 4,
            Decimals::Six => 6,
        }
    }
}

/// Up axis of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// Y up, Z forward.
    Y,
    /// Z up, −Y forward.
    Z,
}

/// Joints of a file with position channels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PositionChannels {
    /// The root only.
    Root,
    /// All joints; positions of non-root joints equal their offsets in every frame.
    All,
}
