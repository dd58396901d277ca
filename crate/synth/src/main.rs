//! Writes the sample clips with their truth.
#![forbid(unsafe_code)]

use std::path::PathBuf;
use std::process::ExitCode;

use plantigrade_synth::{catalogue, files, index};

const USAGE: &str = "usage: plantigrade-synth [--seed N] [--noise LEVEL] [--out DIR]

Writes NAME.bvh, NAME.json (truth) and NAME.svg (picture) of each sample clip
and index.json, their list, into DIR.

  --seed N       variation of steps and noise, a whole number (default 0)
  --noise LEVEL  strength of the foot noise, 1 as recorded, 0 none (default 1)
  --out DIR      folder to write to (default samples)";

struct Options {
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
    let mut options = Options { seed: 0, noise: 1.0, out: PathBuf::from("samples") };
    for pair in arguments.chunks(2) {
        let [name, value] = pair else { return Err(format!("{} needs a value\n\n{USAGE}", pair[0])) };
        match name.as_str() {
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

fn write(options: &Options) -> Result<(), String> {
    let save = |name: String, text: String| {
        let path = options.out.join(name);
        std::fs::write(&path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
    };
    std::fs::create_dir_all(&options.out)
        .map_err(|error| format!("cannot make {}: {error}", options.out.display()))?;
    let recipes = catalogue(options.noise);
    for recipe in &recipes {
        for (name, text) in files(recipe, options.seed) {
            save(name, text)?;
        }
        println!("{}: {} frames at {} Hz", recipe.name, recipe.frames, recipe.rate);
    }
    save("index.json".into(), index(&recipes))
}
