//! Reading and detection over recorded files as they occur.

mod support;

use plantigrade::bvh::{self, Clip};
use plantigrade::foot::Side;
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
        match Feet::new(&clip, &skeleton) {
            Ok(feet) => {
                let detection = plants::detect(&feet, ValidParams::default());
                for foot in detection.parts.iter().flat_map(|labels| &labels.feet) {
                    assert_eq!(foot.planted.len(), clip.frame_count(), "{}", path.display());
                    assert!(foot.confidence.iter().all(|p| (0.5..=1.0).contains(p)), "{}", path.display());
                }
                assert!(detection.ground_height.is_finite());
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
        let first = |clip| plantigrade::kinematics::Kinematics::new(clip).pose(0).to_vec();
        for (found, expected) in first(&back).iter().zip(first(&clip)) {
            assert!((found - expected).norm() < 1e-9, "{}", path.display());
        }
    }
}

/// How far a root may be from the threshold, relative to it, where its sample falls on the other side.
const STATED: f64 = 1e-3;

/// How many labels there are, and how many of them are others than if all pairs were looked at:
/// none but those of samples that are next to the threshold.
fn others(clip: &Clip) -> (usize, usize) {
    let Ok(feet) = Feet::new(clip, &Skeleton::main(clip, &Overrides::default())) else { return (0, 0) };
    let [few, all] = [false, true]
        .map(|exact| plants::detect(&feet, Params { exact, ..Params::default() }.check().unwrap()));
    let (mut labels, mut others) = (0, 0);
    for (few, all) in few.parts.iter().zip(&all.parts) {
        assert_eq!(few.evidence.is_some(), all.evidence.is_some());
        for (close, exact) in few.evidence.iter().zip(&all.evidence) {
            for (near, root) in close.values.iter().zip(&exact.values) {
                let [near, root] = [near, root].map(|root| f64::from(*root));
                let is_other = (near > close.threshold) != (root > exact.threshold);
                let off = (root / exact.threshold - 1.0).abs();
                assert!(!is_other || off < STATED, "{root} {}", exact.threshold);
            }
        }
        for (few, all) in few.feet.iter().zip(&all.feet) {
            labels += few.planted.len();
            others += few.planted.iter().zip(&all.planted).filter(|(few, all)| few != all).count();
        }
    }
    (labels, others)
}

#[test]
fn long_clips_have_the_labels_of_all_pairs() {
    let Some(corpus) = support::corpus::folder() else { return };
    let clips = support::bvh_files(&corpus).into_iter().map(|path| support::read(&path).clip);
    let long: Vec<_> = clips.filter(|clip| clip.frame_count() > 1500).map(|clip| others(&clip)).collect();
    assert!(long.len() >= 3, "{} clips are long", long.len());
    let (labels, others) = long.iter().fold((0, 0), |sum, each| (sum.0 + each.0, sum.1 + each.1));
    assert!(others * 10_000 <= labels, "{others} of {labels} labels are others");
}

#[test]
fn so_have_a_persons_clips_one_after_the_other() {
    const FRAMES: usize = 20_000;
    let Some(corpus) = support::corpus::folder() else { return };
    for person in ["02_", "05_", "86_"] {
        let mut files = support::bvh_files(&corpus.join("cmu"));
        files.retain(|path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(person)));
        let clips: Vec<Clip> = files.iter().map(|path| support::read(path).clip).collect();
        let rows = clips.iter().flat_map(|clip| (0..clip.frame_count()).map(|frame| clip.row(frame)));
        let values: Vec<f64> = rows.cycle().take(FRAMES).flatten().copied().collect();
        let (labels, others) = others(&Clip::new(clips[0].joints().to_vec(), clips[0].frame_time(), values));
        assert!(labels >= 6 * FRAMES && others * 10_000 <= labels, "{person}: {others} of {labels} labels");
    }
}
