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

use std::ops::Range;

use super::{Entry, Family, Found, Task};
use crate::labels::{Part, Side};
use crate::motion::Track;
use crate::notice::{Code, Notice};
use crate::plants::cluster::{self, Between, Evidence};
use crate::plants::degree::Kernel;
use crate::plants::field::Field;
use crate::plants::refine::{self, Refined};
use crate::plants::roots::Among;
use crate::plants::samples::{Ranges, Samples};
use crate::plants::scale::Scale;
use crate::plants::signal::{self, Signal, Signals};
use crate::plants::{Feet, FootLabels, FootTracks, PartLabels, ValidParams, clean, confidence, drag, trim};

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

pub(super) const METHOD: Entry = Entry {
    name: "robust",
    title: "Robust spectral",
    about: "Contact, heel and toe apart; mends glitches first, and reads motion alike at any frame rate.",
    family: Family::Spectral,
    parts: &[Part::Contact, Part::Toe, Part::Heel],
    detect,
};

fn detect(task: &Task) -> Found {
    let &Task { feet, params, .. } = task;
    let pieces = trim::pieces(feet);
    let mut notices = trim_notices(feet, &pieces);
    let refined = refine::refined(feet, &pieces);
    let effector = |track: fn(&FootTracks) -> &Track| {
        signal::smooth(&refined.feet, &refined.pieces, |foot| track(&refined.feet.tracks[foot]).clone())
    };
    let ankle = effector(|foot| &foot.ankle);
    let toe = effector(|foot| &foot.toe);
    let sole = signal::bearing(&ankle, &toe, STILL_SPEED * feet.leg);

    let work = Work { feet, pieces: &pieces, refined: &refined, params };
    let clustering = if feet.frame_count() < FEWEST_FRAMES {
        let text = format!("The clip has fewer than {FEWEST_FRAMES} frames: all are taken for contact.");
        notices.push(Notice::new(Code::ShortClip, text));
        None
    } else if work.stands_still(&sole) {
        let text = "The feet stand still throughout: every frame is contact.";
        notices.push(Notice::new(Code::StandingStill, text));
        None
    } else {
        Some(work.cluster(&sole, KERNEL))
    };
    let mut contact = work.label(Part::Contact, &sole, clustering.as_ref());
    if clustering.is_some() {
        notices.extend(work.drop_dragged(&mut contact.feet));
    }
    // Toe and heel are planted only where something bears weight.
    let within = |mut part: PartLabels| {
        for (foot, contact) in part.feet.iter_mut().zip(&contact.feet) {
            for (planted, contact) in foot.planted.iter_mut().zip(&contact.planted) {
                *planted &= contact;
            }
        }
        part
    };
    let toe = within(work.label(Part::Toe, &toe, clustering.as_ref()));
    // An ankle is high over the ground even where its heel is down: it is its own measure.
    let own = clustering.as_ref().map(|_| work.cluster(&ankle, Kernel::Gaussian));
    let heel = within(work.label(Part::Heel, &ankle, own.as_ref()));
    Found { parts: vec![contact, toe, heel], notices }
}

fn trim_notices(feet: &Feet, pieces: &[Range<usize>]) -> Vec<Notice> {
    let mut notices = Vec::new();
    let (first, end) = (pieces[0].start, pieces[pieces.len() - 1].end);
    let after = feet.frame_count() - end;
    if first + after > 0 {
        let text = format!(
            "{first} frames at the start and {after} at the end jump as poses that were stuck on do: \
             they have their neighbours' labels."
        );
        notices.push(Notice::new(Code::Trimmed, text));
    }
    for piece in &pieces[1..] {
        let text = format!("Both feet jump at frame {}: the motion is taken for two.", piece.start);
        notices.push(Notice::new(Code::Teleport, text));
    }
    notices
}

/// What the labelling of every part shares.
struct Work<'a> {
    feet: &'a Feet,
    pieces: &'a [Range<usize>],
    refined: &'a Refined,
    params: ValidParams,
}

/// A clustering, to which the samples of other parts can be compared.
struct Clustering {
    samples: Samples,
    ranges: Ranges,
    anchors: Vec<f64>,
    evidence: Evidence,
    planted: Vec<bool>,
}

