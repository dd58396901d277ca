//! Legs by joint names.

use super::leg::{self, Leg};
use super::tree::Tree;
use crate::foot::Side;
use crate::skeleton::names::{BodyPart, LimbPair};

/// Number of candidates per side that are compared, in file order.
const MAX_CANDIDATES: usize = 32;

/// A possible leg with the evidence of its names.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    leg: Leg,
    score: f64,
}

/// Returns the legs of both sides that names identify, left first.
pub(super) fn find(tree: &Tree) -> [Option<Leg>; 2] {
    let [left, right] = Side::BOTH.map(|side| candidates(tree, side));
    // Legs of one pair have equal depth and parts.
    let pairs = left.iter().flat_map(|a| right.iter().map(move |b| (a, b)));
    let score = |(a, b): &(&Candidate, &Candidate)| a.score + b.score + symmetry(tree, &a.leg, &b.leg);
    let best_pair = first_max(pairs, score);
    match best_pair {
        Some((left, right)) => [Some(left.leg), Some(right.leg)],
        None => [left, right].map(|side| first_max(side.iter(), |leg| leg.score).map(|best| best.leg)),
    }
}

/// Returns the first item with the highest score.
fn first_max<T>(items: impl Iterator<Item = T>, score: impl Fn(&T) -> f64) -> Option<T> {
    let mut best: Option<(f64, T)> = None;
    for item in items {
        let score = score(&item);
        if best.as_ref().is_none_or(|(highest, _)| score > *highest) {
            best = Some((score, item));
        }
    }
    best.map(|(_, item)| item)
}

/// Returns 0.5 for legs of equal depth, and another 0.5 if both or none have a toe.
fn symmetry(tree: &Tree, a: &Leg, b: &Leg) -> f64 {
    let depth = |leg: &Leg| leg.ankle.map(|ankle| tree.ancestors(ankle).count());
    let has_toe = |leg: &Leg| leg.toe.is_some();
    f64::from(depth(a) == depth(b)) * 0.5 + f64::from(has_toe(a) == has_toe(b)) * 0.5
}

/// Returns the possible legs of one side.
fn candidates(tree: &Tree, side: Side) -> Vec<Candidate> {
    let is_on_side = |joint: usize| tree.side(joint) == Some(side);
    let is_foot = |joint: usize| {
        matches!(tree.part(joint), Some(BodyPart::Ankle | BodyPart::Foot)) && is_on_side(joint)
    };
    // Below a foot, another one is its middle, unless its name is plainer; below a hand, it is no
    // foot.
    let is_topmost = |joint: usize| {
        let unknown_words = tree.name(joint).unknown_words;
        !tree.ancestors(joint).any(|above| {
            is_foot(above) && tree.name(above).unknown_words <= unknown_words
                || tree.part(above).is_some_and(BodyPart::excludes_leg)
        })
    };
    let feet = tree.members().filter(|&joint| is_foot(joint) && is_topmost(joint));
    let mut ankles: Vec<usize> = feet.take(MAX_CANDIDATES).collect();
    if ankles.is_empty() {
        // No foot is named: the ankle is at the end of the bones of a leg.
        let is_leg = |joint: usize| is_on_side(joint) && tree.part(joint).is_some_and(BodyPart::is_of_leg);
        let tops = tree.members().filter(|&joint| {
            is_leg(joint) && tree.part(joint) != Some(BodyPart::Toe) && !tree.ancestors(joint).any(is_leg)
        });
        ankles = tops.filter_map(|top| unnamed_ankle(tree, top)).take(MAX_CANDIDATES).collect();
    }
    ankles.into_iter().map(|ankle| candidate(tree, side, ankle)).collect()
}

