//! CSV: fields in quotes where they must be, and rows of them back.

use std::borrow::Cow;

use crate::formats::LabelsError;

/// A text as a field.
pub(crate) fn field(text: &str) -> Cow<'_, str> {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\"")).into()
    } else {
        text.into()
    }
}

/// One row with its fields.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Row {
    /// The line that it begins in, from 1.
    line: usize,
    fields: Vec<String>,
}

/// The rows of a table, without blank lines.
pub(crate) fn rows(text: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut row = Row { line: 1, fields: Vec::new() };
    let (mut line, mut field, mut is_quoted) = (1, String::new(), false);
    // Spreadsheets put a mark before the first row, and not always a line end after the last.
    let mut text = text.trim_start_matches('\u{feff}').chars().chain(['\n']).peekable();
    while let Some(c) = text.next() {
        line += usize::from(c == '\n');
        match c {
            '"' if is_quoted && text.peek() == Some(&'"') => field.extend(text.next()),
            '"' if is_quoted || field.is_empty() => is_quoted = !is_quoted,
            // A quote that never ends takes no more than the rest.
            ',' if !is_quoted => row.fields.push(std::mem::take(&mut field)),
            '\n' if !is_quoted || text.peek().is_none() => {
                row.fields.push(std::mem::take(&mut field));
                let done = std::mem::replace(&mut row, Row { line, fields: Vec::new() });
                let is_blank = matches!(&done.fields[..], [field] if field.trim().is_empty());
                rows.extend((!is_blank).then_some(done));
            }
            '\r' if !is_quoted => {}
            c => field.push(c),
        }
    }
    rows
}

/// The column of a name.
pub(crate) fn column(head: &Row, name: &str) -> Option<usize> {
    head.fields.iter().position(|field| field.trim() == name)
}

impl Row {
    /// One field, without spaces about it.
    pub fn field(&self, column: usize) -> Option<&str> {
        self.fields.get(column).map(|field| field.trim())
    }

    /// What is wrong with a field.
    pub fn wrong(&self, expected: &str, found: Option<&str>) -> LabelsError {
        let found = found.unwrap_or("nothing");
        LabelsError::Wrong(format!("row {}: expected {expected}, found {found:?}", self.line))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_survive_the_table() {
        let fields = ["walk", "", "a, b", "say \"hop\"", "two\nlines"];
        let text = fields.map(|text| field(text).into_owned()).join(",");
        let rows = rows(&format!("\u{feff}{text}\r\n\r\nlast,1"));
        assert_eq!(rows[0].fields, fields);
        assert_eq!((rows.len(), rows[1].line, rows[1].field(1)), (2, 4, Some("1")));
        assert_eq!(column(&rows[1], "last"), Some(0));
    }

    #[test]
    fn a_quote_without_end_takes_the_rest() {
        assert_eq!(rows("a,\"b,c\nd")[0].fields, ["a", "b,c\nd"]);
        assert!(rows("").is_empty() && rows("\n\r\n").is_empty());
        assert_eq!(rows(",\n").len(), 1, "fields may be empty");
    }
}
