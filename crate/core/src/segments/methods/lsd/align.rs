//! Shapes: joint positions up to translation and rotation, and the least-squares distance of two
//! shapes.

use nalgebra::{Matrix3, Vector3};

/// Maximum coordinate, some 50 km from the first joint; larger values would overflow when squared.
const MAX_COORDINATE: f64 = 1e6;

/// Maximum number of Newton steps; a few suffice unless all joints are collinear.
const MAX_STEPS: usize = 60;

/// Relative size of the last step.
const STEP_TOLERANCE: f64 = 1e-13;

/// Joint positions relative to their centre.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shape {
    points: Vec<Vector3<f64>>,
    /// Sum of the squared lengths of the points.
    squared_norm: f64,
}

impl Shape {
    /// Creates the shape of points; distances are in their unit.
    pub fn new(points: impl ExactSizeIterator<Item = Vector3<f64>> + Clone) -> Shape {
        let bounded = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(-MAX_COORDINATE, MAX_COORDINATE) };
        // Relative to the first point no digits are lost far from the origin.
        let origin = points.clone().next().unwrap_or_default();
        let mut points: Vec<_> = points.map(|point| (point - origin).map(bounded)).collect();
        let centre = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
        points.iter_mut().for_each(|point| *point -= centre);
        let squared_norm = points.iter().map(Vector3::norm_squared).sum();
        Shape { points, squared_norm }
    }

    /// Returns the weighted mean of shapes without aligning them.
    pub fn mean(shapes: impl Iterator<Item = (Shape, f64)>) -> Shape {
        let (mut sum, mut total) = (Vec::new(), 0.0);
        for (shape, weight) in shapes {
            sum.resize(shape.points.len(), Vector3::zeros());
            sum.iter_mut().zip(&shape.points).for_each(|(sum, point)| *sum += point * weight);
            total += weight;
        }
        Shape::new(sum.iter().map(|point| point / total))
    }

    /// Returns the sum over the joints of the squared distance to `other` after optimal rotation
    /// (patent, step S3).
    pub fn distance(&self, other: &Shape) -> f64 {
        let total = self.squared_norm + other.squared_norm;
        (total - 2.0 * max_trace(&self.cross_covariance(other), total / 2.0)).max(0.0)
    }

    /// Returns the shape rotated onto `other` optimally; never mirrored.
    pub fn rotated_onto(&self, other: &Shape) -> Shape {
        let rotation = optimal_rotation(&self.cross_covariance(other));
        Shape {
            points: self.points.iter().map(|point| rotation * point).collect(),
            squared_norm: self.squared_norm,
        }
    }

    /// Returns the cross-covariance times the number of joints.
    fn cross_covariance(&self, other: &Shape) -> Matrix3<f64> {
        let mut cross = Matrix3::zeros();
        for (p, q) in self.points.iter().zip(&other.points) {
            cross += p * q.transpose();
        }
        cross
    }
}

/// Returns the rotation R that maximises tr(R·H) (patent, section 3, steps 4 and 5).
fn optimal_rotation(cross: &Matrix3<f64>) -> Matrix3<f64> {
    let svd = cross.svd(true, true);
    let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else { return Matrix3::identity() };
    let mut v = v_t.transpose();
    if (v * u.transpose()).determinant() < 0.0 {
        v.column_mut(svd.singular_values.imin()).neg_mut();
    }
    v * u.transpose()
}

/// Returns the maximum of tr(R·H) over rotations R, which is at most `bound`.
///
/// The maximum is σ₁ + σ₂ + s·σ₃, with the singular values of H and the sign s of its determinant,
/// and thus the largest root of (x² − |H|²)² − 8·det(H)·x − 4·|cof(H)|². Newton's method converges
/// to it from above (Theobald, Acta Crystallographica A61, 2005), faster than a singular value
/// decomposition.
fn max_trace(cross: &Matrix3<f64>, bound: f64) -> f64 {
    let (a, b, c) = (cross.column(0), cross.column(1), cross.column(2));
    let cofactors = Matrix3::from_columns(&[b.cross(&c), c.cross(&a), a.cross(&b)]);
    let (squared_norm, determinant) = (cross.norm_squared(), a.dot(&cofactors.column(0)));
    let cofactor_norm = cofactors.norm_squared();
    let mut x = bound.min((3.0 * squared_norm).sqrt());
    for _ in 0..MAX_STEPS {
        let difference = x * x - squared_norm;
        let slope = 4.0 * x * difference - 8.0 * determinant;
        let step = (difference * difference - 8.0 * determinant * x - 4.0 * cofactor_norm) / slope;
        // A slope of zero gives NaN, for which the comparison is false.
        if !(slope > 0.0 && step > STEP_TOLERANCE * x) {
            break;
        }
        x -= step;
    }
    x
}

