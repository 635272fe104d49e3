//! A set with two central gears, as its entry describes it.

use super::checks::{NO_LINK, counts, numbers};
use super::losses::losses;
use super::spacing::spaced;
use super::{DescriptionError, SetEntry};
use crate::faults::Faults;
use epicyclic_gears::involute::Profile;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::GROUND;
use epicyclic_train::set::{SetKind, SetSpec, Shifts};
use epicyclic_units::{Number, Quantity};

impl SetEntry {
    /// The set; `None` where a fault leaves its ratio or its planets open. Of what else has a
    /// fault the set has nothing. Without a rack, or friction of the gearbox, nothing follows from them.
    pub(super) fn spec(
        &self,
        rack: Option<&BasicRack>,
        friction: Option<Number>,
        faults: &mut Faults,
    ) -> Option<SetSpec> {
        let set = || self.id.clone();
        let kind = SetKind::from(self.kind);
        let carrier = match (&self.carrier, kind.is_pair()) {
            (None, true) => GROUND,
            (Some(carrier), false) => carrier.as_str(),
            (_, is_pair) => {
                faults.push("carrier", DescriptionError::Carrier { set: set(), is_pair });
                NO_LINK
            }
        };
        let members = [self.sun.as_str(), self.ring.as_str(), carrier];
        let spec = match (self.k, self.teeth) {
            (Some(k), None) => Some(SetSpec::new(&self.id, kind, members, k.get())),
            (None, Some(teeth)) => counts(&self.id, "teeth", &teeth, faults).and_then(|_| {
                let spec = SetSpec::teeth(&self.id, kind, members, teeth[0], teeth[1]);
                faults.keep("teeth", spec.map_err(|source| DescriptionError::of_set(&self.id, source)))
            }),
            _ => {
                faults.push("teeth", DescriptionError::RowKnownInOneWay { set: set() });
                None
            }
        };
        let loss = losses(&self.id, kind, self.efficiency, self.meshes.as_deref(), faults);
        let given = self.planet_teeth.as_deref().unwrap_or_default();
        let planets = counts(&self.id, "planet_teeth", given, faults);
        let planets = planets.and_then(|teeth| match teeth[..] {
            [] if self.planet_teeth.is_none() => Some([None, None]),
            [only] => Some([Some(only), None]),
            [first, second] if kind != SetKind::Simple => Some([Some(first), Some(second)]),
            _ => {
                faults.push("planet_teeth", DescriptionError::PlanetTeeth { set: set(), given: given.len() });
                None
            }
        });
        let in_vibration = self.vibration.as_ref().and_then(|vibration| vibration.planet_angles.as_deref());
        let spacing = spaced(&self.id, self.spacing, [self.planet_angles.as_deref(), in_vibration], faults);
        let (mut spec, planets) = (spec?, planets?);
        (spec.loss, [spec.planet, spec.second_planet]) = (loss, planets);
        if let Some(count) = self.planets {
            spec = spec.planet_count(count);
        }
        let spec = spec.spaced(spacing);
        let with_shifts = self.with_shifts(spec.clone(), faults);
        let helical = with_shifts.and_then(|spec| self.with_helix_angle(spec, faults));
        let cut = helical.and_then(|spec| self.with_tools(spec, rack, faults));
        let whole = cut.and_then(|spec| self.with_friction(spec, rack, friction, faults));
        Some(whole.unwrap_or(spec))
    }

    fn with_shifts(&self, spec: SetSpec, faults: &mut Faults) -> Option<SetSpec> {
        if self.profile_shifts.is_none() && self.tip_alterations.is_none() {
            return Some(spec);
        }
        let is_known = spec.planet.is_some() && spec.second_planet.is_none() && self.teeth.is_some();
        let Some(profile) = self.profile_shifts.as_ref().filter(|_| spec.kind == SetKind::Simple && is_known)
        else {
            let shifts = DescriptionError::Shifts { set: self.id.clone() };
            faults.push(&["profile_shifts", "tip_alterations"][..], shifts);
            return None;
        };
        let mut of = |key, values: &[Number]| numbers(&self.id, key, "sun, planets, ring", values, faults);
        let tips = self.tip_alterations.as_ref().map(|tips| of("tip_alterations", tips));
        let profile = of("profile_shifts", profile)?;
        let tips = match tips {
            Some(tips) => Some(tips?),
            None => None,
        };
        Some(spec.shifted(Shifts { profile, tips }))
    }

    fn with_helix_angle(&self, spec: SetSpec, faults: &mut Faults) -> Option<SetSpec> {
        let Some(Quantity(helix_angle)) = self.helix_angle else { return Some(spec) };
        let profile = Profile { helix_angle, ..Profile::default() };
        let checked = profile.check().map_err(|source| DescriptionError::of_set(&self.id, source));
        faults.keep("helix_angle", checked)?;
        let spec = spec.helical(helix_angle);
        if spec.is_helical() && spec.toothed_set(&BasicRack::default()).is_none() {
            faults.push("helix_angle", DescriptionError::HelixAngle { set: self.id.clone() });
            return None;
        }
        Some(spec)
    }
}
