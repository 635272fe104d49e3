//! Data of a set for its vibration, as far as the file has enough.

use super::records::{Reason, StiffnessOrigin};
use super::spacing::Spacing;
use crate::error::Error;
use crate::shared::fault::{Fault, Named, refused};
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::toothed;
use epicyclic_formats::gearbox::{
    BodyEntry, GearboxFile, Gears, PerGear, SetData, Stiffness, VibrationEntry,
};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::InvoluteGear;
use epicyclic_gears::mass::{MassProperties, TOOTH_FILL, ring};
use epicyclic_pictures::modes::Part;
use epicyclic_strength::load::mesh_stiffness;
use epicyclic_train::PlanetSet;
use epicyclic_train::compound::CentralKind;
use epicyclic_train::planet_set::{GearOf, MeshKind};
use epicyclic_train::set::SetKind;
use epicyclic_train::toothed::ToothedSet;
use epicyclic_units::{Physical, Quantity};
use epicyclic_vibration::Body;
use std::f64::consts::TAU;
use uom::si::f64::{Angle, Length, Mass, MassDensity, MomentOfInertia};

/// Set of the file whose vibration is calculated.
pub(super) struct Of<'a> {
    pub(super) subject: &'a Gearbox,
    pub(super) file: &'a GearboxFile,
    pub(super) data: SetData<'a>,
    pub(super) set: &'a PlanetSet,
}

/// Data of a set in the file, for any held members.
pub(super) struct Prepared {
    /// Number of planets of each kind; 0 of a pair.
    pub(super) planets: u32,
    /// Tooth numbers of the gears; empty if they are not known.
    pub(super) teeth: Vec<(GearOf, u32)>,
    pub(super) spacing: Spacing,
    /// Central gears, then the carrier; none of a pair.
    pub(super) members: Vec<MemberBody>,
    pub(super) planet_kinds: Vec<PlanetKind>,
    pub(super) meshes: Vec<Mesh>,
}

/// Central gear or carrier with its inertia and support.
pub(super) struct MemberBody {
    pub(super) name: String,
    pub(super) part: Part,
    /// Path of the keys of this body, for messages.
    pub(super) keys: String,
    pub(super) radius: Length,
    pub(super) mass: Option<Mass>,
    pub(super) inertia: Option<MomentOfInertia>,
    /// Radial stiffness of the support; `None` if the centre is held.
    pub(super) support: Option<Stiffness>,
    pub(super) tangential: Option<Stiffness>,
}

/// Equal planets.
pub(super) struct PlanetKind {
    pub(super) name: String,
    pub(super) body: Body,
    pub(super) distance: Length,
    /// Angle from the planet of the first kind.
    pub(super) offset_rad: f64,
    pub(super) bearing: Stiffness,
}

/// Equal meshes, one for each planet.
pub(super) struct Mesh {
    /// Name of the mesh: the central gear that is in no other, otherwise both gears.
    pub(super) name: String,
    /// Gears: an internal gear first, otherwise as the set has them, with base radii.
    pub(super) gears: [(GearOf, Length); 2],
    pub(super) is_internal: bool,
    pub(super) stiffness: Stiffness,
    pub(super) by: StiffnessOrigin,
    pub(super) pressure_angle: Angle,
    pub(super) helix_angle: Angle,
}

/// Reason why a set is not calculated, with missing keys.
pub(super) type Lack = (Reason, Vec<String>);

/// Mass and inertia of a body: given, or from its shape.
type Inertias = (Option<Mass>, Option<MomentOfInertia>);

/// Gears of a set with their teeth, in mesh, and whether their sizes follow.
struct Teeth {
    toothed: ToothedSet,
    is_sized: bool,
}

impl Teeth {
    /// A gear with its module, in m.
    fn gear(&self, gear: GearOf) -> Option<(&InvoluteGear, Length)> {
        let mesh = self.toothed.meshes.iter().find(|mesh| mesh.gears.contains(&gear))?;
        Some((self.toothed.gear(gear)?, Length::from_si(mesh.module))).filter(|_| self.is_sized)
    }
}

