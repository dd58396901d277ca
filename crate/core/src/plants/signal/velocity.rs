//! Velocity from positions.

use nalgebra::Vector3;

/// Returns the velocity by central differences, one-sided at the ends.
pub(crate) fn central_difference(track: &[Vector3<f64>], frame_time: f64) -> Vec<Vector3<f64>> {
    let last = track.len().saturating_sub(1);
    (0..track.len())
        .map(|frame| {
            let (from, to) = (frame.saturating_sub(1), (frame + 1).min(last));
            let steps = (to - from).max(1) as f64;
            (track[to] - track[from]) / (steps * frame_time)
        })
        .collect()
}

/// Returns the velocity of the least-squares parabola over `half` frames on either side.
///
/// Savitzky and Golay (1964). Near the ends, the parabola is that of the first or last full window.
/// Windows with fewer than two frames on either side, and tracks shorter than a window, use the
/// central difference.
pub(crate) fn local_quadratic(track: &[Vector3<f64>], half: usize, frame_time: f64) -> Vec<Vector3<f64>> {
    let half = half.min(track.len().saturating_sub(1) / 2);
    if half < 2 {
        return central_difference(track, frame_time);
    }
    // With time relative to the centre of the window, 1, t and t² − mean(t²) are orthogonal.
    let times: Vec<f64> = (0..=2 * half).map(|index| index as f64 - half as f64).collect();
    let sum_of_squares: f64 = times.iter().map(|t| t * t).sum();
    let mean_square = sum_of_squares / times.len() as f64;
    let curvature_basis: Vec<f64> = times.iter().map(|t| t * t - mean_square).collect();
    let curvature_basis_norm: f64 = curvature_basis.iter().map(|b| b * b).sum();
    (0..track.len())
        .map(|frame| {
            let centre = frame.clamp(half, track.len() - 1 - half);
            let window = &track[centre - half..=centre + half];
            let slope: Vector3<f64> = window.iter().zip(&times).map(|(x, t)| x * *t).sum();
            let mut velocity = slope / sum_of_squares;
            if frame != centre {
                let curvature: Vector3<f64> = window.iter().zip(&curvature_basis).map(|(x, b)| x * *b).sum();
                velocity += curvature / curvature_basis_norm * (2.0 * (frame as f64 - centre as f64));
            }
            velocity / frame_time
        })
        .collect()
}

/// Returns the velocity without blurring the instants at which a foot stops or starts.
///
/// A window across such an instant averages motion and rest. Therefore the slope of the straight
/// line through the first or the second half of the window replaces [`local_quadratic`] if it is
/// smaller.
pub(crate) fn edge_preserving(track: &[Vector3<f64>], half: usize, frame_time: f64) -> Vec<Vector3<f64>> {
    let mut velocities = local_quadratic(track, half, frame_time);
    let half = half.min(track.len().saturating_sub(1)).max(1);
    for (start, line) in track.windows(half + 1).enumerate() {
        let slope = slope(line) / frame_time;
        // The line is the second half of its first frame's window and the first half of its last
        // frame's.
        for frame in [start, start + half] {
            if slope.norm_squared() < velocities[frame].norm_squared() {
                velocities[frame] = slope;
            }
        }
    }
    velocities
}

/// Returns the slope per frame of the least-squares line.
fn slope(track: &[Vector3<f64>]) -> Vector3<f64> {
    let centre = (track.len() - 1) as f64 / 2.0;
    let times = (0..track.len()).map(|frame| frame as f64 - centre);
    let sum_of_squares: f64 = times.clone().map(|t| t * t).sum();
    track.iter().zip(times).map(|(x, t)| x * t).sum::<Vector3<f64>>() / sum_of_squares
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn parabolas_are_exact(
            a in -5.0..5.0_f64, b in -5.0..5.0_f64, frames in 5_usize..30, half in 2_usize..8,
        ) {
            let frame_time = 0.01;
            let position = |t: f64| Vector3::new(a * t * t + b * t, b, -a * t);
            let track: Vec<_> = (0..frames).map(|frame| position(frame as f64 * frame_time)).collect();
            for (frame, velocity) in local_quadratic(&track, half, frame_time).iter().enumerate() {
                let expected = Vector3::new(2.0 * a * frame as f64 * frame_time + b, 0.0, -a);
                prop_assert!((velocity - expected).norm() < 1e-9, "{frame}: {velocity} {expected}");
            }
        }
    }

    #[test]
    fn stops_are_not_blurred() {
        // 1 m/s until frame 20, then rest.
        let track: Vec<_> = (0..40).map(|frame| Vector3::x() * f64::from(frame.min(20)) * 0.01).collect();
        let speeds = |velocities: Vec<Vector3<f64>>| velocities.iter().map(|v| v.norm()).collect::<Vec<_>>();
        let blurred = speeds(local_quadratic(&track, 5, 0.01));
        let sharp = speeds(edge_preserving(&track, 5, 0.01));
        assert!(blurred[22] > 0.1 && sharp[20..].iter().all(|&speed| speed < 1e-12));
        assert!(sharp[..16].iter().all(|&speed| (speed - 1.0).abs() < 1e-9));
    }

    #[test]
    fn tracks_of_any_length_have_a_velocity() {
        for frames in 0..12 {
            let track = vec![Vector3::x(); frames];
            assert_eq!(edge_preserving(&track, 4, 0.01), vec![Vector3::zeros(); frames]);
        }
    }

    #[test]
    fn central_difference_is_one_sided_at_the_ends() {
        let track: Vec<_> = [0.0, 1.0, 4.0].map(|x| Vector3::new(x, 0.0, 0.0)).into();
        let speeds: Vec<f64> = central_difference(&track, 0.5).iter().map(|v| v.x).collect();
        assert_eq!(speeds, [2.0, 4.0, 6.0]);
        assert_eq!(central_difference(&track[..1], 0.5), [Vector3::zeros()]);
        assert!(central_difference(&[], 0.5).is_empty());
    }
}
