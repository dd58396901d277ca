//! Labels by the nearest neighbours of the frames that a person labelled, for comparison.

use plantigrade::foot::{Part, Side};
use plantigrade::plants::{Detection, Edit, Feet};

/// Number of neighbours.
const NEIGHBOURS: usize = 5;

/// Labels of contact per frame, left foot first: each frame has the majority of the labels of the five nearest
/// frames of `edits`, and frames of `edits` have their own. The samples are height and speed of contact and toe,
/// in leg lengths, of three consecutive frames, as in the clustering.
pub fn labels(feet: &Feet, detection: &Detection, edits: &[Edit]) -> [Vec<bool>; 2] {
    let sample = |side: Side, frame: usize| -> Vec<f32> {
        let last = feet.frame_count() - 1;
        let window = [frame.saturating_sub(1), frame, (frame + 1).min(last)];
        let parts = [Part::Contact, Part::Toe].map(|part| detection.part(part).expect("a part").foot(side));
        let values = window.into_iter().flat_map(|frame| {
            parts.into_iter().flat_map(move |foot| [foot.height[frame] / 0.4, foot.speed[frame] / 8.0])
        });
        values.map(|value| value / feet.leg as f32).collect()
    };
    let labelled: Vec<(Vec<f32>, bool)> = edits
        .iter()
        .flat_map(|edit| (edit.start..edit.end).map(|frame| (sample(edit.side, frame), edit.planted)))
        .collect();
    Side::BOTH.map(|side| {
        let label = |frame: usize| {
            let here = sample(side, frame);
            let distance = |other: &[f32]| here.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f32>();
            let mut nearest: Vec<(f32, bool)> =
                labelled.iter().map(|(sample, planted)| (distance(sample), *planted)).collect();
            let count = NEIGHBOURS.min(nearest.len());
            if count == 0 {
                return false;
            }
            nearest.select_nth_unstable_by(count - 1, |a, b| a.0.total_cmp(&b.0));
            2 * nearest[..count].iter().filter(|(_, planted)| *planted).count() > count
        };
        let mut labels: Vec<bool> = (0..feet.frame_count()).map(label).collect();
        for edit in edits.iter().filter(|edit| edit.side == side) {
            labels[edit.start..edit.end].fill(edit.planted);
        }
        labels
    })
}
