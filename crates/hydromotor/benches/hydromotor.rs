//! A closed motor from its numbers and a distance, with displacement and ripple; its tooth profiles and their
//! flanks under load; the search for designs on one core.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_hydromotor::centrode::Wheel;
use epicyclic_hydromotor::checks::Subject;
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::flanks::{LoadedPath, MaterialLimits, SealingContact, effective_modulus};
use epicyclic_hydromotor::numbers::Bounds;
use epicyclic_hydromotor::profile::limits::Limit;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::search::forms::{FamilyKind, FormSearch, Steps};
use epicyclic_hydromotor::search::{MotorSearch, Requirements, Size};
use epicyclic_hydromotor::{Motor, MotorNumbers};
use std::hint::black_box;
use uom::si::area::square_millimeter;
use uom::si::f64::{Length, Pressure, Torque};
use uom::si::length::{meter, millimeter};
use uom::si::{pressure::megapascal, torque::newton_meter};

fn closed_motor(c: &mut Criterion) {
    let mm = Length::new::<millimeter>;
    let numbers = MotorNumbers::new(5, 3, 55, 10).expect("admissible");
    let working = |l: Length| {
        let motor = Motor::of_two_arcs(numbers, mm(1.0), l).expect("within the family");
        (motor.displacement_per_width().get::<square_millimeter>(), motor.ripple().delta)
    };
    let (displacement, delta) = working(mm(40.0));
    assert!((displacement - 1412.9151).abs() < 5e-5 && (delta - 0.0764).abs() < 5e-5);
    c.bench_function("hydromotor/closed_motor", |b| b.iter(|| working(black_box(mm(40.0)))));
    c.bench_function("hydromotor/family", |b| b.iter(|| Family::new(black_box(numbers), mm(1.0))));
}

fn profiles(c: &mut Criterion) {
    let mm = Length::new::<millimeter>;
    let of = |n: (u32, u32, u32, u32)| {
        let numbers = MotorNumbers::new(n.0, n.1, n.2, n.3).expect("admissible");
        Motor::of_two_arcs(numbers, mm(1.0), mm(40.0)).expect("within the family")
    };
    // 10⁵ points, evenly among the teeth of all wheels.
    let outlines = |motor: &Motor| {
        let profile = Profile::new(motor, ToothForm::default()).expect("within the limits");
        let numbers = motor.numbers();
        let wheels = [
            (Wheel::Stator, numbers.stator_teeth()),
            (Wheel::Rotor, numbers.rotor_teeth()),
            (Wheel::Satellite, numbers.satellite_teeth()),
        ];
        let a_tooth = 100_000_u32.div_ceil(wheels.iter().map(|(_, teeth)| teeth).sum());
        wheels.map(|(wheel, teeth)| profile.outline(wheel, a_tooth * teeth).expect("in range"))
    };
    for (name, numbers) in [("5x3", (5, 3, 55, 10)), ("6x4", (6, 4, 66, 10))] {
        let motor = of(numbers);
        assert!(outlines(&motor).iter().map(|outline| outline.points.len()).sum::<usize>() >= 100_000);
        c.bench_function(&format!("hydromotor/profile/outlines_1e5/{name}"), |b| {
            b.iter(|| outlines(black_box(&motor)));
        });
    }
    let cosine = Motor::of_cosine_law(MotorNumbers::new(8, 6, 88, 10).expect("admissible"), mm(1.0));
    let cosine = cosine.expect("closes");
    c.bench_function("hydromotor/profile/outlines_1e5/cosine_8x6", |b| {
        b.iter(|| outlines(black_box(&cosine)));
    });
    let motor = of((5, 3, 55, 10));
    let profile = Profile::new(&motor, ToothForm::default()).expect("within the limits");
    assert!(profile.limits().iter().all(Limit::holds));
    c.bench_function("hydromotor/profile/limits", |b| b.iter(|| black_box(&profile).limits()));
    assert!(profile.clearances(120).expect("in range").free());
    let mut slow = c.benchmark_group("hydromotor/profile");
    slow.sample_size(10);
    slow.bench_function("clearances_120", |b| b.iter(|| black_box(&profile).clearances(120)));
    slow.finish();
}

