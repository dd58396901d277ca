//! Poses for display.

use js_sys::Float32Array;
use plantigrade::bvh::Clip;
use plantigrade::motion;
use plantigrade::skeleton::Skeleton;

/// Poses that are placed at a time.
const PART: usize = 1024;

/// All poses: they are written to the page's memory part by part, as the module's own never
/// shrinks once it has held them.
pub(crate) fn all(skeleton: &Skeleton, clip: &Clip) -> Float32Array {
    let (poses, width) = (motion::pose_count(clip), clip.joints().len() * 3);
    let all = Float32Array::new_with_length((poses * width) as u32);
    for start in (0..poses).step_by(PART) {
        let end = poses.min(start + PART);
        let part = skeleton.positions_in(clip, start..end);
        all.subarray((start * width) as u32, (end * width) as u32).copy_from(&part);
    }
    all
}
