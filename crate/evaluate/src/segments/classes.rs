//! Classes of actions: which segments are the same action.

use std::collections::BTreeMap;
use std::ops::Range;

use plantigrade::bvh::Clip;
use plantigrade::score::{self, ClassScore, Tally};
use plantigrade::segments::{self, Method, Segment};
use plantigrade::skeleton::{Overrides, Skeleton};
use plantigrade_synth::ActionClip;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::class_references::{Classes, kmeans_of_segment_means, spectral_clusters_of_frames};
use super::{params_of, two_decimals};
use crate::figure::{Matrix, draw_matrix};
use crate::report::Report;

/// A clip with annotated or generated actions.
pub struct ClassCase<'a> {
    /// The clip.
    pub clip: &'a Clip,
    /// Frame ranges with the names of their actions.
    pub truth: Vec<(Range<usize>, &'a str)>,
}

impl<'a> ClassCase<'a> {
    /// Creates the case of a generated clip; actions change in the middle of each transition.
    pub fn generated(clip: &'a ActionClip) -> ClassCase<'a> {
        let frames = clip.generated.clip.frame_count();
        let starts = std::iter::once(0).chain(clip.cuts.iter().map(|cut| cut.middle));
        let ends = clip.cuts.iter().map(|cut| cut.middle).chain([frames]);
        let ranges = starts.zip(ends).map(|(start, end)| start..end);
        let truth = ranges.zip(&clip.actions).map(|(range, action)| (range, action.name())).collect();
        ClassCase { clip: &clip.generated.clip, truth }
    }

    /// Creates the case of an annotated clip.
    pub fn recorded(clip: &'a Clip, actions: &'a [Segment]) -> ClassCase<'a> {
        let truth = actions.iter().map(|action| (action.frames.clone(), &*action.label)).collect();
        ClassCase { clip, truth }
    }

    /// Returns the number of different actions.
    fn class_count(&self) -> usize {
        let mut names: Vec<&str> = self.truth.iter().map(|(_, name)| *name).collect();
        names.sort_unstable();
        names.dedup();
        names.len()
    }

    /// Compares classes with the truth.
    pub fn score(&self, classes: &Classes) -> ClassScore {
        let detected: Vec<_> = classes.iter().map(|(range, name)| (range.clone(), name.as_str())).collect();
        score::classes(&detected, &self.truth)
    }
}

/// Returns the actions of a method.
pub fn actions_of(clip: &Clip, method: Method) -> Classes {
    classes_by(&segment(clip, method), |segment| &segment.action)
}

fn segment(clip: &Clip, method: Method) -> Vec<Segment> {
    let skeleton = Skeleton::main(clip, &Overrides::default());
    let params = params_of(method, false).check().expect("valid parameters");
    segments::segment(clip, &skeleton, params, &mut |_| Ok(())).expect("a body in motion").segments
}

fn classes_by(segments: &[Segment], name: impl Fn(&Segment) -> &String) -> Classes {
    segments.iter().map(|segment| (segment.frames.clone(), name(segment).clone())).collect()
}

/// Returns the segments of `auto`, each with the true action that has most of its frames: no grouping of
/// these segments is more accurate.
fn best_grouping(case: &ClassCase) -> Classes {
    let ranges = segment(case.clip, Method::Auto).into_iter().map(|segment| segment.frames);
    let best_action = |range: &Range<usize>| {
        let mut frames = BTreeMap::<&str, usize>::new();
        for (truth, name) in &case.truth {
            *frames.entry(name).or_default() += overlap(range, truth);
        }
        frames.into_iter().max_by_key(|(_, count)| *count).map_or("", |(name, _)| name).to_owned()
    };
    ranges.map(|range| (range.clone(), best_action(&range))).collect()
}

/// Returns the number of frames that two ranges have in common.
fn overlap(a: &Range<usize>, b: &Range<usize>) -> usize {
    a.end.min(b.end).saturating_sub(a.start.max(b.start))
}

