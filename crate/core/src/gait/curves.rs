//! Joint angles over the gait cycle: hip, knee and ankle flexion in the sagittal plane of travel.
//!
//! The angles are those of lines between joint centres. They are not clinical angles, which are measured
//! between anatomical frames of pelvis, thigh, shank and foot (Wu et al., Journal of Biomechanics 35(4),
//! 2002): the pelvis does not enter, and rotation and abduction are left out.
//!
//! The sagittal plane of a stride contains the up axis and the horizontal direction of the stride, from
//! heel to heel; forward is the direction in which the feet point. Angles of lines are measured in
//! that plane:
//!
//! - *Hip flexion* is the angle of the thigh (hip to knee) from the vertical, positive with the knee ahead.
//! - *Knee flexion* is the angle between thigh and shank (knee to ankle): 0 for a straight leg.
//! - *Ankle dorsiflexion* is the angle between shank and foot (ankle to toe base) relative to a shank at
//!   right angles to the sole, positive with the toes up. The line of the foot when the sole is flat is
//!   its median in the second quarter of stance, in which the foot is flat in a walk (mid-stance is
//!   12 to 31 % of the gait cycle by Perry and Burnfield, 2010).

use nalgebra::{Vector2, Vector3};
use serde::{Deserialize, Serialize};

use crate::foot::Side;
use crate::gait::Legs;
use crate::gait::footfall::{Footfall, Footfalls};
use crate::gait::legs::LegTracks;
use crate::gait::step::Candidate;
use crate::numeric::{interpolate, stats};
use crate::plants::Feet;

/// Number of points of a curve: one per percent of the gait cycle, from 0 to 100.
pub const CYCLE_POINTS: usize = 101;

/// Joint angles over the gait cycle.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Curves {
    /// Hip flexion.
    pub hip_flexion: SideCurves,
    /// Knee flexion.
    pub knee_flexion: SideCurves,
    /// Ankle dorsiflexion; without curves if the feet have no joint below the ankle.
    pub ankle_dorsiflexion: SideCurves,
}

impl Curves {
    /// Returns the curves by name: `hip_flexion`, `knee_flexion` and `ankle_dorsiflexion`.
    pub fn by_joint(&self) -> [(&'static str, &SideCurves); 3] {
        [
            ("hip_flexion", &self.hip_flexion),
            ("knee_flexion", &self.knee_flexion),
            ("ankle_dorsiflexion", &self.ankle_dorsiflexion),
        ]
    }
}

/// Curves of one angle.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SideCurves {
    /// Left leg; `None` without a stride that counts.
    pub left: Option<Curve>,
    /// Right leg.
    pub right: Option<Curve>,
}

/// One angle over the gait cycle, from foot strike to the next foot strike of the same foot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// Mean over the strides at 0, 1, …, 100 % of the gait cycle, in degrees.
    pub mean: Vec<f64>,
    /// Standard deviation with divisor n − 1, in degrees; `None` for a single stride.
    pub sd: Option<Vec<f64>>,
    /// Number of strides.
    pub strides: usize,
}

/// Angles of one leg at one time, in radians: hip, knee, and the foot's pitch relative to the shank.
type Angles = [f64; 3];

/// Returns the curves of the strides that count.
pub(crate) fn curves(
    feet: &Feet,
    legs: &Legs,
    footfalls: &Footfalls,
    candidates: &[Option<Candidate>],
) -> Option<Curves> {
    let is_counted = |index: &usize| matches!(candidates[*index], Some(Candidate::Counts));
    let counted: Vec<usize> = (0..candidates.len()).filter(is_counted).collect();
    if counted.is_empty() {
        return None;
    }
    let [left, right] = Side::BOTH.map(|side| {
        let strides = counted.iter().map(|&index| (&footfalls.list[index], &footfalls.list[index + 2]));
        let strides: Vec<_> = strides.filter(|(first, _)| first.side == side).collect();
        leg_curves(feet, &legs.legs[side as usize], footfalls, &strides)
    });
    let [[left_hip, left_knee, left_ankle], [right_hip, right_knee, right_ankle]] = [left, right];
    Some(Curves {
        hip_flexion: SideCurves { left: left_hip, right: right_hip },
        knee_flexion: SideCurves { left: left_knee, right: right_knee },
        ankle_dorsiflexion: SideCurves { left: left_ankle, right: right_ankle },
    })
}

