//! Ratios as formulas: known ones, and those of random gearboxes against the solver, also at other numbers of
//! teeth.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::machines::{eight_speed, power_split, ravigneaux_set, simpson, wind};
use common::oracle::{BoxPlan, Dice};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::compound::CompoundSpec;
use epicyclic_train::formula::steps::{Condition, Factor, Steps};
use epicyclic_train::formula::symbol::Symbol;
use epicyclic_train::formula::{Formula, NoFormula};
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_train::{Gearbox, State};

fn formulas(gearbox: &Gearbox) -> Vec<(&str, String)> {
    let text = |gear: &str| match Formula::new(&gearbox.analyze(gear).unwrap()) {
        Ok(formula) => formula.text(),
        Err(why) => why.to_string(),
    };
    gearbox.gears().iter().map(|gear| (gear.name(), text(gear.name()))).collect()
}

fn check(gearbox: &Gearbox, wanted: &[(&str, &str)]) {
    let found = formulas(gearbox);
    let found: Vec<(&str, &str)> = found.iter().map(|(gear, text)| (*gear, text.as_str())).collect();
    assert_eq!(found, wanted);
    for gear in gearbox.gears() {
        let found = gearbox.analyze_gear(gear).unwrap();
        if let Ok(formula) = Formula::new(&found) {
            assert_eq!(formula.exact_value(), found.exact_ratio(), "{}", gear.name());
        }
    }
}

#[test]
fn an_eight_speed_gearbox_has_formulas_of_four_sets() {
    check(
        &eight_speed().gearbox,
        &[
            ("1", "1 + k₄"),
            ("2", "k₂·(1 + k₄)/(1 + k₂)"),
            ("3", "(1 + k₁)·(1 + k₄)/(1 + k₁ + k₄)"),
            ("4", "(1 + k₁ + k₂)/(1 + k₂)"),
            ("5", "(1 + k₁ + k₄ + k₁·k₄ + k₂·k₄ + k₂·k₃·k₄)/(1 + k₁ + k₄ + k₂·k₄ + k₂·k₃·k₄)"),
            ("6", "1"),
            ("7", "k₂·(1 + k₃)/(1 + k₂ + k₂·k₃)"),
            ("8", "k₂/(1 + k₂)"),
            ("R", "k₂·(1 − k₃·k₄)/(1 + k₂)"),
        ],
    );
}

#[test]
fn a_simpson_set_has_formulas_of_two_sets() {
    let wanted = [("1", "(1 + k₁ + k₂)/k₁"), ("2", "(1 + k₁)/k₁"), ("3", "1"), ("R", "−k₂")];
    check(&simpson().gearbox, &wanted);
}

/// Small sun: `+k₁` to the ring; large sun: `−k₂`.
#[test]
fn a_ravigneaux_set_has_a_symbol_for_each_sun() {
    let gearbox = ravigneaux_set([1.0; 4]).build().unwrap();
    let wanted = [("1", "k₁"), ("2", "(k₁ + k₂)/(1 + k₂)"), ("3", "1"), ("4", "k₂/(1 + k₂)"), ("R", "−k₂")];
    check(&gearbox, &wanted);
    let second = gearbox.analyze("2").unwrap();
    let formula = Formula::new(&second).unwrap();
    let told: Vec<(String, bool, Vec<String>)> = formula
        .symbols()
        .iter()
        .map(|symbol| {
            let set = &gearbox.sets()[symbol.set()];
            let gears =
                symbol.teeth().map(|gears| gears.iter().map(|gear| set.gear_name(*gear)).collect::<Vec<_>>());
            (symbol.name(), symbol.is_negative(), gears.concat())
        })
        .collect();
    let teeth = |sun: &str| vec!["ring".to_owned(), format!("sun {sun}")];
    assert_eq!(told, [("k₁".into(), false, teeth("Ss")), ("k₂".into(), true, teeth("Sl"))]);
    assert!((formula.symbols()[0].value() - 72.0 / 30.0).abs() < 1e-15);
}

