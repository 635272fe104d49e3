//! Snapshots of all results of a case, in insta's file format. They detect changes, but do not prove
//! correctness.

use crate::calculations::{Refusal, Results, Value};
use crate::cases::case::{Case, Expectation};
use crate::cases::figure::si_unit;
use crate::schema::write_whole;
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;
use std::io;
use std::path::{Path, PathBuf};

/// Folder of a source's snapshots.
pub const FOLDER: &str = "snapshots";

/// Significant digits in a snapshot.
const DIGITS: usize = 12;
/// Relative difference up to which numbers count as equal: a unit of the last digit.
const SAME: f64 = 1e-11;
/// Part of the largest comparable quantity of a case below which a value counts as zero.
const ZERO: f64 = 1e-12;

/// Text of a case's results: a line each, in SI units.
#[must_use]
pub fn of_results(results: &Results) -> String {
    let largest = |wanted: Dimension| {
        results.iter().fold(0.0, |largest: f64, (_, value)| match value {
            Value::Quantity { si, dimension } if *dimension == wanted => largest.max(si.abs()),
            _ => largest,
        })
    };
    let line = |(name, value): (&str, &Value)| match value {
        Value::Quantity { si, dimension } => {
            let shown = if si.abs() < ZERO * largest(*dimension) { 0.0 } else { *si };
            // A negative zero is a zero.
            format!("{name} = {} {}\n", trimmed(shown + 0.0, DIGITS), si_unit(*dimension).symbol)
        }
        Value::Count(count) => format!("{name} = {count}\n"),
        Value::Text(text) => format!("{name} = {text}\n"),
    };
    results.iter().map(line).collect()
}

/// Text of the expectations of a case, one line per figure, so that removed or changed ones are visible.
#[must_use]
pub fn of_expectations(case: &Case) -> String {
    let line = |(quantity, figure): (&String, &Expectation)| {
        let published = figure.published.as_deref().unwrap_or("-");
        format!("expected {quantity} = {published}, {}\n", figure.verdict.word())
    };
    let error = case.expect_error.iter().map(|name| format!("expected error = {name}\n"));
    case.expect.iter().map(line).chain(error).collect()
}

/// Text of a refusal.
#[must_use]
pub fn of_refusal(refusal: &Refusal) -> String {
    format!("refused: {}\n{}\n", refusal.name, refusal.message)
}

/// Path of a case's snapshot.
#[must_use]
pub fn path(source_folder: &Path, case: &str) -> PathBuf {
    source_folder.join(FOLDER).join(format!("{case}.snap"))
}

/// The text of a stored snapshot, if there is one.
///
/// # Errors
/// A file that is there and cannot be read as a snapshot.
pub fn read(path: &Path) -> Result<Option<String>, String> {
    if !path.exists() {
        return Ok(None);
    }
    let snapshot = insta::Snapshot::from_file(path).map_err(|error| error.to_string())?;
    Ok(snapshot.as_text().map(ToString::to_string))
}

/// Writes a snapshot, whole or not at all.
///
/// # Errors
/// As the file system has them.
pub fn write(path: &Path, calculation: &str, text: &str) -> io::Result<()> {
    write_whole(path, &format!("---\nsource: {}\nexpression: {calculation}\n---\n{text}", file!()))
}

/// The first line in which two snapshots differ beyond rounding, by the name before its ` = `.
#[must_use]
pub fn first_difference(stored: &str, found: &str) -> Option<String> {
    fn name(line: &str) -> &str {
        line.split_once(" = ").map_or(line, |(name, _)| name)
    }
    fn of<'a>(text: &'a str, wanted: &str) -> Option<&'a str> {
        text.trim_end().lines().find(|line| name(line) == wanted)
    }
    let changed = stored.trim_end().lines().find_map(|line| match of(found, name(line)) {
        None => Some(format!("`{line}` is gone")),
        Some(other) if !same_line(line, other) => Some(format!("`{line}` became `{other}`")),
        Some(_) => None,
    });
    let mut lines = found.trim_end().lines();
    changed.or_else(|| {
        lines.find(|line| of(stored, name(line)).is_none()).map(|line| format!("`{line}` is new"))
    })
}

fn same_line(stored: &str, found: &str) -> bool {
    let number = |line: &str| {
        let (name, value) = line.split_once(" = ")?;
        let (number, unit) = value.split_once(' ')?;
        Some((name.to_owned(), number.parse::<f64>().ok()?, unit.to_owned()))
    };
    match (number(stored), number(found)) {
        (Some((name, a, unit)), Some((other_name, b, other_unit))) => {
            name == other_name && unit == other_unit && (a - b).abs() <= SAME * a.abs().max(b.abs())
        }
        _ => stored == found,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_does_not_change_a_snapshot_and_values_do() {
        let stored = "a = 1.23456789012 rad/s\nb = 4\n";
        let difference = |found: &str| first_difference(stored, found);
        // One unit of the twelfth digit is rounding, two are a change.
        assert_eq!(difference("a = 1.23456789013 rad/s\nb = 4\n"), None);
        assert_eq!(
            difference("a = 1.23456789014 rad/s\nb = 4\n").as_deref(),
            Some("`a = 1.23456789012 rad/s` became `a = 1.23456789014 rad/s`")
        );
        assert!(difference("a = 1.23456789012 kg\nb = 4\n").is_some());
        assert_eq!(difference("a = 1.23456789012 rad/s\n").as_deref(), Some("`b = 4` is gone"));
        assert!(difference("a = 1.23456789012 rad/s\nb = 5\n").is_some());
        assert_eq!(difference("a = 1.23456789012 rad/s\nc = 1\nb = 4\n").as_deref(), Some("`c = 1` is new"));
    }

    #[test]
    fn rounding_noise_and_negative_zero_are_zero() {
        let mut results = Results::default();
        results.number("large", 1e3).number("noise", 1e-10).number("small", 1e-8).number("zero", -0.0);
        assert_eq!(of_results(&results), "large = 1000 1\nnoise = 0 1\nsmall = 1e-8 1\nzero = 0 1\n");
    }

    #[test]
    fn a_written_snapshot_reads_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = path(folder.path(), "some-case");
        assert_eq!(read(&path), Ok(None));
        write(&path, "gears.row", "a = 1 rad/s\nb = yes\n").unwrap();
        assert_eq!(
            read(&path).unwrap().map(|text| text.trim_end().to_owned()),
            Some("a = 1 rad/s\nb = yes".into())
        );
    }
}
