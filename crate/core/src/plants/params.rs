//! Parameters of detection and the rules they keep.

use crate::plants::spectral::degree::Pairs;
use crate::plants::{Method, methods};

/// What can be set; the defaults serve any clip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// How plants are found; default [`Method::Robust`].
    pub method: Method,
    /// r: how far the variance of the sorted norms may grow before the knee is
    /// reached (paper, section 2.2). Larger is more generous. Default 0.001.
    pub tolerance: f64,
    /// w: frames to either side that a sample takes in (paper, section 2.1). Default 1.
    pub window: usize,
    /// σ set by hand instead of found at the knee; default none.
    pub scale: Option<f64>,
    /// Height under which thresholds take a toe for planted, in metres. Default 0.05.
    pub height: f64,
    /// Speed under which thresholds take a toe for planted, in metres per second. Default 0.5.
    pub speed: f64,
    /// Whether the degrees of long clips are summed over all pairs, which takes time proportional to
    /// the square of the frames, instead of expanded about cells of alike frames and made exact only
    /// where they decide, which gives the same labels but for some within a thousandth of the
    /// threshold, fewer than one in 10,000. Default false.
    pub exact: bool,
}

impl Default for Params {
    fn default() -> Params {
        Params {
            method: Method::Robust,
            tolerance: 0.001,
            window: 1,
            scale: None,
            height: 0.05,
            speed: 0.5,
            exact: false,
        }
    }
}

/// Parameters that keep their rules; made by [`Params::check`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ValidParams(Params);

/// A parameter that breaks its rule.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ParamError {
    /// [`Params::tolerance`]
    #[error("r must be greater than 0 and finite, not {0}")]
    Tolerance(f64),
    /// [`Params::window`]
    #[error("w must be at most {most}, not {0}", most = Params::MOST_WINDOW)]
    Window(usize),
    /// [`Params::height`]
    #[error("the height must be greater than 0 and finite, not {0}")]
    Height(f64),
    /// [`Params::speed`]
    #[error("the speed must be greater than 0 and finite, not {0}")]
    Speed(f64),
    /// [`Params::scale`]
    #[error("sigma must be greater than 0 and finite, not {0}")]
    Scale(f64),
}

impl Params {
    /// The largest window half-width.
    pub const MOST_WINDOW: usize = 16;

    /// Checks the rules.
    ///
    /// # Errors
    /// If a parameter breaks its rule.
    pub fn check(self) -> Result<ValidParams, ParamError> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        if !positive(self.tolerance) {
            return Err(ParamError::Tolerance(self.tolerance));
        }
        if !positive(self.height) {
            return Err(ParamError::Height(self.height));
        }
        if !positive(self.speed) {
            return Err(ParamError::Speed(self.speed));
        }
        if self.window > Params::MOST_WINDOW {
            return Err(ParamError::Window(self.window));
        }
        match self.scale {
            Some(scale) if !positive(scale) => Err(ParamError::Scale(scale)),
            _ => Ok(ValidParams(self)),
        }
    }
}

/// What a method takes a foot for planted under, where it compares with such.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// In metres.
    pub height: Option<f64>,
    /// In metres per second.
    pub speed: Option<f64>,
}

impl ValidParams {
    /// See [`Params::method`].
    pub fn method(&self) -> Method {
        self.0.method
    }

    /// See [`Params::tolerance`].
    pub fn tolerance(&self) -> f64 {
        self.0.tolerance
    }

    /// See [`Params::window`].
    pub fn window(&self) -> usize {
        self.0.window
    }

    /// See [`Params::height`].
    pub fn height(&self) -> f64 {
        self.0.height
    }

    /// See [`Params::speed`].
    pub fn speed(&self) -> f64 {
        self.0.speed
    }

    /// See [`Params::exact`].
    pub fn exact(&self) -> bool {
        self.0.exact
    }

    /// The height and the speed that the method compares with.
    pub fn limits(&self) -> Limits {
        let Params { height, speed, .. } = self.0;
        match self.0.method {
            Method::Height => Limits { height: Some(height), speed: None },
            Method::Speed | Method::MinSpeed => Limits { height: None, speed: Some(speed) },
            Method::Dual => Limits { height: Some(height), speed: Some(speed) },
            Method::MedianSpeed => methods::MEDIAN_SPEED,
            Method::HeightSpeed => methods::HEIGHT_SPEED,
            _ => Limits::default(),
        }
    }

    pub(crate) fn pairs(&self) -> Pairs {
        if self.0.exact { Pairs::All } else { Pairs::Few }
    }

    /// See [`Params::scale`].
    pub fn scale(&self) -> Option<f64> {
        self.0.scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_stated_when_broken() {
        let message = |params: Params| params.check().map_err(|error| error.to_string()).unwrap_err();
        let default = Params::default();
        assert_eq!(default.check(), Ok(ValidParams::default()));
        assert_eq!(
            message(Params { tolerance: 0.0, ..default }),
            "r must be greater than 0 and finite, not 0"
        );
        assert_eq!(message(Params { window: 17, ..default }), "w must be at most 16, not 17");
        assert!(message(Params { scale: Some(f64::NAN), ..default }).starts_with("sigma must be"));
        let limits = Params { method: Method::Dual, ..default }.check().unwrap().limits();
        assert_eq!(limits, Limits { height: Some(0.05), speed: Some(0.5) });
        assert_eq!(ValidParams::default().limits(), Limits::default());
        assert!("best".parse::<Method>().is_err());
    }
}
