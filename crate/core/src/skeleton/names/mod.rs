//! Parsing of joint names into side, body part and qualifiers.

mod part;
mod vocabulary;

use std::collections::{HashMap, HashSet};
use std::sync::LazyLock;

use crate::foot::Side;
use crate::numeric::sort;
pub(crate) use part::BodyPart;
use vocabulary::{FORE_LIMBS, HELPERS, HIND_LIMBS, LANGUAGES, TIPS};

/// Pair of limbs of an animal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LimbPair {
    Fore,
    Hind,
}

/// Meaning of a name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct ParsedName {
    pub side: Option<Side>,
    pub part: Option<BodyPart>,
    /// Fore or hind limb, if the name has one of their words.
    pub limb_pair: Option<LimbPair>,
    /// True for twist, roll and IK joints and other machinery of a rig.
    pub is_helper: bool,
    /// True for the end of a bone.
    pub is_tip: bool,
    /// Number of words that are not understood.
    pub unknown_words: usize,
}

/// Terms of all languages: body part and rank, where 0 is the first language.
static TERMS: LazyLock<HashMap<&str, (BodyPart, usize)>> = LazyLock::new(|| {
    let mut terms = HashMap::new();
    for (rank, language) in LANGUAGES.iter().enumerate() {
        for &(part, words) in language.terms {
            for &word in words {
                terms.entry(word).or_insert((part, rank));
            }
        }
    }
    terms
});

/// Side words of all languages, longest first.
static SIDES: LazyLock<Vec<(&str, Side)>> = LazyLock::new(|| {
    let sides = LANGUAGES
        .iter()
        .flat_map(|language| {
            let left = language.left.iter().map(|&word| (word, Side::Left));
            left.chain(language.right.iter().map(|&word| (word, Side::Right)))
        })
        .collect();
    sort::sort_by_frames(sides, |(word, _)| (usize::MAX - word.len(), 0))
});

/// Fraction of a skeleton's names in which a word has no meaning, such as a prefix.
const COMMON_WORD: f64 = 0.7;

/// Parses the names of the joints of one skeleton. Words that most names share are ignored.
pub(crate) fn parse_all<'a>(names: impl Iterator<Item = &'a str>) -> Vec<ParsedName> {
    let words: Vec<Vec<String>> = names.map(words).collect();
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for words in &words {
        for word in words.iter().map(String::as_str).collect::<HashSet<_>>() {
            *counts.entry(word).or_default() += 1;
        }
    }
    let limit = (COMMON_WORD * words.len() as f64).max(2.0);
    let is_common = |word: &str| counts.get(word).is_some_and(|&count| count as f64 > limit);
    // Letters for front or back and for the side may be one word.
    let has_corners = ["fl", "fr"].iter().all(|&corner| counts.contains_key(corner));
    let words: Vec<Vec<&str>> = words
        .iter()
        .map(|words| words.iter().map(String::as_str).filter(|word| !is_common(word)))
        .map(|words| {
            words.flat_map(|word| corner(word, has_corners)).filter(|word| !word.is_empty()).collect()
        })
        .collect();
    let mut parsed: Vec<ParsedName> = words.iter().cloned().map(parse_words).collect();
    apply_letters(&words, &mut parsed);
    parsed
}

/// Splits a word such as `fl` into its letters for front or back and for the side, if `has_corners`.
fn corner(word: &str, has_corners: bool) -> [&str; 2] {
    match word {
        "fl" | "fr" | "bl" | "br" | "hl" | "hr" if has_corners => [&word[..1], &word[1..]],
        _ => [word, ""],
    }
}

/// Letters for left and right in languages other than English: French, Spanish, Italian, Portuguese,
/// Polish and Swedish.
const SIDE_LETTERS: [[&str; 2]; 6] = [["g", "d"], ["i", "d"], ["s", "d"], ["e", "d"], ["l", "p"], ["v", "h"]];

/// Letters for fore and hind limbs.
const LIMB_LETTERS: [[&str; 2]; 2] = [["f", "b"], ["f", "h"]];

