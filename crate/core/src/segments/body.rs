//! The joints that methods measure, by role, on skeletons of any make.

use crate::bvh::Clip;
use crate::notice::{Code, Notice};
use crate::skeleton::{Role, Skeleton};

use crate::segments::SegmentError;

/// Fewer joints than this say too little of a pose.
const FEWEST: usize = 4;

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

/// Joints to measure, and what is not there.
#[derive(Debug)]
pub(crate) struct Body {
    pub joints: Vec<usize>,
    pub missing: Vec<&'static str>,
}

impl Body {
    /// The 14 joints whose rotations make a pose (Zhang and Wang, section 2.1): three each
    /// of back and of neck and head, and the upper and lower limbs.
    ///
    /// # Errors
    /// If too few of them are known.
    pub fn turning(clip: &Clip, skeleton: &Skeleton) -> Result<Body, SegmentError> {
        let mut body = Body { joints: Vec::new(), missing: Vec::new() };
        body.add_chain(clip, skeleton, Role::Spine, Role::Chest, 3);
        body.add_chain(clip, skeleton, Role::Neck, Role::Head, 3);
        body.add(skeleton, &LIMBS);
        body.checked()
    }

    /// The 19 joints whose places make a pose (patent, step S3): hips, two of the back, neck,
    /// head, and the limbs down to hands and toes.
    ///
    /// # Errors
    /// If too few of them are known.
    pub fn placed(clip: &Clip, skeleton: &Skeleton) -> Result<Body, SegmentError> {
        let mut body = Body { joints: Vec::new(), missing: Vec::new() };
        body.add(skeleton, &[Role::Hips]);
        body.add_chain(clip, skeleton, Role::Spine, Role::Chest, 2);
        body.add(skeleton, &[Role::Neck, Role::Head]);
        body.add(skeleton, &LIMBS);
        body.add(skeleton, &ENDS);
        body.checked()
    }

    /// What to tell of joints that are not there.
    pub fn notices(&self) -> Vec<Notice> {
        if self.missing.is_empty() {
            return Vec::new();
        }
        let text = format!(
            "These joints were not found and are left out of what is compared: {}.",
            self.missing.join(", ")
        );
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

    /// Adds at most `most` joints of the chain from one role up to another, the upper ones first in line.
    fn add_chain(&mut self, clip: &Clip, skeleton: &Skeleton, from: Role, to: Role, most: usize) {
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
        let mut chain: Vec<usize> = up.take_while(|&joint| joint != bottom).take(most).collect();
        if chain.len() < most {
            chain.push(bottom);
        }
        self.joints.extend(chain.into_iter().rev());
    }

    fn checked(self) -> Result<Body, SegmentError> {
        if self.joints.len() >= FEWEST {
            return Ok(self);
        }
        let found = self.joints.len();
        Err(SegmentError::TooFewJoints {
            found,
            wanted: found + self.missing.len(),
            missing: self.missing.join(", "),
        })
    }
}
