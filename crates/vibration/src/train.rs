//! Sets on common links: the torsional model of a whole gearbox.
//!
//! A link is what turns as one piece: central gears and carriers of sets that are joined, with what is on
//! their shafts. Its coordinate is its angle `θ`, so `u` with the radius 1 m. Meshes are bent as in the
//! [torsional model of one set](crate::gear_set). A link has the inertias of its members and, where it has a
//! carrier, the masses of the planets on their circle; the planets rotate by themselves. A shaft joins two
//! links by a torsional stiffness. A link that is held does not rotate.
//!
//! As many modes have no frequency as the links have freedoms that bend no mesh and no shaft: those that the
//! gearbox keeps.

use crate::checks::not_negative;
use crate::gear_set::{GearSet, GearSetParts, Seat};
use crate::model::{Body, BodyId, Freedom, Model, SpringId, Support};
use crate::{Error, TorsionalStiffness};
use epicyclic_units::Physical;
use uom::si::f64::{Length, Mass, MomentOfInertia};

/// A link.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Name of the link.
    pub name: String,
    /// Inertia of what it has beside the members of sets.
    pub inertia: MomentOfInertia,
    /// Torsional stiffness between it and the ground; 0 for none.
    pub support: TorsionalStiffness,
    /// Whether it is held.
    pub held: bool,
}

/// A set with the places of the links of its members.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Name of the set, with which the names of its bodies and springs begin.
    pub name: String,
    /// The set; of its members inertias count, supports and freedoms do not.
    pub set: GearSet,
    /// Links of the members, in their order.
    pub links: Vec<usize>,
}

/// A shaft between two links.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaft {
    /// Name of the shaft.
    pub name: String,
    /// The links.
    pub links: [usize; 2],
    /// Torsional stiffness of the shaft.
    pub stiffness: TorsionalStiffness,
}

/// Places of the links and sets in the model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TrainParts {
    /// The links.
    pub links: Vec<BodyId>,
    /// Planets and meshes of each set.
    pub sets: Vec<GearSetParts>,
    /// The shafts.
    pub shafts: Vec<SpringId>,
    /// The support of each link; empty without.
    pub supports: Vec<Vec<SpringId>>,
}

/// The torsional model of sets on links.
///
/// # Errors
/// [`Error::NotPositive`] for a link that turns without any inertia, and as [`GearSet::torsional`];
/// [`Error::Negative`] for an inertia; [`Error::NoSuchBody`] for a place of a link.
pub fn torsional(links: &[Link], sets: &[Placed], shafts: &[Shaft]) -> Result<(Model, TrainParts), Error> {
    let mut inertias = inertias(links)?;
    for Placed { set, links, name } in sets {
        set.check()?;
        add_inertias(&mut inertias, set, links, name)?;
        if let Some(carrier) = set.carrier {
            inertias[links[carrier]] += set.orbit_kg_m2();
        }
    }
    let mut model = Model::new();
    let mut parts = TrainParts::default();
    (parts.links, parts.supports) = add_links(&mut model, links, inertias)?;
    for Placed { set, links, name } in sets {
        let seat = |link: &usize| Seat { centre: None, turn: parts.links[*link] };
        let seats: Vec<Seat> = links.iter().map(seat).collect();
        parts.sets.push(set.add_planets(&mut model, name, &seats)?);
    }
    for shaft in shafts {
        let [first, second] = shaft.links.map(|link| at(link, links.len()));
        let joined = [parts.links[first?], parts.links[second?]];
        let springs = model.shaft(&shaft.name, joined, shaft.stiffness, Default::default())?;
        parts.shafts.extend(springs);
    }
    Ok((model, parts))
}

/// Own inertias of the links, kg·m².
pub(crate) fn inertias(links: &[Link]) -> Result<Vec<f64>, Error> {
    let own = |link: &Link| not_negative(|| format!("inertia of {}", link.name), link.inertia.si(), "kg·m²");
    links.iter().map(own).collect()
}

/// Adds the inertias of the members of a set to those of its links.
pub(crate) fn add_inertias(
    inertias: &mut [f64],
    set: &GearSet,
    links: &[usize],
    name: &str,
) -> Result<(), Error> {
    let count = links.len();
    at(set.members.len().max(1) - 1, count)?;
    for (member, link) in set.members.iter().zip(links) {
        let inertia = member.central.body.inertia.si();
        let inertia = not_negative(|| format!("inertia in {name}"), inertia, "kg·m²")?;
        inertias[at(*link, inertias.len())?] += inertia;
    }
    Ok(())
}

/// Adds the links with these inertias, and their supports.
pub(crate) fn add_links(
    model: &mut Model,
    links: &[Link],
    inertias: Vec<f64>,
) -> Result<(Vec<BodyId>, Vec<Vec<SpringId>>), Error> {
    let (mut bodies, mut supports) = (vec![], vec![]);
    for (link, inertia) in links.iter().zip(inertias) {
        let inertia = MomentOfInertia::from_si(inertia);
        let body = Body { mass: Mass::default(), inertia, radius: Length::from_si(1.0) };
        let freedom = if link.held { Freedom::Held } else { Freedom::Rotation };
        let place = model.body(&link.name, &body, freedom)?;
        let tangential = Support::tangential_of(link.support, Length::from_si(1.0));
        let support = Support { tangential, ..Support::default() };
        bodies.push(place);
        supports.push(if link.held { vec![] } else { model.support(place, support)? });
    }
    Ok((bodies, supports))
}

pub(crate) fn at(index: usize, count: usize) -> Result<usize, Error> {
    if index < count { Ok(index) } else { Err(Error::NoSuchBody { index, count }) }
}