/// Returns hip, knee and ankle of one leg over strides, given as their first and last footfalls.
fn leg_curves(
    feet: &Feet,
    leg: &LegTracks,
    footfalls: &Footfalls,
    strides: &[(&Footfall, &Footfall)],
) -> [Option<Curve>; 3] {
    let mut samples: [Vec<Vec<f64>>; 3] = Default::default();
    let mut flat_pitches = Vec::new();
    for (first, last) in strides {
        let plane = SagittalPlane::new(feet, footfalls, first, last);
        let (start, time) = (first.times.start, last.times.start - first.times.start);
        let angles: Vec<Angles> = (0..CYCLE_POINTS)
            .map(|point| {
                let fraction = point as f64 / (CYCLE_POINTS - 1) as f64;
                plane.angles_at(leg, (start + fraction * time) / feet.frame_time)
            })
            .collect();
        for (joint, samples) in samples.iter_mut().enumerate() {
            samples.push(angles.iter().map(|angles| angles[joint].to_degrees()).collect());
        }
        let quarter = first.frames.len() / 4;
        let flat =
            first.frames.start + quarter..(first.frames.start + 2 * quarter).max(first.frames.start + 1);
        flat_pitches.extend(flat.map(|frame| plane.foot_pitch(leg, frame).to_degrees()));
    }
    let [hip, knee, mut ankle] = samples;
    let ankle = leg.toe.as_ref().and_then(|_| {
        let flat = stats::median_high(flat_pitches.into_iter())?;
        ankle.iter_mut().flatten().for_each(|angle| *angle = degrees_around(*angle - flat));
        Curve::new(&ankle)
    });
    [Curve::new(&hip), Curve::new(&knee), ankle]
}

/// Sagittal plane of one stride.
struct SagittalPlane<'a> {
    feet: &'a Feet,
    /// Horizontal unit vector forward, in coordinates with Y up.
    forward: Vector3<f64>,
}

impl SagittalPlane<'_> {
    fn new<'a>(
        feet: &'a Feet,
        footfalls: &Footfalls,
        first: &Footfall,
        last: &Footfall,
    ) -> SagittalPlane<'a> {
        let stride = last.heel - first.heel;
        // A person who walks backward faces against the direction of the stride.
        let ahead = if stride.dot(&(first.heading + last.heading)) < 0.0 { -stride } else { stride };
        let on_slope = footfalls.to_level.inverse() * Vector3::new(ahead.x, 0.0, ahead.y);
        let forward = Vector3::new(on_slope.x, 0.0, on_slope.z).normalize();
        SagittalPlane { feet, forward }
    }

    /// Returns a line between joints as its forward and upward components.
    fn line(&self, from: &Vector3<f64>, to: &Vector3<f64>) -> Vector2<f64> {
        let line = self.feet.up.to_y_up(to - from);
        Vector2::new(line.dot(&self.forward), line.y)
    }

    /// Returns the angle of the foot's line above the horizontal in a frame, in radians.
    fn foot_pitch(&self, leg: &LegTracks, frame: usize) -> f64 {
        let toe = leg.toe.as_ref().unwrap_or(&leg.ankle);
        let foot = self.line(&leg.ankle[frame], &toe[frame]);
        foot.y.atan2(foot.x)
    }

    /// Returns the angles in a frame.
    fn angles(&self, leg: &LegTracks, frame: usize) -> Angles {
        // Angle from straight down, positive forward.
        let from_vertical = |line: Vector2<f64>| line.x.atan2(-line.y);
        let thigh = from_vertical(self.line(&leg.hip[frame], &leg.knee[frame]));
        let shank = from_vertical(self.line(&leg.knee[frame], &leg.ankle[frame]));
        [thigh, wrapped(thigh - shank), wrapped(self.foot_pitch(leg, frame) - shank)]
    }

    /// Returns the angles at a time in fractional frames.
    fn angles_at(&self, leg: &LegTracks, time: f64) -> Angles {
        let last = leg.hip.len() - 1;
        let frame = (time.floor().max(0.0) as usize).min(last);
        let four = [0, 1, 2, 3].map(|offset| self.angles(leg, (frame + offset).saturating_sub(1).min(last)));
        [0, 1, 2].map(|joint| {
            let reference = four[1][joint];
            let offsets = four.map(|angles| wrapped(angles[joint] - reference));
            reference + interpolate::catmull_rom(offsets, time - frame as f64)
        })
    }
}

/// Returns the equivalent angle between −π and π.
fn wrapped(angle: f64) -> f64 {
    angle - std::f64::consts::TAU * (angle / std::f64::consts::TAU).round()
}

/// Returns the equivalent angle between −180 and 180 degrees.
fn degrees_around(angle: f64) -> f64 {
    angle - 360.0 * (angle / 360.0).round()
}

impl Curve {
    /// Returns mean and deviation of strides, rounded to 0.001°; `None` without strides.
    fn new(strides: &[Vec<f64>]) -> Option<Curve> {
        let rounded = |degrees: f64| (degrees * 1e3).round() / 1e3;
        let count = strides.len();
        let mean_at = |point: usize| strides.iter().map(|stride| stride[point]).sum::<f64>() / count as f64;
        let sd_at = |point: usize| {
            let mean = mean_at(point);
            let squares: f64 = strides.iter().map(|stride| (stride[point] - mean).powi(2)).sum();
            (squares / (count - 1) as f64).sqrt()
        };
        (count > 0).then(|| Curve {
            mean: (0..CYCLE_POINTS).map(|point| rounded(mean_at(point))).collect(),
            sd: (count > 1).then(|| (0..CYCLE_POINTS).map(|point| rounded(sd_at(point))).collect()),
            strides: count,
        })
    }
}
