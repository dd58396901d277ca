//! Parameters of segmentation and their rules.

use crate::segments::methods::{Method, MethodOption, Settings};
use crate::segments::{Residual, Template};

/// Parameters of segmentation; the defaults suit any clip.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Params {
    /// Segmentation method; default [`Method::Auto`].
    pub method: Method,
    /// d: number of dimensions excluded from the residual, for [`Method::Mvu`] (default 1) and
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
    /// Returns the parameters as the method receives them.
    pub(crate) fn settings(&self) -> Settings {
        let Params { residual, template, published, .. } = self.0;
        Settings { dims: self.dims().unwrap_or_default(), residual, template, published }
    }

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
