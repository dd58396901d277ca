//! Force-plate trials at 30 Hz with the noise of video capture.

use std::path::Path;

use anyhow::Context;
use plantigrade::bvh::{self, Channel, Clip};
use plantigrade::foot::Part;
use plantigrade::formats;
use plantigrade::plants::Method;
use plantigrade::score::{self, Tally, Truth};
use plantigrade::skeleton::{Overrides, Skeleton};
use plantigrade_synth::math::Random;
use plantigrade_synth::noise::VideoNoise;
use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::trial::{Accuracies, Trial, default_params, labels};
use crate::report::{Report, percent};

/// Mark of the section in the page.
pub const MARK: &str = "video noise";

/// Frame rate of video, in Hz.
const RATE: f64 = 30.0;

/// Fuzzy period of the accuracy, in seconds.
const FUZZY: f64 = 0.1;

/// Noise is drawn this many times for each trial.
const REPETITIONS: u64 = 10;

/// Levels of the noise, as factors.
const LEVELS: [f64; 3] = [0.0, 0.5, 1.0];

/// Methods of the table, with the part that is scored.
const METHODS: [(Method, Part); 5] = [
    (Method::Robust, Part::Contact),
    (Method::MinSpeed, Part::Contact),
    (Method::Height, Part::Toe),
    (Method::Speed, Part::Toe),
    (Method::HeightSpeed, Part::Toe),
];

/// Activities of the trials: name, and words in the description of a trial.
const ACTIVITIES: [(&str, &[&str]); 4] = [
    ("standing, squatting, sitting", &["stand", "squat", "sit"]),
    ("walking", &["walk"]),
    ("running", &["run", "sprint"]),
    ("jumps", &["jump"]),
];

/// A recorded trial and its truth.
struct Recording {
    name: String,
    activity: &'static str,
    clip: Clip,
    contact: [Truth; 2],
}

/// Adds the section.
pub fn write(report: &mut Report, corpus: &Path) -> anyhow::Result<()> {
    let recordings = super::timing_tables::recorded_paths(&corpus.join("contact"))?
        .iter()
        .map(|path| Recording::read(path))
        .collect::<anyhow::Result<Vec<_>>>()?;
    report.begin_section(MARK);
    report.text("## Noise of video capture");
    report.text(&format!(
        "Accuracy in % at p = 0.1, lenient, of the trials with measured contact, reduced to 30 Hz, with \
         noise as motion from video has it: the root wanders by 2 cm below 0.7 Hz, and joint rotations by \
         1.5° below 1.5 Hz and 0.4° below 6 Hz (root mean square over the three axes together). \
         {REPETITIONS} draws of the noise per trial. The speed above which noise is a step was chosen from three \
         values on generated motion and on these trials of standing, squatting and sitting. Thresholds are the \
         defaults of the program, in metres."
    ));
    let mut rows = Vec::new();
    for level in LEVELS {
        let trials: Vec<(&str, Trial)> = (0..REPETITIONS)
            .into_par_iter()
            .flat_map_iter(|seed| recordings.iter().map(move |recording| (recording, seed)))
            .map(|(recording, seed)| (recording.activity, recording.noisy(level, seed)))
            .collect();
        for (method, part) in METHODS {
            let tallies: Vec<(&str, Tally)> = trials
                .par_iter()
                .map(|(activity, trial)| {
                    let detection = trial.detect(default_params(method));
                    (*activity, trial.tally(Part::Contact, labels(&detection, part), FUZZY))
                })
                .collect();
            let mut row = vec![format!("{level}×"), format!("{} ({})", method.title(), part.name())];
            row.extend(ACTIVITIES.map(|(activity, _)| {
                let of_activity = tallies.iter().filter(|(other, _)| *other == activity);
                percent(Accuracies::from_tallies(of_activity.map(|(_, tally)| *tally)).pooled())
            }));
            rows.push(row);
        }
    }
    let head: Vec<&str> = ["noise", "method"].into_iter().chain(ACTIVITIES.map(|(name, _)| name)).collect();
    report.table(&head, &rows);
    report.end_section(MARK);
    Ok(())
}

