//! The skeleton of a clip: roles of joints, the up axis and the scale.

mod find;
mod names;
mod roles;
mod world;

pub use roles::{LegRoles, Role, Roles};
pub use world::{Up, unit_name};

use std::ops::Range;

use nalgebra::Vector3;

use crate::bvh::Clip;
use crate::foot::Side;
use crate::kinematics;
use crate::kinematics::Track;
use crate::notice::{Code, Notice};

/// What a person knows better than the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Joints for roles; `None` empties a role.
    pub roles: Vec<(Role, Option<usize>)>,
    /// The axis that points up.
    pub up: Option<Up>,
    /// Metres per file unit.
    pub metres_per_unit: Option<f64>,
}

/// One skeleton of a clip with all that has to be known to measure its feet.
#[derive(Clone, Debug, PartialEq)]
pub struct Skeleton {
    /// Index of its root joint.
    pub root: usize,
    /// Which joint plays which role.
    pub roles: Roles,
    /// The axis that points up.
    pub up: Up,
    /// Thigh plus shank in file units, the longer of both sides; `None` without legs.
    pub leg: Option<f64>,
    /// Metres per file unit, for display only: labels do not depend on it.
    pub metres_per_unit: f64,
    /// What could not be told, or was assumed.
    pub notices: Vec<Notice>,
}

/// The number of poses that axis and scale are measured on.
const POSES: usize = 512;

impl Skeleton {
    /// The skeletons of a clip, one for each root.
    pub fn all(clip: &Clip, overrides: &Overrides) -> Vec<Skeleton> {
        clip.roots().map(|root| Skeleton::of_root(clip, root, overrides)).collect()
    }

    /// The first skeleton that has feet, or the first of all.
    ///
    /// # Panics
    /// If the clip has no joints; the reader gives none such.
    pub fn main(clip: &Clip, overrides: &Overrides) -> Skeleton {
        let mut all = Skeleton::all(clip, overrides);
        let index = all.iter().position(|skeleton| skeleton.roles.has_feet()).unwrap_or(0);
        let mut main = all.swap_remove(index);
        if !all.is_empty() {
            let text = format!("The feet of {} are the ones measured.", clip.joints()[main.root].name);
            main.notices.push(Notice::new(Code::SeveralRoots, text));
        }
        main
    }

    /// The skeleton that hangs from `root`.
    pub fn of_root(clip: &Clip, root: usize, overrides: &Overrides) -> Skeleton {
        let mut roles = find::roles(clip, root);
        for &(role, joint) in &overrides.roles {
            roles.set(role, joint);
        }
        let body = Body::measure(clip, root, &roles);
        let mut notices = Vec::new();
        if !roles.has_feet() {
            let text = "No pair of feet was found in the skeleton. If it has feet, name their joints.";
            notices.push(Notice::new(Code::NoFeet, text));
        } else if Side::BOTH.iter().any(|&side| roles.get(LegRoles::of(side).toe).is_none()) {
            let text = "The skeleton has no toe joints: the tip of the foot, or else the ankle, stands in.";
            notices.push(Notice::new(Code::NoToe, text));
        }
        let upright = overrides.up.or_else(|| body.up());
        if upright.is_none() {
            let text = "The up axis could not be told from the pose: Y is taken.";
            notices.push(Notice::new(Code::UpAxis, text));
        }
        let up = upright.unwrap_or(Up::Y);
        let leg = body.leg();
        let metres_per_unit = overrides.metres_per_unit.unwrap_or_else(|| body.metres_per_unit(leg, up));
        Skeleton { root, roles, up, leg, metres_per_unit, notices }
    }

    /// The joint that stands for the toe of one foot: toe base, tip or ankle.
    pub fn toe(&self, side: Side) -> Option<usize> {
        let leg = LegRoles::of(side);
        [leg.toe, leg.tip, leg.ankle].into_iter().find_map(|role| self.roles.get(role))
    }

    /// The joint that stands for the heel of one foot: the ankle.
    pub fn heel(&self, side: Side) -> Option<usize> {
        self.roles.get(LegRoles::of(side).ankle)
    }

