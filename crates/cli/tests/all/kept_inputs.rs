//! An input file is never replaced by an output file, and an answer that cannot be written is an error.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]
#![cfg(unix)]

use crate::common;

use common::{PROGRAM, here, output, program, text};
use std::fs::{self, File};
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Output, Stdio};

const BOX: &str = "\
gearbox: x
input: sun
output: car
sets: [{ id: s0, sun: sun, ring: ground, carrier: car, k: 3 }]
gears: [{ name: only }]
";

/// A scenario that reads a gearbox and three tables.
const SCENARIO: &str = "\
scenario: start with a measured engine
gearbox_file: box.yaml
inertias: { sun: 0.2 kg·m², car: 2 kg·m² }
torques:
  - { id: engine, link: sun, over_speed: { csv: engine.csv } }
  - { id: load, link: car, over_time: { csv: tables/load.csv } }
duration: 0.1 s
";

/// The folder with the files of a scenario in `sub`, and other names of them.
fn scenario() -> tempfile::TempDir {
    let folder = here();
    let path = |name: &str| folder.path().join(name);
    fs::create_dir_all(path("sub/tables")).unwrap();
    for (name, content) in [
        ("sub/sc.yaml", SCENARIO),
        ("sub/box.yaml", BOX),
        ("sub/engine.csv", "rpm,N·m\n0,120\n3000,0\n"),
        ("sub/tables/load.csv", "s,N·m\n0,-1\n1,-2\n"),
    ] {
        fs::write(path(name), content).unwrap();
    }
    symlink("sub/engine.csv", path("link.csv")).unwrap();
    symlink("sub", path("other")).unwrap();
    fs::hard_link(path("sub/box.yaml"), path("hard.yaml")).unwrap();
    fs::write(path("answer.csv"), "old").unwrap();
    folder
}

fn contents(folder: &Path) -> Vec<String> {
    let files = ["sub/sc.yaml", "sub/box.yaml", "sub/engine.csv", "sub/tables/load.csv", "answer.csv"];
    files.map(|file| fs::read_to_string(folder.join(file)).unwrap()).to_vec()
}

#[test]
fn no_output_replaces_a_file_that_another_file_names() {
    let folder = scenario();
    let before = contents(folder.path());
    let names = [
        "sub/engine.csv",
        "./sub/../sub/engine.csv",
        "link.csv",
        "other/engine.csv",
        "sub/tables/load.csv",
        "other/tables/load.csv",
        "sub/box.yaml",
        "hard.yaml",
        "sub/sc.yaml",
    ];
    let outputs: [&[&str]; 3] = [
        &["simulate", "sub/sc.yaml", "--csv"],
        &["simulate", "sub/sc.yaml", "--format", "json", "--output"],
        &["report", "sub/sc.yaml", "-o"],
    ];
    for name in names {
        for line in outputs {
            // A page is refused by the end of its name before that.
            if line[0] == "report" && !name.ends_with(".yaml") {
                continue;
            }
            let done = output(folder.path(), &[line, &[name]].concat());
            let told = text(&done.stderr);
            assert!(done.status.code() == Some(2) && done.stdout.is_empty(), "{line:?} {name}: {done:?}");
            assert!(
                told.starts_with("error: --") && told.contains(&format!(" {name} and the input sub/")),
                "{told}"
            );
            assert!(
                told.ends_with(" are one file; the input would be lost; name another file to write\n"),
                "{told}"
            );
            assert_eq!(contents(folder.path()), before, "{line:?} {name}");
        }
    }
    // Of several outputs none is written where one would replace an input.
    let line = ["simulate", "sub/sc.yaml", "--csv", "answer.csv", "-o", "sub/engine.csv"];
    assert_eq!(output(folder.path(), &line).status.code(), Some(2));
    assert_eq!(contents(folder.path()), before);
    let line = ["simulate", "sub/sc.yaml", "--csv", "answer.csv", "-o", "answer.txt"];
    let done = output(folder.path(), &line);
    assert!(done.status.success(), "{done:?}");
    assert_eq!(contents(folder.path())[..4], before[..4]);
}

#[test]
fn the_file_of_standard_input_is_an_input() {
    let folder = scenario();
    let before = contents(folder.path());
    for name in ["sub/box.yaml", "hard.yaml", "other/box.yaml"] {
        let input = File::open(folder.path().join("sub/box.yaml")).unwrap();
        let done = program(folder.path(), &["analyze", "-", "-o", name]).stdin(input).output().unwrap();
        let due = format!(
            "error: --output {name} and the file of standard input are one file; the input would be lost; name another file to write\n"
        );
        assert_eq!((done.status.code(), text(&done.stderr)), (Some(2), due));
        assert_eq!(contents(folder.path()), before);
    }
    let done =
        program(folder.path(), &["analyze", "-", "-o", "/dev/null"]).stdin(Stdio::null()).output().unwrap();
    assert!(text(&done.stderr).contains("the file is empty"), "{done:?}");
}

/// The program with what a shell makes of its standard output.
fn redirected(folder: &Path, redirection: &str, args: &[&str]) -> Output {
    let mut command = Command::new("sh");
    command.args(["-c", &format!("exec \"$0\" \"$@\" {redirection}"), PROGRAM]).args(args);
    command.current_dir(folder).stdin(Stdio::null()).output().unwrap()
}

#[test]
fn an_answer_that_nobody_takes_is_an_error() {
    let folder = scenario();
    let answers: [&[&str]; 8] = [
        &["analyze", "sub/box.yaml"],
        &["analyze", "sub/box.yaml", "--format", "json"],
        &["analyze", "sub/box.yaml", "--format", "csv"],
        &["simulate", "sub/sc.yaml"],
        &["schema", "gearbox"],
        &["completions", "bash"],
        &["--help"],
        &["--version"],
    ];
    for line in answers {
        for (redirection, why) in [
            (">&-", "it is closed"),
            ("1</dev/null", "Bad file descriptor (os error 9)"),
            (">/dev/full", "No space left"),
        ] {
            let done = redirected(folder.path(), redirection, line);
            assert_eq!(done.status.code(), Some(3), "{line:?} {redirection}: {done:?}");
            let told = text(&done.stderr);
            assert!(
                told.starts_with(&format!("error: standard output: {why}")),
                "{line:?} {redirection}: {told}"
            );
        }
        let done = redirected(folder.path(), ">/dev/null", line);
        assert!(done.status.success() && done.stderr.is_empty(), "{line:?}: {done:?}");
    }
    // By its name it is no better, and what goes elsewhere is written.
    for name in ["/dev/stdout", "/dev/fd/1"] {
        let done = redirected(folder.path(), ">&-", &["analyze", "sub/box.yaml", "-o", name]);
        let due = format!("error: {name}: cannot be written: it is closed\n");
        assert_eq!((done.status.code(), text(&done.stderr)), (Some(3), due));
    }
    let done = redirected(folder.path(), ">&-", &["analyze", "sub/box.yaml", "-o", "answer.txt"]);
    assert!(done.status.success() && folder.path().join("answer.txt").exists(), "{done:?}");
}
