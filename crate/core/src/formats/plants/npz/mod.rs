//! Plants as a NumPy archive (`.npz`) with named columns.
//!
//! The writer stores the arrays without compression, which needs a checksum only; the browser
//! compresses downloads anyway. The reader accepts archives with or without compression, as
//! `numpy.savez` and `numpy.savez_compressed` write them.

mod read;

#[cfg(test)]
mod tests;

use crate::foot::{Part, Side};
use crate::formats::format_info::FormatInfo;
use crate::formats::plants::events::{GaitEvent, events, part_events};
use crate::formats::plants::export::{DetectionRef, Reader, Writer};
use crate::formats::{npy, zip};
use crate::plants::{Detection, FootLabels};

pub(super) const FORMAT_INFO: FormatInfo<Writer, Reader> = FormatInfo {
    name: "npz",
    title: "Arrays",
    description: "Arrays for NumPy with named columns, and the confidence.",
    extension: "contacts.npz",
    media_type: "application/zip",
    write: |export| npz(&export.labelled(), &export.source.name, export.clip.frame_time()),
    read: Some(Reader { recognises: read::is_archive, read: read::read }),
};

/// Columns of `contacts` for parts with labels.
const CONTACTS_COLUMNS: [(Side, Part); 4] =
    [(Side::Left, Part::Heel), (Side::Left, Part::Toe), (Side::Right, Part::Heel), (Side::Right, Part::Toe)];

/// Columns of `contact`.
const CONTACT_COLUMNS: [(Side, Part); 2] = [(Side::Left, Part::Contact), (Side::Right, Part::Contact)];

/// Files of events: names, times, uncertainties, roots.
const EVENT_FILES: [&str; 4] = ["event.npy", "event_time.npy", "event_uncertainty.npy", "event_root.npy"];

/// Files of events of heel and toe, likewise.
const PART_EVENT_FILES: [&str; 4] =
    ["part_event.npy", "part_event_time.npy", "part_event_uncertainty.npy", "part_event_root.npy"];

/// Returns an archive of arrays for a clip of F frames named `source`.
///
/// | array | shape and type | content |
/// |---|---|---|
/// | `contacts` | (F, 4) bool | true while left heel, left toe, right heel and right toe are planted |
/// | `columns` | (4) text | names of these columns: `left_heel`, ... |
/// | `confidence` | (F, 4) float32 | probability that the label is right, from 0.5 to 1 |
/// | `contact` | (F, 2) bool | true while any part of the left and the right foot bears on the ground |
/// | `contact_columns` | (2) text | `left_contact`, `right_contact` |
/// | `event` | (E) text | foot strikes and foot offs in order of time: `left_strike`, `left_off`, ... |
/// | `event_time` | (E) float64 | time of each event, in seconds |
/// | `event_uncertainty` | (E) float64 | standard deviation of the error of each time, in seconds; NaN if the event is known to the frame only |
/// | `part_event` | (P) text | these events and those of heel and toe: `left_heel_strike`, `left_toe_strike`, `left_foot_flat`, `left_heel_off`, `left_toe_off`, ... |
/// | `part_event_time`, `part_event_uncertainty` | (P) float64 | times and uncertainties of these events, likewise |
/// | `time` | (F) float64 | time from the start of the clip, in seconds |
/// | `rate` | () float64 | frame rate, in Hz |
/// | `source` | () text | file name of the clip |
///
/// Parts without labels have no columns; the names list the columns that exist. With R skeletons the
/// arrays of labels and confidence have a first axis of length R, as in (R, F, 4), `roots` (R) has the
/// names of the root joints, and `event_root` (E) and `part_event_root` (P) have that of each event.
///
/// # Panics
/// If the archive would exceed 4 GiB.
fn npz(labelled: &[DetectionRef], source: &str, frame_time: f64) -> Vec<u8> {
    let Some(first) = labelled.first() else { return zip::store(&[]) };
    let frames = first.detection.principal().feet[0].planted.len();
    let roots: Vec<&str> = labelled.iter().filter_map(|labelled| labelled.root).collect();
    let existing = |columns: &[(Side, Part)]| -> Vec<(Side, Part)> {
        columns.iter().copied().filter(|&(_, part)| first.detection.part(part).is_some()).collect()
    };
    let [columns, contact] = [existing(&CONTACTS_COLUMNS), existing(&CONTACT_COLUMNS)];
    let shape = |columns: &[(Side, Part)]| {
        let skeletons = (!roots.is_empty()).then_some(labelled.len());
        skeletons.into_iter().chain([frames, columns.len()]).collect::<Vec<_>>()
    };
    let booleans = |columns: &[(Side, Part)]| {
        let values = column_values(labelled, frames, columns, |foot, frame| [u8::from(foot.planted[frame])]);
        npy::write("|b1", &shape(columns), &values)
    };
    let names = |columns: &[(Side, Part)]| {
        let names: Vec<String> =
            columns.iter().map(|(side, part)| format!("{}_{}", side.name(), part.name())).collect();
        npy::texts(&[names.len()], &names.iter().map(String::as_str).collect::<Vec<_>>())
    };
    let confidence =
        column_values(labelled, frames, &columns, |foot, frame| foot.confidence[frame].to_le_bytes());
    let time: Vec<u8> = (0..frames).flat_map(|frame| (frame as f64 * frame_time).to_le_bytes()).collect();
    let mut files = vec![
        ("contacts.npy", booleans(&columns)),
        ("columns.npy", names(&columns)),
        ("confidence.npy", npy::write("<f4", &shape(&columns), &confidence)),
        ("contact.npy", booleans(&contact)),
        ("contact_columns.npy", names(&contact)),
        ("time.npy", npy::write("<f8", &[frames], &time)),
        ("rate.npy", npy::write("<f8", &[], &(1.0 / frame_time).to_le_bytes())),
        ("source.npy", npy::texts(&[], &[source])),
    ];
    files.extend(event_arrays(EVENT_FILES, labelled, frame_time, |detection, _| events(detection)));
    files.extend(event_arrays(PART_EVENT_FILES, labelled, frame_time, part_events));
    if !roots.is_empty() {
        files.push(("roots.npy", npy::texts(&[roots.len()], &roots)));
    }
    zip::store(&files)
}

