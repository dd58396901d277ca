//! Foot plants by spectral clustering, with nothing to tune.
//!
//! After Liu, Lu and Xie, *Foot plant detection based on spectral clustering
//! algorithm for motion capture data*, Journal of Image and Graphics 19(9),
//! 2014. Each frame of each foot is a sample of height and speed; samples that
//! lie close together have large degrees in the graph of their similarities,
//! and the frames on the ground are the ones that do: they are all alike.
//!
//! The way of the data: [`Feet`] (positions) → signals (height and speed) →
//! samples → scale → degree → threshold → labels. The degrees of many samples are
//! summed by expansion about cells of alike ones, and made exact where they decide.
//! [`Method::Paper`] is the published method; [`Method::Robust`] the one to use.

mod annotation;
mod detector;
mod edits;
mod feet;
pub(crate) mod methods;
mod params;
mod postprocess;
mod signal;
mod spectral;

pub use annotation::Annotation;
pub use detector::Detector;
pub use edits::{Edit, edited};
pub use feet::{DetectError, Feet, FootTracks};
pub use methods::{Family, Method};
pub use params::{Limits, ParamError, Params, ValidParams};
pub use spectral::affinity::Kernel;
pub use spectral::field::Field;
pub use spectral::threshold::Evidence;

use crate::foot::{Part, Side};
use crate::kinematics::Track;
use crate::notice::Notice;
use methods::{Found, Task};
use postprocess::{ground_height, plausibility};

/// The labels of a clip with how they came about.
#[derive(Clone, Debug, PartialEq)]
pub struct Detection {
    /// The parameters that were used.
    pub params: ValidParams,
    /// Contact, toe and heel; the paper's method labels toes only.
    pub parts: Vec<PartLabels>,
    /// Height of the ground along the up axis, in file units.
    pub floor: f64,
    /// What was assumed or is doubtful.
    pub notices: Vec<Notice>,
    /// What a person corrected in the labels; empty in what is detected.
    pub edits: Vec<Edit>,
}

/// The labels of one part of both feet.
#[derive(Clone, Debug, PartialEq)]
pub struct PartLabels {
    /// Contact, toe or heel.
    pub part: Part,
    /// The left foot's labels, then the right's.
    pub feet: [FootLabels; 2],
    /// How the clustering came about; `None` where there was nothing to cluster.
    pub evidence: Option<Evidence>,
}

/// The labels of one part of one foot, per frame of the clip.
#[derive(Clone, Debug, PartialEq)]
pub struct FootLabels {
    /// Whether the foot is planted.
    pub planted: Vec<bool>,
    /// Probability that the label is right, from 0.5 to 1.
    pub confidence: Vec<f32>,
    /// Height above the lowest that the clip comes, in file units.
    pub height: Vec<f32>,
    /// Speed in file units per second.
    pub speed: Vec<f32>,
}

impl Detection {
    /// The labels of one part, if the method gives them.
    pub fn part(&self, part: Part) -> Option<&PartLabels> {
        self.parts.iter().find(|labels| labels.part == part)
    }

    /// The labels that say best when a foot is down: contact, or else toe.
    pub fn principal(&self) -> &PartLabels {
        &self.parts[0]
    }
}

impl PartLabels {
    /// The labels of one foot.
    pub fn foot(&self, side: Side) -> &FootLabels {
        &self.feet[side as usize]
    }
}

/// Finds the frames in which each foot is planted.
///
/// Any frame rate, unit and up axis; the labels of spectral methods do not depend
/// on them. Takes time proportional to the number of frames, but for some of the methods
/// that stand beside, whose time grows with its square.
pub fn detect(feet: &Feet, params: ValidParams) -> Detection {
    run(Task { feet, still: None, params, kept: None })
}

/// As [`detect`], of feet that nobody needs afterwards: in long clips it takes a sixth less memory.
pub fn detect_once(mut feet: Feet, params: ValidParams) -> Detection {
    let whole = Whole::of(&feet);
    feet.hips = Track::new();
    for foot in &mut feet.tracks {
        foot.tip = None;
    }
    run_in(whole, Task { feet: &feet, still: None, params, kept: None })
}

/// As [`detect`], with the feet of the same character standing still clustered along,
/// which helps where a clip is all small movement (paper, section 3.5).
///
/// Methods that do not build on the published samples leave the standing clip aside.
pub fn detect_along(feet: &Feet, still: &Feet, params: ValidParams) -> Detection {
    run(Task { feet, still: Some(still), params, kept: None })
}

fn run(task: Task) -> Detection {
    run_in(Whole::of(task.feet), task)
}

/// What is asked of all tracks of the feet, where methods need but ankles and toes.
struct Whole {
    rate: Option<Notice>,
    lowest: [Vec<f64>; 2],
}

impl Whole {
    fn of(feet: &Feet) -> Whole {
        Whole { rate: plausibility::rate(feet), lowest: ground_height::lowest(feet) }
    }
}

fn run_in(whole: Whole, task: Task) -> Detection {
    let Found { parts, mut notices } = task.params.method().detect(&task);
    notices.extend(whole.rate.into_iter().chain(plausibility::airborne(&parts)));
    let floor = ground_height::height(&whole.lowest, &parts[0]);
    Detection { params: task.params, floor, parts, notices, edits: Vec::new() }
}

#[cfg(test)]
mod tests;
