//! Keys of earlier days are refused with the word of today, at their place.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_formats::document::RENAMED;
use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use epicyclic_formats::{Document, drive};

/// Kind of file that an old key was in.
#[derive(Clone, Copy)]
enum In {
    Drive,
    Gearbox,
    Transmissions,
}

fn refusal(kind: In, text: &str) -> String {
    let document = Document::parse_one("file.yaml", text.as_bytes()).unwrap();
    let error = match kind {
        In::Drive => drive::read(&document).map(drop),
        In::Gearbox => document.read::<GearboxFile>().map(drop),
        In::Transmissions => document.read::<TransmissionsFile>().map(drop),
    };
    let error = error.unwrap_err();
    assert_eq!(error.name(), "renamed-key", "{error}");
    error.to_string()
}

const BOX: &str = "gearbox: I\ninput: D\noutput: B\nsets:\n- { id: P, sun: D, ring: T1, carrier: B, k: 3 }\n";
const LIST: &str = "transmissions:\n- name: pair\n  sets: [{ id: P, planet: pair, gear_a: X, gear_b: Y, z_a: 24, z_b: 77 }]\n  \
    links: { x: [X], y: [Y] }\n  input: x\n  output: y\n  shift_elements: {}\n  gears: []\n";

#[test]
fn every_old_key_is_refused_with_the_word_of_today() {
    let drive = "power: 30 kW\nspeed: 1450 rpm\nratio: 5\nwheels: { module: 5 mm, face_width: 50 mm }\n";
    let sized = BOX.replace("k: 3", "k: 3, bearing_capacity: 20 kN");
    let [rows, nodes, elements, controls] = [
        LIST.replace("  sets:", "  rows:"),
        LIST.replace("  links:", "  nodes:"),
        LIST.replace("shift_elements:", "elements:"),
        LIST.replace("shift_elements:", "controls:"),
    ];
    let cases = [
        ("wheels", In::Drive, drive.to_owned(), "4:1: "),
        ("rows", In::Gearbox, BOX.replace("sets:", "rows:"), "4:1: "),
        ("rows", In::Transmissions, rows, "3:3: transmissions[0]."),
        ("nodes", In::Transmissions, nodes, "4:3: transmissions[0]."),
        ("elements", In::Transmissions, elements, "7:3: transmissions[0]."),
        ("controls", In::Transmissions, controls, "7:3: transmissions[0]."),
        ("bearing_capacity", In::Gearbox, sized, "5:48: sets[0]."),
    ];
    for (old, new) in RENAMED {
        assert!(cases.iter().any(|case| case.0 == old), "no case of {old}");
        for (_, kind, text, place) in cases.iter().filter(|case| case.0 == old) {
            let expected = format!("file.yaml:{place}{old}: the key {old} is now {new}; write {new}");
            assert_eq!(refusal(*kind, text), expected);
        }
    }
}
