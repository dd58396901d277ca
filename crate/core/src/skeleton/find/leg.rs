//! Joints of one leg along a chain from the pelvis to the tip of the foot.

use super::tree::Tree;
use crate::skeleton::names::BodyPart;

/// Joints of one leg.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Leg {
    pub thigh: Option<usize>,
    pub shank: Option<usize>,
    pub ankle: Option<usize>,
    pub toe: Option<usize>,
    pub tip: Option<usize>,
}

/// Fraction of a leg's length, from the hip joint to the tip, that a foot takes at most.
///
/// The feet of the generated characters take 0.17 to 0.23.
const MAX_FOOT: f64 = 0.3;

/// Straightness of a chain, relative to its straightest part, at which it begins with the hip joint.
///
/// A thigh and a shank of a stretched leg have a straightness of 1; with a joint at the side of the
/// pelvis in front they have less than 0.96.
const MIN_STRAIGHTNESS: f64 = 0.98;

/// Returns the index of the ankle in a chain of joints by bone lengths: the first joint after which
/// only a foot is left.
pub(super) fn ankle_index(tree: &Tree, chain: &[usize]) -> usize {
    let lengths: Vec<f64> = chain.windows(2).map(|bone| tree.distance(bone[0], bone[1])).collect();
    let total: f64 = lengths.iter().sum();
    let mut rest = total;
    for (index, length) in lengths.iter().enumerate() {
        if rest <= MAX_FOOT * total {
            return index;
        }
        rest -= length;
    }
    chain.len() - 1
}

/// Assigns thigh and shank of the chain that ends with an ankle, by names or by bone lengths.
pub(super) fn thigh_and_shank(tree: &Tree, chain: &[usize]) -> (Option<usize>, Option<usize>) {
    let Some((_, above)) = chain.split_last() else { return (None, None) };
    let is_named = |joint: usize, part| tree.name(joint).part == Some(part);
    // A part may be split into several joints; the topmost one with the plainest name counts.
    let first = |part| {
        let named = (0..above.len()).filter(|&at| is_named(above[at], part));
        named.min_by_key(|&at| (tree.name(above[at]).is_helper, tree.name(above[at]).unknown_words))
    };
    let named_thigh = first(BodyPart::Thigh).or_else(|| first(BodyPart::Hip));
    let named_shank = first(BodyPart::Shank);
    let (thigh, shank) = match (named_thigh, named_shank, first(BodyPart::Leg)) {
        (Some(thigh), Some(shank), _) => (Some(thigh), Some(shank)),
        (Some(thigh), None, leg) => (Some(thigh), leg.filter(|&leg| leg > thigh)),
        (None, Some(shank), leg) => (leg.filter(|&leg| leg < shank), Some(shank)),
        // Of several joints named leg, bone lengths tell the knee.
        (None, None, Some(leg)) => (Some(leg), None),
        (None, None, None) => (None, None),
    };
    // Without a named shank, the joint above the ankle is the knee, unless it is the only one.
    let thigh =
        thigh.or_else(|| hip_joint(tree, chain, shank.unwrap_or(above.len().saturating_sub(1)).max(1)));
    let shank = shank.or_else(|| knee(tree, chain, thigh?));
    (thigh.map(|at| chain[at]), shank.map(|at| chain[at]))
}

/// Returns the index of the hip joint: the first joint before index `end` from which the chain to
/// the ankle is straight when the leg is stretched.
fn hip_joint(tree: &Tree, chain: &[usize], end: usize) -> Option<usize> {
    let ankle = *chain.last()?;
    let straightness: Vec<f64> = (0..end.min(chain.len() - 1))
        .map(|start| {
            let length: f64 = chain[start..].windows(2).map(|bone| tree.distance(bone[0], bone[1])).sum();
            let poses = tree.track(chain[start]).iter().zip(tree.track(ankle));
            let reach = poses.map(|(hip, ankle)| (ankle - hip).norm()).fold(0.0, f64::max);
            if length > 0.0 { reach / length } else { 0.0 }
        })
        .collect();
    let best = straightness.iter().copied().fold(0.0, f64::max);
    straightness.iter().position(|&straight| straight >= MIN_STRAIGHTNESS * best)
}

/// Returns the index of the knee: the joint nearest to the middle of the chain from the hip joint to
/// the ankle.
fn knee(tree: &Tree, chain: &[usize], hip: usize) -> Option<usize> {
    let lengths: Vec<f64> = chain[hip..].windows(2).map(|bone| tree.distance(bone[0], bone[1])).collect();
    let total: f64 = lengths.iter().sum();
    let mut length = 0.0;
    let mut best = None;
    for (index, bone) in lengths.iter().enumerate().take(lengths.len().saturating_sub(1)) {
        length += bone;
        let error = (length - total / 2.0).abs();
        if best.is_none_or(|(least, _)| error < least) {
            best = Some((error, hip + index + 1));
        }
    }
    best.map(|(_, index)| index)
}

/// Returns the toe base below an ankle, by names.
pub(super) fn named_toe(tree: &Tree, ankle: usize) -> Option<usize> {
    let with_part = |part| {
        tree.descendants(ankle).filter(move |&joint| tree.part(joint) == Some(part)).min_by_key(|&joint| {
            let name = tree.name(joint);
            (tree.ancestors(joint).count(), name.unknown_words, &tree.clip.joints()[joint].name)
        })
    };
    // A foot below the ankle is its front part, which replaces a toe that is not named.
    with_part(BodyPart::Toe).or_else(|| with_part(BodyPart::Foot))
}

/// Returns the end of the foot: the leaf below `joint` that is farthest from it in the rest pose.
/// Heels and helpers are skipped.
pub(super) fn tip(tree: &Tree, joint: usize) -> Option<usize> {
    let is_front = |member: usize| {
        std::iter::once(member).chain(tree.ancestors(member)).take_while(|&above| above != joint).all(
            |above| {
                let name = tree.name(above);
                name.part != Some(BodyPart::Heel) && !name.is_helper
            },
        )
    };
    let reach = |tip: usize| {
        let mut offset = tree.clip.joints()[tip].offset;
        for above in tree.ancestors(tip).take_while(|&above| above != joint) {
            offset += tree.clip.joints()[above].offset;
        }
        offset.norm()
    };
    tree.descendants(joint)
        .filter(|&member| tree.is_leaf(member) && is_front(member))
        .max_by(|&a, &b| reach(a).total_cmp(&reach(b)))
}
