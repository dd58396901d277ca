//! Groups of what is alike: average linkage, cut at a distance.

use crate::segments::task::Cancelled;

/// Things that are all compared with each other. More would take too much room: those join
/// the group whose first member is nearest, or found another.
const MOST: usize = 2048;

/// The first member of each thing's group.
///
/// Groups whose members are less than `apart` from each other on average become one, the
/// nearest first. `alive` is asked now and then whether to go on.
pub(crate) fn groups(
    count: usize,
    distance: impl Fn(usize, usize) -> f64,
    apart: f64,
    alive: &mut impl FnMut() -> Result<(), Cancelled>,
) -> Result<Vec<usize>, Cancelled> {
    let compared = count.min(MOST);
    let mut rows = Vec::with_capacity(compared);
    for thing in 0..compared {
        alive()?;
        rows.push((0..thing).map(|other| distance(other, thing)).collect());
    }
    let mut heads = linked(rows, apart);
    let mut founders: Vec<usize> = (0..compared).filter(|&thing| heads[thing] == thing).collect();
    for thing in compared..count {
        alive()?;
        let far = founders.iter().map(|&founder| (distance(founder, thing), founder));
        match far.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((near, founder)) if near <= apart => heads.push(founder),
            _ => {
                heads.push(thing);
                founders.push(thing);
            }
        }
    }
    Ok(heads)
}

/// The same from all distances: row i has those to the i things before.
///
/// From any group, go to the nearest and on to the nearest of that, until two are each other's
/// nearest and become one. With average linkage that makes the same groups as taking the nearest
/// pair of all each time (Murtagh, Computer Journal 26, 1983), in time that grows with the square.
fn linked(mut rows: Vec<Vec<f64>>, apart: f64) -> Vec<usize> {
    let mut heads: Vec<usize> = (0..rows.len()).collect();
    let mut sizes = vec![1.0; rows.len()];
    let mut open = heads.clone();
    let mut chain: Vec<usize> = Vec::new();
    let between = |rows: &[Vec<f64>], a: usize, b: usize| rows[a.max(b)][a.min(b)];
    while let Some(tip) = chain.pop().or_else(|| open.first().copied()) {
        let others = open.iter().filter(|&&other| other != tip);
        let far = chain.last().into_iter().chain(others).map(|&other| (between(&rows, tip, other), other));
        // Of equals, min_by takes the first: the one that the chain came from.
        let nearest = far.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(near, _)| *near <= apart);
        let Some((_, nearest)) = nearest else {
            // Nothing will ever be nearer.
            open.retain(|&other| other != tip);
            continue;
        };
        if chain.last() != Some(&nearest) {
            chain.extend([tip, nearest]);
            continue;
        }
        chain.pop();
        let (head, gone) = (tip.min(nearest), tip.max(nearest));
        open.retain(|&other| other != gone);
        let (a, b) = (sizes[head], sizes[gone]);
        for &other in open.iter().filter(|&&other| other != head) {
            let mean = (a * between(&rows, head, other) + b * between(&rows, gone, other)) / (a + b);
            rows[head.max(other)][head.min(other)] = mean;
        }
        sizes[head] += sizes[gone];
        heads.iter_mut().filter(|of| **of == gone).for_each(|of| *of = head);
    }
    heads
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn grouped(values: &[f64], apart: f64) -> Vec<usize> {
        groups(values.len(), |a, b| (values[a] - values[b]).abs(), apart, &mut || Ok(())).unwrap()
    }

    /// The nearest pair of all each time, every mean taken anew.
    fn nearest_pairs(values: &[f64], apart: f64) -> Vec<usize> {
        let mut all: Vec<Vec<usize>> = (0..values.len()).map(|thing| vec![thing]).collect();
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
            if best.0 > apart {
                break;
            }
            let gone = all.remove(best.2);
            all[best.1].extend(gone);
        }
        (0..values.len())
            .map(|thing| {
                let group = all.iter().find(|group| group.contains(&thing)).unwrap();
                *group.iter().min().unwrap()
            })
            .collect()
    }

    #[test]
    fn heaps_are_groups() {
        assert_eq!(grouped(&[0.0, 5.0, 0.4, 5.3, 0.8, 9.0], 1.0), [0, 1, 0, 1, 0, 5]);
        assert_eq!(grouped(&[3.0; 4], 1.0), [0; 4]);
        assert_eq!(grouped(&[], 1.0), [0; 0]);
    }

    #[test]
    fn many_things_join_the_groups_of_the_first() {
        let values: Vec<f64> =
            (0..MOST + 300).map(|i| (i % 3) as f64 * 10.0 + (i % 7) as f64 * 0.05).collect();
        let heads = grouped(&values, 1.0);
        assert!(heads.iter().enumerate().all(|(thing, &head)| head == thing % 3));
        let mut late = values;
        late.extend([77.0, 77.2]);
        assert_eq!(grouped(&late, 1.0)[MOST + 300..], [MOST + 300, MOST + 300]);
    }

    #[test]
    fn it_can_be_stopped() {
        assert_eq!(groups(3, |_, _| 0.0, 1.0, &mut || Err(Cancelled)), Err(Cancelled));
    }

    proptest! {
        #[test]
        fn agrees_with_nearest_pairs(values in prop::collection::vec(0.0..8.0_f64, 0..24)) {
            prop_assert_eq!(grouped(&values, 1.0), nearest_pairs(&values, 1.0));
        }
    }
}
