//! Hidden Markov model with two Gaussian states (Rabiner 1989), fitted by Baum–Welch iterations.

use nalgebra::Vector2;

use crate::foot::Part;
use crate::plants::methods::gmm;
use crate::plants::methods::gmm::{Gaussian, Mixture};
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "hmm",
    title: "Hidden Markov model",
    description: "Hidden Markov model with two Gaussian states on the logarithms of height and speed, fitted to each clip.",
    family: Family::Mixture,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

/// Number of EM iterations.
const ITERATIONS: usize = 15;

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let points = gmm::points(&toes.signals, input.feet.leg);
    let frames = input.feet.frame_count();
    let mut model = Model { states: Mixture::fit(&points), persistence: [0.95; 2] };
    let mut feet: [Vec<f64>; 2] = Default::default();
    for _ in 0..ITERATIONS {
        let posteriors = [&points[..frames], &points[frames..]].map(|points| model.forward_backward(points));
        let persisting = [0, 1].map(|state| {
            let sum = |pick: fn(&Posterior, usize) -> f64| {
                posteriors.iter().map(|posterior| pick(posterior, state)).sum::<f64>()
            };
            (sum(|posterior, state| posterior.persisting[state])
                / sum(|posterior, state| posterior.total_frames[state]).max(1e-9))
            .clamp(0.5, 0.999)
        });
        feet = posteriors.map(|posterior| posterior.planted);
        let planted: Vec<f64> = feet.concat();
        let states = Mixture {
            planted: Gaussian::fit(&points, |i| planted[i]),
            moving: Gaussian::fit(&points, |i| 1.0 - planted[i]),
        };
        model = Model { states, persistence: persisting };
    }
    let planted: Vec<bool> = feet.iter().flatten().map(|p| *p > 0.5).collect();
    toes.into_output(Part::Toe, &planted, Some(feet), None)
}

/// State 0 is planted, state 1 is moving.
struct Model {
    states: Mixture,
    /// Probability that a state persists for another frame.
    persistence: [f64; 2],
}

/// Posterior quantities of one foot.
struct Posterior {
    /// Probability of being planted per frame.
    planted: Vec<f64>,
    /// Expected number of frames in which each state persists, and in which it could.
    persisting: [f64; 2],
    total_frames: [f64; 2],
}

impl Model {
    /// Runs the forward–backward algorithm over the points of one foot.
    fn forward_backward(&self, points: &[Vector2<f64>]) -> Posterior {
        let likelihood: Vec<[f64; 2]> = points
            .iter()
            .map(|point| {
                let log = [self.states.planted.log_density(point), self.states.moving.log_density(point)];
                let max = log[0].max(log[1]);
                log.map(|log| (log - max).exp().max(1e-12))
            })
            .collect();
        let step = |from: usize, to: usize| {
            if from == to { self.persistence[from] } else { 1.0 - self.persistence[from] }
        };
        let normalise = |[a, b]: [f64; 2]| [a / (a + b), b / (a + b)];
        let mut forward: Vec<[f64; 2]> = Vec::with_capacity(points.len());
        for current in &likelihood {
            let before = forward.last().copied();
            forward.push(normalise([0, 1].map(|to| {
                current[to] * before.map_or(0.5, |before| before[0] * step(0, to) + before[1] * step(1, to))
            })));
        }
        let mut backward = [1.0; 2];
        let mut posterior =
            Posterior { planted: vec![0.0; points.len()], persisting: [0.0; 2], total_frames: [0.0; 2] };
        for frame in (0..points.len()).rev() {
            let both = normalise([0, 1].map(|state| forward[frame][state] * backward[state]));
            posterior.planted[frame] = both[0];
            let ahead = [0, 1].map(|state| likelihood[frame][state] * backward[state]);
            if let Some(before) = frame.checked_sub(1) {
                let joint = |from: usize, to: usize| forward[before][from] * step(from, to) * ahead[to];
                let total: f64 = (0..4).map(|pair| joint(pair / 2, pair % 2)).sum();
                for state in 0..2 {
                    posterior.persisting[state] += joint(state, state) / total;
                    posterior.total_frames[state] += (joint(state, 0) + joint(state, 1)) / total;
                }
            }
            backward = normalise([0, 1].map(|from| step(from, 0) * ahead[0] + step(from, 1) * ahead[1]));
        }
        posterior
    }
}
