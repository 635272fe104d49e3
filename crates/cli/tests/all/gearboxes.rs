//! The commands for gearboxes of several speeds: analyze, select, schemes, machine.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use common::{examples, here, output, run, session, text};
use std::fs;

#[test]
fn shifts_of_many_gears_are_left_out_and_that_is_told() {
    let folder = here();
    let gears = |count: usize| {
        let gear = |place: usize| format!("  - {{ name: g{place}, engaged: [K{}] }}\n", 1 + place % 2);
        let gears: String = (0..count).map(gear).collect();
        let file = format!(
            "gearbox: many\ninput: D\noutput: B\nsets: [{{ id: P, sun: D, ring: T, carrier: B, k: 3 }}]\nbrakes: [{{ id: K1, link: T \
             }}]\nclutches: [{{ id: K2, links: [D, B] }}]\ngears:\n{gears}"
        );
        fs::write(folder.path().join("many.yaml"), file).unwrap();
    };
    gears(65);
    let told = output(folder.path(), &["analyze", "many.yaml"]);
    assert!(text(&told.stdout).contains("shifts are told of at most 64 gears; these are 65"));
    let refused = output(folder.path(), &["analyze", "many.yaml", "--shifts"]);
    assert!(refused.status.code() == Some(2) && text(&refused.stderr).contains("at most 64"), "{refused:?}");
    gears(64);
    let done = output(folder.path(), &["analyze", "many.yaml", "--shifts", "--format", "json"]);
    let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    // Each of the 32 slow gears to each of the 32 fast ones.
    assert_eq!(told["shifts"].as_array().unwrap().len(), 32 * 32);
}

const WIND: [&str; 6] = ["strength", "wind-stage.yaml", "--torque", "999.650881 kN·m", "--speed", "47.8 rpm"];

/// As printed by the commercial calculation: safeties of sun, planet at the sun, planet at the ring, ring.
/// The ring's root contains a `Y_S` that is compared only.
#[test]
fn the_safeties_of_the_wind_stage_are_those_printed() {
    let done = output(&examples(), &[&WIND[..], &["--format", "json"]].concat());
    let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let rows = told["at_point"].as_array().unwrap();
    let of = |key: &str| rows.iter().map(|row| row[key].as_f64().unwrap()).collect::<Vec<_>>();
    for (key, printed) in [
        ("flank_safety", &[1.21, 1.38, 3.43, 1.81][..]),
        ("root_safety", &[2.82, 2.04, 4.18]),
        ("contact_stress_pa", &[1071.17e6, 994.13e6, 404.76e6, 404.76e6]),
        ("root_stress_pa", &[209.38e6, 210.14e6, 102.77e6]),
    ] {
        for (value, printed) in of(key).iter().zip(printed) {
            assert!((value / printed - 1.0).abs() < 0.01, "{key}: {value}, printed {printed}");
        }
    }
    // 1 N·m of the ring's torque is printed beyond six digits.
    assert!(of("tangential_force_n").iter().all(|force| (force / 285_900.438 - 1.0).abs() < 1e-6));
}

/// With the deviations of grade 6, bores and blank factor of the same calculation, `K_v` is the printed one
/// of each mesh.
#[test]
fn the_dynamic_factors_of_the_wind_stage_are_those_printed() {
    let wind = fs::read_to_string(examples().join("wind-stage.yaml")).unwrap();
    let given = "K_v: 1.061, K_H_alpha: 1, K_F_alpha: 1 }";
    let accuracy = "accuracy: { pitch_deviations: [16.9 µm, 17.9 µm, 20.7 µm], profile_deviations: [21 µm, 23 µm, 27 µm], \
                    sun_bore: 194.32 mm, blank_factor: 0.862 }";
    let changed = wind.replace(&format!("{given}\n"), &format!("}}\n      {accuracy}\n"));
    let changed = changed.replace("    module: 21 mm\n", "    module: 21 mm\n    planet_bore: 576.96 mm\n");
    let folder = here();
    fs::write(folder.path().join("wind-stage.yaml"), changed).unwrap();
    let done = output(folder.path(), &[&WIND[..], &["--factors", "--format", "json"]].concat());
    let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let rows = told["at_point"].as_array().unwrap();
    let factor = |row: usize, symbol: &str| {
        let mut all = rows[row]["factors"].as_array().unwrap().iter();
        all.find(|factor| factor["symbol"] == symbol).unwrap()["value"].as_f64().unwrap()
    };
    for (row, printed) in [(0, 1.02), (1, 1.02), (2, 1.061), (3, 1.061)] {
        let dynamic = factor(row, "K_v");
        assert!((dynamic - printed).abs() <= if row < 2 { 0.005 } else { 0.0005 }, "{dynamic}");
        assert_eq!([factor(row, "K_Hα"), factor(row, "K_Fα")], [1.0, 1.0]);
    }
}

