//! Shapes: poses freed of place and heading, and the least-squares distance between two.

use nalgebra::Matrix3;
use nalgebra::Vector3;

/// Coordinates end here, some 50 km from the first joint: beyond, powers would overflow.
const FAR: f64 = 1e6;

/// Most steps towards the best turn: a handful do, but where all joints are in line.
const STEPS: usize = 60;

/// A step this small in proportion is the last.
const SETTLED: f64 = 1e-13;

/// Joint positions about their centre.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shape {
    points: Vec<Vector3<f64>>,
    /// Sum of the points' squared lengths.
    square: f64,
}

impl Shape {
    /// The shape of some points, in whose unit distances are.
    pub fn new(points: impl ExactSizeIterator<Item = Vector3<f64>> + Clone) -> Shape {
        let bounded = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(-FAR, FAR) };
        // From the first point on, no digits are lost far from the origin.
        let origin = points.clone().next().unwrap_or_default();
        let mut points: Vec<_> = points.map(|point| (point - origin).map(bounded)).collect();
        let centre = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
        points.iter_mut().for_each(|point| *point -= centre);
        let square = points.iter().map(Vector3::norm_squared).sum();
        Shape { points, square }
    }

    /// The mean of shapes as they lie, by their weights.
    pub fn mean(shapes: impl Iterator<Item = (Shape, f64)>) -> Shape {
        let (mut sum, mut total) = (Vec::new(), 0.0);
        for (shape, weight) in shapes {
            sum.resize(shape.points.len(), Vector3::zeros());
            sum.iter_mut().zip(&shape.points).for_each(|(sum, point)| *sum += point * weight);
            total += weight;
        }
        Shape::new(sum.iter().map(|point| point / total))
    }

    /// The sum over joints of the squared distance from `other`, when turned to lie best on it
    /// (patent, step S3).
    pub fn distance(&self, other: &Shape) -> f64 {
        let both = self.square + other.square;
        (both - 2.0 * best_product(&self.cross(other), both / 2.0)).max(0.0)
    }

    /// The shape turned to lie best on `other`, never mirrored.
    pub fn turned_onto(&self, other: &Shape) -> Shape {
        let turn = best_turn(&self.cross(other));
        Shape { points: self.points.iter().map(|point| turn * point).collect(), square: self.square }
    }

    /// The cross covariance, but for the number of joints.
    fn cross(&self, other: &Shape) -> Matrix3<f64> {
        let mut cross = Matrix3::zeros();
        for (p, q) in self.points.iter().zip(&other.points) {
            cross += p * q.transpose();
        }
        cross
    }
}

/// The rotation R that makes tr(R·H) largest (patent, section 3, steps 4 and 5).
fn best_turn(cross: &Matrix3<f64>) -> Matrix3<f64> {
    let svd = cross.svd(true, true);
    let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else { return Matrix3::identity() };
    let mut v = v_t.transpose();
    if (v * u.transpose()).determinant() < 0.0 {
        v.column_mut(svd.singular_values.imin()).neg_mut();
    }
    v * u.transpose()
}

/// The largest tr(R·H) over rotations R, which is no more than `bound`.
///
/// It is σ₁ + σ₂ + s·σ₃, from the singular values of H and the sign s of its determinant, and
/// therefore the largest root of (x² − |H|²)² − 8·det(H)·x − 4·|cof(H)|². Newton's method comes
/// down on it from above (Theobald, Acta Crystallographica A61, 2005), quicker than by the
/// singular values.
fn best_product(cross: &Matrix3<f64>, bound: f64) -> f64 {
    let (a, b, c) = (cross.column(0), cross.column(1), cross.column(2));
    let cofactors = Matrix3::from_columns(&[b.cross(&c), c.cross(&a), a.cross(&b)]);
    let (square, determinant) = (cross.norm_squared(), a.dot(&cofactors.column(0)));
    let cofactor_square = cofactors.norm_squared();
    let mut x = bound.min((3.0 * square).sqrt());
    for _ in 0..STEPS {
        let off = x * x - square;
        let slope = 4.0 * x * off - 8.0 * determinant;
        let step = (off * off - 8.0 * determinant * x - 4.0 * cofactor_square) / slope;
        // Without a slope there is no number to compare.
        if !(slope > 0.0 && step > SETTLED * x) {
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

    fn turn() -> impl Strategy<Value = Rotation3<f64>> {
        prop::array::uniform3(-3.0..3.0_f64).prop_map(|angles| Rotation3::from_scaled_axis(angles.into()))
    }

    fn shape(points: &[Vector3<f64>]) -> Shape {
        Shape::new(points.iter().copied())
    }

    proptest! {
        #[test]
        fn rotations_and_places_do_not_count(points in points(7), turn in turn(), x in -1e4..1e4_f64) {
            let moved: Vec<_> = points.iter().map(|p| turn * p + Vector3::new(x, -x, 3.0)).collect();
            let (still, moved) = (shape(&points), shape(&moved));
            prop_assert!(still.distance(&moved) < 1e-7, "{}", still.distance(&moved));
            let back = moved.turned_onto(&still);
            for (p, q) in back.points.iter().zip(&still.points) {
                prop_assert!((p - q).norm() < 1e-6);
            }
        }

        #[test]
        fn the_best_turn_is_a_rotation_and_reaches_the_distance(a in points(6), b in points(6)) {
            let (a, b) = (shape(&a), shape(&b));
            let turn = best_turn(&a.cross(&b));
            prop_assert!((turn.determinant() - 1.0).abs() < 1e-9);
            let turned = a.turned_onto(&b);
            let reached: f64 = turned.points.iter().zip(&b.points).map(|(p, q)| (p - q).norm_squared()).sum();
            prop_assert!((reached - a.distance(&b)).abs() < 1e-7, "{reached} {}", a.distance(&b));
            prop_assert!((b.distance(&a) - a.distance(&b)).abs() < 1e-7);
        }

        #[test]
        fn singular_values_say_the_same(a in points(5), b in points(5), flat in 0_usize..4) {
            let press = |points: &[Vector3<f64>]| {
                let mut points = points.to_vec();
                // Planes and lines too: there, singular values vanish.
                points.iter_mut().for_each(|p| (0..flat).for_each(|axis| p[axis] = 0.0));
                shape(&points)
            };
            let (a, b) = (press(&a), shape(&b));
            let cross = a.cross(&b);
            let mut values: Vec<f64> = cross.singular_values().iter().copied().collect();
            values.sort_by(|a, b| b.total_cmp(a));
            let best = values[0] + values[1] + cross.determinant().signum() * values[2];
            prop_assert!((best_product(&cross, f64::INFINITY) - best).abs() < 1e-5);
        }

        #[test]
        fn mirror_images_are_apart(points in points(6)) {
            let mirrored: Vec<_> = points.iter().map(|p| Vector3::new(-p.x, p.y, p.z)).collect();
            let (a, b) = (shape(&points), shape(&mirrored));
            let least = a.cross(&a).symmetric_eigenvalues().min();
            prop_assert!((a.distance(&b) - 4.0 * least).abs() < 1e-6, "{} {least}", a.distance(&b));
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
                    Shape::mean([(a.turned_onto(&b), 1.0), (b, 1.0)].into_iter()).square.is_finite(),
                    "{x} {y}"
                );
            }
        }
        assert_eq!(shape(&[]).distance(&shape(&[])), 0.0);
    }
}
