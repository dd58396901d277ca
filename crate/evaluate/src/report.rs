//! The report: a Markdown page of text, tables and figures.

use std::fmt::Write;
use std::path::PathBuf;

/// A Markdown page under construction.
pub struct Report {
    text: String,
    figures: PathBuf,
}

impl Report {
    /// Creates an empty page whose figures are written to the folder `figures`.
    pub fn new(figures: PathBuf) -> Report {
        Report { text: String::new(), figures }
    }

    /// Adds paragraphs.
    pub fn text(&mut self, text: &str) {
        if !self.text.is_empty() {
            self.text.push('\n');
        }
        self.text.push_str(text.trim_end());
        self.text.push('\n');
    }

    /// Adds a table. All columns but the first are aligned right.
    pub fn table(&mut self, head: &[&str], rows: &[Vec<String>]) {
        let mut table = format!("| {} |\n|---|{}\n", head.join(" | "), "---:|".repeat(head.len() - 1));
        for row in rows {
            // Writing to a String cannot fail.
            let _ = writeln!(table, "| {} |", row.join(" | "));
        }
        self.text(&table);
    }

    /// Adds a figure and returns the path to write it to.
    pub fn figure(&mut self, name: &str, alt: &str) -> PathBuf {
        self.text(&format!("![{alt}](docs/results/{name}.svg)"));
        self.figures.join(format!("{name}.svg"))
    }

    /// Begins a section that [`Report::copy_section`] can copy.
    pub fn begin_section(&mut self, mark: &str) {
        self.text(&format!("<!-- {mark} -->"));
    }

    /// Ends a section.
    pub fn end_section(&mut self, mark: &str) {
        self.text(&format!("<!-- /{mark} -->"));
    }

    /// Copies a section from a previous version of the page. Its figures are not changed.
    pub fn copy_section(&mut self, previous: &str, mark: &str) {
        let (begin, end) = (format!("<!-- {mark} -->"), format!("<!-- /{mark} -->"));
        if let (Some(from), Some(to)) = (previous.find(&begin), previous.find(&end)) {
            self.text(&previous[from..to + end.len()]);
            println!("Copied the section \"{mark}\": the recorded trials are not available.");
        }
    }

    /// Returns the text of the page.
    pub fn finish(self) -> String {
        self.text
    }
}

/// Formats a percentage with two decimals.
pub fn percent(value: f64) -> String {
    format!("{value:.2}")
}

/// Formats a difference with its sign and two decimals.
pub fn signed(value: f64) -> String {
    format!("{value:+.2}")
}
