//! Losses of the meshes in a gearbox file: efficiencies, or friction of teeth.

use super::place::keys_of;
use super::shape::missing;
use super::{CompoundEntry, DescriptionError, GearboxFile, SetEntry};
use crate::Path;
use crate::faults::{At, Faults};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::involute::sliding::mesh_efficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_train::toothed::Untoothed;
use epicyclic_train::{Gearbox, PlanetSet};
use epicyclic_units::{Number, Quantity};
use uom::si::f64::Ratio;

impl GearboxFile {
    /// Sets to which the friction of the gearbox is not applied, with what their teeth lack for it.
    #[must_use]
    pub fn without_friction(&self, gearbox: &Gearbox) -> Vec<(String, Untoothed)> {
        let (Some(friction), Ok(rack)) = (self.friction, self.rack()) else { return vec![] };
        let states_losses = |set: &PlanetSet| {
            let short = self.sets.iter().filter(|entry| entry.id == set.id());
            let compound = self.compound_sets.iter().filter(|entry| entry.id == set.id());
            short
                .map(SetEntry::states_losses)
                .chain(compound.map(CompoundEntry::states_losses))
                .any(|has| has)
        };
        let without = |set: &PlanetSet| {
            let why = match set.toothed(&rack, &self.stated_modules(set)) {
                Err(why) => Some(why),
                Ok(toothed) => {
                    let eta = toothed.meshes.iter().map(|mesh| mesh_efficiency(&mesh.pair, friction.get()));
                    eta.collect::<Result<Vec<_>, _>>().err().map(Untoothed::Refused)
                }
            };
            Some((set.id().to_owned(), why?))
        };
        gearbox.sets().iter().filter(|set| !states_losses(set)).filter_map(without).collect()
    }
}

impl SetEntry {
    fn states_losses(&self) -> bool {
        self.efficiency.is_some() || self.meshes.is_some() || self.friction.is_some()
    }

    /// The set with the losses by its friction or that of the gearbox, where it states no efficiencies.
    pub(super) fn with_friction(
        &self,
        spec: SetSpec,
        rack: Option<&BasicRack>,
        of_gearbox: Option<Number>,
        faults: &mut Faults,
    ) -> Option<SetSpec> {
        let set = || self.id.clone();
        let has_efficiency = self.efficiency.is_some() || self.meshes.is_some();
        let own = match &self.friction {
            Some(_) if has_efficiency => {
                faults.push("friction", DescriptionError::LossesTwice { set: set() });
                return None;
            }
            Some(own) => {
                let friction = self.of_each_mesh("friction", spec.kind, Some(own), faults)?;
                Some(friction.iter().map(|friction| friction.get()).collect())
            }
            None => None,
        };
        let usual =
            of_gearbox.filter(|_| !has_efficiency).map(|friction| vec![friction.get(); spec.kind.meshes()]);
        let is_own = own.is_some();
        let Some(friction) = own.or(usual) else { return Some(spec) };
        match spec.friction_losses(
            rack?,
            &self.stated_modules(spec.kind.meshes(), !spec.kind.is_stepped()),
            &friction,
        ) {
            Ok(losses) => Some(spec.with_loss(losses)),
            Err(Untoothed::Refused(source)) if is_own => {
                faults.push(keys_of(&source), DescriptionError::of_set(&self.id, source));
                None
            }
            Err(why) => {
                if let Some(missing) = missing(&why).filter(|_| is_own) {
                    faults.push("friction", DescriptionError::Friction { set: set(), missing });
                }
                Some(spec)
            }
        }
    }
}

/// Losses of a set by its efficiency or by those of its meshes; none where these have a fault.
pub(super) fn losses(
    set: &str,
    kind: SetKind,
    efficiency: Option<Quantity<Ratio>>,
    meshes: Option<&[Quantity<Ratio>]>,
    faults: &mut Faults,
) -> MeshLoss {
    let mut eta = |eta: Quantity<Ratio>, at: At| {
        let eta = MeshEfficiency::new(eta.0.value).map_err(|source| DescriptionError::of_set(set, source));
        faults.keep(at, eta).unwrap_or(MeshEfficiency::IDEAL)
    };
    let mesh = |place| Path::root().key("meshes").index(place).into();
    let expected = kind.meshes();
    match (efficiency, meshes) {
        (None, None) => MeshLoss::IDEAL,
        (Some(whole), None) => MeshLoss::Set(eta(whole, "efficiency".into())),
        (None, Some([only])) if expected == 1 => MeshLoss::Set(eta(*only, mesh(0))),
        (None, Some([first, second])) if expected == 2 => {
            MeshLoss::sun_and_ring(eta(*first, mesh(0)), eta(*second, mesh(1)))
        }
        (None, Some([first, between, second])) if expected == 3 => {
            let (first, between) = (eta(*first, mesh(0)), eta(*between, mesh(1)));
            MeshLoss::Meshes { first, between, second: eta(*second, mesh(2)) }
        }
        _ => {
            faults.push("meshes", DescriptionError::Losses { set: set.to_owned(), expected });
            MeshLoss::IDEAL
        }
    }
}
