//! Gait to write.

use std::convert::Infallible;

use crate::bvh::Clip;
use crate::formats::document::Source;
use crate::gait::{ActionGait, ActionRanges, GaitAnalysis, Legs};
use crate::plants::{Detection, Feet};
use crate::skeleton::Skeleton;

/// Writes gait as the text of a file.
pub(crate) type Writer = fn(&GaitExport) -> String;

/// The formats of gait are not read.
pub(crate) type Reader = Infallible;

/// Gait to write.
#[derive(Clone, Debug)]
pub struct GaitExport<'a> {
    /// Name and digest of the clip's file.
    pub source: Source,
    /// The clip.
    pub clip: &'a Clip,
    /// Skeletons with their gait.
    pub skeletons: Vec<SkeletonGait<'a>>,
}

/// Gait of one skeleton.
#[derive(Clone, Debug)]
pub struct SkeletonGait<'a> {
    /// The skeleton.
    pub skeleton: &'a Skeleton,
    /// Its plants, with edits applied.
    pub detection: &'a Detection,
    /// Gait of the whole clip, whose action has no name, or of each action.
    pub parts: Vec<ActionGait>,
}

impl<'a> SkeletonGait<'a> {
    /// Analyses the gait of a detection: of the whole clip or, if `actions` are given, of each of them.
    pub fn new(
        clip: &Clip,
        skeleton: &'a Skeleton,
        feet: &Feet,
        detection: &'a Detection,
        actions: Option<Vec<ActionRanges>>,
    ) -> SkeletonGait<'a> {
        let legs = Legs::new(clip, skeleton);
        let analyse =
            |ranges: Option<&[_]>| GaitAnalysis::from_detection(feet, legs.as_ref(), detection, ranges);
        let whole_clip = || {
            let frames = vec![0..feet.frame_count()];
            vec![ActionGait { action: ActionRanges { name: String::new(), frames }, analysis: analyse(None) }]
        };
        let parts = actions.map_or_else(whole_clip, |actions| {
            let part = |action: ActionRanges| {
                let analysis = analyse(Some(&action.frames));
                ActionGait { action, analysis }
            };
            actions.into_iter().map(part).collect()
        });
        SkeletonGait { skeleton, detection, parts }
    }

    /// True if the gait is given per action.
    pub(crate) fn is_per_action(&self) -> bool {
        self.parts.iter().any(|part| !part.action.name.is_empty())
    }
}

impl GaitExport<'_> {
    /// Returns the name of the root joint of a skeleton, if the clip has several skeletons.
    pub(crate) fn root(&self, skeleton: &Skeleton) -> Option<&str> {
        (self.clip.roots().count() > 1).then(|| self.clip.joints()[skeleton.root].name.as_str())
    }
}
