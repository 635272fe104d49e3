//! `synthesize` in parts on many machines: the search through one share, and all shares together.
//!
//! A share in work keeps what is done beside its part, in a file with `.progress` at the end of its name: a
//! part that is not complete. It is written whole or not at all. The same command goes on from there, and the
//! part it ends with is byte for byte that of a run that was never ended: what is found in a structure
//! depends on nothing but the question.

use crate::desk::{Call, Hearing, Text};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::shared::options::of_synthesis;
use crate::synthesize::answer::{Kept, Searching, Synthesis, Tried, Wanted, solve_by, tried};
use epicyclic_synthesis::asked::{Asked, asked};
use epicyclic_synthesis::run::go_on;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::work::{Share, Work};
use epicyclic_tables::merge::{merge, same_question};
use epicyclic_tables::part::Part;
use std::io::{self, ErrorKind};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The most bytes of a part: of so much the memory for what it holds is a multiple.
const MOST_BYTES: u64 = 1 << 30;

/// How often what is done is kept at most, in s.
const KEPT_EVERY: f64 = 0.2;

/// Keeping takes at most one part in so many of the time.
const KEPT_SHARE: f64 = 20.0;

/// Searches a share of all classes that may have to be searched, and writes what it finds. Whether a class
/// has solutions in other shares is not known here, so all of them are searched.
pub(crate) fn search(call: &Call<'_>, wanted: &Wanted, share: Share, file: &Path) -> Result<(), Failure> {
    let questions = tried(wanted).map_err(of_synthesis)?;
    let asked = asked_of(&questions);
    if let Some(part) = read(call, file)?.filter(|part| part.is_complete() && is_same(part, share, &asked)) {
        call.complain(&format!("note: {} is complete already: {}", file.display(), told(&part)));
        return Ok(());
    }
    let progress = in_work(file);
    let mut part = match read(call, &progress)? {
        Some(part) => {
            let name = progress.display().to_string();
            if part.version != VERSION || part.share != share {
                let (given, version) = (&part.version, &part.share);
                let message = format!(
                    "{name} is of share {version} and version {given}, not of share {share} and version {VERSION}: remove it, or \
                     name another file"
                );
                return Err(Failure::invalid("--shard", message));
            }
            same_question(&name, &part, &asked)?;
            call.complain(&format!("note: going on with {name}"));
            part
        }
        None => {
            let searches = asked.into_iter().map(|asked| (asked, Work::default())).collect();
            Part { version: VERSION.into(), share, searches }
        }
    };
    let _hearing = Hearing::new(call);
    for (number, Tried { searching: Searching { class, .. }, wish, .. }) in questions.iter().enumerate() {
        let before = std::mem::take(&mut part.searches[number].1);
        let at = before.progress();
        let shown = Progress::from(call, at.done as f64 / at.of.max(1) as f64);
        let keeping = Mutex::new(Keeping { part: part.clone(), next: call.desk.seconds(), failed: None });
        let work = go_on(*class, wish, share, before, &|work| {
            let at = work.progress();
            let goes_on = shown.at(at.done as f64 / at.of.max(1) as f64);
            let mut keeping = keeping.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            keeping.keep(call, number, work, &progress);
            if keeping.failed.is_some() { ControlFlow::Break(()) } else { goes_on }
        });
        part.searches[number].1 = work.map_err(|error| of_synthesis(error.into()))?;
        if let Some(failed) = keeping.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner).failed {
            return Err(failed);
        }
        if !part.searches[number].1.is_complete() {
            call.write(&[(progress.clone(), part.to_parquet()?)])?;
            return Err(Failure::Interrupted(format!(
                "interrupted: ended with {}; what is done is kept in {}, and the same command goes on from there",
                told(&part),
                progress.display()
            )));
        }
    }
    call.write(&[(file.to_owned(), part.to_parquet()?)])?;
    call.desk.remove(&progress).map_err(|source| Failure::Write { file: progress, source })?;
    call.complain(&format!("note: {} is complete: {}", file.display(), told(&part)));
    Ok(())
}

/// Keeps what is done, now and then.
struct Keeping {
    part: Part,
    /// When it is kept next, by the clock of the desk.
    next: f64,
    failed: Option<Failure>,
}

impl Keeping {
    fn keep(&mut self, call: &Call<'_>, number: usize, work: &Work, file: &Path) {
        let begun = call.desk.seconds();
        if begun < self.next || self.failed.is_some() {
            return;
        }
        self.part.searches[number].1 = work.clone();
        let written = self.part.to_parquet().map_err(Failure::from);
        self.failed = written.and_then(|bytes| call.write(&[(file.to_owned(), bytes)])).err();
        let now = call.desk.seconds();
        self.next = now + KEPT_EVERY.max(KEPT_SHARE * (now - begun));
    }
}

/// The answer to a question from all parts of its search.
pub(crate) fn merged(
    call: &Call<'_>,
    wanted: &Wanted,
    files: &[PathBuf],
) -> Result<(Synthesis, Vec<Kept>), Failure> {
    let asked = asked_of(&tried(wanted).map_err(of_synthesis)?);
    let mut parts = Vec::new();
    for file in files {
        let part = read(call, file)?
            .ok_or_else(|| Failure::Read { file: file.clone(), source: ErrorKind::NotFound.into() })?;
        parts.push((file.display().to_string(), part));
    }
    let mut answers = merge(&parts, VERSION, &asked)?.into_iter();
    drop(parts);
    solve_by(wanted, &mut |_: &Searching, _: &Wish| {
        // The classes come in the order of the questions.
        answers.next().ok_or_else(|| Failure::NothingFound("the parts have no such class".into()))
    })
}

fn asked_of(questions: &[Tried]) -> Vec<Asked> {
    questions.iter().map(|tried| asked(tried.searching.class, &tried.wish)).collect()
}

fn is_same(part: &Part, share: Share, asked: &[Asked]) -> bool {
    part.version == VERSION && part.share == share && same_question("", part, asked).is_ok()
}

/// The part in a file, if there is one.
fn read(call: &Call<'_>, file: &Path) -> Result<Option<Part>, Failure> {
    let failed = |source| Failure::Read { file: file.to_owned(), source };
    // A device may have no end, and a pipe no beginning.
    if call.desk.exists(file) && !call.desk.are_one_file(file, file) {
        let message = "a part is a file, no device, pipe or folder";
        return Err(failed(io::Error::new(ErrorKind::InvalidInput, message)));
    }
    let bytes = match call.desk.read(Some(file), MOST_BYTES) {
        Ok(Text::Whole(bytes)) => bytes,
        Ok(Text::TooLarge { .. }) => return Err(failed(ErrorKind::FileTooLarge.into())),
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(failed(error)),
    };
    let part = Part::from_parquet(bytes);
    part.map(Some).map_err(|error| failed(io::Error::new(ErrorKind::InvalidData, error.to_string())))
}

/// Where the work on a part is kept.
fn in_work(file: &Path) -> PathBuf {
    let mut name = file.as_os_str().to_owned();
    name.push(".progress");
    name.into()
}

/// How many structures were searched, and what was found.
fn told(part: &Part) -> String {
    let sum = |of: fn(&Work) -> usize| part.searches.iter().map(|(_, work)| of(work)).sum::<usize>();
    let (done, found) = (sum(|work| work.progress().done), sum(|work| work.found.len()));
    format!("share {}, {done} structures searched, {found} gearboxes found", part.share)
}
