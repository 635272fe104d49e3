//! Reader of a folder of cases that reports every fault.

use crate::calculations::Calculation;
use crate::cases::case::{Case, Expectation, Verdict};
use crate::cases::index::{self, Index};
use crate::cases::tolerance::{Printed, Width};
use epicyclic_formats::document::{Document, Path as YamlPath, Position};
use epicyclic_formats::{Error as FormatError, nearest};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// Name of the fault of a case that holds and has no snapshot yet.
pub const NEW: &str = "missing-snapshot";

/// Fault of a file of cases, or of its content.
#[derive(Debug, Clone, Serialize)]
pub struct Fault {
    /// Path of the file from the project's root.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column, from 1.
    pub column: usize,
    /// Name of the fault: `unknown-key`.
    pub name: String,
    /// Message about the fault, with the allowed values.
    pub message: String,
}

impl Fault {
    /// A fault at a place of a document.
    #[must_use]
    pub fn at(document: &Document, path: &YamlPath, name: &str, message: impl Into<String>) -> Self {
        Self::at_position(document.file(), document.position(path), name, message)
    }

    /// Whether the fault is a case that holds and has no snapshot yet.
    #[must_use]
    pub fn is_new(&self) -> bool {
        self.name == NEW
    }

    pub(crate) fn at_position(
        file: &str,
        position: Position,
        name: &str,
        message: impl Into<String>,
    ) -> Self {
        Self {
            file: file.to_owned(),
            line: position.line,
            column: position.column,
            name: name.to_owned(),
            message: message.into(),
        }
    }
}

impl From<FormatError> for Fault {
    fn from(error: FormatError) -> Self {
        let at = error.at();
        let path = if at.path.is_root() { String::new() } else { format!("{}: ", at.path) };
        let message = format!("{path}{}", error.problem());
        Self::at_position(&at.file, at.position, error.name(), message)
    }
}

/// Case with its document.
#[derive(Debug)]
pub struct Loaded {
    /// The case.
    pub case: Case,
    /// Document of the case.
    pub document: Document,
}

/// Source: its index, its cases, and their faults.
#[derive(Debug)]
pub struct Source {
    /// Name of the source's folder.
    pub id: String,
    /// The folder.
    pub folder: PathBuf,
    /// Index of the source; `None` if it cannot be read.
    pub index: Option<Index>,
    /// Valid cases, in the order of file names and documents.
    pub cases: Vec<Loaded>,
    /// Faults of index and cases.
    pub faults: Vec<Fault>,
}

impl Source {
    /// Path of a file of the source, from the project's root.
    #[must_use]
    pub fn file(&self, name: &str) -> String {
        let root = self.folder.parent().and_then(Path::file_name).unwrap_or_default().to_string_lossy();
        format!("{root}/{}/{name}", self.id)
    }
}

/// Reads every source below `root`: one folder each.
///
/// # Errors
/// The error of a folder that cannot be listed.
pub fn sources(root: &Path, calculations: &[Calculation]) -> io::Result<Vec<Source>> {
    let mut folders: Vec<PathBuf> =
        fs::read_dir(root)?.map(|entry| entry.map(|entry| entry.path())).collect::<io::Result<Vec<_>>>()?;
    folders.retain(|path| path.is_dir());
    folders.sort();
    folders.into_iter().map(|folder| source(folder, calculations)).collect()
}

fn source(folder: PathBuf, calculations: &[Calculation]) -> io::Result<Source> {
    let id = folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let mut files: Vec<PathBuf> = fs::read_dir(&folder)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<io::Result<Vec<_>>>()?;
    files.retain(|path| path.extension().is_some_and(|extension| extension == "yaml" || extension == "yml"));
    // Folders are listed in any order; sorted files give every report the same order.
    files.sort();

    let mut source = Source { id, folder, index: None, cases: Vec::new(), faults: Vec::new() };
    let mut index_document = None;
    for file in files {
        let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let shown = source.file(&name);
        let bytes = fs::read(&file)?;
        let documents = match Document::parse_all(&shown, &bytes) {
            Ok(documents) => documents,
            Err(error) => {
                source.faults.push(error.into());
                continue;
            }
        };
        for document in documents {
            if name == index::FILE {
                match document.read::<Index>() {
                    Ok(index) => source.index = Some(index),
                    Err(error) => source.faults.push(error.into()),
                }
                index_document = Some(document);
            } else {
                match document.read::<Case>() {
                    Ok(case) => source.cases.push(Loaded { case, document }),
                    Err(error) => source.faults.push(error.into()),
                }
            }
        }
    }
    // Cases are checked last, because citations and links need the index and all other cases.
    check_index(&mut source, index_document.as_ref());
    let faults: Vec<Fault> =
        (0..source.cases.len()).flat_map(|at| check_case(&source, at, calculations)).collect();
    source.faults.extend(faults);
    Ok(source)
}

