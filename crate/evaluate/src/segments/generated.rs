//! Segmentation of generated motion, whose cuts are known to the frame.

use plantigrade::score::{self, CutTally, Tolerance, TrueCut};
use plantigrade::segments::Method;
use plantigrade_synth::actions::Action;
use plantigrade_synth::{ActionClip, action_sequences, decimate, generate_sequence};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use super::{Case, Variant, all_cuts, classes, pooled, two_decimals, variants};
use crate::plants::trial::SEEDS;
use crate::report::Report;

/// Maximum distance of equal cuts at different frame rates, in seconds.
const RATE_TOLERANCE: f64 = 0.2;

/// Margin around the ranges of true cuts in the last column of the table, in seconds.
const RANGE_MARGIN: f64 = 0.5;

/// Generated clips and their segmentation by all variants.
pub struct Generated {
    /// The clips, by seed and sequence.
    pub clips: Vec<ActionClip>,
    /// The clips with their true cuts.
    pub cases: Vec<Case>,
    /// The cuts of each clip, by variant.
    pub cuts: Vec<(Variant, Vec<Vec<usize>>)>,
}

impl Generated {
    /// Generates the clips of all seeds and segments them with all variants.
    pub fn new(seeds: impl Iterator<Item = u64>) -> Generated {
        let sequences = action_sequences();
        let jobs: Vec<_> =
            seeds.flat_map(|seed| sequences.iter().map(move |sequence| (sequence, seed))).collect();
        let clips: Vec<ActionClip> =
            jobs.par_iter().map(|(sequence, seed)| generate_sequence(sequence, *seed, 1.0)).collect();
        let cases: Vec<Case> = clips.iter().map(case).collect();
        let jobs: Vec<(Variant, &[Case])> =
            variants().into_iter().map(|variant| (variant, cases.as_slice())).collect();
        let cuts = jobs.iter().map(|(variant, _)| *variant).zip(all_cuts(&jobs)).collect();
        Generated { clips, cases, cuts }
    }

    /// Compares the cuts of a variant with the truth, pooled over the clips.
    fn tally(&self, variant: &Variant, tolerance: Tolerance) -> CutTally {
        pooled(&self.cases, self.cuts_of(variant), tolerance)
    }

    /// Compares the cuts of a variant with the true ranges, extended by [`RANGE_MARGIN`].
    fn tally_near_range(&self, variant: &Variant) -> CutTally {
        let mut tally = CutTally::default();
        for (case, cuts) in self.cases.iter().zip(self.cuts_of(variant)) {
            tally += score::cuts(cuts, &extended_ranges(case), case.clip.frame_time(), Tolerance::Inside);
        }
        tally
    }

    fn cuts_of(&self, variant: &Variant) -> &[Vec<usize>] {
        let cuts = self.cuts.iter().find(|(other, _)| other == variant);
        cuts.map(|(_, cuts)| cuts.as_slice()).expect("cuts of every variant")
    }
}

fn case(clip: &ActionClip) -> Case {
    let true_cut =
        |cut: &plantigrade_synth::Cut| TrueCut { earliest: cut.earliest as f64, latest: cut.latest as f64 };
    Case { clip: clip.generated.clip.clone(), truth: clip.cuts.iter().map(true_cut).collect() }
}

/// Adds the section. Returns the generated clips.
pub fn write(report: &mut Report) -> Generated {
    let generated = Generated::new(SEEDS);
    introduction(report);
    let count = action_sequences().len();
    let frames: usize = generated.cases[..count].iter().map(|case| case.clip.frame_count()).sum();
    report.text("### Generated actions");
    report.text(&format!(
        "{count} sequences of four to eight actions, planned as one motion at 120 Hz ({frames} frames per \
         seed), with known cuts. The methods were selected on seeds 0 to 3; results are for seeds 10 to \
         19. Seeds differ in steps and noise but not in the order of actions, so ten seeds provide less \
         than ten times the evidence of one."
    ));
    table(report, &generated);
    frame_rates(report, &generated);
    classes::write_generated(report, &generated.clips);
    generated
}

fn introduction(report: &mut Report) {
    report.text("## Segmentation into actions");
    report.text(
        "Detected cuts are matched one to one with true cuts, nearest pairs first. A cut is correct if it \
         is within a given time of the middle of the true cut, or *inside* the range of frames in which \
         one action changes into the next. P (precision) is the fraction of detected cuts that are \
         correct, R (recall) the fraction of true cuts that are detected, F1 their harmonic mean. The MVU \
         paper counts both inside. The methods:",
    );
    let description =
        |method: &Method| format!("- `{}`: {}. {}", method.name(), method.title(), method.description());
    report.text(&Method::ALL.iter().map(description).collect::<Vec<_>>().join("\n"));
    report.text(
        "*As published* follows the publication where the default differs from it. For `mvu` this is ten \
         dimensions, the residual as a ratio of the total, and a cut wherever the residual grows by more \
         than the mean (`--dims 10 --residual ratio --published`). Its defaults are one dimension, the \
         absolute residual, and three times the mean relative to the window 0.67 s before; two further \
         rows each change one of these. For `ppca` it is a fixed peak of 15. For `lsd` it is a separate \
         threshold for each wavelet level, no smoothing, and splits by amplitude only. `pca` is as \
         published.",
    );
}

