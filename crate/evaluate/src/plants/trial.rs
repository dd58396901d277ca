//! Clips with truth, and the accuracy of labels.

use std::ops::Range;
use std::path::Path;

use plantigrade::bvh::{self, Clip};
use plantigrade::foot::{Part, Side};
use plantigrade::formats;
use plantigrade::plants::{self, Detection, Feet, Method, Params};
use plantigrade::score::{self, Events, Tally, Truth};
use plantigrade::skeleton::{Overrides, Skeleton};
use plantigrade_synth::{ClipSpec, Generated, generate};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

/// Seeds of the reported results.
pub const SEEDS: Range<u64> = 10..20;

/// One clip with its truth.
pub struct Trial {
    /// Name of the clip.
    pub name: String,
    /// Tracks of the feet.
    pub feet: Feet,
    /// Truth of each part, left foot first.
    truth: Vec<(Part, [Truth; 2])>,
}

impl Trial {
    /// Creates a trial from a clip and the truth of some parts, left foot first.
    pub fn new(name: String, clip: &Clip, truth: Vec<(Part, [Truth; 2])>) -> Trial {
        let skeleton = Skeleton::main(clip, &Overrides::default());
        let feet = Feet::new(clip, &skeleton).expect("a clip with feet in motion");
        Trial { name, feet, truth }
    }

    /// Creates a trial from a generated clip.
    pub fn generated(name: impl Into<String>, generated: &Generated) -> Trial {
        let truth = |part: Part| {
            let known = |labels: Vec<bool>| labels.into_iter().map(Some).collect();
            let side = |side| known(generated.truth.labels(side, part).expect("truth of every part"));
            (part, Side::BOTH.map(side))
        };
        Trial::new(name.into(), &generated.clip, Part::ALL.map(truth).into())
    }

    /// Reads a recorded clip, with measured contact in a JSON file of the same name.
    pub fn recorded(path: &Path) -> anyhow::Result<Trial> {
        let clip = bvh::parse(&std::fs::read(path)?, bvh::Options::default())?.clip;
        let bytes = std::fs::read(path.with_extension("json"))?;
        let truth = formats::read_plants(&bytes, clip.frame_count())?;
        let masked = truth.parts.into_iter().map(|(part, feet)| {
            (part, feet.map(|labels| score::mask_near_unknown(&labels, clip.frame_time())))
        });
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        Ok(Trial::new(name.into_owned(), &clip, masked.collect()))
    }

    /// Time between frames, in seconds.
    pub fn frame_time(&self) -> f64 {
        self.feet.frame_time
    }

    /// Truth of one part, left foot first.
    pub fn truth(&self, part: Part) -> &[Truth; 2] {
        let truth = self.truth.iter().find(|(other, _)| *other == part);
        truth.map(|(_, truth)| truth).expect("truth of that part")
    }

    /// Detects plants.
    pub fn detect(&self, params: Params) -> Detection {
        plants::detect(&self.feet, params.check().expect("valid parameters"))
    }

    /// Returns the lenient tally of labels of both feet.
    pub fn tally(&self, part: Part, labels: [&[bool]; 2], fuzzy: f64) -> Tally {
        let mut tally = Tally::default();
        for (labels, truth) in labels.into_iter().zip(self.truth(part)) {
            tally += score::lenient(labels, truth, self.frame_time(), fuzzy);
        }
        tally
    }

    /// Returns the strict tally of labels of both feet.
    pub fn strict(&self, part: Part, labels: [&[bool]; 2], fuzzy: f64) -> Tally {
        let mut tally = Tally::default();
        for (labels, truth) in labels.into_iter().zip(self.truth(part)) {
            tally += score::strict(labels, truth, self.frame_time(), fuzzy);
        }
        tally
    }

    /// Compares the plants of both feet with the truth as events.
    pub fn events(&self, part: Part, labels: [&[bool]; 2]) -> Events {
        let mut events = Events::default();
        for (labels, truth) in labels.into_iter().zip(self.truth(part)) {
            events += score::events(labels, truth, self.frame_time());
        }
        events
    }
}

/// Returns the labels of one part, left foot first.
pub fn labels(detection: &Detection, part: Part) -> [&[bool]; 2] {
    let labels = detection.part(part).expect("the method labels that part");
    Side::BOTH.map(|side| labels.foot(side).planted.as_slice())
}

/// Returns the default parameters of a method.
pub fn default_params(method: Method) -> Params {
    Params { method, ..Params::default() }
}

/// Generates the trials of all specifications for all seeds.
pub fn generate_trials(specs: &[ClipSpec], seeds: impl IntoIterator<Item = u64>) -> Vec<Trial> {
    let jobs: Vec<(&ClipSpec, u64)> =
        seeds.into_iter().flat_map(|seed| specs.iter().map(move |spec| (spec, seed))).collect();
    let trial = |(spec, seed): &(&ClipSpec, u64)| Trial::generated(spec.name.clone(), &generate(spec, *seed));
    jobs.par_iter().map(trial).collect()
}

/// Accuracies of several clips.
#[derive(Clone, Debug, Default)]
pub struct Accuracies {
    pooled: Tally,
    per_clip: Vec<f64>,
}

impl Accuracies {
    /// Collects the tallies of clips.
    pub fn from_tallies(tallies: impl IntoIterator<Item = Tally>) -> Accuracies {
        let mut accuracies = Accuracies::default();
        for tally in tallies {
            accuracies.pooled += tally;
            accuracies.per_clip.push(100.0 * tally.accuracy());
        }
        accuracies
    }

    /// Accuracy pooled over frames, in percent.
    pub fn pooled(&self) -> f64 {
        100.0 * self.pooled.accuracy()
    }

    /// Accuracy of the worst clip, in percent.
    pub fn lowest(&self) -> f64 {
        self.per_clip.iter().copied().fold(100.0, f64::min)
    }

    /// Accuracy of the best clip, in percent.
    pub fn highest(&self) -> f64 {
        self.per_clip.iter().copied().fold(0.0, f64::max)
    }

    /// Sample standard deviation over clips (n − 1), as a fraction.
    pub fn standard_deviation(&self) -> f64 {
        let mean = self.per_clip.iter().sum::<f64>() / self.per_clip.len() as f64;
        let squares: f64 = self.per_clip.iter().map(|accuracy| (accuracy - mean).powi(2)).sum();
        (squares / (self.per_clip.len().max(2) - 1) as f64).sqrt() / 100.0
    }
}

/// Returns the accuracies of a method over trials, for each fuzzy period.
pub fn accuracies<const N: usize>(
    trials: &[Trial],
    params: Params,
    part: Part,
    fuzzy: [f64; N],
) -> [Accuracies; N] {
    let tallies = |trial: &Trial| {
        let detection = trial.detect(params);
        fuzzy.map(|fuzzy| trial.tally(part, labels(&detection, part), fuzzy))
    };
    let tallies: Vec<[Tally; N]> = trials.par_iter().map(tallies).collect();
    std::array::from_fn(|index| Accuracies::from_tallies(tallies.iter().map(|tallies| tallies[index])))
}
