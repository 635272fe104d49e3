//! The command `motor` from outside: its answers, its refusals, its files read back.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common;

use common::{examples, here, output, session, text};
use dxf::Drawing;
use dxf::entities::EntityType;
use dxf::enums::Units;
use std::fs;
use std::path::Path;

const FIVE_THREE: [&str; 11] =
    ["motor", "--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", "2 mm"];
const SIX_FOUR: [&str; 11] =
    ["motor", "--stator", "6", "--rotor", "4", "--z3", "66", "--zs", "10", "--module", "2 mm"];

fn with<'a>(motor: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    [motor, more].concat()
}

fn said(args: &[&str]) -> String {
    session(here().path(), args)
}

#[test]
fn a_motor_of_a_file_is_that_of_its_options() {
    let folder = examples();
    let load = ["--l", "80 mm", "--width", "40 mm", "--pressure", "20 MPa", "--speed", "100 rpm"];
    let of = |motor: &[&str], more: &[&str]| {
        text(&output(&folder, &[motor, more, &["--format", "json"]].concat()).stdout)
    };
    let (file, options) = (["motor", "motor-5x3.yaml"], with(&FIVE_THREE, &load));
    let turned = ["--angle", "30 deg"];
    assert_eq!(of(&file, &[]), of(&options, &[]));
    assert_eq!(of(&file, &turned), of(&options, &turned));
    assert_ne!(of(&file, &turned), of(&file, &[]));
}

/// Answers for programs with numbers to nine digits, without the places where limits of the teeth are
/// closest, because many are equally close.
fn seen_by_programs(args: &[&str]) -> String {
    let is_of_number = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '+' | '_');
    let rounded = |token: &str| match token.parse::<f64>() {
        Ok(value) if token.contains('.') => format!("{:.8e}", value).parse::<f64>().unwrap().to_string(),
        _ => token.to_owned(),
    };
    let line = |line: &str| -> String {
        let mut out = String::new();
        let mut token = String::new();
        for c in line.chars().chain(['\n']) {
            if is_of_number(c) {
                token.push(c);
            } else {
                out += &rounded(&std::mem::take(&mut token));
                out.push(c);
            }
        }
        out
    };
    said(args).lines().filter(|line| !line.contains("at_arc")).map(line).collect()
}

#[test]
fn a_motor_for_programs() {
    let loads = ["--a", "30.6126 mm", "--width", "50 mm", "--pressure", "200 bar", "--format", "json"];
    insta::assert_snapshot!(seen_by_programs(&with(&FIVE_THREE, &loads)));
    insta::assert_snapshot!(
        "csv",
        seen_by_programs(&with(&FIVE_THREE, &["--part", "0.4", "--format", "csv"]))
    );
}

/// Runs a motor that writes its files into a folder.
fn files(folder: &Path, motor: &[&str], view: &str) {
    let args = ["--view", view, "--angle", "20 deg", "--svg", "m.svg", "--dxf", "m.dxf", "--csv", "m.csv"];
    let done = output(folder, &with(motor, &args));
    assert!(done.status.success() && done.stderr.is_empty(), "{}", text(&done.stderr));
}

#[test]
fn drawings_open_in_cad_and_as_images() {
    for motor in [FIVE_THREE, SIX_FOUR] {
        for (view, wheel) in
            [("centrodes", "stator"), ("teeth", "stator teeth"), ("motor", "housing"), ("chambers", "rotor")]
        {
            let folder = here();
            files(folder.path(), &motor, view);
            let drawing = Drawing::load_file(folder.path().join("m.dxf").to_str().unwrap()).unwrap();
            assert_eq!(drawing.header.default_drawing_units, Units::Millimeters);
            let on_layer =
                |name: &str| drawing.entities().filter(|entity| entity.common.layer == name).count();
            assert!(on_layer(wheel) >= 1 && drawing.layers().any(|layer| layer.name == wheel), "{view}");
            // Every curve of a wheel is closed.
            for entity in drawing.entities() {
                if let EntityType::LwPolyline(line) = &entity.specific
                    && line.vertices.len() > 3
                {
                    assert!(line.is_closed(), "{view} {}", entity.common.layer);
                }
            }
            let image = fs::read_to_string(folder.path().join("m.svg")).unwrap();
            let tree = resvg::usvg::Tree::from_str(&image, &resvg::usvg::Options::default()).unwrap();
            assert!(tree.size().width() > 300.0, "{view}");
        }
    }
}

