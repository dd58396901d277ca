//! Reading of and detection in recorded files of many programs.

use std::path::Path;
use std::sync::Arc;

use plantigrade::bvh::{self, Clip};
use plantigrade::foot::Side;
use plantigrade::plants::{self, DetectError, Feet, Params, ValidParams};
use plantigrade::skeleton::{Overrides, Skeleton};

use crate::support;

/// Files without a pair of feet: a bar, a chain, a trunk, and a body with one leg.
const WITHOUT_FEET: [&str; 4] = [
    "bvh_anim_test_simple.bvh",
    "fairmotion_sinusoidal_no_end_site.bvh",
    "pybvh_full_precision_frame_time.bvh",
    "pybvh_rotation_first_root.bvh",
];

pub fn files_are_read_and_feet_identified(corpus: &Path) {
    let files = support::bvh_files(corpus);
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
                &clip.joints()[skeleton.toe(side).expect("a toe or its replacement")].name.to_lowercase();
            let heel = &clip.joints()[skeleton.heel(side).expect("an ankle")].name.to_lowercase();
            assert!(heel.contains("foot") || heel.contains("ankle"), "{name}: {heel}");
            assert!(toe.contains("toe") || toe.contains("forefoot") || toe == "end site", "{name}: {toe}");
        }
    }
}

pub fn clips_with_motion_and_feet_are_labelled(corpus: &Path) {
    let mut labelled = 0;
    for path in support::bvh_files(corpus) {
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

pub fn written_clips_equal_the_clips_that_were_read(corpus: &Path) {
    for path in support::bvh_files(&corpus.join("dialects")) {
        let clip = support::read(&path).clip;
        let back = bvh::parse(bvh::write(&clip).as_bytes(), bvh::Options::default()).expect("valid BVH").clip;
        if clip.position_rule() == bvh::PositionRule::Replace {
            assert_eq!(back, clip, "{}", path.display());
        }
        // The writer may change the position rule, but not the pose.
        let first = |clip| plantigrade::kinematics::Kinematics::new(clip).pose(0).to_vec();
        for (found, expected) in first(&back).iter().zip(first(&clip)) {
            assert!((found - expected).norm() < 1e-9, "{}", path.display());
        }
    }
}

pub fn unchanged_clips_keep_every_byte_of_their_files(corpus: &Path) {
    for path in support::bvh_files(corpus) {
        let bytes = std::fs::read(&path).expect("a file");
        let bvh::Parsed { clip, layout, .. } = support::read(&path);
        let frames = 0..clip.frame_count();
        let written = bvh::rewrite(&bytes, &layout, &Arc::new(clip), frames);
        assert!(written == bytes, "{}", path.display());
    }
}

/// Maximum relative distance from the threshold of a decision value whose label differs.
const MAX_DISTANCE: f64 = 1e-3;

/// Returns the number of labels and the number of those that differ from the labels by all pairs.
/// Only labels of samples near the threshold may differ.
fn count_differences(clip: &Clip) -> (usize, usize) {
    let Ok(feet) = Feet::new(clip, &Skeleton::main(clip, &Overrides::default())) else { return (0, 0) };
    let [by_cells, by_pairs] = [false, true]
        .map(|exact| plants::detect(&feet, Params { exact, ..Params::default() }.check().unwrap()));
    let (mut labels, mut differences) = (0, 0);
    for (by_cells, by_pairs) in by_cells.parts.iter().zip(&by_pairs.parts) {
        assert_eq!(by_cells.evidence.is_some(), by_pairs.evidence.is_some());
        for (approximate, exact) in by_cells.evidence.iter().zip(&by_pairs.evidence) {
            for (a, b) in approximate.values.iter().zip(&exact.values) {
                let [a, b] = [a, b].map(|value| f64::from(*value));
                let differs = (a > approximate.threshold) != (b > exact.threshold);
                let distance = (b / exact.threshold - 1.0).abs();
                assert!(!differs || distance < MAX_DISTANCE, "{b} {}", exact.threshold);
            }
        }
        for (a, b) in by_cells.feet.iter().zip(&by_pairs.feet) {
            labels += a.planted.len();
            differences += a.planted.iter().zip(&b.planted).filter(|(a, b)| a != b).count();
        }
    }
    (labels, differences)
}

pub fn cells_give_long_clips_the_labels_of_all_pairs(corpus: &Path) {
    let clips = support::bvh_files(corpus).into_iter().map(|path| support::read(&path).clip);
    let long = clips.filter(|clip| clip.frame_count() > 1500);
    let counts: Vec<_> = long.map(|clip| count_differences(&clip)).collect();
    assert!(counts.len() >= 3, "only {} clips are long", counts.len());
    let [labels, differences] = [
        counts.iter().map(|(labels, _)| labels).sum::<usize>(),
        counts.iter().map(|(_, differences)| differences).sum(),
    ];
    assert!(differences * 10_000 <= labels, "{differences} of {labels} labels differ");
}

pub fn cells_give_concatenated_clips_the_labels_of_all_pairs(corpus: &Path) {
    const FRAMES: usize = 20_000;
    for person in ["02_", "05_", "86_"] {
        let mut files = support::bvh_files(&corpus.join("cmu"));
        files.retain(|path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(person)));
        let clips: Vec<Clip> = files.iter().map(|path| support::read(path).clip).collect();
        let rows = clips.iter().flat_map(|clip| (0..clip.frame_count()).map(|frame| clip.row(frame)));
        let values: Vec<f64> = rows.cycle().take(FRAMES).flatten().copied().collect();
        let clip = Clip::new(clips[0].joints().to_vec(), clips[0].frame_time(), values);
        let (labels, differences) = count_differences(&clip);
        assert!(labels >= 6 * FRAMES);
        assert!(differences * 10_000 <= labels, "{person}: {differences} of {labels} labels differ");
    }
}
