//! Cuts of generated motion, which are known to the frame.

use plantigrade::score::{self, CutTally, Tolerance, TrueCut};
use plantigrade::segments::Method;
use plantigrade_synth::act::Action;
use plantigrade_synth::{Chain, chained, decimated, sequences};

use super::{Case, Way, all_cuts, pooled, share, ways};
use crate::parallel;
use crate::report::Report;
use crate::trial::SEEDS;

/// How far cuts at different rates may lie apart and be the same, in seconds.
const SAME: f64 = 0.2;

/// Seconds by which a cut may miss the range of the true one in the last column.
const NEAR: f64 = 0.5;

/// Generated clips, seed by seed, with what every way makes of them.
pub struct Generated {
    pub chains: Vec<Chain>,
    pub cases: Vec<Case>,
    pub found: Vec<(Way, Vec<Vec<usize>>)>,
}

impl Generated {
    /// The clips of some seeds, cut in all ways.
    pub fn of(seeds: impl Iterator<Item = u64>) -> Generated {
        let plans = sequences();
        let jobs: Vec<_> = seeds.flat_map(|seed| plans.iter().map(move |plan| (plan, seed))).collect();
        let chains = parallel::map(&jobs, |(plan, seed)| chained(plan, *seed, 1.0));
        let cases: Vec<Case> = chains.iter().map(case).collect();
        let jobs: Vec<(Way, &[Case])> = ways().into_iter().map(|way| (way, cases.as_slice())).collect();
        let found = jobs.iter().map(|(way, _)| *way).zip(all_cuts(&jobs)).collect();
        Generated { chains, cases, found }
    }

    /// Cuts of a way, pooled over its clips.
    fn tally(&self, way: &Way, tolerance: Tolerance) -> CutTally {
        pooled(&self.cases, self.cuts(way), tolerance)
    }

    /// How many of a way's cuts are no farther than [`NEAR`] from the true ranges.
    fn near(&self, way: &Way) -> CutTally {
        let mut tally = CutTally::default();
        for (case, found) in self.cases.iter().zip(self.cuts(way)) {
            tally += score::cuts(found, &widened(case), case.clip.frame_time(), Tolerance::Inside);
        }
        tally
    }

    fn cuts(&self, way: &Way) -> &[Vec<usize>] {
        let found = self.found.iter().find(|(other, _)| other == way);
        found.map(|(_, cuts)| cuts.as_slice()).expect("cuts of every way")
    }
}

fn case(chain: &Chain) -> Case {
    let range =
        |cut: &plantigrade_synth::Cut| TrueCut { earliest: cut.earliest as f64, latest: cut.latest as f64 };
    Case { clip: chain.generated.clip.clone(), truth: chain.cuts.iter().map(range).collect() }
}

/// Adds the section, and gives what it is of.
pub fn write(report: &mut Report) -> Generated {
    let generated = Generated::of(SEEDS);
    introduction(report);
    let frames: usize = generated.cases[..sequences().len()].iter().map(|case| case.clip.frame_count()).sum();
    report.text("### Actions, generated");
    report.text(&format!(
        "{} sequences of four to eight actions, planned as one motion at 120 Hz ({frames} frames for each seed), \
         with the true cuts known. Seeds 0 to 3 were looked at when methods were chosen; these are seeds 10 to 19. \
         Another seed gives other steps \
         and noise, but the same actions in the same order: ten seeds are less than ten times the evidence of one.",
        sequences().len()
    ));
    table(report, &generated);
    rates(report, &generated);
    generated
}

fn introduction(report: &mut Report) {
    report.text("## Cutting into actions");
    report.text(
        "Cuts are matched with true ones, each once and the nearest pair first. They are right within a time of the \
         middle of the true cut, or *inside* the range of frames in which one action goes over into the next. P is \
         the share of found cuts that are right, R that of true cuts that were found (the MVU paper counts both inside), \
         F1 their harmonic mean. The methods:",
    );
    let methods =
        Method::ALL.map(|method| format!("- `{}`: {}. {}", method.name(), method.title(), method.about()));
    report.text(&methods.join("\n"));
    report.text(
        "*As published* is to the letter where the methods depart from it. For `mvu` that is ten dimensions, the \
         residual as a share of all, and a cut wherever it grows by more than the mean (`--dims 10 --residual ratio \
         --published`); its own are one dimension, the residual itself, and three times the mean against the \
         window 0.67 s before. Two more lines change one of the three each. For `ppca` it is a fixed peak of 15, for \
         `lsd` thresholds of each wavelet level's own, no blur and splits by amplitude alone. `pca` is as published.",
    );
}