/// By hand: without `K_A` and `K_v` stresses of the flank are those of 2500 kN·m over `√(1.25·1.061)`, limits
/// the static ones, `σ_Hlim·1.6` of case-hardened steel; of the root `σ_Flim·2·2.5·Y_δrelT,stat·Y_M`.
#[test]
fn the_overload_is_held_against_the_static_limits() {
    let done = output(&examples(), &[&WIND[..], &["--factors", "--format", "json"]].concat());
    let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let [point, peak] = ["at_point", "overload"].map(|key| told[key].as_array().unwrap().clone());
    assert_eq!((point.len(), peak.len()), (4, 4));
    let more = 2500.0 / 999.650881 / (1.25 * 1.061);
    for (one, other) in point.iter().zip(&peak).take(3) {
        let number = |of: &serde_json::Value, key: &str| of[key].as_f64().unwrap();
        let stress = number(one, "contact_stress_pa") / 1e6 * f64::sqrt(more);
        assert!((number(other, "flank_safety") / (1500.0 * 1.6 / stress) - 1.0).abs() < 1e-9, "{other}");
        let factor = |symbol: &str| {
            let mut all = one["factors"].as_array().unwrap().iter();
            all.find(|factor| factor["symbol"] == symbol).unwrap()["value"].as_f64().unwrap()
        };
        let notch = 0.44 * factor("Y_S") + 0.12;
        let limit = 430.0 * 2.0 * 2.5 * notch * factor("Y_M");
        let stress = number(one, "root_stress_pa") / 1e6 * more;
        assert!((number(other, "root_safety") / (limit / stress) - 1.0).abs() < 1e-9, "{other}");
    }
}

/// Stresses depend on the size of the load alone: braked, the safeties are the same.
#[test]
fn the_direction_of_power_does_not_change_the_safeties() {
    let at = |torque: &str| -> serde_json::Value {
        let line =
            ["strength", "wind-stage.yaml", "--torque", torque, "--speed", "40 rpm", "--format", "json"];
        let told: serde_json::Value = serde_json::from_slice(&output(&examples(), &line).stdout).unwrap();
        told["at_point"].clone()
    };
    assert_eq!(at("500 kN·m"), at("-500 kN·m"));
}

/// As printed by the commercial calculation, to all digits. The file has the shifts with the digits that the
/// printed centre distance asks for, which round to the four that are printed.
#[test]
fn the_data_sheets_of_the_wind_stage_are_those_printed() {
    let done = output(&examples(), &["sheet", "wind-stage.yaml", "--format", "json"]);
    let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let set = &told["sets"][0];
    let is = |value: &serde_json::Value, scale: f64, printed: f64| {
        let value = value.as_f64().unwrap() * scale;
        assert!((value - printed).abs() <= 0.5001e-3, "{value}, printed {printed}");
    };
    is(&set["centre_distance_m"], 1e3, 584.0);
    for (key, printed) in [
        ("reference_diameter_m", [378.0, 756.0, 1953.0]),
        ("base_diameter_m", [355.204, 710.408, 1835.220]),
        ("tip_diameter_m", [432.838, 815.663, 1906.081]),
        ("root_diameter_m", [341.838, 724.663, 2000.581]),
        ("tip_thickness_m", [12.910, 14.858, 18.937]),
        ("span_m", [165.869, 296.803, 676.615]),
        ("over_balls_m", [466.306, 836.492, 1900.511]),
    ] {
        for (gear, printed) in set["gears"].as_array().unwrap().iter().zip(printed) {
            is(&gear[key], 1e3, printed);
        }
    }
    let spanned: Vec<u64> =
        set["gears"].as_array().unwrap().iter().map(|gear| gear["spanned_teeth"].as_u64().unwrap()).collect();
    assert_eq!(spanned, [3, 5, 11]);
    for (mesh, angle, contact, working, clearances, sliding) in [
        (0, 24.169, 1.370, [389.333, 778.667], [5.250, 5.250], [0.533, 0.614]),
        (1, 15.630, 1.618, [737.684, 1905.684], [8.459, 6.709], [0.309, -0.005]),
    ] {
        let of = &set["meshes"][mesh];
        is(&of["working_angle_rad"], 180.0 / std::f64::consts::PI, angle);
        is(&of["contact_ratio"], 1.0, contact);
        for (place, gear) in of["gears"].as_array().unwrap().iter().enumerate() {
            is(&gear["working_diameter_m"], 1e3, working[place]);
            is(&gear["tip_clearance_m"], 1e3, clearances[place]);
            is(&gear["sliding_at_tip"], 1.0, sliding[place]);
        }
    }
}

/// Two makers number their gears in opposite order of the ratios, so equal names denote different gears; the
/// order of a file does not determine steps.
#[test]
fn gears_of_one_name_and_other_order_stand_by_their_ratios() {
    let folder = here();
    let file = fs::read_to_string(examples().join("scheme-ii-3.yaml")).unwrap();
    let swapped = file
        .replace("name: slow", "name: X")
        .replace("name: middle", "name: slow")
        .replace("name: X", "name: middle");
    assert_ne!(file, swapped);
    fs::write(folder.path().join("one.yaml"), &file).unwrap();
    fs::write(folder.path().join("other.yaml"), swapped).unwrap();
    let json = |arguments: &[&str]| -> serde_json::Value {
        let done = output(folder.path(), &[arguments, &["--format", "json"]].concat());
        serde_json::from_slice(&done.stdout).unwrap()
    };
    assert_eq!(json(&["compare", "one.yaml", "one.yaml"])["gears_by"], "name");
    let compared = json(&["compare", "one.yaml", "other.yaml"]);
    assert_eq!(compared["gears_by"], "ratio");
    for gear in compared["gears"].as_array().unwrap() {
        let ratio =
            gear["figures"].as_array().unwrap().iter().find(|figure| figure["figure"] == "ratio").unwrap();
        let values = ratio["values"].as_array().unwrap();
        assert_eq!(values[0]["value"], values[1]["value"], "{gear}");
    }
    let steps = |file: &str| -> Vec<(String, f64)> {
        let gears = json(&["analyze", file])["gears"].as_array().unwrap().clone();
        let mut steps: Vec<(String, f64)> = gears
            .iter()
            .filter_map(|gear| Some((gear["ratio"].as_f64()?.to_string(), gear["step"].as_f64()?)))
            .collect();
        steps.sort_by(|one, other| one.0.cmp(&other.0));
        steps
    };
    assert_eq!(steps("one.yaml"), steps("other.yaml"));
    assert!(steps("one.yaml").iter().all(|(_, step)| *step > 1.0));
}

