//! Gears without profile shift that cannot be cut or turned together: what a search for tooth numbers leaves out.
//!
//! Each gear is cut by its [usual tool](super::tool::Tool::usual), the tips of the ring are shortened to stay out of the fillets of the planets. Undercut is no reason:
//! such gears turn, and are marked. Nor are tips of planets that reach into the fillets of a ring by a small
//! shaper, which a larger shaper or shorter tips avoid.

use super::check::{Check, Place, Rule, SetMesh, Severity};
use super::checks::{Limits, gear_checks, mesh_checks};
use super::{InvoluteGear, Pair, Profile};
use crate::gear_kind::GearKind;
use crate::quantity::SimpleGear;
use crate::rack::BasicRack;
use crate::{Error, ToothCount};

/// The first check of sun, planet and ring on one centre distance that does not hold and is an error.
///
/// The gap between planets is left to the search, which knows their number.
///
/// # Errors
/// Those of [`Pair::without_backlash`].
pub fn miss(teeth: [ToothCount; 3], rack: &BasicRack) -> Result<Option<Check>, Error> {
    let [sun, planet, ring] = teeth;
    let sun_mesh = mesh_miss([sun, planet], GearKind::External, SetMesh::SunPlanet, rack)?;
    Ok(match sun_mesh {
        Some(miss) => Some(miss),
        None => mesh_miss([planet, ring], GearKind::Internal, SetMesh::PlanetRing, rack)?,
    })
}

fn mesh_miss(
    teeth: [ToothCount; 2],
    second: GearKind,
    mesh: SetMesh,
    rack: &BasicRack,
) -> Result<Option<Check>, Error> {
    let profile = Profile::of_rack(*rack);
    let one = InvoluteGear::searched(GearKind::External, teeth[0], profile);
    let other = InvoluteGear::searched(second, teeth[1], profile);
    let [first_name, second_name] = mesh.gears();
    // Teeth that are pointed or none are as little to be had.
    let (one, other) = match (one, other) {
        (Ok(one), Ok(other)) => (one, other),
        (Err(_), _) => return Ok(Some(no_teeth(first_name))),
        (_, Err(_)) => return Ok(Some(no_teeth(second_name))),
    };
    let pair = Pair::without_backlash(one, other)?;
    let Ok(pair) = pair.with_clear_ring_tips() else { return Ok(Some(no_teeth(second_name))) };
    let mut first = None;
    let mut see = |check: Check| {
        // Planets of a large ring are cut a little shorter, or the ring by a larger shaper.
        let is_fillet = check.rule == Rule::Fillet;
        let counts = check.rule.severity() == Severity::Error && !check.holds() && !is_fillet;
        if counts && first.is_none() {
            first = Some(check);
        }
    };
    let limits = Limits::default();
    for (name, gear) in [(first_name, &pair.gears()[0]), (second_name, &pair.gears()[1])] {
        gear_checks(&Place::Gear(name), gear, &limits, &mut see);
    }
    let tips = mesh.gears().map(|gear| Place::Tips(gear, mesh));
    mesh_checks(&Place::Mesh(mesh), &tips, &pair, &limits, &mut see);
    Ok(first)
}

fn no_teeth(gear: SimpleGear) -> Check {
    Check {
        rule: Rule::TipThickness,
        place: Place::Gear(gear),
        value: 0.0,
        limit: Limits::default().tip_thickness,
    }
}
