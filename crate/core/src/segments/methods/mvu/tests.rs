use proptest::prelude::*;

use super::*;
use crate::skeleton::{Overrides, Skeleton};

/// Poses along a helix with noise, one per column.
fn helix(count: usize, seed: f64) -> DMatrix<f64> {
    DMatrix::from_fn(5, count, |row, column| {
        let angle = 0.3 * column as f64;
        let noise = (12.9898 * (row as f64 + 1.0) * (column as f64 + seed)).sin();
        [angle.cos(), angle.sin(), 0.1 * angle, 0.0, 0.0][row] + 0.05 * noise
    })
}

/// Returns the solution from the default starting point.
fn solve(count: usize, edges: &[neighbours::Edge]) -> unfold::Unfolded {
    unfold::unfold(count, edges, &InteriorPoint::default(), &mut || Ok(())).unwrap()
}

/// Returns the unfolded poses of a single window.
fn unfold_single(poses: DMatrixView<f64>, k: usize) -> DMatrix<f64> {
    unfold_window(poses, k, &mut PreviousWindow::default(), &mut || Ok(())).unwrap()
}

/// Returns the residual of a single window.
fn residual_single(poses: DMatrixView<f64>, dims: usize, kind: Residual) -> f64 {
    residual(poses, dims, kind, &mut PreviousWindow::default(), &mut || Ok(())).unwrap()
}

#[test]
fn the_solution_is_optimal() {
    for seed in 0..20 {
        let poses = helix(30, f64::from(seed));
        let distances = neighbours::squared_distances(poses.as_view());
        let edges = neighbours::edges(&distances, 6);
        let unfolded = solve(30, &edges);
        assert!(unfolded.gap < 5e-6, "gap {}", unfolded.gap);
        assert!(unfolded.violation < 1e-6, "violation {}", unfolded.violation);
        let k = &unfolded.products;
        for edge in &edges {
            let (i, j) = (edge.from, edge.to);
            let squared = k[(i, i)] + k[(j, j)] - 2.0 * k[(i, j)];
            assert!((squared - edge.squared).abs() < 1e-5 * edge.squared.max(0.1));
        }
        assert!(k.column_sum().amax() < 1e-6 * k.trace());
        assert!(k.symmetric_eigenvalues().min() > -1e-8 * k.trace());
        // The original poses preserve all distances too, so the optimum is no smaller.
        let original = neighbours::centred_products(&distances).trace();
        assert!(k.trace() > original * (1.0 - 1e-5));
    }
}

#[test]
fn a_chain_unfolds_to_a_line() {
    // Points on a circle, each connected to the next only.
    let poses = DMatrix::from_fn(2, 9, |row, column| {
        let angle = 0.6 * column as f64;
        if row == 0 { angle.cos() } else { angle.sin() }
    });
    let distances = neighbours::squared_distances(poses.as_view());
    let edges = neighbours::edges(&distances, 0);
    assert_eq!(edges.len(), 8);
    let k = solve(9, &edges).products;
    let remaining = residual_of(&k, 1);
    assert!(remaining < 1e-4 * k.trace(), "{remaining}");
    let step = distances[(0, 1)].sqrt();
    let expected: f64 = (0..9).map(|index| ((f64::from(index) - 4.0) * step).powi(2)).sum();
    assert!((k.trace() - expected).abs() < 1e-4 * expected);
}

#[test]
fn agrees_with_general_solvers() {
    // SCS (to 1e-9) and Clarabel agree on these values.
    for (k, trace) in [(3, 30.7221), (6, 26.3778)] {
        let distances = neighbours::squared_distances(helix(24, 0.0).as_view());
        let found = solve(24, &neighbours::edges(&distances, k)).products.trace();
        assert!((found - trace).abs() < 1e-4 * trace, "k = {k}: {found}");
    }
}

/// Returns windows of a sample's poses: `count` poses from pose `first`, every twelfth of a second.
fn sample_windows(windows: &[(usize, usize)]) -> Vec<DMatrix<f64>> {
    let bytes = include_bytes!("../../../../../../samples/limp-to-run.bvh");
    let clip = crate::bvh::parse(bytes, Default::default()).unwrap().clip;
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let body = Body::rotation_joints(&clip, &skeleton).unwrap();
    let poses = Poses::new(&clip, &body, &(0..clip.frame_count()), 12.0);
    windows.iter().map(|&(first, count)| poses.columns.columns(first, count).into_owned()).collect()
}

