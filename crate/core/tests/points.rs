//! Detection in positions of points.

#[path = "support/points.rs"]
mod support;

use std::fs;
use std::path::Path;

use nalgebra::Vector3;
use plantigrade::bvh::{self, Clip};
use plantigrade::kinematics;
use plantigrade::notice::Code;
use plantigrade::plants::{self, Feet, ValidParams};
use plantigrade::points::{PointClip, Points, PointsError};
use plantigrade::skeleton::{Overrides, Role, Skeleton};
use support::{coordinates, have_the_labels_of};

fn sample(name: &str) -> Clip {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../samples/{name}.bvh"));
    bvh::parse(&fs::read(path).expect("a sample"), bvh::Options::default()).expect("BVH").clip
}

/// The joints of a sample with some roles, as unconnected points.
struct Body {
    clip: Clip,
    skeleton: Skeleton,
    positions: Vec<f64>,
    names: Vec<String>,
}

impl Body {
    fn new(roles: &[Role]) -> Body {
        let clip = sample("curved-walk");
        let skeleton = Skeleton::main(&clip, &Overrides::default());
        let joints: Vec<usize> =
            roles.iter().map(|&role| skeleton.roles.get(role).expect("a complete skeleton")).collect();
        let all = coordinates(&clip);
        let rows = all.chunks_exact(3 * clip.joints().len());
        let positions = rows
            .flat_map(|row| joints.iter().flat_map(|joint| row[3 * joint..3 * joint + 3].to_vec()))
            .collect();
        Body { clip, skeleton, positions, names: roles.iter().map(|role| role.name().into()).collect() }
    }

    fn points(&self) -> Points<'_> {
        Points { positions: &self.positions, names: &self.names, parents: &[], rate: self.clip.rate() }
    }

    /// Returns the fraction of contact labels of the sample that the points reproduce.
    fn agreement(&self, points: &PointClip) -> f64 {
        let labels = |clip: &Clip, skeleton: &Skeleton| {
            let feet = Feet::new(clip, skeleton).expect("feet");
            let detection = plants::detect(&feet, ValidParams::default());
            detection.principal().feet.each_ref().map(|foot| foot.planted.clone()).concat()
        };
        let expected = labels(&self.clip, &self.skeleton);
        let found = labels(&points.clip, &points.skeleton);
        expected.iter().zip(&found).filter(|(a, b)| a == b).count() as f64 / expected.len() as f64
    }
}

const LEGS: [Role; 6] =
    [Role::LeftAnkle, Role::RightAnkle, Role::LeftToe, Role::RightToe, Role::LeftThigh, Role::RightThigh];

#[test]
fn points_have_the_labels_of_their_clip() {
    for name in ["curved-walk", "limp-to-run", "one-leg-hop", "frog-jumps"] {
        assert!(have_the_labels_of(&sample(name), name));
    }
}

#[test]
fn names_identify_unconnected_points() {
    let body = Body::new(&LEGS);
    let points = body.points().clip(&Overrides::default()).expect("points");
    for role in LEGS {
        let expected = body.names.iter().position(|name| name == role.name()).map(|at| points.joints[at]);
        assert_eq!(points.skeleton.roles.get(role), expected, "{role:?}");
    }
    assert!(body.agreement(&points) > 0.99);
    assert!(points.skeleton.notices.iter().any(|notice| notice.text.contains("middle of both hip joints")));
}

#[test]
fn ankles_alone_are_sufficient() {
    let body = Body::new(&LEGS[..2]);
    let points = body.points().clip(&Overrides::default()).expect("points");
    let texts: Vec<_> = points.skeleton.notices.iter().map(|notice| notice.text.as_str()).collect();
    assert!(texts.iter().any(|text| text.contains("mean of all points")), "{texts:?}");
    assert!(texts.iter().any(|text| text.contains("legs of 0.9 m are assumed")), "{texts:?}");
    assert!(points.skeleton.notices.iter().any(|notice| notice.code == Code::NoToe));
    let scale = Overrides { metres_per_unit: Some(body.skeleton.metres_per_unit), ..Overrides::default() };
    let points = body.points().clip(&scale).expect("points");
    // The heel leaves the ground before the toe.
    assert!(body.agreement(&points) > 0.85);
}