impl<'a> Of<'a> {
    /// Data of the set in the file, or what is missing.
    pub(super) fn prepared(&self) -> Result<Result<Prepared, Lack>, Error> {
        let is_bevel = |mesh: &epicyclic_train::planet_set::Mesh| {
            matches!(mesh.kind, MeshKind::BevelLeft | MeshKind::BevelRight)
        };
        if self.set.meshes().iter().any(is_bevel) {
            return Ok(Err((Reason::Bevel, vec![])));
        }
        if self.set.centrals().iter().any(|central| central.kind == CentralKind::PlanetShaft) {
            return Ok(Err((Reason::PlanetShaft, vec![])));
        }
        let Some(vibration) = &self.data.vibration else {
            return Ok(Err((Reason::KeysMissing, vec!["vibration".to_owned()])));
        };
        let (teeth, without_teeth) = match toothed(self.subject, &self.data, self.set)? {
            Ok(mut toothed) => {
                // The pairs of a simple set are those of its picture and its checks to the last digit.
                if let Some(simple) = self.set.simple_involutes(&toothed) {
                    let pairs = [*simple.sun_mesh(), *simple.ring_mesh()];
                    toothed.meshes.iter_mut().zip(pairs).for_each(|(mesh, pair)| mesh.pair = pair);
                }
                let is_sized = self.data.modules.iter().any(Option::is_some);
                (Some(Teeth { toothed, is_sized }), None)
            }
            Err(key) => (None, key),
        };
        let mut missing: Vec<String> = vec![];
        let has_module = teeth.as_ref().is_some_and(|teeth| teeth.is_sized);
        // Of the data for a shape, the message names the first that is missing: teeth, module, face width.
        let mut lacks = |in_their_place: &str| {
            let key = match (without_teeth, has_module) {
                (Some(teeth), _) => teeth,
                (None, false) => "module",
                (None, true) => "face_width",
            };
            let one = format!("{key} (or {in_their_place})");
            // Several values may lack the same key, which is then named once.
            if !missing.contains(&one) {
                missing.push(one);
            }
        };
        let radii = self.radii(vibration, teeth.as_ref());
        if radii.is_none() {
            lacks("vibration.base_radii");
        }
        let distances = self.distances(teeth.as_ref());
        if distances.is_none() {
            lacks(if self.set.short().is_some() { "carrier_radius" } else { "planet_sizes" });
        }
        let angles = self.pressure_angles(vibration, teeth.as_ref());
        if angles.is_none() {
            lacks("vibration.pressure_angles");
        }
        let stiffness = self.stiffness(vibration, teeth.as_ref())?;
        if stiffness.is_none() {
            lacks("vibration.mesh_stiffness");
        }
        let mut planets = vec![];
        for planet in 0..self.set.planets().len() {
            let (mass, inertia) = self.planet(vibration, planet, teeth.as_ref(), radii.as_deref())?;
            let name = self.planet_name(planet);
            if mass.is_none() {
                let is_short = self.set.short().is_some();
                let sizes = format!("planet_sizes.{name}.mass");
                lacks(if is_short { "planet_mass" } else { &sizes });
            }
            if inertia.is_none() {
                lacks(&format!("{}.inertia", vibration.keys_of(name).join(".")));
            }
            planets.extend(mass.zip(inertia));
        }
        let bearings: Vec<Option<Stiffness>> = (0..self.set.planets().len())
            .map(|planet| {
                let own = vibration.body(self.planet_name(planet)).bearing;
                own.or(vibration.planet_bearing).map(|bearing| bearing.0)
            })
            .collect();
        if bearings.iter().any(Option::is_none) {
            missing.push("vibration.planet_bearing".to_owned());
        }
        let spacing = self.spacing()?;
        if spacing.is_none() {
            missing.insert(0, "planets".to_owned());
        }
        let (Some(spacing), Some(radii), Some(distances), Some(angles), Some(stiffness), true) =
            (spacing, radii, distances, angles, stiffness, missing.is_empty())
        else {
            return Ok(Err((Reason::KeysMissing, missing)));
        };
        if teeth.is_some() && !spacing.fits {
            let is_simple = self.set.kind() == Some(SetKind::Simple);
            let reason = if is_simple { Reason::UnequalPlanets } else { Reason::NotAssembled };
            return Ok(Err((reason, vec![])));
        }
        let Some(offsets) = self.offsets(teeth.as_ref(), spacing.angles_rad.len()) else {
            return Ok(Err((Reason::PlanetsApart, vec![])));
        };
        let planets_of = std::iter::zip(planets, bearings.into_iter().flatten()).enumerate();
        let planet_kinds = planets_of.map(|(planet, ((mass, inertia), bearing))| PlanetKind {
            name: self.planet_name(planet).to_owned(),
            body: Body { mass, inertia, radius: radii[self.data.place(GearOf::Planet(planet, 0))] },
            distance: distances[planet],
            offset_rad: offsets[planet],
            bearing,
        });
        let meshes = (0..self.set.meshes().len()).map(|mesh| {
            let mut gears = self.set.gears_of_mesh(mesh).map(|gear| (gear, radii[self.data.place(gear)]));
            let is_internal = self.set.meshes()[mesh].kind == MeshKind::Internal;
            if is_internal {
                gears.reverse();
            }
            Mesh {
                name: self.mesh_name(gears.map(|gear| gear.0)),
                gears,
                is_internal,
                stiffness: stiffness[mesh].0,
                by: stiffness[mesh].1,
                pressure_angle: angles[mesh],
                helix_angle: self.set.tooth_shape().helix_angle(mesh),
            }
        });
        Ok(Ok(Prepared {
            planets: if self.set.is_pair() { 0 } else { spacing.angles_rad.len() as u32 },
            teeth: teeth.as_ref().map_or_else(Vec::new, |teeth| {
                let own = |gear: &GearOf| Some((*gear, teeth.toothed.gear(*gear)?.teeth().get()));
                self.data.of.iter().filter_map(own).collect()
            }),
            members: self.members(vibration, teeth.as_ref(), &radii, distances.first().copied())?,
            planet_kinds: planet_kinds.collect(),
            meshes: meshes.collect(),
            spacing,
        }))
    }

