//! Cached intermediate results of the detection: those that depend on no parameter, and those that
//! depend on the window only.

use std::cell::OnceCell;
use std::ops::Range;
use std::sync::Arc;

use crate::foot::Part;
use crate::kinematics::Track;
use crate::notice::{Code, Notice};
use crate::numeric::stats;
use crate::plants::signal::resampling::Resampler;
use crate::plants::signal::samples::Ranges;
use crate::plants::signal::{Signals, fixed_hips, ground, motion_segments, moving_ground, tilt};
use crate::plants::spectral::bandwidth;
use crate::plants::spectral::cells::PartitionedSamples;
use crate::plants::{Feet, FootTracks, signal};

/// Speed below which a foot is still, in leg lengths per second. The character stands still if almost all
/// speeds are below it …
const STILL_SPEED: f64 = 0.35;
/// … and all heights are within this range, in leg lengths.
const STILL_HEIGHT: f64 = 0.15;

/// Cached results of the detection in one clip.
#[derive(Default)]
pub(crate) struct DetectionCache {
    pub motion: Option<Motion>,
    pub sample_sets: SampleSets,
}

/// Filtered signals of the feet.
pub(crate) struct Motion {
    /// Spans of continuous motion, in frames.
    pub spans: Vec<Range<usize>>,
    /// The same spans in resampled frames.
    pub fine_spans: Vec<Range<usize>>,
    /// Upsampling factor.
    pub factor: usize,
    pub ankle: Signals,
    pub toe: Signals,
    /// Height of the heel of a foot that stands on its toe, by foot and resampled frame, in file units.
    heel_rise: [Vec<f32>; 2],
    /// True if the toe bears weight rather than the ankle, by foot and resampled frame.
    is_toe_bearing: [Vec<bool>; 2],
    pub stands_still: bool,
    /// Notices about frames that were left out.
    pub notices: Vec<Notice>,
}

impl Motion {
    pub fn new(feet: &Feet) -> Motion {
        let spans = motion_segments::motion_spans(feet);
        let on_ground = moving_ground::displacement(feet, &spans).map(|ground| relative_to(feet, &ground));
        let has_fixed_hips =
            on_ground.is_some() && spans.iter().any(|span| fixed_hips::are_fixed(feet, span));
        let levelled = tilt::levelled(on_ground.as_ref().unwrap_or(feet), &spans);
        let relative = levelled.as_ref().or(on_ground.as_ref()).unwrap_or(feet);
        let resampler = Resampler::new(feet, &spans);
        let mut ankle = signal::filtered(relative, &resampler, |foot| &foot.ankle);
        let mut toe = signal::filtered(relative, &resampler, |foot| &foot.toe);
        let heel_rise = ground::subtract(relative, &resampler, &mut ankle, &mut toe);
        // From here on, memory is needed for something else.
        drop((levelled, on_ground));
        let is_toe_bearing = signal::weight_bearing(&ankle, &toe, STILL_SPEED * feet.leg);
        let Resampler { fine_spans, factor, .. } = resampler;
        let mut notices = span_notices(feet, &spans);
        if has_fixed_hips {
            let text = "The hips never move: the motion of the root is missing, or positions are relative to the \
                        hips. Unless the feet move as on a treadmill, labels assume that the ground is where the lower \
                        foot is, which is unknown in jumps, and slides are not relative to it.";
            notices.push(Notice::new(Code::FixedHips, text));
        }
        let mut motion = Motion {
            spans,
            fine_spans,
            factor,
            ankle,
            toe,
            heel_rise,
            is_toe_bearing,
            stands_still: false,
            notices,
        };
        motion.stands_still = motion.is_standing(feet.leg);
        motion
    }

    /// Returns height and speed of a part of a foot at a resampled frame: contact is the part that bears weight,
    /// and the ground of the heel is that under the toe.
    pub fn at(&self, part: Part, foot: usize, frame: usize) -> [f64; 2] {
        let (ankle, toe) = (&self.ankle[foot], &self.toe[foot]);
        match part {
            Part::Contact => if self.is_toe_bearing[foot][frame] { toe } else { ankle }.at(frame),
            Part::Toe => toe.at(frame),
            Part::Heel => [ankle.height[frame] + f64::from(self.heel_rise[foot][frame]), ankle.speed[frame]],
        }
    }

    /// True if almost all speeds and all heights are those of standing feet.
    fn is_standing(&self, leg: f64) -> bool {
        let values =
            || signal::values_within(&self.fine_spans, |foot, frame| self.at(Part::Contact, foot, frame));
        let (lowest, highest) = signal::min_max(values().map(|[height, _]| height));
        highest - lowest < STILL_HEIGHT * leg
            && stats::percentile(values().map(|[_, speed]| speed).collect(), 0.99) < STILL_SPEED * leg
    }
}

/// Samples of one part.
pub(crate) struct SampleSet {
    /// Ranges by which heights and speeds were divided.
    pub ranges: Ranges,
    pub samples: PartitionedSamples,
    sorted_norms: OnceCell<Arc<[f64]>>,
}

impl SampleSet {
    pub fn new(samples: PartitionedSamples, ranges: Ranges) -> SampleSet {
        SampleSet { ranges, samples, sorted_norms: OnceCell::new() }
    }

    /// Returns the norms of the samples in ascending order.
    pub fn sorted_norms(&self) -> Arc<[f64]> {
        self.sorted_norms.get_or_init(|| bandwidth::sorted(&self.samples.samples.norms)).clone()
    }
}

/// Samples of all parts for the window of the last detection.
#[derive(Default)]
pub(crate) struct SampleSets {
    window: usize,
    by_part: [Option<SampleSet>; Part::ALL.len()],
}

impl SampleSets {
    /// Takes the samples of a part, if they are cached.
    pub fn take(&mut self, part: Part, window: usize) -> Option<SampleSet> {
        if window != self.window {
            *self = SampleSets { window, ..SampleSets::default() };
        }
        self.by_part[part as usize].take()
    }

    /// Caches the samples of a part.
    pub fn put(&mut self, part: Part, samples: SampleSet) {
        self.by_part[part as usize] = Some(samples);
    }
}

/// Returns the feet relative to moving ground.
fn relative_to(feet: &Feet, ground: &Track) -> Feet {
    let relative =
        |track: &Track| track.iter().zip(ground).map(|(position, ground)| position - ground).collect();
    let tracks = feet.tracks.each_ref().map(|foot| FootTracks {
        ankle: relative(&foot.ankle),
        toe: relative(&foot.toe),
        tip: None,
    });
    Feet { tracks, hips: Track::new(), ..*feet }
}

fn span_notices(feet: &Feet, spans: &[Range<usize>]) -> Vec<Notice> {
    let mut notices = Vec::new();
    let (first, end) = (spans[0].start, spans[spans.len() - 1].end);
    let after = feet.frame_count() - end;
    if first + after > 0 {
        let text = format!(
            "{first} frames at the start and {after} at the end were left out because the pose jumps there; \
             they take the labels of their neighbours."
        );
        notices.push(Notice::new(Code::Trimmed, text));
    }
    let jumps: Vec<usize> = spans[1..].iter().map(|span| span.start).collect();
    let text = match jumps[..] {
        [] => return notices,
        [frame] => format!("Both feet jump at frame {frame}; the motion is split there."),
        [frame, ..] => format!(
            "Both feet jump at {} frames, the first of which is {frame}; the motion is split there. If the \
             character does not jump, the root may have another unit than the offsets of the skeleton.",
            jumps.len()
        ),
    };
    notices.push(Notice::new(Code::Teleport, text));
    notices
}
