//! The truth about each frame, read off the plan.

use plantigrade::foot::{Part, Side};
use plantigrade::formats::{Document, FORMAT, Foot, FootJoints, Joints, MethodUsed};
use plantigrade::formats::{Source, SpanSource, VERSION};

use crate::character::{Bone, Character};
use crate::feet::FootPath;

/// Pitch below which a foot counts as flat, in degrees.
const FLAT: f64 = 0.5;

/// What stands at `time`: contact, toe, heel.
///
/// *Contact* runs from foot strike to toe-off. The *toe* is down and still once the
/// foot has rolled off its heel, the *heel* until it rises. A foot that is dragged or
/// slides touches the ground but is none of the three: it neither stands nor is still.
pub fn parts(path: &FootPath, time: f64) -> [bool; 3] {
    let Some(stance) = path.standing(time) else { return [false; 3] };
    let pitch = path.standing_pitch(stance, time);
    [true, pitch > -FLAT, pitch < FLAT]
}

/// The document of a clip called `name`, from the parts of each foot in each frame;
/// `floor` is the height of its ground, where it has one.
pub fn document(
    name: &str,
    character: &Character,
    rate: f64,
    floor: Option<f64>,
    labels: &[Vec<[bool; 3]>; 2],
) -> Document {
    let joints = |side| FootJoints {
        heel: character.naming.name(Bone::Foot(side)),
        toe: character.naming.name(Bone::Toe(side)),
    };
    let foot = |side: Side| {
        let mut foot = Foot::default();
        for (n, part) in [Part::Contact, Part::Toe, Part::Heel].into_iter().enumerate() {
            let labels: Vec<bool> = labels[side as usize].iter().map(|parts| parts[n]).collect();
            foot.set(part, &labels, rate, |_| SpanSource::Truth);
        }
        foot
    };
    Document {
        format: FORMAT.into(),
        version: VERSION,
        source: Source { name: format!("{name}.bvh"), sha256: None },
        root: None,
        notices: Vec::new(),
        frames: labels[0].len(),
        rate,
        joints: Some(Joints { left: joints(Side::Left), right: joints(Side::Right) }),
        floor,
        method: MethodUsed { name: "truth".into(), ..MethodUsed::default() },
        left: foot(Side::Left),
        right: foot(Side::Right),
    }
}
