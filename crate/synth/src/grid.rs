//! The even grid of time on which a motion is worked out.

/// Grid points per second: a multiple of 24, 30, 60 and 120, so that a motion does
/// not depend on the rate at which it is sampled.
pub const GRID_RATE: usize = 240;

/// Evenly spaced moments from `start` on, [`GRID_RATE`] a second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Points before time 0.
    lead: usize,
    /// Number of points.
    count: usize,
}

impl Grid {
    /// The grid from `start` (at most 0) to at least `end`, in seconds.
    pub fn new(start: f64, end: f64) -> Grid {
        let lead = (-start * GRID_RATE as f64).ceil() as usize;
        Grid { lead, count: lead + (end * GRID_RATE as f64).ceil() as usize + 1 }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether the grid has no points; it always has.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The time of a point, in seconds.
    pub fn time(&self, index: usize) -> f64 {
        (index as f64 - self.lead as f64) / GRID_RATE as f64
    }

    /// The point at or right before `time`, or the nearest there is.
    pub fn at(&self, time: f64) -> usize {
        ((time * GRID_RATE as f64).floor() + self.lead as f64).clamp(0.0, (self.count - 1) as f64) as usize
    }

    /// All times in order.
    pub fn times(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.count).map(|index| self.time(index))
    }

    /// The point of frame `frame` of a clip at `rate` frames per second.
    pub fn of_frame(&self, frame: usize, rate: usize) -> usize {
        self.lead + frame * GRID_RATE / rate
    }

    /// A length of time in grid points.
    pub fn points(seconds: f64) -> f64 {
        seconds * GRID_RATE as f64
    }
}
