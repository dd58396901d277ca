//! What any foot would be taken for: the degree over the plane of height and speed.

use std::cell::OnceCell;

use crate::plants::signal::samples::{Ranges, Samples};
use crate::plants::spectral::affinity::Kernel;
use crate::plants::spectral::degree::{Among, Pairs};

/// More samples than this would draw the same picture.
const MOST: usize = 3000;

/// The graph of a clip as a field: the root of the degree that a foot would have at any height
/// and speed, to be compared with the threshold that parts the clip's own samples.
///
/// Of many samples every n-th is kept and counts for n: the roots of a long clip are those of a picture,
/// not of a label.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    samples: Samples,
    weights: Vec<f64>,
    sigma: f64,
    kernel: Kernel,
    ranges: Ranges,
}

impl Field {
    /// The field of samples whose heights and speeds were divided by `ranges`.
    pub(crate) fn of(among: &Among, ranges: Ranges) -> Field {
        let &Among { weights, sigma, kernel, .. } = among;
        let samples = &among.samples.samples;
        let stride = samples.len().div_ceil(MOST).max(1);
        let kept = || (0..samples.len()).step_by(stride);
        let share = samples.len() as f64 / kept().count().max(1) as f64;
        Field {
            weights: kept().map(|sample| weights[sample] * share).collect(),
            samples: samples.some(kept()),
            sigma,
            kernel,
            ranges,
        }
    }

    /// u of a foot that holds a height and a speed over the window, for each height all speeds;
    /// file units and file units per second.
    ///
    /// Takes about 1 ns for each pair of such a foot and a sample that is kept.
    pub fn roots(&self, heights: &[f64], speeds: &[f64]) -> Vec<f64> {
        let held = Samples::held(heights, speeds, self.ranges, self.samples.dimension).into();
        let &Field { ref weights, sigma, kernel, .. } = self;
        let (samples, pairs, expansion) = (&self.samples.clone().into(), Pairs::All, OnceCell::new());
        Among { samples, weights, sigma, kernel, pairs, expansion }.of(&held).values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::spectral::cells::Grouped;

    /// Feet that stand and swing in turn: without a window, so that every frame holds what it is.
    fn swinging(count: usize) -> (Vec<[f64; 2]>, Grouped) {
        let places: Vec<[f64; 2]> = (0..count)
            .map(|index| {
                let swing = (index as f64 * 0.0611).sin().max(0.0);
                [0.4 * swing, 3.0 * swing * swing]
            })
            .collect();
        let points = places.iter().flat_map(|[height, speed]| [height / 0.4, speed / 3.0]).collect();
        (places, Samples::new(2, points).into())
    }

    fn among<'a>(samples: &'a Grouped, weights: &'a [f64], kernel: Kernel) -> Among<'a> {
        Among { samples, weights, sigma: 0.15, kernel, pairs: Pairs::All, expansion: OnceCell::new() }
    }

    fn field(samples: &Grouped, kernel: Kernel) -> Field {
        let weights = vec![1.0; samples.samples.len()];
        Field::of(&among(samples, &weights, kernel), Ranges { height: 0.4, speed: 3.0 })
    }

    #[test]
    fn the_field_at_a_sample_is_its_own_degree_and_itself() {
        let (places, samples) = swinging(500);
        let weights = vec![1.0; 500];
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let own = among(&samples, &weights, kernel).own().values;
            for sample in [0, 20, 77, 499] {
                let [height, speed] = places[sample];
                let root = field(&samples, kernel).roots(&[height], &[speed])[0];
                assert!((root * root - 1.0 - own[sample] * own[sample]).abs() < 1e-3);
            }
        }
    }

    #[test]
    fn a_few_samples_of_many_draw_the_same_picture() {
        let (_, samples) = swinging(20_000);
        let heights: Vec<f64> = (0..8).map(|step| f64::from(step) * 0.05).collect();
        let speeds: Vec<f64> = (0..8).map(|step| f64::from(step) * 0.4).collect();
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let some = field(&samples, kernel);
            assert!(some.samples.len() <= MOST);
            let weights = vec![1.0; samples.samples.len()];
            let all = among(&samples, &weights, kernel);
            let held = Samples::held(&heights, &speeds, some.ranges, 2).into();
            let most = some.roots(&[0.0], &[0.0])[0];
            for (some, all) in some.roots(&heights, &speeds).iter().zip(all.of(&held).values) {
                assert!((some - all).abs() < 0.005 * most, "{some} {all}");
            }
        }
    }
}
