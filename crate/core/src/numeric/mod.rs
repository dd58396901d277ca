//! Numerical helpers, independent of motion data.

pub(crate) mod interpolate;
pub(crate) mod sort;
pub(crate) mod stats;

/// Returns the values within `half` indices on either side of an index.
pub(crate) fn around<T>(values: &[T], index: usize, half: usize) -> &[T] {
    &values[index.saturating_sub(half)..(index + half + 1).min(values.len())]
}
