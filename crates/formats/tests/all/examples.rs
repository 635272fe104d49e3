//! The project's example files read, and say what they claim.

use epicyclic_formats::Document;
use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use std::path::Path;

fn example<T: serde::de::DeserializeOwned>(name: &str) -> T {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    let bytes = std::fs::read(path).expect("the example is part of the project");
    Document::parse_one(name, &bytes).and_then(|document| document.read()).expect("the example reads")
}

#[test]
fn every_published_ratio_of_five_transmissions_holds() {
    let file: TransmissionsFile = example("real-transmissions.yaml");
    assert_eq!(file.transmissions.len(), 5);
    let mut gears = 0;
    for transmission in &file.transmissions {
        let gearbox = transmission.gearbox().unwrap();
        assert_eq!(gearbox.to_builder().build().as_ref(), Ok(&gearbox));
        for gear in &transmission.gears {
            let ratio = gearbox.analyze(&gear.name).unwrap().ratio().unwrap();
            assert!(gear.stands_for(ratio), "{} {}: {ratio}", transmission.name, gear.name);
            gears += 1;
        }
    }
    assert_eq!(gears, 25);
}

#[test]
fn closed_planetary_gears_have_the_ratios_of_their_comments() {
    let (k1, k2) = (3.0, 2.5);
    let of = |name: &str| example::<GearboxFile>(name).gearbox().unwrap();
    let gearbox = of("closed-by-ordinary-train.yaml");
    let by_train = gearbox.analyze("closed").unwrap();
    assert!((by_train.ratio().unwrap() - (-k1 - k2 - k1 * k2)).abs() < 1e-13);
    assert!(by_train.ideal().unwrap().power.circulating < 1e-12);
    let gearbox = of("closed-by-planetary-gear.yaml");
    let by_row = gearbox.analyze("closed").unwrap();
    assert!((by_row.ratio().unwrap() - (1.0 - k1 / k2)).abs() < 1e-13);
    assert!(by_row.ideal().unwrap().power.circulating > 1.0);
}

#[test]
fn a_sized_gearbox_lacks_nothing_for_the_forces_on_its_planets() {
    let file: GearboxFile = example("sized-gearbox.yaml");
    let bearings = file.planet_bearings(&file.gearbox().unwrap()).unwrap();
    assert_eq!(bearings.len(), 2);
    assert!(bearings.iter().all(|bearing| bearing.lacks.is_empty()), "{bearings:?}");
    let unsized_: GearboxFile = example("scheme-ii-3.yaml");
    let bearings = unsized_.planet_bearings(&unsized_.gearbox().unwrap()).unwrap();
    assert!(bearings.iter().all(|bearing| bearing.lacks.len() == 3), "{bearings:?}");
}

#[test]
fn automatic_transmissions_have_the_ratios_of_their_comments() {
    let cases: [(&str, &[f64]); 2] = [
        ("simpson.yaml", &[2.44, 2.44, 1.45, 1.0, -2.2]),
        ("lepelletier.yaml", &[4.171, 2.340, 1.521, 1.143, 0.867, 0.691, -3.403]),
    ];
    for (name, published) in cases {
        let gearbox = example::<GearboxFile>(name).gearbox().unwrap();
        let ratios = gearbox.gears().iter().map(|gear| gearbox.analyze_gear(gear).unwrap().ratio().unwrap());
        for (ratio, published) in ratios.zip(published) {
            // Three decimals of the second, two of the first.
            let last = if name == "simpson.yaml" { 0.005 } else { 0.0006 };
            assert!((ratio - published).abs() < last, "{name}: {ratio}, {published}");
        }
        assert_eq!(gearbox.gears().len(), published.len());
    }
}
