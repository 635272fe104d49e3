//! Designs whose fast stage is a pair of gears on parallel axes.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common::{GO_ON, stages, taken};
use epicyclic_commands::design::Request;
use epicyclic_commands::design::answer::stages::Stages;
use epicyclic_commands::design::answer::ways_out::Limit;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::size;
use epicyclic_commands::size::answer::records::SizedDesign;
use epicyclic_commands::words::request;
use epicyclic_formats::Document;
use epicyclic_formats::yaml::{Value, to_string};

const SPACE: &str = "--modules=2mm, 3mm, 4mm|--face-widths=20mm, 30mm, 50mm, 80mm";

/// Mass of the lightest size of a pair by `size`, which makes layouts of any set; `None` where none keeps to usual
/// practice.
fn mass_of(file: &str, teeth: [u32; 2], sizes: &str) -> Option<f64> {
    let mut file = Document::parse_one("pair.yaml", file.as_bytes()).unwrap().value().clone();
    let set = file["sets"][0].as_mapping_mut().unwrap();
    for key in ["module", "face_width", "profile_shifts", "tip_alterations"] {
        set.shift_remove(key).unwrap();
    }
    set.insert("teeth".into(), Value::Sequence(teeth.map(Value::from).to_vec()));
    set["strength"]["factors"]["K_H_beta"] = 1.25.into();
    let text = to_string(&file).unwrap();
    let request: size::Request = request(sizes.split('|').chain(["--minimise=whole", "--most=1"])).unwrap();
    let request = size::Request { widens_face_load: true, ..request };
    let size = request.answer(&Gearbox::parse("pair.yaml", text.as_bytes()).unwrap(), &GO_ON).unwrap();
    size.sets[0].found.first().filter(|best| best.rules_missed == 0).map(SizedDesign::with_structure_kg)
}

/// Every pair with the ratio, sized one by one as any set of a file is.
#[test]
fn the_best_pair_is_the_lightest_of_all_sized_one_by_one() {
    for (torque, helix) in [(30, 0), (600, 0), (600, 17)] {
        let stages = stages(&format!(
            "--ratio=4|--tolerance=0|--axes=parallel|--stages=1|--torque={torque} N·m|--input=1500rpm|\
             --helix-angle={helix}deg|{SPACE}"
        ));
        let best = taken(&stages);
        let file = stages.file.unwrap();
        let all = (17..=30).filter_map(|pinion| mass_of(&file, [pinion, 4 * pinion], SPACE));
        let least = all.reduce(f64::min).unwrap();
        assert!((best.mass_kg / least - 1.0).abs() < 1e-9, "{} for {least}: {:?}", best.mass_kg, best.teeth);
        assert_eq!(best.rules_missed, 0);
    }
}

/// Speeds and losses of the file are those of a pair before sets with held rings: by the solver, and by the
/// product over the stages.
#[test]
fn the_file_of_a_train_behind_a_pair_has_its_ratio_and_losses() {
    for (ratio, speed) in [(12.0, "1500rpm"), (1.0 / 12.0, "120rpm"), (-12.0, "1500rpm")] {
        let words = format!(
            "--ratio={ratio}|--axes=parallel|--stages=2|--output-torque=300 N·m|--input={speed}|--efficiency=0.96|\
             --sun=18..24|--planets=3|{SPACE}"
        );
        let stages = stages(&words);
        let best = taken(&stages);
        let near = |one: f64, other: f64| assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}");
        let (pairs, sets): (Vec<_>, Vec<_>) = best.teeth.iter().partition(|teeth| teeth.len() == 2);
        let [pair] = pairs[..] else { panic!("{:?}", best.teeth) };
        let u = f64::from(pair[1]) / f64::from(pair[0]);
        let k: f64 = sets.iter().map(|teeth| f64::from(teeth[2]) / f64::from(teeth[0])).sum();
        assert_eq!(sets.len(), 1);
        let reduction = -u * (1.0 + k);
        near(stages.ratio.unwrap(), if f64::abs(ratio) > 1.0 { reduction } else { 1.0 / reduction });
        near(stages.asked_ratio, ratio);
        // A pair has two thirds of the loss of a set.
        let of_pair = 1.0 - 0.04 * 2.0 / 3.0;
        let of_set = match f64::abs(ratio) > 1.0 {
            true => (1.0 + 0.96 * k) / (1.0 + k),
            false => (1.0 + k) / (1.0 + k / 0.96),
        };
        near(stages.efficiency.unwrap(), of_pair * of_set);
        near(stages.output_torque_n_m.unwrap(), 300.0);
        let gearbox = Gearbox::parse("design.yaml", stages.file.unwrap().as_bytes()).unwrap();
        let analysis = gearbox.train.analyze_gear(&gearbox.train.gears()[0]).unwrap();
        near(analysis.ratio().unwrap(), stages.ratio.unwrap());
        near(analysis.efficiency().unwrap(), stages.efficiency.unwrap());
    }
}

/// Of both kinds of trains the cheaper one is taken.
#[test]
fn either_kind_is_taken_by_its_price() {
    // The set of the last order has larger bearings than those of the tables.
    for order in [
        "--ratio=3|--torque=300 N·m|--input=1500rpm",
        "--ratio=5|--torque=300 N·m|--input=1500rpm",
        "--ratio=3|--power=30kW|--input=2000rpm",
    ] {
        let of = |axes: &str| stages(&format!("{order}|--axes={axes}|--stages=1"));
        let price = |stages: &Stages| taken(stages).price_kg;
        let [one, other, either] = ["coaxial", "parallel", "either"].map(of);
        assert!((price(&either) - price(&one).min(price(&other))).abs() < 1e-9);
        assert_eq!(either.trains.len(), 2);
    }
}

/// A limit of rings bounds no pair, which has no smaller ring either.
#[test]
fn a_pair_alone_has_no_ring() {
    let order = "--ratio=1.8|--power=20kW|--input=1500rpm|--axes=parallel|--stages=1";
    let free = stages(&format!("{order}|--front"));
    assert_eq!(free.front.as_deref(), Some(&[][..]));
    let bound = stages(&format!("{order}|--max-ring=60mm"));
    assert_eq!(taken(&free), taken(&bound));
}

/// A ratio that no held ring gives, and the option that does.
#[test]
fn a_ratio_below_that_of_sets_names_the_pair() {
    let none = stages("--ratio=1.8|--power=20kW|--input=1500rpm");
    let ways = none.ways_out.unwrap();
    let [way] = &ways[..] else { panic!("{ways:?}") };
    assert!(none.file.is_none() && way.limits[0].limit == Limit::Axes, "{way:?}");
    let stages = stages("--ratio=1.8|--power=20kW|--input=1500rpm|--axes=either");
    assert_eq!((taken(&stages).teeth, stages.ratio), (way.teeth.clone(), Some(way.ratio)));
    let request: Request =
        request("--ratio=-8|--power=20kW|--input=1500rpm|--axes=either".split('|')).unwrap();
    let error = request.answer_stages(&GO_ON).unwrap_err().to_string();
    assert!(error.contains("--axes coaxial"), "{error}");
}
