//! Spikes of the hips: frames in which they jump away, and back to where they were.

use std::ops::Range;

use nalgebra::Vector3;

use crate::bvh::{Channel, Clip};

/// Maximum duration of a spike, in seconds.
const MAX_DURATION: f64 = 0.05;

/// Deviation from the straight line over the spike, in leg lengths, at least.
const MIN_DEVIATION: f64 = 0.05;

/// Acceleration of hips, in leg lengths per second squared, above which they do not move by themselves: about
/// 8 g. Those of jumps and falls are below 5 g.
const MAX_ACCELERATION: f64 = 90.0;

/// Deviation relative to the distance over the spike, at least; a jump that does not come back has 0.5.
const MIN_RETURN: f64 = 0.6;

/// Returns the spikes of a joint's position channels, in order.
pub(super) fn find(clip: &Clip, joint: usize, leg: f64) -> Vec<Range<usize>> {
    let track: Vec<Vector3<f64>> =
        (0..clip.frame_count()).map(|frame| position(clip, joint, frame)).collect();
    let dt = clip.frame_time();
    let max_frames = ((MAX_DURATION / dt).round() as usize).max(1);
    let is_spike = |frames: &Range<usize>| {
        let (before, after) = (frames.start - 1, frames.end);
        let travel = (track[after] - track[before]).norm();
        frames.clone().all(|frame| {
            let [since, until] = [frame - before, after - frame].map(|steps| steps as f64 * dt);
            let line = track[before].lerp(&track[after], since / (since + until));
            let possible = (MIN_DEVIATION + MAX_ACCELERATION / 2.0 * since * until) * leg;
            (track[frame] - line).norm() > possible.max(MIN_RETURN * travel)
        })
    };
    let mut spikes = Vec::new();
    let mut frame = 1;
    while frame + 1 < track.len() {
        let ends = frame + 1..(frame + max_frames + 1).min(track.len());
        match ends.map(|end| frame..end).find(is_spike) {
            Some(spike) => {
                frame = spike.end + 1;
                spikes.push(spike);
            }
            None => frame += 1,
        }
    }
    spikes
}

/// Returns the clip with a joint on a straight line during the given spikes.
pub(super) fn repair(clip: &Clip, joint: usize, spikes: &[Range<usize>]) -> Clip {
    let (mut values, width) = (clip.values().to_vec(), clip.channel_count());
    let channels = &clip.joints()[joint].channels;
    let slots = clip.channel_range(joint).zip(channels);
    for (slot, _) in slots.filter(|(_, channel)| matches!(channel, Channel::Position(_))) {
        for spike in spikes {
            let [before, after] = [spike.start - 1, spike.end].map(|frame| clip.row(frame)[slot]);
            for frame in spike.clone() {
                let fraction = (frame + 1 - spike.start) as f64 / (spike.len() + 1) as f64;
                values[frame * width + slot] = before + (after - before) * fraction;
            }
        }
    }
    Clip::new(clip.joints().to_vec(), clip.frame_time(), values).with_position_rule(clip.position_rule())
}

/// Returns the values of a joint's position channels, in file units.
fn position(clip: &Clip, joint: usize, frame: usize) -> Vector3<f64> {
    let mut position = Vector3::zeros();
    for (slot, channel) in clip.channel_range(joint).zip(&clip.joints()[joint].channels) {
        if let Channel::Position(axis) = channel {
            position[axis.index()] = clip.row(frame)[slot];
        }
    }
    position
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvh::{Axis, Joint, JointKind};

    fn clip(rate: f64, heights: &[f64]) -> Clip {
        let channels = Axis::ALL.map(Channel::Position).to_vec();
        let hips = Joint {
            name: "hips".into(),
            kind: JointKind::Root,
            parent: None,
            offset: Vector3::zeros(),
            channels,
        };
        // The hips travel at 1.5 leg lengths per second.
        let values = heights.iter().enumerate();
        let values =
            values.flat_map(|(frame, &height)| [1.5 * frame as f64 / rate, 1.0 + height, 0.0]).collect();
        Clip::new(vec![hips], 1.0 / rate, values)
    }

    #[test]
    fn short_jumps_and_back_are_spikes() {
        for rate in [24.0, 30.0, 60.0, 120.0, 240.0] {
            for length in 1..=((0.05 * rate) as usize).max(1) {
                let mut heights = vec![0.0; 40];
                heights[20..20 + length].fill(-0.3);
                let spiked = clip(rate, &heights);
                let spikes = find(&spiked, 0, 1.0);
                assert_eq!(spikes, [20..20 + length], "{length} frames at {rate} Hz");
                let repaired = repair(&spiked, 0, &spikes);
                let smooth = clip(rate, &[0.0; 40]);
                assert!(repaired.values().iter().zip(smooth.values()).all(|(a, b)| (a - b).abs() < 1e-12));
            }
        }
    }

    #[test]
    fn other_motion_has_no_spikes() {
        for rate in [24.0, 30.0, 60.0, 120.0, 240.0] {
            let at = |height: &dyn Fn(f64) -> f64| -> Vec<f64> {
                (0..80).map(|frame| height(frame as f64 / rate)).collect()
            };
            // A jump to another place, a hop, and a fall that ends at once.
            for heights in [
                at(&|time| f64::from(time > 0.15)),
                at(&|time| (0.3 - 16.0 * (time - 0.2).powi(2)).max(0.0)),
                at(&|time| -(5.5 * time * time).min(0.8)),
            ] {
                assert_eq!(find(&clip(rate, &heights), 0, 1.0), [], "{rate} Hz");
            }
        }
    }
}
