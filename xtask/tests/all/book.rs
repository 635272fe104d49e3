//! The book: its chapter on the documents' errors lists all of them, each with the right value, and nothing
//! else; its pages are whole.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;
use xtask::cases::figure::{Figure, Status};
use xtask::cases::tolerance::{Printed, Rounding};
use xtask::verify::{self, Arguments, Format};

const PROMPT: &str = "$ cargo xtask ";

fn figures() -> Vec<Figure> {
    let arguments =
        Arguments { filter: String::new(), format: Format::Human, html: None, accept: false, cases: None };
    verify::outcomes(&arguments).unwrap().into_iter().flat_map(|outcome| outcome.figures).collect()
}

fn chapter(name: &str) -> String {
    fs::read_to_string(xtask::project_root().join("docs/src").join(name)).unwrap()
}

/// The rows of the chapter's tables that begin with the name of a figure: its other cells.
fn rows(chapter: &str) -> BTreeMap<String, Vec<String>> {
    let mut rows = BTreeMap::new();
    for line in chapter.lines() {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let name = cells.get(1).and_then(|cell| cell.strip_prefix('`')?.strip_suffix('`'));
        let Some(name) = name.filter(|name| name.contains('/')) else { continue };
        let others = cells[2..].iter().map(|cell| (*cell).to_owned()).collect();
        assert!(rows.insert(name.to_owned(), others).is_none(), "{name} twice");
    }
    rows
}

/// Whether a cell states the value: a quantity within the last digit that it shows, a word letter by letter.
fn states(cell: &str, computed: &str) -> bool {
    let value = epicyclic_units::parse(computed).map(|measured| measured.si());
    match (Printed::parse(cell, Rounding::Nearest), value) {
        (Ok(shown), Ok(value)) => shown.stands_for(value),
        _ => cell == computed,
    }
}

#[test]
fn every_contradicted_and_lost_figure_is_in_the_book() {
    let (figures, chapter) = (figures(), chapter("findings.md"));
    let mut rows = rows(&chapter);
    for figure in &figures {
        let name = &figure.name;
        match figure.status {
            Status::Contradicted => {
                let row = rows.remove(name).unwrap_or_else(|| panic!("{name} is not in findings.md"));
                let (published, computed) =
                    (figure.published.as_ref().unwrap(), figure.computed.as_ref().unwrap());
                assert_eq!(&row[0], published, "{name}");
                assert!(states(&row[1], computed), "{name}: {} for {computed}", row[1]);
            }
            Status::Unrecoverable => {
                rows.remove(name).unwrap_or_else(|| panic!("{name} is not in findings.md"));
            }
            _ => {}
        }
    }
    assert!(rows.is_empty(), "no longer contradicted: {rows:?}");
}

#[test]
fn figures_in_a_wrong_unit_are_in_the_book() {
    let chapter = chapter("findings.md");
    for figure in figures() {
        if let Some(unit) = &figure.printed_unit {
            let shown = chapter.lines().any(|line| line.contains(&figure.name) && line.contains(unit));
            assert!(shown, "{}: {unit}", figure.name);
        }
    }
}

/// Runs the commands of a document, and of those in a folder; how many.
fn check(path: &Path) -> usize {
    if path.is_dir() {
        return fs::read_dir(path).unwrap().map(|entry| check(&entry.unwrap().path())).sum();
    }
    let document = fs::read_to_string(path).unwrap();
    let mut run = 0;
    for block in document.split("```console\n").skip(1).map(|rest| rest.split("```").next().unwrap()) {
        let Some((command, shown)) = block.strip_prefix(PROMPT).and_then(|block| block.split_once('\n'))
        else {
            continue;
        };
        if command.contains('#') {
            continue;
        }
        let output = Command::new(env!("CARGO_BIN_EXE_xtask"))
            .args(command.split_whitespace())
            .current_dir(xtask::project_root())
            .output()
            .unwrap();
        let printed = String::from_utf8(output.stdout).unwrap();
        // A line of dots stands for what is left out before it, or after it.
        let kept = shown.trim_start_matches("…\n").trim_end_matches("…\n");
        let from = shown.starts_with("…\n") || printed.starts_with(kept);
        let to = shown.ends_with("\n…\n") || printed.ends_with(kept);
        assert!(from && to && printed.contains(kept), "{command}\n{printed}");
        run += 1;
    }
    run
}