    /// Places of the planets; of a pair one place. `None` if their number is unknown.
    fn spacing(&self) -> Result<Option<Spacing>, Error> {
        if self.set.is_pair() {
            return Ok(Some(Spacing::alone()));
        }
        Spacing::of(self.set).transpose().map_err(|message| {
            let why = Named("planet-angles", message);
            self.refused(&["planet_angles", "vibration", "planet_angles"], &why)
        })
    }

    /// Base radius of each gear. Given values replace those of the teeth, so that sets without known teeth
    /// can be calculated.
    fn radii(&self, vibration: &VibrationEntry, teeth: Option<&Teeth>) -> Option<Vec<Length>> {
        let given = given(vibration.base_radii.as_ref(), &self.data.gears);
        let of_teeth = |gear: GearOf| {
            let (gear, module) = teeth?.gear(gear)?;
            Some(module * (gear.base_diameter() / 2.0))
        };
        self.data.of.iter().zip(given).map(|(gear, given)| given.or_else(|| of_teeth(*gear))).collect()
    }

    /// Distance of each planet from the axis.
    fn distances(&self, teeth: Option<&Teeth>) -> Option<Vec<Length>> {
        let is_only = self.set.planets().len() == 1;
        let distance = |planet: usize| {
            // Planets in mesh are where their teeth put them.
            let given = self.data.planets[planet].carrier_radius.filter(|_| is_only);
            let of_teeth = || teeth.filter(|teeth| teeth.is_sized)?.toothed.radii[planet];
            given.or_else(|| of_teeth().map(Length::from_si))
        };
        (0..self.set.planets().len()).map(distance).collect()
    }

    fn pressure_angles(&self, vibration: &VibrationEntry, teeth: Option<&Teeth>) -> Option<Vec<Angle>> {
        let given = given(vibration.pressure_angles.as_ref(), &self.data.vibrating.meshes);
        let of_teeth = |mesh: usize| {
            teeth.map(|teeth| Angle::from_si(teeth.toothed.meshes[mesh].pair.working_angle_rad()))
        };
        given.into_iter().enumerate().map(|(mesh, given)| given.or_else(|| of_teeth(mesh))).collect()
    }

    /// Stiffness of each mesh with its origin.
    fn stiffness(
        &self,
        vibration: &VibrationEntry,
        teeth: Option<&Teeth>,
    ) -> Result<Option<Vec<(Stiffness, StiffnessOrigin)>>, Error> {
        let given = given(vibration.mesh_stiffness.as_ref(), &self.data.vibrating.meshes);
        let mut all = vec![];
        for (mesh, given) in given.into_iter().enumerate() {
            let of_teeth = teeth.filter(|teeth| teeth.is_sized).map(|teeth| &teeth.toothed.meshes[mesh]);
            let width = self.data.common_width(self.set.gears_of_mesh(mesh));
            all.push(match (given, of_teeth.zip(width)) {
                (Some(given), _) => (given, StiffnessOrigin::Given),
                (None, Some((mesh, width))) => {
                    let stiffness = mesh_stiffness(&mesh.pair, width);
                    let stiffness = stiffness.map_err(|error| self.refused(&["face_width"], &error))?;
                    (stiffness, StiffnessOrigin::Iso6336)
                }
                _ => return Ok(None),
            });
        }
        Ok(Some(all))
    }

