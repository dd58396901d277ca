//! Tests of the clean-up on unusual clips: few frames, few channels, few joints.

use proptest::prelude::*;

use super::*;
use crate::bvh::{self, Channel, Clip, Joint};
use crate::foot::{Part, Side};
use crate::notice::Code;
use crate::skeleton::{Overrides, Role, Skeleton};

const SAMPLE: &[u8] = include_bytes!("../../../../samples/curved-walk.bvh");
const TRUTH: &str = include_str!("../../../../samples/curved-walk.json");

fn sample() -> (Clip, Contacts) {
    let clip = bvh::parse(SAMPLE, bvh::Options::default()).expect("a sample").clip;
    let truth = crate::formats::read_plants(TRUTH.as_bytes(), clip.frame_count()).expect("its truth");
    (clip, Contacts::from(&truth))
}

fn clean_checked(clip: &Clip, contacts: &Contacts) -> Cleaned {
    let skeleton = Skeleton::main(clip, &Overrides::default());
    let cleaned = clean(clip, &skeleton, contacts, &Options::default()).expect("feet");
    assert_eq!(cleaned.clip.joints(), clip.joints());
    assert_eq!(cleaned.clip.values().len(), clip.values().len());
    assert!(cleaned.clip.values().iter().all(|value| value.is_finite()));
    cleaned
}

/// Returns the clip with other channels: `change` returns the channels of a joint that remain.
fn with_channels(clip: &Clip, change: impl Fn(&Joint) -> Vec<Channel>) -> Clip {
    let joints: Vec<Joint> =
        clip.joints().iter().map(|joint| Joint { channels: change(joint), ..joint.clone() }).collect();
    let mut values = Vec::new();
    for frame in 0..clip.frame_count() {
        for (index, joint) in clip.joints().iter().enumerate() {
            let row = &clip.row(frame)[clip.channel_range(index)];
            let remaining = joint
                .channels
                .iter()
                .zip(row)
                .filter(|(channel, _)| joints[index].channels.contains(channel));
            values.extend(remaining.map(|(_, value)| *value));
        }
    }
    Clip::new(joints, clip.frame_time(), values)
}

fn constant_contacts(clip: &Clip, planted: bool) -> Contacts {
    Contacts::new(|_, _| Some(vec![planted; clip.frame_count()]))
}

#[test]
fn only_legs_and_the_hip_position_change() {
    let (clip, contacts) = sample();
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let found = clean_checked(&clip, &contacts);
    let is_leg_role = |role: &str| ["thigh", "shank", "ankle"].iter().any(|part| role.ends_with(part));
    for (index, joint) in clip.joints().iter().enumerate() {
        let is_leg = skeleton.roles.iter().any(|(role, joint)| joint == index && is_leg_role(role.name()));
        for (slot, channel) in clip.channel_range(index).zip(&joint.channels) {
            let is_hip_position = index == skeleton.root && matches!(channel, Channel::Position(_));
            for frame in 0..clip.frame_count() {
                let (before, after) = (clip.row(frame)[slot], found.clip.row(frame)[slot]);
                assert!(is_leg || is_hip_position || before.to_bits() == after.to_bits(), "{}", joint.name);
                assert!((before - after).abs() < 40.0, "{} turns around", joint.name);
            }
        }
    }
}

#[test]
fn clips_without_plants_are_unchanged() {
    let (clip, _) = sample();
    for contacts in [constant_contacts(&clip, false), Contacts::default()] {
        let found = clean_checked(&clip, &contacts);
        assert_eq!(found.clip, clip);
        assert_eq!(found.notices[0].code, Code::NothingPlanted);
    }
}

/// Returns the clip on a treadmill whose belt moves along the Z axis, given its speed in file units per second.
fn on_treadmill(clip: &Clip, speed: f64) -> Clip {
    let root = Skeleton::main(clip, &Overrides::default()).root;
    let is_z = |channel: &Channel| *channel == Channel::Position(bvh::Axis::Z);
    let slot = clip.channel_range(root).start
        + clip.joints()[root].channels.iter().position(is_z).expect("a position channel");
    let mut values = clip.values().to_vec();
    for (frame, row) in values.chunks_exact_mut(clip.channel_count()).enumerate() {
        row[slot] += speed * frame as f64 * clip.frame_time();
    }
    Clip::new(clip.joints().to_vec(), clip.frame_time(), values)
}

#[test]
fn feet_on_a_treadmill_move_with_the_belt() {
    let (clip, contacts) = sample();
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let speed = 1.0 / skeleton.metres_per_unit;
    let overground = clean_checked(&clip, &contacts);
    let treadmill = clean_checked(&on_treadmill(&clip, speed), &contacts);
    assert_eq!(treadmill.constrained_count(), treadmill.plants.len(), "{:?}", treadmill.plants);
    assert!(treadmill.plants.iter().all(|plant| plant.after < 1e-3));
    // The belt's velocity is estimated from the feet, so that their own slide remains unknown.
    let stance = treadmill.plants[0].frames.clone();
    let toe = skeleton.toe(Side::Left).expect("a toe");
    let track = &crate::kinematics::tracks(&treadmill.clip, &[toe])[0];
    let moved = (track[stance.start + 20] - track[stance.start]) / (20.0 * clip.frame_time());
    assert!((moved.z - speed).abs() < 0.1 * speed, "{moved} {speed}");
    assert_eq!(treadmill.plants.len(), overground.plants.len());
}

