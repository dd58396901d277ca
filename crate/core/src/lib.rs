//! Foot plants in motion capture.
#![forbid(unsafe_code)]

pub mod bvh;
pub mod gait;
pub mod labels;
pub mod motion;
mod named;
pub mod notice;
pub mod plants;
pub mod score;
pub mod segments;
pub mod skate;
pub mod skeleton;
mod spline;
