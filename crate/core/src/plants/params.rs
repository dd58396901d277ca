//! Parameters of detection and their rules.

use crate::plants::methods::{Method, Settings, Thresholds};
use crate::plants::spectral::degree::Summation;

/// Parameters of detection; the defaults suit any clip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Detection method; default [`Method::Robust`].
    pub method: Method,
    /// r: upper bound of the running variance of the sorted norms before the knee (paper, section
    /// 2.2). A larger value gives longer plants. Default 0.001.
    pub tolerance: f64,
    /// w: number of frames on either side that a sample includes (paper, section 2.1). Default 1.
    pub window: usize,
    /// σ: bandwidth of the kernel, if not determined by the knee; default none.
    pub sigma: Option<f64>,
    /// Height threshold for planted toes, in metres. Default 0.05.
    pub height: f64,
    /// Speed threshold for planted toes, in metres per second. Default 0.5.
    pub speed: f64,
    /// If true, the degrees of long clips are summed over all pairs, in quadratic time. If false,
    /// they are approximated by cells of similar frames and computed exactly near the threshold;
    /// fewer than one label in 10,000 differs, near samples within a thousandth of the threshold.
    /// Default false.
    pub exact: bool,
}

impl Default for Params {
    fn default() -> Params {
        Params {
            method: Method::Robust,
            tolerance: 0.001,
            window: 1,
            sigma: None,
            height: 0.05,
            speed: 0.5,
            exact: false,
        }
    }
}

/// Parameters that satisfy their rules; see [`Params::check`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ValidParams(Params);

/// A parameter that violates its rule.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ParamError {
    /// [`Params::tolerance`]
    #[error("r must be greater than 0 and finite, not {0}")]
    Tolerance(f64),
    /// [`Params::window`]
    #[error("w must be at most {max}, not {0}", max = Params::MAX_WINDOW)]
    Window(usize),
    /// [`Params::height`]
    #[error("the height must be greater than 0 and finite, not {0}")]
    Height(f64),
    /// [`Params::speed`]
    #[error("the speed must be greater than 0 and finite, not {0}")]
    Speed(f64),
    /// [`Params::sigma`]
    #[error("sigma must be greater than 0 and finite, not {0}")]
    Sigma(f64),
}

impl Params {
    /// Maximum window half-width.
    pub const MAX_WINDOW: usize = 16;

    /// Checks the rules.
    ///
    /// # Errors
    /// If a parameter violates its rule.
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
        if self.window > Params::MAX_WINDOW {
            return Err(ParamError::Window(self.window));
        }
        match self.sigma {
            Some(sigma) if !positive(sigma) => Err(ParamError::Sigma(sigma)),
            _ => Ok(ValidParams(self)),
        }
    }
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

    /// Returns the thresholds that the method compares with.
    pub fn thresholds(&self) -> Thresholds {
        self.0.method.thresholds(self.0.height, self.0.speed)
    }

    /// Returns the parameters as the method receives them.
    pub(crate) fn settings(&self) -> Settings {
        Settings {
            tolerance: self.0.tolerance,
            window: self.0.window,
            sigma: self.0.sigma,
            height: self.0.height,
            speed: self.0.speed,
            summation: if self.0.exact { Summation::AllPairs } else { Summation::Cells },
        }
    }

    /// See [`Params::sigma`].
    pub fn sigma(&self) -> Option<f64> {
        self.0.sigma
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn violated_rules_are_stated() {
        let message = |params: Params| params.check().map_err(|error| error.to_string()).unwrap_err();
        let default = Params::default();
        assert_eq!(default.check(), Ok(ValidParams::default()));
        assert_eq!(
            message(Params { tolerance: 0.0, ..default }),
            "r must be greater than 0 and finite, not 0"
        );
        assert_eq!(message(Params { window: 17, ..default }), "w must be at most 16, not 17");
        assert!(message(Params { sigma: Some(f64::NAN), ..default }).starts_with("sigma must be"));
        let thresholds = Params { method: Method::Dual, ..default }.check().unwrap().thresholds();
        assert_eq!(thresholds, Thresholds { height: Some(0.05), speed: Some(0.5) });
        assert_eq!(ValidParams::default().thresholds(), Thresholds::default());
        assert!("best".parse::<Method>().is_err());
    }
}