fn wolfrom() -> Gearbox {
    let eta = MeshEfficiency::IDEAL;
    let set = CompoundSpec::new("set", "arm")
        .sun("sun", 32)
        .ring("ground", 100)
        .ring("drum", 96)
        .planet("p", &[34, 30])
        .mesh("sun", "p.1", eta)
        .mesh("p.1", "ground", eta)
        .mesh("p.2", "drum", eta);
    let links = Gearbox::builder("51 to 1").links(["sun", "arm", "drum"]).compound_set(set);
    links.input("sun").output("drum").gear("only", [""; 0]).build().unwrap()
}

/// `k₁ = z_b1/z_a`, `k₂ = z_g1·z_b2/(z_a·z_g2)`, and `51 = 3.4·(1 + 3.125)/(3.4 − 3.125)`.
#[test]
fn a_wolfrom_set_has_a_stepped_symbol() {
    let gearbox = wolfrom();
    check(&gearbox, &[("only", "(1 + k₁)·k₂/(k₂ − k₁)")]);
    let only = gearbox.analyze("only").unwrap();
    let formula = Formula::new(&only).unwrap();
    let values: Vec<String> =
        formula.symbols().iter().map(|symbol| symbol.exact().unwrap().to_string()).collect();
    assert_eq!(values, ["25/8", "17/5"]);
    assert_eq!(formula.exact_value().unwrap().to_string(), "51");
    let set = &gearbox.sets()[0];
    let [above, below] = formula.symbols()[1]
        .teeth()
        .map(|gears| gears.iter().map(|gear| set.teeth(*gear).unwrap().get()).product::<u32>());
    assert_eq!([above, below], [34 * 96, 32 * 30]);
}

#[test]
fn pairs_have_gear_ratios() {
    let wanted = [
        ("MG1 locked", "k₁/(1 + k₁)"),
        ("EV", "−k₁"),
        ("MG2", "−k₂"),
        ("final drive", "u₃·u₄"),
        ("all tied", "1"),
    ];
    check(&power_split().gearbox, &wanted);
    check(&wind().gearbox, &[("overall", "u₂·u₃/(1 + k₁)"), ("planetary stage", "1/(1 + k₁)")]);
}

#[test]
fn a_double_planet_set_has_its_k_with_the_other_sign() {
    let double = SetSpec::new("P", SetKind::DoublePlanet, ["a", "b", "H"], 2.5);
    let builder = Gearbox::builder("double").links(["a", "b", "H"]).set(double).input("a").output("H");
    let gearbox = builder.brake("K", "b").gear("1", ["K"]).gear("free", [""; 0]).build().unwrap();
    let found = formulas(&gearbox);
    assert_eq!(found[0].1, "1 − k₁");
    assert_eq!(found[1].1, "the gear has no ratio: underdetermined (b, H)");
}

#[test]
fn what_does_not_matter_does_not_occur() {
    // Set 2 turns along, set 3 is a block, set 4 has nothing to do with the rest.
    let set = |id: &str, members: [&str; 3]| SetSpec::simple(id, members, 3.0);
    let gearbox = Gearbox::builder("idle")
        .links(["D", "B", "T", "x", "y", "v", "z", "u"])
        .set(set("1", ["D", "T", "B"]))
        .set(set("2", ["D", "x", "B"]))
        .set(set("3", ["D", "y", "v"]))
        .set(set("4", ["z", "u", "ground"]))
        .brake("K", "T")
        .clutch("L", "D", "v")
        .input("D")
        .output("B")
        .gear("1", ["K", "L"])
        .build()
        .unwrap();
    let found = gearbox.analyze("1").unwrap();
    let formula = Formula::new(&found).unwrap();
    assert_eq!(formula.text(), "1 + k₁");
    assert_eq!(formula.symbols().len(), 1);
    assert_eq!(formula.occurring().collect::<Vec<_>>(), [0]);
    assert!(formula.spare().is_empty());
}

