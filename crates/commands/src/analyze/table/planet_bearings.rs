//! Forces on the planet bearings, in one gear or in all.

use crate::analyze::answer::OperatingPoint;
use crate::analyze::answer::planet_bearings::{Lack, LackName, PlanetBearing};
use crate::table::columns::Table;
use crate::table::report::{Records, View};
use epicyclic_units::Dimension::{AngularSpeed, Force, Length, Mass, Torque};

/// Seconds of an hour, in which a bearing's life is told.
const HOUR_S: f64 = 3600.0;

/// A table of the planet bearings; `None` of no bearings, or where nothing is known of them.
pub(super) fn records(bearings: &[PlanetBearing], at: &OperatingPoint, of_one_gear: bool) -> Option<Records> {
    if bearings.is_empty() {
        return None;
    }
    let is_sized = bearings.iter().any(|bearing| bearing.carrier_radius_m.is_some());
    // Of planets that differ nothing is known without sizes.
    if !is_sized && bearings.iter().all(|bearing| bearing.carrier_torque_of_input.is_none()) {
        return None;
    }
    let is_loaded = bearings.iter().any(|bearing| bearing.tangential_force_n.is_some());
    let first: &[&'static str] = if of_one_gear { &["set", "planet"] } else { &["gear", "set", "planet"] };
    let shown: &[&'static str] = match (is_sized, is_loaded, at.speed_rad_s) {
        (false, ..) => &["planets", "carrier_torque_of_input", "carrier_torque_each_of_input"],
        (true, false, None) => {
            &["planets", "carrier_radius", "tangential_force_n_per_input_n_m", "radial_force_n_per_input_n_m"]
        }
        (true, false, Some(_)) => &[
            "planets",
            "carrier_radius",
            "planet_mass",
            "tangential_force_n_per_input_n_m",
            "centrifugal_force",
        ],
        (true, true, None) => &["planets", "carrier_radius", "tangential_force", "radial_force"],
        (true, true, Some(_)) => {
            &["planets", "planet_mass", "tangential_force", "radial_force", "centrifugal_force", "force"]
        }
    };
    let title = match (is_sized, is_loaded) {
        (false, _) => "Torque of the planet pins on the carrier, over the input's",
        (true, false) => "Force on the bearing of each planet at 1 N·m on the input, N",
        (true, true) => "Force on the bearing of each planet, N",
    };
    let mut views = vec![View {
        note: note(bearings, is_sized, at.speed_rad_s.is_some()),
        ..View::new(title, &[first, shown].concat())
    }];
    if bearings.iter().any(|bearing| bearing.axial_forces_n.is_some()) {
        views.push(View {
            note: "Of the meshes with sun and ring, against each other; tilting: the moment of both on the planet, which is no part of the force and life of its bearing."
                .to_owned(),
            ..View::new(
                "Axial forces of helical teeth on each planet, N",
                &[first, &["axial_force_sun", "axial_force_ring", "tilting_moment"]].concat(),
            )
        });
    }
    let has_load_rating = bearings.iter().any(|bearing| bearing.bearing_load_rating_n.is_some());
    if has_load_rating && is_loaded && at.speed_rad_s.is_some() {
        let shown: &[&'static str] = &["force", "bearing_load_rating", "bearing_speed", "bearing_life_h"];
        views.push(View {
            note: "C: basic dynamic load rating. Speed: relative to the carrier. Basic rating life, which 90 % reach, where \
                   planets carry alike, with the losses of the meshes; `strength` counts K_γ. None where a planet does not turn."
                .to_owned(),
            ..View::new("Life of the planet bearings", &[first, shown].concat())
        });
    }
    let table = Table::new("planet_bearings", bearings)
        .text("set", "set", |one| &one.set)
        .text("gear", "gear", |one| &one.gear)
        .text("planet", "planet", |one| &one.planet)
        .number("planets", "n", |one| one.planets)
        .quantity("carrier_radius", "at radius", Length, |one| one.carrier_radius_m)
        .quantity("planet_mass", "mass", Mass, |one| one.planet_mass_kg)
        .multiple("carrier_torque_of_input", "|T_H|", |one| one.carrier_torque_of_input)
        .multiple("carrier_torque_each_of_input", "|T_H|/n", |one| one.carrier_torque_each_of_input)
        .multiple("tangential_force_n_per_input_n_m", "tangential", |one| {
            one.tangential_force_n_per_input_n_m
        })
        .multiple("radial_force_n_per_input_n_m", "radial", |one| one.radial_force_n_per_input_n_m)
        .headed("tangential_force", "tangential", Force, |one| one.tangential_force_n)
        .headed("radial_force", "radial", Force, |one| one.radial_force_n)
        .headed("centrifugal_force", "centrifugal", Force, |one| one.centrifugal_force_n)
        .headed("force", "together", Force, |one| one.force_n)
        .headed("axial_force_sun", "at the sun", Force, |one| one.axial_forces_n.map(|[sun, _]| sun))
        .headed("axial_force_ring", "at the ring", Force, |one| one.axial_forces_n.map(|[_, ring]| ring))
        .quantity("tilting_moment", "tilting", Torque, |one| one.tilting_moment_n_m)
        .quantity("bearing_load_rating", "C", Force, |one| one.bearing_load_rating_n)
        .quantity("bearing_speed", "speed", AngularSpeed, |one| one.bearing_speed_rad_s)
        .number("bearing_life_h", "life, h", |one| one.bearing_life_s.map(|life| life / HOUR_S));
    Some(table.views(views).records())
}

/// What the columns are, and what is missing of which set.
fn note(bearings: &[PlanetBearing], is_sized: bool, turns: bool) -> String {
    let mut notes = vec![];
    if is_sized {
        notes.push(
            "n: planets, which carry alike. Tangential: along the orbit, positive as all planets together push the \
             carrier. Radial: of the meshes, outwards positive."
                .to_owned(),
        );
        if !turns {
            notes.push("--speed adds the centrifugal force.".to_owned());
        }
    }
    let differ = |one: &PlanetBearing| {
        let alike = bearings.iter().filter(|other| (&other.set, &other.gear) == (&one.set, &one.gear));
        one.carrier_torque_of_input.is_none() && alike.count() > 1
    };
    if !is_sized && bearings.iter().any(differ) {
        notes.push("Planets that differ share the carrier's torque as their sizes make them.".to_owned());
    }
    let in_list =
        |bearing: &&PlanetBearing| bearing.missing.iter().any(|lack| lack.lack == LackName::NoSizesInList);
    if bearings.iter().all(|bearing| in_list(&bearing)) {
        notes.push("A list of transmissions states no sizes, and no forces follow.".to_owned());
        return notes.join(" ");
    }
    let mut sets: Vec<&str> = vec![];
    let mut told: Vec<(&Lack, Vec<&str>)> = vec![];
    for bearing in bearings {
        let set = bearing.set.as_str();
        if !sets.contains(&set) {
            sets.push(set);
        }
        for lack in bearing.missing.iter().filter(|lack| lack.lack != LackName::NoSizesInList) {
            match told.iter_mut().find(|(known, _)| *known == lack) {
                Some((_, sets)) if sets.contains(&set) => {}
                Some((_, sets)) => sets.push(set),
                None => told.push((lack, vec![set])),
            }
        }
    }
    let of_sets = |which: &[&str]| match which.len() {
        all if all == sets.len() => "all sets".to_owned(),
        1 => format!("set {}", which[0]),
        _ => format!("sets {}", which.join(", ")),
    };
    let missing: Vec<String> =
        told.iter().map(|(lack, sets)| format!("{} ({})", wanted(lack), of_sets(sets))).collect();
    if !missing.is_empty() {
        notes.push(format!("Missing for the forces: {}.", missing.join("; ")));
    }
    notes.join(" ")
}

/// The keys of a file that would help, or why there is no force.
fn wanted(lack: &Lack) -> String {
    let other = lack.other_planet.as_ref();
    let other = other.map_or_else(|| "another planet".to_owned(), |name| format!("planet {name}"));
    match lack.lack {
        LackName::Planets => "planets".to_owned(),
        LackName::Radius => "module with teeth, or carrier_radius".to_owned(),
        LackName::CommonRadius => "a carrier_radius of each planet, since they differ".to_owned(),
        LackName::Teeth => "teeth, for the radial force".to_owned(),
        LackName::OtherRadius => format!("the radius of the centre of {other}, in mesh with it"),
        LackName::Distance => format!("module or teeth of the mesh with {other}"),
        LackName::Triangle => {
            let mm = |length: f64| format!("{:.3} mm", 1e3 * length);
            let [own, of_other] = lack.radii_m.unwrap_or_default();
            format!(
                "its centre at a radius of {} and that of {other} at {} cannot stand {} apart, as module and teeth of \
                 their mesh ask",
                mm(own),
                mm(of_other),
                mm(lack.distance_m.unwrap_or_default())
            )
        }
        LackName::Mass => "planet_mass or face_width, for the centrifugal force".to_owned(),
        LackName::Bevel => "forces on bevel planets are not computed".to_owned(),
        LackName::NoSizesInList => "a list of transmissions states no sizes".to_owned(),
    }
}
