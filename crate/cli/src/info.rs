//! `plantigrade info`

use std::collections::BTreeMap;
use std::fmt::Write;

use plantigrade::bvh::{JointKind, Parsed};
use plantigrade::foot::Side;
use plantigrade::notice::Notice;
use plantigrade::skeleton::{self, LegRoles, Role, Skeleton};
use serde::Serialize;

use crate::args::{InfoArgs, InfoFormat};
use crate::failure;
use crate::inputs::{self, Input, Loaded};

/// What is said of one file.
#[derive(Serialize)]
struct Info {
    /// The input's path.
    path: String,
    frames: usize,
    /// Seconds from one frame to the next.
    frame_time: f64,
    /// Joints without end sites.
    joints: usize,
    up: String,
    metres_per_unit: f64,
    /// Thigh plus shank in file units.
    leg: Option<f64>,
    /// Role to joint name.
    roles: BTreeMap<&'static str, Option<String>>,
    notices: Vec<Notice>,
}

/// Describes all inputs and counts those that failed; an error is one of the command line.
pub fn run(args: &InfoArgs) -> Result<usize, String> {
    let inputs = inputs::collect(&args.read)?;
    let mut infos = Vec::new();
    let mut failed = 0;
    for input in &inputs {
        match inputs::load(input, &args.read) {
            Ok(loaded) => infos.push(describe(input, &loaded)),
            Err(failure) => {
                eprintln!("{failure}");
                failed += 1;
            }
        }
    }
    match args.format {
        InfoFormat::Text => infos.iter().for_each(|info| print!("{}", text(info))),
        InfoFormat::Json if inputs.len() == 1 => infos.first().into_iter().for_each(print_json),
        InfoFormat::Json => print_json(&infos),
    }
    Ok(failed)
}

fn print_json(value: &impl Serialize) {
    println!("{}", serde_json::to_string_pretty(value).expect("text, numbers and lists"));
}

fn describe(input: &Input, loaded: &Loaded) -> Info {
    let Parsed { clip, notices } = &loaded.parsed;
    let skeleton = Skeleton::main(clip, &loaded.overrides);
    let name = |role| Some(clip.joints()[skeleton.roles.get(role)?].name.clone());
    Info {
        path: failure::name(&input.path),
        frames: clip.frame_count(),
        frame_time: clip.frame_time(),
        joints: clip.joints().iter().filter(|joint| joint.kind != JointKind::EndSite).count(),
        up: skeleton.up.to_string(),
        metres_per_unit: skeleton.metres_per_unit,
        leg: skeleton.leg,
        roles: Role::ALL.into_iter().map(|role| (role.name(), name(role))).collect(),
        notices: [notices.as_slice(), &skeleton.notices].concat(),
    }
}

fn text(info: &Info) -> String {
    let mut text = format!("{}\n", info.path);
    let mut line = |what: &str, value: String| {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {what:<8} {value}");
    };
    let seconds = info.frames as f64 * info.frame_time;
    line("motion", format!("{} frames at {:.4} Hz, {seconds:.2} s", info.frames, 1.0 / info.frame_time));
    let unit =
        skeleton::unit_name(info.metres_per_unit).map_or_else(String::new, |name| format!(" ({name})"));
    line("space", format!("{} up, {:.6} m per unit{unit}", info.up, info.metres_per_unit));
    line("joints", info.joints.to_string());
    for side in Side::BOTH {
        let foot = LegRoles::of(side);
        let joints =
            [foot.ankle, foot.toe, foot.tip].map(|role| info.roles[role.name()].as_deref().unwrap_or("-"));
        line(side.name(), format!("ankle {}, toe {}, tip {}", joints[0], joints[1], joints[2]));
    }
    for notice in &info.notices {
        line("notice", notice.to_string());
    }
    text
}
