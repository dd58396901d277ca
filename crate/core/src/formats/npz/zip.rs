//! As much of ZIP as archives of arrays need: files one after the other, and a directory at the end.
//!
//! After PKWARE's APPNOTE 6.3.10: local file header (4.3.7), central directory header (4.3.12)
//! and its end (4.3.16).

use crate::formats::LabelsError;

const LOCAL: [u8; 4] = *b"PK\x03\x04";
const CENTRAL: [u8; 4] = *b"PK\x01\x02";
const END: [u8; 4] = *b"PK\x05\x06";

/// Bytes of the fixed part of each header.
const LOCAL_BYTES: usize = 30;
const CENTRAL_BYTES: usize = 46;
const END_BYTES: usize = 22;

/// A comment after the end is no longer than this.
const COMMENT_BYTES: usize = u16::MAX as usize;

/// The first day that ZIP can tell, so that the same labels are the same bytes.
const DATE: u16 = (1 << 5) | 1;

/// An archive of files as they are, by name.
///
/// # Panics
/// If it would be larger than the 4 GiB that sizes can tell.
pub(crate) fn store(files: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let size = |bytes: usize| u32::try_from(bytes).expect("an archive of less than 4 GiB");
    let mut archive = Vec::new();
    let mut directory = Vec::new();
    for (name, bytes) in files {
        // Version 2.0, no flags, stored, midnight.
        let mut head = Vec::new();
        for field in [20, 0, 0, 0, DATE] {
            head.extend(field.to_le_bytes());
        }
        for field in [crc32fast::hash(bytes), size(bytes.len()), size(bytes.len())] {
            head.extend(field.to_le_bytes());
        }
        head.extend((name.len() as u16).to_le_bytes());
        head.extend([0; 2]);
        directory.extend(CENTRAL);
        directory.extend(20_u16.to_le_bytes());
        directory.extend(&head);
        // No comment, first disk, no attributes.
        directory.extend([0; 10]);
        directory.extend(size(archive.len()).to_le_bytes());
        directory.extend(name.as_bytes());
        archive.extend(LOCAL);
        archive.extend(&head);
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

/// The file of a name, of at most `most` bytes; `None` where there is none.
///
/// # Errors
/// If the archive is damaged, the file is larger, or packed in another way than deflate.
pub(crate) fn file(archive: &[u8], name: &str, most: usize) -> Result<Option<Vec<u8>>, LabelsError> {
    let broken = || LabelsError::Wrong("the archive breaks off or is damaged".into());
    let Some(entry) = entry(archive, name).ok_or_else(broken)? else { return Ok(None) };
    if entry.flags & 1 != 0 {
        return Err(LabelsError::Wrong(format!("{name} is encrypted")));
    }
    // Sizes are those of the directory: who writes as a stream does not know them before.
    if entry.bytes > most {
        return Err(LabelsError::Wrong(format!(
            "{name} has {} bytes, more than the clip's labels",
            entry.bytes
        )));
    }
    let packed = packed(archive, &entry).ok_or_else(broken)?;
    let bytes = match entry.method {
        0 => packed.to_vec(),
        // Memory grows with what is there, not with what the directory claims.
        8 => miniz_oxide::inflate::decompress_to_vec_with_limit(packed, most).map_err(|_| broken())?,
        _ => {
            let what = format!("{name} is packed in a way that is not known: save it uncompressed");
            return Err(LabelsError::Wrong(what));
        }
    };
    let is_whole = bytes.len() == entry.bytes && crc32fast::hash(&bytes) == entry.crc;
    if is_whole { Ok(Some(bytes)) } else { Err(broken()) }
}

/// What the directory says of a file.
struct Entry {
    flags: u16,
    method: u16,
    crc: u32,
    packed: usize,
    bytes: usize,
    at: usize,
}

/// Finds a file in the directory; the outer `None` means that the directory is damaged.
fn entry(archive: &[u8], name: &str) -> Option<Option<Entry>> {
    let earliest = archive.len().saturating_sub(END_BYTES + COMMENT_BYTES);
    let latest = archive.len().checked_sub(END_BYTES)?;
    let end = (earliest..=latest).rev().find(|&at| archive[at..].starts_with(&END))?;
    let count = short(archive, end + 10)?;
    let mut at = long(archive, end + 16)?;
    for _ in 0..count {
        if !archive.get(at..)?.starts_with(&CENTRAL) {
            return None;
        }
        let lengths = [28, 30, 32].map(|offset| short(archive, at + offset).map(usize::from));
        let [Some(named), Some(extra), Some(comment)] = lengths else { return None };
        if archive.get(at + CENTRAL_BYTES..)?.get(..named)? == name.as_bytes() {
            return Some(Some(Entry {
                flags: short(archive, at + 8)?,
                method: short(archive, at + 10)?,
                crc: long(archive, at + 16)? as u32,
                packed: long(archive, at + 20)?,
                bytes: long(archive, at + 24)?,
                at: long(archive, at + 42)?,
            }));
        }
        at += CENTRAL_BYTES + named + extra + comment;
    }
    Some(None)
}

/// The bytes of a file as they are packed.
fn packed<'a>(archive: &'a [u8], entry: &Entry) -> Option<&'a [u8]> {
    let head = archive.get(entry.at..).filter(|head| head.starts_with(&LOCAL))?;
    let [named, extra] = [26, 28].map(|offset| short(head, offset).map(usize::from));
    head.get(LOCAL_BYTES + named? + extra?..)?.get(..entry.packed)
}

fn short(bytes: &[u8], at: usize) -> Option<u16> {
    bytes.get(at..)?.first_chunk().map(|field| u16::from_le_bytes(*field))
}

fn long(bytes: &[u8], at: usize) -> Option<usize> {
    bytes.get(at..)?.first_chunk().map(|field| u32::from_le_bytes(*field) as usize)
}
