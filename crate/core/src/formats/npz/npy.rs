//! Arrays in NumPy's format, version 1.0 (and 2.0 and 3.0, whose headers may be longer):
//! a magic word, a header that is a Python literal, and the values.

use crate::formats::LabelsError;

const MAGIC: &[u8] = b"\x93NUMPY";

/// Headers end at multiples of this.
const ALIGNMENT: usize = 64;

/// An array with its shape.
#[derive(Debug)]
pub(crate) struct Array<'a> {
    /// Kind and size of a value, as in `b1` or `U10`.
    pub kind: char,
    /// Bytes of a value; characters of a text.
    pub size: usize,
    pub shape: Vec<usize>,
    /// Whether the first index is the one that runs fastest.
    pub fortran: bool,
    values: &'a [u8],
}

/// A file of values of a type, the last index running fastest.
pub(crate) fn write(kind: &str, shape: &[usize], values: &[u8]) -> Vec<u8> {
    // A shape of one number needs its comma.
    let shape: String = shape.iter().map(|size| format!("{size},")).collect();
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}");
    let before = MAGIC.len() + 4;
    while !(before + header.len() + 1).is_multiple_of(ALIGNMENT) {
        header.push(' ');
    }
    header.push('\n');
    [MAGIC, &[1, 0], &(header.len() as u16).to_le_bytes(), header.as_bytes(), values].concat()
}

/// A file of texts.
pub(crate) fn texts(shape: &[usize], texts: &[&str]) -> Vec<u8> {
    // NumPy has no text of no characters.
    let longest = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
    let padded = |text: &str| {
        let values = text.chars().map(u32::from).chain(std::iter::repeat(0)).take(longest);
        values.flat_map(u32::to_le_bytes).collect::<Vec<u8>>()
    };
    let values: Vec<u8> = texts.iter().flat_map(|text| padded(text)).collect();
    write(&format!("<U{longest}"), shape, &values)
}

/// Reads a file; nothing is taken from it but what is there.
pub(crate) fn read<'a>(name: &str, bytes: &'a [u8]) -> Result<Array<'a>, LabelsError> {
    let wrong = |what: &str| LabelsError::Wrong(format!("{name} is not an array that can be read: {what}"));
    let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| wrong("it does not begin as one"))?;
    let (length, rest) = match rest {
        [1, 0, a, b, rest @ ..] => (usize::from(u16::from_le_bytes([*a, *b])), rest),
        [2 | 3, 0, a, b, c, d, rest @ ..] => (u32::from_le_bytes([*a, *b, *c, *d]) as usize, rest),
        _ => return Err(wrong("its version is not known")),
    };
    let (header, values) = rest.split_at_checked(length).ok_or_else(|| wrong("it breaks off"))?;
    let header = str::from_utf8(header).map_err(|_| wrong("its header is no text"))?;
    let kind = entry(header, "descr").and_then(|rest| rest.strip_prefix('\'')?.split('\'').next());
    let kind = kind.ok_or_else(|| wrong("its values are of several types"))?;
    let (kind, size) = match kind.strip_prefix(['<', '|']).and_then(|kind| {
        let (letter, size) = kind.split_at_checked(1)?;
        Some((letter.chars().next()?, size.parse::<usize>().ok()?))
    }) {
        Some(kind) => kind,
        None => return Err(wrong(&format!("values of type {kind} are not known"))),
    };
    let shape = entry(header, "shape").and_then(|rest| rest.strip_prefix('(')?.split(')').next());
    let sizes = shape.ok_or_else(|| wrong("it has no shape"))?.split(',').map(str::trim);
    let shape: Result<Vec<usize>, _> =
        sizes.filter(|size| !size.is_empty()).map(|size| size.parse::<usize>()).collect();
    let shape = shape.map_err(|_| wrong("it has no shape"))?;
    let bytes = if kind == 'U' { size.checked_mul(4) } else { Some(size) };
    let whole = shape.iter().try_fold(bytes.unwrap_or(0), |product, &size| product.checked_mul(size));
    if bytes.is_none_or(|bytes| bytes == 0) || whole != Some(values.len()) {
        return Err(wrong("its values are not as many as its shape says"));
    }
    let fortran = entry(header, "fortran_order").is_some_and(|rest| rest.starts_with("True"));
    Ok(Array { kind, size, shape, fortran, values })
}

/// What follows a key of the header.
fn entry<'a>(header: &'a str, key: &str) -> Option<&'a str> {
    let (_, rest) = header.split_once(&format!("'{key}'"))?;
    Some(rest.trim_start().strip_prefix(':')?.trim_start())
}

impl Array<'_> {
    /// The values as numbers, in the order of the file; `None` where they are none.
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

    /// The values as texts; `None` where they are none.
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
