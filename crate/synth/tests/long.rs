//! Fast detection on long clips, compared with exact detection.

use plantigrade::plants::{self, Feet, Method, Params};
use plantigrade::skeleton::{Overrides, Skeleton};
use plantigrade_synth::{generate, long_mix};

#[test]
fn fast_labels_match_exact_labels() {
    let clip = generate(&long_mix(10_000, 1.0), 3).clip;
    let feet = Feet::new(&clip, &Skeleton::main(&clip, &Overrides::default())).unwrap();
    for method in [Method::Robust, Method::Paper, Method::FixedSigma] {
        let [fast, exact] = [false, true].map(|exact| {
            plants::detect(&feet, Params { method, exact, ..Params::default() }.check().unwrap())
        });
        for (fast, exact) in fast.parts.iter().zip(&exact.parts) {
            for (fast, exact) in fast.feet.iter().zip(&exact.feet) {
                let differences = fast.planted.iter().zip(&exact.planted).filter(|(a, b)| a != b).count();
                assert!(differences <= 1, "{method}: {differences} of {} frames", feet.frame_count());
            }
        }
    }
}
