//! `plantigrade segment`: segments clips into actions.

use plantigrade::bvh::Parsed;
use plantigrade::formats::{SegmentExport, SegmentsDocument};
use plantigrade::segments::{self, ActionMovements, SegmentError, ValidParams};

use crate::args::SegmentArgs;
use crate::batch::Batch;
use crate::error::{InputError, UsageError};
use crate::input::{Input, LoadedClip};

/// Segments of one clip.
struct Segmented {
    /// One document per skeleton.
    documents: Vec<SegmentsDocument>,
    /// Movements of the actions of each skeleton.
    actions: Vec<Vec<ActionMovements>>,
    as_array: bool,
}

/// Segments all inputs. Equal actions of all clips have equal names. Returns the number of inputs that
/// failed.
pub fn run(args: &SegmentArgs) -> Result<usize, UsageError> {
    let params = args.params.check(args.method)?;
    args.params.warn_of_unused(args.method);
    let batch = Batch {
        read: &args.read,
        write: &args.write,
        extension: args.format.extension(),
        options: format!("{params:?}"),
    };
    let write =
        |Segmented { documents, as_array, .. }| args.format.write(&SegmentExport { documents, as_array });
    batch.run_jointly(|input, loaded| segment(input, loaded, params), name_actions, write)
}

/// Segments the skeletons of a clip.
fn segment(input: &Input, loaded: &LoadedClip, params: ValidParams) -> Result<Segmented, InputError> {
    let Parsed { clip, notices, .. } = &loaded.parsed;
    let mut segmented =
        Segmented { documents: Vec::new(), actions: Vec::new(), as_array: clip.roots().count() > 1 };
    let mut last_error = SegmentError::NoMotion;
    for skeleton in loaded.skeletons() {
        match segments::segment(clip, &skeleton, params, &mut |_| Ok(())) {
            Ok(segmentation) => {
                let source = loaded.source(input);
                let document = SegmentsDocument::new(source, clip, &skeleton, &segmentation, notices);
                segmented.documents.push(document);
                segmented.actions.push(segmentation.actions);
            }
            Err(error) => last_error = error,
        }
    }
    if segmented.documents.is_empty() {
        return Err(InputError::Segment { path: input.path.clone(), error: last_error });
    }
    Ok(segmented)
}

/// Gives equal actions of all skeletons and clips equal names.
fn name_actions(clips: &mut [Segmented]) {
    let actions: Vec<&[ActionMovements]> =
        clips.iter().flat_map(|clip| &clip.actions).map(Vec::as_slice).collect();
    if actions.len() < 2 {
        return;
    }
    let mut names = segments::common_names(&actions).into_iter();
    for clip in clips {
        for (document, actions) in clip.documents.iter_mut().zip(&clip.actions) {
            let own_names = actions.iter().map(|action| action.name.clone());
            document.rename_actions(&own_names.zip(names.next().unwrap_or_default()).collect());
        }
    }
}
