//! Parsing of joint names into a side and a body part.

use crate::foot::Side;

/// Body part that joints are named after.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BodyPart {
    Hips,
    Spine,
    Neck,
    Head,
    /// Collar bone, or the upper arm if no collar bone is named.
    Shoulder,
    Arm,
    Forearm,
    Hand,
    Thigh,
    Shank,
    Ankle,
    /// Foot: the ankle, or the toe base below a joint named ankle.
    Foot,
    Toe,
}

/// Meaning of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ParsedName {
    pub side: Option<Side>,
    pub part: Option<BodyPart>,
}

/// Rig prefixes without a meaning for the body.
const PREFIXES: [&str; 14] = [
    "mixamorig",
    "character",
    "bip",
    "biped",
    "cc",
    "base",
    "jnt",
    "joint",
    "def",
    "bone",
    "j",
    "b",
    "valve",
    "skel",
];

/// Parses the name of a joint.
pub(crate) fn parse(name: &str) -> ParsedName {
    let name = name.rsplit(':').next().unwrap_or(name);
    let (side_character, name) = strip_side_character(name);
    let mut words = words(&name);
    while words.len() > 1 && PREFIXES.contains(&words[0].as_str()) {
        words.remove(0);
    }
    let side = side_character.or_else(|| {
        let at = words.iter().position(|word| side_word(word).is_some())?;
        side_word(&words.remove(at))
    });
    let body = words.concat();
    if side.is_none()
        && let Some((side, part)) = joined_side(&body)
    {
        return ParsedName { side: Some(side), part: Some(part) };
    }
    ParsedName { side, part: body_part(&body, side.is_some()) }
}

/// Removes the Chinese and Japanese characters for left and right.
fn strip_side_character(name: &str) -> (Option<Side>, String) {
    for (character, side) in [('左', Side::Left), ('右', Side::Right)] {
        if name.contains(character) {
            return (Some(side), name.replace(character, ""));
        }
    }
    (None, name.into())
}

