//! Executes one measured operation per line of standard input and writes its time in milliseconds.
//!
//! `npm run bench` alternates these operations with others, in this process or elsewhere, so that both
//! run under the same load. Operations are those of the core and, as references, those of other crates
//! on the same bytes.

use std::hint::black_box;
use std::io::{BufRead, Write};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use plantigrade::bvh::{self, Clip};
use plantigrade::plants::{self, Detector, Feet, Params};
use plantigrade::segments;
use plantigrade::skeleton::{Overrides, Skeleton};

/// Minimum duration of a measurement. Shorter operations are repeated, and the mean is reported.
const MIN_DURATION: Duration = Duration::from_millis(20);

/// The file that the operations read.
struct Input {
    bytes: Vec<u8>,
    clip: Clip,
    skeleton: Skeleton,
    /// Detector with the cached results of the last detection.
    detector: Detector,
    /// Number of detections so far, which differ in r.
    detections: usize,
}

impl Input {
    fn open(path: &str) -> Result<Input> {
        let bytes = std::fs::read(path).with_context(|| format!("cannot read {path}"))?;
        let clip = bvh::parse(&bytes, Default::default())?.clip;
        let skeleton = Skeleton::main(&clip, &Overrides::default());
        let detector = Detector::new(Feet::new(&clip, &skeleton)?);
        Ok(Input { bytes, clip, skeleton, detector, detections: 0 })
    }

    /// Returns the text of the frames, without hierarchy and header.
    fn frames(&self) -> &[u8] {
        let header = b"Frame Time:";
        let start = self.bytes.windows(header.len()).position(|bytes| bytes == header).unwrap_or(0);
        let line = self.bytes[start..].iter().position(|&byte| byte == b'\n').unwrap_or(0);
        &self.bytes[start + line..]
    }

    /// Executes an operation and returns its mean time.
    fn measure(&mut self, operation: &str, argument: Option<&str>) -> Result<Duration> {
        Ok(match operation {
            "read" => mean_time(|| bvh::parse(&self.bytes, Default::default()).expect("was read before")),
            // The text only, as fast as memory allows.
            "pass" => mean_time(|| {
                let words = black_box(&self.bytes).chunks_exact(8);
                words
                    .map(|word| u64::from_le_bytes(word.try_into().expect("8 bytes")))
                    .fold(0, u64::wrapping_add)
            }),
            "fast-float" => mean_time(|| numbers(self.frames())),
            "bvh_anim" => mean_time(|| bvh_anim::from_bytes(self.bytes.as_slice()).expect("valid BVH")),
            "positions" => mean_time(|| self.skeleton.positions(&self.clip)),
            "detect" => self.detect(false)?,
            "detect-all-pairs" => self.detect(true)?,
            "detect-another-r" => {
                self.detections += 1;
                let tolerance = 0.001 + 1e-5 * (self.detections % 50) as f64;
                let params = Params { tolerance, ..Params::default() }.check()?;
                let start = Instant::now();
                black_box(self.detector.detect(params));
                start.elapsed()
            }
            "segment" => {
                let method = argument.context("segment needs a method")?.parse()?;
                let params = segments::Params { method, ..Default::default() }.check()?;
                mean_time(|| segments::segment(&self.clip, &self.skeleton, params, &mut |_| Ok(())))
            }
            _ => bail!("unknown operation {operation}"),
        })
    }

    /// Returns the time of a first detection of all parts of both feet, with placing the joints.
    fn detect(&self, exact: bool) -> Result<Duration> {
        let params = Params { exact, ..Params::default() }.check()?;
        let feet = || Feet::new(&self.clip, &self.skeleton).expect("has feet");
        Ok(mean_time(|| plants::detect(&feet(), params)))
    }
}

/// Reads all numbers of a text with fast-float2 and returns them.
fn numbers(mut text: &[u8]) -> Vec<f64> {
    let mut numbers = Vec::new();
    loop {
        let blanks = text.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        text = &text[blanks..];
        let Ok((number, length)) = fast_float2::parse_partial(text) else { return numbers };
        numbers.push(number);
        text = &text[length..];
    }
}

/// Returns the mean time of an operation, without the time to drop its results.
fn mean_time<T>(mut operation: impl FnMut() -> T) -> Duration {
    let mut total = Duration::ZERO;
    let mut runs = 0;
    while total < MIN_DURATION {
        let start = Instant::now();
        let result = black_box(operation());
        total += start.elapsed();
        drop(result);
        runs += 1;
    }
    total / runs
}

/// Lines are `open FILE`, or `OPERATION [ARGUMENT]` on that file.
fn main() -> Result<()> {
    let mut input = None;
    let mut output = std::io::stdout();
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let (operation, argument) = line.split_once(' ').map_or((line.as_str(), None), |(a, b)| (a, Some(b)));
        let milliseconds = if operation == "open" {
            input = Some(Input::open(argument.context("open needs a file")?)?);
            0.0
        } else {
            let input = input.as_mut().context("no file is open")?;
            1e3 * input.measure(operation, argument)?.as_secs_f64()
        };
        writeln!(output, "{milliseconds}")?;
        output.flush()?;
    }
    Ok(())
}
