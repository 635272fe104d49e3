//! Planets on their carrier and on their pins: angles, load sharing, limits of speed; and teeth that are not
//! rated.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{SHARP, here, output, text};
use serde_json::Value;
use std::fs;
use std::path::Path;

fn json(folder: &Path, args: &[&str]) -> Value {
    let done = output(folder, &[args, &["--format", "json"]].concat());
    assert!(done.status.success(), "{args:?}: {}", text(&done.stderr));
    serde_json::from_slice(&done.stdout).unwrap()
}

fn names(answer: &Value) -> Vec<String> {
    let all = answer["warnings"].as_array().unwrap();
    all.iter().map(|one| one["name"].as_str().unwrap().to_owned()).collect()
}

/// Four planets of 26, 35 and 96 teeth, whose 122 assembly positions are not divisible by 4.
fn four(keys: &str) -> String {
    format!(
        "gearbox: four\ninput: sun\noutput: mast\nsets: [{{ id: P, sun: sun, ring: ground, carrier: mast, teeth: [26, 96], planet_teeth: [35], module: 2.8 mm, face_width: 25 mm, {keys} }}]\ngears: [{{ name: only }}]\n"
    )
}

/// A set that `teeth` places at unequal angles is saved with them, and every command takes it there.
#[test]
fn what_teeth_places_at_unequal_angles_keeps_them_in_a_file() {
    let folder = here();
    let mut checked = 0;
    for args in [
        &["--ratio", "4.6923", "--sun", "26", "--planet", "35", "--ring", "96"][..],
        &["--ratio", "4.6923", "--sun", "26", "--ring", "..100", "--ring-offset=1..2", "--tolerance", "2%"],
        &["--ratio", "-1.6", "--double-planet"],
    ] {
        let args =
            [&["teeth", "--planets", "4", "--spacing", "least-unequal", "--limit", "40"], args].concat();
        let found = json(folder.path(), &args);
        let all = found["tooth_numbers"].as_array().unwrap();
        let Some(unequal) = all.iter().position(|set| set["equal_spacing"] == false) else { continue };
        let number = (unequal + 1).to_string();
        let saved = output(folder.path(), &[&args[..], &["--save", "set.yaml", "--nth", &number]].concat());
        assert!(saved.status.success(), "{}", text(&saved.stderr));
        let read = fs::read_to_string(folder.path().join("set.yaml")).unwrap();
        assert!(read.contains("spacing: least_unequal"), "{read}");
        let told = output(folder.path(), &["analyze", "set.yaml"]);
        let told = text(&told.stdout) + &text(&told.stderr);
        assert!(!told.contains("assembled"), "{told}");
        checked += 1;
    }
    assert!(checked > 1);
}

/// Stated angles are checked where they are; old files have them in `vibration`.
#[test]
fn stated_angles_are_the_angles_of_every_command() {
    let folder = here();
    let bodies = "planet_bearing: 400 N/µm, carrier: { mass: 5 kg, inertia: 0.05 kg·m² }, sun: { mass: 1 kg, inertia: 10 kg·cm² }, ring: { outside_diameter: 320 mm }";
    let angles = "planet_angles: [0 deg, 88.5246 deg, 180 deg, 268.5246 deg]";
    let vibrating = |keys: &str, more: &str| four(&format!("{keys}, vibration: {{ {bodies}{more} }}"));
    let files = [
        vibrating(angles, ""),
        vibrating("planets: 4", &format!(", {angles}")),
        vibrating("planets: 4, spacing: least_unequal", ""),
    ];
    let mut found: Vec<Value> = vec![];
    for file in &files {
        fs::write(folder.path().join("four.yaml"), file).unwrap();
        let warned = names(&json(folder.path(), &["analyze", "four.yaml"]));
        assert!(!warned.iter().any(|name| ["teeth", "planet-angle"].contains(&name.as_str())), "{warned:?}");
        let set = json(folder.path(), &["analyze", "four.yaml"])["sets"][0].clone();
        let vibration = json(folder.path(), &["vibrate", "four.yaml"])["sets"][0].clone();
        assert_eq!(vibration["equally_spaced"], false);
        found.extend([set, vibration["planet_angles_rad"].clone()]);
    }
    assert_eq!(found[..2], found[2..4]);
    assert_eq!(found[0], found[4]);
    for (one, other) in found[1].as_array().unwrap().iter().zip(found[5].as_array().unwrap()) {
        assert!((one.as_f64().unwrap() - other.as_f64().unwrap()).abs() < 1e-12);
    }
    // At equal angles they do not assemble, and at others that are no positions neither.
    for (keys, message) in [
        ("planets: 4", "4 planets cannot be assembled at equal angles"),
        ("planet_angles: [0 deg, 90 deg, 180 deg, 270 deg]", "planet 2 cannot be assembled at 90 deg"),
        ("planet_angles: [0 deg, 35.4098 deg]", "the tip circles of neighbours among 2 planets are"),
    ] {
        fs::write(folder.path().join("four.yaml"), four(keys)).unwrap();
        let told = json(folder.path(), &["analyze", "four.yaml"])["warnings"].to_string();
        assert!(told.contains(message), "{told}");
    }
    fs::write(folder.path().join("four.yaml"), vibrating(angles, &format!(", {angles}"))).unwrap();
    let refused = output(folder.path(), &["analyze", "four.yaml"]);
    assert!(text(&refused.stderr).contains("stated twice"), "{}", text(&refused.stderr));
}

