//! Channel values of a rotation, near the previous values.

use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, Unit, Vector3};

use crate::bvh::{Axis, Channel};
use crate::skate::leg::scaled_axis;

/// Number of steps towards a rotation that the channels of a joint cannot represent exactly.
const GAUSS_NEWTON_STEPS: usize = 4;

/// Sets the rotation channels in `values` (all channels of a joint, in degrees) to `target` or the
/// nearest rotation that the channels can represent. The new values are those nearest to the
/// previous ones, without full turns.
pub(crate) fn set_rotation(channels: &[Channel], values: &mut [f64], target: &Matrix3<f64>) {
    let slots: Vec<(usize, Axis)> = channels
        .iter()
        .enumerate()
        .filter_map(|(slot, channel)| match channel {
            Channel::Rotation(axis) => Some((slot, *axis)),
            Channel::Position(_) | Channel::Scale(_) => None,
        })
        .collect();
    let angles = match slots[..] {
        [(a, i), (b, j), (c, k)] if i != j && j != k && k != i => {
            let last = [a, b, c].map(|slot| values[slot].to_radians());
            nearest_euler_angles(target, [i, j, k].map(Axis::index), last).to_vec()
        }
        _ => approach(&slots, values, target),
    };
    if angles.iter().all(|angle| angle.is_finite()) {
        for ((slot, _), angle) in slots.iter().zip(angles) {
            values[*slot] = angle.to_degrees();
        }
    }
}

/// True if a joint can take any orientation: it has three rotations about different axes.
pub(crate) fn is_ball_joint(channels: &[Channel]) -> bool {
    let has = |axis| channels.contains(&Channel::Rotation(axis));
    let count = channels.iter().filter(|channel| matches!(channel, Channel::Rotation(_))).count();
    count == 3 && Axis::ALL.into_iter().all(has)
}

/// Returns the angles of R(i)·R(j)·R(k), for three different axes, nearest to `last`; in radians.
fn nearest_euler_angles(matrix: &Matrix3<f64>, [i, j, k]: [usize; 3], last: [f64; 3]) -> [f64; 3] {
    use std::f64::consts::{PI, TAU};
    let sign = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
    let at = |row: usize, column: usize| matrix[(row, column)];
    let cos_middle = at(k, k).hypot(at(j, k));
    let middle = (sign * at(i, k)).atan2(cos_middle);
    let first = if cos_middle > 1e-6 {
        let outer = (-sign * at(j, k)).atan2(at(k, k));
        [outer, middle, (-sign * at(i, j)).atan2(at(i, i))]
    } else {
        // Gimbal lock: the first angle is unchanged and the last one determines the rotation.
        let sum = (sign * at(j, i)).atan2(at(j, j));
        [last[0], middle, if sign * middle > 0.0 { sum - last[0] } else { sum + last[0] }]
    };
    let second = [first[0] + PI, PI - first[1], first[2] + PI];
    let unwrapped = |angles: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|n| angles[n] + TAU * ((last[n] - angles[n]) / TAU).round())
    };
    let distance = |angles: &[f64; 3]| (0..3).map(|n| (angles[n] - last[n]).powi(2)).sum::<f64>();
    let [first, second] = [first, second].map(unwrapped);
    if distance(&first) <= distance(&second) { first } else { second }
}

/// Returns the angles nearest to `target` by damped Gauss–Newton steps from the previous values.
fn approach(slots: &[(usize, Axis)], values: &[f64], target: &Matrix3<f64>) -> Vec<f64> {
    let mut angles =
        DVector::from_iterator(slots.len(), slots.iter().map(|&(slot, _)| values[slot].to_radians()));
    for _ in 0..GAUSS_NEWTON_STEPS {
        let mut rotation = Rotation3::identity();
        let mut axes = DMatrix::zeros(3, slots.len());
        for (n, &(_, axis)) in slots.iter().enumerate() {
            let axis = Unit::new_unchecked(Vector3::ith(axis.index(), 1.0));
            axes.set_column(n, &(rotation * axis.into_inner()));
            rotation *= Rotation3::from_axis_angle(&axis, angles[n]);
        }
        let error = scaled_axis(target * rotation.matrix().transpose());
        let normal_matrix = axes.transpose() * &axes + DMatrix::identity(slots.len(), slots.len()) * 1e-6;
        let Some(step) = normal_matrix.lu().solve(&(axes.transpose() * error)) else { break };
        angles += step;
    }
    angles.iter().copied().collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn rotation(channels: &[Channel], values: &[f64]) -> Rotation3<f64> {
        channels.iter().zip(values).fold(Rotation3::identity(), |rotation, (channel, value)| match channel {
            Channel::Rotation(axis) => {
                let axis = Unit::new_unchecked(Vector3::ith(axis.index(), 1.0));
                rotation * Rotation3::from_axis_angle(&axis, value.to_radians())
            }
            Channel::Position(_) | Channel::Scale(_) => rotation,
        })
    }

    fn orders() -> Vec<Vec<Channel>> {
        [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]]
            .map(|order| order.map(|axis| Channel::Rotation(Axis::ALL[axis])).to_vec())
            .to_vec()
    }

    proptest! {
        #[test]
        fn rotations_are_set_near_the_previous_values(
            order in 0_usize..6,
            previous in prop::array::uniform3(-900.0..900.0_f64),
            change in prop::array::uniform3(-0.1..0.1_f64),
            locked in any::<bool>(),
        ) {
            let channels = &orders()[order];
            let mut values = previous;
            if locked {
                values[1] = 90.0;
            }
            let target = Rotation3::new(Vector3::from(change)) * rotation(channels, &values);
            let before = values;
            set_rotation(channels, &mut values, target.matrix());
            let error = (rotation(channels, &values).matrix() - target.matrix()).amax();
            prop_assert!(error < 1e-9, "{error} {before:?} {values:?}");
            prop_assert!(before.iter().zip(values).all(|(a, b)| (a - b).abs() <= 200.0));
            // Setting the same rotation again does not change the values, even in gimbal lock.
            let same = values;
            set_rotation(channels, &mut values, rotation(channels, &same).matrix());
            prop_assert!(same.iter().zip(values).all(|(a, b)| (a - b).abs() < 1e-4), "{same:?} {values:?}");
        }
    }

    #[test]
    fn a_hinge_rotates_as_far_as_it_can() {
        let channels = [Channel::Position(Axis::Y), Channel::Rotation(Axis::X)];
        let mut values = [7.0, 20.0];
        let target = rotation(&channels, &[7.0, 50.0]);
        set_rotation(&channels, &mut values, target.matrix());
        assert!(values[0] == 7.0 && (values[1] - 50.0).abs() < 1e-6, "{values:?}");
        assert!(!is_ball_joint(&channels) && is_ball_joint(&orders()[3]));
    }
}
