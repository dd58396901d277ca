//! Clips with truth, and what comes of labelling them.

use std::path::Path;

use plantigrade::bvh::{self, Clip};
use plantigrade::labels::{self, Part, Side};
use plantigrade::plants::{self, Detection, Feet, Method, Params};
use plantigrade::score::{self, Events, Tally, Truth};
use plantigrade::skeleton::{Overrides, Skeleton};
use plantigrade_synth::{Generated, Recipe, generate};

use crate::parallel;

/// Seeds that are reported on.
pub const SEEDS: std::ops::Range<u64> = 10..20;

/// One clip with its truth.
pub struct Trial {
    pub name: String,
    pub feet: Feet,
    /// Truth of each part: the left foot's, then the right's.
    truth: Vec<(Part, [Truth; 2])>,
}

impl Trial {
    fn new(name: String, clip: &Clip, truth: Vec<(Part, [Truth; 2])>) -> Trial {
        let skeleton = Skeleton::main(clip, &Overrides::default());
        let feet = Feet::of(clip, &skeleton).expect("a clip with feet in motion");
        Trial { name, feet, truth }
    }

    /// A generated clip.
    pub fn generated(name: impl Into<String>, generated: &Generated) -> Trial {
        let truth = |part: Part| {
            let known = |labels: Vec<bool>| labels.into_iter().map(Some).collect();
            let side = |side| known(generated.truth.labels(side, part).expect("truth of every part"));
            (part, Side::BOTH.map(side))
        };
        Trial::new(name.into(), &generated.clip, Part::ALL.map(truth).into())
    }

    /// A recorded clip with measured contact beside it.
    pub fn recorded(path: &Path) -> anyhow::Result<Trial> {
        let clip = bvh::parse(&std::fs::read(path)?, bvh::Options::default())?.clip;
        let text = std::fs::read_to_string(path.with_extension("json"))?;
        let truth = labels::read(&text, clip.frame_count())?;
        let masked = truth.parts.into_iter().map(|(part, feet)| {
            (part, feet.map(|labels| score::mask_near_unknown(&labels, clip.frame_time())))
        });
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        Ok(Trial::new(name.into_owned(), &clip, masked.collect()))
    }

    pub fn frame_time(&self) -> f64 {
        self.feet.frame_time
    }

    /// Truth of one part.
    pub fn truth(&self, part: Part) -> &[Truth; 2] {
        let found = self.truth.iter().find(|(other, _)| *other == part);
        found.map(|(_, truth)| truth).expect("truth of that part")
    }

    pub fn detect(&self, params: Params) -> Detection {
        plants::detect(&self.feet, params.check().expect("parameters within their rules"))
    }

    /// Lenient accuracy of labels of both feet.
    pub fn tally(&self, part: Part, labels: [&[bool]; 2], fuzzy: f64) -> Tally {
        let mut tally = Tally::default();
        for (labels, truth) in labels.into_iter().zip(self.truth(part)) {
            tally += score::lenient(labels, truth, self.frame_time(), fuzzy);
        }
        tally
    }

    /// Strict accuracy of labels of both feet.
    pub fn strict(&self, part: Part, labels: [&[bool]; 2], fuzzy: f64) -> Tally {
        let mut tally = Tally::default();
        for (labels, truth) in labels.into_iter().zip(self.truth(part)) {
            tally += score::strict(labels, truth, self.frame_time(), fuzzy);
        }
        tally
    }

    /// Plants of both feet as events.
    pub fn events(&self, part: Part, labels: [&[bool]; 2]) -> Events {
        let mut events = Events::default();
        for (labels, truth) in labels.into_iter().zip(self.truth(part)) {
            events += score::events(labels, truth, self.frame_time());
        }
        events
    }
}

/// The labels of one part of both feet.
pub fn labels(detection: &Detection, part: Part) -> [&[bool]; 2] {
    let labels = detection.part(part).expect("the method labels that part");
    Side::BOTH.map(|side| labels.foot(side).planted.as_slice())
}

/// Default parameters of a method.
pub fn of(method: Method) -> Params {
    Params { method, ..Params::default() }
}

/// The trials of some recipes for some seeds.
pub fn trials(recipes: &[Recipe], seeds: impl IntoIterator<Item = u64>) -> Vec<Trial> {
    let jobs: Vec<(&Recipe, u64)> =
        seeds.into_iter().flat_map(|seed| recipes.iter().map(move |recipe| (recipe, seed))).collect();
    parallel::map(&jobs, |(recipe, seed)| Trial::generated(recipe.name.to_string(), &generate(recipe, *seed)))
}

/// Accuracies of many clips.
#[derive(Clone, Debug, Default)]
pub struct Accuracies {
    pooled: Tally,
    each: Vec<f64>,
}

impl Accuracies {
    pub fn of(tallies: impl IntoIterator<Item = Tally>) -> Accuracies {
        let mut all = Accuracies::default();
        for tally in tallies {
            all.pooled += tally;
            all.each.push(100.0 * tally.accuracy());
        }
        all
    }

    /// In percent, pooled over frames.
    pub fn pooled(&self) -> f64 {
        100.0 * self.pooled.accuracy()
    }

    /// In percent, of the worst clip.
    pub fn lowest(&self) -> f64 {
        self.each.iter().copied().fold(100.0, f64::min)
    }

    /// In percent, of the best clip.
    pub fn highest(&self) -> f64 {
        self.each.iter().copied().fold(0.0, f64::max)
    }

    /// Standard deviation over clips (n − 1), as a share.
    pub fn deviation(&self) -> f64 {
        let mean = self.each.iter().sum::<f64>() / self.each.len() as f64;
        let squares: f64 = self.each.iter().map(|each| (each - mean).powi(2)).sum();
        (squares / (self.each.len().max(2) - 1) as f64).sqrt() / 100.0
    }
}

/// Accuracies of a method over trials, for each fuzzy period.
pub fn accuracies<const N: usize>(
    trials: &[Trial],
    params: Params,
    part: Part,
    fuzzy: [f64; N],
) -> [Accuracies; N] {
    let tallies = parallel::map(trials, |trial| {
        let detection = trial.detect(params);
        fuzzy.map(|fuzzy| trial.tally(part, labels(&detection, part), fuzzy))
    });
    std::array::from_fn(|place| Accuracies::of(tallies.iter().map(|tallies| tallies[place])))
}
