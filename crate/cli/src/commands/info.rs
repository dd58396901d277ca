//! `plantigrade info`: describes clips.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::num::NonZeroUsize;

use plantigrade::bvh::{JointKind, Parsed};
use plantigrade::foot::Side;
use plantigrade::notice::Notice;
use plantigrade::skeleton::{self, LegRoles, Reason, Role};
use serde::Serialize;

use crate::args::{InfoArgs, InfoFormat};
use crate::error::UsageError;
use crate::input::{self, Input, LoadedClip};
use crate::output::{self, print_json};
use crate::parallel;
use crate::text::{display_name, escape};

/// Description of one file.
#[derive(Serialize)]
struct Info {
    /// Path of the input.
    path: String,
    frames: usize,
    /// Time between frames, in seconds.
    frame_time: f64,
    /// Number of joints, end sites excluded.
    joints: usize,
    up: String,
    metres_per_unit: f64,
    /// Length of thigh and shank, in file units.
    leg: Option<f64>,
    /// Joint name of each role.
    roles: BTreeMap<&'static str, Option<String>>,
    /// Confidence of each assigned role and the reasons for it.
    role_evidence: BTreeMap<&'static str, Evidence>,
    notices: Vec<Notice>,
}

/// Evidence for the joint of a role.
#[derive(Serialize)]
struct Evidence {
    /// From 0 to 1.
    confidence: f64,
    reasons: Vec<Reason>,
}

/// Describes all inputs. Returns the number of inputs that failed.
pub fn run(args: &InfoArgs) -> Result<usize, UsageError> {
    let inputs = input::collect(&args.read)?;
    let one_by_one = NonZeroUsize::new(1);
    let (infos, failures) =
        parallel::map(&inputs, one_by_one, |input| Ok(describe(input, &input::load(input, &args.read)?)));
    match args.format {
        InfoFormat::Text => infos.iter().for_each(|info| output::print(format_args!("{}", text(info)))),
        InfoFormat::Json if inputs.len() == 1 => infos.first().into_iter().for_each(print_json),
        InfoFormat::Json => print_json(&infos),
    }
    Ok(failures)
}

fn describe(input: &Input, loaded: &LoadedClip) -> Info {
    let Parsed { clip, notices, .. } = &loaded.parsed;
    let skeleton = loaded.main_skeleton();
    let joint_name = |role| Some(clip.joints()[skeleton.roles.get(role)?].name.clone());
    let evidence = |role| {
        let assignment = skeleton.roles.assignment(role)?;
        // Two digits; more would claim an accuracy that an estimate does not have.
        let confidence = (100.0 * assignment.confidence()).round() / 100.0;
        Some((role.name(), Evidence { confidence, reasons: assignment.reasons.clone() }))
    };
    Info {
        path: display_name(&input.path),
        frames: clip.frame_count(),
        frame_time: clip.frame_time(),
        joints: clip.joints().iter().filter(|joint| joint.kind != JointKind::EndSite).count(),
        up: skeleton.up.to_string(),
        metres_per_unit: skeleton.metres_per_unit,
        leg: skeleton.leg,
        roles: Role::ALL.into_iter().map(|role| (role.name(), joint_name(role))).collect(),
        role_evidence: Role::ALL.into_iter().filter_map(evidence).collect(),
        notices: [notices.as_slice(), &skeleton.notices].concat(),
    }
}

fn text(info: &Info) -> String {
    let mut text = format!("{}\n", escape(&info.path));
    let mut line = |label: &str, value: String| {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {label:<8} {}", escape(&value));
    };
    let seconds = info.frames as f64 * info.frame_time;
    line("motion", format!("{} frames at {:.4} Hz, {seconds:.2} s", info.frames, 1.0 / info.frame_time));
    let unit =
        skeleton::unit_name(info.metres_per_unit).map_or_else(String::new, |name| format!(" ({name})"));
    line("space", format!("{} up, {:.6} m per unit{unit}", info.up, info.metres_per_unit));
    line("joints", info.joints.to_string());
    for side in Side::BOTH {
        let leg = LegRoles::for_side(side);
        let joints =
            [leg.ankle, leg.toe, leg.tip].map(|role| info.roles[role.name()].as_deref().unwrap_or("-"));
        let confidence = info
            .role_evidence
            .get(leg.ankle.name())
            .map_or_else(String::new, |evidence| format!(" ({:.0} % certain)", 100.0 * evidence.confidence));
        line(side.name(), format!("ankle {}{confidence}, toe {}, tip {}", joints[0], joints[1], joints[2]));
    }
    for notice in &info.notices {
        line("notice", notice.to_string());
    }
    text
}
