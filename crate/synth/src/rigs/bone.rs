//! What joints of a rig are.

use plantigrade::foot::Side;

/// What a joint is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bone {
    Hips,
    Spine(usize),
    Neck,
    Head,
    /// Collar bone, upper arm, forearm and hand.
    Arm(Side, usize),
    Finger(Side),
    PelvisSide(Side),
    Thigh(Side, usize),
    Shank(Side, usize),
    Ankle(Side),
    Midfoot(Side),
    Toe(Side),
    Heel(Side),
    Ik(Side),
    ThighTwist(Side),
    ShankTwist(Side),
    Skirt(usize, usize),
    Wing(Side, usize),
    Tail(usize),
    /// Hip, knee and ankle of a hind limb.
    Hind(Side, usize),
    /// Shoulder, elbow and wrist of a fore limb.
    Fore(Side, usize),
    End,
}
