//! A set of any kind as bodies and springs: central gears, a carrier, planets, and a list of meshes.
//!
//! # Planar model
//!
//! Every body has `x`, `y`, `u` in axes that turn with the carrier. The first gear of a mesh is `1`, the
//! other `2`. `φ` is the direction from the centre of gear 1 to the pitch point: towards gear 2, of an
//! internal mesh from the ring to the gear in it. With the transverse working pressure angle `α`, the line of
//! action has the unit vector `e`, and the mesh is shorter by `δ`:
//!
//! ```text
//! e = (−sin β, cos β)        β = φ − s·c·α
//! δ = e·(d_1 − d_2) + h_1·θ_1 − h_2·θ_2        h_1 = r_b1,  h_2 = ∓r_b2
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | `d`, `θ` | displacement of a centre, rotation of a body |
//! | `s` | 1 where gear 1 drives gear 2 in the positive direction, −1 where it is driven so: the flank in contact |
//! | `c` | 1; −1 where gear 1 is the internal one, which its mate pushes inwards |
//! | `r_b` | base radius; `h_2` is negative where both gears are external |
//!
//! A planet at the angle `ψ` and the distance `R` from the axis is on its bearing:
//!
//! ```text
//! radial  δ = e_r·(d_c − d_n)        tangential  δ = e_t·(d_c − d_n) + R·θ_c
//! e_r = (cos ψ, sin ψ)               e_t = (−sin ψ, cos ψ)
//! ```
//!
//! A planet is one rigid body, whatever its gears. Two gears on fixed axes have no carrier; the second lies
//! in the direction of `x`. Left out: the change of mesh stiffness over time, friction, gaps, bearings of
//! planets that resist rotation, stiffness from the mean load, motion along the axis, tilting.
//!
//! # Torsional model
//!
//! The centres of central gears and carrier are at rest, and planets are rigid on the carrier:
//! `d_n = R·θ_c·e_t`. The carrier has the inertia `I_c + Σ m_n·R²`. The torsional model is the limit of the
//! planar one as bearings and supports become rigid.

use crate::checks::{positive, within};
use crate::model::{Axis, Body, BodyId, Freedom, Model, Orbiting, SpringId, Support, Term};
use crate::{Error, Stiffness, tolerance};
use epicyclic_units::Physical;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use uom::si::f64::{Angle, Length, MomentOfInertia};

/// A central gear or the carrier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Central {
    /// Mass and inertia of the member; the radius is the base radius of a gear, and for the carrier that of
    /// the planets' circle.
    pub body: Body,
    /// Springs of the member to the ground.
    pub support: Support,
    /// Freedom of the member. A torsional model takes [`Freedom::Planar`] as [`Freedom::Rotation`], and
    /// [`Freedom::Translation`] as held.
    pub freedom: Freedom,
}

impl Central {
    /// A member that moves in the plane on a support.
    #[must_use]
    pub fn new(body: Body, support: Support) -> Self {
        Self { body, support, freedom: Freedom::Planar }
    }

    /// Returns the member held: it neither moves nor rotates.
    #[must_use]
    pub fn held(self) -> Self {
        Self { freedom: Freedom::Held, ..self }
    }
}

/// A central gear or the carrier, with its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// Name of the member.
    pub name: String,
    /// The body with its support.
    pub central: Central,
}

/// A planet on the carrier.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanetBody {
    /// Name of the planet.
    pub name: String,
    /// Mass, inertia, and any radius of the rotation coordinate.
    pub body: Body,
    /// Distance `R` of its centre from the axis.
    pub distance: Length,
    /// Angle `ψ` on the carrier.
    pub angle: Angle,
    /// Radial stiffness of its bearing on the carrier.
    pub bearing: Stiffness,
}

/// Body of a gear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BodyOf {
    /// A member, by its place in [`GearSet::members`].
    Member(usize),
    /// A planet, by its place in [`GearSet::planets`].
    Planet(usize),
}

/// A gear in mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gear {
    /// Body of the gear.
    pub of: BodyOf,
    /// Base radius.
    pub base_radius: Length,
    /// Whether it has internal teeth.
    pub is_internal: bool,
}

