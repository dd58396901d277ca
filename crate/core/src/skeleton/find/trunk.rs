//! Trunk and arms.

use nalgebra::Vector3;

use super::tree::Tree;
use crate::foot::Side;
use crate::skeleton::names::BodyPart;
use crate::skeleton::{Reason, Role, Roles};

/// Height of hands above the feet, relative to the distance from feet to hips, at which a skeleton
/// stands on its hands.
const STANDING_HANDS: f64 = 0.2;

/// Cosine of the angle between trunk and legs of a body that lies or has four legs, at most.
const LYING_TRUNK: f64 = 0.7;

/// Assigns hips, spine, chest, neck, head and both arms.
pub(super) fn assign(tree: &Tree, roles: &mut Roles) {
    assign_trunk(tree, roles);
    for side in Side::BOTH {
        assign_arm(tree, side, roles);
    }
}

fn has_name(tree: &Tree, joint: usize, side: Option<Side>, part: BodyPart) -> bool {
    tree.part(joint) == Some(part) && tree.name(joint).side == side
}

/// Assigns a joint by its name.
fn assign_named(tree: &Tree, roles: &mut Roles, role: Role, joint: Option<usize>) {
    if let Some(joint) = joint {
        let is_whole = tree.name(joint).unknown_words == 0;
        roles.assign(role, joint, vec![if is_whole { Reason::Name } else { Reason::PartOfName }]);
    }
}

fn assign_trunk(tree: &Tree, roles: &mut Roles) {
    // The name with the fewest unknown words counts; of several, the first one below the root, which may
    // be the origin of the scene.
    let first = |part| {
        tree.members()
            .filter(|&joint| has_name(tree, joint, None, part))
            .min_by_key(|&joint| (tree.name(joint).unknown_words, joint == tree.root))
    };
    let named_hips = first(BodyPart::Hips);
    let fork = || tree.common_ancestor(roles.get(Role::LeftThigh)?, roles.get(Role::RightThigh)?);
    let (hips, mut reasons) = match (fork(), named_hips) {
        (Some(fork), _) => {
            let thighs = [Role::LeftThigh, Role::RightThigh];
            let is_named =
                thighs.iter().all(|&role| roles.assignment(role).is_some_and(|thigh| !thigh.is_doubtful()));
            (fork, if is_named { vec![Reason::Chain, Reason::Structure] } else { vec![Reason::Structure] })
        }
        (None, Some(named)) => (named, vec![]),
        (None, None) => (tree.root, vec![Reason::Structure]),
    };
    // In a list of points, all joints have the root in common.
    let hips = match named_hips {
        Some(named) if tree.distance(hips, named) > 0.0 && tree.is_leaf_but_end(named) => named,
        _ => hips,
    };
    if named_hips == Some(hips) {
        reasons.insert(0, Reason::Name);
    }
    roles.assign(Role::Hips, hips, reasons);
    assign_named(tree, roles, Role::Spine, first(BodyPart::Spine));
    assign_named(tree, roles, Role::Neck, first(BodyPart::Neck));
    assign_named(tree, roles, Role::Head, first(BodyPart::Head));
    let top = roles.get(Role::Neck).or(roles.get(Role::Head));
    let chest =
        top.and_then(|top| tree.ancestors(top).find(|&joint| has_name(tree, joint, None, BodyPart::Spine)));
    assign_named(tree, roles, Role::Chest, chest);
}

fn assign_arm(tree: &Tree, side: Side, roles: &mut Roles) {
    let [shoulder, arm, forearm, hand] = match side {
        Side::Left => [Role::LeftShoulder, Role::LeftArm, Role::LeftForearm, Role::LeftHand],
        Side::Right => [Role::RightShoulder, Role::RightArm, Role::RightForearm, Role::RightHand],
    };
    let first = |part| tree.members().find(|&joint| has_name(tree, joint, Some(side), part));
    let elbow = first(BodyPart::Forearm);
    assign_named(tree, roles, forearm, elbow);
    assign_named(tree, roles, hand, first(BodyPart::Hand));
    // Above the elbow is the arm, named arm or shoulder; the topmost shoulder is the collar bone.
    let is_upper = |&joint: &usize| {
        has_name(tree, joint, Some(side), BodyPart::Arm)
            || has_name(tree, joint, Some(side), BodyPart::Shoulder)
    };
    let above: Vec<usize> =
        elbow.into_iter().flat_map(|elbow| tree.ancestors(elbow)).filter(is_upper).collect();
    let upper = above.iter().copied().rfind(|&joint| has_name(tree, joint, Some(side), BodyPart::Arm));
    let upper = upper.or_else(|| above.first().copied());
    assign_named(tree, roles, arm, upper);
    assign_named(tree, roles, shoulder, above.last().copied().filter(|&joint| Some(joint) != upper));
}

/// True if the hands are as low as the feet, and the trunk lies, in the rest pose and in most poses:
/// an animal with the names of a human.
pub(super) fn hands_stand(tree: &Tree, roles: &Roles) -> bool {
    let joints = [Role::LeftAnkle, Role::RightAnkle, Role::Hips, Role::LeftHand, Role::RightHand]
        .map(|role| roles.get(role));
    let top = roles.get(Role::Head).or(roles.get(Role::Neck));
    let [Some(left), Some(right), Some(hips), Some(left_hand), Some(right_hand)] = joints else {
        return false;
    };
    let Some(top) = top else { return false };
    let stands = |position: &dyn Fn(usize) -> Vector3<f64>| {
        let feet = (position(left) + position(right)) / 2.0;
        let hands = (position(left_hand) + position(right_hand)) / 2.0;
        let up = position(hips) - feet;
        let trunk = position(top) - position(hips);
        up.norm() > 0.0
            && (hands - feet).dot(&up) < STANDING_HANDS * up.norm_squared()
            && trunk.dot(&up) < LYING_TRUNK * trunk.norm() * up.norm()
    };
    let rest = tree.rest_pose();
    let poses = tree.track(hips).len();
    let standing = (0..poses).filter(|&pose| stands(&|joint| tree.track(joint)[pose])).count();
    stands(&|joint| rest[joint - tree.root]) && 2 * standing > poses
}
