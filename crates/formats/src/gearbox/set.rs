//! A set with two central gears, as its entry describes it.

use super::checks::{counts, numbers};
use super::losses::losses;
use super::spacing::spaced;
use super::{DescriptionError, SetEntry};
use crate::Path;
use epicyclic_gears::involute::Profile;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::GROUND;
use epicyclic_train::set::{SetKind, SetSpec, Shifts};
use epicyclic_units::{Number, Quantity};

impl SetEntry {
    pub(super) fn spec(&self) -> Result<SetSpec, DescriptionError> {
        let set = || self.id.clone();
        let kind = SetKind::from(self.kind);
        let carrier = match (&self.carrier, kind.is_pair()) {
            (None, true) => GROUND,
            (Some(carrier), false) => carrier,
            (_, is_pair) => return Err(DescriptionError::Carrier { set: set(), is_pair }),
        };
        let members = [self.sun.as_str(), self.ring.as_str(), carrier];
        let mut spec = match (self.k, self.teeth) {
            (Some(k), None) => SetSpec::new(&self.id, kind, members, k.get()),
            (None, Some(teeth)) => {
                counts(&self.id, "teeth", &teeth)?;
                let refuse =
                    |source| DescriptionError::Set { set: set(), at: Path::root().key("teeth"), source };
                SetSpec::teeth(&self.id, kind, members, teeth[0], teeth[1]).map_err(refuse)?
            }
            _ => return Err(DescriptionError::RowKnownInOneWay { set: set() }),
        };
        spec.loss = losses(&self.id, kind, self.efficiency, self.meshes.as_deref())?;
        if let Some(teeth) = &self.planet_teeth {
            spec = match counts(&self.id, "planet_teeth", teeth)?[..] {
                [only] => spec.planet_teeth(only, None),
                [first, second] if kind != SetKind::Simple => spec.planet_teeth(first, Some(second)),
                _ => return Err(DescriptionError::PlanetTeeth { set: set(), given: teeth.len() }),
            };
        }
        if let Some(count) = self.planets {
            spec = spec.planet_count(count);
        }
        let in_vibration = self.vibration.as_ref().and_then(|vibration| vibration.planet_angles.as_deref());
        spec = spec.spaced(spaced(&self.id, self.spacing, [self.planet_angles.as_deref(), in_vibration])?);
        if self.profile_shifts.is_some() || self.tip_alterations.is_some() {
            spec = self.with_shifts(spec)?;
        }
        self.with_helix_angle(spec)
    }

    fn with_shifts(&self, spec: SetSpec) -> Result<SetSpec, DescriptionError> {
        let set = || self.id.clone();
        let is_known = spec.planet.is_some() && spec.second_planet.is_none() && self.teeth.is_some();
        let Some(profile) = self.profile_shifts.as_ref().filter(|_| spec.kind == SetKind::Simple && is_known)
        else {
            return Err(DescriptionError::Shifts { set: set() });
        };
        let of = |key, values: &[Number]| numbers(&self.id, key, "sun, planets, ring", values);
        let tips = self.tip_alterations.as_ref().map(|tips| of("tip_alterations", tips)).transpose()?;
        Ok(spec.shifted(Shifts { profile: of("profile_shifts", profile)?, tips }))
    }

    fn with_helix_angle(&self, spec: SetSpec) -> Result<SetSpec, DescriptionError> {
        let Some(Quantity(helix_angle)) = self.helix_angle else { return Ok(spec) };
        let at = Path::root().key("helix_angle");
        let refuse = |source| DescriptionError::Set { set: self.id.clone(), at, source };
        Profile { helix_angle, ..Profile::default() }.check().map_err(refuse)?;
        let spec = spec.helical(helix_angle);
        if spec.is_helical() && spec.toothed_set(&BasicRack::default()).is_none() {
            return Err(DescriptionError::HelixAngle { set: self.id.clone() });
        }
        Ok(spec)
    }
}
