//! Joint names in any encoding.

/// Decoder of joint names of which at least one is not UTF-8: returns the texts and the name of the
/// encoding, as the Encoding Standard of WHATWG names it. Saved files keep the bytes, so that the texts are
/// for display and for roles only.
pub type NameDecoder = fn(&[Vec<u8>]) -> (Vec<String>, &'static str);

/// The decoder that is used by default.
#[cfg(feature = "encodings")]
pub(crate) const DEFAULT_DECODER: NameDecoder = guess::decode;
/// The decoder that is used by default.
#[cfg(not(feature = "encodings"))]
pub(crate) const DEFAULT_DECODER: NameDecoder = decode_windows_1252;

/// Returns the names as text, and their encoding if it is not UTF-8.
pub(crate) fn decode(names: &[Vec<u8>], decoder: NameDecoder) -> (Vec<String>, Option<&'static str>) {
    match names.iter().map(|name| std::str::from_utf8(name).map(str::to_owned)).collect() {
        Ok(names) => (names, None),
        Err(_) => {
            let (names, encoding) = decoder(names);
            (names, Some(encoding))
        }
    }
}

/// Characters of windows-1252 from 0x80 to 0x9f, as the Encoding Standard of WHATWG defines them.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}',
    '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// Decodes names as windows-1252, which gives any bytes a meaning.
pub fn decode_windows_1252(names: &[Vec<u8>]) -> (Vec<String>, &'static str) {
    let decode = |&byte: &u8| match byte {
        0x80..=0x9f => WINDOWS_1252[usize::from(byte - 0x80)],
        byte => char::from(byte),
    };
    (names.iter().map(|name| name.iter().map(decode).collect()).collect(), "windows-1252")
}

#[cfg(feature = "encodings")]
mod guess {
    use chardetng::{EncodingDetector, Iso2022JpDetection, Utf8Detection};
    use encoding_rs::Encoding;

    /// Decodes names in the encoding that is guessed from all of them together. Encoding the texts
    /// returns the bytes: if the guess does not have that property, windows-1252 is used.
    pub fn decode(names: &[Vec<u8>]) -> (Vec<String>, &'static str) {
        let mut detector = EncodingDetector::new(Iso2022JpDetection::Deny);
        for name in names {
            detector.feed(name, false);
            detector.feed(b"\n", false);
        }
        detector.feed(b"", true);
        let guess = detector.guess(None, Utf8Detection::Deny);
        let decoded: Option<_> = names.iter().map(|name| decode_exactly(name, guess)).collect();
        decoded.map_or_else(|| super::decode_windows_1252(names), |decoded| (decoded, guess.name()))
    }

    /// Decodes a name if the text encodes to the same bytes.
    fn decode_exactly(name: &[u8], encoding: &'static Encoding) -> Option<String> {
        let text = encoding.decode_without_bom_handling_and_without_replacement(name)?;
        let (bytes, _, has_errors) = encoding.encode(&text);
        (!has_errors && *bytes == *name).then(|| text.into_owned())
    }
}

/// Returns the length of a name at the beginning of `text`, which ends with the line, at a brace
/// or at a comment.
pub(crate) fn name_len(text: &[u8]) -> usize {
    // Whether the text before the first brace is UTF-8 decides for all braces, as what follows a character
    // that is not UTF-8 is not UTF-8, either.
    let mut is_utf8 = None;
    let before = |at: usize| at.checked_sub(1).map_or(b' ', |before| text[before]);
    let ends = |&at: &usize| match text[at] {
        // In other encodings than UTF-8 the last byte of a character may equal a brace.
        b'{' => {
            *is_utf8.get_or_insert_with(|| std::str::from_utf8(&text[..at]).is_ok()) || before(at).is_ascii()
        }
        // A name may contain `#2`.
        b'#' => is_blank(before(at)) && text.get(at + 1).is_none_or(|&next| is_blank(next)),
        b'/' => is_blank(before(at)) && text.get(at + 1) == Some(&b'/'),
        _ => false,
    };
    (0..text.len()).find(ends).unwrap_or(text.len())
}

fn is_blank(byte: u8) -> bool {
    crate::bvh::number::is_blank(byte)
}

#[cfg(all(test, feature = "encodings"))]
mod tests {
    use encoding_rs::{BIG5, EUC_KR, Encoding, GBK, SHIFT_JIS, WINDOWS_1252};
    use proptest::prelude::*;

    use super::*;

    fn encode(names: &[&str], encoding: &'static Encoding) -> Vec<Vec<u8>> {
        names.iter().map(|name| encoding.encode(name).0.into_owned()).collect()
    }

    #[test]
    fn common_encodings_are_recognised() {
        for (encoding, names) in [
            (
                SHIFT_JIS,
                &["センター", "上半身", "下半身", "左足", "左ひざ", "左足首", "右足", "右ひざ", "右足首"][..],
            ),
            (
                GBK,
                &["骨盆", "左大腿", "左小腿", "左脚", "左脚趾", "右大腿", "右小腿", "右脚", "脊椎", "头部"],
            ),
            (
                EUC_KR,
                &["골반", "왼쪽허벅지", "왼쪽종아리", "왼쪽발", "오른쪽허벅지", "오른쪽종아리", "오른쪽발"],
            ),
            (
                BIG5,
                &["骨盆", "左大腿", "左小腿", "左腳", "左腳趾", "右大腿", "右小腿", "右腳", "脊椎", "頭部"],
            ),
            (WINDOWS_1252, &["Hüfte", "Oberschenkel links", "Knie links", "Fuß links", "Fuß rechts"]),
        ] {
            let (decoded, guess) = decode(&encode(names, encoding), DEFAULT_DECODER);
            assert_eq!(
                (&decoded[..], guess),
                (&names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>()[..], Some(encoding.name()))
            );
        }
    }

    #[test]
    fn unicode_names_are_not_guessed() {
        let names = ["Hips", "左足首", "Hüfte"];
        let (decoded, guess) = decode(&names.map(|name| name.as_bytes().to_vec()), DEFAULT_DECODER);
        assert_eq!((decoded, guess), (names.map(String::from).to_vec(), None));
    }

    #[test]
    fn names_end_at_braces_and_comments() {
        for (text, len) in [
            (&b"Hips"[..], 4),
            (b"Left Foot {", 10),
            (b"Foot{", 4),
            ("Fuß{".as_bytes(), 4),
            // The second byte of ボ in Shift-JIS equals a brace.
            (b"\x83\x7b\x81\x5b {", 5),
            (b"\x83\x7b", 2),
            (b"Finger #2", 9),
            (b"Finger # the second", 7),
            (b"Foot // left {", 5),
            (b"a//b", 4),
            (b"# none", 0),
        ] {
            assert_eq!(name_len(text), len, "{}", String::from_utf8_lossy(text));
        }
    }

    proptest! {
        #[test]
        fn bytes_of_names_are_recoverable(names in prop::collection::vec(prop::collection::vec(0x20_u8.., 0..9), 1..6)) {
            let encode = |text: &str, encoding: &str| {
                let encoding = Encoding::for_label(encoding.as_bytes()).expect("the name of an encoding");
                encoding.encode(text).0.into_owned()
            };
            for decoder in [DEFAULT_DECODER, decode_windows_1252] {
                let (decoded, encoding) = decode(&names, decoder);
                for (text, bytes) in decoded.iter().zip(&names) {
                    let encoded = encoding.map_or(text.as_bytes().to_vec(), |encoding| encode(text, encoding));
                    prop_assert_eq!(&encoded, bytes);
                }
            }
        }
    }
}
