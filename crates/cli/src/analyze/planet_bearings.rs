//! Forces on the bearings of the planets, in one gear or in all.

use super::subject::Subject;
use super::{Input, Worked};
use crate::failure::Failure;
use epicyclic_formats::Dimension;
use epicyclic_train::planet_bearings::{Lack, PlanetBearing};
use epicyclic_train::{Direction, LoadCase, PlanetSet};
use epicyclic_views::figure::{Figure, column, multiple, text};
use epicyclic_views::report::{Column, Records, View};
use uom::si::time::hour;

/// The planets of one gear, where it has any.
pub(super) fn of_gear(
    subject: &Subject,
    worked: &Worked<'_>,
    input: Input,
) -> Result<Option<Records>, Failure> {
    let bearings = &subject.planet_bearings;
    let sized = bearings.iter().any(|bearing| bearing.radius.is_some());
    if bearings.is_empty() || !(sized || worked.analysis.ideal().is_some()) {
        return Ok(None);
    }
    let rows = rows(subject, worked, input, bearings)?;
    Ok(Some(records(subject, rows, input, worked.operation.is_some(), bearings, false)))
}

/// The planets of all gears, where the size of any row is known.
pub(super) fn of_gears(
    subject: &Subject,
    worked: &[Worked<'_>],
    input: Input,
) -> Result<Option<Records>, Failure> {
    let bearings = &subject.planet_bearings;
    if bearings.iter().all(|bearing| bearing.radius.is_none()) {
        return Ok(None);
    }
    let mut all = vec![];
    for worked in worked {
        all.extend(rows(subject, worked, input, bearings)?);
    }
    let loaded = worked.iter().any(|worked| worked.operation.is_some());
    Ok(Some(records(subject, all, input, loaded, bearings, true)))
}

fn rows(
    subject: &Subject,
    worked: &Worked<'_>,
    input: Input,
    bearings: &[PlanetBearing],
) -> Result<Vec<Vec<Figure>>, Failure> {
    let analysis = &worked.analysis;
    let is_back_driven = worked.operation.as_ref().is_some_and(|at| at.direction == Direction::BackDrive);
    let case = if is_back_driven { analysis.back_driving() } else { analysis.driving() };
    let mut rows = vec![];
    for bearing in bearings {
        let set = &subject.gearbox.sets()[bearing.set];
        let of_carrier = |case: &LoadCase| {
            let torques = case.members[bearing.set].as_ref()?;
            Some(torques.last()?.abs() / case.input.abs())
        };
        let carrier_torque = case.and_then(of_carrier);
        let each = carrier_torque.zip(bearing.planets).map(|(torque, count)| torque / f64::from(count));
        let per_unit = case.map(|case| bearing.of_unit_input(case)).transpose()?.unwrap_or_default();
        let carrier = analysis.speed(set.carrier());
        let speed = input.speed.zip(carrier).map(|(speed, of)| speed * of);
        let at = worked.operation.as_ref().and_then(|operation| operation.members[bearing.set].as_deref());
        let forces = bearing.forces(at, speed)?;
        let planet = analysis.sets()[bearing.set].planets[bearing.planet];
        let turning = input.speed.zip(planet).map(|(speed, planet)| speed * planet.relative);
        let life = match forces.total.zip(turning) {
            Some((force, turning)) => bearing.life(force, turning)?,
            None => None,
        };
        rows.push(vec![
            text(set.id()),
            text(analysis.gear().name()),
            text(planet_name(set, bearing.planet)),
            bearing.planets.map_or(Figure::None, Figure::Count),
            column(bearing.radius),
            column(bearing.mass),
            multiple(carrier_torque),
            multiple(each),
            // At 1 N·m on the input.
            multiple(per_unit.tangential.map(|force| force.value)),
            multiple(per_unit.radial.map(|force| force.value)),
            column(forces.tangential),
            column(forces.radial),
            column(forces.centrifugal),
            column(forces.total),
            column(bearing.load_rating.map(|(load_rating, _)| load_rating)),
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
    bearings: &[PlanetBearing],
    several: bool,
) -> Records {
    let first: &[&'static str] = if several { &["gear", "set", "planet"] } else { &["set", "planet"] };
    let sized = bearings.iter().any(|bearing| bearing.radius.is_some());
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
        note: note(subject, bearings, sized, input.speed.is_some()),
        ..View::new(title, &[first, shown].concat())
    }];
    let has_load_rating = bearings.iter().any(|bearing| bearing.load_rating.is_some());
    if has_load_rating && loaded && input.speed.is_some() {
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
            Column::words("planet", "planet"),
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
fn note(subject: &Subject, bearings: &[PlanetBearing], sized: bool, turns: bool) -> String {
    let mut notes = vec![];
    if sized {
        notes.push("Tangential: along the orbit, positive against the carrier. Radial: of the meshes, outwards positive. All \
             planets carry alike.".to_owned());
        if !turns {
            notes.push("--speed adds the centrifugal force.".to_owned());
        }
    }
    // A list of transmissions states sizes of compound sets alone.
    let has_sizes = |bearing: &&PlanetBearing| {
        subject.published.is_empty() || subject.gearbox.sets()[bearing.set].short().is_none()
    };
    if !bearings.iter().any(|bearing| has_sizes(&bearing)) {
        notes.push("A list of transmissions states no sizes, and no forces follow.".to_owned());
        return notes.join(" ");
    }
    let mut told: Vec<(Lack, Vec<&str>)> = vec![];
    for bearing in bearings.iter().filter(has_sizes) {
        let set = subject.gearbox.sets()[bearing.set].id();
        for lack in &bearing.lacks {
            match told.iter_mut().find(|(known, _)| known == lack) {
                Some((_, sets)) if sets.last() == Some(&set) => {}
                Some((_, sets)) => sets.push(set),
                None => told.push((lack.clone(), vec![set])),
            }
        }
    }
    let count = bearings.iter().map(|bearing| bearing.set).collect::<std::collections::BTreeSet<_>>().len();
    let of_rows = |rows: &[&str]| match rows.len() {
        all if all == count => "all sets".to_owned(),
        1 => format!("set {}", rows[0]),
        _ => format!("sets {}", rows.join(", ")),
    };
    let missing: Vec<String> =
        told.iter().map(|(lack, rows)| format!("{} ({})", wanted(lack), of_rows(rows))).collect();
    if !missing.is_empty() {
        notes.push(format!("Missing for the forces: {}.", missing.join("; ")));
    }
    notes.join(" ")
}

/// A planet of a set by its name, or by its number where it has none.
pub(super) fn planet_name(set: &PlanetSet, planet: usize) -> String {
    match &set.planets()[planet].name {
        name if name.is_empty() => (planet + 1).to_string(),
        name => name.clone(),
    }
}

/// The keys of a file that would help.
fn wanted(lack: &Lack) -> String {
    match lack {
        Lack::Planets => "planets".to_owned(),
        Lack::Radius => "module with teeth, or carrier_radius".to_owned(),
        Lack::Teeth => "teeth, for the radial force".to_owned(),
        Lack::Mass => "planet_mass or face_width, for the centrifugal force".to_owned(),
        other => other.to_string(),
    }
}
