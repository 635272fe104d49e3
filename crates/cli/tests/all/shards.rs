//! `synthesize` in shares: parts together are the whole search, and a share that is killed or ended goes on
//! to the same part.

use crate::common::{console::words, names};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use std::{fs, thread};

/// The six-speed of three sets: half a second to some seconds of work, 43 solutions.
const SIX_SPEED: &str = "synthesize --ratios '3.48718 1.86429 1.40276 1 0.75198 0.6525 -4.9325' --class all-sparse --sets 3 --elements 5 --engaged 2 --k 1.4..4.5";

/// A four-speed of two sets, quickly found.
const FOUR_SPEED: &str = "synthesize --ratios '3.059 1.625 1 0.696 -2.294' --class all-sparse --sets 2 --elements 4..6 --engaged 2";

fn program(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_epicyclic"));
    command.current_dir(folder);
    command
}

fn run(folder: &Path, question: &str, more: &[&str]) -> Output {
    program(folder).args(words(question)).args(more).output().expect("the program runs")
}

fn told(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn all_parts_together_give_the_answer_of_the_whole_search() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for share in 1..=3 {
        let (share, file) = (format!("{share}/3"), format!("part-{share}.parquet"));
        let output = run(folder, FOUR_SPEED, &["--shard", &share, "-o", &file]);
        assert!(output.status.success() && output.stdout.is_empty(), "{}", told(&output));
        assert!(told(&output).contains("is complete: share"), "{}", told(&output));
    }
    assert_eq!(names(folder), ["part-1.parquet", "part-2.parquet", "part-3.parquet"]);
    let parts = ["--merge", "part-2.parquet", "part-3.parquet", "part-1.parquet"];
    for format in [&["--format", "json"][..], &["--format", "csv"], &[], &["--limit", "2"]] {
        let whole = run(folder, FOUR_SPEED, format);
        let merged = run(folder, FOUR_SPEED, &[&parts[..], format].concat());
        assert!(whole.status.success() && merged.status.success(), "{}", told(&merged));
        assert!(whole.stdout.len() > 500);
        assert_eq!(String::from_utf8_lossy(&merged.stdout), String::from_utf8_lossy(&whole.stdout));
    }
    // A complete part is not searched again.
    let output = run(folder, FOUR_SPEED, &["--shard", "2/3", "-o", "part-2.parquet"]);
    assert!(output.status.success() && told(&output).contains("is complete already"), "{}", told(&output));
}

#[test]
fn parts_that_do_not_fit_together_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for share in 1..=3 {
        let (share, file) = (format!("{share}/3"), format!("{share}.parquet"));
        assert!(run(folder, FOUR_SPEED, &["--shard", &share, "-o", &file]).status.success());
    }
    let other = FOUR_SPEED.replace("3.059", "3.06");
    fs::write(folder.join("text"), "no table").unwrap();
    for (question, parts, message) in [
        (FOUR_SPEED, "1.parquet 3.parquet", "error: missing: share 2 of 3"),
        (FOUR_SPEED, "1.parquet", "error: missing: shares 2, 3 of 3"),
        (FOUR_SPEED, "1.parquet 2.parquet 3.parquet 2.parquet", "2.parquet and 2.parquet are both share 2/3"),
        (
            &other,
            "1.parquet 2.parquet 3.parquet",
            "1.parquet is of another search: its gears: 3.02841..3.08959",
        ),
        (FOUR_SPEED, "1.parquet 2.parquet none.parquet", "none.parquet: cannot be read"),
        (FOUR_SPEED, "1.parquet text 3.parquet", "text: cannot be read: no part of a search with a checksum"),
    ] {
        let parts: Vec<&str> = ["--merge"].into_iter().chain(parts.split(' ')).collect();
        let output = run(folder, question, &parts);
        assert!(!output.status.success() && output.stdout.is_empty());
        assert!(told(&output).contains(message), "{message}: {}", told(&output));
    }
}

fn start(folder: &Path, file: &str) -> Child {
    let mut command = program(folder);
    command.args(words(SIX_SPEED)).args(["--shard", "1/1", "-o", file]);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program runs")
}

#[test]
fn a_share_killed_at_any_moment_goes_on_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let begun = Instant::now();
    let whole = start(folder, "whole.parquet").wait_with_output().unwrap();
    let took = begun.elapsed();
    assert!(whole.status.success(), "{}", told(&whole));
    let whole = fs::read(folder.join("whole.parquet")).unwrap();
    let (mut killed, mut went_on) = (0, 0);
    for first in [0.05, 0.2, 0.35, 0.5, 0.65, 0.8] {
        let mut wait = took.mul_f64(first);
        loop {
            let mut child = start(folder, "part.parquet");
            thread::sleep(wait);
            // SIGKILL.
            let _ = child.kill();
            let output = child.wait_with_output().unwrap();
            went_on += usize::from(told(&output).contains("going on with part.parquet.progress"));
            if output.status.success() {
                break;
            }
            killed += 1;
            wait += took.mul_f64(0.1);
        }
        assert_eq!(fs::read(folder.join("part.parquet")).unwrap(), whole, "first killed at {first}");
        assert_eq!(names(folder), ["part.parquet", "whole.parquet"], "nothing else is left");
        fs::remove_file(folder.join("part.parquet")).unwrap();
    }
    assert!(killed > 5 && went_on > 2, "killed {killed} times, went on {went_on} times");
}

