//! Statements of the frame time, with or without a unit.

use crate::bvh::number::{self, DecimalMark};

/// Frame time as stated in a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StatedFrameTime {
    pub seconds: f64,
    /// Length of the number with its unit, in bytes.
    pub len: usize,
    pub mark: DecimalMark,
    /// True if a unit or a fraction was stated, which BVH does not provide for.
    pub has_unit: bool,
}

impl StatedFrameTime {
    /// Parses the beginning of `text`: a number of seconds, a number with a unit as in `33.3 ms` or
    /// `30 fps`, or a fraction as in `1/30`. Returns `None` if there is no number.
    pub fn parse(text: &[u8]) -> Option<StatedFrameTime> {
        let word = number::word(text);
        let is_number = |byte: &&u8| byte.is_ascii_digit() || **byte == b'.';
        let number_len = word.len() - word.iter().rev().take_while(|byte| !is_number(byte)).count();
        if let Some(slash) = word.iter().position(|&byte| byte == b'/') {
            let [numerator, denominator] = [&word[..slash], &word[slash + 1..]].map(whole_number);
            let ((numerator, mark), (denominator, _)) = numerator.zip(denominator)?;
            return Some(StatedFrameTime {
                seconds: numerator / denominator,
                len: word.len(),
                mark,
                has_unit: true,
            });
        }
        let (value, mark) = match whole_number(&word[..number_len]) {
            Some(number) => number,
            None => {
                let number = number::parse_leading(text)?;
                let (seconds, len, mark) = (number.value, number.len, number.mark);
                return Some(StatedFrameTime { seconds, len, mark, has_unit: false });
            }
        };
        let unit_at = number::skip_blanks(text, number_len);
        let unit = number::word(&text[unit_at..]);
        Some(match seconds(value, unit) {
            Some(seconds) => StatedFrameTime { seconds, len: unit_at + unit.len(), mark, has_unit: true },
            None => StatedFrameTime { seconds: value, len: number_len, mark, has_unit: false },
        })
    }
}

/// Returns the value and decimal mark if all of `word` is one number.
fn whole_number(word: &[u8]) -> Option<(f64, DecimalMark)> {
    let number = number::parse_leading(word)?;
    (number.len == word.len()).then_some((number.value, number.mark))
}

/// Returns the time in seconds for a value with a unit of time or of rate.
fn seconds(value: f64, unit: &[u8]) -> Option<f64> {
    let unit = std::str::from_utf8(unit).ok()?.to_ascii_lowercase();
    Some(match unit.trim_end_matches('.') {
        "s" | "sec" | "secs" | "second" | "seconds" => value,
        "ms" | "msec" | "msecs" | "millisecond" | "milliseconds" => value / 1e3,
        "us" | "\u{b5}s" | "\u{3bc}s" | "microseconds" => value / 1e6,
        "hz" | "fps" | "frames" | "frames/s" | "frames/sec" | "frames/second" => 1.0 / value,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_and_fractions_are_understood() {
        for (text, seconds, len) in [
            ("33.3 ms", 0.0333, 7),
            ("33.3ms", 0.0333, 6),
            ("0.04 sec 1 2 3", 0.04, 8),
            ("0,04 s", 0.04, 6),
            ("2.5e-2s", 0.025, 7),
            ("40 Milliseconds", 0.04, 15),
            ("25 fps", 0.04, 6),
            ("25Hz", 0.04, 4),
            ("1/25", 0.04, 4),
            ("25 frames/s", 0.04, 11),
            ("25 frames per second", 0.04, 9),
            ("40000 us", 0.04, 8),
        ] {
            let stated = StatedFrameTime::parse(text.as_bytes()).expect(text);
            assert!((stated.seconds - seconds).abs() < 1e-12, "{text}");
            assert_eq!((stated.len, stated.has_unit), (len, true), "{text}");
        }
    }

    #[test]
    fn plain_numbers_are_seconds() {
        for (text, seconds, len) in [
            ("0.04", 0.04, 4),
            (".04 1 2 3", 0.04, 3),
            ("4e-2", 0.04, 4),
            ("0.04 (25 fps)", 0.04, 4),
            ("0.04, 1 2 3", 0.04, 4),
            ("0.04;", 0.04, 4),
            ("0.0-7.5", 0.0, 3),
        ] {
            let stated = StatedFrameTime::parse(text.as_bytes()).expect(text);
            assert_eq!((stated.seconds, stated.len, stated.has_unit), (seconds, len, false), "{text}");
        }
        for text in ["", "none", "ms", "fps 30", "1/x", "-"] {
            assert_eq!(StatedFrameTime::parse(text.as_bytes()), None, "{text}");
        }
    }
}
