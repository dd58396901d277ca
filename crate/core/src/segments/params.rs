//! Parameters of segmentation and their rules.

use std::fmt;
use std::str::FromStr;

use crate::segments::{Method, MethodOption};

/// Parameters of segmentation; the defaults suit any clip.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Params {
    /// Segmentation method; default [`Method::Auto`].
    pub method: Method,
    /// d: number of dimensions before the rest is residual, for [`Method::Mvu`] (default 1) and
    /// [`Method::PcaTail`] (default 2).
    pub dims: Option<usize>,
    /// Definition of the residual, for [`Method::Mvu`].
    pub residual: Residual,
    /// Template pose, for [`Method::Lsd`].
    pub template: Template,
    /// If true, the method follows its publication exactly where the default differs; see each
    /// method.
    pub published: bool,
}

/// Definition of the residual: a function of the eigenvalues beyond the first d.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Residual {
    /// Their sum, which increases with the variation of the motion.
    #[default]
    Absolute,
    /// Their fraction of the sum of all eigenvalues, as published; nearly constant.
    Ratio,
}

/// Template pose with which all poses are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Template {
    /// The mean of all poses after alignment.
    #[default]
    Mean,
    /// The skeleton with all rotations zero.
    TPose,
    /// A frame of the clip, from 0.
    Frame(usize),
}

impl fmt::Display for Residual {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Residual::Absolute => "absolute",
            Residual::Ratio => "ratio",
        })
    }
}

impl FromStr for Residual {
    type Err = OptionError;

    fn from_str(name: &str) -> Result<Residual, OptionError> {
        match name {
            "absolute" => Ok(Residual::Absolute),
            "ratio" => Ok(Residual::Ratio),
            _ => Err(OptionError::Residual(name.into())),
        }
    }
}

/// Formats as `mean`, `tpose` or the frame number.
impl fmt::Display for Template {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Template::Mean => f.write_str("mean"),
            Template::TPose => f.write_str("tpose"),
            Template::Frame(frame) => frame.fmt(f),
        }
    }
}

impl FromStr for Template {
    type Err = OptionError;

    fn from_str(name: &str) -> Result<Template, OptionError> {
        match name {
            "mean" => Ok(Template::Mean),
            "tpose" => Ok(Template::TPose),
            frame => frame.parse().map(Template::Frame).map_err(|_| OptionError::Template(name.into())),
        }
    }
}

/// Value of an option that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OptionError {
    /// Not a [`Residual`].
    #[error("the residual must be absolute or ratio, not {0:?}")]
    Residual(String),
    /// Not a [`Template`].
    #[error("the template must be mean, tpose or a frame number, not {0:?}")]
    Template(String),
}

/// Parameters that satisfy their rules; see [`Params::check`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ValidParams(Params);

/// A parameter that violates its rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ParamError {
    /// [`Params::dims`]
    #[error("d must be from 1 to {max}, not {0}", max = Params::MAX_DIMS)]
    Dims(usize),
}

impl Params {
    /// Maximum number of dimensions: that of a pose.
    pub const MAX_DIMS: usize = 56;

    /// Checks the rules.
    ///
    /// # Errors
    /// If a parameter violates its rule.
    pub fn check(self) -> Result<ValidParams, ParamError> {
        match self.dims {
            Some(dims) if dims == 0 || dims > Params::MAX_DIMS => Err(ParamError::Dims(dims)),
            _ => Ok(ValidParams(self)),
        }
    }
}

impl ValidParams {
    /// See [`Params::method`].
    pub fn method(&self) -> Method {
        self.0.method
    }

    /// See [`Params::dims`]: the given value or the default of the method; `None` if the method
    /// does not use it.
    pub fn dims(&self) -> Option<usize> {
        let default = self.method().options().iter().find_map(|option| match option {
            MethodOption::Dims(default) => Some(*default),
            _ => None,
        })?;
        Some(self.0.dims.unwrap_or(default))
    }

    /// See [`Params::residual`].
    pub fn residual(&self) -> Residual {
        self.0.residual
    }

    /// See [`Params::template`].
    pub fn template(&self) -> Template {
        self.0.template
    }

    /// See [`Params::published`].
    pub fn published(&self) -> bool {
        self.0.published
    }
}
