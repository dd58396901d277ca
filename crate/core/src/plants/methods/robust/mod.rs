//! Default method: labels contact, toe and heel.
//!
//! Differences from the method of the paper: frames that do not belong to the motion are left out
//! and single-frame spikes removed. Clips of low rates are resampled to 120 Hz, and speeds are
//! smoothed without blurring stops and starts. Positions are relative to moving ground, and heights
//! to the plane of tilted ground and to the ground of each stance, so that belts, slopes, stairs and
//! tilted floors do not matter. The slower of ankle and toe bears weight; if both are still, the lower
//! one. Ranges are capped, degrees are weighted towards rest, the kernel has a heavy tail, and the
//! threshold is the mean of the class medians. Toes are compared with the samples that bear weight;
//! heels are clustered separately. Runs that are too short for human motion, swings that noise
//! explains, and dragged feet are removed. The edges of contact are moved to the instants of impact
//! and release.

pub(crate) mod cache;

use std::cell::OnceCell;

use crate::foot::{Part, Side};
use crate::notice::{Code, Notice};
use crate::plants::methods::method_info::{Family, Input, MethodInfo, Output, Settings, Thresholds};
use crate::plants::methods::robust::cache::{DetectionCache, Motion, SampleSet, SampleSets};
use crate::plants::postprocess::{capture_noise, confidence, dragging, edges, short_runs};
use crate::plants::signal::samples::{Ranges, Samples};
use crate::plants::spectral::affinity::Kernel;
use crate::plants::spectral::bandwidth::Bandwidth;
use crate::plants::spectral::cells::PartitionedSamples;
use crate::plants::spectral::degree::DegreeQuery;
use crate::plants::spectral::expansion::Expansion;
use crate::plants::spectral::field::DegreeField;
use crate::plants::spectral::threshold::{self, CutRule, Evidence};
use crate::plants::{Feet, FootLabels, PartLabels};

/// Maximum number of frames whose samples are cached, which takes about 20 MB.
const MAX_CACHED_FRAMES: usize = 50_000;
/// Minimum number of frames to cluster.
const MIN_FRAMES: usize = 10;
/// Maximum ranges by which heights and speeds are divided, in leg lengths and leg lengths per
/// second.
const HEIGHT_CAP: f64 = 0.4;
const SPEED_CAP: f64 = 8.0;
/// The heavy tail finds the edges of contact earlier than a Gaussian.
const KERNEL: Kernel = Kernel::Cauchy;
/// Limits of the bandwidth, as speeds at height 0 in leg lengths per second: planted feet are slower
/// than the upper one. Feet that stand exactly still have norms of zero, which move the knee to either
/// extreme. Chosen on generated motion with and without noise (seeds 0 to 2).
const MIN_BANDWIDTH: f64 = 0.15;
const MAX_BANDWIDTH: f64 = 0.8;
/// Minimum duration of a gap and of a plant, in seconds.
const MIN_RUN: f64 = 0.1;
/// Half-width of the window over which confidence is averaged, in seconds.
const CONFIDENCE_WINDOW: f64 = 0.04;

pub(crate) const METHOD: MethodInfo = MethodInfo {
    name: "robust",
    title: "Robust spectral",
    description: "Contact, heel and toe; repairs single-frame glitches; independent of the frame rate.",
    family: Family::Spectral,
    parts: &[Part::Contact, Part::Toe, Part::Heel],
    thresholds: |_, _| Thresholds::NONE,
    detect,
};

fn detect(input: &mut Input) -> Output {
    let (feet, settings) = (input.feet, input.settings);
    let caches_samples = input.cache.is_some() && feet.frame_count() <= MAX_CACHED_FRAMES;
    let mut temporary = DetectionCache::default();
    let cache = input.cache.as_deref_mut().unwrap_or(&mut temporary);
    let motion = &*cache.motion.get_or_insert_with(|| Motion::new(feet));
    Pipeline { feet, settings, motion, caches_samples }.detect(&mut cache.sample_sets)
}

