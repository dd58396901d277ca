//! Rows that begin with a number or the time of their frame, which BVH does not provide for.

/// Number of rows with the same step larger than 1, from which a column of integers counts frames.
const COUNTED_ROWS: usize = 3;

/// Relative difference between the step of a column and the frame time, at which the column is the time.
const TIME_TOLERANCE: f64 = 0.05;

/// Recognises a column in front of the channels, row by row.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ExtraColumn {
    previous: Option<FirstNumber>,
}

/// First number of a row that has more numbers than there are channels.
#[derive(Clone, Copy, Debug)]
struct FirstNumber {
    value: f64,
    /// Difference from the row before, if that has such a number, too.
    step: Option<f64>,
    /// Number of rows in succession with the same difference.
    equal_steps: usize,
}

impl ExtraColumn {
    /// Adds the first number of the next row if the row has one or two numbers more than there are channels,
    /// or `None`. Returns the content of the column as soon as it is certain: its numbers increase by one, by
    /// a constant step, or by the frame time in seconds or milliseconds.
    pub fn add(&mut self, first: Option<f64>, frame_time: Option<f64>) -> Option<&'static str> {
        let previous = self.previous.take();
        let step = first.zip(previous).map(|(first, previous)| first - previous.value);
        let equal_steps =
            previous.filter(|previous| previous.step == step).map_or(1, |previous| previous.equal_steps + 1);
        self.previous = first.map(|value| FirstNumber { value, step, equal_steps });
        let (first, step) = first.zip(step)?;
        let is_time = |time: f64| (step / time - 1.0).abs() < TIME_TOLERANCE;
        let is_count = step == 1.0 || step > 1.0 && equal_steps >= COUNTED_ROWS;
        if first.fract() == 0.0 && is_count {
            Some("the number of the frame")
        } else if frame_time.is_some_and(|time| is_time(time) || is_time(1e3 * time)) {
            Some("the time of the frame")
        } else {
            None
        }
    }
}
