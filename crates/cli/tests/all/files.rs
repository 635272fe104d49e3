//! Files that are read and written: which may be equal, size limits, files left behind, and names with
//! control characters.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]
#![cfg(unix)]

use crate::common;

use common::{PROGRAM, examples, here, names, output, program, run, text};
use std::fs::{self, File};
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const BOX: &str = "\
gearbox: conveyor
input: D
output: B
sets: [{ id: P, sun: D, ring: T1, carrier: B, k: 2.94, efficiency: 0.97 }]
brakes: [{ id: K1, link: T1 }]
clutches: [{ id: K2, links: [D, B] }]
gears: [{ name: slow, engaged: [K1] }, { name: fast, engaged: [K2] }]
";

const MOTOR: [&str; 11] =
    ["motor", "--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", "2 mm"];

#[test]
fn an_output_that_is_the_input_is_refused() {
    let folder = here();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("box.yaml"), BOX).unwrap();
    fs::create_dir(path("sub")).unwrap();
    symlink("../box.yaml", path("sub/link.yaml")).unwrap();
    fs::hard_link(path("box.yaml"), path("hard.yaml")).unwrap();
    for (line, one, other) in [
        (&["report", "box.yaml", "-o", "box.yaml"][..], "--output box.yaml", "the input box.yaml"),
        (
            &["report", "./box.yaml", "-o", "sub/../box.yaml"],
            "--output sub/../box.yaml",
            "the input ./box.yaml",
        ),
        (&["analyze", "box.yaml", "-o", "sub/link.yaml"], "--output sub/link.yaml", "the input box.yaml"),
        (&["analyze", "sub/link.yaml", "-o", "box.yaml"], "--output box.yaml", "the input sub/link.yaml"),
        (&["draw", "box.yaml", "--svg", "hard.yaml"], "--svg hard.yaml", "the input box.yaml"),
        (&["draw", "box.yaml", "--dxf", "box.yaml"], "--dxf box.yaml", "the input box.yaml"),
        // The fault is found before anything is read: this is no drive.
        (&["drive", "box.yaml", "--output=box.yaml"], "--output box.yaml", "the input box.yaml"),
    ] {
        let done = output(folder.path(), line);
        let due = format!(
            "error: {one} and {other} are one file; the input would be lost; name another file to write\n"
        );
        assert_eq!((done.status.code(), text(&done.stderr)), (Some(2), due), "{line:?}");
        assert_eq!(fs::read_to_string(path("box.yaml")).unwrap(), BOX);
    }
    // A file that does not exist cannot be lost, and the name of a scheme is not a file.
    let done = output(folder.path(), &["draw", "II-3", "-o", "ii-3.svg"]);
    assert!(done.status.success(), "{done:?}");
    let done = output(folder.path(), &["analyze", "new.yaml", "-o", "new.yaml"]);
    assert!(text(&done.stderr).starts_with("error: new.yaml: cannot be read"), "{done:?}");
}

