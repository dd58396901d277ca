//! Tests of the reader on the variants of the format.

use super::*;
use crate::bvh::hierarchy::HierarchySection;
use crate::bvh::lines::Line;
use crate::bvh::motion_section::MotionSection;
use crate::bvh::number::Decimals;
use crate::notice::{Code, Location};
use nalgebra::Vector3;

mod properties;

const HEAD: &str = "HIERARCHY\nROOT Hips\n{\n\tOFFSET 0 0 0\n\tCHANNELS 3 Xposition Yposition Zposition\n\
                    \tEnd Site\n\t{\n\t\tOFFSET 0 1 0\n\t}\n}\n";

fn read(text: &str) -> Parsed {
    parse(text.as_bytes(), Options::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn reject(text: &str) -> Error {
    parse(text.as_bytes(), Options::default()).expect_err(text)
}

/// Returns line and column of an error.
fn location(error: &Error) -> Option<(usize, usize)> {
    error.location.map(|location| (location.line, location.column))
}

fn motion(motion: &str) -> String {
    format!("{HEAD}MOTION\n{motion}")
}

fn codes(parsed: &Parsed) -> Vec<Code> {
    parsed.notices.iter().map(|notice| notice.code).collect()
}

/// Returns the rows of the clip and the codes of its notices.
fn rows(text: &str) -> (Vec<Vec<f64>>, Vec<Code>) {
    let parsed = read(&motion(text));
    let rows = (0..parsed.clip.frame_count()).map(|frame| parsed.clip.row(frame).to_vec()).collect();
    (rows, codes(&parsed))
}

#[test]
fn reads_an_ordinary_file() {
    let parsed = read(&motion("Frames: 2\nFrame Time: 0.01\n1 2 3\n4 5 6\n"));
    assert_eq!(parsed.notices, []);
    let clip = parsed.clip;
    assert_eq!(clip.joints()[0].name, "Hips");
    assert_eq!(clip.joints()[1].kind, JointKind::EndSite);
    assert_eq!(clip.joints()[1].parent, Some(0));
    assert_eq!(clip.joints()[1].offset, Vector3::new(0.0, 1.0, 0.0));
    assert_eq!(clip.row(1), [4.0, 5.0, 6.0]);
    assert_eq!(clip.frame_time(), 0.01);
}

#[test]
fn keywords_are_read_in_any_case_and_spacing() {
    for header in [
        "Frames:\t1\nFrame Time:\t0.01\n",
        "Frames:    1\nFrame Time: 0.01\n",
        "Frames: 1 \nFrame Time: .01 \n",
        "Frames :1\nFrame Time : 1e-2\n",
        "frames: 1\nframe time: +0.01\n",
        "FRAMES: 1\nFRAME TIME: 0.01\n",
        "\n\nFrames: 1\n\nFrame Time: 0.01\n\t\n",
        "Frames: 1 Frame Time: 0.01\n",
    ] {
        let parsed = read(&motion(&format!("{header}1 2 3")));
        assert_eq!((codes(&parsed), parsed.clip.frame_time()), (vec![], 0.01), "{header}");
    }
    let one_line = "hierarchy root Left Foot{offset 0 0 0 channels 1 xPosition End site{OFFSET 0 1 0}}motion";
    assert_eq!(read(&format!("{one_line}\nFrames: 1\nFrame Time: 1\n7")).clip.joints()[0].name, "Left Foot");
}

#[test]
fn frame_count_is_the_number_of_rows() {
    let time = "Frame Time: 0.01\n";
    let two = vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0]];
    for (declared, notices) in [
        ("Frames: 2\n", vec![]),
        ("Frames: 3\n", vec![Code::FrameCount]),
        ("Frames: 1\n", vec![Code::FrameCount]),
        ("Frames: 99999999999999999999\n", vec![Code::FrameCount]),
        ("Frames: many\n", vec![Code::FrameCount]),
        ("", vec![Code::FrameCount]),
    ] {
        assert_eq!(rows(&format!("{declared}{time}1 2 3\n4 5 6")), (two.clone(), notices), "{declared}");
    }
}

