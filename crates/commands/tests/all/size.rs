//! Sizes found for a file, and the file written with them.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_commands::analyze::answer as analyze;
use epicyclic_commands::answer::to_json;
use epicyclic_commands::failure::Failure;
use epicyclic_commands::shared::gearbox::Gearbox;
use epicyclic_commands::shared::lists::List;
use epicyclic_commands::size::answer::records::HeldKey;
use epicyclic_commands::size::{self, Request, Size};
use epicyclic_commands::strength;
use epicyclic_commands::strength::answer::records::Reason;
use epicyclic_commands::words::request;
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_strength::sizing::{Objective, Requirement};

/// Two speeds and direct drive of two simple sets, and a double-planet set that nothing drives through.
const BOX: &str = "\
gearbox: hoist
input: motor
output: drum
sets:
  - { id: A, sun: motor, ring: R, carrier: drum, teeth: [24, 84], strength: HARD }
  - { id: B, sun: motor, ring: S, carrier: R, teeth: [30, 81], planet_teeth: [25], strength: HARD }
  - { id: C, kind: double_planet, sun: motor, ring: drum, carrier: T, teeth: [30, 72] }
oil: { viscosity: 220 mm²/s }
life: 3000 h
required: { flank: 1.1, root: 1.4 }
duty:
  - { gear: low, share: 30 %, torque: 90 N·m, speed: 1450 rpm }
  - { gear: high, share: 50 %, torque: 60 N·m, speed: 1450 rpm }
  - { gear: high, share: 20 %, torque: 0 N·m, speed: 1450 rpm }
brakes: [{ id: K1, link: R }, { id: K2, link: S }]
gears: [{ name: low, engaged: [K1] }, { name: high, engaged: [K2] }]
";

const HARD: &str = "{ materials: [18CrNiMo7-6, 18CrNiMo7-6, 34CrNiMo6], flank_roughness: [4 µm, 4 µm, 6 µm], \
    root_roughness: [16 µm, 16 µm, 20 µm], shaper: { teeth: 30 }, ring_factors: { Y_delta_rel_T_stat: 1 }, \
    factors: { K_A: 1.25, K_v: 1.05, K_H_beta: 1.2, K_H_alpha: 1, K_F_alpha: 1 } }";

fn hoist() -> String {
    BOX.replace("HARD", HARD)
}

/// A small space.
fn small() -> Request {
    let words = "--modules=2mm, 2.5mm, 3mm, 4mm, 5mm|--face-widths=20mm, 30mm, 40mm, 50mm, 60mm|--planets=3..4|\
                 --centre-distance-step=1mm|--planet-rim=2";
    request(words.split('|')).unwrap()
}

fn read(text: &str) -> Document {
    Document::parse_one("box.yaml", text.as_bytes()).unwrap()
}

fn gearbox(text: &str) -> Gearbox {
    Gearbox::parse("box.yaml", text.as_bytes()).unwrap()
}

fn sized(text: &str, request: &Request) -> Result<Size, Failure> {
    let gearbox = Gearbox::parse("box.yaml", text.as_bytes())?;
    request.answer(&gearbox, &|| std::ops::ControlFlow::Continue(()))
}

/// Every safety over the duty of a file, and its mass of planets' bores.
fn safeties(text: &str) -> Vec<[f64; 2]> {
    let subject = gearbox(text);
    let told = strength::Request::default().answer(&subject).unwrap();
    told.over_duty
        .iter()
        .map(|one| [one.flank.as_ref().unwrap().safety, one.root.as_ref().unwrap().safety])
        .collect()
}

