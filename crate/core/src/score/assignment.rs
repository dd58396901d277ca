//! Assignment of rows to columns with the maximum total value.

/// Returns the column of each row such that the total of `values` is maximal; `None` for rows without a
/// column, if there are fewer columns than rows. Each column is assigned once at most.
///
/// The Hungarian method with potentials (Kuhn 1955, Munkres 1957), in cubic time.
pub(crate) fn best_assignment(values: &[Vec<f64>]) -> Vec<Option<usize>> {
    let rows = values.len();
    let columns = values.iter().map(Vec::len).max().unwrap_or(0);
    let size = rows.max(columns);
    // Rows and columns count from 1; 0 is the start of each search. Missing values cost 0.
    let cost = |row: usize, column: usize| {
        -values.get(row - 1).and_then(|row| row.get(column - 1)).copied().unwrap_or(0.0)
    };
    let (mut row_potentials, mut column_potentials) = (vec![0.0; size + 1], vec![0.0; size + 1]);
    let mut row_of = vec![0; size + 1];
    for row in 1..=size {
        row_of[0] = row;
        let mut column = 0;
        let mut slacks = vec![f64::INFINITY; size + 1];
        let mut previous = vec![0; size + 1];
        let mut is_visited = vec![false; size + 1];
        while row_of[column] != 0 {
            is_visited[column] = true;
            let (mut least, mut next) = (f64::INFINITY, 0);
            for other in (1..=size).filter(|&other| !is_visited[other]) {
                let current = row_of[column];
                let slack = cost(current, other) - row_potentials[current] - column_potentials[other];
                if slack < slacks[other] {
                    slacks[other] = slack;
                    previous[other] = column;
                }
                if slacks[other] < least {
                    (least, next) = (slacks[other], other);
                }
            }
            for other in 0..=size {
                if is_visited[other] {
                    row_potentials[row_of[other]] += least;
                    column_potentials[other] -= least;
                } else {
                    slacks[other] -= least;
                }
            }
            column = next;
        }
        while column != 0 {
            row_of[column] = row_of[previous[column]];
            column = previous[column];
        }
    }
    let mut assigned = vec![None; rows];
    for (column, row) in row_of.into_iter().skip(1).take(columns).enumerate() {
        if let Some(assigned) = assigned.get_mut(row - 1) {
            *assigned = Some(column);
        }
    }
    assigned
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn total(values: &[Vec<f64>], assigned: &[Option<usize>]) -> f64 {
        values.iter().zip(assigned).filter_map(|(row, column)| Some(row[(*column)?])).sum()
    }

    /// Returns the maximum total by trying all assignments.
    fn exhaustive(values: &[Vec<f64>], row: usize, is_used: &mut Vec<bool>) -> f64 {
        if row == values.len() {
            return 0.0;
        }
        let mut best = exhaustive(values, row + 1, is_used);
        for column in 0..values[row].len() {
            if !is_used[column] {
                is_used[column] = true;
                best = best.max(values[row][column] + exhaustive(values, row + 1, is_used));
                is_used[column] = false;
            }
        }
        best
    }

    #[test]
    fn the_largest_value_is_not_always_assigned() {
        let values = [vec![9.0, 8.0], vec![8.0, 1.0]];
        assert_eq!(best_assignment(&values), [Some(1), Some(0)]);
        assert_eq!(best_assignment(&[vec![1.0], vec![2.0]]), [None, Some(0)]);
        assert_eq!(best_assignment(&[vec![1.0, 2.0]]), [Some(1)]);
        assert_eq!(best_assignment(&[]), []);
        assert_eq!(best_assignment(&[vec![], vec![]]), [None, None]);
    }

    proptest! {
        #[test]
        fn the_total_is_maximal(
            values in (1_usize..5, 1_usize..6).prop_flat_map(|(rows, columns)| {
                prop::collection::vec(prop::collection::vec(0_u8..20, columns), rows)
            }),
        ) {
            let values: Vec<Vec<f64>> =
                values.iter().map(|row| row.iter().map(|&value| f64::from(value)).collect()).collect();
            let assigned = best_assignment(&values);
            let best = exhaustive(&values, 0, &mut vec![false; values[0].len()]);
            prop_assert_eq!(total(&values, &assigned), best);
            let mut columns: Vec<usize> = assigned.into_iter().flatten().collect();
            columns.sort_unstable();
            prop_assert!(columns.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }
}
