//! A file has one topic: at most 600 lines without its tests.

use super::{Breach, source::Source};

/// The most lines of a file, its tests apart.
const MOST: usize = 600;

/// Longer files, and the most lines that each may have: what it had when the rule came.
const LONGER: &[(&str, usize)] = &[("xtask/src/calculations/schemes.rs", 780)];

/// Files that are too long.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    sources.iter().filter(|source| source.in_crate().is_some()).filter_map(of).collect()
}

fn of(source: &Source) -> Option<Breach> {
    let length = source.length();
    let exception = LONGER.iter().find(|(path, _)| *path == source.path).map(|(_, most)| *most);
    match exception {
        Some(_) if length <= MOST => Some(Breach::new(
            &source.path,
            1,
            "is short enough now: remove it from LONGER of xtask/src/tidy/length.rs",
        )),
        _ if length > exception.unwrap_or(MOST) => {
            let most = exception.unwrap_or(MOST);
            let message = format!("{length} lines without tests, at most {most}: split it by topic");
            Some(Breach::new(&source.path, 1, message))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_file_is_a_breach_and_long_tests_are_none() {
        let long = "fn a() {}\n".repeat(MOST + 1);
        assert_eq!(check(&[Source::new("crates/gears/src/a.rs", &long)]).len(), 1);
        let tests = format!("fn a() {{}}\n#[cfg(test)]\nmod tests {{\n{long}}}\n");
        assert!(check(&[Source::new("crates/gears/src/a.rs", &tests)]).is_empty());
        assert!(check(&[Source::new("crates/gears/tests/a.rs", &long)]).is_empty());
    }
}
