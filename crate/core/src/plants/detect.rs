//! Detection in a clip.

use crate::notice::{Code, Notice};
use crate::plants::methods::{DEFAULT_FUNCTION, DetectionCache, Input, Method, Output};
use crate::plants::postprocess::capture_noise::CaptureNoise;
use crate::plants::postprocess::{ground_height, plausibility};
use crate::plants::{Detection, Feet, Ground, ValidParams};

/// Detects the frames in which each foot is planted.
///
/// Accepts any frame rate, unit and up axis; the labels of spectral methods are invariant to them.
/// The time is proportional to the number of frames, except for some of the methods for comparison,
/// whose time is quadratic.
pub fn detect(feet: &Feet, params: ValidParams) -> Detection {
    run(params.method().function(), feet, None, params, None)
}

/// Detects like [`detect`] with the default method. A program that calls no other function that detects does not
/// contain the other methods.
///
/// # Panics
/// If the parameters name another method.
pub fn detect_by_default(feet: &Feet, params: ValidParams) -> Detection {
    run(default_function(params), feet, None, params, None)
}

/// Returns the function of the default method, which the parameters must name.
pub(crate) fn default_function(params: ValidParams) -> Function {
    assert!(params.method() == Method::default(), "the method must be the default");
    DEFAULT_FUNCTION
}

/// Detects like [`detect`], and clusters the samples together with those of a standing clip of the
/// same character, which helps if the entire clip has little movement (paper, section 3.5).
///
/// Methods that do not use the samples of the paper ignore the standing clip.
pub fn detect_with_standing(feet: &Feet, standing: &Feet, params: ValidParams) -> Detection {
    run(params.method().function(), feet, Some(standing), params, None)
}

/// Function of a method.
pub(crate) type Function = fn(&mut Input) -> Output;

/// Detects with the given function and cache.
pub(crate) fn run(
    function: Function,
    feet: &Feet,
    standing: Option<&Feet>,
    params: ValidParams,
    cache: Option<&mut DetectionCache>,
) -> Detection {
    let mut input = Input { feet, standing, settings: params.settings(), cache };
    let Output { parts, mut notices } = function(&mut input);
    notices.extend(plausibility::rate(feet).into_iter().chain(plausibility::airborne(&parts)));
    let ground_height = ground_height::height(feet, &parts[0]);
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
