//! Up axis.

use std::fmt;
use std::str::FromStr;

use nalgebra::{Matrix3, Vector3};

use crate::bvh::Axis;

/// Signed axis of the file that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Up {
    /// The axis.
    pub axis: Axis,
    /// True if its negative end is up.
    pub negative: bool,
}

impl Up {
    /// Y up, the axis of most BVH files.
    pub const Y: Up = Up { axis: Axis::Y, negative: false };

    /// The six directions; where evidence is equal, the first one counts.
    pub const ALL: [Up; 6] = [
        Up::Y,
        Up { axis: Axis::Z, negative: false },
        Up { axis: Axis::X, negative: false },
        Up { axis: Axis::Y, negative: true },
        Up { axis: Axis::Z, negative: true },
        Up { axis: Axis::X, negative: true },
    ];

    /// Returns the axis nearest to `direction`.
    pub fn nearest(direction: Vector3<f64>) -> Up {
        let axis = Axis::ALL[direction.iamax()];
        Up { axis, negative: direction[axis.index()] < 0.0 }
    }

    /// Returns the height of a position: its coordinate along this axis.
    pub fn height(self, position: &Vector3<f64>) -> f64 {
        let height = position[self.axis.index()];
        if self.negative { -height } else { height }
    }

    /// Returns the unit vector that points up.
    pub fn vector(self) -> Vector3<f64> {
        Vector3::ith(self.axis.index(), if self.negative { -1.0 } else { 1.0 })
    }

    /// Returns the rotation from coordinates with Y up to those of the file: the inverse of
    /// [`Up::to_y_up`].
    pub fn from_y_up(self) -> Matrix3<f64> {
        let rows = [0, 1, 2].map(|axis| self.to_y_up(Vector3::ith(axis, 1.0)).transpose());
        Matrix3::from_rows(&rows)
    }

    /// Returns a position in right-handed coordinates with Y up.
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

/// Text that is not an up axis.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the up axis must be x, y or z, with - before it for down, not {0:?}")]
pub struct UpError(pub String);

impl FromStr for Up {
    type Err = UpError;

    fn from_str(text: &str) -> Result<Up, UpError> {
        let (negative, name) = text.strip_prefix('-').map_or((false, text), |name| (true, name));
        let axis = match name.to_ascii_lowercase().as_str() {
            "x" => Axis::X,
            "y" => Axis::Y,
            "z" => Axis::Z,
            _ => {
                return Err(UpError(text.into()));
            }
        };
        Ok(Up { axis, negative })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversion_preserves_handedness_and_height() {
        for axis in Axis::ALL {
            for negative in [false, true] {
                let up = Up { axis, negative };
                let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|unit| up.to_y_up(unit));
                assert_eq!(x.cross(&y), z, "{up}");
                let position = Vector3::new(1.0, 2.0, 3.0);
                assert_eq!(up.to_y_up(position).y, up.height(&position), "{up}");
                assert_eq!(up.from_y_up() * up.to_y_up(position), position, "{up}");
                assert_eq!(up.from_y_up() * Vector3::y(), up.vector(), "{up}");
                assert_eq!(up.to_string().parse(), Ok(up));
            }
        }
        assert!("w".parse::<Up>().is_err());
    }
}
