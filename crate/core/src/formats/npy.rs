//! NumPy's array format, version 1.0 (and 2.0 and 3.0, which allow longer headers): a magic word, a
//! header that is a Python literal, and the values.

use crate::formats::document::ReadError;

const MAGIC: &[u8] = b"\x93NUMPY";

/// Headers are padded to a multiple of this length, in bytes.
const ALIGNMENT: usize = 64;

/// Array with its shape.
#[derive(Debug)]
pub(crate) struct Array<'a> {
    /// Kind of the values, as `b` in `b1` or `U` in `U10`.
    pub kind: char,
    /// Size of a value, in bytes, or in characters for text.
    pub size: usize,
    pub shape: Vec<usize>,
    /// True if the first index varies fastest.
    pub fortran: bool,
    values: &'a [u8],
}

/// Returns the file of an array whose last index varies fastest.
pub(crate) fn write(kind: &str, shape: &[usize], values: &[u8]) -> Vec<u8> {
    // A tuple of one number needs a comma.
    let shape: String = shape.iter().map(|size| format!("{size},")).collect();
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}");
    let before = MAGIC.len() + 4;
    while !(before + header.len() + 1).is_multiple_of(ALIGNMENT) {
        header.push(' ');
    }
    header.push('\n');
    [MAGIC, &[1, 0], &(header.len() as u16).to_le_bytes(), header.as_bytes(), values].concat()
}

/// Returns the file of an array of texts.
pub(crate) fn texts(shape: &[usize], texts: &[&str]) -> Vec<u8> {
    // NumPy has no empty text type.
    let max_len = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
    let padded = |text: &str| {
        let values = text.chars().map(u32::from).chain(std::iter::repeat(0)).take(max_len);
        values.flat_map(u32::to_le_bytes).collect::<Vec<u8>>()
    };
    let values: Vec<u8> = texts.iter().flat_map(|text| padded(text)).collect();
    write(&format!("<U{max_len}"), shape, &values)
}

/// Reads a file without trusting the sizes in its header.
pub(crate) fn read<'a>(name: &str, bytes: &'a [u8]) -> Result<Array<'a>, ReadError> {
    let invalid = |what: &str| ReadError::Invalid(format!("{name} is not a valid array: {what}"));
    let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| invalid("it does not begin with the magic word"))?;
    let (length, rest) = match rest {
        [1, 0, a, b, rest @ ..] => (usize::from(u16::from_le_bytes([*a, *b])), rest),
        [2 | 3, 0, a, b, c, d, rest @ ..] => (u32::from_le_bytes([*a, *b, *c, *d]) as usize, rest),
        _ => return Err(invalid("its version is unknown")),
    };
    let (header, values) = rest.split_at_checked(length).ok_or_else(|| invalid("it is incomplete"))?;
    let header = str::from_utf8(header).map_err(|_| invalid("its header is not text"))?;
    let kind = header_entry(header, "descr").and_then(|rest| rest.strip_prefix('\'')?.split('\'').next());
    let kind = kind.ok_or_else(|| invalid("its values have several types"))?;
    let (kind, size) = match kind.strip_prefix(['<', '|']).and_then(|kind| {
        let (letter, size) = kind.split_at_checked(1)?;
        Some((letter.chars().next()?, size.parse::<usize>().ok()?))
    }) {
        Some(kind) => kind,
        None => return Err(invalid(&format!("the type {kind} is not supported"))),
    };
    let shape = header_entry(header, "shape").and_then(|rest| rest.strip_prefix('(')?.split(')').next());
    let sizes = shape.ok_or_else(|| invalid("it has no shape"))?.split(',').map(str::trim);
    let shape: Result<Vec<usize>, _> =
        sizes.filter(|size| !size.is_empty()).map(|size| size.parse::<usize>()).collect();
    let shape = shape.map_err(|_| invalid("it has no shape"))?;
    let bytes = if kind == 'U' { size.checked_mul(4) } else { Some(size) };
    let total = shape.iter().try_fold(bytes.unwrap_or(0), |product, &size| product.checked_mul(size));
    if bytes.is_none_or(|bytes| bytes == 0) || total != Some(values.len()) {
        return Err(invalid("the number of values does not match its shape"));
    }
    let fortran = header_entry(header, "fortran_order").is_some_and(|rest| rest.starts_with("True"));
    Ok(Array { kind, size, shape, fortran, values })
}

/// Returns the text after a key of the header.
fn header_entry<'a>(header: &'a str, key: &str) -> Option<&'a str> {
    let (_, rest) = header.split_once(&format!("'{key}'"))?;
    Some(rest.trim_start().strip_prefix(':')?.trim_start())
}

impl Array<'_> {
    /// Returns the values as numbers in the order of the file; `None` for other types.
    pub fn numbers(&self) -> Option<Vec<f64>> {
        let number: fn(&[u8]) -> f64 = match (self.kind, self.size) {
            ('b' | 'u', 1) => |bytes| f64::from(bytes[0]),
            ('i', 1) => |bytes| f64::from(bytes[0] as i8),
            ('i', 2) => |bytes| bytes.first_chunk().map_or(f64::NAN, |&b| i16::from_le_bytes(b).into()),
            ('i', 4) => |bytes| bytes.first_chunk().map_or(f64::NAN, |&b| i32::from_le_bytes(b).into()),
            ('i', 8) => |bytes| bytes.first_chunk().map_or(f64::NAN, |&b| i64::from_le_bytes(b) as f64),
            ('f', 4) => |bytes| bytes.first_chunk().map_or(f64::NAN, |&b| f32::from_le_bytes(b).into()),
            ('f', 8) => |bytes| bytes.first_chunk().map_or(f64::NAN, |&b| f64::from_le_bytes(b)),
            _ => return None,
        };
        Some(self.values.chunks_exact(self.size).map(number).collect())
    }

    /// Returns the values as texts; `None` for other types.
    pub fn texts(&self) -> Option<Vec<String>> {
        let text = |bytes: &[u8]| {
            let (values, _) = bytes.as_chunks();
            let values =
                values.iter().map(|value| u32::from_le_bytes(*value)).take_while(|&value| value != 0);
            values.map(char::from_u32).collect::<Option<String>>()
        };
        (self.kind == 'U').then(|| self.values.chunks_exact(4 * self.size).map(text).collect())?
    }
}
