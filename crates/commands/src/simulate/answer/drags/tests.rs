//! Drags in motion compared with `losses` and closed forms.

use crate::losses::answer as losses;
use crate::shared::gearbox::{Choice, one};
use crate::simulate::answer::tests::{close, document, simulated};
use crate::simulate::answer::{Beside, ChangeKind, DragKind, Simulation, State, answer};
use epicyclic_formats::{Document, scenario};
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Torque};

const BOX: &str = "\
gearbox: two speeds
input: D
output: B
sets: [{ id: P, sun: D, ring: T, carrier: B, k: 3, meshes: [0.98, 0.99] }]
brakes: [{ id: K1, link: T, drag: { speeds: [0 rpm, 2000 rpm], torques: [0.5 N·m, 1.5 N·m] } }]
clutches: [{ id: K2, links: [D, B], drag: { speeds: [0 rpm, 500 rpm, 1500 rpm], torques: [1 N·m, 3 N·m, 2 N·m] } }]
drags:
  - { id: seal, between: [D, ground], curve: { speeds: [0 rpm, 3000 rpm], torques: [1 N·m, 2.5 N·m] } }
  - { id: churning, between: [ground, B], curve: { speeds: [0 rpm, 400 rpm], torques: [0 N·m, 2 N·m], beyond: constant } }
gears: [{ name: slow, engaged: [K1] }, { name: fast, engaged: [K2] }]
";

/// Simulation of the gearbox with its file beside the scenario.
fn moved(text: &str) -> Result<Simulation, crate::error::Error> {
    let document = document(text);
    let gearbox = Some(Document::parse_one("box.yaml", BOX.as_bytes()).unwrap());
    answer(&document, &scenario::read(&document).unwrap(), &Beside { gearbox, ..Beside::default() })
}

fn steady(gear: &str, load: f64) -> String {
    format!(
        "scenario: steady\ngearbox_file: box.yaml\ninertias: {{ D: 0.2 kg·m², T: 0.1 kg·m², B: 3 kg·m² }}\ngear: {gear}\n\
         start: {{ input_speed: 1000 rpm }}\nduration: 5 s\n\
         torques: [{{ id: motor, link: D, constant: 100 N·m }}, {{ id: load, link: B, constant: {load:.17e} N·m }}]\n\
         elements: [{{ id: K1, holding: 900 N·m }}, {{ id: K2, holding: 900 N·m }}]\n"
    )
}

/// With the torques in balance according to `losses`, the speeds stay constant and each drag loses the power
/// given there.
#[test]
fn an_even_motion_is_the_balance_of_losses() {
    let file = Document::parse_one("box.yaml", BOX.as_bytes()).unwrap();
    let subject = one(&file, &Choice::default()).unwrap();
    let speed = AngularVelocity::from_si(1000.0 * std::f64::consts::PI / 30.0);
    for gear in ["slow", "fast"] {
        let load = losses::GivenLoad::Input(epicyclic_train::InputLoad::Torque(Torque::from_si(100.0)));
        let due = losses::answer(&subject, Some(gear), losses::Point { speed, load }, None).unwrap();
        let found = moved(&steady(gear, due.gears[0].output_torque_n_m)).unwrap();
        for link in &found.end {
            assert!(link.acceleration_rad_s2.abs() < 1e-9, "{gear}: {link:?}");
        }
        close(found.end.iter().find(|link| link.link == "D").unwrap().speed_rad_s, speed.si(), 1e-11);
        assert_eq!(found.drags.len(), 4);
        for drag in &found.drags {
            let is_it = |one: &&losses::Loss| one.of == drag.id && one.kind != losses::LossKind::Mesh;
            let loss = due.losses.iter().find(is_it).map_or(0.0, |one| one.loss_w);
            assert!((drag.loss_j - 5.0 * loss).abs() < 1e-9 * due.gears[0].loss_w, "{gear}: {drag:?} {loss}");
            assert!((drag.peak_power_w - loss).abs() < 1e-9 * due.gears[0].loss_w);
            let is_open = drag.kind == DragKind::OpenElement;
            assert_eq!(is_open, ["K1", "K2"].contains(&drag.id.as_str()));
        }
        close(found.energies.drag_loss_j, 5.0 * due.gears[0].drag_loss_w, 1e-9);
        assert!((found.energies.mesh_loss_j - 5.0 * due.gears[0].mesh_loss_w).abs() < 1e-6);
        assert!(found.energies.residual.abs() < 1e-11);
        // The torque of sets and shift elements equals the load plus the oil drag on the output.
        let oil = found.drags.iter().find(|drag| drag.id == "churning").unwrap();
        let given = -due.gears[0].output_torque_n_m + oil.end_torque_n_m;
        close(*found.samples.output_torques_n_m.last().unwrap(), given, 1e-9);
    }
}

