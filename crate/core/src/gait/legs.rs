//! Tracks of the joint centres of both legs.

use crate::bvh::Clip;
use crate::foot::Side;
use crate::kinematics::{self, Track};
use crate::skeleton::{LegRoles, Skeleton};

/// Tracks of the joint centres of both legs, in file units and axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Legs {
    /// Left leg and right leg.
    pub(crate) legs: [LegTracks; 2],
}

/// Tracks of the joint centres of one leg.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LegTracks {
    pub hip: Track,
    pub knee: Track,
    pub ankle: Track,
    /// Toe base or, without one, tip of the foot; `None` if the foot has no joint below the ankle.
    pub toe: Option<Track>,
}

impl Legs {
    /// Computes the tracks of one skeleton of a clip; `None` if a hip, knee or ankle is unknown.
    pub fn new(clip: &Clip, skeleton: &Skeleton) -> Option<Legs> {
        let mut joints = Vec::new();
        let mut has_toe = [false; 2];
        for side in Side::BOTH {
            let leg = LegRoles::for_side(side);
            for role in [leg.thigh, leg.shank, leg.ankle] {
                joints.push(skeleton.roles.get(role)?);
            }
            let toe = skeleton.roles.get(leg.toe).or_else(|| skeleton.roles.get(leg.tip));
            has_toe[side as usize] = toe.is_some();
            joints.extend(toe);
        }
        let mut tracks = kinematics::tracks(clip, &joints).into_iter();
        let mut next = || tracks.next().expect("each joint has a track");
        let legs = has_toe.map(|has_toe| LegTracks {
            hip: next(),
            knee: next(),
            ankle: next(),
            toe: has_toe.then(&mut next),
        });
        Some(Legs { legs })
    }
}
