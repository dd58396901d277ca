//! Path of each foot over time, computed from the plan.

use plantigrade::foot::Side;

use crate::character::{Proportions, lateral_sign};
use crate::math::{
    Keyframe, Rot, Track, Vec3, bump, ease_in_out, forward, heading_rotation, leftward, lerp, rotation_about,
    smooth_step,
};
use crate::plan::{FootPlan, Placement, Stance, Step, stances};

/// Pose of a foot, in metres and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FootPose {
    /// Position of the ankle joint.
    pub ankle: Vec3,
    /// Heading of the foot, positive to the left.
    pub heading: f64,
    /// Pitch of the foot, positive with the heel up.
    pub pitch: f64,
    /// Dorsiflexion of the toes relative to the foot.
    pub bend: f64,
    /// Outward rotation of the knee in addition to that implied by foot and pelvis.
    pub turnout: f64,
    /// Weight of corrections of the pose: 0 while the foot stands, rising to 1 away from the
    /// ground.
    pub freedom: f64,
}

impl FootPose {
    /// Raises an airborne foot that would penetrate the floor, with a soft transition.
    pub fn clear_floor(&mut self, proportions: &Proportions) {
        let foot = self.rotation();
        let sole = |z: f64| foot * Vec3::new(0.0, -proportions.ankle, z);
        let toes = rotation_about(0, -self.bend) * Vec3::new(0.0, -0.8 * proportions.ball, proportions.toes);
        let tip = foot * (Vec3::new(0.0, proportions.ball - proportions.ankle, proportions.instep) + toes);
        let lowest = sole(-proportions.heel).y.min(sole(proportions.instep).y).min(tip.y);
        let depth = (SOFT_FLOOR - self.ankle.y - lowest).max(0.0);
        let lift =
            if depth < 2.0 * SOFT_FLOOR { depth * depth / (4.0 * SOFT_FLOOR) } else { depth - SOFT_FLOOR };
        self.ankle.y += lift * self.freedom;
    }

    /// Returns the orientation of the foot.
    pub fn rotation(&self) -> Rot {
        heading_rotation(self.heading) * rotation_about(0, self.pitch)
    }
}

/// Height of the soft zone above the floor, in metres.
const SOFT_FLOOR: f64 = 0.012;

/// Time after toe-off and before foot strike in which a swinging foot follows its path closely, in
/// seconds.
const NEAR_GROUND_TIME: f64 = 0.1;

/// Minimum of this time, for the shortest stances, in seconds.
const MIN_NEAR_GROUND_TIME: f64 = 0.03;

/// Path of one foot.
pub struct FootPath<'a> {
    side: Side,
    proportions: &'a Proportions,
    plan: &'a FootPlan,
    stances: Vec<Stance>,
    swings: Vec<Swing>,
}

/// Pitch of the foot and bend of the toes during a swing, in degrees.
struct Swing {
    pitch: Track<1>,
    bend: Track<1>,
}

