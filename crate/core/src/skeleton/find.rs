//! Roles by joint names, and legs by topology if the names are not sufficient.

use nalgebra::Vector3;

use crate::bvh::{Clip, JointKind};
use crate::foot::Side;
use crate::kinematics;
use crate::numeric::sort;
use crate::skeleton::names::{BodyPart, ParsedName};
use crate::skeleton::{LegRoles, Role, Roles, names};

/// Assigns the roles in the skeleton below `root`.
pub(crate) fn assign_roles(clip: &Clip, root: usize) -> Roles {
    let tree = Tree::new(clip, root);
    let mut roles = Roles::default();
    let legs = Side::BOTH.map(|side| tree.leg_by_names(side));
    let legs = if legs.iter().all(Option::is_some) {
        legs.map(Option::unwrap_or_default)
    } else {
        tree.legs_by_topology().unwrap_or_default()
    };
    for (side, leg) in Side::BOTH.into_iter().zip(legs) {
        let role = LegRoles::for_side(side);
        roles.set(role.thigh, leg.thigh);
        roles.set(role.shank, leg.shank);
        roles.set(role.ankle, leg.ankle);
        roles.set(role.toe, leg.toe);
        roles.set(role.tip, leg.ankle.and_then(|ankle| tree.tip(leg.toe.unwrap_or(ankle))));
    }
    tree.assign_trunk(&mut roles);
    for side in Side::BOTH {
        tree.assign_arm(side, &mut roles);
    }
    roles
}

#[derive(Clone, Copy, Debug, Default)]
struct Leg {
    thigh: Option<usize>,
    shank: Option<usize>,
    ankle: Option<usize>,
    toe: Option<usize>,
}

/// One skeleton of a clip with the meaning of its joint names.
struct Tree<'a> {
    clip: &'a Clip,
    root: usize,
    /// Root and all of its descendants, parents first.
    members: Vec<usize>,
    names: Vec<ParsedName>,
}

