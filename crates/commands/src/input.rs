//! Files that are read; `-` in place of a name is standard input.

use crate::desk::{Call, Text};
use crate::failure::Failure;
use epicyclic_formats::Document;
use epicyclic_formats::document::{SIZE_LIMIT, too_large};
use std::io;
use std::path::Path;

/// File name on the command line that means standard input.
const STANDARD_INPUT: &str = "-";

/// Name of standard input in messages.
const ITS_NAME: &str = "standard input";

/// Whether standard input is meant.
#[must_use]
pub fn is_standard_input(file: &Path) -> bool {
    file.as_os_str() == STANDARD_INPUT
}

/// Whether there is something to read; a file called `-` is read as `./-`.
pub(crate) fn exists(call: &Call<'_>, file: &Path) -> bool {
    is_standard_input(file) || call.desk.exists(file)
}

/// The YAML document of a file.
pub(crate) fn document(call: &Call<'_>, file: &Path) -> Result<Document, Failure> {
    Ok(with_bytes(call, file)?.0)
}

/// The text of a file that is no YAML.
pub fn text(call: &Call<'_>, file: &Path) -> Result<String, Failure> {
    let (name, bytes) = named(call, file)?;
    String::from_utf8(bytes).map_err(|error| Failure::Read {
        file: name.into(),
        source: io::Error::new(io::ErrorKind::InvalidData, error.utf8_error()),
    })
}

/// Reads the YAML document of a file and the file's bytes.
pub(crate) fn with_bytes(call: &Call<'_>, file: &Path) -> Result<(Document, Vec<u8>), Failure> {
    let (name, bytes) = named(call, file)?;
    Ok((Document::parse_one(&name, &bytes)?, bytes))
}

/// Reads the bytes of a file and its name for messages.
fn named(call: &Call<'_>, file: &Path) -> Result<(String, Vec<u8>), Failure> {
    let file = (!is_standard_input(file)).then_some(file);
    let name = file.map_or_else(|| ITS_NAME.to_owned(), |file| file.display().to_string());
    match call.read(file, &name, SIZE_LIMIT)? {
        Text::Whole(bytes) => Ok((name, bytes)),
        Text::TooLarge { size } => Err(too_large(&name, size).into()),
    }
}
