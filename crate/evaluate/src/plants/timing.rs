//! Timing of foot strikes and foot offs: detected events against true ones.

use plantigrade::foot::{Part, Side};
use plantigrade::plants::{Detection, FootLabels};
use plantigrade::score::Truth;

/// Largest distance between a detected event and the true event it belongs to, in seconds.
pub const MAX_DISTANCE: f64 = 0.15;

/// Kind of a gait event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Foot strike: contact begins.
    Strike,
    /// Foot off: contact ends.
    Off,
}

impl Kind {
    /// Both kinds, in order of time within a plant.
    pub const BOTH: [Kind; 2] = [Kind::Strike, Kind::Off];

    /// Returns the name: `foot strike` or `foot off`.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Strike => "foot strike",
            Kind::Off => "foot off",
        }
    }
}

/// A foot strike or a foot off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// The foot.
    pub side: Side,
    /// Strike or off.
    pub kind: Kind,
    /// Time since the first frame, in seconds.
    pub time: f64,
}

/// True events of a clip, and the frames in which the truth is known.
#[derive(Clone, Debug)]
pub struct TrueEvents {
    /// The events.
    pub events: Vec<Event>,
    /// True contact per frame, left foot first. Detected events in unknown frames do not count.
    pub contact: [Truth; 2],
    /// Time between frames, in seconds.
    pub frame_time: f64,
}

impl TrueEvents {
    /// Takes the events from labels: the edges between two known frames.
    pub fn from_labels(contact: [Truth; 2], frame_time: f64) -> TrueEvents {
        let events = Side::BOTH
            .into_iter()
            .flat_map(|side| edges(side, &contact[side as usize], |frame| (frame as f64 - 0.5) * frame_time));
        TrueEvents { events: events.collect(), contact, frame_time }
    }

    /// True if the truth is known in the frames next to `event`.
    fn is_known_at(&self, event: &Event) -> bool {
        let contact = &self.contact[event.side as usize];
        let frame = event.time / self.frame_time;
        // An event on a frame has that frame on both sides.
        [(frame + 1e-6).floor(), (frame - 1e-6).ceil()]
            .into_iter()
            .all(|frame| frame >= 0.0 && contact.get(frame as usize).is_some_and(Option::is_some))
    }
}

/// Returns the events of the labels of one part.
pub fn detected_events(detection: &Detection, part: Part, frame_time: f64) -> Vec<Event> {
    let labels = detection.part(part).expect("the method labels that part");
    Side::BOTH.into_iter().flat_map(|side| foot_events(side, labels.foot(side), frame_time)).collect()
}

/// Returns the events of the labels of one foot. All times of detected events come from here.
fn foot_events(side: Side, labels: &FootLabels, frame_time: f64) -> Vec<Event> {
    let known: Truth = labels.planted.iter().map(|&planted| Some(planted)).collect();
    edges(side, &known, |frame| labels.boundary_time(frame, frame_time))
}

/// Returns the edges between two known frames; `time` is that of the boundary before a frame.
fn edges(side: Side, labels: &[Option<bool>], time: impl Fn(usize) -> f64) -> Vec<Event> {
    let edge = |(index, pair): (usize, &[Option<bool>])| {
        let kind = match pair {
            [Some(false), Some(true)] => Kind::Strike,
            [Some(true), Some(false)] => Kind::Off,
            _ => return None,
        };
        Some(Event { side, kind, time: time(index + 1) })
    };
    labels.windows(2).enumerate().filter_map(edge).collect()
}

/// Timing of the detected events of one kind.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Timing {
    /// Errors of the detected events nearest to true ones: detected minus true, in milliseconds.
    pub errors: Vec<f64>,
    /// True events without a detected one within 150 ms.
    pub missed: usize,
    /// Detected events in known frames without a true one within 150 ms.
    pub false_events: usize,
}

impl Timing {
    /// Compares the events of one kind in one clip.
    pub fn compare(kind: Kind, detected: &[Event], truth: &TrueEvents) -> Timing {
        let nearest = |event: &Event, others: &[Event]| {
            others
                .iter()
                .filter(|other| other.side == event.side && other.kind == kind)
                .map(|other| other.time - event.time)
                .min_by(|a, b| a.abs().total_cmp(&b.abs()))
                .filter(|distance| distance.abs() <= MAX_DISTANCE + 1e-9)
        };
        let mut timing = Timing::default();
        for event in truth.events.iter().filter(|event| event.kind == kind) {
            match nearest(event, detected) {
                Some(error) => timing.errors.push(1e3 * error),
                None => timing.missed += 1,
            }
        }
        timing.false_events = detected
            .iter()
            .filter(|event| event.kind == kind && truth.is_known_at(event))
            .filter(|event| nearest(event, &truth.events).is_none())
            .count();
        timing
    }

    /// Pools the timing of several clips.
    pub fn pool(timings: impl IntoIterator<Item = Timing>) -> Timing {
        timings.into_iter().fold(Timing::default(), |mut pooled, timing| {
            pooled.errors.extend(timing.errors);
            pooled.missed += timing.missed;
            pooled.false_events += timing.false_events;
            pooled
        })
    }

    /// Number of true events.
    pub fn total(&self) -> usize {
        self.errors.len() + self.missed
    }