#[test]
fn outputs_that_are_one_file_are_refused() {
    let folder = here();
    symlink("x", folder.path().join("link")).unwrap();
    let motor = |more: &[&'static str]| [&MOTOR[..], more].concat();
    for (line, pair) in [
        (vec!["draw", "II-3", "--svg", "x", "--dxf", "x"], ["svg x", "dxf x"]),
        (vec!["draw", "II-3", "-o", "./x.svg", "--dxf", "x.svg"], ["output ./x.svg", "dxf x.svg"]),
        (vec!["draw", "II-3", "--svg", "link", "--dxf", "x"], ["svg link", "dxf x"]),
        (motor(&["--svg", "x", "--csv", "x"]), ["svg x", "csv x"]),
        (motor(&["-o", "a.json", "--csv", "a.json"]), ["csv a.json", "output a.json"]),
        (
            vec!["motor", "search", "--displacement", "250 cm3/rev", "--dxf", "y", "-o", "y"],
            ["dxf y", "output y"],
        ),
    ] {
        let start = Instant::now();
        let done = output(folder.path(), &line);
        let message = text(&done.stderr);
        assert!(
            done.status.code() == Some(2)
                && pair.iter().all(|option| message.contains(&format!("--{option} ")))
                && message.ends_with(" are one file; name a file for each\n"),
            "{message}"
        );
        // The refusal comes before any calculation.
        assert!(start.elapsed() < Duration::from_secs(2), "{line:?}");
        assert_eq!(names(folder.path()), ["link"]);
    }
    let twice_nothing = motor(&["--svg", "/dev/null", "--dxf", "/dev/null"]);
    assert!(output(folder.path(), &twice_nothing).status.success());
}

/// The second of two files fails when it is prepared, or as a device: the first is not there either.
#[test]
fn of_several_files_all_are_written_or_none() {
    let folder = here();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("old.svg"), "old").unwrap();
    let motor = |more: &[&'static str]| [&MOTOR[..], more].concat();
    for line in [
        vec!["draw", "II-3", "--svg", "old.svg", "--dxf", "no/such.dxf"],
        motor(&["--svg", "old.svg", "--dxf", "new.dxf", "--csv", "no/such.csv"]),
        motor(&["--svg", "old.svg", "--csv", "new.csv", "-o", "no/such.txt"]),
        motor(&["--svg", "old.svg", "--csv", "new.csv", "-o", "/dev/full"]),
    ] {
        if line.contains(&"/dev/full") && !Path::new("/dev/full").exists() {
            continue;
        }
        let done = output(folder.path(), &line);
        assert_eq!((done.status.code(), done.stdout.len()), (Some(3), 0), "{done:?}");
        assert_eq!(names(folder.path()), ["old.svg"]);
        assert_eq!(fs::read_to_string(path("old.svg")).unwrap(), "old");
    }
}

/// A write that fails names the target and the reason, not the temporary file. The limit on the size of files
/// simulates a full disk.
#[test]
fn a_failed_write_names_its_target() {
    let folder = here();
    let limited = |line: &[&str]| {
        let mut command = Command::new("sh");
        command.args(["-c", "trap '' XFSZ; ulimit -f 4; exec \"$0\" \"$@\"", PROGRAM]).args(line);
        command.current_dir(folder.path()).stdin(Stdio::null()).output().unwrap()
    };
    let long = ["teeth", "--ratio", "4", "--tolerance", "50%", "--format", "json", "-o", "answer.json"];
    for state in ["", "; it is unchanged"] {
        let done = limited(&long);
        let due = format!("error: answer.json: cannot be written: File too large (os error 27){state}\n");
        assert_eq!((done.status.code(), text(&done.stderr)), (Some(3), due));
        fs::write(folder.path().join("answer.json"), "old").unwrap();
    }
    assert_eq!(names(folder.path()), ["answer.json"]);
}

#[test]
fn a_link_to_nothing_is_kept_and_its_target_made() {
    let folder = here();
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("answers")).unwrap();
    symlink("answers/today.txt", path("latest.txt")).unwrap();
    let done = output(folder.path(), &["schemes", "-o", "latest.txt"]);
    assert!(done.status.success(), "{done:?}");
    assert!(path("latest.txt").is_symlink() && path("answers/today.txt").is_file());
    symlink("none/today.txt", path("lost.txt")).unwrap();
    let done = output(folder.path(), &["schemes", "-o", "lost.txt"]);
    let due = "error: lost.txt: cannot be written: there is no folder ./none\n";
    assert_eq!((done.status.code(), text(&done.stderr).as_str()), (Some(3), due));
    assert!(path("lost.txt").is_symlink());
}

