use nalgebra::Vector3;

use super::*;
use crate::bvh::Axis;
use crate::plants::FootTracks;
use crate::skeleton::Up;

/// A walk along a line or a curve, known to the frame: each foot stands for `stance` of the
/// `stride` seconds, and is put down `width` metres from the way.
struct Walk {
    rate: f64,
    stance: [f64; 2],
    /// When the right foot strikes after the left one, as a share of the stride.
    phase: f64,
    width: f64,
    /// Radius of the way, to the left.
    radius: Option<f64>,
    /// Metres from stride to stride.
    length: f64,
}

const STRIDE: f64 = 1.0;
const EVEN: Walk =
    Walk { rate: 100.0, stance: [0.6, 0.6], phase: 0.5, width: 0.06, radius: None, length: 1.4 };

impl Walk {
    /// The place beside the way, `ahead` metres along it, and the way's direction: (x, z).
    fn place(&self, ahead: f64, left: f64) -> (Vector2<f64>, Vector2<f64>) {
        let Some(radius) = self.radius else { return (Vector2::new(left, ahead), Vector2::y()) };
        let (sin, cos) = (ahead / radius).sin_cos();
        (Vector2::new(radius - (radius - left) * cos, (radius - left) * sin), Vector2::new(sin, cos))
    }