/// Two gears in mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearMesh {
    /// The gears.
    pub gears: [Gear; 2],
    /// Stiffness along the line of action.
    pub stiffness: Stiffness,
    /// Transverse working pressure angle.
    pub pressure_angle: Angle,
    /// Whether the first gear drives the second in the positive direction; otherwise it is driven so. The
    /// flank in contact follows.
    pub is_forward: bool,
}

/// A set of any kind.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GearSet {
    /// Central gears and carrier.
    pub members: Vec<Member>,
    /// Place of the carrier among the members; none of gears on fixed axes.
    pub carrier: Option<usize>,
    /// Every single planet.
    pub planets: Vec<PlanetBody>,
    /// Every single mesh.
    pub meshes: Vec<GearMesh>,
}

/// Places of the bodies and springs of a set in its model. Lists are in the order of the set.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GearSetParts {
    /// The members.
    pub members: Vec<BodyId>,
    /// The planets.
    pub planets: Vec<BodyId>,
    /// The meshes.
    pub meshes: Vec<SpringId>,
    /// Radial and tangential spring of each planet's bearing; none in a torsional model.
    pub bearings: Vec<[SpringId; 2]>,
    /// Springs between each member and the ground.
    pub supports: Vec<Vec<SpringId>>,
}

/// Bodies by which a member moves in a model.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Seat {
    /// Body that moves with the centre; none where the centre is at rest.
    pub(crate) centre: Option<BodyId>,
    /// Body that rotates.
    pub(crate) turn: BodyId,
}

impl GearSet {
    /// The planar model of this set alone.
    ///
    /// # Errors
    /// [`Error::TooFew`] for a carrier without planets, [`Error::SameAngle`]; [`Error::OutOfRange`] for a
    /// pressure angle outside 0 to 90°; [`Error::NotPositive`] for a mass, inertia, radius or the stiffness
    /// of a mesh or planet bearing; [`Error::Negative`] for a support; [`Error::NoSuchBody`].
    pub fn planar(&self) -> Result<(Model, GearSetParts), Error> {
        let mut model = Model::new();
        let parts = self.add_planar(&mut model, "")?;
        Ok((model, parts))
    }

    /// The torsional model of this set alone.
    ///
    /// # Errors
    /// As [`Self::planar`].
    pub fn torsional(&self) -> Result<(Model, GearSetParts), Error> {
        let mut model = Model::new();
        let parts = self.add_torsional(&mut model, "")?;
        Ok((model, parts))
    }

    /// Adds the set to a model, planar. The names of bodies and springs begin with `prefix`.
    ///
    /// Sets of one model share its axes. Where their carriers turn at different speeds, this holds for their
    /// rotational modes, and for others where no lateral spring joins the sets.
    ///
    /// # Errors
    /// As [`Self::planar`].
    pub fn add_planar(&self, model: &mut Model, prefix: &str) -> Result<GearSetParts, Error> {
        let (members, supports) = self.add_members(model, prefix, false)?;
        let seats: Vec<Seat> = members.iter().map(|body| Seat { centre: Some(*body), turn: *body }).collect();
        let parts = self.add_planets(model, prefix, &seats)?;
        Ok(GearSetParts { members, supports, ..parts })
    }

    /// Adds the set to a model, torsional.
    ///
    /// # Errors
    /// As [`Self::planar`].
    pub fn add_torsional(&self, model: &mut Model, prefix: &str) -> Result<GearSetParts, Error> {
        let (members, supports) = self.add_members(model, prefix, true)?;
        let seats: Vec<Seat> = members.iter().map(|body| Seat { centre: None, turn: *body }).collect();
        let parts = self.add_planets(model, prefix, &seats)?;
        Ok(GearSetParts { members, supports, ..parts })
    }

    /// Inertia of the planets on their circles, which moves with a carrier that they are rigid on.
    pub(crate) fn orbit_kg_m2(&self) -> f64 {
        let circles = self.planets.chunk_by(|one, other| one.distance == other.distance);
        let inertia = |circle: &[PlanetBody]| {
            let (masses, radius) =
                (circle.iter().map(|planet| planet.body.mass.si()).sum::<f64>(), circle[0].distance.si());
            masses * radius * radius
        };
        circles.map(inertia).sum()
    }

