//! Roles: which joint is the left ankle, and so on.

use serde::{Deserialize, Serialize};

use crate::foot::Side;

/// What a joint is to the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// The joint that both legs hang from.
    Hips,
    /// The lowest joint of the back.
    Spine,
    /// The joint that the shoulders spring from.
    Chest,
    /// The lowest joint of the neck.
    Neck,
    /// The head.
    Head,
    /// The left collar bone.
    LeftShoulder,
    /// The left upper arm: the shoulder joint.
    LeftArm,
    /// The left forearm: the elbow joint.
    LeftForearm,
    /// The left hand: the wrist joint.
    LeftHand,
    /// The right collar bone.
    RightShoulder,
    /// The right upper arm: the shoulder joint.
    RightArm,
    /// The right forearm: the elbow joint.
    RightForearm,
    /// The right hand: the wrist joint.
    RightHand,
    /// The left thigh: the hip joint.
    LeftThigh,
    /// The left shank: the knee joint.
    LeftShank,
    /// The left ankle.
    LeftAnkle,
    /// The left toe base: the ball of the foot.
    LeftToe,
    /// The tip of the left foot.
    LeftTip,
    /// The right thigh: the hip joint.
    RightThigh,
    /// The right shank: the knee joint.
    RightShank,
    /// The right ankle.
    RightAnkle,
    /// The right toe base: the ball of the foot.
    RightToe,
    /// The tip of the right foot.
    RightTip,
}

impl Role {
    /// All roles, from the hips up and then down.
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

    /// The role's name, as in `left_ankle`.
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

    /// The role of that name.
    pub fn named(name: &str) -> Option<Role> {
        Role::ALL.into_iter().find(|role| role.name() == name)
    }
}

/// The roles of one leg, from the hip down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LegRoles {
    /// The hip joint.
    pub thigh: Role,
    /// The knee.
    pub shank: Role,
    /// The ankle.
    pub ankle: Role,
    /// The toe base.
    pub toe: Role,
    /// The tip of the foot.
    pub tip: Role,
}

impl LegRoles {
    /// The leg of one side.
    pub const fn of(side: Side) -> LegRoles {
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

/// Which joint plays which role; a role may be nobody's.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Roles([Option<usize>; Role::ALL.len()]);

impl Roles {
    /// The joint in a role.
    pub fn get(&self, role: Role) -> Option<usize> {
        self.0[role as usize]
    }

    /// Puts a joint into a role, or empties it.
    pub fn set(&mut self, role: Role, joint: Option<usize>) {
        self.0[role as usize] = joint;
    }

    /// The roles that are filled, with their joints.
    pub fn iter(&self) -> impl Iterator<Item = (Role, usize)> + '_ {
        Role::ALL.into_iter().filter_map(|role| Some((role, self.get(role)?)))
    }

    /// Whether both ankles are known: what detection needs.
    pub fn has_feet(&self) -> bool {
        self.get(Role::LeftAnkle).is_some() && self.get(Role::RightAnkle).is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_role_has_its_place_and_name() {
        for (index, role) in Role::ALL.into_iter().enumerate() {
            assert_eq!(role as usize, index);
            assert_eq!(Role::named(role.name()), Some(role));
            assert_eq!(serde_json::to_value(role).unwrap(), role.name());
        }
    }
}
