//! Parts that the scripts for Blender and for game engines share.

use std::fmt::Write;

/// Functions that add to the animations that are selected in Unreal Engine. They use the constants `FOLDER`,
/// `DURATION`, `RATE`, `REMOVE` and `TRACK` of the script.
pub(super) const UNREAL: &str = include_str!("unreal.py");

/// How to run a script in Unreal Engine.
pub(super) const RUN_IN_UNREAL: &str = "select the animation sequence in the content browser, then run this script\n\
    # (Tools > Execute Python Script; requires the plugins Python Editor Script Plugin and Editor Scripting Utilities).\n\n";

/// Returns the constants that a script for Unreal Engine begins with.
pub(super) fn unreal_constants(source: &str, rate: f64, duration: f64) -> String {
    format!(
        "# File name, frame rate in Hz and duration in seconds of the clip.\n\
         SOURCE = {}\nRATE = {rate:?}\nDURATION = {duration:?}\n\n\
         # Folder of the classes of the notifies.\nFOLDER = \"/Game/Plantigrade\"\n\n\
         # True to remove what an earlier run has added, and add nothing.\nREMOVE = False\n\n",
        python_literal(source)
    )
}

/// Menu commands that add to what is selected in Unity, or remove it. They call `Change` of the script for an
/// animation clip, and `Import` for an imported model; each returns false if it does not apply.
pub(super) const UNITY: &str = include_str!("unity.cs");

/// Returns the start of an editor script for Unity, with the constants of its class: `contents` is what it adds
/// to `target`.
pub(super) fn unity_class(class: &str, contents: &str, target: &str, source: &str) -> String {
    format!(
        "// To add {contents} in Unity, put this script into a folder named Editor, select {target}\n\
         // in the project window, and choose Assets > Plantigrade > Add {contents}.\n\
         #if UNITY_EDITOR\n\
         using System;\nusing System.Collections.Generic;\nusing UnityEditor;\nusing UnityEngine;\n\n\
         namespace Plantigrade\n{{\n    static class {class}_{}\n    {{\n\
         {INDENT}const string Menu = {};\n{INDENT}const string Target = {};\n",
        identifier(source),
        csharp_literal(&format!("{contents} of {source}")),
        csharp_literal(target),
    )
}

/// Indentation of the members of a class.
const INDENT: &str = "        ";

/// Returns a text as a Python literal: JSON strings in ASCII are Python literals.
pub(super) fn python_literal(text: &str) -> String {
    let json = serde_json::Value::from(text).to_string();
    let mut literal = String::with_capacity(json.len());
    for c in json.chars() {
        match c {
            ' '..='~' => literal.push(c),
            _ => {
                // Writing to a String cannot fail.
                let _ = write!(literal, "\\U{:08x}", u32::from(c));
            }
        }
    }
    literal
}

/// Returns a text as a C# string literal for a menu or a name of an asset, in which slashes and other special
/// characters have a meaning.
pub(super) fn csharp_literal(text: &str) -> String {
    let mut literal = String::from("\"");
    for c in text.chars() {
        match c {
            '/' | '%' | '#' | '&' | '\\' | '"' => literal.push('_'),
            ' '..='~' => literal.push(c),
            _ => {
                for unit in c.encode_utf16(&mut [0; 2]) {
                    let _ = write!(literal, "\\u{unit:04x}");
                }
            }
        }
    }
    literal.push('"');
    literal
}

/// Returns a name in which other characters than ASCII letters and digits are replaced by an underscore and
/// their code, so that different names differ.
pub(super) fn identifier(name: &str) -> String {
    let mut identifier = String::with_capacity(name.len());
    for c in name.chars() {
        match c {
            'a'..='z' | 'A'..='Z' | '0'..='9' => identifier.push(c),
            _ => identifier.push_str(&format!("_{:x}", u32::from(c))),
        }
    }
    identifier
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_text_becomes_a_literal() {
        assert_eq!(python_literal("walk.bvh"), "\"walk.bvh\"");
        assert_eq!(python_literal("\"\"\"\\\n\r"), r#""\"\"\"\\\n\r""#);
        assert_eq!(
            python_literal("à\u{2028}\u{7f}𝄞\0"),
            r#""\U000000e0\U00002028\U0000007f\U0001d11e\u0000""#
        );
        assert_eq!(csharp_literal("walk 1.bvh"), "\"walk 1.bvh\"");
        assert_eq!(csharp_literal("a/b\\\"c\n𝄞"), "\"a_b__c\\u000a\\ud834\\udd1e\"");
    }

    #[test]
    fn different_names_have_different_identifiers() {
        assert_eq!(identifier("B:Hips"), "B_3aHips");
        assert_ne!(identifier("a b"), identifier("a_b"));
    }
}
