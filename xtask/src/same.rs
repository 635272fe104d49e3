//! `cargo xtask same`: what two programs answer to the same command lines, compared byte for byte.

use crate::project_root;
use clap::Args;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// Compare what two programs answer, byte for byte.
///
/// Runs every command of the book, every help, and every example file through every command that reads files, as
/// text, JSON and CSV, with the program of an earlier revision and with this one's: exit codes, what is printed, and
/// files that are written. Exit code 0 if all are the same, 1 if not; then the differences lie in the folder.
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  git worktree add /tmp/old v0.1.0\n  cargo build --manifest-path /tmp/old/Cargo.toml -p epicyclic\n  \
                  cargo xtask same /tmp/old/target/debug/epicyclic"
)]
pub struct Arguments {
    /// The program of the earlier revision.
    pub old: PathBuf,
    /// This revision's.
    #[arg(default_value = "target/debug/epicyclic")]
    pub new: PathBuf,
    /// Folder of the differences, which is replaced.
    #[arg(short, long, value_name = "FOLDER", default_value = "target/same")]
    pub output: PathBuf,
}

const PROMPT: &str = "$ cargo run -q -p epicyclic -- ";
const READERS: [&str; 10] =
    ["analyze", "drive", "losses", "motor", "report", "sheet", "simulate", "size", "strength", "vibrate"];

/// Command lines that are run one after the other in one folder.
struct Session {
    name: String,
    lines: Vec<String>,
}

/// All that a command line leaves behind.
#[derive(PartialEq)]
struct Outcome {
    code: Option<i32>,
    printed: Vec<u8>,
    messages: Vec<u8>,
    files: BTreeMap<PathBuf, Vec<u8>>,
}

/// Runs the command.
///
/// # Errors
/// A message for a program that cannot be run, and for folders that cannot be read or written.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let [old, new] = [&arguments.old, &arguments.new].map(|path| {
        path.canonicalize().map_err(|error| format!("{}: {error}; build it first", path.display()))
    });
    let programs = [old?, new?];
    if arguments.output.exists() {
        fs::remove_dir_all(&arguments.output).map_err(|error| at(&arguments.output, &error))?;
    }
    let (mut all, mut unlike) = (0, 0);
    for session in sessions(&programs[1])? {
        let folders = [bench()?, bench()?];
        for (place, line) in session.lines.iter().enumerate() {
            all += 1;
            let [old, new] = [0, 1].map(|of| outcome(&programs[of], folders[of].path(), line));
            let (old, new) = (old?, new?);
            if old != new {
                unlike += 1;
                println!("{line}\n    {}", difference(&old, &new));
                for (which, outcome) in [("old", &old), ("new", &new)] {
                    write(
                        &arguments.output.join(format!("{}-{place}.{which}", session.name)),
                        line,
                        outcome,
                    )?;
                }
            }
        }
    }
    println!("{all} command lines: {unlike} answered otherwise");
    Ok(if unlike == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn at(path: &Path, error: &std::io::Error) -> String {
    format!("{}: {error}", path.display())
}

/// A folder with the project's examples.
fn bench() -> Result<tempfile::TempDir, String> {
    let folder = tempfile::tempdir().map_err(|error| format!("a temporary folder: {error}"))?;
    let examples = folder.path().join("examples");
    fs::create_dir(&examples).map_err(|error| at(&examples, &error))?;
    for path in files(&project_root().join("examples"))? {
        let to = examples.join(path.file_name().unwrap_or_default());
        fs::copy(&path, &to).map_err(|error| at(&to, &error))?;
    }
    Ok(folder)
}

/// The files of a folder, by name.
fn files(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let entries = fs::read_dir(folder).map_err(|error| at(folder, &error))?;
    let mut found: Vec<PathBuf> =
        entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file()).collect();
    found.sort();
    Ok(found)
}

