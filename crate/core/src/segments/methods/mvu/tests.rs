use proptest::prelude::*;

use super::*;
use crate::skeleton::{Overrides, Skeleton};

/// Poses along a helix with a tail of noise: one column each.
fn helix(count: usize, seed: f64) -> DMatrix<f64> {
    DMatrix::from_fn(5, count, |row, column| {
        let angle = 0.3 * column as f64;
        let noise = (12.9898 * (row as f64 + 1.0) * (column as f64 + seed)).sin();
        [angle.cos(), angle.sin(), 0.1 * angle, 0.0, 0.0][row] + 0.05 * noise
    })
}

/// The solution from nothing, of points along their edges.
fn solved(count: usize, edges: &[neighbours::Edge]) -> unfold::Unfolded {
    unfold::unfold(count, edges, &Inside::default(), &mut || Ok(())).unwrap()
}

/// The unfolded poses of a single window.
fn unfolded_alone(poses: DMatrixView<f64>, k: usize) -> DMatrix<f64> {
    unfolded(poses, k, &mut Last::default(), &mut || Ok(())).unwrap()
}

/// What a single window leaves over.
fn residual_alone(poses: DMatrixView<f64>, dims: usize, kind: Residual) -> f64 {
    residual(poses, dims, kind, &mut Last::default(), &mut || Ok(())).unwrap()
}

#[test]
fn the_solution_is_the_best_there_is() {
    for seed in 0..20 {
        let poses = helix(30, f64::from(seed));
        let distances = neighbours::squared_distances(poses.as_view());
        let edges = neighbours::edges(&distances, 6);
        let unfolded = solved(30, &edges);
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
        // The poses as they are keep all distances too, so the best is no smaller.
        let as_they_are = neighbours::centred_products(&distances).trace();
        assert!(k.trace() > as_they_are * (1.0 - 1e-5));
    }
}

#[test]
fn a_chain_unfolds_to_a_line() {
    // Points around a circle, each tied to the next only.
    let poses = DMatrix::from_fn(2, 9, |row, column| {
        let angle = 0.6 * column as f64;
        if row == 0 { angle.cos() } else { angle.sin() }
    });
    let distances = neighbours::squared_distances(poses.as_view());
    let edges = neighbours::edges(&distances, 0);
    assert_eq!(edges.len(), 8);
    let k = solved(9, &edges).products;
    let rest = residual_of(&k, 1);
    assert!(rest < 1e-4 * k.trace(), "{rest}");
    let step = distances[(0, 1)].sqrt();
    let along: f64 = (0..9).map(|place| ((f64::from(place) - 4.0) * step).powi(2)).sum();
    assert!((k.trace() - along).abs() < 1e-4 * along);
}

#[test]
fn general_solvers_find_the_same() {
    // SCS (to 1e-9) and Clarabel agree on these.
    for (k, trace) in [(3, 30.7221), (6, 26.3778)] {
        let distances = neighbours::squared_distances(helix(24, 0.0).as_view());
        let found = solved(24, &neighbours::edges(&distances, k)).products.trace();
        assert!((found - trace).abs() < 1e-4 * trace, "k = {k}: {found}");
    }
}

#[path = "../../../../tests/support/corpus.rs"]
mod corpus;

/// Windows of recorded poses: `count` of them from frame `first` on, every twelfth of a second.
fn recorded(windows: &[(usize, usize)]) -> Option<Vec<DMatrix<f64>>> {
    let bytes = std::fs::read(corpus::folder()?.join("cmu/86_01.bvh")).unwrap();
    let clip = crate::bvh::parse(&bytes, Default::default()).unwrap().clip;
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let body = Body::turning(&clip, &skeleton).unwrap();
    let window = |&(first, count): &(usize, usize)| {
        let poses = Poses::of(&clip, &body, &(first..clip.frame_count()), 12.0);
        poses.columns.columns(0, count).into_owned()
    };
    Some(windows.iter().map(window).collect())
}

#[test]
fn recorded_poses_unfold_as_a_general_solver_has_it() {
    let Some(windows) = recorded(&[(0, 60)]) else { return };
    // Clarabel's values.
    for (k, trace) in [(4, 24.4767), (6, 9.6669)] {
        let found = unfolded_alone(windows[0].as_view(), k).trace();
        assert!((found - trace).abs() < 1e-4 * trace, "k = {k}: {found}");
    }
}

