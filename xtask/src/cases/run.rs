//! Execution of a source's cases, linked ones first.

use crate::calculations::{Calculation, Failure, Refusal, Results, Value};
use crate::cases::case::{From, Taken, Verdict};
use crate::cases::figure::{Figure, Judgement, Kind, Status, judge, si_unit};
use crate::cases::index::places;
use crate::cases::load::{Fault, Loaded, NEW, Source};
use crate::cases::snapshot;
use epicyclic_formats::Path as YamlPath;
use epicyclic_formats::yaml::Value as Yaml;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// Result of `verify` for a source.
#[derive(Debug, Serialize)]
pub struct Outcome {
    /// Name of the source.
    pub source: String,
    /// Title of the source.
    pub title: String,
    /// Number of cases that were run.
    pub cases: usize,
    /// Figures of all cases.
    pub figures: Vec<Figure>,
    /// Places of the source with the number of figures that cite them; empty if only some cases were run.
    pub coverage: Vec<Coverage>,
    /// Faults besides those of figures.
    pub faults: Vec<Fault>,
}

/// Place of the index with its coverage.
#[derive(Debug, Serialize)]
pub struct Coverage {
    /// Name of the place.
    pub place: String,
    /// Content of the place.
    pub what: String,
    /// Number of figures that cite the place.
    pub figures: usize,
    /// Reason why no figure cites the place.
    pub excused: Option<String>,
}

impl Outcome {
    /// Whether all figures hold and there are no faults.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.faults.is_empty() && self.figures.iter().all(|figure| figure.status != Status::Failed)
    }

    /// Number of figures with a status.
    #[must_use]
    pub fn count(&self, status: Status) -> usize {
        self.figures.iter().filter(|figure| figure.status == status).count()
    }

    /// Number of results that were compared: all figures except inputs that must be refused.
    #[must_use]
    pub fn comparisons(&self) -> usize {
        self.figures.iter().filter(|figure| figure.is_comparison()).count()
    }

    /// Number of printed figures in these comparisons; several comparisons may use one print.
    #[must_use]
    pub fn prints(&self) -> usize {
        self.figures.iter().filter_map(|figure| figure.print.as_ref()).collect::<BTreeSet<_>>().len()
    }
}

/// Treatment of the snapshots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Snapshots {
    /// Compares, and writes nothing.
    Compare,
    /// Writes changed snapshots, and removes those without a case.
    Accept,
}

/// Runs the cases of a source whose name contains `filter`, or all if the source's does.
#[must_use]
pub fn run(source: &Source, calculations: &[Calculation], filter: &str, snapshots: Snapshots) -> Outcome {
    let mut run = Run { source, calculations, done: BTreeMap::new(), stack: Vec::new() };
    let whole = source.id.contains(filter);
    let mut outcome = Outcome {
        source: source.id.clone(),
        title: source.index.as_ref().map(|index| index.title.clone()).unwrap_or_default(),
        cases: 0,
        figures: Vec::new(),
        coverage: Vec::new(),
        faults: source.faults.clone(),
    };
    for loaded in &source.cases {
        if !whole && !loaded.case.case.contains(filter) {
            continue;
        }
        outcome.cases += 1;
        let result = run.result(loaded);
        let (figures, results) = match &result {
            Computed::Results(results) => (figures(source, loaded, results), snapshot::of_results(results)),
            Computed::Refused(refusal) => (vec![refused(loaded, refusal)], snapshot::of_refusal(refusal)),
            Computed::Fault(fault) => {
                outcome.faults.push(fault.clone());
                continue;
            }
        };
        let text = results + &snapshot::of_expectations(&loaded.case);
        let holds = figures.iter().all(|figure| figure.status != Status::Failed);
        outcome.figures.extend(figures);
        outcome.faults.extend(compare_snapshot(source, loaded, &text, holds, snapshots));
    }
    if whole {
        outcome.faults.extend(orphans(source, snapshots));
        coverage(source, &mut outcome);
    }
    outcome
}

/// Result of a case.
#[derive(Debug, Clone)]
enum Computed {
    Results(Results),
    Refused(Refusal),
    Fault(Fault),
}

struct Run<'a> {
    source: &'a Source,
    calculations: &'a [Calculation],
    done: BTreeMap<&'a str, Computed>,
    /// Cases in progress, to detect a circular link.
    stack: Vec<&'a str>,
}

impl<'a> Run<'a> {
    fn result(&mut self, loaded: &'a Loaded) -> Computed {
        let name = loaded.case.case.as_str();
        if let Some(done) = self.done.get(name) {
            return done.clone();
        }
        self.stack.push(name);
        let computed = self.compute(loaded).unwrap_or_else(Computed::Fault);
        self.stack.pop();
        self.done.insert(name, computed.clone());
        computed
    }