impl Work<'_> {
    fn stands_still(&self, signals: &Signals) -> bool {
        let pieces = &self.refined.pieces;
        let speeds = signal::kept(signals, pieces, |signal| &signal.speed).collect();
        let (lowest, highest) = signal::extremes(signal::kept(signals, pieces, |signal| &signal.height));
        let leg = self.feet.leg;
        percentile(speeds, 0.99) < STILL_SPEED * leg && highest - lowest < STILL_HEIGHT * leg
    }

    fn cluster(&self, signals: &Signals, kernel: Kernel) -> Clustering {
        let leg = self.feet.leg;
        let window = self.params.window();
        let ranges = Ranges::of(signals, &self.refined.pieces).capped(HEIGHT_CAP * leg, SPEED_CAP * leg);
        let samples = self.samples(signals, ranges);
        // A wider window has longer norms: r is stated for w = 1.
        let r = self.params.tolerance() * (2 * window + 1) as f64 / 3.0;
        let scale = Scale::find(&samples.norms, r);
        let sigma = self.params.scale().unwrap_or(scale.sigma());
        // Samples near rest count for more, so that a foot held still in the air,
        // dense as its samples are, is not taken for one on the ground.
        let reach = (8.0 * sigma).min(0.5 * ((2 * window + 1) as f64).sqrt());
        let anchors: Vec<f64> = samples.norms.iter().map(|norm| (-(norm / reach).powi(2)).exp()).collect();
        let pairs = self.params.pairs();
        let among = Among { samples: &samples, weights: &anchors, sigma, kernel, pairs };
        let frames = self.pieces.iter().cloned().flatten().collect();
        let (mut evidence, planted) =
            cluster::divide(frames, &samples, scale, sigma, among.own(), Between::Medians);
        evidence.field = Some(Field::of(among, ranges));
        Clustering { samples, ranges, anchors, evidence, planted }
    }

    fn samples(&self, signals: &Signals, ranges: Ranges) -> Samples {
        let Refined { pieces, stride, .. } = self.refined;
        Samples::of(signals, pieces, ranges, self.params.window(), *stride)
    }

    /// Labels of one part; everything is planted where nothing was clustered.
    fn label(&self, part: Part, signals: &Signals, clustering: Option<&Clustering>) -> PartLabels {
        let compared = clustering.map(|clustering| match part {
            Part::Contact | Part::Heel => (clustering.evidence.clone(), clustering.planted.clone()),
            Part::Toe => self.compare(signals, clustering),
        });
        let labels = |foot: usize| {
            let frames = self.feet.frame_count();
            let (planted, confidence) = match &compared {
                Some((evidence, planted)) => self.spread(foot, evidence, planted),
                None => (vec![true; frames], vec![1.0; frames]),
            };
            let coarse = |values: &[f64]| values.iter().copied().step_by(self.refined.stride).collect();
            let Signal { height, speed } = &signals[foot];
            FootLabels { planted, confidence, height: coarse(height), speed: coarse(speed) }
        };
        PartLabels { part, feet: [labels(0), labels(1)], evidence: compared.map(|(evidence, _)| evidence) }
    }

    /// Which samples of a part lie where those of feet that bear weight do.
    fn compare(&self, signals: &Signals, clustering: &Clustering) -> (Evidence, Vec<bool>) {
        let Clustering { samples, ranges, anchors, evidence, .. } = clustering;
        let own = self.samples(signals, *ranges);
        let (sigma, pairs) = (evidence.sigma, self.params.pairs());
        let mut roots = Among { samples, weights: anchors, sigma, kernel: KERNEL, pairs }.of(&own);
        roots.settle(evidence.threshold);
        let values = roots.values;
        let planted = values.iter().map(|&root| root > evidence.threshold).collect();
        (Evidence { roots: values, norms: own.norms, ..evidence.clone() }, planted)
    }

    /// Labels and confidence of one foot over all frames of the clip.
    fn spread(&self, foot: usize, evidence: &Evidence, planted: &[bool]) -> (Vec<bool>, Vec<f64>) {
        let count = evidence.frames.len();
        let own = foot * count..(foot + 1) * count;
        let (roots, planted) = (&evidence.roots[own.clone()], &planted[own]);
        // Comparing in frames needs a margin for rates such as 0.0083333.
        let shortest = (SHORTEST_RUN / self.feet.frame_time - 1e-3).ceil() as usize;
        let half = self.feet.frames_in(CONFIDENCE_WINDOW);
        let mut labels = vec![false; self.feet.frame_count()];
        let mut confidence = vec![1.0; labels.len()];
        let mut done = 0;
        for piece in self.pieces {
            let samples = done..done + piece.len();
            let mut piece_labels = planted[samples.clone()].to_vec();
            clean::drop_short_runs(&mut piece_labels, shortest);
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
        for piece in self.pieces {
            drag::drop_dragged(self.feet, piece, contact);
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
    fn fill_ends(&self, labels: &mut [bool], confidence: &mut [f64]) {
        let (first, last) = (self.pieces[0].start, self.pieces[self.pieces.len() - 1].end - 1);
        for frame in (0..first).chain(last + 1..labels.len()) {
            labels[frame] = labels[frame.clamp(first, last)];
            confidence[frame] = 0.5;
        }
    }
}

/// The value below which `share` of the values lie, interpolated.
fn percentile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let place = share * values.len().saturating_sub(1) as f64;
    let (below, above) = (place.floor() as usize, place.ceil() as usize);
    match (values.get(below), values.get(above)) {
        (Some(low), Some(high)) => low + (high - low) * place.fract(),
        _ => 0.0,
    }
}
