//! Two Gaussians on the logarithms of height and speed.

use nalgebra::Matrix2;
use nalgebra::Vector2;

use crate::foot::Part;
use crate::plants::methods::toes::Toes;
use crate::plants::methods::{Entry, Family, Found, Task};
use crate::plants::signal::Signals;

pub(crate) const METHOD: Entry = Entry {
    name: "gmm",
    title: "Gaussian mixture",
    about: "Two Gaussians on the logarithms of height and speed, fitted to each clip.",
    family: Family::Mixture,
    parts: &[Part::Toe],
    detect,
};

/// Rounds of expectation and maximisation.
const ROUNDS: usize = 60;

fn detect(task: &Task) -> Found {
    let toes = Toes::of(task);
    let points = points(&toes.signals, task.feet.leg);
    let mixture = Mixture::fit(&points);
    let probability: Vec<f64> = points.iter().map(|point| mixture.planted(point)).collect();
    let planted: Vec<bool> = probability.iter().map(|p| *p > 0.5).collect();
    let (left, right) = probability.split_at(task.feet.frame_count());
    toes.labelled(Part::Toe, &planted, Some([left.to_vec(), right.to_vec()]), None)
}

/// Logarithms of height and speed in legs; the floor keeps rest finite.
pub(crate) fn points(signals: &Signals, leg: f64) -> Vec<Vector2<f64>> {
    let log = |value: f64, floor: f64| (value / leg + floor).ln();
    let point = |(height, speed): (&f64, &f64)| Vector2::new(log(*height, 0.005), log(*speed, 0.02));
    signals.iter().flat_map(|signal| signal.height.iter().zip(&signal.speed).map(point)).collect()
}

/// One Gaussian with its share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gaussian {
    pub share: f64,
    mean: Vector2<f64>,
    covariance: Matrix2<f64>,
}

impl Gaussian {
    /// The Gaussian of weighted points.
    pub fn of(points: &[Vector2<f64>], weights: impl Fn(usize) -> f64) -> Gaussian {
        let total: f64 = (0..points.len()).map(&weights).sum::<f64>().max(1e-9);
        let mean =
            points.iter().enumerate().map(|(i, point)| point * weights(i)).sum::<Vector2<f64>>() / total;
        let scatter = points.iter().enumerate().map(|(i, point)| {
            let off = point - mean;
            off * off.transpose() * weights(i)
        });
        // A little of its own width keeps a class of equal points from collapsing.
        let covariance = scatter.sum::<Matrix2<f64>>() / total + Matrix2::identity() * 1e-3;
        Gaussian { share: total / points.len().max(1) as f64, mean, covariance }
    }

    /// Logarithm of the density at a point, without the share.
    pub fn log_density(&self, point: &Vector2<f64>) -> f64 {
        let off = point - self.mean;
        let inverse = self.covariance.try_inverse().unwrap_or_else(Matrix2::identity);
        -0.5 * ((off.transpose() * inverse * off)[0] + self.covariance.determinant().ln())
    }

    /// How far up and fast its middle is.
    fn height_and_speed(&self) -> f64 {
        self.mean.sum()
    }
}

/// Planted and not.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mixture {
    pub planted: Gaussian,
    pub moving: Gaussian,
}

impl Mixture {
    /// Fits both from the lower and the upper half of the points.
    pub fn fit(points: &[Vector2<f64>]) -> Mixture {
        let mut sums: Vec<f64> = points.iter().map(Vector2::sum).collect();
        let middle = sums.len() / 2;
        let split = *sums.select_nth_unstable_by(middle, f64::total_cmp).1;
        let low = |i: usize| f64::from(u8::from(points[i].sum() < split));
        let mut mixture =
            Mixture { planted: Gaussian::of(points, low), moving: Gaussian::of(points, |i| 1.0 - low(i)) };
        for _ in 0..ROUNDS {
            let planted: Vec<f64> = points.iter().map(|point| mixture.planted(point)).collect();
            mixture = Mixture {
                planted: Gaussian::of(points, |i| planted[i]),
                moving: Gaussian::of(points, |i| 1.0 - planted[i]),
            };
        }
        if mixture.planted.height_and_speed() > mixture.moving.height_and_speed() {
            std::mem::swap(&mut mixture.planted, &mut mixture.moving);
        }
        mixture
    }

    /// Probability that a point is planted.
    pub fn planted(&self, point: &Vector2<f64>) -> f64 {
        let log = |gaussian: &Gaussian| gaussian.share.max(1e-12).ln() + gaussian.log_density(point);
        1.0 / (1.0 + (log(&self.moving) - log(&self.planted)).exp())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_heaps_are_told_apart() {
        let heap = |x: f64, y: f64, n: usize| {
            (0..n).map(move |i| Vector2::new(x + (i % 7) as f64 * 0.1, y + (i % 5) as f64 * 0.1))
        };
        let points: Vec<_> = heap(-5.0, -4.0, 120).chain(heap(-1.0, 0.0, 60)).collect();
        let mixture = Mixture::fit(&points);
        assert!((mixture.planted.share - 2.0 / 3.0).abs() < 0.01);
        assert!(points[..120].iter().all(|point| mixture.planted(point) > 0.99));
        assert!(points[120..].iter().all(|point| mixture.planted(point) < 0.01));
    }
}