/// One root outside the range of the standard leaves every other flank and root rated, and is named with its
/// value.
#[test]
fn a_root_outside_the_standard_withholds_nothing_else() {
    let folder = here();
    fs::write(folder.path().join("sharp.yaml"), SHARP).unwrap();
    let args = ["strength", "sharp.yaml", "--torque", "500 N·m", "--speed", "1000 rpm", "--factors"];
    let answer = json(folder.path(), &args);
    let not = answer["not_rated"].as_array().unwrap();
    assert!(!not.is_empty());
    for one in not {
        assert_eq!((&one["reason"], &one["place"]), (&"beyond_standard".into(), &"root".into()), "{one}");
        assert!(
            one["value"].as_f64().unwrap() > 8.0 && one["because"].as_str().unwrap().contains("q_s"),
            "{one}"
        );
    }
    let rows = answer["at_point"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let is_not = |one: &&Value| one["mesh"] == row["mesh"] && one["toothed_gear"] == row["toothed_gear"];
        assert_eq!(row["root_safety"].is_null(), not.iter().any(|one| is_not(&one)), "{row}");
        assert!(row["flank_safety"].as_f64().unwrap() > 0.0, "{row}");
    }
    assert!(rows.iter().any(|row| !row["root_safety"].is_null()));
    let table = output(folder.path(), &args);
    assert!(
        text(&table.stdout).contains("Not rated") && text(&table.stdout).contains("of what could be rated")
    );
    let page = output(folder.path(), &["report", "sharp.yaml", "--torque", "500 N·m", "--speed", "1000 rpm"]);
    assert!(page.status.success(), "{}", text(&page.stderr));
}

/// Limits of planets on their pins need a speed and a bearing: n·d_m of bearings with and without a cage, and
/// the orbit.
#[test]
fn fast_planets_are_held_against_their_bearings() {
    let folder = here();
    let set = |bearing: &str| {
        let keys = format!("planets: 3, load_rating: 40 kN{bearing}");
        fs::write(folder.path().join("four.yaml"), four(&keys).replace("[26, 96]", "[26, 97]")).unwrap();
    };
    let told = |speed: &str| {
        json(folder.path(), &["analyze", "four.yaml", "--speed", speed])["warnings"].to_string()
    };
    // n = 0.5857 of the input's speed: (1 − 1/(1 + 97/26))·26/35.
    let relative = (1.0 - 1.0 / (1.0 + 97.0 / 26.0)) * 26.0 / 35.0;
    for (rolling, most) in [("rollers", 5e5), ("full_complement", 2e5), ("balls", 5e5), ("needles", 5e5)] {
        set(&format!(", bearing_rolling: {rolling}, bearing_diameter: 50 mm"));
        let limit = most / 50.0 / relative;
        assert!(!told(&format!("{} rpm", limit * 0.999)).contains("n·d_m"), "{rolling}");
        let beyond = told(&format!("{} rpm", limit * 1.001));
        assert!(
            beyond.contains("n·d_m")
                && beyond.contains(&format!("at most {most} mm/min by makers of bearings")),
            "{rolling}: {beyond}"
        );
    }
    // a·ω² of the carrier at 85.4 mm: 150 g are 1253 rpm of it.
    set(", bearing_rolling: rollers");
    let limit = (150.0 * 9.80665 / 0.0854_f64).sqrt() * 30.0 / std::f64::consts::PI * (1.0 + 97.0 / 26.0);
    assert!(!told(&format!("{} rpm", limit * 0.99)).contains("about the axis"));
    assert!(told(&format!("{} rpm", limit * 1.01)).contains("g, at most 150 g by usual practice"));
    // Without a speed or without a bearing nothing is said, however fast the planets are.
    assert!(
        !json(folder.path(), &["analyze", "four.yaml"])["warnings"].to_string().contains("planet bearings")
    );
    let fast = "gearbox: fast\ninput: arm\noutput: sun\nsets: [{ id: P, sun: sun, ring: ground, carrier: arm, k: 5 }]\ngears: [{ name: only }]\n";
    fs::write(folder.path().join("fast.yaml"), fast).unwrap();
    assert_eq!(
        names(&json(folder.path(), &["analyze", "fast.yaml", "--speed", "3000 rpm"])),
        [] as [&str; 0]
    );
}

