//! The skeleton of a clip: roles of joints, the up axis and the scale.

mod body;
mod find;
mod names;
mod roles;
mod unit;
mod up;

pub use names::{joint_names_document, known_name_count};
pub use roles::{Assignment, LegRoles, Reason, Role, Roles};
pub use unit::{LIMITS as UNITS, unit_name};
pub use up::{Up, UpError};

use std::ops::Range;

use crate::bvh::{Clip, JointKind};
use crate::foot::Side;
use crate::kinematics;
use crate::notice::{self, Code, Notice, shortened};
use body::Body;
use find::RoleSearch;

/// Values that override those detected from the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Joints of roles; `None` clears a role. A joint is a role of the skeleton that owns it.
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

impl Skeleton {
    /// Returns the skeletons of a clip, one per root.
    pub fn all(clip: &Clip, overrides: &Overrides) -> Vec<Skeleton> {
        clip.roots().map(|root| Skeleton::from_root(clip, root, overrides)).collect()
    }

    /// Returns the skeleton that owns a joint of the overrides, the first one with feet, or the first one.
    ///
    /// # Panics
    /// If the clip has no joints, which the reader never returns.
    pub fn main(clip: &Clip, overrides: &Overrides) -> Skeleton {
        let mut all = Skeleton::all(clip, overrides);
        let owner = overrides.roles.iter().find_map(|&(_, joint)| Some(root_of(clip, joint?)));
        let is_main =
            |skeleton: &Skeleton| owner.map_or(skeleton.roles.has_feet(), |owner| skeleton.root == owner);
        let index = all.iter().position(is_main).unwrap_or(0);
        let mut main = all.swap_remove(index);
        if !all.is_empty() {
            let text = format!("The feet of {} are measured.", shortened(&clip.joints()[main.root].name));
            main.notices.push(Notice::new(Code::SeveralRoots, text));
        }
        main
    }

    /// Returns the skeleton below `root`.
    pub fn from_root(clip: &Clip, root: usize, overrides: &Overrides) -> Skeleton {
        let RoleSearch { mut roles, is_quadruped } = find::assign_roles(clip, root);
        for &(role, joint) in &overrides.roles {
            if joint.is_none_or(|joint| root_of(clip, joint) == root) {
                roles.set(role, joint);
            }
        }
        let mut notices = role_notices(clip, root, &roles);
        if is_quadruped {
            let text = "The skeleton has four legs; only the hind feet are measured.";
            notices.push(Notice::new(Code::Quadruped, text));
        }
        let body = Body::measure(clip, root, &roles);
        let leg = body.leg();
        let found_up = body.up(leg);
        if overrides.up.is_none() && !found_up.is_some_and(|found| found.is_certain) {
            let up = found_up.map_or(Up::Y, |found| found.up).to_string().to_ascii_uppercase();
            let text = format!("The up axis is uncertain; {up} is used. Set the up axis if this is wrong.");
            notices.push(Notice::new(Code::UpAxis, text));
        }
        let up = overrides.up.or(found_up.map(|found| found.up)).unwrap_or(Up::Y);
        let unit = body.unit(leg, up, is_quadruped);
        if overrides.metres_per_unit.is_none() && !unit.is_certain {
            let length = leg.unwrap_or_default() * unit.metres_per_unit;
            let name = unit_name(unit.metres_per_unit)
                .map_or_else(|| format!("{:.4} m", unit.metres_per_unit), |name| format!("1 {name}"));
            let text = format!(
                "The unit is uncertain; {name} is used, so that the legs are {length:.2} m long. Set the unit if \
                 this is wrong."
            );
            notices.push(Notice::new(Code::Unit, text));
        }
        let metres_per_unit = overrides.metres_per_unit.unwrap_or(unit.metres_per_unit);
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

/// Returns the root of the skeleton that owns `joint`.
fn root_of(clip: &Clip, joint: usize) -> usize {
    clip.roots().take_while(|&root| root <= joint).last().unwrap_or(joint)
}

/// Returns notices on the roles of the legs.
fn role_notices(clip: &Clip, root: usize, roles: &Roles) -> Vec<Notice> {
    let mut notices = Vec::new();
    let legs = Side::BOTH.map(LegRoles::for_side);
    if !roles.has_feet() {
        let names: Vec<&str> = clip.joints()[clip.skeleton_joints(root)]
            .iter()
            .filter(|joint| joint.kind != JointKind::EndSite)
            .map(|joint| joint.name.as_str())
            .collect();
        let text = format!(
            "No feet were detected. If the skeleton has feet, choose both ankle joints. The joints are {}.",
            notice::list(&names)
        );
        notices.push(Notice::new(Code::NoFeet, text));
        return notices;
    }
    if legs.iter().any(|leg| roles.get(leg.toe).is_none()) {
        let text = "The skeleton has no toe joints; the tip of the foot, or the ankle, is used instead.";
        notices.push(Notice::new(Code::NoToe, text));
    }
    let ankles = legs.map(|leg| roles.assignment(leg.ankle));
    for (part, [left, right]) in [("ankles", legs.map(|leg| leg.ankle)), ("toes", legs.map(|leg| leg.toe))] {
        if let Some(joint) = roles.get(left)
            && roles.get(right) == Some(joint)
        {
            let name = shortened(&clip.joints()[joint].name);
            let text = format!("Both {part} are {name}. Set another joint for one foot.");
            notices.push(Notice::new(Code::DoubtfulRole, text));
        }
    }
    if let [Some(left), Some(right)] = ankles
        && (left.is_doubtful() || right.is_doubtful())
    {
        let name = |ankle: &Assignment| shortened(&clip.joints()[ankle.joint].name);
        let text = format!(
            "Joint names do not identify the feet. By the structure of the skeleton, the left ankle is {} and \
             the right ankle is {}. Set the ankle joints if this is wrong.",
            name(left),
            name(right)
        );
        notices.push(Notice::new(Code::DoubtfulRole, text));
    }
    notices
}
