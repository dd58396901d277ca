//! Joints that the methods measure, by role, on any skeleton.

use crate::bvh::Clip;
use crate::notice::{Code, Notice};
use crate::segments::SegmentError;
use crate::skeleton::{Role, Skeleton};

/// Minimum number of joints that describe a pose.
const MIN_JOINTS: usize = 4;

const LIMBS: [Role; 8] = [
    Role::LeftArm,
    Role::RightArm,
    Role::LeftForearm,
    Role::RightForearm,
    Role::LeftThigh,
    Role::RightThigh,
    Role::LeftShank,
    Role::RightShank,
];
const ENDS: [Role; 6] =
    [Role::LeftAnkle, Role::RightAnkle, Role::LeftToe, Role::RightToe, Role::LeftHand, Role::RightHand];

/// Leg length in metres if the skeleton has none.
const DEFAULT_LEG_METRES: f64 = 0.9;

/// Returns the length of thigh and shank, in file units: the unit of distances between poses.
pub(crate) fn leg_length(skeleton: &Skeleton) -> f64 {
    let leg = skeleton.leg.filter(|leg| leg.is_normal());
    leg.unwrap_or(DEFAULT_LEG_METRES / skeleton.metres_per_unit)
}

/// Joints to measure, and roles that are missing.
#[derive(Debug)]
pub(crate) struct Body {
    pub joints: Vec<usize>,
    pub missing: Vec<&'static str>,
}

impl Body {
    /// Returns the 14 joints whose rotations define a pose (Zhang and Wang, section 2.1): three
    /// each of the back and of neck and head, and the upper and lower limbs.
    ///
    /// # Errors
    /// If too few of them are known.
    pub fn rotation_joints(clip: &Clip, skeleton: &Skeleton) -> Result<Body, SegmentError> {
        let mut body = Body { joints: Vec::new(), missing: Vec::new() };
        body.add_chain(clip, skeleton, Role::Spine, Role::Chest, 3);
        body.add_chain(clip, skeleton, Role::Neck, Role::Head, 3);
        body.add(skeleton, &LIMBS);
        body.check()
    }

    /// Returns the 19 joints whose positions define a pose (patent, step S3): hips, two of the
    /// back, neck, head, and the limbs down to hands and toes.
    ///
    /// # Errors
    /// If too few of them are known.
    pub fn position_joints(clip: &Clip, skeleton: &Skeleton) -> Result<Body, SegmentError> {
        let mut body = Body { joints: Vec::new(), missing: Vec::new() };
        body.add(skeleton, &[Role::Hips]);
        body.add_chain(clip, skeleton, Role::Spine, Role::Chest, 2);
        body.add(skeleton, &[Role::Neck, Role::Head]);
        body.add(skeleton, &LIMBS);
        body.add(skeleton, &ENDS);
        body.check()
    }

    /// Returns a notice about missing joints, if any.
    pub fn notices(&self) -> Vec<Notice> {
        if self.missing.is_empty() {
            return Vec::new();
        }
        let text = format!("These joints were not found and are not compared: {}.", self.missing.join(", "));
        vec![Notice::new(Code::MissingJoints, text)]
    }

    fn add(&mut self, skeleton: &Skeleton, roles: &[Role]) {
        for &role in roles {
            match skeleton.roles.get(role) {
                Some(joint) => self.joints.push(joint),
                None => self.missing.push(role.name()),
            }
        }
    }

    /// Adds at most `max` joints of the chain between two roles, from the upper end.
    fn add_chain(&mut self, clip: &Clip, skeleton: &Skeleton, from: Role, to: Role, max: usize) {
        let (bottom, top) = (skeleton.roles.get(from), skeleton.roles.get(to));
        self.missing.extend(
            [(from, bottom), (to, top)]
                .iter()
                .filter(|(_, joint)| joint.is_none())
                .map(|(role, _)| role.name()),
        );
        let (Some(bottom), Some(top)) = (bottom, top) else {
            self.joints.extend(bottom.or(top));
            return;
        };
        let up = std::iter::successors(Some(top), |&joint| clip.joints()[joint].parent);
        let mut chain: Vec<usize> = up.take_while(|&joint| joint != bottom).take(max).collect();
        if chain.len() < max {
            chain.push(bottom);
        }
        self.joints.extend(chain.into_iter().rev());
    }

    fn check(self) -> Result<Body, SegmentError> {
        if self.joints.len() >= MIN_JOINTS {
            return Ok(self);
        }
        let count = self.joints.len();
        Err(SegmentError::TooFewJoints {
            found: count,
            wanted: count + self.missing.len(),
            missing: self.missing.join(", "),
        })
    }
}