fn check_index(source: &mut Source, document: Option<&Document>) {
    let Some(document) = document else {
        let file = source.file(index::FILE);
        let message = "the source has no index: list its equations, tables and figures as `places`";
        source.faults.push(Fault::at_position(&file, Position::START, "missing-index", message));
        return;
    };
    let Some(index) = &source.index else { return };
    let mut faults = Vec::new();
    let root = YamlPath::root;
    if index.source != source.id {
        let message = format!("source {} stands in the folder {}: use one name", index.source, source.id);
        faults.push(Fault::at(document, &root().key("source"), "wrong-source", message));
    }
    for (at, place) in index.places.iter().enumerate() {
        let path = root().key("places").index(at).key("place");
        if place.place.contains(',') || place.place.trim() != place.place || place.place.is_empty() {
            let message = format!("place {:?}: no commas, no blanks at its ends, not empty", place.place);
            faults.push(Fault::at(document, &path, "unusable-place", message));
        }
        if index.places[..at].iter().any(|other| other.place == place.place) {
            let message = format!("place {} stands twice in the index", place.place);
            faults.push(Fault::at(document, &path, "duplicate-place", message));
        }
    }
    source.faults.extend(faults);
}

fn check_case(source: &Source, at: usize, calculations: &[Calculation]) -> Vec<Fault> {
    let Loaded { case, document } = &source.cases[at];
    let root = YamlPath::root;
    let mut faults = Vec::new();
    let mut fault = |path: YamlPath, name: &str, message: String| {
        faults.push(Fault::at(document, &path, name, message));
    };

    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if case.case.is_empty() || !case.case.chars().all(plain) {
        let message =
            format!("case name {:?}: small letters, digits and hyphens, as in scheme-ii-3", case.case);
        fault(root().key("case"), "unusable-name", message);
    }
    if let Some(first) = source.cases[..at].iter().find(|other| other.case.case == case.case) {
        let path = root().key("case");
        let (file, position) = (first.document.file(), first.document.position(&path));
        let message = format!("case {} stands twice, first at {file}:{position}: rename one", case.case);
        fault(path, "duplicate-case", message);
    }
    if calculations.iter().all(|known| known.name != case.calculation) {
        let known: Vec<String> = calculations.iter().map(|known| known.name.to_owned()).collect();
        let like =
            nearest(&case.calculation, &known).map(|name| format!("; write {name}?")).unwrap_or_default();
        let message =
            format!("unknown calculation {}{like} (cargo xtask new-case lists them)", case.calculation);
        fault(root().key("calculation"), "unknown-calculation", message);
    }
    let cites = std::iter::once((root().key("cite"), case.cite.as_str())).chain(
        case.expect.iter().filter_map(|(name, expectation)| {
            Some((root().key("expect").key(name).key("cite"), expectation.cite.as_deref()?))
        }),
    );
    for (path, cite) in cites {
        for place in index::places(cite) {
            let known = |index: &Index| index.places.iter().any(|known| known.place == place);
            if place.is_empty() {
                let message = "an empty citation: name the place in the source".to_owned();
                fault(path.clone(), "missing-citation", message);
            } else if source.index.as_ref().is_some_and(|index| !known(index)) {
                let message = format!("place {place} does not stand in the source's index: add it there");
                fault(path.clone(), "unknown-place", message);
            }
        }
    }
    match (&case.expect_error, case.expect.is_empty()) {
        (None, true) => {
            let message = "the case expects nothing: write `expect` or `expect_error`".to_owned();
            fault(root(), "nothing-expected", message);
        }
        (Some(_), false) => {
            let message =
                "a case that must be refused has no results: write `expect` or `expect_error`".to_owned();
            fault(root().key("expect_error"), "both-expected", message);
        }
        _ => {}
    }
    for (quantity, expectation) in &case.expect {
        let path = root().key("expect").key(quantity);
        let needs = |verdict: &str, key: &str, why: &str| format!("{verdict} needs `{key}`: {why}");
        let has_because = expectation.because.is_some();
        let printed = expectation.published.is_some();
        let message = match expectation.verdict {
            Verdict::Unrecoverable if printed => {
                Some("an unrecoverable figure has no `published`: say what is `legible`".to_owned())
            }
            Verdict::Unrecoverable if expectation.legible.is_none() => {
                Some(needs("an unrecoverable figure", "legible", "what is left of it"))
            }
            Verdict::Unrecoverable => None,
            _ if !printed => Some(needs("a figure", "published", "the figure as printed")),
            Verdict::Contradicted if expectation.computed.is_none() => {
                Some(needs("a contradiction", "computed", "the right value"))
            }
            Verdict::Contradicted if !has_because => {
                Some(needs("a contradiction", "because", "the calculation behind `computed`"))
            }
            Verdict::Definition if !has_because => Some(needs("a definition", "because", "what it repeats")),
            Verdict::Agrees | Verdict::Reconstructed | Verdict::Definition | Verdict::Given
                if expectation.computed.is_some() || expectation.arithmetic.is_some() =>
            {
                Some("`computed` and `arithmetic` belong to a contradicted figure".to_owned())
            }
            _ if expectation.tolerance.is_some() && !has_because => {
                Some(needs("a tolerance wider than the digits'", "because", "its reason"))
            }
            _ => None,
        };
        if let Some(message) = message {
            fault(path.clone(), "incomplete-figure", message);
        }
        let cite = expectation.cite.as_deref().unwrap_or(&case.cite);
        let restored = |place: &str| source.index.as_ref().is_some_and(|index| index.restores(place));
        // `agrees` is also the default, so only the text shows whether the author has decided.
        let is_stated = document.text_at(&path.clone().key("verdict")).is_some();
        let message = match (expectation.verdict, index::places(cite).any(restored), case.restored.is_some())
        {
            (Verdict::Agrees, true, _) => {
                Some("a restored reading is no print: write `verdict: reconstructed`")
            }
            (Verdict::Reconstructed, false, false) => Some(
                "it cites a print: say in `restored` how the formula was inferred, or cite the reading, or remove `verdict`",
            ),
            (_, _, true) if !is_stated => Some(
                "the case has `restored`: write `verdict: reconstructed` where the restored formula is used, else `verdict: agrees`",
            ),
            _ => None,
        };
        if let Some(message) = message {
            fault(path.clone(), "restored-figure", format!("{}/{quantity}: {message}", case.case));
        }
        if let Some((name, message)) =
            tolerance_fault(expectation).or_else(|| print_fault(source, expectation))
        {
            fault(path, name, format!("{}/{quantity}: {message}", case.case));
        }
    }
    faults
}

