//! Files that are read; `-` in place of a name is standard input.

use crate::failure::Failure;
use epicyclic_formats::Document;
use epicyclic_formats::document::{SIZE_LIMIT, too_large};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// What is written in place of a file for standard input.
const STANDARD_INPUT: &str = "-";

/// Its name in messages.
const ITS_NAME: &str = "standard input";

/// Whether standard input is meant.
pub(crate) fn is_standard_input(file: &Path) -> bool {
    file.as_os_str() == STANDARD_INPUT
}

/// Whether there is something to read; a file called `-` is read as `./-`.
pub(crate) fn exists(file: &Path) -> bool {
    is_standard_input(file) || file.exists()
}

/// The YAML document of a file.
pub(crate) fn document(file: &Path) -> Result<Document, Failure> {
    Ok(with_bytes(file)?.0)
}

/// The text of a file that is no YAML.
pub(crate) fn text(file: &Path) -> Result<String, Failure> {
    let (name, bytes) = named(file)?;
    String::from_utf8(bytes).map_err(|error| Failure::Read {
        file: name.into(),
        source: io::Error::new(io::ErrorKind::InvalidData, error.utf8_error()),
    })
}

/// The same, and the file as it stands.
pub(crate) fn with_bytes(file: &Path) -> Result<(Document, Vec<u8>), Failure> {
    let (name, bytes) = named(file)?;
    Ok((Document::parse_one(&name, &bytes)?, bytes))
}

/// What stands in a file, and its name in messages.
fn named(file: &Path) -> Result<(String, Vec<u8>), Failure> {
    let (name, bytes) = if is_standard_input(file) {
        // The tests of whole command lines within the program give it none.
        (ITS_NAME.to_owned(), if cfg!(test) { limited(io::empty()) } else { limited(io::stdin().lock()) })
    } else {
        (file.display().to_string(), bytes(file))
    };
    let bytes = match bytes {
        Ok(Content::Whole(bytes)) => bytes,
        Ok(Content::TooLarge { size }) => return Err(too_large(&name, size).into()),
        Err(source) => return Err(Failure::Read { file: name.into(), source }),
    };
    Ok((name, bytes))
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
    // A file may also have grown since.
    limited(file)
}

fn limited(from: impl Read) -> io::Result<Content> {
    let mut bytes = Vec::new();
    from.take(SIZE_LIMIT + 1).read_to_end(&mut bytes)?;
    Ok(if bytes.len() as u64 > SIZE_LIMIT { Content::TooLarge { size: None } } else { Content::Whole(bytes) })
}
