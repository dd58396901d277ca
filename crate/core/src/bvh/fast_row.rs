//! Plain rows in one pass: what nearly every row of nearly every file is.

use crate::bvh::number::EXACT_POWERS;

/// The bytes that a plain row takes up at the beginning of `text`, its line end included.
///
/// A plain row is a line of numbers without exponents or commas, as many as
/// there are `values`, each of no more digits than a double holds exactly.
/// Anything else, or a line whose end has not come yet, is `None` and for
/// others to judge; `values` then hold anything. `points` becomes true at the
/// first decimal point.
pub(crate) fn row(text: &[u8], values: &mut [f64], points: &mut bool) -> Option<usize> {
    let mut cursor = Cursor { text, at: 0, byte: *text.first()? };
    for value in values {
        cursor.skip_blanks()?;
        let negative = cursor.byte == b'-';
        if negative {
            cursor.step()?;
        }
        let mut mantissa = 0;
        let mut digits = cursor.digits(&mut mantissa)?;
        let mut fraction = 0;
        if cursor.byte == b'.' {
            *points = true;
            cursor.step()?;
            fraction = cursor.digits(&mut mantissa)?;
            digits += fraction;
        }
        // The mantissa of more digits has wrapped around.
        if digits == 0 || digits > 19 || mantissa > 1 << 53 || !cursor.is_between() {
            return None;
        }
        // Both operands are exact, so the quotient is correctly rounded.
        let magnitude = mantissa as f64 / EXACT_POWERS.get(fraction)?;
        *value = if negative { -magnitude } else { magnitude };
    }
    cursor.skip_blanks()?;
    match (cursor.byte, text.get(cursor.at + 1)) {
        (b'\n', _) => Some(cursor.at + 1),
        (b'\r', Some(b'\n')) => Some(cursor.at + 2),
        // After a CR that comes last there may be an LF to come.
        (b'\r', Some(_)) => Some(cursor.at + 1),
        _ => None,
    }
}

/// A place in a text that goes on: steps beyond the end are `None`.
struct Cursor<'a> {
    text: &'a [u8],
    at: usize,
    byte: u8,
}

impl Cursor<'_> {
    #[inline]
    fn step(&mut self) -> Option<()> {
        self.at += 1;
        self.byte = *self.text.get(self.at)?;
        Some(())
    }

    #[inline]
    fn skip_blanks(&mut self) -> Option<()> {
        while matches!(self.byte, b' ' | b'\t') {
            self.step()?;
        }
        Some(())
    }

    /// Appends the digits that come next to `mantissa` and counts them.
    #[inline]
    fn digits(&mut self, mantissa: &mut u64) -> Option<usize> {
        let start = self.at;
        while self.byte.is_ascii_digit() {
            *mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(self.byte - b'0'));
            self.step()?;
        }
        Some(self.at - start)
    }

    /// Whether a number may end here.
    #[inline]
    fn is_between(&self) -> bool {
        matches!(self.byte, b' ' | b'\t' | b'\n' | b'\r')
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::bvh::number;

    fn one(text: &str) -> Option<f64> {
        let mut values = [f64::NAN];
        let len = row(text.as_bytes(), &mut values, &mut false)?;
        assert_eq!(len, text.len());
        Some(values[0])
    }

    #[test]
    fn lines_end_in_many_ways() {
        for (text, expected) in [
            ("1 -2.5\nx", Some(7)),
            ("1 -2.5 \t\nx", Some(9)),
            ("\t1\t-2.5\r\nx", Some(9)),
            ("1 -2.5\rx", Some(7)),
            ("1 -2.5\r", None),
            ("1 -2.5", None),
            ("1 -2.5 3\n", None),
            ("1\n-2.5\n", None),
            ("\n", None),
            ("", None),
        ] {
            let (mut values, mut points) = ([0.0; 2], false);
            assert_eq!(row(text.as_bytes(), &mut values, &mut points), expected, "{text:?}");
            if expected.is_some() {
                assert_eq!((values, points), ([1.0, -2.5], true));
            }
        }
        let mut points = false;
        assert!(row(b"1 2\n", &mut [0.0; 2], &mut points).is_some() && !points);
    }

    #[test]
    fn what_is_not_plain_is_left_to_others() {
        for word in ["+1", "1e3", "0,5", "1-2", "nan", "-", ".", "--1", "1.2.3", "1\u{b}", "9007199254740993"]
        {
            assert_eq!(one(&format!("{word}\n")), None, "{word}");
        }
        assert_eq!(one("9007199254740992\n"), Some(9007199254740992.0));
        assert_eq!(one("0.0000000000000000000001\n"), None);
        assert_eq!(one(".000000000000000001\n"), Some(1e-18));
    }

    proptest! {
        #[test]
        fn agrees_with_the_standard_library(x in prop_oneof![-1e3..1e3, prop::num::f64::NORMAL], digits in 0_usize..25) {
            for word in [format!("{x}"), format!("{x:.digits$}")] {
                if let Some(value) = one(&format!("{word}\n")) {
                    prop_assert_eq!(value.to_bits(), word.parse::<f64>().unwrap().to_bits());
                }
            }
            let short = format!("{:.4}\n", x % 1e4);
            prop_assert!(one(&short).is_some());
        }

        #[test]
        fn takes_no_more_than_others_do(word in "[-+0-9.,eE]{0,24}") {
            if let Some(value) = one(&format!("{word}\n")) {
                let number = number::leading(word.as_bytes()).unwrap();
                prop_assert_eq!((value.to_bits(), word.len()), (number.value.to_bits(), number.len));
            }
        }
    }
}
