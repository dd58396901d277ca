//! Sums of likenesses over many samples, by expansion about cells of them.
//!
//! The likeness f(|y − y′|²) of a sample and all those of a cell is written as a series about
//! the centres of both cells. Of the cell of sources, weight, centre and second moments count;
//! on the side of the targets, value, slope and curvature. What is left out is of the third order
//! in the size of one cell, measured in units of the kernel's scale. The sum over all pairs of n
//! samples takes time proportional to n and to the product of the numbers of cells.
//!
//! What is left out on the side of the targets is wrong for each of them in its own way, while the
//! errors of many cells of sources hardly add up: one sample that is no cell's is close to exact.

use crate::plants::spectral::affinity::Kernel;
use crate::plants::spectral::cells::{Cells, DIMS, Group, Point};

/// Axes along which second moments and curvature count: along the others cells have next to no extent.
const LEADING: usize = 4;
/// Entries of a symmetric matrix over them.
const TRIANGLE: usize = LEADING * (LEADING + 1) / 2;
/// Cells that are looked at together, by the same instruction where the machine can.
const LANES: usize = 8;

/// The series is short: samples farther from the centre of their cell than this, in units of the
/// kernel's scale and over all coordinates, are looked at by themselves ...
const FAR: f32 = 0.3;
/// ... of so many samples one at most, the farthest first.
const FAR_SHARE: usize = 100;

type Lanes = [f32; LANES];
const NONE: Lanes = [0.0; LANES];

/// Cells of sources, as many as there are lanes.
struct Sources {
    weight: Lanes,
    centre: [Lanes; DIMS],
    /// Second moments about the centre, lower triangle by rows.
    moments: [Lanes; TRIANGLE],
    /// Trace of the second moments along all axes.
    trace: Lanes,
    /// Mean square of what coordinates do not keep.
    rest: Lanes,
}

impl Sources {
    /// The ways from the centres to a place, `rest` of whose square is not in its coordinates, and
    /// their squares.
    #[inline(always)]
    fn off(&self, place: &[f32; DIMS], rest: f32) -> ([Lanes; DIMS], Lanes) {
        let mut off = [NONE; DIMS];
        let mut squares = self.rest.map(|own| own + rest);
        for axis in 0..DIMS {
            for lane in 0..LANES {
                off[axis][lane] = place[axis] - self.centre[axis][lane];
                squares[lane] += off[axis][lane] * off[axis][lane];
            }
        }
        (off, squares)
    }

    /// The moments along the way between the centres.
    #[inline(always)]
    fn turned(&self, off: &[Lanes; DIMS]) -> [Lanes; LEADING] {
        let mut turned = [NONE; LEADING];
        let mut entry = 0;
        for row in 0..LEADING {
            for column in 0..=row {
                let moments = &self.moments[entry];
                entry += 1;
                for lane in 0..LANES {
                    turned[row][lane] += moments[lane] * off[column][lane];
                }
                if column < row {
                    for lane in 0..LANES {
                        turned[column][lane] += moments[lane] * off[row][lane];
                    }
                }
            }
        }
        turned
    }
}

/// What all sources add up to at a place, `rest` of whose square is not in its coordinates.
#[inline(always)]
fn value_at(
    place: &[f32; DIMS],
    rest: f32,
    sources: &[Sources],
    derivatives: impl Fn(Lanes) -> [Lanes; 4],
) -> f32 {
    let mut value = NONE;
    for source in sources {
        let (off, squares) = source.off(place, rest);
        let [f, f1, f2, _] = derivatives(squares);
        let turned = source.turned(&off);
        for lane in 0..LANES {
            let mut along = 0.0;
            for axis in 0..LEADING {
                along += off[axis][lane] * turned[axis][lane];
            }
            value[lane] +=
                source.weight[lane] * f[lane] + f1[lane] * source.trace[lane] + 2.0 * f2[lane] * along;
        }
    }
    value.iter().sum()
}

/// What all sources add up to about the centre of a cell of targets.
struct Local {
    value: f32,
    slope: [f32; DIMS],
    /// Curvature but for what is the same in all directions.
    curvature: [f32; TRIANGLE],
    /// Half the curvature that is the same in all directions.
    isotropic: f32,
}

