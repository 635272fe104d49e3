//! Which mechanisms, and which of their direct-drive clutches, can be drawn without self-crossing.
//!
//! Brakes, input and output are drawn always; of the options for that clutch only the one chosen is built, so a
//! mechanism is drawable if at least one of them can be drawn with the rest, and the choice is among these.

use super::mechanism::Mechanism;
use epicyclic_layout::{Options, Verdict, direct_clutch_options, draw, is_drawable};
use epicyclic_schemes::structures::Role;

/// The pairs of links between which a direct-drive clutch can be drawn; where there are none, what cannot be
/// drawn together.
pub fn drawable_direct_clutches(mechanism: Mechanism) -> Result<Vec<[Role; 2]>, String> {
    // Whether a scheme can be drawn does not depend on k.
    let gearbox = mechanism.without_direct_clutch(3.0).map_err(|error| error.to_string())?;
    if !is_drawable(&gearbox) {
        return match draw(&gearbox, Options { attempts: 1, ..Options::default() }) {
            Verdict::SelfCrossing(witness) => Err(witness.describe(&gearbox)),
            Verdict::Drawable(_) => unreachable!("both verdicts are one"),
        };
    }
    let role = |link| Role::ALL.into_iter().find(|role| gearbox.link(role.symbol()) == Some(link));
    let pairs = direct_clutch_options(&gearbox).into_iter();
    let pairs: Vec<[Role; 2]> = pairs.filter_map(|[x, y]| Some([role(x)?, role(y)?])).collect();
    if pairs.is_empty() { Err("no direct-drive clutch can be drawn with the rest".into()) } else { Ok(pairs) }
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
