//! Faults put into gearbox files of several styles: each is found with its name, line, column and path, alone
//! and together with another one.

#![allow(clippy::unwrap_used, reason = "tests")]

use epicyclic_formats::Document;
use epicyclic_formats::gearbox::GearboxFile;
use proptest::prelude::*;

/// Changed text, the wrong key or value in it, path and name of the fault.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static str);

/// Texts between `@` and `@` are the wrong keys and values.
const CASES: [Case; 24] = [
    ("sun: D", "@sunn@: D", "sets[0].sunn", "unknown-key", ""),
    ("sun: D", "sun: @[D]@", "sets[0].sun", "wrong-type", ""),
    ("sun: D", "sun: @12@", "sets[0].sun", "wrong-type", ""),
    ("teeth: [20, 60]", "teeth: [@twenty@, 60]", "sets[0].teeth[0]", "wrong-type", ""),
    ("teeth: [20, 60]", "teeth: [20, @-60@]", "sets[0].teeth[1]", "out-of-range", ""),
    ("teeth: [20, 60]", "teeth: [20, @60.5@]", "sets[0].teeth[1]", "wrong-type", ""),
    ("teeth: [20, 60]", "teeth: @20@", "sets[0].teeth", "wrong-type", ""),
    ("planets: 3", "planets: @'3'@", "sets[0].planets", "wrong-type", ""),
    ("planets: 3", "planets: @true@", "sets[0].planets", "wrong-type", ""),
    ("planets: 3", "planets: @4294967296@", "sets[0].planets", "out-of-range", ""),
    ("module: 4 mm", "module: @4@", "sets[0].module", "missing-unit", ""),
    ("module: 4 mm", "module: @4 kW@", "sets[0].module", "wrong-dimension", ""),
    ("module: 4 mm", "module: @4 mmm@", "sets[0].module", "unknown-unit", ""),
    ("module: 4 mm", "module: @'4,5 mm'@", "sets[0].module", "decimal-comma", ""),
    ("module: 4 mm", "@modul@: 4 mm", "sets[0].modul", "unknown-key", ""),
    ("spacing: equal", "spacing: @even@", "sets[0].spacing", "unknown-name", ""),
    ("id: K1", "@name@: K1", "brakes[0].name", "unknown-key", "id"),
    ("link: T1", "link: @{ T1: 1 }@", "brakes[0].link", "wrong-type", ""),
    ("name: slow", "name: @~@", "gears[0].name", "wrong-type", ""),
    ("engaged: [K1]", "engaged: @K1@", "gears[0].engaged", "wrong-type", ""),
    ("engaged: [K1]", "engaged: [@1.5@]", "gears[0].engaged[0]", "wrong-type", ""),
    ("density: 7800 kg/m³", "density: @7800 kg@", "density", "wrong-dimension", ""),
    ("addendum: 1.0", "addendum: @1 mm@", "addendum", "unexpected-unit", ""),
    ("addendum: 1.0", "@addendums@: 1.0", "addendums", "unknown-key", ""),
];

const KEYS: [(&str, &[&[&str]]); 3] = [
    (
        "sets",
        &[&[
            "id: P",
            "sun: D",
            "ring: T1",
            "carrier: B",
            "teeth: [20, 60]",
            "planets: 3",
            "module: 4 mm",
            "spacing: equal",
        ]],
    ),
    ("brakes", &[&["id: K1", "link: T1"]]),
    ("gears", &[&["name: slow", "engaged: [K1]"]]),
];

/// A gearbox file in a style: entries in braces or line by line, remarks, depth of indentation.
fn written(is_flow: bool, has_remarks: bool, depth: usize) -> String {
    let mut text = String::from("gearbox: I\ninput: D\noutput: B\ndensity: 7800 kg/m³\naddendum: 1.0\n");
    let indent = " ".repeat(depth);
    for (list, entries) in KEYS {
        if has_remarks {
            text.push_str("# ä remark: [\n\n");
        }
        text.push_str(&format!("{list}:\n"));
        for keys in entries {
            if is_flow {
                text.push_str(&format!("{indent}- {{ {} }}\n", keys.join(", ")));
            } else {
                let between = format!("\n{indent}  ");
                text.push_str(&format!("{indent}- {}\n", keys.join(&between)));
            }
        }
    }
    text
}

/// Takes the marks out of a text: line and column of the wrong parts.
fn unmarked(text: &str) -> (String, Vec<(usize, usize)>) {
    let (mut plain, mut places, mut is_open) = (String::new(), vec![], false);
    for (line, content) in text.lines().enumerate() {
        let mut column = 1;
        for c in content.chars() {
            if c == '@' {
                is_open = !is_open;
                if is_open {
                    places.push((line + 1, column));
                }
            } else {
                plain.push(c);
                column += 1;
            }
        }
        plain.push('\n');
    }
    (plain, places)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn faults_are_found_where_they_were_put(
        one in 0..CASES.len(), other in prop::option::of(0..CASES.len()), is_flow: bool, has_remarks: bool, depth in 0..5_usize,
    ) {
        let mut put = vec![CASES[one]];
        put.extend(other.map(|other| CASES[other]).filter(|case| case.0 != CASES[one].0));
        let mut text = written(is_flow, has_remarks, depth);
        for (from, to, ..) in &put {
            prop_assert_eq!(text.matches(from).count(), 1);
            text = text.replace(from, to);
        }
        let (text, places) = unmarked(&text);
        let error = Document::parse_one("box.yaml", text.as_bytes()).unwrap().read::<GearboxFile>().unwrap_err();
        let found: Vec<_> = error
            .faults()
            .filter(|fault| fault.problem.name() != "missing-key")
            .map(|fault| (fault.at.path.to_string(), fault.problem.name(), (fault.at.position.line, fault.at.position.column)))
            .collect();
        let mut expected: Vec<_> = put.iter().map(|case| (case.2.to_owned(), case.3)).collect();
        expected.sort();
        let mut of_found: Vec<_> = found.iter().map(|(path, name, _)| (path.clone(), *name)).collect();
        of_found.sort();
        prop_assert_eq!(of_found, expected, "{}\n{}", text, error);
        prop_assert_eq!(found.iter().map(|(.., at)| *at).collect::<Vec<_>>(), places, "{}", text);
        // A key whose likely meaning is known is not reported as missing besides.
        let missing: Vec<_> = error.faults().filter(|fault| fault.problem.name() == "missing-key").collect();
        prop_assert_eq!(missing.len(), put.iter().filter(|case| !case.4.is_empty()).count(), "{}", error);
    }
}

#[test]
fn missing_keys_and_wrong_values_are_found_together() {
    let text = "gearbox: I\noutput: 3\nsets:\n- { id: P, sun: D, ring: T1, k: 3,94 }\n- { sun: D, k: a }\n";
    let document = Document::parse_one("box.yaml", text.replace("3,94", "'3,94'").as_bytes()).unwrap();
    let faults: Vec<String> = document
        .read::<GearboxFile>()
        .unwrap_err()
        .faults()
        .map(|fault| format!("{} {}", fault.at, fault.problem.name()))
        .collect();
    assert_eq!(
        faults,
        [
            "box.yaml:1:1 missing-key",
            "box.yaml:2:9: output wrong-type",
            "box.yaml:4:33: sets[0].k decimal-comma",
            "box.yaml:5:3: sets[1] missing-key",
            "box.yaml:5:3: sets[1] missing-key",
            "box.yaml:5:16: sets[1].k wrong-type",
        ]
    );
}