/// Sources as they are seen from anywhere, at one scale.
pub(crate) struct Expansion {
    kernel: Kernel,
    /// What lengths are multiplied by.
    scale: f32,
    sources: Vec<Sources>,
}

impl Expansion {
    /// Of samples with weights, by sample; `sigma` is the kernel's scale in the units of the cells.
    pub fn of(kernel: Kernel, sigma: f64, cells: &Cells, weights: &[f64]) -> Expansion {
        Expansion { kernel, scale: (1.0 / sigma) as f32, sources: gathered(cells, weights, 1.0 / sigma) }
    }

    /// Number of cells of sources, at least one.
    pub fn cells(&self) -> usize {
        LANES * self.sources.len().max(1)
    }

    /// For each sample of `targets`, the weighted sum of its likenesses to all sources.
    pub fn sums(&self, targets: &Cells) -> Vec<f64> {
        let scale = self.scale;
        let mut sums = vec![0.0; targets.points.len()];
        let mut far = Vec::new();
        for (range, centre) in &targets.targets {
            let points = &targets.points[range.clone()];
            let place = centre.map(|place| place * scale);
            let middle =
                points.iter().map(|point| point.rest).sum::<f32>() / points.len() as f32 * scale * scale;
            let local = match self.kernel {
                Kernel::Gaussian => Local::about(&place, middle, &self.sources, gaussian),
                Kernel::Cauchy => Local::about(&place, middle, &self.sources, cauchy),
            };
            for point in points {
                let off: [f32; DIMS] = std::array::from_fn(|axis| (point.place[axis] - centre[axis]) * scale);
                let rest = point.rest * scale * scale - middle;
                sums[point.index as usize] = f64::from(local.at(off, rest)).max(0.0);
                let square = off.iter().map(|off| off * off).sum::<f32>() + rest.abs();
                if square > FAR * FAR {
                    far.push((square, point));
                }
            }
        }
        let most = sums.len() / FAR_SHARE;
        if far.len() > most {
            far.select_nth_unstable_by(most, |a, b| b.0.total_cmp(&a.0).then(a.1.index.cmp(&b.1.index)));
            far.truncate(most);
        }
        for (_, point) in far {
            sums[point.index as usize] = self.at(point);
        }
        sums
    }

    /// The same for one sample, without an expansion on its own side.
    pub fn at(&self, point: &Point) -> f64 {
        let place = point.place.map(|place| place * self.scale);
        let rest = point.rest * self.scale * self.scale;
        let sum = match self.kernel {
            Kernel::Gaussian => value_at(&place, rest, &self.sources, gaussian),
            Kernel::Cauchy => value_at(&place, rest, &self.sources, cauchy),
        };
        f64::from(sum).max(0.0)
    }
}

/// f, f′, f″ and f‴ of exp(−x) at squares x.
#[inline(always)]
fn gaussian(squares: Lanes) -> [Lanes; 4] {
    let value = crate::plants::spectral::affinity::power_of_two(
        squares.map(|square| square * std::f32::consts::LOG2_E),
    );
    let minus = value.map(|value| -value);
    [value, minus, value, minus]
}

/// f, f′, f″ and f‴ of 1 / (1 + x) at squares x.
#[inline(always)]
fn cauchy(squares: Lanes) -> [Lanes; 4] {
    let value = squares.map(|square| 1.0 / (1.0 + square));
    let first = value.map(|value| -value * value);
    let second = value.map(|value| 2.0 * value * value * value);
    let third = value.map(|value| -6.0 * (value * value) * (value * value));
    [value, first, second, third]
}