#[test]
fn the_saved_file_has_the_safeties_that_were_found() {
    for minimise in [Objective::Mass, Objective::Ring, Objective::Whole] {
        let size = sized(&hoist(), &Request { minimise: Some(minimise), ..small() }).unwrap();
        assert_eq!(size.sets.len(), 2);
        assert_eq!((size.not_sized[0].set.as_str(), size.not_sized[0].reason), ("C", Reason::KeysMissing));
        let text = size::saved(&read(&hoist()), &size).unwrap();
        let found: Vec<[f64; 2]> = size
            .sets
            .iter()
            .flat_map(|set| &set.found[0].over_duty)
            .map(|one| [one.flank.safety, one.root.safety])
            .collect();
        let told = safeties(&text);
        assert_eq!(told.len(), 8);
        for (one, other) in found.iter().flatten().zip(told.iter().flatten()) {
            assert!((one / other - 1.0).abs() < 1e-9, "{found:?} {told:?}");
        }
        assert!(told.iter().all(|[flank, root]| *flank >= 1.1 && *root >= 1.4));
        // The file is whole: gears, duty, and the sets that have no size.
        let subject = gearbox(&text);
        let gear = |name: &str| analyze::analysis(&subject.train, name).unwrap().ratio().unwrap();
        assert!((gear("low") - 4.5).abs() < 1e-12 && gear("high") > 1.0);
        assert!(text.contains("# Set A: bearing 6") && text.contains("load_rating"), "{text}");
        to_json(&size).unwrap();
    }
}

/// In low set A alone carries: it gets heavier, and its saved file has the static safeties that were found.
#[test]
fn the_sizes_hold_against_the_overloads_of_the_file() {
    let overload = "overload: [{ gear: low, torque: 800 N·m, required: { flank: 1.1, root: 1.5 } }]\n";
    let [plain, text] = [hoist(), hoist() + overload];
    let [without, size] = [&plain, &text].map(|text| sized(text, &small()).unwrap());
    let [light, heavy] = [&without.sets[0], &size.sets[0]];
    assert!(heavy.found[0].mass_kg > light.found[0].mass_kg && heavy.left_out.overload > 0);
    assert_eq!(light.found[0].overload, None);
    let saved = size::saved(&read(&text), &size).unwrap();
    let subject = gearbox(&saved);
    let told = strength::Request::default().answer(&subject).unwrap();
    for set in size.sets.iter().filter(|set| set.found[0].overload.is_some()) {
        let own = told.overload.iter().filter(|one| one.set == set.set);
        let least = own.flat_map(|one| {
            [one.flank_safety.unwrap() / one.required.flank, one.root_safety.unwrap() / one.required.root]
        });
        let found = set.found[0].overload.as_ref().unwrap();
        let least = least.fold(f64::INFINITY, f64::min);
        assert!(
            least >= 1.0 && (found.value / found.required / least - 1.0).abs() < 1e-9,
            "{least} {found:?}"
        );
    }
    let loaded: Vec<&str> = told.overload.iter().map(|one| one.set.as_str()).collect();
    assert_eq!(loaded, ["A"; 4]);
    let weak = sized(&text.replace("800 N·m", "80 N·m"), &small()).unwrap();
    let warned = weak.warnings.iter().find(|one| one.name == "overload-below-duty").unwrap();
    assert!(warned.message.ends_with("write 90 N·m or more"), "{}", warned.message);
    let out_of_reach = sized(&text.replace("800 N·m", "80 kN·m"), &small()).unwrap();
    let [miss] = &out_of_reach.warnings[..] else { panic!("{:?}", out_of_reach.warnings) };
    assert!(miss.message.contains("against the overload"), "{}", miss.message);
    assert!(out_of_reach.sets[0].nearest_miss.as_ref().unwrap().governing.requirement.is_against_overload());
    let wrong = sized(&text.replace("low, torque: 800", "crawl, torque: 800"), &small()).unwrap_err();
    assert!(wrong.to_string().contains("crawl"), "{wrong}");
}

/// The bearings too: what differs is the planets' mass, by the density of the material or of the file.
#[test]
fn the_saved_file_has_the_bearing_lives_that_were_found() {
    let size = sized(&hoist(), &small()).unwrap();
    let text = size::saved(&read(&hoist()), &size).unwrap();
    let subject = gearbox(&text);
    let told = strength::Request::default().answer(&subject).unwrap();
    assert_eq!(told.bearings.len(), 2);
    for (bearing, set) in told.bearings.iter().zip(&size.sets) {
        let found = set.found[0].planet_sizes[0].bearing.as_ref().unwrap().life_s.unwrap();
        assert!((bearing.basic_life_s.unwrap() / found - 1.0).abs() < 2e-3, "{bearing:?} {found}");
        assert!(bearing.modified.is_none() && bearing.missing.is_empty());
    }
}

