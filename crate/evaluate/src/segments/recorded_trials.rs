//! Recorded trials with annotated actions.

use std::fs;
use std::path::Path;

use plantigrade::bvh;
use plantigrade::formats;
use plantigrade::segments::Segment;

use super::Case;

/// Recorded trials with annotated actions.
pub struct Recorded {
    /// 86_01 and 13_30.
    pub cases: Vec<Case>,
    /// The annotated actions of both; those of 86_01 by the first annotator.
    pub actions: [Vec<Segment>; 2],
    /// The cuts of 86_01 by the second annotator.
    pub second: Case,
}

impl Recorded {
    /// Reads the trials from the folder of recorded motion.
    pub fn read(corpus: &Path) -> anyhow::Result<Recorded> {
        let folder = corpus.join("cmu");
        let case = |name: &str, truth: &str| {
            let bytes = fs::read(folder.join(name).with_extension("bvh"))?;
            let clip = bvh::parse(&bytes, bvh::Options::default())?.clip;
            let text = fs::read_to_string(folder.join(truth))?;
            let truth = formats::read_cuts(&text, name, clip.frame_count(), clip.rate())?;
            anyhow::Ok((Case { clip, truth }, text))
        };
        let (walk, text) = case("86_01", "segmentation.json")?;
        let (exercise, exercise_text) = case("13_30", "segmentation_mocap6.json")?;
        let actions = |name: &str, case: &Case, text: &str| {
            formats::read_segments(text, name, case.clip.frame_count(), case.clip.rate())
        };
        let actions = [actions("86_01", &walk, &text)?, actions("13_30", &exercise, &exercise_text)?];
        let (second, _) = case("86_01", "segmentation_second_annotator.json")?;
        Ok(Recorded { cases: vec![walk, exercise], actions, second })
    }
}
