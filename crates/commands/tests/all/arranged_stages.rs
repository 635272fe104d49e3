//! Designs of one stage with stepped planets, or of a Wolfrom set, against sizes of every set of teeth.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common::{GO_ON, stages, taken};
use epicyclic_commands::design::Request;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::words::request;
use epicyclic_commands::{size, strength, teeth};
use epicyclic_formats::Document;
use epicyclic_formats::yaml::{Value, to_string};
use std::collections::BTreeSet;

/// An order with few sets of teeth, and its kind, ratio and ranges of teeth as `teeth` takes them.
const ORDERS: [[&str; 4]; 3] = [
    ["stepped", "12", "--sun=17..20|--planet=28..66|--ring=90..125", "--input=1500rpm"],
    ["stepped", "-9", "--sun=17..20|--planet=28..60|--ring=90..115", "--input=1500rpm"],
    ["wolfrom", "60", "--sun=17..40|--planet=24..50|--ring=80..130", "--input=1500rpm"],
];

const LOAD: &str = "--output-torque=900 N·m|--application=conveyor";
const SIZES: &str = "--modules=1.5mm, 2mm, 2.5mm, 3mm|--face-widths=20mm, 25mm, 30mm, 40mm|--planets=3";

/// Every set of teeth with the ratio, of all the gears in the order of `teeth`, by the search for teeth alone.
fn every_set(kind: &str, ratio: &str, ranges: &str) -> Vec<Vec<u32>> {
    let mode = if ratio.starts_with('-') { "|--mode=ab^H" } else { "" };
    let words = format!("--ratio={ratio}|--kind={kind}|--tolerance=0.3%|--planets=3|{ranges}{mode}");
    let request: teeth::Request = request(words.split('|')).unwrap();
    let found = request.answer_arranged(|_| GO_ON()).unwrap();
    let teeth = found.tooth_numbers.iter().map(|set| set.gears.iter().map(|gear| gear.teeth).collect());
    teeth.collect::<BTreeSet<Vec<u32>>>().into_iter().collect()
}

/// Rules missed and mass with carrier and housing of the best sizes of a set of teeth, in the place of those of a
/// file; `None` if nothing holds.
fn sized(file: &str, teeth: &[u32], torque: f64) -> Option<(bool, f64)> {
    let mut file = Document::parse_one("stage.yaml", file.as_bytes()).unwrap().value().clone();
    let set = file["compound_sets"][0].as_mapping_mut().unwrap();
    for key in [
        "profile_shifts",
        "tip_alterations",
        "planet_sizes",
        "face_width",
        "face_widths",
        "module",
        "planets",
        "tools",
    ] {
        set.shift_remove(key);
    }
    for mesh in set["meshes"].as_sequence_mut().unwrap() {
        mesh.as_mapping_mut().unwrap().shift_remove("module");
    }
    let strength = set["strength"].as_mapping_mut().unwrap();
    strength.shift_remove("rims");
    strength.shift_remove("mesh_factors");
    strength["shaper"].as_mapping_mut().unwrap().shift_remove("addendum");
    strength["factors"]["K_H_beta"] = 1.25.into();
    set["suns"]["input"] = teeth[0].into();
    let steps = if teeth.len() == 4 { [1, 2] } else { [1, 3] };
    set["planet_gears"]["planet"] = Value::Sequence(steps.map(|step| teeth[step].into()).to_vec());
    for (ring, place) in [("ground", if teeth.len() == 4 { 3 } else { 2 }), ("output", teeth.len() - 1)] {
        if let Some(own) = set["rings"].as_mapping_mut().unwrap().get_mut(ring) {
            *own = teeth[place].into();
        }
    }
    file["duty"][0]["torque"] = format!("{torque} N·m").into();
    let text = to_string(&file).unwrap();
    let words = SIZES.split('|').chain(["--minimise=whole", "--most=1", "--application=conveyor"]);
    let own: size::Request = request(words).unwrap();
    let own = size::Request { widens_face_load: true, ..own };
    let size = own.answer(&Gearbox::parse("stage.yaml", text.as_bytes()).unwrap(), &GO_ON).unwrap();
    size.sets[0].found.first().map(|best| (best.rules_missed > 0, best.with_structure_kg()))
}

/// Ratio of a set, and its torque on the input for one on the output, by its teeth and the efficiencies of its meshes.
fn ratio_and_torque(teeth: &[u32], turns_back: bool, output: f64) -> (f64, f64) {
    let z: Vec<f64> = teeth.iter().map(|teeth| f64::from(*teeth)).collect();
    let [outer, inner] = [1.0 - 2.0 / 3.0 * (1.0 - 0.9702), 0.9702 / (1.0 - 2.0 / 3.0 * (1.0 - 0.9702))];
    match z[..] {
        [sun, first, second, ring] => {
            let k = ring * first / (sun * second);
            let of = if turns_back { k * outer * inner } else { 1.0 + k * outer * inner };
            (if turns_back { -k } else { 1.0 + k }, output / of)
        }
        [sun, first, first_ring, second, second_ring] => {
            let (k, q) = (first_ring / sun, first_ring * second / (first * second_ring));
            // Power leaves the carrier's frame through the second ring, or enters by it.
            let of = |mesh: f64| (1.0 + k * outer * inner) / (1.0 - q * mesh);
            let lossy = if q < 1.0 { of(inner * inner) } else { of(1.0 / (inner * inner)) };
            ((1.0 + k) / (1.0 - q), (output / lossy).abs())
        }
        _ => panic!("{teeth:?}"),
    }
}

