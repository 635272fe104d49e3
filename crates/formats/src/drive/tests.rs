//! Drive files: what they mean, and what is refused where.

use super::*;
use crate::Problem;
use epicyclic_dynamics::drive::{Bore, CarrierSpec, Start, TeethSpec, design};
use epicyclic_units::Physical;

const EXCAVATOR: &str = include_str!("../../../../examples/xe215cll-drive.yaml");
const MINIMAL: &str = include_str!("../../../../examples/minimal-drive.yaml");

fn spec(text: &str) -> Result<DriveSpec, Error> {
    read(&Document::parse_one("drive.yaml", text.as_bytes())?).map(|(_, spec)| spec)
}

/// The message of a refusal, whether by the reader, by the file's meaning or by the calculation.
fn refusal(text: &str) -> String {
    let document = Document::parse_one("drive.yaml", text.as_bytes()).unwrap();
    match read(&document) {
        Err(error) => error.to_string(),
        Ok((_, spec)) => {
            let error = design(&spec).unwrap_err();
            document.error(&place(&error), Problem::refused(error.name(), error.to_string())).to_string()
        }
    }
}

fn with(old: &str, new: &str) -> String {
    assert!(EXCAVATOR.contains(old), "{old}");
    EXCAVATOR.replacen(old, new, 1)
}

#[test]
fn the_example_is_the_excavator() {
    let found = design(&spec(EXCAVATOR).unwrap()).unwrap();
    let teeth = found.teeth.numbers;
    assert_eq!((teeth.sun.get(), teeth.planet.get(), teeth.ring.get(), teeth.planets), (20, 40, 100, 4));
    assert!((found.gear_set.ring.root_diameter().mm() - 819.2).abs() < 1e-9);
    let names: Vec<_> = found.warnings.iter().map(epicyclic_dynamics::drive::Warning::name).collect();
    assert_eq!(names, ["shaft-too-thin"; 3]);
    assert_eq!(found.with_losses.start, Start::InBalance);
}

#[test]
fn the_least_file_is_a_drive() {
    let read = spec(MINIMAL).unwrap();
    let plain = DriveSpec::new(read.power, read.speed, 5.0, read.gear_set.module, read.gear_set.face_width);
    assert_eq!(read, plain);
    let found = design(&read).unwrap();
    let names: Vec<_> = found.warnings.iter().map(epicyclic_dynamics::drive::Warning::name).collect();
    assert_eq!(names, ["carrier-neglected"]);
}

#[test]
fn teeth_given_in_full_need_no_ratio() {
    let without = with("ratio: 6\n", "");
    assert_eq!(spec(&without.replacen("sun: 20\n", "sun: 20\n  planet: 40\n", 1)).unwrap().ratio, 6.0);
    assert_eq!(spec(&without.replacen("sun: 20\n", "sun: 20\n  ring: 100\n", 1)).unwrap().ratio, 6.0);
    assert_eq!(refusal(&without), "drive.yaml:4:1: the key ratio is missing");
    let range = spec(&with("sun: 20\n", "sun: 17..40\n  ring: ..=150\n  spacing: least-unequal\n")).unwrap();
    match range.teeth {
        TeethSpec::Within(bounds) => {
            assert_eq!((bounds.sun, bounds.ring, bounds.planets), (17..=40, 12..=150, 4..=4));
        }
        TeethSpec::Given { .. } => panic!("a range was taken for a number"),
    }
}

