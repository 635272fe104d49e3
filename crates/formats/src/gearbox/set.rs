//! A set with two central gears, as its entry describes it.

use super::checks::{NO_LINK, counts};
use super::losses::losses;
use super::shape::{Shape, Stated, missing, one_module};
use super::spacing::spaced;
use super::{DescriptionError, Gears, RollingEntry, SetEntry, Vibrating};
use crate::Path;
use crate::faults::Faults;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::GROUND;
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_train::spacing::Spacing;
use epicyclic_train::toothed::Untoothed;
use epicyclic_units::Number;
use uom::si::f64::Angle;

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
            _ if kind.is_pair() => Some([None, None]),
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
        let spacing = if kind.is_pair() { Spacing::default() } else { spacing };
        if kind.is_pair() {
            self.refuse_planets(faults);
        }
        let (mut spec, planets) = (spec?, planets?);
        (spec.loss, [spec.planet, spec.second_planet]) = (loss, planets);
        if let Some(count) = self.planets.filter(|_| !kind.is_pair()) {
            spec = spec.planet_count(count);
        }
        let mut spec = spec.spaced(spacing);
        let gears = Gears::of_kind(kind);
        let planet_gears = gears.names.len() - 2;
        let meshes = Gears::meshes_of_kind(kind);
        let known = [spec.planet, spec.second_planet].into_iter().flatten().count();
        let shape = Shape {
            set: &self.id,
            gears: &gears,
            profile_shifts: self.profile_shifts.as_ref(),
            tip_alterations: self.tip_alterations.as_ref(),
            face_widths: self.face_widths.as_ref(),
            tools: &self.tools,
            strength: self.strength.as_ref(),
            data_sheet: self.data_sheet.as_ref(),
            helix_angles: self.helix_angles(kind, faults),
            is_known: self.teeth.is_some() && known == planet_gears && kind != SetKind::Bevel,
            teeth: self.all_teeth(),
            closing: self.closing(kind, &meshes),
        };
        let (tooth_shape, is_sound) =
            faults.sound(|faults| {
                if let Some(modules) = self.of_each_mesh("modules", kind, self.modules.as_deref(), faults) {
                    let meshes = meshes.iter().zip(modules).enumerate().map(|(place, (gears, module))| {
                        Stated { gears, module: module.0, at: Path::root().key("modules").index(place) }
                    });
                    one_module(&self.id, &meshes.collect::<Vec<_>>(), faults);
                }
                shape.tooth_shape(rack, faults)
            });
        spec.tooth_shape = tooth_shape;
        if let Some(vibration) = &self.vibration {
            vibration.check(&self.id, &gears, &Vibrating::of_kind(kind), faults);
        }
        if self.carrier_radius.is_some() && self.centre_distance.is_some() {
            let (first, second) = ("centre_distance", "carrier_radius");
            faults.push(second, DescriptionError::Twice { set: set(), first, second });
        }
        if self.modules.is_some() && self.module.is_some() {
            let twice = DescriptionError::Twice { set: set(), first: "module", second: "modules" };
            faults.push("modules", twice);
        }
        // Profile shifts may be open: sizes pick them.
        if spec.is_helical()
            && let Err(why) = spec.toothed(&BasicRack::default(), &[])
            && why != Untoothed::Shifts
            && let Some(missing) = missing(&why)
        {
            let at = &["helix_angle", "helix_angles"][..];
            faults.push(at, DescriptionError::HelixAngle { set: set(), missing });
            spec.tooth_shape.helix_angles.clear();
        }
        // Friction of teeth with a fault would only repeat it.
        let whole = self.with_friction(spec.clone(), rack.filter(|_| is_sound), friction, faults);
        Some(whole.unwrap_or(spec))
    }

    /// Teeth of sun, planets and ring, as far as they are stated.
    fn all_teeth(&self) -> Vec<u32> {
        let [sun, ring] = self.teeth.unwrap_or_default();
        let planets = self.planet_teeth.iter().flatten().copied();
        let planets = planets.filter(|_| !SetKind::from(self.kind).is_pair());
        [sun].into_iter().chain(planets).chain([ring]).collect()
    }

    /// Refuses keys of planets, which a pair has not.
    fn refuse_planets(&self, faults: &mut Faults) {
        let given = [
            ("planet_teeth", self.planet_teeth.is_some()),
            ("planets", self.planets.is_some()),
            ("spacing", self.spacing.is_some()),
            ("planet_angles", self.planet_angles.is_some()),
            ("floating", self.floating.is_some()),
            ("carrier_radius", self.carrier_radius.is_some()),
            ("planet_bore", self.planet_bore.is_some()),
            ("planet_mass", self.planet_mass.is_some()),
            ("load_rating", self.load_rating.is_some()),
            ("bearing_rolling", self.bearing_rolling != RollingEntry::Unstated),
            ("static_load_rating", self.static_load_rating.is_some()),
            ("fatigue_limit", self.fatigue_limit.is_some()),
            ("bearing_diameter", self.bearing_diameter.is_some()),
            ("bearing_span", self.bearing_span.is_some()),
        ];
        let refused = |key| DescriptionError::OfPlanets { set: self.id.clone(), key };
        for (key, _) in given.into_iter().filter(|one| one.1) {
            faults.push(key, refused(key));
        }
        if self.vibration.as_ref().is_some_and(|vibration| vibration.planet_angles.is_some()) {
            let key = "planet_angles";
            faults.push(Path::root().key("vibration").key(key), refused(key));
        }
    }

    /// Helix angle of each mesh, with the path of its key.
    fn helix_angles(&self, kind: SetKind, faults: &mut Faults) -> Vec<(Angle, Path)> {
        if let (Some(_), Some(_)) = (self.helix_angle, &self.helix_angles) {
            let (set, first, second) = (self.id.clone(), "helix_angle", "helix_angles");
            faults.push(second, DescriptionError::Twice { set, first, second });
        }
        match self.of_each_mesh("helix_angles", kind, self.helix_angles.as_deref(), faults) {
            Some(angles) => {
                let at = |place| Path::root().key("helix_angles").index(place);
                angles.iter().enumerate().map(|(place, angle)| (angle.0, at(place))).collect()
            }
            None => {
                let angle = self.helix_angle.map_or_else(Angle::default, |angle| angle.0);
                vec![(angle, Path::root().key("helix_angle")); kind.meshes()]
            }
        }
    }

    /// The values of a key, one for each mesh.
    pub(super) fn of_each_mesh<'v, T>(
        &self,
        key: &'static str,
        kind: SetKind,
        values: Option<&'v [T]>,
        faults: &mut Faults,
    ) -> Option<&'v [T]> {
        let values = values?;
        let expected = kind.meshes();
        if values.len() == expected {
            return Some(values);
        }
        let (set, given, of) = (self.id.clone(), values.len(), "meshes from sun to ring".to_owned());
        faults.push(key, DescriptionError::Values { set, key, of, given, expected });
        None
    }
}