impl<'a> Tree<'a> {
    fn new(clip: &'a Clip, root: usize) -> Tree<'a> {
        let descendant_count =
            clip.joints()[root + 1..].iter().take_while(|joint| joint.parent.is_some()).count();
        let unnamed = ParsedName { side: None, part: None };
        let names = clip
            .joints()
            .iter()
            .map(|joint| if joint.kind == JointKind::EndSite { unnamed } else { names::parse(&joint.name) })
            .collect();
        Tree { clip, root, members: (root..=root + descendant_count).collect(), names }
    }

    fn parent(&self, joint: usize) -> Option<usize> {
        self.clip.joints()[joint].parent
    }

    /// Returns the ancestors of `joint`, nearest first.
    fn ancestors(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(self.parent(joint), |&joint| self.parent(joint))
    }

    /// Returns the descendants of `joint`, in file order.
    fn descendants(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        self.members.iter().copied().filter(move |&member| self.ancestors(member).any(|above| above == joint))
    }

    fn has_name(&self, joint: usize, side: Option<Side>, part: BodyPart) -> bool {
        self.names[joint] == ParsedName { side, part: Some(part) }
    }

    /// Returns the leg with the best names: a foot with as many as possible of shank and thigh
    /// as its ancestors.
    fn leg_by_names(&self, side: Side) -> Option<Leg> {
        let is = |joint: usize, part| self.has_name(joint, Some(side), part);
        let candidates = self.members.iter().copied().filter(|&joint| {
            is(joint, BodyPart::Ankle)
                // Below an ankle, a foot is the toe base.
                || is(joint, BodyPart::Foot) && !self.ancestors(joint).any(|above| is(above, BodyPart::Ankle))
        });
        let legs = candidates.map(|ankle| {
            // A part may be split into several joints, such as twist bones; the topmost joint is used.
            let topmost = |part| self.ancestors(ankle).filter(|&joint| is(joint, part)).last();
            let toe = self
                .descendants(ankle)
                .filter(|&joint| is(joint, BodyPart::Toe) || is(joint, BodyPart::Foot))
                .min_by_key(|&joint| (self.ancestors(joint).count(), &self.clip.joints()[joint].name));
            Leg { thigh: topmost(BodyPart::Thigh), shank: topmost(BodyPart::Shank), ankle: Some(ankle), toe }
        });
        let score = |leg: &Leg| {
            2 * usize::from(leg.thigh.is_some())
                + 2 * usize::from(leg.shank.is_some())
                + usize::from(leg.toe.is_some())
        };
        let mut best: Option<Leg> = None;
        for leg in legs {
            if best.is_none_or(|best| score(&leg) > score(&best)) {
                best = Some(leg);
            }
        }
        let mut leg = best?;
        self.fill_from_ancestors(&mut leg);
        Some(leg)
    }

    /// Assigns the ancestors of the ankle to shank and thigh if no name does.
    fn fill_from_ancestors(&self, leg: &mut Leg) {
        let Some(ankle) = leg.ankle else { return };
        let fits = |joint: &usize| self.parent(*joint).is_some();
        leg.shank = leg.shank.or_else(|| self.parent(ankle).filter(fits));
        leg.thigh = leg.thigh.or_else(|| self.parent(leg.shank?).filter(fits));
    }

    /// Returns the end of the foot: the descendant of `joint` that is farthest from it in the rest
    /// pose.
    fn tip(&self, joint: usize) -> Option<usize> {
        let reach = |tip: usize| {
            let mut offset = self.clip.joints()[tip].offset;
            for above in self.ancestors(tip).take_while(|&above| above != joint) {
                offset += self.clip.joints()[above].offset;
            }
            offset.norm()
        };
        self.descendants(joint)
            .filter(|&member| self.clip.children(member).next().is_none())
            .max_by(|&a, &b| reach(a).total_cmp(&reach(b)))
    }

    /// Returns the two mirrored chains that reach farthest from the root: the legs of a skeleton
    /// without usable names.
    ///
    /// Hands are near the hips and there is one head, so only feet are a pair far from the
    /// hips. If two pairs reach about equally far (a quadruped or a crab), the result is undecided.
    fn legs_by_topology(&self) -> Option<[Leg; 2]> {
        let tips: Vec<usize> = self
            .members
            .iter()
            .copied()
            .filter(|&member| self.clip.children(member).next().is_none())
            .collect();
        let mut joints = tips.clone();
        joints.push(self.root);
        let frames = kinematics::sample_frames(self.clip, 64);
        let mut tracks = kinematics::tracks_at(self.clip, &joints, frames);
        let root = tracks.pop()?;
        let mean_from_root = |track: &kinematics::Track| {
            let sum: Vector3<f64> = track.iter().zip(&root).map(|(tip, root)| tip - root).sum();
            sum / root.len() as f64
        };
        let means: Vec<Vector3<f64>> = tracks.iter().map(mean_from_root).collect();
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for a in 0..tips.len() {
            for b in a + 1..tips.len() {
                if self.are_mirrored(tips[a], tips[b]) {
                    pairs.push(((means[a] + means[b]).norm() / 2.0, a, b));
                }
            }
        }
        let reaches: Vec<f64> = pairs.iter().map(|pair| pair.0).collect();
        let pairs: Vec<_> =
            sort::argsort_descending(&reaches).into_iter().map(|index| pairs[index]).collect();
        let &(reach, a, b) = pairs.first()?;
        let chains = [self.chain(tips[a], tips[b]), self.chain(tips[b], tips[a])];
        // A competing pair of limbs reaches almost as far.
        let is_rival = |&(other, c, d): &(f64, usize, usize)| {
            other > 0.8 * reach && ![tips[c], tips[d]].iter().any(|&tip| self.shares_limb(tip, &chains))
        };
        if pairs[1..].iter().any(is_rival) || chains.iter().any(|chain| chain.len() < 3) {
            return None;
        }
        let up = -(means[a] + means[b]);
        let legs = chains.map(|chain| Leg {
            thigh: Some(chain[0]),
            shank: Some(chain[1]),
            ankle: Some(chain[2]),
            toe: chain.get(3).copied().filter(|&joint| self.clip.children(joint).next().is_some()),
        });
        Some(if self.is_first_left(&legs, up) { legs } else { [legs[1], legs[0]] })
    }

    /// Returns the joints from the common ancestor of `tip` and `other`, exclusive, to `tip`.
    fn chain(&self, tip: usize, other: usize) -> Vec<usize> {
        let others: Vec<usize> = self.ancestors(other).collect();
        let mut chain: Vec<usize> = std::iter::once(tip)
            .chain(self.ancestors(tip))
            .take_while(|joint| !others.contains(joint))
            .collect();
        chain.reverse();
        chain
    }

    fn shares_limb(&self, tip: usize, limbs: &[Vec<usize>; 2]) -> bool {
        limbs.iter().any(|limb| tip == limb[0] || self.ancestors(tip).any(|above| above == limb[0]))
    }

    /// True if two tips end chains with equal bone lengths.
    fn are_mirrored(&self, a: usize, b: usize) -> bool {
        let (a, b) = (self.chain(a, b), self.chain(b, a));
        a.len() == b.len()
            && a.iter().zip(&b).all(|(&a, &b)| {
                let (a, b) = (self.clip.joints()[a].offset.norm(), self.clip.joints()[b].offset.norm());
                (a - b).abs() <= 0.05 * a.max(b)
            })
    }

    /// True if the first leg is the left one, judged by the direction of the feet.
    ///
    /// Evaluated per pose, as left has no fixed direction in the world when the character turns.
    fn is_first_left(&self, [leg, other]: &[Leg; 2], up: Vector3<f64>) -> bool {
        let (Some(first), Some(second)) = (leg.ankle, other.ankle) else { return true };
        let tips = [first, second].map(|ankle| self.tip(ankle).unwrap_or(ankle));
        let joints = [first, second, tips[0], tips[1]];
        let tracks = kinematics::tracks_at(self.clip, &joints, kinematics::sample_frames(self.clip, 64));
        let votes = (0..tracks[0].len()).map(|frame| {
            let [first, second, tip, other_tip] = [0, 1, 2, 3].map(|joint| tracks[joint][frame]);
            let forward = (tip - first) + (other_tip - second);
            up.cross(&forward).dot(&(first - second))
        });
        votes.sum::<f64>() > 0.0
    }

    fn assign_trunk(&self, roles: &mut Roles) {
        let first = |part| self.members.iter().copied().find(|&joint| self.has_name(joint, None, part));
        let fork = |left, right| {
            let (left, right) = (roles.get(left)?, roles.get(right)?);
            self.ancestors(left).find(|&joint| self.ancestors(right).any(|above| above == joint))
        };
        let hips =
            fork(Role::LeftThigh, Role::RightThigh).or_else(|| first(BodyPart::Hips)).or(Some(self.root));
        roles.set(Role::Hips, hips);
        roles.set(Role::Spine, first(BodyPart::Spine));
        roles.set(Role::Neck, first(BodyPart::Neck));
        roles.set(Role::Head, first(BodyPart::Head));
        let chest = roles
            .get(Role::Neck)
            .or(roles.get(Role::Head))
            .and_then(|neck| self.ancestors(neck).find(|&joint| self.has_name(joint, None, BodyPart::Spine)));
        roles.set(Role::Chest, chest);
    }

    fn assign_arm(&self, side: Side, roles: &mut Roles) {
        let [shoulder, arm, forearm, hand] = match side {
            Side::Left => [Role::LeftShoulder, Role::LeftArm, Role::LeftForearm, Role::LeftHand],
            Side::Right => [Role::RightShoulder, Role::RightArm, Role::RightForearm, Role::RightHand],
        };
        let first = |part| self.members.iter().copied().find(|&joint| self.has_name(joint, Some(side), part));
        let elbow = first(BodyPart::Forearm);
        roles.set(forearm, elbow);
        roles.set(hand, first(BodyPart::Hand));
        // Above the elbow is the arm, named arm or shoulder; the topmost shoulder is the collar
        // bone.
        let above: Vec<usize> = elbow
            .into_iter()
            .flat_map(|elbow| self.ancestors(elbow))
            .filter(|&joint| {
                self.has_name(joint, Some(side), BodyPart::Arm)
                    || self.has_name(joint, Some(side), BodyPart::Shoulder)
            })
            .collect();
        let upper = above.iter().copied().rfind(|&joint| self.has_name(joint, Some(side), BodyPart::Arm));
        let upper = upper.or_else(|| above.first().copied());
        roles.set(arm, upper);
        roles.set(shoulder, above.last().copied().filter(|&joint| Some(joint) != upper));
    }
}

#[cfg(test)]
mod tests {
    use crate::bvh;
    use crate::skeleton::{Overrides, Skeleton};

