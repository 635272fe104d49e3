//! Checks of the records by independent calculations.

use super::parts::Scenario;
use super::*;
use epicyclic_formats::scenario;

pub(super) fn document(text: &str) -> Document {
    Document::parse_one("scenario.yaml", text.as_bytes()).unwrap()
}

pub(super) fn simulated(text: &str) -> Simulation {
    let document = document(text);
    answer(&document, &scenario::read(&document).unwrap(), &Beside::default()).unwrap()
}

pub(super) fn close(found: f64, due: f64, relative: f64) {
    assert!((found - due).abs() <= relative * due.abs(), "found {found:e}, due {due:e}");
}

/// Brake that slips at a constant 50 rad/s with 30 N·m: the torques of motor, load and brake are as 1 : −4 :
/// 3.
const STEADY: &str = "\
scenario: steady
gearbox: { gearbox: g, input: s, output: c, sets: [{ id: P, sun: s, ring: r, carrier: c, k: 3 }], brakes: [{ id: B, link: r }] }
inertias: { s: 0.1 kg·m², r: 0.2 kg·m², c: 0.3 kg·m² }
start: { speeds: { s: 100 rad/s, r: -50 rad/s } }
duration: 40 s
torques: [{ id: motor, link: s, constant: 10 N·m }, { id: load, link: c, constant: -40 N·m }]
elements: [{ id: B, capacity: { times: [0 s], torques: [30 N·m] }, friction_area: 500 mm², heat_capacity: 1 kJ/K }]
";

#[test]
fn an_adiabatic_element_warms_by_its_heat_over_its_heat_capacity() {
    let found = simulated(STEADY);
    let [brake] = &found.elements[..] else { panic!("{:?}", found.elements) };
    close(brake.heat_j, 1500.0 * 40.0, 1e-12);
    close(brake.peak_power_w, 1500.0, 1e-12);
    close(brake.slip_time_s, 40.0, 1e-12);
    close(brake.peak_temperature_rise_k.unwrap(), brake.heat_j / 1000.0, 1e-12);
    close(brake.heat_per_area_j_m2.unwrap(), 60_000.0 / 500e-6, 1e-12);
    close(brake.peak_power_per_area_w_m2.unwrap(), 1500.0 / 500e-6, 1e-12);
}