#[test]
fn a_scheme_is_what_its_file_says_and_a_structure_the_same_in_any_order() {
    let ratios = |args: &[&str]| {
        let done = output(&examples(), &[&["analyze"], args, &["--format", "json"]].concat());
        let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        [0, 1].map(|gear| told["gears"][gear]["ratio"].as_f64().unwrap())
    };
    let [slow, fast] = ratios(&["scheme-ii-3.yaml"]);
    let file = [fast, slow];
    let by_ratio = ratios(&["II-3", "--ratio1", &file[0].to_string(), "--ratio2", &file[1].to_string()]);
    let [one, two] = ratios(&["D.T1.B+T2.B.T1", "--k1", "2.5", "--k2", "1.618"]);
    let sets = ratios(&["T2.B.T1+D.T1.B", "--k1", "1.618", "--k2", "2.5"]);
    let brakes = ratios(&["D.T2.B+T1.B.T2", "--k1", "2.5", "--k2", "1.618"]);
    let sizes = ["--ratio1", &one.to_string(), "--ratio2", &two.to_string()].map(str::to_owned);
    let sizes: Vec<&str> = sizes.iter().map(String::as_str).collect();
    let again = ratios(&[&["T2.B.T1+D.T1.B"], &sizes[..]].concat());
    for (found, known) in [(by_ratio, file), (sets, [one, two]), (brakes, [two, one]), (again, [one, two])] {
        for (found, known) in std::iter::zip(found, known) {
            assert!((found / known - 1.0).abs() < 1e-12, "{found} {known}");
        }
    }
}

/// The terms of the record, multiplied and summed here, give the ratio of the same gear's analysis.
#[test]
fn the_terms_of_a_formula_give_the_ratio() {
    let mut formulas = 0;
    for file in [
        "scheme-ii-3.yaml",
        "ravigneaux.yaml",
        "wolfrom.yaml",
        "wolfrom-self-locking.yaml",
        "power-split.yaml",
        "closed-by-planetary-gear.yaml",
        "closed-by-ordinary-train.yaml",
        "every-gearbox-key.yaml",
        "sized-gearbox.yaml",
    ] {
        let json = |more: &[&str]| -> serde_json::Value {
            let done = output(&examples(), &[&["analyze", file, "--format", "json"], more].concat());
            serde_json::from_slice(&done.stdout).unwrap()
        };
        let (told, plain) = (json(&["--formula"]), json(&[]));
        let value = |symbol: &serde_json::Value| {
            let all = told["symbols"].as_array().unwrap();
            all.iter().find(|one| one["symbol"] == *symbol).unwrap()["value"].as_f64().unwrap()
        };
        let term = |term: &serde_json::Value| {
            let symbols = term["symbols"].as_array().unwrap();
            term["coefficient"].as_f64().unwrap() * symbols.iter().map(value).product::<f64>()
        };
        let factor =
            |factor: &serde_json::Value| factor["terms"].as_array().unwrap().iter().map(term).sum::<f64>();
        for (gear, same) in told["gears"].as_array().unwrap().iter().zip(plain["gears"].as_array().unwrap()) {
            assert_eq!(gear["ratio"], same["ratio"], "{file}");
            let Some(ratio) = same["ratio"].as_f64() else {
                assert!(gear["formula"].is_null() && gear["no_formula"]["reason"] == "no_ratio", "{file}");
                continue;
            };
            let side =
                |side: &str| gear["formula"][side].as_array().unwrap().iter().map(factor).product::<f64>();
            assert!((side("numerator") / side("denominator") / ratio - 1.0).abs() < 1e-12, "{file} {gear}");
            assert!(
                (gear["formula"]["value"].as_f64().unwrap() / ratio - 1.0).abs() < 1e-12,
                "{file} {gear}"
            );
            formulas += 1;
        }
    }
    assert!(formulas > 15, "{formulas}");
}

#[test]
fn the_torques_of_the_steps_balance_on_each_link() {
    let mut links = 0;
    for file in ["scheme-ii-3.yaml", "ravigneaux.yaml", "wolfrom.yaml", "closed-by-planetary-gear.yaml"] {
        let done = output(&examples(), &["analyze", file, "--steps", "--format", "json"]);
        let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        for gear in told["gears"].as_array().unwrap() {
            for link in gear["steps"]["torques"]["links"].as_array().unwrap() {
                let torques = link["torques"].as_array().unwrap().iter();
                let torques: Vec<f64> = torques.map(|one| one["torque_of_input"].as_f64().unwrap()).collect();
                let largest = torques.iter().fold(0.0_f64, |most, torque| most.max(torque.abs()));
                assert!(torques.iter().sum::<f64>().abs() < 1e-9 * largest, "{file} {link}");
                links += 1;
            }
        }
    }
    assert!(links > 20, "{links}");
}

