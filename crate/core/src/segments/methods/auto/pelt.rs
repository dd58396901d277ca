//! The cheapest way to cut: dynamic programming with exact pruning (Killick, Fearnhead and Eckley 2012).

use crate::segments::task::{Cancelled, Progress};

/// How many places are passed between two reports of progress.
const REPORT: usize = 256;

/// Places to cut `0..count` at, so that the costs of all segments and `penalty` for each are least.
///
/// Segments are at least `shortest` long. `cost(start, end)` must never grow when a segment
/// is cut in two. Of several cheapest ways it is the one whose last segments are longest.
pub(crate) fn cuts(
    count: usize,
    shortest: usize,
    penalty: f64,
    cost: impl Fn(usize, usize) -> f64,
    progress: &mut Progress,
) -> Result<Vec<usize>, Cancelled> {
    // The least cost of 0..end and where its last segment starts.
    let mut best = vec![(f64::INFINITY, 0); count + 1];
    best[0].0 = 0.0;
    // Starts that the last segment may still have, and from which end on they may not.
    let mut starts: Vec<(usize, usize)> = Vec::new();
    for end in shortest..=count {
        if end % REPORT == 0 {
            progress(end as f64 / count as f64)?;
        }
        let newest = end - shortest;
        if best[newest].0.is_finite() {
            starts.push((newest, usize::MAX));
        }
        let totals: Vec<f64> = starts.iter().map(|&(start, _)| best[start].0 + cost(start, end)).collect();
        for (&(start, _), total) in starts.iter().zip(&totals) {
            if total + penalty < best[end].0 {
                best[end] = (total + penalty, start);
            }
        }
        // A start that is dearer than to cut here as well can never win again, once a
        // segment that starts here may end.
        for ((_, last), total) in starts.iter_mut().zip(totals) {
            if total > best[end].0 {
                *last = (*last).min(end + shortest);
            }
        }
        starts.retain(|&(_, last)| end + 1 < last);
    }
    let mut cuts = Vec::new();
    let mut end = if best[count].0.is_finite() { count } else { 0 };
    while end > 0 {
        end = best[end].1;
        if end > 0 {
            cuts.push(end);
        }
    }
    cuts.reverse();
    Ok(cuts)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Sum of squared distances from the mean.
    fn variation(values: &[f64]) -> impl Fn(usize, usize) -> f64 {
        |start, end| {
            let run = &values[start..end];
            let mean = run.iter().sum::<f64>() / run.len() as f64;
            run.iter().map(|value| (value - mean).powi(2)).sum()
        }
    }

    fn total(cuts: &[usize], count: usize, penalty: f64, cost: impl Fn(usize, usize) -> f64) -> f64 {
        let bounds: Vec<usize> = std::iter::once(0).chain(cuts.iter().copied()).chain([count]).collect();
        bounds.windows(2).map(|pair| cost(pair[0], pair[1]) + penalty).sum()
    }

    #[test]
    fn steps_are_cut_where_they_rise() {
        let values = [0.0, 0.0, 0.1, 0.0, 5.0, 5.1, 5.0, 5.0, 5.0];
        assert_eq!(cuts(9, 2, 1.0, variation(&values), &mut |_| Ok(())), Ok(vec![4]));
        assert_eq!(cuts(9, 2, 100.0, variation(&values), &mut |_| Ok(())), Ok(vec![]));
        assert_eq!(cuts(9, 2, 1.0, variation(&values), &mut |_| Err(Cancelled)), Ok(vec![4]));
        assert_eq!(cuts(1, 2, 1.0, variation(&values), &mut |_| Ok(())), Ok(vec![]));
    }

    proptest! {
        #[test]
        fn pruning_loses_nothing(
            values in prop::collection::vec(0.0..4.0_f64, 4..14),
            penalty in 0.1..6.0_f64,
            shortest in 1_usize..4,
        ) {
            let count = values.len();
            let cost = variation(&values);
            let found = cuts(count, shortest, penalty, &cost, &mut |_| Ok(())).unwrap();
            // Every way to cut is a subset of the places between.
            let cheapest = (0_u32..1 << (count - 1))
                .map(|set| (1..count).filter(|place| set >> (place - 1) & 1 == 1).collect::<Vec<_>>())
                .filter(|cuts| {
                    let bounds: Vec<usize> = std::iter::once(0).chain(cuts.iter().copied()).chain([count]).collect();
                    bounds.windows(2).all(|pair| pair[1] - pair[0] >= shortest)
                })
                .map(|cuts| total(&cuts, count, penalty, &cost))
                .fold(f64::INFINITY, f64::min);
            prop_assert!((total(&found, count, penalty, &cost) - cheapest).abs() < 1e-9);
        }
    }
}
