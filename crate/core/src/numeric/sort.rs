//! Sorting by numeric keys.
//!
//! The standard library's sort is compiled once per item type, at ten kilobytes of the WebAssembly
//! module each. These functions share one instance for float keys and one for frame keys.

/// Returns the indices that sort `keys` in ascending order; equal keys keep their order.
pub(crate) fn argsort(keys: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..keys.len()).collect();
    order.sort_unstable_by(|&a, &b| keys[a].total_cmp(&keys[b]).then(a.cmp(&b)));
    order
}

/// Returns the indices that sort `keys` in descending order; equal keys keep their order.
pub(crate) fn argsort_descending(keys: &[f64]) -> Vec<usize> {
    argsort(&keys.iter().map(|key| -key).collect::<Vec<_>>())
}

/// Sorts items by a pair of integers each, such as first frame and end; equal items keep their order.
pub(crate) fn sort_by_frames<T>(items: Vec<T>, frames: impl Fn(&T) -> (usize, usize)) -> Vec<T> {
    let mut order: Vec<_> = items.iter().enumerate().map(|(index, item)| (frames(item), index)).collect();
    order.sort_unstable();
    let mut items: Vec<Option<T>> = items.into_iter().map(Some).collect();
    order.into_iter().filter_map(|(_, index)| items[index].take()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_keys_keep_their_order() {
        let keys = [2.0, -1.0, 2.0, 0.5];
        assert_eq!(argsort(&keys), [1, 3, 0, 2]);
        assert_eq!(argsort_descending(&keys), [0, 2, 3, 1]);
        let items = vec![(5, 'a'), (3, 'b'), (5, 'c'), (4, 'd')];
        assert_eq!(sort_by_frames(items, |item| (item.0, 0)), [(3, 'b'), (4, 'd'), (5, 'a'), (5, 'c')]);
    }
}
