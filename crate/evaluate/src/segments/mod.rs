//! Sections about segmentation into actions.

mod class_references;
pub mod classes;
pub mod failures;
pub mod generated;
pub mod recorded;
pub mod recorded_figures;
mod recorded_trials;

use plantigrade::bvh::Clip;
use plantigrade::score::{self, CutTally, Tolerance, TrueCut};
use plantigrade::segments::{self, Method, Params, Residual, Segmentation};
use plantigrade::skeleton::{Overrides, Skeleton};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

/// Maximum variance unfolding with the published parameters.
const MVU_PUBLISHED: Params =
    Params { dims: Some(10), published: true, residual: Residual::Ratio, ..params_of(Method::Mvu, true) };

/// A method with parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variant {
    /// Name in tables.
    pub name: &'static str,
    /// Method and parameters.
    pub params: Params,
}

/// Returns all methods with default parameters, followed by their published variants.
pub fn variants() -> Vec<Variant> {
    let default = |&method: &Method| Variant { name: method.name(), params: params_of(method, false) };
    let defaults: Vec<Variant> = Method::ALL.iter().map(default).collect();
    let variant = |name, params| Variant { name, params };
    let published = [
        variant("lsd, as published", params_of(Method::Lsd, true)),
        variant("mvu, as published", MVU_PUBLISHED),
        variant(
            "mvu, d = 10, published rule, absolute",
            Params { residual: Residual::Absolute, ..MVU_PUBLISHED },
        ),
        variant("mvu, d = 10, own rule, ratio", Params { published: false, ..MVU_PUBLISHED }),
        variant("ppca, as published", params_of(Method::Ppca, true)),
    ];
    defaults.into_iter().chain(published).collect()
}

/// Returns the default or the published parameters of a method.
const fn params_of(method: Method, published: bool) -> Params {
    Params { method, dims: None, residual: Residual::Absolute, template: segments::Template::Mean, published }
}

/// A clip with known cuts.
#[derive(Clone, Debug)]
pub struct Case {
    /// The clip.
    pub clip: Clip,
    /// The true cuts.
    pub truth: Vec<TrueCut>,
}

impl Case {
    /// Returns the cuts of a variant.
    pub fn cuts(&self, variant: Variant) -> Vec<usize> {
        segmentation(&self.clip, variant.params).cuts()
    }

    /// Compares cuts with the truth.
    pub fn tally(&self, cuts: &[usize], tolerance: Tolerance) -> CutTally {
        score::cuts(cuts, &self.truth, self.clip.frame_time(), tolerance)
    }
}

/// Segments a clip.
pub fn segmentation(clip: &Clip, params: Params) -> Segmentation {
    let skeleton = Skeleton::main(clip, &Overrides::default());
    let params = params.check().expect("valid parameters");
    segments::segment(clip, &skeleton, params, &mut |_| Ok(())).expect("a body in motion")
}

/// Returns the cuts of each variant in each of its cases.
pub fn all_cuts(jobs: &[(Variant, &[Case])]) -> Vec<Vec<Vec<usize>>> {
    let flat: Vec<(Variant, &Case)> =
        jobs.iter().flat_map(|(variant, cases)| cases.iter().map(move |case| (*variant, case))).collect();
    let cuts: Vec<Vec<usize>> = flat.par_iter().map(|(variant, case)| case.cuts(*variant)).collect();
    let mut cuts = cuts.into_iter();
    jobs.iter().map(|(_, cases)| cuts.by_ref().take(cases.len()).collect()).collect()
}

/// Compares the cuts of several cases with the truth, pooled.
pub fn pooled(cases: &[Case], cuts: &[Vec<usize>], tolerance: Tolerance) -> CutTally {
    let mut tally = CutTally::default();
    cases.iter().zip(cuts).for_each(|(case, cuts)| tally += case.tally(cuts, tolerance));
    tally
}

/// Formats precision, recall and F1 in one cell.
fn precision_recall_f1(tally: CutTally) -> String {
    format!("{:.2} / {:.2} / {:.2}", tally.precision(), tally.recall(), tally.f1())
}

/// Formats a fraction with two decimals.
fn two_decimals(value: f64) -> String {
    format!("{value:.2}")
}
