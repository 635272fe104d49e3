//! Five transmissions in service: every published ratio, and what else must hold in every gear.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::machines::{self, Machine};
use common::plain;
use epicyclic_gears::ToothCount;
use epicyclic_gears::simple_set::Fraction;
use epicyclic_train::planet_set::Description;
use epicyclic_train::set::{MeshLoss, SetKind};
use epicyclic_train::{Analysis, CompiledGear, Direction, Gearbox, Solution, State, Warning};

#[test]
fn every_gear_has_its_published_ratio() {
    for Machine { gearbox, gears } in machines::all() {
        for published in gears {
            let found = gearbox.analyze(published.gear).unwrap();
            assert_eq!(*found.state(), State::Driven, "{} {}", gearbox.name(), published.gear);
            let ratio = found.ratio().unwrap();
            let exact = found.exact_ratio().unwrap();
            assert!((ratio - *exact.numer() as f64 / *exact.denom() as f64).abs() < 1e-14 * ratio.abs());
            let shown = if published.inverted { 1.0 / ratio } else { ratio };
            let printed: f64 = published.ratio.parse().unwrap();
            let unit = 0.1_f64.powi(published.ratio.split('.').nth(1).map_or(0, str::len) as i32);
            let off = shown.abs() - printed.abs();
            let fits = if published.truncated { (0.0..unit).contains(&off) } else { off.abs() <= unit / 2.0 };
            assert!(fits && shown * printed > 0.0, "{} {}: {shown}", gearbox.name(), published.gear);
        }
    }
}

#[test]
fn ratios_are_exact_fractions() {
    let eight = machines::eight_speed().gearbox;
    let exact = |gear| eight.analyze(gear).unwrap().exact_ratio().unwrap();
    assert_eq!(exact("1"), Fraction::new(33, 7));
    assert_eq!(exact("6"), Fraction::from_integer(1));
    assert_eq!(exact("8"), Fraction::new(2, 3));
}

fn balances(found: &Analysis<'_>) {
    let cases = [found.ideal(), found.driving(), found.back_driving()];
    for case in cases.into_iter().flatten() {
        let largest = case.power.largest;
        let losses: f64 = case.power.sets.iter().map(|set| set.as_ref().unwrap().loss).sum();
        assert!(losses > -1e-12 * largest);
        assert!((losses - (1.0 - case.efficiency)).abs() < 1e-12 * largest, "{losses} {}", case.efficiency);
        for set in case.power.sets.iter().flatten() {
            assert!((set.members.iter().sum::<f64>() - set.loss).abs() < 1e-12 * largest);
        }
        for torques in case.members.iter().flatten() {
            assert!(torques.iter().sum::<f64>().abs() < 1e-12 * largest);
        }
    }
}

#[test]
fn powers_and_torques_balance_in_every_gear() {
    for Machine { gearbox, gears } in machines::all() {
        for published in gears {
            let found = gearbox.analyze(published.gear).unwrap();
            balances(&found);
            let kreines = found.kreines().unwrap();
            assert!(kreines.reversed.is_empty());
            let largest = found.driving().unwrap().power.largest;
            assert!((kreines.efficiency - found.efficiency().unwrap()).abs() < 1e-12 * largest);
        }
    }
}

#[test]
fn brakes_and_grounds_hold_what_input_and_output_leave() {
    let eight = machines::eight_speed().gearbox;
    for gear in ["1", "2", "3", "4", "5", "7", "8", "R"] {
        let found = eight.analyze(gear).unwrap();
        let case = found.driving().unwrap();
        let brakes: f64 = eight
            .shift_elements()
            .iter()
            .zip(&case.shift_elements)
            .filter(|(shift_element, _)| shift_element.is_brake())
            .map(|(_, torque)| torque.unwrap())
            .sum();
        assert!(
            (brakes - case.housing).abs() < 1e-12 * case.power.largest,
            "{gear}: {brakes} {}",
            case.housing
        );
    }
}

#[test]
fn the_first_gear_of_a_simpson_set_by_hand() {
    // FWD: ring A turns with 1. LR: carrier B rests. k = 27/13, i = 2 + 1/k.
    let simpson = machines::simpson().gearbox;
    let first = simpson.analyze("1").unwrap();
    assert_eq!(first.exact_ratio(), Some(Fraction::new(67, 27)));
    let case = first.ideal().unwrap();
    // FWD carries the input torque from `in` to `RA`: on `in` it acts with −1.
    assert_eq!(case.shift_elements[0], Some(-1.0));
    assert_eq!(case.shift_elements[1], Some(0.0));
    // T_out = −67/27, the brake holds the rest.
    assert!((case.shift_elements[3].unwrap() - (67.0 / 27.0 - 1.0)).abs() < 1e-14);
    // Sun: −k·ω_out with both sets; slip of INT is the sun's speed.
    assert!((first.slips()[2].unwrap() - -(54.0 / 26.0) * 27.0 / 67.0).abs() < 1e-14);
}