/// Function from a case to its classes.
type Classifier = Box<dyn Fn(&ClassCase) -> Classes + Sync>;

/// Returns the methods and the references with their names in the table.
fn classifiers() -> Vec<(String, Classifier)> {
    let method = |&method: &Method| -> (String, Classifier) {
        (method.name().into(), Box::new(move |case| actions_of(case.clip, method)))
    };
    let kmeans = |case: &ClassCase, count: Option<usize>| {
        let segments = segment(case.clip, Method::Auto).into_iter();
        kmeans_of_segment_means(case.clip, &segments.map(|segment| segment.frames).collect::<Vec<_>>(), count)
    };
    let references: [(&str, Classifier); 6] = [
        ("best grouping of `auto` segments", Box::new(best_grouping)),
        ("k-means of the mean poses of `auto` segments", Box::new(move |case| kmeans(case, None))),
        (
            "the same, given the number of actions",
            Box::new(move |case| kmeans(case, Some(case.class_count()))),
        ),
        ("spectral clustering of frames", Box::new(|case| spectral_clusters_of_frames(case.clip, None))),
        (
            "the same, given the number of actions",
            Box::new(|case| spectral_clusters_of_frames(case.clip, Some(case.class_count()))),
        ),
        (
            "motif labels of `lsd`",
            Box::new(|case| classes_by(&segment(case.clip, Method::Lsd), |segment| &segment.label)),
        ),
    ];
    let references = references.map(|(name, classifier)| (format!("*{name}*"), classifier));
    Method::ALL.iter().map(method).chain(references).collect()
}

/// Adds the table of methods and references for some cases. With `by_clip`, each case has a column of its
/// own, under the given name.
pub fn table(report: &mut Report, cases: &[ClassCase], names: &[&str]) {
    let rows: Vec<Vec<String>> = classifiers()
        .iter()
        .map(|(name, classifier)| {
            let scores: Vec<ClassScore> =
                cases.par_iter().map(|case| case.score(&classifier(case))).collect();
            let mut frames = Tally::default();
            scores.iter().for_each(|score| frames += score.frames);
            let mean = scores.iter().map(|score| score.adjusted_rand).sum::<f64>() / scores.len() as f64;
            let mut row = vec![name.clone(), two_decimals(frames.accuracy()), two_decimals(mean)];
            row.extend(names.iter().zip(&scores).flat_map(|(_, score)| {
                [two_decimals(score.frames.accuracy()), two_decimals(score.adjusted_rand)]
            }));
            row
        })
        .collect();
    let by_name = names.iter().flat_map(|name| [format!("accuracy, {name}"), format!("index, {name}")]);
    let head: Vec<String> =
        ["actions of", "accuracy", "index"].map(String::from).into_iter().chain(by_name).collect();
    report.table(&head.iter().map(String::as_str).collect::<Vec<_>>(), &rows);
}

/// Adds the section about generated clips.
pub fn write_generated(report: &mut Report, clips: &[ActionClip]) {
    report.text("### Classes of actions");
    report.text(INTRODUCTION);
    let cases: Vec<ClassCase> = clips.iter().map(ClassCase::generated).collect();
    table(report, &cases, &[]);
    report.text(&common_names(clips));
}

