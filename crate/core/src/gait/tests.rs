use nalgebra::{Vector2, Vector3};

use super::*;
use crate::bvh::Axis;
use crate::foot::Side;
use crate::plants::{Edge, Feet, FootTracks};
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
    assert_eq!((on_the_spot.strides, on_the_spot.cadence_steps_per_min), (0, None));
    assert!(on_the_spot.left_out.on_the_spot > 10, "{on_the_spot:?}");
    // Each end cuts off one stride.
    assert_eq!(SYMMETRIC.gait(0.9).strides, 0);
    let (feet, mut planted) = SYMMETRIC.feet(8.0, Up::Y, 1.0);
    for down in [true, false] {
        planted.iter_mut().for_each(|labels| labels.fill(down));
        assert_eq!(Gait::measure(&feet, planted.each_ref().map(Vec::as_slice)).strides, 0);
    }
    // One foot alone hops; two feet that land together jump.
    let (feet, [hops, _]) = SYMMETRIC.feet(8.0, Up::Y, 1.0);
    let never_planted = vec![false; hops.len()];
    for other in [&never_planted, &hops] {
        let gait = Gait::measure(&feet, [&hops, other]);
        assert_eq!((gait.strides, gait.step_time_s, gait.step_length_m), Default::default());
        assert!(gait.left_out.missing_event >= 6, "{gait:?}");
    }
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

#[test]
fn percentages_of_the_gait_cycle_add_up() {
    let gait = Walk { rate: 1000.0, ..SYMMETRIC }.gait(8.0);
    assert_both_near(gait.stance_percent, 60.0, 0.2);
    assert_both_near(gait.swing_percent, 40.0, 0.2);
    // In a walk, one foot's single support is the swing of the other.
    assert_both_near(gait.single_support_percent, 40.0, 0.2);
    assert_both_near(gait.double_support_percent, 20.0, 0.2);
    let run = Walk { stance: [0.35, 0.35], ..SYMMETRIC }.gait(5.0);
    assert_both_near(run.single_support_percent, 35.0, 1e-9);
    assert_both_near(run.double_support_percent, 0.0, 0.0);
}

#[test]
fn instants_between_frames_are_used() {
    // Feet at 30 Hz whose edges are known exactly; the frame rate alone is too coarse for 1 ms.
    let walk = Walk { rate: 30.0, stance: [0.617, 0.583], phase: 0.473, ..SYMMETRIC };
    let (feet, planted) = walk.feet(8.0, Up::Y, 1.0);
    let edges = Side::BOTH.map(|side| {
        let index = side as usize;
        let labels = &planted[index];
        let changes = (1..labels.len()).filter(|&frame| labels[frame] != labels[frame - 1]);
        let exact = |frame: usize| {
            let phase = if side == Side::Left { 0.0 } else { walk.phase } + 0.2;
            let strikes = (0..10).map(|n| f64::from(n) + phase - 1.0);
            let instants = strikes.flat_map(|strike| [strike, strike + walk.stance[index]]);
            let nearest = |time: &f64| (time + 0.5 / walk.rate - frame as f64 / walk.rate).abs();
            let instant = instants.min_by(|a, b| nearest(a).total_cmp(&nearest(b))).unwrap();
            Edge { frame, time: instant, uncertainty: 0.001 }
        };
        changes.map(exact).collect::<Vec<_>>()
    });
    let contacts = [0, 1].map(|index| Contact { planted: &planted[index], edges: &edges[index] });
    let gait = GaitAnalysis::new(&feet, None, contacts, None).gait;
    for (measure, left, right) in [
        (gait.stance_s, 0.617, 0.583),
        (gait.swing_s, 0.383, 0.417),
        (gait.step_time_s, 0.527, 0.473),
        (gait.stride_time_s, 1.0, 1.0),
    ] {
        assert_near(measure.left.map(|spread| spread.mean), left, 1e-9);
        assert_near(measure.right.map(|spread| spread.mean), right, 1e-9);
    }
}