/// Returns the arrays of the events that `events_of` returns for each skeleton; `files` are the names for
/// events, times, uncertainties and roots.
fn event_arrays(
    files: [&'static str; 4],
    labelled: &[DetectionRef],
    frame_time: f64,
    events_of: fn(&Detection, f64) -> Vec<GaitEvent>,
) -> Vec<(&'static str, Vec<u8>)> {
    let events: Vec<(Option<&str>, GaitEvent)> = labelled
        .iter()
        .flat_map(|DetectionRef { root, detection }| {
            events_of(detection, frame_time).into_iter().map(|event| (*root, event))
        })
        .collect();
    let names: Vec<String> =
        events.iter().map(|(_, event)| format!("{}_{}", event.side.name(), event.kind.name())).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let floats = |value: &dyn Fn(&GaitEvent) -> f64| {
        let values: Vec<u8> = events.iter().flat_map(|(_, event)| value(event).to_le_bytes()).collect();
        npy::write("<f8", &[events.len()], &values)
    };
    let uncertainty =
        |event: &GaitEvent| event.instant.map_or(f64::NAN, |instant| instant.uncertainty_ms / 1e3);
    let mut arrays = vec![
        (files[0], npy::texts(&[names.len()], &names)),
        (files[1], floats(&|event| event.time(frame_time))),
        (files[2], floats(&uncertainty)),
    ];
    let roots: Vec<&str> = events.iter().filter_map(|(root, _)| *root).collect();
    if labelled.iter().any(|labelled| labelled.root.is_some()) {
        arrays.push((files[3], npy::texts(&[roots.len()], &roots)));
    }
    arrays
}

/// Returns a value per skeleton, frame and column, in this order.
fn column_values<const N: usize>(
    labelled: &[DetectionRef],
    frames: usize,
    columns: &[(Side, Part)],
    value: impl Fn(&FootLabels, usize) -> [u8; N],
) -> Vec<u8> {
    let mut values = Vec::with_capacity(labelled.len() * frames * columns.len() * N);
    for DetectionRef { detection, .. } in labelled {
        let feet: Vec<_> =
            columns.iter().filter_map(|&(side, part)| Some(detection.part(part)?.foot(side))).collect();
        values.extend(
            (0..frames)
                .flat_map(|frame| feet.iter().map(move |foot| (foot, frame)))
                .flat_map(|(foot, frame)| value(foot, frame)),
        );
    }
    values
}
