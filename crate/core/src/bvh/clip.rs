//! The clip: a hierarchy of joints and the channel values that move it.

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

    /// The axis's place among the coordinates: 0, 1 or 2.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// What one number of a frame means for its joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Channel {
    /// A coordinate of the joint's position in its parent, in file units.
    Position(Axis),
    /// A rotation about one axis, in degrees; rotations apply in channel order.
    Rotation(Axis),
}

impl Channel {
    /// The name BVH gives the channel, as in `Zrotation`.
    pub fn name(self) -> &'static str {
        match self {
            Channel::Position(Axis::X) => "Xposition",
            Channel::Position(Axis::Y) => "Yposition",
            Channel::Position(Axis::Z) => "Zposition",
            Channel::Rotation(Axis::X) => "Xrotation",
            Channel::Rotation(Axis::Y) => "Yrotation",
            Channel::Rotation(Axis::Z) => "Zrotation",
        }
    }
}

/// What a joint is in the hierarchy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// The top of a skeleton (`ROOT`).
    Root,
    /// A joint with a parent (`JOINT`).
    Joint,
    /// The tip of a bone, without a name or channels of its own (`End Site`).
    EndSite,
}

/// One joint, with the offset that places it in its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The name as the file writes it; [`END_SITE`] for an end site.
    pub name: String,
    /// Root, joint or end site.
    pub kind: JointKind,
    /// Index of the parent, always smaller than the joint's own; `None` for a root.
    pub parent: Option<usize>,
    /// Rest position in the parent, in file units.
    pub offset: Vector3<f64>,
    /// The joint's own channels in the file's order.
    pub channels: Vec<Channel>,
}

/// The name that end sites bear in [`Joint::name`].
pub const END_SITE: &str = "End Site";

/// How the position channels of joints other than roots relate to `OFFSET`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PositionRule {
    /// A position channel replaces that component of the offset: the common rule.
    #[default]
    Replace,
    /// Position channels are added to the offset, as some exporters write them.
    Add,
}

/// The joint before `index` and all joints above that one.
fn branch_above(joints: &[Joint], index: usize) -> impl Iterator<Item = usize> + '_ {
    std::iter::successors(index.checked_sub(1), |&joint| joints[joint].parent)
}

/// A hierarchy with its motion.
///
/// Joints stand in file order, depth first: a joint comes right after its parent
/// or after the whole branch of an elder sibling. A frame is one row of numbers,
/// the channels of all joints in joint order.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    joints: Vec<Joint>,
    /// Where each joint's channels begin in a row, and the row's length last.
    starts: Vec<usize>,
    frame_time: f64,
    values: Vec<f64>,
    position_rule: PositionRule,
}

impl Clip {
    /// A clip of `joints` with the rows `values` (frames × channels, row by
    /// row; file units and degrees), `frame_time` seconds apart.
    ///
    /// # Panics
    /// If the joints are not in depth-first order, an end site has channels, or
    /// `values` is not a whole number of rows.
    pub fn new(joints: Vec<Joint>, frame_time: f64, values: Vec<f64>) -> Clip {
        let mut starts = Vec::with_capacity(joints.len() + 1);
        let mut width = 0;
        for (index, joint) in joints.iter().enumerate() {
            assert!(
                joint.parent.is_none_or(|parent| branch_above(&joints, index).any(|j| j == parent)),
                "joint {index} is not in depth-first order"
            );
            assert!(
                joint.kind != JointKind::EndSite || joint.channels.is_empty(),
                "end site {index} must not have channels"
            );
            starts.push(width);
            width += joint.channels.len();
        }
        starts.push(width);
        assert!(
            if width == 0 { values.is_empty() } else { values.len().is_multiple_of(width) },
            "{} values are not whole rows of {width} channels",
            values.len()
        );
        Clip { joints, starts, frame_time, values, position_rule: PositionRule::Replace }
    }

    /// The same clip with another rule for the position channels of joints
    /// other than roots.
    pub fn with_position_rule(self, position_rule: PositionRule) -> Clip {
        Clip { position_rule, ..self }
    }

    /// The same skeleton with some of the frames only.
    ///
    /// # Panics
    /// If there are no such frames.
    pub fn part(&self, frames: std::ops::Range<usize>) -> Clip {
        let width = self.channel_count();
        let values = self.values[frames.start * width..frames.end * width].to_vec();
        Clip { joints: self.joints.clone(), starts: self.starts.clone(), values, ..*self }
    }

    /// Sets the seconds from one frame to the next.
    pub fn set_frame_time(&mut self, frame_time: f64) {
        self.frame_time = frame_time;
    }

    /// All joints and end sites, parents before children.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Indices of the roots: one for each skeleton in the clip.
    pub fn roots(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.joints.len()).filter(|&joint| self.joints[joint].parent.is_none())
    }

    /// Indices of the children of `joint`.
    pub fn children(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        (joint + 1..self.joints.len()).filter(move |&child| self.joints[child].parent == Some(joint))
    }

    /// The range of `joint`'s channels in a row.
    pub fn channel_range(&self, joint: usize) -> std::ops::Range<usize> {
        self.starts[joint]..self.starts[joint + 1]
    }

    /// Channels in a row.
    pub fn channel_count(&self) -> usize {
        self.starts[self.joints.len()]
    }

    /// Number of frames; 0 for a hierarchy without motion.
    pub fn frame_count(&self) -> usize {
        self.values.len().checked_div(self.channel_count()).unwrap_or(0)
    }

    /// Seconds from one frame to the next.
    pub fn frame_time(&self) -> f64 {
        self.frame_time
    }

    /// Frames per second.
    pub fn rate(&self) -> f64 {
        1.0 / self.frame_time
    }

    /// The channel values of one frame, in joint order.
    ///
    /// # Panics
    /// If there is no such frame.
    pub fn row(&self, frame: usize) -> &[f64] {
        let width = self.channel_count();
        &self.values[frame * width..(frame + 1) * width]
    }

    /// All channel values, row by row.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// How position channels of joints other than roots relate to offsets.
    pub fn position_rule(&self) -> PositionRule {
        self.position_rule
    }
}
