//! The eight performers.

use plantigrade::bvh::Axis::{X, Y, Z};

use super::{Build, Character, Decimals, Naming, Positions, Unit, Up};
use crate::noise::Noise;

/// The names of the performers.
pub const CAST: [&str; 8] = ["ada", "ben", "chen", "dora", "emil", "fay", "gus", "hana"];

/// The performer called `name`.
///
/// # Panics
/// If no performer of [`CAST`] has that name.
pub fn character(name: &str) -> Character {
    let name = CAST.into_iter().find(|&known| known == name).expect("a performer of the cast");
    // Noise: jitter, slide and float, in millimetres.
    match name {
        "ada" => make(name, Build::new(1.68, 1.0, 0.95), Naming::MotionBuilder, 3, Unit::Centimetre)
            .noise(1.2, 3.0, 2.5),
        "ben" => make(name, Build::new(1.83, 1.02, 1.06), Naming::Biped, 2, Unit::Inch)
            .order([Z, X, Y])
            .noise(2.0, 5.0, 4.0),
        "chen" => make(name, Build::new(1.75, 0.98, 1.0), Naming::MotionBuilder, 2, Unit::Asf)
            .order([Z, Y, X])
            .noise(3.0, 8.0, 6.0),
        "dora" => make(name, Build::new(1.60, 0.99, 0.92), Naming::Suffix, 3, Unit::Metre)
            .order([X, Y, Z])
            .z_up()
            .noise(2.4, 7.0, 5.0),
        "emil" => make(name, Build::new(1.78, 1.03, 1.0), Naming::Mixamo, 3, Unit::Centimetre)
            .order([X, Y, Z])
            .noise(3.4, 9.0, 7.0),
        "fay" => make(name, Build::new(1.64, 1.05, 0.9), Naming::Mixamo, 3, Unit::Metre)
            .order([Y, X, Z])
            .noise(1.8, 5.0, 5.0),
        "gus" => make(name, Build::new(1.74, 0.97, 1.1), Naming::Daz, 2, Unit::Centimetre)
            .order([X, Z, Y])
            .noise(2.6, 8.0, 8.0),
        _ => make(name, Build::new(1.71, 1.0, 1.04), Naming::Suffix, 2, Unit::Inch)
            .order([Y, Z, X])
            .positions(Positions::All)
            .noise(2.2, 6.0, 6.0),
    }
}

fn make(name: &'static str, build: Build, naming: Naming, spine_joints: usize, unit: Unit) -> Character {
    Character {
        name,
        build,
        naming,
        spine_joints,
        unit,
        up: Up::Y,
        rotation_order: [Z, X, Y],
        positions: Positions::Root,
        decimals: Decimals::Enough,
        noise: Noise::default(),
    }
}

impl Character {
    fn order(self, rotation_order: [plantigrade::bvh::Axis; 3]) -> Character {
        Character { rotation_order, ..self }
    }

    fn z_up(self) -> Character {
        Character { up: Up::Z, ..self }
    }

    fn positions(self, positions: Positions) -> Character {
        Character { positions, ..self }
    }

    fn noise(self, jitter: f64, slide: f64, float: f64) -> Character {
        let noise = Noise { jitter: jitter / 1e3, slide: slide / 1e3, float: float / 1e3 };
        Character { noise, ..self }
    }
}