#[test]
fn a_motion_that_is_ended_has_all_up_to_there() {
    let document = document(SHIFT);
    let file = scenario::read(&document).unwrap();
    let whole = simulated(SHIFT);
    let ended = |share: f64| {
        let mut last = -1.0;
        answer_watched(&document, &file, &Beside::default(), |done| {
            assert!(done >= last && done <= 1.0, "{done} after {last}");
            last = done;
            if done < share { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })
        .unwrap()
    };
    assert_eq!(ended(2.0), whole);
    let early = ended(0.5);
    assert!(early.duration_s >= 0.5 * whole.duration_s && early.duration_s < whole.duration_s);
    let before = whole.events.iter().take_while(|event| event.time_s < early.duration_s);
    let before: Vec<&EventRecord> = before.collect();
    assert!(!before.is_empty() && before.len() <= early.events.len());
    assert!(std::iter::zip(&early.events, before).all(|(one, other)| one == other));
    assert!(early.energies.residual.abs() < 1e-9);
    let names = |of: &Simulation| of.warnings.iter().any(|warning| warning.name == "ended-early");
    assert!(names(&early) && !names(&whole));
    // A motion that is stopped immediately has only the start.
    assert_eq!(ended(0.0).duration_s, 0.0);
}

#[test]
fn few_samples_leave_the_peaks() {
    let found = simulated(&STEADY.replace("duration: 40 s", "duration: 40 s\nsample_every: 1000 s"));
    assert_eq!(found.samples.times_s, [0.0, 40.0]);
    close(found.elements[0].peak_temperature_rise_k.unwrap(), 60.0, 1e-12);
    let shift = SHIFT.replace("duration: 1 s", "duration: 1 s\nsample_every: 9 s");
    let (few, many) = (simulated(&shift), simulated(SHIFT));
    for (few, many) in few.elements.iter().zip(&many.elements) {
        assert!((few.peak_power_w - many.peak_power_w).abs() <= 1e-9 * many.peak_power_w, "{few:?} {many:?}");
    }
}

#[test]
fn an_element_in_oil_nears_its_power_over_the_conductance() {
    let found =
        simulated(&STEADY.replace("heat_capacity: 1 kJ/K", "heat_capacity: 1 kJ/K, conductance: 25 W/K"));
    let rise = |t: f64| 60.0 * (1.0 - libm::exp(-0.025 * t));
    close(found.elements[0].end_temperature_rise_k.unwrap(), rise(40.0), 1e-11);
    let element = &found.samples.elements[0];
    let rises = element.temperature_rises_k.as_ref().unwrap();
    assert_eq!(rises.len(), found.samples.times_s.len());
    for (time, found) in found.samples.times_s.iter().zip(rises).skip(1) {
        close(*found, rise(*time), 1e-10);
    }
}

/// Shift between two gears, from the ring brake to the clutch, with sufficient capacity.
const SHIFT: &str = "\
scenario: shift
gearbox:
  gearbox: g
  input: s
  output: c
  sets: [{ id: P, sun: s, ring: r, carrier: c, k: 3 }]
  brakes: [{ id: B, link: r }]
  clutches: [{ id: C, links: [s, r] }]
  gears: [{ name: low, engaged: [B] }, { name: high, engaged: [C] }]
inertias: { s: 0.1 kg·m², r: 0.02 kg·m², c: 3 kg·m² }
gear: low
start: { input_speed: 200 rad/s }
duration: 1 s
torques: [{ id: motor, link: s, constant: 60 N·m }, { id: load, link: c, resistance: 100 N·m }]
elements: [{ id: B, holding: 400 N·m }, { id: C, holding: 150 N·m }]
shifts: [{ at: 0.2 s, to: high, release: 0.1 s, apply: 0.3 s, overlap: 0.06 s }]
";

#[test]
fn ramps_are_where_the_shift_says() {
    for (overlap, release, apply) in [
        ("0.06 s", [0.2, 0.3], [0.24, 0.54]),
        ("0.18 s", [0.28, 0.38], [0.2, 0.5]),
        ("-0.05 s", [0.2, 0.3], [0.35, 0.65]),
    ] {
        let found = simulated(&SHIFT.replace("overlap: 0.06 s", &format!("overlap: {overlap}")));
        let (times, elements) = (&found.samples.times_s, &found.samples.elements);
        let of =
            |id: &str| elements.iter().find(|one| one.id == id).unwrap().capacities_n_m.as_ref().unwrap();
        for (place, &t) in times.iter().enumerate() {
            let part = |[from, to]: [f64; 2]| ((t - from) / (to - from)).clamp(0.0, 1.0);
            assert!((of("B")[place] - 400.0 * (1.0 - part(release))).abs() < 1e-9, "{overlap} {t}");
            assert!((of("C")[place] - 150.0 * part(apply)).abs() < 1e-9, "{overlap} {t}");
        }
    }
}

#[test]
fn the_phases_of_a_shift_are_the_times_of_its_events() {
    let found = simulated(SHIFT);
    let time = |id: &str, from: State, to: State| {
        let is = |one: &ChangeRecord| one.id == id && one.from == Some(from) && one.to == Some(to);
        let event = found.events.iter().find(|event| event.changes.iter().any(is));
        event.unwrap_or_else(|| panic!("{id}: {:?}", found.events)).time_s
    };
    let carries = time("C", State::Open, State::SlipsForward);
    close(carries, 0.24, 1e-12);
    let lock = time("C", State::SlipsForward, State::Holds);
    let gone = found
        .events
        .iter()
        .find(|event| event.changes.iter().any(|one| one.id == "B" && one.from == Some(State::Holds)));
    let gone = gone.unwrap().time_s;
    let [shift] = &found.shifts[..] else { panic!("{:?}", found.shifts) };
    assert_eq!((shift.released.join(","), shift.applied.join(",")), ("B".to_owned(), "C".to_owned()));
    close(shift.shift_time_s.unwrap(), lock - 0.2, 1e-12);
    close(shift.inertia_phase_s.unwrap(), lock - gone, 1e-12);
    close(shift.torque_phase_s.unwrap(), gone - carries, 1e-12);
    let heat: f64 = found.elements.iter().map(|one| one.heat_j).sum();
    let resisting = found.samples.elements.iter().find(|one| one.id == "load").unwrap();
    assert!(shift.heat_j < heat && shift.heat_j > heat - resisting.heats_j.last().unwrap());
    assert!(shift.torque_hole.unwrap() > 0.0 && shift.torque_surge.unwrap() >= 0.0);
}

/// The output torque computed from the acceleration equals that of the set's carrier.
#[test]
fn the_torque_of_the_output_is_what_its_set_gives() {
    let document = document(SHIFT);
    let file = scenario::read(&document).unwrap();
    let subject = *gearbox::gearbox(&document, root("gearbox"), None).unwrap();
    let texts = Texts::new();
    let scenario = Scenario { document: &document, file: &file, subject: &subject, texts: &texts };
    let built = scenario.built().unwrap();
    let run = built.model.run(&built.start, Time::from_si(1.0), Some(Time::from_si(1e-3))).unwrap();
    for sample in run.samples.iter().chain(run.events.iter().flat_map(|event| [&event.before, &event.after]))
    {
        let given = -sample.sets[0][2].si();
        assert!(
            (built.output.torque(sample) - given).abs() < 1e-9,
            "{} {given}",
            built.output.torque(sample)
        );
    }
    // In first gear (60 − 100/4) N·m act on 0.1 + 3/16 kg·m²; the sun's torque minus its inertia torque
    // reaches the output fourfold.
    let first = 4.0 * (60.0 - 0.1 * 35.0 / 0.2875);
    close(built.output.torque(&run.samples[0]), first, 1e-12);
}

#[test]
fn a_capacity_follows_its_pressure() {
    let pressure = "pressure: { times: [0.1 s, 0.2 s, 0.6 s], pressures: [0 bar, 3 bar, 5 bar], fill_time: 0.3 s, kiss_point: 1 bar, \
                    piston_area: 40 cm², mean_radius: 60 mm, surfaces: 4, coefficient: 0.11 }";
    for fill in [0.0, 0.02, 0.3] {
        let pressure = pressure.replace("0.3 s, kiss", &format!("{fill} s, kiss"));
        let found = simulated(
            &STEADY
                .replace("40 s", "1 s")
                .replace("capacity: { times: [0 s], torques: [30 N·m] }", &pressure),
        );
        let capacities = found.samples.elements[0].capacities_n_m.as_ref().unwrap();
        let mut above = 0;
        for (&t, &found) in found.samples.times_s.iter().zip(capacities) {
            let bar = if t < 0.2 { 30.0 * (t - 0.1) } else { (3.0 + 5.0 * (t - 0.2)).min(5.0) };
            let due = 0.11 * 4.0 * 0.06 * 40e-4 * 1e5 * (bar - 1.0).max(0.0);
            // At the jump itself, the value before and the value after are both correct.
            if (t - 0.1 - fill).abs() > 1e-9 {
                let due = if t < 0.1 + fill { 0.0 } else { due };
                assert!((found - due).abs() < 1e-9, "{fill} {t}: {found} {due}");
                above += usize::from(due > 0.0);
            }
        }
        assert!(above > 100);
    }
}

#[test]
fn a_sweep_is_its_single_runs() {
    let document = document(SHIFT);
    let range = "shifts[0].overlap=0ms..80ms".parse().unwrap();
    let found =
        sweep::sweep(&document, &Beside::default(), &range, 3, |_| ControlFlow::Continue(())).unwrap();
    assert_eq!(found.runs.iter().map(|run| run.value).collect::<Vec<_>>(), [0.0, 40.0, 80.0]);
    for run in &found.runs {
        let one = simulated(&SHIFT.replace("overlap: 0.06 s", &format!("overlap: {} ms", run.value)));
        assert_eq!((&run.shifts, &run.elements, &run.end), (&one.shifts, &one.elements, &one.end));
    }
    let by_name = "elements[C].holding=-1 N·m..150 N·m".parse().unwrap();
    let found =
        sweep::sweep(&document, &Beside::default(), &by_name, 2, |_| ControlFlow::Continue(())).unwrap();
    assert!(found.runs[0].refused.is_some() && found.runs[1].refused.is_none());
    assert_eq!(found.warnings[0].name, "refused");
    let stopped = sweep::sweep(&document, &Beside::default(), &range, 3, |_| ControlFlow::Break(())).unwrap();
    assert!(stopped.runs.is_empty() && stopped.warnings[0].name == "interrupted");
}

fn refused_as(text: &str) -> String {
    let document = document(text);
    answer(&document, &scenario::read(&document).unwrap(), &Beside::default()).unwrap_err().to_string()
}

/// Set locked as one piece of 1 kg·m², with a body of 0.5 kg·m² on its output shaft.
const TWO_MASSES: &str = "\
scenario: two masses
gearbox: { gearbox: g, input: s, output: c, sets: [{ id: P, sun: s, ring: r, carrier: c, k: 3 }], clutches: [{ id: C, links: [s, c] }] }
inertias: { s: 0.1 kg·m², r: 0.2 kg·m², c: 0.7 kg·m² }
bodies: { wheel: 0.5 kg·m² }
engaged: [C]
duration: 1 s
sample_every: 1 ms
shafts: [{ id: axle, links: [c, wheel], stiffness: 3000 N·m/rad, twist: 2 deg }]
";

/// Natural frequency `f = √(c·(1/J₁ + 1/J₂))/2π`, with all energy in the shaft at the start. The ring's share
/// of the torque reaches the output through the set.
#[test]
fn two_masses_swing_at_their_natural_frequency() {
    let found = simulated(TWO_MASSES);
    let [axle] = &found.samples.shafts[..] else { panic!("{:?}", found.samples.shafts) };
    let (omega, twist) = ((3000.0_f64 * (1.0 + 2.0)).sqrt(), 2.0_f64.to_radians());
    for ((t, torque), by) in
        found.samples.times_s.iter().zip(&axle.torques_n_m).zip(&found.samples.output_torques_n_m)
    {
        assert!((torque - 3000.0 * twist * libm::cos(omega * t)).abs() < 1e-5, "{t}");
        assert!((0.2 * torque - by).abs() < 1e-9, "through the set comes what the ring gives: {torque} {by}");
    }
    close(found.shafts[0].peak_torque_n_m, 3000.0 * twist, 1e-12);
    close(found.energies.elastic_before_j, 1500.0 * twist * twist, 1e-12);
    assert!(found.energies.residual.abs() < 1e-9);
    let damped = simulated(&TWO_MASSES.replace("twist:", "damping: { torque: 20 N·m, at: 1 rad/s }, twist:"));
    close(damped.shafts[0].heat_j, damped.energies.damping_heat_j, 1e-15);
    close(
        damped.energies.damping_heat_j + damped.energies.elastic_after_j + damped.energies.kinetic_after_j,
        found.energies.elastic_before_j,
        1e-9,
    );
}

#[test]
fn a_body_at_the_start_turns_with_its_shaft() {
    let text = TWO_MASSES.replace("duration:", "gear: one\nstart: { input_speed: 50 rad/s }\nduration:");
    let text = text
        .replace("clutches:", "gears: [{ name: one, engaged: [C] }], clutches:")
        .replace(", twist: 2 deg", "");
    let found = simulated(&text);
    assert!(found.end.iter().all(|link| (link.speed_rad_s - 50.0).abs() < 1e-12), "{:?}", found.end);
    close(found.energies.kinetic_before_j, 0.5 * 1.5 * 2500.0, 1e-12);
}

/// Backlash: nothing moves the wheel before the shaft has turned through half its backlash.
#[test]
fn a_shaft_with_backlash_drives_when_it_is_used_up() {
    let text = TWO_MASSES.replace("twist: 2 deg", "backlash: 4 deg")
        + "torques: [{ id: motor, link: s, constant: 5 N·m }]\n";
    let found = simulated(&text);
    let first = &found.events[0];
    assert_eq!(
        (first.changes[0].kind, first.changes[0].from, first.changes[0].to),
        (ChangeKind::Shaft, Some(State::Open), Some(State::DrivesForward))
    );
    // φ = ½·(M/J)·t² = 2 deg.
    close(first.time_s, (2.0 * 2.0_f64.to_radians() / 5.0).sqrt(), 1e-9);
}

/// Stalled turbine: the impeller runs at its steady speed `√(T/λ)`, and all power becomes heat.
#[test]
fn a_stalled_converter_takes_torque_with_the_square_of_the_speed() {
    let text = "\
scenario: stall
gearbox: { gearbox: g, input: s, output: c, sets: [{ id: P, sun: s, ring: r, carrier: c, k: 3 }], brakes: [{ id: B, link: r }] }
inertias: { s: 0.1 kg·m², c: 0.7 kg·m² }
bodies: { engine: 0.2 kg·m² }
engaged: [B]
duration: 2 s
start: { speeds: { s: 0 rpm, engine: 2000 rpm } }
torques: [{ id: engine torque, link: engine, constant: 80 N·m }, { id: brake, link: c, resistance: 5000 N·m }]
converters: [{ id: TC, links: [engine, s], speed_ratios: [0, 1], torque_ratios: [2, 1], impeller_torques: [80 N·m, 0 N·m], impeller_speed: 2000 rpm }]
";
    let found = simulated(text);
    let [converter] = &found.converters[..] else { panic!("{:?}", found.converters) };
    let speed = 2000.0 * std::f64::consts::PI / 30.0;
    close(converter.end_torque_n_m, 160.0, 1e-9);
    close(converter.heat_j, 80.0 * speed * 2.0, 1e-9);
    close(converter.peak_heat_flow_w, 80.0 * speed, 1e-9);
    close(found.energies.converter_heat_j, converter.heat_j, 1e-15);
    assert_eq!(converter.end_speed_ratio, Some(0.0));
    close(found.samples.converters[0].impeller_torques_n_m[0], 80.0, 1e-9);
    // The carrier receives four times the turbine's torque through the set.
    close(found.samples.output_torques_n_m[5], 4.0 * 160.0, 1e-9);
    let message = refused_as(&text.replace("torque_ratios: [2, 1]", "torque_ratios: [2]"));
    assert!(message.contains("converters[0].torque_ratios: 1 values at 2 speed_ratios"), "{message}");
    let message = refused_as(&text.replace("impeller_speed: 2000 rpm", "impeller_speed: 0 rpm"));
    assert!(message.contains("converters[0].impeller_speed: it must be above 0"), "{message}");
}

/// Two free bodies engaged by dogs lose the energy `½·J₁·J₂/(J₁ + J₂)·Δω²`.
#[test]
fn dogs_take_the_energy_of_an_impact() {
    let text = "\
scenario: dogs
gearbox: { gearbox: g, input: s, output: c, sets: [{ id: P, sun: s, ring: r, carrier: c, k: 3 }], clutches: [{ id: C, links: [s, c] }, { id: D, links: [c, x] }], links: [x] }
inertias: { s: 0.1 kg·m², r: 0.2 kg·m², c: 0.7 kg·m², x: 0.5 kg·m² }
engaged: [C]
duration: 1 s
start: { speeds: { s: 30 rad/s, x: 10 rad/s } }
elements: [{ id: D, dog: { engage: [0.25 s], release: [0.75 s] } }]
";
    let found = simulated(text);
    close(found.energies.impact_j, 0.5 * (1.0 * 0.5 / 1.5) * 400.0, 1e-12);
    close(found.end[0].speed_rad_s, (30.0 + 5.0) / 1.5, 1e-12);
    let times: Vec<f64> = found.events.iter().map(|event| event.time_s).collect();
    assert_eq!(times, [0.25, 0.75]);
    assert_eq!(found.elements[0].kind, ElementKind::DogClutch);
    let never = simulated(&text.replace("release: [0.75 s]", "largest_slip: 5 rad/s"));
    assert_eq!((never.events.len(), never.energies.impact_j), (0, 0.0));
    let message = refused_as(&text.replace("dog:", "static_ratio: 1.1, dog:"));
    assert!(message.contains("elements[0].static_ratio: a dog clutch has no friction"), "{message}");
    let message = refused_as(&text.replace("dog:", "holding: 5 N·m, dog:"));
    assert!(message.contains("needs the gear at the start"), "{message}");
}

/// At constant power above the base speed the kinetic energy grows by `P·t`; below it the torque limit
/// applies.
#[test]
fn a_source_of_constant_power_gives_it() {
    let text = TWO_MASSES
        .replace("shafts: [{ id: axle, links: [c, wheel], stiffness: 3000 N·m/rad, twist: 2 deg }]\n", "")
        .replace("bodies: { wheel: 0.5 kg·m² }\n", "")
        + "start: { speeds: { s: 20 rad/s } }\ntorques: [{ id: motor, link: s, constant_power: { power: 2 kW, limit: 100 N·m } }]\n";
    let found = simulated(&text);
    close(found.energies.work_j, 2000.0, 1e-9);
    let slow = simulated(&text.replace("20 rad/s", "10 rad/s").replace("duration: 1 s", "duration: 0.1 s"));
    // 100 rad/s² from 10 rad/s to the base speed of 20 rad/s.
    close(slow.end[0].speed_rad_s, 20.0, 1e-9);
}

/// Half throttle between −10 and 30 N·m gives 10 N·m; the throttle opens within the time.
#[test]
fn a_throttle_lies_between_its_curves() {
    let text = TWO_MASSES
        .replace("shafts: [{ id: axle, links: [c, wheel], stiffness: 3000 N·m/rad, twist: 2 deg }]\n", "")
        .replace("bodies: { wheel: 0.5 kg·m² }\n", "")
        + "torques: [{ id: engine, link: s, throttle: { closed: { speeds: [0 rpm], torques: [-10 N·m] }, full: { speeds: [0 rpm], torques: [30 N·m] }, times: [0 s, 1 s], openings: [0.25, 0.75] } }]\n";
    let found = simulated(&text);
    close(found.end[0].speed_rad_s, 10.0, 1e-9);
    let message = refused_as(&text.replace("openings: [0.25, 0.75]", "openings: [0.25]"));
    assert!(message.contains("torques[0].throttle: 2 times and 1 openings"), "{message}");
    let message = refused_as(&text.replace("[0.25, 0.75]", "[0.25, 1.75]"));
    assert!(message.contains("throttle"), "{message}");
}

/// The steady brake slips at 50 rad/s. Halfway between 1 at rest and 0.5 at 100 rad/s, a capacity of 40 N·m
/// becomes 30 N·m.
#[test]
fn friction_over_slip_is_what_a_brake_carries() {
    let text = STEADY.replace(
        "torques: [30 N·m] }",
        "torques: [40 N·m] }, friction_over_slip: { speeds: [0 rad/s, 100 rad/s], factors: [1, 0.5] }",
    );
    let found = simulated(&text.replace("duration: 40 s", "duration: 1 s"));
    close(found.samples.elements[0].capacities_n_m.as_ref().unwrap()[0], 30.0, 1e-12);
    close(found.elements[0].heat_j, 1500.0, 1e-9);
    let message = refused_as(&text.replace("factors: [1, 0.5]", "factors: [1]"));
    assert!(message.contains("elements[0].friction_over_slip: 2 speeds and 1 factors"), "{message}");
}

/// Names occur in several places, and every entry has a line of its own.
const PLACES: &str = "\
scenario: B
gearbox:
  gearbox: engine
  input: s
  output: c
  sets:
    - { id: P, sun: s, ring: r, carrier: c, k: 3 }
  brakes:
    - { id: B, link: r }
  gears:
    - { name: one, engaged: [B] }
inertias:
  s: 0.1 kg·m²
  r: 0.2 kg·m²
  c: 0.3 kg·m²
gear: one
duration: 0.1 s
start: { speeds: { s: 40 rad/s, c: 10 rad/s } }
torques:
  - { id: motor, link: s, constant: 10 N·m }
  - id: engine
    link: c
    over_speed:
      speeds:
        - 0 rpm
        - 10 rpm
      torques: [1 N·m, 2 N·m]
elements:
  - { id: B, holding: 100 N·m }
";

#[test]
fn a_fault_of_a_scenario_is_at_its_value_and_has_a_name() {
    simulated(PLACES);
    for (from, to, place, name) in [
        ("s: 0.1 kg·m²", "s: -0.1 kg·m²", "13:6: inertias.s", "value"),
        ("  c: 0.3 kg·m²", "  zz: 0.3 kg·m²", "15:7: inertias.zz", "unknown"),
        ("  s: 0.1 kg·m²\n  r: 0.2 kg·m²\n  c: 0.3 kg·m²\n", "  s: 0 kg·m²\n", "13:", "no-inertia"),
        ("gear: one", "gear: zz", "16:7: gear", "unknown"),
        ("duration: 0.1 s", "duration: 0 s", "17:11: duration", "not-positive"),
        ("s: 40 rad/s, c: 10 rad/s", "c: 10 rad/s, s: 40 rad/s, r: 7 rad/s", "18:", "initial-speeds"),
        ("s: 40 rad/s, c: 10 rad/s", "c: 10 rad/s", "18:", "initial-open"),
        ("id: engine\n", "id: motor\n", "21:9: torques[1].id", "duplicate"),
        ("    link: c", "    link: zz", "22:11: torques[1].link", "unknown"),
        ("        - 10 rpm", "        - 0 rpm", "26:11: torques[1].over_speed.speeds[1]", "order"),
        ("[1 N·m, 2 N·m]", "[1 N·m]", "24:7: torques[1].over_speed", "table"),
        ("{ id: B, holding", "{ id: zz, holding", "29:11: elements[0].id", "no-shift-element"),
        ("holding: 100 N·m", "holding: -100 N·m", "29:", "value"),
        (
            "holding: 100 N·m",
            "holding: 100 N·m, capacity: { times: [0 s], torques: [1 N·m] }",
            "29:5: elements[0]",
            "one-capacity",
        ),
        ("elements:\n  - { id: B, holding: 100 N·m }", "engaged: [B, zz]", "28:14: engaged[1]", "unknown"),
        ("k: 3", "k: 0.3", "7:48: gearbox.sets[0].k", "ring-to-sun-ratio"),
    ] {
        assert_eq!(PLACES.matches(from).count(), 1, "{from}");
        let text = PLACES.replace(from, to);
        let document = document(&text);
        let file = scenario::read(&document).unwrap();
        let error = answer(&document, &file, &Beside::default()).unwrap_err();
        assert!(error.to_string().starts_with(&format!("scenario.yaml:{place}")), "{to}: {error}");
        assert_eq!(error.name(), name, "{error}");
    }
}

/// Faults that belong to no single line are reported at a part that they name, in the scenario or in the
/// gearbox, and never at the first line.
#[test]
fn a_motion_that_cannot_go_on_is_at_a_part_of_it() {
    let document = document(PLACES);
    let file = scenario::read(&document).unwrap();
    let subject = crate::shared::gearbox::gearbox(&document, Path::root().key("gearbox"), None).unwrap();
    let texts = scenario::Texts::default();
    let scenario = Scenario { document: &document, file: &file, subject: &subject, texts: &texts };
    let (time_s, names) = (0.0, |all: &[&str]| all.iter().map(|one| (*one).to_owned()).collect::<Vec<_>>());
    for (why, place) in [
        (
            motion::Error::NoMotion {
                time_s,
                parts: names(&["P", "B"]),
                links: vec![],
                violation: Some(1.0),
            },
            "29:5: elements[0]",
        ),
        (
            motion::Error::NoMotion { time_s, parts: names(&["P"]), links: vec![], violation: Some(1.0) },
            "7:7: gearbox.sets[0]",
        ),
        (
            motion::Error::Accumulating {
                time_s,
                events: 9,
                within_s: 1e-9,
                parts: names(&["motor"]),
                links: vec![],
            },
            "20:5: torques[0]",
        ),
        (
            motion::Error::NotUnique { sets: names(&["P"]), least: -1.0, greatest: 1.0 },
            "7:7: gearbox.sets[0]",
        ),
        (motion::Error::StepTooShort { time_s, step_s: 1e-20 }, "17:11: duration"),
        (motion::Error::NoFreedom, "3:3: gearbox"),
        (motion::Error::TooManyMeshes { given: 99, most: 9 }, "3:3: gearbox"),
    ] {
        let told = scenario.of_run(why).to_string();
        assert!(told.starts_with(&format!("scenario.yaml:{place}: ")), "{told}");
    }
}
