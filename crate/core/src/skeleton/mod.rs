//! The skeleton of a clip: roles of joints, the up axis and the scale.

mod find;
mod names;
mod roles;
mod world;

pub use roles::{LegRoles, Role, Roles};
pub use world::{Up, UpError, unit_name};

use std::ops::Range;

use nalgebra::Vector3;

use crate::bvh::Clip;
use crate::foot::Side;
use crate::kinematics::{self, Track};
use crate::notice::{Code, Notice};
use crate::numeric::stats::median_low;

/// Values that override those detected from the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Joints of roles; `None` clears a role.
    pub roles: Vec<(Role, Option<usize>)>,
    /// Up axis.
    pub up: Option<Up>,
    /// Metres per file unit.
    pub metres_per_unit: Option<f64>,
}

/// One skeleton of a clip with the properties needed to measure its feet.
#[derive(Clone, Debug, PartialEq)]
pub struct Skeleton {
    /// Index of the root joint.
    pub root: usize,
    /// Joints of the roles.
    pub roles: Roles,
    /// Up axis.
    pub up: Up,
    /// Leg length (thigh plus shank) of the longer leg, in file units; `None` without legs.
    pub leg: Option<f64>,
    /// Metres per file unit, for display and thresholds in metres; spectral labels do not depend on
    /// it.
    pub metres_per_unit: f64,
    /// Assumptions and omissions.
    pub notices: Vec<Notice>,
}

/// Number of poses on which axis and scale are measured.
const SAMPLED_POSES: usize = 512;

impl Skeleton {
    /// Returns the skeletons of a clip, one per root.
    pub fn all(clip: &Clip, overrides: &Overrides) -> Vec<Skeleton> {
        clip.roots().map(|root| Skeleton::from_root(clip, root, overrides)).collect()
    }

    /// Returns the first skeleton with feet, or the first one.
    ///
    /// # Panics
    /// If the clip has no joints, which the reader never returns.
    pub fn main(clip: &Clip, overrides: &Overrides) -> Skeleton {
        let mut all = Skeleton::all(clip, overrides);
        let index = all.iter().position(|skeleton| skeleton.roles.has_feet()).unwrap_or(0);
        let mut main = all.swap_remove(index);
        if !all.is_empty() {
            let text = format!("The feet of {} are measured.", clip.joints()[main.root].name);
            main.notices.push(Notice::new(Code::SeveralRoots, text));
        }
        main
    }

    /// Returns the skeleton below `root`.
    pub fn from_root(clip: &Clip, root: usize, overrides: &Overrides) -> Skeleton {
        let mut roles = find::assign_roles(clip, root);
        for &(role, joint) in &overrides.roles {
            roles.set(role, joint);
        }
        let body = BodyTracks::measure(clip, root, &roles);
        let mut notices = Vec::new();
        if !roles.has_feet() {
            let text = "No pair of feet was found in the skeleton. If it has feet, name their joints.";
            notices.push(Notice::new(Code::NoFeet, text));
        } else if Side::BOTH.iter().any(|&side| roles.get(LegRoles::for_side(side).toe).is_none()) {
            let text = "The skeleton has no toe joints; the tip of the foot, or the ankle, is used instead.";
            notices.push(Notice::new(Code::NoToe, text));
        }
        let up_axis = overrides.up.or_else(|| body.up());
        if up_axis.is_none() {
            let text = "The up axis could not be determined from the pose; Y is used.";
            notices.push(Notice::new(Code::UpAxis, text));
        }
        let up = up_axis.unwrap_or(Up::Y);
        let leg = body.leg();
        let metres_per_unit = overrides.metres_per_unit.unwrap_or_else(|| body.metres_per_unit(leg, up));
        Skeleton { root, roles, up, leg, metres_per_unit, notices }
    }

    /// Returns the joint that represents the toe of one foot: toe base, tip or ankle.
    pub fn toe(&self, side: Side) -> Option<usize> {
        let leg = LegRoles::for_side(side);
        [leg.toe, leg.tip, leg.ankle].into_iter().find_map(|role| self.roles.get(role))
    }

    /// Returns the joint that represents the heel of one foot: the ankle.
    pub fn heel(&self, side: Side) -> Option<usize> {
        self.roles.get(LegRoles::for_side(side).ankle)
    }

    /// Returns all poses for display: frames × joints × 3 in metres, Y up, right-handed.
    ///
    /// A clip without motion returns its rest pose.
    pub fn positions(&self, clip: &Clip) -> Vec<f32> {
        self.positions_in(clip, 0..kinematics::pose_count(clip))
    }

