//! Parameters of segmentation and the rules they keep.

use std::fmt;
use std::str::FromStr;

use crate::segments::{Method, MethodOption};

/// What can be set; the defaults serve any clip.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Params {
    /// How the clip is cut; default [`Method::Auto`].
    pub method: Method,
    /// d: dimensions kept before the rest is called residual, for [`Method::Mvu`]
    /// (default 1) and [`Method::PcaTail`] (default 2).
    pub dims: Option<usize>,
    /// What of the eigenvalues is called residual, for [`Method::Mvu`].
    pub residual: Residual,
    /// The pose that others are compared with, for [`Method::Lsd`].
    pub template: Template,
    /// Keeps to the letter of what was published, where the default departs from it: see each method.
    pub published: bool,
}

/// What of the eigenvalues beyond the first d is called residual.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Residual {
    /// Their sum: it grows with what happens.
    #[default]
    Absolute,
    /// Their share of the sum of all, as published; nearly constant.
    Ratio,
}

/// The pose that others are compared with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Template {
    /// The mean of all poses, after each is turned to lie best on it.
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
    type Err = String;

    fn from_str(name: &str) -> Result<Residual, String> {
        match name {
            "absolute" => Ok(Residual::Absolute),
            "ratio" => Ok(Residual::Ratio),
            _ => Err(format!("the residual is absolute or ratio, not {name:?}")),
        }
    }
}

/// `mean`, `tpose` or the number of a frame.
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
    type Err = String;

    fn from_str(name: &str) -> Result<Template, String> {
        match name {
            "mean" => Ok(Template::Mean),
            "tpose" => Ok(Template::TPose),
            frame => frame
                .parse()
                .map(Template::Frame)
                .map_err(|_| format!("the template is mean, tpose or the number of a frame, not {name:?}")),
        }
    }
}

/// Parameters that keep their rules; made by [`Params::check`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ValidParams(Params);

/// A parameter that breaks its rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ParamError {
    /// [`Params::dims`]
    #[error("d must be from 1 to {most}, not {0}", most = Params::MOST_DIMS)]
    Dims(usize),
}

impl Params {
    /// The most dimensions that can be kept: those of the poses.
    pub const MOST_DIMS: usize = 56;

    /// Checks the rules.
    ///
    /// # Errors
    /// If a parameter breaks its rule.
    pub fn check(self) -> Result<ValidParams, ParamError> {
        match self.dims {
            Some(dims) if dims == 0 || dims > Params::MOST_DIMS => Err(ParamError::Dims(dims)),
            _ => Ok(ValidParams(self)),
        }
    }
}

impl ValidParams {
    /// See [`Params::method`].
    pub fn method(&self) -> Method {
        self.0.method
    }

    /// See [`Params::dims`]: as set, or the method's default; none where it does not matter.
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
