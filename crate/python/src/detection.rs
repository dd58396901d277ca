//! Detected plants.

use numpy::ndarray::Array2;
use numpy::{Element, IntoPyArray, PyArray2};
use plantigrade::foot::{Part, Side};
use plantigrade::formats::{self, GaitEvent, PlantExport, PlantFormat};
use plantigrade::gait::Gait;
use plantigrade::intervals::intervals;
use plantigrade::plants::{self, Annotation, Corrections, Detection, Edit, FootLabels, PartLabels};
use plantigrade::score;
use plantigrade::skate::{self, Contacts};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use serde_json::Value;

use crate::clip_data::ClipData;
use crate::failure::Failure;
use crate::params::{self, EditArgument, EditTuple, NoticeTuple};

/// The plants of a clip.
#[pyclass(frozen)]
pub struct RawDetection {
    data: ClipData,
    detection: Detection,
}

impl RawDetection {
    pub fn new(data: ClipData, detection: Detection) -> RawDetection {
        RawDetection { data, detection }
    }

    fn part(&self, name: &str) -> Result<&PartLabels, Failure> {
        let part = params::part(name)?;
        self.detection.part(part).ok_or_else(|| {
            let method = self.detection.params.method().name();
            let labelled: Vec<_> = self.detection.parts.iter().map(|labels| labels.part.name()).collect();
            Failure::new(
                format!("the method {method} does not label {name}"),
                &format!(
                    "It labels {}. The method robust labels contact, heel and toe.",
                    labelled.join(", ")
                ),
            )
        })
    }

    /// Returns a series of both feet as an array, frames × 2.
    fn array<'py, T: Element + Copy>(
        &self,
        py: Python<'py>,
        part: &str,
        series: fn(&FootLabels) -> &[T],
        map: impl Fn(T) -> T,
    ) -> PyResult<Bound<'py, PyArray2<T>>> {
        let [left, right] = &self.part(part)?.feet;
        let (left, right) = (series(left), series(right));
        let values = left.iter().zip(right).flat_map(|(&left, &right)| [map(left), map(right)]).collect();
        let array = Array2::from_shape_vec((left.len(), 2), values).map_err(crate::failure::display)?;
        Ok(array.into_pyarray(py))
    }

    fn metres(&self) -> impl Fn(f32) -> f32 {
        let metres_per_unit = self.data.skeleton.metres_per_unit;
        move |value| (f64::from(value) * metres_per_unit) as f32
    }
}

/// A plant: side, part, first frame, end, time and uncertainty of its beginning and of its end, in seconds.
type Interval = (&'static str, &'static str, usize, usize, Option<[f64; 2]>, Option<[f64; 2]>);