    /// Angle of each kind of planets from the first kind; `None` where two in mesh do not reach each other.
    fn offsets(&self, teeth: Option<&Teeth>, planets: usize) -> Option<Vec<f64>> {
        let count = self.set.planets().len();
        if count < 2 {
            return Some(vec![0.0; count]);
        }
        let angles = self.set.angles_between(&teeth?.toothed, &self.data.is_behind)?;
        let mut firsts: Vec<usize> = angles.iter().map(|(first, _)| *first).collect();
        firsts.sort_unstable();
        firsts.dedup();
        // Planets that no mesh ties share the space between the first ones equally.
        let step = TAU / planets as f64 / firsts.len() as f64;
        let of = |(first, angle): (usize, Angle)| {
            let place = firsts.iter().position(|one| *one == first).unwrap_or_default();
            angle.si() + step * place as f64
        };
        Some(angles.into_iter().map(of).collect())
    }

    fn planet_name(&self, planet: usize) -> &str {
        &self.data.vibrating.planets[planet]
    }

    fn gear_name(&self, gear: GearOf) -> &str {
        &self.data.gears.names[self.data.place(gear)]
    }

    fn mesh_name(&self, gears: [GearOf; 2]) -> String {
        let is_alone = |gear: &GearOf| {
            let own = self.set.meshes().iter().filter(|mesh| mesh.gears.contains(gear));
            matches!(gear, GearOf::Central(_)) && own.count() == 1
        };
        match gears.iter().find(|gear| is_alone(gear)) {
            Some(gear) if !self.set.is_pair() => self.gear_name(*gear).to_owned(),
            _ => gears.map(|gear| self.gear_name(gear)).join("-"),
        }
    }

    /// Mass and inertia of a planet: the sum of its gears.
    fn planet(
        &self,
        vibration: &VibrationEntry,
        planet: usize,
        teeth: Option<&Teeth>,
        radii: Option<&[Length]>,
    ) -> Result<Inertias, Error> {
        let name = self.planet_name(planet);
        let of_set = &self.data.planets[planet];
        let bore = of_set.bore.unwrap_or_default();
        let bore_keys =
            if self.set.short().is_some() { vec!["planet_bore"] } else { vec!["planet_sizes", name, "bore"] };
        let steps = 0..self.set.planets()[planet].gears.len();
        let sizes = steps.map(|step| self.size(teeth, GearOf::Planet(planet, step)));
        let sizes = sizes.collect::<Option<Vec<_>>>().unwrap_or_default().into_iter();
        let shapes = sizes.map(|(diameters, width)| self.shape(diameters, bore, width, &bore_keys));
        let shape = shapes.collect::<Result<Vec<_>, _>>()?.into_iter().reduce(|sum, own| sum + own);
        let entry = vibration.body(name);
        let radius = radii.map(|radii| radii[self.data.place(GearOf::Planet(planet, 0))]);
        let inertia = self.inertia(&vibration.keys_of(name), &entry, radius)?;
        let mass = entry.mass.map(|mass| mass.0).or(of_set.mass);
        Ok(with_shape((mass, inertia), shape))
    }

    /// Tip and root diameter and face width of a gear.
    fn size(&self, teeth: Option<&Teeth>, gear: GearOf) -> Option<([Length; 2], Length)> {
        let (own, module) = teeth?.gear(gear)?;
        let diameters = [own.tip_diameter(), own.root_diameter()].map(|diameter| module * diameter);
        Some((diameters, self.data.face_widths[self.data.place(gear)]?))
    }