fn sessions(program: &Path) -> Result<Vec<Session>, String> {
    let mut found = vec![Session { name: "help".to_owned(), lines: helps(program, "")? }];
    let chapters =
        ["docs/src", "docs/src/reference", "docs/src/tutorials"].map(|folder| project_root().join(folder));
    for folder in chapters.iter().filter(|folder| folder.is_dir()) {
        for path in files(folder)?
            .into_iter()
            .chain((folder == &chapters[0]).then(|| project_root().join("README.md")))
        {
            let text = fs::read_to_string(&path).map_err(|error| at(&path, &error))?;
            let lines = text
                .lines()
                .filter_map(|line| line.strip_prefix(PROMPT))
                .filter(|line| !line.starts_with("serve"))
                .flat_map(forms)
                .collect();
            let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            found.push(Session { name: stem, lines });
        }
    }
    for path in files(&project_root().join("examples"))? {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let lines = READERS.iter().flat_map(|command| forms(&format!("{command} examples/{name}"))).collect();
        found.push(Session { name, lines });
    }
    Ok(found)
}

/// A command line for every kind of answer, where it asks for none itself.
fn forms(line: &str) -> Vec<String> {
    if ["--format", " -o", "--output", " > ", "|", "--help"].iter().any(|part| line.contains(part)) {
        return vec![line.to_owned()];
    }
    ["", " --format json", " --format csv"].map(|format| format!("{line}{format}")).to_vec()
}

/// The help of a command and of those below it.
fn helps(program: &Path, command: &str) -> Result<Vec<String>, String> {
    let line = format!("{command} --help");
    let help = outcome(program, Path::new("."), &line)?;
    let text = String::from_utf8_lossy(&help.printed).into_owned();
    let mut lines = vec![line];
    let below =
        text.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    // Lines further in go on with the words of the one above.
    let names = below
        .filter(|line| line.len() > 2 && !line[2..].starts_with(' '))
        .filter_map(|line| line.split_whitespace().next());
    for name in names.filter(|name| *name != "help") {
        lines.extend(helps(program, &format!("{command} {name}"))?);
    }
    Ok(lines)
}

fn outcome(program: &Path, folder: &Path, line: &str) -> Result<Outcome, String> {
    let output = Command::new("sh")
        .args(["-c", &format!("\"$EPICYCLIC\" {line}")])
        .env("EPICYCLIC", program)
        .current_dir(folder)
        .output()
        .map_err(|error| format!("sh cannot be run: {error}"))?;
    let mut written = BTreeMap::new();
    if folder != Path::new(".") {
        for path in files(folder)? {
            let bytes = fs::read(&path).map_err(|error| at(&path, &error))?;
            written.insert(path.file_name().unwrap_or_default().into(), bytes);
        }
    }
    Ok(Outcome {
        code: output.status.code(),
        printed: output.stdout,
        messages: output.stderr,
        files: written,
    })
}

/// Where two outcomes part, in words.
fn difference(old: &Outcome, new: &Outcome) -> String {
    if old.code != new.code {
        return format!("exit code {:?}, then {:?}", old.code, new.code);
    }
    for (old, new) in [(&old.printed, &new.printed), (&old.messages, &new.messages)] {
        let (old, new) = (String::from_utf8_lossy(old), String::from_utf8_lossy(new));
        let (mut old, mut new) = (old.lines(), new.lines());
        loop {
            match (old.next(), new.next()) {
                (None, None) => break,
                (one, other) if one == other => {}
                (one, other) => {
                    return format!("- {}\n    + {}", one.unwrap_or_default(), other.unwrap_or_default());
                }
            }
        }
    }
    "files that it writes".to_owned()
}

fn write(path: &Path, line: &str, outcome: &Outcome) -> Result<(), String> {
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(|error| at(folder, &error))?;
    let mut bytes = format!("$ {line}\n").into_bytes();
    for (name, part) in [("stdout", &outcome.printed), ("stderr", &outcome.messages)] {
        bytes.extend(format!("\n== {name}\n").bytes().chain(part.iter().copied()));
    }
    for (name, content) in &outcome.files {
        bytes.extend(format!("\n== {}\n", name.display()).bytes().chain(content.iter().copied()));
    }
    fs::write(path, bytes).map_err(|error| at(path, &error))
}
