//! The plants document: JSON that is saved, shared and read back.

use std::ops::Range;

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::bvh::Clip;
use crate::foot::{Part, Side};
use crate::formats::document::{FrameRange, Header, Origin, Source};
use crate::intervals::intervals;
use crate::notice::Notice;
use crate::plants::{CaptureNoise, Detection, Edge, Edit, Ground};
use crate::skate::Contacts;
use crate::skeleton::Skeleton;

/// Plants of one clip and their origin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlantsDocument {
    /// Format, clip and frame rate.
    #[serde(flatten)]
    pub header: Header,
    /// Joints of heels and toes; absent if the plants are not detected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joints: Option<Joints>,
    /// Height of the ground along the up axis, in file units.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub floor: Option<f64>,
    /// Ground on which the feet stand; absent if the plants are not detected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground: Option<GroundUsed>,
    /// Noise of planted feet; absent if the plants are not detected or no foot is planted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noise: Option<Noise>,
    /// Method with its parameters.
    pub method: MethodUsed,
    /// Plants of the left foot.
    pub left: FootPlants,
    /// Plants of the right foot.
    pub right: FootPlants,
    /// Corrections of a person, in the order in which they apply; later ones override earlier ones.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub edits: Vec<Edit>,
    /// Notices of the reader and of the detector.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notices: Vec<Notice>,
}

/// Ground on which the feet stand, in the axes of the file; see [`Ground`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GroundUsed {
    /// Unit normal of the plane.
    pub normal: [f64; 3],
    /// Point of the plane, in file units.
    pub origin: [f64; 3],
    /// Tilt of the plane against the up axis, in degrees.
    pub tilt_deg: f64,
    /// Heights of the levels above the plane along the up axis, in file units, ascending.
    pub levels: Vec<f64>,
    /// Belt of a treadmill; absent if the ground is at rest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub belt: Option<Belt>,
}

/// Belt of a treadmill.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Belt {
    /// Speed, in metres per second.
    pub speed_m_per_s: f64,
    /// Unit vector in which the belt moves, in the axes of the file.
    pub direction: [f64; 3],
}

impl GroundUsed {
    fn new(ground: &Ground, skeleton: &Skeleton) -> GroundUsed {
        let rounded = |vector: &Vector3<f64>| vector.map(|value| (value * 1e6).round() / 1e6).into();
        GroundUsed {
            normal: rounded(&ground.normal),
            origin: rounded(&ground.origin),
            tilt_deg: (ground.tilt_degrees(skeleton.up) * 100.0).round() / 100.0,
            levels: ground.levels.iter().map(|level| (level * 1e6).round() / 1e6).collect(),
            belt: ground.belt.map(|velocity| Belt {
                speed_m_per_s: significant(velocity.norm() * skeleton.metres_per_unit),
                direction: rounded(&velocity.normalize()),
            }),
        }
    }
}

/// Noise of planted feet; see [`CaptureNoise`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Noise {
    /// Standard deviation of each coordinate of planted toes, in millimetres.
    pub position_mm: f64,
    /// Median speed, in millimetres per second.
    pub speed_mm_per_s: f64,
}

impl Noise {
    /// Converts from file units, and rounds to three significant digits.
    fn new(noise: CaptureNoise, metres_per_unit: f64) -> Noise {
        let [position_mm, speed_mm_per_s] =
            [noise.position, noise.speed].map(|value| significant(1e3 * metres_per_unit * value));
        Noise { position_mm, speed_mm_per_s }
    }
}

/// Returns a value rounded to three significant digits.
fn significant(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// Joints of both feet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Joints {
    /// Joints of the left foot.
    pub left: FootJoints,
    /// Joints of the right foot.
    pub right: FootJoints,
}

/// Names of the joints of one foot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FootJoints {
    /// Ankle, which represents the heel.
    pub heel: String,
    /// Toe base, or the joint that replaces it.
    pub toe: String,
}

