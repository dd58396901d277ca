//! Source cells: weight, centre and second moments of the samples that sums run over, eight cells per block.

use crate::plants::spectral::cells::{CellExtent, Cells, DIMS};

/// Number of axes with second moments; along the others, cells have almost no extent.
pub(super) const LEADING_AXES: usize = 4;
/// Number of entries of a symmetric matrix over these axes.
pub(super) const TRIANGLE: usize = LEADING_AXES * (LEADING_AXES + 1) / 2;
/// Number of cells processed by one vector instruction.
pub(super) const LANES: usize = 8;

pub(super) type Lanes = [f32; LANES];
pub(super) const ZEROS: Lanes = [0.0; LANES];

/// Source cells, one per lane.
#[derive(Clone)]
pub(super) struct Sources {
    pub weight: Lanes,
    pub centre: [Lanes; DIMS],
    /// Second moments about the centre: lower triangle by rows.
    pub moments: [Lanes; TRIANGLE],
    /// Trace of the second moments over all axes.
    pub trace: Lanes,
    /// Mean squared distance from the principal subspace.
    pub residual: Lanes,
}

impl Sources {
    /// Sources without weight.
    pub const NONE: Sources = Sources {
        weight: ZEROS,
        centre: [ZEROS; DIMS],
        moments: [ZEROS; TRIANGLE],
        trace: ZEROS,
        residual: ZEROS,
    };

    /// Sets one lane to the cell that stands for all lanes of `children`. Returns the largest distance of
    /// one of them from its centre.
    fn set_parent(&mut self, lane: usize, children: &Sources) -> f32 {
        let weight: f32 = children.weight.iter().sum();
        if weight <= 0.0 {
            return 0.0;
        }
        let mean = |values: &Lanes| {
            values.iter().zip(&children.weight).map(|(value, weight)| value * weight).sum::<f32>() / weight
        };
        let centre = children.centre.each_ref().map(mean);
        self.weight[lane] = weight;
        self.residual[lane] = mean(&children.residual);
        for (own, centre) in self.centre.iter_mut().zip(centre) {
            own[lane] = centre;
        }
        let mut radius: f32 = 0.0;
        for (child, &weight) in children.weight.iter().enumerate().filter(|(_, weight)| **weight > 0.0) {
            let offset: [f32; DIMS] = std::array::from_fn(|axis| children.centre[axis][child] - centre[axis]);
            let squared: f32 = offset.iter().map(|offset| offset * offset).sum();
            radius = radius.max(squared.sqrt());
            self.trace[lane] += children.trace[child] + weight * squared;
            for (entry, (row, column)) in entries().enumerate() {
                self.moments[entry][lane] +=
                    children.moments[entry][child] + weight * offset[row] * offset[column];
            }
        }
        radius
    }

    /// Removes the cells of the given lanes.
    pub fn remove(&mut self, lanes: [bool; LANES]) {
        let moments = self.moments.iter_mut();
        for values in moments.chain([&mut self.weight, &mut self.trace]) {
            for (value, removed) in values.iter_mut().zip(lanes) {
                *value = if removed { 0.0 } else { *value };
            }
        }
    }

    /// Returns the offsets from the centres to a point and their squared lengths. `residual` is the
    /// squared distance of the point from the principal subspace.
    #[inline(always)]
    pub fn offsets(&self, position: &[f32; DIMS], residual: f32) -> ([Lanes; DIMS], Lanes) {
        let mut offset = [ZEROS; DIMS];
        let mut squared = self.residual.map(|own| own + residual);
        for axis in 0..DIMS {
            for lane in 0..LANES {
                offset[axis][lane] = position[axis] - self.centre[axis][lane];
                squared[lane] += offset[axis][lane] * offset[axis][lane];
            }
        }
        (offset, squared)
    }

    /// Returns the product of the second moments and the offset.
    #[inline(always)]
    pub fn moment_product(&self, offset: &[Lanes; DIMS]) -> [Lanes; LEADING_AXES] {
        let mut product = [ZEROS; LEADING_AXES];
        let mut entry = 0;
        for row in 0..LEADING_AXES {
            for column in 0..=row {
                let moments = &self.moments[entry];
                entry += 1;
                for lane in 0..LANES {
                    product[row][lane] += moments[lane] * offset[column][lane];
                }
                if column < row {
                    for lane in 0..LANES {
                        product[column][lane] += moments[lane] * offset[row][lane];
                    }
                }
            }
        }
        product
    }
}

/// Cells that stand for eight source cells each, one lane for each block of sources.
pub(super) struct Parents {
    pub cells: Vec<Sources>,
    /// Largest distance of a source cell from the centre of its parent.
    pub radii: Vec<Lanes>,
}

impl Parents {
    /// Creates the parents of blocks of sources.
    pub fn new(sources: &[Sources]) -> Parents {
        let blocks = sources.len().div_ceil(LANES);
        let mut parents = Parents { cells: vec![Sources::NONE; blocks], radii: vec![ZEROS; blocks] };
        for (index, children) in sources.iter().enumerate() {
            let (block, lane) = (index / LANES, index % LANES);
            parents.radii[block][lane] = parents.cells[block].set_parent(lane, children);
        }
        parents
    }
}

/// Computes the moments of all source cells, with lengths times `scale`; unused lanes have weight
/// 0.
pub(super) fn source_moments(cells: &Cells, weights: &[f64], scale: f64) -> Vec<Sources> {
    let moments_of = |chunk: &[CellExtent]| {
        let mut sources = Sources::NONE;
        for (lane, (range, mean)) in chunk.iter().enumerate() {
            let points = &cells.points[range.clone()];
            let weighted = || points.iter().map(|point| (point, weights[point.index as usize]));
            let total: f64 = weighted().map(|(_, weight)| weight).sum();
            let centre: [f64; DIMS] = std::array::from_fn(|axis| {
                let offset = |position: f32| f64::from(position - mean[axis]);
                let sum: f64 = weighted().map(|(point, weight)| weight * offset(point.coords[axis])).sum();
                f64::from(mean[axis]) + if total > 0.0 { sum / total } else { 0.0 }
            });
            let mut moments = [0.0; TRIANGLE];
            let (mut trace, mut residual) = (0.0, 0.0);
            for (point, weight) in weighted() {
                let offset: [f64; DIMS] =
                    std::array::from_fn(|axis| f64::from(point.coords[axis]) - centre[axis]);
                trace += weight * offset.iter().map(|offset| offset * offset).sum::<f64>();
                residual += weight * f64::from(point.residual);
                for (moment, (row, column)) in moments.iter_mut().zip(entries()) {
                    *moment += weight * offset[row] * offset[column];
                }
            }
            sources.weight[lane] = total as f32;
            sources.trace[lane] = (trace * scale * scale) as f32;
            sources.residual[lane] =
                if total > 0.0 { (residual / total * scale * scale) as f32 } else { 0.0 };
            for (lanes, value) in sources.centre.iter_mut().zip(centre) {
                lanes[lane] = (value * scale) as f32;
            }
            for (lanes, value) in sources.moments.iter_mut().zip(moments) {
                lanes[lane] = (value * scale * scale) as f32;
            }
        }
        sources
    };
    cells.sources.chunks(LANES).map(moments_of).collect()
}

/// Returns row and column of each entry of a lower triangle.
#[inline(always)]
pub(super) fn entries() -> impl Iterator<Item = (usize, usize)> {
    (0..LEADING_AXES).flat_map(|row| (0..=row).map(move |column| (row, column)))
}
