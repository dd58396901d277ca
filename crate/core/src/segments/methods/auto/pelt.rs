//! PELT: optimal segmentation by dynamic programming with exact pruning (Killick, Fearnhead and
//! Eckley 2012).

use crate::segments::progress::{Cancelled, Progress};

/// Number of steps between two progress reports.
const PROGRESS_INTERVAL: usize = 256;

/// Returns the cuts of `0..count` with the minimum sum of segment costs and penalties.
///
/// Segments have at least `min_length` elements. `cost(start, end)` must not increase when a
/// segment is split. Of several optimal segmentations the result has the longest last segments.
pub(crate) fn optimal_cuts(
    count: usize,
    min_length: usize,
    penalty: f64,
    cost: impl Fn(usize, usize) -> f64,
    progress: &mut Progress,
) -> Result<Vec<usize>, Cancelled> {
    // Minimum cost of 0..end and the start of its last segment.
    let mut best = vec![(f64::INFINITY, 0); count + 1];
    best[0].0 = 0.0;
    // Possible starts of the last segment, each with the end from which it is excluded.
    let mut starts: Vec<(usize, usize)> = Vec::new();
    for end in min_length..=count {
        if end % PROGRESS_INTERVAL == 0 {
            progress(end as f64 / count as f64)?;
        }
        let newest = end - min_length;
        if best[newest].0.is_finite() {
            starts.push((newest, usize::MAX));
        }
        let totals: Vec<f64> = starts.iter().map(|&(start, _)| best[start].0 + cost(start, end)).collect();
        for (&(start, _), total) in starts.iter().zip(&totals) {
            if total + penalty < best[end].0 {
                best[end] = (total + penalty, start);
            }
        }
        // A start that costs more than an additional cut here cannot be optimal once a segment that
        // starts here may end.
        for ((_, excluded_from), total) in starts.iter_mut().zip(totals) {
            if total > best[end].0 {
                *excluded_from = (*excluded_from).min(end + min_length);
            }
        }
        starts.retain(|&(_, excluded_from)| end + 1 < excluded_from);
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

    /// Returns the sum of squared distances from the mean.
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
    fn steps_are_cut_at_their_rise() {
        let values = [0.0, 0.0, 0.1, 0.0, 5.0, 5.1, 5.0, 5.0, 5.0];
        assert_eq!(optimal_cuts(9, 2, 1.0, variation(&values), &mut |_| Ok(())), Ok(vec![4]));
        assert_eq!(optimal_cuts(9, 2, 100.0, variation(&values), &mut |_| Ok(())), Ok(vec![]));
        assert_eq!(optimal_cuts(1, 2, 1.0, variation(&values), &mut |_| Ok(())), Ok(vec![]));
    }

    #[test]
    fn can_be_cancelled() {
        let values = vec![0.0; 2 * PROGRESS_INTERVAL];
        let mut reports = 0;
        let mut progress = |_| {
            reports += 1;
            Err(Cancelled)
        };
        let result = optimal_cuts(values.len(), 2, 1.0, variation(&values), &mut progress);
        assert_eq!((result, reports), (Err(Cancelled), 1));
    }

    proptest! {
        #[test]
        fn pruning_preserves_the_optimum(
            values in prop::collection::vec(0.0..4.0_f64, 4..14),
            penalty in 0.1..6.0_f64,
            min_length in 1_usize..4,
        ) {
            let count = values.len();
            let cost = variation(&values);
            let found = optimal_cuts(count, min_length, penalty, &cost, &mut |_| Ok(())).unwrap();
            // Every segmentation is a subset of the inner positions.
            let cheapest = (0_u32..1 << (count - 1))
                .map(|set| (1..count).filter(|position| set >> (position - 1) & 1 == 1).collect::<Vec<_>>())
                .filter(|cuts| {
                    let bounds: Vec<usize> = std::iter::once(0).chain(cuts.iter().copied()).chain([count]).collect();
                    bounds.windows(2).all(|pair| pair[1] - pair[0] >= min_length)
                })
                .map(|cuts| total(&cuts, count, penalty, &cost))
                .fold(f64::INFINITY, f64::min);
            prop_assert!((total(&found, count, penalty, &cost) - cheapest).abs() < 1e-9);
        }
    }
}
