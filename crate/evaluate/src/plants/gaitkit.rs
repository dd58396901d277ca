//! Events of the detectors of gaitkit, a Python package, for comparison.
//!
//! The tracks of the legs are written to a file, and a script of the project returns the events.
//! The environment variable [`PYTHON`] names a Python interpreter that has the package;
//! `npm run evaluate` sets it.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, ensure};
use plantigrade::bvh::Clip;
use plantigrade::foot::Side;
use plantigrade::kinematics;
use plantigrade::skeleton::{LegRoles, Overrides, Skeleton};
use serde::{Deserialize, Serialize};

use super::timing::{Event, Kind};

/// Environment variable that names the Python interpreter.
const PYTHON: &str = "PLANTIGRADE_GAITKIT_PYTHON";

/// Tracks of the legs of one clip.
#[derive(Clone, Debug, Serialize)]
pub struct LegTracks {
    /// Frame rate, in Hz.
    rate: f64,
    /// Positions in metres by name of the joint, with the third axis up.
    joints: BTreeMap<String, Vec<[f64; 3]>>,
}

impl LegTracks {
    /// Computes hips, knees, ankles and toes of a clip.
    pub fn new(clip: &Clip) -> LegTracks {
        let skeleton = Skeleton::main(clip, &Overrides::default());
        let named: Vec<(String, usize)> = Side::BOTH
            .into_iter()
            .flat_map(|side| {
                let roles = LegRoles::for_side(side);
                let joints = [
                    ("hip", skeleton.roles.get(roles.thigh)),
                    ("knee", skeleton.roles.get(roles.shank)),
                    ("ankle", skeleton.heel(side)),
                    ("toe", skeleton.toe(side)),
                ];
                joints.map(|(name, joint)| Some((format!("{}_{name}", side.name()), joint?)))
            })
            .flatten()
            .collect();
        let joints: Vec<usize> = named.iter().map(|(_, joint)| *joint).collect();
        let tracks = kinematics::tracks(clip, &joints);
        let in_metres = |track: kinematics::Track| {
            let position = |position| {
                let [x, y, z] = (skeleton.up.to_y_up(position) * skeleton.metres_per_unit).into();
                [z, x, y]
            };
            track.into_iter().map(position).collect()
        };
        let joints = named.into_iter().zip(tracks).map(|((name, _), track)| (name, in_metres(track)));
        LegTracks { rate: 1.0 / clip.frame_time(), joints: joints.collect() }
    }
}

/// Output of the script: the events of each trial by name of the detector, in order of the rows.
#[derive(Deserialize)]
struct Output {
    version: String,
    detectors: Vec<Detector>,
}

#[derive(Deserialize)]
struct Detector {
    title: String,
    events: Vec<Vec<(Side, String, f64)>>,
}

/// Events of all detectors of the package.
pub struct GaitkitEvents {
    /// Version of the package.
    pub version: String,
    /// Title of each detector, and its events in each trial.
    pub detectors: Vec<(String, Vec<Vec<Event>>)>,
}

/// Runs the detectors of gaitkit on the tracks of trials. Returns `None` if no interpreter is given.
pub fn detect(tracks: &[LegTracks]) -> anyhow::Result<Option<GaitkitEvents>> {
    let Some(python) = std::env::var_os(PYTHON) else { return Ok(None) };
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let [input, output] = ["tracks", "events"]
        .map(|name| std::env::temp_dir().join(format!("plantigrade-{name}-{}.json", std::process::id())));
    std::fs::write(&input, serde_json::to_vec(tracks)?)?;
    let status = Command::new(python)
        .arg(root.join("scripts/evaluate/gaitkit_events.py"))
        .args([&input, &output])
        .status()
        .context("the Python interpreter could not be started")?;
    ensure!(status.success(), "the script that runs gaitkit failed");
    let result: Output = serde_json::from_slice(&std::fs::read(&output)?)?;
    std::fs::remove_file(input)?;
    std::fs::remove_file(output)?;
    let detectors = result.detectors.into_iter().map(|detector| {
        let events = detector.events.into_iter().map(|events| events.into_iter().map(event).collect());
        (detector.title, events.collect())
    });
    Ok(Some(GaitkitEvents { version: result.version, detectors: detectors.collect() }))
}

fn event((side, kind, time): (Side, String, f64)) -> Event {
    Event { side, kind: if kind == "strike" { Kind::Strike } else { Kind::Off }, time }
}