#[test]
fn wrapped_and_long_rows_are_read() {
    let head = "Frames: 2\nFrame Time: 0.01\n";
    let two = vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0]];
    assert_eq!(rows(&format!("{head}1\n2 3\n4 5\n6")), (two.clone(), vec![Code::WrappedRow]));
    assert_eq!(rows(&format!("{head}1 2 3 9\n4 5 6 9 9")), (two.clone(), vec![Code::LongRow]));
    assert_eq!(rows(&format!("{head}1 2 3\n4 5 6\n7 8\nend")), (two.clone(), vec![Code::TrailingMatter]));
    assert_eq!(
        rows(&format!("{head}1 2 3\n4 5")),
        (two[..1].to_vec(), vec![Code::IncompleteRow, Code::FrameCount])
    );

    let error = reject(&motion(&format!("{head}1 2\n3 4 5\n6 7 8")));
    assert_eq!(error.kind, ErrorKind::RaggedRow { expected: 3, found: 5, frame: 0 });
    assert_eq!(error.location.unwrap().line, 14);
}

#[test]
fn an_incomplete_number_at_the_end_is_ignored() {
    let head = "Frames: 2\nFrame Time: 0.01\n1 2 3\n";
    let incomplete = vec![Code::IncompleteRow, Code::FrameCount];
    for end in ["4 -", "4 5e", "4 5 6.1e-"] {
        assert_eq!(rows(&format!("{head}{end}")), (vec![vec![1.0, 2.0, 3.0]], incomplete.clone()), "{end}");
    }
    assert!(matches!(reject(&motion(&format!("{head}4 x"))).kind, ErrorKind::BadValue { .. }));
    assert_eq!(reject("HIERARCHY\nROOT a\n{\nOFFS").kind, ErrorKind::UnclosedBraces { open: 1 });
}

#[test]
fn numbers_are_read_in_all_notations() {
    let head = "Frames: 1\nFrame Time: 0.01\n";
    assert_eq!(rows(&format!("{head}+1.0 2e0 .3")).0, [[1.0, 2.0, 0.3]]);
    assert_eq!(rows(&format!("{head}0.0-7.5+2")).0, [[0.0, -7.5, 2.0]]);
}

#[test]
fn decimal_commas_are_read_if_the_file_is_consistent() {
    let text = motion("Frames: 1\nFrame Time: 0,01\n1,5 2 3");
    let parsed = read(&text);
    assert_eq!((parsed.clip.row(0)[0], parsed.clip.frame_time()), (1.5, 0.01));
    assert_eq!(codes(&parsed), [Code::DecimalComma]);
    assert_eq!(reject(&motion("Frames: 1\nFrame Time: 0.01\n1,5 2 3")).kind, ErrorKind::MixedDecimals);
}

#[test]
fn memory_is_reserved_for_plausible_frame_counts() {
    let capacity = |stated: &str, expected_bytes| {
        let options = Options { expected_bytes, ..Options::default() };
        let hierarchy = HierarchySection {
            joints: read(HEAD).clip.joints().to_vec(),
            name_encoding: None,
            decimals: Decimals::default(),
            locations: Default::default(),
            notices: Vec::new(),
        };
        let mut rows = MotionSection::new(options, hierarchy);
        let header = format!("Frames: {stated}");
        rows.line(Line { number: 1, start: 0, text: header.as_bytes() }).unwrap();
        rows.line(Line { number: 2, start: 99, text: b"1 2 3" }).unwrap();
        rows.values.capacity()
    };
    assert_eq!(capacity("1000", 10_000), 3000);
    assert_eq!(capacity("1e300", 10_000), 5000);
    assert!(capacity("1e300", 0) < 100 && capacity("1e300", u64::MAX) < 100);
}

#[test]
fn implausible_frame_times_are_replaced_by_a_thirtieth() {
    for time in ["0", "-1", "30", "0.000001", "none", ""] {
        let parsed = read(&motion(&format!("Frames: 1\nFrame Time: {time}\n1 2 3")));
        assert_eq!((codes(&parsed), parsed.clip.frame_time()), (vec![Code::FrameTime], 1.0 / 30.0), "{time}");
    }
}

#[test]
fn a_skeleton_without_motion_is_a_rest_pose() {
    for text in [HEAD.to_owned(), motion(""), motion("Frames: 0\nFrame Time: 0.01\n")] {
        let parsed = read(&text);
        assert_eq!((parsed.clip.frame_count(), codes(&parsed)), (0, vec![Code::NoMotion]), "{text}");
    }
}

