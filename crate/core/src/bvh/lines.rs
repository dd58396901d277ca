//! Splits chunks into lines that end in LF, CRLF, CR or a mixture.

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
}

impl Lines {
    /// Returns the next line that ends within `text`, with its number, and advances `text` past it.
    ///
    /// If it returns `None`, pass `text` to [`carry`](Lines::carry).
    pub fn next<'a, 't: 'a>(&'a mut self, text: &mut &'t [u8]) -> Option<(usize, &'a [u8])> {
        if self.after_cr && !text.is_empty() {
            self.after_cr = false;
            *text = text.strip_prefix(b"\n").unwrap_or(text);
        }
        let end = text.iter().position(|&byte| byte == b'\n' || byte == b'\r')?;
        let line = &text[..end];
        *text = match text[end..] {
            [b'\r'] => {
                self.after_cr = true;
                &[]
            }
            [b'\r', b'\n', ref rest @ ..] | [_, ref rest @ ..] => rest,
            [] => unreachable!("a line end was found"),
        };
        self.count += 1;
        if self.carried.is_empty() {
            return Some((self.count, line));
        }
        self.carried.extend_from_slice(line);
        std::mem::swap(&mut self.carried, &mut self.joined);
        self.carried.clear();
        Some((self.count, &self.joined))
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

    /// Counts lines that were read elsewhere.
    pub fn skip(&mut self, lines: usize) {
        self.count += lines;
    }

    /// Returns the last line if the text does not end with a line end.
    pub fn finish(&mut self) -> Option<(usize, Vec<u8>)> {
        let rest = std::mem::take(&mut self.carried);
        (!rest.is_empty()).then(|| {
            self.count += 1;
            (self.count, rest)
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
        for mut chunk in text.as_bytes().chunks(chunk) {
            while let Some((number, line)) = lines.next(&mut chunk) {
                result.push(String::from_utf8(line.to_vec()).unwrap());
                assert_eq!(number, result.len());
            }
            lines.carry(chunk, 1000).unwrap();
        }
        result.extend(lines.finish().map(|(_, line)| String::from_utf8(line).unwrap()));
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
