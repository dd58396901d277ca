//! The same motion at a lower frame rate.

use plantigrade::bvh::Clip;
use plantigrade::foot::{Part, Side};
use plantigrade::formats::SpanSource;

use crate::recipe::Generated;

/// Every `factor`-th frame of `generated`, the first included, with its truth.
///
/// # Panics
/// If `factor` is 0.
pub fn decimated(generated: &Generated, factor: usize) -> Generated {
    let Generated { clip, truth } = generated;
    let kept = || (0..clip.frame_count()).step_by(factor);
    let values = kept().flat_map(|frame| clip.row(frame)).copied().collect();
    let clip = Clip::new(clip.joints().to_vec(), factor as f64 * clip.frame_time(), values);

    let mut fewer = truth.clone();
    (fewer.frames, fewer.rate) = (clip.frame_count(), clip.rate());
    for part in Part::ALL {
        for side in Side::BOTH {
            let Some(labels) = truth.labels(side, part) else { continue };
            let labels: Vec<bool> = kept().map(|frame| labels[frame]).collect();
            let foot = if side == Side::Left { &mut fewer.left } else { &mut fewer.right };
            foot.set(part, &labels, clip.rate(), |_| SpanSource::Truth);
        }
    }
    Generated { clip, truth: fewer }
}
