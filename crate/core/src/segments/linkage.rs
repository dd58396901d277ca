//! Agglomerative clustering with average linkage, cut at a distance.

use crate::segments::progress::Cancelled;

/// Returns the first member of each item's group.
///
/// Groups are merged while their average distance is at most `max_distance`, the nearest first. All
/// distances between the first `max_compared` items are computed, which limits memory and time; further
/// items join the group whose first member is nearest, or start a group. `checkpoint` is called regularly
/// and may cancel.
pub(crate) fn groups(
    count: usize,
    max_compared: usize,
    distance: &dyn Fn(usize, usize) -> f64,
    max_distance: f64,
    checkpoint: &mut dyn FnMut() -> Result<(), Cancelled>,
) -> Result<Vec<usize>, Cancelled> {
    let compared = count.min(max_compared);
    let mut rows = Vec::with_capacity(compared);
    for item in 0..compared {
        checkpoint()?;
        rows.push((0..item).map(|other| distance(other, item) as f32).collect());
    }
    let mut first_members = average_linkage(rows, max_distance);
    let mut representatives: Vec<usize> = (0..compared).filter(|&item| first_members[item] == item).collect();
    for item in compared..count {
        checkpoint()?;
        let candidates =
            representatives.iter().map(|&representative| (distance(representative, item), representative));
        match candidates.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((distance, representative)) if distance <= max_distance => {
                first_members.push(representative)
            }
            _ => {
                first_members.push(item);
                representatives.push(item);
            }
        }
    }
    Ok(first_members)
}

/// Clusters items with all distances given: row i has the distances to the i items before, in single precision,
/// since they need most of the memory.
///
/// Nearest-neighbour chain: follows nearest neighbours until two groups are mutual nearest
/// neighbours, and merges them. With average linkage this gives the same groups as merging the
/// nearest pair each time (Murtagh, Computer Journal 26, 1983), in quadratic time.
fn average_linkage(mut rows: Vec<Vec<f32>>, max_distance: f64) -> Vec<usize> {
    let mut first_members: Vec<usize> = (0..rows.len()).collect();
    let mut sizes = vec![1.0; rows.len()];
    let mut open = first_members.clone();
    let mut chain: Vec<usize> = Vec::new();
    let distance = |rows: &[Vec<f32>], a: usize, b: usize| f64::from(rows[a.max(b)][a.min(b)]);
    while let Some(tip) = chain.pop().or_else(|| open.first().copied()) {
        let others = open.iter().filter(|&&other| other != tip);
        let candidates =
            chain.last().into_iter().chain(others).map(|&other| (distance(&rows, tip, other), other));
        // Of equal distances, min_by takes the first: the previous group of the chain.
        let nearest =
            candidates.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(distance, _)| *distance <= max_distance);
        let Some((_, nearest)) = nearest else {
            // No other group will ever be nearer.
            open.retain(|&other| other != tip);
            continue;
        };
        if chain.last() != Some(&nearest) {
            chain.extend([tip, nearest]);
            continue;
        }
        chain.pop();
        let (first, merged) = (tip.min(nearest), tip.max(nearest));
        open.retain(|&other| other != merged);
        let (a, b) = (sizes[first], sizes[merged]);
        for &other in open.iter().filter(|&&other| other != first) {
            let mean = (a * distance(&rows, first, other) + b * distance(&rows, merged, other)) / (a + b);
            rows[first.max(other)][first.min(other)] = mean as f32;
        }
        sizes[first] += sizes[merged];
        first_members.iter_mut().filter(|group| **group == merged).for_each(|group| *group = first);
    }
    first_members
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const MAX_COMPARED: usize = 100;

    fn group_values(values: &[f64], max_distance: f64) -> Vec<usize> {
        groups(
            values.len(),
            MAX_COMPARED,
            &|a, b| (values[a] - values[b]).abs(),
            max_distance,
            &mut || Ok(()),
        )
        .unwrap()
    }

    /// Merges the nearest pair each time, with every mean computed from scratch.
    fn merge_nearest_pairs(values: &[f64], max_distance: f64) -> Vec<usize> {
        let mut all: Vec<Vec<usize>> = (0..values.len()).map(|item| vec![item]).collect();
        loop {
            let mut best = (f64::INFINITY, 0, 0);
            for b in 0..all.len() {
                for a in 0..b {
                    let pairs = all[a].iter().flat_map(|&i| all[b].iter().map(move |&j| (i, j)));
                    let sum: f64 = pairs.map(|(i, j)| (values[i] - values[j]).abs()).sum();
                    let mean = sum / (all[a].len() * all[b].len()) as f64;
                    best = if mean < best.0 { (mean, a, b) } else { best };
                }
            }
            if best.0 > max_distance {
                break;
            }
            let merged = all.remove(best.2);
            all[best.1].extend(merged);
        }
        (0..values.len())
            .map(|item| {
                let group = all.iter().find(|group| group.contains(&item)).unwrap();
                *group.iter().min().unwrap()
            })
            .collect()
    }

    #[test]
    fn nearby_values_form_groups() {
        assert_eq!(group_values(&[0.0, 5.0, 0.4, 5.3, 0.8, 9.0], 1.0), [0, 1, 0, 1, 0, 5]);
        assert_eq!(group_values(&[3.0; 4], 1.0), [0; 4]);
        assert_eq!(group_values(&[], 1.0), [0; 0]);
    }

    #[test]
    fn further_items_join_existing_groups() {
        let values: Vec<f64> =
            (0..MAX_COMPARED + 300).map(|i| (i % 3) as f64 * 10.0 + (i % 7) as f64 * 0.05).collect();
        let first_members = group_values(&values, 1.0);
        assert!(first_members.iter().enumerate().all(|(item, &first)| first == item % 3));
        let mut late = values;
        late.extend([77.0, 77.2]);
        assert_eq!(group_values(&late, 1.0)[MAX_COMPARED + 300..], [MAX_COMPARED + 300, MAX_COMPARED + 300]);
    }

    #[test]
    fn can_be_cancelled() {
        assert_eq!(groups(3, 9, &|_, _| 0.0, 1.0, &mut || Err(Cancelled)), Err(Cancelled));
    }

    proptest! {
        #[test]
        fn agrees_with_merging_nearest_pairs(values in prop::collection::vec(0.0..8.0_f64, 0..24)) {
            prop_assert_eq!(group_values(&values, 1.0), merge_nearest_pairs(&values, 1.0));
        }
    }
}
