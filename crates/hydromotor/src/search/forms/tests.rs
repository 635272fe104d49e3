#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;
use crate::checks::{Check, Subject};
use crate::closure::Family;
use crate::cosine::Numbers;
use crate::flanks::{LoadedPath, MaterialLimits, SealingContact, effective_modulus};
use crate::motor::Motor;
use crate::ports::PortPlate;
use crate::profile::limits::{Limit, LimitKind};
use crate::profile::{Crest, Profile, ToothForm};
use crate::search::{Progress, Reason, Size, SizeLimits};
use crate::second_harmonic;
use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure, Torque, Volume};

fn metre() -> Length {
    Length::from_si(1.0)
}

fn steps(from: f64, to: f64, step: f64) -> Steps<f64> {
    Steps { from, to, step }
}

/// Few motors and forms, so that a test can try every point.
fn small() -> FormSearch {
    let mut search = FormSearch::new(Requirements::of_displacement(Volume::from_cm3(300.0)));
    search.requirements.size = Size::WidthOverDiameter(0.5);
    search.bounds = Bounds { stator_lobes: 4..=6, stator_teeth: 54..=66, satellite_teeth: 9..=11 };
    search.places = 5;
    search.forms.pressure_angle = Steps {
        from: Angle::from_degrees(22.5),
        to: Angle::from_degrees(27.5),
        step: Angle::from_degrees(2.5),
    };
    search.forms.addendum = steps(0.75, 0.85, 0.1);
    search.forms.shift = steps(0.1, 0.3, 0.1);
    search
}

/// A point by the public way.
#[derive(Debug, Clone)]
struct Point {
    motor: Motor,
    form: ToothForm,
    /// Values of the objectives, each the greater the better.
    objectives: [f64; 4],
}

/// Every motor of a search at its places, each by its own constructor.
fn motors(search: &FormSearch) -> Vec<Motor> {
    let mut all = Vec::new();
    for numbers in search.bounds.all().unwrap() {
        if search.families.contains(&FamilyKind::TwoArcs)
            && let Ok(family) = Family::new(numbers, metre())
        {
            for interval in family.intervals() {
                let [from, to] = [interval.lower, interval.upper]
                    .map(|end| end.arcs().map_or(0.0, |arcs| arcs.trough_distance().si().recip()));
                for i in 0..search.places {
                    let part = (f64::from(i) / f64::from(search.places - 1)).clamp(1e-6, 1.0 - 1e-6);
                    let l = metre() / (from + (to - from) * part);
                    // No motor if the rotor reaches into the stator.
                    all.extend(Motor::of_two_arcs(numbers, metre(), l));
                }
            }
        }
        if search.families.contains(&FamilyKind::CosineLaw) {
            all.extend(Motor::of_cosine_law(numbers, metre()));
        }
        if search.families.contains(&FamilyKind::SecondHarmonic)
            && let Ok(range) = second_harmonic::range(numbers)
        {
            let of = |end: second_harmonic::HarmonicEnd| 4.0 * end.second_amplitude / end.amplitude;
            let (from, to) = (of(range.lower), of(range.upper));
            for i in 0..search.places {
                let part = (f64::from(i) / f64::from(search.places - 1)).clamp(1e-6, 1.0 - 1e-6);
                let law = Numbers::of(numbers).at_part(from + (to - from) * part).unwrap();
                all.extend(Motor::of_second_harmonic(numbers, metre(), law.second));
            }
        }
    }
    all
}

