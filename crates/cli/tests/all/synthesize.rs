//! `synthesize`: sets that share planets in its answer and its file, forward and reverse gears apart, where
//! the search stops.

use super::common::{here, output};
use serde_json::Value;
use std::path::Path;

fn answer(folder: &Path, args: &[&str]) -> Value {
    let done = output(folder, &[args, &["--format", "json"][..]].concat());
    assert!(done.status.success(), "{args:?} {done:?}");
    serde_json::from_slice(&done.stdout).expect("an answer in JSON")
}

fn list<'a>(of: &'a Value, key: &str) -> &'a Vec<Value> {
    of[key].as_array().expect("a list")
}

/// 1-2-a b-2-a*, brakes a and b, at k 2.2 and 2.8 has the ratios −k₁ and (k₁ + k₂)/(k₂ − 1) = 5/1.8.
const RAVIGNEAUX: [&str; 12] = [
    "synthesize",
    "--ratios=2.7778, -2.2",
    "--sets",
    "2",
    "--elements",
    "2",
    "--engaged",
    "1",
    "--double-planets",
    "1",
    "--all-gearboxes",
    "--first-class",
];

#[test]
fn a_saved_compound_set_has_the_figures_of_the_answer() {
    let folder = here();
    let found = answer(folder.path(), &RAVIGNEAUX);
    let is_compound = |one: &&Value| list(one, "shared_planets").iter().any(|of| of["apart"].is_null());
    let compounds: Vec<&Value> = list(&found, "solutions").iter().filter(is_compound).collect();
    assert!(!compounds.is_empty());
    for solution in compounds {
        let number = solution["number"].to_string();
        let done =
            output(folder.path(), &[&RAVIGNEAUX[..], &["--save", "box.yaml", "--nth", &number]].concat());
        assert!(done.status.success(), "{done:?}");
        let file = std::fs::read_to_string(folder.path().join("box.yaml")).unwrap();
        assert!(file.contains("compound_sets:") && file.contains("proportional: true"), "{file}");
        let analysed = answer(folder.path(), &["analyze", "box.yaml"]);
        let efficiencies = |gears: &Vec<Value>, key: &str| {
            let mut all: Vec<f64> = gears.iter().filter_map(|gear| gear[key].as_f64()).collect();
            all.sort_by(f64::total_cmp);
            all
        };
        let told = efficiencies(list(solution, "gears"), "efficiency");
        let by_analyze = efficiencies(list(&analysed, "gears"), "efficiency");
        assert_eq!(told.len(), 2);
        assert!(
            told.iter().zip(&by_analyze).all(|(one, other)| (one - other).abs() < 1e-9),
            "{told:?} {by_analyze:?}"
        );
    }
}

/// The limits of a usable gearbox decide where the search ends; searches of the single classes give the
/// expected result.
#[test]
fn a_search_goes_on_until_a_gearbox_is_of_use() {
    let folder = here();
    let search = |elements: &str, more: &[&str]| {
        let args = ["synthesize", "--ratios=6, 1.5", "--sets", "2", "--engaged", "1..2", "--all-gearboxes"];
        answer(folder.path(), &[&args[..], &["--elements", elements], more].concat())
    };
    let of_class = |elements| search(elements, &["--first-class"]);
    let classes = [of_class("2"), of_class("3")];
    let of_use = |class: &Value, limit: f64| {
        let is_of_use = |one: &&Value| {
            one["rating"]["drawable"] == true && one["forward_efficiency"].as_f64().unwrap() >= limit
        };
        list(class, "solutions").iter().filter(is_of_use).count()
    };
    let found = |class: &Value| class["found"].as_u64().unwrap();
    let mut ends = std::collections::BTreeSet::new();
    for limit in ["0", "0.8", "0.85", "0.9", "0.93", "0.95", "0.97", "1"] {
        let value: f64 = limit.parse().unwrap();
        let whole = search("2..3", &["--least-efficiency", limit, "--most-circulating", "1000"]);
        let behind: u64 =
            list(&whole, "left_behind").iter().map(|of| of["solutions"].as_u64().unwrap()).sum();
        let [smaller, larger] =
            [&classes[0], &classes[1]].map(|class| (of_use(class, value) > 0, found(class)));
        let (expected, left) = match (smaller, larger) {
            ((true, all), _) => (all, 0),
            ((false, left), (true, all)) => (all, left),
            ((false, one), (false, other)) => (one + other, 0),
        };
        assert_eq!((found(&whole), behind), (expected, left), "{limit}");
        ends.insert(expected);
    }
    assert_eq!(ends.len(), 3, "{ends:?}");
}

#[test]
fn reverse_gears_do_not_decide_and_shares_weigh_the_forward_ones() {
    let folder = here();
    let search = |more: &[&str]| {
        let args =
            ["synthesize", "--ratios=3.059, 1.625, 1, 0.696, -2.294", "--sets", "2", "--elements", "5"];
        let more = [&["--engaged", "2", "--class", "all-sparse", "--all-gearboxes"], more].concat();
        answer(folder.path(), &[&args[..], &more].concat())
    };
    let efficiency = |gear: &Value| gear["efficiency"].as_f64().unwrap();
    for one in list(&search(&[]), "solutions") {
        let gears = list(one, "gears");
        let least = gears[..4].iter().map(efficiency).fold(1.0, f64::min);
        assert_eq!(one["forward_efficiency"].as_f64(), Some(least));
        assert_eq!(one["reverse_efficiency"].as_f64(), Some(efficiency(&gears[4])));
    }
    let shares = [0.05, 0.15, 0.3, 0.5];
    let by_shares = search(&["--shares", "1:5%, 2:15%, 3:30%, 4:50%", "--order", "efficiency"]);
    let mut last = f64::INFINITY;
    for one in list(&by_shares, "solutions") {
        let mean: f64 =
            list(one, "gears").iter().zip(shares).map(|(gear, share)| share * efficiency(gear)).sum();
        assert!((one["mean_efficiency"].as_f64().unwrap() - mean).abs() < 1e-12);
        assert!(mean < last + 1e-5, "{mean} after {last}");
        last = mean;
    }
}
