//! Joint names in common conventions.

use plantigrade::foot::Side;

use super::Bone;

/// Joint naming convention.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Naming {
    /// `LeftUpLeg`, `LeftLeg`, `LeftFoot`, `LeftToeBase`: MotionBuilder and most CMU conversions.
    MotionBuilder,
    /// MotionBuilder names with the prefix `mixamorig:`.
    Mixamo,
    /// `Thigh_L`, `Shin_L`, `Foot_L`, `Toe_L`: the side as a suffix.
    Suffix,
    /// `lThigh`, `lShin`, `lFoot`, `lToe`: Poser and Daz Studio.
    Daz,
    /// `Bip01 L Thigh`, `Bip01 L Calf`, `Bip01 L Foot`, `Bip01 L Toe0`: 3ds Max Biped.
    Biped,
}

impl Naming {
    /// Returns the name of the joint that rotates `bone`.
    pub fn name(self, bone: Bone) -> String {
        match self {
            Naming::MotionBuilder => motion_builder(bone),
            Naming::Mixamo => format!("mixamorig:{}", motion_builder(bone)),
            Naming::Suffix => suffixed(bone),
            Naming::Daz => daz(bone),
            Naming::Biped => biped(bone),
        }
    }
}

fn pick(side: Side, left: &'static str, right: &'static str) -> &'static str {
    match side {
        Side::Left => left,
        Side::Right => right,
    }
}

fn motion_builder(bone: Bone) -> String {
    let sided = |side, name: &str| format!("{}{name}", pick(side, "Left", "Right"));
    match bone {
        Bone::Hips => "Hips".into(),
        Bone::Spine(0) => "Spine".into(),
        Bone::Spine(n) => format!("Spine{n}"),
        Bone::Neck => "Neck".into(),
        Bone::Head => "Head".into(),
        Bone::Clavicle(side) => sided(side, "Shoulder"),
        Bone::UpperArm(side) => sided(side, "Arm"),
        Bone::Forearm(side) => sided(side, "ForeArm"),
        Bone::Hand(side) => sided(side, "Hand"),
        Bone::Thigh(side) => sided(side, "UpLeg"),
        Bone::Shank(side) => sided(side, "Leg"),
        Bone::Foot(side) => sided(side, "Foot"),
        Bone::Toe(side) => sided(side, "ToeBase"),
    }
}

fn suffixed(bone: Bone) -> String {
    let sided = |side, name: &str| format!("{name}_{}", pick(side, "L", "R"));
    match bone {
        Bone::Hips => "Pelvis".into(),
        Bone::Spine(n) => format!("Spine_{}", n + 1),
        Bone::Neck => "Neck".into(),
        Bone::Head => "Head".into(),
        Bone::Clavicle(side) => sided(side, "Clavicle"),
        Bone::UpperArm(side) => sided(side, "UpperArm"),
        Bone::Forearm(side) => sided(side, "Forearm"),
        Bone::Hand(side) => sided(side, "Hand"),
        Bone::Thigh(side) => sided(side, "Thigh"),
        Bone::Shank(side) => sided(side, "Shin"),
        Bone::Foot(side) => sided(side, "Foot"),
        Bone::Toe(side) => sided(side, "Toe"),
    }
}

fn daz(bone: Bone) -> String {
    let sided = |side, name: &str| format!("{}{name}", pick(side, "l", "r"));
    match bone {
        Bone::Hips => "hip".into(),
        Bone::Spine(0) => "abdomen".into(),
        Bone::Spine(1) => "chest".into(),
        Bone::Spine(n) => format!("chest{n}"),
        Bone::Neck => "neck".into(),
        Bone::Head => "head".into(),
        Bone::Clavicle(side) => sided(side, "Collar"),
        Bone::UpperArm(side) => sided(side, "Shldr"),
        Bone::Forearm(side) => sided(side, "ForeArm"),
        Bone::Hand(side) => sided(side, "Hand"),
        Bone::Thigh(side) => sided(side, "Thigh"),
        Bone::Shank(side) => sided(side, "Shin"),
        Bone::Foot(side) => sided(side, "Foot"),
        Bone::Toe(side) => sided(side, "Toe"),
    }
}

fn biped(bone: Bone) -> String {
    let sided = |side, name: &str| format!("Bip01 {} {name}", pick(side, "L", "R"));
    match bone {
        Bone::Hips => "Bip01".into(),
        Bone::Spine(0) => "Bip01 Spine".into(),
        Bone::Spine(n) => format!("Bip01 Spine{n}"),
        Bone::Neck => "Bip01 Neck".into(),
        Bone::Head => "Bip01 Head".into(),
        Bone::Clavicle(side) => sided(side, "Clavicle"),
        Bone::UpperArm(side) => sided(side, "UpperArm"),
        Bone::Forearm(side) => sided(side, "Forearm"),
        Bone::Hand(side) => sided(side, "Hand"),
        Bone::Thigh(side) => sided(side, "Thigh"),
        Bone::Shank(side) => sided(side, "Calf"),
        Bone::Foot(side) => sided(side, "Foot"),
        Bone::Toe(side) => sided(side, "Toe0"),
    }
}
