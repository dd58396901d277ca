//! Cuts of recorded motion against those that people made.

mod support;

use std::fs;

use plantigrade::bvh::Clip;
use plantigrade::formats;
use plantigrade::score::{self, CutTally, Tolerance, TrueCut};
use plantigrade::segments::{self, Kind, Method, Params, SegmentError, Segmentation};
use plantigrade::skeleton::{Overrides, Skeleton};

fn cut(clip: &Clip, params: Params) -> Result<Segmentation, SegmentError> {
    let skeleton = Skeleton::main(clip, &Overrides::default());
    segments::segment(clip, &skeleton, params.check().unwrap(), &mut |_| Ok(()))
}

fn by(method: Method) -> Params {
    Params { method, ..Params::default() }
}

/// The recorded clips whose cuts are known.
fn trials() -> Option<Vec<(&'static str, Clip, Vec<TrueCut>)>> {
    let folder = support::corpus::folder()?.join("cmu");
    let trial = |(name, truth)| {
        let clip = support::read(&folder.join(name).with_extension("bvh")).clip;
        let text = fs::read_to_string(folder.join(truth)).expect("the truth");
        let cuts = formats::read_cuts(&text, name, clip.frame_count(), clip.rate()).expect("cuts");
        (name, clip, cuts)
    };
    Some([("86_01", "segmentation.json"), ("13_30", "segmentation_mocap6.json")].map(trial).into())
}

#[test]
fn cuts_are_where_people_made_them() {
    let Some(trials) = trials() else { return };
    let least = [
        (by(Method::Auto), 0.94),
        (by(Method::Ppca), 0.90),
        (by(Method::Lsd), 0.85),
        (by(Method::PcaTail), 0.80),
        (by(Method::Mvu), 0.60),
    ];
    for (params, least) in least {
        let mut tally = CutTally::default();
        for (_, clip, truth) in &trials {
            let found = cut(clip, params).unwrap().cuts();
            tally += score::cuts(&found, truth, clip.frame_time(), Tolerance::Seconds(1.0));
        }
        assert_eq!(tally.total, 10);
        assert!(tally.f1() >= least, "{}: {:.3}", params.method, tally.f1());
    }
}

#[test]
fn rates_give_the_same_cuts() {
    let Some(trials) = trials() else { return };
    for method in Method::ALL {
        for (name, clip, _) in &trials {
            let seconds = |every: usize| {
                let rows = (0..clip.frame_count()).step_by(every);
                let values = rows.flat_map(|frame| clip.row(frame)).copied().collect();
                let clip = Clip::new(clip.joints().to_vec(), clip.frame_time() * every as f64, values);
                let cuts = cut(&clip, by(*method)).unwrap().cuts();
                cuts.iter().map(|&cut| cut as f64 * clip.frame_time()).collect::<Vec<_>>()
            };
            let whole = seconds(1);
            for every in [2, 4, 5] {
                let other = seconds(every);
                assert_eq!(whole.len(), other.len(), "{method} {name}: {whole:?} {other:?}");
                for (a, b) in whole.iter().zip(&other) {
                    assert!((a - b).abs() <= 0.2, "{method} {name}, every {every}: {whole:?} {other:?}");
                }
            }
        }
    }
}

#[test]
fn motifs_are_the_patents() {
    let Some(trials) = trials() else { return };
    let found = cut(&trials[0].1, by(Method::Lsd)).unwrap();
    let inner = &found.motifs[1..found.motifs.len() - 1];
    // The threshold is 6.5; the patent's split keeps what is 10 and more.
    assert!(inner.iter().all(|motif| motif.amplitude.abs() >= 10.0));
    // What is left out is small: between all turning points, few changes lie from 5 to 10.
    let turns: Vec<f64> = {
        let values = &found.curve.values;
        let is_turn = |i: &usize| (values[*i] - values[i - 1]) * (values[i + 1] - values[*i]) < 0.0;
        (1..values.len() - 1).filter(is_turn).map(|i| values[i]).collect()
    };
    let changes: Vec<f64> = turns.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    let between = changes.iter().filter(|change| (5.0..10.0).contains(*change)).count();
    assert!(between * 10 <= changes.len(), "{between} of {}", changes.len());
    // Walk, jump, walk, punch, walk, kick, punch: what is the same has the same cycle.
    let [walk, _, walk_2, punch, walk_3, kick, punch_2] = &found.segments[..] else {
        panic!("{:?}", found.segments);
    };
    assert!([walk, punch, kick].iter().all(|segment| segment.kind == Kind::Periodic));
    assert!(walk.label == walk_2.label && walk.label == walk_3.label);
    assert_eq!(punch.label, punch_2.label);
}

#[test]
fn every_file_has_an_answer_or_a_message() {
    let Some(corpus) = support::corpus::folder() else { return };
    for path in support::bvh_files(&corpus) {
        let clip = support::read(&path).clip;
        for method in [Method::Auto, Method::Lsd, Method::Pca, Method::PcaTail, Method::Ppca] {
            match cut(&clip, by(method)) {
                Ok(found) => {
                    let last = found.segments.last().map(|segment| segment.frames.end);
                    assert_eq!(last, Some(clip.frame_count()), "{}", path.display());
                    assert!(found.curve.values.iter().all(|value| value.is_finite()), "{}", path.display());
                }
                Err(SegmentError::NoMotion) => assert_eq!(clip.frame_count(), 0),
                Err(error) => assert!(error.to_string().contains("name more joints"), "{error}"),
            }
        }
    }
}
