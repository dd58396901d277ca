//! Lines from chunks: LF, CRLF, CR, or a mixture.

/// Cuts text that comes in chunks into lines and counts them.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    /// The beginning of a line whose end has not come yet.
    carry: Vec<u8>,
    /// The last line that was put together from several chunks.
    joined: Vec<u8>,
    /// The last line ended in CR: an LF that follows belongs to it.
    after_cr: bool,
    /// Number of the line last given out, from 1.
    count: usize,
}

impl Lines {
    /// The next line that ends within `text`, with its number; leaves in `text` what follows it.
    ///
    /// Where there is none, `text` is to be held for the next chunk.
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
        if self.carry.is_empty() {
            return Some((self.count, line));
        }
        self.carry.extend_from_slice(line);
        std::mem::swap(&mut self.carry, &mut self.joined);
        self.carry.clear();
        Some((self.count, &self.joined))
    }

    /// Holds back the beginning of a line for the next chunk.
    ///
    /// Gives the line's number if it is longer than `limit` bytes.
    pub fn hold(&mut self, text: &[u8], limit: usize) -> Result<(), usize> {
        if self.carry.len() + text.len() > limit {
            return Err(self.count + 1);
        }
        self.carry.extend_from_slice(text);
        Ok(())
    }

    /// Whether the text that comes next begins a line.
    pub fn at_start(&self) -> bool {
        self.carry.is_empty() && !self.after_cr
    }

    /// Counts lines that were read without being given out.
    pub fn skip(&mut self, lines: usize) {
        self.count += lines;
    }

    /// The last line, if the text does not end with a line end.
    pub fn finish(&mut self) -> Option<(usize, Vec<u8>)> {
        let rest = std::mem::take(&mut self.carry);
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
        let mut found = Vec::new();
        for mut chunk in text.as_bytes().chunks(chunk) {
            while let Some((number, line)) = lines.next(&mut chunk) {
                found.push(String::from_utf8(line.to_vec()).unwrap());
                assert_eq!(number, found.len());
            }
            lines.hold(chunk, 1000).unwrap();
        }
        found.extend(lines.finish().map(|(_, line)| String::from_utf8(line).unwrap()));
        found
    }

    #[test]
    fn all_line_ends_count_once() {
        assert_eq!(lines("a\nb\r\nc\rd\r\re", 100), ["a", "b", "c", "d", "", "e"]);
        assert_eq!(lines("", 1), [""; 0]);
        assert_eq!(lines("a\r\n", 1), ["a"]);
    }

    #[test]
    fn long_lines_are_refused() {
        let mut lines = Lines::default();
        let mut text = &b"ok\nabcdef"[..];
        assert!(lines.next(&mut text).is_some());
        assert_eq!(lines.hold(text, 5), Err(2));
    }

    proptest! {
        #[test]
        fn chunks_do_not_matter(text in "[ab\n\r]{0,40}", chunk in 1_usize..8) {
            prop_assert_eq!(lines(&text, chunk), lines(&text, 100));
        }
    }
}