#[test]
fn the_best_stage_is_the_lightest_of_all_sized_one_by_one() {
    for [kind, ratio, ranges, input] in ORDERS {
        let stages = stages(&format!("--ratio={ratio}|--kind={kind}|{ranges}|{input}|{LOAD}|{SIZES}"));
        let best = taken(&stages);
        assert_eq!(stages.trains.iter().map(|trains| trains.complete).collect::<Vec<_>>(), [true]);
        let file = stages.file.unwrap();
        let turns_back = ratio.starts_with('-');
        let all = every_set(kind, ratio, ranges);
        assert!(all.len() > 3, "{all:?}");
        let of = |teeth: &Vec<u32>| {
            let (ratio, torque) = ratio_and_torque(teeth, turns_back, 900.0);
            let ((misses, mass), loses) =
                (sized(&file, teeth, torque)?, 900.0 / (torque * ratio.abs()) < 0.95);
            Some(((misses || loses, mass), ratio))
        };
        let all: Vec<((bool, f64), f64)> = all.iter().filter_map(of).collect();
        let least = all.into_iter().reduce(|one, other| if other.0 < one.0 { other } else { one });
        let ((misses, mass), exact) = least.unwrap();
        assert_eq!(misses, best.rules_missed > 0);
        assert!((best.mass_kg / mass - 1.0).abs() < 1e-9, "{} for {mass}: {:?}", best.mass_kg, best.teeth);
        assert!((best.ratio / exact - 1.0).abs() < 1e-12, "{} {exact}", best.ratio);
    }
}

/// Safeties and losses of the design are those of `strength` and `analyze` for its file: every mesh has the factor of
/// its own width.
#[test]
fn the_file_of_a_stage_has_the_safeties_and_losses_of_the_design() {
    for [kind, ratio, ranges, input] in ORDERS {
        let stages = stages(&format!("--ratio={ratio}|--kind={kind}|{ranges}|{input}|{LOAD}|{SIZES}"));
        let file = stages.file.clone().unwrap();
        let gearbox = Gearbox::parse("stage.yaml", file.as_bytes()).unwrap();
        let request: strength::Request = request(std::iter::empty::<&str>()).unwrap();
        let answer = request.answer(&gearbox).unwrap();
        let strength: Vec<f64> =
            answer.over_duty.iter().map(|gear| gear.flank.as_ref().unwrap().safety).collect();
        let design = &stages.sizes.as_ref().unwrap().sets[0].found[0];
        let sized: Vec<f64> = design.over_duty.iter().map(|gear| gear.flank.safety).collect();
        assert_eq!(strength.len(), sized.len());
        for (one, other) in strength.iter().zip(&sized) {
            assert!((one / other - 1.0).abs() < 1e-9, "{kind}: {strength:?} {sized:?}");
        }
        let (of_teeth, torque) = ratio_and_torque(&taken(&stages).teeth[0], ratio.starts_with('-'), 900.0);
        assert!((stages.ratio.unwrap() / of_teeth - 1.0).abs() < 1e-12);
        assert!((stages.input_torque_n_m.unwrap() / torque - 1.0).abs() < 1e-9);
        // Without the distance of the rows lives leave out the couple of the steps, by a warning.
        let spanless: String = file
            .lines()
            .filter(|line| !line.contains("bearing_span"))
            .map(|line| format!("{line}\n"))
            .collect();
        assert_ne!(spanless, file);
        let without = request.answer(&Gearbox::parse("stage.yaml", spanless.as_bytes()).unwrap()).unwrap();
        let warned = |of: &strength::Strength| of.warnings.iter().any(|one| one.name == "step-couple");
        assert_eq!([warned(&answer), warned(&without)], [false, true], "{kind}");
        assert!(without.bearings[0].basic_life_s > answer.bearings[0].basic_life_s, "{kind}");
        let radius = design.planet_sizes[0].radius_m;
        assert!(design.ring_diameter_m.unwrap() > 2.0 * radius, "planets reach beyond their centres");
    }
}

#[test]
fn kinds_that_cannot_be_are_refused_with_what_to_type() {
    for (words, remedy) in [
        ("--kind=wolfrom|--stages=2..3|--ratio=50", "--stages 1"),
        ("--kind=stepped|--axes=parallel|--ratio=12", "leave out --axes"),
        ("--kind=wolfrom|--ratio=0.02", "--kind simple,stepped"),
    ] {
        let request: Request =
            request(words.split('|').chain(["--input=1500rpm", "--torque=20 N·m"])).unwrap();
        let refused = request.answer_stages(&GO_ON).unwrap_err().to_string();
        assert!(refused.contains(remedy), "{refused}");
    }
}
