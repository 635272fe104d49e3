//! Files that are read.

use crate::failure::Failure;
use epicyclic_formats::Document;
use std::fs;
use std::path::Path;

/// The YAML document of a file.
pub(crate) fn document(file: &Path) -> Result<Document, Failure> {
    Ok(with_bytes(file)?.0)
}

/// The same, and the file as it stands.
pub(crate) fn with_bytes(file: &Path) -> Result<(Document, Vec<u8>), Failure> {
    let bytes = fs::read(file).map_err(|source| Failure::Read { file: file.to_owned(), source })?;
    Ok((Document::parse_one(&file.display().to_string(), &bytes)?, bytes))
}
