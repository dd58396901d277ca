//! Tests on recorded motion; they are ignored if it is not available.
//!
//! The folder of recorded motion is named by the environment variable `PLANTIGRADE_CORPUS`; the default
//! is `shared/corpus` next to the project's folder.

mod force_plates;
mod points;
mod reading;
#[path = "../support/roughness.rs"]
mod roughness;
mod segments;
mod skate;
#[path = "../support/files.rs"]
mod support;
#[path = "../support/points.rs"]
mod support_points;

use std::path::{Path, PathBuf};

use libtest_mimic::{Arguments, Trial};

/// Declares the tests: functions of the folder of recorded motion.
macro_rules! tests {
    ($($module:ident::$name:ident,)+) => {
        [$((concat!(stringify!($module), "::", stringify!($name)), $module::$name as fn(&Path))),+]
    };
}

fn main() {
    let tests = tests![
        reading::files_are_read_and_feet_identified,
        reading::clips_with_motion_and_feet_are_labelled,
        reading::written_clips_equal_the_clips_that_were_read,
        reading::unchanged_clips_keep_every_byte_of_their_files,
        reading::cells_give_long_clips_the_labels_of_all_pairs,
        reading::cells_give_concatenated_clips_the_labels_of_all_pairs,
        points::points_of_clips_have_the_labels_of_the_clips,
        force_plates::robust_contact_agrees_with_force_plates,
        force_plates::robust_contact_agrees_with_force_plates_on_a_belt,
        force_plates::robust_contact_agrees_with_force_plates_without_root_motion,
        force_plates::paper_method_has_its_reported_accuracy,
        force_plates::robust_toe_plants_agree_with_contact,
        segments::cuts_agree_with_annotated_cuts,
        segments::cuts_are_invariant_to_the_frame_rate,
        segments::motifs_agree_with_the_patent,
        segments::files_are_segmented_or_rejected_with_a_reason,
        skate::cleaned_plants_hardly_slide,
    ];
    let default = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let corpus = std::env::var_os("PLANTIGRADE_CORPUS").map_or(default, PathBuf::from);
    let is_present = corpus.is_dir();
    let trial = |(name, run): (&str, fn(&Path))| {
        let corpus = corpus.clone();
        let test = move || {
            run(&corpus);
            Ok(())
        };
        Trial::test(name, test).with_ignored_flag(!is_present)
    };
    libtest_mimic::run(&Arguments::from_args(), tests.map(trial).into()).exit();
}
