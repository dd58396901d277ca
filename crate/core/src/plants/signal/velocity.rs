//! Velocity from positions.

use nalgebra::Vector3;

/// Velocity by the central difference; one-sided at the ends.
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

/// Velocity of the parabola that fits the track best over `half` frames to either side.
///
/// Savitzky and Golay (1964); towards the ends, of the parabola that fits the
/// first or last full window. Windows of less than two frames to either side,
/// or tracks shorter than those, use the central difference.
pub(crate) fn local_quadratic(track: &[Vector3<f64>], half: usize, frame_time: f64) -> Vec<Vector3<f64>> {
    let half = half.min(track.len().saturating_sub(1) / 2);
    if half < 2 {
        return central_difference(track, frame_time);
    }
    // With time counted from the window's middle, 1, t and t² − mean(t²) are orthogonal.
    let times: Vec<f64> = (0..=2 * half).map(|index| index as f64 - half as f64).collect();
    let square_sum: f64 = times.iter().map(|t| t * t).sum();
    let square_mean = square_sum / times.len() as f64;
    let bend: Vec<f64> = times.iter().map(|t| t * t - square_mean).collect();
    let bend_sum: f64 = bend.iter().map(|b| b * b).sum();
    (0..track.len())
        .map(|frame| {
            let middle = frame.clamp(half, track.len() - 1 - half);
            let window = &track[middle - half..=middle + half];
            let slope: Vector3<f64> = window.iter().zip(&times).map(|(x, t)| x * *t).sum();
            let mut velocity = slope / square_sum;
            if frame != middle {
                let curve: Vector3<f64> = window.iter().zip(&bend).map(|(x, b)| x * *b).sum();
                velocity += curve / bend_sum * (2.0 * (frame as f64 - middle as f64));
            }
            velocity / frame_time
        })
        .collect()
}

/// Velocity that does not blur the moments in which a foot stops and starts.
///
/// A window that reaches across such a moment takes the foot to be moving when
/// it already stands, or still stands. So where the straight line that fits the
/// first or the second half of the window is flatter than [`local_quadratic`],
/// its slope is taken.
pub(crate) fn edge_preserving(track: &[Vector3<f64>], half: usize, frame_time: f64) -> Vec<Vector3<f64>> {
    let mut velocities = local_quadratic(track, half, frame_time);
    let half = half.min(track.len().saturating_sub(1)).max(1);
    for (start, line) in track.windows(half + 1).enumerate() {
        let slope = slope(line) / frame_time;
        // The line is the second half of its first frame's window and the first half of its last one's.
        for frame in [start, start + half] {
            if slope.norm_squared() < velocities[frame].norm_squared() {
                velocities[frame] = slope;
            }
        }
    }
    velocities
}

/// Slope per frame of the straight line that fits best.
fn slope(track: &[Vector3<f64>]) -> Vector3<f64> {
    let middle = (track.len() - 1) as f64 / 2.0;
    let times = (0..track.len()).map(|frame| frame as f64 - middle);
    let square_sum: f64 = times.clone().map(|t| t * t).sum();
    track.iter().zip(times).map(|(x, t)| x * t).sum::<Vector3<f64>>() / square_sum
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
            let place = |t: f64| Vector3::new(a * t * t + b * t, b, -a * t);
            let track: Vec<_> = (0..frames).map(|frame| place(frame as f64 * frame_time)).collect();
            for (frame, velocity) in local_quadratic(&track, half, frame_time).iter().enumerate() {
                let expected = Vector3::new(2.0 * a * frame as f64 * frame_time + b, 0.0, -a);
                prop_assert!((velocity - expected).norm() < 1e-9, "{frame}: {velocity} {expected}");
            }
        }
    }

    #[test]
    fn a_stop_is_not_blurred() {
        // A metre per second until frame 20, then rest.
        let track: Vec<_> = (0..40).map(|frame| Vector3::x() * f64::from(frame.min(20)) * 0.01).collect();
        let speeds = |velocities: Vec<Vector3<f64>>| velocities.iter().map(|v| v.norm()).collect::<Vec<_>>();
        let blurred = speeds(local_quadratic(&track, 5, 0.01));
        let sharp = speeds(edge_preserving(&track, 5, 0.01));
        assert!(blurred[22] > 0.1 && sharp[20..].iter().all(|&speed| speed < 1e-12));
        assert!(sharp[..16].iter().all(|&speed| (speed - 1.0).abs() < 1e-9));
    }

    #[test]
    fn any_length_has_a_velocity() {
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
