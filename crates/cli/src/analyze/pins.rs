//! Forces on the bearings of the planets, in one gear or in all.

use super::subject::Subject;
use super::{Input, Worked};
use crate::failure::Failure;
use crate::figure::{Figure, column, multiple, text};
use crate::report::{Column, Records, View};
use epicyclic_formats::Dimension;
use epicyclic_schemes::pins::{Lack, Pin};
use epicyclic_schemes::{Direction, LoadCase};
use uom::si::f64::Torque;
use uom::si::time::hour;
use uom::si::torque::newton_meter;

/// The planets of one gear, where it has any.
pub(super) fn of_gear(
    subject: &Subject,
    worked: &Worked<'_>,
    input: Input,
) -> Result<Option<Records>, Failure> {
    let pins = &subject.pins;
    let sized = pins.iter().any(|(_, pin)| pin.radius.is_some());
    if pins.is_empty() || !(sized || worked.analysis.ideal().is_some()) {
        return Ok(None);
    }
    let rows = rows(subject, worked, input, pins)?;
    Ok(Some(records(subject, rows, input, worked.operation.is_some(), pins, false)))
}

/// The planets of all gears, where the size of any row is known.
pub(super) fn of_gears(
    subject: &Subject,
    worked: &[Worked<'_>],
    input: Input,
) -> Result<Option<Records>, Failure> {
    let pins = &subject.pins;
    if pins.iter().all(|(_, pin)| pin.radius.is_none()) {
        return Ok(None);
    }
    let mut all = vec![];
    for worked in worked {
        all.extend(rows(subject, worked, input, pins)?);
    }
    let loaded = worked.iter().any(|worked| worked.operation.is_some());
    Ok(Some(records(subject, all, input, loaded, pins, true)))
}

fn rows(
    subject: &Subject,
    worked: &Worked<'_>,
    input: Input,
    pins: &[(usize, Pin)],
) -> Result<Vec<Vec<Figure>>, Failure> {
    let analysis = &worked.analysis;
    let is_overrun = worked.operation.as_ref().is_some_and(|at| at.direction == Direction::Overrun);
    let case = if is_overrun { analysis.overrun() } else { analysis.driving() };
    let newton_metres = Torque::new::<newton_meter>;
    let mut rows = vec![];
    for (place, pin) in pins {
        let row = &subject.gearbox.sets()[*place];
        let of_input = |case: &LoadCase| {
            let torques = <[f64; 3]>::try_from(case.members[*place].clone()?).ok()?;
            Some(torques.map(|torque| torque / case.input))
        };
        let of_input = case.and_then(of_input);
        let carrier_torque = of_input.map(|torques| torques[2].abs());
        let each = carrier_torque.zip(pin.planets).map(|(torque, count)| torque / f64::from(count));
        let per_unit = pin.forces(of_input.map(|torques| torques.map(newton_metres)), None)?;
        let carrier = analysis.speed(row.carrier());
        let speed = input.speed.zip(carrier).map(|(speed, of)| speed * of);
        let at = worked.operation.as_ref().and_then(|operation| operation.members[*place].clone());
        let torques = at.and_then(|torques| <[Torque; 3]>::try_from(torques).ok());
        let forces = pin.forces(torques, speed)?;
        // A row with a pin has one planet: of kinds with more no force follows.
        let planet = analysis.sets()[*place].planets.first().copied().flatten();
        let turning = input.speed.zip(planet).map(|(speed, planet)| speed * planet.relative);
        let life = match forces.total.zip(turning) {
            Some((force, turning)) => pin.life(force, turning)?,
            None => None,
        };
        rows.push(vec![
            text(row.id()),
            text(analysis.gear().name()),
            pin.planets.map_or(Figure::None, Figure::Count),
            column(pin.radius),
            column(pin.mass),
            multiple(carrier_torque),
            multiple(each),
            // At 1 N·m on the input.
            multiple(per_unit.tangential.map(|force| force.value)),
            multiple(per_unit.radial.map(|force| force.value)),
            column(forces.tangential),
            column(forces.radial),
            column(forces.centrifugal),
            column(forces.total),
            column(pin.bearing.map(|(capacity, _)| capacity)),
            column(turning),
            life.map_or(Figure::None, |life| Figure::Number(life.get::<hour>())),
        ]);
    }
    Ok(rows)
}

fn records(
    subject: &Subject,
    rows: Vec<Vec<Figure>>,
    input: Input,
    loaded: bool,
    pins: &[(usize, Pin)],
    several: bool,
) -> Records {
    let first: &[&'static str] = if several { &["gear", "set"] } else { &["set"] };
    let sized = pins.iter().any(|(_, pin)| pin.radius.is_some());
    let shown: &[&'static str] = match (sized, loaded, input.speed) {
        (false, ..) => &["planets", "carrier_torque_of_input", "carrier_torque_each_of_input"],
        (true, false, None) => {
            &["planets", "carrier_radius", "tangential_force_per_input_n_m", "radial_force_per_input_n_m"]
        }
        (true, false, Some(_)) => &[
            "planets",
            "carrier_radius",
            "planet_mass",
            "tangential_force_per_input_n_m",
            "centrifugal_force",
        ],
        (true, true, None) => &["planets", "carrier_radius", "tangential_force", "radial_force"],
        (true, true, Some(_)) => {
            &["planets", "planet_mass", "tangential_force", "radial_force", "centrifugal_force", "force"]
        }
    };
    let headed = |name, heading: &str, dimension| Column {
        heading: heading.to_owned(),
        ..Column::quantity(name, dimension)
    };
    let title = match (sized, loaded) {
        (false, _) => "Torque that the pins of the planets hand to the carrier, over the input's",
        (true, false) => "Force on the bearing of each planet at 1 N·m on the input, N",
        (true, true) => "Force on the bearing of each planet, N",
    };
    let mut views = vec![View {
        note: note(subject, pins, sized, input.speed.is_some()),
        ..View::new(title, &[first, shown].concat())
    }];
    let has_capacity = pins.iter().any(|(_, pin)| pin.bearing.is_some());
    if has_capacity && loaded && input.speed.is_some() {
        let shown: &[&'static str] = &["force", "bearing_capacity", "bearing_speed", "bearing_life_h"];
        views.push(View {
            note:
                "Basic rating life, 90 % reach it; turns: on its carrier. None where a planet does not turn."
                    .to_owned(),
            ..View::new("Life of the bearings of the planets", &[first, shown].concat())
        });
    }
    Records {
        name: "planet_bearings",
        columns: vec![
            Column::words("set", "set"),
            Column::words("gear", "gear"),
            Column::number("planets", "planets"),
            headed("carrier_radius", "at radius, mm", Dimension::Length),
            headed("planet_mass", "mass, kg", Dimension::Mass),
            Column::number("carrier_torque_of_input", "|T_H|"),
            Column::number("carrier_torque_each_of_input", "|T_H|/n"),
            Column::number("tangential_force_per_input_n_m", "tangential"),
            Column::number("radial_force_per_input_n_m", "radial"),
            headed("tangential_force", "tangential", Dimension::Force),
            headed("radial_force", "radial", Dimension::Force),
            headed("centrifugal_force", "centrifugal", Dimension::Force),
            headed("force", "together", Dimension::Force),
            headed("bearing_capacity", "capacity, N", Dimension::Force),
            headed("bearing_speed", "turns, rpm", Dimension::AngularSpeed),
            Column::number("bearing_life_h", "life, h"),
        ],
        rows,
        views,
        is_answer: false,
    }
}

/// What the columns are, and what is missing of which row.
fn note(subject: &Subject, pins: &[(usize, Pin)], sized: bool, turns: bool) -> String {
    let mut notes = vec![];
    if sized {
        notes.push("Radial: of the meshes, outwards positive. All planets carry alike.".to_owned());
        if !turns {
            notes.push("--speed adds the centrifugal force.".to_owned());
        }
    }
    let mut told: Vec<(Lack, Vec<&str>)> = vec![];
    for (place, pin) in pins {
        let row = subject.gearbox.sets()[*place].id();
        for &lack in &pin.lacks {
            match told.iter_mut().find(|(known, _)| *known == lack) {
                Some((_, rows)) => rows.push(row),
                None => told.push((lack, vec![row])),
            }
        }
    }
    if !subject.published.is_empty() {
        notes.push("A list of transmissions states no sizes, and no forces follow.".to_owned());
        return notes.join(" ");
    }
    let of_rows = |rows: &[&str]| match rows.len() {
        all if all == pins.len() => "all sets".to_owned(),
        1 => format!("set {}", rows[0]),
        _ => format!("sets {}", rows.join(", ")),
    };
    let missing: Vec<String> =
        told.iter().map(|(lack, rows)| format!("{} ({})", wanted(*lack), of_rows(rows))).collect();
    if !missing.is_empty() {
        notes.push(format!("Missing for the forces: {}.", missing.join("; ")));
    }
    notes.join(" ")
}

/// The keys of a file that would help.
fn wanted(lack: Lack) -> String {
    match lack {
        Lack::Planets => "planets".to_owned(),
        Lack::Radius => "module with teeth, or carrier_radius".to_owned(),
        Lack::Teeth => "teeth, for the radial force".to_owned(),
        Lack::Mass => "planet_mass or face_width, for the centrifugal force".to_owned(),
        other => other.to_string(),
    }
}
