//! Positions to which planted feet are constrained.

use std::ops::Range;

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::numeric::stats::median_low;
use crate::plants::{self, Ground};
use crate::skate::blend;
use crate::skate::leg::{Leg, scaled_axis, smallest_rotation};
use crate::skate::phases::{Phase, runs};
use crate::skeleton::Up;

/// Maximum rotation of a flat foot from its mean orientation that is removed, in radians.
const MAX_ROTATION: f64 = 0.8;

/// One foot with its plants.
pub(crate) struct Planted<'a> {
    /// Phase of the foot in each frame.
    pub phases: &'a [Phase],
    /// Frame ranges of the plants.
    pub plants: &'a [Range<usize>],
    /// True for each plant to be constrained.
    pub is_constrained: &'a [bool],
    /// Position of the heel relative to the ankle, in the ankle's axes.
    pub heel: Vector3<f64>,
}

/// Correction that constrains a foot to fixed positions.
pub(crate) struct Correction {
    /// Displacement of the ankle per frame, in file units.
    pub ankle: Vec<Vector3<f64>>,
    /// Rotation of the foot per frame, as axis times angle in the file's axes.
    pub foot: Vec<Vector3<f64>>,
    /// Position to which each plant is constrained: of the toe, or of the heel if the toe is never
    /// planted.
    pub positions: Vec<Option<Vector3<f64>>>,
}

/// Options of the clean-up in frames and file units.
pub(crate) struct Settings {
    pub up: Up,
    /// Leg length.
    pub length: f64,
    /// Frames over which a correction fades in or out.
    pub window: usize,
    /// Half-width of the window that smooths the ankle while the foot rolls over its toe, in
    /// frames.
    pub ankle_half_width: usize,
    /// True if plants are moved to common levels of the ground.
    pub level: bool,
    pub ground: Ground,
}

/// Frame range in which the toe is at a fixed position.
struct Hold {
    frames: Range<usize>,
    toe: Vector3<f64>,
}

