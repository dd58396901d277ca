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

/// Sorts items by a number each, in ascending order; equal items keep their order.
pub(crate) fn sort_by_number<T>(items: Vec<T>, number: impl Fn(&T) -> f64) -> Vec<T> {
    let order = argsort(&items.iter().map(number).collect::<Vec<_>>());
    in_order(items, order.into_iter())
}

/// Sorts items by a number each, in descending order; equal items keep their order.
pub(crate) fn sort_descending<T>(items: Vec<T>, number: impl Fn(&T) -> f64) -> Vec<T> {
    sort_by_number(items, |item| -number(item))
}

/// Sorts items by a pair of integers each, such as first frame and end; equal items keep their order.
pub(crate) fn sort_by_frames<T>(items: Vec<T>, frames: impl Fn(&T) -> (usize, usize)) -> Vec<T> {
    let mut order: Vec<_> = items.iter().enumerate().map(|(index, item)| (frames(item), index)).collect();
    order.sort_unstable();
    in_order(items, order.into_iter().map(|(_, index)| index))
}

/// Truncates pairs of a number and an index to the `max` smallest, in no particular order; of equal numbers, those
/// with smaller indices are smaller.
pub(crate) fn truncate_to_smallest(pairs: &mut Vec<(f64, usize)>, max: usize) {
    if max < pairs.len() {
        pairs.select_nth_unstable_by(max, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        pairs.truncate(max);
    }
}

/// Returns the items in the order of the indices, each of which occurs once.
fn in_order<T>(items: Vec<T>, order: impl Iterator<Item = usize>) -> Vec<T> {
    let mut items: Vec<Option<T>> = items.into_iter().map(Some).collect();
    order.filter_map(|index| items[index].take()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_keys_keep_their_order() {
        let keys = [2.0, -1.0, 2.0, 0.5];
        assert_eq!(argsort(&keys), [1, 3, 0, 2]);
        assert_eq!(argsort_descending(&keys), [0, 2, 3, 1]);
        let items = vec![(5_u32, 'a'), (3, 'b'), (5, 'c'), (4, 'd')];
        assert_eq!(
            sort_by_number(items.clone(), |item| item.0.into()),
            [(3, 'b'), (4, 'd'), (5, 'a'), (5, 'c')]
        );
        assert_eq!(
            sort_descending(items.clone(), |item| item.0.into()),
            [(5, 'a'), (5, 'c'), (4, 'd'), (3, 'b')]
        );
        let items: Vec<(usize, char)> =
            items.into_iter().map(|(number, name)| (number as usize, name)).collect();
        assert_eq!(sort_by_frames(items, |item| (item.0, 0)), [(3, 'b'), (4, 'd'), (5, 'a'), (5, 'c')]);
    }
}
