//! The writer: the reader's inverse.

use std::fmt::Write;

use super::{Channel, Clip, JointKind, PositionRule};

/// The clip as BVH text, LF line ends, one row a frame.
///
/// Numbers are written with the fewest digits that read back to the same
/// value and without exponents, so `parse(write(clip))` gives the same clip. The one thing BVH cannot
/// say is [`PositionRule::Add`]: such a clip is written with the offsets added
/// to its position channels, which moves it in the same way.
pub fn write(clip: &Clip) -> String {
    let mut text = String::from("HIERARCHY\n");
    write_hierarchy(clip, &mut text);
    let _ = writeln!(text, "MOTION\nFrames: {}\nFrame Time: {}", clip.frame_count(), clip.frame_time());
    let shift = position_shift(clip);
    for frame in 0..clip.frame_count() {
        for (channel, (value, shift)) in clip.row(frame).iter().zip(&shift).enumerate() {
            if channel > 0 {
                text.push(' ');
            }
            write_number(value + shift, &mut text);
        }
        text.push('\n');
    }
    text
}

/// As `Display` has it, in a third of its time.
fn write_number(value: f64, text: &mut String) {
    let mut buffer = zmij::Buffer::new();
    let digits = buffer.format(value);
    // Not all programs read exponents.
    if digits.contains('e') {
        let _ = write!(text, "{value}");
    } else {
        text.push_str(digits.strip_suffix(".0").unwrap_or(digits));
    }
}

fn write_hierarchy(clip: &Clip, text: &mut String) {
    // The joints whose braces are open, outermost first.
    let mut open: Vec<usize> = Vec::new();
    for (index, joint) in clip.joints().iter().enumerate() {
        while open.last().copied() != joint.parent {
            close_brace(&mut open, text);
        }
        let indent = "\t".repeat(open.len());
        let keyword = match joint.kind {
            JointKind::Root => "ROOT ",
            JointKind::Joint => "JOINT ",
            JointKind::EndSite => "",
        };
        let [x, y, z] = joint.offset.into();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{indent}{keyword}{}\n{indent}{{\n{indent}\tOFFSET {x} {y} {z}", joint.name);
        if joint.kind != JointKind::EndSite {
            let _ = write!(text, "{indent}\tCHANNELS {}", joint.channels.len());
            for channel in &joint.channels {
                let _ = write!(text, " {}", channel.name());
            }
            text.push('\n');
        }
        open.push(index);
    }
    while !open.is_empty() {
        close_brace(&mut open, text);
    }
}

fn close_brace(open: &mut Vec<usize>, text: &mut String) {
    open.pop();
    let _ = writeln!(text, "{}}}", "\t".repeat(open.len()));
}

/// What has to be added to each channel of a row for it to replace its offset.
fn position_shift(clip: &Clip) -> Vec<f64> {
    let mut shift = vec![0.0; clip.channel_count()];
    if clip.position_rule() == PositionRule::Add {
        for (index, joint) in clip.joints().iter().enumerate().filter(|(_, joint)| joint.parent.is_some()) {
            for (slot, channel) in clip.channel_range(index).zip(&joint.channels) {
                if let Channel::Position(axis) = channel {
                    shift[slot] = joint.offset[axis.index()];
                }
            }
        }
    }
    shift
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn numbers_are_written_as_the_standard_library_does(value in any::<f64>(), places in 0..12) {
            let usual = (value % 1e4 * 10_f64.powi(places)).round() / 10_f64.powi(places);
            for value in [value, usual, usual.round(), value % 1e-4] {
                let mut text = String::new();
                write_number(value, &mut text);
                prop_assert_eq!(text, value.to_string());
            }
        }
    }
}
