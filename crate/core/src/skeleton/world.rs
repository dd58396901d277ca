//! Which way is up and how long a metre is.

use std::fmt;
use std::str::FromStr;

use nalgebra::Vector3;

use crate::bvh::Axis;

/// The signed axis of the file that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Up {
    /// The axis.
    pub axis: Axis,
    /// Whether its negative end is up.
    pub negative: bool,
}

impl Up {
    /// Y up, as most BVH files have it.
    pub const Y: Up = Up { axis: Axis::Y, negative: false };

    /// The axis nearest to `direction`.
    pub fn nearest(direction: Vector3<f64>) -> Up {
        let axis = Axis::ALL[direction.iamax()];
        Up { axis, negative: direction[axis.index()] < 0.0 }
    }

    /// The height of a position: its coordinate along this axis.
    pub fn height(self, position: &Vector3<f64>) -> f64 {
        let height = position[self.axis.index()];
        if self.negative { -height } else { height }
    }

    /// A position turned so that Y is up, right-handed.
    pub fn to_y_up(self, position: Vector3<f64>) -> Vector3<f64> {
        let [x, y, z] = position.into();
        match (self.axis, self.negative) {
            (Axis::X, false) => Vector3::new(-y, x, z),
            (Axis::X, true) => Vector3::new(y, -x, z),
            (Axis::Y, false) => position,
            (Axis::Y, true) => Vector3::new(x, -y, -z),
            (Axis::Z, false) => Vector3::new(x, z, -y),
            (Axis::Z, true) => Vector3::new(x, -z, y),
        }
    }
}

impl fmt::Display for Up {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let axis = ["x", "y", "z"][self.axis.index()];
        write!(f, "{}{axis}", if self.negative { "-" } else { "" })
    }
}

impl FromStr for Up {
    type Err = String;

    fn from_str(text: &str) -> Result<Up, String> {
        let (negative, name) = text.strip_prefix('-').map_or((false, text), |name| (true, name));
        let axis = match name.to_ascii_lowercase().as_str() {
            "x" => Axis::X,
            "y" => Axis::Y,
            "z" => Axis::Z,
            _ => {
                return Err(format!(
                    "the up axis must be x, y or z, with - before it for down; not {text:?}"
                ));
            }
        };
        Ok(Up { axis, negative })
    }
}

/// Metres from hip joint to sole that a figure is taken to have.
const LEG_METRES: f64 = 0.9;

/// Units that BVH files are written in: metres per unit and name.
const UNITS: [(f64, &str); 6] =
    [(1.0, "m"), (0.01, "cm"), (0.001, "mm"), (0.0254, "in"), (0.3048, "ft"), (0.0564, "ASF unit")];

/// Metres per file unit, for a figure whose legs are `leg` file units from hip joint to sole.
///
/// The nearest known unit is taken where it comes within 10 % of legs of 0.9 m.
pub(crate) fn metres_per_unit(leg: f64) -> f64 {
    let metres = LEG_METRES / leg;
    let off = |unit: f64| (unit / metres - 1.0).abs();
    let nearest = UNITS.iter().map(|&(unit, _)| unit).min_by(|&a, &b| off(a).total_cmp(&off(b)));
    nearest.filter(|&unit| off(unit) <= 0.1).unwrap_or(metres)
}

/// The name of a unit of `metres_per_unit`, if it is a known one.
pub fn unit_name(metres_per_unit: f64) -> Option<&'static str> {
    UNITS.iter().find(|(unit, _)| (unit / metres_per_unit - 1.0).abs() < 1e-9).map(|&(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turning_keeps_hands_and_heights() {
        for axis in Axis::ALL {
            for negative in [false, true] {
                let up = Up { axis, negative };
                let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|unit| up.to_y_up(unit));
                assert_eq!(x.cross(&y), z, "{up}");
                let position = Vector3::new(1.0, 2.0, 3.0);
                assert_eq!(up.to_y_up(position).y, up.height(&position), "{up}");
                assert_eq!(up.to_string().parse(), Ok(up));
            }
        }
        assert!("w".parse::<Up>().is_err());
    }

    #[test]
    fn units_are_recognised_by_leg_length() {
        assert_eq!(metres_per_unit(0.95), 1.0);
        assert_eq!(metres_per_unit(88.0), 0.01);
        assert_eq!(metres_per_unit(16.5), 0.0564);
        assert_eq!(metres_per_unit(3.0), 0.3048);
        assert_eq!(unit_name(0.0254), Some("in"));
        let own = metres_per_unit(60.0);
        assert!((own - 0.015).abs() < 1e-12 && unit_name(own).is_none());
    }
}
