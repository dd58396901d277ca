//! Joints of a rig: a standing rest pose in metres, Y up, facing Z.

use nalgebra::Vector3;
use plantigrade::bvh::{Axis, Channel, Joint, JointKind};
use plantigrade::foot::Side;
use plantigrade::skeleton::{LegRoles, Role};

use super::bone::Bone;
use super::names::NAMINGS;
use super::spec::{BodyKind, Rig};

/// Joints of a rig and what they are.
pub(super) struct Built {
    pub joints: Vec<Joint>,
    pub bones: Vec<Bone>,
}

/// Number of joints of the spine.
const SPINE: usize = 3;

struct Builder<'a> {
    rig: &'a Rig,
    built: Built,
}

impl Builder<'_> {
    /// Appends a joint. Offsets are relative to a leg of 1 m.
    fn add(&mut self, bone: Bone, parent: Option<usize>, offset: [f64; 3]) -> usize {
        let index = self.built.joints.len();
        let name = match (self.rig.naming, bone) {
            (_, Bone::End) => plantigrade::bvh::END_SITE.to_owned(),
            (Some(naming), bone) => {
                format!("{}{}{}", self.rig.prefix, NAMINGS[naming].name(bone), self.rig.suffix)
            }
            (None, _) => format!("Bone{index:02}"),
        };
        let rotations = [Axis::Z, Axis::X, Axis::Y].map(Channel::Rotation);
        let positions = Axis::ALL.map(Channel::Position);
        self.built.joints.push(Joint {
            name,
            kind: match (parent, bone) {
                (None, _) => JointKind::Root,
                (_, Bone::End) => JointKind::EndSite,
                _ => JointKind::Joint,
            },
            parent,
            offset: Vector3::from(offset) * self.rig.leg,
            channels: match (parent, bone) {
                (None, _) => positions.into_iter().chain(rotations).collect(),
                (_, Bone::End) => vec![],
                _ => rotations.to_vec(),
            },
        });
        self.built.bones.push(bone);
        index
    }

    /// Appends an end site, if the rig has them.
    fn end(&mut self, parent: usize, offset: [f64; 3]) {
        if self.rig.has_end_sites {
            self.add(Bone::End, Some(parent), offset);
        }
    }

    /// Appends a chain of joints with an end site.
    fn chain(&mut self, bones: &[Bone], parent: usize, offsets: &[[f64; 3]], end: [f64; 3]) {
        let mut last = parent;
        for (bone, offset) in bones.iter().zip(offsets) {
            last = self.add(*bone, Some(last), *offset);
        }
        self.add(Bone::End, Some(last), end);
    }

    fn leg(&mut self, side: Side, hips: usize) {
        let x = if side == Side::Left { 1.0 } else { -1.0 };
        let mut parent = hips;
        let mut hip = [0.1 * x, -0.05, 0.0];
        if self.rig.has_pelvis_sides {
            parent = self.add(Bone::PelvisSide(side), Some(parent), [0.03 * x, 0.0, 0.0]);
            hip[0] -= 0.03 * x;
        }
        let [thighs, shanks] = self.rig.split;
        let mut offset = hip;
        for index in 0..thighs {
            parent = self.add(Bone::Thigh(side, index), Some(parent), offset);
            if index == 0 && self.rig.has_twist_leaves {
                self.chain(&[Bone::ThighTwist(side)], parent, &[[0.0, -0.2, 0.0]], [0.0, -0.05, 0.0]);
            }
            offset = [0.0, -0.46 / thighs as f64, 0.0];
        }
        for index in 0..shanks {
            parent = self.add(Bone::Shank(side, index), Some(parent), offset);
            if index == 0 && self.rig.has_twist_leaves {
                self.chain(&[Bone::ShankTwist(side)], parent, &[[0.0, -0.2, 0.0]], [0.0, -0.05, 0.0]);
            }
            offset = [0.0, -0.44 / shanks as f64, 0.0];
        }
        let ankle = self.add(Bone::Ankle(side), Some(parent), offset);
        if self.rig.has_heels {
            self.chain(&[Bone::Heel(side)], ankle, &[[0.0, -0.08, -0.05]], [0.0, 0.0, -0.01]);
        }
        let ball = [0.0, -0.07, 0.14];
        if self.rig.has_toes {
            let mut foot = ankle;
            let mut offset = ball;
            if self.rig.has_midfoot {
                foot = self.add(Bone::Midfoot(side), Some(foot), ball.map(|part| 0.4 * part));
                offset = ball.map(|part| 0.6 * part);
            }
            let toe = self.add(Bone::Toe(side), Some(foot), offset);
            self.end(toe, [0.0, -0.02, 0.07]);
        } else {
            self.end(ankle, [0.0, -0.09, 0.2]);
        }
        if self.rig.has_ik {
            self.chain(&[Bone::Ik(side)], ankle, &[[0.0, -0.09, -0.2]], [0.0, 0.0, -0.05]);
        }
    }

    fn arm(&mut self, side: Side, chest: usize) {
        let x = if side == Side::Left { 1.0 } else { -1.0 };
        let offsets =
            [[0.04 * x, 0.16, 0.0], [0.14 * x, 0.0, 0.0], [0.3 * x, 0.0, 0.0], [0.28 * x, 0.0, 0.0]];
        let mut parent = chest;
        for (index, offset) in offsets.into_iter().enumerate() {
            parent = self.add(Bone::Arm(side, index), Some(parent), offset);
        }
        if self.rig.has_fingers {
            self.chain(&[Bone::Finger(side)], parent, &[[0.09 * x, 0.0, 0.02]], [0.04 * x, 0.0, 0.0]);
        }
        self.end(parent, [0.18 * x, 0.0, 0.0]);
    }

    fn quadruped(&mut self) {
        let hips = self.add(Bone::Hips, None, [0.0; 3]);
        let limb = |x: f64| [[0.1 * x, -0.02, 0.0], [0.0, -0.48, 0.0], [0.0, -0.46, 0.0]];
        for (side, x) in [(Side::Left, 1.0), (Side::Right, -1.0)] {
            let bones = [0, 1, 2].map(|index| Bone::Hind(side, index));
            self.chain(&bones, hips, &limb(x), [0.0, -0.04, 0.08]);
        }
        let mut spine = hips;
        for index in 0..SPINE {
            spine = self.add(Bone::Spine(index), Some(spine), [0.0, 0.01, 0.35]);
        }
        let neck = self.add(Bone::Neck, Some(spine), [0.0, 0.12, 0.15]);
        let head = self.add(Bone::Head, Some(neck), [0.0, 0.15, 0.1]);
        self.end(head, [0.0, 0.0, 0.2]);
        for (side, x) in [(Side::Left, 1.0), (Side::Right, -1.0)] {
            let bones = [0, 1, 2].map(|index| Bone::Fore(side, index));
            self.chain(&bones, spine, &limb(x), [0.0, -0.04, 0.06]);
        }
    }

    fn human(&mut self) {
        let kind = self.rig.kind;
        let hips = self.add(Bone::Hips, None, [0.0; 3]);
        if kind != BodyKind::UpperBody {
            self.leg(Side::Left, hips);
            if kind != BodyKind::OneLeg {
                self.leg(Side::Right, hips);
            }
        }
        let mut spine = hips;
        for index in 0..SPINE {
            spine = self.add(Bone::Spine(index), Some(spine), [0.0, [0.1, 0.14, 0.14][index], 0.0]);
        }
        let neck = self.add(Bone::Neck, Some(spine), [0.0, 0.24, 0.0]);
        let head = self.add(Bone::Head, Some(neck), [0.0, 0.1, 0.02]);
        self.end(head, [0.0, 0.19, 0.0]);
        self.arm(Side::Left, spine);
        self.arm(Side::Right, spine);
        if self.rig.has_skirt {
            for chain in 0..4 {
                let (sin, cos) = (chain as f64 * std::f64::consts::FRAC_PI_2).sin_cos();
                let bones = [0, 1, 2].map(|index| Bone::Skirt(chain, index));
                let offsets = [[0.15 * sin, -0.03, 0.15 * cos], [0.0, -0.18, 0.0], [0.0, -0.18, 0.0]];
                self.chain(&bones, hips, &offsets, [0.0, -0.15, 0.0]);
            }
        }
        if kind == BodyKind::SpareLimbs {
            for (side, x) in [(Side::Left, 1.0), (Side::Right, -1.0)] {
                let bones = [0, 1, 2].map(|index| Bone::Hind(side, index));
                let offsets = [[0.14 * x, -0.08, -0.2], [0.05 * x, -0.48, -0.1], [0.0, -0.42, 0.0]];
                self.chain(&bones, hips, &offsets, [0.0, -0.05, 0.1]);
                let bones = [0, 1, 2].map(|index| Bone::Wing(side, index));
                let offsets = [[0.1 * x, 0.1, -0.1], [0.17 * x, 0.03, -0.1], [0.3 * x, 0.0, -0.2]];
                self.chain(&bones, spine, &offsets, [0.3 * x, 0.0, -0.2]);
            }
            let bones = [0, 1, 2].map(Bone::Tail);
            self.chain(
                &bones,
                hips,
                &[[0.0, 0.0, -0.1], [0.0, -0.1, -0.2], [0.0, -0.1, -0.2]],
                [0.0, 0.0, -0.2],
            );
        }
    }
}