#[test]
fn the_losses_of_each_drag_grow_to_what_it_loses_in_all() {
    let text = steady("slow", -390.0);
    let found = moved(&text).unwrap();
    for (drag, samples) in found.drags.iter().zip(&found.samples.drags) {
        assert_eq!((&drag.id, samples.losses_j[0]), (&samples.id, 0.0));
        assert!(samples.losses_j.windows(2).all(|pair| pair[1] >= pair[0]));
        assert_eq!(*samples.losses_j.last().unwrap(), drag.loss_j);
        assert_eq!(*samples.torques_n_m.last().unwrap(), drag.end_torque_n_m);
        assert_eq!(*samples.slips_rad_s.last().unwrap(), drag.end_slip_rad_s);
        // Trapezoidal rule for the power: at every sample it must agree with the loss integrated with the
        // motion.
        let powers: Vec<f64> = samples
            .torques_n_m
            .iter()
            .zip(&samples.slips_rad_s)
            .map(|(torque, slip)| -torque * slip)
            .collect();
        let step = found.samples.times_s[1];
        let sum: f64 = powers.windows(2).map(|pair| 0.5 * step * (pair[0] + pair[1])).sum();
        assert!((sum - drag.loss_j).abs() <= 1e-4 * drag.loss_j, "{}: {sum} {}", drag.id, drag.loss_j);
    }
    let all: f64 = found.drags.iter().map(|drag| drag.loss_j).sum();
    close(found.energies.drag_loss_j, all, 1e-12);
    let bare = moved(&text.replace("duration", "drags: false\nduration")).unwrap();
    assert!(bare.drags.is_empty() && bare.samples.drags.is_empty() && bare.energies.drag_loss_j == 0.0);
    assert_eq!(bare.warnings[0].name, "drags");
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    // Brakes and clutches that are always engaged have no slip, so that their drags lose nothing.
    let engaged = text
        .replace("gear: slow\n", "gear: slow\nengaged: [K1]\n")
        .replace("{ id: K1, holding: 900 N·m }, ", "");
    let found = moved(&engaged).unwrap();
    assert_eq!(
        found.drags.iter().map(|drag| drag.id.as_str()).collect::<Vec<_>>(),
        ["seal", "churning", "K2"]
    );
}

/// Rotor with a dry seal alone: it stops after `t = J·ω_0/M`, all its energy goes into the seal, and it stays
/// at rest.
#[test]
fn a_seal_brings_to_rest_in_a_line() {
    let text = "\
scenario: run-down
gearbox:
  gearbox: g
  input: s
  output: c
  sets: [{ id: P, sun: s, ring: r, carrier: c, k: 3 }]
  clutches: [{ id: C, links: [s, c] }]
  drags: [{ id: seal, between: [c, ground], curve: { speeds: [0 rpm], torques: [2 N·m], beyond: constant } }]
inertias: { s: 0.1 kg·m², r: 0.2 kg·m², c: 0.7 kg·m² }
engaged: [C]
start: { speeds: { s: 30 rad/s } }
duration: 20 s
";
    let found = simulated(text);
    let [stop] = &found.events[..] else { panic!("{:?}", found.events) };
    close(stop.time_s, 15.0, 1e-11);
    let [change] = &stop.changes[..] else { panic!("{:?}", stop.changes) };
    assert_eq!((change.kind, change.id.as_str()), (ChangeKind::Drag, "seal"));
    assert_eq!((change.from, change.to), (Some(State::SlipsForward), Some(State::Holds)));
    close(found.drags[0].loss_j, 450.0, 1e-11);
    assert!(found.end.iter().all(|link| link.speed_rad_s == 0.0));
    for (time, speed) in found.samples.times_s.iter().zip(&found.samples.links[0].speeds_rad_s) {
        assert!((speed - (30.0 - 2.0 * time).max(0.0)).abs() < 1e-9, "{time}: {speed}");
    }
}

#[test]
fn a_speed_outside_a_curve_is_refused_at_its_place_in_the_gearbox() {
    let refused = moved(&steady("slow", 300.0)).unwrap_err().to_string();
    assert!(refused.starts_with("box.yaml:6:"), "{refused}");
    assert!(refused.contains("clutches[0].drag.speeds: at ") && refused.contains("drag `K2`"), "{refused}");
    let inner = "\
scenario: run-up
gearbox:
  gearbox: g
  input: s
  output: c
  sets: [{ id: P, sun: s, ring: r, carrier: c, k: 3 }]
  clutches: [{ id: C, links: [s, c] }]
  drags: [{ id: seal, between: [c, ground], curve: { speeds: [0 rpm, 100 rpm], torques: [2 N·m, 2 N·m] } }]
inertias: { s: 0.1 kg·m², r: 0.2 kg·m², c: 0.7 kg·m² }
engaged: [C]
torques: [{ id: motor, link: s, constant: 12 N·m }]
duration: 20 s
";
    let document = document(inner);
    let file = scenario::read(&document).unwrap();
    let refused = answer(&document, &file, &Beside::default()).unwrap_err();
    let told = refused.to_string();
    assert!(told.contains("gearbox.drags[0].curve.speeds: at 1.047"), "{told}");
    assert_eq!(refused.name(), "drag-speed");
}