/// The fault of a stated tolerance. A tolerance that cannot be read is refused when the figure is judged.
fn tolerance_fault(expectation: &Expectation) -> Option<(&'static str, &'static str)> {
    let width = || {
        let tolerance = expectation.tolerance.as_deref()?;
        Printed::parse(expectation.published.as_deref()?, expectation.rounding).ok()?.width(tolerance).ok()
    };
    match (width(), expectation.cause) {
        (Some(Width::Idle), _) => {
            Some(("idle-tolerance", "the tolerance is no wider than the digits: remove it"))
        }
        (Some(Width::Loose), None) => Some((
            "loose-tolerance",
            "the tolerance is beyond ten half-units of the last digit, or beyond 2 %: make it narrower, or name the `cause` \
             beside `because`: constant, rounding or rough",
        )),
        (Some(Width::Wide) | None, Some(_)) => {
            Some(("idle-cause", "`cause` belongs to a loose tolerance: remove it"))
        }
        _ => None,
    }
}

/// The fault of `print_of`, which names another figure of the same print.
fn print_fault(source: &Source, expectation: &Expectation) -> Option<(&'static str, &'static str)> {
    let (case, quantity) = expectation.print_of.as_deref()?.split_once('/').unwrap_or_default();
    let first = source.cases.iter().find(|other| other.case.case == case);
    let problem = match first.and_then(|first| first.case.expect.get(quantity)) {
        None => "`print_of` names no figure of this source: write case/quantity",
        Some(first) if first.print_of.is_some() => {
            "`print_of` names a figure that has `print_of`: name the first one"
        }
        Some(first) if first.published != expectation.published => {
            "`print_of` names a figure with another `published`: one print has one text"
        }
        Some(_) => return None,
    };
    Some(("unusable-print", problem))
}
