//! Writes the segments of a BVH file by one method: start and end in seconds, and the label.
//!
//! ```sh
//! cargo run --example segment -- samples/limp-to-run.bvh lsd
//! ```

use std::error::Error;

use plantigrade::bvh;
use plantigrade::segments::{self, Params};
use plantigrade::skeleton::{Overrides, Skeleton};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().ok_or("usage: segment FILE.bvh [METHOD]")?;
    let method = arguments.next().as_deref().unwrap_or("auto").parse()?;

    let clip = bvh::parse(&std::fs::read(path)?, bvh::Options::default())?.clip;
    let skeleton = Skeleton::main(&clip, &Overrides::default());
    let params = Params { method, ..Params::default() }.check()?;
    // The callback receives the completed fraction and could cancel.
    let segmentation = segments::segment(&clip, &skeleton, params, &mut |_| Ok(()))?;

    for segment in &segmentation.segments {
        let [start, end] =
            [segment.frames.start, segment.frames.end].map(|frame| frame as f64 * clip.frame_time());
        println!("{start:8.2} {end:8.2}  {} {}", segment.kind.name(), segment.label);
    }
    Ok(())
}
