//! Roles of joints in the body.

use serde::{Deserialize, Serialize};

use crate::foot::Side;

/// Role of a joint in the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Common ancestor of both legs.
    Hips,
    /// Lowest joint of the back.
    Spine,
    /// Joint from which the shoulders branch.
    Chest,
    /// Lowest joint of the neck.
    Neck,
    /// Head.
    Head,
    /// Left collar bone.
    LeftShoulder,
    /// Left shoulder joint, the upper end of the arm.
    LeftArm,
    /// Left elbow.
    LeftForearm,
    /// Left wrist.
    LeftHand,
    /// Right collar bone.
    RightShoulder,
    /// Right shoulder joint, the upper end of the arm.
    RightArm,
    /// Right elbow.
    RightForearm,
    /// Right wrist.
    RightHand,
    /// Left hip joint, the upper end of the thigh.
    LeftThigh,
    /// Left knee.
    LeftShank,
    /// Left ankle.
    LeftAnkle,
    /// Left toe base: the ball of the foot.
    LeftToe,
    /// Tip of the left foot.
    LeftTip,
    /// Right hip joint, the upper end of the thigh.
    RightThigh,
    /// Right knee.
    RightShank,
    /// Right ankle.
    RightAnkle,
    /// Right toe base: the ball of the foot.
    RightToe,
    /// Tip of the right foot.
    RightTip,
}

impl Role {
    /// All roles: trunk, arms, legs.
    pub const ALL: [Role; 23] = [
        Role::Hips,
        Role::Spine,
        Role::Chest,
        Role::Neck,
        Role::Head,
        Role::LeftShoulder,
        Role::LeftArm,
        Role::LeftForearm,
        Role::LeftHand,
        Role::RightShoulder,
        Role::RightArm,
        Role::RightForearm,
        Role::RightHand,
        Role::LeftThigh,
        Role::LeftShank,
        Role::LeftAnkle,
        Role::LeftToe,
        Role::LeftTip,
        Role::RightThigh,
        Role::RightShank,
        Role::RightAnkle,
        Role::RightToe,
        Role::RightTip,
    ];

    /// Returns the name, as in `left_ankle`.
    pub fn name(self) -> &'static str {
        match self {
            Role::Hips => "hips",
            Role::Spine => "spine",
            Role::Chest => "chest",
            Role::Neck => "neck",
            Role::Head => "head",
            Role::LeftShoulder => "left_shoulder",
            Role::LeftArm => "left_arm",
            Role::LeftForearm => "left_forearm",
            Role::LeftHand => "left_hand",
            Role::RightShoulder => "right_shoulder",
            Role::RightArm => "right_arm",
            Role::RightForearm => "right_forearm",
            Role::RightHand => "right_hand",
            Role::LeftThigh => "left_thigh",
            Role::LeftShank => "left_shank",
            Role::LeftAnkle => "left_ankle",
            Role::LeftToe => "left_toe",
            Role::LeftTip => "left_tip",
            Role::RightThigh => "right_thigh",
            Role::RightShank => "right_shank",
            Role::RightAnkle => "right_ankle",
            Role::RightToe => "right_toe",
            Role::RightTip => "right_tip",
        }
    }

    /// Returns the role with a name.
    pub fn from_name(name: &str) -> Option<Role> {
        Role::ALL.into_iter().find(|role| role.name() == name)
    }
}

/// Roles of one leg, from the hip joint downwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LegRoles {
    /// Hip joint.
    pub thigh: Role,
    /// Knee.
    pub shank: Role,
    /// Ankle.
    pub ankle: Role,
    /// Toe base.
    pub toe: Role,
    /// Tip of the foot.
    pub tip: Role,
}

impl LegRoles {
    /// Returns the roles of the leg of one side.
    pub const fn for_side(side: Side) -> LegRoles {
        match side {
            Side::Left => LegRoles {
                thigh: Role::LeftThigh,
                shank: Role::LeftShank,
                ankle: Role::LeftAnkle,
                toe: Role::LeftToe,
                tip: Role::LeftTip,
            },
            Side::Right => LegRoles {
                thigh: Role::RightThigh,
                shank: Role::RightShank,
                ankle: Role::RightAnkle,
                toe: Role::RightToe,
                tip: Role::RightTip,
            },
        }
    }
}

