//! Libraries neither print nor open files, read the environment or start programs.

use super::{Breach, source::Source};

/// Text patterns that a library must not contain.
const PATTERNS: [&str; 13] = [
    "println!",
    "print!",
    "eprintln!",
    "eprint!",
    "dbg!",
    "std::fs",
    "std::io::std",
    "std::env",
    "std::process",
    "std::net",
    "std::thread",
    "File::",
    "OpenOptions",
];

/// Finds lines of libraries with such patterns.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    sources.iter().filter(|source| source.is_library()).flat_map(of).collect()
}

fn of(source: &Source) -> Vec<Breach> {
    let mut found = Vec::new();
    for (number, line) in source.code.lines().enumerate() {
        if let Some(pattern) = PATTERNS.iter().find(|pattern| contains(line, pattern)) {
            let message = format!(
                "`{pattern}` in a library: return what is to be written, and let the program write it"
            );
            found.push(Breach::new(&source.path, number + 1, message));
        }
    }
    found
}

/// Whether a line has the pattern where no longer name ends with it.
fn contains(line: &str, pattern: &str) -> bool {
    line.match_indices(pattern)
        .any(|(at, _)| !line[..at].ends_with(|before: char| before.is_alphanumeric() || before == '_'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn printing_and_opening_are_breaches() {
        let code = "fn a() {\n    println!(\"x\");\n    let f = std::fs::read(\"x\");\n}\n";
        let lines: Vec<usize> =
            check(&[Source::new("crates/gears/src/a.rs", code)]).iter().map(|breach| breach.line).collect();
        assert_eq!(lines, [2, 3]);
    }

    #[test]
    fn the_program_may_and_words_that_end_alike_are_none() {
        let code = "fn a() { println!(\"x\"); }\n";
        assert!(check(&[Source::new("crates/cli/src/a.rs", code)]).is_empty());
        let alike = "fn a() { MotorFile::read(\"println!\"); } // println!\n";
        assert!(check(&[Source::new("crates/formats/src/a.rs", alike)]).is_empty());
    }
}
