//! What a clip's detection does not find anew each time: what depends on no parameter, and what
//! depends on the window alone.

use std::cell::OnceCell;
use std::ops::Range;

use super::{STILL_HEIGHT, STILL_SPEED};
use crate::labels::Part;
use crate::notice::{Code, Notice};
use crate::plants::cells::Grouped;
use crate::plants::refine::{self, Refined};
use crate::plants::samples::Ranges;
use crate::plants::scale::Norms;
use crate::plants::signal::{self, Signals};
use crate::plants::{Feet, trim};

/// Most coordinates of the samples of one part that are kept: those of 10,000 frames at w = 3 ...
/// at w = 1 of 23,000, with all else that goes with them about 20 MB.
const MOST_COORDINATES: usize = 280_000;

/// A clip's motion and its samples.
pub(in crate::plants) struct Kept {
    pub(super) motion: Motion,
    pub(super) clouds: Clouds,
}

/// Signals of the feet, piece by piece.
pub(super) struct Motion {
    /// The runs of the clip's frames that are one motion each.
    pub pieces: Vec<Range<usize>>,
    /// The same runs in the signals, which have `stride` places for each frame.
    pub fine_pieces: Vec<Range<usize>>,
    pub stride: usize,
    pub ankle: Signals,
    pub toe: Signals,
    /// Of what bears weight.
    pub sole: Signals,
    pub stands_still: bool,
    /// What was left out.
    pub notices: Vec<Notice>,
}

impl Motion {
    pub fn of(feet: &Feet) -> Motion {
        let pieces = trim::pieces(feet);
        let Refined { feet: fine, pieces: fine_pieces, stride } = refine::refined(feet, &pieces);
        let ankle = signal::smooth(&fine, &fine_pieces, |foot| &foot.ankle);
        let toe = signal::smooth(&fine, &fine_pieces, |foot| &foot.toe);
        let sole = signal::bearing(&ankle, &toe, STILL_SPEED * feet.leg);
        Motion {
            stands_still: stands_still(&sole, &fine_pieces, feet.leg),
            notices: trim_notices(feet, &pieces),
            pieces,
            fine_pieces,
            stride,
            ankle,
            toe,
            sole,
        }
    }

    /// The signals that a part is labelled by.
    pub fn signals(&self, part: Part) -> &Signals {
        match part {
            Part::Contact => &self.sole,
            Part::Toe => &self.toe,
            Part::Heel => &self.ankle,
        }
    }
}

/// The samples of one part.
pub(super) struct Cloud {
    /// What their heights and speeds were divided by.
    pub ranges: Ranges,
    pub samples: Grouped,
    norms: OnceCell<Norms>,
}

impl Cloud {
    pub fn new(samples: Grouped, ranges: Ranges) -> Cloud {
        Cloud { ranges, samples, norms: OnceCell::new() }
    }

    /// The samples' norms, in order.
    pub fn norms(&self) -> &Norms {
        self.norms.get_or_init(|| Norms::of(&self.samples.samples.norms))
    }
}

/// The samples of the parts for the window that was asked for last.
#[derive(Default)]
pub(super) struct Clouds {
    window: usize,
    by_part: [Option<Cloud>; Part::ALL.len()],
}

impl Clouds {
    /// The samples of a part, if they were kept.
    pub fn take(&mut self, part: Part, window: usize) -> Option<Cloud> {
        if window != self.window {
            *self = Clouds { window, ..Clouds::default() };
        }
        self.by_part[part as usize].take()
    }

    /// Keeps the samples of a part, unless they are too many.
    pub fn put(&mut self, part: Part, cloud: Cloud) {
        if cloud.samples.samples.points.len() <= MOST_COORDINATES {
            self.by_part[part as usize] = Some(cloud);
        }
    }
}

/// Whether nearly all speeds and all heights are those of feet that stand.
fn stands_still(signals: &Signals, pieces: &[Range<usize>], leg: f64) -> bool {
    let speeds = signal::kept(signals, pieces, |signal| &signal.speed).collect();
    let (lowest, highest) = signal::extremes(signal::kept(signals, pieces, |signal| &signal.height));
    percentile(speeds, 0.99) < STILL_SPEED * leg && highest - lowest < STILL_HEIGHT * leg
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
