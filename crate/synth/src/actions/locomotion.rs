//! Locomotion: starting, changing style and stopping.

use super::{Actor, GaitStyle, HALF_STANCE_WIDTH, Posture};
use crate::math::Random;
use crate::plan::{Gait, Landing, Lift};

/// Blend fractions of the steps of a transition: between gaits of the same kind, between walking
/// and running, and from running and walking to a stop.
const BLEND_SAME_KIND: [f64; 2] = [0.0, 0.7];
const BLEND_WALK_RUN: [f64; 4] = [0.15, 0.4, 0.65, 0.85];
const BLEND_RUN_STOP: [f64; 4] = [0.7, 0.4, 0.15, 0.0];
const BLEND_WALK_STOP: [f64; 1] = [0.3];

/// Steps until full sprinting speed.
const SPRINT_START_STEPS: u8 = 12;

impl Actor<'_> {
    /// Moves in `style` until time `until`; `turn` returns the rotation of each step in degrees to
    /// the left. The actor continues to move afterwards.
    pub fn travel(&mut self, style: &GaitStyle, until: f64, mut turn: impl FnMut(&mut Random) -> f64) {
        self.change_style(style);
        while self.now() < until {
            let turn = turn(self.random);
            self.step_in_style(style, turn);
        }
    }

    /// Moves straight in `style` until time `until`.
    pub fn travel_straight(&mut self, style: &GaitStyle, until: f64) {
        self.travel(style, until, |random| random.uniform(-0.8, 0.8));
    }

    /// Takes one step in `style`, turning `turn` degrees to the left.
    pub fn step_in_style(&mut self, style: &GaitStyle, turn: f64) {
        let gait = &style.gait;
        let (time, length) = (self.random.vary(0.7 * style.variation), self.random.vary(style.variation));
        self.take_step(&Gait { time: gait.time * time, length: gait.length * length, turn, ..gait.clone() });
    }

    /// Starts locomotion in `style`, or changes to it.
    pub fn change_style(&mut self, style: &GaitStyle) {
        let first = style.first_step(self.scale);
        let (from, posture) = match self.current_style.take() {
            Some(before) => (before.gait, before.posture),
            None => (first, Posture::default()),
        };
        self.set_posture(self.now(), &posture);
        let same = style.gait.is_run() == from.is_run();
        let fractions = if same { &BLEND_SAME_KIND[..] } else { &BLEND_WALK_RUN[..] };
        for &fraction in fractions {
            self.take_step(&from.blend(&style.gait, fraction));
        }
        self.set_posture(self.now(), &style.posture);
        self.current_style = Some(style.clone());
    }

    /// Stops with the feet side by side, if the actor is moving.
    pub fn stop(&mut self) {
        let Some(style) = self.current_style.take() else { return };
        self.set_posture(self.now(), &style.posture);
        let last = style.first_step(self.scale);
        let fractions = if style.gait.is_run() { &BLEND_RUN_STOP[..] } else { &BLEND_WALK_STOP[..] };
        for &fraction in fractions {
            self.take_step(&last.blend(&style.gait, fraction));
        }
        self.close_feet(&last);
        self.set_posture(self.now() + 0.35, &Posture::default());
        self.wait(0.5);
    }

    /// Places the rear foot next to the other.
    pub(super) fn close_feet(&mut self, gait: &Gait) {
        let close = Gait {
            time: gait.time.max(0.5),
            length: 0.02 * self.scale,
            width: HALF_STANCE_WIDTH * self.scale,
            toe_out: 8.0,
            swing: gait.swing.clamp(0.36, 0.6),
            landing: Landing { pitch: gait.landing.pitch.max(10.0), settle: 0.12, rest: 0.0 },
            ..gait.clone()
        };
        self.take_step(&close);
    }

    /// Starts a sprint from standing: one foot back, leaning forward, with quick steps of growing
    /// length.
    pub fn start_sprint(&mut self) {
        self.stop();
        let (style, scale) = (GaitStyle::sprint(self.scale), self.scale);
        let start = self.now();
        self.set_posture(start, &Posture::default());
        let back = Gait {
            swing: 0.4,
            landing: Landing { pitch: 34.0, settle: 0.1, rest: 24.0 },
            ..Gait::walk(scale)
        };
        let placement = self.planner.placement(self.side).translated(-0.36 * scale, 0.0);
        self.planner.place_foot(self.side, start + 0.55, placement, &back);
        let set = style.posture.bent_forward(46.0).lowered(0.1);
        self.set_posture(start + 0.9, &set);
        self.wait(1.2);
        let off = self.now();
        self.set_posture(off, &set);
        let first = Gait {
            time: 0.27,
            length: 0.6 * scale,
            swing: 0.29,
            lift: Lift { pitch: 54.0, lead: 0.12 },
            ..style.gait.clone()
        };
        for step in 0..SPRINT_START_STEPS {
            self.take_step(&first.blend(&style.gait, f64::from(step) / f64::from(SPRINT_START_STEPS)));
        }
        self.set_posture(off + 0.8, &style.posture.bent_forward(36.0).lowered(0.03));
        self.set_posture(self.now(), &style.posture);
        self.current_style = Some(style);
    }
}
