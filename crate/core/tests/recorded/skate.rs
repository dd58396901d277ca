//! Clean-up of recorded motion.

use std::path::Path;

use plantigrade::plants::{self, Feet, ValidParams};
use plantigrade::skate::{self, CleanedPlant, Contacts, Options};
use plantigrade::skeleton::{Overrides, Skeleton};

use crate::roughness::{mean, roughness};
use crate::support;

pub fn cleaned_plants_hardly_slide(corpus: &Path) {
    let mut all: Vec<CleanedPlant> = Vec::new();
    for path in support::bvh_files(&corpus.join("cmu")) {
        if path.file_stem().is_some_and(|name| name == "13_30") {
            continue;
        }
        let clip = support::read(&path).clip;
        let skeleton = Skeleton::main(&clip, &Overrides::default());
        let Ok(feet) = Feet::new(&clip, &skeleton) else { continue };
        let contacts = Contacts::from(&plants::detect(&feet, ValidParams::default()));
        let cleaned = skate::clean(&clip, &skeleton, &contacts, &Options::default()).expect("feet");
        let (acceleration, knee, joint) = roughness(&clip, &cleaned.clip, &skeleton);
        println!(
            "{}: {} of {} constrained, acceleration x {acceleration:.2} ({joint}), knee x {knee:.2}",
            path.file_stem().unwrap_or_default().to_string_lossy(),
            cleaned.constrained_count(),
            cleaned.plants.len()
        );
        all.extend(cleaned.plants);
    }
    let constrained: Vec<&CleanedPlant> = all.iter().filter(|plant| plant.skip_reason.is_none()).collect();
    let before = mean(&constrained.iter().map(|plant| plant.before).collect::<Vec<f64>>());
    let after = mean(&constrained.iter().map(|plant| plant.after).collect::<Vec<f64>>());
    println!(
        "{} of {} constrained, mean slide {:.1} -> {:.4} mm",
        constrained.len(),
        all.len(),
        1e3 * before,
        1e3 * after
    );
    assert!(constrained.len() * 10 >= all.len() * 9);
    assert!(after <= 0.05 * before);
}