    /// Median error, in milliseconds.
    pub fn median(&self) -> f64 {
        let mut sorted = self.errors.clone();
        sorted.sort_by(f64::total_cmp);
        let middle = sorted.len() / 2;
        match sorted.len() {
            0 => f64::NAN,
            count if count % 2 == 0 => (sorted[middle - 1] + sorted[middle]) / 2.0,
            _ => sorted[middle],
        }
    }

    /// Mean absolute error, in milliseconds.
    pub fn mean_absolute(&self) -> f64 {
        self.errors.iter().map(|error| error.abs()).sum::<f64>() / self.errors.len() as f64
    }

    /// Sample standard deviation of the errors (n − 1), in milliseconds.
    pub fn standard_deviation(&self) -> f64 {
        let count = self.errors.len() as f64;
        if count < 2.0 {
            return f64::NAN;
        }
        let mean = self.errors.iter().sum::<f64>() / count;
        let squares: f64 = self.errors.iter().map(|error| (error - mean).powi(2)).sum();
        (squares / (count - 1.0)).sqrt()
    }

    /// Percentage of the true events with a detected one within `max` milliseconds; missed events
    /// are not.
    pub fn within(&self, max: f64) -> f64 {
        let near = self.errors.iter().filter(|error| error.abs() <= max + 1e-6).count();
        100.0 * near as f64 / self.total() as f64
    }

    /// Cells of a table whose head is [`Timing::HEAD`], without the first.
    pub fn cells(&self) -> Vec<String> {
        let number = |value: f64, text: String| if value.is_finite() { text } else { "–".into() };
        let (median, mean, deviation) = (self.median(), self.mean_absolute(), self.standard_deviation());
        vec![
            number(median, format!("{median:+.1}")),
            number(mean, format!("{mean:.1}")),
            number(deviation, format!("{deviation:.1}")),
            number(self.within(10.0), format!("{:.0}", self.within(10.0))),
            number(self.within(20.0), format!("{:.0}", self.within(20.0))),
            self.missed.to_string(),
            self.false_events.to_string(),
        ]
    }

    /// Names of the columns after the first.
    pub const HEAD: [&'static str; 7] =
        ["median ms", "MAE ms", "SD ms", "within 10 ms in %", "within 20 ms in %", "missed", "false"];
}

#[cfg(test)]
mod tests {
    use super::*;

    fn truth(text: &str) -> TrueEvents {
        let labels: Truth = text.chars().map(|c| (c != '?').then_some(c == '#')).collect();
        let unknown = vec![None; labels.len()];
        TrueEvents::from_labels([labels, unknown], 0.01)
    }

    fn strike(time: f64) -> Event {
        Event { side: Side::Left, kind: Kind::Strike, time }
    }

    fn times(events: &[Event]) -> Vec<(Kind, f64)> {
        events.iter().map(|event| (event.kind, (event.time * 1e4).round() / 1e4)).collect()
    }

    #[test]
    fn events_lie_between_known_frames() {
        let truth = truth("..###..#?##.");
        let expected = [(Kind::Strike, 0.015), (Kind::Off, 0.045), (Kind::Strike, 0.065), (Kind::Off, 0.105)];
        assert_eq!(times(&truth.events), expected);
    }

    #[test]
    fn an_event_without_a_detected_one_nearby_is_missed() {
        let truth = truth(&format!("{}{}", ".".repeat(50), "#".repeat(50)));
        let timing = Timing::compare(Kind::Strike, &[strike(0.64)], &truth);
        assert_eq!((timing.errors.len(), timing.missed, timing.total()), (1, 0, 1));
        let timing = Timing::compare(Kind::Strike, &[strike(0.66)], &truth);
        assert_eq!((timing.errors.len(), timing.missed, timing.false_events), (0, 1, 1));
        // The other foot and the other kind do not count.
        let others = [Event { side: Side::Right, ..strike(0.5) }, Event { kind: Kind::Off, ..strike(0.5) }];
        assert_eq!(Timing::compare(Kind::Strike, &others, &truth).missed, 1);
    }

    #[test]
    fn detected_events_are_false_only_where_the_truth_is_known() {
        let truth = truth(&format!("{}{}{}", ".".repeat(40), "#".repeat(40), "?".repeat(40)));
        let at = |time| Timing::compare(Kind::Strike, &[strike(0.4), strike(time)], &truth).false_events;
        assert_eq!((at(0.1), at(0.3), at(0.7), at(0.79), at(0.795), at(1.0)), (1, 0, 1, 1, 0, 0));
    }

    #[test]
    fn errors_are_summarised() {
        let timing = Timing { errors: vec![30.0, -10.0, 0.0, 20.0], missed: 1, false_events: 2 };
        assert_eq!((timing.median(), timing.mean_absolute()), (10.0, 15.0));
        assert!((timing.standard_deviation() - 18.257).abs() < 1e-3);
        assert_eq!((timing.within(10.0), timing.within(20.0)), (40.0, 60.0));
        assert_eq!(Timing { errors: vec![5.0, 7.0, -90.0], ..timing.clone() }.median(), 5.0);
        let pooled = Timing::pool([timing.clone(), timing]);
        assert_eq!((pooled.total(), pooled.missed, pooled.false_events), (10, 2, 4));
        assert_eq!(Timing::default().cells()[0], "–");
    }
}
