//! Writes the plants of a BVH file: foot, first and last frame, and mean confidence.
//!
//! ```sh
//! cargo run --example detect -- samples/curved-walk.bvh
//! ```

use std::error::Error;

use plantigrade::bvh;
use plantigrade::foot::Side;
use plantigrade::intervals::intervals;
use plantigrade::plants::{self, Feet, ValidParams};
use plantigrade::skeleton::{Overrides, Skeleton};

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: detect FILE.bvh")?;
    let parsed = bvh::parse(&std::fs::read(path)?, bvh::Options::default())?;
    let skeleton = Skeleton::main(&parsed.clip, &Overrides::default());
    let feet = Feet::new(&parsed.clip, &skeleton)?;
    let detection = plants::detect(&feet, ValidParams::default());

    for notice in parsed.notices.iter().chain(&skeleton.notices).chain(&detection.notices) {
        eprintln!("{notice}");
    }
    for side in Side::BOTH {
        let foot = detection.principal().foot(side);
        for plant in intervals(&foot.planted) {
            let confidence = foot.confidence[plant.clone()].iter().sum::<f32>() / plant.len() as f32;
            println!("{} {} {} {confidence:.2}", side.name(), plant.start, plant.end - 1);
        }
    }
    Ok(())
}
