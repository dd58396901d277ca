//! Clean-up of what is odd: few frames, few channels, few joints.

use proptest::prelude::*;

use super::*;
use crate::bvh;
use crate::bvh::{Channel, Joint};
use crate::foot::Part;
use crate::notice::Code;
use crate::skeleton::{Overrides, Role};

const SAMPLE: &[u8] = include_bytes!("../../../../samples/curved-walk.bvh");
const TRUTH: &str = include_str!("../../../../samples/curved-walk.json");

fn sample() -> (Clip, Contacts) {
    let clip = bvh::parse(SAMPLE, bvh::Options::default()).expect("a sample").clip;
    let truth = crate::formats::read(TRUTH, clip.frame_count()).expect("its truth");
    (clip, Contacts::from(&truth))
}

fn cleaned(clip: &Clip, contacts: &Contacts) -> Cleaned {
    let skeleton = Skeleton::main(clip, &Overrides::default());
    let cleaned = clean(clip, &skeleton, contacts, &Options::default()).expect("feet");
    assert_eq!(cleaned.clip.joints(), clip.joints());
    assert_eq!(cleaned.clip.values().len(), clip.values().len());
    assert!(cleaned.clip.values().iter().all(|value| value.is_finite()));
    cleaned
}

/// The clip with other joints: `change` gives the new joint and which of its channels are kept.
fn rebuilt(clip: &Clip, change: impl Fn(&Joint) -> Vec<Channel>) -> Clip {
    let joints: Vec<Joint> =
        clip.joints().iter().map(|joint| Joint { channels: change(joint), ..joint.clone() }).collect();
    let mut values = Vec::new();
    for frame in 0..clip.frame_count() {
        for (index, joint) in clip.joints().iter().enumerate() {
            let row = &clip.row(frame)[clip.channel_range(index)];
            let kept = joint
                .channels
                .iter()
                .zip(row)
                .filter(|(channel, _)| joints[index].channels.contains(channel));
            values.extend(kept.map(|(_, value)| *value));
        }
    }
    Clip::new(joints, clip.frame_time(), values)
}

fn every(clip: &Clip, planted: bool) -> Contacts {
    Contacts::of(|_, _| Some(vec![planted; clip.frame_count()]))
}

#[test]
fn only_legs_and_the_place_of_the_hips_change() {
    let (clip, contacts) = sample();
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let found = cleaned(&clip, &contacts);
    let may = |role: &str| ["thigh", "shank", "ankle"].iter().any(|part| role.ends_with(part));
    for (index, joint) in clip.joints().iter().enumerate() {
        let is_leg = skeleton.roles.iter().any(|(role, joint)| joint == index && may(role.name()));
        for (slot, channel) in clip.channel_range(index).zip(&joint.channels) {
            let is_place = index == skeleton.root && matches!(channel, Channel::Position(_));
            for frame in 0..clip.frame_count() {
                let (before, after) = (clip.row(frame)[slot], found.clip.row(frame)[slot]);
                assert!(is_leg || is_place || before.to_bits() == after.to_bits(), "{}", joint.name);
                assert!((before - after).abs() < 40.0, "{} turns around", joint.name);
            }
        }
    }
}

#[test]
fn where_nothing_is_planted_nothing_changes() {
    let (clip, _) = sample();
    for contacts in [every(&clip, false), Contacts::default()] {
        let found = cleaned(&clip, &contacts);
        assert_eq!(found.clip, clip);
        assert_eq!(found.notices[0].code, Code::NothingPlanted);
    }
}

#[test]
fn labels_of_another_clip_are_refused() {
    let (clip, contacts) = sample();
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let part = clip.slice(0..9);
    let refused = measure(&part, &skeleton, &contacts);
    assert_eq!(refused, Err(SkateError::Length { found: clip.frame_count(), frames: 9 }));
    assert_eq!(measure(&clip.slice(0..0), &skeleton, &contacts), Err(SkateError::NoMotion));
    let text = SkateError::NoFeet.to_string();
    let footless = Overrides { roles: vec![(Role::LeftAnkle, None)], ..Overrides::default() };
    let refused = measure(&clip, &Skeleton::main(&clip, &footless), &contacts);
    assert_eq!(refused.map_err(|error| error.to_string()), Err(text));
}

#[test]
fn the_shortest_clips_are_clips() {
    let (clip, _) = sample();
    for frames in 1..4 {
        let part = clip.slice(100..100 + frames);
        let found = cleaned(&part, &every(&part, true));
        assert!(found.plants.iter().all(|plant| plant.after <= 0.001), "{:?}", found.plants);
    }
}

