//! Arguments of Python as parameters of the core.

use plantigrade::foot::{Part, Side};
use plantigrade::notice::Notice;
use plantigrade::plants::{self, Annotation, Edit};
use plantigrade::registry::UnknownName;
use plantigrade::segments;
use plantigrade::skeleton::{Role, Up};
use pyo3::prelude::*;

use crate::failure::Failure;

/// Parameters of a detection: method, r, w, sigma, height, speed, exact.
#[derive(FromPyObject)]
pub struct DetectParams(String, f64, usize, Option<f64>, f64, f64, bool);

impl DetectParams {
    /// Checks the parameters.
    pub fn check(self) -> Result<plants::ValidParams, Failure> {
        let DetectParams(method, tolerance, window, sigma, height, speed, exact) = self;
        let method = method.parse()?;
        Ok(plants::Params { method, tolerance, window, sigma, height, speed, exact }.check()?)
    }
}

/// Parameters of a segmentation: method, dims, residual, template, published.
#[derive(FromPyObject)]
pub struct SegmentParams(String, Option<usize>, String, String, bool);

impl SegmentParams {
    /// Checks the parameters.
    pub fn check(self) -> Result<segments::ValidParams, Failure> {
        let SegmentParams(method, dims, residual, template, published) = self;
        let (residual, template) = (residual.parse()?, template.parse()?);
        Ok(segments::Params { method: method.parse()?, dims, residual, template, published }.check()?)
    }
}

/// Parses an up axis.
pub fn up(text: Option<&str>) -> Result<Option<Up>, Failure> {
    Ok(text.map(str::parse).transpose()?)
}

/// Parses the name of a role.
pub fn role(name: &str) -> Result<Role, Failure> {
    let known = || Role::ALL.map(Role::name).to_vec();
    let unknown = || UnknownName { kind: "role", name: name.into(), known: known() };
    Ok(Role::from_name(name).ok_or_else(unknown)?)
}

/// Parses the name of a side.
pub fn side(name: &str) -> Result<Side, Failure> {
    let unknown = || UnknownName { kind: "side", name: name.into(), known: vec!["left", "right"] };
    Ok(Side::BOTH.into_iter().find(|side| side.name() == name).ok_or_else(unknown)?)
}

/// Parses the name of a part.
pub fn part(name: &str) -> Result<Part, Failure> {
    let unknown =
        || UnknownName { kind: "part", name: name.into(), known: Part::ALL.map(Part::name).to_vec() };
    Ok(Part::ALL.into_iter().find(|part| part.name() == name).ok_or_else(unknown)?)
}

/// Labels of one part: its name, and 1, 0 or −1 for unknown in each frame of the left foot and of the
/// right foot.
pub type PartLabels = (String, Vec<i8>, Vec<i8>);

/// Returns labels as an annotation of a clip with `frames` frames.
pub fn annotation(labels: Vec<PartLabels>, frames: usize) -> Result<Annotation, Failure> {
    let known = |labels: Vec<i8>| -> Vec<Option<bool>> {
        labels.into_iter().map(|label| (label >= 0).then_some(label > 0)).collect()
    };
    let mut parts = Vec::new();
    for (name, left, right) in labels {
        if let Some(found) = [&left, &right].map(Vec::len).into_iter().find(|&length| length != frames) {
            let message = format!("the labels of {name} have {found} frames, but the clip has {frames}");
            return Err(Failure::new(
                message,
                "Pass labels of the shape (frames, 2): left foot, right foot.",
            ));
        }
        parts.push((part(&name)?, [known(left), known(right)]));
    }
    Ok(Annotation { parts })
}

/// An edit from Python: side, part, first frame, end, planted.
pub type EditArgument = (String, String, usize, usize, bool);

/// An edit for Python.
pub type EditTuple = (&'static str, &'static str, usize, usize, bool);

/// Parses edits.
pub fn edits(edits: Vec<EditArgument>) -> Result<Vec<Edit>, Failure> {
    let parse = |(side_name, part_name, start, end, planted): EditArgument| {
        Ok(Edit { side: side(&side_name)?, part: part(&part_name)?, start, end, planted })
    };
    edits.into_iter().map(parse).collect()
}

/// Returns an edit for Python.
pub fn edit_tuple(edit: &Edit) -> EditTuple {
    (edit.side.name(), edit.part.name(), edit.start, edit.end, edit.planted)
}

/// A notice: code, text, line and column.
pub type NoticeTuple = (String, String, Option<usize>, Option<usize>);

/// Returns notices for Python.
pub fn notices<'a>(notices: impl IntoIterator<Item = &'a Notice>) -> Vec<NoticeTuple> {
    let tuple = |notice: &Notice| {
        let location = notice.location;
        (notice.code.name(), notice.text.clone(), location.map(|at| at.line), location.map(|at| at.column))
    };
    notices.into_iter().map(tuple).collect()
}