    fn add_members(
        &self,
        model: &mut Model,
        prefix: &str,
        torsional: bool,
    ) -> Result<(Vec<BodyId>, Vec<Vec<SpringId>>), Error> {
        let (mut members, mut supports) = (vec![], vec![]);
        for (place, member) in self.members.iter().enumerate() {
            let name = format!("{prefix}{}", member.name);
            let mut body = member.central.body;
            let freedom = match member.central.freedom {
                Freedom::Planar if torsional => Freedom::Rotation,
                Freedom::Translation if torsional => Freedom::Held,
                other => other,
            };
            if torsional && self.carrier == Some(place) {
                if freedom == Freedom::Rotation {
                    positive(|| format!("inertia of {name}"), body.inertia.si(), "kg·m²")?;
                }
                body.inertia += MomentOfInertia::from_si(self.orbit_kg_m2());
            }
            let id = model.body(&name, &body, freedom)?;
            // A held coordinate has no use for a spring.
            let (of, none) = (member.central.support, Support::default());
            let support = match freedom {
                Freedom::Held => none,
                Freedom::Rotation => Support { radial: none.radial, ..of },
                Freedom::Translation => Support { tangential: none.tangential, ..of },
                Freedom::Planar => of,
            };
            supports.push(model.support(id, support)?);
            members.push(id);
        }
        Ok((members, supports))
    }

    /// Adds planets, meshes and bearings to a model that has the members. Planets whose carrier has no centre
    /// are rigid on it.
    pub(crate) fn add_planets(
        &self,
        model: &mut Model,
        prefix: &str,
        seats: &[Seat],
    ) -> Result<GearSetParts, Error> {
        self.check()?;
        let carrier = self.carrier.map(|place| seats[place]);
        let is_rigid = carrier.is_some_and(|carrier| carrier.centre.is_none());
        let mut parts = GearSetParts::default();
        for planet in &self.planets {
            let freedom = if is_rigid { Freedom::Rotation } else { Freedom::Planar };
            parts.planets.push(model.body(&format!("{prefix}{}", planet.name), &planet.body, freedom)?);
        }
        let u = Axis::Rotation;
        let radius = |model: &Model, body: BodyId| model.body_radius(body).map_or(1.0, Physical::si);
        for mesh in &self.meshes {
            let name = format!("{prefix}mesh of {} and {}", self.name(mesh, 0), self.name(mesh, 1));
            let (phi, alpha) = self.line_of_action_rad(mesh)?;
            let line = [-libm::sin(phi + alpha), libm::cos(phi + alpha)];
            let (mut terms, mut turns, mut carried): (Vec<Term>, Vec<Term>, Vec<Term>) = Default::default();
            for (gear, sign) in mesh.gears.iter().zip([1.0, -1.0]) {
                let (centre, turn) = match gear.of {
                    BodyOf::Member(place) => (seats[place].centre, seats[place].turn),
                    BodyOf::Planet(place) => {
                        let body = parts.planets[place];
                        if let Some(carrier) = carrier.filter(|_| is_rigid) {
                            let planet = &self.planets[place];
                            let along = planet.distance.si() * libm::cos(phi - planet.angle.si() + alpha);
                            carried.push((carrier.turn, u, sign * along / radius(model, carrier.turn)));
                        }
                        (Some(body).filter(|_| !is_rigid), body)
                    }
                };
                if let Some(centre) = centre {
                    terms.extend([(centre, Axis::X, sign * line[0]), (centre, Axis::Y, sign * line[1])]);
                }
                // Only the second of two external gears turns against the line of action.
                let is_turned = sign < 0.0 && mesh.gears.iter().all(|gear| !gear.is_internal);
                let lever = if is_turned { -gear.base_radius.si() } else { gear.base_radius.si() };
                turns.push((turn, u, sign * lever / radius(model, turn)));
            }
            terms.extend(turns.into_iter().chain(carried));
            parts.meshes.push(model.spring(&name, mesh.stiffness, &terms)?);
        }
        let Some(Seat { centre: Some(centre), turn }) = carrier else { return Ok(parts) };
        let carrier_radius = radius(model, turn);
        for (planet, body) in self.planets.iter().zip(parts.planets.clone()) {
            let (psi, lever) = (planet.angle.si(), planet.distance.si() / carrier_radius);
            let [cos, sin] = [libm::cos(psi), libm::sin(psi)];
            let mut spring = |direction: &str, [x, y]: [f64; 2], turned: f64| {
                let name = format!("{prefix}bearing of {}, {direction}", planet.name);
                let between =
                    [(centre, Axis::X, x), (centre, Axis::Y, y), (body, Axis::X, -x), (body, Axis::Y, -y)];
                model.spring(&name, planet.bearing, &[&between[..], &[(turn, u, turned)]].concat())
            };
            parts
                .bearings
                .push([spring("radial", [cos, sin], 0.0)?, spring("tangential", [-sin, cos], lever)?]);
            model.bodies[turn.0].orbiting.push(Orbiting {
                mass_kg: planet.body.mass.si(),
                bearing_n_per_m: planet.bearing.si(),
                angle_rad: psi,
                lever,
            });
        }
        Ok(parts)
    }

