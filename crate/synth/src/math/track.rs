//! Keyframe tracks.

use super::hermite;

/// Value at a time, with an optional slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keyframe<const N: usize> {
    /// Time, in seconds.
    pub time: f64,
    /// Value, one number per dimension.
    pub value: [f64; N],
    /// Slope per second; `None` selects a monotone slope.
    pub slope: Option<[f64; N]>,
}

/// Time of the keyframe of a constant track: so early that it does not influence other keyframes.
const DISTANT_PAST: f64 = -1e9;

/// C¹ curve of `N` dimensions through keyframes, constant before the first and after the last.
///
/// Unspecified slopes are those of Fritsch and Carlson: the curve never overshoots, and is constant
/// between two equal keyframes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Track<const N: usize> {
    keys: Vec<Keyframe<N>>,
}

impl<const N: usize> Track<N> {
    /// Creates a track with a constant value, until keyframes are added.
    pub fn constant(value: [f64; N]) -> Track<N> {
        Track { keys: vec![Keyframe { time: DISTANT_PAST, value, slope: None }] }
    }

    /// Creates a track from keyframes in any order. A later keyframe replaces an earlier one at the
    /// same time.
    pub fn from_keyframes(keys: impl IntoIterator<Item = Keyframe<N>>) -> Track<N> {
        let mut track = Track { keys: Vec::new() };
        for key in keys {
            track.add(key);
        }
        track
    }

    /// Creates a track from times and values.
    pub fn from_keys(keys: &[(f64, [f64; N])]) -> Track<N> {
        Track::from_keyframes(keys.iter().map(|&(time, value)| Keyframe { time, value, slope: None }))
    }

    /// Adds a keyframe at `time`, or replaces the one at the same time.
    pub fn set_key(&mut self, time: f64, value: [f64; N]) {
        self.add(Keyframe { time, value, slope: None });
    }

    fn add(&mut self, key: Keyframe<N>) {
        let index = self.keys.partition_point(|other| other.time < key.time - 1e-9);
        match self.keys.get_mut(index) {
            Some(same) if same.time <= key.time + 1e-9 => *same = key,
            _ => self.keys.insert(index, key),
        }
    }

    /// Returns the value at `time`; zeros if the track has no keyframes.
    pub fn at(&self, time: f64) -> [f64; N] {
        let next = self.keys.partition_point(|key| key.time <= time);
        let Some(after) = self.keys.get(next) else {
            return self.keys.last().map_or([0.0; N], |key| key.value);
        };
        if next == 0 {
            return after.value;
        }
        let before = &self.keys[next - 1];
        let length = after.time - before.time;
        let u = (time - before.time) / length;
        std::array::from_fn(|n| {
            let from = (before.value[n], self.slope(next - 1, n));
            hermite(from, (after.value[n], self.slope(next, n)), length, u)
        })
    }

    fn slope(&self, index: usize, n: usize) -> f64 {
        let key = &self.keys[index];
        if let Some(slope) = key.slope {
            return slope[n];
        }
        if index == 0 || index + 1 == self.keys.len() {
            return 0.0;
        }
        let (before, after) = (&self.keys[index - 1], &self.keys[index + 1]);
        let (left, right) = (key.time - before.time, after.time - key.time);
        let rising_in = (key.value[n] - before.value[n]) / left;
        let rising_out = (after.value[n] - key.value[n]) / right;
        if rising_in * rising_out <= 0.0 {
            return 0.0;
        }
        let (a, b) = (2.0 * right + left, right + 2.0 * left);
        (a + b) / (a / rising_in + b / rising_out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn track_interpolates_keyframes_without_overshoot() {
        let track = Track::from_keys(&[(1.0, [0.0]), (0.0, [1.0]), (2.0, [0.0]), (3.0, [4.0])]);
        assert_eq!(track.at(-1.0), [1.0]);
        assert_eq!(track.at(1.0), [0.0]);
        assert_eq!(track.at(1.5), [0.0]);
        assert_eq!(track.at(9.0), [4.0]);
        assert!((0..300).all(|i| (0.0..=4.0).contains(&track.at(f64::from(i) / 100.0)[0])));
    }
}
