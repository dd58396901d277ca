//! Poses for display.

use js_sys::Float32Array;
use plantigrade::bvh::Clip;
use plantigrade::kinematics;
use plantigrade::skeleton::Skeleton;

/// Number of poses computed at a time.
const CHUNK: usize = 1024;

/// Joint positions of all poses, written to JavaScript memory in chunks: wasm memory never shrinks,
/// so a copy of all poses would occupy it permanently.
pub(crate) fn all(skeleton: &Skeleton, clip: &Clip) -> Float32Array {
    let (poses, width) = (kinematics::pose_count(clip), clip.joints().len() * 3);
    let all = Float32Array::new_with_length((poses * width) as u32);
    for start in (0..poses).step_by(CHUNK) {
        let end = poses.min(start + CHUNK);
        let chunk = skeleton.positions_in(clip, start..end);
        all.subarray((start * width) as u32, (end * width) as u32).copy_from(&chunk);
    }
    all
}