#[test]
fn contact_or_toe_alone_is_enough() {
    let (clip, contacts) = sample();
    for part in [Part::Contact, Part::Toe] {
        let labels = |side, other| {
            let foot: &FootContacts = contacts.foot(side);
            (part == other)
                .then(|| if part == Part::Toe { foot.toe.clone() } else { foot.contact.clone() })?
        };
        let found = cleaned(&clip, &Contacts::of(labels));
        assert!(found.plants.len() >= 4, "{part:?}");
        assert_eq!(found.constrained(), found.plants.len(), "{part:?} {:?}", found.plants);
    }
}

#[test]
fn feet_without_toes_stand_on_their_ankles() {
    let (clip, contacts) = sample();
    let toes = [Role::LeftToe, Role::LeftTip, Role::RightToe, Role::RightTip];
    let overrides = Overrides { roles: toes.map(|role| (role, None)).to_vec(), ..Overrides::default() };
    let skeleton = Skeleton::main(&clip, &overrides);
    let found = clean(&clip, &skeleton, &contacts, &Options::default()).expect("ankles");
    assert_eq!(found.constrained(), found.plants.len());
}

#[test]
fn hips_without_a_place_stay() {
    let (clip, contacts) = sample();
    let is_turn = |channel: &Channel| matches!(channel, Channel::Rotation(_));
    let fixed = rebuilt(&clip, |joint| joint.channels.iter().copied().filter(is_turn).collect());
    let found = cleaned(&fixed, &contacts);
    assert!(found.notices.iter().any(|notice| notice.code == Code::FixedRoot));
}

#[test]
fn legs_that_cannot_be_solved_are_left_alone() {
    let (clip, contacts) = sample();
    let stiff =
        rebuilt(
            &clip,
            |joint| {
                if joint.name.ends_with("L Thigh") { Vec::new() } else { joint.channels.clone() }
            },
        );
    let found = cleaned(&stiff, &contacts);
    for plant in &found.plants {
        assert_eq!(plant.why_not == Some(WhyNot::NoLeg), plant.side == Side::Left, "{plant:?}");
        assert_eq!(plant.position.is_none(), plant.side == Side::Left);
    }
    assert!(found.notices.iter().any(|notice| notice.code == Code::Unconstrained));
}

#[test]
fn joints_between_go_along() {
    let (clip, contacts) = sample();
    // A joint half-way down each thigh and shank, that bends a little and stays so.
    let (mut joints, mut places, mut sources) = (Vec::<Joint>::new(), Vec::new(), Vec::new());
    for (index, joint) in clip.joints().iter().enumerate() {
        let parent = joint.parent.map(|parent: usize| places[parent]);
        let is_lower = joint.name.ends_with("Calf") || joint.name.ends_with("Foot");
        if is_lower {
            let channels = clip.joints()[1].channels.clone();
            let half = Joint {
                name: format!("{} half", joint.name),
                offset: joint.offset / 2.0,
                channels,
                parent,
                ..joint.clone()
            };
            joints.push(half);
            sources.push(None);
            joints.push(Joint {
                parent: Some(joints.len() - 1),
                offset: joint.offset / 2.0,
                ..joint.clone()
            });
        } else {
            joints.push(Joint { parent, ..joint.clone() });
        }
        sources.push(Some(index));
        places.push(joints.len() - 1);
    }
    let mut values = Vec::new();
    for frame in 0..clip.frame_count() {
        for (joint, source) in joints.iter().zip(&sources) {
            match source {
                Some(source) => values.extend(&clip.row(frame)[clip.channel_range(*source)]),
                None => values.extend(joint.channels.iter().map(|_| 2.0)),
            }
        }
    }
    let found = cleaned(&Clip::new(joints, clip.frame_time(), values), &contacts);
    assert_eq!((found.constrained(), found.plants.len()), (5, 5), "{:?}", found.plants);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_labels_of_any_motion_are_survived(
        seed in prop::collection::vec(any::<[bool; 6]>(), 1..60),
        wild in prop::collection::vec(-400.0..400.0_f64, 1..40),
        is_wild in any::<bool>(),
    ) {
        let (clip, _) = sample();
        let part = clip.slice(0..seed.len());
        let contacts = Contacts::of(|side, part| {
            Some(seed.iter().map(|flags| flags[3 * side as usize + part as usize]).collect())
        });
        if is_wild {
            let values = part.values().iter().enumerate().map(|(n, value)| value + wild[n % wild.len()]);
            cleaned(&Clip::new(part.joints().to_vec(), part.frame_time(), values.collect()), &contacts);
        } else {
            cleaned(&part, &contacts);
        }
    }
}