    fn compute(&mut self, loaded: &'a Loaded) -> Result<Computed, Fault> {
        let Loaded { case, document } = loaded;
        let path = YamlPath::root().key("given");
        let given = self.linked(loaded, &case.given, &path)?;
        // An unknown calculation is a separate fault, found when the case was read.
        let unknown = || Fault::at(document, &YamlPath::root().key("calculation"), "not-run", "not run");
        let calculation =
            self.calculations.iter().find(|known| known.name == case.calculation).ok_or_else(unknown)?;
        match calculation.run(document, &given) {
            Ok(results) => Ok(Computed::Results(results)),
            Err(Failure::Refused(refusal)) => Ok(Computed::Refused(refusal)),
            Err(Failure::Unreadable(error)) if case.expect_error.is_some() => {
                let message = error.problem().to_string();
                Ok(Computed::Refused(Refusal { name: error.name().to_owned(), message }))
            }
            Err(Failure::Unreadable(error)) => Err(error.into()),
        }
    }

    /// Replaces every `{ from, as }` in `given` by the linked value.
    fn linked(&mut self, loaded: &'a Loaded, value: &Yaml, path: &YamlPath) -> Result<Yaml, Fault> {
        match value {
            Yaml::Mapping(map) if map.contains_key("from") => {
                let link: From = loaded.document.read_value(value, path)?;
                self.follow(loaded, &link, &path.clone().key("from"))
            }
            Yaml::Mapping(map) => {
                let mut linked = epicyclic_formats::yaml::Mapping::new();
                for (key, value) in map {
                    let step = path.clone().key(key.as_str().unwrap_or_default());
                    linked.insert(key.clone(), self.linked(loaded, value, &step)?);
                }
                Ok(Yaml::Mapping(linked))
            }
            Yaml::Sequence(items) => {
                let linked = items.iter().enumerate();
                let linked = linked.map(|(at, item)| self.linked(loaded, item, &path.clone().index(at)));
                Ok(Yaml::Sequence(linked.collect::<Result<_, _>>()?))
            }
            _ => Ok(value.clone()),
        }
    }

    fn follow(&mut self, loaded: &'a Loaded, link: &From, path: &YamlPath) -> Result<Yaml, Fault> {
        let fault = |name: &str, message: String| Fault::at(&loaded.document, path, name, message);
        let Some((case, quantity)) = link.from.split_once('/') else {
            return Err(fault("unusable-link", format!("from {}: write case/quantity", link.from)));
        };
        let Some(target) = self.source.cases.iter().find(|other| other.case.case == case) else {
            return Err(fault("unknown-case", format!("from {}: no case {case} in this source", link.from)));
        };
        if let Some(first) = self.stack.iter().position(|under_way| *under_way == case) {
            let circle = self.stack[first..].join(" → ");
            return Err(fault("circular-link", format!("the cases take from each other: {circle} → {case}")));
        }
        if link.taken == Taken::Published {
            let published = target.case.expect.get(quantity).and_then(|figure| figure.published.clone());
            return published.map(|text| as_yaml(&text)).ok_or_else(|| {
                fault("unknown-quantity", format!("from {}: {case} publishes no {quantity}", link.from))
            });
        }
        match self.result(target) {
            Computed::Results(results) => results.get(quantity).map(value_as_yaml).ok_or_else(|| {
                let known: Vec<&str> = results.iter().map(|(name, _)| name).collect();
                let message =
                    format!("from {}: {case} computes no {quantity}, but {}", link.from, known.join(", "));
                fault("unknown-quantity", message)
            }),
            Computed::Refused(refusal) => {
                Err(fault("refused-link", format!("from {}: {case} is refused: {refusal}", link.from)))
            }
            Computed::Fault(_) => {
                Err(fault("failed-link", format!("from {}: {case} does not run", link.from)))
            }
        }
    }
}

/// Published figure as an input: a number if it has no unit.
fn as_yaml(published: &str) -> Yaml {
    let text = published.trim().replace('−', "-");
    if let Ok(count) = text.parse::<i64>() {
        return Yaml::from(count);
    }
    text.parse::<f64>().map_or_else(|_| Yaml::from(published), Yaml::from)
}

/// Result as an input, to the last bit.
fn value_as_yaml(value: &Value) -> Yaml {
    match value {
        Value::Quantity { si, dimension } => match si_unit(*dimension).symbol {
            "1" => Yaml::from(*si),
            unit => Yaml::from(format!("{si} {unit}")),
        },
        Value::Count(count) => Yaml::from(*count),
        Value::Text(text) => Yaml::from(text.as_str()),
    }
}