#[test]
fn a_load_that_turns_a_one_way_clutch_free_is_told() {
    let told = |gear: &[&str], load: &[&str]| {
        let done = output(&examples(), &[&["analyze", "ravigneaux.yaml"], gear, load].concat());
        assert!(done.status.success());
        text(&done.stdout).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let first = ["--gear", "1"];
    let reversed = "F1 would be reversed, so it overruns; engage LR besides";
    for load in [
        &["--torque", "-100 N·m"][..],
        &["--power", "-20 kW", "--speed", "2000 rpm"],
        &["--torque", "-100 N·m", "--speed", "-2000 rpm"],
    ] {
        assert!(told(&first, load).contains(reversed) && told(&[], load).contains(reversed), "{load:?}");
        assert!(!told(&["--gear", "1 low"], load).contains("would be reversed"), "{load:?}");
    }
    for load in [&["--torque", "100 N·m"][..], &["--torque", "100 N·m", "--speed", "-2000 rpm"]] {
        assert!(!told(&first, load).contains("would be reversed"), "{load:?}");
    }
    let several = told(&first, &["--speeds", "turbine=1000rpm", "--torques", "turbine=-100 N·m"]);
    assert!(several.contains("F1 would overrun at these torques"), "{several}");
}

#[test]
fn forces_on_the_bearings_of_planets() {
    let folder = examples();
    let forces = |args: &[&str]| {
        let seen = session(&folder, &[&["analyze"], args].concat());
        let from = seen.find("Force on").or_else(|| seen.find("Torque of the planet pins")).unwrap();
        let to = seen[from..].find("\n\n").unwrap();
        format!("$ {}\n{}\n", args.join(" "), &seen[from..from + to])
    };
    let sized = "sized-gearbox.yaml";
    insta::assert_snapshot!(
        [
            forces(&[sized]),
            forces(&[sized, "--torque", "500 N·m"]),
            forces(&[sized, "--speed", "1475 rpm"]),
            forces(&[sized, "--speed", "1475 rpm", "--power", "75 kW"]),
            forces(&[sized, "--speed", "1475 rpm", "--power", "-75 kW", "--gear", "slow"]),
            forces(&["scheme-ii-3.yaml", "--gear", "slow"]),
            forces(&["real-transmissions.yaml", "--transmission", "8HP", "--gear", "1"]),
        ]
        .join("\n")
    );
}

/// Files that `select` and `synthesize` save for sets with profile shift are read by every command, and the
/// centre distance of the data sheet is that of the search.
#[test]
fn every_command_reads_a_saved_gearbox_with_profile_shift() {
    let folder = here();
    let select = "select --ratios 6.1667 --teeth --ring-offset 3 --sun 18 --planet-count 3 --tolerance 0.01% --planet-speed 5 --save box.yaml \
                  --format json --load-factor 2MPa --torque 500N·m";
    let found = output(folder.path(), &select.split(' ').collect::<Vec<_>>());
    assert!(found.status.success(), "{}", text(&found.stderr));
    let found: serde_json::Value = serde_json::from_slice(&found.stdout).unwrap();
    let set = &found["designs"][0]["tooth_numbers"][0];
    assert_eq!([&set["sun"], &set["planet"], &set["ring"]], [18, 36, 93]);
    // With what strength and size ask for, and no efficiency, module and width of its own.
    let saved = fs::read_to_string(folder.path().join("box.yaml")).unwrap();
    let strength = "strength: { materials: [18CrNiMo7-6, 18CrNiMo7-6, 34CrNiMo6], flank_roughness: [4 µm, 4 µm, 6 µm], \
                    root_roughness: [16 µm, 16 µm, 20 µm], shaper: { teeth: 30 }, ring_factors: { Y_delta_rel_T_stat: 1 }, \
                    factors: { K_A: 1.25, K_v: 1.05, K_H_beta: 1.2, K_H_alpha: 1, K_F_alpha: 1 } }, efficiency";
    assert!(saved.contains("profile_shifts: [") && saved.contains("efficiency"), "{saved}");
    let whole = saved.replacen("efficiency", strength, 1)
        + "oil: { viscosity: 220 mm²/s }\nlife: 500 h\nduty: [{ gear: \"1\", share: 1, torque: 500 N·m, speed: 1450 rpm }]\n";
    fs::write(folder.path().join("whole.yaml"), whole).unwrap();
    let told = |line: &str| {
        let told = output(folder.path(), &line.split(' ').collect::<Vec<_>>());
        assert!(told.status.success(), "{line}: {}", text(&told.stderr));
        told.stdout
    };
    let json = |line: &str| -> serde_json::Value { serde_json::from_slice(&told(line)).unwrap() };
    let sheet = json("sheet box.yaml --format json");
    let near = |one: &serde_json::Value, other: f64| {
        let one = one.as_f64().unwrap();
        assert!((one / other - 1.0).abs() < 1e-4, "{one} {other}");
    };
    let centre = set["shifts"]["centre_distance_in_modules"].as_f64().unwrap();
    near(&sheet["sets"][0]["centre_distance_m"], centre * set["module_m"].as_f64().unwrap());
    let size = json("size whole.yaml --format json --most 1");
    for place in 0..3 {
        near(
            &size["sets"][0]["found"][0]["gears"][place]["profile_shift"],
            set["shifts"]["profile_shifts"][place].as_f64().unwrap(),
        );
    }
    assert!(!json("strength whole.yaml --format json")["over_duty"].as_array().unwrap().is_empty());
    told("analyze box.yaml --gear 1");
    told("draw box.yaml --view teeth -o teeth.svg");
    let synthesize = "synthesize --ratios 2.56,1.465 --sets 2 --elements 2 --teeth --ring ..110 --ring-offset 1..2 --limit 1 --save two.yaml";
    told(synthesize);
    told("draw two.yaml --view teeth -o two.svg");
}

const CONVEYOR: &str = "0.8 m/s, 3.15 m/s";
const WHEEL: &str = "0.76 m/s, 1.33 m/s, 1.95 m/s";

#[test]
fn a_gearbox_at_its_power_and_speed() {
    let duty = |more: &[&str]| {
        let seen = session(here().path(), &[&["select", "--speeds"], more].concat());
        let from = seen.find(": output, rpm").or_else(|| seen.find(": torques of shafts")).unwrap();
        format!("$ {}\n{}", more.join(" "), &seen[seen[..from].rfind('\n').unwrap()..])
    };
    insta::assert_snapshot!(
        [
            duty(&[CONVEYOR, "--power", "75 kW", "--input", "1475 rpm"]),
            duty(&[CONVEYOR, "--input", "1475 rpm"]),
            duty(&[CONVEYOR, "--torque", "500 N·m"]),
            duty(&[WHEEL, "--all-structures", "--power", "75 kW", "--input", "1475 rpm"]),
            duty(&[WHEEL, "--teeth", "--ring", "..90", "--limit", "1", "--torque", "500 N·m"]),
        ]
        .join("\n")
    );
}

/// The torques at the load are those of the lists times the input's, and powers balance.
#[test]
fn torques_and_powers_at_a_load_agree_with_the_lists() {
    let args = ["select", "--speeds", WHEEL, "--power", "75 kW", "--input", "1475 rpm", "--format", "json"];
    let json: serde_json::Value = serde_json::from_slice(&output(here().path(), &args).stdout).unwrap();
    let speed = 1475.0 * std::f64::consts::PI / 30.0;
    let torque = 75e3 / speed;
    let near = |one: f64, other: f64| (one - other).abs() < 1e-9 * torque.max(other.abs());
    let mut checked = 0;
    for candidate in json["candidates"].as_array().unwrap() {
        for row in candidate["operation"].as_array().unwrap() {
            let of = |key: &str| row[key].as_f64().unwrap();
            assert!(near(of("input_torque_n_m"), torque));
            assert!(near(of("entering_w"), of("leaving_w") + of("loss_w")));
            assert!(near(of("output_torque_n_m") * of("output_speed_rad_s"), -of("leaving_w")));
            let clutches = candidate["direct_drive_clutches"].as_array().unwrap();
            let (key, of_input) = match row["gear"].as_str().unwrap() {
                "1" => ("k1_torque_n_m", &candidate["gears"][0]["brake_torque_of_input"]),
                "2" => ("k2_torque_n_m", &candidate["gears"][1]["brake_torque_of_input"]),
                _ => (
                    "direct_drive_clutch_torque_n_m",
                    &clutches.iter().find(|clutch| clutch["chosen"] == true).unwrap()["torque_of_input"],
                ),
            };
            assert!(near(of(key), of_input.as_f64().unwrap() * torque), "{row} {candidate}");
            checked += 1;
        }
    }
    assert!(checked >= 6, "{checked}");
}

#[test]
fn no_key_of_an_answer_hides_another() {
    let folder = examples();
    for args in [
        &["analyze", "scheme-ii-3.yaml", "--gear", "slow", "--torque", "500 N·m", "--speed", "1475 rpm"][..],
        &["schemes", "II-3", "--k1", "2.15", "--k2", "2.35"],
        &["machine", "speeds", "0.76 m/s, 1.33 m/s, 1.95 m/s"],
    ] {
        let csv = text(&output(&folder, &[args, &["--format", "csv"]].concat()).stdout);
        let mut keys: Vec<&str> =
            csv.lines().skip(1).map(|line| line.rsplitn(3, ',').last().unwrap()).collect();
        let all = keys.len();
        keys.sort_unstable();
        keys.dedup();
        assert_eq!(keys.len(), all, "{csv}");
    }
}

#[test]
fn lists_of_an_answer_count_alike() {
    let args = ["select", "--ratios", "2.5, 4", "--all-structures", "--limit", "2", "--format", "json"];
    let json: serde_json::Value = serde_json::from_slice(&output(here().path(), &args).stdout).unwrap();
    let candidates = json["candidates"].as_array().unwrap();
    assert_eq!(candidates.len(), 4);
    for candidate in candidates {
        let count = |list: &str| candidate[list].as_array().unwrap().len();
        let lists = ["sets", "gears", "direct_drive_clutches", "engagement_table", "criteria", "operation"];
        assert_eq!(lists.map(count), [2, 2, 6, 3, 9, 0], "{candidate}");
    }
}

/// The ratios of a file's gears by `analyze`.
fn analyzed(folder: &std::path::Path, file: &str) -> Vec<(String, f64)> {
    let done = output(folder, &["analyze", file, "--format", "json"]);
    assert!(done.status.success(), "{done:?}");
    let answer: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let gears = answer["gears"].as_array().unwrap();
    gears
        .iter()
        .map(|gear| (gear["gear"].as_str().unwrap().to_owned(), gear["ratio"].as_f64().unwrap()))
        .collect()
}

/// In every mode, for simple and double-planet sets, the ratio of the file equals that of the list exactly.
#[test]
fn a_saved_set_of_tooth_numbers_has_its_ratio() {
    let folder = here();
    let run = |args: &[&str]| {
        let done = output(folder.path(), args);
        assert!(done.status.success(), "{args:?} {done:?}");
        done
    };
    let double = ["--double-planet"];
    for (ratio, mode, more) in [
        ("6", "aH^b", &[][..]),
        ("-4", "ab^H", &[]),
        ("1.3", "bH^a", &[]),
        ("-0.3", "ba^H", &[]),
        ("0.2", "Ha^b", &[]),
        ("-1.6", "aH^b", &double),
        ("2.6", "ab^H", &double),
        ("0.6", "bH^a", &double),
        ("0.4", "ba^H", &double),
        ("1.6", "Hb^a", &double),
    ] {
        let list = ["teeth", "--ratio", ratio, "--mode", mode, "--no-undercut", "--format", "json"];
        let saved = [&list[..], &["--limit", "2", "--save", "set.yaml", "--nth", "3"], more].concat();
        let told: serde_json::Value = serde_json::from_slice(&run(&saved).stdout).unwrap();
        // The third is saved, and two are shown.
        assert_eq!(told["tooth_numbers"].as_array().unwrap().len(), 2);
        let three = [&list[..], &["--limit", "3"], more].concat();
        let found: serde_json::Value = serde_json::from_slice(&run(&three).stdout).unwrap();
        let set = &found["tooth_numbers"][2];
        let read = run(&["analyze", "set.yaml", "--format", "json"]);
        let read: serde_json::Value = serde_json::from_slice(&read.stdout).unwrap();
        assert_eq!(read["gears"][0]["exact_ratio"], set["exact_ratio"], "{mode} {more:?}");
        // The teeth fit together; a warning reports shortened tips of some rings.
        let warnings = read["warnings"].as_array().unwrap();
        assert!(
            warnings.iter().all(|one| one["message"].as_str().unwrap().contains("cut the blank so")),
            "{read}"
        );
        run(&["draw", "set.yaml", "-o", "set.svg"]);
        run(&["report", "set.yaml", "-o", "set.html"]);
    }
    let refused = output(folder.path(), &["teeth", "--ratio", "6", "--save", "no.yaml", "--nth", "999"]);
    assert!(text(&refused.stderr).starts_with("error: --nth: 999: there are sets 1 to "), "{refused:?}");
    assert!(!folder.path().join("no.yaml").exists());
}

/// If all candidates are rejected, the answer names options that accept some, and these do.
#[test]
fn options_that_are_named_where_nothing_is_found_do_help() {
    let wheel = "0.76 m/s, 1.33 m/s, 1.95 m/s";
    let list: &[(&[&str], &[&str])] = &[
        (&["select", "--speeds", wheel, "--same-direction"], &["--planet-speed 2.29"]),
        (&["select", "--ratios", "2.5,1.5", "--same-direction"], &["--planet-speed 2.4"]),
        (&["select", "--ratios", "3.9375", "--least-efficiency", "0.99"], &["--least-efficiency 0.977"]),
        (&["select", "--ratios", "12.5", "--k", "1.3..10"], &["--k 1.3..11.5"]),
        (&["select", "--ratios", "2, 1.3", "--planet-speed", "1.2"], &["--all-structures"]),
    ];
    for (args, options) in list {
        let done = output(&examples(), args);
        let said = text(&done.stderr);
        assert_eq!(done.status.code(), Some(1), "{args:?} {done:?}");
        for option in *options {
            assert!(text(&done.stdout).contains(option), "{args:?}: {option} in {}", text(&done.stdout));
            let words: Vec<&str> = option.split(' ').collect();
            let mut line: Vec<&str> = args.to_vec();
            if let Some(at) = line.iter().position(|word| *word == words[0]) {
                line.drain(at..at + 2);
            }
            let helped = output(&examples(), &[&line[..], &words].concat());
            assert_eq!(helped.status.code(), Some(0), "{line:?} {option}");
        }
        assert!(said.starts_with("error: no design meets every required criterion; --"), "{said}");
    }
}

/// At a load factor the file has what it asks for: then forces on the planets follow.
#[test]
fn a_saved_design_has_the_module_and_face_width_of_its_load_factor() {
    let folder = here();
    let line = ["select", "--ratios", "3.9375", "--teeth", "--torque", "500 N·m", "--load-factor", "2 MPa"];
    let done = output(folder.path(), &[&line[..], &["--save", "set.yaml", "--format", "json"]].concat());
    let found: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let module = 1000.0 * found["designs"][0]["tooth_numbers"][0]["module_m"].as_f64().unwrap();
    let saved = std::fs::read_to_string(folder.path().join("set.yaml")).unwrap();
    let written = saved.split("module: ").nth(1).unwrap().split(' ').next().unwrap();
    assert!((written.parse::<f64>().unwrap() / module - 1.0).abs() < 1e-4, "{saved}");
    assert!(saved.contains("face_width: "), "{saved}");
    let read = output(folder.path(), &["analyze", "set.yaml", "--torque", "500 N·m", "--format", "json"]);
    let read: serde_json::Value = serde_json::from_slice(&read.stdout).unwrap();
    assert!(read["planet_bearings"][0]["carrier_radius_m"].as_f64().unwrap() > 0.0, "{read}");
}

/// One design of each scheme is listed besides the first ones of the front, which are similar.
#[test]
fn the_best_design_of_each_scheme_is_told() {
    let line = ["select", "--ratios", "1.465,2.56", "--teeth", "--ring", "..60", "--planet-speed", "4"];
    let more = ["--order", "efficiency", "--all-structures", "--format", "json"];
    let done = output(&examples(), &[&line[..], &more].concat());
    let found: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let best = found["best_of_structures"].as_array().unwrap();
    let first = &found["designs"][0];
    assert_eq!(best[0]["structure"], first["candidate"]["structure"]);
    assert_eq!(best[0]["tooth_numbers"], first["tooth_numbers"]);
    let structures: std::collections::BTreeSet<String> =
        best.iter().map(|one| one["structure"].to_string()).collect();
    assert!(best.len() > 3 && structures.len() == best.len(), "{}", best.len());
    let efficiency = |one: &serde_json::Value| one["objectives"]["efficiency"].as_f64().unwrap();
    // Those that reverse follow all others.
    let reverses = |one: &&serde_json::Value| one["mixed_directions"].as_bool().unwrap();
    for of_kind in [false, true] {
        let ranked: Vec<f64> = best.iter().filter(|one| reverses(one) == of_kind).map(efficiency).collect();
        assert!(ranked.windows(2).all(|pair| pair[0] >= pair[1]), "{ranked:?}");
    }
    // A scheme by itself has no other best design.
    let other = best[1]["structure"].as_str().unwrap();
    assert!(
        found["designs"].as_array().unwrap().iter().all(|one| one["candidate"]["structure"] != *other)
            || efficiency(&best[1]) <= efficiency(&best[0])
    );
}

/// A brake may be called as another column is.
#[test]
fn columns_of_csv_have_names_of_their_own() {
    let folder = here();
    let file = "gearbox: clash\ninput: D\noutput: B\nsets: [{ id: P, sun: D, ring: T1, carrier: B, k: 3 }]\nbrakes: [{ id: output, \
                link: T1 }]\ngears: [{ name: slow, engaged: [output] }]\n";
    std::fs::write(folder.path().join("clash.yaml"), file).unwrap();
    let done = output(folder.path(), &["analyze", "clash.yaml", "--format", "csv"]);
    let header: Vec<String> =
        text(&done.stdout).lines().next().unwrap().split(',').map(str::to_owned).collect();
    let names: std::collections::BTreeSet<&String> = header.iter().collect();
    assert_eq!(names.len(), header.len(), "{header:?}");
    for name in ["output_torque_n_m", "output.torque_n_m", "output_slip_of_input"] {
        assert!(header.iter().any(|other| other == name), "{name} in {header:?}");
    }
    let done = output(&examples(), &["analyze", "ravigneaux.yaml", "--format", "csv"]);
    assert!(text(&done.stdout).lines().any(|line| line.starts_with("1,FWD+F1,")), "{done:?}");
}

/// The second of the designs for two speeds, read back.
#[test]
fn a_saved_set_of_two_speeds_has_the_teeth_that_were_chosen() {
    let folder = here();
    let list = ["select", "--ratios", "3.9375", "--teeth", "--limit", "3", "--format", "json"];
    let done = output(folder.path(), &[&list[..], &["--save", "set.yaml", "--nth", "2"]].concat());
    assert!(done.status.success(), "{done:?}");
    let found: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let design = &found["designs"][1];
    let text = std::fs::read_to_string(folder.path().join("set.yaml")).unwrap();
    let of = |member: &str| design["tooth_numbers"][0][member].to_string();
    let [sun, planet, ring, planets] = ["sun", "planet", "ring", "planets"].map(of);
    let teeth = format!("teeth: [{sun}, {ring}], planet_teeth: [{planet}], planets: {planets}");
    assert!(text.contains(&teeth), "{teeth} in\n{text}");
    let gears = analyzed(folder.path(), "set.yaml");
    let ratio = design["candidate"]["gears"][0]["ratio"].as_f64().unwrap();
    assert_eq!(gears[0].0, "1");
    assert!((gears[0].1 - ratio).abs() < 1e-12 && gears[1] == ("2".to_owned(), 1.0), "{gears:?}");
    for args in [&["draw", "set.yaml", "-o", "set.svg"][..], &["report", "set.yaml", "-o", "set.html"]] {
        assert!(output(folder.path(), args).status.success(), "{args:?}");
    }
}

/// The file holds what was chosen: ratios, teeth, and the direct-drive clutch of least torque that can be
/// drawn.
#[test]
fn a_saved_choice_has_its_ratios_and_its_direct_drive_clutch() {
    let folder = here();
    let list = ["select", "--ratios", "1.465, 2.56", "--planet-speed", "3", "--format", "json"];
    let run = |more: &[&str]| {
        let done = output(folder.path(), &[&list[..], more].concat());
        assert!(done.status.success(), "{done:?}");
        serde_json::from_slice::<serde_json::Value>(&done.stdout).unwrap()
    };
    let teeth = ["--save", "teeth.yaml", "--teeth", "--ring", "..60", "--limit", "1"];
    let found = [run(&["--save", "k.yaml", "--nth", "2"]), run(&teeth)];
    let chosen = [&found[0]["candidates"][1], &found[1]["designs"][0]["candidate"]];
    for (file, candidate) in ["k.yaml", "teeth.yaml"].into_iter().zip(chosen) {
        let text = std::fs::read_to_string(folder.path().join(file)).unwrap();
        assert!(text.contains("teeth: [") == (file == "teeth.yaml"), "{text}");
        let clutches = candidate["direct_drive_clutches"].as_array().unwrap();
        let clutch = clutches.iter().find(|clutch| clutch["chosen"] == true).unwrap();
        let links = clutch["links"].as_array().unwrap().iter().map(|link| format!("{link}"));
        let links = format!("links: [{}]", links.collect::<Vec<_>>().join(", "));
        assert!(text.contains(&links), "{links} in {text}");
        let analyzed = analyzed(folder.path(), file);
        let gears = candidate["gears"].as_array().unwrap().iter();
        let mut due: Vec<f64> = gears.map(|gear| gear["ratio"].as_f64().unwrap()).chain([1.0]).collect();
        due.sort_by(|one, other| (*one < 0.0).cmp(&(*other < 0.0)).then(other.abs().total_cmp(&one.abs())));
        assert_eq!(analyzed.len(), due.len());
        for (place, ((name, ratio), due)) in analyzed.iter().zip(due).enumerate() {
            // Numbered as they are driven: the slowest first, with reverse gears behind them.
            let number = if due > 0.0 { (place + 1).to_string() } else { format!("R{place}") };
            assert!(*name == number && (ratio / due - 1.0).abs() < 1e-9, "{file} {name} {ratio} {due}");
        }
    }
    for line in [&["draw", "k.yaml", "-o", "k.svg"][..], &["report", "teeth.yaml", "-o", "teeth.html"]] {
        let done = output(folder.path(), line);
        assert!(done.status.success(), "{line:?}: {done:?}");
    }
    let refused = output(folder.path(), &[&list[..], &["--save", "no.yaml", "--nth", "99"]].concat());
    assert!(!refused.status.success() && !folder.path().join("no.yaml").exists());
    assert!(String::from_utf8_lossy(&refused.stderr).contains("--nth"), "{refused:?}");
}

#[test]
fn a_saved_solution_has_its_ratios_and_is_drawn_reported_and_found_again() {
    let folder = here();
    let search = |more: &str| {
        let ratios = "--ratios '3.059, 1.625, 1, 0.696, -2.294'";
        let class = "--sets 2 --elements 5 --engaged 2 --class all-sparse";
        run(folder.path(), &format!("synthesize {ratios} {class} {more}"))
    };
    let found = |more: &str| {
        let done = search(more);
        assert!(done.status.success(), "{done:?}");
        text(&done.stdout)
    };
    let wanted = [("1", 3.059), ("2", 1.625), ("3", 1.0), ("4", 0.696), ("R", -2.294)];
    for (file, more) in [("k.yaml", "--nth 2"), ("teeth.yaml", "--teeth --limit 1")] {
        found(&format!("--save {file} {more}"));
        for ((gear, ratio), (name, wanted)) in analyzed(folder.path(), file).iter().zip(wanted) {
            assert_eq!(gear, name, "{file}");
            assert!((ratio / wanted - 1.0).abs() <= 0.01, "{file}: {gear} {ratio}");
        }
    }
    for line in [&["draw", "k.yaml", "-o", "k.svg"][..], &["report", "teeth.yaml", "-o", "teeth.html"]] {
        let done = output(folder.path(), line);
        assert!(done.status.success(), "{line:?}: {done:?}");
    }
    // The saved gearbox is the second of the search, by its structure and shift elements.
    let told = found("--explain k.yaml --limit 1");
    assert!(told.contains("it is gearbox 2 of the search"), "{told}");
    // A page has the best of each of the three families, or the first ten of all; the last families and
    // gearboxes are not drawable. The best stands at the head of the page once more.
    for (more, drawn) in [("", 3), ("--all-gearboxes", 7)] {
        let page = found(&format!("-o search.html {more}"));
        assert!(page.is_empty());
        let page = std::fs::read_to_string(folder.path().join("search.html")).unwrap();
        assert!(page.starts_with("<!DOCTYPE html>"), "{}", page.len());
        assert_eq!(page.matches("<svg").count(), drawn, "{more:?}");
    }
    let refused = search("--save no.yaml --nth 15");
    assert!(!refused.status.success() && !folder.path().join("no.yaml").exists());
    assert!(String::from_utf8_lossy(&refused.stderr).contains("--nth"), "{refused:?}");
}

#[test]
fn what_leaves_all_of_a_class_out_is_told_before_a_larger_one_is_searched() {
    let folder = here();
    let told = |elements: &str| {
        let search = "synthesize --ratios '3.059, 1.625, 1, 0.696, -2.294' --class all-sparse --sets 2 --engaged 2 --slip 1.4";
        text(&run(folder.path(), &format!("{search} --elements {elements}")).stderr)
    };
    let note = "note: up to 2 sets with 5 shift elements nothing is left; left out 14 with a faster slip of an open shift element\n";
    assert!(told("5..6").contains(note), "{}", told("5..6"));
    assert!(!told("4").contains("nothing is left"));
}