/// Returns the trials of each activity with noise of a level, one draw each.
pub(super) fn noisy_trials(corpus: &Path, level: f64) -> anyhow::Result<Vec<(&'static str, Vec<Trial>)>> {
    let recordings = super::timing_tables::recorded_paths(&corpus.join("contact"))?
        .iter()
        .map(|path| Recording::read(path))
        .collect::<anyhow::Result<Vec<_>>>()?;
    let of_activity = |(activity, _): (&'static str, _)| {
        let recordings = recordings.iter().filter(|recording| recording.activity == activity);
        (activity, recordings.map(|recording| recording.noisy(level, 0)).collect())
    };
    Ok(ACTIVITIES.map(of_activity).into())
}

impl Recording {
    fn read(path: &Path) -> anyhow::Result<Recording> {
        #[derive(serde::Deserialize)]
        struct Description {
            activity: String,
        }
        let bytes = std::fs::read(path.with_extension("json"))?;
        let description: Description = serde_json::from_slice(&bytes).context("activity of a trial")?;
        let activity = ACTIVITIES
            .into_iter()
            .find(|(_, words)| words.iter().any(|word| description.activity.contains(word)))
            .with_context(|| format!("unknown activity {:?}", description.activity))?;
        let clip = bvh::parse(&std::fs::read(path)?, bvh::Options::default())?.clip;
        let truth = formats::read_plants(&bytes, clip.frame_count())?;
        let contact = truth.part(Part::Contact).context("labels of contact")?;
        let contact = contact.each_ref().map(|labels| score::mask_near_unknown(labels, clip.frame_time()));
        // The noise depends on the name, not on the folder.
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Recording { name, activity: activity.0, clip, contact })
    }

    /// Returns the trial at 30 Hz with noise.
    fn noisy(&self, level: f64, seed: u64) -> Trial {
        let clip = at_rate(&self.clip, RATE);
        let source = |frame: usize| (frame as f64 / RATE / self.clip.frame_time()).round() as usize;
        let contact = self.contact.each_ref().map(|labels| {
            (0..clip.frame_count()).map(|frame| labels[source(frame).min(labels.len() - 1)]).collect()
        });
        let metres = Skeleton::main(&clip, &Overrides::default()).metres_per_unit;
        let noise = VideoNoise::TYPICAL.scaled(level);
        let clip = noise.apply(&clip, metres, &mut Random::new(seed, &self.name));
        Trial::new(self.name.clone(), &clip, vec![(Part::Contact, contact)])
    }
}

/// Returns a clip at another frame rate. Channels are interpolated linearly, angles the short way
/// round.
fn at_rate(clip: &Clip, rate: f64) -> Clip {
    let channels: Vec<Channel> = clip.joints().iter().flat_map(|joint| joint.channels.clone()).collect();
    let last = clip.frame_count() - 1;
    // The margin is for frame times such as 0.0083333.
    let frames = (last as f64 * clip.frame_time() * rate + 0.01) as usize + 1;
    let row = |frame: usize| {
        let position = (frame as f64 / rate / clip.frame_time()).min(last as f64);
        let (before, fraction) = (position.floor() as usize, position.fract());
        let rows = clip.row(before).iter().zip(clip.row((before + 1).min(last))).zip(&channels);
        let value = move |((from, to), channel): ((&f64, &f64), &Channel)| {
            let difference = match channel {
                Channel::Position(_) | Channel::Scale(_) => to - from,
                Channel::Rotation(_) => to - from - 360.0 * ((to - from) / 360.0).round(),
            };
            from + fraction * difference
        };
        rows.map(value).collect::<Vec<_>>()
    };
    Clip::new(clip.joints().to_vec(), 1.0 / rate, (0..frames).flat_map(row).collect())
        .with_position_rule(clip.position_rule())
}

#[cfg(test)]
mod tests {
    use plantigrade_synth::{generate, samples};

    use super::*;

    #[test]
    fn resampling_preserves_common_frames() {
        let spec = samples(0.0).into_iter().find(|spec| spec.rate == 120).expect("a sample of 120 Hz");
        let clip = generate(&spec, 0).clip;
        let reduced = at_rate(&clip, 30.0);
        assert_eq!(reduced.frame_count(), clip.frame_count().div_ceil(4));
        for frame in 0..reduced.frame_count() {
            let pairs = reduced.row(frame).iter().zip(clip.row(4 * frame));
            assert!(pairs.map(|(a, b)| (a - b).abs()).all(|difference| difference < 0.05), "frame {frame}");
        }
    }
}
