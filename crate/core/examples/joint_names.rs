//! Writes `docs/joint-names.md`, the table of all known joint names.
//!
//! Run with `cargo run -p plantigrade --example joint_names > docs/joint-names.md`.

fn main() {
    print!("{}", plantigrade::skeleton::joint_names_document());
}
