//! A hidden Markov model of two Gaussian states (Rabiner 1989), fitted by Baum and Welch's rounds.

use nalgebra::Vector2;

use crate::foot::Part;
use crate::plants::methods::gmm::{Gaussian, Mixture};
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task, gmm};

pub(crate) const METHOD: Entry = Entry {
    name: "hmm",
    title: "Hidden Markov model",
    about: "Two Gaussian states on the logarithms of height and speed that tend to last, fitted to each clip.",
    family: Family::Mixture,
    parts: &[Part::Toe],
    detect,
};

/// Rounds of expectation and maximisation.
const ROUNDS: usize = 15;

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let points = gmm::points(&toes.signals, task.feet.leg);
    let frames = task.feet.frame_count();
    let mut model = Model { states: Mixture::fit(&points), stay: [0.95; 2] };
    let mut feet: [Vec<f64>; 2] = Default::default();
    for _ in 0..ROUNDS {
        let passes = [&points[..frames], &points[frames..]].map(|points| model.pass(points));
        let stays = [0, 1].map(|state| {
            let sum =
                |pick: fn(&Pass, usize) -> f64| passes.iter().map(|pass| pick(pass, state)).sum::<f64>();
            (sum(|pass, state| pass.stays[state]) / sum(|pass, state| pass.leaves[state]).max(1e-9))
                .clamp(0.5, 0.999)
        });
        feet = passes.map(|pass| pass.planted);
        let planted: Vec<f64> = feet.concat();
        let states = Mixture {
            planted: Gaussian::of(&points, |i| planted[i]),
            moving: Gaussian::of(&points, |i| 1.0 - planted[i]),
        };
        model = Model { states, stay: stays };
    }
    let planted: Vec<bool> = feet.iter().flatten().map(|p| *p > 0.5).collect();
    toes.labelled(Part::Toe, &planted, Some(feet), None)
}

/// States 0, planted, and 1, moving.
struct Model {
    states: Mixture,
    /// Probability that a state lasts for another frame.
    stay: [f64; 2],
}

/// What the points of one foot say.
struct Pass {
    /// Probability of being planted per frame.
    planted: Vec<f64>,
    /// Expected number of frames in which a state lasts, and of those in which it could.
    stays: [f64; 2],
    leaves: [f64; 2],
}

impl Model {
    /// Forward and backward over one foot's points.
    fn pass(&self, points: &[Vector2<f64>]) -> Pass {
        let likelihood: Vec<[f64; 2]> = points
            .iter()
            .map(|point| {
                let log = [self.states.planted.log_density(point), self.states.moving.log_density(point)];
                let most = log[0].max(log[1]);
                log.map(|log| (log - most).exp().max(1e-12))
            })
            .collect();
        let step = |from: usize, to: usize| if from == to { self.stay[from] } else { 1.0 - self.stay[from] };
        let normal = |[a, b]: [f64; 2]| [a / (a + b), b / (a + b)];
        let mut forward: Vec<[f64; 2]> = Vec::with_capacity(points.len());
        for here in &likelihood {
            let before = forward.last().copied();
            forward.push(normal([0, 1].map(|to| {
                here[to] * before.map_or(0.5, |before| before[0] * step(0, to) + before[1] * step(1, to))
            })));
        }
        let mut backward = [1.0; 2];
        let mut pass = Pass { planted: vec![0.0; points.len()], stays: [0.0; 2], leaves: [0.0; 2] };
        for frame in (0..points.len()).rev() {
            let both = normal([0, 1].map(|state| forward[frame][state] * backward[state]));
            pass.planted[frame] = both[0];
            let ahead = [0, 1].map(|state| likelihood[frame][state] * backward[state]);
            if let Some(before) = frame.checked_sub(1) {
                let joint = |from: usize, to: usize| forward[before][from] * step(from, to) * ahead[to];
                let total: f64 = (0..4).map(|pair| joint(pair / 2, pair % 2)).sum();
                for state in 0..2 {
                    pass.stays[state] += joint(state, state) / total;
                    pass.leaves[state] += (joint(state, 0) + joint(state, 1)) / total;
                }
            }
            backward = normal([0, 1].map(|from| step(from, 0) * ahead[0] + step(from, 1) * ahead[1]));
        }
        pass
    }
}
