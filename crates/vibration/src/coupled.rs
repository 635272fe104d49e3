//! Sets on common links: the planar model of a whole gearbox.
//!
//! A link is the parts that turn as one piece, a centre the parts that move in the plane as one piece. They
//! are bodies of their own, since members that a clutch lets turn together need not move together. The
//! springs depend on the angle `θ` of a link and the displacement `d = (x, y)` of a centre. With the base
//! radii `r`, the radius `r_c` of the planets' circle and the unit vectors of the [planar model of one
//! set](crate::planetary) their elongations are:
//!
//! ```text
//! sun–planet        δ_s = t_s·(d_s − d_n) + r_s·θ_s + u_n
//! ring–planet       δ_r = t_r·(d_r − d_n) + r_r·θ_r − u_n
//! bearing, radial   δ_x = e_r·(d_c − d_n)
//! bearing, tang.    δ_y = e_t·(d_c − d_n) + r_c·θ_c
//! ```
//!
//! A link has the inertias of its members without planets, a centre their masses and their radial supports. A
//! shaft joins two links by a torsional stiffness and two centres by a lateral one.
//!
//! # Axes
//! The axes of a set turn with its carrier. At rest all are the same. In a set of three or more equal planets
//! at equal angles, the planets have the same stiffness for every direction of a centre's motion. So the
//! angle between such sets, or to one other set, does not matter. If all sets are such, each mode is of one
//! kind:
//!
//! | kind | links | centres | planets |
//! |---|---|---|---|
//! | rotational | rotate | are at rest | those of a set all do the same |
//! | translational, double | are at rest | translate | |
//! | planet, `N − 3` times for each frequency of a set | are at rest | are at rest | of this set alone |
//!
//! # Source
//! D. R. Kiracofe, R. G. Parker, Structured vibration modes of general compound planetary gear systems,
//! Journal of Vibration and Acoustics 129 (2007) 1–16, for the kinds; the energies are those of the planar
//! model of each set.

use crate::checks::not_negative;
use crate::model::{Axis, Body, BodyId, Freedom, Model, Orbiting, SpringId, Support};
use crate::planetary::PlanetarySet;
use crate::train::Link;
use crate::{Error, Stiffness, TorsionalStiffness, newtons_per_meter};
use epicyclic_units::Physical;
use uom::si::f64::{Length, Mass, MomentOfInertia};

/// A centre: what moves in the plane as one piece.
#[derive(Debug, Clone, PartialEq)]
pub struct Centre {
    /// Name of the centre.
    pub name: String,
    /// Mass of what it has beside the members of sets.
    pub mass: Mass,
    /// Whether it is held.
    pub held: bool,
}

/// A set with the places of the links and the centres of its sun, ring and carrier.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed<'s> {
    /// Name of the set, with which the names of its bodies and springs begin.
    pub name: String,
    /// The set; of its members masses, inertias, radii and radial supports count, tangential supports and
    /// freedoms do not.
    pub set: &'s PlanetarySet,
    /// Links of sun, ring and carrier.
    pub links: [usize; 3],
    /// Centres of sun, ring and carrier.
    pub centres: [usize; 3],
}

/// A shaft between two links, and between two centres.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaft {
    /// Name of the shaft.
    pub name: String,
    /// The links, with its torsional stiffness.
    pub links: Option<([usize; 2], TorsionalStiffness)>,
    /// The centres, with its lateral stiffness.
    pub centres: Option<([usize; 2], Stiffness)>,
}

/// Places of links, centres and sets in the model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CoupledParts {
    /// The links.
    pub links: Vec<BodyId>,
    /// The centres.
    pub centres: Vec<BodyId>,
    /// Planets of each set.
    pub planets: Vec<Vec<BodyId>>,
    /// Meshes of the sun of each set.
    pub sun_meshes: Vec<Vec<SpringId>>,
    /// Meshes of the ring of each set.
    pub ring_meshes: Vec<Vec<SpringId>>,
    /// Bearings of the planets of each set.
    pub bearings: Vec<Vec<SpringId>>,
    /// Springs of each shaft: torsion, bending.
    pub shafts: Vec<[Vec<SpringId>; 2]>,
    /// The support of each link against rotation; empty without.
    pub link_supports: Vec<Vec<SpringId>>,
    /// The radial support of each centre; empty without.
    pub centre_supports: Vec<Vec<SpringId>>,
}

impl CoupledParts {
    /// Links and centres, which determine the kind of a mode.
    #[must_use]
    pub fn central(&self) -> Vec<BodyId> {
        self.links.iter().chain(&self.centres).copied().collect()
    }
}

