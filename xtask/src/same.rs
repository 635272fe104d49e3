//! `cargo xtask same`: byte-for-byte comparison of the answers of two programs to equal command lines.

use crate::project_root;
use crate::tidy::source;
use clap::Args;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Output};

/// Compare what two programs answer, byte for byte.
///
/// The programs run every command of the book and every help, and every command that reads files on every
/// example, as text, JSON and CSV. Exit codes, answers, messages and written files are compared. Exit code 0
/// if all are the same; else 1, and the folder has both answers of each command line that differs.
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  git worktree add /tmp/old v0.1.0\n  cargo build --manifest-path /tmp/old/Cargo.toml -p epicyclic\n  \
                  cargo xtask same /tmp/old/target/debug/epicyclic"
)]
pub struct Arguments {
    /// The program of the earlier revision.
    pub old: PathBuf,
    /// The program of this revision.
    #[arg(default_value = "target/debug/epicyclic")]
    pub new: PathBuf,
    /// Folder of the differences; those of an earlier run are removed.
    #[arg(short, long, value_name = "FOLDER", default_value = "target/same")]
    pub output: PathBuf,
}

const PROMPT: &str = "$ cargo run -q -p epicyclic -- ";
const READERS: [&str; 10] =
    ["analyze", "drive", "losses", "motor", "report", "sheet", "simulate", "size", "strength", "vibrate"];

/// Endings of the files with the answers of the old and the new program: of no files that people have there.
const ENDINGS: [&str; 2] = ["old-answer", "new-answer"];

/// Command lines that are run one after the other in one folder.
struct Session {
    name: String,
    lines: Vec<String>,
}

/// Exit code, answer, messages and written files of a command line.
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
    if arguments.output.is_dir() {
        for path in files(&arguments.output)? {
            if path.extension().is_some_and(|ending| ENDINGS.iter().any(|ours| ending == *ours)) {
                fs::remove_file(&path).map_err(|error| at(&path, &error))?;
            }
        }
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
                for (ending, outcome) in ENDINGS.iter().zip([&old, &new]) {
                    write(
                        &arguments.output.join(format!("{}-{place}.{ending}", session.name)),
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
    for file in source::of_project(&project_root())? {
        let reads = |command| forms(&format!("{command} {}", file.path));
        let lines: Vec<String> = if file.path.starts_with("examples/") {
            READERS.into_iter().flat_map(reads).collect()
        } else if file.path.ends_with(".md") {
            let commands = file.text.lines().filter_map(|line| line.strip_prefix(PROMPT));
            // It serves until it is ended.
            commands.filter(|line| !line.starts_with("serve")).flat_map(forms).collect()
        } else {
            continue;
        };
        found.push(Session { name: file.path.replace('/', "-"), lines });
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
    let line = format!("{command} --help-all");
    let help = answered(program, Path::new("."), &line)?;
    let text = String::from_utf8_lossy(&help.stdout).into_owned();
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

fn answered(program: &Path, folder: &Path, line: &str) -> Result<Output, String> {
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("\"$EPICYCLIC\" {line}")]).env("EPICYCLIC", program).current_dir(folder);
    shell.output().map_err(|error| format!("sh cannot be run: {error}"))
}

fn outcome(program: &Path, folder: &Path, line: &str) -> Result<Outcome, String> {
    let Output { status, stdout, stderr } = answered(program, folder, line)?;
    let read = |path: PathBuf| {
        let bytes = fs::read(&path).map_err(|error| at(&path, &error))?;
        Ok::<_, String>((path.file_name().unwrap_or_default().into(), bytes))
    };
    let files = files(folder)?.into_iter().map(read).collect::<Result<_, _>>()?;
    Ok(Outcome { code: status.code(), printed: stdout, messages: stderr, files })
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
