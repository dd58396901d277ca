//! The subset of ZIP that NumPy archives use: consecutive files and a directory at the end.
//!
//! After PKWARE's APPNOTE 6.3.10: local file header (4.3.7), central directory header (4.3.12)
//! and its end (4.3.16).

use crate::formats::crc32::crc32;
use crate::formats::document::ReadError;

const LOCAL: [u8; 4] = *b"PK\x03\x04";
const CENTRAL: [u8; 4] = *b"PK\x01\x02";
const END: [u8; 4] = *b"PK\x05\x06";

/// Size of the fixed part of each header, in bytes.
const LOCAL_BYTES: usize = 30;
const CENTRAL_BYTES: usize = 46;
const END_BYTES: usize = 22;

/// Maximum length of the comment at the end, in bytes.
const COMMENT_BYTES: usize = u16::MAX as usize;

/// First day that ZIP can represent; a fixed date makes the output reproducible.
const DATE: u16 = (1 << 5) | 1;

/// Returns an archive of uncompressed files.
///
/// # Panics
/// If the archive would exceed 4 GiB, the limit of its size fields.
pub(crate) fn store(files: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let size = |bytes: usize| u32::try_from(bytes).expect("the archive must be smaller than 4 GiB");
    let mut archive = Vec::new();
    let mut directory = Vec::new();
    for (name, bytes) in files {
        // Version 2.0, no flags, stored, midnight.
        let mut header = Vec::new();
        for field in [20, 0, 0, 0, DATE] {
            header.extend(field.to_le_bytes());
        }
        for field in [crc32(bytes), size(bytes.len()), size(bytes.len())] {
            header.extend(field.to_le_bytes());
        }
        header.extend((name.len() as u16).to_le_bytes());
        header.extend([0; 2]);
        directory.extend(CENTRAL);
        directory.extend(20_u16.to_le_bytes());
        directory.extend(&header);
        // No comment, first disk, no attributes.
        directory.extend([0; 10]);
        directory.extend(size(archive.len()).to_le_bytes());
        directory.extend(name.as_bytes());
        archive.extend(LOCAL);
        archive.extend(&header);
        archive.extend(name.as_bytes());
        archive.extend(bytes);
    }
    let at = size(archive.len());
    archive.extend(&directory);
    archive.extend(END);
    archive.extend([0; 4]);
    let count = files.len() as u16;
    archive.extend([count, count].map(u16::to_le_bytes).concat());
    archive.extend([size(directory.len()), at].map(u32::to_le_bytes).concat());
    archive.extend([0; 2]);
    archive
}

/// Returns the file with a name, of at most `max_bytes` bytes; `None` if there is none.
///
/// # Errors
/// If the archive is damaged, or the file is larger or compressed by a method other than deflate.
pub(crate) fn file(archive: &[u8], name: &str, max_bytes: usize) -> Result<Option<Vec<u8>>, ReadError> {
    let damaged = || ReadError::Invalid("the archive is incomplete or damaged".into());
    let Some(entry) = entry(archive, name).ok_or_else(damaged)? else { return Ok(None) };
    if entry.flags & 1 != 0 {
        return Err(ReadError::Invalid(format!("{name} is encrypted")));
    }
    // Streamed archives have sizes in the directory only.
    if entry.size > max_bytes {
        return Err(ReadError::Invalid(format!(
            "{name} has {} bytes, more than the labels of the clip can have",
            entry.size
        )));
    }
    let compressed = compressed_bytes(archive, &entry).ok_or_else(damaged)?;
    let bytes = match entry.method {
        0 => compressed.to_vec(),
        // The memory grows with the actual data, not with the size stated in the directory.
        8 => miniz_oxide::inflate::decompress_to_vec_with_limit(compressed, max_bytes)
            .map_err(|_| damaged())?,
        _ => {
            let what = format!("{name} uses an unsupported compression method; save it uncompressed");
            return Err(ReadError::Invalid(what));
        }
    };
    let is_complete = bytes.len() == entry.size && crc32(&bytes) == entry.crc;
    if is_complete { Ok(Some(bytes)) } else { Err(damaged()) }
}

/// Directory entry of a file.
struct Entry {
    flags: u16,
    method: u16,
    crc: u32,
    compressed_size: usize,
    size: usize,
    /// Position of the local header.
    offset: usize,
}

/// Finds a file in the directory. The outer `None` means that the directory is damaged.
fn entry(archive: &[u8], name: &str) -> Option<Option<Entry>> {
    let earliest = archive.len().saturating_sub(END_BYTES + COMMENT_BYTES);
    let latest = archive.len().checked_sub(END_BYTES)?;
    let end = (earliest..=latest).rev().find(|&at| archive[at..].starts_with(&END))?;
    let count = read_u16(archive, end + 10)?;
    let mut at = read_u32(archive, end + 16)?;
    for _ in 0..count {
        if !archive.get(at..)?.starts_with(&CENTRAL) {
            return None;
        }
        let lengths = [28, 30, 32].map(|offset| read_u16(archive, at + offset).map(usize::from));
        let [Some(named), Some(extra), Some(comment)] = lengths else { return None };
        if archive.get(at + CENTRAL_BYTES..)?.get(..named)? == name.as_bytes() {
            return Some(Some(Entry {
                flags: read_u16(archive, at + 8)?,
                method: read_u16(archive, at + 10)?,
                crc: read_u32(archive, at + 16)? as u32,
                compressed_size: read_u32(archive, at + 20)?,
                size: read_u32(archive, at + 24)?,
                offset: read_u32(archive, at + 42)?,
            }));
        }
        at += CENTRAL_BYTES + named + extra + comment;
    }
    Some(None)
}

/// Returns the compressed bytes of a file.
fn compressed_bytes<'a>(archive: &'a [u8], entry: &Entry) -> Option<&'a [u8]> {
    let header = archive.get(entry.offset..).filter(|header| header.starts_with(&LOCAL))?;
    let [named, extra] = [26, 28].map(|offset| read_u16(header, offset).map(usize::from));
    header.get(LOCAL_BYTES + named? + extra?..)?.get(..entry.compressed_size)
}

fn read_u16(bytes: &[u8], at: usize) -> Option<u16> {
    bytes.get(at..)?.first_chunk().map(|field| u16::from_le_bytes(*field))
}

fn read_u32(bytes: &[u8], at: usize) -> Option<usize> {
    bytes.get(at..)?.first_chunk().map(|field| u32::from_le_bytes(*field) as usize)
}