#[test]
fn the_stator_in_cad_has_the_radii_of_the_answer() {
    let folder = here();
    files(folder.path(), &with(&FIVE_THREE, &["--l", "80 mm"]), "centrodes");
    let drawing = Drawing::load_file(folder.path().join("m.dxf").to_str().unwrap()).unwrap();
    let stator = drawing.entities().find(|entity| entity.common.layer == "stator").unwrap();
    let EntityType::LwPolyline(stator) = &stator.specific else { panic!("a polyline") };
    assert_eq!(stator.vertices.len(), 10);
    let radius = |i: usize| {
        let (one, next) = (&stator.vertices[i], &stator.vertices[(i + 1) % 10]);
        0.5 * libm::hypot(next.x - one.x, next.y - one.y) / libm::sin(2.0 * libm::atan(one.bulge))
    };
    // R₂ and −R₁ of the source's vector at module 2 mm, through nine decimals of the file.
    assert!((radius(0) - 25.883_299_8).abs() < 1e-6 && (radius(1) + 32.207_592_2).abs() < 1e-6);
}

#[test]
fn the_centrodes_as_points_close_and_keep_their_length() {
    let folder = here();
    files(folder.path(), &FIVE_THREE, "motor");
    let mut reader = csv::Reader::from_path(folder.path().join("m.csv")).unwrap();
    let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    assert_eq!(header[0..4], ["wheel", "arc_length_mm", "x_mm", "y_mm"]);
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    for (wheel, teeth, lobes) in [("stator", 55.0, 5), ("rotor", 33.0, 3)] {
        let points: Vec<[f64; 2]> = rows
            .iter()
            .filter(|row| &row[0] == wheel)
            .map(|row| [row[2].parse().unwrap(), row[3].parse().unwrap()])
            .collect();
        assert_eq!(points.len(), 200 * lobes);
        let next = points.iter().cycle().skip(1);
        let length: f64 = points.iter().zip(next).map(|(a, b)| libm::hypot(b[0] - a[0], b[1] - a[1])).sum();
        let whole = std::f64::consts::PI * 2.0 * teeth;
        assert!(length < whole && length > whole * (1.0 - 1e-4), "{length} {whole}");
    }
}

#[test]
fn a_file_that_cannot_be_written_leaves_the_answer_unsaid() {
    let folder = here();
    fs::create_dir(folder.path().join("taken")).unwrap();
    let done = output(folder.path(), &with(&FIVE_THREE, &["--svg", "taken"]));
    assert!(!done.status.success() && done.stdout.is_empty());
    assert!(text(&done.stderr).contains("taken: cannot be written"));
}

const WITHOUT_SATELLITES: [&str; 9] =
    ["motor", "--stator", "5", "--rotor", "3", "--z3", "55", "--module", "2 mm"];

