//! Random sets of every kind through every command: each has an answer of finite figures, or says what it
//! lacks.

use epicyclic::call;
use epicyclic_commands::desk::memory::Memory;
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Commands that read a gearbox, as far as they do not search for structures or teeth.
const COMMANDS: [&[&str]; 16] = [
    &["analyze"],
    &["analyze", "--formula"],
    &["analyze", "--speed", "900 rpm", "--torque", "50 N·m"],
    &["sheet"],
    &["losses", "--speed", "900 rpm", "--torque", "50 N·m"],
    &["losses", "--speed", "-900 rpm", "--load-torque", "50 N·m"],
    &["strength"],
    &["strength", "--speed", "900 rpm", "--torque", "50 N·m"],
    &["vibrate"],
    &["vibrate", "--speeds", "0rpm..1200rpm/5", "--transmission-error", "3um,1um", "--damping", "0.03"],
    &["vibrate", "--coupled"],
    &["draw", "--view", "front"],
    &["draw", "--view", "teeth"],
    &["draw", "--view", "lever"],
    &["report"],
    &[
        "size",
        "--modules",
        "2mm, 3mm",
        "--face-widths",
        "20mm, 40mm",
        "--centre-distance-step",
        "1mm",
        "--most",
        "1",
    ],
];

/// Sizes that files have, and that `size` is to find.
const SIZES: &str = "module: 3 mm, face_width: 30 mm, ";

fn run(words: &[&str], text: &str) -> (u8, String, String) {
    let desk = Memory::new(BTreeMap::from([(PathBuf::from("box.yaml"), text.as_bytes().to_vec())]), None);
    let code = call(words, &desk);
    let kept = desk.into_kept();
    (code, String::from_utf8_lossy(&kept.answer).into_owned(), kept.messages.join("\n"))
}

/// Runs every command on a gearbox; number of answers.
fn tried(text: &str) -> Result<u32, TestCaseError> {
    let mut answered = 0;
    for words in COMMANDS {
        let text = &if words[0] == "size" { text.replace(SIZES, "") } else { text.to_owned() };
        let with: Vec<&str> =
            words[..1].iter().copied().chain(["box.yaml"]).chain(words[1..].iter().copied()).collect();
        let (code, answer, messages) = run(&with, text);
        let of = || format!("{with:?}\n{text}\n{messages}");
        prop_assert_eq!(code == 0, !messages.contains("error:"), "{}", of());
        // A fault has a name of what is wrong: more than a word.
        let has_reason = messages.lines().any(|line| line.starts_with("error:") && line.len() > 20);
        prop_assert!(code == 0 || has_reason, "{}", of());
        if words[0] == "report" || words[0] == "draw" {
            answered += u32::from(code == 0);
            prop_assert!(!answer.contains("NaN") && !answer.contains(">inf"), "{}", of());
            continue;
        }
        let (of_json, json, _) = run(&[&with[..], &["--format", "json"]].concat(), text);
        prop_assert_eq!(code, of_json, "{}", of());
        let parsed: Result<serde_json::Value, _> = serde_json::from_str(&json);
        prop_assert!(parsed.is_ok(), "{}\n{}", of(), json);
        for word in ["NaN", " inf ", "-inf"] {
            prop_assert!(!answer.contains(word), "{}\n{}", of(), answer);
        }
        answered += u32::from(code == 0);
    }
    Ok(answered)
}

/// A key with a value for each gear.
fn by_gear(key: &str, gears: &[&str], of_ring: &str, of_others: &str) -> String {
    let value = |gear: &&str| format!("{gear}: {}", if gear.contains("ring") { of_ring } else { of_others });
    format!("{key}: {{ {} }}", gears.iter().map(value).collect::<Vec<_>>().join(", "))
}

