//! Description of a clip, and overrides of it.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use plantigrade::bvh::{FRAME_RATES, JointKind};
use plantigrade::skeleton::{self, Role, UNITS};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use super::{ArgumentError, Failure, NoticeInfo, parse_name};

/// One joint of a clip.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct JointInfo {
    /// Name as written in the file.
    pub name: String,
    /// Position in the hierarchy.
    #[tsify(type = "\"root\" | \"joint\" | \"end-site\"")]
    pub kind: String,
    /// Index of the parent.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parent: Option<usize>,
}

impl From<&plantigrade::bvh::Joint> for JointInfo {
    fn from(joint: &plantigrade::bvh::Joint) -> JointInfo {
        let kind = match joint.kind {
            JointKind::Root => "root",
            JointKind::Joint => "joint",
            JointKind::EndSite => "end-site",
        };
        JointInfo { name: joint.name.clone(), kind: kind.into(), parent: joint.parent }
    }
}

/// Evidence for the joint of a role.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct RoleEvidence {
    /// Confidence, from 0 to 1.
    pub confidence: f64,
    /// True if the confidence is too low to rely on the joint.
    pub doubtful: bool,
    /// Kinds of evidence in a few words, as in "name" and "the other side".
    pub reasons: Vec<String>,
}

impl From<&skeleton::Assignment> for RoleEvidence {
    fn from(assignment: &skeleton::Assignment) -> RoleEvidence {
        RoleEvidence {
            confidence: assignment.confidence(),
            doubtful: assignment.is_doubtful(),
            reasons: assignment.reasons.iter().map(|reason| reason.description().into()).collect(),
        }
    }
}

/// Description of a clip.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[tsify(hashmap_as_object)]
#[serde(rename_all = "camelCase")]
pub struct ClipInfo {
    /// Number of frames; 0 if there is only a rest pose.
    pub frames: usize,
    /// Frame rate in use, in Hz.
    pub rate: f64,
    /// All joints and end sites, parents first.
    pub joints: Vec<JointInfo>,
    /// Up axis.
    #[tsify(type = "\"x\" | \"-x\" | \"y\" | \"-y\" | \"z\" | \"-z\"")]
    pub up: String,
    /// Metres per file unit in use.
    pub metres_per_unit: f64,
    /// Name of the unit, if known.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// Leg length (thigh plus shank), in metres.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leg: Option<f64>,
    /// Role to joint index; unassigned roles are absent.
    pub roles: BTreeMap<String, usize>,
    /// Role to the evidence for its joint; unassigned roles are absent.
    pub role_evidence: BTreeMap<String, RoleEvidence>,
    /// Names of all roles, in order.
    pub role_names: Vec<String>,
    /// Notices of the reader.
    pub notices: Vec<NoticeInfo>,
}

/// Overrides of what the reader detected; absent fields stay as detected.
#[derive(Debug, Default, Serialize, Deserialize, Tsify)]
#[tsify(hashmap_as_object)]
#[serde(rename_all = "camelCase", default)]
pub struct Overrides {
    /// Frame rate, from 1 to 1000 Hz.
    #[tsify(optional)]
    pub rate: Option<f64>,
    /// Up axis.
    #[tsify(optional, type = "\"x\" | \"-x\" | \"y\" | \"-y\" | \"z\" | \"-z\"")]
    pub up: Option<String>,
    /// Metres per file unit, from 10⁻⁶ to 10⁶.
    #[tsify(optional)]
    pub metres_per_unit: Option<f64>,
    /// Role to joint index; −1 clears a role.
    #[tsify(optional)]
    pub roles: Option<BTreeMap<String, i32>>,
}

impl Overrides {
    /// Converts to the core's overrides, for a clip with `joints` joints.
    ///
    /// # Errors
    /// If a role, joint or axis does not exist, or a number is beyond its limits.
    pub fn check(&self, joints: usize) -> Result<skeleton::Overrides, Failure> {
        let within = |name: &'static str, value: Option<f64>, range: RangeInclusive<f64>| match value {
            Some(value) if !range.contains(&value) => {
                let range = [*range.start(), *range.end()];
                Err(Failure::from(ArgumentError::OutOfRange { name, value, range }))
            }
            value => Ok(value),
        };
        within("rate", self.rate, FRAME_RATES)?;
        let role = |(name, &joint): (&String, &i32)| {
            let role = Role::from_name(name).ok_or_else(|| ArgumentError::Role(name.clone()))?;
            match usize::try_from(joint) {
                Err(_) => Ok((role, None)),
                Ok(joint) if joint < joints => Ok((role, Some(joint))),
                Ok(joint) => Err(Failure::from(ArgumentError::Joint(joint))),
            }
        };
        Ok(skeleton::Overrides {
            roles: self.roles.iter().flatten().map(role).collect::<Result<_, Failure>>()?,
            up: self.up.as_deref().map(parse_name).transpose()?,
            metres_per_unit: within("scale", self.metres_per_unit, UNITS)?,
        })
    }
}