/// Detection of all parts of a clip.
struct Pipeline<'a> {
    feet: &'a Feet,
    settings: Settings,
    motion: &'a Motion,
    /// True if samples are cached for another detection.
    caches_samples: bool,
}

/// Evidence of a clustering and the class of each sample.
type Classified = (Evidence, Vec<bool>);

/// Clustering with which the samples of other parts can be compared.
struct Clustering {
    set: SampleSet,
    weights: Vec<f64>,
    expansion: OnceCell<Expansion>,
    evidence: Evidence,
    planted: Vec<bool>,
}

impl Pipeline<'_> {
    fn detect(&self, sample_sets: &mut SampleSets) -> Output {
        let mut notices = self.motion.notices.clone();
        let clustering = if self.feet.frame_count() < MIN_FRAMES {
            let text = format!("The clip has fewer than {MIN_FRAMES} frames; all are labelled as contact.");
            notices.push(Notice::new(Code::ShortClip, text));
            None
        } else if self.motion.stands_still {
            let text = "The feet stand still in the whole clip; every frame is contact.";
            notices.push(Notice::new(Code::StandingStill, text));
            None
        } else {
            Some(self.cluster(self.sample_set(sample_sets, Part::Contact, None), KERNEL))
        };
        let is_clustered = clustering.is_some();
        let [contact, toe, heel] = self.classify(clustering, sample_sets);
        let mut contact = self.label(Part::Contact, contact);
        let mut toe = self.label(Part::Toe, toe);
        let mut heel = self.label(Part::Heel, heel);
        if is_clustered {
            // Heels and toes may rise slowly without a step, unless noise has made swings of contact.
            if let Some(notice) = capture_noise::fill_swings(self.feet, &mut contact) {
                notices.push(notice);
                for labels in [&mut toe, &mut heel] {
                    capture_noise::fill_swings(self.feet, labels);
                }
            }
            notices.extend(self.drop_dragged(&mut contact.feet));
            self.refine_edges(&mut contact.feet);
        }
        // Toe and heel are planted only during contact.
        for part in [&mut toe, &mut heel] {
            for (foot, contact) in part.feet.iter_mut().zip(&contact.feet) {
                for (planted, contact) in foot.planted.iter_mut().zip(&contact.planted) {
                    *planted &= contact;
                }
            }
        }
        if is_clustered {
            for foot in 0..2 {
                let parts = [(Part::Heel, &mut heel.feet[foot]), (Part::Toe, &mut toe.feet[foot])];
                edges::refine_parts(self.feet, foot, &self.motion.spans, &contact.feet[foot], parts);
            }
        }
        Output { parts: vec![contact, toe, heel], notices }
    }

    /// Classifies the samples of contact, toe and heel. The samples need most of the memory and are
    /// freed before labels are created, unless they are cached.
    fn classify(&self, contact: Option<Clustering>, sample_sets: &mut SampleSets) -> [Option<Classified>; 3] {
        let Some(mut contact) = contact else { return [const { None }; 3] };
        let toes = self.sample_set(sample_sets, Part::Toe, Some(contact.set.ranges));
        let toe = compare(&toes, &mut contact, self.settings);
        self.store(sample_sets, Part::Toe, toes);
        self.store(sample_sets, Part::Contact, contact.set);
        drop(contact.weights);
        // An ankle is high above the ground even if the heel is down, so heels are clustered
        // separately.
        let heel = self.cluster(self.sample_set(sample_sets, Part::Heel, None), Kernel::Gaussian);
        self.store(sample_sets, Part::Heel, heel.set);
        [(contact.evidence, contact.planted), toe, (heel.evidence, heel.planted)].map(Some)
    }

    /// Returns the samples of a part, divided by their own ranges unless ranges are given.
    fn sample_set(&self, sample_sets: &mut SampleSets, part: Part, ranges: Option<Ranges>) -> SampleSet {
        let window = self.settings.window;
        sample_sets.take(part, window).unwrap_or_else(|| {
            let (leg, motion) = (self.feet.leg, self.motion);
            let Motion { fine_spans: spans, factor, .. } = motion;
            let at = |foot, frame| motion.at(part, foot, frame);
            let ranges =
                ranges.unwrap_or_else(|| Ranges::new(spans, at).capped(HEIGHT_CAP * leg, SPEED_CAP * leg));
            let samples = Samples::from_signals(at, spans, ranges, window, *factor);
            SampleSet::new(PartitionedSamples::new(samples, self.caches_samples), ranges)
        })
    }

    fn store(&self, sample_sets: &mut SampleSets, part: Part, set: SampleSet) {
        if self.caches_samples {
            sample_sets.put(part, set);
        }
    }

    fn cluster(&self, set: SampleSet, kernel: Kernel) -> Clustering {
        let window = self.settings.window;
        let samples = &set.samples.samples;
        // A wider window has larger norms; r refers to w = 1.
        let r = self.settings.tolerance * (2 * window + 1) as f64 / 3.0;
        let bandwidth = Bandwidth::from_knee(set.sorted_norms(), r);
        let of_speed =
            |speed: f64| ((2 * window + 1) as f64).sqrt() * speed * self.feet.leg / set.ranges.speed;
        let [min, max] = [MIN_BANDWIDTH, MAX_BANDWIDTH].map(of_speed);
        let at_knee = bandwidth.sigma();
        let sigma = self.settings.sigma.unwrap_or(at_knee.clamp(min, max));
        let sigma_is_limited = self.settings.sigma.is_none() && sigma != at_knee;
        // Samples near rest have larger weights, so that a foot held still in the air, whose
        // samples are dense, does not count as planted.
        let reach = (8.0 * sigma).min(0.5 * ((2 * window + 1) as f64).sqrt());
        let weights: Vec<f64> = samples.norms.iter().map(|norm| (-(norm / reach).powi(2)).exp()).collect();
        let (summation, expansion) = (self.settings.summation, OnceCell::new());
        let query =
            DegreeQuery { samples: &set.samples, weights: &weights, sigma, kernel, summation, expansion };
        let frames = self.motion.spans.iter().cloned().flatten().collect();
        let (mut evidence, planted) =
            threshold::split(frames, samples, bandwidth, sigma, query.sqrt_degrees(), CutRule::Medians);
        evidence.sigma_is_limited = sigma_is_limited;
        evidence.field = Some(DegreeField::new(&query, set.ranges));
        let expansion = query.expansion;
        Clustering { set, weights, expansion, evidence, planted }
    }

    /// Creates the labels of one part; without a clustering, all frames are planted.
    fn label(&self, part: Part, clustered: Option<Classified>) -> PartLabels {
        let frames = self.feet.frame_count();
        let labels = |foot: usize| {
            let (planted, confidence) = match &clustered {
                Some((evidence, planted)) => self.frame_labels(foot, evidence, planted),
                None => (vec![true; frames], vec![1.0; frames]),
            };
            let at = |frame: usize| {
                self.motion.at(part, foot, frame * self.motion.factor).map(|value| value as f32)
            };
            let (height, speed) = (0..frames).map(at).map(|[height, speed]| (height, speed)).unzip();
            FootLabels { planted, confidence, height, speed, edges: Vec::new() }
        };
        PartLabels { part, feet: [labels(0), labels(1)], evidence: clustered.map(|(evidence, _)| evidence) }
    }

    /// Returns labels and confidence of one foot for all frames of the clip.
    fn frame_labels(&self, foot: usize, evidence: &Evidence, planted: &[bool]) -> (Vec<bool>, Vec<f32>) {
        let count = evidence.frames.len();
        let samples_of_foot = foot * count..(foot + 1) * count;
        let (values, planted) = (&evidence.values[samples_of_foot.clone()], &planted[samples_of_foot]);
        // Comparing in frames needs a margin for frame times such as 0.0083333.
        let min_length = (MIN_RUN / self.feet.frame_time - 1e-3).ceil() as usize;
        let half = self.feet.frames_in(CONFIDENCE_WINDOW);
        let mut labels = vec![false; self.feet.frame_count()];
        let mut confidence = vec![1.0; labels.len()];
        let mut next = 0;
        for span in &self.motion.spans {
            let samples = next..next + span.len();
            let mut span_labels = planted[samples.clone()].to_vec();
            short_runs::drop_short_runs(&mut span_labels, min_length);
            let probability = confidence::planted_probability(&values[samples.clone()], evidence, half);
            for ((frame, label), p) in span.clone().zip(span_labels).zip(probability) {
                labels[frame] = label;
                confidence[frame] = confidence::label_confidence(label, p);
            }
            next = samples.end;
        }
        self.fill_ends(&mut labels, &mut confidence);
        (labels, confidence)
    }

    /// Removes the contact of dragged feet and returns notices about it.
    fn drop_dragged(&self, contact: &mut [FootLabels; 2]) -> Vec<Notice> {
        let planted = |foot: &FootLabels| foot.planted.iter().filter(|planted| **planted).count();
        let before = contact.each_ref().map(planted);
        for span in &self.motion.spans {
            dragging::drop_dragged(self.feet, span, contact);
        }
        for labels in &mut *contact {
            self.fill_ends(&mut labels.planted, &mut labels.confidence);
        }
        let dropped = Side::BOTH.into_iter().zip(before.iter().zip(contact.each_ref().map(planted)));
        let notice = |(side, (before, after)): (Side, (&usize, usize))| {
            let seconds = (before - after) as f64 * self.feet.frame_time;
            let text = format!(
                "The {} foot moves away from the other along the ground for {seconds:.1} s; \
                 it is dragged and not planted.",
                side.name()
            );
            (after < *before).then(|| Notice::new(Code::Dragged, text))
        };
        dropped.filter_map(notice).collect()
    }

    /// Moves the boundaries of contact to the instants of impact and release.
    fn refine_edges(&self, contact: &mut [FootLabels; 2]) {
        for (foot, labels) in contact.iter_mut().enumerate() {
            edges::refine(self.feet, foot, &self.motion.spans, labels);
            self.fill_ends(&mut labels.planted, &mut labels.confidence);
        }
    }

    /// Gives frames that were left out the label of their nearest neighbour, with minimum
    /// confidence.
    fn fill_ends(&self, labels: &mut [bool], confidence: &mut [f32]) {
        let (first, last) =
            (self.motion.spans[0].start, self.motion.spans[self.motion.spans.len() - 1].end - 1);
        for frame in (0..first).chain(last + 1..labels.len()) {
            labels[frame] = labels[frame.clamp(first, last)];
            confidence[frame] = 0.5;
        }
    }
}

/// Classifies the samples of a part by comparison with the samples that bear weight.
fn compare(other: &SampleSet, clustering: &mut Clustering, settings: Settings) -> Classified {
    let expansion = std::mem::take(&mut clustering.expansion);
    let Clustering { set, weights, evidence, .. } = clustering;
    let (samples, sigma, summation) = (&set.samples, evidence.sigma, settings.summation);
    let query = DegreeQuery { samples, weights, sigma, kernel: KERNEL, summation, expansion };
    let mut degrees = query.sqrt_degrees_of(&other.samples);
    degrees.refine_near(evidence.threshold);
    let planted = degrees.values.iter().map(|&value| value > evidence.threshold).collect();
    let evidence = Evidence {
        values: threshold::to_single(&degrees.values),
        norms: threshold::to_single(&other.samples.samples.norms),
        frames: evidence.frames.clone(),
        sorted_norms: evidence.sorted_norms.clone(),
        field: evidence.field.clone(),
        ..*evidence
    };
    (evidence, planted)
}
