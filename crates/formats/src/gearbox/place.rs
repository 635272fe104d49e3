//! Keys of a gearbox file that hold the cause of a fault, and paths of named entries.

use crate::faults::Keys;
use crate::yaml::Value;
use crate::{Document, Path};
use epicyclic_gears::Quantity;
use epicyclic_train::{GearPart, SetPart};

/// Path of a key of a gear, where the gear has it; otherwise that of the gear.
#[must_use]
pub fn gear_place(document: &Document, base: &Path, gear: &str, key: &str) -> Path {
    let entry = entry(document, base, &["gears"], gear).unwrap_or_else(|| base.clone());
    let path = entry.clone().key(key);
    if document.has(&path) { path } else { entry }
}

/// Path of the set or shift element of a name, if the gearbox has one.
#[must_use]
pub fn part_place(document: &Document, base: &Path, name: &str) -> Option<Path> {
    let lists = ["sets", "compound_sets", "brakes", "clutches", "shift_elements", "one_way"];
    entry(document, base, &lists, name)
}

/// Path of the entry of a name, which is unique in a gearbox that was built.
fn entry(document: &Document, base: &Path, lists: &[&str], name: &str) -> Option<Path> {
    let bears =
        |entry: &Value| ["id", "name"].iter().any(|key| entry.get(key).and_then(Value::as_str) == Some(name));
    lists.iter().find_map(|list| {
        let path = base.clone().key(*list);
        match document.value_at(&path)? {
            Value::Sequence(entries) => entries.iter().position(bears).map(|index| path.index(index)),
            Value::Mapping(entries) => entries.contains_key(name).then(|| path.key(name)),
            _ => None,
        }
    })
}

/// Keys of the lists of sets.
pub(super) const LISTS_OF_SETS: Keys = &["sets", "compound_sets"];

/// Path of a set by its number; the entries of `sets`, whose number is `simple`, come before those of
/// `compound_sets`.
pub(super) fn of_set(simple: usize, set: usize) -> Path {
    match set.checked_sub(simple) {
        None => Path::root().key("sets").index(set),
        Some(compound) => Path::root().key("compound_sets").index(compound),
    }
}

/// Path of a part of a gear.
pub(super) fn of_gear(gear: usize, part: GearPart) -> Path {
    let entry = Path::root().key("gears").index(gear);
    match part {
        GearPart::Whole => entry,
        GearPart::Engaged(index) => entry.key("engaged").index(index),
        GearPart::Terminal(which) => entry.key(which.to_string()),
    }
}

/// Keys of a part of a set, in files of gearboxes and of transmissions.
pub(super) const fn keys_of_part(part: SetPart) -> Keys {
    match part {
        SetPart::BasicRatio => &["k", "teeth", "z_r", "z_b"],
        SetPart::PlanetCount => &["planets", "n_p", "planet_angles", "vibration.planet_angles"],
        SetPart::Spacing => &["spacing", "planet_angles", "vibration.planet_angles"],
        SetPart::Carrier => &["carrier"],
        SetPart::Central(0) => &["sun", "gear_a"],
        SetPart::Central(_) => &["ring", "gear_b"],
        _ => &[],
    }
}

/// Keys of a set that may hold the cause of an error of its gears.
#[must_use]
pub fn keys_of(error: &epicyclic_gears::Error) -> Keys {
    use epicyclic_gears::Error as E;
    match error {
        E::Efficiency { .. } | E::EfficiencyTooSmall { .. } => &["efficiency", "meshes", "friction"],
        E::NoTeeth => &["teeth"],
        E::NotAbove { quantity: Quantity::ContactRatio, .. } => &["profile_shifts", "teeth"],
        E::ShiftOutOfRange { tip_alteration, .. } if *tip_alteration != 0.0 => {
            &["tip_alterations", "profile_shifts", "tools", "teeth"]
        }
        E::ShiftOutOfRange { .. } | E::ShiftSumOutOfRange { .. } => &["profile_shifts", "tools", "teeth"],
        E::NotAbove { quantity: Quantity::CentreDistance, .. } => &["modules", "profile_shifts", "teeth"],
        E::HelixAnglesDiffer { .. } => &["helix_angles", "helix_angle"],
        E::Uncut { .. } => &["tools", "strength", "teeth"],
        E::NotPositive { quantity, .. } | E::OutOfRange { quantity, .. } => match quantity {
            Quantity::Module => &["module", "modules"],
            Quantity::HelixAngle => &["helix_angle", "helix_angles"],
            Quantity::CarrierRadius => &["carrier_radius"],
            Quantity::FaceWidth | Quantity::Width => &["face_width"],
            Quantity::PlanetBore | Quantity::BoreDiameter => &["planet_bore"],
            Quantity::PlanetMass => &["planet_mass"],
            Quantity::LoadRating => &["load_rating"],
            Quantity::Friction => &["friction"],
            _ => &[],
        },
        _ => &[],
    }
}
