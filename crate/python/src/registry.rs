//! Lists of methods, formats and roles, and default parameters.

use plantigrade::formats::{PlantFormat, SegmentFormat};
use plantigrade::skeleton::Role;
use plantigrade::{plants, segments};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Name, title, description and labelled parts of each detection method, the default first.
#[pyfunction]
pub fn detection_methods() -> Vec<(&'static str, &'static str, &'static str, Vec<&'static str>)> {
    let parts = |method: plants::Method| method.parts().iter().map(|part| part.name()).collect();
    plants::Method::ALL
        .iter()
        .map(|&method| (method.name(), method.title(), method.description(), parts(method)))
        .collect()
}

/// Name, title and description of each segmentation method, the default first.
#[pyfunction]
pub fn segmentation_methods() -> Vec<(&'static str, &'static str, &'static str)> {
    let methods = segments::Method::ALL.iter();
    methods.map(|method| (method.name(), method.title(), method.description())).collect()
}

/// Name, title, description and file extension of each format of plants, the default first.
#[pyfunction]
pub fn plant_formats() -> Vec<(&'static str, &'static str, &'static str, &'static str)> {
    let formats = PlantFormat::ALL.iter();
    formats.map(|format| (format.name(), format.title(), format.description(), format.extension())).collect()
}

/// Name, title, description and file extension of each format of segments, the default first.
#[pyfunction]
pub fn segment_formats() -> Vec<(&'static str, &'static str, &'static str, &'static str)> {
    let formats = SegmentFormat::ALL.iter();
    formats.map(|format| (format.name(), format.title(), format.description(), format.extension())).collect()
}

/// Names of all roles: trunk, arms, legs.
#[pyfunction]
pub fn role_names() -> Vec<&'static str> {
    Role::ALL.map(Role::name).to_vec()
}

/// Default parameters of the core, by operation.
#[pyfunction]
pub fn defaults(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let detect = PyDict::new(py);
    let params = plants::Params::default();
    detect.set_item("method", params.method.name())?;
    detect.set_item("r", params.tolerance)?;
    detect.set_item("w", params.window)?;
    detect.set_item("sigma", params.sigma)?;
    detect.set_item("height", params.height)?;
    detect.set_item("speed", params.speed)?;
    detect.set_item("exact", params.exact)?;
    let segment = PyDict::new(py);
    let params = segments::Params::default();
    segment.set_item("method", params.method.name())?;
    segment.set_item("dims", params.dims)?;
    segment.set_item("residual", params.residual.to_string())?;
    segment.set_item("template", params.template.to_string())?;
    segment.set_item("published", params.published)?;
    let defaults = PyDict::new(py);
    defaults.set_item("detect", detect)?;
    defaults.set_item("segment", segment)?;
    Ok(defaults)
}
