#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::f64::consts::PI;

use epicyclic_units::Physical;
use proptest::prelude::*;
use uom::si::f64::Length;
use uom::si::f64::{AngularVelocity, Pressure, Torque, Volume};

use super::*;
use crate::checks::Subject;
use crate::closure::Interval;
use crate::motor::Motor;

fn mm(value: f64) -> Length {
    Length::from_mm(value)
}

fn cm3(value: f64) -> Volume {
    Volume::from_cm3(value)
}

/// Few numbers, so that a test can try them all; sizes are free.
fn small(stator_lobes: RangeInclusive<u32>, stator_teeth: RangeInclusive<u32>) -> MotorSearch {
    let mut search = MotorSearch::new(Requirements::of_displacement(cm3(300.0)));
    search.requirements.size = Size::WidthOverDiameter(0.5);
    search.bounds = Bounds { stator_lobes, stator_teeth, satellite_teeth: 8..=60 };
    // The trial uses centrodes alone; teeth and ports have tests of their own.
    search.made = false;
    search
}

/// A motor found by trial.
#[derive(Debug, Clone)]
struct Tried {
    numbers: MotorNumbers,
    l: f64,
    objectives: [f64; 3],
    refused: Option<Reason>,
}

/// The motor at a part of an interval, by the public way: every check, ripple, envelope.
fn tried(search: &MotorSearch, numbers: MotorNumbers, interval: &Interval, part: f64) -> Tried {
    let metre = Length::from_si(1.0);
    let inverse =
        |end: &crate::closure::End| end.arcs().map_or(0.0, |arcs| arcs.trough_distance().si().recip());
    let (from, to) = (inverse(&interval.lower), inverse(&interval.upper));
    let l = (from + (to - from) * part).recip();
    let motor = Motor::of_closed_arcs(numbers, crate::closure::arcs_at(numbers, metre, metre * l).unwrap());
    let checks = motor.checks(search.heights).unwrap();
    let curved = [Subject::StatorBulge, Subject::StatorHollow, Subject::RotorBulge, Subject::RotorHollow];
    let radii = checks.iter().filter(|check| curved.contains(&check.subject));
    let least = radii.map(|check| check.value.si()).fold(f64::INFINITY, f64::min);
    Tried {
        numbers,
        l,
        objectives: [motor.envelope().displacement_by_volume, -motor.ripple().delta, least],
        refused: checks.iter().find(|check| !check.holds()).map(|check| check.subject.into()).or_else(|| {
            motor.clone().turning().err().map(|error| match error {
                Error::RotorInStator { .. } => Reason::RotorInStator,
                _ => Reason::NoChamber,
            })
        }),
    }
}

/// Motors of the bounds at this number of places, by loops in the opposite order.
fn trial(search: &MotorSearch, places: u32) -> (Vec<Tried>, usize) {
    let mut all = Vec::new();
    let mut without = 0;
    for satellite in search.bounds.satellite_teeth.clone().rev() {
        for teeth in search.bounds.stator_teeth.clone() {
            for rotor in 1..=*search.bounds.stator_lobes.end() {
                for stator in search.bounds.stator_lobes.clone() {
                    let Ok(numbers) = MotorNumbers::new(stator, rotor, teeth, satellite) else { continue };
                    let Ok(family) = Family::new(numbers, Length::from_si(1.0)) else {
                        without += 1;
                        continue;
                    };
                    for interval in family.intervals() {
                        all.extend((0..places).map(|i| {
                            let part = f64::from(i) / f64::from(places - 1);
                            tried(search, numbers, interval, part.clamp(1e-6, 1.0 - 1e-6))
                        }));
                    }
                }
            }
        }
    }
    (all, without)
}

fn dominates(one: &Tried, other: &Tried) -> bool {
    (0..3).all(|i| one.objectives[i] >= other.objectives[i]) && one.objectives != other.objectives
}

