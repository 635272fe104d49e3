//! A file as the rules see it: its text, and its code without comments, strings and tests.

use std::path::Path;
use std::{fs, ops::Range};

/// A file of the project.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Path from the project's root, with `/`.
    pub path: String,
    /// Text of the file.
    pub text: String,
    /// Rust code with blanks for comments, the contents of strings, and items under `#[cfg(test)]`; every
    /// byte keeps its place. Empty for other files.
    pub code: String,
    /// Modules in other files that are declared under `#[cfg(test)]`.
    pub test_modules: Vec<String>,
    /// How many lines belong to items under `#[cfg(test)]`.
    pub test_lines: usize,
}

/// Folders and files that are read.
const ROOTS: [&str; 8] = [
    "crates",
    "xtask/src",
    "xtask/Cargo.toml",
    "docs/src",
    "examples",
    "README.md",
    "ARCHITECTURE.md",
    "CHANGELOG.md",
];

/// Endings of the files that a rule can read.
const ENDINGS: [&str; 4] = [".rs", ".md", ".toml", ".yaml"];

impl Source {
    /// Source from path and text.
    #[must_use]
    pub fn new(path: &str, text: &str) -> Self {
        let mut source = Self {
            path: path.to_owned(),
            text: text.to_owned(),
            code: String::new(),
            test_modules: Vec::new(),
            test_lines: 0,
        };
        if path.ends_with(".rs") {
            // Comments go first, because braces in them would end a test item too early or too late.
            let mut code = without_comments(text);
            for item in test_items(&code) {
                source.test_lines += code[item.clone()].matches('\n').count() + 1;
                source.test_modules.extend(declared(&text[item.clone()]));
                let blank = blanked(&code[item.clone()]);
                code.replace_range(item, &blank);
            }
            source.code = code;
        }
        source
    }

    /// The crate's folder (`gears`, `xtask`) and the path within its `src`, for a file there.
    #[must_use]
    pub fn in_crate(&self) -> Option<(&str, &str)> {
        let (folder, inner) = self.path.split_once("/src/")?;
        (self.path.ends_with(".rs") && (folder == "xtask" || folder.starts_with("crates/")))
            .then(|| (folder.trim_start_matches("crates/"), inner))
    }

    /// Whether this is a library's own code: of a crate other than the program and `xtask`.
    #[must_use]
    pub fn is_library(&self) -> bool {
        self.in_crate().is_some_and(|(name, _)| !matches!(name, "cli" | "python" | "xtask"))
    }

    /// The line, from 1, of a byte of the text.
    #[must_use]
    pub fn line_of(&self, byte: usize) -> usize {
        self.text[..byte].matches('\n').count() + 1
    }

    /// How many lines the file has without its tests.
    #[must_use]
    pub fn length(&self) -> usize {
        self.text.lines().count().saturating_sub(self.test_lines)
    }
}

/// Every file that a rule reads; of Rust files those that are not tests of another.
///
/// # Errors
/// The file that cannot be read.
pub fn of_project(root: &Path) -> Result<Vec<Source>, String> {
    let mut sources = Vec::new();
    for start in ROOTS {
        read(root, &root.join(start), &mut sources)?;
    }
    sources.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(without_test_files(sources))
}

fn read(root: &Path, path: &Path, into: &mut Vec<Source>) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("{}: {error}", path.display());
    if path.is_dir() {
        for entry in fs::read_dir(path).map_err(failed)? {
            let entry = entry.map_err(failed)?.path();
            if entry.file_name().is_none_or(|name| name != "target" && name != "snapshots") {
                read(root, &entry, into)?;
            }
        }
    } else if path.is_file() && ENDINGS.iter().any(|end| path.to_string_lossy().ends_with(end)) {
        let name = path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
        into.push(Source::new(&name, &fs::read_to_string(path).map_err(failed)?));
    }
    Ok(())
}

/// Leaves out the files of modules that are declared under `#[cfg(test)]`.
fn without_test_files(sources: Vec<Source>) -> Vec<Source> {
    let tests: Vec<String> = sources
        .iter()
        .flat_map(|source| {
            let folder = source.path.rsplit_once('/').map_or("", |(folder, _)| folder);
            let stem = source.path.trim_end_matches(".rs");
            source.test_modules.iter().flat_map(move |name| {
                [
                    format!("{folder}/{name}.rs"),
                    format!("{stem}/{name}.rs"),
                    format!("{folder}/{name}/mod.rs"),
                ]
            })
        })
        .collect();
    sources.into_iter().filter(|source| !tests.contains(&source.path)).collect()
}

/// The module that an item under `#[cfg(test)]` declares in another file, by its name or that of its file.
fn declared(item: &str) -> Option<String> {
    let (attributes, name) = item.strip_suffix(';')?.rsplit_once("mod ")?;
    let path = attributes.split_once("#[path = \"").and_then(|(_, path)| path.split_once(".rs\""));
    Some(path.map_or(name.trim(), |(path, _)| path).to_owned())
}

/// Bytes of a text replaced by blanks, except the ends of lines.
fn blanked(text: &str) -> String {
    text.bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }).collect()
}

