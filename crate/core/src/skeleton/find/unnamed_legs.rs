//! Legs by the structure of the skeleton, for names without a meaning.

use nalgebra::Vector3;

use super::leg::{self, Leg};
use super::tree::{MIRROR_TOLERANCE, Tree};
use crate::foot::Side;
use crate::kinematics::Track;
use crate::numeric::sort;
use crate::skeleton::names::{BodyPart, LimbPair};

/// Number of branches of one joint that are compared: the longest ones.
const MAX_BRANCHES: usize = 24;

/// Reach of another pair of limbs, relative to the farthest, at which legs are undecided.
const RIVAL_REACH: f64 = 0.8;

/// Fraction of a travelling body's time in which a joint of one of two legs rests, at least. Walks have more than 0.9,
/// runs more than 0.5.
const FEET_REST: f64 = 0.45;

/// Fraction of a travelling body's time in which a joint of one of two arms rests, at most.
const HANDS_REST: f64 = 0.1;

/// Two mirrored limbs.
struct LimbPairing {
    /// Common joint.
    fork: usize,
    /// Chains from below the common joint to the tips.
    chains: [Vec<usize>; 2],
    /// Mean vector from the common joint to the tips, in file units.
    reach: Vector3<f64>,
}

impl LimbPairing {
    /// Returns the joints of both chains below their first ones.
    fn joints(&self) -> Vec<usize> {
        self.chains.iter().flat_map(|chain| chain[1..].iter().copied()).collect()
    }
}

/// Returns the two mirrored chains that reach farthest from their common joint, left first.
///
/// The mean of both hands is near the trunk, and there is one head, so only feet are a pair far from it. Limbs
/// with names of arms, heads or wings are no legs, nor are limbs that point towards the head. If two
/// pairs reach about equally far (a quadruped), the hind ones are the legs if names tell them apart;
/// otherwise no legs are returned. If the body travels, legs rest on the ground in turn.
///
/// Directions are those of the rest pose or, if it decides nothing, of the motion.
pub(super) fn find(tree: &Tree) -> Option<[Leg; 2]> {
    let rest: Vec<Track> = tree.rest_pose().into_iter().map(|position| vec![position]).collect();
    let by_rest_pose = if tree.has_standing_rest_pose() { find_in(tree, &rest, false) } else { None };
    by_rest_pose.or_else(|| find_in(tree, tree.tracks(), true))
}

/// Returns the legs by the directions of limbs in the tracks of the members, and by rest on the ground if
/// `is_motion`.
fn find_in(tree: &Tree, tracks: &[Track], is_motion: bool) -> Option<[Leg; 2]> {
    let means: Vec<Vector3<f64>> =
        tracks.iter().map(|track| track.iter().sum::<Vector3<f64>>() / track.len() as f64).collect();
    let no_legs = branches_without_legs(tree);
    let pairs = tree.members().flat_map(|joint| pairs_below(tree, &means, &no_legs, joint));
    let mut pairs: Vec<LimbPairing> = pairs.collect();
    let is_hind = |pair: &LimbPairing| is_limb(tree, pair, LimbPair::Hind);
    if pairs.iter().any(is_hind) {
        pairs.retain(is_hind);
    }
    if is_motion {
        let rests: Vec<Option<f64>> = pairs.iter().map(|pair| tree.rest_fraction(&pair.joints())).collect();
        let is_hand = |rest: Option<f64>| rest.is_some_and(|rest| rest < HANDS_REST);
        let has_feet = rests.iter().flatten().any(|&rest| rest >= FEET_REST);
        if has_feet || rests.iter().all(|&rest| is_hand(rest)) {
            // Feet rest on the ground in turn while the body travels; other limbs never do.
            let mut rests = rests.iter();
            pairs.retain(|_| rests.next().is_some_and(|&rest| !is_hand(rest)));
        }
    }
    let reaches: Vec<f64> = pairs.iter().map(|pair| pair.reach.norm()).collect();
    let order = sort::argsort_descending(&reaches);
    let best = &pairs[*order.first()?];
    let is_rival = |&index: &usize| {
        reaches[index] > RIVAL_REACH * best.reach.norm() && !shares_limb(tree, &pairs[index], best)
    };
    if order[1..].iter().any(is_rival) || best.chains.iter().any(|chain| chain.len() < 3) {
        return None;
    }
    let legs = [&best.chains[0], &best.chains[1]].map(|chain| leg_of_chain(tree, chain));
    // The names of either leg decide the sides, if they tell them.
    let sides = [&best.chains[0], &best.chains[1]]
        .map(|chain| chain.iter().rev().find_map(|&joint| tree.name(joint).side));
    let is_first_left = match sides {
        [Some(side), _] => side == Side::Left,
        [None, Some(side)] => side == Side::Right,
        [None, None] => is_first_left(tree, tracks, best.fork, &legs),
    };
    Some(if is_first_left { legs } else { [legs[1], legs[0]] })
}

fn is_limb(tree: &Tree, pair: &LimbPairing, limb: LimbPair) -> bool {
    pair.chains.iter().flatten().any(|&joint| tree.name(joint).limb_pair == Some(limb))
}

fn shares_limb(tree: &Tree, pair: &LimbPairing, other: &LimbPairing) -> bool {
    pair.chains
        .iter()
        .flatten()
        .any(|&joint| other.chains.iter().any(|chain| tree.is_within(joint, chain[0])))
}

