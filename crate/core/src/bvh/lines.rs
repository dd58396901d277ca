//! Splits chunks into lines that end in LF, CRLF, CR or a mixture.

/// One line of a text, without its end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<'a> {
    /// Number, from 1.
    pub number: usize,
    /// Byte index of the line in the whole text.
    pub start: u64,
    pub text: &'a [u8],
}

/// Splits text that arrives in chunks into numbered lines.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    /// Beginning of a line whose end has not been read.
    carried: Vec<u8>,
    /// Last line that was joined from several chunks.
    joined: Vec<u8>,
    /// True if the last line ended in CR: an LF that follows belongs to it.
    after_cr: bool,
    /// Number of the line returned last, from 1.
    count: usize,
    /// Byte index of the next line in the whole text.
    start: u64,
}

impl Lines {
    /// Returns the next line that ends within `text`, and advances `text` past it.
    ///
    /// If it returns `None`, pass `text` to [`carry`](Lines::carry).
    pub fn next<'a, 't: 'a>(&'a mut self, text: &mut &'t [u8]) -> Option<Line<'a>> {
        if self.after_cr && !text.is_empty() {
            self.after_cr = false;
            if let Some(rest) = text.strip_prefix(b"\n") {
                *text = rest;
                self.start += 1;
            }
        }
        let end = text.iter().position(|&byte| byte == b'\n' || byte == b'\r')?;
        let line = &text[..end];
        let before = text.len();
        *text = match text[end..] {
            [b'\r'] => {
                self.after_cr = true;
                &[]
            }
            [b'\r', b'\n', ref rest @ ..] | [_, ref rest @ ..] => rest,
            [] => unreachable!("a line end was found"),
        };
        let start = self.start;
        self.start += (self.carried.len() + before - text.len()) as u64;
        self.count += 1;
        let number = self.count;
        if self.carried.is_empty() {
            return Some(Line { number, start, text: line });
        }
        self.carried.extend_from_slice(line);
        std::mem::swap(&mut self.carried, &mut self.joined);
        self.carried.clear();
        Some(Line { number, start, text: &self.joined })
    }

    /// Stores the beginning of a line until the next chunk.
    ///
    /// # Errors
    /// The number of the line if it is longer than `limit` bytes.
    pub fn carry(&mut self, text: &[u8], limit: usize) -> Result<(), usize> {
        if self.carried.len() + text.len() > limit {
            return Err(self.count + 1);
        }
        self.carried.extend_from_slice(text);
        Ok(())
    }

    /// True if the next text begins a line.
    pub fn at_start(&self) -> bool {
        self.carried.is_empty() && !self.after_cr
    }

    /// Returns the byte index of the next line in the whole text.
    pub fn start(&self) -> u64 {
        self.start
    }

    /// Counts lines that were read elsewhere, and their bytes.
    pub fn skip(&mut self, lines: usize, bytes: usize) {
        self.count += lines;
        self.start += bytes as u64;
    }

    /// Returns the last line if the text does not end with a line end.
    pub fn finish(&mut self) -> Option<Line<'_>> {
        self.joined = std::mem::take(&mut self.carried);
        let start = self.start;
        self.start += self.joined.len() as u64;
        (!self.joined.is_empty()).then(|| {
            self.count += 1;
            Line { number: self.count, start, text: &self.joined }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn lines(text: &str, chunk: usize) -> Vec<String> {
        let mut lines = Lines::default();
        let mut result = Vec::new();
        let mut add = |line: Line<'_>| {
            let found = String::from_utf8(line.text.to_vec()).unwrap();
            assert!(text[line.start as usize..].starts_with(&found));
            assert!(line.start == 0 || matches!(text.as_bytes()[line.start as usize - 1], b'\n' | b'\r'));
            result.push(found);
            assert_eq!(line.number, result.len());
        };
        for mut chunk in text.as_bytes().chunks(chunk) {
            while let Some(line) = lines.next(&mut chunk) {
                add(line);
            }
            lines.carry(chunk, 1000).unwrap();
        }
        lines.finish().into_iter().for_each(add);
        result
    }

    #[test]
    fn every_line_end_counts_once() {
        assert_eq!(lines("a\nb\r\nc\rd\r\re", 100), ["a", "b", "c", "d", "", "e"]);
        assert_eq!(lines("", 1), [""; 0]);
        assert_eq!(lines("a\r\n", 1), ["a"]);
    }

    #[test]
    fn long_lines_are_rejected() {
        let mut lines = Lines::default();
        let mut text = &b"ok\nabcdef"[..];
        assert!(lines.next(&mut text).is_some());
        assert_eq!(lines.carry(text, 5), Err(2));
    }

    proptest! {
        #[test]
        fn the_result_does_not_depend_on_the_chunks(text in "[ab\n\r]{0,40}", chunk in 1_usize..8) {
            prop_assert_eq!(lines(&text, chunk), lines(&text, 100));
        }
    }
}
