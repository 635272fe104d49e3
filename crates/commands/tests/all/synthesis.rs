//! Gearboxes of two and three speeds: `synthesize` and `select` find the same.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_commands::shared::profile_shift::WantedShifts;
use epicyclic_commands::synthesize::answer::teeth::TeethWanted;
use epicyclic_commands::synthesize::answer::{Set, Solution, Wanted, answer, saved, solve};
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_formats::wanted_ratio::Wanted as Ratio;
use epicyclic_formats::{Document, WantedRatio};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::involute::family::Aim as ShiftAim;
use epicyclic_gears::involute::set::Limits as TeethLimits;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_schemes::RatioSeries;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_selection::{Limits, Requirements, Signs, Space, select};
use epicyclic_synthesis::Kind;
use epicyclic_synthesis::rank::Objective;
use epicyclic_synthesis::rules::Rules;
use epicyclic_synthesis::teeth::{Aim, Alike};
use std::collections::BTreeSet;
use std::ops::ControlFlow;

/// Ring-to-sun ratios of the sets of the schemes here.
const K: [f64; 2] = [2.3, 3.1];

fn gear(ratio: f64) -> WantedRatio {
    WantedRatio { wanted: Ratio::Around { ratio, within: None }, optional: false }
}

/// The braked gears of so many sets, without a clutch for the direct drive.
fn wanted(ratios: Vec<f64>, tolerance: f64) -> Wanted {
    let count = ratios.len();
    Wanted {
        gears: ratios.into_iter().map(gear).collect(),
        tolerance,
        kind: Kind::Core,
        sets: count..=count,
        elements: count..=count,
        engaged: 1..=1,
        links: 0..=usize::MAX,
        open: 0..=usize::MAX,
        k: 1.4..=4.5,
        double_planets: 0..=0,
        k_double: 1.6..=4.5,
        equal_k: 1,
        rules: Rules::default(),
        limits: epicyclic_synthesis::limits::Limits::default(),
        drawable: false,
        shares: None,
        usable: None,
        efficiency: MeshEfficiency::new(0.97).unwrap(),
        most: usize::MAX,
        all_gearboxes: true,
        also: None,
        order: vec![],
        objectives: Objective::ALL.to_vec(),
        teeth: None,
        explain: None,
    }
}

/// Ratios of a scheme's braked gears by the solver.
fn ratios(scheme: Scheme) -> Vec<f64> {
    let sets: Vec<_> = scheme.sets().into_iter().zip(K).collect();
    let gearbox =
        epicyclic_schemes::structures::gearbox(scheme.name(), &sets, MeshEfficiency::IDEAL, None).unwrap();
    gearbox.gears().iter().map(|gear| gearbox.analyze_gear(gear).unwrap().ratio().unwrap()).collect()
}

#[test]
fn every_scheme_of_the_document_is_found_from_its_ratios_and_named() {
    for scheme in Scheme::all() {
        let found = answer(&wanted(ratios(scheme), 0.001), &|_, _| ControlFlow::Continue(())).unwrap();
        let near = |of: &&Solution| {
            let mut k: Vec<f64> = of.sets.iter().map(|set| set.k).collect();
            k.sort_by(f64::total_cmp);
            k.iter().zip(K).all(|(found, built)| (found / built - 1.0).abs() < 0.01)
        };
        let named = found.solutions.iter().filter(|solution| solution.scheme == Some(scheme.name()));
        assert_eq!(named.filter(near).count(), 1, "{}", scheme.name());
    }
}

#[test]
fn select_with_all_structures_finds_the_same_gearboxes() {
    for wanted_ratios in [vec![1.465, 2.56], vec![2.5, -3.0], vec![3.94]] {
        let tolerance = 0.001;
        let requirements = Requirements {
            tolerance,
            signs: Signs::AsGiven,
            limits: Limits {
                ring_to_sun: 1.4..=4.5,
                efficiency: 0.0,
                link_speed: f64::INFINITY,
                planet_speed: f64::INFINITY,
                clutch_slip: f64::INFINITY,
                drawable: false,
                ..Limits::default()
            },
            ..Requirements::new(RatioSeries::of_braked_gears(&wanted_ratios).unwrap())
        };
        let selected = select(&requirements, &Space::All).unwrap();
        let found = answer(&wanted(wanted_ratios, tolerance), &|_, _| ControlFlow::Continue(())).unwrap();
        // The sets in any order with their k, T₁ and T₂ not told apart.
        let one = |sets: Vec<(String, f64)>| {
            let mut sets: Vec<String> = sets.into_iter().map(|(name, k)| format!("{name} {k:.1}")).collect();
            sets.sort();
            sets.join(" ")
        };
        let mut of_select = BTreeSet::new();
        for candidate in &selected.accepted {
            let sets = candidate.mechanism.sets().into_iter().zip(&candidate.k);
            let name = |roles: [epicyclic_schemes::structures::Role; 3]| {
                roles.map(|role| role.symbol().trim_end_matches(['1', '2'])).join("-")
            };
            of_select.insert(one(sets.map(|(set, k)| (name(set), *k)).collect()));
        }
        let link = |link: char| match link {
            '1' => "D",
            '2' => "B",
            _ => "T",
        };
        let name = |set: &Set| [set.sun, set.ring, set.carrier].map(link).join("-");
        let braked = found
            .solutions
            .iter()
            .filter(|found| found.shift_elements.iter().all(|element| element.is_brake));
        let of_synthesis: BTreeSet<String> =
            braked.map(|found| one(found.sets.iter().map(|set| (name(set), set.k)).collect())).collect();
        assert!(!of_select.is_empty());
        assert_eq!(of_select, of_synthesis);
    }
}

