//! The checksum of ZIP.

/// Reversed generator polynomial.
const POLYNOMIAL: u32 = 0xedb8_8320;

/// Returns the CRC-32 of some bytes.
///
/// The tables of faster implementations would take 16 kB of the WebAssembly module, which do not compress.
pub(crate) fn crc32(bytes: &[u8]) -> u32 {
    let table: [u32; 256] = std::array::from_fn(|byte| {
        (0..8).fold(byte as u32, |value, _| (value >> 1) ^ if value & 1 == 1 { POLYNOMIAL } else { 0 })
    });
    let update = |crc: u32, byte: &u8| (crc >> 8) ^ table[usize::from(crc as u8 ^ byte)];
    !bytes.iter().fold(!0, update)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_is_that_of_the_standard() {
        assert_eq!(crc32(b""), 0);
        assert_eq!(crc32(b"123456789"), 0xcbf4_3926);
        assert_eq!(crc32(&[0; 32]), 0x190a_55ad);
    }
}