/// Method of the plants, with its parameters.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodUsed {
    /// Name of the method; `truth` for measured or generated plants.
    pub name: String,
    /// Upper bound of the running variance of the sorted norms.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub r: Option<f64>,
    /// Window half-width, in frames.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub w: Option<usize>,
    /// Bandwidth of the kernel, if it was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sigma: Option<f64>,
}

/// Plants of one foot, for each part with labels.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FootPlants {
    /// Contact of any part of the foot.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<Vec<Plant>>,
    /// Contact of the toe.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub toe: Option<Vec<Plant>>,
    /// Contact of the heel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heel: Option<Vec<Plant>>,
}

/// One plant: a run of planted frames.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plant {
    /// Frames and times.
    #[serde(flatten)]
    pub frames: FrameRange,
    /// Origin of the plant.
    pub source: Origin,
    /// Foot strike (of a part: heel strike or toe strike); absent if it is known to the frame only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strike: Option<Instant>,
    /// Foot flat: the instant from which heel and toe are both down; of contact only, absent if it is
    /// unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flat: Option<Instant>,
    /// Foot off (of a part: heel off or toe off); absent if it is known to the frame only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub off: Option<Instant>,
}

/// Instant with its uncertainty.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Instant {
    /// Time from the first frame of the clip, in seconds.
    pub time_s: f64,
    /// Standard deviation of the error of the time, in milliseconds.
    pub uncertainty_ms: f64,
}

impl MethodUsed {
    /// Name of measured or generated plants.
    pub const TRUTH: &'static str = "truth";
}

impl From<&Edge> for Instant {
    /// Rounds the time to microseconds and the uncertainty to tenths of a millisecond.
    fn from(edge: &Edge) -> Instant {
        Instant {
            time_s: (edge.time * 1e6).round() / 1e6,
            uncertainty_ms: (edge.uncertainty * 1e4).round() / 10.0,
        }
    }
}

impl Plant {
    /// Creates a plant at `rate` Hz with instants known to the frame.
    pub fn new(range: Range<usize>, rate: f64, source: Origin) -> Plant {
        Plant { frames: FrameRange::new(range, rate), source, strike: None, flat: None, off: None }
    }
}

impl PlantsDocument {
    /// Value of [`Header::format`].
    pub const FORMAT: &'static str = "plantigrade-labels";

    /// Creates the document of a detection in a clip; `notices` are those of the reader.
    pub fn new(
        source: Source,
        clip: &Clip,
        skeleton: &Skeleton,
        detection: &Detection,
        notices: &[Notice],
    ) -> PlantsDocument {
        let name = |joint: usize| clip.joints()[joint].name.clone();
        let joints =
            |side| Some(FootJoints { heel: name(skeleton.heel(side)?), toe: name(skeleton.toe(side)?) });
        let foot = |side: Side| {
            let mut foot = FootPlants::default();
            for labels in &detection.parts {
                let (part, labels) = (labels.part, labels.foot(side));
                foot.set(part, &labels.planted, |run| {
                    let is_edited = detection.is_edited(side, part, &run);
                    let origin = if is_edited { Origin::Edited } else { Origin::Auto };
                    let [strike, off] =
                        [run.start, run.end].map(|frame| labels.edge(frame).map(Instant::from));
                    let flat = (part == Part::Contact).then(|| detection.foot_flat(side, &run)).flatten();
                    let flat = flat.and_then(|(_, edge)| edge).map(Instant::from);
                    Plant { strike, flat, off, ..Plant::new(run, clip.rate(), origin) }
                });
            }
            foot
        };
        let params = detection.params;
        PlantsDocument {
            header: Header::new(PlantsDocument::FORMAT, source, clip, skeleton),
            joints: joints(Side::Left).zip(joints(Side::Right)).map(|(left, right)| Joints { left, right }),
            floor: Some(detection.ground_height),
            ground: Some(GroundUsed::new(&detection.ground, skeleton)),
            noise: detection.noise.map(|noise| Noise::new(noise, skeleton.metres_per_unit)),
            method: MethodUsed {
                name: params.method().name().into(),
                r: Some(params.tolerance()),
                w: Some(params.window()),
                sigma: params.sigma(),
            },
            left: foot(Side::Left),
            right: foot(Side::Right),
            edits: detection.edits.clone(),
            notices: [notices, &skeleton.notices, &detection.notices].concat(),
        }
    }

