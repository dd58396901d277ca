//! Reader of NumPy archives.

use crate::foot::{Part, Side};
use crate::formats::document::ReadError;
use crate::formats::{npy, zip};
use crate::plants::Annotation;

/// Maximum size of an array per frame, in bytes: eight columns of the widest numbers.
const FRAME_BYTES: usize = 64;

/// Additional size of any array, in bytes, for header and names.
const HEADER_BYTES: usize = 1 << 16;

/// True if the bytes are an archive.
pub(super) fn is_archive(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK")
}

/// Reads the arrays `contacts` and `contact`, whose columns are named by `columns` and
/// `contact_columns`. Values are 0, 1, or −1 or NaN for unknown.
pub(super) fn read(archive: &[u8], frames: usize) -> Result<Annotation, ReadError> {
    let mut columns = columns(archive, "contacts", "columns", frames)?;
    columns.extend(self::columns(archive, "contact", "contact_columns", frames)?);
    let mut column = |side: Side, part: Part| {
        let name = format!("{}_{}", side.name(), part.name());
        columns.iter_mut().find(|(other, _)| *other == name).map(|(_, labels)| std::mem::take(labels))
    };
    let parts = Part::ALL.into_iter().filter_map(|part| {
        let [left, right] = Side::BOTH.map(|side| column(side, part));
        Some((part, [left?, right?]))
    });
    Ok(Annotation { parts: parts.collect() })
}

/// Returns the columns of a table with their names; none if the table does not exist.
#[expect(clippy::type_complexity, reason = "a name with its column")]
fn columns(
    archive: &[u8],
    table: &str,
    names: &str,
    frames: usize,
) -> Result<Vec<(String, Vec<Option<bool>>)>, ReadError> {
    let max_bytes = frames.saturating_mul(FRAME_BYTES).saturating_add(HEADER_BYTES);
    let file = |name: &str| zip::file(archive, &format!("{name}.npy"), max_bytes);
    let Some(bytes) = file(table)? else { return Ok(Vec::new()) };
    let array = npy::read(table, &bytes)?;
    let name_bytes = file(names)?.ok_or_else(|| {
        ReadError::Invalid(format!("{names} is missing, which has the column names of {table}"))
    })?;
    let names = npy::read(names, &name_bytes)?
        .texts()
        .ok_or_else(|| ReadError::Invalid(format!("{names} is not an array of texts")))?;
    let [rows, count] = match array.shape[..] {
        [rows, count] | [1, rows, count] => [rows, count],
        [_, _, _] => return Err(ReadError::SeveralSkeletons),
        _ => return Err(ReadError::Invalid(format!("{table} must have rows and columns"))),
    };
    if count != names.len() {
        return Err(ReadError::Invalid(format!("{table} has {count} columns but {} names", names.len())));
    }
    let numbers = array
        .numbers()
        .ok_or_else(|| ReadError::Invalid(format!("{table} has values that are not numbers")))?;
    let label = |(row, column): (usize, usize)| {
        let number = numbers[if array.fortran { column * rows + row } else { row * count + column }];
        match number {
            1.0 => Ok(Some(true)),
            0.0 => Ok(Some(false)),
            _ if number == -1.0 || number.is_nan() => Ok(None),
            _ => Err(ReadError::Invalid(format!("{table}, row {row}: expected 0, 1 or -1, found {number}"))),
        }
    };
    let labels = |column: usize| (0..rows).map(|row| label((row, column))).collect::<Result<Vec<_>, _>>();
    names.into_iter().enumerate().map(|(column, name)| Ok((name, labels(column)?))).collect()
}
