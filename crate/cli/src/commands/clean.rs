//! `plantigrade clean`: removes foot skate.

use std::num::NonZeroUsize;
use std::sync::Arc;

use plantigrade::bvh;
use plantigrade::formats;
use plantigrade::plants::{self, Feet};
use plantigrade::skate::{self, Cleaned, Contacts, Options};

use crate::args::CleanArgs;
use crate::error::{InputError, UsageError};
use crate::file;
use crate::input::{self, Input, LoadedClip};
use crate::output;
use crate::parallel;
use crate::text::display_name;

/// Removes foot skate from one clip. Returns the number of inputs that failed (0 or 1).
pub fn run(args: &CleanArgs) -> Result<usize, UsageError> {
    let params = args.detection.params()?;
    args.detection.warn_of_unused();
    let inputs = input::collect(&args.read)?;
    let [_] = &inputs[..] else { return Err(UsageError::NotOneClip(inputs.len())) };
    input::check_stdin(&args.read, &[&args.labels])?;
    if args.labels.as_ref().is_some_and(|labels| file::is_same(labels, &args.out)) {
        return Err(UsageError::OutIsInput(args.out.clone()));
    }
    let (_, failures) = parallel::map(&inputs, NonZeroUsize::new(1), |input| {
        let (loaded, bytes) = input::load_with_bytes(input, &args.read)?;
        clean(input, &loaded, &bytes, params, args)
    });
    Ok(failures)
}

/// Cleans a clip, writes the result and reports a summary and the notices.
fn clean(
    input: &Input,
    loaded: &LoadedClip,
    bytes: &[u8],
    params: plants::ValidParams,
    args: &CleanArgs,
) -> Result<(), InputError> {
    let clip = &loaded.parsed.clip;
    let skeleton = loaded.main_skeleton();
    let contacts = match &args.labels {
        Some(path) => {
            let labels_error = |error| InputError::Labels { path: path.clone(), error };
            let labels = formats::read_plants(&input::read_file(path)?, clip.frame_count());
            Contacts::from(&labels.map_err(labels_error)?)
        }
        None => {
            let detect_error = |error| InputError::Detect { path: input.path.clone(), error };
            Contacts::from(&plants::detect(&Feet::new(clip, &skeleton).map_err(detect_error)?, params))
        }
    };
    let options = Options { repair_spikes: !args.keep_spikes, ..Options::default() };
    let cleaned = skate::clean(clip, &skeleton, &contacts, &options);
    let cleaned = cleaned.map_err(|error| InputError::Clean { path: input.path.clone(), error })?;
    let summary = summary(&cleaned);
    let cleaned_clip = Arc::new(cleaned.clip);
    let text = bvh::rewrite(bytes, &loaded.parsed.layout, &cleaned_clip, 0..clip.frame_count());
    output::write(&args.out, &text)?;
    let name = display_name(&input.path);
    output::report(format_args!("{name}: {summary}"));
    let notices = loaded.parsed.notices.iter().chain(&skeleton.notices).chain(&cleaned.notices);
    for notice in notices {
        output::report(format_args!("{name}: {notice}"));
    }
    Ok(())
}

/// Returns a summary in one line: number of plants, and their slide before and after.
fn summary(cleaned: &Cleaned) -> String {
    let mean_and_max = |slide: fn(&skate::CleanedPlant) -> f64| {
        let slides = || cleaned.plants.iter().map(slide);
        // The standard library returns −0 as the sum of no numbers.
        let mean = slides().fold(0.0, |sum, slide| sum + slide) / cleaned.plants.len().max(1) as f64;
        [mean, slides().fold(0.0, f64::max)].map(|metres| 1e3 * metres)
    };
    let [mean, max] = mean_and_max(|plant| plant.before);
    let [mean_after, max_after] = mean_and_max(|plant| plant.after);
    format!(
        "{} plants, {} corrected; slide: mean {mean:.1} → {mean_after:.1} mm, maximum {max:.1} → {max_after:.1} mm",
        cleaned.plants.len(),
        cleaned.constrained_count(),
    )
}