/// Deviations belong to gears of one size: they do not replace factors if sizes are searched.
#[test]
fn with_an_accuracy_the_factors_are_asked_for() {
    let factors = "{ K_A: 1.25, K_v: 1.05, K_H_beta: 1.2, K_H_alpha: 1, K_F_alpha: 1 }";
    let accuracy = "{ K_A: 1.25, K_H_beta: 1.2 }, accuracy: { pitch_deviations: [6 µm, 6 µm, 8 µm], profile_deviations: [6 µm, 6 µm, 8 µm] }";
    let error = sized(&hoist().replace(factors, accuracy), &small()).unwrap_err();
    let error = error.to_string();
    let keys = "`strength.factors.K_v`, `strength.factors.K_H_alpha`, `strength.factors.K_F_alpha`";
    let missing =
        format!("missing: {keys} of set `A`; {keys} of set `B`; `planet_teeth`, `strength` of set `C`. ");
    assert!(error.contains(&missing), "{error}");
}

#[test]
fn counts_add_up_and_designs_are_in_order() {
    let size = sized(&hoist(), &small()).unwrap();
    for set in &size.sets {
        let out = set.left_out;
        let left_out = out.spacing
            + out.planets_touch
            + out.geometry
            + out.practice
            + out.width_ratio
            + out.rim
            + out.bearing_width
            + out.not_calculable
            + out.flank
            + out.root
            + out.overload
            + out.bearing_life;
        assert_eq!(left_out + set.not_reached + set.found.len() as u64, set.designs);
        let ranks: Vec<(bool, f64)> =
            set.found.iter().map(|one| (one.rules_missed > 0, one.mass_kg)).collect();
        assert!(ranks.is_sorted(), "{ranks:?}");
        assert!(set.found.iter().all(|design| design.governing.value >= design.governing.required));
    }
    let best: f64 = size.sets.iter().map(|set| set.found[0].mass_kg).sum();
    assert!((size.mass_kg.unwrap() - best).abs() < 1e-12);
    // A set is sized as it would be alone: the other one's size changes nothing.
    let other = hoist().replace("id: B, sun: motor", "id: B, module: 5 mm, face_width: 60 mm, sun: motor");
    let held = sized(&other, &small()).unwrap();
    assert_eq!(held.sets[0], size.sets[0]);
    assert_eq!(held.sets[1].held, [HeldKey::Module, HeldKey::FaceWidth]);
    let families = held.sets[1].found.iter().flat_map(|design| &design.families);
    assert!(families.into_iter().all(|of| of.module_m == 0.005 && of.face_width_m == 0.06));
}

#[test]
fn what_the_file_gives_is_held() {
    let keys =
        "planets: 3, planet_bore: 40 mm, load_rating: 60 kN, bearing_rolling: rollers, sun: motor, ring: R";
    let size = sized(&hoist().replace("sun: motor, ring: R", keys), &small()).unwrap();
    assert_eq!(size.sets[0].held, [HeldKey::Planets, HeldKey::LoadRating, HeldKey::PlanetBore]);
    let bearing = size.sets[0].found[0].planet_sizes[0].bearing.as_ref().unwrap();
    assert_eq!((bearing.designation.as_ref(), bearing.outside_diameter_m), (None, Some(0.04)));
    let solid = sized(&hoist(), &Request { no_bearings: true, ..small() }).unwrap();
    let planet = &solid.sets[0].found[0].planet_sizes[0];
    assert_eq!((planet.bearing.as_ref(), planet.rim_m), (None, None));
}

#[test]
fn a_set_without_a_size_has_a_nearest_miss_and_is_not_saved() {
    let size = sized(&hoist().replace("root: 1.4", "root: 1400"), &small()).unwrap();
    let miss = size.sets[0].nearest_miss.as_ref().unwrap();
    assert_eq!(miss.governing.requirement, Requirement::Root);
    assert_eq!((size.mass_kg, size.warnings.len()), (None, 2));
    assert!(size.warnings[0].message.starts_with("set A: the nearest misses S_F = "));
    let error = size::saved(&read(&hoist()), &size).unwrap_err();
    assert!(error.is_nothing_found());
    assert_eq!(error.to_string(), "set A has no size that meets the requirements");
}

