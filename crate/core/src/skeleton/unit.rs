//! Unit of length.

use std::ops::RangeInclusive;

/// Height of the hip joint above the sole of an adult, in metres.
const ADULT_LEG: f64 = 0.9;

/// Standard deviation of the logarithm of the leg length of people who are shorter than the mean adult,
/// children included.
const DEVIATION_BELOW: f64 = 0.33;
/// Standard deviation of the logarithm of the leg length of people who are taller.
const DEVIATION_ABOVE: f64 = 0.15;

/// Logarithm of how much rarer than metres and centimetres a unit is that is not known.
///
/// With this value, legs of 0.45 m in centimetres are those of a child. Chosen with the deviations
/// above on files of fifteen other programs, whose units are known.
const UNKNOWN_UNIT_PENALTY: f64 = 2.25;

/// Leg lengths of people, in metres. No unit is known if none gives a length in this range.
const PEOPLE: RangeInclusive<f64> = 0.3..=1.25;

/// Leg lengths of people that need no notice, in metres.
const ADULTS: RangeInclusive<f64> = 0.6..=1.15;

/// Leg lengths of people that need no notice if the unit is a rare one, in metres.
const MEAN_ADULTS: RangeInclusive<f64> = 0.8..=1.07;

/// Leg length of an animal with four legs in a known unit, in metres.
const ANIMALS: RangeInclusive<f64> = 0.08..=1.6;

/// Units that may replace the one of a file, in metres.
pub const LIMITS: RangeInclusive<f64> = 1e-6..=1e6;

/// Units of BVH files: metres per unit, name, and the logarithm of how much rarer than metres and
/// centimetres they are.
const UNITS: [(f64, &str, f64); 7] = [
    (0.01, "cm", 0.0),
    (1.0, "m", 0.0),
    (0.001, "mm", 0.0),
    (0.1, "dm", 1.0),
    (0.0254, "in", 1.5),
    (0.3048, "ft", 2.0),
    (0.0564, "CMU/ASF unit", 1.0),
];

/// Assumed unit of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct AssumedUnit {
    pub metres_per_unit: f64,
    /// True if the unit is certain enough to need no notice.
    pub is_certain: bool,
}

/// Returns the unit of a skeleton whose hip joints are `leg` file units above the sole.
///
/// The known unit with the highest probability is used, by the leg lengths of people and the
/// frequency of units. If none is probable, the legs are assumed to be 0.9 m long. Animals have
/// the first unit of a plausible length.
pub(super) fn of_leg(leg: f64, is_animal: bool) -> AssumedUnit {
    let log_probability = |unit: f64, rarity: f64| {
        let deviation = (leg * unit / ADULT_LEG).ln();
        let scale = if deviation < 0.0 { DEVIATION_BELOW } else { DEVIATION_ABOVE };
        -(deviation / scale).powi(2) / 2.0 - rarity
    };
    let is_plausible = |&(unit, _, rarity): &(f64, &str, f64)| {
        PEOPLE.contains(&(leg * unit)) && log_probability(unit, rarity) > -UNKNOWN_UNIT_PENALTY
    };
    let best = if is_animal {
        UNITS.iter().find(|(unit, ..)| ANIMALS.contains(&(leg * unit)))
    } else {
        let people = UNITS.iter().filter(|unit| is_plausible(unit));
        people.max_by(|a, b| log_probability(a.0, a.2).total_cmp(&log_probability(b.0, b.2)))
    };
    match best {
        Some(&(unit, _, rarity)) => {
            let adults = if rarity == 0.0 { ADULTS } else { MEAN_ADULTS };
            AssumedUnit { metres_per_unit: unit, is_certain: adults.contains(&(leg * unit)) && !is_animal }
        }
        None => AssumedUnit { metres_per_unit: ADULT_LEG / leg, is_certain: false },
    }
}

/// Returns the name of a unit of `metres_per_unit`, if it is a known one.
pub fn unit_name(metres_per_unit: f64) -> Option<&'static str> {
    UNITS.iter().find(|(unit, ..)| (unit / metres_per_unit - 1.0).abs() < 1e-9).map(|&(_, name, _)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_recognised_by_leg_length() {
        let unit = |leg| of_leg(leg, false).metres_per_unit;
        assert_eq!(unit(0.95), 1.0);
        assert_eq!(unit(88.0), 0.01);
        assert_eq!(unit(16.5), 0.0564);
        assert_eq!(unit(3.0), 0.3048);
        assert_eq!(unit(35.0), 0.0254);
        assert_eq!(unit(42.0), 0.0254);
        assert_eq!(unit(9.2), 0.1);
        assert_eq!(unit(900.0), 0.001);
        assert_eq!(unit_name(0.0254), Some("in"));
    }

    #[test]
    fn short_legs_in_centimetres_are_those_of_children() {
        for leg in [45.0, 50.0, 60.0, 70.0, 110.0] {
            assert_eq!(of_leg(leg, false).metres_per_unit, 0.01, "{leg}");
        }
        assert_eq!(of_leg(0.55, false).metres_per_unit, 1.0);
        assert!(!of_leg(0.55, false).is_certain && of_leg(0.85, false).is_certain);
    }

    #[test]
    fn unknown_units_assume_legs_of_an_adult() {
        let other = of_leg(5.0, false);
        assert!((other.metres_per_unit - 0.18).abs() < 1e-12 && !other.is_certain);
        assert!(unit_name(other.metres_per_unit).is_none());
    }

    #[test]
    fn animals_are_not_scaled_as_humans() {
        assert_eq!(of_leg(52.0, true).metres_per_unit, 0.01);
        assert_eq!(of_leg(0.4, true).metres_per_unit, 1.0);
    }
}