/// The moments of all cells, lengths times `scale`; lanes that are left over weigh nothing.
fn gathered(cells: &Cells, weights: &[f64], scale: f64) -> Vec<Sources> {
    let gather = |chunk: &[Group]| {
        let mut sources = Sources {
            weight: NONE,
            centre: [NONE; DIMS],
            moments: [NONE; TRIANGLE],
            trace: NONE,
            rest: NONE,
        };
        for (lane, (range, middle)) in chunk.iter().enumerate() {
            let points = &cells.points[range.clone()];
            let weighed = || points.iter().map(|point| (point, weights[point.index as usize]));
            let whole: f64 = weighed().map(|(_, weight)| weight).sum();
            let centre: [f64; DIMS] = std::array::from_fn(|axis| {
                let off = |place: f32| f64::from(place - middle[axis]);
                let sum: f64 = weighed().map(|(point, weight)| weight * off(point.place[axis])).sum();
                f64::from(middle[axis]) + if whole > 0.0 { sum / whole } else { 0.0 }
            });
            let mut moments = [0.0; TRIANGLE];
            let (mut trace, mut rest) = (0.0, 0.0);
            for (point, weight) in weighed() {
                let off: [f64; DIMS] =
                    std::array::from_fn(|axis| f64::from(point.place[axis]) - centre[axis]);
                trace += weight * off.iter().map(|off| off * off).sum::<f64>();
                rest += weight * f64::from(point.rest);
                for (moment, (row, column)) in moments.iter_mut().zip(entries()) {
                    *moment += weight * off[row] * off[column];
                }
            }
            sources.weight[lane] = whole as f32;
            sources.trace[lane] = (trace * scale * scale) as f32;
            sources.rest[lane] = if whole > 0.0 { (rest / whole * scale * scale) as f32 } else { 0.0 };
            for (lanes, value) in sources.centre.iter_mut().zip(centre) {
                lanes[lane] = (value * scale) as f32;
            }
            for (lanes, value) in sources.moments.iter_mut().zip(moments) {
                lanes[lane] = (value * scale * scale) as f32;
            }
        }
        sources
    };
    cells.sources.chunks(LANES).map(gather).collect()
}

/// Row and column of each entry of a lower triangle.
#[inline(always)]
fn entries() -> impl Iterator<Item = (usize, usize)> {
    (0..LEADING).flat_map(|row| (0..=row).map(move |column| (row, column)))
}

impl Local {
    #[inline(always)]
    fn about(
        centre: &[f32; DIMS],
        rest: f32,
        sources: &[Sources],
        derivatives: impl Fn(Lanes) -> [Lanes; 4],
    ) -> Local {
        let mut value = NONE;
        let mut isotropic = NONE;
        let mut slope = [NONE; DIMS];
        let mut curvature = [NONE; TRIANGLE];
        for source in sources {
            let (off, squares) = source.off(centre, rest);
            let [f, f1, f2, f3] = derivatives(squares);
            let turned = source.turned(&off);
            let mut along = NONE;
            for axis in 0..LEADING {
                for lane in 0..LANES {
                    along[lane] += off[axis][lane] * turned[axis][lane];
                }
            }
            let (mut pull, mut turn, mut bend) = (NONE, NONE, NONE);
            for lane in 0..LANES {
                let (weight, trace) = (source.weight[lane], source.trace[lane]);
                value[lane] += weight * f[lane] + f1[lane] * trace + 2.0 * f2[lane] * along[lane];
                isotropic[lane] += weight * f1[lane];
                pull[lane] = 2.0 * (weight * f1[lane] + f2[lane] * trace + 2.0 * f3[lane] * along[lane]);
                turn[lane] = 4.0 * f2[lane];
                bend[lane] = 4.0 * weight * f2[lane];
            }
            let mut entry = 0;
            for row in 0..DIMS {
                for lane in 0..LANES {
                    slope[row][lane] += pull[lane] * off[row][lane];
                }
            }
            for row in 0..LEADING {
                let mut bent = NONE;
                for lane in 0..LANES {
                    slope[row][lane] += turn[lane] * turned[row][lane];
                    bent[lane] = bend[lane] * off[row][lane];
                }
                for along in &off[..=row] {
                    for lane in 0..LANES {
                        curvature[entry][lane] += bent[lane] * along[lane];
                    }
                    entry += 1;
                }
            }
        }
        let sum = |lanes: Lanes| lanes.iter().sum();
        Local {
            value: sum(value),
            slope: slope.map(sum),
            curvature: curvature.map(sum),
            isotropic: sum(isotropic),
        }
    }