/// Every admissible point, by each motor's own checks and each profile's own limits.
fn trial(search: &FormSearch) -> Vec<Point> {
    let forms = search.forms.forms().unwrap();
    let mut all = Vec::new();
    for motor in motors(search) {
        let before = all.len();
        for &form in &forms {
            let heights = ToothHeights {
                addendum: form.addendum + form.shift,
                dedendum: form.addendum + form.clearance + form.shift,
            };
            let checks = motor.checks(heights).unwrap();
            if !checks.iter().all(Check::holds) {
                continue;
            }
            let Ok(profile) = Profile::new(&motor, form) else { continue };
            let limits = profile.limits();
            if !limits.iter().all(Limit::holds) {
                continue;
            }
            let curved =
                [Subject::StatorBulge, Subject::StatorHollow, Subject::RotorBulge, Subject::RotorHollow];
            let radii = checks.iter().filter(|check| curved.contains(&check.subject));
            let paths = limits.iter().filter(|limit| limit.kind == LimitKind::ContactPath);
            let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
            let ratio = least(&mut paths.map(|limit| (limit.value / limit.bound).value));
            if ratio < search.least_contact_ratio {
                continue;
            }
            let objectives = [
                motor.envelope().displacement_by_volume,
                motor.ripple().delta.recip(),
                least(&mut radii.map(|check| check.value.si())),
                ratio,
            ];
            all.push(Point { motor: motor.clone(), form, objectives });
        }
        // Of the motors that have a form at all: the timing takes longer than all forms.
        let has_form = all.len() > before;
        if has_form && PortPlate::of_ideal_holes(&motor, 0.95).and_then(|plate| plate.timing()).is_err() {
            all.truncate(before);
        }
    }
    all
}

/// Points of [`small`], tried once.
fn all_of_small() -> &'static [Point] {
    static ALL: std::sync::OnceLock<Vec<Point>> = std::sync::OnceLock::new();
    ALL.get_or_init(|| trial(&small()))
}

fn objectives(design: &FormDesign) -> [f64; 4] {
    [design.displacement_by_volume, design.ripple.recip(), design.least_radius, design.contact_ratio]
}

fn mpa(value: f64) -> Pressure {
    Pressure::from_mpa(value)
}

fn steel() -> MaterialLimits {
    let modulus = effective_modulus([mpa(206e3); 2], [0.3; 2]).unwrap();
    MaterialLimits { contact: mpa(1500.0), root: mpa(400.0), modulus }
}

