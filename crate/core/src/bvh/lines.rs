//! Lines from chunks: LF, CRLF, CR, or a mixture.

/// Cuts text that comes in chunks into lines and counts them.
#[derive(Debug, Default)]
pub(super) struct Lines {
    /// The beginning of a line whose end has not come yet.
    carry: Vec<u8>,
    /// The last line ended in CR: an LF that follows belongs to it.
    after_cr: bool,
    /// Number of the line last given out, from 1.
    count: usize,
}

impl Lines {
    /// Gives every line that ends within `text` to `each`, with its number.
    ///
    /// Stops at the first error. `limit` is the longest line that is held
    /// back for the next chunk, in bytes; a longer one gives `too_long`.
    pub fn feed<E>(
        &mut self,
        mut text: &[u8],
        limit: usize,
        too_long: impl FnOnce(usize) -> E,
        mut each: impl FnMut(usize, &[u8]) -> Result<(), E>,
    ) -> Result<(), E> {
        if self.after_cr && !text.is_empty() {
            self.after_cr = false;
            text = text.strip_prefix(b"\n").unwrap_or(text);
        }
        while let Some(end) = text.iter().position(|&byte| byte == b'\n' || byte == b'\r') {
            self.count += 1;
            if self.carry.is_empty() {
                each(self.count, &text[..end])?;
            } else {
                self.carry.extend_from_slice(&text[..end]);
                each(self.count, &self.carry)?;
                self.carry.clear();
            }
            let was_cr = text[end] == b'\r';
            text = &text[end + 1..];
            if was_cr {
                match text.first() {
                    Some(b'\n') => text = &text[1..],
                    Some(_) => {}
                    None => self.after_cr = true,
                }
            }
        }
        if self.carry.len() + text.len() > limit {
            return Err(too_long(self.count + 1));
        }
        self.carry.extend_from_slice(text);
        Ok(())
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
        for chunk in text.as_bytes().chunks(chunk) {
            lines
                .feed(
                    chunk,
                    1000,
                    |_| (),
                    |number, line| {
                        found.push(String::from_utf8(line.to_vec()).unwrap());
                        assert_eq!(number, found.len());
                        Ok(())
                    },
                )
                .unwrap();
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
        assert_eq!(lines.feed(b"ok\nabcdef", 5, |line| line, |_, _| Ok(())), Err(2));
    }

    proptest! {
        #[test]
        fn chunks_do_not_matter(text in "[ab\n\r]{0,40}", chunk in 1_usize..8) {
            prop_assert_eq!(lines(&text, chunk), lines(&text, 100));
        }
    }
}
