//! Plans of the sample motions, one file per motion.

mod ballet;
mod bowling;
mod curved_walk;
mod drunken_stagger;
mod foot_drag_walk;
mod frog_jumps;
mod limp_to_run;
mod modern_dance;
mod one_leg_hop;
mod run_and_jump;
mod skipping;
mod straight_jog;
mod sword_and_shield;

pub use ballet::ballet;
pub use bowling::bowling;
pub use curved_walk::curved_walk;
pub use drunken_stagger::drunken_stagger;
pub use foot_drag_walk::foot_drag_walk;
pub use frog_jumps::frog_jumps;
pub use limp_to_run::limp_to_run;
pub use modern_dance::modern_dance;
pub use one_leg_hop::one_leg_hop;
pub use run_and_jump::run_and_jump;
pub use skipping::skipping;
pub use straight_jog::straight_jog;
pub use sword_and_shield::sword_and_shield;