/// The list has the motors that `motor --zs` has, with its figures, and no other satellite has one.
#[test]
fn the_satellites_listed_are_those_that_have_a_motor() {
    let list = answered(&WITHOUT_SATELLITES);
    let below = number(&list, "satellite_teeth_below");
    let listed = list["motors"].as_array().unwrap();
    for teeth in 1..=12_u32 {
        let zs = teeth.to_string();
        let one = output(here().path(), &with(&WITHOUT_SATELLITES, &["--zs", &zs, "--format", "json"]));
        let row = listed.iter().find(|row| row["satellite_teeth"] == teeth);
        assert_eq!(one.status.success(), row.is_some(), "{teeth}");
        let is_refused = list["without"].as_array().unwrap().iter().any(|one| {
            (one["from"].as_u64().unwrap()..=one["to"].as_u64().unwrap()).contains(&u64::from(teeth))
        });
        assert_eq!(is_refused, row.is_none() && f64::from(teeth) < below, "{teeth}");
        let Some(row) = row else { continue };
        let motor: serde_json::Value = serde_json::from_slice(&one.stdout).unwrap();
        for (listed, of_motor) in [
            ("l_m", "arcs.l_m"),
            ("a_m", "arcs.a_m"),
            ("family.0.from_m", "arcs.family.0.from_m"),
            ("family.0.to_m", "arcs.family.0.to_m"),
            ("least_chamber_m2", "work.least_chamber_m2"),
            ("displacement_per_width_m2", "work.displacement_per_width_m2"),
            ("ripple", "work.ripple"),
        ] {
            assert_eq!(number(row, listed), number(&motor, of_motor), "{teeth} {listed}");
        }
        let fails = motor["tooth_limits"]
            .as_array()
            .map(|limits| limits.iter().filter(|limit| limit["verdict"] == "fails").count());
        assert_eq!(row["broken_limits"].as_array().map(Vec::len), fails, "{teeth}");
    }
    assert_eq!(list["next_satellite_teeth"], 10);
}

#[test]
fn a_construction_as_csv() {
    insta::assert_snapshot!(
        "construction_closed",
        seen_by_programs(&with(&FIVE_THREE, &["--l", "80 mm", "--construction", "--format", "csv"]))
    );
}

/// The restored vector and points of the document at module 1 mm, as its cases have them.
#[test]
fn a_construction_has_the_figures_of_the_document() {
    let motor = ["motor", "--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", "1 mm"];
    let found = answered(&with(&motor, &["--l", "40 mm", "--a", "15.30631008 mm"]));
    let third = std::f64::consts::FRAC_PI_3;
    let fifth = std::f64::consts::PI / 5.0;
    for (key, value, within) in [
        ("arcs.r1_m", 16.103_796_1e-3, 5e-11),
        ("arcs.r2_m", 12.941_649_9e-3, 5e-11),
        ("arcs.gamma_rad", 0.314_929_961_159, 1e-9),
        ("arcs.beta_rad", 0.943_248_491_877, 1e-9),
        ("junction.op_m", 25.187_096_225e-3, 5e-12),
        ("junction.op1_m", 16.480_682_926e-3, 5e-12),
        ("junction.t_rad", fifth - 0.428_956_717_8, 1e-9),
        ("junction.pi_rad", third - 0.382_756_695_9, 1e-9),
        ("closure.open_rad", 0.0, 1e-9),
        ("closure.open_by_quadrature_rad", 0.0, 1e-9),
        ("closure.a_that_closes_m", 15.306_310_08e-3, 5e-12),
        ("closure.l_that_closes_m", 40e-3, 1e-10),
    ] {
        let number = number(&found, key);
        assert!((number - value).abs() < within, "{key} {number}");
    }
    assert_eq!(found["closure"]["closes"], true);
}

