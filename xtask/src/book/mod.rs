//! `cargo xtask book`: the book as web pages, which need no network and no program but a browser.
//!
//! | module | holds |
//! |---|---|
//! | [`formulas`] | formulas in a chapter, `$…$` and `$$…$$`, as MathML |
//! | [`symbols`] | the symbols of a formula |
//! | [`keys`] | keys of the answers in JSON, from the schemas of the program |
//! | [`links`] | links of the finished pages: none leads nowhere |

pub mod formulas;
pub mod keys;
pub mod links;
pub mod symbols;

use crate::{project_root, report, verify};
use clap::Args;
use formulas::Typesetter;
use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Build the book as web pages.
///
/// Exit code 0, or 2 if a formula cannot be set or a link leads nowhere; then nothing is written.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  cargo xtask book -o target/book")]
pub struct Arguments {
    /// Folder of the pages: a new or empty one, or that of an earlier book, which is replaced.
    #[arg(short, long, value_name = "FOLDER", default_value = "target/book")]
    pub output: PathBuf,
    /// Folder of the book's source, with `book.toml`.
    #[arg(long, value_name = "FOLDER", help = "Folder of the book's source [default: docs]")]
    pub source: Option<PathBuf>,
}

/// Page that every book of ours has, by which its folder is recognized.
const SIGN: &str = "toc.html";

/// Place in a chapter where the report of `verify` is linked, which then becomes a page of the book.
const REPORT_HERE: &str = "<!-- cargo xtask book links the report of verify here -->";
/// Where a chapter lists the keys of all answers.
const KEYS_HERE: &str = "<!-- cargo xtask book lists the keys of every answer here -->";
const REPORT: &str = "verification-report.html";

/// Runs the command.
///
/// # Errors
/// A message if a formula cannot be typeset, a link leads nowhere, or the folder is not that of a book.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let source = arguments.source.clone().unwrap_or_else(|| project_root().join("docs"));
    let output = std::path::absolute(&arguments.output).map_err(|error| error.to_string())?;
    if output.exists() && !replaceable(&output) {
        return Err(format!(
            "{}: holds other things than a book; name a new or empty folder",
            arguments.output.display()
        ));
    }
    let said = |error: std::io::Error| format!("{}: {error}", arguments.output.display());
    let parent = output.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(parent).map_err(said)?;
    // A temporary folder next to the target allows a renaming in one step.
    let workshop = tempfile::tempdir_in(parent).map_err(said)?;
    let pages = workshop.path().join("book");
    let chapters = build(&source, &pages)?;
    let dead = links::dead(&pages).map_err(said)?;
    if !dead.is_empty() {
        return Err(format!("links that lead nowhere:\n  {}", dead.join("\n  ")));
    }
    if output.exists() {
        fs::rename(&output, workshop.path().join("replaced")).map_err(said)?;
    }
    fs::rename(&pages, &output).map_err(said)?;
    println!("{}: {chapters} chapters, from index.html on", arguments.output.display());
    Ok(ExitCode::SUCCESS)
}

/// Whether a folder is empty or an earlier book.
fn replaceable(folder: &Path) -> bool {
    let is_empty = fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_none());
    is_empty || folder.join(SIGN).is_file()
}

/// Writes the pages of a book into a folder; returns the number of chapters.
///
/// # Errors
/// The message of mdBook, or all formulas that cannot be typeset, with chapter and line.
pub fn build(source: &Path, pages: &Path) -> Result<usize, String> {
    let said = |error: mdbook_driver::errors::Error| format!("{}: {error:#}", source.display());
    let mut config = Config::from_disk(source.join("book.toml")).map_err(said)?;
    config.build.build_dir = pages.to_owned();
    let mut book = MDBook::load_with_config(source, config).map_err(said)?;
    let typesetter = Typesetter::default();
    let mut lists_keys = false;
    book.book.for_each_chapter_mut(|chapter| lists_keys |= chapter.content.contains(KEYS_HERE));
    // The program prints its fifty schemas for them.
    let keys = if lists_keys { keys::tables()? } else { String::new() };
    let (mut chapters, mut has_report, mut faults) = (0, false, Vec::new());
    book.book.for_each_chapter_mut(|chapter| {
        chapters += 1;
        if chapter.content.contains(REPORT_HERE) {
            has_report = true;
            let link = format!("[Every figure of every source with its verdict]({REPORT})");
            chapter.content = chapter.content.replace(REPORT_HERE, &link);
        }
        chapter.content = chapter.content.replace(KEYS_HERE, &keys);
        match typesetter.chapter(&chapter.content) {
            Ok(content) => chapter.content = content,
            Err(wrong) => {
                let path = chapter.source_path.as_deref().unwrap_or(Path::new(&chapter.name));
                faults.extend(wrong.iter().map(|fault| format!("{}:{fault}", path.display())));
            }
        }
    });
    if !faults.is_empty() {
        return Err(format!("formulas that cannot be set:\n  {}", faults.join("\n  ")));
    }
    book.build().map_err(said)?;
    if has_report {
        let page = report::html::render(&verify::outcomes(&verify::Arguments::default())?);
        fs::write(pages.join(REPORT), page).map_err(|error| format!("{REPORT}: {error}"))?;
    }
    Ok(chapters)
}
