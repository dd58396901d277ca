//! The eight preset characters.

use plantigrade::bvh::Axis::{X, Y, Z};

use super::{Character, Decimals, Naming, PositionChannels, Proportions, Unit, Up};
use crate::noise::Noise;

/// Names of the characters.
pub const CHARACTER_NAMES: [&str; 8] = ["ada", "ben", "chen", "dora", "emil", "fay", "gus", "hana"];

/// Returns the character called `name`.
///
/// # Panics
/// If [`CHARACTER_NAMES`] does not contain the name.
pub fn character(name: &str) -> Character {
    let name = CHARACTER_NAMES.into_iter().find(|&known| known == name).expect("the name of a character");
    // Noise: jitter, slide and float, in millimetres.
    match name {
        "ada" => preset(name, Proportions::new(1.68, 1.0, 0.95), Naming::MotionBuilder, 3, Unit::Centimetre)
            .noise(1.2, 3.0, 2.5),
        "ben" => preset(name, Proportions::new(1.83, 1.02, 1.06), Naming::Biped, 2, Unit::Inch)
            .rotation_order([Z, X, Y])
            .noise(2.0, 5.0, 4.0),
        "chen" => preset(name, Proportions::new(1.75, 0.98, 1.0), Naming::MotionBuilder, 2, Unit::Asf)
            .rotation_order([Z, Y, X])
            .noise(3.0, 8.0, 6.0),
        "dora" => preset(name, Proportions::new(1.60, 0.99, 0.92), Naming::Suffix, 3, Unit::Metre)
            .rotation_order([X, Y, Z])
            .z_up()
            .noise(2.4, 7.0, 5.0),
        "emil" => preset(name, Proportions::new(1.78, 1.03, 1.0), Naming::Mixamo, 3, Unit::Centimetre)
            .rotation_order([X, Y, Z])
            .noise(3.4, 9.0, 7.0),
        "fay" => preset(name, Proportions::new(1.64, 1.05, 0.9), Naming::Mixamo, 3, Unit::Metre)
            .rotation_order([Y, X, Z])
            .noise(1.8, 5.0, 5.0),
        "gus" => preset(name, Proportions::new(1.74, 0.97, 1.1), Naming::Daz, 2, Unit::Centimetre)
            .rotation_order([X, Z, Y])
            .noise(2.6, 8.0, 8.0),
        _ => preset(name, Proportions::new(1.71, 1.0, 1.04), Naming::Suffix, 2, Unit::Inch)
            .rotation_order([Y, Z, X])
            .position_channels(PositionChannels::All)
            .noise(2.2, 6.0, 6.0),
    }
}

fn preset(
    name: &'static str,
    proportions: Proportions,
    naming: Naming,
    spine_joints: usize,
    unit: Unit,
) -> Character {
    Character {
        name,
        proportions,
        naming,
        spine_joints,
        unit,
        up: Up::Y,
        rotation_order: [Z, X, Y],
        position_channels: PositionChannels::Root,
        decimals: Decimals::Compact,
        noise: Noise::default(),
    }
}

impl Character {
    fn rotation_order(self, rotation_order: [plantigrade::bvh::Axis; 3]) -> Character {
        Character { rotation_order, ..self }
    }

    fn z_up(self) -> Character {
        Character { up: Up::Z, ..self }
    }

    fn position_channels(self, position_channels: PositionChannels) -> Character {
        Character { position_channels, ..self }
    }

    fn noise(self, jitter: f64, slide: f64, float: f64) -> Character {
        let noise = Noise { jitter: jitter / 1e3, slide: slide / 1e3, float: float / 1e3 };
        Character { noise, ..self }
    }
}
