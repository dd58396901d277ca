//! Registry entry of a file format.

/// A format with its writer and reader.
pub(crate) struct FormatInfo<Writer, Reader> {
    pub name: &'static str,
    pub title: &'static str,
    pub description: &'static str,
    /// File extension, without the leading dot; it differs from those of all other formats.
    pub extension: &'static str,
    /// Media (MIME) type.
    pub media_type: &'static str,
    pub write: Writer,
    /// Reader, if the format can be read.
    pub read: Option<Reader>,
}

/// Returns the text of a file without a byte order mark; `None` if it is not UTF-8.
pub(crate) fn text_of(bytes: &[u8]) -> Option<&str> {
    str::from_utf8(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)).ok()
}
