use nalgebra::Vector3;

use super::*;
use crate::bvh::Axis;
use crate::plants::FootTracks;
use crate::skeleton::Up;

/// A walk along a line or a circle, known to the frame: each foot is in stance for `stance` of
/// `STRIDE`, `width` metres from the centre line.
struct Walk {
    rate: f64,
    stance: [f64; 2],
    /// Time from left to right foot strike, as a fraction of the stride.
    phase: f64,
    width: f64,
    /// Radius of the centre line, which curves to the left.
    radius: Option<f64>,
    /// Stride length, in metres.
    length: f64,
}

const STRIDE: f64 = 1.0;
const SYMMETRIC: Walk =
    Walk { rate: 100.0, stance: [0.6, 0.6], phase: 0.5, width: 0.06, radius: None, length: 1.4 };

impl Walk {
    /// Returns the point `left` metres from the centre line and `ahead` metres along it, with the
    /// direction there: (x, z).
    fn point(&self, ahead: f64, left: f64) -> (Vector2<f64>, Vector2<f64>) {
        let Some(radius) = self.radius else { return (Vector2::new(left, ahead), Vector2::y()) };
        let (sin, cos) = (ahead / radius).sin_cos();
        (Vector2::new(radius - (radius - left) * cos, (radius - left) * sin), Vector2::new(sin, cos))
    }

    /// Returns tracks in file units and axes, with labels.
    fn feet(&self, seconds: f64, up: Up, unit: f64) -> (Feet, [Vec<bool>; 2]) {
        let frames = (seconds * self.rate) as usize;
        let mut planted = [Vec::new(), Vec::new()];
        let tracks = Side::BOTH.map(|side| {
            let mut foot = FootTracks { ankle: Vec::new(), toe: Vec::new(), tip: None };
            for frame in 0..frames {
                let side_phase = if side == Side::Left { 0.0 } else { self.phase };
                // The half frame places strikes between frames.
                let time = (frame as f64 + 0.5) / self.rate / STRIDE - side_phase - 0.2;
                let (count, phase_in_stride) = (time.floor(), time - time.floor());
                let stance = self.stance[side as usize];
                let swung = ((phase_in_stride - stance) / (1.0 - stance)).max(0.0);
                planted[side as usize].push(phase_in_stride < stance);
                let left = if side == Side::Left { self.width } else { -self.width };
                let (point, ahead) = self.point((count + swung + side_phase) * self.length, left);
                let toe = point + 0.13 * ahead;
                // The heel is off the ground from mid-stance.
                let heel = if phase_in_stride > 0.4 { point + 0.05 * ahead } else { point };
                foot.ankle.push(from_y_up(up, Vector3::new(heel.x, 0.08, heel.y)) / unit);
                foot.toe.push(from_y_up(up, Vector3::new(toe.x, 0.02, toe.y)) / unit);
            }
            foot
        });
        let hips = vec![Vector3::zeros(); frames];
        let frame_time = 1.0 / self.rate;
        (Feet { tracks, hips, up, leg: 0.9 / unit, metres_per_unit: unit, frame_time }, planted)
    }

    fn gait(&self, seconds: f64) -> Gait {
        let (feet, planted) = self.feet(seconds, Up::Y, 1.0);
        Gait::measure(&feet, planted.each_ref().map(Vec::as_slice))
    }
}

/// Inverse of [`Up::to_y_up`], whose rotations are quarter turns.
fn from_y_up(up: Up, position: Vector3<f64>) -> Vector3<f64> {
    let columns = Axis::ALL.map(|axis| up.to_y_up(Vector3::ith(axis.index(), 1.0)));
    nalgebra::Matrix3::from_columns(&columns).transpose() * position
}

fn assert_near(actual: Option<f64>, expected: f64, tolerance: f64) {
    assert!(
        actual.is_some_and(|actual| (actual - expected).abs() <= tolerance),
        "{actual:?}, not {expected}"
    );
}

fn assert_both_near(measure: PerSide, expected: f64, tolerance: f64) {
    for side in [measure.left, measure.right] {
        assert_near(side.map(|spread| spread.mean), expected, tolerance);
        assert_near(side.and_then(|spread| spread.sd), 0.0, tolerance);
    }
}

#[test]
fn measures_are_invariant_to_axes_unit_and_rate() {
    for (axis, negative) in [(Axis::Y, false), (Axis::Z, false), (Axis::X, true), (Axis::Z, true)] {
        for (unit, rate) in [(1.0, 100.0), (0.01, 30.0), (0.0254, 240.0)] {
            let (feet, planted) = Walk { rate, ..SYMMETRIC }.feet(8.0, Up { axis, negative }, unit);
            let gait = Gait::measure(&feet, planted.each_ref().map(Vec::as_slice));
            let frame = 1.0 / rate;
            assert_near(gait.cadence_steps_per_min, 120.0, 1e-9);
            assert_near(gait.speed_m_per_s, 1.4, 1e-9);
            assert_both_near(gait.stance_s, 0.6, frame);
            assert_both_near(gait.swing_s, 0.4, frame);
            assert_both_near(gait.step_time_s, 0.5, frame);
            assert_both_near(gait.stride_time_s, 1.0, 1e-9);
            assert_both_near(gait.stride_length_m, 1.4, 1e-9);
            assert_both_near(gait.step_length_m, 0.7, 1e-9);
            assert_both_near(gait.step_width_m, 0.12, 1e-9);
            assert_near(gait.double_support_share.map(|spread| spread.mean), 0.2, 2.0 * frame);
            assert_near(gait.flight_s.map(|spread| spread.mean), 0.0, 0.0);
            assert_near(gait.symmetry.stance_percent, 0.0, 1e-6);
        }
    }
}

