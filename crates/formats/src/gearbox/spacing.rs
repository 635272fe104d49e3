//! Where the planets of a set stand, as files say it.

use super::DescriptionError;
use crate::drive::Spacing as Word;
use epicyclic_gears::synthesis::Placement;
use epicyclic_train::spacing::Spacing;
use epicyclic_units::Quantity;
use uom::si::f64::Angle;

/// The spacing of a word or of one of these lists of angles; at equal angles without either.
pub(super) fn spaced(
    set: &str,
    word: Option<Word>,
    angles: [Option<&[Quantity<Angle>]>; 2],
) -> Result<Spacing, DescriptionError> {
    let twice = || DescriptionError::SpacingTwice { set: set.to_owned() };
    match (word, angles) {
        (word, [None, None]) => Ok(Spacing::Placed(word.map_or(Placement::Equal, Placement::from))),
        (None, [Some(angles), None] | [None, Some(angles)]) => {
            Ok(Spacing::At(angles.iter().map(|angle| angle.0).collect()))
        }
        _ => Err(twice()),
    }
}