/// Ripple at the flanks, forces and stresses of a motor whose teeth are known.
fn flanks(c: &mut Criterion) {
    let mm = Length::new::<millimeter>;
    let mpa = Pressure::new::<megapascal>;
    let numbers = MotorNumbers::new(6, 4, 66, 10).expect("admissible");
    let motor = Motor::of_two_arcs(numbers, mm(1.0), mm(40.0)).expect("within the family");
    let profile = Profile::new(&motor, ToothForm::default()).expect("within the limits");
    let modulus = effective_modulus([mpa(206e3); 2], [0.3; 2]).expect("sound");
    let limits = MaterialLimits { contact: mpa(1500.0), root: mpa(400.0), modulus };
    let ripple = |profile: &Profile| profile.flank_ripple(SealingContact::Nearest);
    let forces = |profile: &Profile| {
        let alpha = profile.form().pressure_angle;
        let greatest = profile.motor().greatest_flank_forces(alpha, mm(10.0), mpa(20.0)).expect("held");
        let bearing = profile.motor().greatest_bearing_load(alpha, mm(10.0), mpa(20.0)).expect("held");
        let third = profile.third_contact_bounds(SealingContact::Nearest, mm(10.0), mpa(20.0)).expect("held");
        (greatest, bearing, third)
    };
    let stresses = |profile: &Profile| {
        let contact = profile.contact_stresses(mpa(20.0), modulus).expect("held");
        (contact, profile.root_stresses(LoadedPath::Whole, mpa(20.0)).expect("held"))
    };
    let all = |profile: &Profile| (ripple(profile), forces(profile), stresses(profile));
    assert!((ripple(&profile).at_flanks.delta - 0.0780).abs() < 5e-5 && stresses(&profile).1.len() == 3);
    c.bench_function("hydromotor/flanks/ripple", |b| b.iter(|| ripple(black_box(&profile))));
    c.bench_function("hydromotor/flanks/forces", |b| b.iter(|| forces(black_box(&profile))));
    c.bench_function("hydromotor/flanks/stresses", |b| b.iter(|| stresses(black_box(&profile))));
    c.bench_function("hydromotor/flanks/all", |b| b.iter(|| all(black_box(&profile))));
    c.bench_function("hydromotor/flanks/allowed_pressure", |b| {
        b.iter(|| black_box(&profile).allowed_pressure(LoadedPath::Whole, &limits).expect("held"));
    });
}

/// The requirements of the benches: 900 N·m at 20 MPa.
fn order() -> MotorSearch {
    let pressure = Pressure::new::<megapascal>(20.0);
    let requirements =
        Requirements::of_torque(Torque::new::<newton_meter>(900.0), pressure).expect("positive");
    MotorSearch::new(requirements)
}

fn search(c: &mut Criterion) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    let found = |search: &MotorSearch| pool.install(|| search.front()).expect("sound");
    let mut group = c.benchmark_group("hydromotor/search");
    group.sample_size(10);
    // Every set with N ≤ 10, Z_3 ≤ 120, Z_s ≥ 8, refined to 2 %; and the evenly spaced places alone.
    let all = order();
    let places = MotorSearch { resolution: None, ..all.clone() };
    let answer = found(&all);
    assert!(answer.funnel.sets == 3061 && answer.funnel.points > 16 * 2800);
    let error = answer.spacing_error;
    assert!(error.displacement_by_volume.max(error.ripple).max(error.least_radius) <= 0.02);
    group.bench_function("all", |b| b.iter(|| found(black_box(&all))));
    group.bench_function("all_places_only", |b| b.iter(|| found(black_box(&places))));
    // On few numbers beside the plain way: each motor by itself with all its checks, each held against each.
    let mut few = places;
    few.bounds = Bounds { stator_lobes: 4..=6, stator_teeth: 40..=66, satellite_teeth: 8..=60 };
    few.requirements.size = Size::WidthOverDiameter(0.5);
    // The plain way asks neither teeth nor ports.
    few.made = false;
    assert_eq!(found(&few).designs.len(), trial(&few));
    group.bench_function("few_places_only", |b| b.iter(|| found(black_box(&few))));
    group.bench_function("few_by_trial", |b| b.iter(|| trial(black_box(&few))));
    group.finish();
}

