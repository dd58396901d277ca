//! Comparison of clips with the points of their joints.

use nalgebra::Vector3;
use plantigrade::bvh::Clip;
use plantigrade::kinematics::{self, Kinematics};
use plantigrade::plants::{self, Feet, ValidParams};
use plantigrade::points::{PointClip, Points};
use plantigrade::skeleton::{Overrides, Skeleton};

/// Returns the coordinates of all joints in all frames.
pub fn coordinates(clip: &Clip) -> Vec<f64> {
    let mut kinematics = Kinematics::new(clip);
    let mut coordinates = Vec::new();
    for frame in 0..kinematics::pose_count(clip) {
        let pose: &[Vector3<f64>] = kinematics.pose(frame);
        coordinates.extend(pose.iter().flat_map(|position| [position.x, position.y, position.z]));
    }
    coordinates
}

/// Returns the roles of a skeleton as overrides, with its up axis and unit.
fn overrides(skeleton: &Skeleton) -> Overrides {
    Overrides {
        roles: skeleton.roles.iter().map(|(role, joint)| (role, Some(joint))).collect(),
        up: Some(skeleton.up),
        metres_per_unit: Some(skeleton.metres_per_unit),
    }
}

/// Checks that the joints of a clip as points have its labels, connected and unconnected. Returns false if
/// the clip has no feet or no motion.
pub fn have_the_labels_of(clip: &Clip, name: &str) -> bool {
    let skeleton = Skeleton::main(clip, &Overrides::default());
    let Ok(feet) = Feet::new(clip, &skeleton) else { return false };
    let expected = plants::detect(&feet, ValidParams::default());
    let positions = coordinates(clip);
    let names: Vec<String> = (0..clip.joints().len()).map(|joint| joint.to_string()).collect();
    let connected: Vec<Option<usize>> = clip.joints().iter().map(|joint| joint.parent).collect();
    for parents in [&connected[..], &[]] {
        let points = Points { positions: &positions, names: &names, parents, rate: clip.rate() };
        let PointClip { clip: mut points, skeleton, .. } =
            points.clip(&overrides(&skeleton)).unwrap_or_else(|error| panic!("{name}: {error}"));
        points.set_frame_time(clip.frame_time());
        let feet = Feet::new(&points, &skeleton).expect("feet");
        let detection = plants::detect(&feet, ValidParams::default());
        assert!(detection.parts == expected.parts, "{name}: labels of points differ from those of the clip");
    }
    true
}