#[test]
fn the_search_finds_what_trial_of_every_motor_finds() {
    let mut search = small(2..=6, 30..=54);
    search.resolution = None;
    let found = search.front().unwrap();
    let (all, without) = trial(&search, 16);
    assert_eq!((found.funnel.without_family, found.funnel.points), (without, all.len()));
    for reason in Reason::OF_MOTORS {
        let same = |tried: &&Tried| tried.refused == Some(reason);
        assert_eq!(found.funnel.refused(reason), all.iter().filter(same).count() as u64, "{reason:?}");
    }
    let accepted: Vec<&Tried> = all.iter().filter(|tried| tried.refused.is_none()).collect();
    assert_eq!(found.funnel.accepted, accepted.len());
    let mut front: Vec<&Tried> =
        accepted.iter().copied().filter(|one| !accepted.iter().any(|other| dominates(other, one))).collect();
    front.sort_by(|one, other| other.objectives[0].total_cmp(&one.objectives[0]));
    assert!(front.len() > 20 && found.designs.len() == front.len(), "{}", front.len());
    for (design, tried) in found.designs.iter().zip(front) {
        assert_eq!(design.numbers, tried.numbers);
        let l = design.arcs(Length::from_si(1.0)).unwrap().trough_distance().si();
        assert!((l / tried.l - 1.0).abs() < 1e-12);
        let own = [design.displacement_by_volume, -design.ripple, design.least_radius];
        for (own, tried) in own.iter().zip(tried.objectives) {
            assert!((own - tried).abs() <= 1e-9 * tried.abs(), "{own} {tried}");
        }
    }
}

/// The claim of the module's docs: of 256 places in each interval no motor is better than every design by
/// more than the spacing error of one.
#[test]
fn finer_places_are_better_by_no_more_than_the_error_says() {
    for (search, least_gain) in [(small(3..=6, 48..=54), 0.01), (small(2..=4, 60..=66), 0.01)] {
        let found = search.front().unwrap();
        let error = found.spacing_error;
        let errors = [error.displacement_by_volume, error.ripple, error.least_radius];
        assert!(errors.iter().all(|error| *error <= 0.02), "{errors:?}");
        assert!(found.refinement_gain.displacement_by_volume > least_gain);
        let (all, _) = trial(&search, 256);
        let mut fronts = 0;
        for tried in all.iter().filter(|tried| tried.refused.is_none()) {
            let covered = found.designs.iter().any(|design| {
                let SpacingError { displacement_by_volume, ripple, least_radius, .. } = design.spacing_error;
                tried.objectives[0]
                    <= design.displacement_by_volume * (1.0 + displacement_by_volume) * (1.0 + 1e-9)
                    && -tried.objectives[1] * (1.0 + ripple) * (1.0 + 1e-9) >= design.ripple
                    && tried.objectives[2] <= design.least_radius * (1.0 + least_radius) * (1.0 + 1e-9)
            });
            assert!(covered, "{tried:?}");
            fronts += 1;
        }
        assert!(fronts > 2000, "{fronts}");
    }
}

