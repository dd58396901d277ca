//! Smoothed derivatives of one coordinate of a track around an edge.

use std::ops::Range;

use nalgebra::Vector3;

use crate::kinematics::Track;
use crate::numeric::{interpolate, stats};
use crate::plants::signal::remove_spikes;

/// Minimum rate of the interpolated coordinate, in Hz.
const MIN_RATE: f64 = 480.0;
/// Standard deviation of the Gaussian whose derivatives are taken, in seconds: the width of an impact,
/// and the period of optical motion capture at its usual rates.
pub(super) const SMOOTHING: f64 = 0.008;
/// Half-width of the kernels, in standard deviations.
const KERNEL_REACH: f64 = 5.0;

/// Values at equal intervals.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Series {
    /// Time of the first value, in seconds.
    pub start: f64,
    /// Time between values, in seconds.
    pub step: f64,
    pub values: Vec<f64>,
}

/// Part of a track within a span of continuous motion.
#[derive(Clone, Copy)]
pub(super) struct TrackSpan<'a> {
    pub track: &'a Track,
    /// Frames of the span.
    pub span: &'a Range<usize>,
    /// In seconds.
    pub frame_time: f64,
    /// Leg length, in track units.
    pub leg: f64,
    pub kernels: &'a Kernels,
}

impl TrackSpan<'_> {
    /// Returns the velocity (order 1), the acceleration (2) or the jerk (3) of a coordinate in a period
    /// of time, in coordinate units per second to the power of the order.
    ///
    /// The coordinate is interpolated between frames without spikes by Catmull–Rom splines and
    /// convolved with a derivative of a Gaussian. Beyond the span it is constant.
    pub fn derivatives<const N: usize>(
        &self,
        period: &Range<f64>,
        orders: [usize; N],
        coordinate: impl Fn(&Vector3<f64>) -> f64,
    ) -> [Series; N] {
        let Kernels { factor, step, reach, .. } = *self.kernels;
        let first = (period.start / step).ceil() as isize;
        let count = ((period.end / step).floor() as isize - first + 1).max(0) as usize;
        let time_index = |index: usize| first + index as isize - reach as isize;
        // A spline needs one frame before and two after a time.
        let last = (self.span.end - 1) as isize;
        let in_span = |frame: isize| frame.clamp(self.span.start as isize, last) as usize;
        let start = in_span(time_index(0).div_euclid(factor as isize) - 1);
        let end = in_span(time_index(count + 2 * reach).div_euclid(factor as isize) + 2) + 1;
        let values: Vec<f64> = self.without_spikes(start..end).iter().map(coordinate).collect();
        let interpolated: Vec<f64> = (0..count + 2 * reach)
            .map(|index| {
                let position = time_index(index) as f64 / factor as f64;
                let frame = position.floor();
                let points = [-1, 0, 1, 2].map(|offset| values[in_span(frame as isize + offset) - start]);
                interpolate::catmull_rom(points, position - frame)
            })
            .collect();
        orders.map(|order| {
            let kernel = &self.kernels.by_order[order - 1];
            let value = |window: &[f64]| window.iter().zip(kernel).map(|(x, weight)| x * weight).sum();
            let values = interpolated.windows(kernel.len()).take(count).map(value).collect();
            Series { start: first as f64 * step, step, values }
        })
    }

    /// Returns the positions in frames of the span, without spikes.
    fn without_spikes(&self, frames: Range<usize>) -> Track {
        // A spike shows by its neighbours.
        let start = frames.start.saturating_sub(1).max(self.span.start);
        let mut window = self.track[start..(frames.end + 1).min(self.span.end)].to_vec();
        remove_spikes(&mut window, self.leg);
        window.drain(..frames.start - start);
        window.truncate(frames.len());
        window
    }

    /// Returns the mean velocity in a period, in track units per second; zero if it has fewer than two
    /// frames.
    pub fn mean_velocity(&self, period: &Range<f64>) -> Vector3<f64> {
        let positions = self.without_spikes(self.frames(period));
        let [first, .., last] = positions.as_slice() else { return Vector3::zeros() };
        (last - first) / ((positions.len() - 1) as f64 * self.frame_time)
    }

    /// Returns the velocities in a period by central differences over at least twice [`SMOOTHING`], in
    /// track units per second.
    pub fn velocities(&self, period: &Range<f64>) -> impl Iterator<Item = Vector3<f64>> {
        let half = (SMOOTHING / self.frame_time).round().max(1.0) as usize;
        let frames = self.frames(period);
        let around =
            frames.start.saturating_sub(half).max(self.span.start)..(frames.end + half).min(self.span.end);
        let duration = 2.0 * half as f64 * self.frame_time;
        let positions = self.without_spikes(around);
        (2 * half..positions.len()).map(move |to| (positions[to] - positions[to - 2 * half]) / duration)
    }

    /// Returns the frames of the span in a period.
    fn frames(&self, period: &Range<f64>) -> Range<usize> {
        let frame = |time: f64| {
            ((time / self.frame_time).ceil().max(0.0) as usize).clamp(self.span.start, self.span.end)
        };
        frame(period.start)..frame(period.end)
    }
}

