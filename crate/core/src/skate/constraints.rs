//! Where planted feet are held.

use std::ops::Range;

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::skate::leg::{Leg, median, scaled_axis, smallest_turn, upright};
use crate::skate::phases::{Phase, runs};
use crate::skate::{blend, ground};
use crate::skeleton::Up;

/// A flat foot that turns farther than this from its mean pose is not held by its heel, in radians.
const TURN: f64 = 0.8;

/// One foot with its plants.
pub(crate) struct Planted {
    /// What it stands on in each frame.
    pub phases: Vec<Phase>,
    /// The runs of frames in which it stands.
    pub plants: Vec<Range<usize>>,
    /// Whether each plant is to be held.
    pub is_held: Vec<bool>,
    /// The heel, in the ankle's axes from the ankle.
    pub heel: Vector3<f64>,
}

/// What has to change for a foot to stand still.
pub(crate) struct Correction {
    /// How far the ankle has to move, per frame, in file units.
    pub ankle: Vec<Vector3<f64>>,
    /// How the foot has to turn, per frame, as axis times angle in the file's axes.
    pub foot: Vec<Vector3<f64>>,
    /// Where each plant is held: the toe, or the heel where the toe never stands.
    pub positions: Vec<Option<Vector3<f64>>>,
}

/// Seconds, units and switches of clean-up, turned into frames and file units.
#[derive(Clone, Copy)]
pub(crate) struct Setting {
    pub up: Up,
    /// Thigh plus shank.
    pub length: f64,
    /// Frames over which a correction comes or goes.
    pub window: usize,
    /// Frames to either side over which the ankle is steadied while the foot rolls over its toe.
    pub steady: usize,
    /// Whether plants are put on common ground.
    pub level: bool,
}

/// A run of frames in which the toe is held, and where.
struct Hold {
    frames: Range<usize>,
    toe: Vector3<f64>,
}

impl Planted {
    /// The corrections that hold the plants and blend between them.
    pub fn correction(&self, leg: &Leg, setting: &Setting) -> Correction {
        let mut foot = self.turns(leg, setting);
        let turned = foot.iter().map(|turn| Rotation3::new(*turn).into_inner()).collect();
        let mut stance = Stance { leg, turned, heel: self.heel, up: setting.up };
        let mut holds = self.holds(leg, setting);
        let mut ankle = vec![Vector3::zeros(); leg.ankle.len()];
        let mut positions = Vec::new();
        let mut held = Vec::new();
        for (plant, &is_held) in self.plants.iter().zip(&self.is_held) {
            if !is_held {
                positions.push(None);
                continue;
            }
            held.push(plant.clone());
            let first = holds.partition_point(|hold| hold.frames.start < plant.start);
            let last = holds.partition_point(|hold| hold.frames.start < plant.end);
            let within = &mut holds[first..last];
            stance.join(within);
            for hold in &*within {
                for frame in hold.frames.clone() {
                    ankle[frame] = stance.ankle_under(hold.toe, frame) - leg.ankle[frame];
                }
            }
            let mut from = plant.start;
            for hold in &*within {
                stance.roll(from..hold.frames.start, plant, &mut ankle);
                from = hold.frames.end;
            }
            stance.roll(from..plant.end, plant, &mut ankle);
            for run in runs(&self.phases, plant, |phase| phase == Phase::Toe) {
                stance.steady(run, plant, setting.steady, &mut ankle);
            }
            for frame in plant.clone() {
                foot[frame] = scaled_axis(stance.turned[frame]);
            }
            let heel = || leg.ankle[plant.start] + ankle[plant.start] + stance.heel_at(plant.start);
            positions.push(Some(within.first().map_or_else(heel, |hold| hold.toe)));
        }
        blend::fill(&mut ankle, &held, setting.window);
        blend::fill(&mut foot, &held, setting.window);
        Correction { ankle, foot, positions }
    }

    /// The turns that keep the flat foot as it stands in the mean.
    fn turns(&self, leg: &Leg, setting: &Setting) -> Vec<Vector3<f64>> {
        let mut turns = vec![Vector3::zeros(); leg.ankle.len()];
        let mut held = Vec::new();
        for (plant, _) in self.plants.iter().zip(&self.is_held).filter(|(_, is_held)| **is_held) {
            for run in runs(&self.phases, plant, |phase| phase == Phase::Flat) {
                let sum = run.clone().map(|frame| leg.foot[frame]).sum::<Matrix3<f64>>();
                let first = Rotation3::from_matrix_unchecked(leg.foot[run.start]);
                let mean = Rotation3::from_matrix_eps(&sum, 1e-12, 64, first);
                let turned =
                    run.clone().map(|frame| scaled_axis(mean.matrix() * leg.foot[frame].transpose()));
                let turned: Vec<Vector3<f64>> = turned.collect();
                if turned.iter().all(|turn| turn.norm() <= TURN) {
                    turns[run.clone()].copy_from_slice(&turned);
                    held.push(run);
                }
            }
        }
        blend::fill(&mut turns, &held, setting.window);
        turns
    }