#[cfg(unix)]
fn interrupt(child: &Child) {
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(sent.expect("kill runs").success());
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_the_work_of_a_share() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let mut tries = 0;
    let output = loop {
        let mut child = start(folder, "part.parquet");
        // As soon as some work is kept.
        while !folder.join("part.parquet.progress").exists() && child.try_wait().unwrap().is_none() {
            thread::sleep(Duration::from_millis(1));
        }
        if child.try_wait().unwrap().is_none() {
            interrupt(&child);
        }
        let output = child.wait_with_output().unwrap();
        tries += 1;
        if output.status.code() == Some(130) || tries == 20 {
            break output;
        }
        // The search was quicker.
        let _ = fs::remove_file(folder.join("part.parquet"));
    };
    assert_eq!(output.status.code(), Some(130), "{}", told(&output));
    assert!(told(&output).contains("what is done is kept in part.parquet.progress"), "{}", told(&output));
    assert_eq!(names(folder), ["part.parquet.progress"]);
    let part = fs::read(folder.join("part.parquet.progress")).unwrap();
    let refused = run(folder, SIX_SPEED, &["--merge", "part.parquet.progress"]);
    assert!(told(&refused).contains("part.parquet.progress is not complete: "), "{}", told(&refused));
    // Of another share or question it is not gone on with, and it stays.
    for (question, share) in [(SIX_SPEED, "1/2"), (FOUR_SPEED, "1/1")] {
        let refused = run(folder, question, &["--shard", share, "-o", "part.parquet"]);
        assert!(!refused.status.success(), "{}", told(&refused));
        assert_eq!(fs::read(folder.join("part.parquet.progress")).unwrap(), part);
    }
    let output = start(folder, "part.parquet").wait_with_output().unwrap();
    assert!(output.status.success(), "{}", told(&output));
    assert_eq!(names(folder), ["part.parquet"]);
}

#[cfg(unix)]
#[test]
fn ctrl_c_tells_what_was_found_and_that_it_is_not_all() {
    let mut last = String::new();
    // How far a search is after some time nobody knows; one of these moments is before its end and after its
    // first solution.
    let waits = std::iter::successors(Some(60.0), |wait| Some(1.12 * wait)).take_while(|wait| *wait < 4000.0);
    for wait in waits {
        let mut command = program(Path::new("."));
        let child =
            command.args(words(SIX_SPEED)).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        thread::sleep(Duration::from_millis(wait as u64));
        interrupt(&child);
        let output = child.wait_with_output().unwrap();
        let shown = String::from_utf8_lossy(&output.stdout).into_owned();
        last = format!("{:?} {}{shown}", output.status.code(), told(&output));
        if output.status.code() == Some(130) && !shown.is_empty() {
            assert!(shown.contains(" found before the search was ended"), "{shown}");
            assert!(
                told(&output).contains("error: interrupted: the search was ended before it was complete")
            );
            return;
        }
    }
    panic!("{last}");
}

/// Bits of a part and of work in progress that are not as they were written, files that have no end, and
/// outputs that take no file.
#[test]
fn what_is_no_part_or_no_longer_one_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let shard = ["--shard", "1/1", "-o", "part.parquet"];
    assert!(run(folder, FOUR_SPEED, &shard).status.success());
    let part = fs::read(folder.join("part.parquet")).unwrap();
    let told_of = |more: &[&str], code: i32| {
        let output = run(folder, FOUR_SPEED, more);
        assert_eq!(output.status.code(), Some(code), "{more:?}: {}", told(&output));
        told(&output)
    };
    for place in [5, part.len() / 3, part.len() / 2, part.len() - 200, part.len() - 6] {
        let mut changed = part.clone();
        changed[place] ^= 4;
        for name in ["changed.parquet", "other.parquet.progress"] {
            fs::write(folder.join(name), &changed).unwrap();
        }
        assert!(told_of(&["--merge", "changed.parquet"], 3).contains("checksum"), "{place}");
        assert!(told_of(&["--shard", "1/1", "-o", "other.parquet"], 3).contains("checksum"), "{place}");
        assert_eq!(fs::read(folder.join("other.parquet.progress")).unwrap(), changed, "it stays");
        assert!(!folder.join("other.parquet").exists());
    }
    fs::write(folder.join("text.parquet"), "no part").unwrap();
    assert!(told_of(&["--merge", "text.parquet"], 3).contains("with a checksum"));
    for device in ["/dev/zero", "/dev/full", "/dev/null", "/dev/stdout"] {
        if Path::new(device).exists() {
            let no_file = "a part is a file, no device, pipe or folder";
            assert!(told_of(&["--merge", "part.parquet", device], 3).contains(no_file), "{device}");
            assert!(told_of(&["--shard", "1/2", "-o", device], 3).contains(no_file), "{device}");
        }
    }
    assert!(told_of(&["--merge", "."], 3).contains("a part is a file"));
}