/// With the distances that it says would close, the rotor closes; a motor of a file and of its `l` have one
/// construction.
#[test]
fn the_distances_that_close_do() {
    let open = answered(&with(&FIVE_THREE, &["--l", "80 mm", "--a", "31 mm"]));
    assert_eq!((&open["closure"]["closes"], &open["warnings"][0]["name"]), (&false.into(), &"open".into()));
    let [l, a] =
        ["l", "a"].map(|key| format!("{:?} m", number(&open, &format!("closure.{key}_that_closes_m"))));
    for [l, a] in [["80 mm", &a], [&l, "31 mm"]] {
        let closed = answered(&with(&FIVE_THREE, &["--l", l, "--a", a]));
        assert!(number(&closed, "closure.open_rad").abs() < 1e-11);
        let found = answered(&with(&FIVE_THREE, &["--l", l, "--construction"]));
        let distance = number(&found, "arcs.a_m") - number(&closed, "arcs.a_m");
        assert!(distance.abs() < 1e-13, "{distance}");
    }
    let of_options = said(&with(&FIVE_THREE, &["--l", "80 mm", "--construction", "--format", "json"]));
    let of_file = ["motor", "motor-5x3.yaml", "--construction", "--format", "json"];
    let of_file = text(&output(&examples(), &of_file).stdout);
    assert!(of_options.contains(of_file.trim_end()), "{of_file}");
}

#[test]
fn the_construction_is_drawn_alone_and_from_a_file() {
    let folder = here();
    let distances = ["--l", "80 mm", "--a", "31 mm", "-o", "m.dxf"];
    let done = output(folder.path(), &with(&FIVE_THREE, &distances));
    assert!(done.status.success() && text(&done.stdout).contains("at this l it closes with"));
    let drawing = Drawing::load_file(folder.path().join("m.dxf").to_str().unwrap()).unwrap();
    assert!(drawing.entities().any(|entity| entity.common.layer == "gap"));
    fs::write(
        folder.path().join("motor.yaml"),
        "stator: 5\nrotor: 3\nz3: 55\nzs: 10\nmodule: 2 mm\nl: 80 mm\n",
    )
    .unwrap();
    let drawn = |line: &[&str]| {
        let done = output(folder.path(), line);
        assert!(done.status.success(), "{}", text(&done.stderr));
        fs::read_to_string(folder.path().join("m.svg")).unwrap()
    };
    let of_draw = drawn(&["draw", "motor.yaml", "--view", "construction", "-o", "m.svg"]);
    let of_motor = drawn(&["motor", "motor.yaml", "--view", "construction", "-o", "m.svg"]);
    let alone = drawn(&["motor", "motor.yaml", "--construction", "-o", "m.svg"]);
    assert_eq!((&of_draw, &of_draw), (&of_motor, &alone));
}

const SEARCH: [&str; 10] =
    ["motor", "search", "--torque", "600 N·m", "--pressure", "20 MPa", "--stator", "5..6", "--z3", "55..66"];

#[test]
fn a_search_for_programs() {
    let wanted =
        ["motor", "search", "--displacement", "250 cm3/rev", "--stator", "5", "--z3", "55", "--zs", "10"];
    let json = ["--width-over-diameter", "0.5", "--limit", "1", "--format", "json"];
    insta::assert_snapshot!(seen_by_programs(&with(&wanted, &json)));
    let csv = ["--module", "2 mm", "--width", "45 mm", "--tolerance", "5 %", "--format", "csv"];
    insta::assert_snapshot!("search_csv", seen_by_programs(&with(&wanted, &csv)));
}