#[test]
fn the_planet_of_the_wind_gearbox_turns_by_its_teeth() {
    let wind = machines::wind().gearbox;
    let found = wind.analyze("overall").unwrap();
    // No planet count given: z_g from equal centre distances, (99 − 21)/2 = 39. ω_s = 120/21.
    let planet = found.sets()[0].planets[0].unwrap();
    assert!((planet.relative - -(120.0 / 21.0 - 1.0) * 21.0 / 39.0).abs() < 1e-13);
    assert!(found.sets()[1].planets.is_empty());
    assert_eq!(wind.warnings(), [] as [Warning; 0]);
}

#[test]
fn the_compiled_gear_equals_the_analysis_and_the_plain_way() {
    for Machine { gearbox, gears } in machines::all() {
        let values = gearbox.values();
        let etas: Vec<f64> = values.efficiencies.iter().map(|eta| eta.get()).collect();
        let mut solution = Solution::default();
        for published in gears {
            let gear = gearbox.gear(published.gear).unwrap();
            let found = gearbox.analyze_gear(gear).unwrap();
            let compiled = CompiledGear::new(&gearbox, gear).unwrap();
            compiled.solve(&values, Direction::Drive, &mut solution).unwrap();
            let plain = plain::solve(&gearbox, gear, &plain::ratios(&gearbox), &etas).unwrap();
            assert!((solution.ratio() - found.ratio().unwrap()).abs() < 1e-13 * solution.ratio().abs());
            for (index, speed) in found.speeds().iter().enumerate().skip(1) {
                assert!((speed.unwrap() - plain.speeds[index - 1]).abs() < 1e-12);
            }
            let efficiency = found.efficiency().unwrap();
            assert!((solution.efficiency().unwrap() - efficiency).abs() < 1e-14);
            assert!((plain.efficiency - efficiency).abs() < 1e-12, "{} {}", gearbox.name(), published.gear);
            assert_eq!(plain.signs, found.driving().unwrap().signs);
            for (set, torques) in found.driving().unwrap().members.iter().enumerate() {
                assert!((torques.as_ref().unwrap()[0] - plain.suns[set]).abs() < 1e-12);
            }
        }
    }
}

/// Ford AOD: gears 4 and R turn the long planets by the large sun, 36 teeth at the input's speed against the
/// carrier. The short ones are in mesh with them, so the double planet's speeds need its teeth: 18 and 18
/// make all planets alike, 15 of the short ones turn them the fastest.
#[test]
fn planets_in_mesh_turn_by_their_teeth() {
    let planets = |gearbox: &Gearbox, gear: &str, set: usize| -> Vec<Option<f64>> {
        let found = gearbox.analyze(gear).unwrap();
        found.sets()[set].planets.iter().map(|planet| planet.map(|planet| planet.relative)).collect()
    };
    let teeth = |count| ToothCount::new(count).unwrap();
    for (short, fastest) in [(18, 2.0), (15, 2.4)] {
        let two_sets = machines::ravigneaux_builder([MeshLoss::IDEAL; 2])
            .map_sets(|set| match set.kind {
                SetKind::DoublePlanet => set.planet_teeth(teeth(short), Some(teeth(18))),
                _ => set,
            })
            .build()
            .unwrap();
        let one_set = machines::ravigneaux_set([1.0; 4])
            .map_descriptions(|description| match description {
                Description::Compound(mut set) => {
                    set.planets[0].teeth = vec![short];
                    Description::Compound(set)
                }
                short => short,
            })
            .build()
            .unwrap();
        for (gear, sense) in [("R", 1.0), ("4", -1.0)] {
            // Against the carrier the large sun turns as the input in R, and backwards as fast in 4.
            let expected = [sense * 36.0 / f64::from(short), -sense * 36.0 / 18.0];
            for found in [planets(&two_sets, gear, 0), planets(&one_set, gear, 0)] {
                let fastest_found = found.iter().flatten().fold(0.0_f64, |most, speed| most.max(speed.abs()));
                assert!((fastest_found - fastest).abs() < 1e-12, "{gear}");
                for (speed, expected) in found.iter().zip(expected) {
                    assert!((speed.unwrap() - expected).abs() < 1e-12, "{gear} {found:?}");
                }
            }
            assert!((planets(&two_sets, gear, 1)[0].unwrap() + sense * 2.0).abs() < 1e-12);
        }
    }
    // Without their teeth they are missing, not those of the other set.
    assert_eq!(planets(&machines::ravigneaux().gearbox, "R", 0), [None, None]);
}