/// Figures at the flanks as objectives, in addition to those at the pitch points and in their place, keep the
/// errors too; every figure is that of the motor.
#[test]
fn figures_at_the_flanks_as_objectives_are_complete_within_the_error_too() {
    let mut search = small(5..=6, 55..=60);
    search.bounds.satellite_teeth = 9..=11;
    search.objectives = vec![Objective::DisplacementByVolume, Objective::FlankRipple, Objective::LeastTorque];
    search.flanks = FlankTerms { ripple: Some(0.1), least_torque: Some(0.93), ..FlankTerms::default() };
    let found = search.front().unwrap();
    let form = search.flanks.form;
    for design in &found.designs {
        let at = AtFlanks::of(&design.motor(mm(2.0)).unwrap(), form).unwrap();
        let own = design.at_flanks.unwrap();
        assert!((at.ripple / own.ripple - 1.0).abs() < 1e-9, "{at:?} {own:?}");
        assert!((at.least_over_mean - own.least_over_mean).abs() < 1e-9, "{at:?} {own:?}");
        assert!(own.ripple <= 0.1 && own.least_over_mean >= 0.93 && own.ripple > design.ripple);
        let SpacingError { ripple, least_radius, .. } = design.spacing_error;
        assert_eq!((ripple, least_radius), (0.0, 0.0));
    }
    assert!(!found.designs.is_empty() && found.funnel.refused(Reason::FlankRipple) > 0, "{:?}", found.funnel);
    let mut tried = 0;
    for numbers in search.bounds.all().unwrap() {
        let Ok(family) = Family::new(numbers, Length::from_si(1.0)) else { continue };
        for i in 0..96 {
            let part = (f64::from(i) / 95.0).clamp(1e-6, 1.0 - 1e-6);
            let Some(arcs) = family.within(&family.intervals()[0], part) else { continue };
            let motor = Motor::of_closed_arcs(numbers, arcs);
            if motor.checks(search.heights).unwrap().iter().any(|check| !check.holds()) {
                continue;
            }
            let Some(at) = AtFlanks::of(&motor, form) else { continue };
            if at.ripple > 0.1 || at.least_over_mean < 0.93 {
                continue;
            }
            let volume = motor.envelope().displacement_by_volume;
            let covered = found.designs.iter().any(|design| {
                let (own, error) = (design.at_flanks.unwrap(), design.spacing_error);
                let reach = |error: f64| (1.0 + error) * (1.0 + 1e-9);
                volume <= design.displacement_by_volume * reach(error.displacement_by_volume)
                    && at.ripple * reach(error.flank_ripple) >= own.ripple
                    && at.least_over_mean <= own.least_over_mean * reach(error.least_torque)
            });
            assert!(covered, "{numbers:?} {part} {volume} {at:?}");
            tried += 1;
        }
    }
    assert!(tried > 100, "{tried}");
}

/// Bounds at the flanks refuse motors; without bounds every motor is as before.
#[test]
fn bounds_at_the_flanks_refuse_and_figures_alone_do_not() {
    let usual = small(5..=6, 55..=60).front().unwrap();
    assert_eq!(
        [Reason::NoTeeth, Reason::FlankRipple, Reason::LeastTorque].map(|of| usual.funnel.refused(of)),
        [0; 3]
    );
    assert!(usual.designs.iter().all(|design| design.at_flanks.is_none()));
    let mut bound = small(5..=6, 55..=60);
    bound.flanks.least_torque = Some(0.95);
    let bound = bound.front().unwrap();
    assert!(bound.funnel.refused(Reason::LeastTorque) > 0 && bound.funnel.accepted < usual.funnel.accepted);
    assert!(bound.designs.iter().all(|design| design.at_flanks.unwrap().least_over_mean >= 0.95));
}

/// If every motor of the front must have teeth and ports, the front is that of all motors that have. Each
/// motor is tested in full: every limit of the profile, every port.
#[test]
fn the_front_of_what_can_be_made_is_that_of_trial() {
    let mut search = small(4..=6, 48..=54);
    search.made = true;
    search.resolution = None;
    search.heights = ToothHeights { addendum: 1.05, dedendum: 1.3 };
    let found = search.front().unwrap();
    let form = search.flanks.form;
    let can_be_made = |tried: &Tried| {
        let metre = Length::from_si(1.0);
        let motor = Motor::of_two_arcs(tried.numbers, metre, metre * tried.l).unwrap();
        let profile = crate::profile::Profile::new(&motor, form);
        profile.is_ok_and(|profile| profile.limits().iter().all(crate::profile::limits::Limit::holds))
            && crate::ports::PortPlate::of_ideal_holes(&motor, 0.95).and_then(|plate| plate.timing()).is_ok()
    };
    let (all, _) = trial(&search, 16);
    let passed: Vec<&Tried> = all.iter().filter(|tried| tried.refused.is_none()).collect();
    let made: Vec<&Tried> = passed.iter().copied().filter(|tried| can_be_made(tried)).collect();
    assert!(made.len() > 30 && made.len() < passed.len(), "{} of {}", made.len(), passed.len());
    let mut front: Vec<&Tried> =
        made.iter().copied().filter(|one| !made.iter().any(|other| dominates(other, one))).collect();
    front.sort_by(|one, other| other.objectives[0].total_cmp(&one.objectives[0]));
    let of =
        |design: &Design| (design.numbers, (design.arcs(mm(1.0)).unwrap().trough_distance() / mm(1.0)).value);
    assert_eq!(found.designs.len(), front.len());
    for (design, tried) in found.designs.iter().zip(front) {
        let (numbers, l) = of(design);
        assert!(numbers == tried.numbers && (l / tried.l - 1.0).abs() < 1e-12, "{numbers:?} {l}");
    }
    // Fewer motors are tested than there are, and each refusal is counted.
    let of_teeth = Reason::OF_MOTORS.into_iter().skip_while(|reason| *reason != Reason::NoTeeth);
    let refused: u64 = of_teeth.map(|reason| found.funnel.refused(reason)).sum();
    assert!(refused > 0 && refused <= (passed.len() - made.len()) as u64, "{refused}");
}