    /// A body of nameless limbs, each with three bones and a tip, at the given offsets.
    fn body(limbs: &[&str]) -> String {
        let mut text = String::from("HIERARCHY\nROOT q\n{\nOFFSET 0 0 0\n");
        for (limb, offset) in limbs.iter().enumerate() {
            text += &format!(
                "JOINT a{limb}\n{{\nOFFSET {offset}\nJOINT b{limb}\n{{\nOFFSET 0 -4 0\nJOINT c{limb}\n{{\n\
                 OFFSET 0 -4 0\nEnd Site\n{{\nOFFSET 0 0 1\n}}\n}}\n}}\n}}\n"
            );
        }
        text + "}\n"
    }

    fn has_feet(limbs: &[&str]) -> bool {
        let clip = bvh::parse(body(limbs).as_bytes(), bvh::Options::default()).expect("a body").clip;
        Skeleton::main(&clip, &Overrides::default()).roles.has_feet()
    }

    #[test]
    fn quadrupeds_have_no_unique_pair_of_feet() {
        assert!(has_feet(&["1 0 0", "-1 0 0"]));
        assert!(!has_feet(&["1 0 0", "-1 0 0", "1 0 -6", "-1 0 -6"]));
        assert!(!has_feet(&["1 0 0"]));
    }
}
