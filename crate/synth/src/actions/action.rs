//! Named actions.

use plantigrade::foot::Side::{Left, Right};

use super::{Actor, GaitStyle};

/// An action that can be performed for a given time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Action {
    /// Relaxed standing.
    Stand,
    /// Walking, straight and in curves.
    Walk,
    /// Jogging, straight and in curves.
    Jog,
    /// Walking with bent knees and a bent back.
    Crouch,
    /// Turning on the spot.
    Turn,
    /// Repeated jumps with both feet.
    Jump,
    /// Jumping jacks.
    Jacks,
    /// Hopping on one leg.
    Hop,
    /// Front kicks with alternating legs.
    Kick,
    /// Boxing.
    Box,
    /// Squats, feet flat.
    Squat,
    /// Stretching arms and trunk.
    Stretch,
    /// Swinging the arms forward and back.
    SwingArms,
    /// Side steps to the right and back to the left.
    SideSteps,
}

impl Action {
    /// Returns the name of the action.
    pub fn name(self) -> &'static str {
        match self {
            Action::Stand => "stand",
            Action::Walk => "walk",
            Action::Jog => "jog",
            Action::Crouch => "crouch",
            Action::Turn => "turn",
            Action::Jump => "jump",
            Action::Jacks => "jacks",
            Action::Hop => "hop",
            Action::Kick => "kick",
            Action::Box => "box",
            Action::Squat => "squat",
            Action::Stretch => "stretch",
            Action::SwingArms => "swing-arms",
            Action::SideSteps => "side-steps",
        }
    }
}

/// Time interval of an action, in seconds. The time between two intervals is a transition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ActionInterval {
    /// The action.
    pub action: Action,
    /// Start of its first movement.
    pub start: f64,
    /// End of its last movement.
    pub end: f64,
}

impl Actor<'_> {
    /// Performs `action` for about `seconds`, starting from the current movement. Walking and
    /// jogging change into each other; between all other actions the actor stands still.
    pub fn perform(&mut self, action: Action, seconds: f64) -> ActionInterval {
        let scale = self.scale;
        let travels = |style: GaitStyle, actor: &mut Actor| {
            actor.change_style(&style);
            let start = actor.now();
            actor.travel_in_curves(&style, start + seconds);
            ActionInterval { action, start, end: actor.now() }
        };
        match action {
            Action::Walk => return travels(GaitStyle::walk(scale, 1.0), self),
            Action::Jog => return travels(GaitStyle::jog(scale, 1.0), self),
            Action::Crouch => return travels(GaitStyle::crouch(scale), self),
            _ => self.stop(),
        }
        let start = self.now();
        let times = |each: f64| (seconds / each).round().max(1.0) as usize;
        match action {
            Action::Stand => self.stand(seconds),
            Action::Turn => {
                let to = if self.random.uniform(-1.0, 1.0) > 0.0 { 160.0 } else { -160.0 };
                self.turn(to);
            }
            Action::Jump => self.jump_up(times(1.05)),
            Action::Jacks => self.jumping_jacks(times(0.88)),
            Action::Hop => self.hop_on(Left, times(0.53), 0.32),
            Action::Kick => (0..times(2.2)).for_each(|n| self.kick(if n % 2 == 0 { Right } else { Left })),
            Action::Box => self.boxing(seconds),
            Action::Squat => self.squat(times(2.3), 0.36),
            Action::Stretch => self.stretch(seconds),
            Action::SwingArms => self.swing_arms(seconds),
            Action::SideSteps => {
                let steps = times(2.0);
                self.side_steps(Right, steps);
                self.side_steps(Left, steps);
            }
            Action::Walk | Action::Jog | Action::Crouch => {}
        }
        ActionInterval { action, start, end: self.now() }
    }

    /// Continues in `style` until `until`, straight and in random curves.
    fn travel_in_curves(&mut self, style: &GaitStyle, until: f64) {
        while self.now() < until {
            let curved = self.random.uniform(0.0, 1.0) > 0.5;
            let turn = if curved { self.random.uniform(-22.0, 22.0) } else { 0.0 };
            let steps = self.random.uniform(3.0, 8.0) as usize;
            for _ in 0..steps {
                if self.now() < until {
                    let wobble = self.random.uniform(-1.0, 1.0);
                    self.step_in_style(style, turn + wobble);
                }
            }
        }
        self.set_posture(self.now(), &style.posture);
    }
}
