//! Calculations of free vibration: a simple set by its bodies and springs, and the closed form of a held
//! ring.

use super::{Calculation, Refusal, Results};
use epicyclic_formats::gearbox::Stiffness;
use epicyclic_units::TorsionalStiffness;
use epicyclic_units::{Physical, Quantity};
use epicyclic_vibration::kahraman::HeldRing;
use epicyclic_vibration::{
    Body, Central, Freedom, Group, Kind, Model, Planet, PlanetarySet, Support, newtons_per_meter,
};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{Angle, Length, Mass, MomentOfInertia};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new(
            "vibration.set",
            "natural frequencies of a simple set, by kinds of modes, planar or torsional",
            set_modes,
        ),
        Calculation::new(
            "vibration.held_ring",
            "torsional frequencies of a set with a held ring in closed form",
            held_ring,
        ),
        Calculation::new("vibration.chain", "natural frequencies of discs on elastic shafts", chain),
    ]
}

/// A body: its inertia in one of two ways.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct BodyGiven {
    /// Mass.
    mass: Quantity<Mass>,
    /// Inertia about its centre.
    #[serde(default)]
    inertia: Option<Quantity<MomentOfInertia>>,
    /// In place of the inertia: the inertia over the square of the radius, `I/r²`.
    #[serde(default)]
    rotary_mass: Option<Quantity<Mass>>,
    /// Base radius; of a carrier the radius of the planets' circle. Default 1 m: frequencies depend on
    /// `I/r²` alone.
    #[serde(default)]
    radius: Option<Quantity<Length>>,
}

impl BodyGiven {
    fn body(&self, name: &str) -> Result<Body, Refusal> {
        let radius = self.radius.map_or(Length::from_si(1.0), |radius| radius.0);
        match (self.inertia, self.rotary_mass) {
            (Some(inertia), None) => Ok(Body { mass: self.mass.0, inertia: inertia.0, radius }),
            (None, Some(rotary)) => Ok(Body::with_rotary_mass(self.mass.0, rotary.0, radius)),
            _ => Err(Refusal {
                name: "inertia-in-one-way".into(),
                message: format!("{name}: give either inertia or rotary_mass"),
            }),
        }
    }
}

/// Sun, ring or carrier.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CentralGiven {
    /// The body.
    body: BodyGiven,
    /// Radial stiffness of its support. Default 0.
    #[serde(default)]
    radial: Option<Quantity<Stiffness>>,
    /// Tangential stiffness of its support, the torsional one over the square of the radius. Default 0.
    #[serde(default)]
    tangential: Option<Quantity<Stiffness>>,
    /// Whether it neither moves nor turns. Default: it is free.
    #[serde(default)]
    held: bool,
}

impl CentralGiven {
    fn central(&self, name: &str) -> Result<Central, Refusal> {
        let stiffness =
            |given: Option<Quantity<Stiffness>>| given.map_or(newtons_per_meter(0.0), |one| one.0.into());
        let support = Support { radial: stiffness(self.radial), tangential: stiffness(self.tangential) };
        let central = Central::new(self.body.body(name)?, support);
        Ok(if self.held { central.held() } else { central })
    }
}

/// Motions of a model.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum MotionsGiven {
    /// Translations and rotations in the plane.
    Planar,
    /// Rotations alone; supports and bearings are rigid.
    Torsional,
}

/// Equal planets.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct PlanetsGiven {
    /// How many, equally spaced; or give `angles`.
    #[serde(default)]
    count: Option<u32>,
    /// Angles of the planets on the carrier; or give `count`.
    #[serde(default)]
    angles: Option<Vec<Quantity<Angle>>>,
    /// One planet.
    body: BodyGiven,
    /// Radial stiffness of its bearing.
    bearing: Quantity<Stiffness>,
    /// Stiffness of its mesh with the sun.
    sun_mesh: Quantity<Stiffness>,
    /// Stiffness of its mesh with the ring.
    ring_mesh: Quantity<Stiffness>,
}

impl PlanetsGiven {
    fn planets(&self) -> Result<Vec<Planet>, Refusal> {
        let planet = Planet {
            body: self.body.body("planet")?,
            angle: Angle::from_si(0.0),
            bearing: self.bearing.0.into(),
            sun_mesh: self.sun_mesh.0.into(),
            ring_mesh: self.ring_mesh.0.into(),
        };
        match (self.count, &self.angles) {
            (Some(count), None) => Ok(planet.equally_spaced(count as usize)),
            (None, Some(angles)) => {
                Ok(angles.iter().map(|angle| Planet { angle: angle.0, ..planet }).collect())
            }
            _ => Err(Refusal {
                name: "planets-in-one-way".into(),
                message: "planets: give either count or angles".into(),
            }),
        }
    }
}