fn table(report: &mut Report, generated: &Generated) {
    let rows: Vec<Vec<String>> = generated
        .found
        .iter()
        .map(|(way, _)| {
            let [half, one, inside] = Tolerance::USUAL.map(|tolerance| generated.tally(way, tolerance));
            let near = generated.near(way);
            let shares = [one.precision(), one.recall(), one.f1(), half.f1(), inside.f1(), near.f1()];
            let mut row = vec![way.name.to_owned(), one.wanted.to_string(), one.found.to_string()];
            row.extend(shares.map(share));
            row
        })
        .collect();
    let last = format!("F1 within {NEAR} s of the range");
    report.table(
        &[
            "method",
            "true cuts",
            "found",
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

/// True cuts with some time added to both ends of their ranges.
fn widened(case: &Case) -> Vec<TrueCut> {
    let more = NEAR / case.clip.frame_time();
    let wider = |cut: &TrueCut| TrueCut { earliest: cut.earliest - more, latest: cut.latest + more };
    case.truth.iter().map(wider).collect()
}

/// How many cuts are those of the full rate when frames are left out.
fn rates(report: &mut Report, generated: &Generated) {
    const FACTORS: [usize; 3] = [2, 4, 5];
    let count = sequences().len();
    let fewer = FACTORS.map(|factor| {
        let thinned =
            |chain: &Chain| Case { clip: decimated(&chain.generated, factor).clip, truth: Vec::new() };
        generated.chains[..count].iter().map(thinned).collect::<Vec<Case>>()
    });
    let own: Vec<Way> = ways().into_iter().take(Method::ALL.len()).collect();
    let jobs: Vec<(Way, &[Case])> =
        own.iter().flat_map(|way| fewer.iter().map(move |cases| (*way, cases.as_slice()))).collect();
    let mut found = all_cuts(&jobs).into_iter();
    let rows: Vec<Vec<String>> = own
        .iter()
        .map(|way| {
            let of_rate = FACTORS.map(|factor| {
                let cuts = found.next().expect("cuts at each rate");
                let all = generated.cases.iter().zip(generated.cuts(way));
                let mut tally = CutTally::default();
                for ((case, whole), cuts) in all.zip(cuts) {
                    let whole: Vec<TrueCut> = whole.iter().map(|&cut| TrueCut::at(cut as f64)).collect();
                    let cuts: Vec<usize> = cuts.iter().map(|cut| cut * factor).collect();
                    tally += score::cuts(&cuts, &whole, case.clip.frame_time(), Tolerance::Seconds(SAME));
                }
                share(tally.f1())
            });
            [vec![way.name.to_owned()], of_rate.to_vec()].concat()
        })
        .collect();
    report.text(&format!(
        "The clips of seed {} with frames left out: the share of cuts (of both rates together) that lie within \
         {SAME} s of one at 120 Hz.",
        SEEDS.start
    ));
    report.table(&["method", "60 Hz", "30 Hz", "24 Hz"], &rows);
}

/// What goes over into what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Walking into jogging or back.
    Gait,
    /// Into a turn on the spot, or out of it.
    Turn,
    /// With a second or more in which the actor comes to rest or gets going.
    Slow,
    /// At once.
    Quick,
}

impl Change {
    /// All of them.
    pub const ALL: [Change; 4] = [Change::Gait, Change::Turn, Change::Slow, Change::Quick];

    /// Whatever is between two actions.
    pub fn of(actions: &[Action], cut: &TrueCut, frame_time: f64) -> Change {
        if actions.iter().all(|action| matches!(action, Action::Walk | Action::Jog)) {
            Change::Gait
        } else if actions.contains(&Action::Turn) {
            Change::Turn
        } else if (cut.latest - cut.earliest) * frame_time >= 1.0 {
            Change::Slow
        } else {
            Change::Quick
        }
    }

    /// What it is called.
    pub fn title(self) -> &'static str {
        match self {
            Change::Gait => "walk to jog, jog to walk",
            Change::Turn => "into and out of a turn of 2 s",
            Change::Slow => "others that take 1 s or more",
            Change::Quick => "others",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_is_ahead_of_all_others() {
        let generated = Generated::of(10..11);
        let (default, others) = generated.found.split_first().expect("several ways");
        assert_eq!(default.0.params.method, Method::Auto);
        // At the ends of a rest between two actions there are cuts as good as in its middle.
        let near = |way: &Way| generated.near(way).f1();
        let own = near(&default.0);
        assert!(own >= 0.8, "{own}");
        for (way, _) in others {
            assert!(near(way) < own, "{}: {} {own}", way.name, near(way));
        }
        // From the middle, what is as published is behind as well.
        let middle = |way: &Way| generated.tally(way, Tolerance::Seconds(1.0)).f1();
        for (way, _) in others.iter().filter(|(way, _)| way.params.published) {
            assert!(middle(way) < middle(&default.0), "{}: {}", way.name, middle(way));
        }
    }
}
