//! Clip: a hierarchy of joints and the channel values that animate it.

use std::ops::Range;

use nalgebra::Vector3;

/// A coordinate axis of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// The first coordinate.
    X,
    /// The second coordinate.
    Y,
    /// The third coordinate.
    Z,
}

impl Axis {
    /// All axes in coordinate order.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// Returns the index of the coordinate: 0, 1 or 2.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// Meaning of one number of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Channel {
    /// Coordinate of the joint's position relative to its parent, in file units.
    Position(Axis),
    /// Rotation about one axis, in degrees. Rotations apply in channel order.
    Rotation(Axis),
    /// Factor of the size along one axis, which is read and written but not used.
    Scale(Axis),
}

impl Channel {
    /// Returns the name of the channel in BVH, as in `Zrotation`.
    pub fn name(self) -> &'static str {
        match self {
            Channel::Position(Axis::X) => "Xposition",
            Channel::Position(Axis::Y) => "Yposition",
            Channel::Position(Axis::Z) => "Zposition",
            Channel::Rotation(Axis::X) => "Xrotation",
            Channel::Rotation(Axis::Y) => "Yrotation",
            Channel::Rotation(Axis::Z) => "Zrotation",
            Channel::Scale(Axis::X) => "Xscale",
            Channel::Scale(Axis::Y) => "Yscale",
            Channel::Scale(Axis::Z) => "Zscale",
        }
    }
}

/// Kind of a joint in the hierarchy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// Top of a skeleton (`ROOT`).
    Root,
    /// Joint with a parent (`JOINT`).
    Joint,
    /// Tip of a bone, without channels (`End Site`).
    EndSite,
}

/// One joint of a hierarchy.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Name in the file, decoded; [`END_SITE`] for an end site.
    pub name: String,
    /// Root, joint or end site.
    pub kind: JointKind,
    /// Index of the parent, always smaller than the joint's; `None` for a root.
    pub parent: Option<usize>,
    /// Rest position relative to the parent, in file units.
    pub offset: Vector3<f64>,
    /// Channels of the joint in file order.
    pub channels: Vec<Channel>,
}

/// Name of end sites in [`Joint::name`].
pub const END_SITE: &str = "End Site";

/// Rule for the position channels of joints other than roots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PositionRule {
    /// A position channel replaces that component of the offset (the usual rule).
    #[default]
    Replace,
    /// A position channel is added to the offset, as some exporters write it.
    Add,
    /// Position channels are coordinates in the axes of the file, not relative to the parent: the joints
    /// are points, whose positions are exactly the values. Files never have this rule.
    Global,
}

/// Returns the joint before `index` and all its ancestors: the valid parents of joint `index`.
fn possible_parents(joints: &[Joint], index: usize) -> impl Iterator<Item = usize> + '_ {
    std::iter::successors(index.checked_sub(1), |&joint| joints[joint].parent)
}

/// A hierarchy with its motion.
///
/// Joints are in file order, depth first: a joint follows its parent or the whole branch of an
/// earlier sibling. A frame is one row of numbers: the channels of all joints in joint order.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    joints: Vec<Joint>,
    /// Index of each joint's first channel in a row, followed by the length of a row.
    first_channels: Vec<usize>,
    frame_time: f64,
    values: Vec<f64>,
    position_rule: PositionRule,
}

impl Clip {
    /// Creates a clip. `values` is frames × channels in row-major order, in file units and degrees;
    /// `frame_time` is the time between frames, in seconds.
    ///
    /// # Panics
    /// If the joints are not in depth-first order, an end site has channels, or `values` is not a
    /// whole number of rows.
    pub fn new(joints: Vec<Joint>, frame_time: f64, values: Vec<f64>) -> Clip {
        let mut first_channels = Vec::with_capacity(joints.len() + 1);
        let mut width = 0;
        for (index, joint) in joints.iter().enumerate() {
            assert!(
                joint.parent.is_none_or(|parent| possible_parents(&joints, index).any(|j| j == parent)),
                "joint {index} is not in depth-first order"
            );
            assert!(
                joint.kind != JointKind::EndSite || joint.channels.is_empty(),
                "end site {index} must not have channels"
            );
            first_channels.push(width);
            width += joint.channels.len();
        }
        first_channels.push(width);
        assert!(
            if width == 0 { values.is_empty() } else { values.len().is_multiple_of(width) },
            "{} values are not whole rows of {width} channels",
            values.len()
        );
        Clip { joints, first_channels, frame_time, values, position_rule: PositionRule::Replace }
    }

    /// Returns the clip with another rule for the position channels of joints other than roots.
    pub fn with_position_rule(self, position_rule: PositionRule) -> Clip {
        Clip { position_rule, ..self }
    }

    /// Returns the same skeleton with a range of the frames.
    ///
    /// # Panics
    /// If the range exceeds the frames of the clip.
    pub fn slice(&self, frames: Range<usize>) -> Clip {
        let width = self.channel_count();
        let values = self.values[frames.start * width..frames.end * width].to_vec();
        Clip { joints: self.joints.clone(), first_channels: self.first_channels.clone(), values, ..*self }
    }

    /// Returns all channel values in row-major order, to be changed.
    pub(crate) fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Sets the time between frames, in seconds.
    pub fn set_frame_time(&mut self, frame_time: f64) {
        self.frame_time = frame_time;
    }

    /// Returns all joints and end sites, parents before children.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Returns the indices of the roots: one per skeleton.
    pub fn roots(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.joints.len()).filter(|&joint| self.joints[joint].parent.is_none())
    }

    /// Returns the joints of the skeleton below `root`, parents first.
    pub fn skeleton_joints(&self, root: usize) -> Range<usize> {
        let next = self.joints[root + 1..].iter().position(|joint| joint.parent.is_none());
        root..next.map_or(self.joints.len(), |count| root + 1 + count)
    }

    /// Returns the range of the channels of `joint` in a row.
    pub fn channel_range(&self, joint: usize) -> Range<usize> {
        self.first_channels[joint]..self.first_channels[joint + 1]
    }

    /// Returns the number of channels, the length of a row.
    pub fn channel_count(&self) -> usize {
        self.first_channels[self.joints.len()]
    }

    /// Returns the number of frames; 0 for a hierarchy without motion.
    pub fn frame_count(&self) -> usize {
        self.values.len().checked_div(self.channel_count()).unwrap_or(0)
    }

    /// Returns the time between frames, in seconds.
    pub fn frame_time(&self) -> f64 {
        self.frame_time
    }

    /// Returns the frame rate, in Hz.
    pub fn rate(&self) -> f64 {
        1.0 / self.frame_time
    }

    /// Returns the channel values of one frame, in joint order.
    ///
    /// # Panics
    /// If `frame` is not a frame of the clip.
    pub fn row(&self, frame: usize) -> &[f64] {
        let width = self.channel_count();
        &self.values[frame * width..(frame + 1) * width]
    }

    /// Returns all channel values in row-major order.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns the rule for the position channels of joints other than roots.
    pub fn position_rule(&self) -> PositionRule {
        self.position_rule
    }
}