#[test]
fn the_design_that_is_drawn_is_the_motor_listed() {
    let folder = here();
    let wanted =
        ["--module", "2 mm", "--design", "2", "--format", "json", "--view", "centrodes", "--dxf", "best.dxf"];
    let done = output(folder.path(), &with(&SEARCH, &wanted));
    assert!(done.status.success(), "{}", text(&done.stderr));
    let answer: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let design = &answer["designs"][1];
    let size = &design["size"];
    let drawing = Drawing::load_file(folder.path().join("best.dxf").to_str().unwrap()).unwrap();
    let stator = drawing.entities().find(|entity| entity.common.layer == "stator").unwrap();
    let EntityType::LwPolyline(stator) = &stator.specific else { panic!("a polyline") };
    assert_eq!(stator.vertices.len() as u64, 2 * design["stator_lobes"].as_u64().unwrap());
    let (one, next) = (&stator.vertices[0], &stator.vertices[1]);
    let r2 = 0.5 * libm::hypot(next.x - one.x, next.y - one.y) / libm::sin(2.0 * libm::atan(one.bulge));
    assert!((r2 - 1e3 * size["r2_m"].as_f64().unwrap()).abs() < 1e-6);
    // And `motor` at its distance l gives the same displacement.
    let text_of = |key: &str| design[key].as_u64().unwrap().to_string();
    let [stator, rotor, z3, zs] =
        ["stator_lobes", "rotor_lobes", "stator_teeth", "satellite_teeth"].map(text_of);
    let [l, b] = ["l_m", "width_m"].map(|key| format!("{:?} m", size[key].as_f64().unwrap()));
    let again =
        ["motor", "--stator", &stator, "--rotor", &rotor, "--z3", &z3, "--zs", &zs, "--module", "2 mm"];
    let again = output(folder.path(), &with(&again, &["--l", &l, "--width", &b, "--format", "json"]));
    let again: serde_json::Value = serde_json::from_slice(&again.stdout).unwrap();
    let [found, wanted] =
        [&again["work"]["displacement_m3"], &size["displacement_m3"]].map(|value| value.as_f64().unwrap());
    assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}");
}