/// Derivatives of a Gaussian, for interpolated coordinates.
pub(super) struct Kernels {
    /// Interpolated times per frame.
    factor: usize,
    /// Time between interpolated times, in seconds.
    step: f64,
    /// Half-width of the kernels, in steps.
    reach: usize,
    /// Weights that yield the derivatives of orders 1 to 3 at the centre of a window.
    by_order: [Vec<f64>; 3],
}

impl Kernels {
    /// Creates the kernels for a clip; `frame_time` is in seconds.
    pub fn new(frame_time: f64) -> Kernels {
        let factor = (MIN_RATE * frame_time).ceil().max(1.0);
        let step = frame_time / factor;
        let reach = (KERNEL_REACH * SMOOTHING / step).ceil() as usize;
        let times: Vec<f64> = (0..=2 * reach).map(|index| (index as f64 - reach as f64) * step).collect();
        let gaussian = |t: f64| (-0.5 * (t / SMOOTHING).powi(2)).exp();
        let total: f64 = times.iter().map(|&t| gaussian(t)).sum();
        let variance = SMOOTHING * SMOOTHING;
        let kernel = |polynomial: fn(f64, f64) -> f64| -> Vec<f64> {
            let weights = times.iter().map(|&t| polynomial(t, variance) * gaussian(t) / total);
            // A constant has no derivative, although the kernel has ends.
            let mean = stats::mean(weights.clone());
            weights.map(|weight| weight - mean).collect()
        };
        // The derivative of a convolution is a correlation with the derivative of the kernel, negated
        // for odd orders.
        let by_order = [
            kernel(|t, variance| t / variance),
            kernel(|t, variance| (t * t / variance - 1.0) / variance),
            kernel(|t, variance| (t * t / variance - 3.0) * t / (variance * variance)),
        ];
        Kernels { factor: factor as usize, step, reach, by_order }
    }
}

impl Series {
    /// Returns the time of the largest positive local maximum, refined by a parabola through its
    /// neighbours; `None` if there is none.
    ///
    /// The maxima are weighted by a parabola that falls from 1 in the middle to 0 at the ends, so that
    /// a small shift of the ends does not change the result.
    pub fn time_of_peak(&self) -> Option<f64> {
        let middle = (self.values.len() as f64 - 1.0) / 2.0;
        let weight = |index: usize| 1.0 - ((index as f64 - middle) / (middle + 1.0)).powi(2);
        let is_peak = |three: &[f64]| three[1] > 0.0 && three[1] >= three[0] && three[1] > three[2];
        let peaks = self.values.windows(3).enumerate().filter(|(_, three)| is_peak(three));
        let (index, three, _) = peaks
            .map(|(before, three)| (before + 1, three, three[1] * weight(before + 1)))
            .reduce(|largest, peak| if peak.2 > largest.2 { peak } else { largest })?;
        let [before, here, after] = [three[0], three[1], three[2]];
        let offset = 0.5 * (before - after) / (before - 2.0 * here + after);
        Some(self.time(index as f64 + offset))
    }

