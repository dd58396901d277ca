//! Writes sets of clips with their truth.
#![forbid(unsafe_code)]

use std::path::PathBuf;
use std::process::ExitCode;

use plantigrade_synth::{Recipe, catalogue, files, full_set, hard_cases, index, long};

const USAGE: &str = "usage: plantigrade-synth [--set SET] [--frames N] [--seed N] [--noise LEVEL] [--out DIR]

Writes NAME.bvh, NAME.json (truth) and NAME.svg (picture) of each clip of a set
and index.json, their list, into DIR.

  --set SET      samples: the thirteen sample clips (default)
                 full: the samples and 22 others, 16,613 frames in all
                 hard: cases that detectors stumble over
                 long: one long mix of everyday motion at 120 Hz
  --frames N     length of the long clip (default 14400: two minutes)
  --seed N       variation of steps and noise, a whole number (default 0)
  --noise LEVEL  strength of the foot noise, 1 as recorded, 0 none (default 1)
  --out DIR      folder to write to (default samples)";

struct Options {
    set: String,
    frames: usize,
    seed: u64,
    noise: f64,
    out: PathBuf,
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "--help" || argument == "-h") {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    match options(&arguments).and_then(|options| write(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn options(arguments: &[String]) -> Result<Options, String> {
    let mut options =
        Options { set: "samples".into(), frames: 14_400, seed: 0, noise: 1.0, out: PathBuf::from("samples") };
    for pair in arguments.chunks(2) {
        let [name, value] = pair else { return Err(format!("{} needs a value\n\n{USAGE}", pair[0])) };
        match name.as_str() {
            "--set" => options.set = value.clone(),
            "--frames" => {
                options.frames = value.parse().map_err(|_| "--frames must be a whole number")?;
                if !(120..=10_000_000).contains(&options.frames) {
                    return Err("--frames must be from 120 to 10000000".into());
                }
            }
            "--seed" => options.seed = value.parse().map_err(|_| "--seed must be a whole number")?,
            "--noise" => {
                options.noise = value.parse().map_err(|_| "--noise must be a number")?;
                if !(0.0..=10.0).contains(&options.noise) {
                    return Err("--noise must be from 0 to 10".into());
                }
            }
            "--out" => options.out = value.into(),
            _ => return Err(format!("unknown option {name}\n\n{USAGE}")),
        }
    }
    Ok(options)
}

/// The clips of the set that was asked for.
fn recipes(options: &Options) -> Result<Vec<Recipe>, String> {
    match options.set.as_str() {
        "samples" => Ok(catalogue(options.noise)),
        "full" => Ok(full_set(options.noise)),
        "hard" => Ok(hard_cases(options.noise)),
        "long" => Ok(vec![long(options.frames, options.noise)]),
        other => Err(format!("--set must be samples, full, hard or long, not {other:?}")),
    }
}

fn write(options: &Options) -> Result<(), String> {
    let save = |name: String, text: String| {
        let path = options.out.join(name);
        std::fs::write(&path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
    };
    let recipes = recipes(options)?;
    std::fs::create_dir_all(&options.out)
        .map_err(|error| format!("cannot make {}: {error}", options.out.display()))?;
    for recipe in &recipes {
        for (name, text) in files(recipe, options.seed) {
            save(name, text)?;
        }
        println!("{}: {} frames at {} Hz", recipe.name, recipe.frames, recipe.rate);
    }
    save("index.json".into(), index(&recipes))
}
