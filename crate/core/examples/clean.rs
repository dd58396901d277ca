//! Removes foot skate: writes a BVH file in which planted feet do not slide.
//!
//! ```sh
//! cargo run --example clean -- samples/curved-walk.bvh clean.bvh
//! ```

use std::error::Error;
use std::sync::Arc;

use plantigrade::bvh::{self, Parsed};
use plantigrade::plants::{self, Feet, ValidParams};
use plantigrade::skate::{self, Contacts, Options};
use plantigrade::skeleton::{Overrides, Skeleton};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(input), Some(output)) = (arguments.next(), arguments.next()) else {
        return Err("usage: clean INPUT.bvh OUTPUT.bvh".into());
    };
    let bytes = std::fs::read(input)?;
    let Parsed { clip, layout, .. } = bvh::parse(&bytes, bvh::Options::default())?;
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let detection = plants::detect(&Feet::new(&clip, &skeleton)?, ValidParams::default());

    let cleaned = skate::clean(&clip, &skeleton, &Contacts::from(&detection), &Options::default())?;
    for plant in &cleaned.plants {
        let [before, after] = [plant.before, plant.after].map(|metres| 1e3 * metres);
        println!("{} from frame {}: {before:.1} -> {after:.1} mm", plant.side.name(), plant.frames.start);
    }
    let frames = 0..clip.frame_count();
    std::fs::write(output, bvh::rewrite(&bytes, &layout, &Arc::new(cleaned.clip), frames))?;
    Ok(())
}
