//! From the plan to the path of each foot: where the ankle is and how the foot is
//! turned at any time.

use plantigrade::foot::Side;

use crate::character::{Build, outward};
use crate::curve::{Key, Track, bump, ramped, smooth_step};
use crate::maths::{Rot, Vec3, forward, heading, leftward, lerp, turn};
use crate::plan::{FootPlan, Place, Stance, Step, stances};

/// A foot at one moment. Metres and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FootPose {
    /// The ankle joint.
    pub ankle: Vec3,
    /// Turn of the foot to the left.
    pub heading: f64,
    /// Pitch of the foot, heel up.
    pub pitch: f64,
    /// Bend of the toes against the foot, toes up.
    pub bend: f64,
    /// Outward turn of the knee besides what follows from foot and pelvis.
    pub turnout: f64,
    /// 0 where the foot stands, rising to 1 as it gets away from the ground.
    pub freedom: f64,
}

impl FootPose {
    /// Lifts a foot in the air that would go through the floor, more softly than the
    /// floor would.
    pub fn clear_floor(&mut self, build: &Build) {
        let foot = self.rotation();
        let sole = |z: f64| foot * Vec3::new(0.0, -build.ankle, z);
        let toes = turn(0, -self.bend) * Vec3::new(0.0, -0.8 * build.ball, build.toes);
        let tip = foot * (Vec3::new(0.0, build.ball - build.ankle, build.instep) + toes);
        let lowest = sole(-build.heel).y.min(sole(build.instep).y).min(tip.y);
        let depth = (CUSHION - self.ankle.y - lowest).max(0.0);
        let give = if depth < 2.0 * CUSHION { depth * depth / (4.0 * CUSHION) } else { depth - CUSHION };
        self.ankle.y += give * self.freedom;
    }

    /// The foot's orientation.
    pub fn rotation(&self) -> Rot {
        heading(self.heading) * turn(0, self.pitch)
    }
}

/// Height in which a foot in the air gives way to the floor, in metres.
const CUSHION: f64 = 0.012;

/// Seconds near the ground in which a swinging foot is still bound to its path.
const NEAR_GROUND: f64 = 0.1;

/// The same around the shortest stances.
const NEAR_SPRINT: f64 = 0.03;

/// The path of one foot.
pub struct FootPath<'a> {
    side: Side,
    build: &'a Build,
    plan: &'a FootPlan,
    stances: Vec<Stance>,
    swings: Vec<Swing>,
}

/// How the pitch of a foot and the bend of its toes run during a swing, in degrees.
struct Swing {
    pitch: Track<1>,
    bend: Track<1>,
}

