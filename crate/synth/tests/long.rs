//! Long clips are labelled as if all pairs of their frames had been compared.

use plantigrade::plants::{self, Feet, Method, Params};
use plantigrade::skeleton::{Overrides, Skeleton};
use plantigrade_synth::{generate, long};

#[test]
fn labels_are_those_of_all_pairs() {
    let clip = generate(&long(10_000, 1.0), 3).clip;
    let feet = Feet::new(&clip, &Skeleton::main(&clip, &Overrides::default())).unwrap();
    for method in [Method::Robust, Method::Paper, Method::FixedScale] {
        let [few, all] = [false, true].map(|exact| {
            plants::detect(&feet, Params { method, exact, ..Params::default() }.check().unwrap())
        });
        for (few, all) in few.parts.iter().zip(&all.parts) {
            for (few, all) in few.feet.iter().zip(&all.feet) {
                let others = few.planted.iter().zip(&all.planted).filter(|(few, all)| few != all).count();
                assert!(others <= 1, "{method}, {}: {others}", feet.frame_count());
            }
        }
    }
}
