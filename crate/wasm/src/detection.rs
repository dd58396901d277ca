//! The labels of a clip.

use plantigrade::bvh::Clip;
use plantigrade::labels::{self, Document, Edit, Labelled, Source};
use plantigrade::notice::Notice;
use plantigrade::plants::{Detection, FootLabels, PartLabels};
use plantigrade::skeleton::Skeleton;
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::records::{EditFacts, Failure, NoticeText, from_js, side, to_js};

/// The labels of a clip; series are given by part and side.
#[wasm_bindgen]
pub struct RawDetection {
    found: Detection,
    /// What was found under the edits of a person, where there are any.
    edited: Option<Detection>,
    metres_per_unit: f64,
    frame_time: f64,
}

impl RawDetection {
    pub(crate) fn new(found: Detection, metres_per_unit: f64, frame_time: f64) -> RawDetection {
        RawDetection { found, edited: None, metres_per_unit, frame_time }
    }

    pub(crate) fn core(&self) -> &Detection {
        self.edited.as_ref().unwrap_or(&self.found)
    }

    pub(crate) fn save(
        &self,
        format: &str,
        name: String,
        sha256: Option<String>,
        clip: &Clip,
        skeleton: &Skeleton,
        notices: &[Notice],
    ) -> Result<Vec<u8>, Failure> {
        let several = clip.roots().count() > 1;
        let root = several.then(|| clip.joints()[skeleton.root].name.as_str());
        let labelled = [Labelled { root, detection: self.core() }];
        let frame_time = clip.frame_time();
        let text = match format {
            "json" => Document::of(Source { name, sha256 }, clip, skeleton, self.core(), notices).to_json(),
            "csv" => labels::frames_csv(&labelled, frame_time),
            "intervals" => labels::intervals_csv(&labelled, frame_time),
            "events" => labels::events_csv(&labelled, frame_time),
            "blender" => labels::blender_script(&labelled, &name, frame_time),
            "npz" => return Ok(labels::npz(&labelled, &name, frame_time)),
            _ => return Err(Failure::from(format!("there is no format {format:?}"))),
        };
        Ok(text.into_bytes())
    }

    pub(crate) fn metres_per_unit(&self) -> f64 {
        self.metres_per_unit
    }

    pub(crate) fn part(&self, part: &str) -> Result<&PartLabels, Failure> {
        part_of(self.core(), part)
    }

    /// The same as it was found, whatever a person says.
    pub(crate) fn part_found(&self, part: &str) -> Result<&PartLabels, Failure> {
        part_of(&self.found, part)
    }

    pub(crate) fn foot(&self, part: &str, of: &str) -> Result<&FootLabels, Failure> {
        Ok(self.part(part)?.foot(side(of)?))
    }

    fn metres(&self, values: &[f32]) -> Vec<f32> {
        values.iter().map(|&value| (f64::from(value) * self.metres_per_unit) as f32).collect()
    }
}

#[wasm_bindgen]
impl RawDetection {
    /// Lays a person's edits over what was found, in place of those before; later ones count more.
    ///
    /// # Errors
    /// If one of them is none.
    pub fn edit(&mut self, edits: Vec<Ts<EditFacts>>) -> Result<(), Failure> {
        let edits =
            edits.iter().map(|edit| Ok(from_js(edit)?.into())).collect::<Result<Vec<Edit>, Failure>>()?;
        self.edited = (!edits.is_empty()).then(|| labels::edited(&self.found, &edits, self.frame_time));
        Ok(())
    }

    /// The parts that were labelled, the one that says best when a foot is down first.
    pub fn parts(&self) -> Vec<String> {
        self.core().parts.iter().map(|labels| labels.part.name().into()).collect()
    }

    /// Height of the ground in the clip's positions, in metres.
    #[wasm_bindgen(getter)]
    pub fn floor(&self) -> f64 {
        self.core().floor * self.metres_per_unit
    }

    /// What was assumed or is doubtful.
    ///
    /// # Errors
    /// None that a clip can cause.
    pub fn notices(&self) -> Result<Vec<Ts<NoticeText>>, Failure> {
        self.core().notices.iter().map(|notice| to_js(&NoticeText::from(notice))).collect()
    }

    /// 1 where the foot is planted, per frame.
    ///
    /// # Errors
    /// If there is no such part or side; so for all series.
    pub fn planted(&self, part: &str, side: &str) -> Result<Vec<u8>, Failure> {
        Ok(self.foot(part, side)?.planted.iter().map(|&planted| u8::from(planted)).collect())
    }

    /// Probability that the label is right, per frame.
    pub fn confidence(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        Ok(self.foot(part, side)?.confidence.clone())
    }

    /// Height above the ground in metres, per frame.
    pub fn height(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        Ok(self.metres(&self.foot(part, side)?.height))
    }

    /// Speed in metres per second, per frame.
    pub fn speed(&self, part: &str, side: &str) -> Result<Vec<f32>, Failure> {
        Ok(self.metres(&self.foot(part, side)?.speed))
    }

    /// Plants as frames: start, end, start, end, ...; half-open.
    pub fn intervals(&self, part: &str, side: &str) -> Result<Vec<u32>, Failure> {
        let ranges = labels::intervals(&self.foot(part, side)?.planted);
        Ok(ranges.into_iter().flat_map(|range| [range.start as u32, range.end as u32]).collect())
    }

    /// For each of those plants 1 where it is as a person wants it, else 0.
    pub fn edited(&self, part: &str, of: &str) -> Result<Vec<u8>, Failure> {
        let (shown, labels, side) = (self.core(), self.part(part)?, side(of)?);
        let ranges = labels::intervals(&labels.foot(side).planted);
        Ok(ranges.iter().map(|range| u8::from(shown.is_edited(side, labels.part, range))).collect())
    }
}

fn part_of<'a>(detection: &'a Detection, part: &str) -> Result<&'a PartLabels, Failure> {
    let labels = detection.parts.iter().find(|labels| labels.part.name() == part);
    labels.ok_or_else(|| Failure::from(format!("this method does not label {part:?}")))
}
