//! The sets of a gearbox as equations of speeds and as torques of meshes.

use super::{Mechanism, MeshForce, Place, SetMotion, not_negative};
use crate::Error;
use crate::tolerance::RANK;
use epicyclic_dynamics::gearbox::PlanetMasses;
use epicyclic_numerics::linear::Matrix;
use epicyclic_numerics::values::largest_absolute;
use epicyclic_train::compound::CentralKind;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::{Gearbox, PlanetSet};
use epicyclic_units::Physical;

/// An equation of a set over the nodes.
pub(super) struct Asked {
    pub(super) set: usize,
    pub(super) row: Vec<f64>,
}

/// The equations of all sets; those of a member in the housing lack its term.
pub(super) fn asked(gearbox: &Gearbox, node: &[Place], nodes: usize) -> Vec<Asked> {
    let mut all = vec![];
    for (place, set) in gearbox.sets().iter().enumerate() {
        let of = |member: usize| node[set.members()[member].index()];
        let (root, carrier) = (of(0), of(set.centrals().len()));
        for central in 1..set.centrals().len() {
            let i = set.ratio_between(0, central);
            let mut row = vec![0.0; nodes];
            for (at, factor) in [(root, 1.0), (of(central), -i), (carrier, i - 1.0)] {
                if let Some(at) = at {
                    row[at] += factor;
                }
            }
            all.push(Asked { set: place, row });
        }
    }
    all
}

/// A mesh while its set is put together: bodies by their numbers in the set.
struct Between {
    bodies: [usize; 2],
    ratio: f64,
    efficiency: f64,
    gears: [String; 2],
}

/// A set while it is put together.
struct Parts<'a> {
    set: &'a PlanetSet,
    /// `g` of each body over that of the first central gear.
    factors: Vec<f64>,
    /// Inertia of all planets of a kind about their own axes.
    planet_inertias: Vec<f64>,
    meshes: Vec<Between>,
}

impl Mechanism {
    /// Adds the planets and meshes of all sets.
    pub(super) fn add_sets(
        &mut self,
        gearbox: &Gearbox,
        masses: &[(String, PlanetMasses)],
    ) -> Result<(), Error> {
        for (name, _) in masses {
            if !gearbox.sets().iter().any(|set| set.id() == name) {
                return Err(Error::Unknown { what: "set", name: name.clone() });
            }
        }
        for (place, set) in gearbox.sets().iter().enumerate() {
            let node = |member: usize| self.node[set.members()[member].index()];
            let (first, carrier) = (node(0), node(set.centrals().len()));
            let mut planet_inertias = vec![0.0; set.planets().len()];
            let mut orbital = 0.0;
            for (_, planets) in masses.iter().filter(|(name, _)| name == set.id()) {
                orbital += add_planets(set, planets, &mut planet_inertias)?;
            }
            if let Some(carrier) = carrier {
                self.inertias[carrier] += orbital;
            }
            let parts = Parts::new(set, planet_inertias)?;
            let rolling: Vec<f64> =
                (0..self.freedoms()).map(|q| self.factor(first, q) - self.factor(carrier, q)).collect();
            let factors = (0..self.freedoms()).flat_map(|q| [self.factor(first, q), self.factor(carrier, q)]);
            let size = largest_absolute(factors);
            let can_roll = largest_absolute(&rolling) > RANK * size;
            let rows = self.add_bodies(&parts, &rolling, carrier);
            let from = self.meshes.len();
            for mesh in parts.meshes {
                let factor = parts.factors[mesh.bodies[0]];
                self.meshes.push(MeshForce {
                    set: place,
                    ends: mesh.bodies.map(|body| rows[body]),
                    carrier,
                    ratio: mesh.ratio,
                    efficiency: mesh.efficiency,
                    gears: mesh.gears,
                    bodies: mesh.bodies,
                    factor,
                    rolling: rolling.iter().map(|one| one * factor).collect(),
                });
            }
            let is_lossy = can_roll && self.meshes[from..].iter().any(MeshForce::is_lossy);
            self.sets.push(SetMotion {
                name: set.id().to_owned(),
                carrier,
                root: rows[set.body(GearOf::Central(0))],
                meshes: from..self.meshes.len(),
                rolling,
                is_lossy,
                centrals: (0..set.centrals().len()).map(|one| set.body(GearOf::Central(one))).collect(),
            });
        }
        Ok(())
    }

    fn factor(&self, place: Place, q: usize) -> f64 {
        place.map_or(0.0, |row| self.speeds.row(row)[q])
    }