/// The number of motors that no other dominates, the plain way.
fn trial(search: &MotorSearch) -> usize {
    let module = Length::new::<meter>(1.0);
    let mut motors = Vec::new();
    for numbers in search.bounds.all().expect("sound") {
        let Ok(family) = Family::new(numbers, module) else { continue };
        for interval in family.intervals() {
            let [from, to] = [interval.lower, interval.upper]
                .map(|end| end.arcs().map_or(0.0, |arcs| arcs.trough_distance().get::<meter>().recip()));
            for i in 0..16 {
                let part = (f64::from(i) / 15.0).clamp(1e-6, 1.0 - 1e-6);
                let l = module / (from + (to - from) * part);
                // Within the family a rotor may still reach into the stator.
                let Ok(motor) = Motor::of_two_arcs(numbers, module, l) else { continue };
                let checks = motor.checks(search.heights).expect("sound");
                if checks.iter().any(|check| !check.holds()) {
                    continue;
                }
                let radii = checks.iter().filter(|check| {
                    !matches!(check.subject, Subject::RotorLeastRadius | Subject::Neighbours)
                });
                let least = radii.map(|check| check.value.get::<meter>()).fold(f64::INFINITY, f64::min);
                motors.push([motor.envelope().displacement_by_volume, -motor.ripple().delta, least]);
            }
        }
    }
    let dominates = |one: &[f64; 3], other: &[f64; 3]| (0..3).all(|i| one[i] >= other[i]) && one != other;
    motors.iter().filter(|one| !motors.iter().any(|other| dominates(other, one))).count()
}

/// The search with the tooth form free: all numbers, three families, 350 forms, on all cores.
fn forms(c: &mut Criterion) {
    let mut search = FormSearch::new(order().requirements);
    // As a test it runs once and unoptimised: fewer forms do.
    let is_measured = std::env::args().any(|arg| arg == "--bench");
    if !is_measured {
        search.forms.addendum = Steps { from: 0.9, to: 0.9, step: 0.05 };
    }
    let found = search.front().expect("sound");
    assert!(
        found.funnel.points() > if is_measured { 10_000_000 } else { 1_000_000 } && found.designs.len() > 20
    );
    let mut group = c.benchmark_group("hydromotor/forms");
    group.sample_size(10);
    group.bench_function("all", |b| b.iter(|| black_box(&search).front()));
    // Few motors of two arcs and few forms beside the plain way: every profile with all its limits.
    let mut few = search;
    few.bounds = Bounds { stator_lobes: 6..=6, stator_teeth: 66..=66, satellite_teeth: 9..=10 };
    few.families = vec![FamilyKind::TwoArcs];
    few.forms.addendum = Steps { from: 0.8, to: 0.85, step: 0.05 };
    (few.places, few.resolution) = (6, None);
    assert!(few.front().expect("sound").funnel.admissible > 0 && admissible(&few) > 0);
    group.bench_function("few", |b| b.iter(|| black_box(&few).front()));
    group.bench_function("few_by_trial", |b| b.iter(|| admissible(black_box(&few))));
    group.finish();
}

/// Number of admissible points, by trial of every point.
fn admissible(search: &FormSearch) -> usize {
    let module = Length::new::<meter>(1.0);
    let forms = search.forms.forms().expect("sound");
    let mut count = 0;
    for numbers in search.bounds.all().expect("sound") {
        let Ok(family) = Family::new(numbers, module) else { continue };
        for i in 0..search.places {
            let part = (f64::from(i) / f64::from(search.places - 1)).clamp(1e-6, 1.0 - 1e-6);
            let l = family.at_part(part).expect("within the family").trough_distance();
            let Ok(motor) = Motor::of_two_arcs(numbers, module, l) else { continue };
            let profiles = forms.iter().filter_map(|&form| Profile::new(&motor, form).ok());
            count += profiles.filter(|profile| profile.limits().iter().all(Limit::holds)).count();
        }
    }
    count
}

criterion_group!(benches, closed_motor, profiles, flanks, search, forms);
criterion_main!(benches);
