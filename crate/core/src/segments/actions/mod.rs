//! Actions that recur: groups of segments in which the same is done.
//!
//! Each segment is a set of movements ([`Movement`]): joint positions and velocities relative to the
//! body, so that place, heading, unit, axes and frame rate do not matter. Two segments are compared by
//! the distance of their sets ([`distance`]), and grouped by average linkage. Distances have the unit of
//! a leg length, so the groups are cut at a fixed distance, and their number follows from the data.
//! Actions are named by letters in order of first appearance.
//!
//! The same distance joins the actions of several clips under common names ([`common_names`]).

mod cycles;
mod distance;
mod names;

use crate::segments::linkage;
use crate::segments::movement::{JointSet, Movement, Row};
use crate::segments::progress::Cancelled;
use crate::segments::segment::Segment;
use distance::distance;

/// Maximum distance of the segments of one action, in leg lengths (root mean square over the joints).
/// Chosen on seeds 0 to 3 of the generator: with true cuts, segments of the same action are nearer than
/// 0.138 and those of different actions farther than 0.171.
const MAX_DISTANCE: f64 = 0.155;

/// Number of movements that represent a segment or an action.
const MAX_ROWS: usize = 48;

/// Maximum number of segments or actions of which all pairs are compared, which limits the time.
const MAX_COMPARED: usize = 256;

/// Fractional part of the golden ratio: its multiples are spread evenly and are not periodic.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Movements of an action, by which it is found in other clips.
#[derive(Clone, Debug, PartialEq)]
pub struct ActionMovements {
    /// Name of the action in its clip, as in [`Segment::action`].
    pub name: String,
    rows: Vec<Row>,
    joints: JointSet,
}

/// Names the actions of the segments of a clip and measures their cycles. Returns the movements of each
/// action, in order of first appearance.
///
/// `checkpoint` is called regularly and may cancel.
pub(crate) fn name_actions(
    movement: &Movement,
    segments: &mut [Segment],
    checkpoint: &mut impl FnMut() -> Result<(), Cancelled>,
) -> Result<Vec<ActionMovements>, Cancelled> {
    let mut sets = Vec::with_capacity(segments.len());
    for segment in segments.iter_mut() {
        checkpoint()?;
        let rows = movement.rows(&segment.frames);
        segment.cycles = cycles::cycles(rows, movement.step());
        sets.push(spread(rows.iter()));
    }
    let distance = |a: usize, b: usize| distance(&sets[a], &sets[b]);
    let first_members = linkage::groups(sets.len(), MAX_COMPARED, &distance, MAX_DISTANCE, checkpoint)?;
    let names = names::in_order(&first_members);
    for (segment, name) in segments.iter_mut().zip(&names) {
        segment.action.clone_from(name);
    }
    let firsts = (0..sets.len()).filter(|&segment| first_members[segment] == segment);
    let actions = firsts.map(|first| {
        let members = (first..sets.len()).filter(|&segment| first_members[segment] == first);
        let rows = spread(members.flat_map(|segment| &sets[segment]).collect::<Vec<_>>().into_iter());
        ActionMovements { name: names[first].clone(), rows, joints: movement.joints }
    });
    Ok(actions.collect())
}

/// Returns the names of the actions of several clips, such that equal actions have equal names: letters
/// in order of first appearance, first by clip and then by action.
///
/// Actions that have different names within a clip may have the same name in the result. The names
/// depend on the order of the clips, the groups do not unless there are more than 256 actions; further
/// actions join the group whose first member is nearest, or start a group.
pub fn common_names(clips: &[&[ActionMovements]]) -> Vec<Vec<String>> {
    let actions: Vec<&ActionMovements> = clips.iter().copied().flatten().collect();
    let distance = |a: usize, b: usize| actions[a].distance(actions[b]);
    let groups = linkage::groups(actions.len(), MAX_COMPARED, &distance, MAX_DISTANCE, &mut || Ok(()));
    let mut names = names::in_order(&groups.unwrap_or_default()).into_iter();
    clips.iter().map(|actions| names.by_ref().take(actions.len()).collect()).collect()
}

impl ActionMovements {
    /// Appends the action without its name as numbers, which [`ActionMovements::read`] reads: its joints, the
    /// number of its movements, and the movements.
    pub fn write(&self, values: &mut Vec<f32>) {
        values.extend([f32::from(self.joints.bits()), self.rows.len() as f32]);
        values.extend(self.rows.as_flattened());
    }

    /// Reads actions that [`ActionMovements::write`] wrote. Their names are empty. Stops at an incomplete one.
    pub fn read(mut values: &[f32]) -> Vec<ActionMovements> {
        let mut actions = Vec::new();
        while let &[joints, count, ref rest @ ..] = values {
            let Some(rows) = rest.as_chunks().0.get(..count as usize) else { break };
            values = &rest[rows.as_flattened().len()..];
            let joints = JointSet::from_bits(joints as u16);
            actions.push(ActionMovements { name: String::new(), rows: rows.to_vec(), joints });
        }
        actions
    }

    /// Returns the distance of two actions by the joints that are known for both; infinite if they are
    /// too few.
    fn distance(&self, other: &ActionMovements) -> f64 {
        if self.joints == other.joints {
            return distance(&self.rows, &other.rows);
        }
        let Some(common) = self.joints.common(other.joints) else { return f64::INFINITY };
        let restrict = |action: &ActionMovements| -> Vec<Row> {
            action.rows.iter().map(|row| action.joints.restrict(row, common)).collect()
        };
        distance(&restrict(self), &restrict(other))
    }
}

/// Returns at most [`MAX_ROWS`] rows that are spread evenly over the given ones. Their spacing is
/// irregular, so that no phase of a periodic movement is left out.
fn spread<'a>(rows: impl ExactSizeIterator<Item = &'a Row> + Clone) -> Vec<Row> {
    let count = rows.len();
    if count <= MAX_ROWS {
        return rows.copied().collect();
    }
    let mut picked: Vec<usize> =
        (0..MAX_ROWS).map(|n| ((n as f64 * GOLDEN).fract() * count as f64) as usize).collect();
    picked.sort_unstable();
    picked.dedup();
    let mut picked = picked.into_iter().peekable();
    rows.enumerate().filter(|(index, _)| picked.next_if_eq(index).is_some()).map(|(_, row)| *row).collect()
}