/// Applies single letters whose meaning is clear only if names of legs have both letters of a pair: for
/// sides, if other words do not tell both of them; for limbs of animals.
fn apply_letters(words: &[Vec<&str>], parsed: &mut [ParsedName]) {
    let has = |index: usize, letter: &str| words[index].contains(&letter);
    let of_leg = |parsed: &[ParsedName], index: usize| parsed[index].part.is_some_and(BodyPart::is_of_leg);
    let find = |parsed: &[ParsedName], pairs: &[[&'static str; 2]]| -> Option<[&'static str; 2]> {
        let exists = |letter: &str| (0..words.len()).any(|index| of_leg(parsed, index) && has(index, letter));
        pairs.iter().copied().find(|pair| pair.iter().all(|letter| exists(letter)))
    };
    let knows =
        |side| (0..words.len()).any(|index| of_leg(parsed, index) && parsed[index].side == Some(side));
    if !Side::BOTH.iter().all(|&side| knows(side))
        && let Some([left, right]) = find(parsed, &SIDE_LETTERS)
    {
        for (index, words) in words.iter().enumerate() {
            let at = words.iter().rposition(|word| *word == left || *word == right);
            if let Some(at) = at {
                let side = if words[at] == left { Side::Left } else { Side::Right };
                let rest: Vec<&str> = words
                    .iter()
                    .enumerate()
                    .filter(|(other, _)| *other != at)
                    .map(|(_, word)| *word)
                    .collect();
                parsed[index] = ParsedName { side: Some(side), ..parse_with_side(rest, true) };
            }
        }
    }
    if let Some([fore, hind]) = find(parsed, &LIMB_LETTERS) {
        let limbs = [(fore, LimbPair::Fore), (hind, LimbPair::Hind)];
        for (words, name) in words.iter().zip(parsed) {
            if let Some((_, limb)) = limbs.into_iter().find(|(letter, _)| words.contains(letter)) {
                name.limb_pair = Some(limb);
            }
        }
    }
}

/// Parses words of one name.
fn parse_words(mut words: Vec<&str>) -> ParsedName {
    let mut parsed = ParsedName::default();
    if let Some(at) = words.iter().position(|word| side_word(word).is_some()) {
        parsed.side = side_word(words.remove(at));
    } else if let Some((at, side, rest)) =
        words.iter().enumerate().find_map(|(at, word)| split_side(word).map(|(side, rest)| (at, side, rest)))
    {
        parsed.side = Some(side);
        words[at] = rest;
    }
    let side = parsed.side;
    ParsedName { side, ..parse_with_side(words, side.is_some()) }
}

/// Parses words of a name without those of its side.
fn parse_with_side(words: Vec<&str>, is_sided: bool) -> ParsedName {
    let mut parsed = ParsedName::default();
    let (part, term) = body_part(&words, is_sided);
    parsed.part = part;
    for (index, word) in words.iter().enumerate() {
        if term.contains(&index) {
            continue;
        }
        if part == Some(BodyPart::Other) && (FORE_LIMBS.contains(word) || HIND_LIMBS.contains(word)) {
            // The front of a skirt is no limb.
        } else if FORE_LIMBS.contains(word) {
            parsed.limb_pair = Some(LimbPair::Fore);
        } else if HIND_LIMBS.contains(word) || *word == "back" && part.is_some_and(BodyPart::is_of_leg) {
            parsed.limb_pair = Some(LimbPair::Hind);
        } else if HELPERS.contains(word) {
            parsed.is_helper = true;
        } else if TIPS.contains(word) {
            parsed.is_tip = true;
        } else if !word.is_empty() {
            parsed.unknown_words += 1;
        }
    }
    parsed
}

/// Splits a name at spaces, signs, digits, capitals and changes of script, into lower-case words
/// without accents.
fn words(name: &str) -> Vec<String> {
    let name = name.rsplit([':', '|']).next().unwrap_or(name);
    let mut words: Vec<String> = vec![String::new()];
    let letters: Vec<char> = name.chars().collect();
    for (index, &letter) in letters.iter().enumerate() {
        let before = index.checked_sub(1).map(|index| letters[index]);
        let after = letters.get(index + 1);
        // `LeftFoot` and `LFoot` are split before F, `LHipJoint` before H and J.
        let is_word_start = letter.is_uppercase()
            && (before.is_some_and(char::is_lowercase)
                || before.is_some_and(char::is_uppercase) && after.is_some_and(|after| after.is_lowercase()))
            || before.is_some_and(|before| {
                before.is_alphabetic() && is_east_asian(before) != is_east_asian(letter)
            });
        if is_word_start || !letter.is_alphabetic() {
            words.push(String::new());
        }
        if letter.is_alphabetic()
            && let Some(word) = words.last_mut()
        {
            for letter in letter.to_lowercase() {
                fold(letter, word);
            }
        }
    }
    // A lower-case word may contain the side: `playerleftfoot`.
    let mut split = Vec::with_capacity(words.len());
    for word in words {
        match ["left", "right"].into_iter().find_map(|side| Some((word.find(side)?, side.len()))) {
            Some((at, length)) if word != "upright" => {
                split.extend([&word[..at], &word[at..at + length], &word[at + length..]].map(str::to_owned));
            }
            _ => split.push(word),
        }
    }
    split.retain(|word| !word.is_empty());
    split
}

/// True for letters of scripts without spaces between words.
fn is_east_asian(letter: char) -> bool {
    matches!(letter, '\u{2e80}'..='\u{9fff}' | '\u{f900}'..='\u{faff}' | '\u{20000}'..='\u{3ffff}')
}

/// Appends a lower-case letter without its accent; full-width letters become ASCII.
fn fold(letter: char, word: &mut String) {
    let folded = match letter {
        'à'..='å' | 'ā' | 'ă' | 'ą' => 'a',
        'ç' | 'ć' | 'č' => 'c',
        'è'..='ë' | 'ē' | 'ę' | 'ě' => 'e',
        'ì'..='ï' | 'ī' => 'i',
        'ł' => 'l',
        'ñ' | 'ń' | 'ň' => 'n',
        'ò'..='ö' | 'ø' | 'ō' => 'o',
        'ś' | 'š' => 's',
        'ù'..='ü' | 'ū' => 'u',
        'ý' | 'ÿ' => 'y',
        'ź' | 'ż' | 'ž' => 'z',
        'ß' => {
            word.push('s');
            's'
        }
        // Combining accents of decomposed letters.
        '\u{300}'..='\u{36f}' => return,
        'ａ'..='ｚ' => char::from_u32(letter as u32 - 'ａ' as u32 + 'a' as u32).unwrap_or(letter),
        letter => letter,
    };
    word.push(folded);
}

fn side_word(word: &str) -> Option<Side> {
    SIDES.iter().find(|(side, _)| *side == word).map(|&(_, side)| side)
}

/// Splits a side off a word that is otherwise a term, as in `rthigh`, `footl` and `左足首`.
fn split_side(word: &str) -> Option<(Side, &str)> {
    if TERMS.contains_key(word) || FORE_LIMBS.contains(&word) || HIND_LIMBS.contains(&word) {
        return None;
    }
    SIDES.iter().find_map(|&(side_word, side)| {
        let rest = word.strip_prefix(side_word).or_else(|| word.strip_suffix(side_word))?;
        let is_known = TERMS.contains_key(rest) || FORE_LIMBS.contains(&rest) || HIND_LIMBS.contains(&rest);
        (is_known || matches!(side_word, "左" | "右")).then_some((side, rest))
    })
}

/// Returns the body part of the longest term in consecutive words, and the range of these words.
fn body_part(words: &[&str], is_sided: bool) -> (Option<BodyPart>, std::ops::Range<usize>) {
    let mut matches: Vec<(BodyPart, usize, usize, std::ops::Range<usize>)> = Vec::new();
    for start in 0..words.len() {
        let mut joined = String::new();
        // No term has more than four words.
        for end in start + 1..=words.len().min(start + 4) {
            joined.push_str(words[end - 1]);
            if let Some(&(part, rank)) = TERMS.get(joined.as_str()) {
                let part = match part {
                    BodyPart::Hip if !is_sided => BodyPart::Hips,
                    // The trunk has no sides: `LeftBackFoot` is a hind foot.
                    BodyPart::Spine if is_sided => continue,
                    part => part,
                };
                matches.push((part, rank, joined.len(), start..end));
            }
        }
    }
    // A finger is meant unless another part but the hand is named: `LeftToeIndex` is a toe.
    let weight = |part| match part {
        BodyPart::Finger => 1,
        BodyPart::Other | BodyPart::Hand => 0,
        _ => 2,
    };
    let best = matches.into_iter().max_by_key(|(part, rank, length, range)| {
        (weight(*part), std::cmp::Reverse((*rank).min(1)), *length, range.start)
    });
    best.map_or((None, 0..0), |(part, _, _, range)| (Some(part), range))
}

/// Returns how many names of joints contain words that are known.
pub fn known_name_count<'a>(names: impl Iterator<Item = &'a str>) -> usize {
    parse_all(names).iter().filter(|name| name.part.is_some()).count()
}