/// Rust with blanks for comments and the contents of strings.
fn without_comments(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut code = String::with_capacity(text.len());
    let mut at = 0;
    while at < bytes.len() {
        let rest = &text[at..];
        let skip = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            block_comment(rest)
        } else if let Some(length) = string(rest, bytes[..at].last().copied()) {
            length
        } else if let Some(length) = character(rest) {
            length
        } else {
            let whole = rest.chars().next().map_or(1, char::len_utf8);
            code.push_str(&rest[..whole]);
            at += whole;
            continue;
        };
        code.push_str(&blanked(&rest[..skip]));
        at += skip;
    }
    code
}

fn block_comment(rest: &str) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while at < rest.len() {
        let here = &rest.as_bytes()[at..];
        if here.starts_with(b"/*") {
            (depth, at) = (depth + 1, at + 2);
        } else if here.starts_with(b"*/") {
            (depth, at) = (depth - 1, at + 2);
            if depth == 0 {
                return at;
            }
        } else {
            at += 1;
        }
    }
    rest.len()
}

/// Length of the string literal that begins here, with its quotes.
fn string(rest: &str, before: Option<u8>) -> Option<usize> {
    // A name that ends with `r` or `b` before a quote does not begin a raw or byte string.
    let in_word = before.is_some_and(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    let open = rest.strip_prefix('b').filter(|_| !in_word).unwrap_or(rest);
    if let Some(raw) = open.strip_prefix('r').filter(|_| !in_word) {
        let hashes = raw.bytes().take_while(|byte| *byte == b'#').count();
        let body = raw[hashes..].strip_prefix('"')?;
        let close = format!("\"{}", "#".repeat(hashes));
        let end = body.find(&close).map_or(body.len(), |end| end + close.len());
        return Some(rest.len() - body.len() + end);
    }
    let body = open.strip_prefix('"')?;
    let mut escaped = false;
    for (at, byte) in body.bytes().enumerate() {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'"' => return Some(rest.len() - body.len() + at + 1),
            _ => {}
        }
    }
    Some(rest.len())
}

/// Length of the character literal that begins here; a lifetime is none.
fn character(rest: &str) -> Option<usize> {
    let body = rest.strip_prefix('\'')?;
    let first = body.chars().next()?;
    if first == '\\' {
        return body[2..].find('\'').map(|end| end + 4);
    }
    body[first.len_utf8()..].starts_with('\'').then(|| first.len_utf8() + 2)
}

/// Ranges of items under `#[cfg(test)]`, attribute and body.
fn test_items(code: &str) -> Vec<Range<usize>> {
    let mut items = Vec::new();
    let mut from = 0;
    while let Some(found) = code[from..].find("#[cfg(test)]") {
        let start = from + found;
        let mut depth = 0_usize;
        let mut end = code.len();
        for (at, byte) in code[start..].bytes().enumerate() {
            match byte {
                b'{' => depth += 1,
                b'}' => {
                    depth = depth.saturating_sub(1);
                    if depth == 0 {
                        end = start + at + 1;
                        break;
                    }
                }
                b';' if depth == 0 => {
                    end = start + at + 1;
                    break;
                }
                _ => {}
            }
        }
        items.push(start..end);
        from = end;
    }
    items
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_strings_and_tests_are_blank_and_lines_stay() {
        let text = "fn a() { let s = \"dbg!()\"; } // dbg!()\n/* dbg!() /* in */ */\n#[cfg(test)]\nmod tests {\n    fn b() { dbg!() }\n}\nfn c() {}\n";
        let source = Source::new("crates/gears/src/a.rs", text);
        assert!(!source.code.contains("dbg!"), "{}", source.code);
        assert_eq!(source.code.matches('\n').count(), text.matches('\n').count());
        assert!(source.code.ends_with("fn c() {}\n"));
        assert_eq!(source.test_lines, 4);
        assert_eq!(source.length(), 3);
    }

    #[test]
    fn a_lifetime_opens_no_character_and_a_raw_string_ends_at_its_hashes() {
        let source =
            Source::new("a.rs", "fn a<'a>(x: &'a str) -> char { '\\'' } r#\"\"//\"#; let y = '\"'; 'b'");
        assert!(source.code.starts_with("fn a<'a>(x: &'a str) -> char {"));
        assert!(source.code.contains("; let y ="), "{}", source.code);
    }

    #[test]
    fn a_file_of_tests_is_left_out() {
        let sources = vec![
            Source::new("crates/gears/src/a.rs", "#[cfg(test)]\nmod tests;\n"),
            Source::new("crates/gears/src/b.rs", "#[cfg(test)]\n#[path = \"b_tests.rs\"]\nmod tests;\n"),
            Source::new("crates/gears/src/b_tests.rs", "fn b() { dbg!() }"),
            Source::new("crates/gears/src/a/tests.rs", "fn b() { dbg!() }"),
        ];
        let left: Vec<String> = without_test_files(sources).into_iter().map(|source| source.path).collect();
        assert_eq!(left, ["crates/gears/src/a.rs", "crates/gears/src/b.rs"]);
    }
}