impl Planted<'_> {
    /// Returns the plants to be constrained.
    fn constrained(&self) -> impl Iterator<Item = &Range<usize>> {
        self.plants
            .iter()
            .zip(self.is_constrained)
            .filter(|(_, constrained)| **constrained)
            .map(|(plant, _)| plant)
    }

    /// Returns true for each frame in which the foot is constrained.
    pub fn constrained_frames(&self) -> Vec<bool> {
        let mut constrained = vec![false; self.phases.len()];
        for plant in self.constrained() {
            constrained[plant.clone()].fill(true);
        }
        constrained
    }

    /// Returns the corrections that constrain the plants, blended between them.
    pub fn correction(&self, leg: &Leg, settings: &Settings) -> Correction {
        let mut foot = self.flat_rotations(leg, settings);
        let rotations = foot.iter().map(|rotation| Rotation3::new(*rotation).into_inner()).collect();
        let mut stance = Stance { leg, rotations, heel: self.heel, up: settings.up };
        let mut holds = self.holds(leg, settings);
        let mut ankle = vec![Vector3::zeros(); leg.ankle.len()];
        let mut positions = Vec::new();
        let mut fixed = Vec::new();
        for (plant, &is_constrained) in self.plants.iter().zip(self.is_constrained) {
            fixed.push(plant.clone());
            if !is_constrained {
                // The foot stays where it is, even if hips or corrections nearby move.
                foot[plant.clone()].fill(Vector3::zeros());
                positions.push(None);
                continue;
            }
            let first = holds.partition_point(|hold| hold.frames.start < plant.start);
            let last = holds.partition_point(|hold| hold.frames.start < plant.end);
            let holds_in_plant = &mut holds[first..last];
            stance.align_holds(holds_in_plant);
            for hold in &*holds_in_plant {
                for frame in hold.frames.clone() {
                    ankle[frame] = stance.ankle_under(hold.toe, frame) - leg.ankle[frame];
                }
            }
            let mut from = plant.start;
            for hold in &*holds_in_plant {
                stance.hold_heel(from..hold.frames.start, plant, &mut ankle);
                from = hold.frames.end;
            }
            stance.hold_heel(from..plant.end, plant, &mut ankle);
            for run in runs(self.phases, plant, |phase| phase == Phase::Toe) {
                stance.smooth_ankle(run, plant, settings.ankle_half_width, &mut ankle);
            }
            for frame in plant.clone() {
                foot[frame] = scaled_axis(stance.rotations[frame]);
            }
            let heel = || leg.ankle[plant.start] + ankle[plant.start] + stance.heel_at(plant.start);
            positions.push(Some(holds_in_plant.first().map_or_else(heel, |hold| hold.toe)));
        }
        blend::fill(&mut ankle, &fixed, settings.window);
        blend::fill(&mut foot, &fixed, settings.window);
        Correction { ankle, foot, positions }
    }

    /// Returns the rotations that give a flat foot its mean orientation.
    fn flat_rotations(&self, leg: &Leg, settings: &Settings) -> Vec<Vector3<f64>> {
        let mut rotations = vec![Vector3::zeros(); leg.ankle.len()];
        let mut fixed = Vec::new();
        for plant in self.constrained() {
            for run in runs(self.phases, plant, |phase| phase == Phase::Flat) {
                let sum = run.clone().map(|frame| leg.foot[frame]).sum::<Matrix3<f64>>();
                let first = Rotation3::from_matrix_unchecked(leg.foot[run.start]);
                let mean = Rotation3::from_matrix_eps(&sum, 1e-12, 64, first);
                let to_mean: Vec<Vector3<f64>> = run
                    .clone()
                    .map(|frame| scaled_axis(mean.matrix() * leg.foot[frame].transpose()))
                    .collect();
                if to_mean.iter().all(|rotation| rotation.norm() <= MAX_ROTATION) {
                    rotations[run.clone()].copy_from_slice(&to_mean);
                    fixed.push(run);
                }
            }
        }
        blend::fill(&mut rotations, &fixed, settings.window);
        rotations
    }

    /// Returns the fixed positions of the toe: its median, on the ground.
    fn holds(&self, leg: &Leg, settings: &Settings) -> Vec<Hold> {
        let (up, up_direction) = (settings.up, settings.up.vector());
        let all = self.constrained().flat_map(|plant| runs(self.phases, plant, Phase::has_toe));
        let mut holds: Vec<Hold> = all
            .map(|frames| {
                let median_coordinate =
                    |axis: usize| median_low(frames.clone().map(|frame| leg.toe[frame][axis]));
                let mut toe = Vector3::from_fn(|axis, _| median_coordinate(axis).unwrap_or_default());
                // The ground height is most accurate while the foot is flat.
                let flat = frames.clone().filter(|&frame| self.phases[frame] == Phase::Flat);
                if let Some(height) = median_low(flat.map(|frame| up.height(&leg.toe[frame]))) {
                    toe += up_direction * (height - up.height(&toe));
                }
                Hold { frames, toe }
            })
            .collect();
        if settings.level {
            let heights: Vec<f64> =
                holds.iter().map(|hold| settings.ground.height_above(&hold.toe, up)).collect();
            let levels = plants::levels(&heights, settings.length);
            for ((hold, height), level) in holds.iter_mut().zip(heights).zip(levels) {
                hold.toe += up_direction * (level - height);
            }
        }
        holds
    }
}

/// A foot with its rotations, and the resulting positions of ankle, heel and toe.
struct Stance<'a> {
    leg: &'a Leg,
    /// Rotation of the foot from its original orientation, per frame.
    rotations: Vec<Matrix3<f64>>,
    heel: Vector3<f64>,
    up: Up,
}

