//! Conversions between quantities and numbers are in `crates/units` alone.

use super::{Breach, excused, source::Source};

/// File that may convert.
const DOOR: &str = "crates/units/src/conversion.rs";

/// Files that still convert.
const NOT_YET: &[&str] = &[];

/// Text patterns of a conversion.
const PATTERNS: [&str; 2] = [".get::<", "::new::<"];

/// Finds lines of libraries that convert elsewhere.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    excused(sources.iter().flat_map(of).collect(), sources, NOT_YET)
}

fn of(source: &Source) -> Vec<Breach> {
    if !source.is_library() || source.path == DOOR {
        return Vec::new();
    }
    if source.path.ends_with("/units.rs") {
        return vec![Breach::new(
            &source.path,
            1,
            format!("holds conversions of its own: they are in {DOOR}"),
        )];
    }
    let lines = source.code.lines().enumerate();
    lines
        .filter(|(_, line)| PATTERNS.iter().any(|pattern| line.contains(pattern)))
        .map(|(number, _)| {
            Breach::new(
                &source.path,
                number + 1,
                format!("converts a quantity: `si`, `from_si` and their like are in {DOOR}"),
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
    fn a_file_of_conversions_beside_the_crate_of_units_is_a_breach() {
        assert_eq!(check(&[Source::new("crates/gears/src/units.rs", "fn a() {}\n")]).len(), 1);
    }

    #[test]
    fn the_crate_of_units_docs_tests_and_the_program_may_convert() {
        assert!(check(&[Source::new(DOOR, CODE)]).is_empty());
        assert!(check(&[Source::new("crates/cli/src/a.rs", CODE)]).is_empty());
        assert!(check(&[Source::new("crates/gears/tests/a.rs", CODE)]).is_empty());
        assert!(
            check(&[Source::new("crates/gears/src/a.rs", "/// x.get::<meter>()\nfn a() {}\n")]).is_empty()
        );
        let tests = format!("#[cfg(test)]\nmod tests {{\n{CODE}}}\n");
        assert!(check(&[Source::new("crates/gears/src/a.rs", &tests)]).is_empty());
    }
}