#[test]
fn every_optional_key_is_understood() {
    let text = with("ratio: 6\n", "ratio: 6\nratio_tolerance: 2 %\nattached: { motor: 0.05 kg·m², machine: 2 kgm2 }\nstart: { driving_torque: 600 Nm, load: 2 kN·m }\n")
        .replace("  planets: 4", "  planet: 17..\n  tip_gap: 0.4\n  spacing: equal\n  planets: 4")
        .replace("clearance: 0.2 ", "addendum: 1\n  pressure_angle: 20 deg\n  planet_bore: 120 mm\n  clearance: 0.2 ")
        .replace("allowable_stress: 20 MPa", "allowable_stress: 15 MPa\n  bearing_series: 300");
    let read = spec(&text).unwrap();
    assert_eq!(read.ratio_tolerance, 0.02);
    assert_eq!(read.gear_set.planet_bore, Bore::Given("120 mm".parse::<Quantity<Length>>().unwrap().0));
    assert!(matches!(design(&read).unwrap().with_losses.start, Start::After(_)));
    let inertia =
        text.split("carrier:\n  arms").next().unwrap().to_owned() + "carrier: { inertia: 0.144 kg·m² }\n";
    assert!(matches!(spec(&inertia).unwrap().carrier, CarrierSpec::Inertia(_)));
}

#[test]
fn refusals_name_field_line_and_column() {
    let refusals: Vec<String> = [
        ("power: 106.5", "power: 106,5"),
        ("106.5 kW", "106.5 Nm"),
        ("power: 106.5 kW", "power: -1 kW"),
        ("ratio: 6", "ratio: 60"),
        ("ratio: 6", "ratio: 6\nratios: 6"),
        ("sun: 20", "sun: 0"),
        ("sun: 20", "sun: 40..20"),
        ("sun: 20", "sun: 20.5"),
        ("sun: 20", "sun: [20]"),
        ("sun: 20", "sun: 300.."),
        ("planets: 4 ", "planets: 9 "),
        ("sun: 20", "sun: 20\n  planet: 40\n  ring: 101"),
        ("sun: 20", "sun: 20\n  ring: 101"),
        ("sun: 20", "sun: 20\n  planet: 0"),
        ("sun: 20", "sun: 20\n  tip_gap: -1"),
        ("sun: 20", "sun: 20\n  spacing: even"),
        ("sun_planet: 0.97", "sun_planet: 97"),
        ("module: 8 mm", "module: 0 mm"),
        ("density: 7900 kg/m³", "density: 7900 kg"),
        ("sun_bore: bearing", "sun_bore: hole"),
        ("sun_bore: bearing", "sun_bore: 50"),
        ("sun_bore: bearing", "sun_bore: -5 mm"),
        ("sun_bore: bearing", "sun_bore: 141 mm"),
        ("allowable_stress: 20 MPa", "bearing_series: 500"),
        ("allowable_stress: 20 MPa", "allowable_stress: 0 MPa"),
        ("bearing: 310", "bearing: 510"),
        ("diameter: 60 mm", "diameter: 0 mm"),
        ("{ diameter: 50 mm, bearing: 310 }", "{ diameter: 120 mm }"),
        ("hole: { radius: 30 mm", "hole: { radius: 45 mm"),
        ("width: 80 mm", "width: 800 mm"),
        ("outside_radius: 105 mm", "outside_radius: 90 mm"),
        ("  arms:", "  inertia: 1 kg·m²\n  arms:"),
        ("ratio: 6", "ratio: 6\nattached: { motor: -1 kg·m² }"),
        ("ratio: 6", "ratio: 6\nstart: { driving_torque: 0 N·m }"),
        ("ratio: 6", "ratio: 6\nratio_tolerance: -1 %"),
    ]
    .into_iter()
    .map(|(old, new)| refusal(&with(old, new)))
    .collect();
    insta::assert_snapshot!(refusals.join("\n"));
}

#[test]
fn the_schema_describes_every_key() {
    let schema = schemars::schema_for!(DriveFile);
    let text = serde_yaml::to_string(schema.as_value()).unwrap();
    for key in [
        "mesh_efficiency",
        "sun_bore",
        "from_outer_end",
        "driving_torque",
        "bearing_series",
        "Default 20 MPa",
    ] {
        assert!(text.contains(key), "{key}");
    }
    assert_eq!(text.matches("additionalProperties: false").count(), 14);
}
