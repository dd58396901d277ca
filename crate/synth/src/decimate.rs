//! Reduction of the frame rate.

use plantigrade::bvh::Clip;
use plantigrade::foot::{Part, Side};
use plantigrade::formats::{Origin, Plant};

use crate::generate::Generated;

/// Returns every `factor`-th frame of a clip and its truth, starting with the first.
///
/// # Panics
/// If `factor` is 0.
pub fn decimate(generated: &Generated, factor: usize) -> Generated {
    let Generated { clip, truth } = generated;
    let frames = || (0..clip.frame_count()).step_by(factor);
    let values = frames().flat_map(|frame| clip.row(frame)).copied().collect();
    let clip = Clip::new(clip.joints().to_vec(), factor as f64 * clip.frame_time(), values);

    let mut decimated_truth = truth.clone();
    let header = &mut decimated_truth.header;
    (header.frames, header.rate) = (clip.frame_count(), clip.rate());
    for part in Part::ALL {
        for side in Side::BOTH {
            let Some(labels) = truth.labels(side, part) else { continue };
            let labels: Vec<bool> = frames().map(|frame| labels[frame]).collect();
            let foot =
                if side == Side::Left { &mut decimated_truth.left } else { &mut decimated_truth.right };
            foot.set(part, &labels, |run| Plant::new(run, clip.rate(), Origin::Truth));
        }
    }
    Generated { clip, truth: decimated_truth }
}
