//! Refusals for programs: a name that stays, the option or the place in a file, for every way in which a call
//! can be wrong.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common;

use common::{examples, here, output, text};
use serde_json::Value;
use std::fs;
use std::path::Path;

fn refused(folder: &Path, line: &[&str]) -> Value {
    let done = output(folder, line);
    assert!(!done.status.success(), "{line:?}");
    serde_json::from_slice(&done.stdout).unwrap_or_else(|error| panic!("{line:?}: {error}: {done:?}"))
}

#[test]
fn a_wrong_command_line_is_refused_in_json() {
    let folder = here();
    for (line, name, option) in [
        ("teeth --ratio abc --format json", "invalid-value", Some("--ratio")),
        ("teeth --format=json --ratio abc", "invalid-value", Some("--ratio")),
        ("teeth --ratio 6 --rato 7 --format json", "unknown-argument", Some("--rato")),
        ("teeth --format json", "missing-argument", Some("--ratio")),
        ("analyze --format json", "missing-argument", None),
        (
            "analyze x.yaml --torque 1N·m --power 1kW --speed 1rpm --format json",
            "argument-conflict",
            Some("--torque"),
        ),
        ("tooth --format json", "unknown-command", None),
        ("machine --format json", "unknown-argument", Some("--format")),
    ] {
        let words: Vec<&str> = line.split(' ').collect();
        let found = refused(folder.path(), &words);
        assert_eq!(
            (found["answer"].as_str(), found["name"].as_str()),
            (Some("error"), Some(name)),
            "{line}: {found}"
        );
        assert_eq!(
            (found["option"].as_str(), found["exit_code"].as_u64()),
            (option, Some(2)),
            "{line}: {found}"
        );
        let message = found["message"].as_str().unwrap();
        assert!(!message.is_empty() && !message.contains('\n') && !message.starts_with("error"), "{message}");
        // People are told the same as without JSON.
        assert!(text(&output(folder.path(), &words).stderr).starts_with("error: "), "{line}");
    }
    // Where JSON goes to a file, or is not asked for, standard output stays empty.
    for line in
        ["teeth --ratio abc", "teeth --ratio abc --format json -o x", "teeth --ratio abc -- --format json"]
    {
        let words: Vec<&str> = line.split(' ').collect();
        assert!(output(folder.path(), &words).stdout.is_empty(), "{line}");
    }
}

/// Name, value, remedy and path of each fault.
fn faults(refused: &Value) -> Vec<[Option<&str>; 4]> {
    let faults = refused["faults"].as_array().unwrap().iter();
    let of =
        |fault| ["/name", "/value", "/remedy", "/place/path"].map(|key| Value::pointer(fault, key)?.as_str());
    faults.map(of).collect()
}

#[test]
fn all_faults_are_listed_with_value_and_remedy() {
    let folder = here();
    let text = "gearbox: I\ninput: D\noutput: B\nsets:\n- { id: P, sun: D, ring: T1, carrier: B, k: 3 }\n\
                brakes:\n- { id: K1, link: T1 }\n- { id: K2, link: T12 }\ngears:\n- { name: slow, engaged: [K1, K3] }\n";
    let file = folder.path().join("box.yaml");
    let line = ["analyze", "box.yaml", "--format", "json"];
    fs::write(&file, text.replace("k: 3", "k: 0.5")).unwrap();
    let found = refused(folder.path(), &line);
    let expected = [
        [Some("ring-to-sun-ratio"), Some("0.5"), None, Some("sets[0].k")],
        [Some("unknown"), Some("T12"), Some("T1"), Some("brakes[1].link")],
        [Some("unknown"), Some("K3"), Some("K1"), Some("gears[0].engaged[1]")],
    ];
    assert_eq!(faults(&found), expected, "{found}");
    assert_eq!(found["faults"][0]["place"], found["place"]);
    fs::write(&file, text.replace("k: 3", "k: '3,94', modul: 4 mm")).unwrap();
    let found = refused(folder.path(), &line);
    let expected = [
        [Some("decimal-comma"), Some("3,94"), Some("3.94"), Some("sets[0].k")],
        [Some("unknown-key"), Some("modul"), Some("module"), Some("sets[0].modul")],
    ];
    assert_eq!(faults(&found), expected, "{found}");
    // Of the command line.
    let found = refused(folder.path(), &["teeth", "--ratoi", "5", "--format", "json"]);
    assert_eq!(
        faults(&found),
        [[Some("unknown-argument"), Some("--ratoi"), Some("--ratio"), None]],
        "{found}"
    );
    let found = refused(folder.path(), &["teeth", "--ratio", "abc", "--format", "json"]);
    assert_eq!(faults(&found), [[Some("invalid-value"), Some("abc"), None, None]], "{found}");
}

#[test]
fn a_fault_of_a_motor_file_is_at_its_key_and_of_an_option_at_the_option() {
    let folder = here();
    let motor = "# A motor.\nstator: 5\nrotor: 3\nz3: 55\nzs: 10\nmodule: 2 mm\n";
    for (more, path, name) in [
        ("width: 0 mm\n", "width", "not-positive"),
        ("width: -3 mm\n", "width", "not-positive"),
        ("pressure: 0 bar\n", "pressure", "pressure-drop"),
        ("teeth: { fillet: -1 }\n", "teeth.fillet", "out-of-range"),
    ] {
        let file = folder.path().join("motor.yaml");
        fs::write(&file, format!("{motor}{more}")).unwrap();
        for line in [
            &["motor", "motor.yaml", "--format", "json"][..],
            &["motor", "motor.yaml", "--format", "json", "--csv", "x.csv"],
        ] {
            let found = refused(folder.path(), line);
            let place = &found["place"];
            assert_eq!(
                (place["path"].as_str(), place["line"].as_u64()),
                (Some(path), Some(7)),
                "{more}: {found}"
            );
            assert_eq!((found["name"].as_str(), &found["option"]), (Some(name), &Value::Null), "{found}");
        }
    }
    fs::write(folder.path().join("motor.yaml"), motor).unwrap();
    let line = ["motor", "motor.yaml", "--format", "json", "--csv", "x.csv", "--points", "0"];
    assert_eq!(refused(folder.path(), &line)["option"], "--points");
    let own = ["motor", "--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", "2 mm"];
    let line = [&own[..], &["--width", "0 mm", "--format", "json"]].concat();
    assert_eq!(refused(folder.path(), &line)["option"], "--width");
}

#[test]
fn a_map_is_streamed_or_refused_with_its_size() {
    let folder = here();
    let file = examples().join("power-split.yaml");
    let map = |places: &str, format: &str| {
        let ranges = format!("engine=800rpm..4000rpm/{places}, generator=-5000rpm..5000rpm/{places}");
        let line =
            ["analyze", file.to_str().unwrap(), "--gear", "drive", "--map", &ranges, "--format", format];
        output(folder.path(), &line)
    };
    let done = map("1000", "table");
    assert_eq!((done.status.code(), done.stdout.len()), (Some(2), 0));
    let told = text(&done.stderr);
    assert!(
        told.starts_with("error: --map: ") && told.contains("000000 lines") && told.contains("--format csv"),
        "{told}"
    );
    // As a list and streamed the entries are the same.
    let csv = text(&map("12", "csv").stdout);
    let json: Value = serde_json::from_slice(&map("12", "json").stdout).unwrap();
    let entries = json["map"].as_array().unwrap();
    assert_eq!((csv.lines().count(), entries.len() % 144), (entries.len() + 1, 0));
    let table = text(&map("12", "table").stdout);
    assert!(table.lines().count() > entries.len(), "{table}");
}
