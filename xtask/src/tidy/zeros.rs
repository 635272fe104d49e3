//! Check that limits below which a value counts as zero are defined in `tolerance.rs`, with their meaning.

use super::{Breach, excused, source::Source};

/// Number up to which a literal in the code counts as such a limit.
const SMALL: f64 = 1e-6;

/// Files whose small numbers are factors of units.
const FACTORS: [&str; 1] = ["crates/units/src/unit.rs"];

/// Files that still have such numbers.
const NOT_YET: &[&str] = &[];

/// Finds small numbers of libraries outside `tolerance.rs`.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    excused(sources.iter().flat_map(of).collect(), sources, NOT_YET)
}

fn of(source: &Source) -> Vec<Breach> {
    if !source.is_library()
        || source.path.ends_with("/tolerance.rs")
        || FACTORS.contains(&source.path.as_str())
    {
        return Vec::new();
    }
    let mut found = Vec::new();
    for (number, line) in source.code.lines().enumerate() {
        for literal in literals(line) {
            let message = format!(
                "{literal} stands for nothing: give it a name and its meaning in the crate's tolerance.rs"
            );
            found.push(Breach::new(&source.path, number + 1, message));
        }
    }
    found
}

/// The small floating-point literals of a line of code.
fn literals(line: &str) -> impl Iterator<Item = &str> {
    let bytes = line.as_bytes();
    let starts = (0..line.len()).filter(move |&at| {
        let before = at.checked_sub(1).map(|before| bytes[before]);
        let in_word =
            |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'.' || !byte.is_ascii();
        // A range's dots open a number.
        let after_range = at >= 2 && &bytes[at - 2..at] == b"..";
        bytes[at].is_ascii_digit() && (after_range || !before.is_some_and(in_word))
    });
    starts.map(move |start| &line[start..start + length(&bytes[start..])]).filter(|literal| {
        let is_float = literal.contains(['.', 'e']) && !literal.starts_with("0x");
        let value: Option<f64> = literal.replace('_', "").parse().ok();
        is_float && value.is_some_and(|value| value > 0.0 && value <= SMALL)
    })
}

/// How many bytes the number that begins here has.
fn length(bytes: &[u8]) -> usize {
    let mut at = 0;
    while at < bytes.len() {
        let goes_on = match bytes[at] {
            b'0'..=b'9' | b'_' => true,
            b'.' => bytes.get(at + 1).is_some_and(u8::is_ascii_digit),
            b'e' | b'E' => bytes.get(at + 1).is_some_and(|next| next.is_ascii_digit() || *next == b'-'),
            b'-' => at > 0 && matches!(bytes[at - 1], b'e' | b'E'),
            _ => false,
        };
        if !goes_on {
            break;
        }
        at += 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_numbers_are_found_and_others_not() {
        let found = |line: &'static str| literals(line).collect::<Vec<_>>();
        assert_eq!(found("if x < 1e-9 * (1.0 - 2.5e-7) {"), ["1e-9", "2.5e-7"]);
        assert_eq!(found("(0.000_000_1..=1e-12)"), ["0.000_000_1", "1e-12"]);
        assert!(found("let x1e = 1e-5 + 0.0 + 1e6 - 0x1e - 9; x.0").is_empty());
    }

    #[test]
    fn tolerance_and_tests_may_have_them() {
        let code = "const A: f64 = 1e-9;\n";
        assert_eq!(check(&[Source::new("crates/gears/src/a.rs", code)]).len(), 1);
        assert!(check(&[Source::new("crates/gears/src/tolerance.rs", code)]).is_empty());
        let tests = format!("#[cfg(test)]\nmod tests {{\n{code}}}\n");
        assert!(check(&[Source::new("crates/gears/src/a.rs", &tests)]).is_empty());
    }
}
