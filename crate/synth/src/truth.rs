//! Ground truth of each frame, derived from the plan.

use plantigrade::foot::{Part, Side};
use plantigrade::formats::{
    FootJoints, FootPlants, Header, Joints, MethodUsed, Origin, Plant, PlantsDocument, Source, VERSION,
};

use crate::character::{Bone, Character};
use crate::foot_path::FootPath;

/// Maximum pitch of a flat foot, in degrees.
const MAX_FLAT_PITCH: f64 = 0.5;

/// Returns whether contact, toe contact and heel contact hold at `time`.
///
/// *Contact* lasts from foot strike to toe-off. Foot strike is the instant at which the sole first
/// reaches the ground: the curve of the heel, or the tip of the toes under a ball that is still
/// raised. The foot still moves then; the ground stops it within the time of
/// [`EndMotion`](crate::plan::EndMotion), while the heel pad yields by a few millimetres. Toe-off is
/// the instant at which the tip of the toes leaves the ground; the ball rises before it.
///
/// *Toe contact* and *heel contact* are plants: that part is on the ground and still. Both begin
/// after the impact, toe contact when the foot has rolled off the heel; toe contact ends when the
/// ball rises, heel contact when the heel rises. A foot that is dragged or slides touches the ground
/// but is not planted: all three are false.
pub fn contact_at(path: &FootPath, time: f64) -> [bool; 3] {
    let Some(stance) = path.stance_at(time) else { return [false; 3] };
    let pitch = path.stance_pitch(stance, time);
    let at_rest = path.is_at_rest(time);
    [true, at_rest && pitch > -MAX_FLAT_PITCH, at_rest && pitch < MAX_FLAT_PITCH]
}

/// Returns the plants document of the clip `name`. `labels` holds contact, toe and heel contact per
/// foot and frame; `floor` is the height of the ground in metres, if it is constant.
pub fn document(
    name: &str,
    character: &Character,
    rate: f64,
    floor: Option<f64>,
    labels: &[Vec<[bool; 3]>; 2],
) -> PlantsDocument {
    let joints = |side| FootJoints {
        heel: character.naming.name(Bone::Foot(side)),
        toe: character.naming.name(Bone::Toe(side)),
    };
    let foot = |side: Side| {
        let mut foot = FootPlants::default();
        for (n, part) in [Part::Contact, Part::Toe, Part::Heel].into_iter().enumerate() {
            let labels: Vec<bool> = labels[side as usize].iter().map(|parts| parts[n]).collect();
            foot.set(part, &labels, |run| Plant::new(run, rate, Origin::Truth));
        }
        foot
    };
    PlantsDocument {
        header: Header {
            format: PlantsDocument::FORMAT.into(),
            version: VERSION,
            source: Source { name: format!("{name}.bvh"), sha256: None, name_encoding: None },
            root: None,
            frames: labels[0].len(),
            rate,
        },
        edits: Vec::new(),
        notices: Vec::new(),
        joints: Some(Joints { left: joints(Side::Left), right: joints(Side::Right) }),
        floor,
        ground: None,
        noise: None,
        method: MethodUsed { name: MethodUsed::TRUTH.into(), ..MethodUsed::default() },
        left: foot(Side::Left),
        right: foot(Side::Right),
    }
}