/// Builds the joints of a rig.
pub(super) fn build(rig: &Rig) -> Built {
    let mut builder = Builder { rig, built: Built { joints: vec![], bones: vec![] } };
    match rig.kind {
        BodyKind::Quadruped => builder.quadruped(),
        _ => builder.human(),
    }
    depth_first(&builder.built)
}

/// Returns the joints in depth-first order.
fn depth_first(built: &Built) -> Built {
    let mut sorted = Built { joints: vec![], bones: vec![] };
    // Pairs of a joint and the new index of its parent.
    let mut stack = vec![(0, None)];
    while let Some((joint, parent)) = stack.pop() {
        let index = sorted.joints.len();
        sorted.joints.push(Joint { parent, ..built.joints[joint].clone() });
        sorted.bones.push(built.bones[joint]);
        let children = (0..built.joints.len()).filter(|&child| built.joints[child].parent == Some(joint));
        stack.extend(children.rev().map(|child| (child, Some(index))));
    }
    sorted
}

impl Built {
    /// Returns the joints that are one of `bones`.
    fn find(&self, bones: &[Bone]) -> Vec<usize> {
        (0..self.bones.len()).filter(|&joint| bones.contains(&self.bones[joint])).collect()
    }

    /// Returns the joints of the roles of the legs, several where each is right.
    pub fn roles(&self, rig: &Rig) -> Vec<(Role, Vec<usize>)> {
        let mut roles = Vec::new();
        for side in Side::BOTH {
            let leg = LegRoles::for_side(side);
            let is_quadruped = rig.kind == BodyKind::Quadruped;
            let ankle = if is_quadruped { Bone::Hind(side, 2) } else { Bone::Ankle(side) };
            // Where no name tells the toe, the joint before it is as good.
            let toes = match (rig.has_toes, rig.naming) {
                (true, None) => vec![Bone::Midfoot(side), Bone::Toe(side)],
                (true, Some(_)) => vec![Bone::Toe(side)],
                (false, _) => vec![],
            };
            roles.push((leg.ankle, self.find(&[ankle])));
            roles.push((leg.toe, self.find(&toes)));
            if !is_quadruped {
                roles.push((leg.thigh, self.find(&[Bone::Thigh(side, 0)])));
                roles.push((leg.shank, self.find(&[Bone::Shank(side, 0)])));
            }
        }
        roles
    }

    /// Returns the joints that belong to no leg.
    pub fn no_legs(&self) -> Vec<usize> {
        let is_other = |bone: &Bone| {
            matches!(
                bone,
                Bone::Arm(..)
                    | Bone::Finger(_)
                    | Bone::Fore(..)
                    | Bone::Wing(..)
                    | Bone::Tail(_)
                    | Bone::Skirt(..)
                    | Bone::Head
                    | Bone::Neck
            )
        };
        (0..self.bones.len()).filter(|&joint| is_other(&self.bones[joint])).collect()
    }
}
