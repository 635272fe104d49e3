//! Orders of excitation of a set in a gear, in coordinates on the carrier.
//!
//! In these coordinates planets are at rest, and parts that turn with a central gear pass them. With the
//! speeds `ν` of gears relative to the carrier:
//!
//! | source | frequency | periods a turn `p` |
//! |---|---|---|
//! | harmonic `l` of meshes | `l·z·|ν|` of any gear in them | `l·z_c` of their central gear `c` |
//! | a turn of a central gear | `|ν_c|` | 1 |
//! | `N` planets that pass a place of a central gear | `N·|ν_c|` | `N` |
//! | a turn of a planet | `|ν_p|` | each planet has its own phase |
//!
//! The modes that `p` excites are given by [`phasing`] for equally spaced planets; with other spacings it may
//! excite all. Meshes that share gears have one frequency; those of the two steps of a planet have two. From
//! a central gear on, a planet of one gear passes the phase of its meshes on to its other meshes.

use super::prepared::{Mesh, Of, Prepared};
use super::records::{Order, Source};
use crate::tolerance::ROUNDED;
use epicyclic_train::compound::CentralKind;
use epicyclic_train::in_mesh::sharing;
use epicyclic_train::planet_set::GearOf;
use epicyclic_vibration::phasing;
use std::f64::consts::TAU;
use uom::si::f64::Length;

/// Order with what its phases follow from.
pub(super) struct Phased {
    pub(super) order: Order,
    /// Periods around the set; `None` if each planet has its own phase.
    pub(super) periods: Option<u64>,
    /// Meshes that excite; empty for other sources.
    pub(super) meshes: Vec<usize>,
}

/// Lists the orders whose frequency is not 0, harmonics of the meshes last. Speeds are those of the members,
/// relative to the input speed; `fastest` is the greatest speed of the input, rad/s.
pub(super) fn all(
    of: &Of<'_>,
    prepared: &Prepared,
    gear: &str,
    speeds: &[f64],
    (harmonics, fastest): (u32, f64),
) -> Vec<Phased> {
    let set = of.set;
    let centrals = set.centrals();
    let (planets, is_simple) = (prepared.planets, prepared.is_simple());
    let carrier = speeds.get(centrals.len()).copied().unwrap_or_default();
    let excited =
        |periods: u64| phasing::excited(periods, planets).ok().filter(|_| prepared.is_equally_spaced());
    let order = |source, part: &str, harmonic, of_input: f64, periods: Option<u64>| Phased {
        order: Order {
            set: set.id().to_owned(),
            gear: gear.to_owned(),
            source,
            part: (!is_simple).then(|| part.to_owned()),
            harmonic,
            of_input,
            frequency_hz: of_input * fastest / TAU,
            excites: periods.and_then(excited),
        },
        periods,
        meshes: vec![],
    };
    let relative = |central: usize| (speeds[central] - carrier).abs();
    // Teeth that pass a mesh with a central gear, in a turn of the input.
    let passing = |mesh: &Mesh| {
        let [one, other] = mesh.gears.map(|gear| gear.0);
        let of = |gear: GearOf| match gear {
            GearOf::Central(central) => Some(f64::from(prepared.teeth_of(gear)?) * relative(central)),
            GearOf::Planet(..) => None,
        };
        of(one).or_else(|| of(other))
    };
    let of_planet = |planet: usize| {
        let own = |gear: &(GearOf, Length)| matches!(gear.0, GearOf::Planet(of, _) if of == planet);
        let by_teeth = prepared.meshes.iter().find_map(|mesh| {
            let gear = mesh.gears.iter().find(|gear| own(gear))?.0;
            Some(passing(mesh)? / f64::from(prepared.teeth_of(gear)?))
        });
        by_teeth.or_else(|| Some(set.planet_factor(planet)?.abs() * relative(0)))
    };
    let name = |central: usize| prepared.members[central].name.as_str();
    let mut orders = vec![];
    for (central, own) in centrals.iter().enumerate() {
        let source = match own.kind {
            _ if set.is_pair() => Source::GearTurn,
            CentralKind::Ring => Source::RingTurn,
            _ => Source::SunTurn,
        };
        orders.push(order(source, name(central), 1, relative(central), Some(1)));
    }
    for (planet, kind) in prepared.planet_kinds.iter().enumerate() {
        let turn = of_planet(planet).unwrap_or_default();
        orders.push(order(Source::PlanetTurn, &kind.name, 1, turn, None));
    }
    for (central, own) in centrals.iter().enumerate().filter(|_| planets > 0) {
        let source =
            if own.kind == CentralKind::Ring { Source::RingPlanetPass } else { Source::SunPlanetPass };
        let passes = f64::from(planets) * relative(central);
        orders.push(order(source, name(central), 1, passes, Some(planets.into())));
    }
    let gears: Vec<[GearOf; 2]> = prepared.meshes.iter().map(|mesh| mesh.gears.map(|gear| gear.0)).collect();
    // Meshes that share gears have one frequency.
    for meshes in sharing(&gears) {
        let own = || meshes.iter().map(|mesh| &prepared.meshes[*mesh]);
        let central = own().flat_map(|mesh| &mesh.gears).find(|gear| matches!(gear.0, GearOf::Central(_)));
        let teeth = central.and_then(|gear| prepared.teeth_of(gear.0));
        // Meshes of planets alone have the teeth of one of them.
        let of_planets = || {
            let gear = own().next()?.gears[0].0;
            let GearOf::Planet(planet, _) = gear else { return None };
            Some(f64::from(prepared.teeth_of(gear)?) * of_planet(planet)?)
        };
        let Some(passing) = own().find_map(passing).or_else(of_planets) else { continue };
        let names: Vec<&str> = meshes.iter().map(|mesh| prepared.meshes[*mesh].name.as_str()).collect();
        for harmonic in 1..=harmonics {
            let periods = teeth.map(|teeth| u64::from(harmonic) * u64::from(teeth));
            let of_input = f64::from(harmonic) * passing;
            let one = order(Source::Mesh, &names.join(", "), harmonic, of_input, periods);
            orders.push(Phased { meshes: meshes.clone(), ..one });
        }
    }
    orders.retain(|one| one.order.of_input > ROUNDED);
    orders
}
