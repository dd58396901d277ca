//! The labels of a clip.

use plantigrade::bvh::Clip;
use plantigrade::labels::{self, Document, Labelled, Source};
use plantigrade::notice::Notice;
use plantigrade::plants::{Detection, Evidence, FootLabels, PartLabels};
use plantigrade::skeleton::Skeleton;
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::records::{Failure, NoticeText, side, to_js};

/// The labels of a clip; series are given by part and side.
#[wasm_bindgen]
pub struct RawDetection {
    detection: Detection,
    metres_per_unit: f64,
}

impl RawDetection {
    pub(crate) fn new(detection: Detection, metres_per_unit: f64) -> RawDetection {
        RawDetection { detection, metres_per_unit }
    }

    pub(crate) fn core(&self) -> &Detection {
        &self.detection
    }

    pub(crate) fn save(
        &self,
        format: &str,
        name: String,
        sha256: Option<String>,
        clip: &Clip,
        skeleton: &Skeleton,
        notices: &[Notice],
    ) -> Result<String, Failure> {
        let several = clip.roots().count() > 1;
        let root = several.then(|| clip.joints()[skeleton.root].name.as_str());
        let labelled = [Labelled { root, detection: &self.detection }];
        Ok(match format {
            "json" => {
                Document::of(Source { name, sha256 }, clip, skeleton, &self.detection, notices).to_json()
            }
            "csv" => labels::frames_csv(&labelled, clip.frame_time()),
            "intervals" => labels::intervals_csv(&labelled, clip.frame_time()),
            "events" => labels::events_csv(&labelled, clip.frame_time()),
            _ => return Err(Failure::from(format!("there is no format {format:?}"))),
        })
    }

    fn part(&self, part: &str) -> Result<&PartLabels, Failure> {
        let labels = self.detection.parts.iter().find(|labels| labels.part.name() == part);
        labels.ok_or_else(|| Failure::from(format!("this method does not label {part:?}")))
    }

    fn foot(&self, part: &str, of: &str) -> Result<&FootLabels, Failure> {
        Ok(self.part(part)?.foot(side(of)?))
    }

    fn evidence(&self, part: &str) -> Result<&Evidence, Failure> {
        let evidence = self.part(part)?.evidence.as_ref();
        evidence.ok_or_else(|| Failure::from("nothing was clustered".to_owned()))
    }

    fn metres(&self, values: &[f64]) -> Vec<f32> {
        values.iter().map(|value| (value * self.metres_per_unit) as f32).collect()
    }
}

#[wasm_bindgen]
impl RawDetection {
    /// The parts that were labelled, the one that says best when a foot is down first.
    pub fn parts(&self) -> Vec<String> {
        self.detection.parts.iter().map(|labels| labels.part.name().into()).collect()
    }

    /// Height of the ground in the clip's positions, in metres.
    #[wasm_bindgen(getter)]
    pub fn floor(&self) -> f64 {
        self.detection.floor * self.metres_per_unit
    }

    /// What was assumed or is doubtful.
    ///
    /// # Errors
    /// None that a clip can cause.
    pub fn notices(&self) -> Result<Vec<Ts<NoticeText>>, Failure> {
        self.detection.notices.iter().map(|notice| to_js(&NoticeText::from(notice))).collect()
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
        Ok(self.foot(part, side)?.confidence.iter().map(|&confidence| confidence as f32).collect())
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

    /// Whether there was anything to cluster; without, there is no evidence.
    #[wasm_bindgen(js_name = hasEvidence)]
    pub fn has_evidence(&self, part: &str) -> Result<bool, Failure> {
        Ok(self.part(part)?.evidence.is_some())
    }

    /// Norms of the samples of both feet, ascending.
    #[wasm_bindgen(js_name = sortedNorms)]
    pub fn sorted_norms(&self, part: &str) -> Result<Vec<f32>, Failure> {
        Ok(single(&self.evidence(part)?.sorted_norms))
    }

    /// Variance of the first norms up to each one.
    #[wasm_bindgen(js_name = runningVariance)]
    pub fn running_variance(&self, part: &str) -> Result<Vec<f32>, Failure> {
        Ok(single(&self.evidence(part)?.running_variance))
    }

    /// Index of the knee.
    pub fn knee(&self, part: &str) -> Result<usize, Failure> {
        Ok(self.evidence(part)?.knee)
    }

    /// Scale of the kernel.
    pub fn sigma(&self, part: &str) -> Result<f64, Failure> {
        Ok(self.evidence(part)?.sigma)
    }

    /// Root of each sample's degree: left frames, then right ones.
    pub fn roots(&self, part: &str) -> Result<Vec<f32>, Failure> {
        Ok(single(&self.evidence(part)?.roots))
    }

    /// The value of the roots that parts planted from not.
    pub fn threshold(&self, part: &str) -> Result<f64, Failure> {
        Ok(self.evidence(part)?.threshold)
    }
}

fn single(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}
