use proptest::prelude::*;

use super::*;
use crate::formats::{ReadError, read_plants};
use crate::plants::{Detection, FootLabels, Ground, Params, PartLabels};

fn foot(planted: Vec<bool>) -> FootLabels {
    let rest = vec![0.0; planted.len()];
    FootLabels {
        confidence: vec![0.75; planted.len()],
        height: rest.clone(),
        speed: rest,
        planted,
        edges: Vec::new(),
    }
}

/// A detection of some parts with the labels of both feet.
fn detection(parts: Vec<(Part, [Vec<bool>; 2])>) -> Detection {
    let labels =
        |(part, feet): (Part, [Vec<bool>; 2])| PartLabels { part, feet: feet.map(foot), evidence: None };
    Detection {
        params: Params::default().check().unwrap(),
        parts: parts.into_iter().map(labels).collect(),
        ground_height: 0.0,
        ground: Ground::level(),
        noise: None,
        notices: Vec::new(),
        edits: Vec::new(),
    }
}

fn archive(detection: &Detection) -> Vec<u8> {
    npz(&[DetectionRef { root: None, detection }], "walk.bvh", 0.01)
}

/// An archive with one table of values of a type, and its column names.
fn table(kind: &str, shape: &[usize], values: &[u8], names: &[&str]) -> Vec<u8> {
    let contacts = npy::write(kind, shape, values);
    zip::store(&[("contacts.npy", contacts), ("columns.npy", npy::texts(&[names.len()], names))])
}

proptest! {
    #[test]
    fn labels_round_trip(
        labels in prop::collection::vec(prop::array::uniform6(any::<bool>()), 1..40),
        labelled in prop::collection::vec(any::<bool>(), 3),
    ) {
        let column = |n: usize| labels.iter().map(|row: &[bool; 6]| row[n]).collect::<Vec<_>>();
        let mut parts: Vec<_> =
            Part::ALL.into_iter().enumerate().map(|(n, part)| (part, [column(2 * n), column(2 * n + 1)])).collect();
        // Every method labels at least one part.
        parts.retain(|(part, _)| labelled[*part as usize] || *part == Part::Toe);
        let read = read_plants(&archive(&detection(parts.clone())), labels.len()).unwrap();
        prop_assert_eq!(read.parts.len(), parts.len());
        for (part, feet) in parts {
            let expected = feet.map(|labels| labels.into_iter().map(Some).collect::<Vec<_>>());
            prop_assert_eq!(read.part(part), Some(&expected));
        }
    }

    #[test]
    fn damaged_archives_never_panic(position in 0.0..1.0_f64, byte in any::<u8>(), cut in 0.0..1.0_f64) {
        let contact = [vec![true, false, true], vec![false, true, true]];
        let archive_bytes = archive(&detection(vec![(Part::Contact, contact)]));
        let mut changed = archive_bytes.clone();
        let at = (position * archive_bytes.len() as f64) as usize;
        changed[at] = byte;
        let _ = read_plants(&changed, 3);
        let cut = (cut * archive_bytes.len() as f64) as usize;
        prop_assert!(read_plants(&archive_bytes[..cut], 3).is_err());
    }
}

#[test]
fn arrays_of_all_number_types_are_read() {
    let names = ["left_toe", "right_toe"];
    let of = |values: &[Option<bool>]| values.to_vec();
    let expected = [of(&[Some(true), None]), of(&[Some(false), Some(true)])];
    let rows = [1.0, 0.0, -1.0, 1.0_f32];
    let floats: Vec<u8> = rows.iter().flat_map(|value| value.to_le_bytes()).collect();
    let doubles: Vec<u8> = rows.iter().flat_map(|value| f64::from(*value).to_le_bytes()).collect();
    let longs: Vec<u8> = rows.iter().flat_map(|value| (*value as i64).to_le_bytes()).collect();
    let bytes = rows.map(|value| value as i8 as u8);
    for (kind, values) in [("<f4", floats), ("<f8", doubles), ("<i8", longs), ("|i1", bytes.to_vec())] {
        let read = read_plants(&table(kind, &[2, 2], &values, &names), 2).unwrap();
        assert_eq!(read.part(Part::Toe), Some(&expected), "{kind}");
    }
    let mut columns_first = npy::write("|i1", &[2, 2], &[1, 255, 0, 1]);
    let position = columns_first.windows(5).position(|word| word == b"False").unwrap();
    columns_first[position..position + 5].copy_from_slice(b"True ");
    let archive = zip::store(&[("contacts.npy", columns_first), ("columns.npy", npy::texts(&[2], &names))]);
    assert_eq!(read_plants(&archive, 2).unwrap().part(Part::Toe), Some(&expected));
}

#[test]
fn errors_state_the_reason() {
    let names = ["left_toe", "right_toe"];
    let assert_error = |archive: &[u8], what: &str| {
        let error = read_plants(archive, 2).unwrap_err();
        assert!(error.to_string().contains(what), "{error}");
    };
    assert_error(&table("|b1", &[3, 2], &[1; 6], &names), "has 3 frames");
    assert_error(&table("|b1", &[2, 2], &[1; 3], &names), "does not match its shape");
    assert_error(&table("|b1", &[usize::MAX, 2], &[1; 4], &names), "does not match its shape");
    assert_error(&table("|b1", &[2, 3], &[1; 6], &names), "3 columns but 2 names");
    assert_error(&table("|b1", &[2, 2, 1], &[1; 4], &names), "several skeletons");
    assert_error(&table("|u1", &[2, 2], &[7; 4], &names), "expected 0, 1 or -1, found 7");
    assert_error(&table(">i2", &[2, 2], &[0; 8], &names), "type >i2");
    assert_error(&table("|O", &[2, 2], &[0; 4], &names), "type |O");
    assert_error(&table("|b1", &[200_000, 2], &[0; 400_000], &names), "more than the labels of the clip");
    assert_error(&zip::store(&[("contacts.npy", npy::write("|b1", &[2, 2], &[0; 4]))]), "columns is missing");
    assert_error(&zip::store(&[]), "the file has no plants");
    assert_error(b"PK\x03\x04", "incomplete");
    assert_eq!(read_plants(b"\xff\xfe", 2), Err(ReadError::NoPlants));
    assert_eq!(read_plants(br#"{"left": [0, 1], "right": [1, 1]}"#, 2).unwrap().parts.len(), 1);
    let toes = detection(vec![(Part::Toe, [vec![true, false], vec![true, true]])]);
    let several = ["A", "B"].map(|root| DetectionRef { root: Some(root), detection: &toes });
    assert_error(&npz(&several, "walk.bvh", 0.01), "several skeletons");
}
