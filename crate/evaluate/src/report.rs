//! The page: text, tables and figures.

use std::fmt::Write;
use std::path::PathBuf;

/// The page as it grows.
pub struct Report {
    text: String,
    figures: PathBuf,
}

impl Report {
    /// An empty page whose figures go into a folder.
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

    /// Adds a table; all but the first column are numbers.
    pub fn table(&mut self, head: &[&str], rows: &[Vec<String>]) {
        let mut table = format!("| {} |\n|---|{}\n", head.join(" | "), "---:|".repeat(head.len() - 1));
        for row in rows {
            // Writing to a String cannot fail.
            let _ = writeln!(table, "| {} |", row.join(" | "));
        }
        self.text(&table);
    }

    /// Adds a figure and gives the path to write it to.
    pub fn figure(&mut self, name: &str, alt: &str) -> PathBuf {
        self.text(&format!("![{alt}](docs/results/{name}.svg)"));
        self.figures.join(format!("{name}.svg"))
    }

    /// Begins a part that can be kept.
    pub fn begin(&mut self, mark: &str) {
        self.text(&format!("<!-- {mark} -->"));
    }

    /// Ends a part that can be kept.
    pub fn end(&mut self, mark: &str) {
        self.text(&format!("<!-- /{mark} -->"));
    }

    /// Takes a part over from an earlier page, with its figures as they are.
    pub fn keep(&mut self, before: &str, mark: &str) {
        let (begin, end) = (format!("<!-- {mark} -->"), format!("<!-- /{mark} -->"));
        if let (Some(from), Some(to)) = (before.find(&begin), before.find(&end)) {
            self.text(&before[from..to + end.len()]);
            println!("The section \"{mark}\" is kept as it is: the recorded trials are not here.");
        }
    }

    /// The whole page.
    pub fn finish(self) -> String {
        self.text
    }
}

/// A percentage with two decimals.
pub fn percent(value: f64) -> String {
    format!("{value:.2}")
}

/// A difference with its sign.
pub fn signed(value: f64) -> String {
    format!("{value:+.2}")
}
