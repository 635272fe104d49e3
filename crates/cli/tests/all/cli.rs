//! The program from outside: what it prints, where, and its exit codes.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{PROGRAM, examples, here, output, run, session, text};
use std::fs;
use std::path::Path;
use std::process::Command;

/// A folder with the excavator's file, changed.
fn with(old: &str, new: &str) -> tempfile::TempDir {
    let folder = here();
    let excavator = fs::read_to_string(examples().join("xe215cll-drive.yaml")).unwrap();
    assert!(excavator.contains(old), "{old}");
    fs::write(folder.path().join("drive.yaml"), excavator.replacen(old, new, 1)).unwrap();
    folder
}

#[test]
fn a_drive_that_does_not_start_forward_is_warned_of() {
    let at = |load: &str| {
        let folder = with("carrier:\n", &format!("start: {{ load: {load} }}\ncarrier:\n"));
        let answer = output(folder.path(), &["drive", "drive.yaml", "--format", "json"]).stdout;
        let answer: serde_json::Value = serde_json::from_slice(&answer).unwrap();
        let motion = answer["start"]["with_losses"].clone();
        let outcome = motion["outcome"].as_str().unwrap().to_owned();
        let acceleration = motion["acceleration_sun_rad_s2"].as_f64().unwrap();
        let warning = answer["warnings"].to_string();
        (outcome, acceleration, motion["starting_time_s"].as_f64(), warning)
    };
    // Between 3000.4 and 3264.7 N·m the meshes hold the drive.
    let (outcome, acceleration, time, warning) = at("3050 N·m");
    assert_eq!((outcome.as_str(), acceleration, time), ("held", 0.0, None));
    assert!(warning.contains("holds loads from 3000.4 to 3264.7 N·m"), "{warning}");
    let (outcome, acceleration, time, warning) = at("3300 N·m");
    assert_eq!((outcome.as_str(), time), ("runs_backward", None));
    assert!(acceleration < 0.0 && warning.contains("turns the drive backward"), "{acceleration} {warning}");
    let (outcome, acceleration, time, _) = at("2900 N·m");
    assert_eq!(outcome, "starts");
    assert!(acceleration > 0.0 && time.is_some());
}

/// The commands that the help of a command shows as its example.
fn examples_in_help(command: &[&str]) -> Vec<String> {
    let help = text(&output(here().path(), &[command, &["--help-all"]].concat()).stdout);
    let after = help.split("Example:\n").nth(1).unwrap();
    after.lines().take_while(|line| !line.is_empty()).map(|line| line.trim().to_owned()).collect()
}

#[test]
fn the_examples_in_the_help_work_as_printed() {
    let commands: [&[&str]; 15] = [
        &["teeth"],
        &["drive"],
        &["analyze"],
        &["select"],
        &["schemes"],
        &["machine"],
        &["machine", "speeds"],
        &["machine", "rotor"],
        &["schema"],
        &["completions"],
        &["man"],
        &["draw"],
        &["motor"],
        &["motor", "search"],
        &["motor", "forms"],
    ];
    for command in commands {
        let (folder, script) = (here(), examples_in_help(command).join("\n"));
        let path = format!("{}:{}", Path::new(PROGRAM).parent().unwrap().display(), env!("PATH"));
        let mut shell = Command::new("sh");
        let output =
            shell.args(["-ec", &script]).env("PATH", path).current_dir(folder.path()).output().unwrap();
        assert!(output.status.success() && output.stderr.is_empty(), "{script}: {output:?}");
        let printed = text(&output.stdout);
        let written = fs::read_dir(folder.path()).unwrap().count();
        assert!(printed.len() > 200 || written == 1, "{script}");
        // Tables: JSON has lines of its own.
        for line in printed.lines().take_while(|line| *line != "{") {
            assert!(line.chars().count() <= 80, "{script}\n{line}");
        }
        let help = text(&common::output(folder.path(), &[command, &["--help-all"]].concat()).stdout);
        for line in help.lines() {
            assert!(line.trim_end().chars().count() <= 80, "{command:?}\n{line}");
        }
    }
}

/// Spaces too large are refused with their size, and what to narrow; the most exact are still to be had.
#[test]
fn spaces_beyond_memory_are_refused_with_their_size() {
    let folder = here();
    let wide = ["--sun", "1..1000", "--planet", "1..1000", "--ring", "1..1000", "--tolerance", "50%"];
    let run = |args: &[&str]| {
        let found = output(folder.path(), &[args, &wide].concat());
        (found.status.code(), text(&found.stderr), text(&found.stdout).lines().count())
    };
    let (code, said, _) = run(&["teeth", "--ratio", "6", "--format", "csv"]);
    assert_eq!(code, Some(2));
    assert!(
        said.starts_with("error: --limit: 103824 sets of tooth numbers are within the tolerance"),
        "{said}"
    );
    assert!(said.contains("narrow --tolerance"), "{said}");
    let (code, said, lines) = run(&["teeth", "--ratio", "6", "--format", "csv", "--limit", "1000"]);
    assert_eq!((code, lines), (Some(0), 1001));
    assert_eq!(said, "note: 103824 sets of tooth numbers found, 1000 shown; --limit shows more.\n");
    let (code, said, _) = run(&["select", "--ratios", "1.5, 2.5", "--teeth"]);
    assert_eq!(code, Some(2));
    assert!(
        said.contains("223177 combinations of tooth numbers a set")
            && said.contains("narrow the ranges of teeth"),
        "{said}"
    );
    let (code, said, _) = run(&["select", "--ratios", "1.5, 2.5", "--teeth", "--limit", "10001"]);
    assert!(code == Some(2) && said.contains("at most 10000"), "{said}");
}

