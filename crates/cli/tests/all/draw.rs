//! The command `draw`: pictures of gearboxes.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{examples, here, output, sessions, text};
use std::fs;

const BOXES: &str = "real-transmissions.yaml";

#[test]
fn drawings_are_files_that_say_their_size() {
    let folder = here();
    fs::copy(examples().join(BOXES), folder.path().join(BOXES)).unwrap();
    insta::assert_snapshot!(sessions(
        folder.path(),
        &[
            &["draw", "II-3", "-o", "ii-3.svg", "--dxf", "ii-3.dxf", "--title", "Scheme II-3"][..],
            &["draw", "ii-3", "--whole", "--same-side", "--svg", "whole.svg"],
            &[
                "draw",
                "I",
                "--k1",
                "2.94",
                "--gear",
                "1",
                "--power",
                "--efficiency",
                "0.97",
                "-o",
                "power.dxf"
            ],
            &["draw", BOXES, "--transmission", "prius", "--view", "ladder", "-o", "ladder.svg"],
            &[
                "draw",
                BOXES,
                "--transmission",
                "TH400",
                "--view",
                "levers",
                "--gear",
                "1",
                "-o",
                "levers.svg"
            ],
        ]
    ));
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    assert!(read("ii-3.svg").starts_with("<svg") && read("ii-3.svg").contains("Scheme II-3"));
    for name in ["ii-3.dxf", "power.dxf"] {
        assert!(read(name).contains("SECTION") && read(name).trim_end().ends_with("EOF"), "{name}");
    }
    // On standard output it is the same picture.
    let printed = text(&output(folder.path(), &["draw", "II-3", "--title", "Scheme II-3"]).stdout);
    assert_eq!(printed.trim_end(), read("ii-3.svg").trim_end());
}

/// Either set first, either brake as T1: the same gearbox, its links, sets and gears as they were named.
#[test]
fn a_structure_is_drawn_by_any_spelling_of_its_name() {
    let folder = here();
    let drawn = |args: &[&str]| {
        let args = [&["draw"], args].concat();
        text(&output(folder.path(), &args).stdout)
    };
    let ratio = |image: &str| {
        let ratio = image.split("i = ").nth(1).and_then(|rest| rest.split(['<', '"']).next());
        ratio.unwrap_or_else(|| panic!("no ratio in {image}")).to_owned()
    };
    let canonical = drawn(&["D.T1.B+T2.B.T1", "--k1", "1.618", "--k2", "2.5", "--gear", "2", "--power"]);
    assert!(canonical.contains("<svg"), "{canonical}");
    for (name, k1, k2, gear) in [
        ("D.T2.B+T1.B.T2", "1.618", "2.5", "1"),
        ("T2.B.T1+D.T1.B", "2.5", "1.618", "2"),
        ("t1.b.t2+d.t2.b", "2.5", "1.618", "1"),
    ] {
        let image = drawn(&[name, "--k1", k1, "--k2", k2, "--gear", gear, "--power"]);
        assert!(image.contains(&format!("{}, gear {gear}", name.to_uppercase())), "{name}");
        assert_eq!(ratio(&image), ratio(&canonical), "{name}");
    }
    let refused = |name: &str| text(&output(folder.path(), &["draw", name]).stderr);
    let unknown = refused("D.T1.B+D.T1.T3");
    assert!(unknown.contains("did you mean `D.T1.B+D.T1.T2`?"), "{unknown}");
    assert!(refused("D.T1.B+D.B.T1").contains("no structure"));
}

#[test]
fn what_is_drawn_and_what_cannot_be_are_told_as_data() {
    let folder = here();
    let told = |args: &[&str]| {
        let done = output(folder.path(), &[&["draw"], args, &["--format", "json"]].concat());
        let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        (done.status.code(), told)
    };
    let (code, drawn) = told(&["II-3", "-o", "ii-3.svg", "--dxf", "ii-3.dxf"]);
    assert_eq!((code, &drawn["view"]), (Some(0), &"scheme".into()));
    assert_eq!(drawn["files"][1]["format"], "dxf");
    assert!(folder.path().join("ii-3.svg").exists() && folder.path().join("ii-3.dxf").exists());
    // The size of the image itself.
    let image = fs::read_to_string(folder.path().join("ii-3.svg")).unwrap();
    let width = image.split("width=\"").nth(1).and_then(|rest| rest.split("mm").next()).unwrap();
    let width: f64 = width.parse().unwrap();
    assert!((drawn["sheet"]["width_m"].as_f64().unwrap() * 1000.0 - width).abs() < 0.01, "{width}");
    // A structure is drawn as it is named, whichever name it has.
    let (_, drawn) = told(&["T2.B.T1+D.T1.B", "--k1", "2.5", "--k2", "1.618", "--gear", "1"]);
    assert_eq!(drawn["subject"]["name"], "T2.B.T1+D.T1.B");
    assert_eq!(drawn["subject"]["sets"][0]["basic_ratio"], -2.5);
    let crossing = examples().join("self-crossing.yaml");
    let (code, none) = told(&[crossing.to_str().unwrap(), "-o", "none.svg"]);
    assert_eq!((code, &none["sheet"]), (Some(1), &serde_json::Value::Null));
    assert_eq!(none["conflict"]["shut_in"], serde_json::json!(["T1"]));
    assert_eq!(none["conflict"]["cannot_reach"], "housing");
    assert!(!folder.path().join("none.svg").exists());
}
