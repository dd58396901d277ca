//! Numbers straight from bytes, correctly rounded.

use crate::bvh::error::place;
use crate::notice::Place;

/// A number found at the beginning of some bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Number {
    pub value: f64,
    /// Bytes it takes up.
    pub len: usize,
    pub mark: Mark,
}

/// The decimal mark of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    None,
    Point,
    Comma,
}

/// The decimal marks that a file has used so far.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Decimals {
    pub points: bool,
    /// Where the first comma stands.
    pub commas: Option<Place>,
}

impl Decimals {
    /// Takes note of a number whose first byte is `at` of line number `line`.
    pub fn note(&mut self, mark: Mark, line: usize, text: &[u8], at: usize) {
        match mark {
            Mark::Point => self.points = true,
            Mark::Comma if self.commas.is_none() => self.commas = Some(place(line, text, at)),
            _ => {}
        }
    }

    pub fn mixed(&self) -> bool {
        self.points && self.commas.is_some()
    }
}

/// Powers of ten that a double holds exactly.
pub(crate) const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// The finite number that `bytes` begin with.
///
/// It must end with the bytes, at a blank, or at the sign of a number run
/// together with it, as in `0.0-7.5`; otherwise the word is no number.
pub(crate) fn leading(bytes: &[u8]) -> Option<Number> {
    let mut at = 0;
    let negative = match bytes.first()? {
        b'-' => {
            at = 1;
            true
        }
        b'+' => {
            at = 1;
            false
        }
        _ => false,
    };
    // A mantissa of 19 digits fits u64; where there are more, the slow path is taken.
    let mut mantissa = 0_u64;
    let digits_from = at;
    let mut mark = Mark::None;
    let mut mark_at = 0;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'0'..=b'9' => mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(byte - b'0')),
            b'.' | b',' if mark == Mark::None => {
                mark = if byte == b'.' { Mark::Point } else { Mark::Comma };
                mark_at = at;
            }
            _ => break,
        }
        at += 1;
    }
    let marked = usize::from(mark != Mark::None);
    let digits = at - digits_from - marked;
    if digits == 0 {
        return None;
    }
    let fraction = if marked == 1 { at - mark_at - 1 } else { 0 };
    let exponent = exponent_len(&bytes[at..]);
    let end = at + exponent;
    match bytes.get(end) {
        None | Some(b' ' | b'\t' | b'-' | b'+' | 0x0b | 0x0c) => {}
        Some(_) => return None,
    }
    let value = if exponent == 0 && digits <= 19 && mantissa <= 1 << 53 && fraction < EXACT_POWERS.len() {
        // Both operands are exact, so the quotient is correctly rounded.
        let magnitude = mantissa as f64 / EXACT_POWERS[fraction];
        if negative { -magnitude } else { magnitude }
    } else {
        slowly(&bytes[..end], mark)?
    };
    Some(Number { value, len: end, mark })
}

/// Length of the exponent that `bytes` begin with; 0 if there is none.
fn exponent_len(bytes: &[u8]) -> usize {
    let Some(b'e' | b'E') = bytes.first() else { return 0 };
    let sign = usize::from(matches!(bytes.get(1), Some(b'+' | b'-')));
    match bytes[1 + sign..].iter().take_while(|byte| byte.is_ascii_digit()).count() {
        0 => 0,
        digits => 1 + sign + digits,
    }
}

fn slowly(bytes: &[u8], mark: Mark) -> Option<f64> {
    let text = std::str::from_utf8(bytes).ok()?;
    let value: f64 = match mark {
        Mark::Comma => text.replacen(',', ".", 1).parse().ok()?,
        _ => text.parse().ok()?,
    };
    value.is_finite().then_some(value)
}

/// The bytes up to the next blank.
pub(crate) fn word(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().position(|&byte| is_blank(byte)).unwrap_or(bytes.len());
    &bytes[..end]
}

/// Index of the first byte from `at` on that is no blank.
pub(crate) fn skip_blanks(bytes: &[u8], at: usize) -> usize {
    at + bytes[at..].iter().take_while(|&&byte| is_blank(byte)).count()
}

pub(crate) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0b | 0x0c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value(text: &str) -> Option<f64> {
        leading(text.as_bytes()).map(|number| number.value)
    }

    #[test]
    fn reads_numbers_as_they_occur() {
        for (text, expected) in [
            ("0", 0.0),
            ("-12.5", -12.5),
            ("+1.0", 1.0),
            (".0083333", 0.0083333),
            ("5.", 5.0),
            ("1e-3", 1e-3),
            ("-4.2E+2", -420.0),
            ("0,033", 0.033),
            ("1,5e1", 15.0),
            ("0.016666666666666666", 0.016666666666666666),
            ("123456789012345678901234567890", 123456789012345678901234567890.0),
        ] {
            assert_eq!(value(text), Some(expected), "{text}");
        }
    }

    #[test]
    fn refuses_what_is_no_number() {
        for text in ["", "-", ".", "abc", "nan", "inf", "1.2.3", "1x", "1e", "0x10", "1e999", "1,2,3"] {
            assert_eq!(value(text), None, "{text}");
        }
    }

    #[test]
    fn separates_numbers_run_together() {
        let number = leading(b"0.0-7.5").unwrap();
        assert_eq!((number.value, number.len), (0.0, 3));
        assert_eq!(leading(b"1e-3-2").unwrap().len, 4);
    }

    proptest! {
        #[test]
        fn agrees_with_the_standard_library(x in proptest::num::f64::NORMAL, digits in 0_usize..30) {
            for text in [format!("{x}"), format!("{x:e}"), format!("{x:.digits$}")] {
                prop_assert_eq!(value(&text), text.parse().ok());
            }
        }

        #[test]
        fn never_panics(bytes in proptest::collection::vec(any::<u8>(), 0..40)) {
            let _ = leading(&bytes);
        }
    }
}
