//! A curve through keys.

use super::hermite;

/// A value at a time, with the slope there if it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key<const N: usize> {
    /// When, in seconds.
    pub time: f64,
    /// What, one number per dimension.
    pub value: [f64; N],
    /// Change per second; where absent, the slope that keeps to the neighbours' range.
    pub slope: Option<[f64; N]>,
}

/// Time of the key of a constant track, so far off that other keys drown it.
const LONG_AGO: f64 = -1e9;

/// A C¹ curve of `N` dimensions through keys, constant before the first and after
/// the last.
///
/// Free slopes are those of Fritsch and Carlson: the curve never swings past a
/// key, so a pose held over two keys is held still.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Track<const N: usize> {
    keys: Vec<Key<N>>,
}

impl<const N: usize> Track<N> {
    /// The track that is `value` at all times, as long as it has no other keys.
    pub fn constant(value: [f64; N]) -> Track<N> {
        Track { keys: vec![Key { time: LONG_AGO, value, slope: None }] }
    }

    /// The track through keys in any order; a later key replaces an earlier one of
    /// the same time.
    pub fn through(keys: impl IntoIterator<Item = Key<N>>) -> Track<N> {
        let mut track = Track { keys: Vec::new() };
        for key in keys {
            track.add(key);
        }
        track
    }

    /// The track through these times and values.
    pub fn of(keys: &[(f64, [f64; N])]) -> Track<N> {
        Track::through(keys.iter().map(|&(time, value)| Key { time, value, slope: None }))
    }

    /// Puts a key at `time`.
    pub fn key(&mut self, time: f64, value: [f64; N]) {
        self.add(Key { time, value, slope: None });
    }

    fn add(&mut self, key: Key<N>) {
        let place = self.keys.partition_point(|other| other.time < key.time - 1e-9);
        match self.keys.get_mut(place) {
            Some(same) if same.time <= key.time + 1e-9 => *same = key,
            _ => self.keys.insert(place, key),
        }
    }

    /// The value at `time`; zeros for a track without keys.
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
    fn a_track_meets_its_keys_and_stays_between_them() {
        let track = Track::of(&[(1.0, [0.0]), (0.0, [1.0]), (2.0, [0.0]), (3.0, [4.0])]);
        assert_eq!(track.at(-1.0), [1.0]);
        assert_eq!(track.at(1.0), [0.0]);
        assert_eq!(track.at(1.5), [0.0]);
        assert_eq!(track.at(9.0), [4.0]);
        assert!((0..300).all(|i| (0.0..=4.0).contains(&track.at(f64::from(i) / 100.0)[0])));
    }
}
