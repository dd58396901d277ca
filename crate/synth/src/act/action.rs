//! Actions by name, to be put in a row.

use plantigrade::foot::Side::{Left, Right};

use super::{Actor, Style};

/// Something people do for a while.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Action {
    /// Standing at ease.
    Stand,
    /// Walking, now and then in a curve.
    Walk,
    /// Jogging, now and then in a curve.
    Jog,
    /// Walking with bent knees and a bent back.
    Crouch,
    /// Turning round on the spot.
    Turn,
    /// Jumping up with both feet, again and again.
    Jump,
    /// Jumping jacks.
    Jacks,
    /// Hopping on one leg.
    Hop,
    /// Front kicks with either leg.
    Kick,
    /// Boxing.
    Box,
    /// Squats, feet flat.
    Squat,
    /// Stretching arms and trunk.
    Stretch,
    /// Swinging the arms to and fro.
    SwingArms,
    /// Side steps, there and back.
    SideSteps,
}

impl Action {
    /// The action's name.
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

/// When an action was under way, in seconds: what lies between two of them is transition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Performed {
    /// What was done.
    pub action: Action,
    /// When the first movement of the action itself begins.
    pub begin: f64,
    /// When its last movement is over.
    pub end: f64,
}

impl Actor<'_> {
    /// Does `action` for about `seconds`, from whatever the actor does. Walking and jogging
    /// go over into each other; in all else the actor comes to rest between two actions.
    pub fn perform(&mut self, action: Action, seconds: f64) -> Performed {
        let scale = self.scale;
        let travels = |style: Style, actor: &mut Actor| {
            actor.fall_in(&style);
            let begin = actor.now();
            actor.wander(&style, begin + seconds);
            Performed { action, begin, end: actor.now() }
        };
        match action {
            Action::Walk => return travels(Style::walk(scale, 1.0), self),
            Action::Jog => return travels(Style::jog(scale, 1.0), self),
            Action::Crouch => return travels(Style::crouch(scale), self),
            _ => self.stop(),
        }
        let begin = self.now();
        let times = |each: f64| (seconds / each).round().max(1.0) as usize;
        match action {
            Action::Stand => self.stand(seconds),
            Action::Turn => {
                let to = if self.random.between(-1.0, 1.0) > 0.0 { 160.0 } else { -160.0 };
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
        Performed { action, begin, end: self.now() }
    }

    /// Goes on in `style` until `until`, straight on and in curves.
    fn wander(&mut self, style: &Style, until: f64) {
        while self.now() < until {
            let curved = self.random.between(0.0, 1.0) > 0.5;
            let turn = if curved { self.random.between(-22.0, 22.0) } else { 0.0 };
            let steps = self.random.between(3.0, 8.0) as usize;
            for _ in 0..steps {
                if self.now() < until {
                    let wobble = self.random.between(-1.0, 1.0);
                    self.stride(style, turn + wobble);
                }
            }
        }
        self.carry(self.now(), &style.carriage);
    }
}
