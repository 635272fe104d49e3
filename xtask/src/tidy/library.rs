//! Requirements of every library: a README with an example that runs, and the data that a registry needs.

use super::{Breach, source::Source};

/// Crates that are not libraries.
const PROGRAMS: [&str; 4] = ["browser", "calls", "cli", "python"];

/// Keys of a manifest besides its name.
const KEYS: [&str; 4] = ["description", "readme", "keywords", "categories"];

/// Maximum number of lines of an example.
const MOST: usize = 30;

/// A chapter and the example that it shows.
const SHOWN: (&str, &str) = ("docs/src/library.md", "crates/train/examples/");

/// Libraries that lack something.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    let manifests = sources.iter().filter_map(|source| {
        let name = source.path.strip_prefix("crates/")?.strip_suffix("/Cargo.toml")?;
        (!name.contains('/')).then_some((name, source))
    });
    let mut breaches: Vec<Breach> =
        manifests.flat_map(|(name, manifest)| of(name, manifest, sources)).collect();
    let examples: Vec<&Source> = in_folder(sources, SHOWN.1).collect();
    if let Some(chapter) = sources.iter().find(|source| source.path == SHOWN.0) {
        breaches.extend(shows(chapter, &examples));
    }
    breaches
}

fn of(name: &str, manifest: &Source, sources: &[Source]) -> Vec<Breach> {
    let mut breaches: Vec<Breach> = KEYS
        .iter()
        .filter(|key| !manifest.text.lines().any(|line| line.starts_with(&format!("{key} = "))))
        .map(|key| Breach::new(&manifest.path, 1, format!("no `{key}`: write it under [package]")))
        .collect();
    let Some(readme) = sources.iter().find(|source| source.path == format!("crates/{name}/README.md")) else {
        breaches.push(Breach::new(
            &manifest.path,
            1,
            "no README.md: say what the crate answers, with an example",
        ));
        return breaches;
    };
    if PROGRAMS.contains(&name) {
        return breaches;
    }
    let examples: Vec<&Source> = in_folder(sources, &format!("crates/{name}/examples/")).collect();
    breaches.extend(shows(readme, &examples));
    breaches.extend(examples.iter().filter(|example| example.text.lines().count() > MOST).map(|example| {
        Breach::new(&example.path, MOST + 1, format!("more than {MOST} lines: a first example is short"))
    }));
    breaches
}

fn in_folder<'a>(sources: &'a [Source], folder: &str) -> impl Iterator<Item = &'a Source> {
    sources.iter().filter(move |source| source.path.starts_with(folder) && source.path.ends_with(".rs"))
}

/// A breach where a document shows none of the examples word by word.
fn shows(document: &Source, examples: &[&Source]) -> Option<Breach> {
    let shown =
        examples.iter().any(|example| document.text.contains(&format!("```rust\n{}```", example.text)));
    (!shown).then(|| {
        let message = "shows no example of the crate word by word: put one into examples/ and its text here";
        Breach::new(&document.path, 1, message)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const MANIFEST: &str = "[package]\ndescription = \"a\"\nreadme = \"README.md\"\nkeywords = [\"a\"]\ncategories = [\"science\"]\n";

    fn library(manifest: &str, readme: &str, example: &str) -> Vec<Breach> {
        check(&[
            Source::new("crates/new/Cargo.toml", manifest),
            Source::new("crates/new/README.md", readme),
            Source::new("crates/new/examples/a.rs", example),
        ])
    }

    #[test]
    fn a_library_with_all_of_it_keeps_the_rule() {
        assert!(library(MANIFEST, "# new\n\n```rust\nfn main() {}\n```\n", "fn main() {}\n").is_empty());
    }

    #[test]
    fn what_is_missing_stale_or_long_is_a_breach() {
        let readme = "# new\n\n```rust\nfn main() {}\n```\n";
        assert_eq!(library("[package]\nreadme = \"README.md\"\n", readme, "fn main() {}\n").len(), 3);
        assert_eq!(library(MANIFEST, readme, "fn main() { }\n").len(), 1);
        let long = format!("fn main() {{\n{}}}\n", "    ();\n".repeat(MOST));
        assert_eq!(library(MANIFEST, &format!("```rust\n{long}```"), &long).len(), 1);
        assert_eq!(check(&[Source::new("crates/new/Cargo.toml", MANIFEST)]).len(), 1);
    }
}
