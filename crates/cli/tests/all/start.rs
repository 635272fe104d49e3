//! Files to start from, and keys to paste into a file that lacks them.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{here, output, run, text};
use serde_json::Value;
use std::fs;

/// A file of `init` works with the commands that its first lines name.
#[test]
fn a_file_to_start_from_works_with_the_commands_it_names() {
    for kind in ["gearbox", "drive", "motor", "scenario"] {
        let folder = here();
        let file = format!("{kind}.yaml");
        assert!(output(folder.path(), &["init", kind, "-o", &file]).status.success());
        let written = fs::read_to_string(folder.path().join(&file)).unwrap();
        assert_eq!(text(&output(folder.path(), &["init", kind]).stdout), written);
        let commands: Vec<&str> =
            written.lines().filter_map(|line| line.strip_prefix("#   epicyclic ")).collect();
        assert!(commands.len() > 1, "{kind}");
        for command in commands {
            let done = run(folder.path(), command);
            assert!(done.status.success(), "{command}: {}", text(&done.stderr));
        }
    }
}

#[test]
fn a_file_that_exists_is_kept_unless_it_is_to_be_replaced() {
    let folder = here();
    let file = folder.path().join("box.yaml");
    fs::write(&file, "mine").unwrap();
    let done = output(folder.path(), &["init", "drive", "-o", "box.yaml"]);
    let said = text(&done.stderr);
    assert_eq!(done.status.code(), Some(2));
    assert!(said.contains("box.yaml exists") && said.contains("--replace"), "{said}");
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
    assert!(output(folder.path(), &["init", "drive", "-o", "box.yaml", "--replace"]).status.success());
    assert!(fs::read_to_string(&file).unwrap().contains("power: 30 kW"));
}

/// Files that lack keys: all of them, those of single sets, single ones, also of sets in braces.
const LACKING: [&str; 4] = [
    "\
gearbox: hoist
input: s
output: h
sets:
  - id: P
    sun: s
    ring: ground
    carrier: h
    teeth: [24, 84]
gears: [{ name: only }]
",
    "\
gearbox: several
input: a
output: d
life: 1000 h
sets:
  - { id: one, sun: a, ring: ground, carrier: b, teeth: [24, 84] }
  - id: 'two, b'
    sun: b
    ring: ground
    carrier: c
    teeth: [24, 84]
    strength:
      materials: { sun: 18CrNiMo7-6, planet: 18CrNiMo7-6 }
      factors: { KA: 1.5 }
  - id: pair
    kind: external_pair
    sun: c
    ring: d
    teeth: [20, 41]
gears: [{ name: '1' }, { name: 'x, y', output: c }]
",
    "\
gearbox: two planets
input: s
output: h
oil: { viscosity: 100 mm²/s }
sets:
  - teeth: [30, 72]
    id: D
    kind: double_planet
    planet_teeth: [15, 18]
    sun: s
    ring: ground
    carrier: h
gears: [{ name: only }]
",
    "\
gearbox: compound
input: s
output: h
compound_sets:
  - id: C
    carrier: h
    suns: { s: 24 }
    rings: { ground: 84 }
    planet_gears: { p: [30] }
    meshes:
      - { gears: [s, p] }
      - { gears: [p, ground] }
gears: [{ name: only }]
",
];

/// A file with the lines of a refusal put where they say that they belong.
fn pasted(file: &str, refusal: &str) -> String {
    let mut lines: Vec<String> = file.lines().map(str::to_owned).collect();
    for part in refusal.trim_end().split("\n\n").skip(1) {
        let (place, own) = part.split_once('\n').unwrap();
        let number = |after: &str| {
            let digits = place.split_once(after).unwrap().1;
            digits.chars().take_while(char::is_ascii_digit).collect::<String>().parse::<usize>().unwrap()
        };
        if place == "# at the end of the file" {
            lines.push(own.to_owned());
        } else if place.starts_with("# below line ") {
            lines.insert(number("line "), own.to_owned());
        } else {
            assert!(place.starts_with("# in the braces of line "), "{place}");
            let line = &mut lines[number("line ") - 1];
            let end = line.rfind('}').unwrap();
            line.insert_str(end, own);
        }
    }
    lines.join("\n") + "\n"
}

#[test]
fn lines_of_a_refusal_work_where_they_are_pasted() {
    for command in [
        &[
            "size",
            "--modules",
            "3mm,4mm,5mm",
            "--face-widths",
            "40mm,80mm",
            "--planets",
            "3",
            "--no-bearings",
            "--beyond-practice",
        ][..],
        &["strength"],
        &["strength", "--torque", "100 N·m", "--speed", "1450 rpm"],
    ] {
        for file in LACKING {
            let folder = here();
            let path = folder.path().join("box.yaml");
            fs::write(&path, file).unwrap();
            let line = [command, &["box.yaml"]].concat();
            let refused = output(folder.path(), &line);
            let said = text(&refused.stderr);
            assert_eq!(refused.status.code(), Some(2), "{line:?} {said}");
            let pasted = pasted(file, &said);
            fs::write(&path, &pasted).unwrap();
            let done = output(folder.path(), &line);
            assert_eq!(done.status.code(), Some(0), "{line:?}\n{pasted}\n{}", text(&done.stderr));
        }
    }
}

#[test]
fn an_application_gives_what_the_file_lacks_and_the_answer_lists_it() {
    let folder = here();
    let duty = "duty: [{ gear: only, share: 1, torque: 60 N·m, speed: 1450 rpm }]\nlife: 7000 h\n";
    fs::write(folder.path().join("box.yaml"), LACKING[0].to_owned() + duty).unwrap();
    let line = ["size", "box.yaml", "--application", "winch", "--format", "json", "--save", "sized.yaml"];
    let done = output(folder.path(), &line);
    assert!(done.status.success(), "{}", text(&done.stderr));
    let answer: Value = serde_json::from_slice(&done.stdout).unwrap();
    let listed = |key: &str| {
        let all = answer["basis"].as_array().unwrap();
        all.iter().find(|one| one["key"] == key).map(|one| one["value"].as_str().unwrap().to_owned())
    };
    assert_eq!(listed("life"), None);
    assert_eq!(answer["life_s"], 7000.0 * 3600.0);
    assert_eq!(listed("required").unwrap(), "flank 1.1, root 1.5");
    assert!(listed("strength.factors").unwrap().starts_with("K_A 1.4"));
    assert_eq!(answer["required"]["root"], 1.5);
    // The saved file states them.
    let done = output(folder.path(), &["strength", "sized.yaml"]);
    assert!(done.status.success(), "{}", text(&done.stderr));
}
