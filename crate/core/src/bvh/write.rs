//! The writer: the reader's inverse.

use std::fmt::Write;

use super::{Channel, Clip, JointKind, PositionRule};

/// The clip as BVH text, LF line ends, one row a frame.
///
/// Numbers are written with the fewest digits that read back to the same
/// value, so `parse(write(clip))` gives the same clip. The one thing BVH cannot
/// say is [`PositionRule::Add`]: such a clip is written with the offsets added
/// to its position channels, which moves it in the same way.
pub fn write(clip: &Clip) -> String {
    let mut text = String::from("HIERARCHY\n");
    write_hierarchy(clip, &mut text);
    let _ = writeln!(text, "MOTION\nFrames: {}\nFrame Time: {}", clip.frame_count(), clip.frame_time());
    let shift = position_shift(clip);
    for frame in 0..clip.frame_count() {
        for (channel, (value, shift)) in clip.row(frame).iter().zip(&shift).enumerate() {
            let _ = write!(text, "{}{}", if channel > 0 { " " } else { "" }, value + shift);
        }
        text.push('\n');
    }
    text
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