#[test]
fn labels_of_another_clip_are_rejected() {
    let (clip, contacts) = sample();
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let slice = clip.slice(0..9);
    let result = measure(&slice, &skeleton, &contacts);
    assert_eq!(result, Err(SkateError::Length { found: clip.frame_count(), frames: 9 }));
    assert_eq!(measure(&clip.slice(0..0), &skeleton, &contacts), Err(SkateError::NoMotion));
    let text = SkateError::NoFeet.to_string();
    let footless = Overrides { roles: vec![(Role::LeftAnkle, None)], ..Overrides::default() };
    let result = measure(&clip, &Skeleton::main(&clip, &footless), &contacts);
    assert_eq!(result.map_err(|error| error.to_string()), Err(text));
}

#[test]
fn the_shortest_clips_are_cleaned() {
    let (clip, _) = sample();
    for frames in 1..4 {
        let slice = clip.slice(100..100 + frames);
        let found = clean_checked(&slice, &constant_contacts(&slice, true));
        assert!(found.plants.iter().all(|plant| plant.after <= 0.001), "{:?}", found.plants);
    }
}

#[test]
fn contact_or_toe_labels_suffice() {
    let (clip, contacts) = sample();
    for part in [Part::Contact, Part::Toe] {
        let labels = |side, other| {
            let foot: &FootContacts = contacts.foot(side);
            (part == other)
                .then(|| if part == Part::Toe { foot.toe.clone() } else { foot.contact.clone() })?
        };
        let found = clean_checked(&clip, &Contacts::new(labels));
        assert!(found.plants.len() >= 4, "{part:?}");
        assert_eq!(found.constrained_count(), found.plants.len(), "{part:?} {:?}", found.plants);
    }
}

#[test]
fn feet_without_toes_are_held_at_their_ankles() {
    let (clip, contacts) = sample();
    let toes = [Role::LeftToe, Role::LeftTip, Role::RightToe, Role::RightTip];
    let overrides = Overrides { roles: toes.map(|role| (role, None)).to_vec(), ..Overrides::default() };
    let skeleton = Skeleton::main(&clip, &overrides);
    let found = clean(&clip, &skeleton, &contacts, &Options::default()).expect("ankles");
    assert_eq!(found.constrained_count(), found.plants.len());
}

#[test]
fn hips_without_position_channels_do_not_move() {
    let (clip, contacts) = sample();
    let is_rotation = |channel: &Channel| matches!(channel, Channel::Rotation(_));
    let fixed = with_channels(&clip, |joint| joint.channels.iter().copied().filter(is_rotation).collect());
    let found = clean_checked(&fixed, &contacts);
    assert!(found.notices.iter().any(|notice| notice.code == Code::FixedRoot));
}

#[test]
fn legs_without_solution_are_left_unchanged() {
    let (clip, contacts) = sample();
    let rigid = with_channels(&clip, |joint| {
        if joint.name.ends_with("L Thigh") { Vec::new() } else { joint.channels.clone() }
    });
    let found = clean_checked(&rigid, &contacts);
    for plant in &found.plants {
        assert_eq!(plant.skip_reason == Some(SkipReason::NoLeg), plant.side == Side::Left, "{plant:?}");
        assert_eq!(plant.position.is_none(), plant.side == Side::Left);
    }
    assert!(found.notices.iter().any(|notice| notice.code == Code::Unconstrained));
}

#[test]
fn joints_within_a_leg_follow() {
    let (clip, contacts) = sample();
    // A joint in the middle of each thigh and shank, with a small constant bend.
    let (mut joints, mut indices, mut sources) = (Vec::<Joint>::new(), Vec::new(), Vec::new());
    for (index, joint) in clip.joints().iter().enumerate() {
        let parent = joint.parent.map(|parent: usize| indices[parent]);
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
        indices.push(joints.len() - 1);
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
    let found = clean_checked(&Clip::new(joints, clip.frame_time(), values), &contacts);
    assert_eq!((found.constrained_count(), found.plants.len()), (5, 5), "{:?}", found.plants);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn random_labels_and_motion_never_panic(
        seed in prop::collection::vec(any::<[bool; 6]>(), 1..60),
        wild in prop::collection::vec(-400.0..400.0_f64, 1..40),
        is_wild in any::<bool>(),
    ) {
        let (clip, _) = sample();
        let slice = clip.slice(0..seed.len());
        let contacts = Contacts::new(|side, part| {
            Some(seed.iter().map(|flags| flags[3 * side as usize + part as usize]).collect())
        });
        if is_wild {
            let values = slice.values().iter().enumerate().map(|(n, value)| value + wild[n % wild.len()]);
            clean_checked(&Clip::new(slice.joints().to_vec(), slice.frame_time(), values.collect()), &contacts);
        } else {
            clean_checked(&slice, &contacts);
        }
    }
}

#[test]
fn the_clean_up_can_be_limited_to_some_plants() {
    let (clip, contacts) = sample();
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let all = clean(&clip, &skeleton, &contacts, &Options::default()).expect("feet");
    let chosen = all.plants.iter().find(|plant| plant.skip_reason.is_none()).expect("a corrected plant");
    let only = vec![(chosen.side, chosen.frames.clone())];
    let some = clean(&clip, &skeleton, &contacts, &Options { only, ..Options::default() }).expect("feet");
    for plant in &some.plants {
        let is_chosen = plant.side == chosen.side && plant.frames == chosen.frames;
        assert_eq!(plant.skip_reason == Some(SkipReason::NotSelected), !is_chosen, "{plant:?}");
    }
    assert!(some.notices.iter().all(|notice| notice.code != Code::Unconstrained));
}
