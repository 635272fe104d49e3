//! No circle of files within a crate: of two files at most one names the other.
//!
//! An arrow is a path through `crate`, `self`, `super` or a module of one's own. It points to the file that
//! defines the name, not to one that passes it on: `use` of a name is followed. A module may name what its
//! parents define, since it is a part of theirs with a file of its own; and a `pub use` of one's own modules
//! is a table of contents.

use super::{Breach, source::Source};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// How often a name is passed on at most.
const DEEPEST: usize = 8;

/// Circles of every crate.
#[must_use]
pub fn check(sources: &[Source]) -> Vec<Breach> {
    let mut crates: BTreeMap<&str, Vec<File>> = BTreeMap::new();
    for source in sources {
        if let Some((name, inner)) = source.in_crate() {
            crates.entry(name).or_default().push(File::new(source, inner));
        }
    }
    crates.values().flat_map(|files| of(files)).collect()
}

/// A file as a module.
struct File<'a> {
    source: &'a Source,
    inner: &'a str,
    module: Vec<&'a str>,
    paths: Vec<Reference<'a>>,
}

/// A path in the code.
struct Reference<'a> {
    line: usize,
    /// From the crate's root.
    target: Vec<&'a str>,
    /// The name under which a `use` brings it in, `*` for all.
    alias: Option<&'a str>,
    /// A `pub use` of one's own modules.
    is_contents: bool,
}

impl<'a> File<'a> {
    fn new(source: &'a Source, inner: &'a str) -> Self {
        let mut module: Vec<&str> = inner.trim_end_matches(".rs").split('/').collect();
        if matches!(module.last(), Some(&("mod" | "lib" | "main"))) {
            module.pop();
        }
        let tokens = tokens(&source.code);
        let declares = |at: usize| {
            (tokens[at].1 == "mod" && tokens.get(at + 2).is_some_and(|(_, end)| *end == ";"))
                .then(|| tokens[at + 1].1)
        };
        let children: Vec<&str> = (0..tokens.len()).filter_map(declares).collect();
        let paths = references(source, &tokens, &module, &children);
        Self { source, inner, module, paths }
    }
}

/// Names, `::` and signs of the code, with their places.
fn tokens(code: &str) -> Vec<(usize, &str)> {
    let bytes = code.as_bytes();
    let is_name = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || !byte.is_ascii();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let length = if is_name(bytes[at]) {
            bytes[at..].iter().take_while(|byte| is_name(**byte)).count()
        } else if bytes[at..].starts_with(b"::") {
            2
        } else {
            1
        };
        if !bytes[at].is_ascii_whitespace() {
            found.push((at, &code[at..at + length]));
        }
        at += length;
    }
    found
}

