//! `plantigrade segment`: segments clips into actions.

use plantigrade::bvh::Parsed;
use plantigrade::formats::{SegmentExport, SegmentsDocument};
use plantigrade::segments::{self, SegmentError, ValidParams};

use crate::args::SegmentArgs;
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
) -> Result<Vec<u8>, InputError> {
    let Parsed { clip, notices, .. } = &loaded.parsed;
    let mut documents: Vec<SegmentsDocument> = Vec::new();
    let mut last_error = SegmentError::NoMotion;
    for skeleton in loaded.skeletons() {
        match segments::segment(clip, &skeleton, params, &mut |_| Ok(())) {
            Ok(segmentation) => {
                let source = loaded.source(input);
                documents.push(SegmentsDocument::new(source, clip, &skeleton, &segmentation, notices));
            }
            Err(error) => last_error = error,
        }
    }
    if documents.is_empty() {
        return Err(InputError::Segment { path: input.path.clone(), error: last_error });
    }
    let as_array = clip.roots().count() > 1;
    Ok(args.format.write(&SegmentExport { documents, as_array }))
}