/// Introduction of the document of joint names.
const DOCUMENT_HEAD: &str = "\
# Joint names

Plantigrade finds the roles of joints by their names, by the structure of the skeleton and by its
motion. This page lists the words that it knows. It is made from the code by
`cargo run -p plantigrade --example joint_names > docs/joint-names.md`.

A name is split into words at spaces, signs, digits, capitals and changes of script. Case, accents and
everything before the last `:` or `|` do not matter, and words that most names of the skeleton share,
such as a prefix, are ignored. The side may stand anywhere: `LeftFoot`, `L_Foot`, `foot.l`, `lFoot`,
`FootLeft`. Words of one term may be separated: `upper_leg` is `upperleg`.

- *Hip* with a side is the thigh, unless a joint below it is named thigh. Without a side it is the pelvis.
- *Leg* is the shank below a thigh, the thigh above a shank, and the ankle below a shank.
- The first joint named *ankle* or *foot* is the ankle; a foot below it is the middle of the foot.
- If a leg is named and its foot is not, the ankle is the joint below which bone lengths leave only a foot.
- If nothing is named, the legs are the mirrored limbs that reach farthest from their common joint and do not
  point to the head. A notice states it. Limbs with names of fore limbs, arms, wings or clothes are no legs, and
  limbs named hind are the legs only if there are no others.

