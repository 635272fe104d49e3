//! What the records say, by other ways.

use super::parts::Scenario;
use super::*;
use epicyclic_formats::scenario;

fn document(text: &str) -> Document {
    Document::parse_one("scenario.yaml", text.as_bytes()).unwrap()
}

fn simulated(text: &str) -> Simulation {
    let document = document(text);
    answer(&document, &scenario::read(&document).unwrap(), &Beside::default()).unwrap()
}

fn close(found: f64, due: f64, relative: f64) {
    assert!((found - due).abs() <= relative * due.abs(), "found {found:e}, due {due:e}");
}

/// A brake that slips at 50 rad/s with 30 N·m for ever: motor, load and brake are as 1 : −4 : 3.
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
    let rise = |t: f64| 60.0 * (1.0 - (-0.025 * t).exp());
    close(found.elements[0].end_temperature_rise_k.unwrap(), rise(40.0), 1e-11);
    let element = &found.samples.elements[0];
    let rises = element.temperature_rises_k.as_ref().unwrap();
    assert_eq!(rises.len(), found.samples.times_s.len());
    for (time, found) in found.samples.times_s.iter().zip(rises).skip(1) {
        close(*found, rise(*time), 1e-10);
    }
}

/// The shift of two gears: ring brake to clutch, with a capacity that is enough.
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

/// The torque of the output by the acceleration is what the set's carrier gives.
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
    // In first gear (60 − 100/4) N·m on 0.1 + 3/16 kg·m²; what the sun's inertia leaves comes out fourfold.
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
            // At the jump itself either side is right.
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
    let wanted = sweep::Wanted {
        key: "shifts[0].overlap".into(),
        from: 0.0,
        to: 80.0,
        unit: Some("ms".into()),
        steps: 3,
    };
    let found = sweep::sweep(&document, &Beside::default(), &wanted, |_| true).unwrap();
    assert_eq!(found.runs.iter().map(|run| run.value).collect::<Vec<_>>(), [0.0, 40.0, 80.0]);
    for run in &found.runs {
        let one = simulated(&SHIFT.replace("overlap: 0.06 s", &format!("overlap: {} ms", run.value)));
        assert_eq!((&run.shifts, &run.elements, &run.end), (&one.shifts, &one.elements, &one.end));
    }
    let by_name = sweep::Wanted {
        key: "elements[C].holding".into(),
        unit: Some("N·m".into()),
        from: -1.0,
        to: 150.0,
        steps: 2,
    };
    let found = sweep::sweep(&document, &Beside::default(), &by_name, |_| true).unwrap();
    assert!(found.runs[0].refused.is_some() && found.runs[1].refused.is_none());
    assert_eq!(found.warnings[0].name, "refused");
    let stopped = sweep::sweep(&document, &Beside::default(), &wanted, |_| false).unwrap();
    assert!(stopped.runs.is_empty() && stopped.warnings[0].name == "interrupted");
}