#[test]
fn words_that_are_not_numbers_are_rejected_or_replaced() {
    for bad in ["abc", "NaN", "-inf", "1e999", "1.#QNAN"] {
        let text = motion(&format!("Frames: 2\nFrame Time: 0.01\n1 2 3\n4  {bad} 6"));
        let error = reject(&text);
        let expected = format!("15:4: expected a number, found {bad:?} (frame 1, channel Hips Yposition)");
        assert_eq!(error.to_string(), expected);
        assert_eq!(error.excerpt, Some(Excerpt { text: format!("4  {bad} 6"), caret: 3 }));

        let lenient = parse(text.as_bytes(), Options { lenient: true, ..Options::default() }).unwrap();
        assert_eq!((lenient.clip.row(1), codes(&lenient)), (&[4.0, 2.0, 6.0][..], vec![Code::HeldValue]));
    }
}

#[test]
fn each_joint_has_its_own_channels() {
    let text = "HIERARCHY\nROOT a\n{\nOFFSET 1 2 3\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT b\n{\nOFFSET 0 1 0\n\
                CHANNELS 6 Xposition Yposition Zposition Zrotation\nJOINT b\n{\nOFFSET 0 1 0\n}\n}\n}\n";
    let parsed = read(text);
    assert_eq!(parsed.clip.channel_range(1), 3..7);
    assert_eq!(codes(&parsed), [Code::ChannelCount, Code::DuplicateName, Code::NoMotion]);
}

#[test]
fn several_roots_are_several_skeletons() {
    let text =
        format!("{HEAD}{}MOTION\nFrames: 1\nFrame Time: 0.01\n1 2 3 4 5 6", &HEAD["HIERARCHY\n".len()..]);
    let parsed = read(&text);
    assert_eq!(parsed.clip.roots().collect::<Vec<_>>(), [0, 2]);
    assert!(codes(&parsed).contains(&Code::SeveralRoots));
}

#[test]
fn near_zero_position_channels_are_added_to_offsets() {
    let file = |value: &str| {
        format!(
            "HIERARCHY\nROOT a\n{{\nOFFSET 0 0 0\nCHANNELS 0\nJOINT b\n{{\nOFFSET 0 5 0\n\
             CHANNELS 3 Xposition Yposition Zposition\n}}\n}}\nMOTION\nFrames: 1\nFrame Time: 0.01\n0 {value} 0"
        )
    };
    let added = read(&file("0.001"));
    assert_eq!((added.clip.position_rule(), codes(&added)), (PositionRule::Add, vec![Code::AddedPositions]));
    assert_eq!(read(&file("5")).clip.position_rule(), PositionRule::Replace);
    // In the written file the offset is part of the channel.
    assert_eq!(read(&write(&added.clip)).clip.row(0), [0.0, 5.001, 0.0]);
}

#[test]
fn errors_state_what_is_wrong() {
    for (text, kind) in [
        ("", ErrorKind::Empty),
        (" \n\t\n", ErrorKind::Empty),
        ("PK\u{3}\u{4}abc", ErrorKind::NotBvh("a zip archive")),
        ("Kaydara FBX Binary", ErrorKind::NotBvh("FBX")),
        ("<!DOCTYPE html>", ErrorKind::NotBvh("a web page")),
        ("\u{1}\u{2}", ErrorKind::NotBvh("binary data")),
        ("HIERARCHY\n", ErrorKind::NoJoints),
        ("HIERARCHY\nMOTION\n", ErrorKind::NoJoints),
        ("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n", ErrorKind::UnclosedBraces { open: 1 }),
        ("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nMOTION\n", ErrorKind::UnclosedBraces { open: 1 }),
    ] {
        assert_eq!(reject(text).kind, kind, "{text}");
    }
    let error = reject("HIERARCHY\nROOT a\n{\n OFFSET 0 x 0\n}");
    assert_eq!(error.kind, ErrorKind::Unexpected { expected: "a number", found: "x".into() });
    assert_eq!(location(&error), Some((4, 11)));
    let error = reject("HIERARCHY\nROOT é\n{\nCHANNELS 1 Wrotation\n}");
    assert_eq!(
        (error.kind.clone(), location(&error)),
        (ErrorKind::UnknownChannel("Wrotation".into()), Some((4, 12)))
    );
    let error = reject("hello world");
    assert_eq!(error.to_string(), "1:1: expected HIERARCHY, found \"hello\"");
    let error = reject("HIERARCHY\nROOT a\n{\n}\n}\n");
    assert_eq!(location(&error), Some((5, 1)));
}

