//! Uniform time grid on which motions are simulated.

/// Sampling rate of the grid, in Hz: a multiple of 24, 30, 60 and 120, so that a motion does not
/// depend on the frame rate of the clip.
pub const GRID_RATE: usize = 240;

/// Uniformly spaced times at [`GRID_RATE`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeGrid {
    /// Number of points before time 0.
    lead: usize,
    /// Number of points.
    count: usize,
}

impl TimeGrid {
    /// Creates the grid from `start` (at most 0) to at least `end`, in seconds.
    pub fn new(start: f64, end: f64) -> TimeGrid {
        let lead = (-start * GRID_RATE as f64).ceil() as usize;
        TimeGrid { lead, count: lead + (end * GRID_RATE as f64).ceil() as usize + 1 }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.count
    }

    /// True if the grid has no points, which never happens.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Returns the time of a point, in seconds.
    pub fn time(&self, index: usize) -> f64 {
        (index as f64 - self.lead as f64) / GRID_RATE as f64
    }

    /// Returns the last point at or before `time`, clamped to the grid.
    pub fn point_at(&self, time: f64) -> usize {
        ((time * GRID_RATE as f64).floor() + self.lead as f64).clamp(0.0, (self.count - 1) as f64) as usize
    }

    /// Iterates over the times of all points.
    pub fn times(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.count).map(|index| self.time(index))
    }

    /// Returns the point of a frame of a clip at `rate` frames per second.
    pub fn frame_point(&self, frame: usize, rate: usize) -> usize {
        self.lead + frame * GRID_RATE / rate
    }

    /// Converts a duration in seconds to grid points.
    pub fn points(seconds: f64) -> f64 {
        seconds * GRID_RATE as f64
    }
}
