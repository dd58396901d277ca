//! What a clip's detection does not find anew each time: what depends on no parameter, and what
//! depends on the window alone.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::ops::Range;
use std::sync::Arc;

use crate::foot::Part;
use crate::notice::{Code, Notice};
use crate::plants::methods::robust::{STILL_HEIGHT, STILL_SPEED};
use crate::plants::signal::resampling::Refined;
use crate::plants::signal::samples::Ranges;
use crate::plants::signal::{Signals, motion_segments};
use crate::plants::spectral::bandwidth;
use crate::plants::spectral::cells::Grouped;
use crate::plants::{Feet, signal};

/// A clip's motion and its samples.
pub(crate) struct Kept {
    pub(crate) motion: Motion,
    pub(crate) clouds: Clouds,
}

/// Signals of the feet, piece by piece.
pub(crate) struct Motion {
    /// The runs of the clip's frames that are one motion each.
    pub pieces: Vec<Range<usize>>,
    /// The same runs in the signals, which have `stride` places for each frame.
    pub fine_pieces: Vec<Range<usize>>,
    pub stride: usize,
    pub ankle: Signals,
    pub toe: Signals,
    /// Whether the toe bears weight, by foot and frame: else the ankle does.
    is_toe: [Vec<bool>; 2],
    pub stands_still: bool,
    /// What was left out.
    pub notices: Vec<Notice>,
}

impl Motion {
    pub fn of(feet: &Feet) -> Motion {
        let pieces = motion_segments::pieces(feet);
        let refined = Refined::of(feet, &pieces);
        let ankle = signal::smooth(feet, &refined, |foot| &foot.ankle);
        let toe = signal::smooth(feet, &refined, |foot| &foot.toe);
        let is_toe = signal::bearing(&ankle, &toe, STILL_SPEED * feet.leg);
        let Refined { pieces: fine_pieces, stride, .. } = refined;
        let notices = trim_notices(feet, &pieces);
        let mut motion =
            Motion { pieces, fine_pieces, stride, ankle, toe, is_toe, stands_still: false, notices };
        motion.stands_still = stands_still(&motion.sole(), &motion.fine_pieces, feet.leg);
        motion
    }

    /// The signals that a part is labelled by; those of contact are put together when asked for.
    pub fn signals(&self, part: Part) -> Cow<'_, Signals> {
        match part {
            Part::Contact => Cow::Owned(self.sole()),
            Part::Toe => Cow::Borrowed(&self.toe),
            Part::Heel => Cow::Borrowed(&self.ankle),
        }
    }

    /// Those of what bears weight.
    fn sole(&self) -> Signals {
        signal::either(&self.ankle, &self.toe, &self.is_toe)
    }
}

/// The samples of one part.
pub(crate) struct Cloud {
    /// What their heights and speeds were divided by.
    pub ranges: Ranges,
    pub samples: Grouped,
    sorted_norms: OnceCell<Arc<[f64]>>,
}

impl Cloud {
    pub fn new(samples: Grouped, ranges: Ranges) -> Cloud {
        Cloud { ranges, samples, sorted_norms: OnceCell::new() }
    }

    /// The samples' norms, in order.
    pub fn sorted_norms(&self) -> Arc<[f64]> {
        self.sorted_norms.get_or_init(|| bandwidth::sorted(&self.samples.samples.norms)).clone()
    }
}

/// The samples of the parts for the window that was asked for last.
#[derive(Default)]
pub(crate) struct Clouds {
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

    /// Keeps the samples of a part.
    pub fn put(&mut self, part: Part, cloud: Cloud) {
        self.by_part[part as usize] = Some(cloud);
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
    if values.is_empty() {
        return 0.0;
    }
    let place = share * (values.len() - 1) as f64;
    let (_, &mut low, above) = values.select_nth_unstable_by(place as usize, f64::total_cmp);
    let high = above.iter().copied().fold(f64::INFINITY, f64::min);
    if place.fract() > 0.0 { low + (high - low) * place.fract() } else { low }
}
