//! What is known of a clip, and what a person knows better.

use std::collections::BTreeMap;

use plantigrade::bvh::JointKind;
use plantigrade::skeleton::{self, Role};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use super::{Failure, NoticeText};

/// One joint of a clip.
#[derive(Debug, Serialize, Deserialize, Tsify)]
pub struct JointFacts {
    /// Its name as the file writes it.
    pub name: String,
    /// What it is in the hierarchy.
    #[tsify(type = "\"root\" | \"joint\" | \"end-site\"")]
    pub kind: String,
    /// Index of its parent.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parent: Option<usize>,
}

impl From<&plantigrade::bvh::Joint> for JointFacts {
    fn from(joint: &plantigrade::bvh::Joint) -> JointFacts {
        let kind = match joint.kind {
            JointKind::Root => "root",
            JointKind::Joint => "joint",
            JointKind::EndSite => "end-site",
        };
        JointFacts { name: joint.name.clone(), kind: kind.into(), parent: joint.parent }
    }
}

/// What is known of a clip.
#[derive(Debug, Serialize, Deserialize, Tsify)]
#[tsify(hashmap_as_object)]
#[serde(rename_all = "camelCase")]
pub struct ClipFacts {
    /// Number of frames; 0 where there is only a rest pose.
    pub frames: usize,
    /// Frames per second in force.
    pub rate: f64,
    /// All joints and end sites, parents first.
    pub joints: Vec<JointFacts>,
    /// The axis that points up.
    #[tsify(type = "\"x\" | \"-x\" | \"y\" | \"-y\" | \"z\" | \"-z\"")]
    pub up: String,
    /// Metres per file unit in force.
    pub metres_per_unit: f64,
    /// Name of the unit, if it is a known one.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// Thigh plus shank, in metres.
    #[tsify(optional)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leg: Option<f64>,
    /// Role to joint index; roles that nobody plays are absent.
    pub roles: BTreeMap<String, usize>,
    /// All roles there are, in order.
    pub role_names: Vec<String>,
    /// What the reader had to say.
    pub notices: Vec<NoticeText>,
}

/// What a person knows better; what is absent stays as found.
#[derive(Debug, Default, Serialize, Deserialize, Tsify)]
#[tsify(hashmap_as_object)]
#[serde(rename_all = "camelCase", default)]
pub struct Overrides {
    /// Frames per second.
    #[tsify(optional)]
    pub rate: Option<f64>,
    /// The axis that points up.
    #[tsify(optional, type = "\"x\" | \"-x\" | \"y\" | \"-y\" | \"z\" | \"-z\"")]
    pub up: Option<String>,
    /// Metres per file unit.
    #[tsify(optional)]
    pub metres_per_unit: Option<f64>,
    /// Role to joint index; −1 empties a role.
    #[tsify(optional)]
    pub roles: Option<BTreeMap<String, i32>>,
}

impl Overrides {
    /// The core's overrides, for a clip of so many joints.
    ///
    /// # Errors
    /// If a role, joint or axis does not exist or a number is not positive.
    pub fn check(&self, joints: usize) -> Result<skeleton::Overrides, Failure> {
        let positive = |what: &str, value: Option<f64>| match value {
            Some(value) if !(value > 0.0 && value.is_finite()) => {
                Err(Failure::from(format!("the {what} must be greater than 0, not {value}")))
            }
            value => Ok(value),
        };
        positive("rate", self.rate)?;
        let role = |(name, &joint): (&String, &i32)| {
            let role = Role::named(name).ok_or_else(|| format!("there is no role {name:?}"))?;
            match usize::try_from(joint) {
                Err(_) => Ok((role, None)),
                Ok(joint) if joint < joints => Ok((role, Some(joint))),
                Ok(joint) => Err(Failure::from(format!("there is no joint {joint}"))),
            }
        };
        Ok(skeleton::Overrides {
            roles: self.roles.iter().flatten().map(role).collect::<Result<_, Failure>>()?,
            up: self.up.as_deref().map(str::parse).transpose()?,
            metres_per_unit: positive("scale", self.metres_per_unit)?,
        })
    }
}
