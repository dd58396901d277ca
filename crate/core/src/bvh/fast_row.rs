//! Fast reader of rows of plain numbers, the most common kind of row.

use crate::bvh::number::EXACT_POWERS;

/// Reads a row from the beginning of `text` and returns its length with the line end, in bytes.
///
/// Accepts a line of numbers without exponents and commas, as many as there are `values`, each with
/// no more digits than a double represents exactly and no larger than `limit`. Returns `None` for any
/// other line and for a line whose end has not been read; `values` are then unspecified, and the general
/// reader must be used. Sets `points` at the first decimal point, and raises `decimals` to the number of decimals
/// of each value.
pub(crate) fn read_row(
    text: &[u8],
    values: &mut [f64],
    decimals: &mut [u8],
    points: &mut bool,
    limit: f64,
) -> Option<usize> {
    let mut cursor = Cursor { text, at: 0, byte: *text.first()? };
    for (value, decimals) in values.iter_mut().zip(decimals) {
        cursor.skip_blanks()?;
        let negative = cursor.byte == b'-';
        if negative {
            cursor.advance()?;
        }
        let mut mantissa = 0;
        let mut digits = cursor.append_digits(&mut mantissa)?;
        let mut fraction = 0;
        if cursor.byte == b'.' {
            *points = true;
            cursor.advance()?;
            fraction = cursor.append_digits(&mut mantissa)?;
            digits += fraction;
        }
        // With more digits the mantissa has wrapped around.
        if digits == 0 || digits > 19 || mantissa > 1 << 53 || !cursor.at_number_end() {
            return None;
        }
        // Both operands are exact, so the quotient is correctly rounded.
        let magnitude = mantissa as f64 / EXACT_POWERS.get(fraction)?;
        if magnitude > limit {
            return None;
        }
        *value = if negative { -magnitude } else { magnitude };
        *decimals = (*decimals).max(fraction as u8);
    }
    cursor.skip_blanks()?;
    match (cursor.byte, text.get(cursor.at + 1)) {
        (b'\n', _) => Some(cursor.at + 1),
        (b'\r', Some(b'\n')) => Some(cursor.at + 2),
        // An LF may follow a CR at the end of the chunk.
        (b'\r', Some(_)) => Some(cursor.at + 1),
        _ => None,
    }
}

/// Position in a text that may continue: steps beyond the end return `None`.
struct Cursor<'a> {
    text: &'a [u8],
    at: usize,
    byte: u8,
}

impl Cursor<'_> {
    #[inline]
    fn advance(&mut self) -> Option<()> {
        self.at += 1;
        self.byte = *self.text.get(self.at)?;
        Some(())
    }

    #[inline]
    fn skip_blanks(&mut self) -> Option<()> {
        while matches!(self.byte, b' ' | b'\t') {
            self.advance()?;
        }
        Some(())
    }

    /// Appends the digits at the cursor to `mantissa` and returns their count.
    #[inline]
    fn append_digits(&mut self, mantissa: &mut u64) -> Option<usize> {
        let start = self.at;
        while self.byte.is_ascii_digit() {
            *mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(self.byte - b'0'));
            self.advance()?;
        }
        Some(self.at - start)
    }

    /// True if a number may end at the cursor.
    #[inline]
    fn at_number_end(&self) -> bool {
        matches!(self.byte, b' ' | b'\t' | b'\n' | b'\r')
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::bvh::number;

    fn read_one(text: &str) -> Option<f64> {
        let mut values = [f64::NAN];
        let len = read_row(text.as_bytes(), &mut values, &mut [0], &mut false, f64::INFINITY)?;
        assert_eq!(len, text.len());
        Some(values[0])
    }

    #[test]
    fn all_line_ends_are_accepted() {
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
            let (mut values, mut decimals, mut points) = ([0.0; 2], [0; 2], false);
            let len = read_row(text.as_bytes(), &mut values, &mut decimals, &mut points, f64::INFINITY);
            assert_eq!(len, expected, "{text:?}");
            if expected.is_some() {
                assert_eq!((values, decimals, points), ([1.0, -2.5], [0, 1], true));
            }
        }
        let mut points = false;
        let mut read = |limit| read_row(b"1 -2\n", &mut [0.0; 2], &mut [0; 2], &mut points, limit);
        assert_eq!((read(2.0), read(1.9)), (Some(5), None));
        assert!(!points);
    }

    #[test]
    fn other_numbers_are_left_to_the_general_reader() {
        for word in ["+1", "1e3", "0,5", "1-2", "nan", "-", ".", "--1", "1.2.3", "1\u{b}", "9007199254740993"]
        {
            assert_eq!(read_one(&format!("{word}\n")), None, "{word}");
        }
        assert_eq!(read_one("9007199254740992\n"), Some(9007199254740992.0));
        assert_eq!(read_one("0.0000000000000000000001\n"), None);
        assert_eq!(read_one(".000000000000000001\n"), Some(1e-18));
    }

    proptest! {
        #[test]
        fn agrees_with_the_standard_library(x in prop_oneof![-1e3..1e3, prop::num::f64::NORMAL], digits in 0_usize..25) {
            for word in [format!("{x}"), format!("{x:.digits$}")] {
                if let Some(value) = read_one(&format!("{word}\n")) {
                    prop_assert_eq!(value.to_bits(), word.parse::<f64>().unwrap().to_bits());
                }
            }
            let short = format!("{:.4}\n", x % 1e4);
            prop_assert!(read_one(&short).is_some());
        }

        #[test]
        fn agrees_with_the_general_reader(word in "[-+0-9.,eE]{0,24}") {
            if let Some(value) = read_one(&format!("{word}\n")) {
                let number = number::parse_leading(word.as_bytes()).unwrap();
                prop_assert_eq!((value.to_bits(), word.len()), (number.value.to_bits(), number.len));
            }
        }
    }
}
