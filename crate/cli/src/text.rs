//! Names from outside in messages and text.

use std::ffi::OsStr;
use std::fmt::Write;
use std::path::Path;

/// Returns the name of an input: its path, or `<stdin>`. Bytes that are not UTF-8 become `\xNN`. Control
/// characters remain; see [`escape`].
pub fn display_name(path: &Path) -> String {
    if path == Path::new("-") { "<stdin>".into() } else { decode(path.as_os_str()) }
}

/// Returns a name as text, with `\xNN` for each byte that is not UTF-8.
pub fn decode(name: &OsStr) -> String {
    let mut text = String::new();
    for chunk in name.as_encoded_bytes().utf8_chunks() {
        text.push_str(chunk.valid());
        for byte in chunk.invalid() {
            // Writing to a String cannot fail.
            let _ = write!(text, r"\x{byte:02x}");
        }
    }
    text
}

/// Escapes the characters that break lines, control the terminal or reorder text.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => {
                escaped.extend(c.escape_default());
            }
            c if c.is_control() => escaped.extend(c.escape_default()),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escape_replaces_control_characters_only() {
        for text in ["", "walk.bvh", "左ひざ é ± → “x”", r"C:\clips\a.bvh", "👩‍🚀"] {
            assert_eq!(escape(text), text);
        }
        assert_eq!(
            escape("a\n\r\t\0\u{1b}[31m\u{7f}\u{9b}\u{202e}\u{2028}"),
            r"a\n\r\t\u{0}\u{1b}[31m\u{7f}\u{9b}\u{202e}\u{2028}"
        );
    }

    #[cfg(unix)]
    #[test]
    fn decode_tells_invalid_bytes_apart() {
        use std::os::unix::ffi::OsStrExt;
        assert_eq!(decode(OsStr::from_bytes(b"a\xff\xfe\xc3\xa9")), r"a\xff\xfeé");
    }
}
