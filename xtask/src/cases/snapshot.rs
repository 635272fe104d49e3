//! Snapshots of everything a case computes, in insta's file format: they say *changed*, never
//! *right*.

use crate::calculations::{Refusal, Results, Value};
use crate::cases::figure::si_unit;
use crate::schema::write_whole;
use epicyclic_formats::quantity::Dimension;
use epicyclic_formats::quantity::format::trimmed;
use std::io;
use std::path::{Path, PathBuf};

/// Folder of a source's snapshots.
pub const FOLDER: &str = "snapshots";

/// Digits that a snapshot keeps.
const DIGITS: usize = 10;
/// Numbers that differ by less than this, relative, are the same.
const SAME: f64 = 1e-9;
/// What is below this part of the case's largest like quantity is zero.
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

/// The first line in which two snapshots differ beyond rounding.
#[must_use]
pub fn first_difference(stored: &str, found: &str) -> Option<String> {
    let (mut stored_lines, mut found_lines) = (stored.trim_end().lines(), found.trim_end().lines());
    loop {
        match (stored_lines.next(), found_lines.next()) {
            (None, None) => return None,
            (Some(stored), Some(found)) if same_line(stored, found) => {}
            (stored, found) => {
                let shown =
                    |line: Option<&str>| line.map_or("nothing".to_owned(), |line| format!("`{line}`"));
                return Some(format!("{} became {}", shown(stored), shown(found)));
            }
        }
    }
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
        let stored = "a = 1.234567891 rad/s\nb = 4\n";
        assert_eq!(first_difference(stored, "a = 1.234567892 rad/s\nb = 4\n"), None);
        assert_eq!(
            first_difference(stored, "a = 1.234568 rad/s\nb = 4\n").as_deref(),
            Some("`a = 1.234567891 rad/s` became `a = 1.234568 rad/s`")
        );
        assert!(first_difference(stored, "a = 1.234567891 kg\nb = 4\n").is_some());
        assert!(first_difference(stored, "a = 1.234567891 rad/s\n").is_some());
        assert!(first_difference(stored, "a = 1.234567891 rad/s\nb = 5\n").is_some());
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