#[test]
fn the_answer_does_not_depend_on_the_number_of_threads() {
    let mut search = small(4..=5, 48..=55);
    search.made = true;
    let answer = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| search.front()).unwrap()
    };
    let one = answer(1);
    assert!(!one.designs.is_empty());
    assert_eq!(one, answer(2));
    assert_eq!(one, answer(5));
}

#[test]
fn a_finer_resolution_lists_more_and_leaves_less() {
    let mut search = small(3..=5, 50..=60);
    let mut last: Option<Found> = None;
    for resolution in [0.2, 0.05, 0.01] {
        search.resolution = Some(resolution);
        let found = search.front().unwrap();
        let SpacingError { displacement_by_volume, ripple, least_radius, .. } = found.spacing_error;
        assert!([displacement_by_volume, ripple, least_radius].iter().all(|error| *error <= resolution));
        if let Some(last) = last {
            assert!(found.designs.len() > last.designs.len() && found.funnel.refined > last.funnel.refined);
        }
        last = Some(found);
    }
}

/// Every record agrees with the motor that it describes, in every way to give a size.
#[test]
fn the_records_are_those_of_the_motors() {
    let pressure = Pressure::from_mpa(20.0);
    let speed = AngularVelocity::from_si(10.0);
    let torque = Torque::from_si(900.0);
    let list = vec![mm(2.0), mm(2.5), mm(3.0)];
    let both = Size::ModulesAndWidth { modules: list.clone(), width: mm(50.0), tolerance: 0.1 };
    let mut refused = [0; 3];
    for size in [Size::Modules(list), Size::Width(mm(60.0)), both, Size::WidthOverDiameter(0.4)] {
        let mut search = small(4..=6, 40..=60);
        search.requirements =
            Requirements { speed: Some(speed), size, ..Requirements::of_torque(torque, pressure).unwrap() };
        search.limits.size.outer_diameter = Some(mm(150.0));
        search.limits.size.width_over_diameter = 0.2..=0.8;
        search.limits.ripple = Some(0.07);
        search.limits.least_radius = Some(3.0);
        search.limits.rotor_lobes = 3..=5;
        let found = search.front().unwrap();
        assert!(!found.designs.is_empty(), "{:?} {:?}", search.requirements.size, found.funnel);
        assert!(found.funnel.outside_limits > 0);
        for (counted, reason) in refused.iter_mut().zip([Reason::Ripple, Reason::LeastRadius, Reason::Size]) {
            *counted += found.funnel.refused(reason);
        }
        for design in &found.designs {
            assert!(design.ripple <= 0.07 && design.least_radius >= 3.0 && design.nearest_margin > 0.0);
            assert!((3..=5).contains(&design.numbers.rotor_lobes()) && !design.dimensions.is_empty());
            for size in &design.dimensions {
                let motor = design.motor(size.module).unwrap();
                let near = |one: f64, other: f64| (one / other - 1.0).abs() < 1e-9;
                let checks = motor.checks(search.heights).unwrap();
                assert!(checks.iter().all(crate::checks::Check::holds));
                let margin = |check: &crate::checks::Check| (check.value / check.limit).value - 1.0;
                let nearest =
                    checks.iter().min_by(|one, other| margin(one).total_cmp(&margin(other))).unwrap();
                assert_eq!(nearest.subject, design.nearest_check);
                assert!((margin(nearest) - design.nearest_margin).abs() < 1e-9);
                let radius = checks.iter().find(|check| check.subject == design.least_radius_of).unwrap();
                assert!(near((radius.value / size.module).value, design.least_radius));
                assert!(near(motor.envelope().displacement_by_volume, design.displacement_by_volume));
                assert!(near(motor.envelope().stator_outer.value, size.outer_diameter.value));
                assert!(near(motor.displacement(size.width).unwrap().value, size.displacement.value));
                assert!(near((size.displacement / size.volume).value, design.displacement_by_volume));
                assert!(near(motor.ripple().delta, design.ripple));
                let whole = motor.theoretical_torque(size.width, pressure).unwrap();
                assert!(near(whole.value, size.torque.unwrap().value));
                let least = (motor.ripple().least * size.width * pressure).value;
                assert!(near(least, size.least_torque.unwrap().value) && least < whole.value);
                assert!(near(motor.mean_flow(size.width, speed).unwrap().value, size.flow.unwrap().value));
                assert!(near(size.power.unwrap().value, whole.value * 10.0));
                // The wanted torque, and the limits.
                let reach =
                    if matches!(search.requirements.size, Size::ModulesAndWidth { .. }) { 0.1 } else { 1e-9 };
                assert!((whole.value / 900.0 - 1.0).abs() < reach + 1e-9);
                assert!(size.outer_diameter <= mm(150.0 + 1e-6));
                let ratio = (size.width / size.outer_diameter).value;
                assert!(ratio > 0.2 - 1e-9 && ratio < 0.8 + 1e-9);
                match &search.requirements.size {
                    Size::Modules(modules) => assert!(modules.contains(&size.module)),
                    Size::Width(width) => assert_eq!(*width, size.width),
                    Size::ModulesAndWidth { modules, width, .. } => {
                        assert!(modules.contains(&size.module) && *width == size.width);
                    }
                    Size::WidthOverDiameter(part) => assert!(near(ratio, *part)),
                }
            }
        }
    }
    assert!(refused.iter().all(|&refused| refused > 0), "{refused:?}");
}