    /// Tracks in file units and axes, with labels.
    fn feet(&self, seconds: f64, up: Up, unit: f64) -> (Feet, [Vec<bool>; 2]) {
        let frames = (seconds * self.rate) as usize;
        let mut planted = [Vec::new(), Vec::new()];
        let tracks = Side::BOTH.map(|side| {
            let mut foot = FootTracks { ankle: Vec::new(), toe: Vec::new(), tip: None };
            for frame in 0..frames {
                let side_phase = if side == Side::Left { 0.0 } else { self.phase };
                // Half a frame on, so that no strike falls onto a frame.
                let time = (frame as f64 + 0.5) / self.rate / STRIDE - side_phase - 0.2;
                let (count, into) = (time.floor(), time - time.floor());
                let stance = self.stance[side as usize];
                let swung = ((into - stance) / (1.0 - stance)).max(0.0);
                planted[side as usize].push(into < stance);
                let left = if side == Side::Left { self.width } else { -self.width };
                let (place, ahead) = self.place((count + swung + side_phase) * self.length, left);
                let toe = place + 0.13 * ahead;
                // The heel is off the ground from mid-stance on.
                let heel = if into > 0.4 { place + 0.05 * ahead } else { place };
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

/// The other way of [`Up::to_y_up`], whose turns are quarter ones.
fn from_y_up(up: Up, position: Vector3<f64>) -> Vector3<f64> {
    let columns = Axis::ALL.map(|axis| up.to_y_up(Vector3::ith(axis.index(), 1.0)));
    nalgebra::Matrix3::from_columns(&columns).transpose() * position
}

fn near(found: Option<f64>, expected: f64, within: f64) {
    assert!(found.is_some_and(|found| (found - expected).abs() <= within), "{found:?}, not {expected}");
}

fn both(measure: PerSide, expected: f64, within: f64) {
    for side in [measure.left, measure.right] {
        near(side.map(|spread| spread.mean), expected, within);
        near(side.and_then(|spread| spread.sd), 0.0, within);
    }
}

#[test]
fn a_walk_is_measured_whatever_its_axes_unit_and_rate() {
    for (axis, negative) in [(Axis::Y, false), (Axis::Z, false), (Axis::X, true), (Axis::Z, true)] {
        for (unit, rate) in [(1.0, 100.0), (0.01, 30.0), (0.0254, 240.0)] {
            let (feet, planted) = Walk { rate, ..EVEN }.feet(8.0, Up { axis, negative }, unit);
            let gait = Gait::measure(&feet, planted.each_ref().map(Vec::as_slice));
            let frame = 1.0 / rate;
            near(gait.cadence_steps_per_min, 120.0, 1e-9);
            near(gait.speed_m_per_s, 1.4, 1e-9);
            both(gait.stance_s, 0.6, frame);
            both(gait.swing_s, 0.4, frame);
            both(gait.step_time_s, 0.5, frame);
            both(gait.stride_time_s, 1.0, 1e-9);
            both(gait.stride_length_m, 1.4, 1e-9);
            both(gait.step_length_m, 0.7, 1e-9);
            both(gait.step_width_m, 0.12, 1e-9);
            near(gait.double_support_share.map(|spread| spread.mean), 0.2, 2.0 * frame);
            near(gait.flight_s.map(|spread| spread.mean), 0.0, 0.0);
            near(gait.symmetry.stance_percent, 0.0, 1e-6);
        }
    }
}

#[test]
fn curves_widen_no_step() {
    for radius in [2.0, -2.0] {
        let gait = Walk { radius: Some(radius), ..EVEN }.gait(8.0);
        // Chords of the arcs, and the difference of the radii seen half a step off.
        let turn: f64 = 0.35 / radius;
        both(gait.step_length_m, 2.0 * (radius * turn.sin()).abs(), 1e-9);
        both(gait.step_width_m, 0.12 * turn.cos(), 1e-9);
    }
}

#[test]
fn a_limp_shows_on_its_side() {
    // The left foot is spared: it stands for less, and the right one hurries to land.
    let gait = Walk { stance: [0.5, 0.7], phase: 0.4, ..EVEN }.gait(8.0);
    near(gait.symmetry.stance_percent, 100.0 * 0.2 / 0.6, 0.1);
    near(gait.symmetry.swing_percent, -100.0 * 0.2 / 0.4, 0.1);
    near(gait.symmetry.step_time_percent, 100.0 * -0.2 / 0.5, 0.1);
    near(gait.symmetry.step_length_percent, 100.0 * -0.2 / 0.5, 1e-6);
}

#[test]
fn a_run_has_flight_for_double_support() {
    let gait = Walk { stance: [0.35, 0.35], ..EVEN }.gait(5.0);
    near(gait.double_support_share.map(|spread| spread.mean), 0.0, 0.0);
    near(gait.flight_share.map(|spread| spread.mean), 0.3, 1e-9);
}

#[test]
fn what_is_no_gait_measures_nothing() {
    let on_the_spot = Walk { length: 0.3, ..EVEN }.gait(8.0);
    assert_eq!(on_the_spot, Gait::default());
    // One stride is cut by either end.
    assert_eq!(EVEN.gait(0.9).strides, 0);
    let (feet, mut planted) = EVEN.feet(8.0, Up::Y, 1.0);
    for down in [true, false] {
        planted.iter_mut().for_each(|labels| labels.fill(down));
        assert_eq!(Gait::measure(&feet, planted.each_ref().map(Vec::as_slice)), Gait::default());
    }
    // One foot alone hops; two that land together jump.
    let (feet, [hops, _]) = EVEN.feet(8.0, Up::Y, 1.0);
    let never = vec![false; hops.len()];
    assert_eq!(Gait::measure(&feet, [&hops, &never]), Gait::default());
    assert_eq!(Gait::measure(&feet, [&hops, &hops]), Gait::default());
    let (empty, _) = EVEN.feet(0.0, Up::Y, 1.0);
    assert_eq!(Gait::measure(&empty, [&[], &[]]), Gait::default());
}

#[test]
fn a_stand_is_no_stance() {
    let (mut feet, mut planted) = EVEN.feet(9.0, Up::Y, 1.0);
    // Both feet stay where they are from the third second to the sixth.
    for (foot, labels) in feet.tracks.iter_mut().zip(&mut planted) {
        for track in [&mut foot.ankle, &mut foot.toe] {
            let stood = track[300];
            track[300..600].fill(stood);
        }
        labels[300..600].fill(true);
    }
    let gait = Gait::measure(&feet, planted.each_ref().map(Vec::as_slice));
    assert!(gait.strides > 6, "{gait:?}");
    both(gait.stance_s, 0.6, 0.1);
    near(gait.double_support_share.map(|spread| spread.mean), 0.2, 0.05);
}

#[test]
fn measures_survive_json() {
    let gait = EVEN.gait(5.0);
    let text = serde_json::to_string(&gait).unwrap();
    assert_eq!(serde_json::from_str::<Gait>(&text).unwrap(), gait);
}
