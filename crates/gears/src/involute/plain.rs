//! Gears without profile shift that cannot be cut or turned together: what a search for tooth numbers leaves
//! out.
//!
//! Each gear is cut by its [usual tool](super::tool::Tool::usual), the tips of the ring are shortened to stay
//! out of the fillets of the planets. Undercut is no reason: such gears turn, and are marked. Nor are tips of
//! planets that reach into the fillets of a ring by a small shaper, which a larger shaper or shorter tips
//! avoid.

use super::check::{Check, Place, Rule, SetMesh, Severity};
use super::checks::{Limits, gear_checks, mesh_checks};
use super::{InvoluteGear, Pair, Profile};
use crate::gear_kind::GearKind;
use crate::rack::BasicRack;
use crate::{Error, ToothCount};
use std::collections::BTreeMap;

/// The first check of sun, planet and ring on one centre distance that does not hold and is an error.
///
/// The gap between planets is left to the search, which knows their number.
///
/// # Errors
/// Those of [`Pair::without_backlash`].
pub fn miss(teeth: [ToothCount; 3], rack: &BasicRack) -> Result<Option<Check>, Error> {
    let [sun, planet, ring] = teeth;
    let of_mesh = |mesh: SetMesh, teeth, second| {
        let places = Places {
            gears: mesh.gears().map(Place::Gear),
            mesh: Place::Mesh(mesh),
            tips: mesh.gears().map(|gear| Place::Tips(gear, mesh)),
        };
        mesh_miss(teeth, second, &places, rack)
    };
    let of_sun = of_mesh(SetMesh::SunPlanet, [sun, planet], GearKind::External)?;
    if of_sun.is_some() {
        Ok(of_sun)
    } else {
        of_mesh(SetMesh::PlanetRing, [planet, ring], GearKind::Internal)
    }
}

/// A mesh of a double-planet set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum DoublePlanetMesh {
    SunInner,
    InnerOuter,
    OuterRing,
}

impl DoublePlanetMesh {
    const fn second(self) -> GearKind {
        match self {
            Self::SunInner | Self::InnerOuter => GearKind::External,
            Self::OuterRing => GearKind::Internal,
        }
    }

    const fn places(self) -> Places<&'static str> {
        let [gears, mesh, tips] = match self {
            Self::SunInner => [
                ["the sun", "the inner planet"],
                ["the mesh of sun and inner planet", ""],
                [
                    "the tips of the sun, mesh with the inner planet,",
                    "the tips of the inner planet, mesh with the sun,",
                ],
            ],
            Self::InnerOuter => [
                ["the inner planet", "the outer planet"],
                ["the mesh of inner and outer planet", ""],
                [
                    "the tips of the inner planet, mesh with the outer one,",
                    "the tips of the outer planet, mesh with the inner one,",
                ],
            ],
            Self::OuterRing => [
                ["the outer planet", "the ring"],
                ["the mesh of outer planet and ring", ""],
                [
                    "the tips of the outer planet, mesh with the ring,",
                    "the tips of the ring, mesh with the outer planet,",
                ],
            ],
        };
        Places { gears, mesh: mesh[0], tips }
    }
}

/// Results for the meshes of double-planet sets of one rack: each mesh is checked once, since it occurs in
/// many sets.
#[derive(Debug)]
pub struct DoublePlanetMeshes<'a> {
    rack: &'a BasicRack,
    known: BTreeMap<(DoublePlanetMesh, [ToothCount; 2]), Option<Check<&'static str>>>,
}

impl<'a> DoublePlanetMeshes<'a> {
    /// Meshes of a rack, not checked yet.
    #[must_use]
    pub fn new(rack: &'a BasicRack) -> Self {
        Self { rack, known: BTreeMap::default() }
    }

    /// The first check of sun, inner planet, outer planet and ring that does not hold and is an error.
    ///
    /// # Errors
    /// Those of [`Pair::without_backlash`].
    pub fn miss(&mut self, teeth: [ToothCount; 4]) -> Result<Option<Check<&'static str>>, Error> {
        let [sun, inner, outer, ring] = teeth;
        for (mesh, teeth) in [
            (DoublePlanetMesh::SunInner, [sun, inner]),
            (DoublePlanetMesh::InnerOuter, [inner, outer]),
            (DoublePlanetMesh::OuterRing, [outer, ring]),
        ] {
            let miss = match self.known.get(&(mesh, teeth)) {
                Some(known) => *known,
                None => {
                    let miss = mesh_miss(teeth, mesh.second(), &mesh.places(), self.rack)?;
                    self.known.insert((mesh, teeth), miss);
                    miss
                }
            };
            if miss.is_some() {
                return Ok(miss);
            }
        }
        Ok(None)
    }
}

/// Names of the gears of a mesh, of the mesh itself and of the tips of each gear in it.
pub(crate) struct Places<P> {
    pub(crate) gears: [P; 2],
    pub(crate) mesh: P,
    pub(crate) tips: [P; 2],
}

fn mesh_miss<P: Copy>(
    teeth: [ToothCount; 2],
    second: GearKind,
    places: &Places<P>,
    rack: &BasicRack,
) -> Result<Option<Check<P>>, Error> {
    let profile = Profile::of_rack(*rack);
    let one = InvoluteGear::searched(GearKind::External, teeth[0], profile);
    let other = InvoluteGear::searched(second, teeth[1], profile);
    pair_miss([one, other], places, false)
}

/// The first check of two gears in mesh that does not hold and is an error; gears with errors have no teeth.
/// Tips that reach into fillets count for external gears on request, never for internal ones.
///
/// # Errors
/// Those of [`Pair::without_backlash`].
pub(crate) fn pair_miss<P: Copy>(
    [one, other]: [Result<InvoluteGear, Error>; 2],
    places: &Places<P>,
    fillets: bool,
) -> Result<Option<Check<P>>, Error> {
    // Pointed teeth and missing teeth are both faults of the gear.
    let (one, other) = match (one, other) {
        (Ok(one), Ok(other)) => (one, other),
        (Err(_), _) => return Ok(Some(no_teeth(places.gears[0]))),
        (_, Err(_)) => return Ok(Some(no_teeth(places.gears[1]))),
    };
    let second = other.kind();
    let pair = Pair::without_backlash(one, other)?;
    let Ok(pair) = pair.with_clear_ring_tips() else { return Ok(Some(no_teeth(places.gears[1]))) };
    let mut first = None;
    let mut see = |check: Check<P>| {
        // Planets of a large ring are cut a little shorter, or the ring by a larger shaper.
        let is_fillet = check.rule == Rule::Fillet && !(fillets && second == GearKind::External);
        let counts = check.rule.severity() == Severity::Error && !check.holds() && !is_fillet;
        if counts && first.is_none() {
            first = Some(check);
        }
    };
    let limits = Limits::default();
    for (place, gear) in places.gears.iter().zip(pair.gears()) {
        gear_checks(place, gear, &limits, &mut see);
    }
    mesh_checks(&places.mesh, &places.tips, &pair, &limits, &mut see);
    Ok(first)
}

fn no_teeth<P>(place: P) -> Check<P> {
    Check { rule: Rule::TipThickness, place, value: 0.0, limit: Limits::default().tip_thickness }
}