#[test]
fn every_motor_is_counted_once() {
    let mut search = small(2..=5, 40..=60);
    search.limits.divisor = LobeDivisor::Common;
    let Found { designs, funnel, .. } = search.front().unwrap();
    let refused: u64 = Reason::OF_MOTORS.iter().map(|&reason| funnel.refused(reason)).sum();
    assert_eq!((funnel.points + funnel.refined) as u64, refused + funnel.accepted as u64);
    assert_eq!(funnel.sets as u64, search.bounds.count().unwrap());
    assert!(designs.iter().all(|design| design.numbers.bearing_reactions_vanish()));
    assert!(funnel.front >= designs.len() && funnel.accepted >= funnel.front);
    assert_eq!(funnel.refused(Reason::NotClosed), 0);
    search.limits.divisor = LobeDivisor::One;
    let other = search.front().unwrap();
    assert!(other.designs.iter().all(|design| design.numbers.common_divisor() == 1));
    assert_eq!(other.funnel.outside_limits + funnel.outside_limits, funnel.sets);
    // A torque that no size within the limits has.
    search.limits.size.outer_diameter = Some(mm(1.0));
    let none = search.front().unwrap();
    assert!(none.designs.is_empty() && none.funnel.refused(Reason::Size) > 0);
    assert_eq!(none.spacing_error, SpacingError::default());
}