#[test]
fn curves_do_not_widen_steps() {
    for radius in [2.0, -2.0] {
        let gait = Walk { radius: Some(radius), ..SYMMETRIC }.gait(8.0);
        // Chords of the arcs, and the difference of the radii half a step away.
        let turn: f64 = 0.35 / radius;
        assert_both_near(gait.step_length_m, 2.0 * (radius * turn.sin()).abs(), 1e-9);
        assert_both_near(gait.step_width_m, 0.12 * turn.cos(), 1e-9);
    }
}

#[test]
fn a_limp_shows_as_asymmetry() {
    // The left foot is spared: its stance is shorter and the right foot lands sooner.
    let gait = Walk { stance: [0.5, 0.7], phase: 0.4, ..SYMMETRIC }.gait(8.0);
    assert_near(gait.symmetry.stance_percent, 100.0 * 0.2 / 0.6, 0.1);
    assert_near(gait.symmetry.swing_percent, -100.0 * 0.2 / 0.4, 0.1);
    assert_near(gait.symmetry.step_time_percent, 100.0 * -0.2 / 0.5, 0.1);
    assert_near(gait.symmetry.step_length_percent, 100.0 * -0.2 / 0.5, 1e-6);
}

#[test]
fn a_run_has_flight_and_no_double_support() {
    let gait = Walk { stance: [0.35, 0.35], ..SYMMETRIC }.gait(5.0);
    assert_near(gait.double_support_share.map(|spread| spread.mean), 0.0, 0.0);
    assert_near(gait.flight_share.map(|spread| spread.mean), 0.3, 1e-9);
}

#[test]
fn other_motion_has_no_measures() {
    let on_the_spot = Walk { length: 0.3, ..SYMMETRIC }.gait(8.0);
    assert_eq!(on_the_spot, Gait::default());
    // Each end cuts off one stride.
    assert_eq!(SYMMETRIC.gait(0.9).strides, 0);
    let (feet, mut planted) = SYMMETRIC.feet(8.0, Up::Y, 1.0);
    for down in [true, false] {
        planted.iter_mut().for_each(|labels| labels.fill(down));
        assert_eq!(Gait::measure(&feet, planted.each_ref().map(Vec::as_slice)), Gait::default());
    }
    // One foot alone hops; two feet that land together jump.
    let (feet, [hops, _]) = SYMMETRIC.feet(8.0, Up::Y, 1.0);
    let never_planted = vec![false; hops.len()];
    assert_eq!(Gait::measure(&feet, [&hops, &never_planted]), Gait::default());
    assert_eq!(Gait::measure(&feet, [&hops, &hops]), Gait::default());
    let (empty, _) = SYMMETRIC.feet(0.0, Up::Y, 1.0);
    assert_eq!(Gait::measure(&empty, [&[], &[]]), Gait::default());
}

#[test]
fn standing_does_not_count_as_stance() {
    let (mut feet, mut planted) = SYMMETRIC.feet(9.0, Up::Y, 1.0);
    // Both feet stay in point from 3 s to 6 s.
    for (foot, labels) in feet.tracks.iter_mut().zip(&mut planted) {
        for track in [&mut foot.ankle, &mut foot.toe] {
            let position = track[300];
            track[300..600].fill(position);
        }
        labels[300..600].fill(true);
    }
    let gait = Gait::measure(&feet, planted.each_ref().map(Vec::as_slice));
    assert!(gait.strides > 6, "{gait:?}");
    assert_both_near(gait.stance_s, 0.6, 0.1);
    assert_near(gait.double_support_share.map(|spread| spread.mean), 0.2, 0.05);
}

#[test]
fn measures_round_trip_through_json() {
    let gait = SYMMETRIC.gait(5.0);
    let text = serde_json::to_string(&gait).unwrap();
    assert_eq!(serde_json::from_str::<Gait>(&text).unwrap(), gait);
}

#[test]
fn measures_on_a_treadmill_are_relative_to_the_belt() {
    let (mut feet, planted) = SYMMETRIC.feet(10.0, Up::Y, 1.0);
    let overground = Gait::measure(&feet, planted.each_ref().map(Vec::as_slice));
    for tracks in &mut feet.tracks {
        for track in [&mut tracks.ankle, &mut tracks.toe] {
            for (frame, position) in track.iter_mut().enumerate() {
                position.z -= 1.4 * frame as f64 / SYMMETRIC.rate;
            }
        }
    }
    let treadmill = Gait::measure(&feet, planted.each_ref().map(Vec::as_slice));
    assert_eq!(treadmill.strides, overground.strides);
    assert_near(treadmill.speed_m_per_s, 1.4, 1e-6);
    let step = |gait: &Gait| gait.step_length_m.left.map(|step| step.mean);
    assert_near(step(&treadmill), step(&overground).unwrap(), 1e-6);
}

#[test]
fn lengths_are_measured_along_the_slope() {
    let (mut feet, planted) = SYMMETRIC.feet(10.0, Up::Y, 1.0);
    let slope = 12_f64.to_radians().tan();
    for tracks in &mut feet.tracks {
        for track in [&mut tracks.ankle, &mut tracks.toe] {
            track.iter_mut().for_each(|position| position.y += slope * position.z);
        }
    }
    let gait = Gait::measure(&feet, planted.each_ref().map(Vec::as_slice));
    assert_near(gait.speed_m_per_s, 1.4 / 12_f64.to_radians().cos(), 1e-3);
}
