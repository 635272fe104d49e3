//! Limits of an order for gearboxes of several speeds, and larger sizes than usual.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common::GO_ON;
use epicyclic_commands::design::Request;
use epicyclic_commands::design::answer::Design;
use epicyclic_commands::words::request;

const ORDER: &str = "--speeds=0.8 m/s, 3.15 m/s|--power=75kW|--input=1475rpm";

fn design(words: &str) -> Design {
    let request: Request = request(format!("{ORDER}{words}").split('|')).unwrap();
    request.answer(&|_| GO_ON()).unwrap()
}

/// A limit of the mass is kept wherever one of the tooth numbers within the tolerance keeps it, each designed alone.
#[test]
fn a_limit_of_the_mass_finds_every_gearbox_that_keeps_it() {
    let (ratio, mut least) = (3.15 / 0.8, f64::INFINITY);
    for (sun, planet) in (17..=60_u32).flat_map(|sun| (17..=80_u32).map(move |planet| (sun, planet))) {
        let ring = sun + 2 * planet;
        let reached = 1.0 + f64::from(ring) / f64::from(sun);
        if !(50..=140).contains(&ring) || (reached / ratio - 1.0).abs() > 0.003 {
            continue;
        }
        for kinds in ["balls,rollers", "balls,rollers,rollers-in-bore"] {
            let teeth = format!("--sun={sun}|--planet={planet}|--ring={ring}|--bearing-type={kinds}");
            let alone = design(&format!("|--tolerance=0.3%|{teeth}"));
            least = least.min(alone.masses.map_or(f64::INFINITY, |masses| masses.whole_kg));
        }
    }
    let of = |most: f64| design(&format!("|--tolerance=0.3%|--max-mass={most}kg"));
    let free = design("|--tolerance=0.3%").masses.unwrap().whole_kg;
    assert!(least < 0.9 * free, "{least} {free}");
    for most in [free, 0.5 * (free + least), least] {
        let found = of(most);
        assert!(found.masses.unwrap().whole_kg <= most && found.file.is_some(), "{most}");
    }
    // Just below the least, and far below it, where bounds alone leave out all.
    for most in [0.999 * least, 0.2 * least] {
        let none = of(most);
        let lightest = none.limits.lightest_kg.unwrap();
        assert!(none.file.is_none() && lightest >= least * (1.0 - 1e-9), "{lightest} {least}");
        assert!(none.teeth.unwrap().complete);
        let way = &none.ways_out.unwrap()[0];
        let greatest = way.limits[0].greatest.unwrap();
        assert!((lightest..1.01 * lightest).contains(&greatest), "{greatest} {lightest}");
        assert_eq!(of(greatest).masses.unwrap().whole_kg, way.whole_kg.unwrap());
    }
}

/// The design that follows within a limit is the one that its number takes.
#[test]
fn the_next_design_is_the_one_with_its_number() {
    for more in ["", "|--max-mass=51.2kg", "|--tolerance=0.3%"] {
        let next = |number: usize| design(&format!("|--tooth-design={number}{more}")).teeth.unwrap();
        let of_first = design(more).teeth.unwrap();
        assert_eq!(of_first.taken, next(1).taken, "{more}");
        if let Some(of_second) = of_first.next {
            assert_eq!(Some(of_second), next(2).taken, "{more}");
        }
    }
}

/// Planets that turn faster on bearings of a table than is usual have rollers in their bores where these make the
/// gearbox no heavier.
#[test]
fn larger_sizes_are_taken_where_they_miss_less_and_weigh_no_more() {
    let is_fast = |of: &Design| of.warnings.iter().any(|warning| warning.name == "planet-speed");
    let whole = |of: &Design| of.masses.unwrap().whole_kg;
    let of_tables = design("|--bearing-type=balls,rollers");
    let open = design("|--may-reverse");
    assert!(is_fast(&of_tables) && !is_fast(&open), "{:?} {:?}", of_tables.warnings, open.warnings);
    assert!(whole(&open) < 0.9 * whole(&of_tables), "{:?} {:?}", open.masses, of_tables.masses);
}