    fn name(&self, mesh: &GearMesh, end: usize) -> &str {
        match mesh.gears[end].of {
            BodyOf::Member(place) => &self.members[place].name,
            BodyOf::Planet(place) => &self.planets[place].name,
        }
    }

    /// `φ`, and what the angle `β` of the line of action is beyond it.
    fn line_of_action_rad(&self, mesh: &GearMesh) -> Result<(f64, f64), Error> {
        let field = || format!("pressure angle of the {}'s meshes", self.name(mesh, 0));
        let alpha = within(field, mesh.pressure_angle.si(), [0.0, FRAC_PI_2], "rad")?;
        // The centre of a ring is on the same side of its mate and of the pitch point.
        let [from, to] = if mesh.gears[1].is_internal { [1, 0] } else { [0, 1] };
        let centre = |place: usize| {
            let planet = &self.planets[place];
            let (distance, psi) = (planet.distance.si(), planet.angle.si());
            [distance * libm::cos(psi), distance * libm::sin(psi)]
        };
        let phi = match [mesh.gears[from].of, mesh.gears[to].of] {
            [BodyOf::Member(_), BodyOf::Member(_)] => 0.0,
            [BodyOf::Member(_), BodyOf::Planet(place)] => self.planets[place].angle.si(),
            [BodyOf::Planet(place), BodyOf::Member(_)] => self.planets[place].angle.si() + PI,
            [BodyOf::Planet(one), BodyOf::Planet(other)] => {
                let [one, other] = [centre(one), centre(other)];
                libm::atan2(other[1] - one[1], other[0] - one[0])
            }
        };
        let is_subtracted = mesh.is_forward != mesh.gears[0].is_internal;
        Ok((phi, if is_subtracted { -alpha } else { alpha }))
    }

    /// Refuses places that do not exist, a carrier without planets, and two planets at one place.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let within_set = |index: usize, count: usize| {
            if index < count { Ok(()) } else { Err(Error::NoSuchBody { index, count }) }
        };
        for gear in self.meshes.iter().flat_map(|mesh| &mesh.gears) {
            match gear.of {
                BodyOf::Member(place) => within_set(place, self.members.len())?,
                BodyOf::Planet(place) => within_set(place, self.planets.len())?,
            }
        }
        let Some(carrier) = self.carrier else { return within_set(self.planets.len(), 1) };
        within_set(carrier, self.members.len())?;
        if self.planets.is_empty() {
            return Err(Error::TooFew { of: "planets", count: 0, least: 1 });
        }
        for (index, planet) in self.planets.iter().enumerate() {
            let psi = planet.angle.si();
            within(|| format!("angle of {}", planet.name), psi, [-TAU, TAU], "rad")?;
            let own = positive(|| format!("distance of {}", planet.name), planet.distance.si(), "m")?;
            for (other, before) in self.planets[..index].iter().enumerate() {
                let apart = (psi - before.angle.si()).rem_euclid(TAU);
                let is_as_far = (before.distance.si() - own).abs() < tolerance::SAME_ANGLE * own;
                if is_as_far && apart.min(TAU - apart) < tolerance::SAME_ANGLE {
                    return Err(Error::SameAngle { first: other + 1, second: index + 1 });
                }
            }
        }
        Ok(())
    }
}
