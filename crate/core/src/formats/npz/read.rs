//! Arrays back to labels.

use crate::foot::{Part, Side};
use crate::formats::LabelsError;
use crate::formats::npz::{npy, zip};
use crate::plants::Annotation;

/// Bytes that an array may have for each frame: eight columns of the widest numbers.
const FRAME_BYTES: usize = 64;

/// Bytes that any array may have, be the clip as short as it will: for header and names.
const SPARE_BYTES: usize = 1 << 16;

/// Whether these are the bytes of an archive.
pub(crate) fn is_archive(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK")
}

/// Reads the labels of an archive: the arrays `contacts` and `contact`, whose columns `columns`
/// and `contact_columns` name. Their values are 0, 1, or −1 or NaN where that is not known.
pub(crate) fn read(archive: &[u8], frames: usize) -> Result<Annotation, LabelsError> {
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

/// The columns of a table with their names; none where there is no such table.
#[expect(clippy::type_complexity, reason = "a name with its column")]
fn columns(
    archive: &[u8],
    table: &str,
    names: &str,
    frames: usize,
) -> Result<Vec<(String, Vec<Option<bool>>)>, LabelsError> {
    let most = frames.saturating_mul(FRAME_BYTES).saturating_add(SPARE_BYTES);
    let file = |name: &str| zip::file(archive, &format!("{name}.npy"), most);
    let Some(bytes) = file(table)? else { return Ok(Vec::new()) };
    let array = npy::read(table, &bytes)?;
    let name_bytes = file(names)?.ok_or_else(|| {
        LabelsError::Wrong(format!("{names} is missing, which names the columns of {table}"))
    })?;
    let names = npy::read(names, &name_bytes)?
        .texts()
        .ok_or_else(|| LabelsError::Wrong(format!("{names} is not made of texts")))?;
    let [rows, count] = match array.shape[..] {
        [rows, count] => [rows, count],
        [_, _, _] => return Err(LabelsError::Wrong("archives of several skeletons are not compared".into())),
        _ => return Err(LabelsError::Wrong(format!("{table} has not rows and columns"))),
    };
    if count != names.len() {
        return Err(LabelsError::Wrong(format!("{table} has {count} columns, and {} names", names.len())));
    }
    let numbers = array
        .numbers()
        .ok_or_else(|| LabelsError::Wrong(format!("{table} has values that are no numbers")))?;
    let label = |(row, column): (usize, usize)| {
        let number = numbers[if array.fortran { column * rows + row } else { row * count + column }];
        match number {
            1.0 => Ok(Some(true)),
            0.0 => Ok(Some(false)),
            _ if number == -1.0 || number.is_nan() => Ok(None),
            _ => Err(LabelsError::Wrong(format!("{table}, row {row}: expected 0, 1 or -1, found {number}"))),
        }
    };
    let labels = |column: usize| (0..rows).map(|row| label((row, column))).collect::<Result<Vec<_>, _>>();
    names.into_iter().enumerate().map(|(column, name)| Ok((name, labels(column)?))).collect()
}
