//! Conversion of UTF-8 and UTF-16, with or without a byte order mark, to UTF-8 bytes and back.

/// Decodes a file in chunks of any size.
#[derive(Debug, Default)]
pub(crate) struct Decoder {
    encoding: Option<Encoding>,
    /// Bytes of an incomplete character or byte order mark: at most three.
    pending: Vec<u8>,
    /// UTF-16 high surrogate whose low surrogate has not been read.
    surrogate: Option<u16>,
    has_bom: bool,
    text: Vec<u8>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Encoding {
    Utf8,
    Utf16 { big_endian: bool },
}

impl Decoder {
    /// Returns the text of the next chunk, borrowed from the chunk if it already is UTF-8.
    pub fn decode<'a>(&'a mut self, chunk: &'a [u8]) -> &'a [u8] {
        match self.encoding {
            Some(Encoding::Utf8) => return chunk,
            Some(Encoding::Utf16 { big_endian }) => {
                self.pending.extend_from_slice(chunk);
                self.transcode(big_endian);
            }
            None => {
                self.pending.extend_from_slice(chunk);
                // Three bytes distinguish a UTF-8 byte order mark from everything else.
                if self.pending.len() >= 3 {
                    self.detect_encoding();
                } else {
                    self.text.clear();
                }
            }
        }
        &self.text
    }

    /// Returns the remaining text at the end of the file.
    pub fn finish(&mut self) -> &[u8] {
        self.text.clear();
        if self.encoding.is_none() {
            self.detect_encoding();
        }
        if self.surrogate.take().is_some() || !self.pending.is_empty() {
            push_char(&mut self.text, char::REPLACEMENT_CHARACTER);
            self.pending.clear();
        }
        &self.text
    }

    /// Appends the byte order mark of the file, if it has one, after it has been decoded.
    pub fn encode_bom(&self, bytes: &mut Vec<u8>) {
        if self.has_bom {
            self.encode("\u{feff}".as_bytes(), bytes);
        }
    }

    /// Appends text in the encoding of the file: the inverse of decoding, except for characters that
    /// are not valid UTF-16. The text must consist of whole characters.
    pub fn encode(&self, text: &[u8], bytes: &mut Vec<u8>) {
        match self.encoding {
            Some(Encoding::Utf16 { big_endian }) => {
                let units = String::from_utf8_lossy(text);
                let units = units.encode_utf16();
                bytes.extend(
                    units.flat_map(|unit| if big_endian { unit.to_be_bytes() } else { unit.to_le_bytes() }),
                );
            }
            Some(Encoding::Utf8) | None => bytes.extend_from_slice(text),
        }
    }

    fn detect_encoding(&mut self) {
        let (encoding, bom) = match self.pending[..] {
            [0xef, 0xbb, 0xbf, ..] => (Encoding::Utf8, 3),
            [0xff, 0xfe, ..] => (Encoding::Utf16 { big_endian: false }, 2),
            [0xfe, 0xff, ..] => (Encoding::Utf16 { big_endian: true }, 2),
            // Without a byte order mark: BVH begins with ASCII, so one byte of the first pair is zero.
            [1..=255, 0, ..] => (Encoding::Utf16 { big_endian: false }, 0),
            [0, 1..=255, ..] => (Encoding::Utf16 { big_endian: true }, 0),
            _ => (Encoding::Utf8, 0),
        };
        self.encoding = Some(encoding);
        self.has_bom = bom > 0;
        self.pending.drain(..bom);
        match encoding {
            Encoding::Utf8 => self.text = std::mem::take(&mut self.pending),
            Encoding::Utf16 { big_endian } => self.transcode(big_endian),
        }
    }

    fn transcode(&mut self, big_endian: bool) {
        self.text.clear();
        let whole = self.pending.len() / 2 * 2;
        let units = self.pending[..whole].chunks_exact(2).map(|pair| {
            let pair = [pair[0], pair[1]];
            if big_endian { u16::from_be_bytes(pair) } else { u16::from_le_bytes(pair) }
        });
        let mut units: Vec<u16> = self.surrogate.take().into_iter().chain(units).collect();
        if units.last().is_some_and(|unit| (0xd800..0xdc00).contains(unit)) {
            self.surrogate = units.pop();
        }
        for c in char::decode_utf16(units) {
            push_char(&mut self.text, c.unwrap_or(char::REPLACEMENT_CHARACTER));
        }
        self.pending.drain(..whole);
    }
}

fn push_char(text: &mut Vec<u8>, c: char) {
    text.extend_from_slice(c.encode_utf8(&mut [0; 4]).as_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn decode(bytes: &[u8], chunk: usize) -> String {
        let mut decoder = Decoder::default();
        let mut text = Vec::new();
        for chunk in bytes.chunks(chunk) {
            text.extend_from_slice(decoder.decode(chunk));
        }
        text.extend_from_slice(decoder.finish());
        String::from_utf8(text).unwrap()
    }

    fn encode(text: &str, big_endian: bool, bom: bool) -> Vec<u8> {
        let units = bom.then_some(0xfeff).into_iter().chain(text.encode_utf16());
        units.flat_map(|unit| if big_endian { unit.to_be_bytes() } else { unit.to_le_bytes() }).collect()
    }

    proptest! {
        #[test]
        fn decodes_any_encoding_in_chunks_of_any_size(tail in "\\PC{0,20}", chunk in 1_usize..9) {
            let text = format!("HIERARCHY {tail}");
            prop_assert_eq!(&decode(text.as_bytes(), chunk), &text);
            prop_assert_eq!(&decode(format!("\u{feff}{text}").as_bytes(), chunk), &text);
            for big_endian in [false, true] {
                for bom in [false, true] {
                    prop_assert_eq!(&decode(&encode(&text, big_endian, bom), chunk), &text);
                }
            }
        }
    }

    proptest! {
        #[test]
        fn decoded_text_is_encoded_to_the_same_bytes(tail in "\\PC{0,20}", big_endian in any::<bool>(), bom in any::<bool>()) {
            let text = format!("HIERARCHY {tail}");
            let utf8 = if bom { format!("\u{feff}{text}") } else { text.clone() };
            for bytes in [encode(&text, big_endian, bom), utf8.into_bytes()] {
                let mut decoder = Decoder::default();
                let text = decoder.decode(&bytes).to_vec();
                let mut encoded = Vec::new();
                decoder.encode_bom(&mut encoded);
                decoder.encode(&text, &mut encoded);
                prop_assert_eq!(&encoded, &bytes);
            }
        }
    }

    #[test]
    fn short_files_are_decoded() {
        assert_eq!(decode(b"", 1), "");
        assert_eq!(decode(b"H", 1), "H");
        assert_eq!(decode(&[0xff, 0xfe], 1), "");
        assert_eq!(decode(&[0xff, 0xfe, b'H', 0, b'I'], 2), "H\u{fffd}");
    }
}
