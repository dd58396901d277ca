//! Products and Cholesky factors of dense matrices for processors with few vector lanes.
//!
//! Four rows of a matrix form a band, stored column by column. The critical loop multiplies two
//! bands into a 4 × 4 block that stays in registers.

use nalgebra::{DMatrix, DVector};

/// Number of rows of a band.
pub(crate) const WIDTH: usize = 4;
/// Column of a band.
pub(crate) type Quad = [f64; WIDTH];

/// Matrix in bands, padded with zeros to whole blocks.
pub(crate) struct Bands {
    rows: usize,
    bands: Vec<Vec<Quad>>,
}

impl Bands {
    pub fn new(matrix: &DMatrix<f64>) -> Bands {
        let (rows, columns) = matrix.shape();
        let mut bands = vec![vec![Quad::default(); round_up(columns)]; rows.div_ceil(WIDTH)];
        for (index, column) in matrix.column_iter().enumerate() {
            for (band, values) in bands.iter_mut().zip(column.as_slice().chunks(WIDTH)) {
                band[index][..values.len()].copy_from_slice(values);
            }
        }
        Bands { rows, bands }
    }

    /// Creates the lower triangle of a symmetric matrix from bands up to the diagonal block.
    pub fn lower_triangle(rows: usize, bands: impl Iterator<Item = Vec<Quad>>) -> Bands {
        Bands { rows, bands: bands.collect() }
    }

    /// Returns this matrix times the transpose of another.
    pub fn multiply_transposed(&self, other: &Bands) -> DMatrix<f64> {
        let mut product = DMatrix::zeros(self.rows, other.rows);
        for (i, a) in self.bands.iter().enumerate() {
            for (j, b) in other.bands.iter().enumerate() {
                write_block(&mut product, i, j, block_product(a, b));
            }
        }
        product
    }
}

/// Cholesky factor L of a positive definite matrix LLᵀ.
pub(crate) struct Factor {
    rows: usize,
    /// Lower triangle, with the reciprocals of the diagonal.
    bands: Vec<Vec<Quad>>,
}

impl Factor {
    /// Factors a matrix given by its lower triangle; `None` if it is not positive definite.
    pub fn new(lower: Bands) -> Option<Factor> {
        let Bands { rows, mut bands } = lower;
        if let Some(last) = bands.last_mut() {
            (rows..round_up(rows)).for_each(|beyond| last[beyond][beyond % WIDTH] = 1.0);
        }
        for index in 0..bands.len() {
            let (above, rest) = bands.split_at_mut(index);
            let band = &mut rest[0];
            solve_right(band, above, 0);
            let (done, corner) = band.split_at_mut(WIDTH * index);
            let corner = corner.first_chunk_mut()?;
            subtract_product(corner, done, done);
            factor_corner(corner)?;
        }
        Some(Factor { rows, bands })
    }

    /// Solves the linear system with the right-hand side `right`.
    pub fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let mut solution = right.clone().resize_vertically(round_up(self.rows), 0.0);
        let values = solution.as_mut_slice();
        for (index, band) in self.bands.iter().enumerate() {
            let (done, rest) = values.split_at_mut(WIDTH * index);
            let mut quad = Quad::default();
            quad.copy_from_slice(&rest[..WIDTH]);
            for (column, &value) in band.iter().zip(&*done) {
                axpy(&mut quad, -value, column);
            }
            let corner = &band[WIDTH * index..];
            for column in 0..WIDTH {
                quad[column] *= corner[column][column];
                for row in column + 1..WIDTH {
                    quad[row] -= quad[column] * corner[column][row];
                }
            }
            rest[..WIDTH].copy_from_slice(&quad);
        }
        for (index, band) in self.bands.iter().enumerate().rev() {
            let (before, rest) = values.split_at_mut(WIDTH * index);
            let corner = &band[WIDTH * index..];
            for column in (0..WIDTH).rev() {
                for row in column + 1..WIDTH {
                    rest[column] -= rest[row] * corner[column][row];
                }
                rest[column] *= corner[column][column];
            }
            for (value, column) in before.iter_mut().zip(band) {
                *value -= (0..WIDTH).map(|row| column[row] * rest[row]).sum::<f64>();
            }
        }
        solution.resize_vertically(self.rows, 0.0)
    }

    /// Returns the inverse of the matrix.
    pub fn inverse(&self) -> DMatrix<f64> {
        let columns = WIDTH * self.bands.len();
        // L⁻ᵀ, an upper triangle.
        let inverted: Vec<Vec<Quad>> = (0..self.bands.len())
            .map(|index| {
                let mut column_band = vec![Quad::default(); columns];
                (0..WIDTH).for_each(|row| column_band[WIDTH * index + row][row] = 1.0);
                solve_right(&mut column_band, &self.bands, index);
                column_band
            })
            .collect();
        let mut inverse = DMatrix::zeros(self.rows, self.rows);
        for (i, a) in inverted.iter().enumerate() {
            for (j, b) in inverted[..=i].iter().enumerate() {
                write_block(&mut inverse, i, j, block_product(&a[WIDTH * i..], &b[WIDTH * i..]));
            }
        }
        inverse.fill_upper_triangle_with_lower_triangle();
        inverse
    }
}

