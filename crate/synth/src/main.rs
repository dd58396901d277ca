//! Writes sets of generated clips with their ground truth.
#![forbid(unsafe_code)]

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use plantigrade_synth::{
    ClipSpec, clip_files, full_set, gallery_index, generate, hard_cases, long_mix, samples,
};

const USAGE: &str =
    "usage: plantigrade-synth [--set SET] [--frames N] [--seed N] [--clips N] [--noise LEVEL] [--out DIR]

Writes NAME.bvh, NAME.json (truth) and NAME.svg (thumbnail) of each clip of a set,
and index.json (the list of clips), to DIR.

  --set SET      samples: the thirteen sample clips (default)
                 full: the samples and 22 more clips, 16,613 frames in total
                 hard: cases that are difficult for detectors
                 long: one long mix of everyday motion at 120 Hz
  --frames N     length of the long clip in frames (default 14400: two minutes)
  --seed N       seed of the variation of steps and noise, an integer (default 0)
  --clips N      number of clips; beyond the set, NAME-SEED.bvh repeats its clips with other seeds
  --noise LEVEL  factor on the foot noise: 1 is the recorded level, 0 is no noise (default 1)
  --out DIR      folder to write to (default samples)";

struct Options {
    set: String,
    frames: usize,
    seed: u64,
    clips: Option<usize>,
    noise: f64,
    out: PathBuf,
}

#[derive(Debug, thiserror::Error)]
enum Error {
    #[error("{0} needs a value\n\n{USAGE}")]
    MissingValue(String),
    #[error("unknown option {0}\n\n{USAGE}")]
    UnknownOption(String),
    #[error("{option} must be {rule}")]
    InvalidValue { option: &'static str, rule: &'static str },
    #[error("unknown set {0:?}: --set must be samples, full, hard or long")]
    UnknownSet(String),
    #[error("cannot write {path}: {error}", path = .path.display())]
    Write { path: PathBuf, error: io::Error },
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "--help" || argument == "-h") {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    match parse(&arguments).and_then(|options| write(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn parse(arguments: &[String]) -> Result<Options, Error> {
    let mut options = Options {
        set: "samples".into(),
        frames: 14_400,
        seed: 0,
        clips: None,
        noise: 1.0,
        out: PathBuf::from("samples"),
    };
    for pair in arguments.chunks(2) {
        let [name, value] = pair else { return Err(Error::MissingValue(pair[0].clone())) };
        match name.as_str() {
            "--set" => options.set = value.clone(),
            "--frames" => {
                options.frames = number("--frames", "an integer from 120 to 10000000", value, |frames| {
                    (120..=10_000_000).contains(frames)
                })?;
            }
            "--seed" => options.seed = number("--seed", "an integer of at least 0", value, |_| true)?,
            "--clips" => {
                let rule = "an integer of at least 1";
                options.clips = Some(number("--clips", rule, value, |&clips| clips > 0)?);
            }
            "--noise" => {
                options.noise =
                    number("--noise", "a number from 0 to 10", value, |noise| (0.0..=10.0).contains(noise))?;
            }
            "--out" => options.out = value.into(),
            _ => return Err(Error::UnknownOption(name.clone())),
        }
    }
    Ok(options)
}

/// Parses the value of an option, which must satisfy `is_valid`.
fn number<T: std::str::FromStr>(
    option: &'static str,
    rule: &'static str,
    value: &str,
    is_valid: impl Fn(&T) -> bool,
) -> Result<T, Error> {
    value.parse().ok().filter(is_valid).ok_or(Error::InvalidValue { option, rule })
}

/// Returns the specifications of the requested set.
fn specs(options: &Options) -> Result<Vec<ClipSpec>, Error> {
    match options.set.as_str() {
        "samples" => Ok(samples(options.noise)),
        "full" => Ok(full_set(options.noise)),
        "hard" => Ok(hard_cases(options.noise)),
        "long" => Ok(vec![long_mix(options.frames, options.noise)]),
        _ => Err(Error::UnknownSet(options.set.clone())),
    }
}

fn write(options: &Options) -> Result<(), Error> {
    let save = |name: String, text: String| {
        let path = options.out.join(name);
        std::fs::write(&path, text).map_err(|error| Error::Write { path, error })
    };
    let specs = specs(options)?;
    std::fs::create_dir_all(&options.out)
        .map_err(|error| Error::Write { path: options.out.clone(), error })?;
    let count = options.clips.unwrap_or(specs.len());
    for spec in specs.iter().take(count) {
        for (name, text) in clip_files(spec, options.seed) {
            save(name, text)?;
        }
        println!("{}: {} frames at {} Hz", spec.name, spec.frames, spec.rate);
    }
    for clip in specs.len()..count {
        let (spec, seed) = (&specs[clip % specs.len()], options.seed + (clip / specs.len()) as u64);
        let text = plantigrade::bvh::write(&generate(spec, seed).clip);
        save(format!("{}-{seed}.bvh", spec.name), text)?;
    }
    save("index.json".into(), gallery_index(&specs))
}