#[test]
fn limits_are_enforced() {
    let limits = Limits { bytes: 200, line_bytes: 60, joints: 2, depth: 2, ..Limits::default() };
    let kind = |text: &str| {
        let error = parse(text.as_bytes(), Options { limits, ..Options::default() }).expect_err(text);
        assert!(error.kind.is_limit());
        error.kind
    };
    assert_eq!(kind(&"\n".repeat(201)), ErrorKind::TooLarge(200));
    assert_eq!(kind(&"a".repeat(61)), ErrorKind::LineTooLong(60));
    let nested = "HIERARCHY ROOT a { JOINT b {\nJOINT c {\n";
    assert_eq!(kind(nested), ErrorKind::TooManyJoints(2));
    let limits = Limits { joints: 9, ..limits };
    let error = parse(nested.as_bytes(), Options { limits, ..Options::default() }).unwrap_err();
    assert_eq!(error.kind, ErrorKind::TooDeep(2));
}

#[test]
fn long_lines_are_rejected_in_chunks_of_any_size() {
    let options = Options { limits: Limits { line_bytes: 50, ..Limits::default() }, ..Options::default() };
    for (blanks, is_read) in [(46, true), (47, false)] {
        let row = format!("4 5{}6", " ".repeat(blanks));
        let text = motion(&format!("Frames: 3\nFrame Time: 0.01\n1 2 3\n{row}\n7 8 9\n"));
        for chunk in [1, 7, 999] {
            let mut reader = Reader::new(options);
            let read = text.as_bytes().chunks(chunk).try_for_each(|chunk| reader.push(chunk));
            let expected = if is_read { Ok(()) } else { Err(ErrorKind::LineTooLong(50)) };
            assert_eq!(read.map_err(|error| error.kind), expected, "chunks of {chunk}");
        }
    }
}

#[test]
fn text_after_the_stated_frames_is_not_motion_if_lenient() {
    let text = motion("Frames: 1\nFrame Time: 0.01\n1 2 3\nEnd of file\n");
    let parsed = parse(text.as_bytes(), Options { lenient: true, ..Options::default() }).unwrap();
    assert_eq!((parsed.clip.frame_count(), codes(&parsed)), (1, vec![Code::TrailingMatter]));
    // A frame that could not be measured is motion.
    let text = text.replace("End of file", "nan -NaN inf");
    let parsed = parse(text.as_bytes(), Options { lenient: true, ..Options::default() }).unwrap();
    assert_eq!(
        (parsed.clip.row(1), codes(&parsed)),
        (&[1.0, 2.0, 3.0][..], vec![Code::HeldValue, Code::FrameCount])
    );
}

#[test]
fn notices_quote_what_the_header_states() {
    for (header, text) in [
        (
            "Frames: 1e300\nFrame Time: 0.01",
            "The file states 1e300 frames and has 1; the frames present are used.",
        ),
        ("Frames: -5\nFrame Time: 0.01", "The number of frames is stated as \"-5\"; the file has 1."),
        ("Frames: 1,000\nFrame Time: 0.01", "The number of frames is stated as \"1,000\"; the file has 1."),
        ("Frame Time: 0.01", "The file does not state the number of frames; it has 1."),
        (
            "Frames: 1\nFrame Time: 0.02\nFrame Time: 0.01",
            "The file has a second \"Frame Time:\"; the last one is used.",
        ),
        (
            "Frames: 1\nFrame Time: NaN",
            "The stated frame time \"NaN\" is not plausible; 30 frames per second are used. Set the frame rate if \
             you know it.",
        ),
    ] {
        assert_eq!(read(&motion(&format!("{header}\n1.5 2 3\n"))).notices[0].text, text);
    }
}

#[test]
fn values_beyond_the_limit_are_rejected_as_other_bad_values() {
    for large in ["1000000001", "-1e160", "1e300", "4000000000.5"] {
        let text = motion(&format!("Frames: 2\nFrame Time: 0.01\n1 2 3\n4 {large} 6\n"));
        let error = reject(&text);
        assert_eq!(location(&error), Some((15, 3)), "{large}");
        let place = "frame 1, channel Hips Yposition".into();
        assert_eq!(error.kind, ErrorKind::LargeValue { found: large.into(), limit: 1e9, place });
        let parsed = parse(text.as_bytes(), Options { lenient: true, ..Options::default() }).unwrap();
        assert_eq!((codes(&parsed), parsed.clip.row(1)), (vec![Code::HeldValue], &[4.0, 2.0, 6.0][..]));
        let offset = HEAD.replace("OFFSET 0 1 0", &format!("OFFSET 0 {large} 0"));
        assert_eq!(location(&reject(&offset)), Some((8, 12)));
    }
    assert_eq!(rows("Frames: 1\nFrame Time: 0.01\n1e9 -1000000000 0\n").1, []);
}