    /// Central gears, and the carrier of a planet set, with the radii of their coordinates.
    fn members(
        &self,
        vibration: &VibrationEntry,
        teeth: Option<&Teeth>,
        radii: &[Length],
        circle: Option<Length>,
    ) -> Result<Vec<MemberBody>, Error> {
        let mut all = vec![];
        for central in 0..self.set.centrals().len() {
            let gear = GearOf::Central(central);
            let (name, radius) = (self.gear_name(gear), radii[self.data.place(gear)]);
            let (entry, keys) = (vibration.body(name), vibration.keys_of(name));
            let at = |key| [&keys[..], &[key]].concat();
            let size = self.size(teeth, gear);
            let is_internal = self.set.gear_kind(gear) == Some(GearKind::Internal);
            let shape = if is_internal {
                let outside = size.zip(entry.outside_diameter);
                let keys = at("outside_diameter");
                outside.map(|((of, width), outside)| self.rim(of, outside.0, width, &keys)).transpose()?
            } else {
                let bore = entry.bore.map_or_else(Length::default, |bore| bore.0);
                size.map(|(of, width)| self.shape(of, bore, width, &at("bore"))).transpose()?
            };
            let part = if is_internal { Part::Ring } else { Part::Sun };
            all.push(self.member(name, part, &keys, (&entry, radius), shape)?);
        }
        if let Some(circle) = circle {
            let entry = BodyEntry::from(vibration.carrier.clone());
            let keys = vibration.keys_of("carrier");
            all.push(self.member("carrier", Part::Carrier, &keys, (&entry, circle), None)?);
        }
        Ok(all)
    }

    fn member(
        &self,
        name: &str,
        part: Part,
        keys: &[&str],
        (entry, radius): (&BodyEntry, Length),
        shape: Option<MassProperties>,
    ) -> Result<MemberBody, Error> {
        let inertia = self.inertia(keys, entry, Some(radius))?;
        let (mass, inertia) = with_shape((entry.mass.map(|mass| mass.0), inertia), shape);
        Ok(MemberBody {
            name: name.to_owned(),
            part,
            keys: keys.join("."),
            radius,
            mass,
            inertia,
            support: entry.support.map(|one| one.0),
            tangential: entry.tangential_support.map(|one| one.0),
        })
    }

    /// Inertia in one of the two forms in which it can be given.
    fn inertia(
        &self,
        keys: &[&str],
        entry: &BodyEntry,
        radius: Option<Length>,
    ) -> Result<Option<MomentOfInertia>, Error> {
        match (entry.inertia, entry.rotary_mass, radius) {
            (Some(_), Some(_), _) => {
                Err(self.refused(keys, &Named("inertia-twice", "give one of `inertia` and `rotary_mass`")))
            }
            (Some(inertia), ..) => Ok(Some(inertia.0)),
            (None, Some(rotary), Some(radius)) => {
                Ok(Some(Body::with_rotary_mass(Mass::default(), rotary.0, radius).inertia))
            }
            _ => Ok(None),
        }
    }

    /// External gear: half filled between tip and root circle, solid from there to the bore.
    fn shape(
        &self,
        [tip, root]: [Length; 2],
        bore: Length,
        width: Length,
        keys: &[&str],
    ) -> Result<MassProperties, Error> {
        let refuse = |error| self.refused(keys, &error);
        let teeth = ring(tip, root, width, self.density()).map_err(refuse)? * TOOTH_FILL;
        Ok(teeth + ring(root, bore, width, self.density()).map_err(refuse)?)
    }

    /// Internal gear below a rim.
    fn rim(
        &self,
        [tip, root]: [Length; 2],
        outside: Length,
        width: Length,
        keys: &[&str],
    ) -> Result<MassProperties, Error> {
        if outside <= root {
            let [outside, root] = [outside, root].map(Physical::mm);
            let message = format!("{outside} mm is not above the root circle of the ring, {root} mm");
            return Err(self.refused(keys, &Named("no-rim", message)));
        }
        let refuse = |error| self.refused(keys, &error);
        let teeth = ring(root, tip, width, self.density()).map_err(refuse)? * TOOTH_FILL;
        Ok(teeth + ring(outside, root, width, self.density()).map_err(refuse)?)
    }

    fn density(&self) -> MassDensity {
        self.file.gear_density()
    }

    pub(super) fn refused(&self, keys: &[&str], why: &dyn Fault) -> Error {
        refused(&self.subject.document, &self.data.path, keys, why)
    }
}

/// Values of a key in the order of the names.
fn given<T: Copy>(values: Option<&PerGear<Quantity<T>>>, names: &Gears) -> Vec<Option<T>> {
    let Some(values) = values else { return vec![None; names.names.len()] };
    values.of_gears(names).into_iter().map(|value| value.map(|value| value.0)).collect()
}

fn with_shape(given: Inertias, shape: Option<MassProperties>) -> Inertias {
    (given.0.or(shape.map(|shape| shape.mass)), given.1.or(shape.map(|shape| shape.polar_inertia)))
}
