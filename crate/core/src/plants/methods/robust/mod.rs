//! The method to use: contact, toe and heel.
//!
//! What it adds to the published one: frames that belong to no motion are left
//! out and single-frame spikes mended; clips of low rates are refined to 120 Hz,
//! and speeds smoothed over a window of time without blurring stops and starts;
//! heights count from the ground that is near in time, so that slopes and stairs
//! do no harm; the slower of ankle and toe is what bears weight (of two still ones
//! the lower); ranges are capped, degrees anchored at rest, the kernel has a long
//! tail, and the threshold lies between medians. Toes are then compared with what
//! bears weight; heels are clustered by themselves. Runs too short for a person are
//! dropped, and feet that are dragged.

mod cache;

use std::cell::Cell;
use std::cell::OnceCell;

pub(crate) use crate::plants::methods::robust::cache::Kept;
use crate::plants::methods::robust::cache::{Cloud, Clouds, Motion};

use crate::foot::{Part, Side};
use crate::notice::{Code, Notice};
use crate::plants::methods::{Entry, Family, Found, Task};
use crate::plants::postprocess::{confidence, dragging, short_runs};
use crate::plants::signal::Signal;
use crate::plants::signal::samples::{Ranges, Samples};
use crate::plants::spectral::affinity::Kernel;
use crate::plants::spectral::bandwidth::Scale;
use crate::plants::spectral::cells::Grouped;
use crate::plants::spectral::degree::Among;
use crate::plants::spectral::expansion::Expansion;
use crate::plants::spectral::field::Field;
use crate::plants::spectral::threshold;
use crate::plants::spectral::threshold::{Between, Evidence};
use crate::plants::{Feet, FootLabels, PartLabels, ValidParams};

/// The samples of longer clips are not kept for another detection: those of so many frames take
/// about 20 MB with all that goes with them.
const MOST_KEPT: usize = 50_000;
/// Fewer frames than this are not clustered.
const FEWEST_FRAMES: usize = 10;
/// A foot is still below this speed, in legs per second; a clip stands still if nearly all speeds are ...
const STILL_SPEED: f64 = 0.35;
/// ... and all heights within this, in legs.
const STILL_HEIGHT: f64 = 0.15;
/// Largest ranges that heights and speeds are divided by, in legs and legs per second.
const HEIGHT_CAP: f64 = 0.4;
const SPEED_CAP: f64 = 8.0;
/// Its long tail finds the edges of contact sooner than a Gaussian.
const KERNEL: Kernel = Kernel::Cauchy;
/// Shortest gap and shortest run, in seconds.
const SHORTEST_RUN: f64 = 0.1;
/// Half the window over which confidence is averaged, in seconds.
const CONFIDENCE_WINDOW: f64 = 0.04;

pub(crate) const METHOD: Entry = Entry {
    name: "robust",
    title: "Robust spectral",
    about: "Contact, heel and toe apart; mends glitches first, and reads motion alike at any frame rate.",
    family: Family::Spectral,
    parts: &[Part::Contact, Part::Toe, Part::Heel],
    detect,
};

fn detect(task: &Task) -> Found {
    let &Task { feet, params, kept, .. } = task;
    let before = kept.and_then(Cell::take);
    let mut here = before.unwrap_or_else(|| Kept { motion: Motion::of(feet), clouds: Clouds::default() });
    let Kept { motion, clouds } = &mut here;
    let keeps = kept.is_some() && feet.frame_count() <= MOST_KEPT;
    let found = Work { feet, params, motion, keeps }.detect(clouds);
    if let Some(kept) = kept {
        kept.set(Some(here));
    }
    found
}

/// What the labelling of every part shares.
struct Work<'a> {
    feet: &'a Feet,
    params: ValidParams,
    motion: &'a Motion,
    /// Whether samples are to be kept for another detection.
    keeps: bool,
}

/// Why samples are planted or not, and which are.
type Clustered = (Evidence, Vec<bool>);

/// A clustering, to which the samples of other parts can be compared.
struct Clustering {
    cloud: Cloud,
    anchors: Vec<f64>,
    expansion: OnceCell<Expansion>,
    evidence: Evidence,
    planted: Vec<bool>,
}