/// A writer that is killed leaves its temporary file. The next call in that folder removes it, but no file of
/// a living program.
#[test]
fn what_a_killed_program_left_is_removed_by_the_next() {
    let folder = here();
    let pipe = folder.path().join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let temporary = || names(folder.path()).into_iter().find(|name| name.starts_with(".epicyclic-"));
    // The picture is complete, and the pipe waits for a reader.
    let line = [&MOTOR[..], &["--svg", "motor.svg", "--csv", "pipe"]].concat();
    let mut writer =
        program(folder.path(), &line).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    let start = Instant::now();
    while temporary().is_none()
        && start.elapsed() < Duration::from_secs(60)
        && writer.try_wait().unwrap().is_none()
    {
        std::thread::sleep(Duration::from_millis(2));
    }
    let left = temporary();
    let other = || output(folder.path(), &["schemes", "-o", "schemes.txt"]);
    let beside = other();
    let kept = temporary();
    // Before any of this is judged: nothing else would end it.
    writer.kill().unwrap();
    writer.wait().unwrap();
    assert!(left.is_some() && beside.status.success(), "{beside:?}");
    assert_eq!(kept, left, "a living writer's file");
    assert_eq!(temporary(), left);
    assert!(other().status.success());
    assert_eq!(names(folder.path()), ["pipe", "schemes.txt"]);
}

#[test]
fn files_beyond_the_limit_are_refused_at_once() {
    let folder = here();
    let large = File::create(folder.path().join("large.yaml")).unwrap();
    large.set_len(65_000_000).unwrap();
    let mut files = vec![("large.yaml", ": it has 65000000")];
    if Path::new("/dev/zero").exists() {
        files.push(("/dev/zero", ""));
    }
    for command in ["analyze", "drive", "report", "draw"] {
        for (file, size) in &files {
            let start = Instant::now();
            let done = output(folder.path(), &[command, file]);
            let due = format!(
                "error: {file}:1:1: the file is larger than 4194304 bytes{size}; a description is text and far smaller\n"
            );
            assert_eq!((done.status.code(), text(&done.stderr)), (Some(2), due));
            assert!(start.elapsed() < Duration::from_secs(5), "{command} {file}");
        }
    }
}