fn answered(args: &[&str]) -> serde_json::Value {
    let output = output(here().path(), &[args, &["--format", "json"]].concat());
    assert!(output.status.success(), "{}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// A number of an answer by its keys and places, as `flanks.contact.2.alone_pa`.
fn number(answer: &serde_json::Value, path: &str) -> f64 {
    let pointer = format!("/{}", path.replace('.', "/"));
    answer.pointer(&pointer).and_then(serde_json::Value::as_f64).unwrap_or_else(|| panic!("{path}"))
}

/// Figures derived apart from this project, to the digits that were printed.
#[test]
fn a_motor_under_load_has_the_figures_of_its_derivation() {
    let five = with(
        &FIVE_THREE,
        &[
            "--l",
            "80 mm",
            "--width",
            "50 mm",
            "--pressure",
            "20 MPa",
            "--material",
            "youngs_modulus: 210 GPa",
        ],
    );
    let five = answered(&five);
    assert!((number(&five, "flanks.forces.bearing_load.force_n") - 34_800.0).abs() < 50.0);
    let rotor = &five["flanks"]["contact"][2];
    assert_eq!((&rotor["wheel"], &rotor["by"]), (&"rotor".into(), &"crest".into()));
    assert!((number(rotor, "at_pitch_point_pa") / 1e6 - 1973.0).abs() < 0.5);

    let six = |more: &[&str]| {
        let six = [
            "motor",
            "--stator",
            "6",
            "--rotor",
            "4",
            "--z3",
            "66",
            "--zs",
            "10",
            "--module",
            "0.75 mm",
            "--l",
            "30 mm",
            "--width",
            "25 mm",
            "--pressure",
            "25 MPa",
        ];
        answered(&with(&six, more))
    };
    let made = six(&[
        "--oil",
        "dynamic_viscosity: 0.04 Pa·s, density: 870 kg/m³, bulk_modulus: 1.4 GPa",
        "--gaps",
        "satellites: 10 µm",
        "--friction",
        "0.1",
        "--ports",
        "part: 0.9",
    ]);
    let [least, greatest] =
        ["0", "1"].map(|place| number(&made, &format!("made_ports.extremes.{place}.bend_m2")) * 1e6);
    assert!((least - 156.7).abs() < 0.05 && (greatest + 170.1).abs() < 0.05, "{least} {greatest}");
    let eight = 8.0 * number(&made, "losses.leakage.satellite.flow_m3_s") * 6e4;
    assert!((eight - 0.081).abs() < 5e-4, "{eight} l/min");
    assert!((number(&made, "losses.friction.share.0") - 0.0469).abs() < 5e-5);
    assert!(number(&made, "flanks.forces.bearing_load.force_n") == 0.0);

    let second = ["motor", "--stator", "6", "--rotor", "4", "--z3", "66", "--zs", "10", "--module", "1 mm"];
    let second = answered(&with(&second, &["--cosine", "--second-harmonic", "0.015"]));
    assert!((number(&second, "cosine_law.mean_radius_m") * 1e3 - 21.0176).abs() < 5e-5);
    assert!((number(&second, "cosine_law.amplitude") - 0.10702).abs() < 5e-6);
    let areas = number(&second, "work.greatest_chamber_m2") - number(&second, "work.least_chamber_m2");
    assert!((areas * 1e6 - 96.395).abs() < 5e-4, "{areas}");
}

/// The allowed pressure belongs to the shape, and the pressure at which a stress is its limit is the one
/// allowed.
#[test]
fn the_allowed_pressure_is_where_a_stress_meets_its_limit() {
    let limits = "contact_limit: 2000 MPa, root_limit: 400 MPa";
    let at = |module: &str, l: &str, width: &str, pressure: &str| {
        let more = ["--l", l, "--width", width, "--pressure", pressure, "--material", limits];
        let motor =
            ["motor", "--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", module];
        answered(&with(&motor, &more))
    };
    let one = at("2 mm", "80 mm", "50 mm", "20 MPa");
    let allowed = number(&one, "flanks.allowed.pressure_pa");
    let other = at("3 mm", "120 mm", "20 mm", &format!("{} MPa", allowed / 1e6));
    assert!((number(&other, "flanks.allowed.pressure_pa") / allowed - 1.0).abs() < 1e-9);
    let stresses = other["flanks"]["contact"].as_array().unwrap();
    let greatest = stresses.iter().map(|one| number(one, "alone_pa")).fold(0.0, f64::max);
    let at_pitch = stresses.iter().map(|one| number(one, "at_pitch_point_pa")).fold(0.0, f64::max);
    assert!((greatest.max(at_pitch) / 2e9 - 1.0).abs() < 1e-6, "{greatest}");
    assert_eq!(one["flanks"]["allowed"]["governing"], "contact");
}

/// Without friction and gaps there are no losses but the compression; with both efficiencies multiply.
#[test]
fn losses_add_up() {
    let six =
        with(&SIX_FOUR, &["--l", "80 mm", "--width", "30 mm", "--pressure", "20 MPa", "--speed", "60 rpm"]);
    let oil = "viscosity: 46 mm²/s, density: 870 kg/m³";
    let ideal = answered(&with(&six, &["--oil", oil, "--gaps", "satellites: 0 mm", "--friction", "0"]));
    for key in ["volumetric", "mechanical.0", "total.1"] {
        let found = number(&ideal, &format!("losses.at_point.{key}"));
        assert!((found - 1.0).abs() < 1e-12, "{key} {found}");
    }
    let start = number(&ideal, "losses.friction.starting_torque_n_m.0");
    assert!((start / number(&ideal, "flanks.least_torque_n_m") - 1.0).abs() < 1e-9);
    let made =
        answered(&with(&six, &["--oil", oil, "--gaps", "satellites: 20 µm", "--friction", "0.05..0.1"]));
    let at = |key: &str| number(&made, &format!("losses.at_point.{key}"));
    let power = at("torque_n_m.0") * at("speed_rad_s") / (at("inlet_flow_m3_s") * at("pressure_pa"));
    assert!((power / at("total.0") - 1.0).abs() < 1e-12 && at("total.0") < at("total.1"));
    let flow = number(&made, "work.flow_m3_s") + number(&made, "losses.leakage.flow_m3_s");
    assert!((flow / at("inlet_flow_m3_s") - 1.0).abs() < 1e-9);
    let last = number(&made, "losses.map.total.19.19");
    assert!((last / at("total.0") - 1.0).abs() < 1e-12, "the corner of the map is the point");
}