    /// Returns the positions of a range of poses; see [`Skeleton::positions`].
    ///
    /// # Panics
    /// If the range exceeds the poses of the clip.
    pub fn positions_in(&self, clip: &Clip, poses: Range<usize>) -> Vec<f32> {
        let mut kinematics = kinematics::Kinematics::new(clip);
        let mut positions = Vec::with_capacity(poses.len() * clip.joints().len() * 3);
        for frame in poses {
            for position in kinematics.pose(frame) {
                let [x, y, z] = (self.up.to_y_up(*position) * self.metres_per_unit).into();
                positions.extend([x as f32, y as f32, z as f32]);
            }
        }
        positions
    }
}

/// Tracks of the joints that determine axis and scale, at sampled poses.
struct BodyTracks {
    hips: Track,
    head: Option<Track>,
    /// Tracks of thigh, shank, ankle, toe and tip of each side.
    legs: [[Option<Track>; 5]; 2],
    /// Maximum distance between two joints of the first pose, in file units.
    extent: f64,
}

impl BodyTracks {
    fn measure(clip: &Clip, root: usize, roles: &Roles) -> BodyTracks {
        let leg = |side| {
            let leg = LegRoles::for_side(side);
            [leg.thigh, leg.shank, leg.ankle, leg.toe, leg.tip].map(|role| roles.get(role))
        };
        let track = |joint: usize| {
            kinematics::tracks_at(clip, &[joint], kinematics::sample_frames(clip, SAMPLED_POSES)).remove(0)
        };
        let pose = kinematics::Kinematics::new(clip).pose(0).to_vec();
        let distances = pose.iter().flat_map(|a| pose.iter().map(move |b| (a - b).norm()));
        BodyTracks {
            hips: track(roles.get(Role::Hips).unwrap_or(root)),
            head: roles.get(Role::Head).map(track),
            legs: Side::BOTH.map(|side| leg(side).map(|joint| joint.map(track))),
            extent: distances.fold(0.0, f64::max),
        }
    }

    /// Returns the axis from the feet to the hips, or from the hips to the head.
    fn up(&self) -> Option<Up> {
        let feet: Vec<&Track> = self.legs.iter().filter_map(|leg| leg[2].as_ref()).collect();
        let rise = |frame: usize| match (&feet[..], &self.head) {
            ([], None) => None,
            ([], Some(head)) => Some(head[frame] - self.hips[frame]),
            (feet, _) => {
                let sum: Vector3<f64> = feet.iter().map(|foot| foot[frame]).sum();
                Some(self.hips[frame] - sum / feet.len() as f64)
            }
        };
        let rises: Vec<Vector3<f64>> = (0..self.hips.len()).map_while(rise).collect();
        if rises.is_empty() {
            return None;
        }
        let median_rise =
            Vector3::from_fn(|axis, _| median_low(rises.iter().map(|rise| rise[axis])).unwrap_or_default());
        (median_rise.norm() > 0.0).then(|| Up::nearest(median_rise))
    }

    /// Returns the leg length of the longer leg, from positions, as some files have no offsets.
    fn leg(&self) -> Option<f64> {
        let length = |[thigh, shank, ankle, ..]: &[Option<Track>; 5]| {
            let ankle = ankle.as_ref()?;
            let bone = |a: &Track, b: &Track| {
                median_low(a.iter().zip(b).map(|(a, b)| (a - b).norm())).unwrap_or_default()
            };
            match (thigh, shank) {
                (Some(thigh), Some(shank)) => Some(bone(thigh, shank) + bone(shank, ankle)),
                (None, Some(upper)) | (Some(upper), None) => Some(bone(upper, ankle)),
                (None, None) => Some(bone(&self.hips, ankle)),
            }
        };
        let longest = self.legs.iter().filter_map(length).fold(0.0, f64::max);
        (longest > 0.0).then_some(longest)
    }

    /// Returns the scale from the height of the hip joint above the sole, or from the extent of the
    /// body.
    fn metres_per_unit(&self, leg: Option<f64>, up: Up) -> f64 {
        match leg {
            Some(leg) => world::metres_per_unit(leg + self.ankle_height(up)),
            // A character without measurable legs is assumed to be 1.7 m tall.
            None if self.extent > 0.0 => 1.7 / self.extent,
            None => 1.0,
        }
    }

    /// Returns the height of the ankles above the lowest part of the feet, without outliers.
    fn ankle_height(&self, up: Up) -> f64 {
        let fifth_percentile = |tracks: &mut dyn Iterator<Item = &Track>| {
            let mut heights: Vec<f64> =
                tracks.flat_map(|track| track.iter().map(|position| up.height(position))).collect();
            heights.sort_unstable_by(f64::total_cmp);
            heights.get(heights.len() / 20).copied()
        };
        let ankles = fifth_percentile(&mut self.legs.iter().filter_map(|leg| leg[2].as_ref()));
        let soles = fifth_percentile(&mut self.legs.iter().flat_map(|leg| leg[2..].iter().flatten()));
        ankles.zip(soles).map_or(0.0, |(ankle, sole)| (ankle - sole).max(0.0))
    }
}
