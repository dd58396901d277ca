//! Detection in a clip.

use crate::kinematics::Track;
use crate::notice::{Code, Notice};
use crate::plants::methods::{DetectionCache, Input, Output};
use crate::plants::postprocess::capture_noise::CaptureNoise;
use crate::plants::postprocess::{ground_height, plausibility};
use crate::plants::{Detection, Feet, Ground, ValidParams};

/// Detects the frames in which each foot is planted.
///
/// Accepts any frame rate, unit and up axis; the labels of spectral methods are invariant to them.
/// The time is proportional to the number of frames, except for some of the methods for comparison,
/// whose time is quadratic.
pub fn detect(feet: &Feet, params: ValidParams) -> Detection {
    run(feet, None, params, None)
}

/// Detects like [`detect`] and consumes the feet, which needs less memory for long clips.
pub fn detect_once(mut feet: Feet, params: ValidParams) -> Detection {
    let summary = FeetSummary::new(&feet);
    feet.hips = Track::new();
    run_with_summary(summary, &feet, None, params, None)
}

/// Detects like [`detect`], and clusters the samples together with those of a standing clip of the
/// same character, which helps if the entire clip has little movement (paper, section 3.5).
///
/// Methods that do not use the samples of the paper ignore the standing clip.
pub fn detect_with_standing(feet: &Feet, standing: &Feet, params: ValidParams) -> Detection {
    run(feet, Some(standing), params, None)
}

/// Detects with the given cache.
pub(crate) fn run(
    feet: &Feet,
    standing: Option<&Feet>,
    params: ValidParams,
    cache: Option<&mut DetectionCache>,
) -> Detection {
    run_with_summary(FeetSummary::new(feet), feet, standing, params, cache)
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

fn run_with_summary(
    summary: FeetSummary,
    feet: &Feet,
    standing: Option<&Feet>,
    params: ValidParams,
    cache: Option<&mut DetectionCache>,
) -> Detection {
    let mut input = Input { feet, standing, settings: params.settings(), cache };
    let Output { parts, mut notices } = params.method().detect(&mut input);
    notices.extend(summary.rate_notice.into_iter().chain(plausibility::airborne(&parts)));
    let ground_height = ground_height::height(&summary.lowest, &parts[0]);
    let noise = CaptureNoise::new(feet, &parts[0]);
    let ground = Ground::new(feet, parts[0].feet.each_ref().map(|foot| foot.planted.as_slice()));
    notices.extend(ground.belt.map(|belt| {
        let speed = belt.norm() * feet.metres_per_unit;
        let text = format!(
            "Planted feet move at {speed:.2} m/s while the hips stay; the clip is taken for one on a treadmill. \
             Slides and lengths are relative to its belt."
        );
        Notice::new(Code::Belt, text)
    }));
    Detection { params, ground_height, ground, noise, parts, notices, edits: Vec::new() }
}