impl<'a> FootPath<'a> {
    /// The path that `plan` asks of a foot of that `build`.
    pub fn new(side: Side, plan: &'a FootPlan, build: &'a Build) -> FootPath<'a> {
        let mut path = FootPath { side, build, plan, stances: stances(plan), swings: Vec::new() };
        path.swings =
            plan.steps.iter().zip(&path.stances).map(|(step, from)| path.swing(step, from)).collect();
        path
    }

    /// The stances of the foot.
    pub fn stances(&self) -> &[Stance] {
        &self.stances
    }

    /// The stance at `time`, if the foot stands then.
    pub fn standing(&self, time: f64) -> Option<&Stance> {
        let stance = &self.stances[self.index(time)];
        (time < stance.off).then_some(stance)
    }

    /// Pitch of the foot while it stands, in degrees.
    pub fn standing_pitch(&self, stance: &Stance, time: f64) -> f64 {
        let Stance { landing, lift, .. } = stance;
        let landed = share(time, stance.strike, stance.settled);
        let rolled = share(time, stance.heel_off, stance.off);
        let landing_left = (1.0 - landed) * (1.0 - landed);
        let raise = self.plan.raise.at(time)[0] * (1.0 - landing_left) * (1.0 - rolled * rolled);
        let rest = landing.rest + raise;
        rest + (landing.pitch - rest) * landing_left + (lift.pitch - rest) * rolled * rolled
    }

    /// The foot at `time`, without any pose it is held in.
    pub fn at(&self, time: f64) -> FootPose {
        let index = self.index(time);
        let stance = &self.stances[index];
        if time < stance.off {
            self.stand(stance, time)
        } else {
            self.fly([stance, &self.stances[index + 1]], &self.plan.steps[index], &self.swings[index], time)
        }
    }

    /// The step that the foot is on at `time`, if it is in the air.
    pub fn step(&self, time: f64) -> Option<&Step> {
        let index = self.index(time);
        if time < self.stances[index].off { None } else { self.plan.steps.get(index) }
    }

    fn index(&self, time: f64) -> usize {
        self.stances.partition_point(|stance| stance.strike <= time).max(1) - 1
    }

    fn swing(&self, step: &Step, from: &Stance) -> Swing {
        let (landing, carry, off) = (&step.landing, &step.carry, step.off());
        let rest = from.landing.rest;
        let lift_rate = slope(2.0 * (step.lift.pitch - rest), from.off - from.heel_off);
        let landing_rate = slope(2.0 * (landing.rest - landing.pitch), landing.settle);
        let key = |time, value, slope: Option<f64>| Key { time, value: [value], slope: slope.map(|s| [s]) };
        let start = key(off, step.lift.pitch, Some(lift_rate));
        let end = key(step.strike, landing.pitch, Some(landing_rate));
        let middle = key(off + carry.pitch_at * step.swing, carry.pitch, None);
        let pitch = Track::through([start, middle, end]);
        if carry.grounded {
            return Swing { bend: pitch.clone(), pitch };
        }
        let short = step.swing.min(0.6);
        let toes_up = landing.pitch > 0.0;
        let bend = Track::through([
            key(off, step.lift.pitch.max(0.0), Some(lift_rate.max(0.0))),
            key(off + 0.4 * short, 0.0, None),
            key(step.strike - 0.4 * short, 0.0, None),
            key(step.strike, landing.pitch.max(0.0), Some(if toes_up { landing_rate } else { 0.0 })),
        ]);
        Swing { pitch, bend }
    }

    fn stand(&self, stance: &Stance, time: f64) -> FootPose {
        let pitch = self.standing_pitch(stance, time).to_radians();
        let place = self.turned(stance, time);
        let (anchor, point) = if pitch < 0.0 { self.heel(&place) } else { self.ball(&place) };
        self.anchored(anchor, point, place.heading, pitch, pitch.max(0.0), 0.0)
    }

    fn fly(&self, [from, to]: [&Stance; 2], step: &Step, swing: &Swing, time: f64) -> FootPose {
        let carry = &step.carry;
        let u = share(time, step.off(), step.strike);
        let start = self.turned(from, from.off);
        let (start_anchor, start_point) = self.ball(&start);
        let on_heel = step.landing.pitch < 0.0;
        let (end_anchor, end_point) = if on_heel { self.heel(&step.place) } else { self.ball(&step.place) };
        let along = ramped(u, carry.ramps.0, carry.ramps.1);
        let shift = smooth_step(u);
        let turned = lerp(start.heading, step.place.heading, shift);
        let aside =
            leftward(lerp(start.heading, step.place.heading, 0.5)) * outward(self.side) * carry.detour;
        let mut point = start_point.lerp(&end_point, along) + aside * bump(u, 0.5);
        point.y = lerp(start_point.y, end_point.y, shift) + carry.clearance * bump(u, carry.peak);
        let pitch = swing.pitch.at(time)[0].to_radians();
        let bend = swing.bend.at(time)[0].to_radians();
        let leaving = (time - step.off()) / near_ground(from);
        let landing = (step.strike - time) / near_ground(to);
        let freedom = if carry.grounded { 0.0 } else { smooth_step(leaving.min(landing)) };
        self.anchored(start_anchor.lerp(&end_anchor, shift), point, turned, pitch, bend, freedom)
    }

    /// The place of a stance as the foot has turned on it by `time`.
    fn turned(&self, stance: &Stance, time: f64) -> Place {
        let turn = self.plan.pivot.at(time)[0] - self.plan.pivot.at(stance.strike)[0];
        stance.place.turned(turn)
    }

    /// The ball joint: in the foot relative to the ankle, and on the ground.
    fn ball(&self, place: &Place) -> (Vec3, Vec3) {
        let build = self.build;
        let anchor = Vec3::new(0.0, build.ball - build.ankle, build.instep);
        (anchor, place.point() + Vec3::new(0.0, build.ball, 0.0))
    }

    /// The edge of the heel: in the foot relative to the ankle, and on the ground.
    fn heel(&self, place: &Place) -> (Vec3, Vec3) {
        let build = self.build;
        let anchor = Vec3::new(0.0, -build.ankle, -build.heel);
        (anchor, place.point() - (build.instep + build.heel) * forward(place.heading))
    }

    /// The foot whose point `anchor` is at `point`.
    fn anchored(
        &self,
        anchor: Vec3,
        point: Vec3,
        turned: f64,
        pitch: f64,
        bend: f64,
        freedom: f64,
    ) -> FootPose {
        let mut foot = FootPose { ankle: point, heading: turned, pitch, bend, turnout: 0.0, freedom };
        foot.ankle = point - foot.rotation() * anchor;
        foot
    }
}

/// Seconds near the ground that go with a stance: fewer with a sprinter's, whose leg
/// could not follow for longer.
fn near_ground(stance: &Stance) -> f64 {
    match stance.off - stance.strike {
        // A foot that slides on does not stand at all.
        length if length < 1e-6 => NEAR_GROUND,
        length => (length - NEAR_GROUND).clamp(NEAR_SPRINT, NEAR_GROUND),
    }
}

/// How far `time` is from `start` to `end`, from 0 to 1.
fn share(time: f64, start: f64, end: f64) -> f64 {
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
