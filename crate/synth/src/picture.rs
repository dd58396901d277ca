//! A clip as a line drawing: some poses in a row, as in a chronophotograph.

use std::fmt::Write;

use nalgebra::Vector3;
use plantigrade::bvh::Clip;
use plantigrade::kinematics::Kinematics;
use plantigrade::skeleton::{Overrides, Role, Skeleton};

/// Width and height of the drawing.
const SIZE: (f64, f64) = (160.0, 100.0);
/// Room beside the first and the last pose.
const MARGIN: f64 = 27.0;
/// Poses in a drawing.
const POSES: usize = 4;
/// Seconds from one pose to the next.
const STEP: f64 = 0.2;
/// Drawing units per metre, and the ground's height in the drawing.
const SCALE: f64 = 41.0;
const GROUND: f64 = 91.0;

/// The lines of the body; each is drawn as far as its joints are there.
const LINES: [&[Role]; 6] = [
    &[Role::Hips, Role::Spine, Role::Chest, Role::Neck, Role::Head],
    &[Role::Chest, Role::LeftArm, Role::LeftForearm, Role::LeftHand],
    &[Role::Chest, Role::RightArm, Role::RightForearm, Role::RightHand],
    &[Role::Hips, Role::LeftThigh, Role::LeftShank, Role::LeftAnkle, Role::LeftToe, Role::LeftTip],
    &[Role::Hips, Role::RightThigh, Role::RightShank, Role::RightAnkle, Role::RightToe, Role::RightTip],
    &[Role::Neck, Role::Head],
];

/// An SVG of the liveliest moment of `clip`, in `currentColor`, seen from the side.
pub fn picture(clip: &Clip) -> String {
    let body = Body::new(clip);
    let step = ((STEP * clip.rate()).round() as usize).max(1);
    let last = clip.frame_count().saturating_sub(step * POSES).max(1);
    // Every half second is often enough to find a lively moment.
    let starts = (clip.frame_count() / 20..last).step_by((clip.rate() / 2.0) as usize);
    let liveliness = |start: &usize| body.liveliness(*start, step);
    let start = starts.max_by(|a, b| liveliness(a).total_cmp(&liveliness(b))).unwrap_or(0);

    let (width, height) = SIZE;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" fill=\"none\" \
         stroke=\"currentColor\" stroke-width=\"2.4\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n\
         <path d=\"M8 {GROUND}H152\" stroke-width=\"1\" opacity=\".35\"/>\n"
    );
    for pose in 0..POSES {
        let opacity = 0.3 + 0.7 * pose as f64 / (POSES - 1) as f64;
        // Arms and legs reach out to either side, so the outer poses keep off the edges.
        let middle = MARGIN + (width - 2.0 * MARGIN) * pose as f64 / (POSES - 1) as f64;
        // Writing to a String cannot fail.
        let _ = writeln!(svg, "<g opacity=\"{opacity:.2}\">{}</g>", body.draw(start + pose * step, middle));
    }
    svg + "</svg>\n"
}

struct Body<'a> {
    clip: &'a Clip,
    skeleton: Skeleton,
}

impl Body<'_> {
    fn new(clip: &Clip) -> Body<'_> {
        Body { clip, skeleton: Skeleton::main(clip, &Overrides::default()) }
    }

    /// Places of the roles in metres, Y up; the ground is at height 0 in generated clips.
    fn pose(&self, frame: usize) -> impl Fn(Role) -> Option<Vector3<f64>> + use<> {
        let mut kinematics = Kinematics::new(self.clip);
        let pose = kinematics.pose(frame).to_vec();
        let (up, metres, roles) =
            (self.skeleton.up, self.skeleton.metres_per_unit, self.skeleton.roles.clone());
        move |role| Some(up.to_y_up(pose[roles.get(role)?]) * metres)
    }

    /// How much hands and feet spread over the poses that a drawing from `start` would show.
    fn liveliness(&self, start: usize, step: usize) -> f64 {
        let spread = |pose: usize| {
            let at = self.pose(start + pose * step);
            let between = |a, b| at(a).zip(at(b)).map_or(0.0, |(a, b)| (a - b).norm());
            let rise = at(Role::LeftAnkle).zip(at(Role::RightAnkle)).map_or(0.0, |(a, b)| a.y.max(b.y));
            between(Role::LeftAnkle, Role::RightAnkle) + 0.5 * between(Role::LeftHand, Role::RightHand) + rise
        };
        (0..POSES).map(spread).sum()
    }

    /// One pose about `middle`, seen from the side that shows most of the stride.
    fn draw(&self, frame: usize, middle: f64) -> String {
        let at = self.pose(frame);
        let (Some(hips), Some(left), Some(right)) =
            (at(Role::Hips), at(Role::LeftThigh), at(Role::RightThigh))
        else {
            return String::new();
        };
        // Forward is across the hips, level with the ground.
        let across = left - right;
        let forward = Vector3::new(-across.z, 0.0, across.x).normalize();
        let project =
            |place: Vector3<f64>| (middle + SCALE * forward.dot(&(place - hips)), GROUND - SCALE * place.y);
        let mut path = String::new();
        for line in LINES {
            for (index, place) in line.iter().filter_map(|&role| at(role)).enumerate() {
                let (x, y) = project(place);
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