#[test]
fn strides_with_a_missing_event_are_left_out_and_counted() {
    let complete = SYMMETRIC.gait(10.0);
    let (feet, mut planted) = SYMMETRIC.feet(10.0, Up::Y, 1.0);
    // The contact of the right foot around 5 s was not detected.
    let labels = &mut planted[1];
    let middle = (450..600).find(|&frame| labels[frame] && !labels[frame - 1]).unwrap();
    labels[middle..middle + 70].fill(false);
    let contacts = planted.each_ref().map(|labels| Contact::from_frames(labels));
    let GaitAnalysis { gait, steps, .. } = GaitAnalysis::new(&feet, None, contacts, None);
    // Two strides of the right foot become one of 2 s, in which the left foot strikes twice; one stride of
    // the left foot has no strike of the right foot.
    assert_eq!(gait.strides, complete.strides - 3);
    assert_eq!((gait.left_out.missing_event, complete.left_out.missing_event), (2, 0));
    assert_eq!(steps.iter().filter(|step| step.left_out == Some(Omission::MissingEvent)).count(), 2);
    assert_both_near(gait.stance_s, 0.6, 0.01);
    assert_eq!(
        steps.len() + 1,
        GaitAnalysis::new(
            &feet,
            None,
            SYMMETRIC.feet(10.0, Up::Y, 1.0).1.each_ref().map(|labels| Contact::from_frames(labels)),
            None
        )
        .steps
        .len()
    );
}

#[test]
fn ranges_separate_a_walk_from_a_run() {
    let (feet, planted) = SYMMETRIC.feet(10.0, Up::Y, 1.0);
    let contacts = planted.each_ref().map(|labels| Contact::from_frames(labels));
    let whole = GaitAnalysis::new(&feet, None, contacts, None);
    let ranges = [0..500, 500..1000];
    let parts = ranges.clone().map(|range| GaitAnalysis::new(&feet, None, contacts, Some(&[range])));
    for (part, range) in parts.iter().zip(&ranges) {
        assert!(part.steps.iter().all(|step| range.contains(&step.strike_frame)));
        assert_both_near(part.gait.step_length_m, 0.7, 1e-9);
        assert!(part.gait.left_out.cut_off >= 2, "{part:?}");
    }
    let count = |analysis: &GaitAnalysis| analysis.gait.strides;
    assert_eq!(count(&parts[0]) + count(&parts[1]), count(&whole) - 2, "two strides cross the boundary");
    let both = GaitAnalysis::new(&feet, None, contacts, Some(&ranges));
    assert_eq!(count(&both), count(&whole) - 2);
}

#[test]
fn the_belt_distinguishes_treadmill_and_ground() {
    assert_eq!(SYMMETRIC.gait(10.0).belt_m_per_s, None);
    let (mut feet, planted) = SYMMETRIC.feet(10.0, Up::Y, 1.0);
    for tracks in &mut feet.tracks {
        for track in [&mut tracks.ankle, &mut tracks.toe] {
            for (frame, position) in track.iter_mut().enumerate() {
                position.z -= 1.4 * frame as f64 / SYMMETRIC.rate;
            }
        }
    }
    let gait = Gait::measure(&feet, planted.each_ref().map(Vec::as_slice));
    assert_near(gait.belt_m_per_s, 1.4, 0.01);
}