#[test]
fn the_structures_of_select_are_class_core_of_two_sets_and_four_links() {
    use epicyclic_schemes::structures::{Role, Structure as OfRoles};
    use epicyclic_synthesis::{Class, Structure, enumerate};
    // T₁ and T₂ are two names of one role: a structure with them exchanged is the same.
    let link = |role: Role| u8::try_from(role.index() + 1).unwrap();
    let of_roles: BTreeSet<Structure> = OfRoles::all()
        .iter()
        .map(|one| Structure::new(&one.sets().map(|set| set.map(link)), 4).unwrap())
        .collect();
    let all: BTreeSet<Structure> =
        enumerate::all(Class::new(Kind::Core, 2, 4).unwrap()).into_iter().collect();
    assert_eq!(of_roles.len(), 111);
    assert_eq!(of_roles, all);
}

/// The file of a solution has the shifts of its sets: on the listed centre distance, without backlash and
/// without a fault.
#[test]
fn a_file_with_profile_shift_is_read_back() {
    let bounds = Bounds { sun: 17..=30, ring: 50..=80, ..Bounds::default() };
    let shifts = WantedShifts { offsets: 1..=2, aim: ShiftAim::BalancedSliding, tip_thickness: 0.3 };
    let teeth =
        TeethWanted { bounds, shifts: Some(shifts), alike: Alike::default(), aim: Aim::Deviation, most: 1 };
    let wanted = Wanted { teeth: Some(teeth), ..wanted(vec![2.56, 1.465], 0.02) };
    let (found, kept) = solve(&wanted, &|_, _| ControlFlow::Continue(())).unwrap();
    let mut read = 0;
    for (solution, kept) in found.solutions.iter().zip(&kept).filter(|(_, kept)| !kept.teeth.is_empty()) {
        let gearbox = saved::gearbox(kept, "saved", kept.teeth.first()).unwrap();
        let text = saved::file(&gearbox, &[]).unwrap();
        let file: GearboxFile = Document::parse_one("saved.yaml", text.as_bytes()).unwrap().read().unwrap();
        let again = file.gearbox().unwrap();
        let told = &solution.teeth.as_ref().unwrap().choices[0].sets;
        for (set, told) in again.sets().iter().zip(told) {
            let shifts = told.shifts.unwrap();
            assert!((1..=2).contains(&shifts.ring_offset));
            let set = set.short().unwrap().involute_set(&BasicRack::default()).unwrap().unwrap();
            assert!((set.centre_distance() - shifts.centre_distance_in_modules).abs() < 1e-9);
            assert!(set.ring_mesh().backlash().abs() < 1e-9);
            let limits = TeethLimits { tip_thickness: 0.3, ..TeethLimits::default() };
            assert_eq!(set.faults(&limits), vec![]);
            read += 1;
        }
    }
    assert!(read > 1, "{read}");
}

#[test]
fn a_file_with_the_teeth_of_a_double_planet_set_is_read_back() {
    let bounds = Bounds { ring: 60..=90, ..Bounds::default() };
    let teeth = TeethWanted { bounds, shifts: None, alike: Alike::default(), aim: Aim::Deviation, most: 1 };
    let wanted = Wanted { double_planets: 1..=1, teeth: Some(teeth), ..wanted(vec![2.56, 1.465], 0.01) };
    let (found, kept) = solve(&wanted, &|_, _| ControlFlow::Continue(())).unwrap();
    let with_teeth = found.solutions.iter().zip(&kept).filter(|(_, kept)| !kept.teeth.is_empty());
    let mut read = 0;
    for (solution, kept) in with_teeth {
        let gearbox = saved::gearbox(kept, "saved", kept.teeth.first()).unwrap();
        let text = saved::file(&gearbox, &[]).unwrap();
        let file: GearboxFile = Document::parse_one("saved.yaml", text.as_bytes()).unwrap().read().unwrap();
        let again = file.gearbox().unwrap();
        assert!(again.sets().iter().zip(gearbox.sets()).all(|(one, other)| one.kind() == other.kind()));
        let told = &solution.teeth.as_ref().unwrap().choices[0];
        let mut fastest: f64 = 0.0;
        for (gear, ratio) in again.gears().iter().zip(&told.ratios) {
            let analysis = again.analyze_gear(gear).unwrap();
            let exact = analysis.exact_ratio().unwrap();
            assert_eq!((*exact.numer(), *exact.denom()), (ratio.numerator, ratio.denominator));
            let planets = analysis.sets().iter().flat_map(|set| &set.planets);
            fastest = planets.fold(fastest, |all, planet| all.max(planet.unwrap().relative.abs()));
        }
        assert!((told.greatest_planet_speed / fastest - 1.0).abs() < 1e-12, "{fastest}");
        for (set, teeth) in solution.sets.iter().zip(&told.sets) {
            assert_eq!(set.is_double_planet, teeth.outer_planet.is_some());
        }
        read += 1;
    }
    assert!(read > 5, "{read}");
}
