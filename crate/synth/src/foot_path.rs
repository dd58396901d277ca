//! Path of each foot over time, computed from the plan.

use plantigrade::foot::Side;

use crate::character::{Proportions, lateral_sign};
use crate::math::{
    Keyframe, Rot, Track, Vec3, bump, ease_in_out, forward, heading_rotation, leftward, lerp, rotation_about,
    smooth_step,
};
use crate::plan::{EndMotion, FootPlan, Placement, Stance, Step, stances};

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
        let depth = (SOFT_FLOOR - self.lowest_point(proportions)).max(0.0);
        let lift =
            if depth < 2.0 * SOFT_FLOOR { depth * depth / (4.0 * SOFT_FLOOR) } else { depth - SOFT_FLOOR };
        self.ankle.y += lift * self.freedom;
    }

    /// Returns the height of the lowest point of the sole: of heel, ball and tip of the toes.
    fn lowest_point(&self, proportions: &Proportions) -> f64 {
        let foot = self.rotation();
        let toes = rotation_about(0, -self.bend) * Vec3::new(0.0, -0.8 * proportions.ball, proportions.toes);
        let tip = foot * (Vec3::new(0.0, proportions.ball - proportions.ankle, proportions.instep) + toes);
        let ball = foot * Vec3::new(0.0, -proportions.ankle, proportions.instep);
        let (radius, centre) = heel_curve(proportions);
        let heel = (foot * centre).y - radius;
        self.ankle.y + heel.min(ball.y).min(tip.y)
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

/// Largest duration of the motions at the ends of a swing, in seconds and as a fraction of the swing.
const END_MOTION_TIME: (f64, f64) = (0.15, 0.45);

/// Largest time of the motions at the ends of a stance, as a fraction of the stance.
const MAX_END_FRACTION: f64 = 0.4;

/// Radius of the curve at the back of the heel, as a fraction of its distance behind the ankle.
const HEEL_ROUNDNESS: f64 = 0.65;

/// Time in which a foot rises before toe-off, as a fraction of the time in which it moves.
const RISE_FRACTION: f64 = 0.6;

/// Rate of the pitch before a strike with an impact, as a fraction of the rate after it.
const PITCH_RATE_BEFORE_IMPACT: f64 = 0.4;

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
    /// Displacement of the foot before and after toe-off.
    take_off: Displacement,
    /// Displacement of the foot before and after the strike.
    touch_down: Displacement,
}

/// Displacement of a foot that has a velocity at the end of a swing, from the path of a foot that
/// is at rest there.
#[derive(Clone, Copy, Default)]
struct Displacement {
    /// Time of the foot strike or of toe-off, in seconds.
    time: f64,
    /// Velocity at that time, in m/s.
    velocity: Vec3,
    /// Time until the foot is at rest, or from rest, in seconds.
    ground_time: f64,
    /// Time in the air in which the displacement begins or ends, in seconds.
    air_time: f64,
}

impl Displacement {
    /// Displacement at a foot strike: the velocity decreases linearly to 0.
    fn at_strike(&self, time: f64) -> Vec3 {
        let since = time - self.time;
        let rest = -self.velocity * self.ground_time / 2.0;
        if since >= 0.0 {
            let left = 1.0 - progress(since, 0.0, self.ground_time);
            rest * left * left
        } else {
            (rest + self.velocity * since) * self.fade(-since)
        }
    }

    /// Displacement at toe-off: the vertical speed grows linearly; the horizontal speed begins to grow
    /// earlier, with the third power of the time.
    fn at_toe_off(&self, time: f64) -> Vec3 {
        let since = time - self.time;
        let (creep_time, rise_time) = (self.ground_time, self.rise_time());
        let along = Vec3::new(self.velocity.x, 0.0, self.velocity.z);
        let up = self.velocity.y * Vec3::y();
        if since <= 0.0 {
            let (crept, risen) = (progress(since, -creep_time, 0.0), progress(since, -rise_time, 0.0));
            along * (creep_time / 4.0 * crept * crept * crept * crept)
                + up * (rise_time / 2.0 * risen * risen)
        } else {
            let moved = along * creep_time / 4.0 + up * rise_time / 2.0;
            (moved + self.velocity * since) * self.fade(since)
        }
    }

    /// Time in which the ball rises before toe-off, in seconds.
    fn rise_time(&self) -> f64 {
        RISE_FRACTION * self.ground_time
    }

    fn fade(&self, since: f64) -> f64 {
        if self.air_time > 0.0 { 1.0 - smooth_step(since / self.air_time) } else { 0.0 }
    }
}

impl<'a> FootPath<'a> {
    /// Creates the path of one foot from its plan.
    pub fn new(side: Side, plan: &'a FootPlan, proportions: &'a Proportions) -> FootPath<'a> {
        let mut path = FootPath { side, proportions, plan, stances: stances(plan), swings: Vec::new() };
        let pairs = path.stances.windows(2).zip(&plan.steps);
        path.swings = pairs.map(|(ends, step)| path.swing(step, &ends[0], &ends[1])).collect();
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

