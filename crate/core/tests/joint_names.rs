//! The documentation of joint names.

#[test]
fn document_agrees_with_the_vocabulary() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/joint-names.md");
    let document = std::fs::read_to_string(path).expect("docs/joint-names.md");
    assert_eq!(
        document.replace("\r\n", "\n"),
        plantigrade::skeleton::joint_names_document(),
        "run `cargo run -p plantigrade --example joint_names > docs/joint-names.md`"
    );
}
