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
mod apply_edits;
mod corrections;
mod detect;
mod detection;
mod detector;
mod edit;
mod feet;
mod ground;
mod labels;
mod methods;
mod params;
mod postprocess;
mod signal;
mod spectral;

pub use annotation::Annotation;
pub use apply_edits::apply_edits;
pub use corrections::{Corrected, Corrections};
pub use detect::{detect, detect_by_default, detect_with_standing};
pub use detection::Detection;
pub use detector::Detector;
pub use edit::Edit;
pub use feet::{DetectError, Feet, FootTracks};
pub use ground::Ground;
pub(crate) use ground::levels;
pub use labels::{Edge, FootLabels, Instant, PartLabels};
pub use methods::{Family, Method, Thresholds};
pub use params::{ParamError, Params, ValidParams};
pub use postprocess::capture_noise::CaptureNoise;
pub use spectral::affinity::Kernel;
pub use spectral::field::DegreeField;
pub use spectral::threshold::Evidence;

#[cfg(test)]
mod tests;
