//! What a gearbox file says of the losses of its meshes: efficiencies, or friction of teeth.

use super::checks::numbers;
use super::{DescriptionError, GearboxFile, SetEntry};
use crate::Path;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};
use epicyclic_units::Quantity;
use uom::si::f64::Ratio;

impl GearboxFile {
    /// A set with the losses by its friction or that of the gearbox, where it states no efficiencies.
    pub(super) fn with_friction(&self, entry: &SetEntry, spec: SetSpec) -> Result<SetSpec, DescriptionError> {
        let set = || entry.id.clone();
        let has_efficiency = entry.efficiency.is_some() || entry.meshes.is_some();
        if entry.friction.is_some() && has_efficiency {
            return Err(DescriptionError::LossesTwice { set: set() });
        }
        let usual = self.friction.filter(|_| !has_efficiency).map(|friction| [friction.get(); 2]);
        let is_of_teeth = || spec.toothed_set(&Default::default()).is_some();
        let own = match &entry.friction {
            Some(_) if !is_of_teeth() => return Err(DescriptionError::Friction { set: set() }),
            Some(friction) => {
                Some(numbers(&entry.id, "friction", "sun with planets, planets with ring", friction)?)
            }
            None => None,
        };
        let Some(friction) = own.or(usual) else { return Ok(spec) };
        let rack = self.rack().map_err(DescriptionError::Rack)?;
        match spec.friction_losses(&rack, friction) {
            Some(losses) => {
                let at = Path::root();
                let losses = losses.map_err(|source| DescriptionError::Set { set: set(), at, source })?;
                Ok(spec.with_loss(losses))
            }
            None => Ok(spec),
        }
    }
}

/// Losses of a set by its efficiency or by those of its meshes.
pub(super) fn losses(
    set: &str,
    kind: SetKind,
    efficiency: Option<Quantity<Ratio>>,
    meshes: Option<&[Quantity<Ratio>]>,
) -> Result<MeshLoss, DescriptionError> {
    let eta = |eta: Quantity<Ratio>, at: Path| {
        MeshEfficiency::new(eta.0.value).map_err(|source| DescriptionError::Set {
            set: set.to_owned(),
            at,
            source,
        })
    };
    let mesh = |place| Path::root().key("meshes").index(place);
    let expected = match kind {
        SetKind::ExternalPair | SetKind::InternalPair => 1,
        SetKind::DoublePlanet | SetKind::MeshingSuns => 3,
        _ => 2,
    };
    match (efficiency, meshes) {
        (None, None) => Ok(MeshLoss::IDEAL),
        (Some(whole), None) => Ok(MeshLoss::Set(eta(whole, Path::root().key("efficiency"))?)),
        (None, Some([only])) if expected == 1 => Ok(MeshLoss::Set(eta(*only, mesh(0))?)),
        (None, Some([first, second])) if expected == 2 => {
            Ok(MeshLoss::sun_and_ring(eta(*first, mesh(0))?, eta(*second, mesh(1))?))
        }
        (None, Some([first, between, second])) if expected == 3 => {
            let (first, between) = (eta(*first, mesh(0))?, eta(*between, mesh(1))?);
            Ok(MeshLoss::Meshes { first, between, second: eta(*second, mesh(2))? })
        }
        _ => Err(DescriptionError::Losses { set: set.to_owned(), expected }),
    }
}
