//! Conversions between quantities and numbers stand in a crate's `units.rs` alone.

use super::{Breach, excused, source::Source};

/// Files other than `units.rs` in which a crate converts.
const DOORS: [&str; 1] = ["crates/units/src/conversion.rs"];

/// Files that convert still.
const NOT_YET: &[&str] = &[];

/// What a conversion looks like.
const PATTERNS: [&str; 2] = [".get::<", "::new::<"];

/// Lines of libraries that convert elsewhere.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    excused(sources.iter().flat_map(of).collect(), sources, NOT_YET)
}

fn of(source: &Source) -> Vec<Breach> {
    if !source.is_library() || source.path.ends_with("/units.rs") || DOORS.contains(&source.path.as_str()) {
        return Vec::new();
    }
    let lines = source.code.lines().enumerate();
    lines
        .filter(|(_, line)| PATTERNS.iter().any(|pattern| line.contains(pattern)))
        .map(|(number, _)| {
            Breach::new(
                &source.path,
                number + 1,
                "converts a quantity: put the conversion into the crate's units.rs",
            )
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: &str = "fn a(x: Length) -> f64 {\n    x.get::<meter>()\n}\n";

    #[test]
    fn a_conversion_elsewhere_is_a_breach() {
        let breaches = check(&[Source::new("crates/gears/src/a.rs", CODE)]);
        assert_eq!(breaches.len(), 1);
        assert_eq!(breaches[0].line, 2);
    }

    #[test]
    fn units_docs_tests_and_the_program_may_convert() {
        assert!(check(&[Source::new("crates/gears/src/units.rs", CODE)]).is_empty());
        assert!(check(&[Source::new("crates/cli/src/a.rs", CODE)]).is_empty());
        assert!(check(&[Source::new("crates/gears/tests/a.rs", CODE)]).is_empty());
        assert!(
            check(&[Source::new("crates/gears/src/a.rs", "/// x.get::<meter>()\nfn a() {}\n")]).is_empty()
        );
        let tests = format!("#[cfg(test)]\nmod tests {{\n{CODE}}}\n");
        assert!(check(&[Source::new("crates/gears/src/a.rs", &tests)]).is_empty());
    }
}
