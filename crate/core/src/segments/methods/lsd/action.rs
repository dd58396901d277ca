//! An action as a range of motifs.

use std::ops::Range;

/// Range of motifs that form an action.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Action {
    /// The motifs.
    pub motifs: Range<usize>,
    /// Classes of the cycle, from the smallest; empty if the action does not repeat.
    pub cycle: Vec<usize>,
}
