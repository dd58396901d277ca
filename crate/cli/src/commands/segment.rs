//! `plantigrade segment`: segments clips into actions.

use plantigrade::bvh::Parsed;
use plantigrade::labels::{self, SegmentsDocument};
use plantigrade::segments::{self, SegmentError, ValidParams};
use plantigrade::skeleton::Skeleton;

use crate::args::{SegmentArgs, SegmentFormat};
use crate::batch::Batch;
use crate::error::{InputError, UsageError};
use crate::input::{Input, LoadedClip};

/// Segments all inputs. Returns the number of inputs that failed.
pub fn run(args: &SegmentArgs) -> Result<usize, UsageError> {
    let params = args.params.check(args.method)?;
    let batch = Batch {
        read: &args.read,
        write: &args.write,
        extension: args.format.extension(),
        options: format!("{params:?}"),
    };
    batch.run(|input, loaded| segment(input, loaded, params, args))
}

/// Returns the result for one clip in the requested format.
fn segment(
    input: &Input,
    loaded: &LoadedClip,
    params: ValidParams,
    args: &SegmentArgs,
) -> Result<String, InputError> {
    let Parsed { clip, notices } = &loaded.parsed;
    let mut documents: Vec<SegmentsDocument> = Vec::new();
    let mut last_error = SegmentError::NoMotion;
    for skeleton in Skeleton::all(clip, &loaded.overrides) {
        match segments::segment(clip, &skeleton, params, &mut |_| Ok(())) {
            Ok(segmentation) => {
                let source = loaded.source(input);
                documents.push(SegmentsDocument::of(source, clip, &skeleton, &segmentation, notices));
            }
            Err(error) => last_error = error,
        }
    }
    if documents.is_empty() {
        return Err(InputError::Segment { path: input.path.clone(), error: last_error });
    }
    Ok(match args.format {
        SegmentFormat::Csv => labels::segments_csv(&documents),
        SegmentFormat::Babel => labels::babel_json(&documents),
        SegmentFormat::Json if clip.roots().count() > 1 => SegmentsDocument::all_to_json(&documents),
        SegmentFormat::Json => documents[0].to_json(),
    })
}
