//! Where the planets of a set stand, as files say it.

use super::DescriptionError;
use super::place::keys_of_part;
use crate::drive::Spacing as Word;
use crate::faults::Faults;
use epicyclic_gears::synthesis::Placement;
use epicyclic_train::SetPart;
use epicyclic_train::spacing::Spacing;
use epicyclic_units::Quantity;
use uom::si::f64::Angle;

/// The spacing of a word or of one of these lists of angles; at equal angles without either.
pub(super) fn spaced(
    set: &str,
    word: Option<Word>,
    angles: [Option<&[Quantity<Angle>]>; 2],
    faults: &mut Faults,
) -> Spacing {
    match (word, angles) {
        (word, [None, None]) => Spacing::Placed(word.map_or(Placement::Equal, Placement::from)),
        (None, [Some(angles), None] | [None, Some(angles)]) => {
            Spacing::At(angles.iter().map(|angle| angle.0).collect())
        }
        _ => {
            let twice = DescriptionError::SpacingTwice { set: set.to_owned() };
            faults.push(keys_of_part(SetPart::Spacing), twice);
            Spacing::default()
        }
    }
}