#[test]
fn the_commands_of_readme_and_book_print_what_they_show() {
    let root = xtask::project_root();
    assert!(check(&root.join("docs/src")) >= 3);
    assert!(check(&root.join("README.md")) >= 2);
}

/// The book states which crates use insta, proptest, criterion, nalgebra or serde_yaml.
#[test]
fn the_book_says_where_five_crates_of_others_are_used() {
    let root = xtask::project_root();
    let text = fs::read_to_string(root.join("docs/src/reference/crates.md")).unwrap();
    let mut members: Vec<_> =
        fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path()).collect();
    members.push(root.join("xtask"));
    for member in members {
        let manifest = fs::read_to_string(member.join("Cargo.toml")).unwrap();
        let name = member.file_name().unwrap().to_string_lossy().into_owned();
        for used in ["insta", "proptest", "criterion", "nalgebra", "serde_yaml"] {
            if manifest.lines().any(|line| line.starts_with(&format!("{used}."))) {
                let row = text.lines().find(|line| line.starts_with(&format!("| {used} |"))).unwrap();
                assert!(row.contains(&name), "{name} uses {used}");
            }
        }
    }
}

fn book(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_xtask")).arg("book").args(arguments).output().unwrap()
}

/// A book of one chapter, and where its pages are to go.
fn small_book(chapter: &str) -> (TempDir, [String; 4]) {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("docs");
    fs::create_dir_all(source.join("src")).unwrap();
    fs::write(source.join("book.toml"), "[book]\ntitle = \"small\"\n").unwrap();
    fs::write(source.join("src/SUMMARY.md"), "- [A](a.md)\n").unwrap();
    fs::write(source.join("src/a.md"), chapter).unwrap();
    let pages = folder.path().join("pages");
    let arguments = ["--source", source.to_str().unwrap(), "-o", pages.to_str().unwrap()].map(str::to_owned);
    (folder, arguments)
}

#[test]
fn the_book_builds_with_every_formula_and_no_dead_link() {
    let folder = tempfile::tempdir().unwrap();
    let pages = folder.path().join("made/book");
    let output = book(&["-o", pages.to_str().unwrap()]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let page = fs::read_to_string(pages.join("theory/gear-set.html")).unwrap();
    assert!(page.contains("<math display=\"block\"><msub><mi>i</mi><mn>0</mn></msub>"));
    assert!(!page.contains("$$") && !page.contains("\\frac"));
    let verification = fs::read_to_string(pages.join("verification.html")).unwrap();
    assert!(verification.contains("href=\"verification-report.html\""));
    let report = fs::read_to_string(pages.join("verification-report.html")).unwrap();
    assert!(report.contains("motion-of-the-printed-inertia"));
    assert!(
        fs::read_dir(&pages)
            .unwrap()
            .any(|entry| { entry.unwrap().file_name().to_string_lossy().starts_with("searchindex") })
    );
    // An earlier book is replaced; nothing else is left beside it.
    assert!(book(&["--output", pages.to_str().unwrap()]).status.success());
    assert_eq!(fs::read_dir(folder.path().join("made")).unwrap().count(), 1);
}

#[test]
fn a_book_with_a_fault_is_not_written() {
    for (chapter, said) in [
        ("A formula\n\n$$\n\\omgea\n$$\n", "a.md:3: "),
        ("$\\frac{1}{$\n", "a.md:1: a dollar that begins no formula"),
        ("[b](b.md)\n", "b.html does not exist"),
        ("[b](#b)\n", "#b is no place of that page"),
    ] {
        let (folder, arguments) = small_book(chapter);
        let output = book(&arguments.each_ref().map(String::as_str));
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && error.contains(said), "{chapter}: {error}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "{chapter}");
    }
}

#[test]
fn a_folder_of_other_things_is_not_replaced() {
    let (folder, arguments) = small_book("# A\n");
    let pages = folder.path().join("pages");
    fs::create_dir(&pages).unwrap();
    fs::write(pages.join("thesis.tex"), "mine").unwrap();
    let output = book(&arguments.each_ref().map(String::as_str));
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("holds other things than a book"));
    assert_eq!(fs::read_to_string(pages.join("thesis.tex")).unwrap(), "mine");
    fs::remove_file(pages.join("thesis.tex")).unwrap();
    assert!(book(&arguments.each_ref().map(String::as_str)).status.success());
    assert!(pages.join("a.html").is_file());
}

