//! Allowed dependencies between the crates of the workspace.

use super::{Breach, source::Source};

/// The crates that every other may depend on; they depend on none.
const BELOW_ALL: [&str; 2] = ["units", "numerics"];

/// Crates by folder, and the folders of those that each may depend on.
pub const ARROWS: &[(&str, &[&str])] = &[
    (BELOW_ALL[0], &[]),
    (BELOW_ALL[1], &[]),
    ("judge", &[]),
    ("gears", &["judge"]),
    ("strength", &["gears", "judge"]),
    ("vibration", &[]),
    ("train", &["gears"]),
    ("layout", &["train"]),
    ("schemes", &["train", "gears"]),
    ("selection", &["layout", "schemes", "train", "gears"]),
    ("synthesis", &["layout", "train", "gears"]),
    ("tables", &["synthesis"]),
    ("dynamics", &["train", "schemes", "gears"]),
    ("motion", &["dynamics", "train", "gears"]),
    ("hydromotor", &[]),
    ("formats", &["dynamics", "train", "gears", "hydromotor", "judge"]),
    ("drawing", &[]),
    ("pictures", &["drawing", "layout", "train", "schemes", "gears", "hydromotor", "vibration"]),
    (
        "commands",
        &[
            "pictures",
            "drawing",
            "formats",
            "selection",
            "synthesis",
            "tables",
            "dynamics",
            "motion",
            "layout",
            "schemes",
            "train",
            "strength",
            "vibration",
            "gears",
            "hydromotor",
            "judge",
        ],
    ),
    ("browser", &["commands", "pictures", "drawing", "formats", "layout", "schemes", "train", "gears"]),
    ("calls", &["cli"]),
    ("cli", &["commands", "formats"]),
    ("python", &["cli", "commands", "formats", "train", "gears"]),
    (
        "xtask",
        &[
            "formats",
            "selection",
            "synthesis",
            "motion",
            "dynamics",
            "vibration",
            "strength",
            "layout",
            "schemes",
            "train",
            "gears",
            "hydromotor",
        ],
    ),
];

/// Manifests whose dependencies point the wrong way.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    sources
        .iter()
        .filter_map(|source| Some((folder_of(&source.path)?, source)))
        .flat_map(|(folder, source)| of(folder, source))
        .collect()
}

/// The crate whose manifest a path is.
fn folder_of(path: &str) -> Option<&str> {
    let folder = path.strip_suffix("/Cargo.toml")?;
    let name = folder.strip_prefix("crates/").unwrap_or(folder);
    (!name.contains('/')).then_some(name)
}

fn of(folder: &str, source: &Source) -> Vec<Breach> {
    let Some((_, allowed)) = ARROWS.iter().find(|(name, _)| *name == folder) else {
        let advice = "give it a line in ARROWS of xtask/src/tidy/arrows.rs";
        return vec![Breach::new(&source.path, 1, format!("`{folder}` is a crate without arrows: {advice}"))];
    };
    dependencies(&source.text)
        .into_iter()
        .filter(|(_, on)| !allowed.contains(on) && (is_below_all(folder) || !is_below_all(on)))
        .map(|(line, on)| {
            let may = if allowed.is_empty() { "nothing of ours".to_owned() } else { allowed.join(", ") };
            Breach::new(
                &source.path,
                line,
                format!("`{folder}` stands on `{on}`, it may stand on {may}: move what it needs down, or its user up"),
            )
        })
        .collect()
}

fn is_below_all(folder: &str) -> bool {
    BELOW_ALL.contains(&folder)
}

/// Lines and folders of the workspace's crates among the dependencies of a manifest; those of tests are free.
fn dependencies(manifest: &str) -> Vec<(usize, &str)> {
    let mut within = false;
    let mut found = Vec::new();
    for (number, line) in manifest.lines().enumerate() {
        let line = line.trim();
        if let Some(section) = line.strip_prefix('[') {
            within = section.trim_end_matches(']').ends_with("dependencies")
                && !section.contains("dev-dependencies");
        } else if within {
            let name = line.split(['.', '=', ' ']).next().unwrap_or("");
            found.extend(name.strip_prefix("epicyclic-").map(|name| (number + 1, name)));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arrow_up_is_a_breach_and_one_down_is_none() {
        let manifest =
            "[dependencies]\nepicyclic-gears.workspace = true\nepicyclic-schemes = { workspace = true }\n";
        let breaches = check(&[Source::new("crates/train/Cargo.toml", manifest)]);
        assert_eq!(breaches.len(), 1);
        assert_eq!(breaches[0].line, 3);
    }

    #[test]
    fn tests_may_stand_on_anything_and_a_new_crate_needs_a_line() {
        let manifest =
            "[dependencies]\nuom.workspace = true\n[dev-dependencies]\nepicyclic-schemes.workspace = true\n";
        assert!(check(&[Source::new("crates/gears/Cargo.toml", manifest)]).is_empty());
        assert_eq!(check(&[Source::new("crates/new/Cargo.toml", manifest)]).len(), 1);
    }

    #[test]
    fn the_table_itself_has_no_circle() {
        let mut known: Vec<&str> = Vec::new();
        while known.len() < ARROWS.len() {
            let next = ARROWS
                .iter()
                .find(|(name, on)| !known.contains(name) && on.iter().all(|on| known.contains(on)))
                .expect("a crate that stands on known ones alone");
            known.push(next.0);
        }
    }
}