#[test]
fn a_drive_with_less_load_and_more_inertia() {
    let folder = with(
        "ratio: 6\n",
        "ratio: 6\nstart: { load: 2 kN·m }\nattached: { motor: 0.05 kg·m², machine: 12 kg·m² }\n",
    );
    let seen = session(folder.path(), &["drive", "drive.yaml"]);
    insta::assert_snapshot!(&seen[seen.find("Equivalent inertia").unwrap()..]);
}

#[test]
fn files_that_cannot_be_read() {
    let folder = here();
    fs::create_dir(folder.path().join("folder")).unwrap();
    fs::write(folder.path().join("empty.yaml"), "").unwrap();
    fs::write(folder.path().join("latin1.yaml"), b"title: Getriebe f\xfcr Bagger\n").unwrap();
    let read = |file| session(folder.path(), &["drive", file]);
    insta::assert_snapshot!(["missing.yaml", "folder", "empty.yaml", "latin1.yaml"].map(read).join("\n"));
}

#[test]
fn an_answer_is_written_whole_or_not_at_all() {
    let folder = here();
    let answer = folder.path().join("answer.csv");
    let write = |args: &[&str]| {
        let mut all = vec!["teeth", "--format", "csv", "-o", "answer.csv", "--ratio"];
        all.extend(args);
        output(folder.path(), &all)
    };
    let done = write(&["6"]);
    assert!(done.status.success() && done.stdout.is_empty() && done.stderr.is_empty(), "{done:?}");
    let first = fs::read_to_string(&answer).unwrap();
    assert_eq!(first.lines().count(), 48);

    // No answer is written, and the old file remains.
    assert_eq!(write(&["60"]).status.code(), Some(1));
    assert_eq!(fs::read_to_string(&answer).unwrap(), first);

    // A file that may not be written remains, too.
    let mut permissions = fs::metadata(&answer).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&answer, permissions).unwrap();
    let refused = write(&["5"]);
    assert_eq!(refused.status.code(), Some(3));
    assert_eq!(
        text(&refused.stderr),
        "error: answer.csv: cannot be written: permission denied; it is unchanged\n"
    );
    assert_eq!(fs::read_to_string(&answer).unwrap(), first);

    // Nothing is left beside it.
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[cfg(unix)]
#[test]
fn an_answer_keeps_permissions_and_links() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = here();
    let (kept, link) = (folder.path().join("kept.txt"), folder.path().join("link.txt"));
    fs::write(&kept, "old").unwrap();
    fs::set_permissions(&kept, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("kept.txt", &link).unwrap();
    assert!(output(folder.path(), &["teeth", "--ratio", "6", "-o", "link.txt"]).status.success());
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(fs::read_to_string(&kept).unwrap().starts_with("Ratio 6"));
    assert_eq!(fs::metadata(&kept).unwrap().permissions().mode() & 0o777, 0o640);
    assert!(output(folder.path(), &["teeth", "--ratio", "6", "-o", "/dev/null"]).status.success());
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}

#[test]
fn warnings_are_shown_where_the_answer_goes_to_a_file() {
    let folder = with("planets: 4", "planets: 4");
    let done = output(folder.path(), &["drive", "drive.yaml", "-o", "answer.txt"]);
    assert!(done.status.success() && done.stdout.is_empty());
    assert_eq!(text(&done.stderr).matches("warning: the ").count(), 3);
    assert!(fs::read_to_string(folder.path().join("answer.txt")).unwrap().contains("Warnings"));
}

/// Command lines with numbers as wide as they come.
const WIDE: &str = "\
drive drive.yaml
teeth --ratio 1.7 --spacing least-unequal --planets 8 --mode bH^a
teeth --ratio 3.94 --sun 100..2000 --planet 100..2000 --ring 200..4000 --tolerance 0.01%
analyze real-transmissions.yaml --transmission prius --gear 'all tied' --torque '123456 N·m'
analyze real-transmissions.yaml --transmission 8HP --gear R --power '123 MW' --speed '15000 rpm'
analyze real-transmissions.yaml --transmission prius --speed '15000 rpm' --torque '1 MN·m'
analyze real-transmissions.yaml --transmission 8HP --all-combinations
analyze sized-gearbox.yaml --power '12345 kW' --speed '15000 rpm'
select --speeds '0.76 m/s, 1.33 m/s, 1.95 m/s' --all-structures --power '12345 kW' --input '15000 rpm'
select --ratios 30 --k ..40 --power '99 MW' --input '15 rpm'
select --ratios '4, 7' --all-structures --signs any --limit 100
select --ratios '4, 7' --all-structures --teeth --ring ..90 --limit 30 --signs any
schemes I-1 --k1 9 --k2 9
schemes
machine list
machine speeds '0.1 m/s, 1.3 m/s, 17 m/s, 250 m/s'
";

#[test]
fn tables_fit_eighty_columns_and_json_is_json() {
    let folder = with("ratio: 6\n", "ratio: 6\nstart: { load: 20 kN·m }\n");
    for name in ["real-transmissions.yaml", "sized-gearbox.yaml"] {
        fs::copy(examples().join(name), folder.path().join(name)).unwrap();
    }
    for line in WIDE.lines() {
        let table = text(&run(folder.path(), line).stdout);
        assert!(!table.is_empty(), "{line}");
        for row in table.lines() {
            assert!(row.chars().count() <= 80, "{line}\n{row}");
            assert!(!row.contains("NaN") && !row.contains("inf "), "{line}\n{row}");
        }
        let json = run(folder.path(), &format!("{line} --format json")).stdout;
        let json: serde_json::Value = serde_json::from_slice(&json).unwrap();
        assert!(json.is_object(), "{line}");
    }
}