#[test]
fn parents_may_be_in_any_order() {
    let body = Body::new(&LEGS);
    // Ankle ← toe, thigh ← ankle; the thighs are roots.
    let parents = [Some(4), Some(5), Some(0), Some(1), None, None];
    let points = Points { parents: &parents, ..body.points() }.clip(&Overrides::default()).expect("points");
    let ankle = &points.clip.joints()[points.joints[0]];
    assert_eq!(ankle.parent, Some(points.joints[4]));
    let tracks = kinematics::tracks(&points.clip, &points.joints);
    for (point, track) in tracks.iter().enumerate() {
        assert_eq!(track[7], Vector3::from_column_slice(&body.positions[3 * (7 * 6 + point)..][..3]));
    }
}

#[test]
fn written_points_are_read_back() {
    let body = Body::new(&LEGS);
    let parents = [Some(4), Some(5), Some(0), Some(1), None, None];
    let points = Points { parents: &parents, ..body.points() }.clip(&Overrides::default()).expect("points");
    let read = bvh::parse(bvh::write(&points.clip).as_bytes(), bvh::Options::default()).expect("BVH").clip;
    let joints: Vec<usize> = (0..read.joints().len()).collect();
    for (a, b) in kinematics::tracks(&points.clip, &joints).iter().zip(kinematics::tracks(&read, &joints)) {
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).norm() < 1e-9));
    }
}

#[test]
fn invalid_points_are_rejected() {
    let body = Body::new(&LEGS);
    let error = |points: Points, overrides: &Overrides| points.clip(overrides).expect_err("an error");
    let none = Overrides::default();
    assert_eq!(error(Points { names: &[], ..body.points() }, &none), PointsError::NoPoints);
    assert_eq!(error(Points { positions: &[], ..body.points() }, &none), PointsError::NoFrames);
    let short = &body.positions[1..];
    assert!(matches!(error(Points { positions: short, ..body.points() }, &none), PointsError::Length { .. }));
    for rate in [0.0, -1.0, f64::NAN, 1e6] {
        assert!(matches!(error(Points { rate, ..body.points() }, &none), PointsError::Rate(_)));
    }
    let parents = [Some(1), Some(0), None, None, None, None];
    assert_eq!(error(Points { parents: &parents, ..body.points() }, &none), PointsError::Cycle(0));
    let parents = [Some(6), None, None, None, None, None];
    let expected = PointsError::Parent { point: 0, parent: 6, points: 6 };
    assert_eq!(error(Points { parents: &parents, ..body.points() }, &none), expected);
    let expected = PointsError::ParentCount { found: 1, points: 6 };
    assert_eq!(error(Points { parents: &parents[..1], ..body.points() }, &none), expected);
    let overrides = Overrides { roles: vec![(Role::LeftToe, Some(9))], ..none.clone() };
    let expected = PointsError::RolePoint { role: "left_toe", point: 9, points: 6 };
    assert_eq!(error(body.points(), &overrides), expected);
    let mut positions = body.positions.clone();
    positions[3 * (6 * 5 + 2) + 1] = f64::NAN;
    let message = error(Points { positions: &positions, ..body.points() }, &none).to_string();
    assert_eq!(message, "the position of point 2 (left_toe) in frame 5 is NaN");
    positions[0] = 1e12;
    let message = error(Points { positions: &positions, ..body.points() }, &none).to_string();
    assert_eq!(message, "the coordinate 1e12 of point 0 in frame 0 is beyond ±1e9");
    let overrides = Overrides { metres_per_unit: Some(0.0), ..none };
    assert_eq!(error(body.points(), &overrides), PointsError::Unit(0.0));
}