impl<'a> FootPath<'a> {
    /// Creates the path of one foot from its plan.
    pub fn new(side: Side, plan: &'a FootPlan, proportions: &'a Proportions) -> FootPath<'a> {
        let mut path = FootPath { side, proportions, plan, stances: stances(plan), swings: Vec::new() };
        path.swings =
            plan.steps.iter().zip(&path.stances).map(|(step, from)| path.swing(step, from)).collect();
        path
    }

    /// Stances of the foot in order of time.
    pub fn stances(&self) -> &[Stance] {
        &self.stances
    }

    /// Returns the stance at `time`, or `None` during a swing.
    pub fn stance_at(&self, time: f64) -> Option<&Stance> {
        let stance = &self.stances[self.index(time)];
        (time < stance.toe_off).then_some(stance)
    }

    /// Returns the pitch of the foot during a stance, in degrees.
    pub fn stance_pitch(&self, stance: &Stance, time: f64) -> f64 {
        let Stance { landing, lift, .. } = stance;
        let landed = progress(time, stance.strike, stance.settled);
        let rolled = progress(time, stance.heel_off, stance.toe_off);
        let landing_left = (1.0 - landed) * (1.0 - landed);
        let heel_raise = self.plan.heel_raise.at(time)[0] * (1.0 - landing_left) * (1.0 - rolled * rolled);
        let rest = landing.rest + heel_raise;
        rest + (landing.pitch - rest) * landing_left + (lift.pitch - rest) * rolled * rolled
    }

    /// Returns the foot at `time`, without leg poses applied.
    pub fn at(&self, time: f64) -> FootPose {
        let index = self.index(time);
        let stance = &self.stances[index];
        if time < stance.toe_off {
            self.stance_pose(stance, time)
        } else {
            self.swing_pose(
                [stance, &self.stances[index + 1]],
                &self.plan.steps[index],
                &self.swings[index],
                time,
            )
        }
    }

    /// Returns the step in progress at `time`, or `None` during a stance.
    pub fn step(&self, time: f64) -> Option<&Step> {
        let index = self.index(time);
        if time < self.stances[index].toe_off { None } else { self.plan.steps.get(index) }
    }

    fn index(&self, time: f64) -> usize {
        self.stances.partition_point(|stance| stance.strike <= time).max(1) - 1
    }

    fn swing(&self, step: &Step, from: &Stance) -> Swing {
        let (landing, swing_path, toe_off) = (&step.landing, &step.swing_path, step.toe_off());
        let rest = from.landing.rest;
        let lift_rate = slope(2.0 * (step.lift.pitch - rest), from.toe_off - from.heel_off);
        let landing_rate = slope(2.0 * (landing.rest - landing.pitch), landing.settle);
        let key =
            |time, value, slope: Option<f64>| Keyframe { time, value: [value], slope: slope.map(|s| [s]) };
        let start = key(toe_off, step.lift.pitch, Some(lift_rate));
        let end = key(step.strike, landing.pitch, Some(landing_rate));
        let middle = key(toe_off + swing_path.pitch_at * step.swing, swing_path.pitch, None);
        let pitch = Track::from_keyframes([start, middle, end]);
        if swing_path.grounded {
            return Swing { bend: pitch.clone(), pitch };
        }
        let short = step.swing.min(0.6);
        let toes_up = landing.pitch > 0.0;
        let bend = Track::from_keyframes([
            key(toe_off, step.lift.pitch.max(0.0), Some(lift_rate.max(0.0))),
            key(toe_off + 0.4 * short, 0.0, None),
            key(step.strike - 0.4 * short, 0.0, None),
            key(step.strike, landing.pitch.max(0.0), Some(if toes_up { landing_rate } else { 0.0 })),
        ]);
        Swing { pitch, bend }
    }

    fn stance_pose(&self, stance: &Stance, time: f64) -> FootPose {
        let pitch = self.stance_pitch(stance, time).to_radians();
        let placement = self.pivoted(stance, time);
        let (anchor, point) = if pitch < 0.0 { self.heel(&placement) } else { self.ball(&placement) };
        self.anchored(anchor, point, placement.heading, pitch, pitch.max(0.0), 0.0)
    }

    fn swing_pose(&self, [from, to]: [&Stance; 2], step: &Step, swing: &Swing, time: f64) -> FootPose {
        let swing_path = &step.swing_path;
        let u = progress(time, step.toe_off(), step.strike);
        let start = self.pivoted(from, from.toe_off);
        let (start_anchor, start_point) = self.ball(&start);
        let lands_on_heel = step.landing.pitch < 0.0;
        let (end_anchor, end_point) =
            if lands_on_heel { self.heel(&step.placement) } else { self.ball(&step.placement) };
        let along = ease_in_out(u, swing_path.ramps.0, swing_path.ramps.1);
        let shift = smooth_step(u);
        let heading = lerp(start.heading, step.placement.heading, shift);
        let sideways = leftward(lerp(start.heading, step.placement.heading, 0.5))
            * lateral_sign(self.side)
            * swing_path.detour;
        let mut point = start_point.lerp(&end_point, along) + sideways * bump(u, 0.5);
        point.y = lerp(start_point.y, end_point.y, shift) + swing_path.clearance * bump(u, swing_path.peak);
        let pitch = swing.pitch.at(time)[0].to_radians();
        let bend = swing.bend.at(time)[0].to_radians();
        let leaving = (time - step.toe_off()) / near_ground_time(from);
        let landing = (step.strike - time) / near_ground_time(to);
        let freedom = if swing_path.grounded { 0.0 } else { smooth_step(leaving.min(landing)) };
        self.anchored(start_anchor.lerp(&end_anchor, shift), point, heading, pitch, bend, freedom)
    }

    /// Returns the placement of a stance, including the pivot up to `time`.
    fn pivoted(&self, stance: &Stance, time: f64) -> Placement {
        let turn = self.plan.pivot.at(time)[0] - self.plan.pivot.at(stance.strike)[0];
        stance.placement.rotated(turn)
    }

    /// Returns the ball joint relative to the ankle, and its position on the ground.
    fn ball(&self, placement: &Placement) -> (Vec3, Vec3) {
        let proportions = self.proportions;
        let anchor = Vec3::new(0.0, proportions.ball - proportions.ankle, proportions.instep);
        (anchor, placement.point() + Vec3::new(0.0, proportions.ball, 0.0))
    }

    /// Returns the edge of the heel relative to the ankle, and its position on the ground.
    fn heel(&self, placement: &Placement) -> (Vec3, Vec3) {
        let proportions = self.proportions;
        let anchor = Vec3::new(0.0, -proportions.ankle, -proportions.heel);
        (anchor, placement.point() - (proportions.instep + proportions.heel) * forward(placement.heading))
    }

    /// Returns the foot pose in which the local point `anchor` is at `point`.
    fn anchored(
        &self,
        anchor: Vec3,
        point: Vec3,
        heading: f64,
        pitch: f64,
        bend: f64,
        freedom: f64,
    ) -> FootPose {
        let mut foot = FootPose { ankle: point, heading, pitch, bend, turnout: 0.0, freedom };
        foot.ankle = point - foot.rotation() * anchor;
        foot
    }
}

/// Returns the time before and after a stance in which the foot follows its path, in seconds;
/// shorter for sprints, in which the leg cannot follow longer.
fn near_ground_time(stance: &Stance) -> f64 {
    match stance.toe_off - stance.strike {
        // A sliding foot has a stance of zero length.
        length if length < 1e-6 => NEAR_GROUND_TIME,
        length => (length - NEAR_GROUND_TIME).clamp(MIN_NEAR_GROUND_TIME, NEAR_GROUND_TIME),
    }
}

/// Returns the position of `time` between `start` and `end`, clamped to 0–1.
fn progress(time: f64, start: f64, end: f64) -> f64 {
    if time >= end {
        1.0
    } else if time <= start {
        0.0
    } else {
        (time - start) / (end - start)
    }
}

fn slope(rise: f64, run: f64) -> f64 {
    if run > 1e-6 { rise / run } else { 0.0 }
}