#[test]
fn orders_that_make_no_sense_are_refused() {
    let base = small(3..=4, 30..=40);
    let refused = |change: &dyn Fn(&mut MotorSearch)| {
        let mut search = base.clone();
        change(&mut search);
        search.front().unwrap_err().to_string()
    };
    #[allow(clippy::reversed_empty_ranges)] // the fault under test
    let messages = [
        refused(&|search| search.requirements.displacement = cm3(-3.0)),
        refused(&|search| search.requirements.pressure_drop = Some(Pressure::from_mpa(0.0))),
        refused(&|search| {
            search.requirements.speed = Some(AngularVelocity::from_si(f64::NAN));
        }),
        refused(&|search| search.requirements.size = Size::Modules(Vec::new())),
        refused(&|search| search.requirements.size = Size::Modules(vec![mm(2.0), mm(0.0)])),
        refused(&|search| search.requirements.size = Size::Width(mm(f64::INFINITY))),
        refused(&|search| search.requirements.size = Size::WidthOverDiameter(0.0)),
        refused(&|search| {
            search.requirements.size =
                Size::ModulesAndWidth { modules: vec![mm(2.0)], width: mm(50.0), tolerance: 2.0 };
        }),
        refused(&|search| search.limits.size.outer_diameter = Some(mm(-1.0))),
        refused(&|search| search.limits.size.width = Some(mm(50.0)..=mm(40.0))),
        refused(&|search| search.limits.size.width_over_diameter = 0.5..=f64::NAN),
        refused(&|search| search.limits.ripple = Some(0.0)),
        refused(&|search| search.limits.least_radius = Some(-1.0)),
        refused(&|search| search.limits.rotor_lobes = 3..=2),
        refused(&|search| search.heights.addendum = -1.0),
        refused(&|search| search.objectives.clear()),
        refused(&|search| search.flanks.ripple = Some(0.0)),
        refused(&|search| search.flanks.least_torque = Some(1.2)),
        refused(&|search| search.points = 2),
        refused(&|search| search.resolution = Some(0.0)),
        refused(&|search| search.bounds.stator_teeth = 50..=40),
        refused(&|search| {
            search.bounds =
                Bounds { stator_lobes: 2..=5000, stator_teeth: 1..=10_000, satellite_teeth: 1..=u32::MAX }
        }),
        Requirements::of_torque(Torque::from_si(0.0), Pressure::from_mpa(20.0)).unwrap_err().to_string(),
        Requirements::of_torque(Torque::from_si(9.0), Pressure::from_mpa(-2.0)).unwrap_err().to_string(),
    ];
    insta::assert_snapshot!(messages.join("\n"));
}

/// A table for a reader, and against unwanted change.
#[test]
fn the_front_of_a_few_numbers() {
    let mut search = small(5..=6, 50..=66);
    search.requirements = Requirements::of_torque(Torque::from_si(900.0), Pressure::from_mpa(20.0)).unwrap();
    search.limits.size.outer_diameter = Some(mm(180.0));
    search.resolution = Some(0.2);
    let found = search.front().unwrap();
    let mut table = String::from("n×N Z_3/Z_1/Z_s     q/V  ripple  radius  of; nearest check; sizes m x b\n");
    for design in &found.designs {
        let numbers = design.numbers;
        let sizes: Vec<String> = design
            .dimensions
            .iter()
            .map(|size| format!("{} x {:.1}", size.module.mm(), size.width.mm()))
            .collect();
        table += &format!(
            "{}×{} {}/{}/{} {:.4} {:.4} {:.3} {:?}; {:?} {:.3}; {}\n",
            numbers.rotor_lobes(),
            numbers.stator_lobes(),
            numbers.stator_teeth(),
            numbers.rotor_teeth(),
            numbers.satellite_teeth(),
            design.displacement_by_volume,
            design.ripple,
            design.least_radius,
            design.least_radius_of,
            design.nearest_check,
            design.nearest_margin,
            sizes.join(", "),
        );
    }
    let Funnel { sets, without_family, points, refined, accepted, front, .. } = found.funnel;
    table += &format!(
        "{sets} sets, {without_family} without family, {points} + {refined} points, {accepted} accepted, {front} on the front\n"
    );
    insta::assert_snapshot!(table);
}

fn any_length() -> impl Strategy<Value = Length> {
    prop_oneof![any::<f64>(), 0.1..200.0].prop_map(mm)
}

