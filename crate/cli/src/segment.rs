//! `plantigrade segment`

use plantigrade::bvh::Parsed;
use plantigrade::formats::{self, SegmentsDocument};
use plantigrade::segments::{self, SegmentError, ValidParams};
use plantigrade::skeleton::Skeleton;

use crate::args::{SegmentArgs, SegmentFormat};
use crate::failure::Failure;
use crate::inputs::{Input, Loaded};
use crate::results::Results;

/// Cuts all inputs and counts those that failed; an error is one of the command line.
pub fn run(args: &SegmentArgs) -> Result<usize, String> {
    let params = args.segments.params(args.method)?;
    let results = Results {
        read: &args.read,
        write: &args.write,
        ending: args.format.ending(),
        settings: format!("{params:?}"),
    };
    results.make(|input, loaded| segment(input, loaded, params, args))
}

/// The result for one clip, in the format asked for.
fn segment(
    input: &Input,
    loaded: &Loaded,
    params: ValidParams,
    args: &SegmentArgs,
) -> Result<String, Failure> {
    let Parsed { clip, notices } = &loaded.parsed;
    let mut documents: Vec<SegmentsDocument> = Vec::new();
    let mut refused = SegmentError::NoMotion;
    for skeleton in Skeleton::all(clip, &loaded.overrides) {
        match segments::segment(clip, &skeleton, params, &mut |_| Ok(())) {
            Ok(found) => {
                let source = loaded.source(input);
                documents.push(SegmentsDocument::of(source, clip, &skeleton, &found, notices));
            }
            Err(error) => refused = error,
        }
    }
    if documents.is_empty() {
        return Err(Failure::Segment { path: input.path.clone(), error: refused });
    }
    Ok(match args.format {
        SegmentFormat::Csv => formats::segments_csv(&documents),
        SegmentFormat::Babel => formats::babel_json(&documents),
        SegmentFormat::Json if clip.roots().count() > 1 => SegmentsDocument::all_to_json(&documents),
        SegmentFormat::Json => documents[0].to_json(),
    })
}
