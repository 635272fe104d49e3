//! Loads of the meshes of a set, from the torques on its central gears.
//!
//! ```text
//! P_j = Σ g_c·T_c over the central gears on one side of mesh j        T_x = ±P_j/(g_x·N)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `P_j` | power through mesh `j` at a speed of 1 of the first central gear relative to the carrier | N·m |
//! | `g` | speed of a gear relative to the carrier, over that of the first central gear | 1 |
//! | `T_c` | torque on a central gear from outside, without losses | N·m |
//! | `T_x` | torque of one mesh on one of its two gears | N·m |
//! | `N` | planets of a kind; 1 of a pair on fixed axes | 1 |
//!
//! The sign of `T_x` says which flank of the gear it loads: a planet between two central gears passes on what
//! it receives, so its meshes load opposite flanks and bend its teeth both ways. Planets share the load
//! equally.

use crate::planet_places::planet_of;
use crate::planet_set::{GearOf, PlanetSet};

/// Torques and relative speeds of the two gears of a mesh, in the order of
/// [`ToothedMesh`](crate::toothed::ToothedMesh).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshLoad {
    /// Torque of one mesh on each gear, in the unit of the torques on the central gears.
    pub torques: [f64; 2],
    /// Speed of each gear relative to the carrier, over that of the first central gear.
    pub speeds: [f64; 2],
    /// Meshes of this kind that each gear passes in one revolution relative to the carrier.
    pub contacts: [f64; 2],
}

impl PlanetSet {
    /// Torques of all meshes of a kind together on each of their two gears, as [`MeshLoad::torques`] times
    /// the number of planets; `None` where the teeth of a planet are not known.
    #[must_use]
    pub fn mesh_torques(&self, torques: &[f64]) -> Option<Vec<[f64; 2]>> {
        let torques = torques.get(..self.centrals().len())?;
        let flows = self.flows();
        let of = |mesh: usize| {
            let power = flows.through(mesh, torques);
            let near = self.meshes()[mesh].gears[0];
            let gears = self.gears_of_mesh(mesh);
            let torque = |end: usize| {
                let speed = self.relative_speed(gears[end])?;
                Some(if gears[end] == near { -power } else { power } / speed)
            };
            Some([torque(0)?, torque(1)?])
        };
        (0..self.meshes().len()).map(of).collect()
    }

    /// Speed of a gear relative to the carrier, over that of the first central gear.
    fn relative_speed(&self, gear: GearOf) -> Option<f64> {
        match gear {
            GearOf::Central(central) => Some(self.ratio_between(central, 0)),
            GearOf::Planet(planet, _) => self.planet_factor(planet),
        }
    }

    /// Loads of the meshes at these torques on the central gears, in the order of [`PlanetSet::meshes`]; more
    /// values, as that of the carrier, are not read. `None` where the number of planets or the teeth of a
    /// planet are not known.
    #[must_use]
    pub fn mesh_loads(&self, torques: &[f64]) -> Option<Vec<MeshLoad>> {
        let planets = if self.is_pair() { 1.0 } else { f64::from(self.planet_count()?) };
        let load = |(mesh, torques): (usize, [f64; 2])| {
            let gears = self.gears_of_mesh(mesh);
            let contacts = |gear: GearOf, mate: GearOf| {
                let is_among_planets = planet_of(gear).is_none() && planet_of(mate).is_some();
                if is_among_planets { planets } else { 1.0 }
            };
            Some(MeshLoad {
                torques: torques.map(|torque| torque / planets),
                speeds: [self.relative_speed(gears[0])?, self.relative_speed(gears[1])?],
                contacts: [contacts(gears[0], gears[1]), contacts(gears[1], gears[0])],
            })
        };
        self.mesh_torques(torques)?.into_iter().enumerate().map(load).collect()
    }

    /// Whether the meshes of a gear bend its teeth both ways: it passes power on, as a planet with one gear
    /// does between two central gears.
    #[must_use]
    pub fn is_idler(&self, gear: GearOf) -> bool {
        let own = self.meshes().iter().filter(|mesh| mesh.gears.contains(&gear));
        planet_of(gear).is_some() && own.count() > 1
    }
}

#[cfg(test)]
mod tests {
    use crate::compound::CompoundSpec;
    use crate::planet_set::GearOf;
    use crate::set::{SetKind, SetSpec};
    use crate::{Gearbox, PlanetSet};
    use epicyclic_gears::ToothCount;
    use epicyclic_gears::efficiency::MeshEfficiency;