/// Flanks as objectives and as limits against every admissible point, each with its own profile.
#[test]
fn flanks_under_load_are_those_of_every_profile() {
    let mut search = small();
    search.requirements.pressure_drop = Some(mpa(20.0));
    search.resolution = None;
    search.flanks = Some(FlankOrder::of(steel()));
    // By the objectives' own order: −ripple, least torque, −contact, −root, allowed pressure.
    let drop = mpa(20.0);
    let all: Vec<(&Point, [f64; 5])> = all_of_small()
        .iter()
        .map(|point| {
            let profile = Profile::new(&point.motor, point.form).unwrap();
            let stresses = profile.contact_stresses(drop, steel().modulus).unwrap();
            let contact = stresses
                .iter()
                .flat_map(|stress| [Some(stress.at_pitch_point), stress.on_path])
                .flatten()
                .map(|peak| peak.pressure.value)
                .fold(0.0, f64::max);
            let roots = profile.root_stresses(LoadedPath::Whole, drop).unwrap();
            let root = roots.iter().map(|root| root.stress.value).fold(0.0, f64::max);
            let allowed = profile.allowed_pressure(LoadedPath::Whole, &steel()).unwrap().pressure.value;
            let ripple = profile.flank_ripple(SealingContact::Nearest);
            (point, [-ripple.at_flanks.delta, ripple.least_over_mean, -contact, -root, allowed])
        })
        .collect();
    let own = |design: &FormDesign| {
        let flanks = design.flanks.unwrap();
        let [contact, root] = [flanks.contact_stress, flanks.root_stress].map(|stress| stress.unwrap().value);
        [-flanks.ripple, flanks.least_over_mean, -contact, -root, flanks.allowed.pressure.value]
    };
    let near = |one: f64, other: f64| (one - other).abs() <= 1e-6 * other.abs();
    for (i, objective) in Objective::ALL[4..].iter().enumerate() {
        search.objectives = vec![*objective];
        let found = search.front().unwrap();
        let best = all.iter().map(|(_, values)| values[i]).fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(found.designs.len(), 1);
        assert!(near(own(&found.designs[0])[i], best), "{objective:?} {best} {:?}", found.designs[0].flanks);
    }
    // Two that pull apart: every trial point is reached, and every design is one of them.
    search.objectives =
        vec![Objective::DisplacementByVolume, Objective::ContactStress, Objective::FlankRipple];
    let pick = |by_volume: f64, values: &[f64; 5]| [by_volume, values[2], values[0]];
    let found = search.front().unwrap();
    assert!(found.designs.len() > 3);
    let listed: Vec<[f64; 3]> =
        found.designs.iter().map(|design| pick(design.displacement_by_volume, &own(design))).collect();
    let tried: Vec<[f64; 3]> = all.iter().map(|(point, values)| pick(point.objectives[0], values)).collect();
    let no_less =
        |one: &[f64; 3], other: &[f64; 3]| (0..3).all(|i| one[i] >= other[i] - 1e-6 * other[i].abs());
    assert!(tried.iter().all(|point| listed.iter().any(|design| no_less(design, point))));
    assert!(listed.iter().all(|design| tried.iter().any(|point| (0..3).all(|i| near(design[i], point[i])))));
    // Points that keep the limits are as many as by trial, and none fails.
    let middle = |i: usize| {
        let mut values: Vec<f64> = all.iter().map(|(_, values)| values[i]).collect();
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let base = FlankOrder::of(steel());
    let pascal = |value: f64| Pressure::from_si(value);
    let limited = [
        (FlankOrder { ripple: Some(-middle(0)), ..base.clone() }, Reason::FlankRipple),
        (FlankOrder { least_torque: Some(middle(1)), ..base.clone() }, Reason::LeastTorque),
        (FlankOrder { contact_stress: Some(pascal(-middle(2))), ..base.clone() }, Reason::ContactStress),
        (FlankOrder { root_stress: Some(pascal(-middle(3))), ..base.clone() }, Reason::RootStress),
        (FlankOrder { allowed_pressure: Some(pascal(middle(4))), ..base }, Reason::AllowedPressure),
    ];
    for (i, (order, refusal)) in limited.into_iter().enumerate() {
        search.flanks = Some(order);
        search.objectives = vec![Objective::DisplacementByVolume];
        let found = search.front().unwrap();
        assert!(found.funnel.refused(refusal) > 0, "{refusal:?}");
        let kept =
            all.iter().filter(|(_, values)| values[i] >= middle(i) * (1.0 - 1e-9 * middle(i).signum()));
        let best = kept.map(|(point, _)| point.objectives[0]).fold(0.0, f64::max);
        assert!(near(found.designs[0].displacement_by_volume, best), "{refusal:?}");
        assert!(own(&found.designs[0])[i] >= middle(i) - 1e-6 * middle(i).abs());
    }
}

#[test]
fn the_exact_front_is_that_of_a_trial_of_every_point() {
    let mut search = small();
    search.resolution = None;
    let all = all_of_small();
    assert!(all.len() > 200, "{}", all.len());
    for chosen in
        [&Objective::ALL[..4], &Objective::ALL[..2], &[Objective::ContactRatio, Objective::LeastRadius]]
    {
        search.objectives = chosen.to_vec();
        let found = search.front().unwrap();
        let pick = |values: [f64; 4]| -> Vec<f64> {
            chosen.iter().map(|&objective| values[objective as usize]).collect()
        };
        // Values that differ only by rounding count as one.
        let no_less = |one: &[f64], other: &[f64]| one.iter().zip(other).all(|(a, b)| *a >= b * (1.0 - 1e-9));
        let more = |one: &[f64], other: &[f64]| one.iter().zip(other).any(|(a, b)| *a > b * (1.0 + 1e-9));
        let values: Vec<Vec<f64>> = all.iter().map(|point| pick(point.objectives)).collect();
        let mut front: Vec<&Vec<f64>> = values
            .iter()
            .filter(|one| !values.iter().any(|other| no_less(other, one) && more(other, one)))
            .collect();
        front.sort_by(|one, other| other.partial_cmp(one).unwrap());
        front.dedup_by(|one, other| no_less(one, other) && no_less(other, one));
        assert!(!front.is_empty());
        let mut listed: Vec<Vec<f64>> = found.designs.iter().map(|design| pick(objectives(design))).collect();
        listed.sort_by(|one, other| other.partial_cmp(one).unwrap());
        assert_eq!(listed.len(), front.len(), "{chosen:?}");
        for (own, tried) in listed.iter().zip(front) {
            assert!(no_less(own, tried) && no_less(tried, own), "{own:?} {tried:?}");
        }
        let near = |design: &FormDesign, point: &&Point| {
            let (own, other) = (objectives(design), point.objectives);
            point.motor.numbers() == design.numbers
                && point.form == design.form
                && no_less(&own, &other)
                && no_less(&other, &own)
        };
        assert!(found.designs.iter().all(|design| all.iter().any(|point| near(design, &point))));
    }
}

#[test]
fn no_admissible_point_is_better_than_some_design_by_more_than_the_resolution() {
    let mut search = small();
    search.objectives = Objective::ALL[..4].to_vec();
    let all = all_of_small();
    let mut last = usize::MAX;
    for resolution in [0.01, 0.05, 0.2] {
        search.resolution = Some(resolution);
        let found = search.front().unwrap();
        for point in all {
            let covers = |design: &FormDesign| {
                let own = objectives(design);
                (0..4).all(|i| point.objectives[i] <= own[i] * (1.0 + resolution) * (1.0 + 1e-9))
            };
            assert!(found.designs.iter().any(covers), "{point:?}");
        }
        assert!(!found.designs.is_empty() && found.designs.len() < last);
        last = found.designs.len();
    }
}

/// The claim that matters: limits, and no teeth that touch at any of 256 angles.
#[test]
fn every_design_keeps_all_limits_at_256_angles() {
    let mut search = small();
    search.resolution = Some(0.05);
    let found = search.front().unwrap();
    let mut families = Vec::new();
    for design in &found.designs {
        let module = design.sizes[0].module;
        let profile = design.profile(module).unwrap();
        assert!(profile.limits().iter().all(Limit::holds));
        let clearances = profile.clearances(255).unwrap();
        assert!(clearances.free(), "{design:?} {clearances:?}");
        families.push(design.family);
    }
    assert!(families.contains(&FamilyKind::TwoArcs) && families.contains(&FamilyKind::SecondHarmonic));
}

/// Designs of the default search keep all limits too; every seventh is checked.
#[test]
fn designs_of_the_default_search_keep_all_limits_at_256_angles() {
    const STRIDE: usize = 7;
    let search = FormSearch::new(Requirements::of_displacement(Volume::from_cm3(188.5)));
    let found = search.front().unwrap();
    for design in found.designs.iter().step_by(STRIDE) {
        let profile = design.profile(design.sizes[0].module).unwrap();
        assert!(profile.limits().iter().all(Limit::holds), "{design:?}");
        let clearances = profile.clearances(255).unwrap();
        assert!(clearances.free(), "{design:?} {clearances:?}");
    }
    assert!(found.designs.len() > 4 * STRIDE, "{}", found.designs.len());
}

#[test]
fn every_point_is_counted_once() {
    for (resolution, least) in [(None, 1.0), (Some(0.05), 1.2)] {
        let mut search = small();
        search.resolution = resolution;
        search.least_contact_ratio = least;
        search.limits.ripple = Some(0.12);
        search.limits.least_radius = Some(1.5);
        search.limits.size.width_over_diameter = 0.1..=1.0;
        search.requirements.size = Size::Modules(vec![Length::from_mm(1.0)]);
        let FormFound { designs, funnel } = search.front().unwrap();
        let motors: u64 = Reason::OF_SHAPES.iter().map(|&reason| funnel.motors_refused(reason)).sum();
        let refused: u64 = Reason::OF_POINTS.iter().map(|&refusal| funnel.refused(refusal)).sum();
        let points = motors * funnel.forms as u64 + refused + funnel.as_good + funnel.admissible;
        assert_eq!(funnel.points(), points, "{funnel:?}");
        assert_eq!(funnel.forms, search.forms.forms().unwrap().len());
        assert!(funnel.motors > 100 && funnel.admissible as usize >= designs.len(), "{funnel:?}");
        assert!(designs.iter().all(|design| design.contact_ratio >= least && design.ripple <= 0.12));
        assert!(designs.iter().all(|design| design.least_radius >= 1.5));
        for reason in [Reason::LeastRadius, Reason::Size] {
            assert!(funnel.motors_refused(reason) > 0, "{reason:?} {funnel:?}");
        }
    }
}

#[test]
fn the_answer_does_not_depend_on_the_number_of_threads() {
    let mut search = small();
    search.resolution = Some(0.02);
    let answer = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| search.front()).unwrap()
    };
    let one = answer(1);
    assert!(!one.designs.is_empty());
    assert_eq!(one, answer(3));
}

