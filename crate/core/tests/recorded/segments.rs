//! Cuts of recorded motion, compared with annotated cuts.

use std::fs;
use std::path::Path;

use plantigrade::bvh::Clip;
use plantigrade::formats;
use plantigrade::score::{self, CutTally, Tolerance, TrueCut};
use plantigrade::segments::{self, Kind, Method, Params, SegmentError, Segmentation};
use plantigrade::skeleton::{Overrides, Skeleton};

use crate::support;

fn cut(clip: &Clip, params: Params) -> Result<Segmentation, SegmentError> {
    let skeleton = Skeleton::main(clip, &Overrides::default());
    segments::segment(clip, &skeleton, params.check().unwrap(), &mut |_| Ok(()))
}

fn params(method: Method) -> Params {
    Params { method, ..Params::default() }
}

/// Returns the clips with annotated cuts.
fn trials(corpus: &Path) -> [(&'static str, Clip, Vec<TrueCut>); 2] {
    let folder = corpus.join("cmu");
    let trial = |(name, truth)| {
        let clip = support::read(&folder.join(name).with_extension("bvh")).clip;
        let text = fs::read_to_string(folder.join(truth)).expect("the truth");
        let cuts = formats::read_cuts(&text, name, clip.frame_count(), clip.rate()).expect("cuts");
        (name, clip, cuts)
    };
    [("86_01", "segmentation.json"), ("13_30", "segmentation_mocap6.json")].map(trial)
}

pub fn cuts_agree_with_annotated_cuts(corpus: &Path) {
    let trials = trials(corpus);
    let minimum_f1 = [
        (params(Method::Auto), 0.94),
        (params(Method::Ppca), 0.90),
        (params(Method::Lsd), 0.85),
        (params(Method::PcaTail), 0.80),
        (params(Method::Mvu), 0.60),
    ];
    for (params, minimum) in minimum_f1 {
        let mut tally = CutTally::default();
        for (_, clip, truth) in &trials {
            let cuts = cut(clip, params).unwrap().cuts();
            tally += score::cuts(&cuts, truth, clip.frame_time(), Tolerance::Seconds(1.0));
        }
        assert_eq!(tally.total, 10);
        assert!(tally.f1() >= minimum, "{}: {:.3}", params.method, tally.f1());
    }
}

pub fn cuts_are_invariant_to_the_frame_rate(corpus: &Path) {
    let trials = trials(corpus);
    for method in Method::ALL {
        for (name, clip, _) in &trials {
            let cut_times = |every: usize| {
                let rows = (0..clip.frame_count()).step_by(every);
                let values = rows.flat_map(|frame| clip.row(frame)).copied().collect();
                let clip = Clip::new(clip.joints().to_vec(), clip.frame_time() * every as f64, values);
                let cuts = cut(&clip, params(*method)).unwrap().cuts();
                cuts.iter().map(|&cut| cut as f64 * clip.frame_time()).collect::<Vec<_>>()
            };
            let all = cut_times(1);
            for every in [2, 4, 5] {
                let fewer = cut_times(every);
                assert_eq!(all.len(), fewer.len(), "{method} {name}: {all:?} {fewer:?}");
                for (a, b) in all.iter().zip(&fewer) {
                    assert!((a - b).abs() <= 0.2, "{method} {name}, every {every}: {all:?} {fewer:?}");
                }
            }
        }
    }
}

pub fn motifs_agree_with_the_patent(corpus: &Path) {
    let trials = trials(corpus);
    let segmentation = cut(&trials[0].1, params(Method::Lsd)).unwrap();
    let inner = &segmentation.motifs[1..segmentation.motifs.len() - 1];
    // The threshold is 6.5; that of the patent separates changes of at least 10.
    assert!(inner.iter().all(|motif| motif.amplitude.abs() >= 10.0));
    // Few changes between turning points are near the threshold, from 5 to 10.
    let turns: Vec<f64> = {
        let values = &segmentation.curve.values;
        let is_turn = |i: &usize| (values[*i] - values[i - 1]) * (values[i + 1] - values[*i]) < 0.0;
        (1..values.len() - 1).filter(is_turn).map(|i| values[i]).collect()
    };
    let changes: Vec<f64> = turns.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    let near = changes.iter().filter(|change| (5.0..10.0).contains(*change)).count();
    assert!(near * 10 <= changes.len(), "{near} of {}", changes.len());
    // Walk, jump, walk, punch, walk, kick, punch: equal actions have equal labels.
    let [walk, _, walk_2, punch, walk_3, kick, punch_2] = &segmentation.segments[..] else {
        panic!("{:?}", segmentation.segments);
    };
    assert!([walk, punch, kick].iter().all(|segment| segment.kind == Kind::Periodic));
    assert!(walk.label == walk_2.label && walk.label == walk_3.label);
    assert_eq!(punch.label, punch_2.label);
}

pub fn files_are_segmented_or_rejected_with_a_reason(corpus: &Path) {
    for path in support::bvh_files(corpus) {
        let clip = support::read(&path).clip;
        for method in [Method::Auto, Method::Lsd, Method::Pca, Method::PcaTail, Method::Ppca] {
            match cut(&clip, params(method)) {
                Ok(segmentation) => {
                    let last = segmentation.segments.last().map(|segment| segment.frames.end);
                    assert_eq!(last, Some(clip.frame_count()), "{}", path.display());
                    assert!(
                        segmentation.curve.values.iter().all(|value| value.is_finite()),
                        "{}",
                        path.display()
                    );
                }
                Err(SegmentError::NoMotion) => assert_eq!(clip.frame_count(), 0),
                Err(error) => assert!(error.to_string().contains("name more joints"), "{error}"),
            }
        }
    }
}