    /// Returns the time nearest to `near` at which the values rise through `level`.
    pub fn time_of_rise(&self, level: f64, near: f64) -> Option<f64> {
        let rises =
            self.values.windows(2).enumerate().filter(|(_, pair)| pair[0] < level && pair[1] >= level);
        rises
            .map(|(index, pair)| self.time(index as f64 + (level - pair[0]) / (pair[1] - pair[0])))
            .min_by(|a, b| (a - near).abs().total_cmp(&(b - near).abs()))
    }

    /// Returns the largest value; negative infinity if there are none.
    pub fn maximum(&self) -> f64 {
        self.values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// Returns the median of the absolute values; 0 if there are none.
    pub fn median_magnitude(&self) -> f64 {
        stats::median_high(self.values.iter().map(|value| value.abs())).unwrap_or(0.0)
    }

    /// Returns the negated values.
    pub fn negated(mut self) -> Series {
        self.values.iter_mut().for_each(|value| *value = -*value);
        self
    }

    /// Returns the values minus a constant.
    pub fn minus(mut self, constant: f64) -> Series {
        self.values.iter_mut().for_each(|value| *value -= constant);
        self
    }

    /// Returns the norm of a vector with two components at the same times.
    pub fn norm(mut self, other: &Series) -> Series {
        self.values.iter_mut().zip(&other.values).for_each(|(value, other)| *value = value.hypot(*other));
        self
    }

    /// Returns the time at an index.
    pub fn time(&self, index: f64) -> f64 {
        self.start + index * self.step
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn derivatives(position: impl Fn(f64) -> f64, frame_time: f64) -> [Series; 2] {
        let track: Vec<_> =
            (0..200).map(|frame| Vector3::y() * position(f64::from(frame) * frame_time)).collect();
        let kernels = Kernels::new(frame_time);
        let span = TrackSpan { track: &track, span: &(0..200), frame_time, leg: 1e9, kernels: &kernels };
        span.derivatives(&(0.5..0.7), [1, 3], |position| position.y)
    }

    #[test]
    fn derivatives_of_polynomials_are_exact() {
        let [velocity, jerk] = derivatives(|t| 2.0 * t * t - t, 0.007);
        for (index, value) in velocity.values.iter().enumerate() {
            let t = velocity.time(index as f64);
            assert!((0.5..=0.7).contains(&t) && (value - (4.0 * t - 1.0)).abs() < 1e-3, "{t}: {value}");
        }
        // Impacts have a jerk of thousands.
        assert!(jerk.values.iter().all(|jerk| jerk.abs() < 10.0), "{jerk:?}");
        let [_, jerk] = derivatives(|t| t * t * t, 0.01);
        assert!(jerk.values.iter().all(|jerk| (jerk - 6.0).abs() < 10.0), "{jerk:?}");
    }

    #[test]
    fn derivatives_do_not_depend_on_the_origin() {
        for order in &Kernels::new(0.01).by_order {
            let sum: f64 = order.iter().sum();
            let magnitude: f64 = order.iter().map(|weight| weight.abs()).sum();
            assert!(sum.abs() < 1e-14 * magnitude, "{sum} of {magnitude}");
        }
    }

    #[test]
    fn extrema_are_found_between_frames() {
        let [velocity, _] = derivatives(|t| (20.0 * (t - 0.6123)).sin(), 0.01);
        assert!((velocity.time_of_peak().unwrap() - 0.6123).abs() < 1e-3);
        let [velocity, _] = derivatives(|t| t * t, 0.01);
        assert_eq!(velocity.time_of_peak(), None);
    }

    #[test]
    fn the_nearest_rise_counts() {
        let series = Series { start: 1.0, step: 0.5, values: vec![0.0, 1.0, 0.0, 2.0, 3.0] };
        assert_eq!(series.time_of_rise(0.5, 0.0), Some(1.25));
        assert_eq!(series.time_of_rise(0.5, 9.0), Some(2.125));
        assert_eq!(series.time_of_rise(5.0, 9.0), None);
    }
}
