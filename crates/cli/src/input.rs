//! Files that are read.

use crate::failure::Failure;
use epicyclic_formats::Document;
use epicyclic_formats::document::{SIZE_LIMIT, too_large};
use std::fs::File;
use std::io::{self, Read as _};
use std::path::Path;

/// The YAML document of a file.
pub(crate) fn document(file: &Path) -> Result<Document, Failure> {
    Ok(with_bytes(file)?.0)
}

/// The same, and the file as it stands.
pub(crate) fn with_bytes(file: &Path) -> Result<(Document, Vec<u8>), Failure> {
    let name = file.display().to_string();
    let bytes = match bytes(file) {
        Ok(Content::Whole(bytes)) => bytes,
        Ok(Content::TooLarge { size }) => return Err(too_large(&name, size).into()),
        Err(source) => return Err(Failure::Read { file: file.to_owned(), source }),
    };
    Ok((Document::parse_one(&name, &bytes)?, bytes))
}

/// What is read of a file.
enum Content {
    Whole(Vec<u8>),
    /// More than [`SIZE_LIMIT`] bytes; a device or pipe does not say how many.
    TooLarge {
        size: Option<u64>,
    },
}

/// Reads no more than the limit: a device may have no end.
fn bytes(file: &Path) -> io::Result<Content> {
    let file = File::open(file)?;
    let metadata = file.metadata()?;
    let size = metadata.is_file().then_some(metadata.len());
    if size.is_some_and(|size| size > SIZE_LIMIT) {
        return Ok(Content::TooLarge { size });
    }
    let mut bytes = Vec::new();
    file.take(SIZE_LIMIT + 1).read_to_end(&mut bytes)?;
    // A file may also have grown since.
    Ok(if bytes.len() as u64 > SIZE_LIMIT { Content::TooLarge { size: None } } else { Content::Whole(bytes) })
}
