//! Sets on common links: the torsional model of a whole gearbox.
//!
//! A link is what turns as one piece: sun, ring and carrier of sets that are joined, with what is on their
//! shafts. Its coordinate is its angle `θ`, so `u` with the radius 1 m. With base radii `r` and the radius
//! `r_c` of the planets' circle, meshes are bent by
//!
//! ```text
//! δ_s = r_s·θ_s + u_n − r_c·θ_c·cos α_s,     δ_r = r_r·θ_r − u_n − r_c·θ_c·cos α_r
//! ```
//!
//! as in the [torsional model of one set](crate::planetary). A link has the inertias of its members and,
//! where it has a carrier, the masses of the planets on their circle; the planets rotate by themselves. A
//! shaft joins two links by a torsional stiffness. A link that is held does not rotate.
//!
//! As many modes have no frequency as the links have freedoms that bend no mesh and no shaft: those that the
//! gearbox keeps.

use crate::checks::not_negative;
use crate::model::{Axis, Body, BodyId, Freedom, Model, SpringId, Support};
use crate::planetary::PlanetarySet;
use crate::{Error, TorsionalStiffness};
use epicyclic_units::Physical;
use uom::si::f64::{Length, MomentOfInertia};

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

/// A set with the places of the links of its sun, ring and carrier.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed<'s> {
    /// Name of the set, with which the names of its bodies and springs begin.
    pub name: String,
    /// The set; of its members inertias and radii count, supports and freedoms do not.
    pub set: &'s PlanetarySet,
    /// Links of sun, ring and carrier.
    pub links: [usize; 3],
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
#[derive(Debug, Clone, PartialEq)]
pub struct TrainParts {
    /// The links.
    pub links: Vec<BodyId>,
    /// Planets of each set.
    pub planets: Vec<Vec<BodyId>>,
    /// Meshes of the sun of each set.
    pub sun_meshes: Vec<Vec<SpringId>>,
    /// Meshes of the ring of each set.
    pub ring_meshes: Vec<Vec<SpringId>>,
    /// The shafts.
    pub shafts: Vec<SpringId>,
    /// The support of each link; empty without.
    pub supports: Vec<Vec<SpringId>>,
}

/// The torsional model of sets on links.
///
/// # Errors
/// [`Error::NotPositive`] for a link that turns without any inertia, and as [`PlanetarySet::torsional`];
/// [`Error::Negative`] for an inertia; [`Error::NoSuchBody`] for a place of a link.
pub fn torsional(
    links: &[Link],
    sets: &[Placed<'_>],
    shafts: &[Shaft],
) -> Result<(Model, TrainParts), Error> {
    let count = links.len();
    let at = |index: usize| if index < count { Ok(index) } else { Err(Error::NoSuchBody { index, count }) };
    let mut inertias = Vec::with_capacity(count);
    for link in links {
        inertias.push(not_negative(|| format!("inertia of {}", link.name), link.inertia.si(), "kg·m²")?);
    }
    for Placed { set, links, name } in sets {
        set.check_planets()?;
        for (central, link) in [&set.sun, &set.ring, &set.carrier].into_iter().zip(links) {
            let inertia = central.body.inertia.si();
            inertias[at(*link)?] += not_negative(|| format!("inertia in {name}"), inertia, "kg·m²")?;
        }
        let r_c = set.carrier.body.radius.si();
        let masses: f64 = set.planets.iter().map(|planet| planet.body.mass.si()).sum();
        inertias[links[2]] += masses * r_c * r_c;
    }
    let mut model = Model::new();
    let mut parts = TrainParts {
        links: vec![],
        planets: vec![],
        sun_meshes: vec![],
        ring_meshes: vec![],
        shafts: vec![],
        supports: vec![],
    };
    for (link, inertia) in links.iter().zip(inertias) {
        let body = Body {
            mass: Default::default(),
            inertia: MomentOfInertia::from_si(inertia),
            radius: Length::from_si(1.0),
        };
        let freedom = if link.held { Freedom::Held } else { Freedom::Rotation };
        let place = model.body(&link.name, &body, freedom)?;
        parts.links.push(place);
        let tangential = Support::tangential_of(link.support, Length::from_si(1.0));
        let support = Support { tangential, ..Support::default() };
        parts.supports.push(if link.held { vec![] } else { model.support(place, support)? });
    }
    let u = Axis::Rotation;
    for Placed { set, links, name } in sets {
        let [alpha_s, alpha_r] = set.pressure_angles()?;
        let [sun, ring, carrier] = links.map(|link| parts.links[link]);
        let [r_s, r_r, r_c] = [&set.sun, &set.ring, &set.carrier].map(|central| central.body.radius.si());
        let (mut planets, mut sun_meshes, mut ring_meshes) = (vec![], vec![], vec![]);
        for (index, planet) in set.planets.iter().enumerate() {
            let number = index + 1;
            let p = model.body(&format!("{name}planet {number}"), &planet.body, Freedom::Rotation)?;
            let terms = [(sun, u, r_s), (p, u, 1.0), (carrier, u, -r_c * libm::cos(alpha_s))];
            let mesh = format!("{name}mesh of sun and planet {number}");
            sun_meshes.push(model.spring(&mesh, planet.sun_mesh, &terms)?);
            let terms = [(ring, u, r_r), (p, u, -1.0), (carrier, u, -r_c * libm::cos(alpha_r))];
            let mesh = format!("{name}mesh of ring and planet {number}");
            ring_meshes.push(model.spring(&mesh, planet.ring_mesh, &terms)?);
            planets.push(p);
        }
        parts.planets.push(planets);
        parts.sun_meshes.push(sun_meshes);
        parts.ring_meshes.push(ring_meshes);
    }
    for shaft in shafts {
        let joined = [parts.links[at(shaft.links[0])?], parts.links[at(shaft.links[1])?]];
        let springs = model.shaft(&shaft.name, joined, shaft.stiffness, Default::default())?;
        parts.shafts.extend(springs);
    }
    Ok((model, parts))
}