/// A gear whose speeds the file gives is not called underdetermined.
#[test]
fn given_speeds_settle_a_gear() {
    let folder = here();
    let file = |speeds: &str| {
        format!(
            "gearbox: sum\ninput: s\noutput: h\nsets: [{{ id: P, sun: s, ring: r, carrier: h, k: 3 }}]\ngears: [{{ name: only{speeds} }}]\n"
        )
    };
    for (speeds, state) in [("", "underdetermined"), (", speeds: { s: 100 rpm, r: 50 rpm }", "speeds_given")]
    {
        fs::write(folder.path().join("sum.yaml"), file(speeds)).unwrap();
        assert_eq!(json(folder.path(), &["analyze", "sum.yaml"])["gears"][0]["state"], state);
    }
    let table = output(folder.path(), &["analyze", "sum.yaml"]);
    assert!(!text(&table.stdout).contains("underdetermined"), "{}", text(&table.stdout));
}

/// A tangential support is used in gears that hold its member, several held members included, and refused
/// where no gear does.
#[test]
fn a_tangential_support_is_used_or_refused() {
    let folder = here();
    let file = |sun: &str, held: &str| {
        four(&format!(
            "planets: 2, vibration: {{ planet_bearing: 400 N/µm, carrier: {{ mass: 5 kg, inertia: 0.05 kg·m² }}, sun: {{ mass: 1 kg, inertia: 10 kg·cm²{sun} }}, ring: {{ outside_diameter: 320 mm }} }}"
        ))
        .replace("gears: [{ name: only }]", &format!("brakes: [{{ id: S, link: sun }}, {{ id: M, link: mast }}]\ngears: [{{ name: only{held} }}]"))
    };
    let support = ", tangential_support: 200 N/µm";
    fs::write(folder.path().join("a.yaml"), file(support, "")).unwrap();
    let refused = output(folder.path(), &["vibrate", "a.yaml"]);
    let told = text(&refused.stderr);
    assert!(
        !refused.status.success() && told.contains("sun.tangential_support") && told.contains("no gear does"),
        "{told}"
    );
    // All three held: on its support the sun swings, and a stiffer one raises what it swings in.
    let lowest = |sun: &str| {
        fs::write(folder.path().join("a.yaml"), file(sun, ", engaged: [S, M]")).unwrap();
        let answer = json(folder.path(), &["vibrate", "a.yaml"]);
        answer["sets"][0]["modes"][0]["frequency_hz"].as_f64()
    };
    let (soft, stiff) = (lowest(support).unwrap(), lowest(&support.replace("200", "2000")).unwrap());
    assert!(soft > 0.0 && stiff > soft, "{soft} {stiff}");
    fs::write(folder.path().join("a.yaml"), file("", ", engaged: [S, M]")).unwrap();
    let answer = json(folder.path(), &["vibrate", "a.yaml"]);
    assert_eq!(answer["not_calculated"][0]["reason"], "does_not_roll", "{answer}");
}
