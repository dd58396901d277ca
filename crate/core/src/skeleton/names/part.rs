//! Body parts in joint names.

/// Body part that a joint is named after.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum BodyPart {
    Hips,
    Spine,
    Neck,
    Head,
    /// Collar bone, or the upper arm if no collar bone is named.
    Shoulder,
    Arm,
    Forearm,
    Hand,
    Finger,
    /// Joint between pelvis and hip joint, which is no part of the leg.
    PelvisSide,
    /// Hip: the pelvis without a side; with a side the thigh, if no joint below is named after it.
    Hip,
    Thigh,
    /// Leg: the shank below a thigh, the thigh above a shank.
    Leg,
    Shank,
    Ankle,
    /// Foot: the ankle, or the middle of the foot below a joint named ankle or foot.
    Foot,
    Heel,
    Toe,
    /// A part that is neither limb nor trunk, such as a wing, a skirt or a weapon.
    Other,
}

impl BodyPart {
    /// All parts with their names in the documentation.
    pub const NAMES: [(BodyPart, &'static str); 19] = [
        (BodyPart::Hips, "hips"),
        (BodyPart::Spine, "spine"),
        (BodyPart::Neck, "neck"),
        (BodyPart::Head, "head"),
        (BodyPart::Shoulder, "shoulder"),
        (BodyPart::Arm, "upper arm"),
        (BodyPart::Forearm, "forearm"),
        (BodyPart::Hand, "hand"),
        (BodyPart::Finger, "finger"),
        (BodyPart::PelvisSide, "side of the pelvis"),
        (BodyPart::Hip, "hip"),
        (BodyPart::Thigh, "thigh"),
        (BodyPart::Leg, "leg"),
        (BodyPart::Shank, "shank"),
        (BodyPart::Ankle, "ankle"),
        (BodyPart::Foot, "foot"),
        (BodyPart::Heel, "heel"),
        (BodyPart::Toe, "toe"),
        (BodyPart::Other, "no limb"),
    ];

    /// True if a joint of this name cannot belong to a leg.
    pub fn excludes_leg(self) -> bool {
        use BodyPart::{Arm, Finger, Forearm, Hand, Head, Neck, Other, Shoulder};
        matches!(self, Arm | Finger | Forearm | Hand | Head | Neck | Other | Shoulder)
    }

    /// True if a joint of this name belongs to a leg.
    pub fn is_of_leg(self) -> bool {
        use BodyPart::{Ankle, Foot, Heel, Hip, Leg, Shank, Thigh, Toe};
        matches!(self, Ankle | Foot | Heel | Hip | Leg | Shank | Thigh | Toe)
    }
}