    /// True if the foot stands at `time` and the part of it on the ground is still: after the impact of
    /// the strike and before the ball rises.
    pub fn is_at_rest(&self, time: f64) -> bool {
        let index = self.index(time);
        let stance = &self.stances[index];
        let stopped = index.checked_sub(1).map_or(0.0, |before| self.swings[before].touch_down.ground_time);
        let rising = self.swings.get(index).map_or(0.0, |swing| swing.take_off.rise_time());
        time >= stance.strike + stopped && time < stance.toe_off - rising
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
            let landed = index.checked_sub(1).map(|before| self.swings[before].touch_down.at_strike(time));
            let leaving = self.swings.get(index).map(|swing| swing.take_off.at_toe_off(time));
            self.stance_pose(stance, time, landed.unwrap_or_default() + leaving.unwrap_or_default())
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

    fn swing(&self, step: &Step, from: &Stance, to: &Stance) -> Swing {
        let [take_off, touch_down] = self.displacements(step, from, to);
        let (landing, swing_path, toe_off) = (&step.landing, &step.swing_path, step.toe_off());
        let rest = from.landing.rest;
        let lift_rate = slope(2.0 * (step.lift.pitch - rest), from.toe_off - from.heel_off);
        let landing_rate = slope(2.0 * (landing.rest - landing.pitch), landing.settle);
        let impact = touch_down.velocity != Vec3::zeros();
        let landing_rate = if impact { PITCH_RATE_BEFORE_IMPACT * landing_rate } else { landing_rate };
        let key =
            |time, value, slope: Option<f64>| Keyframe { time, value: [value], slope: slope.map(|s| [s]) };
        let start = key(toe_off, step.lift.pitch, Some(lift_rate));
        let end = key(step.strike, landing.pitch, Some(landing_rate));
        let middle = key(toe_off + swing_path.pitch_at * step.swing, swing_path.pitch, None);
        let pitch = Track::from_keyframes([start, middle, end]);
        if swing_path.grounded {
            return Swing { bend: pitch.clone(), pitch, take_off, touch_down };
        }
        let short = step.swing.min(0.6);
        let bend_at = |pitch: f64, raised: f64| self.bend(pitch.to_radians(), raised).to_degrees();
        let bend_off = bend_at(step.lift.pitch, take_off.at_toe_off(toe_off).y);
        let bend_strike = bend_at(landing.pitch, touch_down.at_strike(step.strike).y);
        let rate = |soft: bool, rate: f64| if soft { Some(rate) } else { None };
        let bend = Track::from_keyframes([
            key(toe_off, bend_off, rate(take_off.velocity.y == 0.0, lift_rate.max(0.0))),
            key(toe_off + 0.4 * short, 0.0, None),
            key(step.strike - 0.4 * short, 0.0, None),
            key(step.strike, bend_strike, Some(if landing.pitch > 0.0 { landing_rate } else { 0.0 })),
        ]);
        Swing { pitch, bend, take_off, touch_down }
    }

    /// Returns the displacements at toe-off and at the strike of a step.
    fn displacements(&self, step: &Step, from: &Stance, to: &Stance) -> [Displacement; 2] {
        let swing_path = &step.swing_path;
        if swing_path.grounded {
            return [Displacement::default(); 2];
        }
        let mut mean = (step.placement.point() - self.pivoted(from, from.toe_off).point()) / step.swing;
        mean.y = 0.0;
        let displacement = |motion: &EndMotion, stance: &Stance, time: f64, up: f64| {
            let ground_time = motion.time.min(MAX_END_FRACTION * (stance.toe_off - stance.strike));
            if ground_time < 1e-6 {
                return Displacement::default();
            }
            let velocity = motion.along * mean + up * motion.vertical * Vec3::y();
            let air_time = END_MOTION_TIME.0.min(END_MOTION_TIME.1 * step.swing);
            Displacement { time, velocity, ground_time, air_time }
        };
        [
            displacement(&swing_path.take_off, from, step.toe_off(), 1.0),
            displacement(&swing_path.touch_down, to, step.strike, -1.0),
        ]
    }

    /// Returns the bend of the toes, in radians, with which their tip is on the ground while the
    /// ball is raised by `raised` metres.
    fn bend(&self, pitch: f64, raised: f64) -> f64 {
        (pitch - libm::asin((raised / self.proportions.toes).clamp(0.0, 1.0))).max(0.0)
    }

    fn stance_pose(&self, stance: &Stance, time: f64, displacement: Vec3) -> FootPose {
        let pitch = self.stance_pitch(stance, time).to_radians();
        let placement = self.pivoted(stance, time);
        let (anchor, point) = if pitch < 0.0 { self.heel(&placement, pitch) } else { self.ball(&placement) };
        let bend = self.bend(pitch, displacement.y);
        self.anchored(anchor, point + displacement, placement.heading, pitch, bend, 0.0)
    }

    fn swing_pose(&self, [from, to]: [&Stance; 2], step: &Step, swing: &Swing, time: f64) -> FootPose {
        let swing_path = &step.swing_path;
        let u = progress(time, step.toe_off(), step.strike);
        let start = self.pivoted(from, from.toe_off);
        let (start_anchor, start_point) = self.ball(&start);
        let landing_pitch = step.landing.pitch.to_radians();
        let lands_on_heel = landing_pitch < 0.0;
        let (end_anchor, end_point) = if lands_on_heel {
            self.heel(&step.placement, landing_pitch)
        } else {
            self.ball(&step.placement)
        };
        let along = ease_in_out(u, swing_path.ramps.0, swing_path.ramps.1);
        let shift = smooth_step(u);
        let heading = lerp(start.heading, step.placement.heading, shift);
        let sideways = leftward(lerp(start.heading, step.placement.heading, 0.5))
            * lateral_sign(self.side)
            * swing_path.detour;
        let mut point = start_point.lerp(&end_point, along) + sideways * bump(u, 0.5);
        point.y = lerp(start_point.y, end_point.y, shift) + swing_path.clearance * bump(u, swing_path.peak);
        point += swing.take_off.at_toe_off(time) + swing.touch_down.at_strike(time);
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

    /// Returns the centre of the heel's curve relative to the ankle, and its position when the heel
    /// has the given pitch, in radians: the heel rolls on the ground.
    fn heel(&self, placement: &Placement, pitch: f64) -> (Vec3, Vec3) {
        let (radius, centre) = heel_curve(self.proportions);
        let behind = self.proportions.instep - centre.z - radius * pitch;
        (centre, placement.point() - behind * forward(placement.heading) + radius * Vec3::y())
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

/// Returns the radius of the curve at the back of the heel, and its centre relative to the ankle, in
/// metres.
fn heel_curve(proportions: &Proportions) -> (f64, Vec3) {
    let radius = HEEL_ROUNDNESS * proportions.heel;
    (radius, Vec3::new(0.0, radius - proportions.ankle, radius - proportions.heel))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::{Gait, Jump, Landing, Lift, Planner, SwingPath};

    /// Checks the left foot of a plan at its strikes and toe-offs.
    fn check(planner: Planner) {
        let plan = planner.finish();
        let proportions = Proportions::new(1.75, 1.0, 1.0);
        let path = FootPath::new(Side::Left, &plan.feet[0], &proportions);
        let velocity = |time: f64| (path.at(time + 1e-5).ankle - path.at(time - 1e-5).ankle) / 2e-5;
        for (step, ends) in plan.feet[0].steps.iter().zip(path.stances().windows(2)) {
            for time in [step.toe_off(), step.strike] {
                let [before, after] = [time - 1e-9, time + 1e-9].map(|time| path.at(time));
                assert!((before.ankle - after.ankle).norm() < 1e-6, "{time}");
                assert!((before.pitch - after.pitch).abs() < 1e-6 && (before.bend - after.bend).abs() < 1e-4);
            }
            let lowest = |time: f64| path.at(time).lowest_point(&proportions);
            // The sole touches the ground at the strike, and the tip of the toes at toe-off.
            assert!((-0.001..0.008).contains(&lowest(step.strike)), "{}", lowest(step.strike));
            assert!((-0.001..0.01).contains(&lowest(step.toe_off())), "{}", lowest(step.toe_off()));
            assert!(lowest(step.strike - 0.01) > lowest(step.strike) + 0.002);
            assert!(lowest(step.toe_off() + 0.015) > lowest(step.toe_off()) + 0.002);
            let falling = -velocity(step.strike - 0.002).y;
            assert!(falling > 0.8 * step.swing_path.touch_down.vertical, "{falling}");
            // The foot is at rest when it has rolled flat.
            assert!(velocity(ends[1].settled + 0.01).norm() < 1e-3);
        }
    }

    #[test]
    fn walking_feet_touch_and_leave_the_ground_at_the_events() {
        let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.09);
        for side in [Side::Left, Side::Right, Side::Left, Side::Right, Side::Left] {
            planner.step(side, &Gait::walk(1.0));
        }
        check(planner);
    }

    #[test]
    fn jumping_feet_touch_and_leave_the_ground_at_the_events() {
        let mut planner = Planner::standing(-1.0, Placement::ORIGIN, 0.09);
        let (take_off, touch_down) = EndMotion::jump(0.4);
        let jump = Jump {
            ground: 0.6,
            flight: 0.4,
            length: 0.3,
            turn: 0.0,
            width: 0.1,
            lift: Lift { pitch: 50.0, lead: 0.2 },
            swing_path: SwingPath { take_off, touch_down, clearance: 0.16, ..Gait::walk(1.0).swing_path },
            landing: Landing { pitch: 20.0, settle: 0.1, rest: 0.0 },
        };
        for _ in 0..3 {
            planner.jump(&Side::BOTH, &jump);
        }
        check(planner);
    }
}