#[test]
fn sets_that_repeat_others_are_told() {
    let set = |id: &str| SetSpec::simple(id, ["D", "T", "B"], 3.0);
    let builder = Gearbox::builder("twice").links(["D", "B", "T"]).set(set("1")).set(set("2"));
    let gearbox = builder.brake("K", "T").input("D").output("B").gear("1", ["K"]).build().unwrap();
    let found = gearbox.analyze("1").unwrap();
    let formula = Formula::new(&found).unwrap();
    assert_eq!(formula.symbols().len(), 1);
    assert_eq!(formula.spare().len(), 1);
    assert!((formula.value() - 4.0).abs() < 1e-15);
}

/// Two sets with ring and carrier in common and nothing to hold them: equal, their suns turn alike.
#[test]
fn a_ratio_that_exists_with_special_numbers_alone_has_no_formula() {
    let gearbox = |second: f64| {
        let builder = Gearbox::builder("special").links(["D", "B", "c", "m"]);
        let builder = builder.set(SetSpec::simple("1", ["D", "c", "m"], 3.0));
        let builder = builder.set(SetSpec::simple("2", ["B", "c", "m"], second));
        builder.input("D").output("B").gear("1", [""; 0]).build().unwrap()
    };
    let equal = gearbox(3.0);
    let found = equal.analyze("1").unwrap();
    assert!((found.ratio().unwrap() - 1.0).abs() < 1e-12);
    assert_eq!(Formula::new(&found).unwrap_err(), NoFormula::TheseNumbersAlone);
    let other = gearbox(3.5);
    assert!(matches!(Formula::new(&other.analyze("1").unwrap()), Err(NoFormula::NoRatio(_))));
}

/// Sets in a row, each with its ring held.
fn chain(sets: usize) -> Gearbox {
    let name = |place: usize| format!("n{place}");
    let mut builder = Gearbox::builder("chain").links((0..=sets).map(name));
    for place in 0..sets {
        let id = format!("{}", place + 1);
        builder = builder.set(SetSpec::simple(&id, [&name(place), "ground", &name(place + 1)], 3.0));
    }
    builder.input("n0").output(&name(sets)).gear("1", [""; 0]).build().unwrap()
}

#[test]
fn a_formula_takes_twelve_symbols() {
    let twelve = chain(12);
    let found = twelve.analyze("1").unwrap();
    let formula = Formula::new(&found).unwrap();
    assert!(formula.text().ends_with("·(1 + k₁₂)"), "{}", formula.text());
    assert!((formula.value() / 4_f64.powi(12) - 1.0).abs() < 1e-12);
    let thirteen = chain(13);
    let found = thirteen.analyze("1").unwrap();
    assert_eq!(Formula::new(&found).unwrap_err(), NoFormula::TooLarge { symbols: 13, most: 12 });
}

#[test]
fn the_steps_of_a_gear_solve_one_equation_after_the_other() {
    let gearbox = eight_speed().gearbox;
    let second = gearbox.analyze("2").unwrap();
    let formula = Formula::new(&second).unwrap();
    let steps = Steps::new(&gearbox, second.gear(), &formula);
    let names: Vec<String> = formula.symbols().iter().map(Symbol::name).collect();
    assert_eq!(names, ["k₂", "k₄"]);
    // Sun and ring of set 1 rest, and its carrier with them. That set 3 is a block matters to nothing.
    let link = |name: &str| gearbox.link(name).unwrap();
    let at_rest = Condition::Set { set: 0, links: [link("C1R4"), link("S1S2")], is_block: true };
    let engaged = [0, 1, 4].map(Condition::Engaged);
    assert_eq!(steps.conditions, [&engaged[..], &[at_rest]].concat());
    let [first, last] = &steps.substitutions[..] else { panic!("{steps:?}") };
    assert_eq!(gearbox.link_name(first.unknown), "R2S3");
    assert_eq!(first.equals.len(), 1);
    assert_eq!(last.unknown, second.gear().output());
    let [(link, Factor::Exact(share))] = last.equals[..] else { panic!("{last:?}") };
    assert_eq!(link, second.gear().input());
    assert_eq!(share.recip(), second.exact_ratio().unwrap());
}