fn table(report: &mut Report, generated: &Generated) {
    let rows: Vec<Vec<String>> = generated
        .cuts
        .iter()
        .map(|(variant, _)| {
            let [half, one, inside] =
                Tolerance::REPORTED.map(|tolerance| generated.tally(variant, tolerance));
            let near_range = generated.tally_near_range(variant);
            let values = [one.precision(), one.recall(), one.f1(), half.f1(), inside.f1(), near_range.f1()];
            let mut row = vec![variant.name.to_owned(), one.total.to_string(), one.detected.to_string()];
            row.extend(values.map(two_decimals));
            row
        })
        .collect();
    let last = format!("F1 within {RANGE_MARGIN} s of the range");
    report.table(
        &[
            "method",
            "true cuts",
            "detected",
            "P at ±1 s",
            "R at ±1 s",
            "F1 at ±1 s",
            "F1 at ±0.5 s",
            "F1 inside",
            &last,
        ],
        &rows,
    );
}

/// Returns the true cuts with their ranges extended by [`RANGE_MARGIN`] at both ends.
fn extended_ranges(case: &Case) -> Vec<TrueCut> {
    let margin = RANGE_MARGIN / case.clip.frame_time();
    let extended = |cut: &TrueCut| TrueCut { earliest: cut.earliest - margin, latest: cut.latest + margin };
    case.truth.iter().map(extended).collect()
}

/// Adds the agreement of cuts at lower frame rates with those at the full rate.
fn frame_rates(report: &mut Report, generated: &Generated) {
    const FACTORS: [usize; 3] = [2, 4, 5];
    let count = action_sequences().len();
    let reduced_cases = FACTORS.map(|factor| {
        let reduced =
            |clip: &ActionClip| Case { clip: decimate(&clip.generated, factor).clip, truth: Vec::new() };
        generated.clips[..count].iter().map(reduced).collect::<Vec<Case>>()
    });
    let defaults: Vec<Variant> = variants().into_iter().take(Method::ALL.len()).collect();
    let jobs: Vec<(Variant, &[Case])> = defaults
        .iter()
        .flat_map(|variant| reduced_cases.iter().map(move |cases| (*variant, cases.as_slice())))
        .collect();
    let mut reduced_cuts = all_cuts(&jobs).into_iter();
    let rows: Vec<Vec<String>> = defaults
        .iter()
        .map(|variant| {
            let by_rate = FACTORS.map(|factor| {
                let reduced = reduced_cuts.next().expect("cuts at each rate");
                let full = generated.cases.iter().zip(generated.cuts_of(variant));
                let mut tally = CutTally::default();
                for ((case, full), reduced) in full.zip(reduced) {
                    let full: Vec<TrueCut> = full.iter().map(|&cut| TrueCut::at(cut as f64)).collect();
                    let reduced: Vec<usize> = reduced.iter().map(|cut| cut * factor).collect();
                    let tolerance = Tolerance::Seconds(RATE_TOLERANCE);
                    tally += score::cuts(&reduced, &full, case.clip.frame_time(), tolerance);
                }
                two_decimals(tally.f1())
            });
            [vec![variant.name.to_owned()], by_rate.to_vec()].concat()
        })
        .collect();
    report.text(&format!(
        "Agreement of cuts at lower frame rates with those at 120 Hz, for the clips of seed {}: F1 with a \
         tolerance of {RATE_TOLERANCE} s.",
        SEEDS.start
    ));
    report.table(&["method", "60 Hz", "30 Hz", "24 Hz"], &rows);
}

/// Kind of transition between two actions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transition {
    /// Between walking and jogging.
    Gait,
    /// Into or out of a turn on the spot.
    Turn,
    /// Other transitions of 1 s or longer, in which the actor pauses.
    Long,
    /// Other transitions.
    Short,
}

impl Transition {
    /// All kinds.
    pub const ALL: [Transition; 4] =
        [Transition::Gait, Transition::Turn, Transition::Long, Transition::Short];

    /// Returns the kind of the transition between two actions.
    pub fn between(actions: &[Action], cut: &TrueCut, frame_time: f64) -> Transition {
        if actions.iter().all(|action| matches!(action, Action::Walk | Action::Jog)) {
            Transition::Gait
        } else if actions.contains(&Action::Turn) {
            Transition::Turn
        } else if (cut.latest - cut.earliest) * frame_time >= 1.0 {
            Transition::Long
        } else {
            Transition::Short
        }
    }

    /// Returns the description in tables.
    pub fn title(self) -> &'static str {
        match self {
            Transition::Gait => "between walking and jogging",
            Transition::Turn => "into and out of a turn of 2 s",
            Transition::Long => "others of 1 s or longer",
            Transition::Short => "others",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_has_the_highest_f1() {
        let generated = Generated::new(10..11);
        let (default, others) = generated.cuts.split_first().expect("several variants");
        assert_eq!(default.0.params.method, Method::Auto);
        // Cuts at the ends of a pause are as good as cuts in its middle.
        let near_range = |variant: &Variant| generated.tally_near_range(variant).f1();
        let default_score = near_range(&default.0);
        assert!(default_score >= 0.8, "{default_score}");
        for (variant, _) in others {
            assert!(
                near_range(variant) < default_score,
                "{}: {} {default_score}",
                variant.name,
                near_range(variant)
            );
        }
        // The published variants have a lower F1 from the middle too.
        let from_middle = |variant: &Variant| generated.tally(variant, Tolerance::Seconds(1.0)).f1();
        for (variant, _) in others.iter().filter(|(variant, _)| variant.params.published) {
            let f1 = from_middle(variant);
            assert!(f1 < from_middle(&default.0), "{}: {f1}", variant.name);
        }
    }
}