#[test]
fn windows_are_solved_to_the_tolerance() {
    let spans: Vec<(usize, usize)> = (0..20).map(|index| (index * 15, 20 + index * 37 % 61)).collect();
    for window in sample_windows(&spans) {
        let distances = neighbours::squared_distances(window.as_view());
        let unfolded = solve(window.ncols(), &neighbours::edges(&distances, 6));
        assert!(unfolded.gap < 5e-6, "gap {}", unfolded.gap);
        assert!(unfolded.violation < 1e-6, "violation {}", unfolded.violation);
    }
}

/// Checks that windows started from the previous one are solved as accurately as from scratch, in
/// fewer steps.
fn check_windows(poses: &DMatrix<f64>, windows: impl Iterator<Item = Range<usize>>) {
    let mut previous = InteriorPoint::default();
    let (mut first, mut warm_steps, mut cold_steps) = (0, 0, 0);
    for window in windows {
        let window_poses = poses.columns_range(window.clone());
        let edges = neighbours::edges(&neighbours::squared_distances(window_poses), 6);
        let unfold = |start: &InteriorPoint, steps: &mut usize| {
            let mut checkpoint = || {
                *steps += 1;
                Ok(())
            };
            unfold::unfold(window_poses.ncols(), &edges, start, &mut checkpoint).unwrap()
        };
        let start = take(&mut previous).without_first(window.start - first);
        let (warm, cold) =
            (unfold(&start, &mut warm_steps), unfold(&InteriorPoint::default(), &mut cold_steps));
        assert!(warm.gap < 5e-6, "{window:?}: gap {}", warm.gap);
        assert!(warm.violation < 5e-7, "{window:?}: violation {}", warm.violation);
        let (trace, expected) = (warm.products.trace(), cold.products.trace());
        assert!((trace - expected).abs() < 2e-5 * expected, "{window:?}: {trace} {expected}");
        (first, previous) = (window.start, warm.interior);
    }
    assert!(warm_steps < cold_steps, "{warm_steps} of {cold_steps}");
}

#[test]
fn windows_start_from_the_previous_one() {
    let windows = || (20..50).step_by(2).map(|end| 0..end).chain((2..16).step_by(2).map(|by| by..48 + by));
    check_windows(&helix(64, 0.5), windows());
    check_windows(&sample_windows(&[(0, 64)])[0], windows());
}

#[test]
fn an_unrelated_start_is_ignored() {
    let edges_of =
        |poses: &DMatrix<f64>| neighbours::edges(&neighbours::squared_distances(poses.as_view()), 6);
    let other =
        solve(30, &edges_of(&DMatrix::from_fn(5, 30, |i, j| (7.3 * (i * 30 + j) as f64).sin()))).interior;
    let edges = edges_of(&helix(30, 1.0));
    let found = unfold::unfold(30, &edges, &other, &mut || Ok(())).unwrap();
    let expected = solve(30, &edges).products.trace();
    assert!(found.gap < 5e-6 && found.violation < 5e-7);
    assert!((found.products.trace() - expected).abs() < 2e-5 * expected);
}

#[test]
fn a_window_can_be_cancelled() {
    let mut steps = 0;
    let mut checkpoint = || {
        steps += 1;
        if steps == 3 { Err(Cancelled) } else { Ok(()) }
    };
    let poses = helix(40, 0.0);
    let found =
        residual(poses.as_view(), 1, Residual::Absolute, &mut PreviousWindow::default(), &mut checkpoint);
    assert_eq!((found, steps), (Err(Cancelled), 3));
}

fn residual_of(products: &DMatrix<f64>, dims: usize) -> f64 {
    products.trace() - inverse_iteration::largest_eigenvalues(products.clone(), dims, &[]).iter().sum::<f64>()
}

#[test]
fn with_all_neighbours_nothing_moves() {
    let poses = helix(7, 0.0);
    let mean = poses.column_mean();
    let centred = DMatrix::from_columns(&poses.column_iter().map(|pose| pose - &mean).collect::<Vec<_>>());
    let products = unfold_single(poses.as_view(), 6);
    assert!((products - centred.tr_mul(&centred)).amax() < 1e-12);
}

#[test]
fn constant_poses_have_no_residual() {
    let constant = DMatrix::from_element(8, 25, 0.3);
    assert_eq!(residual_single(constant.as_view(), 1, Residual::Absolute), 0.0);
    assert_eq!(residual_single(constant.as_view(), 1, Residual::Ratio), 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn random_poses_have_a_residual(
        values in prop::collection::vec(prop_oneof![Just(0.0), -1.0..1.0_f64], 3 * 24),
        dims in 1_usize..4,
    ) {
        let poses = DMatrix::from_vec(3, 24, values);
        let remaining = residual_single(poses.as_view(), dims, Residual::Absolute);
        prop_assert!(remaining.is_finite() && remaining >= 0.0);
    }
}