/// The last substitution of a gear gives its output over its input.
fn last_share(steps: &Steps) -> Option<f64> {
    match &steps.substitutions.last()?.equals[..] {
        [(_, share)] => Some(share.value()),
        _ => None,
    }
}

/// Returns the gearbox with other teeth on every gear.
fn other_teeth(plan: &BoxPlan, dice: &mut Dice) -> BoxPlan {
    let mut plan = plan.clone();
    for set in &mut plan.sets {
        for central in set.centrals.iter_mut().filter(|central| central.teeth > 0) {
            central.teeth += dice.between(1, 9);
        }
        set.planets.iter_mut().flatten().for_each(|teeth| *teeth += dice.between(0, 5));
    }
    plan
}

/// The formula of a gear is that of the structure: with other teeth it gives the other ratio.
#[test]
fn formulas_of_random_gearboxes_give_the_ratios_of_the_solver() {
    let mut dice = Dice(0xf0_0d);
    let (mut own, mut others, mut ones, mut largest, mut several) = (0, 0, 0, 0, 0);
    for round in 0..8000 {
        let plan = BoxPlan::random(5, 50, &mut dice);
        let other = other_teeth(&plan, &mut dice);
        let Ok(gearbox) = plan.build(None) else { continue };
        let found = gearbox.analyze("g").unwrap();
        let formula = match (Formula::new(&found), found.ratio()) {
            (Ok(formula), Some(_)) => formula,
            (Err(NoFormula::NoRatio(_) | NoFormula::TooLarge { .. }), None) => continue,
            (Err(NoFormula::TooLarge { .. }), Some(_)) => continue,
            (formula, ratio) => panic!("{round}: {formula:?} {ratio:?}"),
        };
        own += 1;
        largest = largest.max(formula.symbols().len());
        let ratio = found.ratio().unwrap();
        assert!((formula.value() / ratio - 1.0).abs() < 1e-9, "{round}: {} {ratio}", formula.value());
        if let (Some(one), Some(other)) = (formula.exact_value(), found.exact_ratio()) {
            assert_eq!(one, other, "{round}");
        }
        let steps = Steps::new(&gearbox, found.gear(), &formula);
        if let Some(share) = last_share(&steps) {
            assert!((share * ratio - 1.0).abs() < 1e-9, "{round}: {steps:?} {ratio}");
            several += usize::from(steps.substitutions.len() > 1);
        } else {
            assert!(formula.symbols().is_empty(), "{round}: {steps:?}");
        }
        let Ok(other) = other.build(None) else { continue };
        let other = other.analyze("g").unwrap();
        let (Ok(same), Some(ratio), State::Driven) =
            (Formula::new(&other), other.ratio(), found.kinematic_state())
        else {
            continue;
        };
        // A basic ratio that is exactly 1, of these teeth or of those, has no symbol.
        if formula.symbols().len() != same.symbols().len() {
            ones += 1;
            continue;
        }
        let value = formula.ratio().value(&|symbol| same.symbols()[symbol].value());
        assert!((value / ratio - 1.0).abs() < 1e-9, "{round}: {value} {ratio}");
        assert_eq!(formula.text(), same.text(), "{round}");
        others += 1;
    }
    assert!(
        own > 2500 && others > 2000 && largest > 6 && several > 1200,
        "{own} {others} {largest} {several}"
    );
    assert!(ones < 20, "{ones}");
}
