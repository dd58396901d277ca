//! Shapes of the body in the frames of a clip.

use crate::bvh::Clip;
use crate::kinematics::Kinematics;
use crate::segments::body::{self, Body};
use crate::segments::methods::lsd::align::Shape;
use crate::skeleton::Skeleton;

/// Leg length (thigh plus shank) in the unit of all distances: that of the skeletons for which the
/// patent states its threshold.
const LEG_LENGTH: f64 = 15.94;

/// Number of joints over which squared distances are summed; if some are missing, the sum is
/// scaled.
const FULL_JOINT_COUNT: f64 = 19.0;

/// Computes the shape of the body in each frame.
#[derive(Debug)]
pub(crate) struct PoseShapes<'a> {
    clip: &'a Clip,
    joints: &'a [usize],
    /// Factor from file units to the unit of distances.
    scale: f64,
    kinematics: Kinematics<'a>,
}

impl<'a> PoseShapes<'a> {
    /// Creates the shapes for the joints of a body.
    pub fn new(clip: &'a Clip, skeleton: &Skeleton, body: &'a Body) -> PoseShapes<'a> {
        let joints = &body.joints[..];
        let scale = LEG_LENGTH / body::leg_length(skeleton) * (FULL_JOINT_COUNT / joints.len() as f64).sqrt();
        PoseShapes { clip, joints, scale, kinematics: Kinematics::for_joints(clip, joints) }
    }

    /// Returns the shape in a frame.
    pub fn shape(&mut self, frame: usize) -> Shape {
        shape(&mut self.kinematics, frame, self.joints, self.scale)
    }

    /// Returns the shape with all rotations zero.
    pub fn rest_shape(&self) -> Shape {
        let rest_clip = Clip::new(self.clip.joints().to_vec(), self.clip.frame_time(), Vec::new());
        shape(&mut Kinematics::for_joints(&rest_clip, self.joints), 0, self.joints, self.scale)
    }
}

fn shape(kinematics: &mut Kinematics, frame: usize, joints: &[usize], scale: f64) -> Shape {
    let pose = kinematics.pose(frame);
    Shape::new(joints.iter().map(|&joint| pose[joint] * scale))
}