/// Returns the pairs of mirrored branches of one joint that may be legs.
fn pairs_below(tree: &Tree, means: &[Vector3<f64>], no_legs: &[bool], joint: usize) -> Vec<LimbPairing> {
    let branches: Vec<(f64, Vec<usize>)> = tree
        .children(joint)
        .filter(|&child| !no_legs[child - tree.root] && !tree.name(child).is_helper)
        .map(|child| tree.main_chain(child))
        .collect();
    if branches.len() < 2 {
        return Vec::new();
    }
    let mut branches = sort::sort_descending(branches, |(length, _)| *length);
    branches.truncate(MAX_BRANCHES);
    let head = head_direction(tree, means, joint);
    let mut pairs = Vec::new();
    for (index, (_, a)) in branches.iter().enumerate() {
        for (_, b) in &branches[index + 1..] {
            if !are_mirrored(tree, a, b) {
                continue;
            }
            let reach = mean_vector(tree, means, joint, &[a[a.len() - 1], b[b.len() - 1]]);
            let points_to_head = head.is_some_and(|head| head.dot(&reach) > 0.0);
            if !points_to_head {
                pairs.push(LimbPairing { fork: joint, chains: [a.clone(), b.clone()], reach });
            }
        }
    }
    pairs
}

/// Returns for each member whether names within the branch that begins with it say that it is no leg.
fn branches_without_legs(tree: &Tree) -> Vec<bool> {
    let mut no_legs = vec![false; tree.members().len()];
    for joint in tree.members().rev() {
        let name = tree.name(joint);
        no_legs[joint - tree.root] |=
            name.part.is_some_and(BodyPart::excludes_leg) || name.limb_pair == Some(LimbPair::Fore);
        if let Some(parent) = tree.parent(joint) {
            no_legs[parent - tree.root] |= no_legs[joint - tree.root];
        }
    }
    no_legs
}

/// True if two chains have equal bone lengths.
fn are_mirrored(tree: &Tree, a: &[usize], b: &[usize]) -> bool {
    let bones = |chain: &[usize]| -> Vec<f64> {
        chain.windows(2).map(|bone| tree.distance(bone[0], bone[1])).collect()
    };
    a.len() == b.len()
        && bones(a).iter().zip(&bones(b)).all(|(a, b)| (a - b).abs() <= MIRROR_TOLERANCE * a.max(*b))
}

/// Returns the mean vector from `joint` to `tips`, from the mean position of each member.
fn mean_vector(tree: &Tree, means: &[Vector3<f64>], joint: usize, tips: &[usize]) -> Vector3<f64> {
    let sum: Vector3<f64> = tips.iter().map(|&tip| means[tip - tree.root]).sum();
    sum / tips.len() as f64 - means[joint - tree.root]
}

/// Returns the mean vector from `joint` to the head: by name, or to the joints of the longest branch that
/// has no mirrored one, the trunk with the arms.
fn head_direction(tree: &Tree, means: &[Vector3<f64>], joint: usize) -> Option<Vector3<f64>> {
    let named = tree.descendants(joint).find(|&below| {
        matches!(tree.part(below), Some(BodyPart::Head | BodyPart::Neck)) && tree.name(below).side.is_none()
    });
    if let Some(head) = named {
        return Some(mean_vector(tree, means, joint, &[head]));
    }
    let chains: Vec<(f64, Vec<usize>)> =
        tree.children(joint).take(MAX_BRANCHES).map(|child| tree.main_chain(child)).collect();
    let is_single = |index: usize| {
        chains
            .iter()
            .enumerate()
            .all(|(other, (_, chain))| other == index || !are_mirrored(tree, chain, &chains[index].1))
    };
    let longest = (0..chains.len())
        .filter(|&index| is_single(index))
        .max_by(|&a, &b| chains[a].0.total_cmp(&chains[b].0))?;
    let (length, chain) = &chains[longest];
    let branch: Vec<usize> = std::iter::once(chain[0]).chain(tree.descendants(chain[0])).collect();
    (*length > 0.0).then(|| mean_vector(tree, means, joint, &branch))
}

fn leg_of_chain(tree: &Tree, chain: &[usize]) -> Leg {
    let at = leg::ankle_index(tree, chain);
    let ankle = chain[at];
    let (thigh, shank) = leg::thigh_and_shank(tree, &chain[..=at]);
    let unnamed_toe = || chain.get(at + 1).copied().filter(|&joint| !tree.is_leaf(joint));
    let toe = leg::named_toe(tree, ankle).or_else(unnamed_toe);
    Leg { thigh, shank, ankle: Some(ankle), toe, tip: leg::tip(tree, toe.unwrap_or(ankle)) }
}

/// True if the first leg is the left one, judged by the direction of the feet and of the legs.
///
/// Evaluated per pose, as left has no fixed direction in the world when the character turns.
fn is_first_left(tree: &Tree, tracks: &[Track], fork: usize, [leg, other]: &[Leg; 2]) -> bool {
    let (Some(first), Some(second)) = (leg.ankle, other.ankle) else { return true };
    let tips = [(leg, first), (other, second)].map(|(leg, ankle)| leg.tip.unwrap_or(ankle));
    let joints = [first, second, tips[0], tips[1], fork].map(|joint| &tracks[joint - tree.root]);
    let votes = (0..joints[0].len()).map(|frame| {
        let [first, second, tip, other_tip, fork] = joints.map(|track| track[frame]);
        let up = 2.0 * fork - first - second;
        let forward = (tip - first) + (other_tip - second);
        up.cross(&forward).dot(&(first - second))
    });
    votes.sum::<f64>() > 0.0
}