#[test]
fn repeated_repairs_are_one_notice() {
    let name = "long".repeat(1000);
    let joint = format!("JOINT {name}\n{{\nCHANNELS 1 Xrotation Yrotation\n}}\n");
    let offsets = "OFFSET 1 2 3 ".repeat(1000);
    let text = format!("HIERARCHY\nROOT a\n{{\n{offsets}\n{}}}\n", joint.repeat(3));
    let parsed = read(&text);
    use Code::{ChannelCount, DuplicateName, NoMotion, Offset};
    assert_eq!(codes(&parsed), [Offset, ChannelCount, Offset, DuplicateName, NoMotion]);
    let [second, channels, none, ..] = &parsed.notices[..] else { unreachable!("five notices") };
    assert_eq!(second.text, "a has a second OFFSET; the last one is used. The same occurs 998 more times.");
    let short = format!("{}…", &name[..60]);
    assert!(channels.text.starts_with(&short) && channels.text.ends_with("The same occurs 2 more times."));
    assert!(none.text.starts_with(&short) && none.location == Some(Location { line: 8, column: 1 }));
}

#[test]
fn scale_channels_are_read_and_not_used() {
    let hierarchy = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 4 Xposition Xscale yScale ZSCALE\n}\n";
    let parsed = read(&format!("{hierarchy}MOTION\nFrames: 1\nFrame Time: 0.01\n5 2 2 2\n"));
    assert_eq!(codes(&parsed), [Code::ScaleChannels]);
    assert_eq!(parsed.notices[0].location.unwrap().line, 5);
    assert_eq!(parsed.clip.joints()[0].channels[1], Channel::Scale(Axis::X));
    assert_eq!(parsed.clip.row(0), [5.0, 2.0, 2.0, 2.0]);
    assert_eq!(read(&write(&parsed.clip)).clip, parsed.clip);
}

#[test]
fn comments_are_accepted_anywhere() {
    let text = "# a file\n  // of two\nHIERARCHY # begins\nROOT Hips // the root\n{ # open\n\tOFFSET 0 0 0 # no offset\n\
                CHANNELS 3 Xposition // first\n#between\nYposition Zposition\n\tEnd Site # tip\n\t{\nOFFSET 0 1 0 }\n\
                }//done\nMOTION # of one\n# rate\nFrames: 2 # two\nFrame Time: 0.01 // 100 Hz\n# first\n1 2 3 # row\n\
                // second\n4 5 6 //end\n# last\n";
    for text in [text.to_owned(), text.replace('\n', "\r\n")] {
        let parsed = read(&text);
        assert_eq!((codes(&parsed), parsed.clip.row(1)), (vec![], &[4.0, 5.0, 6.0][..]));
        assert_eq!(parsed.clip.joints()[0].name, "Hips");
    }
}

#[test]
fn names_may_contain_number_signs() {
    let parsed = read(
        "HIERARCHY ROOT Finger #2 {\nOFFSET 0 0 0\nCHANNELS 0\nJOINT a//b\n{ OFFSET 0 0 0 CHANNELS 0 } }",
    );
    assert_eq!(parsed.clip.joints()[0].name, "Finger #2");
    assert_eq!(parsed.clip.joints()[1].name, "a//b");
}

#[test]
fn frame_times_with_units_are_converted() {
    for time in ["40 ms", "40ms", "0.04 s", "0.04sec", "25 Hz", "25fps", "1/25"] {
        let parsed = read(&motion(&format!("Frames: 1\nFrame Time: {time} # rate\n1 2 3")));
        assert_eq!((codes(&parsed), parsed.clip.frame_time()), (vec![Code::FrameTime], 0.04), "{time}");
        assert!(parsed.notices[0].text.contains(&format!("{time:?}")), "{}", parsed.notices[0].text);
    }
    let parsed = read(&motion("Frames: 1 (one)\nFrame Time: 0.04 (25 fps)\n1 2 3"));
    assert_eq!((codes(&parsed), parsed.clip.frame_time()), (vec![Code::FrameCount, Code::FrameTime], 0.04));
}