/// Checks at the speed without load say so, each place of the planets once, by its greatest speed.
#[test]
fn a_runaway_names_its_speed_and_each_place_once() {
    let [fast, slow] = ["|--ratios=3.5|--runaway=8", "|--ratios=3.5|--runaway=1"].map(|words| {
        let order = ORDER.replace("--speeds=0.8 m/s, 3.15 m/s|", "");
        let request: Request = request(format!("{order}{words}").split('|')).unwrap();
        request.answer(&|_| GO_ON()).unwrap()
    });
    let speed = fast.limits.runaway_speed_rad_s.unwrap();
    assert!((speed / (8.0 * 1475.0 * std::f64::consts::TAU / 60.0) - 1.0).abs() < 1e-9, "{speed}");
    let state = ", at the speed without load: ";
    let of = |of: &Design, name: &str| -> Vec<String> {
        let all = of.warnings.iter().filter(|warning| warning.name == name);
        all.map(|warning| warning.message.clone()).collect()
    };
    let of_gears = of(&fast, "spur-speed");
    assert!(!of_gears.is_empty() && of_gears.iter().all(|message| message.contains(state)), "{of_gears:?}");
    let of_planets = of(&fast, "planet-speed");
    let (_, listed) = of_planets[0].split_once(": ").unwrap();
    let places: Vec<&str> =
        listed.split("; ").filter_map(|place| place.split(", at the speed").next()).collect();
    assert!(places.len() > 1 && listed.contains(state), "{listed}");
    for (place, one) in places.iter().enumerate() {
        assert!(!places[..place].contains(one), "{listed}");
    }
    assert!(slow.warnings.iter().all(|warning| !warning.message.contains(state)), "{:?}", slow.warnings);
}

/// The limit of the rings of each gearbox of a front finds this gearbox. Each ring is 5 % smaller than the last.
#[test]
fn a_front_of_several_gears_has_the_best_gearbox_of_each_ring() {
    let order = |more: &str| -> Request {
        let sizes = "--no-bearings|--modules=2mm, 2.5mm, 3mm|--face-widths=20mm, 30mm, 40mm";
        request(format!("--power=20kW|--input=1475rpm|{sizes}|{more}").split('|')).unwrap()
    };
    let is_smaller = |ring: f64, most: f64, before: f64| {
        let is_kept = ring <= most * (1.0 + 1e-9);
        assert!(is_kept && most <= 0.95 * before && most > 0.9 * before, "{ring} {most} {before}");
    };
    let scheme = |more: &str| order(&format!("--ratios=3.5{more}")).answer(&|_| GO_ON()).unwrap();
    let all = scheme("|--front");
    let sets = all.sizes.unwrap().sets;
    let rings = sets.iter().filter_map(|set| set.found[0].ring_diameter_m);
    let (front, mut before) = (all.front.unwrap(), rings.fold(0.0, f64::max));
    assert!(!front.is_empty());
    for point in &front {
        let most = point.limits[0].greatest.unwrap();
        is_smaller(point.ring_diameter_m, most, before);
        let alone = scheme(&format!("|--max-ring={most}m"));
        assert_eq!(alone.teeth.unwrap().taken.unwrap(), point.teeth);
        assert_eq!(alone.masses.unwrap().whole_kg, point.whole_kg.unwrap());
        before = point.ring_diameter_m;
    }
    let list = |more: &str| order(&format!("--ratios=2.8; 1.5; 1{more}")).answer_gears(&GO_ON).unwrap();
    let all = list("|--front");
    let (front, mut before) = (all.front.unwrap(), all.gearboxes[0].ring_diameter_m.unwrap());
    assert!(!front.is_empty());
    for point in &front {
        let most = point.limits[0].greatest.unwrap();
        is_smaller(point.ring_diameter_m, most, before);
        let alone = list(&format!("|--max-ring={most}m"));
        assert_eq!(alone.masses.unwrap().whole_kg, point.whole_kg.unwrap());
        assert_eq!(alone.gearboxes[0].structure, point.structure);
        before = point.ring_diameter_m;
    }
}
