//! Scenarios as they are read: the file and the files that it names.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::simulate::answer::Beside;
use epicyclic_formats::scenario::{self, ScenarioFile};
use epicyclic_formats::{Document, Path as Place, Problem};
use std::path::Path;

/// Scenario with the files that it names.
#[derive(Debug)]
pub struct Scenario {
    /// The file.
    pub document: Document,
    /// Content of the file.
    pub file: ScenarioFile,
    /// Gearbox and tables that the scenario names.
    pub beside: Beside,
}

impl Scenario {
    /// Reads a scenario that names no other files.
    ///
    /// # Errors
    /// Faults of the text with their places.
    pub fn parse(file_name: &str, yaml: &[u8]) -> Result<Self, Error> {
        let document = Document::parse_one(file_name, yaml)?;
        let file = scenario::read(&document)?;
        Ok(Self { document, file, beside: Beside::default() })
    }

    /// Reads the scenario of a file and the files that it names.
    pub(crate) fn of(call: &Call<'_>, path: &Path) -> Result<Self, Failure> {
        Self::beside(call, input::document(call, path)?, path)
    }

    /// Reads the scenario of a document and the files that it names.
    pub(crate) fn beside(call: &Call<'_>, document: Document, path: &Path) -> Result<Self, Failure> {
        let file = scenario::read(&document)?;
        let mut beside = Beside::default();
        // A file of this name, where the name alone would be standard input.
        let file_of = |name: &str| if name == "-" { "./-".to_owned() } else { name.to_owned() };
        let near = |name: &str| path.parent().unwrap_or(Path::new("")).join(file_of(name));
        let refused = |place: &Place, failure: Failure| match failure {
            failure @ Failure::Read { .. } => {
                Failure::from(document.error(place, Problem::refused(failure.name(), failure.to_string())))
            }
            failure => failure,
        };
        if let Some(name) = &file.gearbox_file {
            let place = Place::root().key("gearbox_file");
            beside.gearbox =
                Some(input::document(call, &near(name)).map_err(|failure| refused(&place, failure))?);
        }
        for (name, place) in file.csv_files() {
            let other = near(name);
            let text = input::text(call, &other).map_err(|failure| refused(&place, failure))?;
            beside.texts.insert(name.to_owned(), (other.display().to_string(), text));
        }
        Ok(Self { document, file, beside })
    }
}
