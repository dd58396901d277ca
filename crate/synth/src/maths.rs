//! Trigonometry and rotations that give the same bits on every machine.
//!
//! The standard library's sine comes from the platform; `libm`'s is one piece of
//! Rust for all. Nothing else here leaves IEEE arithmetic.

use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};

/// A point or direction: x to the left, y up, z forward, in metres.
pub type Vec3 = Vector3<f64>;

/// A rotation.
pub type Rot = UnitQuaternion<f64>;

/// Acceleration of free fall, in m/s².
pub const GRAVITY: f64 = 9.81;

/// The rotation by `angle` radians about the coordinate axis `axis` (0, 1 or 2).
pub fn turn(axis: usize, angle: f64) -> Rot {
    let (sin, cos) = libm::sincos(angle / 2.0);
    let mut vector = Vec3::zeros();
    vector[axis] = sin;
    Unit::new_unchecked(Quaternion::from_parts(cos, vector))
}

/// The rotation that turns forward to `heading`, radians to the left.
pub fn heading(heading: f64) -> Rot {
    turn(1, heading)
}

/// The horizontal unit vector that `heading` points along.
pub fn forward(heading: f64) -> Vec3 {
    let (sin, cos) = libm::sincos(heading);
    Vec3::new(sin, 0.0, cos)
}

/// The horizontal unit vector to the left of `heading`.
pub fn leftward(heading: f64) -> Vec3 {
    let (sin, cos) = libm::sincos(heading);
    Vec3::new(cos, 0.0, -sin)
}

/// The smallest rotation that takes the unit vector `from` to `to`.
pub fn smallest_turn(from: Vec3, to: Vec3) -> Rot {
    let scalar = (1.0 + from.dot(&to)).max(1e-9);
    normalised(Quaternion::from_parts(scalar, from.cross(&to)))
}

/// The rotation whose matrix has these orthonormal columns.
pub fn from_columns(x: Vec3, y: Vec3, z: Vec3) -> Rot {
    let matrix = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, y, z]));
    Rot::from_rotation_matrix(&matrix)
}

/// The rotation `share` of the way from `a` to `b`, along the short arc.
///
/// The chord is divided evenly instead of the arc: exact at 0, ½ and 1.
pub fn between(a: &Rot, b: &Rot, share: f64) -> Rot {
    let sign = if a.coords.dot(&b.coords) < 0.0 { -1.0 } else { 1.0 };
    normalised(a.into_inner() * (1.0 - share) + b.into_inner() * (share * sign))
}

fn normalised(quaternion: Quaternion<f64>) -> Rot {
    Unit::new_unchecked(quaternion / quaternion.coords.dot(&quaternion.coords).sqrt())
}

/// `a` + `share` × (`b` − `a`).
pub fn lerp(a: f64, b: f64, share: f64) -> f64 {
    a + (b - a) * share
}
