#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

pub mod bvh;
pub mod foot;
pub mod formats;
pub mod gait;
pub mod intervals;
pub mod kinematics;
pub mod notice;
mod numeric;
pub mod plants;
pub mod points;
pub mod registry;
pub mod score;
pub mod segments;
pub mod skate;
pub mod skeleton;