fn references<'a>(
    source: &Source,
    tokens: &[(usize, &'a str)],
    module: &[&'a str],
    children: &[&'a str],
) -> Vec<Reference<'a>> {
    let text = |at: usize| tokens.get(at).map_or("", |(_, text)| *text);
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let is_use = text(at) == "use";
        let is_public = is_use && at > 0 && matches!(text(at - 1), "pub" | ")");
        let start = at + usize::from(is_use);
        let follows_path = !is_use && at > 0 && matches!(text(at - 1), "::" | ".");
        let opens_path = text(start + 1) == "::"
            && (matches!(text(start), "crate" | "self" | "super") || children.contains(&text(start)));
        if follows_path || !opens_path {
            at += 1;
            continue;
        }
        let mut leaves = Vec::new();
        let mut next = start;
        tree(tokens, &mut next, &mut Vec::new(), is_use, &mut leaves);
        for (path, alias) in leaves {
            let Some(target) = absolute(&path, module) else { continue };
            let own = target.len() > module.len() && target.starts_with(module);
            found.push(Reference {
                line: source.line_of(tokens[at].0),
                is_contents: is_public && own && children.contains(&target[module.len()]),
                target,
                alias: is_use.then_some(alias),
            });
        }
        at = next.max(at + 1);
    }
    found
}

/// Reads a tree of a `use`, or a plain path, from `at` on.
fn tree<'a>(
    tokens: &[(usize, &'a str)],
    at: &mut usize,
    prefix: &mut Vec<&'a str>,
    is_use: bool,
    leaves: &mut Vec<(Vec<&'a str>, &'a str)>,
) {
    let text = |at: usize| tokens.get(at).map_or("", |(_, text)| *text);
    let depth = prefix.len();
    loop {
        match text(*at) {
            "{" if is_use => {
                *at += 1;
                while !matches!(text(*at), "}" | "") {
                    tree(tokens, at, prefix, is_use, leaves);
                    if text(*at) == "," {
                        *at += 1;
                    }
                }
                *at += 1;
                break;
            }
            name => {
                prefix.push(name);
                *at += 1;
                let goes_on = text(*at + 1).starts_with(|c: char| c.is_alphanumeric() || c == '_')
                    || (is_use && matches!(text(*at + 1), "{" | "*"));
                if text(*at) == "::" && goes_on {
                    *at += 1;
                    continue;
                }
                let mut alias = name;
                if is_use && text(*at) == "as" {
                    alias = text(*at + 1);
                    *at += 2;
                }
                if name == "self" && prefix.len() > 1 {
                    let path = prefix[..prefix.len() - 1].to_vec();
                    let own = if alias == "self" { path.last().copied().unwrap_or("") } else { alias };
                    leaves.push((path, own));
                } else {
                    leaves.push((prefix.clone(), alias));
                }
                break;
            }
        }
    }
    prefix.truncate(depth);
}

/// A path from the crate's root.
fn absolute<'a>(path: &[&'a str], module: &[&'a str]) -> Option<Vec<&'a str>> {
    let (mut base, mut rest): (Vec<&str>, &[&str]) = match *path.first()? {
        "crate" => (Vec::new(), &path[1..]),
        "self" => (module.to_vec(), &path[1..]),
        "super" => (module.to_vec(), path),
        _ => (module.to_vec(), path),
    };
    while rest.first() == Some(&"super") {
        base.pop()?;
        rest = &rest[1..];
    }
    base.extend(rest);
    Some(base)
}

/// The file that defines what a path names, `depth` names passed on.
fn defined(files: &[File], target: &[&str], depth: usize) -> Option<usize> {
    let (at, file) = files
        .iter()
        .enumerate()
        .filter(|(_, file)| file.inner != "main.rs" && target.starts_with(&file.module))
        .max_by_key(|(_, file)| file.module.len())?;
    let rest = &target[file.module.len()..];
    let Some(name) = rest.first().filter(|_| depth < DEEPEST) else { return Some(at) };
    let passes_on = |path: &&Reference| path.alias == Some(*name) && path.target != target;
    match file.paths.iter().find(passes_on) {
        Some(path) => {
            let mut onward = path.target.clone();
            onward.extend(&rest[1..]);
            defined(files, &onward, depth + 1)
        }
        None => Some(at),
    }
}

/// The circles of a crate.
fn of(files: &[File]) -> Vec<Breach> {
    // Of each file: the files that it names, and the line.
    let arrows: Vec<BTreeMap<usize, usize>> = files
        .iter()
        .enumerate()
        .map(|(at, file)| {
            let mut arrows = BTreeMap::new();
            for path in file.paths.iter().filter(|path| !path.is_contents) {
                let is_other = |to: &usize| *to != at && !file.module.starts_with(&files[*to].module);
                if let Some(to) = defined(files, &path.target, 0).filter(is_other) {
                    arrows.entry(to).or_insert(path.line);
                }
            }
            arrows
        })
        .collect();
    let reach: Vec<BTreeSet<usize>> = (0..files.len()).map(|from| reached(&arrows, from)).collect();
    let mut breaches = Vec::new();
    let mut done: BTreeSet<usize> = BTreeSet::new();
    for at in 0..files.len() {
        if !reach[at].contains(&at) || done.contains(&at) {
            continue;
        }
        let circle: Vec<usize> = reach[at].iter().copied().filter(|to| reach[*to].contains(&at)).collect();
        done.extend(&circle);
        let names: Vec<&str> = circle.iter().map(|at| files[*at].inner).collect();
        let way = shortest(&arrows, &circle);
        let steps: Vec<String> =
            way.iter().map(|(from, line)| format!("{}:{line}", files[*from].inner)).collect();
        let (first, line) = way[0];
        let message = format!(
            "a circle of {} files, {} and back: move what they share into a lower file",
            names.len(),
            steps.join(" → ")
        );
        breaches.push(Breach::new(&files[first].source.path, line, message));
    }
    breaches
}

/// The shortest way round within a circle: files, and the line at which each names the next.
fn shortest(arrows: &[BTreeMap<usize, usize>], circle: &[usize]) -> Vec<(usize, usize)> {
    let mut ways: VecDeque<Vec<usize>> = circle.iter().map(|at| vec![*at]).collect();
    while let Some(way) = ways.pop_front() {
        let last = way[way.len() - 1];
        for next in arrows[last].keys().filter(|next| circle.contains(next)) {
            if *next == way[0] {
                let round = way.iter().skip(1).chain([next]);
                return way.iter().zip(round).map(|(from, to)| (*from, arrows[*from][to])).collect();
            }
            if !way.contains(next) {
                ways.push_back([&way[..], &[*next]].concat());
            }
        }
    }
    Vec::new()
}

/// Every file on a way from a file; itself where it is on a circle.
fn reached(arrows: &[BTreeMap<usize, usize>], from: usize) -> BTreeSet<usize> {
    let mut found = BTreeSet::new();
    let mut open: Vec<usize> = arrows[from].keys().copied().collect();
    while let Some(at) = open.pop() {
        if found.insert(at) {
            open.extend(arrows[at].keys());
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn breaches(files: &[(&str, &str)]) -> Vec<Breach> {
        let sources: Vec<Source> =
            files.iter().map(|(path, text)| Source::new(&format!("crates/new/src/{path}"), text)).collect();
        check(&sources)
    }

    #[test]
    fn two_files_that_name_each_other_are_a_breach_with_both_lines() {
        let found = breaches(&[
            ("lib.rs", "mod a;\nmod b;\npub use a::A;\n"),
            ("a.rs", "use crate::b::{self, B};\npub struct A(B);\n"),
            ("b.rs", "pub struct B;\n\nfn f(_: crate::A) {}\n"),
        ]);
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].path.as_str(), found[0].line), ("crates/new/src/a.rs", 1));
        assert!(found[0].message.contains("a.rs:1 → b.rs:3 and back"), "{}", found[0]);
    }

    #[test]
    fn a_part_may_name_its_whole_but_not_a_file_that_names_the_whole() {
        let whole = ("a.rs", "mod b;\npub struct C;\nfn f(_: b::B) {}\n");
        assert!(breaches(&[whole, ("a/b.rs", "use super::C;\npub struct B(C);\n")]).is_empty());
        let other = ("c.rs", "pub struct D(crate::a::C);\n");
        assert_eq!(breaches(&[whole, ("a/b.rs", "pub struct B(crate::c::D);\n"), other]).len(), 1);
    }

    #[test]
    fn a_name_passed_on_points_to_where_it_is_defined() {
        assert!(
            breaches(&[
                ("a/mod.rs", "mod b;\nmod c;\npub use self::c::C;\nuse self::b::B;\nfn f(_: B) {}\n"),
                ("a/b.rs", "use super::C;\npub struct B(C);\n"),
                ("a/c.rs", "pub struct C;\n"),
            ])
            .is_empty()
        );
    }

    #[test]
    fn tests_may_name_anything() {
        assert!(
            breaches(&[
                ("a.rs", "use crate::b::B;\npub struct A(B);\n"),
                ("b.rs", "pub struct B;\n#[cfg(test)]\nmod tests {\n    use crate::a::A;\n}\n"),
            ])
            .is_empty()
        );
    }
}