#[test]
fn a_search_of_nothing_and_files_without_a_duty_are_refused() {
    let of = |text: &str, request: &Request| sized(text, request).unwrap_err().to_string();
    let with = |change: &dyn Fn(&mut Request)| {
        let mut request = small();
        change(&mut request);
        of(&hoist(), &request)
    };
    assert_eq!(
        with(&|of| of.modules = Some(List(vec![]))),
        "--modules: no module to search; at least one is needed"
    );
    assert!(
        with(&|of| of.face_widths = Some("0 mm".parse().unwrap()))
            .starts_with("--face-widths: face width is 0 mm")
    );
    assert!(
        with(&|of| of.planet_rim = "-1".parse().ok())
            .starts_with("--planet-rim: least rim of the planets is -1 modules")
    );
    assert!(with(&|of| of.tip_thickness = "-1".parse().unwrap()).contains("tip"));
    let text = hoist();
    let [from, to] = ["duty:", "brakes:"].map(|key| text.find(key).unwrap());
    let no_duty = format!("{}{}", &text[..from], &text[to..]);
    assert!(of(&no_duty, &small()).contains("missing: `duty`"), "{}", of(&no_duty, &small()));
    let wrong = hoist().replace("id: A, sun", "id: A, module: -1 mm, sun");
    assert!(of(&wrong, &small()).contains("module is -1 mm"), "{}", of(&wrong, &small()));
    let none = hoist().replace("shaper: { teeth: 30 },", "");
    let missing = "missing: `strength.shaper` of set `A`; `strength.shaper` of set `B`; `planet_teeth`, `strength` of set `C`. ";
    assert!(of(&none, &small()).contains(missing), "{}", of(&none, &small()));
}

/// The search follows stated limits as the judgement of what it finds does, and the saved file keeps them.
#[test]
fn sizes_follow_the_limits_of_the_file() {
    let only = Request { most: 1, ..small() };
    let found = |limits: &str| {
        let text = hoist() + limits;
        let size = sized(&text, &only).unwrap();
        let widths: Vec<_> =
            size.judgement.checks.iter().filter(|check| check.name == "face-width").cloned().collect();
        assert!(!widths.is_empty());
        (text, size, widths)
    };
    let (_, usual, widths) = found("");
    assert!(widths.iter().all(|check| check.value.unwrap() < 0.6), "{widths:?}");
    // A range without the widths found before: the search takes others, which hold.
    let wide = "limits: { face-width: 0.6.. }\n";
    let (text, size, widths) = found(wide);
    assert!(widths.iter().all(|check| check.holds && check.source == "what is stated"), "{widths:?}");
    assert_ne!(size.sets[0].found[0].mass_kg, usual.sets[0].found[0].mass_kg);
    let limits = |text: &str| read(text).read::<GearboxFile>().unwrap().limits();
    assert_eq!(limits(&size::saved(&read(&text), &size).unwrap()), limits(&text));
    // A range that no size keeps leaves none.
    let none = sized(&(hoist() + "limits: { face-width: ..0.01 }\n"), &only).unwrap();
    assert!(none.sets.iter().all(|set| set.found.is_empty() && set.left_out.practice > 0), "{none:?}");
    assert!(none.warnings[0].message.contains("`face-width` of `limits` in the file leaves out"), "{none:?}");
    // A bearing outside a range is named as well as gears are.
    let slow = sized(&(hoist() + "limits: { pin-speed: ..10 }\n"), &only).unwrap();
    assert!(slow.warnings[0].message.contains("`pin-speed` of `limits` in the file leaves out"), "{slow:?}");
    // Rims that are made are at least the stated ones, unless an option says otherwise.
    let rims = |request: &Request| {
        let size = sized(&(hoist() + "limits: { ring-rim: 4.., planet-rim: 3.2.. }\n"), request).unwrap();
        [size.sought.planet_rim_in_modules, size.sought.ring_rim_in_modules]
    };
    assert_eq!(rims(&Request { planet_rim: None, ..only.clone() }), [3.2, 4.0]);
    assert_eq!(rims(&Request { ring_rim: "3.7".parse().ok(), ..only.clone() }), [2.0, 3.7]);
}

/// An oil without viscosity at work is refused with its place, by sizes as by strength.
#[test]
fn a_viscosity_at_work_is_above_0() {
    let file = hoist().replace("viscosity: 220 mm²/s", "viscosity: 220 mm²/s, working_viscosity: 0 mm²/s");
    let refused = sized(&file, &small()).unwrap_err().to_string();
    assert!(refused.contains("oil.working_viscosity: working_viscosity must be above 0"), "{refused}");
}