/// Splits a name into lower-case words at separators, digits and changes of case; digits are
/// removed.
fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = vec![String::new()];
    let letters: Vec<char> = name.chars().collect();
    for (index, &letter) in letters.iter().enumerate() {
        let before = index.checked_sub(1).map(|index| letters[index]);
        let after = letters.get(index + 1);
        // `LeftFoot` and `LFoot` are split before F, `LHipJoint` before H and J.
        let is_word_start = letter.is_uppercase()
            && (before.is_some_and(char::is_lowercase)
                || before.is_some_and(char::is_uppercase) && after.is_some_and(|after| after.is_lowercase()));
        if is_word_start || !letter.is_alphabetic() {
            words.push(String::new());
        }
        if letter.is_alphabetic()
            && let Some(word) = words.last_mut()
        {
            word.extend(letter.to_lowercase());
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

fn side_word(word: &str) -> Option<Side> {
    match word {
        "left" | "l" | "lft" | "lt" => Some(Side::Left),
        "right" | "r" | "rgt" | "rt" => Some(Side::Right),
        _ => None,
    }
}

/// Parses a side that is joined to the body part, as in `rthigh` and `leftfoot`.
fn joined_side(body: &str) -> Option<(Side, BodyPart)> {
    [("left", Side::Left), ("right", Side::Right), ("l", Side::Left), ("r", Side::Right)]
        .into_iter()
        .find_map(|(prefix, side)| {
            let rest = body.strip_prefix(prefix).or_else(|| body.strip_suffix(prefix))?;
            Some((side, body_part(rest, true)?))
        })
}

/// Returns the body part of a name without side, digits and prefix.
fn body_part(body: &str, sided: bool) -> Option<BodyPart> {
    Some(match body {
        // With a side, a hip is the upper end of the thigh; without, it is the pelvis.
        "hip" if sided => BodyPart::Thigh,
        "hips" | "hip" | "pelvis" | "root" | "腰" | "下半身" | "骨盆" if !sided => BodyPart::Hips,
        "spine" | "chest" | "abdomen" | "lowerback" | "torso" | "waist" | "back" | "thorax" | "上半身"
        | "脊柱" | "胸"
            if !sided =>
        {
            BodyPart::Spine
        }
        "neck" | "lowerneck" | "首" | "颈" if !sided => BodyPart::Neck,
        "head" | "頭" | "头" if !sided => BodyPart::Head,
        "shoulder" | "collar" | "clavicle" | "scapula" | "肩" | "锁骨" => BodyPart::Shoulder,
        "arm" | "upperarm" | "uparm" | "shldr" | "humerus" | "腕" | "上臂" => BodyPart::Arm,
        "forearm" | "lowerarm" | "loarm" | "lowarm" | "elbow" | "radius" | "ひじ" | "前臂" => {
            BodyPart::Forearm
        }
        "hand" | "wrist" | "手首" | "手" => BodyPart::Hand,
        "upleg" | "upperleg" | "thigh" | "femur" | "足" | "大腿" => BodyPart::Thigh,
        "leg" | "lowerleg" | "lowleg" | "loleg" | "shin" | "calf" | "knee" | "tibia" | "shank" | "ひざ"
        | "小腿" => BodyPart::Shank,
        "ankle" | "足首" | "脚踝" | "踝" => BodyPart::Ankle,
        "foot" | "feet" | "heel" | "脚" => BodyPart::Foot,
        "toe" | "toes" | "toebase" | "ball" | "forefoot" | "つま先" | "脚趾" | "脚尖" => BodyPart::Toe,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn naming_conventions_are_parsed() {
        use BodyPart::*;
        use Side::{Left, Right};
        for (name, side, part) in [
            ("LeftUpLeg", Some(Left), Some(Thigh)),
            ("mixamorig:RightToeBase", Some(Right), Some(Toe)),
            ("mixamorig1_LeftFoot", Some(Left), Some(Foot)),
            ("Character1_LeftLeg", Some(Left), Some(Shank)),
            ("CC_Base_L_Calf", Some(Left), Some(Shank)),
            ("Bip01 R Toe0", Some(Right), Some(Toe)),
            ("Bip01 L Thigh", Some(Left), Some(Thigh)),
            ("lThigh", Some(Left), Some(Thigh)),
            ("rthigh", Some(Right), Some(Thigh)),
            ("lhip", Some(Left), Some(Thigh)),
            ("hip", None, Some(Hips)),
            ("LHipJoint", Some(Left), None),
            ("lButtock", Some(Left), None),
            ("LeftHip", Some(Left), Some(Thigh)),
            ("Hips", None, Some(Hips)),
            ("UpperLeg_L", Some(Left), Some(Thigh)),
            ("__UpLeg_L", Some(Left), Some(Thigh)),
            ("LoLeg_R", Some(Right), Some(Shank)),
            ("upperleg02.R", Some(Right), Some(Thigh)),
            ("toe1-1.L", Some(Left), Some(Toe)),
            ("calf_l", Some(Left), Some(Shank)),
            ("J_Bip_L_LowerLeg", Some(Left), Some(Shank)),
            ("R_Talus_RIGMESH", Some(Right), None),
            ("LeftForeFoot", Some(Left), Some(Toe)),
            ("LeftForeArm", Some(Left), Some(Forearm)),
            ("LowerArm_L", Some(Left), Some(Forearm)),
            ("thigh_twist_01_l", Some(Left), None),
            ("左ひざ", Some(Left), Some(Shank)),
            ("右足首", Some(Right), Some(Ankle)),
            ("左大腿", Some(Left), Some(Thigh)),
            ("Leg", None, Some(Shank)),
            ("", None, None),
            ("_", None, None),
        ] {
            assert_eq!(parse(name), ParsedName { side, part }, "{name}");
        }
    }
}
