//! Meshes with a stated centre distance, from which profile shifts follow.

use super::shape::ClosingMesh;
use super::{CompoundEntry, DescriptionError, PlanetSized, SetEntry};
use crate::Path;
use crate::faults::Faults;
use epicyclic_train::compound::CentralKind;
use epicyclic_train::set::SetKind;
use epicyclic_units::Physical;
use std::collections::BTreeMap;
use uom::si::f64::{Angle, Length};

impl SetEntry {
    /// Meshes with the stated centre distance.
    pub(super) fn closing<'m>(&self, kind: SetKind, meshes: &'m [[String; 2]]) -> Vec<ClosingMesh<'m>> {
        let Some(distance) = self.centre_distance else { return vec![] };
        let modules = self.stated_modules(meshes.len(), !kind.is_stepped());
        let is_one = kind.is_pair() || kind.is_stepped() || kind == SetKind::Simple;
        let mesh = |(place, gears): (usize, &'m [String; 2])| {
            let of_mesh =
                self.helix_angles.as_ref().and_then(|angles| angles.get(place)).or(self.helix_angle.as_ref());
            ClosingMesh {
                gears,
                distance: distance.0,
                module: modules[place].map(Length::from_si),
                is_one,
                helix_angle: of_mesh.map_or_else(Angle::default, |angle| angle.0.abs()),
                at: Path::root().key("centre_distance"),
            }
        };
        meshes.iter().enumerate().map(mesh).collect()
    }
}

impl<P: PlanetSized> CompoundEntry<P> {
    /// Teeth of each gear, in the order of [`gears`](Self::gears); those of a central gear as far as they are
    /// whole.
    pub(super) fn teeth(&self) -> Vec<u32> {
        let centrals = self.centrals().filter(|one| one.1 != CentralKind::PlanetShaft);
        let centrals = centrals.map(|(_, _, _, teeth)| teeth as u32);
        centrals.chain(self.planet_gears.values().flatten().copied()).collect()
    }

    /// Meshes with a stated centre distance.
    pub(super) fn closing(&self) -> Vec<ClosingMesh<'_>> {
        let mut all = vec![];
        for (place, mesh) in self.meshes.iter().enumerate() {
            let Some(distance) = mesh.centre_distance else { continue };
            let helix_angle = mesh.helix_angle.or(self.helix_angle);
            all.push(ClosingMesh {
                gears: &mesh.gears,
                distance: distance.0,
                module: mesh.module.or(self.module).map(|module| module.0),
                helix_angle: helix_angle.map_or_else(Angle::default, |angle| angle.0.abs()),
                is_one: true,
                at: Path::root().key("meshes").index(place).key("centre_distance"),
            });
        }
        all
    }

    /// Refuses meshes of one planet with central gears at two centre distances: both are the radius of its
    /// centre.
    pub(super) fn check_distances(&self, faults: &mut Faults) {
        let planet = |gear: &str| {
            let name = gear.rsplit_once('.').map_or(gear, |(name, _)| name);
            self.planet_gears.keys().find(|own| *own == gear || *own == name)
        };
        let mut first: BTreeMap<&String, Length> = BTreeMap::new();
        for (place, mesh) in self.meshes.iter().enumerate() {
            let [one, other] = mesh.gears.each_ref().map(|gear| planet(gear));
            let (Some(distance), Some(of), None) = (mesh.centre_distance, one.or(other), one.and(other))
            else {
                continue;
            };
            let radius = *first.entry(of).or_insert(distance.0);
            if radius != distance.0 {
                let (set, planet, second) = (self.id.clone(), of.clone(), distance.0);
                let at = Path::root().key("meshes").index(place).key("centre_distance");
                faults.push(at, DescriptionError::TwoRadii { set, planet, first: radius, second });
            }
        }
    }
}