    /// Where the toe is held: at its middle position, on the ground.
    fn holds(&self, leg: &Leg, setting: &Setting) -> Vec<Hold> {
        let (up, upright) = (setting.up, upright(setting.up));
        let held = self.plants.iter().zip(&self.is_held).filter(|(_, is_held)| **is_held);
        let all = held.flat_map(|(plant, _)| runs(&self.phases, plant, Phase::has_toe));
        let mut holds: Vec<Hold> = all
            .map(|frames| {
                let middle = |axis: usize| median(frames.clone().map(|frame| leg.toe[frame][axis]));
                let mut toe = Vector3::from_fn(|axis, _| middle(axis).unwrap_or_default());
                // What it stands on tells itself best while the foot is flat.
                let flat = frames.clone().filter(|&frame| self.phases[frame] == Phase::Flat);
                if let Some(height) = median(flat.map(|frame| up.height(&leg.toe[frame]))) {
                    toe += upright * (height - up.height(&toe));
                }
                Hold { frames, toe }
            })
            .collect();
        if setting.level {
            let heights: Vec<f64> = holds.iter().map(|hold| up.height(&hold.toe)).collect();
            for (hold, level) in holds.iter_mut().zip(ground::levels(&heights, setting.length)) {
                hold.toe += upright * (level - up.height(&hold.toe));
            }
        }
        holds
    }
}

/// A foot as it will be turned, and what follows for ankle, heel and toe.
struct Stance<'a> {
    leg: &'a Leg,
    /// How the foot is turned from where it was, per frame.
    turned: Vec<Matrix3<f64>>,
    heel: Vector3<f64>,
    up: Up,
}

impl Stance<'_> {
    /// Where the ankle is with the toe at `toe`.
    fn ankle_under(&self, toe: Vector3<f64>, frame: usize) -> Vector3<f64> {
        toe - self.turned[frame] * self.leg.sole(frame)
    }

    /// From the ankle to the heel.
    fn heel_at(&self, frame: usize) -> Vector3<f64> {
        self.turned[frame] * self.leg.foot[frame] * self.heel
    }

    /// Moves each hold level with the ground, so that the heel that the foot stands on in
    /// between is where the hold before has it.
    fn join(&self, holds: &mut [Hold]) {
        let upright = upright(self.up);
        for n in 1..holds.len() {
            let (last, first) = (holds[n - 1].frames.end - 1, holds[n].frames.start);
            let heel = self.ankle_under(holds[n - 1].toe, last) + self.heel_at(last);
            let apart = heel - self.ankle_under(holds[n].toe, first) - self.heel_at(first);
            holds[n].toe += apart - upright * upright.dot(&apart);
        }
    }

    /// Takes the tremble out of the ankle's correction in `run`, frames of `plant` in which the toe
    /// alone stands: recorded feet tremble against their ankles more than ankles do. The foot turns
    /// for it, about the toe where that is.
    fn steady(&mut self, run: Range<usize>, plant: &Range<usize>, half: usize, ankle: &mut [Vector3<f64>]) {
        let leg = self.leg;
        if leg.is_point() {
            return;
        }
        let trembling = ankle[plant.clone()].to_vec();
        for frame in run.clone() {
            // What stands before and after stays as it is.
            let before = if run.start > plant.start { frame + 1 - run.start } else { half };
            let after = if run.end < plant.end { run.end - frame } else { half };
            let half = half.min(before).min(after);
            let window = frame.saturating_sub(half).max(plant.start)..(frame + half + 1).min(plant.end);
            let steady =
                line(&trembling[window.start - plant.start..window.end - plant.start], frame - window.start);
            let sole = self.turned[frame] * leg.sole(frame);
            let toe = leg.ankle[frame] + ankle[frame] + sole;
            let wanted = toe - leg.ankle[frame] - steady;
            let turn = smallest_turn(sole, wanted);
            self.turned[frame] = turn.matrix() * self.turned[frame];
            ankle[frame] = toe - turn * sole - leg.ankle[frame];
        }
    }

    /// Corrects the ankle so that in `frames`, which are part of `plant`, the heel stands where it
    /// does in the frames before and after, or else at its mean position.
    ///
    /// Only level with the ground: it rises and falls as it did.
    fn roll(&self, frames: Range<usize>, plant: &Range<usize>, ankle: &mut [Vector3<f64>]) {
        let upright = upright(self.up);
        let before = |frame: usize| self.leg.ankle[frame] + self.leg.foot[frame] * self.heel;
        let after = |frame: usize| self.leg.ankle[frame] + ankle[frame] + self.heel_at(frame);
        let raised = |frame: usize| self.up.height(&after(frame)) - self.up.height(&before(frame));
        let start = (frames.start > plant.start).then(|| frames.start - 1);
        let end = (frames.end < plant.end).then_some(frames.end);
        let mean = || frames.clone().map(before).sum::<Vector3<f64>>() / frames.len().max(1) as f64;
        let stand = start.or(end).map_or_else(mean, after);
        let (from, to) = (start.or(end).map_or(0.0, raised), end.or(start).map_or(0.0, raised));
        for frame in frames.clone() {
            let share = (frame - frames.start + 1) as f64 / (frames.len() + 1) as f64;
            let height = self.up.height(&before(frame)) + from + (to - from) * blend::ease(share);
            let target = stand + upright * (height - self.up.height(&stand));
            ankle[frame] = target - self.heel_at(frame) - self.leg.ankle[frame];
        }
    }
}

/// The value at `place` of the straight line through evenly spaced values (least squares).
fn line(values: &[Vector3<f64>], place: usize) -> Vector3<f64> {
    let count = values.len() as f64;
    let middle = (count - 1.0) / 2.0;
    let mean = values.iter().sum::<Vector3<f64>>() / count;
    let moment: Vector3<f64> = values.iter().enumerate().map(|(n, value)| value * (n as f64 - middle)).sum();
    let spread = count * (count * count - 1.0) / 12.0;
    if spread > 0.0 { mean + moment * ((place as f64 - middle) / spread) } else { mean }
}