/// Returns the ankle below the topmost joint of a leg by bone lengths; never a joint named thigh or
/// knee.
fn unnamed_ankle(tree: &Tree, top: usize) -> Option<usize> {
    let (_, chain) = tree.main_chain(top);
    let is_thigh = |&joint: &usize| matches!(tree.part(joint), Some(BodyPart::Thigh | BodyPart::Hip));
    let is_shank = |&joint: &usize| tree.part(joint) == Some(BodyPart::Shank);
    // Below a thigh, the leg is the shank; below a shank, it is the foot.
    let is_leg_shank = chain.iter().any(is_thigh) && !chain.iter().any(is_shank);
    let is_above = |joint: &usize| {
        is_thigh(joint) || is_shank(joint) || is_leg_shank && tree.part(*joint) == Some(BodyPart::Leg)
    };
    let first = chain.iter().rposition(is_above).map_or(0, |last| last + 1);
    // One bone is no leg.
    chain.get(leg::ankle_index(tree, &chain).max(first).max(1)).copied()
}

fn candidate(tree: &Tree, side: Side, ankle: usize) -> Candidate {
    let chain = chain_on_side(tree, side, ankle);
    let (thigh, shank) = leg::thigh_and_shank(tree, &chain);
    let mut leg = Leg { thigh, shank, ankle: Some(ankle), toe: leg::named_toe(tree, ankle), tip: None };
    // In a list of points, the leg is not a chain.
    if chain.len() == 1 {
        fill_by_names(tree, side, &mut leg);
    }
    leg.tip = leg::tip(tree, leg.toe.unwrap_or(ankle));
    let is_named = |joint: Option<usize>| joint.is_some_and(|joint| tree.name(joint).part.is_some());
    let unknown_words: usize = chain.iter().map(|&joint| tree.name(joint).unknown_words).sum();
    let is_of = |pair| chain.iter().any(|&joint| tree.name(joint).limb_pair == Some(pair));
    let mut score = 2.0 * f64::from(is_named(leg.thigh))
        + 2.0 * f64::from(is_named(leg.shank))
        + f64::from(leg.toe.is_some())
        - 0.1 * unknown_words.min(20) as f64
        - tree.name(ankle).unknown_words.min(2) as f64;
    // In a list of points, no order tells that a foot is below its ankle.
    if chain.len() == 1 && tree.part(ankle) == Some(BodyPart::Ankle) {
        score += 0.5;
    }
    if is_of(LimbPair::Fore) {
        score -= 8.0;
    }
    if is_of(LimbPair::Hind) {
        score -= 4.0;
    }
    if !tree.is_animated(&chain) {
        score -= 4.0;
    }
    Candidate { leg, score }
}

/// Returns the joints of one leg from the top down to `ankle`: its ancestors below the root, up to the
/// first that is named after the other side, pelvis or trunk, or that has descendants of the other side.
fn chain_on_side(tree: &Tree, side: Side, ankle: usize) -> Vec<usize> {
    let is_of_leg = |&joint: &usize| {
        let name = tree.name(joint);
        tree.parent(joint).is_some()
            && name.side.is_none_or(|named| named == side)
            && !matches!(name.part, Some(BodyPart::Hips | BodyPart::Spine))
            && !tree.descendants(joint).any(|below| tree.name(below).side.is_some_and(|other| other != side))
    };
    let mut chain: Vec<usize> =
        std::iter::once(ankle).chain(tree.ancestors(ankle).take_while(is_of_leg)).collect();
    chain.reverse();
    chain
}

/// Assigns joints of a list of points by name alone.
fn fill_by_names(tree: &Tree, side: Side, leg: &mut Leg) {
    let Some(ankle) = leg.ankle else { return };
    let first = |parts: &[BodyPart]| {
        tree.members().find(|&joint| {
            joint != ankle
                && tree.name(joint).side == Some(side)
                && tree.part(joint).is_some_and(|part| parts.contains(&part))
        })
    };
    leg.thigh = first(&[BodyPart::Thigh]).or_else(|| first(&[BodyPart::Hip]));
    leg.shank = first(&[BodyPart::Shank]).or_else(|| first(&[BodyPart::Leg]).filter(|_| leg.thigh.is_some()));
    leg.toe = leg.toe.or_else(|| first(&[BodyPart::Toe]));
    if tree.part(ankle) == Some(BodyPart::Ankle) {
        leg.toe = leg.toe.or_else(|| first(&[BodyPart::Foot]));
    }
}