/// Rounds up to whole blocks.
fn round_up(rows: usize) -> usize {
    rows.next_multiple_of(WIDTH)
}

/// Replaces B by X with X·Lᵀ = B; blocks of B before `first` are 0.
fn solve_right(band: &mut [Quad], lower: &[Vec<Quad>], first: usize) {
    for (index, other) in lower.iter().enumerate().skip(first) {
        let (done, rest) = band.split_at_mut(WIDTH * index);
        let Some(block) = rest.first_chunk_mut() else { return };
        subtract_product(block, &done[WIDTH * first..], &other[WIDTH * first..WIDTH * index]);
        let corner = &other[WIDTH * index..][..WIDTH];
        for column in 0..WIDTH {
            block[column] = block[column].map(|value| value * corner[column][column]);
            for right in column + 1..WIDTH {
                let solved = block[column];
                axpy(&mut block[right], -corner[column][right], &solved);
            }
        }
    }
}

/// Factors a diagonal block.
fn factor_corner(corner: &mut [Quad; WIDTH]) -> Option<()> {
    for column in 0..WIDTH {
        let pivot = corner[column][column];
        if pivot.is_nan() || pivot <= 0.0 {
            return None;
        }
        let scale = pivot.sqrt().recip();
        let solved = corner[column].map(|value| value * scale);
        for right in column + 1..WIDTH {
            axpy(&mut corner[right], -solved[right], &solved);
        }
        corner[column] = solved;
        corner[column][column] = scale;
    }
    Some(())
}

#[inline(always)]
fn axpy(to: &mut Quad, factor: f64, from: &Quad) {
    for (to, from) in to.iter_mut().zip(from) {
        *to += factor * from;
    }
}

/// Returns A·Bᵀ, column by column.
#[inline(never)]
fn block_product(a: &[Quad], b: &[Quad]) -> [Quad; WIDTH] {
    let mut block = [Quad::default(); WIDTH];
    for (a, b) in a.iter().zip(b) {
        for column in 0..WIDTH {
            for row in 0..WIDTH {
                block[column][row] += a[row] * b[column];
            }
        }
    }
    block
}

/// Computes block −= A·Bᵀ.
fn subtract_product(block: &mut [Quad; WIDTH], a: &[Quad], b: &[Quad]) {
    for (column, product) in block.iter_mut().zip(block_product(a, b)) {
        axpy(column, -1.0, &product);
    }
}

/// Writes a block into a matrix, without the padding.
fn write_block(matrix: &mut DMatrix<f64>, i: usize, j: usize, block: [Quad; WIDTH]) {
    let rows = WIDTH.min(matrix.nrows() - WIDTH * i);
    let mut columns = matrix.columns_range_mut(WIDTH * j..(WIDTH * (j + 1)).min(matrix.ncols()));
    for (mut column, values) in columns.column_iter_mut().zip(block) {
        column.rows_mut(WIDTH * i, rows).copy_from_slice(&values[..rows]);
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn noise(rows: usize, columns: usize, seed: f64) -> DMatrix<f64> {
        DMatrix::from_fn(rows, columns, |i, j| (78.233 * (i as f64 + seed) + 12.9898 * j as f64).sin())
    }

    proptest! {
        #[test]
        fn factors_solve_and_invert(count in 0_usize..23, seed in 0.0..9.0_f64) {
            let points = noise(count, count + 2, seed);
            let matrix = &points * points.transpose() + DMatrix::identity(count, count) * 0.1;
            let factor = Factor::new(Bands::new(&matrix)).unwrap();
            let right = DVector::from_fn(count, |row, _| (row as f64 + seed).cos());
            prop_assert!((&matrix * factor.solve(&right) - right).amax() < 1e-9);
            let inverse = factor.inverse();
            prop_assert_eq!(&inverse, &inverse.transpose());
            prop_assert!((inverse * matrix - DMatrix::identity(count, count)).amax() < 1e-9);
        }

        #[test]
        fn products_agree_with_nalgebra(a in 0_usize..11, b in 0_usize..11, common in 0_usize..11) {
            let (a, b) = (noise(a, common, 0.5), noise(b, common, 1.5));
            let product = Bands::new(&a).multiply_transposed(&Bands::new(&b));
            prop_assert!((product - a * b.transpose()).amax() < 1e-12);
        }

        #[test]
        fn indefinite_matrices_have_no_factor(count in 1_usize..12, index in 0_usize..12) {
            let points = noise(count, count + 2, 0.3);
            let mut matrix = &points * points.transpose() + DMatrix::identity(count, count);
            matrix[(index % count, index % count)] = -0.1;
            prop_assert!(Factor::new(Bands::new(&matrix)).is_none());
        }
    }
}
