//! Joint names of rigs in many conventions.

use plantigrade::foot::Side;

use super::bone::Bone;

/// Naming convention: names of bones, and how a side is written.
#[derive(Clone, Copy, Debug)]
pub struct Naming {
    /// Words for [left, right].
    sides: [&'static str; 2],
    /// Position of the side.
    placement: Placement,
    /// Hips, spine, neck, head, collar bone, upper arm, forearm, hand, finger.
    upper: [&'static str; 9],
    /// Side of the pelvis, thigh, shank, ankle, midfoot, toe, heel.
    lower: [&'static str; 7],
}

/// Position of the side in a name.
#[derive(Clone, Copy, Debug)]
enum Placement {
    /// Before the bone, joined with the text.
    Before(&'static str),
    /// After the bone, joined with the text.
    After(&'static str),
}

use Placement::{After, Before};

const MOTION_BUILDER: [&str; 9] =
    ["Hips", "Spine", "Neck", "Head", "Shoulder", "Arm", "ForeArm", "Hand", "HandIndex"];
const LOWER_CASE: [&str; 9] =
    ["pelvis", "spine", "neck", "head", "clavicle", "upperarm", "lowerarm", "hand", "index"];

/// All naming conventions.
pub const NAMINGS: &[Naming] = &[
    Naming {
        sides: ["Left", "Right"],
        placement: Before(""),
        upper: MOTION_BUILDER,
        lower: ["HipJoint", "UpLeg", "Leg", "Foot", "FootMid", "ToeBase", "Heel"],
    },
    Naming {
        sides: ["Left", "Right"],
        placement: Before(""),
        upper: ["Hips", "Chest", "Neck", "Head", "Collar", "Shoulder", "Elbow", "Wrist", "Finger"],
        lower: ["HipDummy", "Hip", "Knee", "Ankle", "Foot", "Toe", "Heel"],
    },
    Naming {
        sides: ["l", "r"],
        placement: After("_"),
        upper: LOWER_CASE,
        lower: ["hip_joint", "thigh", "calf", "foot", "metatarsal", "ball", "heel"],
    },
    Naming {
        sides: ["L", "R"],
        placement: After("."),
        upper: ["hips", "spine", "neck", "head", "shoulder", "upper_arm", "forearm", "hand", "f_index"],
        lower: ["buttock", "thigh", "shin", "foot", "midfoot", "toe", "heel.02"],
    },
    Naming {
        sides: ["l", "r"],
        placement: Before(""),
        upper: ["hip", "abdomen", "neck", "head", "Collar", "Shldr", "ForeArm", "Hand", "Index1"],
        lower: ["Buttock", "Thigh", "Shin", "Foot", "Metatarsals", "Toe", "Heel"],
    },
    Naming {
        sides: ["Left", "Right"],
        placement: After(""),
        upper: ["Pelvis", "Torso", "Neck", "Head", "Collar", "Shoulder", "Elbow", "Wrist", "HandIndex"],
        lower: ["HipJoint", "Hip", "Knee", "Ankle", "FootMid", "Toe", "Heel"],
    },
    Naming {
        sides: ["L", "R"],
        placement: Before(" "),
        upper: ["Pelvis", "Spine", "Neck", "Head", "Clavicle", "UpperArm", "Forearm", "Hand", "Finger0"],
        lower: ["Buttock", "Thigh", "Calf", "Foot", "Metatarsal", "Toe0", "Heel"],
    },
    Naming {
        sides: ["left", "right"],
        placement: Before("_"),
        upper: ["mid_hip", "spine", "neck", "head", "collar", "shoulder", "elbow", "wrist", "index"],
        lower: ["hip_joint", "hip", "knee", "ankle", "midfoot", "foot_index", "heel"],
    },
    Naming {
        sides: ["l", "r"],
        placement: Before("_"),
        upper: ["root", "torso", "neck", "head", "shoulder", "up_arm", "low_arm", "hand", "finger"],
        lower: ["hip_joint", "up_leg", "low_leg", "ankle", "foot", "toes", "heel"],
    },
    Naming {
        sides: ["LEFT", "RIGHT"],
        placement: After("_"),
        upper: ["PELVIS", "SPINE_CHEST", "NECK", "HEAD", "CLAVICLE", "SHOULDER", "ELBOW", "WRIST", "THUMB"],
        lower: ["BUTTOCK", "HIP", "KNEE", "ANKLE", "MIDFOOT", "TOE", "HEEL"],
    },
    Naming {
        sides: ["Links", "Rechts"],
        placement: Before("_"),
        upper: ["Becken", "Brust", "Hals", "Kopf", "Schulter", "Oberarm", "Unterarm", "Hand", "Daumen"],
        lower: ["Huefte", "Oberschenkel", "Unterschenkel", "Fuss", "Mittelfuss", "Zehen", "Ferse"],
    },
    Naming {
        sides: ["Gauche", "Droite"],
        placement: After("_"),
        upper: ["Bassin", "Dos", "Cou", "Tete", "Clavicule", "Bras", "AvantBras", "Main", "Pouce"],
        lower: ["Hanche", "Cuisse", "Jambe", "Cheville", "Pied", "Orteils", "Talon"],
    },
    Naming {
        sides: ["izq", "der"],
        placement: After("_"),
        upper: ["caderas", "columna", "cuello", "cabeza", "hombro", "brazo", "antebrazo", "mano", "pulgar"],
        lower: ["cadera", "muslo", "pierna", "tobillo", "pie", "puntera", "talon"],
    },
    Naming {
        sides: ["Sx", "Dx"],
        placement: After("_"),
        upper: ["Bacino", "Schiena", "Collo", "Testa", "Spalla", "Braccio", "Avambraccio", "Mano", "Pollice"],
        lower: ["Anca", "Coscia", "Gamba", "Caviglia", "Piede", "Alluce", "Tallone"],
    },
    Naming {
        sides: ["Esq", "Dir"],
        placement: After("_"),
        upper: ["Quadris", "Coluna", "Pescoco", "Cabeca", "Ombro", "Braco", "Antebraco", "Mao", "Polegar"],
        lower: ["Quadril", "Coxa", "Perna", "Tornozelo", "Pe", "PontaDoPe", "Calcanhar"],
    },
    Naming {
        sides: ["Links", "Rechts"],
        placement: After("_"),
        upper: ["Bekken", "Rug", "Nek", "Hoofd", "Schouder", "Bovenarm", "Onderarm", "Hand", "Duim"],
        lower: ["Heup", "Bovenbeen", "Onderbeen", "Enkel", "Voet", "Tenen", "Hiel"],
    },
    Naming {
        sides: ["Левая", "Правая"],
        placement: Before("_"),
        upper: ["Таз", "Спина", "Шея", "Голова", "Ключица", "Плечо", "Предплечье", "Кисть", "Палец"],
        lower: ["Таз", "Бедро", "Голень", "Лодыжка", "Стопа", "Носок", "Пятка"],
    },
    Naming {
        sides: ["左", "右"],
        placement: Before(""),
        upper: ["センター", "上半身", "首", "頭", "肩", "腕", "ひじ", "手首", "人指"],
        lower: ["股関節", "足", "ひざ", "足首", "足甲", "つま先", "かかと"],
    },
    Naming {
        sides: ["左", "右"],
        placement: Before(""),
        upper: ["骨盆", "脊柱", "颈", "头", "锁骨", "上臂", "前臂", "手", "手指"],
        lower: ["髋", "大腿", "小腿", "脚踝", "脚掌", "脚趾", "脚跟"],
    },
    Naming {
        sides: ["왼쪽", "오른쪽"],
        placement: Before(""),
        upper: ["골반", "척추", "목", "머리", "쇄골", "팔", "팔뚝", "손", "손가락"],
        lower: ["고관절", "허벅지", "종아리", "발목", "발", "발가락", "뒤꿈치"],
    },
];

impl Naming {
    /// Returns the name of a bone.
    pub(super) fn name(&self, bone: Bone) -> String {
        let sided = |side: Side, name: &str| {
            let side = self.sides[usize::from(side == Side::Right)];
            match self.placement {
                Before(joint) => format!("{side}{joint}{name}"),
                After(joint) => format!("{name}{joint}{side}"),
            }
        };
        let numbered = |name: &str, index: usize| match index {
            0 => name.to_owned(),
            index => format!("{name}{index}"),
        };
        match bone {
            Bone::Hips => self.upper[0].into(),
            Bone::Spine(index) => numbered(self.upper[1], index),
            Bone::Neck => self.upper[2].into(),
            Bone::Head => self.upper[3].into(),
            Bone::Arm(side, index) => sided(side, self.upper[4 + index]),
            Bone::Finger(side) => sided(side, self.upper[8]),
            Bone::PelvisSide(side) => sided(side, self.lower[0]),
            Bone::Thigh(side, index) => sided(side, &with_roll(self.lower[1], index)),
            Bone::Shank(side, index) => sided(side, &with_roll(self.lower[2], index)),
            Bone::Ankle(side) => sided(side, self.lower[3]),
            Bone::Midfoot(side) => sided(side, self.lower[4]),
            Bone::Toe(side) => sided(side, self.lower[5]),
            Bone::Heel(side) => sided(side, self.lower[6]),
            Bone::Ik(side) => sided(side, &format!("{}IK", self.lower[3])),
            Bone::ThighTwist(side) => sided(side, &format!("{}Twist", self.lower[1])),
            Bone::ShankTwist(side) => sided(side, &format!("{}Twist", self.lower[2])),
            Bone::Skirt(chain, index) => format!("skirt_{chain}_{index}"),
            Bone::Wing(side, index) => sided(side, &format!("Wing{}", index + 1)),
            Bone::Tail(index) => format!("Tail{}", index + 1),
            Bone::Hind(side, index) => sided(side, &format!("Hind{}", index + 1)),
            Bone::Fore(side, index) => sided(side, &format!("Fore{}", index + 1)),
            Bone::End => plantigrade::bvh::END_SITE.into(),
        }
    }
}

/// Returns the name of the first part or the roll part of a split bone.
fn with_roll(name: &str, index: usize) -> String {
    if index == 0 { name.to_owned() } else { format!("{name}Roll") }
}