/// Whatever a file or a name contains, only text is written to the terminal.
#[test]
fn control_characters_are_written_out() {
    let folder = here();
    let path = |name: &str| folder.path().join(name);
    // An escape sequence, a line break, a new direction of reading, a character without width, C1's "control
    // sequence".
    let name = r"s\e[31m\nerror: \u202Elow\u200B\x9Bm";
    let hostile = BOX
        .replace("conveyor", &format!("\"{name}\""))
        .replace("slow", &format!("\"{name}\""))
        .replace("K1", &format!("\"{name}\""));
    fs::write(path("box.yaml"), &hostile).unwrap();
    let file = "b\u{1b}[2J\nx\u{202e}.yaml";
    fs::write(path(file), &hostile).unwrap();
    fs::write(path("drive.yaml"), format!("title: \"{name}\"\n\"{name}\": 1\n\"{name}\": 1\n")).unwrap();
    let gear = "s\u{1b}[31m\nerror: \u{202e}low\u{200b}\u{9b}m";
    let is_plain = |shown: &str| {
        !shown.contains(|c: char| {
            (c.is_control() && c != '\n') || matches!(c, '\u{202e}' | '\u{200b}' | '\u{feff}')
        })
    };
    let missing = format!("{file}.not");
    for line in [
        &["analyze", "box.yaml"][..],
        &["analyze", file],
        &["analyze", file, "--gear", gear],
        &["analyze", "box.yaml", "--gear", gear, "--torque", "500 N·m", "--speed", "100 rpm"],
        &["analyze", "box.yaml", "--gear", "\u{1b}[2J"],
        &["analyze", "box.yaml", "--all-combinations"],
        &["analyze", &missing],
        &["analyze", "box.yaml", "-o", "no\u{1b}[2J\n/such"],
        &["drive", "drive.yaml"],
        &["drive", file],
        &["draw", file, "--svg", "\u{1b}[2J\n.svg"],
        &["draw", &missing],
        &["draw", "II-3", "--title", gear, "--svg", "a.svg"],
        &["schemes", "\u{1b}]0;title\u{7}"],
        &["teeth", "--ratio", "\u{1b}[31m\n6"],
        &["teeth", "--ratio", "6", "--sun", "\u{1b}[31m..\u{202e}"],
        &["teeth", "--ratio", "6", "--mode", "\u{1b}[31m\nx"],
        &["teeth", "--\u{1b}[31m\n"],
        &["\u{1b}[31m\u{202e}"],
        &["machine", "list", "\u{1b}[31m"],
        &["machine", "speeds", "\u{1b}[31m"],
        &["report", "box.yaml", "--gear", gear],
        &["report", "box.yaml"],
    ] {
        let done = output(folder.path(), line);
        let seen = text(&done.stdout) + &text(&done.stderr);
        assert!(!seen.is_empty() && is_plain(&seen), "{line:?}\n{seen:?}");
        // No line that a name has begun.
        let has_forged = seen.lines().skip(1).any(|line| line.starts_with("error: "));
        assert!(!has_forged || line[0] == "report", "{line:?}\n{seen}");
    }
    // Files for programs: each as its format has it.
    for (kind, view) in [("svg", "scheme"), ("dxf", "scheme"), ("svg", "ladder"), ("dxf", "levers")] {
        let drawing = format!("drawing.{kind}");
        let done = output(folder.path(), &["draw", "box.yaml", "--view", view, "-o", &drawing]);
        assert!(done.status.success(), "{done:?}");
        let drawing = fs::read_to_string(path(&drawing)).unwrap();
        assert!(!drawing.contains(|c: char| c.is_control() && c != '\n' && c != '\r'), "{kind} {view}");
        if kind == "svg" {
            resvg::usvg::Tree::from_str(&drawing, &resvg::usvg::Options::default()).unwrap();
        } else {
            dxf::Drawing::load(&mut drawing.as_bytes()).unwrap();
        }
    }
    let json = output(folder.path(), &["analyze", "box.yaml", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["gears"][0]["gear"], gear);
}

/// One fault has one exit code in every command.
#[test]
fn the_same_fault_of_a_file_ends_with_the_same_code() {
    let folder = here();
    let write = |name: &str, text: String| fs::write(folder.path().join(name), text).unwrap();
    write("syntax.yaml", "a: [".to_owned());
    write("empty.yaml", String::new());
    write("other.yaml", "x: 1\n".to_owned());
    write("unknown-key.yaml", format!("{BOX}colour: red\n"));
    write(
        "no-row.yaml",
        BOX.replace("sets: [{ id: P, sun: D, ring: T1, carrier: B, k: 2.94, efficiency: 0.97 }]", "sets: []"),
    );
    write("k.yaml", BOX.replace("2.94", "0.5"));
    write("no-link.yaml", BOX.replace("link: T1", "link: T9"));
    write("engaged.yaml", BOX.replace("engaged: [K1]", "engaged: [K9]"));
    write("printed.yaml", {
        let all = fs::read_to_string(examples().join("real-transmissions.yaml")).unwrap();
        all.replace("printed_decimals: 3", "printed_decimals: 65536")
    });
    fs::create_dir(folder.path().join("folder.yaml")).unwrap();
    for (file, code) in [
        ("missing.yaml", 3),
        ("folder.yaml", 3),
        ("syntax.yaml", 2),
        ("empty.yaml", 2),
        ("other.yaml", 2),
        ("unknown-key.yaml", 2),
        ("no-row.yaml", 2),
        ("k.yaml", 2),
        ("no-link.yaml", 2),
        ("engaged.yaml", 2),
        ("printed.yaml", 2),
    ] {
        for command in ["analyze", "report", "draw"] {
            let done = output(folder.path(), &[command, file]);
            let message = text(&done.stderr);
            assert_eq!(done.status.code(), Some(code), "{command} {file}: {message}");
            assert!(message.starts_with(&format!("error: {file}:")), "{command}: {message}");
        }
    }
}

#[test]
fn a_picture_beyond_the_paper_is_the_fault_of_its_file_for_each_command() {
    let folder = here();
    let motor = fs::read_to_string(examples().join("motor-5x3.yaml")).unwrap();
    fs::write(folder.path().join("motor.yaml"), motor.replace(" mm", " km")).unwrap();
    for command in ["draw", "report"] {
        let done = output(folder.path(), &[command, "motor.yaml"]);
        let message = text(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{command}: {message}");
        assert!(
            message.starts_with("error: motor.yaml:8:9: module: ") && message.contains("must lie between"),
            "{message}"
        );
    }
}

#[test]
fn no_answer_has_a_number_that_is_none() {
    let folder = here();
    let file = examples().join("scheme-ii-3.yaml");
    let file = file.to_str().unwrap();
    let lines = [
        ("analyze FILE --gear slow --speed '1e200 rad/s' --torque '1e200 N·m'", "at most 1e6 rad/s"),
        ("analyze FILE --gear slow --speed '1 rad/s' --torque '1e200 N·m'", "at most 1e12 N·m"),
        ("machine chain-cutter --pick-spacing '40 cm' --feed '1e308 m/s' --chip '5 mm'", "at most 1e6 m/s"),
        ("machine drum --diameter '1 m' --feed '1e308 m/s' --chip '5 mm' --picks 2", "at most 1e6 m/s"),
        ("teeth --ratio 6 --tolerance 1e308", "at most 1e12 in size"),
        ("teeth --ratio 1e308", "at most 1e12 in size"),
        ("teeth --ratio 6 --k 1..1e300", "at most 1e12 in size"),
        (
            "machine chain-cutter --pick-spacing '1000 km' --feed '1e6 m/s' --chip '1e-300 mm'",
            "not a finite number: ",
        ),
    ];
    for (line, due) in lines {
        for format in ["table", "json", "csv"] {
            let done = run(folder.path(), &format!("{} --format {format}", line.replace("FILE", file)));
            let is_empty = done.stdout.is_empty() || text(&done.stdout).contains("\"answer\": \"error\"");
            assert_eq!((done.status.code(), is_empty), (Some(2), true), "{line:?} {done:?}");
            assert!(text(&done.stderr).contains(due), "{done:?}");
        }
    }
}

/// A picture that cannot be drawn is an error with the place of the gear; a page leaves that picture out.
#[test]
fn a_picture_that_cannot_be_drawn_names_its_place() {
    let folder = here();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    let gears = BOX.replace("brakes: [{", "brakes: [{ id: K3, link: B }, {").replace(
        "{ name: slow, engaged: [K1] }, { name: fast, engaged: [K2] }",
        "{ name: blocked, engaged: [K1, K3] }, { name: loose, engaged: [] }",
    );
    write("box.yaml", &gears);
    let motor = fs::read_to_string(examples().join("motor-5x3.yaml")).unwrap();
    write("large.yaml", &motor.replace("module: 2 mm", "module: 1e9 mm").replace("l: 80 mm", "part: 0.5"));
    for (line, place) in [
        (
            &["draw", "box.yaml", "--gear", "blocked", "--power"][..],
            "box.yaml:7:17: gears[0].name: gear blocked is input blocked",
        ),
        (
            &["draw", "box.yaml", "--gear", "loose", "--view", "speeds"],
            "box.yaml:7:55: gears[1].name: gear loose is underdetermined",
        ),
        (
            &["draw", "box.yaml", "--view", "ladder"],
            "box.yaml:7:8: gears: none of the 2 gears of conveyor has a ratio",
        ),
        (&["draw", "large.yaml"], "large.yaml:"),
        (&["report", "large.yaml"], "large.yaml:"),
    ] {
        let done = output(folder.path(), line);
        let told = text(&done.stderr);
        assert!(
            done.status.code() == Some(2) && told.starts_with(&format!("error: {place}")),
            "{line:?}: {told}"
        );
    }
    assert!(output(folder.path(), &["report", "box.yaml"]).status.success());
}

/// A command whose input comes from a pipe.
fn piped(folder: &Path, args: &[&str], input: &[u8]) -> std::process::Output {
    use std::io::Write as _;
    let mut command = program(folder, args);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    // One that refuses before it reads closes the pipe.
    let _ = child.stdin.take().unwrap().write_all(input);
    child.wait_with_output().unwrap()
}

/// A drive, a gearbox and a motor, each by every command that reads one.
#[test]
fn a_hyphen_is_standard_input_in_every_command_that_reads_a_file() {
    let folder = here();
    let [drive, gearbox, motor] = ["minimal-drive.yaml", "scheme-ii-3.yaml", "motor-5x3.yaml"]
        .map(|name| (name, fs::read(examples().join(name)).unwrap()));
    for ((name, content), line) in [
        (&drive, &["drive", "FILE"][..]),
        (&drive, &["report", "FILE"]),
        (&gearbox, &["analyze", "FILE"]),
        (&gearbox, &["analyze", "FILE", "--gear", "slow"]),
        (&gearbox, &["compare", "FILE", "II-3", "--k1", "2", "--k2", "2", "--format", "csv"]),
        (&gearbox, &["draw", "FILE"]),
        (&gearbox, &["report", "FILE", "--format", "json"]),
        (&gearbox, &["synthesize", "--ratios", "2.56, 1.465", "--explain", "FILE"]),
        (&motor, &["draw", "FILE", "--view", "centrodes"]),
        (&motor, &["report", "FILE"]),
    ] {
        fs::write(folder.path().join(name), content).unwrap();
        let with = |file: &'static str| -> Vec<&str> {
            line.iter().map(|word| if *word == "FILE" { file } else { word }).collect()
        };
        let from_file = output(folder.path(), &with(name));
        let from_pipe = piped(folder.path(), &with("-"), content);
        assert!(from_file.status.success(), "{line:?} {}", text(&from_file.stderr));
        assert_eq!(text(&from_pipe.stdout), text(&from_file.stdout), "{line:?}");
        assert_eq!((from_pipe.status, from_pipe.stderr), (from_file.status, from_file.stderr), "{line:?}");
    }
}

#[test]
fn faults_of_standard_input_are_told_with_their_place() {
    let folder = here();
    let told = |input: &str| {
        let done = piped(folder.path(), &["analyze", "-"], input.as_bytes());
        assert_eq!(done.status.code(), Some(2));
        text(&done.stderr)
    };
    let misspelt = told(&BOX.replace("carrier", "carier"));
    assert!(misspelt.starts_with("error: standard input:4:"), "{misspelt}");
    assert!(told("").starts_with("error: standard input"), "{}", told(""));
    // A file of this name is written with its folder.
    fs::write(folder.path().join("-"), BOX).unwrap();
    assert!(output(folder.path(), &["analyze", "./-"]).status.success());
}

#[test]
fn tables_take_the_width_of_the_terminal_and_no_number_is_parted() {
    let shown = |columns: &str| {
        let line = ["analyze", "real-transmissions.yaml", "--transmission", "8HP", "--efficiency", "0.97"];
        let done = program(&examples(), &line).env("COLUMNS", columns).output().unwrap();
        assert!(done.status.success());
        text(&done.stdout)
    };
    let whole = ["1171/911", "-346/105", "-3.2952", "0.9853"];
    for columns in [20, 30, 40, 60, 80, 132] {
        let table = shown(&columns.to_string());
        // The address of the source is one word.
        let wide = |line: &&str| line.chars().count() > columns && !line.starts_with("wikiwand.com");
        let wide: Vec<&str> = table.lines().filter(wide).collect();
        assert!(wide.is_empty(), "{columns}: {wide:?}");
        assert!(whole.iter().all(|number| table.contains(number)), "{columns}: {table}");
    }
    // What says no number of columns is as none.
    assert!(shown("wide") == shown("80") && shown("0") == shown("80") && shown("132") != shown("80"));
}
