//! Mechanisms that can be drawn without self-crossing, and the direct-drive clutches that can be drawn with
//! them.
//!
//! Brakes, input and output are always drawn. Of the options for the direct-drive clutch only the chosen one
//! is built. A mechanism is therefore drawable if at least one of them can be drawn with the rest, and the
//! choice is among these.

use super::Error;
use super::mechanism::Mechanism;
use epicyclic_layout::{Options, Verdict, Witness, direct_clutch_options, draw, is_drawable};
use epicyclic_schemes::structures::Role;

/// Reason why a mechanism cannot be drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum NotDrawable {
    /// The mechanism makes no gearbox.
    Gearbox(Error),
    /// Elements of [`Mechanism::without_direct_clutch`] that cannot be drawn together.
    SelfCrossing(Witness),
    /// No direct-drive clutch can be drawn with the rest.
    NoDirectClutch,
}

/// Ring-to-sun ratio of the sets that are drawn: whether a scheme can be drawn does not depend on it.
pub const DRAWN_K: f64 = 3.0;

/// The pairs of links between which a direct-drive clutch can be drawn.
///
/// # Errors
/// [`NotDrawable`] if no pair can be drawn.
pub fn drawable_direct_clutches(mechanism: Mechanism) -> Result<Vec<[Role; 2]>, NotDrawable> {
    let gearbox = mechanism.without_direct_clutch(DRAWN_K).map_err(NotDrawable::Gearbox)?;
    if !is_drawable(&gearbox) {
        return match draw(&gearbox, Options { attempts: 1, ..Options::default() }) {
            Verdict::SelfCrossing(witness) => Err(NotDrawable::SelfCrossing(witness)),
            Verdict::Drawable(_) => unreachable!("both verdicts are one"),
        };
    }
    let role = |link| Role::ALL.into_iter().find(|role| gearbox.link(role.symbol()) == Some(link));
    let pairs = direct_clutch_options(&gearbox).into_iter();
    let pairs: Vec<[Role; 2]> = pairs.filter_map(|[x, y]| Some([role(x)?, role(y)?])).collect();
    if pairs.is_empty() { Err(NotDrawable::NoDirectClutch) } else { Ok(pairs) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_schemes::structures::Structure;

    #[test]
    fn every_scheme_of_the_catalogue_can_be_drawn_with_a_direct_drive_clutch() {
        for structure in Structure::catalogue() {
            assert!(drawable_direct_clutches(Mechanism::TwoSets(structure)).is_ok(), "{structure}");
        }
    }
}
