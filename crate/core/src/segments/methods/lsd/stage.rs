//! The shape of the body in any frame.

use crate::bvh::Clip;
use crate::kinematics::Kinematics;
use crate::segments::body::Body;
use crate::segments::methods::lsd::align::Shape;
use crate::skeleton::Skeleton;

/// Length of thigh and shank together in the unit of all lengths here: that of the skeletons
/// on which the patent's threshold keeps its meaning.
const LEG: f64 = 15.94;

/// Length of such a leg in metres, where there is none to measure.
const METRES: f64 = 0.9;

/// Joints over which squares are summed; where some are missing, the others stand for them.
const JOINTS: f64 = 19.0;

/// Sets the body up in one frame after the other.
#[derive(Debug)]
pub(crate) struct Stage<'a> {
    clip: &'a Clip,
    joints: &'a [usize],
    /// From file units to the unit of distances.
    scale: f64,
    kinematics: Kinematics<'a>,
}

impl<'a> Stage<'a> {
    /// The stage for the joints of a body.
    pub fn of(clip: &'a Clip, skeleton: &Skeleton, body: &'a Body) -> Stage<'a> {
        let leg = skeleton.leg.filter(|leg| leg.is_normal());
        let unit = leg.map_or(skeleton.metres_per_unit * LEG / METRES, |leg| LEG / leg);
        let joints = &body.joints[..];
        let scale = unit * (JOINTS / joints.len() as f64).sqrt();
        Stage { clip, joints, scale, kinematics: Kinematics::of_joints(clip, joints) }
    }

    /// The shape in a frame of the clip.
    pub fn shape(&mut self, frame: usize) -> Shape {
        shape(&mut self.kinematics, frame, self.joints, self.scale)
    }

    /// The shape with all rotations zero.
    pub fn rest(&self) -> Shape {
        let still = Clip::new(self.clip.joints().to_vec(), self.clip.frame_time(), Vec::new());
        shape(&mut Kinematics::of_joints(&still, self.joints), 0, self.joints, self.scale)
    }
}

fn shape(kinematics: &mut Kinematics, frame: usize, joints: &[usize], scale: f64) -> Shape {
    let pose = kinematics.pose(frame);
    Shape::new(joints.iter().map(|&joint| pose[joint] * scale))
}
