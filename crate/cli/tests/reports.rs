//! Cases of public bug reports, checked by the script next to them. The folder is named by the environment
//! variable `PLANTIGRADE_REPORTS`; the default is `shared/reports` next to the project's folder. The test is
//! ignored where the folder or Python is missing.

use std::path::{Path, PathBuf};
use std::process::Command;

use libtest_mimic::{Arguments, Trial};

/// Cases that are known to fail; see the limits in `README.md`.
const KNOWN_FAILURES: [&str; 2] = ["tilt-pitch-25", "drift-wave-8"];

fn main() {
    let arguments = Arguments::from_args();
    let default = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/reports");
    let folder = std::env::var_os("PLANTIGRADE_REPORTS").map_or(default, PathBuf::from);
    let script = folder.join("check.py");
    let has_python = Command::new("python3").arg("--version").output().is_ok_and(|run| run.status.success());
    let is_runnable = script.is_file() && has_python;
    let test = move || {
        check(&script);
        Ok(())
    };
    let tests = vec![Trial::test("reported_cases_hold", test).with_ignored_flag(!is_runnable)];
    libtest_mimic::run(&arguments, tests).exit();
}

/// Runs all cases; each failing expectation is a line that begins with the name of its case.
fn check(script: &Path) {
    let output = Command::new("python3")
        .arg(script)
        .args(["--binary", env!("CARGO_BIN_EXE_plantigrade")])
        .output()
        .expect("Python runs");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("cases hold"), "{text}{}", String::from_utf8_lossy(&output.stderr));
    let failures: Vec<&str> = text
        .lines()
        .take_while(|line| !line.is_empty())
        .filter(|line| line.contains('['))
        .filter(|line| !KNOWN_FAILURES.iter().any(|known| line.starts_with(known)))
        .collect();
    assert!(failures.is_empty(), "{failures:#?}");
}
