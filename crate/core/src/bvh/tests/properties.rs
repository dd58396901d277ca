//! Properties of reader and writer on random clips and texts.

use proptest::prelude::*;

use super::{motion, read};
use crate::bvh::*;

/// Generates clips of any shape: joints in depth-first order, each with its channels.
fn any_clip() -> impl Strategy<Value = Clip> {
    let axis = prop::sample::select(&Axis::ALL[..]);
    let channel = (axis, any::<bool>()).prop_map(|(axis, is_rotation)| {
        if is_rotation { Channel::Rotation(axis) } else { Channel::Position(axis) }
    });
    let limit = Limits::default().value;
    let any_number = prop::num::f64::NORMAL.prop_map(move |x| if x.abs() <= limit { x } else { limit / x });
    let number = prop_oneof![-1e3..1e3, any_number];
    let joint = (
        "[\\p{L}:_.-][\\p{L}0-9 :_.-]{0,8}[\\p{L}0-9]",
        prop::array::uniform3(number.clone()),
        prop::collection::vec(channel, 0..4),
        any::<prop::sample::Index>(),
        any::<bool>(),
    );
    let joints = prop::collection::vec(joint, 1..8).prop_map(|drafts| {
        let mut joints: Vec<Joint> = Vec::new();
        for (name, offset, channels, up, is_end) in drafts {
            // The parent is the previous joint or one of its ancestors; a joint without a parent is a root.
            let mut above = Vec::new();
            let mut next = joints.len().checked_sub(1);
            while let Some(index) = next {
                if joints[index].kind != JointKind::EndSite {
                    above.push(Some(index));
                }
                next = joints[index].parent;
            }
            above.push(None);
            let parent = *up.get(&above);
            let kind = match (parent, is_end) {
                (None, _) => JointKind::Root,
                (_, true) => JointKind::EndSite,
                _ => JointKind::Joint,
            };
            let end = kind == JointKind::EndSite;
            joints.push(Joint {
                name: if end { END_SITE.into() } else { name },
                kind,
                parent,
                offset: offset.into(),
                channels: if end { vec![] } else { channels },
            });
        }
        joints
    });
    (joints, 1e-3..0.5_f64, 0_usize..5).prop_flat_map(move |(joints, frame_time, frames)| {
        let width: usize = joints.iter().map(|joint| joint.channels.len()).sum();
        prop::collection::vec(number.clone(), width * frames)
            .prop_map(move |values| Clip::new(joints.clone(), frame_time, values))
    })
}

/// Generates motion of three channels, mostly of ordinary rows.
fn any_motion() -> impl Strategy<Value = String> {
    let odd = [
        "-0",
        "+1.5",
        "1e3",
        "nan",
        "0,5",
        "5.",
        ".5",
        "-",
        "0.0-7.5",
        "1.2.3",
        "9007199254740993",
        "0 1",
        "",
    ];
    let word = prop_oneof![
        12 => (-1e3..1e3).prop_map(|x| format!("{x:.4}")),
        2 => prop::num::f64::NORMAL.prop_map(|x| x.to_string()),
        1 => prop::sample::select(odd.to_vec()).prop_map(Into::into),
    ];
    let end = prop::sample::select(&["\n", "\r\n", "\r", " \n", "\n\n", " "][..]);
    let blank = prop::sample::select(&[" ", "\t", "  ", "\u{b}"][..]);
    let row = (prop::array::uniform3(word), blank, end).prop_map(|(row, blank, end)| row.join(blank) + end);
    (0_usize..9, prop::collection::vec(row, 0..9))
        .prop_map(|(stated, rows)| motion(&format!("Frames: {stated}\nFrame Time: 0.01\n{}", rows.concat())))
}

proptest! {
    #[test]
    fn fast_rows_agree_with_the_general_reader(text in any_motion(), chunk in 2_usize..99, lenient in any::<bool>()) {
        let read = |chunk| {
            let mut reader = Reader::new(Options { lenient, ..Options::default() });
            text.as_bytes().chunks(chunk).try_for_each(|chunk| reader.push(chunk))?;
            reader.finish()
        };
        let bits = |parsed: &Result<Parsed, Error>| {
            let values = parsed.iter().flat_map(|parsed| parsed.clip.values());
            values.map(|value| value.to_bits()).collect::<Vec<_>>()
        };
        // In chunks of one byte no row is complete: none is read by the fast reader.
        let expected = read(1);
        for found in [read(chunk), read(usize::MAX)] {
            prop_assert_eq!(bits(&found), bits(&expected));
            prop_assert_eq!(&found, &expected);
        }
    }

    #[test]
    fn written_clips_read_back(clip in any_clip()) {
        let back = read(&write(&clip)).clip;
        prop_assume!(back.position_rule() == PositionRule::Replace);
        prop_assert_eq!(back, clip);
    }

    #[test]
    fn a_slice_has_its_frames(clip in any_clip(), ends in any::<[prop::sample::Index; 2]>()) {
        let [a, b] = ends.map(|end| end.index(clip.frame_count() + 1));
        let slice = clip.slice(a.min(b)..a.max(b));
        prop_assert_eq!(slice.joints(), clip.joints());
        let rows: Vec<&[f64]> = (0..slice.frame_count()).map(|frame| slice.row(frame)).collect();
        prop_assert_eq!(rows, (a.min(b)..a.max(b)).map(|frame| clip.row(frame)).collect::<Vec<_>>());
    }

    #[test]
    fn the_result_does_not_depend_on_the_chunks(clip in any_clip(), chunk in 1_usize..50, crlf in any::<bool>()) {
        let mut text = write(&clip);
        if crlf {
            text = text.replace('\n', "\r\n");
        }
        let mut reader = Reader::new(Options::default());
        for chunk in text.as_bytes().chunks(chunk) {
            reader.push(chunk).unwrap();
        }
        prop_assert_eq!(reader.finish().unwrap(), read(&text));
    }

    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = parse(&bytes, Options::default());
    }

    #[test]
    fn damaged_files_never_panic(
        clip in any_clip(),
        damage in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(b"{}\n \x00-.,9eJ".to_vec())), 0..6),
        cut in any::<prop::sample::Index>(),
        lenient in any::<bool>(),
    ) {
        let mut bytes = write(&clip).into_bytes();
        for (at, byte) in damage {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        bytes.truncate(cut.index(bytes.len()) + 1);
        if let Ok(parsed) = parse(&bytes, Options { lenient, ..Options::default() }) {
            prop_assert!(parsed.clip.values().iter().all(|value| value.is_finite()));
        }
    }
}