/// An event: time in seconds, first frame after it, side, kind, title, and uncertainty in seconds.
type EventTuple = (f64, usize, &'static str, &'static str, &'static str, Option<f64>);

/// A ground: height, normal, point, levels and velocity of the belt.
type GroundTuple = (f64, [f64; 3], [f64; 3], Vec<f64>, Option<[f64; 3]>);

/// Slide of a plant: side, first frame, end, distance in metres, frame of that distance.
type SlideTuple = (&'static str, usize, usize, f64, usize);

#[pymethods]
impl RawDetection {
    /// Names of the labelled parts, the principal part first.
    fn parts(&self) -> Vec<&'static str> {
        self.detection.parts.iter().map(|labels| labels.part.name()).collect()
    }

    /// Labels, frames × 2.
    fn planted<'py>(&self, py: Python<'py>, part: &str) -> PyResult<Bound<'py, PyArray2<bool>>> {
        self.array(py, part, |foot| &foot.planted, |planted| planted)
    }

    /// Probability that the label is right, frames × 2.
    fn confidence<'py>(&self, py: Python<'py>, part: &str) -> PyResult<Bound<'py, PyArray2<f32>>> {
        self.array(py, part, |foot| &foot.confidence, |confidence| confidence)
    }

    /// Height above the ground in metres, frames × 2.
    fn height<'py>(&self, py: Python<'py>, part: &str) -> PyResult<Bound<'py, PyArray2<f32>>> {
        self.array(py, part, |foot| &foot.height, self.metres())
    }

    /// Speed in metres per second, frames × 2.
    fn speed<'py>(&self, py: Python<'py>, part: &str) -> PyResult<Bound<'py, PyArray2<f32>>> {
        self.array(py, part, |foot| &foot.speed, self.metres())
    }

    /// Plants of all parts: those of contact first, left foot first.
    fn intervals(&self) -> Vec<Interval> {
        let mut plants = Vec::new();
        for part in [Part::Contact, Part::Heel, Part::Toe] {
            let Some(labels) = self.detection.part(part) else { continue };
            for side in Side::BOTH {
                let foot = labels.foot(side);
                let instant = |frame: usize| foot.edge(frame).map(|edge| [edge.time, edge.uncertainty]);
                plants.extend(intervals(&foot.planted).into_iter().map(|range| {
                    let (start, end) = (range.start, range.end);
                    (side.name(), part.name(), start, end, instant(start), instant(end))
                }));
            }
        }
        plants
    }

    /// Events in order of time; those of heel and toe, too, if `parts`.
    fn events(&self, parts: bool) -> Vec<EventTuple> {
        let frame_time = self.data.clip.frame_time();
        let events = if parts {
            formats::part_events(&self.detection, frame_time)
        } else {
            formats::events(&self.detection)
        };
        let tuple = |event: GaitEvent| {
            let uncertainty = event.instant.map(|instant| instant.uncertainty_ms / 1e3);
            let (kind, time) = (event.kind, event.time(frame_time));
            (time, event.frame, event.side.name(), kind.name(), kind.title(), uncertainty)
        };
        events.into_iter().map(tuple).collect()
    }

    /// Name of the method.
    fn method(&self) -> &'static str {
        self.detection.params.method().name()
    }

    /// Frame rate of the clip, in Hz.
    fn fps(&self) -> f64 {
        self.data.clip.rate()
    }

    /// Number of frames.
    fn frames(&self) -> usize {
        self.data.clip.frame_count()
    }

    /// Name of the file of the clip.
    fn name(&self) -> &str {
        &self.data.name
    }

    /// Ground, in metres and the axes of the clip.
    fn ground(&self) -> GroundTuple {
        let metres = self.data.skeleton.metres_per_unit;
        let ground = &self.detection.ground;
        (
            self.detection.ground_height * metres,
            ground.normal.into(),
            (ground.origin * metres).into(),
            ground.levels.iter().map(|level| level * metres).collect(),
            ground.belt.map(|belt| (belt * metres).into()),
        )
    }

    /// Noise of planted feet: standard deviation of position in metres, median speed in metres per second.
    fn noise(&self) -> Option<(f64, f64)> {
        let metres = self.data.skeleton.metres_per_unit;
        self.detection.noise.map(|noise| (noise.position * metres, noise.speed * metres))
    }

    /// Notices of the reader, the skeleton and the method.
    fn notices(&self) -> Vec<NoticeTuple> {
        let ClipData { notices, skeleton, .. } = &self.data;
        params::notices(notices.iter().chain(&skeleton.notices).chain(&self.detection.notices))
    }

    /// Returns the detection with edits. Later ones take precedence.
    fn edited(&self, py: Python<'_>, edits: Vec<EditArgument>) -> PyResult<RawDetection> {
        let edits = params::edits(edits)?;
        let edited = py.detach(|| plants::apply_edits(&self.detection, &edits, self.data.clip.frame_time()));
        Ok(RawDetection::new(self.data.clone(), edited))
    }

    /// Applies the corrections of a clip to similar motion. `example` is the detection of the clip that
    /// `edits` belong to, if it is another one, without edits, as this one is. Returns the detection, its
    /// changes, and the edits of this clip.
    fn corrected(
        &self,
        py: Python<'_>,
        example: Option<&RawDetection>,
        edits: Vec<EditArgument>,
    ) -> PyResult<(RawDetection, Vec<EditTuple>, Vec<EditTuple>)> {
        let edits = params::edits(edits)?;
        Ok(py.detach(|| {
            let example = example.unwrap_or(self);
            let corrections = Corrections::learn(&example.data.feet()?, &example.detection, &edits);
            let own: &[Edit] = if example.data.is_same(&self.data) { &edits } else { &[] };
            let mut corrected = corrections.apply(&self.data.feet()?, &self.detection, own);
            corrected.detection.notices.push(corrected.notice());
            let tuples = |edits: &[Edit]| edits.iter().map(params::edit_tuple).collect();
            let changes = tuples(&corrected.changes);
            Ok::<_, Failure>((
                RawDetection::new(self.data.clone(), corrected.detection),
                changes,
                tuples(own),
            ))
        })?)
    }

    /// Returns the plants as a file.
    fn to_bytes(&self, py: Python<'_>, format: &str) -> PyResult<Vec<u8>> {
        let format: PlantFormat = format.parse().map_err(Failure::from)?;
        Ok(py.detach(|| {
            format.write(&PlantExport {
                source: self.data.source(),
                clip: &self.data.clip,
                notices: &self.data.notices,
                skeletons: vec![(&self.data.skeleton, &self.detection)],
                as_array: false,
            })
        }))
    }

    /// Gait measures as columns with their unit in the name.
    fn gait(&self, py: Python<'_>) -> PyResult<Vec<(String, Option<f64>)>> {
        Ok(py.detach(|| {
            let feet = self.data.feet()?;
            Ok::<_, Failure>(Gait::from_detection(&feet, &self.detection).columns())
        })?)
    }

    /// Slide of each plant.
    fn slides(&self, py: Python<'_>) -> PyResult<Vec<SlideTuple>> {
        Ok(py.detach(|| {
            let contacts = Contacts::from(&self.detection);
            let skate = skate::measure(&self.data.clip, &self.data.skeleton, &contacts)?;
            let slides = skate.plants.into_iter().map(|slide| {
                (slide.side.name(), slide.frames.start, slide.frames.end, slide.distance, slide.frame)
            });
            Ok::<_, Failure>(slides.collect())
        })?)
    }

    /// Agreement with labels, as JSON: an array with an object per part.
    fn score(&self, py: Python<'_>, labels: Vec<params::PartLabels>) -> PyResult<String> {
        let annotation = params::annotation(labels, self.data.clip.frame_count())?;
        Ok(py.detach(|| self.agreement(annotation)))
    }

    /// Edits of a file of labels for this clip.
    fn read_edits(&self, bytes: PyBackedBytes) -> PyResult<Vec<EditTuple>> {
        let edits = formats::read_edits(&bytes, self.data.clip.frame_count()).map_err(Failure::from)?;
        Ok(edits.iter().map(params::edit_tuple).collect())
    }

    /// Edits that set every known label.
    fn edits_of_labels(&self, labels: Vec<params::PartLabels>) -> PyResult<Vec<EditTuple>> {
        let annotation = params::annotation(labels, self.data.clip.frame_count())?;
        Ok(annotation.edits().iter().map(params::edit_tuple).collect())
    }

    /// Labels of a file for this clip: part, and 1, 0 or −1 for unknown in each frame of both feet.
    fn read_labels(&self, py: Python<'_>, bytes: PyBackedBytes) -> PyResult<Vec<params::PartLabels>> {
        let frames = self.data.clip.frame_count();
        Ok(py.detach(|| {
            let annotation = formats::read_plants(&bytes, frames)?;
            let numbers = |labels: Vec<Option<bool>>| -> Vec<i8> {
                labels.into_iter().map(|label| label.map_or(-1, i8::from)).collect()
            };
            let part = |(part, [left, right]): (Part, [Vec<Option<bool>>; 2])| {
                (part.name().into(), numbers(left), numbers(right))
            };
            Ok::<_, Failure>(annotation.parts.into_iter().map(part).collect())
        })?)
    }
}

impl RawDetection {
    /// Compares the labels with an annotation, in which "no contact" next to unknown frames is unknown.
    fn agreement(&self, annotation: Annotation) -> String {
        let frame_time = self.data.clip.frame_time();
        let mask = |(part, feet): (Part, [Vec<Option<bool>>; 2])| {
            (part, feet.map(|labels| score::mask_near_unknown(&labels, frame_time)))
        };
        let masked = Annotation { parts: annotation.parts.into_iter().map(mask).collect() };
        let scores = score::compare(&self.detection, &masked, frame_time);
        serde_json::to_value(scores).as_ref().map(Value::to_string).unwrap_or_default()
    }
}
