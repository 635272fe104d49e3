//! What the program prints, against the snapshots: sessions as text in `sessions/`, by subject.
//!
//! | line | means |
//! |---|---|
//! | `## name` | a session begins, in a folder of its own with the examples; its snapshot has this name |
//! | `analyze box.yaml --gear 1` | a command, parted as a shell does; `epicyclic` is the program without one |
//! | `box.yaml of wind-stage.yaml` | the file becomes a copy of the example |
//! | `box.yaml of wind-stage.yaml: sheet box.yaml` | the command is run for each of the indented lines below |
//! | `  old → new \| old → new` | changes of the example; `N` of the line above becomes the number of this one |
//!
//! In the texts `\n` is a line break and `\s` a space at an end.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common::{change, console::words, examples, here, names, replaced, session};
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// A motor by the cosine law, and a gearbox whose sets shut each other in.
const FILES: [(&str, &str); 2] = [
    ("cosine.yaml", "stator: 7\nrotor: 5\nz3: 84\nzs: 11\nmodule: 1 mm\nlaw: cosine\n"),
    ("alike.yaml", include_str!("sessions/alike.yaml")),
];

/// Output of a command; one that fails leaves no file.
fn printed(folder: &Path, command: &str) -> String {
    let before = names(folder);
    let words = words(command.strip_prefix("epicyclic").unwrap_or(command));
    let seen = session(folder, &words.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(seen.ends_with("exit: 0\n") || names(folder) == before, "{command} has written a file");
    seen
}

/// Output of all commands of a session.
fn all_printed(lines: &str) -> String {
    let folder = here();
    for file in fs::read_dir(examples()).unwrap().map(Result::unwrap) {
        fs::copy(file.path(), folder.path().join(file.file_name())).unwrap();
    }
    fs::create_dir(folder.path().join("folder")).unwrap();
    for (name, text) in FILES {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let (mut seen, mut changed, mut number) = (vec![], ("", "", ""), 0);
    for line in lines.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some(row) = line.strip_prefix("  ") {
            let (name, of, command) = changed;
            let numbered = |text: &str| text.replace("N.yaml", &format!("{number}.yaml"));
            let example = fs::read_to_string(examples().join(of)).unwrap();
            let text = row.split(" | ").map(|text| change(text).unwrap());
            let text = text.fold(example, |file, (from, to)| replaced(&file, &from, &to));
            fs::write(folder.path().join(numbered(name)), text).unwrap();
            seen.push(printed(folder.path(), &numbered(command)));
            number += 1;
        } else if let Some((name, of)) = line.split_once(" of ") {
            let (of, command) = of.split_once(": ").unwrap_or((of, ""));
            if command.is_empty() {
                fs::copy(examples().join(of), folder.path().join(name)).unwrap();
            }
            (changed, number) = ((name, of, command), 0);
        } else {
            seen.push(printed(folder.path(), line));
        }
    }
    seen.join("\n")
}

/// Compares all sessions of a subject with their snapshots, and names those that differ.
fn check(subject: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    let _bound = settings.bind_to_scope();
    let mut faults = vec![];
    for session in text.split("\n## ").skip(1) {
        let (name, lines) = session.split_once('\n').unwrap();
        let is_as_before = catch_unwind(AssertUnwindSafe(|| {
            insta::assert_snapshot!(format!("all__{subject}__{name}"), all_printed(lines));
        }));
        if is_as_before.is_err() {
            faults.push(name);
        }
    }
    assert!(faults.is_empty(), "{subject}: {faults:?} differ from what was expected");
}

#[test]
fn sessions_with_drives_and_tooth_numbers_are_as_before() {
    check("cli", include_str!("sessions/cli.txt"));
}

#[test]
fn sessions_with_drawings_are_as_before() {
    check("draw", include_str!("sessions/draw.txt"));
}

#[test]
fn sessions_with_gearboxes_are_as_before() {
    check("gearboxes", include_str!("sessions/gearboxes.txt"));
}

#[test]
fn sessions_with_motors_are_as_before() {
    check("motor", include_str!("sessions/motor.txt"));
}

#[test]
fn sessions_with_forms_of_motors_are_as_before() {
    check("motor_forms", include_str!("sessions/motor_forms.txt"));
}

#[test]
fn sessions_with_vibration_are_as_before() {
    check("vibration", include_str!("sessions/vibration.txt"));
}