/// A gearbox of one set with all that its commands need.
fn file(list: &str, set: &str, gears: &[&str], is_pair: bool) -> String {
    let is_internal = gears.iter().any(|gear| gear.contains("ring")) || set.contains("internal_pair");
    let shaper = if is_internal { "shaper: { teeth: 30 }, " } else { "" };
    let planets = if is_pair {
        ""
    } else {
        "planet_bearing: 300 N/um, carrier: { mass: 9 kg, inertia: 0.05 kg·m2, support: 200 N/um }"
    };
    format!(
        "gearbox: one\ninput: a\noutput: h\nlife: 10000 h\noil: {{ viscosity: 220 mm²/s }}\nfriction: 0.05\nduty: [{{ gear: only, share: 100 %, speed: 500 rpm, torque: 40 N·m }}]\n{list}:\n  - {{ id: P, {set}, vibration: {{ {planets} }}, strength: {{ {}, {}, {}, {shaper}factors: {{ K_A: 1.25, K_v: 1.05, K_H_beta: 1.2, K_H_alpha: 1, K_F_alpha: 1, Y_delta_rel_T_stat: 1 }} }} }}\ngears: [{{ name: only }}]\n",
        by_gear("materials", gears, "34CrNiMo6", "18CrNiMo7-6"),
        by_gear("flank_roughness", gears, "8 µm", "4 µm"),
        by_gear("root_roughness", gears, "20 µm", "16 µm"),
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn every_set_has_an_answer_or_a_reason(
        kind in 0..11_usize, z1 in 15..40_u32, z2 in 14..40_u32, z3 in 14..40_u32, more in 0..30_u32, close: bool,
        x in proptest::array::uniform5(-0.3..0.6_f64), shifted: bool, helix in prop_oneof![Just(0_u32), 1..20_u32], planets in 1..5_u32,
    ) {
        let ring = if close { z1 + 2 * z2 } else { z1 + z2 + z3 + more };
        let usual = format!("{SIZES}helix_angle: {helix} deg");
        let shifts = |gears: &[&str]| {
            let values = gears.iter().zip(x).map(|(gear, x)| format!("{gear}: {x:.3}"));
            if shifted { format!(", profile_shifts: {{ {} }}", values.collect::<Vec<_>>().join(", ")) } else { String::new() }
        };
        let short = |kind: &str, gears: &[&str], teeth: [u32; 2], of_planets: &[u32]| {
            let carrier = if of_planets.is_empty() {
                ", ring: h".to_owned()
            } else {
                format!(", ring: ground, carrier: h, planet_teeth: {of_planets:?}, planets: {planets}")
            };
            let set = format!("kind: {kind}, sun: a, teeth: {teeth:?}, {usual}{carrier}{}", shifts(gears));
            file("sets", &set, gears, of_planets.is_empty())
        };
        let text = match kind {
            0 => short("simple", &["sun", "planet", "ring"], [z1, z1 + 2 * z2], &[z2]),
            1 => short("double_planet", &["sun", "planet 1", "planet 2", "ring"], [z1, ring], &[z2, z3]),
            2 => short("stepped_sun_ring", &["sun", "planet 1", "planet 2", "ring"], [z1, ring], &[z2, z3]),
            3 => short("stepped_suns", &["sun 1", "planet 1", "planet 2", "sun 2"], [z1, z1 + more], &[z2, z3]),
            4 => short("stepped_rings", &["ring 1", "planet 1", "planet 2", "ring 2"], [ring, ring + 3], &[z2, z3]),
            5 => short("meshing_suns", &["sun 1", "planet 1", "planet 2", "sun 2"], [z1, z1 + more], &[z2, z3]),
            6 => short("external_pair", &["gear 1", "gear 2"], [z1, z2], &[]),
            7 => short("internal_pair", &["gear 1", "gear 2"], [z2, ring], &[]),
            8 => {
                let gears = ["a", "s", "ring", "short", "long"];
                let set = format!(
                    "carrier: h, suns: {{ a: {z1}, s: {} }}, rings: {{ ring: {ring} }}, planet_gears: {{ short: [{z2}], long: [{z3}] }}, planets: {planets}, {usual}{}, meshes: [{{ gears: [a, short] }}, {{ gears: [short, long] }}, {{ gears: [s, long] }}, {{ gears: [long, ring] }}]",
                    z1 + more, shifts(&gears),
                );
                file("compound_sets", &set, &gears, false).replace("output: h", "output: ring") + "brakes: [{ id: B, link: h }]\n"
            }
            9 => {
                let gears = ["a", "ground", "p", "q", "r"];
                let set = format!(
                    "carrier: h, suns: {{ a: {z1} }}, rings: {{ ground: {} }}, planet_gears: {{ p: [{z2}], q: [{z3}], r: [{z2}] }}, planets: {planets}, {usual}{}, meshes: [{{ gears: [a, p] }}, {{ gears: [p, q] }}, {{ gears: [q, r] }}, {{ gears: [r, ground] }}]",
                    z1 + 2 * z2 + z3 + more, shifts(&gears),
                );
                file("compound_sets", &set, &["a", "ground", "p", "q", "r"], false)
            }
            _ => {
                let gears = ["a", "ground", "ring", "p.1", "p.2"];
                let set = format!(
                    "carrier: c, suns: {{ a: {z1} }}, rings: {{ ground: {}, ring: {ring} }}, planet_gears: {{ p: [{z2}, {z3}] }}, planets: {planets}, {usual}{}, meshes: [{{ gears: [a, p.1] }}, {{ gears: [p.1, ground] }}, {{ gears: [p.2, ring] }}]",
                    z1 + 2 * z2, shifts(&gears),
                );
                file("compound_sets", &set, &gears, false).replace("output: h", "output: ring")
            }
        };
        let text = if kind == 8 { text.replace("name: only", "name: only, engaged: [B]") } else { text };
        tried(&text)?;
    }
}
