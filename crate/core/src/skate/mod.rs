//! Foot skate: measuring the slide of planted feet, and removing it.
//!
//! After Kovar, Schreiner and Gleicher, *Footskate cleanup for motion capture editing*, Symposium
//! on Computer Animation 2002. Every plant gets a position to which the foot is constrained. The hips move
//! where legs would not reach. Each leg is solved in closed form, and corrections are blended
//! between plants. The bones of a BVH file have a fixed length, unlike in the paper, so the hips move far
//! enough for every leg to reach.
//!
//! Data flow: [`Contacts`] → phases (heel, flat, toe) → plants → constraints → corrections of the
//! feet → offset of the hips → legs → channels. Spikes of the hips are repaired before, and corrections that
//! harm are withdrawn after it.

mod blend;
mod channels;
mod clean;
mod constraints;
mod contacts;
mod euler;
mod foot_data;
mod harm;
mod heel;
mod knee;
mod leg;
mod measure;
mod phases;
mod root;
mod spikes;
#[cfg(test)]
mod tests;

pub use clean::{Cleaned, CleanedPlant, Options, SkipReason, clean};
pub use contacts::{Contacts, FootContacts};
pub use foot_data::{SkateError, measure};
pub use measure::{Skate, Slide};
