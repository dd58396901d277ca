//! Reading and detection over recorded files as they occur.

mod support;

use plantigrade::bvh;
use plantigrade::labels::Side;
use plantigrade::plants::{self, DetectError, Feet, Params, ValidParams};
use plantigrade::skeleton::{Overrides, Skeleton};

/// Files that have no pair of feet: a bar, a chain, a trunk, and a body with one leg.
const WITHOUT_FEET: [&str; 4] = [
    "bvh_anim_test_simple.bvh",
    "fairmotion_sinusoidal_no_end_site.bvh",
    "pybvh_full_precision_frame_time.bvh",
    "pybvh_rotation_first_root.bvh",
];

#[test]
fn every_file_is_read_and_has_its_feet() {
    let Some(corpus) = support::corpus::folder() else { return };
    let files = support::bvh_files(&corpus);
    assert_eq!(files.len(), 91);
    for path in files {
        let clip = support::read(&path).clip;
        let skeleton = Skeleton::main(&clip, &Overrides::default());
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let has_none = WITHOUT_FEET.contains(&&*name);
        assert_eq!(skeleton.roles.has_feet(), !has_none, "{name}");
        if has_none {
            continue;
        }
        for side in Side::BOTH {
            let toe =
                &clip.joints()[skeleton.toe(side).expect("a toe or what stands in")].name.to_lowercase();
            let heel = &clip.joints()[skeleton.heel(side).expect("an ankle")].name.to_lowercase();
            assert!(heel.contains("foot") || heel.contains("ankle"), "{name}: {heel}");
            assert!(toe.contains("toe") || toe.contains("forefoot") || toe == "end site", "{name}: {toe}");
        }
    }
}

#[test]
fn every_clip_with_motion_and_feet_is_labelled() {
    let Some(corpus) = support::corpus::folder() else { return };
    let mut labelled = 0;
    for path in support::bvh_files(&corpus) {
        let clip = support::read(&path).clip;
        let skeleton = Skeleton::main(&clip, &Overrides::default());
        match Feet::of(&clip, &skeleton) {
            Ok(feet) => {
                let detection = plants::detect(&feet, ValidParams::default());
                for foot in detection.parts.iter().flat_map(|labels| &labels.feet) {
                    assert_eq!(foot.planted.len(), clip.frame_count(), "{}", path.display());
                    assert!(foot.confidence.iter().all(|p| (0.5..=1.0).contains(p)), "{}", path.display());
                }
                assert!(detection.floor.is_finite());
                labelled += 1;
            }
            Err(DetectError::NoMotion) => assert_eq!(clip.frame_count(), 0),
            Err(DetectError::NoFeet) => assert!(!skeleton.roles.has_feet()),
        }
    }
    // Four have no feet, two no motion.
    assert_eq!(labelled, 85);
}

#[test]
fn what_is_read_survives_writing() {
    let Some(corpus) = support::corpus::folder() else { return };
    for path in support::bvh_files(&corpus.join("dialects")) {
        let clip = support::read(&path).clip;
        let back =
            bvh::parse(bvh::write(&clip).as_bytes(), bvh::Options::default()).expect("what was written").clip;
        if clip.position_rule() == bvh::PositionRule::Replace {
            assert_eq!(back, clip, "{}", path.display());
        }
        // However the rule is written, the pose is the same.
        let first = |clip| plantigrade::motion::Kinematics::of(clip).pose(0).to_vec();
        for (found, expected) in first(&back).iter().zip(first(&clip)) {
            assert!((found - expected).norm() < 1e-9, "{}", path.display());
        }
    }
}

#[test]
fn long_clips_have_the_labels_of_all_pairs() {
    let Some(corpus) = support::corpus::folder() else { return };
    let (mut labels, mut others, mut clips) = (0, 0, 0);
    for path in support::bvh_files(&corpus) {
        let clip = support::read(&path).clip;
        let Ok(feet) = Feet::of(&clip, &Skeleton::main(&clip, &Overrides::default())) else { continue };
        if clip.frame_count() <= 1500 {
            continue;
        }
        clips += 1;
        let [few, all] = [false, true]
            .map(|exact| plants::detect(&feet, Params { exact, ..Params::default() }.check().unwrap()));
        for (few, all) in few.parts.iter().zip(&all.parts) {
            for (few, all) in few.feet.iter().zip(&all.feet) {
                labels += few.planted.len();
                others += few.planted.iter().zip(&all.planted).filter(|(few, all)| few != all).count();
            }
        }
    }
    assert!(clips >= 3, "{clips} clips are long");
    assert!(others * 10_000 <= labels, "{others} of {labels} labels are others");
}
