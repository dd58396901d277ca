//! Detection of foot plants by spectral clustering.
//!
//! After Liu, Lu and Xie, *Foot plant detection based on spectral clustering algorithm for motion
//! capture data*, Journal of Image and Graphics 19(9), 2014. Each frame of each foot is a sample of
//! height and speed. The affinity of two samples decreases with their distance, and the degree of a
//! sample is the sum of its affinities. Frames on the ground are similar to each other, so they have
//! large degrees; a threshold on the square root of the degree separates them from the others.
//!
//! Data flow: [`Feet`] (tracks) → `signal` (height, speed, samples) → `spectral` (bandwidth, degree,
//! threshold) → `postprocess` (short runs, dragging, confidence) → [`Detection`]. The degrees of many
//! samples are approximated by expansion about cells of similar samples and computed exactly near the
//! threshold. [`Method::Robust`] is the default, [`Method::Paper`] the published method.

mod annotation;
mod detection;
mod detector;
mod edits;
mod feet;
mod methods;
mod params;
mod postprocess;
mod signal;
mod spectral;

pub use annotation::Annotation;
pub use detection::{Detection, FootLabels, PartLabels};
pub use detector::Detector;
pub use edits::{Edit, apply_edits};
pub use feet::{DetectError, Feet, FootTracks};
pub use methods::{Family, Method};
pub use params::{ParamError, Params, Thresholds, ValidParams};
pub use spectral::affinity::Kernel;
pub use spectral::field::DegreeField;
pub use spectral::threshold::Evidence;

use crate::kinematics::Track;
use crate::notice::Notice;
use methods::{Input, Output};
use postprocess::{ground_height, plausibility};

/// Detects the frames in which each foot is planted.
///
/// Accepts any frame rate, unit and up axis; the labels of spectral methods are invariant to them.
/// The time is proportional to the number of frames, except for some of the methods for comparison,
/// whose time is quadratic.
pub fn detect(feet: &Feet, params: ValidParams) -> Detection {
    run(Input { feet, standing: None, params, cache: None })
}

/// Detects like [`detect`] and consumes the feet, which needs a sixth less memory for long clips.
pub fn detect_once(mut feet: Feet, params: ValidParams) -> Detection {
    let summary = FeetSummary::new(&feet);
    feet.hips = Track::new();
    for foot in &mut feet.tracks {
        foot.tip = None;
    }
    run_with_summary(summary, Input { feet: &feet, standing: None, params, cache: None })
}

/// Detects like [`detect`] and clusters the samples of a standing clip of the same character along,
/// which helps if the whole clip is small movement (paper, section 3.5).
///
/// Methods that do not use the samples of the paper ignore the standing clip.
pub fn detect_with_standing(feet: &Feet, standing: &Feet, params: ValidParams) -> Detection {
    run(Input { feet, standing: Some(standing), params, cache: None })
}

fn run(input: Input) -> Detection {
    run_with_summary(FeetSummary::new(input.feet), input)
}

/// Results that need all tracks of the feet; the methods need ankles and toes only.
struct FeetSummary {
    rate_notice: Option<Notice>,
    lowest: [Vec<f64>; 2],
}

impl FeetSummary {
    fn new(feet: &Feet) -> FeetSummary {
        FeetSummary { rate_notice: plausibility::rate(feet), lowest: ground_height::lowest(feet) }
    }
}

fn run_with_summary(summary: FeetSummary, mut input: Input) -> Detection {
    let Output { parts, mut notices } = input.params.method().detect(&mut input);
    notices.extend(summary.rate_notice.into_iter().chain(plausibility::airborne(&parts)));
    let ground_height = ground_height::height(&summary.lowest, &parts[0]);
    Detection { params: input.params, ground_height, parts, notices, edits: Vec::new() }
}

#[cfg(test)]
mod tests;
