//! Thumbnails: line drawings of several poses in a row, as in chronophotography.

use std::fmt::Write;

use nalgebra::Vector3;
use plantigrade::bvh::Clip;
use plantigrade::kinematics::Kinematics;
use plantigrade::skeleton::{Overrides, Role, Skeleton};

/// Width and height of the drawing.
const SIZE: (f64, f64) = (160.0, 100.0);
/// Horizontal margin around the first and the last pose.
const MARGIN: f64 = 27.0;
/// Number of poses.
const POSES: usize = 4;
/// Time between poses, in seconds.
const STEP: f64 = 0.2;
/// Drawing units per metre, and vertical position of the ground.
const SCALE: f64 = 41.0;
const GROUND: f64 = 91.0;

/// Polylines of the body; joints that the skeleton lacks are skipped.
const LINES: [&[Role]; 6] = [
    &[Role::Hips, Role::Spine, Role::Chest, Role::Neck, Role::Head],
    &[Role::Chest, Role::LeftArm, Role::LeftForearm, Role::LeftHand],
    &[Role::Chest, Role::RightArm, Role::RightForearm, Role::RightHand],
    &[Role::Hips, Role::LeftThigh, Role::LeftShank, Role::LeftAnkle, Role::LeftToe, Role::LeftTip],
    &[Role::Hips, Role::RightThigh, Role::RightShank, Role::RightAnkle, Role::RightToe, Role::RightTip],
    &[Role::Neck, Role::Head],
];

/// Returns an SVG of the most expressive moment of `clip`, drawn in `currentColor` and seen from
/// the side.
pub fn svg(clip: &Clip) -> String {
    let body = Figure::new(clip);
    let step = ((STEP * clip.rate()).round() as usize).max(1);
    let last = clip.frame_count().saturating_sub(step * POSES).max(1);
    // Candidates every half second are enough to find an expressive moment.
    let starts = (clip.frame_count() / 20..last).step_by((clip.rate() / 2.0) as usize);
    let expressiveness = |start: &usize| body.expressiveness(*start, step);
    let start = starts.max_by(|a, b| expressiveness(a).total_cmp(&expressiveness(b))).unwrap_or(0);

    let (width, height) = SIZE;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" fill=\"none\" \
         stroke=\"currentColor\" stroke-width=\"2.4\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n\
         <path d=\"M8 {GROUND}H152\" stroke-width=\"1\" opacity=\".35\"/>\n"
    );
    for pose in 0..POSES {
        let opacity = 0.3 + 0.7 * pose as f64 / (POSES - 1) as f64;
        // The margin leaves space for limbs of the outer poses.
        let middle = MARGIN + (width - 2.0 * MARGIN) * pose as f64 / (POSES - 1) as f64;
        // Writing to a String cannot fail.
        let _ = writeln!(text, "<g opacity=\"{opacity:.2}\">{}</g>", body.draw(start + pose * step, middle));
    }
    text + "</svg>\n"
}

struct Figure<'a> {
    clip: &'a Clip,
    skeleton: Skeleton,
}

impl Figure<'_> {
    fn new(clip: &Clip) -> Figure<'_> {
        Figure { clip, skeleton: Skeleton::main(clip, &Overrides::default()) }
    }

    /// Returns joint positions by role in metres, Y up; generated clips have the ground at height
    /// 0.
    fn pose(&self, frame: usize) -> impl Fn(Role) -> Option<Vector3<f64>> + use<> {
        let mut kinematics = Kinematics::new(self.clip);
        let pose = kinematics.pose(frame).to_vec();
        let (up, metres, roles) =
            (self.skeleton.up, self.skeleton.metres_per_unit, self.skeleton.roles.clone());
        move |role| Some(up.to_y_up(pose[roles.get(role)?]) * metres)
    }

    /// Returns a score for the extension of hands and feet over the poses of a drawing that begins
    /// at `start`.
    fn expressiveness(&self, start: usize, step: usize) -> f64 {
        let extension = |pose: usize| {
            let at = self.pose(start + pose * step);
            let distance = |a, b| at(a).zip(at(b)).map_or(0.0, |(a, b)| (a - b).norm());
            let foot_height =
                at(Role::LeftAnkle).zip(at(Role::RightAnkle)).map_or(0.0, |(a, b)| a.y.max(b.y));
            distance(Role::LeftAnkle, Role::RightAnkle)
                + 0.5 * distance(Role::LeftHand, Role::RightHand)
                + foot_height
        };
        (0..POSES).map(extension).sum()
    }

    /// Draws one pose centred at `middle`, seen from the left or right of the hips.
    fn draw(&self, frame: usize, middle: f64) -> String {
        let at = self.pose(frame);
        let (Some(hips), Some(left), Some(right)) =
            (at(Role::Hips), at(Role::LeftThigh), at(Role::RightThigh))
        else {
            return String::new();
        };
        // Forward is perpendicular to the hip axis, parallel to the ground.
        let across = left - right;
        let forward = Vector3::new(-across.z, 0.0, across.x).normalize();
        let project = |position: Vector3<f64>| {
            (middle + SCALE * forward.dot(&(position - hips)), GROUND - SCALE * position.y)
        };
        let mut path = String::new();
        for line in LINES {
            for (index, position) in line.iter().filter_map(|&role| at(role)).enumerate() {
                let (x, y) = project(position);
                let _ = write!(path, "{}{x:.1} {y:.1}", if index == 0 { "M" } else { "L" });
            }
        }
        let mut drawing = format!("<path d=\"{path}\"/>");
        if let Some((x, y)) = at(Role::Head).map(project) {
            let _ = write!(
                drawing,
                "<circle cx=\"{x:.1}\" cy=\"{:.1}\" r=\"3.6\" fill=\"currentColor\"/>",
                y - 3.0
            );
        }
        drawing
    }
}