/// The planar model of sets on links and centres.
///
/// # Errors
/// [`Error::NotPositive`] for a link that turns without any inertia and a centre that moves without any mass,
/// and as [`PlanetarySet::planar`]; [`Error::Negative`] for an inertia, mass or stiffness;
/// [`Error::NoSuchBody`] for a place of a link or centre.
pub fn planar(
    links: &[Link],
    centres: &[Centre],
    sets: &[Placed<'_>],
    shafts: &[Shaft],
) -> Result<(Model, CoupledParts), Error> {
    let mut inertias = links
        .iter()
        .map(|link| not_negative(|| format!("inertia of {}", link.name), link.inertia.si(), "kg·m²"))
        .collect::<Result<Vec<f64>, Error>>()?;
    let mut masses = centres
        .iter()
        .map(|centre| not_negative(|| format!("mass of {}", centre.name), centre.mass.si(), "kg"))
        .collect::<Result<Vec<f64>, Error>>()?;
    // Several members may share a link or a centre: their inertias, masses and supports add up.
    let mut supports = vec![0.0; centres.len()];
    for placed in sets {
        placed.set.check_planets()?;
        let Placed { set, name, .. } = placed;
        for (member, central) in [&set.sun, &set.ring, &set.carrier].into_iter().enumerate() {
            let link = at(placed.links[member], links.len())?;
            let centre = at(placed.centres[member], centres.len())?;
            let inertia = central.body.inertia.si();
            inertias[link] += not_negative(|| format!("inertia in {name}"), inertia, "kg·m²")?;
            let mass = central.body.mass.si();
            masses[centre] += not_negative(|| format!("mass in {name}"), mass, "kg")?;
            let radial = central.support.radial.si();
            supports[centre] += not_negative(|| format!("support in {name}"), radial, "N/m")?;
        }
    }
    let mut model = Model::new();
    let mut parts = CoupledParts::default();
    for (link, inertia) in links.iter().zip(inertias) {
        let inertia = MomentOfInertia::from_si(inertia);
        let body = Body { mass: Mass::default(), inertia, radius: Length::from_si(1.0) };
        let place =
            model.body(&link.name, &body, if link.held { Freedom::Held } else { Freedom::Rotation })?;
        let tangential = Support::tangential_of(link.support, Length::from_si(1.0));
        let support = Support { tangential, ..Support::default() };
        parts.links.push(place);
        parts.link_supports.push(if link.held { vec![] } else { model.support(place, support)? });
    }
    for ((centre, of_members), support) in centres.iter().zip(masses).zip(supports) {
        let body = Body {
            mass: Mass::from_si(of_members),
            inertia: MomentOfInertia::from_si(0.0),
            radius: Length::from_si(1.0),
        };
        let freedom = if centre.held { Freedom::Held } else { Freedom::Translation };
        let place = model.body(&centre.name, &body, freedom)?;
        let support = Support { radial: newtons_per_meter(support), ..Support::default() };
        parts.centres.push(place);
        parts.centre_supports.push(if centre.held { vec![] } else { model.support(place, support)? });
    }
    for placed in sets {
        add(&mut model, &mut parts, placed)?;
    }
    for shaft in shafts {
        let mut springs = [vec![], vec![]];
        if let Some((ends, stiffness)) = shaft.links {
            let [first, second] = ends.map(|end| at(end, links.len()));
            let ends = [parts.links[first?], parts.links[second?]];
            springs[0] = model.shaft(&shaft.name, ends, stiffness, Stiffness::default())?;
        }
        if let Some((ends, stiffness)) = shaft.centres {
            let [first, second] = ends.map(|end| at(end, centres.len()));
            let ends = [parts.centres[first?], parts.centres[second?]];
            springs[1] = model.shaft(&shaft.name, ends, TorsionalStiffness::default(), stiffness)?;
        }
        parts.shafts.push(springs);
    }
    Ok((model, parts))
}

fn at(index: usize, count: usize) -> Result<usize, Error> {
    if index < count { Ok(index) } else { Err(Error::NoSuchBody { index, count }) }
}

/// Adds the planets of a set with their springs.
fn add(model: &mut Model, parts: &mut CoupledParts, placed: &Placed<'_>) -> Result<(), Error> {
    let Placed { set, name, .. } = placed;
    let [alpha_s, alpha_r] = set.pressure_angles()?;
    let links = placed.links.map(|link| parts.links[link]);
    let centres = placed.centres.map(|centre| parts.centres[centre]);
    let radii = [&set.sun, &set.ring, &set.carrier].map(|central| central.body.radius.si());
    let u = Axis::Rotation;
    let (mut planets, mut sun_meshes, mut ring_meshes, mut bearings) = (vec![], vec![], vec![], vec![]);
    for (index, planet) in set.planets.iter().enumerate() {
        let (number, psi) = (index + 1, planet.angle.si());
        let p = model.body(&format!("{name}planet {number}"), &planet.body, Freedom::Planar)?;
        let line = |angle: f64| [-libm::sin(angle), libm::cos(angle)];
        let mut spring = |what: String, stiffness, member: usize, [x, y]: [f64; 2], rotations: [f64; 2]| {
            let centre = centres[member];
            let terms = [
                (centre, Axis::X, x),
                (centre, Axis::Y, y),
                (p, Axis::X, -x),
                (p, Axis::Y, -y),
                (links[member], u, rotations[0]),
                (p, u, rotations[1]),
            ];
            model.spring(&format!("{name}{what}"), stiffness, &terms)
        };
        let mesh = format!("mesh of sun and planet {number}");
        sun_meshes.push(spring(mesh, planet.sun_mesh, 0, line(psi - alpha_s), [radii[0], 1.0])?);
        let mesh = format!("mesh of ring and planet {number}");
        ring_meshes.push(spring(mesh, planet.ring_mesh, 1, line(psi + alpha_r), [radii[1], -1.0])?);
        let radial = [libm::cos(psi), libm::sin(psi)];
        let of_bearing = |direction: &str| format!("bearing of planet {number}, {direction}");
        bearings.push(spring(of_bearing("radial"), planet.bearing, 2, radial, [0.0, 0.0])?);
        bearings.push(spring(of_bearing("tangential"), planet.bearing, 2, line(psi), [radii[2], 0.0])?);
        model.bodies[links[2].0].orbiting.push(Orbiting {
            mass_kg: planet.body.mass.si(),
            bearing_n_per_m: planet.bearing.si(),
            angle_rad: psi,
            lever: radii[2],
        });
        planets.push(p);
    }
    parts.planets.push(planets);
    parts.sun_meshes.push(sun_meshes);
    parts.ring_meshes.push(ring_meshes);
    parts.bearings.push(bearings);
    Ok(())
}