#[cfg(test)]
mod tests {
    use nalgebra::Rotation3;
    use proptest::prelude::*;

    use super::*;

    fn points(count: usize) -> impl Strategy<Value = Vec<Vector3<f64>>> {
        let point = prop::array::uniform3(-10.0..10.0_f64).prop_map(Vector3::from);
        prop::collection::vec(point, count)
    }

    fn rotation() -> impl Strategy<Value = Rotation3<f64>> {
        prop::array::uniform3(-3.0..3.0_f64).prop_map(|angles| Rotation3::from_scaled_axis(angles.into()))
    }

    fn shape(points: &[Vector3<f64>]) -> Shape {
        Shape::new(points.iter().copied())
    }

    proptest! {
        #[test]
        fn distance_is_invariant_to_rotation_and_translation(points in points(7), rotation in rotation(), x in -1e4..1e4_f64) {
            let moved: Vec<_> = points.iter().map(|p| rotation * p + Vector3::new(x, -x, 3.0)).collect();
            let (original, moved) = (shape(&points), shape(&moved));
            prop_assert!(original.distance(&moved) < 1e-7, "{}", original.distance(&moved));
            let back = moved.rotated_onto(&original);
            for (p, q) in back.points.iter().zip(&original.points) {
                prop_assert!((p - q).norm() < 1e-6);
            }
        }

        #[test]
        fn the_optimal_rotation_is_a_rotation_and_reaches_the_distance(a in points(6), b in points(6)) {
            let (a, b) = (shape(&a), shape(&b));
            let rotation = optimal_rotation(&a.cross_covariance(&b));
            prop_assert!((rotation.determinant() - 1.0).abs() < 1e-9);
            let rotated = a.rotated_onto(&b);
            let attained: f64 = rotated.points.iter().zip(&b.points).map(|(p, q)| (p - q).norm_squared()).sum();
            prop_assert!((attained - a.distance(&b)).abs() < 1e-7, "{attained} {}", a.distance(&b));
            prop_assert!((b.distance(&a) - a.distance(&b)).abs() < 1e-7);
        }

        #[test]
        fn trace_agrees_with_singular_values(a in points(5), b in points(5), flat in 0_usize..4) {
            let flatten = |points: &[Vector3<f64>]| {
                let mut points = points.to_vec();
                // Planes and lines too, for which singular values vanish.
                points.iter_mut().for_each(|p| (0..flat).for_each(|axis| p[axis] = 0.0));
                shape(&points)
            };
            let (a, b) = (flatten(&a), shape(&b));
            let cross = a.cross_covariance(&b);
            let mut values: Vec<f64> = cross.singular_values().iter().copied().collect();
            values.sort_by(|a, b| b.total_cmp(a));
            let best = values[0] + values[1] + cross.determinant().signum() * values[2];
            prop_assert!((max_trace(&cross, f64::INFINITY) - best).abs() < 1e-5);
        }

        #[test]
        fn mirror_images_differ(points in points(6)) {
            let mirrored: Vec<_> = points.iter().map(|p| Vector3::new(-p.x, p.y, p.z)).collect();
            let (a, b) = (shape(&points), shape(&mirrored));
            let min = a.cross_covariance(&a).symmetric_eigenvalues().min();
            prop_assert!((a.distance(&b) - 4.0 * min).abs() < 1e-6, "{} {min}", a.distance(&b));
        }
    }

    #[test]
    fn any_points_have_a_finite_distance() {
        let far = [0.0, 1.0, 1e8, 1e300, f64::MAX, f64::INFINITY, f64::NAN];
        for x in far {
            for y in far {
                let a = shape(&[Vector3::new(x, 0.0, y), Vector3::new(-x, y, 1.0), Vector3::zeros()]);
                let b = shape(&[Vector3::zeros(), Vector3::new(y, 1.0, 0.0), Vector3::new(1.0, x, -y)]);
                assert!(a.distance(&b).is_finite(), "{x} {y}");
                assert!(
                    Shape::mean([(a.rotated_onto(&b), 1.0), (b, 1.0)].into_iter()).squared_norm.is_finite(),
                    "{x} {y}"
                );
            }
        }
        assert_eq!(shape(&[]).distance(&shape(&[])), 0.0);
    }
}
