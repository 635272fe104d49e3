//! Checksum of a file within the file: the CRC-32 of all its bytes, with zeros in place of the checksum's
//! digits.
//!
//! The checksum is in the metadata, as `crc32:` and eight hexadecimal digits. It is compared before anything
//! is read from the file. A damaged file is therefore never read, wherever the damage is.

use crate::error::Error;

/// Value of [`KEY`] while the checksum is not known.
pub(crate) const OPEN: &str = "crc32:00000000";

/// The key of the checksum.
pub(crate) const KEY: &str = "epicyclic.checksum";

const MARK: &[u8] = b"crc32:";
const DIGITS: usize = 8;

/// Position of the digits: behind the last mark, since the metadata is at the end.
fn digits(bytes: &[u8]) -> Option<std::ops::Range<usize>> {
    let mark = bytes.windows(MARK.len()).rposition(|some| some == MARK)?;
    let from = mark + MARK.len();
    (from + DIGITS <= bytes.len()).then_some(from..from + DIGITS)
}

/// The checksum of bytes with zeros in the place of the digits.
fn checksum(bytes: &[u8], digits: &std::ops::Range<usize>) -> String {
    let mut hash = crc32fast::Hasher::new();
    hash.update(&bytes[..digits.start]);
    hash.update(&[b'0'; DIGITS]);
    hash.update(&bytes[digits.end..]);
    format!("{:08x}", hash.finalize())
}

/// Writes the checksum into its place.
///
/// # Errors
/// [`Error::NoPart`] if the file has no place for it: a fault of this library.
pub(crate) fn seal(bytes: &mut [u8]) -> Result<(), Error> {
    let digits = digits(bytes).ok_or_else(|| Error::NoPart("no place for the checksum".into()))?;
    let checksum = checksum(bytes, &digits);
    bytes[digits].copy_from_slice(checksum.as_bytes());
    Ok(())
}

/// Refuses bytes that are not as they were sealed.
///
/// # Errors
/// [`Error::Damaged`], [`Error::Unsealed`].
pub(crate) fn check(bytes: &[u8]) -> Result<(), Error> {
    let digits = digits(bytes).ok_or(Error::Unsealed)?;
    if checksum(bytes, &digits).as_bytes() == &bytes[digits] { Ok(()) } else { Err(Error::Damaged) }
}
