//! The program from outside, for the tests of its commands.

#![allow(dead_code, reason = "each test file uses its part")]
#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

pub(crate) mod console;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_epicyclic");

pub(crate) fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

pub(crate) fn program(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(PROGRAM);
    command.args(args).current_dir(folder).env_remove("COLUMNS").stdin(Stdio::null());
    command
}

pub(crate) fn output(folder: &Path, args: &[&str]) -> Output {
    program(folder, args).output().unwrap()
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// What a person sees.
pub(crate) fn session(folder: &Path, args: &[&str]) -> String {
    let output = output(folder, args);
    let mut seen = format!("$ epicyclic {}\n{}", args.join(" "), text(&output.stdout));
    if !output.stderr.is_empty() {
        write!(seen, "stderr:\n{}", text(&output.stderr)).unwrap();
    }
    // Clap leaves spaces at the ends of empty lines.
    let lines: Vec<&str> = seen.lines().map(str::trim_end).collect();
    format!("{}\nexit: {}\n", lines.join("\n"), output.status.code().unwrap())
}

/// Several sessions of one folder.
pub(crate) fn sessions(folder: &Path, all: &[&[&str]]) -> String {
    all.iter().map(|args| session(folder, args)).collect::<Vec<_>>().join("\n")
}

pub(crate) fn here() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}