/// Confidence below which a role is doubtful.
const DOUBTFUL: f64 = 0.75;

/// Reason for the joint of a role.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reason {
    /// The user named the joint.
    Given,
    /// The name of the joint is that of the role.
    Name,
    /// A part of the name of the joint is that of the role; other words are unknown.
    PartOfName,
    /// Bone lengths and branches of the skeleton say so.
    Structure,
    /// The joint is connected to a joint of the same limb that a name identifies.
    Chain,
    /// The joint of the other side has the same distance from the common joint.
    Mirrored,
}

impl Reason {
    /// Probability that the reason alone is right, for the confidence of a role. Chosen by hand, so that
    /// roles with a name, or with a named neighbour in their chain, are above [`DOUBTFUL`].
    fn weight(self) -> f64 {
        match self {
            Reason::Given => 1.0,
            Reason::Name => 0.9,
            Reason::PartOfName => 0.7,
            Reason::Chain => 0.6,
            Reason::Structure => 0.4,
            Reason::Mirrored => 0.2,
        }
    }

    /// Returns the evidence in a few words, to be read after "by".
    pub fn description(self) -> &'static str {
        match self {
            Reason::Given => "your choice",
            Reason::Name => "name",
            Reason::PartOfName => "part of the name",
            Reason::Structure => "structure",
            Reason::Chain => "connected bones",
            Reason::Mirrored => "the other side",
        }
    }
}

/// Joint of a role, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assignment {
    /// Joint index.
    pub joint: usize,
    /// Reasons, the strongest first.
    pub reasons: Vec<Reason>,
}

impl Assignment {
    /// Returns the confidence, from 0 to 1: the probability that at least one of the reasons is
    /// right, if they were independent.
    pub fn confidence(&self) -> f64 {
        1.0 - self.reasons.iter().map(|reason| 1.0 - reason.weight()).product::<f64>()
    }

    /// True if the confidence is below 0.75.
    pub fn is_doubtful(&self) -> bool {
        self.confidence() < DOUBTFUL
    }
}

/// Assignment of joints to roles; a role may have no joint.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Roles([Option<Assignment>; Role::ALL.len()]);

impl Roles {
    /// Returns the joint of a role.
    pub fn get(&self, role: Role) -> Option<usize> {
        self.assignment(role).map(|assignment| assignment.joint)
    }

    /// Returns the joint of a role with the reasons for it.
    pub fn assignment(&self, role: Role) -> Option<&Assignment> {
        self.0[role as usize].as_ref()
    }

    /// Assigns the joint that a user names, or clears the role.
    pub fn set(&mut self, role: Role, joint: Option<usize>) {
        self.0[role as usize] = joint.map(|joint| Assignment { joint, reasons: vec![Reason::Given] });
    }

    /// Assigns a joint for the given reasons.
    pub(crate) fn assign(&mut self, role: Role, joint: usize, reasons: Vec<Reason>) {
        self.0[role as usize] = Some(Assignment { joint, reasons });
    }

    /// Returns the assigned roles with their joints.
    pub fn iter(&self) -> impl Iterator<Item = (Role, usize)> + '_ {
        Role::ALL.into_iter().filter_map(|role| Some((role, self.get(role)?)))
    }

    /// True if both ankles are known, which detection requires.
    pub fn has_feet(&self) -> bool {
        self.get(Role::LeftAnkle).is_some() && self.get(Role::RightAnkle).is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roles_have_unique_indices_and_names() {
        for (index, role) in Role::ALL.into_iter().enumerate() {
            assert_eq!(role as usize, index);
            assert_eq!(Role::from_name(role.name()), Some(role));
            assert_eq!(serde_json::to_value(role).unwrap(), role.name());
        }
    }
}