impl Work<'_> {
    fn detect(&self, clouds: &mut Clouds) -> Found {
        let mut notices = self.motion.notices.clone();
        let clustering = if self.feet.frame_count() < FEWEST_FRAMES {
            let text = format!("The clip has fewer than {FEWEST_FRAMES} frames: all are taken for contact.");
            notices.push(Notice::new(Code::ShortClip, text));
            None
        } else if self.motion.stands_still {
            let text = "The feet stand still throughout: every frame is contact.";
            notices.push(Notice::new(Code::StandingStill, text));
            None
        } else {
            Some(self.cluster(self.cloud(clouds, Part::Contact, None), KERNEL))
        };
        let is_clustered = clustering.is_some();
        let [contact, toe, heel] = self.clustered(clustering, clouds);
        let mut contact = self.label(Part::Contact, contact);
        if is_clustered {
            notices.extend(self.drop_dragged(&mut contact.feet));
        }
        let mut toe = self.label(Part::Toe, toe);
        let mut heel = self.label(Part::Heel, heel);
        // Toe and heel are planted only where something bears weight.
        for part in [&mut toe, &mut heel] {
            for (foot, contact) in part.feet.iter_mut().zip(&contact.feet) {
                for (planted, contact) in foot.planted.iter_mut().zip(&contact.planted) {
                    *planted &= contact;
                }
            }
        }
        Found { parts: vec![contact, toe, heel], notices }
    }

    /// Which samples of contact, toe and heel are planted, and why; the samples themselves take
    /// most memory and are gone before there are labels, unless they are kept.
    fn clustered(&self, contact: Option<Clustering>, clouds: &mut Clouds) -> [Option<Clustered>; 3] {
        let Some(mut contact) = contact else { return [const { None }; 3] };
        let toes = self.cloud(clouds, Part::Toe, Some(contact.cloud.ranges));
        let toe = compare(&toes, &mut contact, self.params);
        self.keep(clouds, Part::Toe, toes);
        self.keep(clouds, Part::Contact, contact.cloud);
        drop(contact.anchors);
        // An ankle is high over the ground even where its heel is down: it is its own measure.
        let heel = self.cluster(self.cloud(clouds, Part::Heel, None), Kernel::Gaussian);
        self.keep(clouds, Part::Heel, heel.cloud);
        [(contact.evidence, contact.planted), toe, (heel.evidence, heel.planted)].map(Some)
    }

    /// The samples of a part, divided by ranges of its own unless they are given.
    fn cloud(&self, clouds: &mut Clouds, part: Part, ranges: Option<Ranges>) -> Cloud {
        let window = self.params.window();
        clouds.take(part, window).unwrap_or_else(|| {
            let (leg, signals) = (self.feet.leg, &*self.motion.signals(part));
            let Motion { fine_pieces: pieces, stride, .. } = self.motion;
            let ranges = ranges
                .unwrap_or_else(|| Ranges::of(signals, pieces).capped(HEIGHT_CAP * leg, SPEED_CAP * leg));
            let samples = Samples::of(signals, pieces, ranges, window, *stride);
            Cloud::new(Grouped::new(samples, self.keeps), ranges)
        })
    }

    fn keep(&self, clouds: &mut Clouds, part: Part, cloud: Cloud) {
        if self.keeps {
            clouds.put(part, cloud);
        }
    }

    fn cluster(&self, cloud: Cloud, kernel: Kernel) -> Clustering {
        let window = self.params.window();
        let samples = &cloud.samples.samples;
        // A wider window has longer norms: r is stated for w = 1.
        let r = self.params.tolerance() * (2 * window + 1) as f64 / 3.0;
        let scale = Scale::find(cloud.sorted_norms(), r);
        let sigma = self.params.scale().unwrap_or(scale.sigma());
        // Samples near rest count for more, so that a foot held still in the air,
        // dense as its samples are, is not taken for one on the ground.
        let reach = (8.0 * sigma).min(0.5 * ((2 * window + 1) as f64).sqrt());
        let anchors: Vec<f64> = samples.norms.iter().map(|norm| (-(norm / reach).powi(2)).exp()).collect();
        let (pairs, expansion) = (self.params.pairs(), OnceCell::new());
        let among = Among { samples: &cloud.samples, weights: &anchors, sigma, kernel, pairs, expansion };
        let frames = self.motion.pieces.iter().cloned().flatten().collect();
        let (mut evidence, planted) =
            threshold::divide(frames, samples, scale, sigma, among.own(), Between::Medians);
        evidence.field = Some(Field::of(&among, cloud.ranges));
        let expansion = among.expansion;
        Clustering { cloud, anchors, expansion, evidence, planted }
    }

    /// Labels of one part by its clustering; everything is planted where nothing was clustered.
    fn label(&self, part: Part, clustered: Option<Clustered>) -> PartLabels {
        let signals = self.motion.signals(part);
        let labels = |foot: usize| {
            let frames = self.feet.frame_count();
            let (planted, confidence) = match &clustered {
                Some((evidence, planted)) => self.spread(foot, evidence, planted),
                None => (vec![true; frames], vec![1.0; frames]),
            };
            let coarse = |values: &[f64]| {
                values.iter().step_by(self.motion.stride).map(|&value| value as f32).collect()
            };
            let Signal { height, speed } = &signals[foot];
            FootLabels { planted, confidence, height: coarse(height), speed: coarse(speed) }
        };
        PartLabels { part, feet: [labels(0), labels(1)], evidence: clustered.map(|(evidence, _)| evidence) }
    }

    /// Labels and confidence of one foot over all frames of the clip.
    fn spread(&self, foot: usize, evidence: &Evidence, planted: &[bool]) -> (Vec<bool>, Vec<f32>) {
        let count = evidence.frames.len();
        let own = foot * count..(foot + 1) * count;
        let (roots, planted) = (&evidence.roots[own.clone()], &planted[own]);
        // Comparing in frames needs a margin for rates such as 0.0083333.
        let shortest = (SHORTEST_RUN / self.feet.frame_time - 1e-3).ceil() as usize;
        let half = self.feet.frames_in(CONFIDENCE_WINDOW);
        let mut labels = vec![false; self.feet.frame_count()];
        let mut confidence = vec![1.0; labels.len()];
        let mut done = 0;
        for piece in &self.motion.pieces {
            let samples = done..done + piece.len();
            let mut piece_labels = planted[samples.clone()].to_vec();
            short_runs::drop_short_runs(&mut piece_labels, shortest);
            let probability = confidence::planted_probability(&roots[samples.clone()], evidence, half);
            for ((frame, label), p) in piece.clone().zip(piece_labels).zip(probability) {
                labels[frame] = label;
                confidence[frame] = confidence::of_label(label, p);
            }
            done = samples.end;
        }
        self.fill_ends(&mut labels, &mut confidence);
        (labels, confidence)
    }

    /// Takes the contact of dragged feet away, and says so.
    fn drop_dragged(&self, contact: &mut [FootLabels; 2]) -> Vec<Notice> {
        let planted = |foot: &FootLabels| foot.planted.iter().filter(|planted| **planted).count();
        let before = contact.each_ref().map(planted);
        for piece in &self.motion.pieces {
            dragging::drop_dragged(self.feet, piece, contact);
        }
        for labels in &mut *contact {
            self.fill_ends(&mut labels.planted, &mut labels.confidence);
        }
        let dropped = Side::BOTH.into_iter().zip(before.iter().zip(contact.each_ref().map(planted)));
        let notice = |(side, (before, after)): (Side, (&usize, usize))| {
            let seconds = (before - after) as f64 * self.feet.frame_time;
            let text = format!(
                "The {} foot moves away from the other along the ground for {seconds:.1} s: \
                 it is dragged, not planted.",
                side.name()
            );
            (after < *before).then(|| Notice::new(Code::Dragged, text))
        };
        dropped.filter_map(notice).collect()
    }

    /// Frames that were left out are labelled as their nearest neighbour, which nobody can vouch for.
    fn fill_ends(&self, labels: &mut [bool], confidence: &mut [f32]) {
        let (first, last) =
            (self.motion.pieces[0].start, self.motion.pieces[self.motion.pieces.len() - 1].end - 1);
        for frame in (0..first).chain(last + 1..labels.len()) {
            labels[frame] = labels[frame.clamp(first, last)];
            confidence[frame] = 0.5;
        }
    }
}

/// Which samples of a part lie where those of feet that bear weight do.
fn compare(own: &Cloud, clustering: &mut Clustering, params: ValidParams) -> Clustered {
    let expansion = std::mem::take(&mut clustering.expansion);
    let Clustering { cloud, anchors: weights, evidence, .. } = clustering;
    let (samples, sigma, pairs) = (&cloud.samples, evidence.sigma, params.pairs());
    let among = Among { samples, weights, sigma, kernel: KERNEL, pairs, expansion };
    let mut roots = among.of(&own.samples);
    roots.settle(evidence.threshold);
    let planted = roots.values.iter().map(|&root| root > evidence.threshold).collect();
    let evidence = Evidence {
        roots: threshold::single(&roots.values),
        norms: threshold::single(&own.samples.samples.norms),
        frames: evidence.frames.clone(),
        sorted_norms: evidence.sorted_norms.clone(),
        field: evidence.field.clone(),
        ..*evidence
    };
    (evidence, planted)
}
