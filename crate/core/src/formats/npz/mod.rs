//! Labels as arrays with named columns, for NumPy: `.npz`.
//!
//! The archive is written without compression by a few lines of our own: that needs a checksum
//! alone, and labels that are packed again in a browser's download gain nothing. It is read with
//! or without, as `numpy.savez` and `numpy.savez_compressed` write it.

mod npy;
mod read;
mod zip;

#[cfg(test)]
mod tests;

pub(crate) use read::{is_archive, read};

use crate::foot::{Part, Side};
use crate::formats::Labelled;

/// The columns of `contacts` in order, as far as the method labels them.
const COLUMNS: [(Side, Part); 4] =
    [(Side::Left, Part::Heel), (Side::Left, Part::Toe), (Side::Right, Part::Heel), (Side::Right, Part::Toe)];

/// The columns of `contact`.
const CONTACT: [(Side, Part); 2] = [(Side::Left, Part::Contact), (Side::Right, Part::Contact)];

/// Labels as an archive of arrays, for a clip of F frames called `source`.
///
/// | array | shape and type | what |
/// |---|---|---|
/// | `contacts` | (F, 4) bool | whether left heel, left toe, right heel and right toe are planted |
/// | `columns` | (4) text | the names of these columns: `left_heel`, ... |
/// | `confidence` | (F, 4) float32 | probability that the label is right, from 0.5 to 1 |
/// | `contact` | (F, 2) bool | whether any part of the left and the right sole carries weight |
/// | `contact_columns` | (2) text | `left_contact`, `right_contact` |
/// | `time` | (F) float64 | seconds from the clip's start |
/// | `rate` | () float64 | frames per second |
/// | `source` | () text | the clip's file name |
///
/// A part that the method does not label has no columns; the names always say which there are.
/// With R skeletons an axis of R comes first in the arrays of labels and confidence, which are
/// then (R, F, 4) and (R, F, 2), and `roots` (R) names the root joints.
///
/// # Panics
/// If the archive would be larger than 4 GiB.
pub fn npz(labelled: &[Labelled], source: &str, frame_time: f64) -> Vec<u8> {
    let Some(first) = labelled.first() else { return zip::store(&[]) };
    let frames = first.detection.principal().feet[0].planted.len();
    let roots: Vec<&str> = labelled.iter().filter_map(|labelled| labelled.root).collect();
    let labelled_of = |columns: &[(Side, Part)]| -> Vec<(Side, Part)> {
        columns.iter().copied().filter(|&(_, part)| first.detection.part(part).is_some()).collect()
    };
    let [columns, contact] = [labelled_of(&COLUMNS), labelled_of(&CONTACT)];
    let shape = |columns: &[(Side, Part)]| {
        let skeletons = (!roots.is_empty()).then_some(labelled.len());
        skeletons.into_iter().chain([frames, columns.len()]).collect::<Vec<_>>()
    };
    let bits = |columns: &[(Side, Part)]| {
        let values = cells(labelled, frames, columns, |foot, frame| [u8::from(foot.planted[frame])]);
        npy::write("|b1", &shape(columns), &values)
    };
    let names = |columns: &[(Side, Part)]| {
        let names: Vec<String> =
            columns.iter().map(|(side, part)| format!("{}_{}", side.name(), part.name())).collect();
        npy::texts(&[names.len()], &names.iter().map(String::as_str).collect::<Vec<_>>())
    };
    let confidence = cells(labelled, frames, &columns, |foot, frame| foot.confidence[frame].to_le_bytes());
    let time: Vec<u8> = (0..frames).flat_map(|frame| (frame as f64 * frame_time).to_le_bytes()).collect();
    let mut files = vec![
        ("contacts.npy", bits(&columns)),
        ("columns.npy", names(&columns)),
        ("confidence.npy", npy::write("<f4", &shape(&columns), &confidence)),
        ("contact.npy", bits(&contact)),
        ("contact_columns.npy", names(&contact)),
        ("time.npy", npy::write("<f8", &[frames], &time)),
        ("rate.npy", npy::write("<f8", &[], &(1.0 / frame_time).to_le_bytes())),
        ("source.npy", npy::texts(&[], &[source])),
    ];
    if !roots.is_empty() {
        files.push(("roots.npy", npy::texts(&[roots.len()], &roots)));
    }
    zip::store(&files)
}

/// A value for each skeleton, frame and column, in this order.
fn cells<const N: usize>(
    labelled: &[Labelled],
    frames: usize,
    columns: &[(Side, Part)],
    of: impl Fn(&crate::plants::FootLabels, usize) -> [u8; N],
) -> Vec<u8> {
    let mut values = Vec::with_capacity(labelled.len() * frames * columns.len() * N);
    for Labelled { detection, .. } in labelled {
        let feet: Vec<_> =
            columns.iter().filter_map(|&(side, part)| Some(detection.part(part)?.foot(side))).collect();
        values.extend(
            (0..frames)
                .flat_map(|frame| feet.iter().map(move |foot| (foot, frame)))
                .flat_map(|(foot, frame)| of(foot, frame)),
        );
    }
    values
}