#[test]
fn a_search_tells_how_far_it_is_and_can_be_cancelled() {
    let search = small();
    let seen = std::sync::Mutex::new(Vec::new());
    search
        .front_watched(&|progress| {
            seen.lock().unwrap().push(progress);
            ControlFlow::Continue(())
        })
        .unwrap();
    let seen = seen.into_inner().unwrap();
    for pass in 0..2 {
        let of: Vec<&Progress> = seen.iter().filter(|progress| progress.pass == pass).collect();
        assert!(of[0].done == 0 && of.iter().any(|progress| progress.done == progress.of));
        assert_eq!(of.len(), of[0].of + 1);
    }
    for pass in 0..2 {
        for done in [0, 3] {
            let watch = |progress: Progress| {
                if progress.pass == pass && progress.done >= done {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            };
            assert_eq!(search.front_watched(&watch), Err(Error::Cancelled));
        }
    }
}

/// Every record agrees with the motor that it describes.
#[test]
fn the_records_are_those_of_the_motors() {
    let mut search = small();
    let (pressure, speed) = (Pressure::from_mpa(20.0), AngularVelocity::from_si(9.0));
    let mm = Length::from_mm;
    search.requirements = Requirements {
        speed: Some(speed),
        size: Size::Modules(vec![mm(1.5), mm(2.0)]),
        ..Requirements::of_torque(Torque::from_si(900.0), pressure).unwrap()
    };
    search.limits.size = SizeLimits { outer_diameter: Some(mm(160.0)), ..SizeLimits::default() };
    search.resolution = Some(0.1);
    let found = search.front().unwrap();
    assert!(found.designs.len() > 2);
    let near = |one: f64, other: f64| (one / other - 1.0).abs() < 1e-9;
    for design in &found.designs {
        assert!(!design.sizes.is_empty());
        for size in &design.sizes {
            let motor = design.motor(size.module).unwrap();
            assert_eq!(motor.arcs().is_some(), design.family == FamilyKind::TwoArcs);
            assert_eq!(motor.cosine_law().is_some(), design.family == FamilyKind::CosineLaw);
            assert_eq!(motor.harmonic_law().map(|law| law.second_amplitude), design.second_amplitude());
            let l = motor.arcs().map(|arcs| (arcs.trough_distance() / size.module).value);
            assert_eq!(l.is_some(), design.trough_distance_over_module().is_some());
            assert!(l.zip(design.trough_distance_over_module()).is_none_or(|(one, other)| near(one, other)));
            assert!(near(motor.envelope().displacement_by_volume, design.displacement_by_volume));
            assert!(near(motor.ripple().delta, design.ripple));
            assert!(near(motor.envelope().stator_outer.value, size.outer_diameter.value));
            assert!(size.outer_diameter <= mm(160.0));
            assert!(near(motor.displacement(size.width).unwrap().value, size.displacement.value));
            assert!(near((size.displacement / size.volume).value, design.displacement_by_volume));
            let torque = motor.theoretical_torque(size.width, pressure).unwrap().value;
            assert!(near(torque, 900.0) && near(torque, size.torque.unwrap().value));
            let least = (motor.ripple().least * size.width * pressure).value;
            assert!(near(least, size.least_torque.unwrap().value));
            assert!(near(motor.mean_flow(size.width, speed).unwrap().value, size.flow.unwrap().value));
            assert!(near(size.power.unwrap().value, torque * 9.0));
        }
    }
}

#[test]
fn orders_that_make_no_sense_are_refused() {
    let base = small();
    let refused = |change: &dyn Fn(&mut FormSearch)| {
        let mut search = base.clone();
        change(&mut search);
        let error = search.front().unwrap_err();
        format!("{}: {error}", error.name())
    };
    let degrees = Angle::from_degrees;
    let messages = [
        refused(&|search| search.families.clear()),
        refused(&|search| search.objectives.clear()),
        refused(&|search| search.objectives.push(Objective::RootStress)),
        refused(&|search| {
            search.flanks = Some(FlankOrder { contact_stress: Some(mpa(1e3)), ..FlankOrder::of(steel()) });
        }),
        refused(&|search| {
            search.flanks = Some(FlankOrder { root_stress: Some(mpa(-1.0)), ..FlankOrder::of(steel()) });
        }),
        refused(&|search| {
            search.flanks = Some(FlankOrder { allowed_pressure: Some(mpa(0.0)), ..FlankOrder::of(steel()) });
        }),
        refused(&|search| {
            search.flanks = Some(FlankOrder { least_torque: Some(1.2), ..FlankOrder::of(steel()) });
        }),
        refused(&|search| search.flanks = Some(FlankOrder { ripple: Some(0.0), ..FlankOrder::of(steel()) })),
        refused(&|search| {
            search.flanks = Some(FlankOrder::of(MaterialLimits { contact: mpa(0.0), ..steel() }));
        }),
        refused(&|search| search.forms.crests.clear()),
        refused(&|search| search.places = 2),
        refused(&|search| search.resolution = Some(0.0)),
        refused(&|search| search.least_contact_ratio = f64::NAN),
        refused(&|search| search.limits.least_radius = Some(-1.0)),
        refused(&|search| search.limits.ripple = Some(0.0)),
        refused(&|search| search.requirements.size = Size::Modules(Vec::new())),
        refused(&|search| {
            search.forms.pressure_angle = Steps { from: degrees(5.0), to: degrees(20.0), step: degrees(1.0) };
        }),
        refused(&|search| {
            search.forms.pressure_angle =
                Steps { from: degrees(25.0), to: degrees(20.0), step: degrees(1.0) };
        }),
        refused(&|search| search.forms.addendum = steps(0.7, 2.1, 0.1)),
        refused(&|search| search.forms.addendum = steps(0.7, 0.9, 0.0)),
        refused(&|search| search.forms.shift = steps(0.0, 0.9, f64::NAN)),
        refused(&|search| search.forms.clearance = steps(-0.1, 0.3, 0.1)),
        refused(&|search| search.forms.fillet = steps(0.0, f64::INFINITY, 0.1)),
        refused(&|search| search.forms.fillet = steps(0.0, 1.0, 1e-9)),
        refused(&|search| search.forms.clearance = steps(0.0, 1.0, 0.001)),
        refused(&|search| search.forms.base.backlash = 0.6),
        refused(&|search| search.forms.base.satellite_share = f64::NAN),
    ];
    insta::assert_snapshot!(messages.join("\n"));
}

#[test]
fn steps_reach_their_end_and_no_further() {
    let values = |from, to, step| steps(from, to, step).values(Quantity::Addendum, [0.0, 2.0], "").unwrap();
    assert_eq!(values(0.7, 1.0, 0.1).len(), 4);
    assert_eq!(values(0.7, 1.0, 0.2), [0.7, 0.7 + 0.2]);
    assert_eq!(values(0.7, 0.7, 0.0), [0.7]);
    let mut space = FormSpace::of(ToothForm::full_depth());
    assert_eq!(space.forms().unwrap(), [ToothForm::full_depth()]);
    space.crests = vec![Crest::Tooth, Crest::Space];
    let angles: Vec<f64> = space.forms().unwrap().iter().map(|form| form.pressure_angle.si()).collect();
    assert_eq!(angles.len(), 2);
}