/// Describes the accuracy of common names for all sequences of one seed.
fn common_names(clips: &[ActionClip]) -> String {
    let count = plantigrade_synth::action_sequences().len();
    let clips = &clips[..count];
    let skeleton = |clip: &Clip| Skeleton::main(clip, &Overrides::default());
    let params = params_of(Method::Auto, false).check().expect("valid parameters");
    let segmentations: Vec<_> = clips
        .par_iter()
        .map(|clip| {
            let clip = &clip.generated.clip;
            segments::segment(clip, &skeleton(clip), params, &mut |_| Ok(())).expect("a body in motion")
        })
        .collect();
    let actions: Vec<_> = segmentations.iter().map(|segmentation| segmentation.actions.as_slice()).collect();
    let names = segments::common_names(&actions);
    let (mut detected, mut truth, mut start) = (Vec::new(), Vec::new(), 0);
    let moved = |range: &Range<usize>, start: usize| range.start + start..range.end + start;
    for ((clip, segmentation), names) in clips.iter().zip(&segmentations).zip(&names) {
        for segment in &segmentation.segments {
            let index = segmentation.actions.iter().position(|action| action.name == segment.action);
            let name = index.map_or("", |index| names[index].as_str());
            detected.push((moved(&segment.frames, start), name));
        }
        let case = ClassCase::generated(clip);
        truth.extend(case.truth.iter().map(|(range, name)| (moved(range, start), *name)));
        start += case.clip.frame_count();
    }
    let score = score::classes(&detected, &truth);
    let count_of = |ranges: &[(Range<usize>, &str)]| {
        ranges.iter().map(|(_, name)| *name).collect::<std::collections::BTreeSet<_>>().len()
    };
    format!(
        "Common names for the {count} sequences of seed {}, which have {} different actions by eight \
         performers: `auto` finds {} actions; with one assignment for all sequences, accuracy is {} and the \
         index {}.",
        crate::plants::trial::SEEDS.start,
        count_of(&truth),
        count_of(&detected),
        two_decimals(score.frames.accuracy()),
        two_decimals(score.adjusted_rand)
    )
}

/// Adds a figure of the seconds that each annotated action of a clip has in each detected action.
pub fn confusion(report: &mut Report, case: &ClassCase, name: &str, method: Method) -> anyhow::Result<()> {
    let detected = actions_of(case.clip, method);
    let mut columns: Vec<&str> = detected.iter().map(|(_, name)| name.as_str()).collect();
    columns.sort_unstable();
    columns.dedup();
    let mut rows: Vec<&str> = Vec::new();
    for (_, name) in &case.truth {
        if !rows.contains(name) {
            rows.push(name);
        }
    }
    let seconds = |row: &str, column: &str| {
        let truth = case.truth.iter().filter(|(_, name)| *name == row);
        let frames: usize = truth
            .flat_map(|(range, _)| {
                let detected = detected.iter().filter(|(_, name)| name == column);
                detected.map(move |(other, _)| overlap(range, other))
            })
            .sum();
        frames as f64 * case.clip.frame_time()
    };
    let amounts: Vec<Vec<f64>> =
        rows.iter().map(|row| columns.iter().map(|column| seconds(row, column)).collect()).collect();
    let path = report.figure(
        "actions-confusion",
        &format!("Seconds of each annotated action of {name} in each action of `{}`", method.name()),
    );
    let title = format!("{name}: seconds of annotated actions in the actions of {}", method.name());
    draw_matrix(
        &path,
        &Matrix { title: &title, rows: &rows, columns: ("Detected actions", &columns), amounts: &amounts },
    )
}

const INTRODUCTION: &str = "\
Segments of the same action share a name. *Accuracy* is the fraction of frames whose name corresponds to the true
action after the one-to-one assignment of names to actions that gives the most, pooled; *index* is the adjusted Rand
index, the mean over clips. Both include errors of the cuts. The names and their number follow from the data. The
thresholds of the grouping were chosen on seeds 0 to 3. The *best grouping* gives each segment of `auto` the true
action of most of its frames: its errors are those of the cuts, and no grouping of these segments is more accurate.
Three references are in italics below it: k-means of the mean poses of the segments of `auto`, spectral clustering of
frames (normalised affinities of five poses per second, as in Hu et al. 2016), and segments of `lsd` with equal
motifs. The number of actions of the first two is that with the largest mean silhouette and that before the largest
gap between eigenvalues; each has a second row in which the true number is given.";
