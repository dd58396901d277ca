use nalgebra::Vector3;

use super::*;
use crate::bvh::{Channel, Clip, Joint, JointKind};
use crate::foot::{Part, Side};
use crate::formats::Source;
use crate::gait::{ActionRanges, Step};
use crate::plants::{Detection, Feet, FootLabels, FootTracks, Ground, PartLabels, ValidParams};
use crate::skeleton::{Overrides, Skeleton, Up};

const RATE: f64 = 100.0;
const FRAMES: usize = 800;

/// Clip with one joint, feet that walk next to it in strides of 1 s and 1.4 m, and their contacts.
fn walk() -> (Clip, Feet, Detection) {
    let root = Joint {
        name: "Hips".into(),
        kind: JointKind::Root,
        parent: None,
        offset: Vector3::zeros(),
        channels: vec![Channel::Position(crate::bvh::Axis::Y)],
    };
    let clip = Clip::new(vec![root], 1.0 / RATE, vec![0.0; FRAMES]);
    let mut planted = [Vec::new(), Vec::new()];
    let tracks = Side::BOTH.map(|side| {
        let index = side as usize;
        let track = (0..FRAMES).map(|frame| {
            let time = (frame as f64 + 0.5) / RATE - 0.2 - 0.5 * index as f64;
            let swung = ((time - time.floor() - 0.6) / 0.4).max(0.0);
            planted[index].push(swung == 0.0);
            let ahead = (time.floor() + swung + 0.5 * index as f64) * 1.4;
            Vector3::new(0.06 - 0.12 * index as f64, 0.02, ahead)
        });
        let toe: Vec<_> = track.collect();
        FootTracks { ankle: toe.iter().map(|toe| toe - Vector3::z() * 0.13).collect(), toe, tip: None }
    });
    let feet = Feet {
        tracks,
        hips: vec![Vector3::zeros(); FRAMES],
        up: Up::Y,
        leg: 0.9,
        metres_per_unit: 1.0,
        frame_time: 1.0 / RATE,
    };
    let labels = planted.map(|planted| FootLabels {
        confidence: vec![1.0; FRAMES],
        height: vec![0.0; FRAMES],
        speed: vec![0.0; FRAMES],
        planted,
        edges: Vec::new(),
    });
    let detection = Detection {
        params: ValidParams::default(),
        parts: vec![PartLabels { part: Part::Contact, feet: labels, evidence: None }],
        ground_height: 0.0,
        ground: Ground::level(),
        noise: None,
        notices: Vec::new(),
        edits: Vec::new(),
    };
    (clip, feet, detection)
}

fn written(format: GaitFormat, name: &str, actions: Option<Vec<ActionRanges>>) -> String {
    let (clip, feet, detection) = walk();
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let gait = SkeletonGait::new(&clip, &skeleton, &feet, &detection, actions);
    let source = Source { name: name.into(), sha256: None, name_encoding: None };
    format.write(&GaitExport { source, clip: &clip, skeletons: vec![gait] })
}

fn halves() -> Vec<ActionRanges> {
    let action = |name: &str, frames| ActionRanges { name: name.into(), frames: vec![frames] };
    vec![action("walk, <slow>", 0..400), action("B", 400..FRAMES)]
}

#[test]
fn the_table_of_steps_has_a_row_per_foot_strike() {
    let text = written(GaitFormat::Steps, "walk.bvh", None);
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0], Step::COLUMNS);
    assert_eq!(rows.len(), 17, "8 strikes of each foot");
    assert!(rows.iter().all(|row| row.len() == Step::COLUMNS.len()), "{text}");
    let row = &rows[6];
    let column = |name: &str| row[Step::COLUMNS.iter().position(|column| *column == name).unwrap()];
    assert_eq!((column("stride_time_s"), column("stride_length_m")), ("1", "1.4"));
    assert_eq!((column("stance_percent"), column("left_out")), ("60", ""));
    assert!(rows[16].contains(&"cut off"), "{text}");
}

#[test]
fn tables_per_action_name_it() {
    let text = written(GaitFormat::Steps, "walk.bvh", Some(halves()));
    assert!(text.starts_with("action,foot,"), "{text}");
    assert!(text.contains("\n\"walk, <slow>\",left,") && text.contains("\nB,right,"), "{text}");
}

#[test]
fn the_report_is_self_contained_and_states_measures_and_definitions() {
    let page = written(GaitFormat::Report, "<b>&\u{202e}walk.bvh", None);
    for expected in [
        "&lt;b&gt;&amp;\u{fffd}walk.bvh",
        "<dt>Cadence</dt><dd>120.0 <small>steps/min</small>",
        "<dt>Surface</dt><dd>Overground</dd>",
        "60.0 <small>± 0.0</small>",
        "140.0 <small>± 0.0</small>",
        "Strides left out: ",
        "100 · (R − L) / ((R + L) / 2)",
        "not clinical angles",
        "Perry J, Burnfield JM.",
    ] {
        assert!(page.contains(expected), "{expected}: {page}");
    }
    for foreign in ["<script", "http:", "https:", "url(", "@import", "<link", "src=", " style="] {
        assert!(!page.contains(foreign), "{foreign}");
    }
}

#[test]
fn the_report_compares_actions() {
    let page = written(GaitFormat::Report, "walk.bvh", Some(halves()));
    assert!(page.contains("walk, &lt;slow&gt;</th>") && page.contains("Action B</th>"), "{page}");
    assert!(!page.contains("<slow>"));
}

#[test]
fn a_report_without_strides_states_it() {
    let nothing = vec![ActionRanges { name: "A".into(), frames: vec![0..30] }];
    let page = written(GaitFormat::Report, "walk.bvh", Some(nothing));
    assert!(page.contains("no complete stride"), "{page}");
}