fn figures(source: &Source, loaded: &Loaded, results: &Results) -> Vec<Figure> {
    let Loaded { case, document } = loaded;
    if let Some(name) = &case.expect_error {
        let path = YamlPath::root().key("expect_error");
        let position = document.position(&path);
        return vec![Figure {
            name: format!("{}/error", case.case),
            file: document.file().to_owned(),
            line: position.line,
            column: position.column,
            status: Status::Failed,
            kind: None,
            cite: case.cite.clone(),
            evidence: None,
            published: Some(name.clone()),
            computed: None,
            difference: None,
            tolerance: None,
            cause: None,
            print: None,
            printed_unit: None,
            because: None,
            arithmetic: None,
            failure: Some(format!("the inputs must be refused as {name}, and are accepted")),
            remedy: Some(
                "correct the inputs, or write `expect` with the figures in place of `expect_error`".into(),
            ),
        }];
    }
    case.expect
        .iter()
        .map(|(quantity, expectation)| {
            let path = YamlPath::root().key("expect").key(quantity);
            let position = document.position(&path.clone().key("published"));
            let (status, judgement) = match expectation.verdict {
                Verdict::Unrecoverable => (Status::Unrecoverable, Judgement::default()),
                Verdict::Given => {
                    (Status::Given, judge_given(loaded, quantity, expectation.published.as_deref()))
                }
                verdict => {
                    let held = match verdict {
                        Verdict::Contradicted => Status::Contradicted,
                        Verdict::Reconstructed => Status::Reconstructed,
                        Verdict::Definition => Status::Definition,
                        _ => Status::Agrees,
                    };
                    let judgement = results.get(quantity).map_or_else(
                        || {
                            let known: Vec<&str> = results.iter().map(|(name, _)| name).collect();
                            Judgement::default().failed(
                                format!("{} computes no {quantity}", case.calculation),
                                &format!("write one of {}", known.join(", ")),
                            )
                        },
                        |value| judge(expectation, value),
                    );
                    (held, judgement)
                }
            };
            let cite = expectation.cite.as_deref().unwrap_or(&case.cite);
            let is_restored =
                places(cite).any(|place| source.index.as_ref().is_some_and(|index| index.restores(place)));
            let name = format!("{}/{quantity}", case.case);
            let print = (!is_restored && expectation.verdict != Verdict::Definition)
                .then(|| expectation.print_of.clone().unwrap_or_else(|| name.clone()));
            Figure {
                name,
                file: document.file().to_owned(),
                line: position.line,
                column: position.column,
                status: if judgement.failure.is_some() { Status::Failed } else { status },
                kind: expectation.published.as_deref().map(Kind::of),
                cite: cite.to_owned(),
                evidence: expectation.evidence.or(case.evidence),
                published: expectation.published.clone(),
                computed: judgement.computed,
                difference: judgement.difference,
                tolerance: judgement.tolerance,
                cause: expectation.cause,
                print,
                printed_unit: expectation.printed_unit.clone(),
                because: expectation.because.clone().or_else(|| expectation.legible.clone()),
                arithmetic: expectation.arithmetic.clone(),
                failure: judgement.failure,
                remedy: judgement.remedy,
            }
        })
        .collect()
}

/// Judges a figure that the source sets: it must be the input of that name, such as `given.arm.length` for
/// `arm.length`.
fn judge_given(loaded: &Loaded, name: &str, published: Option<&str>) -> Judgement {
    let start = YamlPath::root().key("given");
    let path = name.split('.').fold(start, |path, key| match key.parse() {
        Ok(index) => path.index(index),
        Err(_) => path.key(key),
    });
    let judgement = Judgement::default();
    match loaded.document.text_at(&path) {
        Some(text) if Some(text) == published => judgement,
        Some(text) => judgement.failed(
            format!("the source sets it, but the input {name} is {text}"),
            "write the input as the source prints it",
        ),
        None => judgement.failed(
            format!("the source sets it, but {name} is not an input of this case"),
            "give it in `given`, or remove `verdict: given`",
        ),
    }
}

