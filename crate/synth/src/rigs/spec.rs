//! Description of a rig.

use plantigrade::skeleton::Up;

use super::names::NAMINGS;
use super::posture::Posture;
use crate::math::Random;

/// Kind of body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyKind {
    /// Trunk, two arms and two legs.
    Human,
    /// Human with unused hind limbs, wings or a tail.
    SpareLimbs,
    /// Trunk and arms without legs.
    UpperBody,
    /// Human without the right leg.
    OneLeg,
    /// Animal with four legs, named `fore` and `hind`.
    Quadruped,
}

/// Description of a skeleton.
#[derive(Clone, Debug, PartialEq)]
pub struct Rig {
    /// Kind of body.
    pub kind: BodyKind,
    /// Index into [`NAMINGS`], or `None` for names without a meaning.
    pub naming: Option<usize>,
    /// Text before each name.
    pub prefix: &'static str,
    /// Text after each name.
    pub suffix: &'static str,
    /// Number of bones of the thigh and of the shank.
    pub split: [usize; 2],
    /// True if joints at the side of the pelvis precede the thighs.
    pub has_pelvis_sides: bool,
    /// True if twist bones are attached to thighs and shanks.
    pub has_twist_leaves: bool,
    /// True if feet have toe joints.
    pub has_toes: bool,
    /// True if a joint lies between ankle and toe.
    pub has_midfoot: bool,
    /// True if feet have heel joints.
    pub has_heels: bool,
    /// True if feet have IK joints.
    pub has_ik: bool,
    /// True if the chains end with end sites.
    pub has_end_sites: bool,
    /// True if the body wears a skirt of several chains.
    pub has_skirt: bool,
    /// True if hands have fingers.
    pub has_fingers: bool,
    /// Postures, in order, each for the same time.
    pub postures: Vec<Posture>,
    /// Up axis of the file.
    pub up: Up,
    /// True if the rest pose has Y up whatever the axis of the motion is.
    pub rest_is_y_up: bool,
    /// Metres per file unit.
    pub metres_per_unit: f64,
    /// Height of the hip joints, in metres.
    pub leg: f64,
}

impl Rig {
    /// Draws a rig.
    pub fn random(seed: u64) -> Rig {
        let mut random = Random::new(seed, "rig");
        let mut chance = |probability: f64| random.uniform(0.0, 1.0) < probability;
        let kind = match () {
            () if chance(0.08) => BodyKind::UpperBody,
            () if chance(0.05) => BodyKind::OneLeg,
            () if chance(0.08) => BodyKind::Quadruped,
            () if chance(0.1) => BodyKind::SpareLimbs,
            () => BodyKind::Human,
        };
        let is_named = chance(0.95) || kind != BodyKind::Human;
        let splits = [chance(0.2), chance(0.2), chance(0.2)];
        let [pelvis, twist, toes, midfoot, heels, ik, ends, skirt, fingers] =
            [0.25, 0.25, 0.85, 0.15, 0.2, 0.15, 0.8, 0.1, 0.3].map(&mut chance);
        let rest_is_y_up = chance(0.3);
        let is_child = chance(0.1);
        let mut pick = |count: usize| (random.uniform(0.0, count as f64) as usize).min(count - 1);
        let naming = is_named.then(|| pick(NAMINGS.len()));
        let prefix = ["", "", "", "Hero_", "rig:", "Player1_", "Armature|", "chr-"][pick(8)];
        let suffix = ["", "", "", "", "_bind", "_jnt", "_01"][pick(7)];
        let mut postures = vec![Posture::ALL[pick(Posture::ALL.len())]];
        if pick(3) == 0 {
            postures.push(Posture::ALL[pick(Posture::ALL.len())]);
        }
        let up = [Up::Y, Up::Y, Up::Y, Up::ALL[1], Up::ALL[1]][pick(5)];
        let metres_per_unit = [0.01, 0.01, 0.01, 1.0, 1.0, 0.001, 0.0254][pick(7)];
        let is_quadruped = kind == BodyKind::Quadruped;
        // Animals stand or walk.
        if is_quadruped {
            postures = vec![[Posture::Walks, Posture::Stands][pick(2)]];
        }
        let leg = if is_child { random.uniform(0.55, 0.7) } else { random.uniform(0.78, 1.0) };
        Rig {
            kind,
            naming,
            prefix: if is_named { prefix } else { "" },
            suffix: if is_named { suffix } else { "" },
            split: [1 + usize::from(splits[0]), 1 + usize::from(splits[1] && splits[2])],
            has_pelvis_sides: pelvis,
            has_twist_leaves: twist && is_named,
            has_toes: toes && !is_quadruped,
            has_midfoot: midfoot && toes && is_named,
            has_heels: heels && is_named,
            has_ik: ik && is_named,
            has_end_sites: ends || !toes,
            has_skirt: skirt && is_named,
            has_fingers: fingers && is_named,
            rest_is_y_up: rest_is_y_up && postures.iter().all(|posture| posture.is_upright()),
            postures,
            up,
            metres_per_unit: if is_quadruped { 0.01 } else { metres_per_unit },
            leg: if is_quadruped { 0.5 } else { leg },
        }
    }
}