    /// Rows of the bodies of a set; planets that keep a balance of their own get new ones.
    fn add_bodies(&mut self, parts: &Parts, rolling: &[f64], carrier: Place) -> Vec<Place> {
        let set = parts.set;
        let centrals = set.centrals().len();
        let mut rows: Vec<Place> = vec![None; centrals + set.planets().len()];
        for central in 0..centrals {
            let body = set.body(GearOf::Central(central));
            rows[body] = self.node[set.members()[central].index()];
        }
        for (planet, &inertia) in parts.planet_inertias.iter().enumerate() {
            let body = centrals + planet;
            let shaft = (0..centrals).find(|&central| set.body(GearOf::Central(central)) == body);
            if shaft.is_some() {
                // It turns with a link, whose balance is its own.
                if let Some(row) = rows[body] {
                    self.inertias[row] += inertia;
                }
                continue;
            }
            if !parts.meshes.iter().any(|mesh| mesh.bodies.contains(&body)) {
                continue;
            }
            let speeds: Vec<f64> = rolling
                .iter()
                .enumerate()
                .map(|(q, one)| self.factor(carrier, q) + parts.factors[body] * one)
                .collect();
            let row = self.inertias.len();
            let mut grown = Matrix::zeros(row + 1, self.freedoms());
            (0..row).for_each(|one| grown.row_mut(one).copy_from_slice(self.speeds.row(one)));
            grown.row_mut(row).copy_from_slice(&speeds);
            self.speeds = grown;
            self.inertias.push(inertia);
            rows[body] = Some(row);
        }
        rows
    }
}

/// Adds the inertia of planets about their own axes; returns that of their centres about the main axis.
fn add_planets(set: &PlanetSet, planets: &PlanetMasses, own: &mut [f64]) -> Result<f64, Error> {
    let mut orbital = 0.0;
    for (place, planet) in planets.each.iter().enumerate() {
        let field = |what: &str| format!("{what} of planet {} of {}", place + 1, set.id());
        let of_own = own.get_mut(place).ok_or_else(|| Error::Unknown {
            what: "planet",
            name: format!("{} of set {}", place + 1, set.id()),
        })?;
        let mass = not_negative(field("the mass in kg"), planet.mass.si())?;
        let inertia = not_negative(field("the inertia in kg·m²"), planet.inertia.si())?;
        let radius = not_negative(field("the centre radius in m"), planet.radius.si())?;
        let count = f64::from(planets.count);
        *of_own += count * inertia;
        orbital += count * mass * radius * radius;
    }
    Ok(orbital)
}

impl<'a> Parts<'a> {
    fn new(set: &'a PlanetSet, planet_inertias: Vec<f64>) -> Result<Self, Error> {
        let centrals = set.centrals().len();
        let is_bevel = |central: &epicyclic_train::planet_set::Central| {
            matches!(central.kind, CentralKind::BevelLeft | CentralKind::BevelRight)
        };
        let mut factors: Vec<f64> = (0..centrals).map(|central| set.ratio_between(central, 0)).collect();
        for (planet, &inertia) in planet_inertias.iter().enumerate() {
            let missing = match set.planet_factor(planet) {
                _ if set.centrals().iter().any(is_bevel) => Some("the axes of bevel planets are across"),
                None => Some("give the teeth of the planets"),
                Some(_) => None,
            };
            if let Some(missing) = missing.filter(|_| inertia > 0.0) {
                return Err(Error::PlanetSpeed { set: set.id().to_owned(), missing });
            }
            // Of a planet without inertia the factor cancels between its meshes.
            factors.push(set.planet_factor(planet).unwrap_or(1.0));
        }
        let mut made = Self { set, factors, planet_inertias, meshes: vec![] };
        made.walk(set.body(GearOf::Central(0)));
        made.pass_on();
        Ok(made)
    }

    /// Takes the meshes outwards from a body.
    fn walk(&mut self, start: usize) {
        let mut waiting = vec![start];
        let mut taken = vec![false; self.set.meshes().len()];
        while let Some(body) = waiting.pop() {
            for (place, mesh) in self.set.meshes().iter().enumerate() {
                let mut gears = mesh.gears;
                if self.set.body(gears[1]) == body {
                    gears.swap(0, 1);
                }
                if taken[place] || self.set.body(gears[0]) != body {
                    continue;
                }
                taken[place] = true;
                let bodies = gears.map(|gear| self.set.body(gear));
                self.meshes.push(Between {
                    bodies,
                    ratio: self.factors[bodies[0]] / self.factors[bodies[1]],
                    efficiency: mesh.efficiency.get(),
                    gears: gears.map(|gear| self.set.gear_name(gear)),
                });
                waiting.push(bodies[1]);
            }
        }
    }

    /// Joins the two meshes of a planet without inertia, and drops the only mesh of one.
    fn pass_on(&mut self) {
        let centrals = self.set.centrals().len();
        let of_shaft =
            |body: usize| (0..centrals).any(|central| self.set.body(GearOf::Central(central)) == body);
        for (planet, &inertia) in self.planet_inertias.iter().enumerate() {
            let body = centrals + planet;
            if inertia > 0.0 || of_shaft(body) {
                continue;
            }
            let into = self.meshes.iter().position(|mesh| mesh.bodies[1] == body);
            let out: Vec<usize> =
                (0..self.meshes.len()).filter(|&mesh| self.meshes[mesh].bodies[0] == body).collect();
            match (into, out.as_slice()) {
                (Some(into), []) => drop(self.meshes.remove(into)),
                (Some(into), &[out]) => {
                    let after = self.meshes.remove(out);
                    let joined = &mut self.meshes[if out < into { into - 1 } else { into }];
                    joined.bodies[1] = after.bodies[1];
                    joined.gears[1] = after.gears[1].clone();
                    joined.ratio *= after.ratio;
                    joined.efficiency *= after.efficiency;
                }
                _ => {}
            }
        }
    }
}