    /// The sum at a point `off` the centre, of whose square its coordinates leave out so much more.
    fn at(&self, off: [f32; DIMS], rest: f32) -> f32 {
        let square: f32 = off.iter().map(|off| off * off).sum();
        let mut sum = self.value + self.isotropic * (rest + square);
        for (slope, off) in self.slope.iter().zip(off) {
            sum += slope * off;
        }
        for (curvature, (row, column)) in self.curvature.iter().zip(entries()) {
            let share = if row == column { 0.5 } else { 1.0 };
            sum += share * curvature * off[row] * off[column];
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::plants::signal::samples::Samples;
    use crate::plants::spectral::cells::Axes;

    fn likeness(kernel: Kernel, square: f64) -> f64 {
        match kernel {
            Kernel::Gaussian => (-square).exp(),
            Kernel::Cauchy => 1.0 / (1.0 + square),
        }
    }

    fn plain(kernel: Kernel, samples: &Samples, weights: &[f64], sigma: f64, of: usize) -> f64 {
        let likeness = |other: usize| likeness(kernel, samples.square(of, other) / (sigma * sigma));
        (0..samples.len()).map(|other| weights[other] * likeness(other)).sum()
    }

    fn close(kernel: Kernel, samples: &Samples, weights: &[f64], sigma: f64, most: usize) -> Vec<f64> {
        let cells = Cells::of(Axes::of(samples).points(samples), most, most);
        Expansion::of(kernel, sigma, &cells, weights).sums(&cells)
    }

    #[test]
    fn samples_that_stray_from_their_cell_are_looked_at_by_themselves() {
        let near = |index: u32| [f64::from(index % 25) * 1e-3, f64::from(index % 40) * 1e-3];
        let samples = Samples::new(2, (0..999).flat_map(near).chain([0.7, -0.6]).collect());
        let weights = vec![1.0; samples.len()];
        for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
            let found = close(kernel, &samples, &weights, 1.0, 1)[999];
            let expected = plain(kernel, &samples, &weights, 1.0, 999);
            assert!((found / expected - 1.0).abs() < 5e-3, "{found} {expected}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn cells_of_one_sample_each_are_exact(
            values in prop::collection::vec(0.0..1.0_f64, 6 * 20),
            weights in prop::collection::vec(0.0..1.0_f64, 20),
            sigma in 0.1..1.0_f64,
        ) {
            let samples = Samples::new(6, values);
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let found = close(kernel, &samples, &weights, sigma, 20);
                for (of, found) in found.iter().enumerate() {
                    let expected = plain(kernel, &samples, &weights, sigma, of);
                    prop_assert!((found - expected).abs() < 1e-5 * (1.0 + expected), "{found} {expected}");
                }
            }
        }

        /// Third order: in cells of a tenth of the scale what is left out is about a thousandth.
        #[test]
        fn small_cells_are_close(
            seeds in prop::collection::vec(0.0..1.0_f64, 6 * 8),
            offs in prop::collection::vec(-0.0625..0.0625_f64, 6 * 8 * 12),
            sigma in 0.9..1.1_f64,
        ) {
            let points = (0..12 * 8 * 6).map(|index| seeds[index % 48] + offs[index] * 0.5).collect();
            let samples = Samples::new(6, points);
            let weights = vec![1.0; samples.len()];
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let found = close(kernel, &samples, &weights, sigma, 48);
                for (of, found) in found.iter().enumerate() {
                    let expected = plain(kernel, &samples, &weights, sigma, of);
                    prop_assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
                }
            }
        }

        #[test]
        fn what_coordinates_do_not_keep_is_not_forgotten(
            values in prop::collection::vec(0.0..1.0_f64, 10 * 24),
        ) {
            // The last four of ten coordinates hardly vary.
            let shrink = |(index, value): (usize, f64)| if index % 10 < 6 { value } else { value * 0.05 };
            let samples = Samples::new(10, values.into_iter().enumerate().map(shrink).collect());
            let weights = vec![1.0; 24];
            for kernel in [Kernel::Gaussian, Kernel::Cauchy] {
                let found = close(kernel, &samples, &weights, 1.0, 24);
                for (of, found) in found.iter().enumerate() {
                    let expected = plain(kernel, &samples, &weights, 1.0, of);
                    prop_assert!((found / expected - 1.0).abs() < 5e-3, "{found} {expected}");
                }
            }
        }
    }
}
