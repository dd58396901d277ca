//! Writer of BVH files, the inverse of the reader.

use std::fmt::Write;

use crate::bvh::{Axis, Channel, Clip, JointKind, PositionRule};

/// Returns the clip as BVH text with LF line ends and one row per frame.
///
/// Numbers have the fewest digits that read back to the same value and no exponents, so
/// `parse(write(clip))` returns the same clip. BVH cannot express [`PositionRule::Add`]: such a clip
/// is written with the offsets added to its position channels, which results in the same motion. Nor can it
/// express [`PositionRule::Global`]: positions are written relative to those of the parents, and the offsets
/// are those of the first frame. An opening brace in a name, as a file in another encoding than UTF-8 may have it, is written as `(`.
pub fn write(clip: &Clip) -> String {
    if clip.position_rule() == PositionRule::Global {
        return write(&relative_to_parents(clip));
    }
    let mut text = String::from("HIERARCHY\n");
    write_hierarchy(clip, &mut text);
    let _ = writeln!(text, "MOTION\nFrames: {}\nFrame Time: {}", clip.frame_count(), clip.frame_time());
    let shift = offset_shift(clip);
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

/// Returns a clip of global positions as one whose positions are relative to the parents.
fn relative_to_parents(clip: &Clip) -> Clip {
    let mut joints = clip.joints().to_vec();
    let mut values = clip.values().to_vec();
    for (index, joint) in joints.iter_mut().enumerate() {
        let Some(parent) = joint.parent else { continue };
        for (slot, channel) in clip.channel_range(index).zip(&joint.channels) {
            let Channel::Position(axis) = channel else { continue };
            let above = joint_slot(clip, parent, *axis);
            for frame in 0..clip.frame_count() {
                let row = clip.row(frame);
                let value = row[slot] - above.map_or(0.0, |above| row[above]);
                values[frame * clip.channel_count() + slot] = value;
                if frame == 0 {
                    joint.offset[axis.index()] = value;
                }
            }
        }
    }
    Clip::new(joints, clip.frame_time(), values)
}

/// Returns the index in a row of the position of a joint along an axis.
fn joint_slot(clip: &Clip, joint: usize, axis: Axis) -> Option<usize> {
    let position = clip.joints()[joint].channels.iter().position(|other| *other == Channel::Position(axis));
    position.map(|position| clip.channel_range(joint).start + position)
}

/// Appends the shortest decimal that reads back as `value`, without an exponent.
///
/// The text equals that of `Display`. The crate zmij takes a third of the time, but it writes some
/// numbers with an exponent, which not all programs read, and rounds ties to even.
fn write_number(value: f64, text: &mut String) {
    let mut buffer = zmij::Buffer::new();
    let digits = buffer.format(value);
    let digits = digits.strip_suffix(".0").unwrap_or(digits);
    if digits.contains('e') || is_tie(value, digits) {
        let _ = write!(text, "{value}");
    } else {
        text.push_str(digits);
    }
}

/// True if `value` may lie halfway between `digits` and another decimal of the same length.
///
/// The exact decimal of a value with n binary places has n decimal places. Halfway between two
/// decimals means exactly one place more than they have.
fn is_tie(value: f64, digits: &str) -> bool {
    const MANTISSA_BITS: u32 = f64::MANTISSA_DIGITS - 1;
    let bits = value.to_bits();
    let exponent = ((bits >> MANTISSA_BITS) & 0x7ff) as i32 - 1075;
    let mantissa = (bits & ((1 << MANTISSA_BITS) - 1)) | (1 << MANTISSA_BITS);
    let binary_places = -(exponent + mantissa.trailing_zeros() as i32);
    let decimal_places = digits.find('.').map_or(0, |point| digits.len() - point - 1);
    binary_places == decimal_places as i32 + 1
}

fn write_hierarchy(clip: &Clip, text: &mut String) {
    // Joints whose braces are open, outermost first.
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
        let _ = writeln!(
            text,
            "{indent}{keyword}{}\n{indent}{{\n{indent}\tOFFSET {x} {y} {z}",
            written_name(&joint.name)
        );
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

/// Returns the name without characters that would end it.
fn written_name(name: &str) -> String {
    name.replace('{', "(").replace(char::is_control, " ")
}

fn close_brace(open: &mut Vec<usize>, text: &mut String) {
    open.pop();
    let _ = writeln!(text, "{}}}", "\t".repeat(open.len()));
}

/// Returns the values to add to the channels of a row so that positions replace the offsets.
pub(crate) fn offset_shift(clip: &Clip) -> Vec<f64> {
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

    fn written(value: f64) -> String {
        let mut text = String::new();
        write_number(value, &mut text);
        text
    }

    #[test]
    fn ties_are_rounded_up() {
        assert_eq!(written(13_768_107_529_589.313), "13768107529589.313");
        assert_eq!(written(-0.500_007_629_394_531_3), "-0.5000076293945313");
        assert_eq!(written(0.1), "0.1");
    }

    proptest! {
        #[test]
        fn numbers_are_written_as_the_standard_library_does(value in any::<f64>(), places in 0..12) {
            let usual = (value % 1e4 * 10_f64.powi(places)).round() / 10_f64.powi(places);
            for value in [value, usual, usual.round(), value % 1e-4] {
                prop_assert_eq!(written(value), value.to_string());
            }
        }

        /// Sums of few powers of two, which have short exact decimals: some lie halfway between two
        /// shortest forms.
        #[test]
        fn ties_are_written_as_the_standard_library_does(numerator in any::<i64>(), shift in 0..64, power in 0..60) {
            let value = (numerator >> shift) as f64 / 2_f64.powi(power);
            prop_assert_eq!(written(value), value.to_string());
        }
    }
}