/// Legs that walk along Z with known angles in degrees over the gait cycle.
fn legs_with_angles(walk: &Walk, feet: &Feet, angles: impl Fn(f64) -> [f64; 3]) -> Legs {
    let forward = Vector3::z();
    let sloping_foot = 20_f64.to_radians();
    let legs = Side::BOTH.map(|side| {
        let phase = if side == Side::Left { 0.0 } else { walk.phase };
        let [mut hip, mut knee, mut ankle, mut toe] = [const { Vec::new() }; 4];
        for frame in 0..feet.frame_count() {
            let time = (frame as f64 + 0.5) / walk.rate / STRIDE - phase - 0.2;
            let [hip_angle, knee_angle, ankle_angle] = angles(time - time.floor()).map(f64::to_radians);
            let line =
                |angle: f64, length: f64| length * (angle.sin() * forward - angle.cos() * Vector3::y());
            let shank = hip_angle - knee_angle;
            // The foot is at a right angle to the shank at 0 and slopes down from the ankle.
            let pitch = shank + ankle_angle - sloping_foot;
            let foot = 0.15 * (pitch.cos() * forward + pitch.sin() * Vector3::y());
            let hips = Vector3::new(0.0, 0.9, 0.0);
            let points = [hips, hips + line(hip_angle, 0.4), hips + line(hip_angle, 0.4) + line(shank, 0.4)];
            hip.push(from_y_up(feet.up, points[0]));
            knee.push(from_y_up(feet.up, points[1]));
            ankle.push(from_y_up(feet.up, points[2]));
            toe.push(from_y_up(feet.up, points[2] + foot));
        }
        legs::LegTracks { hip, knee, ankle, toe: Some(toe) }
    });
    Legs { legs }
}

#[test]
fn curves_are_the_joint_angles_over_the_gait_cycle() {
    let angles = |cycle: f64| {
        let wave = (std::f64::consts::TAU * cycle).cos();
        // The sole stays flat in stance: the ankle makes up for the shank.
        let (hip, knee) = (20.0 * wave, 30.0 - 25.0 * wave);
        let shank = hip - knee;
        [hip, knee, if cycle < 0.6 { -shank } else { -shank - 300.0 * (cycle - 0.6) * (1.0 - cycle) }]
    };
    for (up, rate) in [(Up::Y, 100.0), (Up { axis: Axis::Z, negative: false }, 30.0)] {
        let walk = Walk { rate, ..SYMMETRIC };
        let (feet, planted) = walk.feet(8.0, up, 1.0);
        let legs = legs_with_angles(&walk, &feet, angles);
        let contacts = planted.each_ref().map(|labels| Contact::from_frames(labels));
        let analysis = GaitAnalysis::new(&feet, Some(&legs), contacts, None);
        let curves = analysis.curves.unwrap();
        for (joint, (name, sides)) in curves.by_joint().into_iter().enumerate() {
            for curve in [&sides.left, &sides.right] {
                let curve = curve.as_ref().unwrap();
                assert_eq!(curve.mean.len(), CYCLE_POINTS);
                let sd = curve.sd.as_ref().unwrap();
                for (percent, (mean, sd)) in curve.mean.iter().zip(sd).enumerate() {
                    // Strikes of labels alone are known to half a frame.
                    let near = [-0.5, 0.0, 0.5].map(|frames| {
                        let cycle = percent as f64 / 100.0 + frames / rate / STRIDE;
                        angles(cycle - cycle.floor())[joint]
                    });
                    let (low, high) = near
                        .iter()
                        .fold((f64::MAX, f64::MIN), |(low, high), angle| (low.min(*angle), high.max(*angle)));
                    let is_near = *mean > low - 0.3 && *mean < high + 0.3;
                    assert!(is_near, "{name} {percent} %: {mean} not in {low}..{high}");
                    assert!(*sd < 1e-3, "{name} {percent} %: {sd}");
                }
            }
        }
        assert_eq!(curves.knee_flexion.left.unwrap().strides, 7);
    }
}

#[test]
fn there_are_no_curves_without_strides() {
    let walk = Walk { length: 0.3, ..SYMMETRIC };
    let (feet, planted) = walk.feet(8.0, Up::Y, 1.0);
    let legs = legs_with_angles(&walk, &feet, |_| [0.0; 3]);
    let contacts = planted.each_ref().map(|labels| Contact::from_frames(labels));
    assert_eq!(GaitAnalysis::new(&feet, Some(&legs), contacts, None).curves, None);
}