fn any_size() -> impl Strategy<Value = Size> {
    let modules = || proptest::collection::vec(any_length(), 0..4);
    let part = || prop_oneof![any::<f64>(), 0.0..1.5];
    prop_oneof![
        modules().prop_map(Size::Modules),
        any_length().prop_map(Size::Width),
        (modules(), any_length(), part()).prop_map(|(modules, width, tolerance)| Size::ModulesAndWidth {
            modules,
            width,
            tolerance
        }),
        part().prop_map(Size::WidthOverDiameter),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn no_order_panics(
        size in any_size(),
        bounds in (0..8_u32, 0..2_u32, 0..60_u32, 0..6_u32, 0..12_u32, 0..20_u32),
        numbers in (prop_oneof![any::<f64>(), 0.1..1e4], any::<f64>(), prop_oneof![any::<f64>(), 0.0..2.0], prop_oneof![any::<f64>(), 0.0..3.0]),
        limits in proptest::option::of((any_length(), any_length(), any_length(), any::<f64>(), 0.0..9.0)),
        points in 0..12_u32,
    ) {
        let (lobes, more, teeth, wider, satellite, width) = bounds;
        let (displacement, pressure, addendum, dedendum) = numbers;
        let mut search = MotorSearch::new(Requirements::of_displacement(cm3(displacement)));
        search.requirements.size = size;
        search.requirements.pressure_drop = Some(Pressure::from_mpa(pressure.abs()));
        search.requirements.speed = Some(AngularVelocity::from_si(pressure));
        search.bounds = Bounds {
            stator_lobes: lobes..=lobes + more,
            stator_teeth: teeth..=teeth + wider,
            satellite_teeth: satellite..=satellite + width,
        };
        search.heights = ToothHeights { addendum, dedendum };
        if let Some((diameter, from, to, ratio, radius)) = limits {
            search.limits.size = SizeLimits { outer_diameter: Some(diameter), width: Some(from..=to), width_over_diameter: 0.0..=ratio };
            search.limits.ripple = Some(ratio);
            search.limits.least_radius = Some(radius);
        }
        search.points = points;
        search.made = points % 2 == 0;
        if let Ok(found) = search.front() {
            for design in &found.designs {
                prop_assert!(design.displacement_by_volume > 0.0 && design.ripple >= 0.0 && !design.dimensions.is_empty());
            }
        }
        let _ = Requirements::of_torque(Torque::from_si(displacement), Pressure::from_mpa(pressure));
    }

    /// A size that is requested to the last digit is not refused by rounding.
    #[test]
    fn the_size_of_a_design_asked_for_again_is_found(module in 0.5..20.0, width in 5.0..300.0) {
        let numbers = MotorNumbers::new(5, 3, 55, 10).unwrap();
        let motor = Motor::of_two_arcs(numbers, mm(module), mm(40.0 * module)).unwrap();
        let requirements = Requirements::of_displacement(motor.displacement(mm(width)).unwrap());
        let diameter = motor.envelope().stator_outer;
        let limits = SizeLimits {
            outer_diameter: Some(diameter),
            width: Some(mm(width)..=mm(width)),
            width_over_diameter: (mm(width) / diameter).value..=(mm(width) / diameter).value,
        };
        let sizes = [Size::Modules(vec![mm(module)]), Size::Width(mm(width)), Size::WidthOverDiameter((mm(width) / diameter).value)];
        for size in sizes {
            let sizing = Sizing::new(&Requirements { size, ..requirements.clone() }, &limits).unwrap();
            let outer = (diameter / mm(module)).value;
            let displacement = motor.displacement_kernel();
            prop_assert!(sizing.margin(displacement, outer) >= 0.0);
            let [found] = sizing.sizes(displacement, outer)[..] else { panic!("one size") };
            prop_assert!((found[0] / mm(module).value - 1.0).abs() < 1e-12 && (found[1] / mm(width).value - 1.0).abs() < 1e-12);
            let disc = PI / 4.0 * outer * outer;
            prop_assert!((displacement / disc - motor.envelope().displacement_by_volume).abs() < 1e-12);
        }
    }
}