#[test]
fn recorded_windows_are_solved_to_the_tolerance() {
    let places: Vec<(usize, usize)> = (0..20).map(|index| (index * 211, 20 + index * 37 % 61)).collect();
    let Some(windows) = recorded(&places) else { return };
    for window in windows {
        let distances = neighbours::squared_distances(window.as_view());
        let unfolded = solved(window.ncols(), &neighbours::edges(&distances, 6));
        assert!(unfolded.gap < 5e-6, "gap {}", unfolded.gap);
        assert!(unfolded.violation < 1e-6, "violation {}", unfolded.violation);
    }
}

/// Checks that windows are solved as well and in fewer steps from the one before as from nothing.
fn check_windows(poses: &DMatrix<f64>, windows: impl Iterator<Item = Range<usize>>) {
    let mut last = Inside::default();
    let (mut first, mut from_last, mut from_nothing) = (0, 0, 0);
    for window in windows {
        let part = poses.columns_range(window.clone());
        let edges = neighbours::edges(&neighbours::squared_distances(part), 6);
        let unfold = |start: &Inside, steps: &mut usize| {
            let mut pause = || {
                *steps += 1;
                Ok(())
            };
            unfold::unfold(part.ncols(), &edges, start, &mut pause).unwrap()
        };
        let start = take(&mut last).without_first(window.start - first);
        let (warm, cold) = (unfold(&start, &mut from_last), unfold(&Inside::default(), &mut from_nothing));
        assert!(warm.gap < 5e-6, "{window:?}: gap {}", warm.gap);
        assert!(warm.violation < 5e-7, "{window:?}: violation {}", warm.violation);
        let (trace, expected) = (warm.products.trace(), cold.products.trace());
        assert!((trace - expected).abs() < 2e-5 * expected, "{window:?}: {trace} {expected}");
        (first, last) = (window.start, warm.inside);
    }
    assert!(from_last < from_nothing, "{from_last} of {from_nothing}");
}

#[test]
fn windows_that_grow_and_slide_start_from_the_one_before() {
    let windows = || (20..50).step_by(2).map(|end| 0..end).chain((2..16).step_by(2).map(|by| by..48 + by));
    check_windows(&helix(64, 0.5), windows());
    if let Some(poses) = recorded(&[(0, 64)]) {
        check_windows(&poses[0], windows());
    }
}

#[test]
fn what_has_nothing_to_do_with_the_window_is_no_start() {
    let edges_of =
        |poses: &DMatrix<f64>| neighbours::edges(&neighbours::squared_distances(poses.as_view()), 6);
    let other =
        solved(30, &edges_of(&DMatrix::from_fn(5, 30, |i, j| (7.3 * (i * 30 + j) as f64).sin()))).inside;
    let edges = edges_of(&helix(30, 1.0));
    let found = unfold::unfold(30, &edges, &other, &mut || Ok(())).unwrap();
    let expected = solved(30, &edges).products.trace();
    assert!(found.gap < 5e-6 && found.violation < 5e-7);
    assert!((found.products.trace() - expected).abs() < 2e-5 * expected);
}

#[test]
fn a_window_can_be_cancelled_in_between() {
    let mut steps = 0;
    let mut pause = || {
        steps += 1;
        if steps == 3 { Err(Cancelled) } else { Ok(()) }
    };
    let poses = helix(40, 0.0);
    let found = residual(poses.as_view(), 1, Residual::Absolute, &mut Last::default(), &mut pause);
    assert_eq!((found, steps), (Err(Cancelled), 3));
}

fn residual_of(products: &DMatrix<f64>, dims: usize) -> f64 {
    products.trace() - inverse_iteration::largest(products.clone(), dims, &[]).iter().sum::<f64>()
}

#[test]
fn with_all_neighbours_nothing_moves() {
    let poses = helix(7, 0.0);
    let mean = poses.column_mean();
    let centred = DMatrix::from_columns(&poses.column_iter().map(|pose| pose - &mean).collect::<Vec<_>>());
    let products = unfolded_alone(poses.as_view(), 6);
    assert!((products - centred.tr_mul(&centred)).amax() < 1e-12);
}

#[test]
fn poses_that_repeat_leave_no_residual() {
    let still = DMatrix::from_element(8, 25, 0.3);
    assert_eq!(residual_alone(still.as_view(), 1, Residual::Absolute), 0.0);
    assert_eq!(residual_alone(still.as_view(), 1, Residual::Ratio), 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_poses_have_a_residual(
        values in prop::collection::vec(prop_oneof![Just(0.0), -1.0..1.0_f64], 3 * 24),
        dims in 1_usize..4,
    ) {
        let poses = DMatrix::from_vec(3, 24, values);
        let rest = residual_alone(poses.as_view(), dims, Residual::Absolute);
        prop_assert!(rest.is_finite() && rest >= 0.0);
    }
}