    /// Returns the plants of one foot.
    pub fn foot(&self, side: Side) -> &FootPlants {
        match side {
            Side::Left => &self.left,
            Side::Right => &self.right,
        }
    }

    /// Returns the labels per frame of one part of one foot; `None` if the part has no labels.
    ///
    /// Plants beyond the end of the clip are cut there.
    pub fn labels(&self, side: Side, part: Part) -> Option<Vec<bool>> {
        let plants = self.foot(side).part(part)?;
        let mut labels = vec![false; self.header.frames];
        for Plant { frames, .. } in plants {
            let end = frames.end.min(self.header.frames);
            labels[frames.start.min(end)..end].fill(true);
        }
        Some(labels)
    }
}

impl FootPlants {
    /// Returns the plants of one part.
    pub fn part(&self, part: Part) -> Option<&[Plant]> {
        match part {
            Part::Contact => self.contact.as_deref(),
            Part::Toe => self.toe.as_deref(),
            Part::Heel => self.heel.as_deref(),
        }
    }

    /// Sets the plants of one part: `plant` of each run of planted frames.
    pub fn set(&mut self, part: Part, labels: &[bool], plant: impl Fn(Range<usize>) -> Plant) {
        let plants = intervals(labels).into_iter().map(plant).collect();
        match part {
            Part::Contact => self.contact = Some(plants),
            Part::Toe => self.toe = Some(plants),
            Part::Heel => self.heel = Some(plants),
        }
    }
}

impl From<&PlantsDocument> for Contacts {
    fn from(document: &PlantsDocument) -> Contacts {
        Contacts::new(|side, part| document.labels(side, part))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::document::VERSION;
    use crate::notice::Code;

    #[test]
    fn documents_round_trip() {
        let labels = [true, false, true, true];
        let mut left = FootPlants::default();
        left.set(Part::Toe, &labels, |run| Plant {
            flat: Some(Instant { time_s: 0.01, uncertainty_ms: 3.0 }),
            off: Some(Instant { time_s: 0.02, uncertainty_ms: 4.5 }),
            ..Plant::new(run, 30.0, Origin::Auto)
        });
        let document = PlantsDocument {
            header: Header {
                format: PlantsDocument::FORMAT.into(),
                version: VERSION,
                source: Source { name: "walk.bvh".into(), sha256: None, name_encoding: None },
                root: None,
                frames: 4,
                rate: 30.0,
            },
            joints: None,
            floor: None,
            ground: Some(GroundUsed {
                normal: [0.0, 1.0, 0.0],
                origin: [0.0, 0.5, 0.0],
                tilt_deg: 0.0,
                levels: vec![0.0, 0.17],
                belt: Some(Belt { speed_m_per_s: 1.25, direction: [0.0, 0.0, -1.0] }),
            }),
            noise: Some(Noise { position_mm: 1.25, speed_mm_per_s: 38.0 }),
            method: MethodUsed { name: "paper".into(), r: Some(0.001), w: Some(1), sigma: None },
            left,
            right: FootPlants::default(),
            edits: vec![Edit { side: Side::Left, part: Part::Toe, start: 2, end: 4, planted: true }],
            notices: vec![Notice::new(Code::NoToe, "No toes.")],
        };
        let text = serde_json::to_string(&document).unwrap();
        let back: PlantsDocument = serde_json::from_str(&text).unwrap();
        assert_eq!(back, document);
        assert_eq!(back.labels(Side::Left, Part::Toe).unwrap(), labels);
        assert_eq!(back.labels(Side::Right, Part::Toe), None);
    }
}
