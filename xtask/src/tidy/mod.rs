//! `cargo xtask tidy`: check of the rules for the code in ARCHITECTURE.md.
//!
//! | module | rule |
//! |---|---|
//! | [`arrows`] | allowed dependencies between crates |
//! | [`circles`] | no circle of files within a crate |
//! | [`conversions`] | conversions of quantities in `crates/units` alone |
//! | [`purity`] | libraries neither print nor open files |
//! | [`length`] | files of bounded length |
//! | [`library`] | a README with an example that runs, and what a registry asks |
//! | [`words`] | words replaced by those of the field |
//! | [`zeros`] | limits below which a value counts as zero, in `tolerance.rs` |
//!
//! A rule is a function of path and text. If the code does not comply yet, a table in the rule's own file
//! names the place. An entry that is no longer needed is a breach too, so that the tables only shrink.

pub mod arrows;
pub mod circles;
pub mod conversions;
pub mod length;
pub mod library;
pub mod purity;
pub mod source;
pub mod words;
pub mod zeros;

use crate::project_root;
use clap::Args;
use source::Source;
use std::fmt;
use std::process::ExitCode;

/// Hold the code against what ARCHITECTURE.md promises: arrows, circles, units, words.
///
/// Exit code 0 if every rule holds, 1 with a line for each breach.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  cargo xtask tidy")]
pub struct Arguments {}

/// Place that breaks a rule.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Breach {
    /// The file, from the project's root.
    pub path: String,
    /// Line of the place, from 1.
    pub line: usize,
    /// Message about the fault, with the remedy.
    pub message: String,
}

impl Breach {
    fn new(path: &str, line: usize, message: impl Into<String>) -> Self {
        Self { path: path.to_owned(), line, message: message.into() }
    }
}

impl fmt::Display for Breach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.path, self.line, self.message)
    }
}

/// Runs the command.
///
/// # Errors
/// A message where the files cannot be read.
pub fn run(_: &Arguments) -> Result<ExitCode, String> {
    let sources = source::of_project(&project_root())?;
    let breaches = check(&sources);
    for breach in &breaches {
        println!("{breach}");
    }
    if breaches.is_empty() {
        println!("tidy: {} files keep all rules", sources.len());
        return Ok(ExitCode::SUCCESS);
    }
    println!("{} breaches", breaches.len());
    Ok(ExitCode::from(1))
}

/// Finds every breach of every rule, in the order of the files.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    let mut breaches: Vec<Breach> = [
        arrows::check,
        circles::check,
        conversions::check,
        purity::check,
        length::check,
        library::check,
        words::check,
        zeros::check,
    ]
    .iter()
    .flat_map(|rule| rule(sources))
    .collect();
    breaches.sort();
    breaches
}

/// The breaches of a rule that a table excuses are left out; an entry of the table that excuses nothing is a
/// breach.
fn excused(found: Vec<Breach>, sources: &[Source], table: &[&str]) -> Vec<Breach> {
    let unused = |path: &&&str| {
        sources.iter().any(|source| source.path == **path)
            && !found.iter().any(|breach| breach.path == **path)
    };
    let stale: Vec<Breach> = table
        .iter()
        .filter(unused)
        .map(|path| {
            Breach::new(path, 1, "keeps the rule it is excused from: remove it from the rule's table")
        })
        .collect();
    found.into_iter().filter(|breach| !table.contains(&breach.path.as_str())).chain(stale).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_excuse_that_is_not_needed_is_a_breach() {
        let sources = [Source::new("a.rs", ""), Source::new("b.rs", "")];
        let found = vec![Breach::new("a.rs", 3, "wrong")];
        assert!(excused(found.clone(), &sources, &["a.rs"]).is_empty());
        let stale = excused(found, &sources, &["a.rs", "b.rs"]);
        assert_eq!(stale.len(), 1);
        assert_eq!(stale[0].path, "b.rs");
    }
}