/// A simple set as bodies and springs.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SetGiven {
    /// Motions of the model.
    motions: MotionsGiven,
    /// The sun.
    sun: CentralGiven,
    /// The ring.
    ring: CentralGiven,
    /// The carrier without planets.
    carrier: CentralGiven,
    /// The planets.
    planets: PlanetsGiven,
    /// Working pressure angle of the sun's meshes.
    sun_pressure_angle: Quantity<Angle>,
    /// Working pressure angle of the ring's meshes.
    ring_pressure_angle: Quantity<Angle>,
}

fn set_modes(given: &SetGiven) -> Result<Results, Refusal> {
    let set = PlanetarySet {
        sun: given.sun.central("sun")?,
        ring: given.ring.central("ring")?,
        carrier: given.carrier.central("carrier")?,
        planets: given.planets.planets()?,
        sun_pressure_angle: given.sun_pressure_angle.0,
        ring_pressure_angle: given.ring_pressure_angle.0,
    };
    let (model, parts) = match given.motions {
        MotionsGiven::Planar => set.planar()?,
        MotionsGiven::Torsional => set.torsional()?,
    };
    let groups = model.groups(&parts.central())?;
    let mut results = Results::default();
    results.count("modes", model.size() as i64);
    for (kind, name) in [
        (Kind::Rotational, "rotational"),
        (Kind::Translational, "translational"),
        (Kind::Planet, "planet"),
        (Kind::Mixed, "mixed"),
    ] {
        let of_kind: Vec<&Group> = groups.iter().filter(|group| group.kind == kind).collect();
        results.count(format!("{name}.frequencies"), of_kind.len() as i64);
        for (place, group) in of_kind.into_iter().enumerate() {
            let number = place + 1;
            results
                .quantity(format!("{name}.{number}"), group.frequency)
                .count(format!("{name}.{number}.modes"), group.multiplicity() as i64);
        }
    }
    Ok(results)
}

/// A set with a held ring, as masses along the lines of action.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct HeldRingGiven {
    /// `I/r²` of the sun.
    sun: Quantity<Mass>,
    /// `I/r²` of a planet.
    planet: Quantity<Mass>,
    /// `(I_c/r_c² + Σ m)/cos²α` of the carrier with its planets.
    carrier: Quantity<Mass>,
    /// Stiffness of the sun's mesh with one planet.
    sun_mesh: Quantity<Stiffness>,
    /// Stiffness of the ring's mesh with one planet.
    ring_mesh: Quantity<Stiffness>,
    /// Number of planets.
    planets: u32,
}

fn held_ring(given: &HeldRingGiven) -> Result<Results, Refusal> {
    let found = HeldRing {
        sun: given.sun.0,
        planet: given.planet.0,
        carrier: given.carrier.0,
        sun_mesh: given.sun_mesh.0.into(),
        ring_mesh: given.ring_mesh.0.into(),
        planets: given.planets as usize,
    }
    .frequencies()?;
    let mut results = Results::default();
    results
        .quantity("rotational.1", found.rotational[0])
        .quantity("rotational.2", found.rotational[1])
        .quantity("planet", found.planet)
        .count("planet.modes", found.planet_multiplicity as i64);
    Ok(results)
}

/// Discs in a row with an elastic shaft between each and the next.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ChainGiven {
    /// Inertia of each disc.
    inertias: Vec<Quantity<MomentOfInertia>>,
    /// Torsional stiffness of each shaft, one fewer than the discs.
    shafts: Vec<Quantity<TorsionalStiffness>>,
}

fn chain(given: &ChainGiven) -> Result<Results, Refusal> {
    if given.shafts.len() + 1 != given.inertias.len() {
        let message = format!(
            "{} shafts for {} discs: one fewer than the discs is required",
            given.shafts.len(),
            given.inertias.len()
        );
        return Err(Refusal { name: "shafts-and-discs".into(), message });
    }
    let mut model = Model::new();
    let mut discs = vec![];
    for (place, inertia) in given.inertias.iter().enumerate() {
        // Neither mass nor radius of a disc matters to its rotation.
        let body = Body { mass: Mass::from_si(1.0), inertia: inertia.0, radius: Length::from_si(1.0) };
        discs.push(model.body(&format!("disc {}", place + 1), &body, Freedom::Rotation)?);
    }
    for (ends, stiffness) in discs.windows(2).zip(&given.shafts) {
        model.shaft("shaft", [ends[0], ends[1]], stiffness.0.per_radian(), newtons_per_meter(0.0))?;
    }
    let mut results = Results::default();
    for (place, mode) in model.modes()?.modes.iter().enumerate() {
        results.quantity(format!("frequency.{}", place + 1), mode.frequency);
    }
    Ok(results)
}