impl Stance<'_> {
    /// Returns the position of the ankle if the toe is at `toe`.
    fn ankle_under(&self, toe: Vector3<f64>, frame: usize) -> Vector3<f64> {
        toe - self.rotations[frame] * self.leg.sole(frame)
    }

    /// Returns the vector from the ankle to the heel.
    fn heel_at(&self, frame: usize) -> Vector3<f64> {
        self.rotations[frame] * self.leg.foot[frame] * self.heel
    }

    /// Moves each hold horizontally so that the heel, which bears weight in between, remains at
    /// the position of the previous hold.
    fn align_holds(&self, holds: &mut [Hold]) {
        let up_direction = self.up.vector();
        for n in 1..holds.len() {
            let (last, first) = (holds[n - 1].frames.end - 1, holds[n].frames.start);
            let heel = self.ankle_under(holds[n - 1].toe, last) + self.heel_at(last);
            let offset = heel - self.ankle_under(holds[n].toe, first) - self.heel_at(first);
            holds[n].toe += offset - up_direction * up_direction.dot(&offset);
        }
    }

    /// Smooths the correction of the ankle in `run`, frames of `plant` in which only the toe is
    /// planted, because recorded feet jitter more than ankles. The foot rotates about the toe to
    /// compensate.
    fn smooth_ankle(
        &mut self,
        run: Range<usize>,
        plant: &Range<usize>,
        half: usize,
        ankle: &mut [Vector3<f64>],
    ) {
        let leg = self.leg;
        if leg.is_point() {
            return;
        }
        let original = ankle[plant.clone()].to_vec();
        for frame in run.clone() {
            // The frames before and after the run remain unchanged.
            let before = if run.start > plant.start { frame + 1 - run.start } else { half };
            let after = if run.end < plant.end { run.end - frame } else { half };
            let half = half.min(before).min(after);
            let window = frame.saturating_sub(half).max(plant.start)..(frame + half + 1).min(plant.end);
            let smoothed = fitted_line(
                &original[window.start - plant.start..window.end - plant.start],
                frame - window.start,
            );
            let sole = self.rotations[frame] * leg.sole(frame);
            let toe = leg.ankle[frame] + ankle[frame] + sole;
            let target = toe - leg.ankle[frame] - smoothed;
            let rotation = smallest_rotation(sole, target);
            self.rotations[frame] = rotation.matrix() * self.rotations[frame];
            ankle[frame] = toe - rotation * sole - leg.ankle[frame];
        }
    }

    /// Corrects the ankle so that in `frames`, a part of `plant`, the heel stays at its position in
    /// the frames before and after, or at its mean position.
    ///
    /// Horizontally only: the height of the heel follows the original motion.
    fn hold_heel(&self, frames: Range<usize>, plant: &Range<usize>, ankle: &mut [Vector3<f64>]) {
        let up_direction = self.up.vector();
        let before = |frame: usize| self.leg.ankle[frame] + self.leg.foot[frame] * self.heel;
        let after = |frame: usize| self.leg.ankle[frame] + ankle[frame] + self.heel_at(frame);
        let height_change = |frame: usize| self.up.height(&after(frame)) - self.up.height(&before(frame));
        let start = (frames.start > plant.start).then(|| frames.start - 1);
        let end = (frames.end < plant.end).then_some(frames.end);
        let mean = || frames.clone().map(before).sum::<Vector3<f64>>() / frames.len().max(1) as f64;
        let position = start.or(end).map_or_else(mean, after);
        let (from, to) = (start.or(end).map_or(0.0, height_change), end.or(start).map_or(0.0, height_change));
        for frame in frames.clone() {
            let fraction = (frame - frames.start + 1) as f64 / (frames.len() + 1) as f64;
            let height = self.up.height(&before(frame)) + from + (to - from) * blend::ease(fraction);
            let target = position + up_direction * (height - self.up.height(&position));
            ankle[frame] = target - self.heel_at(frame) - self.leg.ankle[frame];
        }
    }
}

/// Returns the value at `index` of the least-squares line through evenly spaced values.
fn fitted_line(values: &[Vector3<f64>], index: usize) -> Vector3<f64> {
    let count = values.len() as f64;
    let centre = (count - 1.0) / 2.0;
    let mean = values.iter().sum::<Vector3<f64>>() / count;
    let moment: Vector3<f64> = values.iter().enumerate().map(|(n, value)| value * (n as f64 - centre)).sum();
    let sum_of_squares = count * (count * count - 1.0) / 12.0;
    if sum_of_squares > 0.0 { mean + moment * ((index as f64 - centre) / sum_of_squares) } else { mean }
}