    fn short(kind: SetKind, teeth: [u32; 2], planets: &[u32]) -> PlanetSet {
        let count = |place: usize| planets.get(place).map(|teeth| ToothCount::new(*teeth).unwrap());
        let mut set = SetSpec::teeth("P", kind, ["a", "b", "h"], teeth[0], teeth[1]).unwrap().planet_count(3);
        if let Some(first) = count(0) {
            set = set.planet_teeth(first, count(1));
        }
        let gearbox = Gearbox::builder("one").links(["a", "b", "h"]).set(set).brake("B", "b");
        gearbox.input("a").output("h").gear("1", ["B"]).build().unwrap().sets()[0].clone()
    }

    fn ravigneaux() -> PlanetSet {
        let eta = MeshEfficiency::IDEAL;
        let set = CompoundSpec::new("R", "h").sun("s", 30).sun("l", 36).ring("r", 72).planet("short", &[18]);
        let set = set.planet("long", &[18]).mesh("s", "short", eta).mesh("short", "long", eta);
        let set = set.mesh("l", "long", eta).mesh("long", "r", eta).planet_count(3);
        let gearbox = Gearbox::builder("four").links(["s", "l", "r", "h"]).compound_set(set).brake("B", "h");
        gearbox.input("s").output("r").gear("1", ["B"]).build().unwrap().sets()[0].clone()
    }

    /// Torques on the central gears whose powers relative to the carrier add to zero.
    fn balanced(set: &PlanetSet) -> Vec<f64> {
        let speeds: Vec<f64> = (0..set.centrals().len()).map(|one| set.ratio_between(one, 0)).collect();
        let mut torques: Vec<f64> = (1..=speeds.len()).map(|one| 10.0 * one as f64).collect();
        let others: f64 = speeds.iter().zip(&torques).skip(1).map(|(speed, torque)| speed * torque).sum();
        torques[0] = -others / speeds[0];
        torques
    }

    /// The meshes of each body balance what acts on it: nothing of a planet, the outer torque of a central
    /// gear. Gears in mesh push each other with one force at their pitch circles.
    #[test]
    fn the_meshes_balance_every_body() {
        let sets = [
            short(SetKind::Simple, [20, 76], &[28]),
            short(SetKind::SteppedSunRing, [20, 80], &[40, 20]),
            short(SetKind::SteppedRings, [100, 96], &[34, 30]),
            short(SetKind::DoublePlanet, [30, 72], &[15, 18]),
            short(SetKind::MeshingSuns, [30, 24], &[15, 18]),
            ravigneaux(),
        ];
        for set in sets {
            let torques = balanced(&set);
            let loads = set.mesh_loads(&torques).unwrap();
            let mut bodies = vec![0.0; set.centrals().len() + set.planets().len()];
            for (mesh, load) in loads.iter().enumerate() {
                let gears = set.gears_of_mesh(mesh);
                for (end, gear) in gears.into_iter().enumerate() {
                    bodies[set.body(gear)] += load.torques[end] * load.contacts[end];
                }
                let teeth = gears.map(|gear| set.teeth(gear).unwrap().as_f64());
                let forces = [0, 1].map(|end: usize| load.torques[end].abs() / teeth[end]);
                assert!((forces[0] - forces[1]).abs() < 1e-12 * forces[0].max(1.0), "{forces:?}");
                // Gears outside each other are both turned back, in a ring they push each other forwards.
                let alike = load.torques[0] * load.torques[1] > 0.0;
                assert_eq!(
                    alike,
                    set.gear_kind(gears[1]) == Some(epicyclic_gears::geometry::GearKind::External)
                );
            }
            for (central, torque) in torques.iter().enumerate() {
                assert!((bodies[central] + torque).abs() < 1e-10, "{} {central}: {bodies:?}", set.id());
            }
            for planet in &bodies[torques.len()..] {
                assert!(planet.abs() < 1e-10, "{bodies:?}");
            }
        }
    }

    #[test]
    fn what_passes_power_on_is_bent_both_ways() {
        let simple = short(SetKind::Simple, [20, 76], &[28]);
        let bent: Vec<bool> = simple.gears().into_iter().map(|gear| simple.is_idler(gear)).collect();
        assert_eq!(bent, [false, true, false]);
        let stepped = short(SetKind::SteppedSunRing, [20, 80], &[40, 20]);
        assert!(stepped.gears().into_iter().all(|gear| !stepped.is_idler(gear)));
        let double = short(SetKind::DoublePlanet, [30, 72], &[15, 18]);
        assert!(double.is_idler(GearOf::Planet(0, 0)) && double.is_idler(GearOf::Planet(1, 0)));
    }
}
