//! Correctly rounded numbers from bytes.

use crate::bvh::error::{Error, ErrorKind, location};
use crate::notice::Location;

/// Number at the beginning of a byte string.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Number {
    pub value: f64,
    /// Length in bytes.
    pub len: usize,
    pub mark: DecimalMark,
    /// Decimal places, after the exponent has been applied; at most [`MAX_DECIMALS`].
    pub decimals: u8,
}

/// Decimal places beyond which a double rarely differs.
pub(crate) const MAX_DECIMALS: u8 = 22;

/// Decimal mark of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DecimalMark {
    None,
    Point,
    Comma,
}

/// Decimal marks used in a file so far.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Decimals {
    pub points: bool,
    /// Location of the first comma.
    pub commas: Option<Location>,
}

impl Decimals {
    /// Records the mark of the number at byte `at` of line number `line`.
    ///
    /// # Errors
    /// If numbers before it have the other mark.
    pub fn record(&mut self, mark: DecimalMark, line: usize, text: &[u8], at: usize) -> Result<(), Error> {
        match mark {
            DecimalMark::Point => self.points = true,
            DecimalMark::Comma if self.commas.is_none() => self.commas = Some(location(line, text, at)),
            _ => {}
        }
        match self.points && self.commas.is_some() {
            true => Err(Error::at(ErrorKind::MixedDecimals, line, text, at)),
            false => Ok(()),
        }
    }
}

/// Powers of ten that a double represents exactly.
pub(crate) const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// Returns the finite number at the beginning of `bytes`.
///
/// The number must end with the bytes, at a blank, or at the sign of the next number as in
/// `0.0-7.5`; otherwise the word is not a number.
pub(crate) fn parse_leading(bytes: &[u8]) -> Option<Number> {
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
    // A mantissa of 19 digits fits u64; longer numbers take the slow path.
    let mut mantissa = 0_u64;
    let digits_start = at;
    let mut mark = DecimalMark::None;
    let mut mark_at = 0;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'0'..=b'9' => mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(byte - b'0')),
            b'.' | b',' if mark == DecimalMark::None => {
                mark = if byte == b'.' { DecimalMark::Point } else { DecimalMark::Comma };
                mark_at = at;
            }
            _ => break,
        }
        at += 1;
    }
    let mark_len = usize::from(mark != DecimalMark::None);
    let digits = at - digits_start - mark_len;
    if digits == 0 {
        return None;
    }
    let fraction = if mark_len == 1 { at - mark_at - 1 } else { 0 };
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
        parse_slow(&bytes[..end], mark)?
    };
    let power = std::str::from_utf8(bytes[at..end].get(1..).unwrap_or_default()).ok();
    let power: i64 = power.and_then(|power| power.parse().ok()).unwrap_or_default();
    let decimals = (fraction as i64).saturating_sub(power).clamp(0, MAX_DECIMALS.into()) as u8;
    Some(Number { value, len: end, mark, decimals })
}

/// Returns the length of the exponent at the beginning of `bytes`; 0 if there is none.
fn exponent_len(bytes: &[u8]) -> usize {
    let Some(b'e' | b'E') = bytes.first() else { return 0 };
    let sign = usize::from(matches!(bytes.get(1), Some(b'+' | b'-')));
    match bytes[1 + sign..].iter().take_while(|byte| byte.is_ascii_digit()).count() {
        0 => 0,
        digits => 1 + sign + digits,
    }
}

fn parse_slow(bytes: &[u8], mark: DecimalMark) -> Option<f64> {
    let text = std::str::from_utf8(bytes).ok()?;
    let value: f64 = match mark {
        DecimalMark::Comma => text.replacen(',', ".", 1).parse().ok()?,
        _ => text.parse().ok()?,
    };
    value.is_finite().then_some(value)
}

/// True if `bytes` begin with a comment, which ends with the line.
pub(crate) fn is_comment(bytes: &[u8]) -> bool {
    bytes.starts_with(b"#") || bytes.starts_with(b"//")
}

/// Returns the bytes up to the next blank.
pub(crate) fn word(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().position(|&byte| is_blank(byte)).unwrap_or(bytes.len());
    &bytes[..end]
}

/// Returns the index of the first byte from `at` that is not a blank.
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
        parse_leading(text.as_bytes()).map(|number| number.value)
    }

    #[test]
    fn reads_all_number_formats() {
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
    fn rejects_other_words() {
        for text in ["", "-", ".", "abc", "nan", "inf", "1.2.3", "1x", "1e", "0x10", "1e999", "1,2,3"] {
            assert_eq!(value(text), None, "{text}");
        }
    }

    #[test]
    fn separates_numbers_run_together() {
        let number = parse_leading(b"0.0-7.5").unwrap();
        assert_eq!((number.value, number.len), (0.0, 3));
        assert_eq!(parse_leading(b"1e-3-2").unwrap().len, 4);
    }

    #[test]
    fn decimals_include_the_exponent() {
        for (text, decimals) in
            [("1", 0), ("-1.50", 2), ("1.5e-3", 4), ("1.25e+1", 1), ("5e3", 0), ("1e-300", 22)]
        {
            assert_eq!(parse_leading(text.as_bytes()).unwrap().decimals, decimals, "{text}");
        }
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
            let _ = parse_leading(&bytes);
        }
    }
}