#[test]
fn only_the_first_of_several_motions_is_read() {
    let first = motion("Frames: 2\nFrame Time: 0.01\n1 2 3\n4 5 6\n");
    let second = motion("Frames: 1\nFrame Time: 0.02\n7 8 9\n");
    let other_rig = second.replace(" Zposition", "").replace("NELS 3", "NELS 2").replace(" 9", "");
    for (followers, what) in [
        (second.clone(), "one more hierarchy and one more motion from line 16 on"),
        (second.repeat(2) + &other_rig, "3 more hierarchies and 3 more motions"),
        (second["HIERARCHY\n".len()..].to_owned(), "one more motion from"),
        ("MOTION\nFrames: 1\nFrame Time: 0.01\n7 8 9\n".repeat(2), "2 more motions from"),
        ("  hierarchy ROOT a".to_owned(), "one more hierarchy from"),
    ] {
        let parsed = read(&format!("{first}{followers}"));
        assert_eq!((parsed.clip.frame_count(), codes(&parsed)), (2, vec![Code::SeveralMotions]));
        assert!(parsed.notices[0].text.contains(what), "{}", parsed.notices[0].text);
        assert_eq!(parsed.notices[0].location.unwrap().line, 16);
        assert_eq!(parsed.clip, read(&first).clip);
    }
    // The first motion may break off.
    let parsed = read(&format!("{}\n{second}", &first[..first.len() - 4]));
    assert_eq!(codes(&parsed), [Code::IncompleteRow, Code::SeveralMotions, Code::FrameCount]);
}

#[test]
fn an_extra_column_of_frame_numbers_or_times_is_rejected() {
    let head = "Frames: 3\nFrame Time: 0.0333\n";
    for (rows, column) in [
        ("0 1 2 3\n1 4 5 6\n", "the number of the frame"),
        ("17\t1 2 3 \n18\t4 5 6\n19\t4 5 6\n", "the number of the frame"),
        ("0.0 1 2 3\n0.033333 4 5 6\n", "the time of the frame"),
        ("0 1 2 3\n33.3 4 5 6\n", "the time of the frame"),
    ] {
        let error = reject(&motion(&format!("{head}{rows}")));
        assert_eq!(error.kind, ErrorKind::ExtraColumn { channels: 3, column }, "{rows}");
        assert_eq!(error.location.unwrap().line, 15);
    }
    let every_fourth = format!("{head}0 0.1 1 2 3\n4 0.2 1 2 3\n8 0.3 1 2 3\n12 0.4 1 2 3\n");
    let kind = ErrorKind::ExtraColumn { channels: 3, column: "the number of the frame" };
    assert_eq!(reject(&motion(&every_fourth)).kind, kind);
    // Superfluous numbers at the end are left out.
    assert_eq!(rows(&format!("{head}1 2 3 0\n4 5 6 1\n7 8 9 2\n")).1, [Code::LongRow]);
}

#[test]
fn written_names_are_read_back() {
    let text = b"HIERARCHY\nROOT \x85{a\x85\n{\nOFFSET 0 0 0\nCHANNELS 0\n}\n";
    let options = Options { decode_names: decode_windows_1252, ..Options::default() };
    let parsed = parse(text, options).unwrap();
    assert_eq!(parsed.clip.joints()[0].name, "\u{2026}{a\u{2026}");
    assert_eq!(read(&write(&parsed.clip)).clip.joints()[0].name, "\u{2026}(a\u{2026}");
}

#[test]
fn names_in_other_encodings_are_decoded() {
    let file = |names: [&[u8]; 3]| {
        let mut bytes = b"HIERARCHY\nROOT ".to_vec();
        bytes.extend(names[0]);
        for name in &names[1..] {
            bytes.extend(b"\n{\nCHANNELS 0\nJOINT ");
            bytes.extend(*name);
        }
        bytes.extend(b"\n{\nOFFSET 0 0 0\nCHANNELS 0\n}\n}\n}\n");
        bytes
    };
    let texts = ["ボーン下半身", "左足首", "左足首先"];
    let encoded = texts.map(|text| encoding_rs::SHIFT_JIS.encode(text).0.into_owned());
    let parsed = parse(&file(encoded.each_ref().map(|name| &name[..])), Options::default()).unwrap();
    assert!(parsed.clip.joints().iter().map(|joint| &joint.name[..]).eq(texts));
    assert_eq!(parsed.layout.name_encoding(), Some("Shift_JIS"));
    assert_eq!(codes(&parsed), [Code::Offset, Code::NameEncoding, Code::NoMotion]);
    assert_eq!(parsed.notices[0].text, "左足首 has no OFFSET; zero is used. The same occurs once more.");
    let unicode = parse(&file(texts.map(str::as_bytes)), Options::default()).unwrap();
    assert_eq!((unicode.clip, unicode.layout.name_encoding()), (parsed.clip, None));
}
