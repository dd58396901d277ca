//! Writes `RESULTS.md` and its figures: detection and segmentation, evaluated on generated and on
//! recorded motion and compared with published figures and alternative methods.
//!
//! The result depends only on the code, and on the recorded trials for the sections about them.
//! Where the trials are not available, these sections are copied from the previous page.

mod figure;
mod plants;
mod report;
mod segments;

use std::fs;
use std::path::{Path, PathBuf};

use crate::plants::{
    confidence, corrections, force_plates, frame_rates, hard_cases, methods, paper, timing_tables,
    video_noise,
};
use crate::report::Report;
use crate::segments::{failures, generated, recorded};

fn main() -> anyhow::Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let figures = root.join("docs/results");
    fs::create_dir_all(&figures)?;
    let page = root.join("RESULTS.md");
    let previous = fs::read_to_string(&page).unwrap_or_default();
    let mut report = Report::new(figures);
    report.text(INTRODUCTION);
    paper::write(&mut report)?;
    methods::write(&mut report)?;
    hard_cases::write(&mut report)?;
    frame_rates::write(&mut report)?;
    confidence::write(&mut report)?;
    let corpus = corpus(&root);
    match &corpus {
        Some(corpus) => force_plates::write(&mut report, corpus)?,
        None => report.copy_section(&previous, force_plates::MARK),
    }
    timing_tables::write(&mut report, corpus.as_deref(), &previous)?;
    match &corpus {
        Some(corpus) => video_noise::write(&mut report, corpus)?,
        None => report.copy_section(&previous, video_noise::MARK),
    }
    corrections::write(&mut report, corpus.as_deref(), &previous)?;
    let clips = generated::write(&mut report);
    match &corpus {
        Some(corpus) => recorded::write(&mut report, corpus)?,
        None => report.copy_section(&previous, recorded::MARK),
    }
    failures::write(&mut report, &clips);
    fs::write(&page, report.finish())?;
    println!("Wrote {}.", page.display());
    Ok(())
}

/// Returns the folder of recorded motion, if it exists.
fn corpus(root: &Path) -> Option<PathBuf> {
    let default = root.join("../shared/corpus");
    let folder = std::env::var_os("PLANTIGRADE_CORPUS").map_or(default, PathBuf::from);
    folder.is_dir().then_some(folder)
}

const INTRODUCTION: &str = "\
# Results

Evaluation of foot-plant detection and of segmentation. Detection is tested on
generated motion with exact truth and on contact measured by force plates.
Results are compared with those of the paper that the detector builds on and with
alternative methods. `npm run evaluate` writes this page.

*Accuracy* is the fraction of correct labels over both feet, pooled over frames.
Boundaries are fuzzy for *p* seconds: labels within p/2 of a true boundary count as
correct (lenient). *The paper* is Liu, Lu and Xie (2014). Its 35 recordings are not
public; its figures are compared with ours on a generated set of the same
composition (35 clips, 8 characters, 16,613 frames at 24, 30, 60 and 120 Hz). The
default method was developed on seeds 0 to 3 of the generator and with knowledge of
the measured trials. All results are for seeds 10 to 19, unless stated otherwise.
[docs/notes](docs/notes/README.md) records what was tried and did not help.
";
