//! Mixture of two Gaussians on the logarithms of height and speed.

use nalgebra::{Matrix2, Vector2};

use crate::foot::Part;
use crate::numeric::stats;
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Thresholds};
use crate::plants::methods::toes::Toes;
use crate::plants::signal::Signals;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "gmm",
    title: "Gaussian mixture",
    description: "Two Gaussians on the logarithms of height and speed, fitted to each clip.",
    family: Family::Mixture,
    parts: &[Part::Toe],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

/// Number of EM iterations.
const ITERATIONS: usize = 60;

fn detect(input: &mut Input) -> Output {
    let toes = Toes::new(input);
    let points = points(&toes.signals, input.feet.leg);
    let mixture = Mixture::fit(&points);
    let probability: Vec<f64> = points.iter().map(|point| mixture.planted_probability(point)).collect();
    let planted: Vec<bool> = probability.iter().map(|p| *p > 0.5).collect();
    let (left, right) = probability.split_at(input.feet.frame_count());
    toes.into_output(Part::Toe, &planted, Some([left.to_vec(), right.to_vec()]), None)
}

/// Returns the logarithms of height and speed in leg lengths; the offset makes the logarithm of zero finite.
pub(crate) fn points(signals: &Signals, leg: f64) -> Vec<Vector2<f64>> {
    let log = |value: f64, offset: f64| (value / leg + offset).ln();
    let point = |(height, speed): (&f64, &f64)| Vector2::new(log(*height, 0.005), log(*speed, 0.02));
    signals.iter().flat_map(|signal| signal.height.iter().zip(&signal.speed).map(point)).collect()
}

/// Gaussian with its mixture weight.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gaussian {
    pub weight: f64,
    mean: Vector2<f64>,
    covariance: Matrix2<f64>,
}

impl Gaussian {
    /// Fits a Gaussian to weighted points.
    pub fn fit(points: &[Vector2<f64>], weights: impl Fn(usize) -> f64) -> Gaussian {
        let total: f64 = (0..points.len()).map(&weights).sum::<f64>().max(1e-9);
        let mean =
            points.iter().enumerate().map(|(i, point)| point * weights(i)).sum::<Vector2<f64>>() / total;
        let scatter = points.iter().enumerate().map(|(i, point)| {
            let offset = point - mean;
            offset * offset.transpose() * weights(i)
        });
        // A minimum variance prevents a class of equal points from collapsing.
        let covariance = scatter.sum::<Matrix2<f64>>() / total + Matrix2::identity() * 1e-3;
        Gaussian { weight: total / points.len().max(1) as f64, mean, covariance }
    }

    /// Returns the log-density at a point, without the mixture weight.
    pub fn log_density(&self, point: &Vector2<f64>) -> f64 {
        let offset = point - self.mean;
        let inverse = self.covariance.try_inverse().unwrap_or_else(Matrix2::identity);
        -0.5 * ((offset.transpose() * inverse * offset)[0] + self.covariance.determinant().ln())
    }

    /// Returns the sum of the mean log-height and log-speed.
    fn log_height_plus_speed(&self) -> f64 {
        self.mean.sum()
    }
}

/// Planted and moving component.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mixture {
    pub planted: Gaussian,
    pub moving: Gaussian,
}

impl Mixture {
    /// Fits both components by EM, starting from the lower and the upper half of the points.
    pub fn fit(points: &[Vector2<f64>]) -> Mixture {
        let split = stats::median_high(points.iter().map(Vector2::sum)).unwrap_or_default();
        let low = |i: usize| f64::from(u8::from(points[i].sum() < split));
        let mut mixture =
            Mixture { planted: Gaussian::fit(points, low), moving: Gaussian::fit(points, |i| 1.0 - low(i)) };
        for _ in 0..ITERATIONS {
            let planted: Vec<f64> = points.iter().map(|point| mixture.planted_probability(point)).collect();
            mixture = Mixture {
                planted: Gaussian::fit(points, |i| planted[i]),
                moving: Gaussian::fit(points, |i| 1.0 - planted[i]),
            };
        }
        if mixture.planted.log_height_plus_speed() > mixture.moving.log_height_plus_speed() {
            std::mem::swap(&mut mixture.planted, &mut mixture.moving);
        }
        mixture
    }

    /// Returns the probability that a point is planted.
    pub fn planted_probability(&self, point: &Vector2<f64>) -> f64 {
        let log = |gaussian: &Gaussian| gaussian.weight.max(1e-12).ln() + gaussian.log_density(point);
        1.0 / (1.0 + (log(&self.moving) - log(&self.planted)).exp())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_clusters_are_separated() {
        let cluster = |x: f64, y: f64, n: usize| {
            (0..n).map(move |i| Vector2::new(x + (i % 7) as f64 * 0.1, y + (i % 5) as f64 * 0.1))
        };
        let points: Vec<_> = cluster(-5.0, -4.0, 120).chain(cluster(-1.0, 0.0, 60)).collect();
        let mixture = Mixture::fit(&points);
        assert!((mixture.planted.weight - 2.0 / 3.0).abs() < 0.01);
        assert!(points[..120].iter().all(|point| mixture.planted_probability(point) > 0.99));
        assert!(points[120..].iter().all(|point| mixture.planted_probability(point) < 0.01));
    }
}
