//! Places in a gearbox file of faults of its strength.

use super::records::NotRated;
use crate::error::Error;
use crate::shared::fault::refused;
use epicyclic_formats::{Document, Path};
use epicyclic_strength::{self as strength, Quantity};

/// Reasons why a set cannot be rated.
pub(crate) enum Fault {
    /// Something is missing for this set; the others are rated.
    Row(Box<NotRated>),
    /// The input is invalid.
    Refused(Box<Error>),
}

impl Fault {
    /// Classifies an error of a set at its path.
    pub(crate) fn of(document: &Document, set: &str, path: &Path, error: &strength::Error) -> Self {
        match NotRated::of_error(set, error) {
            Some(row) => Self::Row(Box::new(row)),
            None => Self::Refused(Box::new(located(document, path, error))),
        }
    }
}

/// Error of a set's strength, at the key that caused it.
pub(crate) fn located(document: &Document, set: &Path, error: &strength::Error) -> Error {
    use strength::Error as E;
    let root = Path::root();
    let (path, keys): (&Path, &[&str]) = match error {
        E::NotPositive { quantity, .. }
        | E::Negative { quantity, .. }
        | E::OutOfRange { quantity, .. }
        | E::NotAbove { quantity, .. } => match quantity {
            Quantity::Life => (&root, &["life"]),
            Quantity::Viscosity => (&root, &["oil", "viscosity"]),
            Quantity::RequiredSafety => (&root, &["required"]),
            Quantity::Module => (set, &["module"]),
            Quantity::FaceWidth => (set, &["face_width"]),
            Quantity::Planets => (set, &["planets"]),
            Quantity::FlankRoughness => (set, &["strength", "flank_roughness"]),
            Quantity::RootRoughness => (set, &["strength", "root_roughness"]),
            Quantity::ContactRatio | Quantity::TransverseContactRatio => (set, &["profile_shifts"]),
            Quantity::ShaperTeeth => (set, &["strength", "shaper", "teeth"]),
            Quantity::ShaperShift => (set, &["strength", "shaper", "shift"]),
            Quantity::Rim | Quantity::RimOverHeight => (set, &["strength", "planet_rim"]),
            Quantity::AccuracyGrade => (set, &["strength", "accuracy_grade"]),
            Quantity::RingRim | Quantity::RimOverModule => (set, &["strength", "ring_rim"]),
            Quantity::PitchDeviation => (set, &["strength", "accuracy", "pitch_deviations"]),
            Quantity::ProfileDeviation => (set, &["strength", "accuracy", "profile_deviations"]),
            Quantity::TipRelief => (set, &["strength", "accuracy", "tip_relief"]),
            Quantity::BlankFactor => (set, &["strength", "accuracy", "blank_factor"]),
            Quantity::Bore => (set, &["strength", "accuracy"]),
            Quantity::LongLifeFactor => (set, &["strength", "long_life_factor"]),
            _ => (set, &["strength"]),
        },
        E::NoRootSection { .. } => (set, &["strength", "shaper"]),
        _ => (set, &["strength"]),
    };
    refused(document, path, keys, error)
}