fn refused(loaded: &Loaded, refusal: &Refusal) -> Figure {
    let Loaded { case, document } = loaded;
    let expected = case.expect_error.as_deref();
    let key = if expected.is_some() { "expect_error" } else { "given" };
    let position = document.position(&YamlPath::root().key(key));
    let failure = match expected {
        Some(name) if name == refusal.name => None,
        Some(name) => Some(format!("refused as {}, not as {name}: {refusal}", refusal.name)),
        None => Some(format!("refused as {}: {refusal}", refusal.name)),
    };
    let remedy = failure.as_ref().map(|_| {
        format!("correct the inputs; or, where they must be refused, write `expect_error: {}`", refusal.name)
    });
    Figure {
        name: format!("{}/error", case.case),
        file: document.file().to_owned(),
        line: position.line,
        column: position.column,
        status: if failure.is_some() { Status::Failed } else { Status::Refused },
        kind: None,
        cite: case.cite.clone(),
        evidence: None,
        published: case.expect_error.clone(),
        computed: Some(refusal.name.clone()),
        difference: None,
        tolerance: None,
        cause: None,
        print: None,
        printed_unit: None,
        because: Some(refusal.message.clone()),
        arithmetic: None,
        failure,
        remedy,
    }
}

const ACCEPT: &str = "cargo xtask verify --accept";

fn compare_snapshot(
    source: &Source,
    loaded: &Loaded,
    found: &str,
    holds: bool,
    snapshots: Snapshots,
) -> Option<Fault> {
    let Loaded { case, document } = loaded;
    let path = snapshot::path(&source.folder, &case.case);
    let fault =
        |name: &str, message: String| Some(Fault::at(document, &YamlPath::root().key("case"), name, message));
    let stored = match snapshot::read(&path) {
        Ok(stored) => stored,
        Err(error) => return fault("unreadable-snapshot", format!("{}: {error}", path.display())),
    };
    let difference = match &stored {
        None => Some((NEW, "new: agrees; store its results".to_owned())),
        Some(stored) => snapshot::first_difference(stored, found)
            .map(|difference| ("changed-snapshot", format!("{difference}; if that is meant, accept it"))),
    };
    let (name, message) = difference?;
    if snapshots == Snapshots::Compare {
        // A failing case is reported by its figures; its snapshot is accepted only when it holds.
        let message = format!("{}: {message} with `{ACCEPT} {}`", case.case, case.case);
        return if holds { fault(name, message) } else { None };
    }
    let written = snapshot::write(&path, &case.calculation, found);
    written.err().and_then(|error| fault("unwritable-snapshot", format!("{}: {error}", path.display())))
}

fn orphans(source: &Source, snapshots: Snapshots) -> Vec<Fault> {
    let names: BTreeSet<&str> = source.cases.iter().map(|loaded| loaded.case.case.as_str()).collect();
    let Ok(entries) = fs::read_dir(source.folder.join(snapshot::FOLDER)) else { return Vec::new() };
    let mut faults = Vec::new();
    for entry in entries.flatten() {
        let path = entry.path();
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        if path.extension().is_some_and(|extension| extension == "snap") && names.contains(stem.as_str()) {
            continue;
        }
        let file = source.file(&format!("{}/{}", snapshot::FOLDER, entry.file_name().to_string_lossy()));
        // A case that cannot be read keeps its snapshot, so that its repair needs no acceptance.
        if snapshots == Snapshots::Accept && source.faults.is_empty() {
            if let Err(error) = fs::remove_file(&path) {
                faults.push(orphan(file, format!("cannot be removed: {error}")));
            }
        } else if snapshots == Snapshots::Compare {
            faults.push(orphan(
                file,
                format!("case {stem} was removed; if that is meant, `{ACCEPT}` removes its snapshot too"),
            ));
        }
    }
    faults
}

fn orphan(file: String, message: String) -> Fault {
    Fault { file, line: 1, column: 1, name: "orphan-snapshot".into(), message }
}

fn coverage(source: &Source, outcome: &mut Outcome) {
    let Some(index) = &source.index else { return };
    let mut cited: BTreeMap<&str, usize> = BTreeMap::new();
    // A case that cannot run has no compared figures, so it covers no place.
    for figure in outcome.figures.iter().filter(|figure| figure.was_compared()) {
        places(&figure.cite).for_each(|place| *cited.entry(place).or_default() += 1);
    }
    let mut faults = Vec::new();
    for place in &index.places {
        let figures = cited.get(place.place.as_str()).copied().unwrap_or(0);
        let message = match (figures, &place.excused) {
            (0, None) => {
                let message = format!(
                    "no case covers {} ({}): write one, or say why not in `excused`",
                    place.place, place.what
                );
                Some(("uncovered-place", message))
            }
            (1.., Some(_)) => Some((
                "covered-excuse",
                format!("{} is excused, but cases cover it: remove `excused`", place.place),
            )),
            _ => None,
        };
        if let Some((name, message)) = message {
            let file = source.file(crate::cases::index::FILE);
            faults.push(Fault { file, line: 1, column: 1, name: name.into(), message });
        }
        outcome.coverage.push(Coverage {
            place: place.place.clone(),
            what: place.what.clone(),
            figures,
            excused: place.excused.clone(),
        });
    }
    outcome.faults.extend(faults);
}