    /// All poses for display: frames × joints × 3 in metres, Y up, right-handed.
    ///
    /// A clip without motion gives its rest pose.
    pub fn positions(&self, clip: &Clip) -> Vec<f32> {
        self.positions_in(clip, 0..kinematics::pose_count(clip))
    }

    /// As [`Skeleton::positions`], of some of the poses.
    ///
    /// # Panics
    /// If there are no such poses.
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

/// The joints that axis and scale are measured by, over a spread of poses.
struct Body {
    hips: Track,
    head: Option<Track>,
    /// Thigh, shank, ankle, toe and tip of each side.
    legs: [[Option<Track>; 5]; 2],
    /// Greatest distance between two joints of the first pose, in file units.
    extent: f64,
}

impl Body {
    fn measure(clip: &Clip, root: usize, roles: &Roles) -> Body {
        let leg = |side| {
            let leg = LegRoles::of(side);
            [leg.thigh, leg.shank, leg.ankle, leg.toe, leg.tip].map(|role| roles.get(role))
        };
        let track = |joint: usize| {
            kinematics::tracks_at(clip, &[joint], kinematics::sample_frames(clip, POSES)).remove(0)
        };
        let pose = kinematics::Kinematics::new(clip).pose(0).to_vec();
        let distances = pose.iter().flat_map(|a| pose.iter().map(move |b| (a - b).norm()));
        Body {
            hips: track(roles.get(Role::Hips).unwrap_or(root)),
            head: roles.get(Role::Head).map(track),
            legs: Side::BOTH.map(|side| leg(side).map(|joint| joint.map(track))),
            extent: distances.fold(0.0, f64::max),
        }
    }

    /// The axis from the feet to the hips, or from the hips to the head.
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
        let middle = Vector3::from_fn(|axis, _| median(rises.iter().map(|rise| rise[axis])));
        (middle.norm() > 0.0).then(|| Up::nearest(middle))
    }

    /// Thigh plus shank, the longer side; positions rather than offsets, which some files leave empty.
    fn leg(&self) -> Option<f64> {
        let length = |[thigh, shank, ankle, ..]: &[Option<Track>; 5]| {
            let ankle = ankle.as_ref()?;
            let bone = |a: &Track, b: &Track| median(a.iter().zip(b).map(|(a, b)| (a - b).norm()));
            match (thigh, shank) {
                (Some(thigh), Some(shank)) => Some(bone(thigh, shank) + bone(shank, ankle)),
                (None, Some(upper)) | (Some(upper), None) => Some(bone(upper, ankle)),
                (None, None) => Some(bone(&self.hips, ankle)),
            }
        };
        let longest = self.legs.iter().filter_map(length).fold(0.0, f64::max);
        (longest > 0.0).then_some(longest)
    }

    /// From the leg's length with the ankle's height above the sole, or from the body's extent.
    fn metres_per_unit(&self, leg: Option<f64>, up: Up) -> f64 {
        match leg {
            Some(leg) => world::metres_per_unit(leg + self.ankle_height(up)),
            // A figure without legs that can be measured is taken for one of 1.7 m.
            None if self.extent > 0.0 => 1.7 / self.extent,
            None => 1.0,
        }
    }

    /// Height of the ankles over the lowest that any part of the feet comes, leaving out outliers.
    fn ankle_height(&self, up: Up) -> f64 {
        let low = |tracks: &mut dyn Iterator<Item = &Track>| {
            let mut heights: Vec<f64> =
                tracks.flat_map(|track| track.iter().map(|position| up.height(position))).collect();
            heights.sort_unstable_by(f64::total_cmp);
            heights.get(heights.len() / 20).copied()
        };
        let ankles = low(&mut self.legs.iter().filter_map(|leg| leg[2].as_ref()));
        let soles = low(&mut self.legs.iter().flat_map(|leg| leg[2..].iter().flatten()));
        ankles.zip(soles).map_or(0.0, |(ankle, sole)| (ankle - sole).max(0.0))
    }
}

/// The middle value; the lower of two middle ones.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    let middle = values.len().saturating_sub(1) / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}
