//! Sorting by numbers.
//!
//! The standard library's sort is compiled anew for each kind of thing that it sorts, and takes ten
//! kilobytes of the browser's module each time: here all kinds share one for floats and one for frames.

/// The places of `keys`, that of the least first; equal ones stay in order.
pub(crate) fn ascending(keys: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..keys.len()).collect();
    order.sort_unstable_by(|&a, &b| keys[a].total_cmp(&keys[b]).then(a.cmp(&b)));
    order
}

/// The places of `keys`, that of the greatest first; equal ones stay in order.
pub(crate) fn descending(keys: &[f64]) -> Vec<usize> {
    ascending(&keys.iter().map(|key| -key).collect::<Vec<_>>())
}

/// Items in the order of two whole numbers each, such as first frame and end; equal ones stay in order.
pub(crate) fn by_frames<T>(items: Vec<T>, frames: impl Fn(&T) -> (usize, usize)) -> Vec<T> {
    let mut order: Vec<_> = items.iter().enumerate().map(|(place, item)| (frames(item), place)).collect();
    order.sort_unstable();
    let mut items: Vec<Option<T>> = items.into_iter().map(Some).collect();
    order.into_iter().filter_map(|(_, place)| items[place].take()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_ones_stay_in_order() {
        let keys = [2.0, -1.0, 2.0, 0.5];
        assert_eq!(ascending(&keys), [1, 3, 0, 2]);
        assert_eq!(descending(&keys), [0, 2, 3, 1]);
        let items = vec![(5, 'a'), (3, 'b'), (5, 'c'), (4, 'd')];
        assert_eq!(by_frames(items, |item| (item.0, 0)), [(3, 'b'), (4, 'd'), (5, 'a'), (5, 'c')]);
    }
}
