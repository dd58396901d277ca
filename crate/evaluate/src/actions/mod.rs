//! Cutting into actions: every method, on generated and on recorded motion.

pub mod figures;
pub mod generated;
pub mod limits;
pub mod recorded;

use plantigrade::bvh::Clip;
use plantigrade::score::{self, CutTally, Tolerance, TrueCut};
use plantigrade::segments::{self, Method, Params, Residual, Segmentation};
use plantigrade::skeleton::{Overrides, Skeleton};

use crate::parallel;

/// Maximum variance unfolding with the published ten dimensions.
const TEN: Params =
    Params { dims: Some(10), published: true, residual: Residual::Ratio, ..by(Method::Mvu, true) };

/// A method with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    pub name: &'static str,
    pub params: Params,
}

/// All methods, and what stands in their publications where they depart from it.
pub fn ways() -> Vec<Way> {
    let own = Method::ALL.map(|method| Way { name: method.name(), params: by(method, false) });
    let way = |name, params| Way { name, params };
    let published = [
        way("lsd, as published", by(Method::Lsd, true)),
        way("mvu, as published", TEN),
        way("mvu, d = 10, published rule, absolute", Params { residual: Residual::Absolute, ..TEN }),
        way("mvu, d = 10, own rule, share", Params { published: false, ..TEN }),
        way("ppca, as published", by(Method::Ppca, true)),
    ];
    [own.to_vec(), published.to_vec()].concat()
}

/// A method as it is, or to the letter of its publication.
const fn by(method: Method, published: bool) -> Params {
    Params { method, dims: None, residual: Residual::Absolute, template: segments::Template::Mean, published }
}

/// A clip whose cuts are known.
#[derive(Clone, Debug)]
pub struct Case {
    pub clip: Clip,
    pub truth: Vec<TrueCut>,
}

impl Case {
    /// The cuts that a way finds.
    pub fn cuts(&self, way: Way) -> Vec<usize> {
        segmentation(&self.clip, way.params).cuts()
    }

    /// How many of the cuts that were found are right.
    pub fn tally(&self, found: &[usize], tolerance: Tolerance) -> CutTally {
        score::cuts(found, &self.truth, self.clip.frame_time(), tolerance)
    }
}

/// What comes of cutting a clip.
pub fn segmentation(clip: &Clip, params: Params) -> Segmentation {
    let skeleton = Skeleton::main(clip, &Overrides::default());
    let params = params.check().expect("parameters within their rules");
    segments::segment(clip, &skeleton, params, &mut |_| Ok(())).expect("a body in motion")
}

/// The cuts of each way in each of its cases.
pub fn all_cuts(jobs: &[(Way, &[Case])]) -> Vec<Vec<Vec<usize>>> {
    let flat: Vec<(Way, &Case)> =
        jobs.iter().flat_map(|(way, cases)| cases.iter().map(move |case| (*way, case))).collect();
    let mut found = parallel::map(&flat, |(way, case)| case.cuts(*way)).into_iter();
    jobs.iter().map(|(_, cases)| found.by_ref().take(cases.len()).collect()).collect()
}

/// Cuts of cases, pooled.
pub fn pooled(cases: &[Case], found: &[Vec<usize>], tolerance: Tolerance) -> CutTally {
    let mut tally = CutTally::default();
    cases.iter().zip(found).for_each(|(case, found)| tally += case.tally(found, tolerance));
    tally
}

/// Precision, recall and F1 in one cell.
fn three(tally: CutTally) -> String {
    format!("{:.2} / {:.2} / {:.2}", tally.precision(), tally.recall(), tally.f1())
}

/// A share with two decimals.
fn share(value: f64) -> String {
    format!("{value:.2}")
}
