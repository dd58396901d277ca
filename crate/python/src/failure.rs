//! Failures of the core as Python exceptions.

use std::fmt::Display;

use plantigrade::bvh::Error;
use plantigrade::formats::ReadError;
use plantigrade::plants::{self, DetectError};
use plantigrade::points::PointsError;
use plantigrade::registry::UnknownName;
use plantigrade::segments::{self, OptionError, SegmentError};
use plantigrade::skate::SkateError;
use plantigrade::skeleton::UpError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Failure that becomes the exception `plantigrade.PlantigradeError`.
#[derive(Debug)]
pub struct Failure(Box<Details>);

/// Arguments of the exception.
#[derive(Debug, Default)]
struct Details {
    message: String,
    file: Option<String>,
    line: Option<usize>,
    column: Option<usize>,
    hint: Option<String>,
    excerpt: Option<String>,
    caret: Option<usize>,
}

impl Failure {
    /// Creates a failure with advice.
    pub fn new(message: impl Into<String>, hint: &str) -> Failure {
        let hint = (!hint.is_empty()).then(|| hint.into());
        Failure(Box::new(Details { message: message.into(), hint, ..Details::default() }))
    }

    /// Adds the name of the file.
    pub fn in_file(mut self, name: &str) -> Failure {
        self.0.file = (!name.is_empty()).then(|| name.into());
        self
    }

    /// Returns the exception.
    fn exception(&self, py: Python<'_>) -> PyResult<PyErr> {
        let Details { message, file, line, column, hint, excerpt, caret } = &*self.0;
        let class = py.import("plantigrade._errors")?.getattr("PlantigradeError")?;
        let details = PyDict::new(py);
        details.set_item("file", file)?;
        details.set_item("line", line)?;
        details.set_item("column", column)?;
        details.set_item("hint", hint)?;
        details.set_item("excerpt", excerpt)?;
        details.set_item("caret", caret)?;
        Ok(PyErr::from_value(class.call((message,), Some(&details))?))
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> PyErr {
        Python::attach(|py| failure.exception(py).unwrap_or_else(|error| error))
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Failure {
        Failure(Box::new(Details {
            message: error.kind.to_string(),
            file: None,
            line: error.location.map(|location| location.line),
            column: error.location.map(|location| location.column),
            hint: Some(error.kind.hint().into()),
            caret: error.excerpt.as_ref().map(|excerpt| excerpt.caret),
            excerpt: error.excerpt.map(|excerpt| excerpt.text),
        }))
    }
}

impl From<DetectError> for Failure {
    fn from(error: DetectError) -> Failure {
        let hint = match error {
            DetectError::NoMotion => "Read a clip that has frames.",
            DetectError::NoFeet => {
                "Both feet are required: pass roles={'left_ankle': …, 'right_ankle': …} with a joint name or index \
                 for each, names=… that say which joint is which, or a preset of plantigrade.presets."
            }
        };
        Failure::new(error.to_string(), hint)
    }
}

impl From<PointsError> for Failure {
    fn from(error: PointsError) -> Failure {
        let hint = match error {
            PointsError::NoPoints | PointsError::NoFrames | PointsError::Length { .. } => {
                "Positions have the shape (frames, joints, 3)."
            }
            PointsError::ParentCount { .. } | PointsError::Parent { .. } | PointsError::Cycle(_) => {
                "parents has the index of the parent of each joint, and -1 for a root."
            }
            PointsError::RolePoint { .. } => "Roles are indices of joints on the second axis, from 0.",
            PointsError::NotFinite { .. } => {
                "Fill gaps before the detection, for example by interpolation over time, or cut off the frames \
                 without data."
            }
            PointsError::TooLarge { .. } => "Correct the value, or fill it like a gap.",
            PointsError::Rate(_) => "Pass fps, the number of frames per second.",
            PointsError::Unit(_) => {
                "Pass unit, the length of one unit in metres: 1 for metres, 0.001 for millimetres."
            }
        };
        Failure::new(error.to_string(), hint)
    }
}

/// Implements conversions from errors whose text is the whole message.
macro_rules! impl_from_display {
    ($($error:ty),+) => {$(
        impl From<$error> for Failure {
            fn from(error: $error) -> Failure {
                Failure::new(error.to_string(), "")
            }
        }
    )+};
}

impl_from_display!(
    plants::ParamError,
    segments::ParamError,
    SegmentError,
    SkateError,
    ReadError,
    UnknownName,
    OptionError,
    UpError
);

/// Returns a failure whose message is that of another type.
pub fn display(error: impl Display) -> Failure {
    Failure::new(error.to_string(), "")
}
