//! Fields and rows of CSV tables.

use std::borrow::Cow;

use crate::formats::document::ReadError;

/// Returns a text as a field, quoted if necessary.
pub(crate) fn field(text: &str) -> Cow<'_, str> {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\"")).into()
    } else {
        text.into()
    }
}

/// Returns the header of a table, with a column `root` if any skeleton has a named root.
pub(crate) fn table_header<'a>(mut roots: impl Iterator<Item = Option<&'a str>>, columns: &str) -> String {
    format!("{}{columns}", if roots.any(|root| root.is_some()) { "root," } else { "" })
}

/// Returns the name of the root as a field with its comma; empty without a name.
pub(crate) fn root_field(root: Option<&str>) -> String {
    root.map_or_else(String::new, |name| format!("{},", field(name)))
}

/// Returns the time of a frame in seconds, rounded to microseconds.
pub(crate) fn seconds(frame: usize, frame_time: f64) -> f64 {
    (frame as f64 * frame_time * 1e6).round() / 1e6
}

/// Row of a table.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Row {
    /// Number of the line on which the row begins, from 1.
    line: usize,
    fields: Vec<String>,
}

/// Returns the rows of a table without blank lines.
fn rows(text: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut row = Row { line: 1, fields: Vec::new() };
    let (mut line, mut field, mut is_quoted) = (1, String::new(), false);
    // Spreadsheets write a byte order mark, and not always a line end after the last row.
    let mut text = text.trim_start_matches('\u{feff}').chars().chain(['\n']).peekable();
    while let Some(c) = text.next() {
        line += usize::from(c == '\n');
        match c {
            '"' if is_quoted && text.peek() == Some(&'"') => field.extend(text.next()),
            '"' if is_quoted || field.is_empty() => is_quoted = !is_quoted,
            ',' if !is_quoted => row.fields.push(std::mem::take(&mut field)),
            // A quote without end includes the rest of the text.
            '\n' if !is_quoted || text.peek().is_none() => {
                row.fields.push(std::mem::take(&mut field));
                let complete = std::mem::replace(&mut row, Row { line, fields: Vec::new() });
                let is_blank = matches!(&complete.fields[..], [field] if field.trim().is_empty());
                rows.extend((!is_blank).then_some(complete));
            }
            '\r' if !is_quoted => {}
            c => field.push(c),
        }
    }
    rows
}

/// Returns the header and the rows of a table of one skeleton.
///
/// # Errors
/// If a column `root` has several names.
pub(crate) fn table(text: &str) -> Result<(Row, Vec<Row>), ReadError> {
    let mut rows = rows(text);
    let header = if rows.is_empty() { Row::default() } else { rows.remove(0) };
    if let (Some(root), Some(first)) = (column(&header, "root"), rows.first())
        && rows.iter().any(|row| row.field(root) != first.field(root))
    {
        return Err(ReadError::SeveralSkeletons);
    }
    Ok((header, rows))
}

/// Returns the index of the column with a name.
pub(crate) fn column(header: &Row, name: &str) -> Option<usize> {
    header.fields.iter().position(|field| field.trim() == name)
}

impl Row {
    /// Returns one field without surrounding spaces.
    pub fn field(&self, column: usize) -> Option<&str> {
        self.fields.get(column).map(|field| field.trim())
    }

    /// Returns the error for a field with an unexpected value.
    pub fn unexpected(&self, expected: &str, found: Option<&str>) -> ReadError {
        let found = found.unwrap_or("nothing");
        ReadError::Invalid(format!("row {}: expected {expected}, found {found:?}", self.line))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_round_trip() {
        let fields = ["walk", "", "a, b", "say \"hop\"", "two\nlines"];
        let text = fields.map(|text| field(text).into_owned()).join(",");
        let rows = rows(&format!("\u{feff}{text}\r\n\r\nlast,1"));
        assert_eq!(rows[0].fields, fields);
        assert_eq!((rows.len(), rows[1].line, rows[1].field(1)), (2, 4, Some("1")));
        assert_eq!(column(&rows[1], "last"), Some(0));
    }

    #[test]
    fn a_quote_without_end_includes_the_rest() {
        assert_eq!(rows("a,\"b,c\nd")[0].fields, ["a", "b,c\nd"]);
        assert!(rows("").is_empty() && rows("\n\r\n").is_empty());
        assert_eq!(rows(",\n").len(), 1, "fields may be empty");
    }
}
