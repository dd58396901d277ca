//! Parameters with named values.

use std::fmt;
use std::str::FromStr;

/// Definition of the residual: a function of the eigenvalues beyond the first d.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Residual {
    /// Sum of these eigenvalues, which increases with the variation of the motion.
    #[default]
    Absolute,
    /// Fraction of the sum of all eigenvalues, as published; almost constant.
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
    /// The value is not a [`Residual`].
    #[error("the residual must be absolute or ratio, not {0:?}")]
    Residual(String),
    /// The value is not a [`Template`].
    #[error("the template must be mean, tpose or a frame number, not {0:?}")]
    Template(String),
}