/// Verbs by which a sentence quotes the document itself, so that its numbers must be those of the document.
const SAYS: [&str; 10] =
    ["draws", "prints", "gives", "has", "calls", "says", "recommends", "sets", "names", "takes"];

/// Words after which a sentence goes on with what we say against it.
const AGAINST: [&str; 4] = [", which", " in place of ", " but ", ";"];

/// The sources by what a sentence calls them at its beginning.
fn named(sentence: &str) -> Option<&'static [&'static str]> {
    let sources: [(&str, &[&str]); 4] = [
        ("Excavator-dynamics ", &["excavator-dynamics"]),
        ("Multispeed-gearboxes ", &["multispeed-gearboxes"]),
        ("Rotary-hydromotor ", &["rotary-hydromotor"]),
        ("The document ", &["excavator-dynamics", "multispeed-gearboxes", "rotary-hydromotor"]),
    ];
    sources.into_iter().find_map(|(name, sources)| {
        let verb = sentence.strip_prefix(name)?.split([' ', ',']).next()?;
        SAYS.contains(&verb).then_some(sources)
    })
}

/// Numbers of a sentence, without those of its formulas, code and references.
fn numbers(sentence: &str) -> Vec<f64> {
    let outside =
        |text: &str, mark: char| -> String { text.split(mark).step_by(2).collect::<Vec<_>>().join(" ") };
    let text = outside(&outside(sentence, '`'), '$');
    let words = text.split(|c: char| !(c.is_alphanumeric() || "().-…".contains(c)));
    let plain = words.filter(|word| !word.contains(['(', ')', '…']));
    plain.filter_map(|word| word.trim_end_matches('.').parse().ok()).collect()
}

#[test]
fn what_the_book_says_that_a_document_has_stands_in_its_cases() {
    let figures = figures();
    let printed = |source: &str, number: f64| {
        figures.iter().any(|figure| {
            figure.file.contains(&format!("spec-cases/{source}/"))
                && figure.status != Status::Reconstructed
                && figure.published.as_ref().is_some_and(|published| numbers(published).contains(&number))
        })
    };
    let mut said = 0;
    let pages = ["", "theory", "tutorials"].map(|folder| xtask::project_root().join("docs/src").join(folder));
    for page in pages.iter().flat_map(|folder| fs::read_dir(folder).unwrap()) {
        let page = page.unwrap().path();
        if page.extension().is_none_or(|end| end != "md") {
            continue;
        }
        let text = fs::read_to_string(&page).unwrap();
        let paragraphs: Vec<String> = text.split("\n\n").map(|lines| lines.replace('\n', " ")).collect();
        for sentence in paragraphs.iter().flat_map(|paragraph| paragraph.split(". ")).map(str::trim) {
            let Some(sources) = named(sentence) else { continue };
            said += 1;
            // Corrections after these words are not numbers of the document.
            let own = AGAINST.iter().filter_map(|word| sentence.find(word)).min().unwrap_or(sentence.len());
            for number in numbers(&sentence[..own]) {
                let known = sources.iter().any(|source| printed(source, number));
                assert!(known, "{}: no document prints the {number} of: {sentence}", page.display());
            }
        }
    }
    assert!(said > 5, "{said}");
}

#[test]
fn numbers_of_a_sentence_are_those_of_its_words() {
    assert_eq!(
        numbers("Rotary-hydromotor draws 5 lobes and 3×5, (2) and `9`, $8$, 0.5 mm."),
        [5.0, 3.0, 5.0, 0.5]
    );
    assert!(named("Rotary-hydromotor draws a motor with 55 teeth").is_some());
    assert!(named("The document that draws").is_none());
}