";

/// Returns the text of `docs/joint-names.md`: all words of joint names that are known.
pub fn joint_names_document() -> String {
    let mut text = format!("{DOCUMENT_HEAD}| language | meaning | words |\n|---|---|---|\n");
    let mut row = |language: &str, meaning: &str, words: &[&str]| {
        text += &format!("| {language} | {meaning} | {} |\n", words.join(", "));
    };
    for language in LANGUAGES {
        row(language.name, "left", language.left);
        row("", "right", language.right);
        for (part, name) in BodyPart::NAMES {
            for (_, words) in language.terms.iter().filter(|(term, _)| *term == part) {
                row("", name, words);
            }
        }
    }
    row("all", "fore limb of an animal", FORE_LIMBS);
    row("", "hind limb of an animal", HIND_LIMBS);
    row("", "helper, which has no role of its own", HELPERS);
    row("", "end of a bone", TIPS);
    text
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
            ("Character1_LeftLeg", Some(Left), Some(Leg)),
            ("CC_Base_L_Calf", Some(Left), Some(Shank)),
            ("Bip01 R Toe0", Some(Right), Some(Toe)),
            ("Bip01 L Thigh", Some(Left), Some(Thigh)),
            ("lThigh", Some(Left), Some(Thigh)),
            ("rthigh", Some(Right), Some(Thigh)),
            ("lhip", Some(Left), Some(Hip)),
            ("hip", None, Some(Hips)),
            ("mid_hip", None, Some(Hips)),
            ("LHipJoint", Some(Left), Some(PelvisSide)),
            ("lButtock", Some(Left), Some(PelvisSide)),
            ("LeftHip", Some(Left), Some(Hip)),
            ("Hips", None, Some(Hips)),
            ("UpperLeg_L", Some(Left), Some(Thigh)),
            ("__UpLeg_L", Some(Left), Some(Thigh)),
            ("LoLeg_R", Some(Right), Some(Shank)),
            ("upperleg02.R", Some(Right), Some(Thigh)),
            ("toe1-1.L", Some(Left), Some(Toe)),
            ("calf_l", Some(Left), Some(Shank)),
            ("J_Bip_L_LowerLeg", Some(Left), Some(Shank)),
            ("LeftForeFoot", Some(Left), Some(Toe)),
            ("LeftForeArm", Some(Left), Some(Forearm)),
            ("LowerArm_L", Some(Left), Some(Forearm)),
            ("upper_arm.L", Some(Left), Some(Arm)),
            ("lThighBend", Some(Left), Some(Thigh)),
            ("thigh_stretch.l", Some(Left), Some(Thigh)),
            ("LThighLower", Some(Left), Some(Thigh)),
            ("left_foot_index", Some(Left), Some(Toe)),
            ("LeftHandIndex1", Some(Left), Some(Finger)),
            ("LThumb", Some(Left), Some(Finger)),
            ("Chr_LeftToeMid1", Some(Left), Some(Toe)),
            ("mAnkleLeft", Some(Left), Some(Ankle)),
            ("heel.02.L", Some(Left), Some(Heel)),
            ("HIP_LEFT", Some(Left), Some(Hip)),
            ("playerleftfoot", Some(Left), Some(Foot)),
            ("footL", Some(Left), Some(Foot)),
            ("左ひざ", Some(Left), Some(Shank)),
            ("左足", Some(Left), Some(Leg)),
            ("右足首", Some(Right), Some(Ankle)),
            ("左大腿", Some(Left), Some(Thigh)),
            ("脚踝_右", Some(Right), Some(Ankle)),
            ("왼쪽발목", Some(Left), Some(Ankle)),
            ("Левая_стопа", Some(Left), Some(Foot)),
            ("Rechts_Fuß", Some(Right), Some(Foot)),
            ("LinkesKnie", Some(Left), Some(Shank)),
            ("cuisse_gauche", Some(Left), Some(Thigh)),
            ("piedDroit", Some(Right), Some(Foot)),
            ("tobillo.izq", Some(Left), Some(Ankle)),
            ("Leg", None, Some(Leg)),
            ("Chr_face_L_0", Some(Left), Some(Other)),
            ("", None, None),
            ("_", None, None),
        ] {
            let parsed = parse_all(std::iter::once(name)).remove(0);
            assert_eq!((parsed.side, parsed.part), (side, part), "{name}");
        }
    }

    #[test]
    fn letters_of_other_languages_are_sides_if_both_exist() {
        let sides =
            |names: [&str; 5]| parse_all(names.into_iter()).iter().map(|name| name.side).collect::<Vec<_>>();
        use Side::{Left, Right};
        assert_eq!(
            sides(["Bassin", "Pied_G", "Pied_D", "Tete", "Main_D"]),
            [None, Some(Left), Some(Right), None, Some(Right)]
        );
        assert_eq!(
            sides(["Biodra", "Stopa_L", "Stopa_P", "Glowa", "Szyja"]),
            [None, Some(Left), Some(Right), None, None]
        );
        assert_eq!(sides(["Hips", "Foot_D", "Foot", "Head", "Neck"]), [None; 5]);
        assert_eq!(
            sides(["Hips", "LeftFoot_G", "RightFoot_D", "Head", "Neck"]),
            [None, Some(Left), Some(Right), None, None]
        );
    }

    #[test]
    fn front_and_back_limbs_are_told_apart() {
        let names = ["lFLeg1", "lFFoot", "lBLeg1", "lBFoot", "LeftBackFoot", "LeftBackLeg"];
        let parsed = parse_all(names.into_iter());
        let pairs: Vec<_> = parsed.iter().map(|name| name.limb_pair).collect();
        use LimbPair::{Fore, Hind};
        assert_eq!(pairs, [Fore, Fore, Hind, Hind, Hind, Hind].map(Some));
        assert_eq!(parsed[5].part, Some(BodyPart::Leg));
        let parsed = parse_all(["FL_knee", "FR_paw", "BL_knee", "BR_paw"].into_iter());
        assert_eq!(
            parsed.iter().map(|name| name.limb_pair).collect::<Vec<_>>(),
            [Fore, Fore, Hind, Hind].map(Some)
        );
        assert_eq!(parsed[3].side, Some(Side::Right));
    }

    #[test]
    fn qualifiers_are_parsed() {
        let parse = |name| parse_all(std::iter::once(name)).remove(0);
        assert!(parse("LeftFootIK").is_helper && parse("左足ＩＫ").is_helper);
        assert!(parse("R_Talus_RIGMESH").is_helper);
        assert!(parse("LeftToeEnd").is_tip && !parse("LeftToeBase").is_tip);
        assert_eq!(parse("hindL1").limb_pair, Some(LimbPair::Hind));
        assert_eq!(parse("hindL1").side, Some(Side::Left));
        assert_eq!(parse("front_r_2").limb_pair, Some(LimbPair::Fore));
        assert_eq!(parse("LeftForeArm").limb_pair, None);
        assert_eq!(parse("J_Sec_L_SkirtFront0_01").limb_pair, None);
        assert_eq!((parse("LeftFoot").unknown_words, parse("LeftFootSole").unknown_words), (0, 1));
    }

    #[test]
    fn known_names_are_counted() {
        assert_eq!(known_name_count(["左足首", "Hüfte", "xyz", "ç¸"].into_iter()), 2);
    }

    #[test]
    fn words_of_most_names_are_ignored() {
        let names = ["main_hips", "main_left_hip_joint", "main_left_knee", "main_left_foot", "main_head"];
        let parsed = parse_all(names.into_iter());
        assert_eq!(parsed[0].part, Some(BodyPart::Hips));
        assert!(parsed.iter().all(|name| name.unknown_words == 0), "{parsed:?}");
        let joints = ["left_hip_joint", "left_knee_joint", "right_hip_joint", "right_knee_joint"];
        assert_eq!(parse_all(joints.into_iter())[0].part, Some(BodyPart::Hip));
    }
}
