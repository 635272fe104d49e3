//! Set of a file as bodies and springs, as far as the file has enough data.

use super::records::{StiffnessOrigin, Stiffnesses, VibratingBody};
use super::spacing::Spacing;
use crate::error::Error;
use crate::shared::fault::{Fault, Named, refused};
use crate::shared::gearbox::Gearbox;
use crate::shared::toothed::{self, missing_teeth};
use epicyclic_formats::Path;
use epicyclic_formats::gearbox::{GearboxFile, SetEntry, Stiffness, VibrationEntry};
use epicyclic_gears::involute::PlanetSet as ToothedSet;
use epicyclic_gears::mass::{MassProperties, TOOTH_FILL, ring};
use epicyclic_pictures::modes::Part;
use epicyclic_strength::load::mesh_stiffness;
use epicyclic_train::PlanetSet;
use epicyclic_train::set::SetSpec;
use epicyclic_units::{Physical, Quantity};
use epicyclic_vibration::{Body, Central, Freedom, Planet, PlanetarySet, Support};
use uom::si::f64::{Angle, Length, Mass, MassDensity, MomentOfInertia, Torque};

/// Set of the file whose vibration is calculated.
pub(super) struct Of<'a> {
    pub(super) subject: &'a Gearbox,
    pub(super) file: &'a GearboxFile,
    pub(super) path: Path,
    pub(super) entry: &'a SetEntry,
    pub(super) spec: &'a SetSpec,
    pub(super) set: &'a PlanetSet,
}

/// Data of a set in the file, for any held members.
pub(super) struct Prepared {
    pub(super) planets: u32,
    /// Tooth numbers of sun, planet and ring.
    pub(super) teeth: Option<[u32; 3]>,
    pub(super) spacing: Spacing,
    members: [MemberBody; 3],
    planet: Body,
    bearing: Stiffness,
    meshes: [Stiffness; 2],
    meshes_by: StiffnessOrigin,
    angles: [Angle; 2],
}

/// Sun, ring or carrier with its inertia and support.
struct MemberBody {
    of: Part,
    radius: Length,
    mass: Option<Mass>,
    inertia: Option<MomentOfInertia>,
    support: Option<Stiffness>,
    tangential: Option<Stiffness>,
}

/// Set with its held members in some gears.
pub(super) struct Built {
    pub(super) set: PlanetarySet,
    pub(super) bodies: Vec<VibratingBody>,
    pub(super) stiffness: Stiffnesses,
}

/// Mass and inertia of a body: given, or from its shape.
type Inertias = (Option<Mass>, Option<MomentOfInertia>);

impl Of<'_> {
    /// Data of the set in the file, or the keys that are missing.
    pub(super) fn prepared(&self) -> Result<Result<Prepared, Vec<String>>, Error> {
        let (entry, Some(vibration)) = (self.entry, self.entry.vibration.as_ref()) else {
            return Ok(Err(vec!["vibration".to_owned()]));
        };
        let toothed = toothed::gears(self.subject, &self.path, self.spec)?;
        if let Some(module) = entry.module.filter(|module| module.0.si() <= 0.0) {
            return Err(self.refused(
                &["module"],
                &Named("not-positive", format!("module is {} m; it must be above 0", module.0.si())),
            ));
        }
        let sized = toothed.as_ref().zip(entry.module.map(|module| module.0));
        // Given values replace those of the teeth, so that sets without known teeth can be calculated.
        let radii = match vibration.base_radii {
            Some(radii) => Some(radii.map(|radius| radius.0)),
            None => sized.map(|(set, module)| set.gears().map(|gear| module * (gear.base_diameter() / 2.0))),
        };
        let circle = entry.carrier_radius.map(|radius| radius.0);
        let circle = circle.or(sized.map(|(set, module)| module * set.centre_distance()));
        let angles = match (vibration.pressure_angles, &toothed) {
            (Some(angles), _) => Some(angles.map(|angle| angle.0)),
            (None, Some(set)) => {
                Some([set.sun_mesh(), set.ring_mesh()].map(|pair| Angle::from_si(pair.working_angle_rad())))
            }
            _ => None,
        };
        let width = entry.face_width.map(|width| width.0);
        let by_teeth = sized.zip(width);
        let (meshes, meshes_by) = match (vibration.mesh_stiffness, by_teeth) {
            (Some(given), _) => (Some(given.map(|one| one.0)), StiffnessOrigin::Given),
            (None, Some(((set, _), width))) => {
                let of =
                    |pair| mesh_stiffness(pair, width).map_err(|error| self.refused(&["face_width"], &error));
                (Some([of(set.sun_mesh())?, of(set.ring_mesh())?]), StiffnessOrigin::Iso6336)
            }
            _ => (None, StiffnessOrigin::Iso6336),
        };
        let planet = self.planet(vibration, by_teeth, radii)?;
        let spacing = Spacing::of(self.set).transpose().map_err(|message| {
            let why = Named("planet-angles", message);
            self.refused(&["planet_angles", "vibration", "planet_angles"], &why)
        })?;
        if let (
            Some((planets, spacing)),
            Some(radii),
            Some(circle),
            Some(angles),
            Some(meshes),
            (Some(mass), Some(inertia)),
        ) = (self.set.planet_count().zip(spacing), radii, circle, angles, meshes, planet)
        {
            let teeth = toothed.map(|set| set.gears().map(|gear| gear.teeth().get()));
            return Ok(Ok(Prepared {
                planets,
                teeth,
                spacing,
                members: self.members(vibration, by_teeth, [radii[0], radii[2], circle])?,
                planet: Body { mass, inertia, radius: radii[1] },
                bearing: vibration.planet_bearing.0,
                meshes,
                meshes_by,
                angles,
            }));
        }
        let teeth = missing_teeth(entry);
        // Of the data for a shape, the message names the first that is missing: teeth, module, face width.
        let has = |is_known: bool, in_their_place: &str| {
            let missing = match (toothed.is_some(), entry.module.is_some()) {
                (false, _) => teeth,
                (true, false) => "module",
                (true, true) => "face_width",
            };
            (!is_known).then(|| format!("{missing} (or {in_their_place})"))
        };
        let mut missing: Vec<String> = [
            self.set.planet_count().is_none().then(|| "planets".to_owned()),
            has(radii.is_some(), "vibration.base_radii"),
            has(circle.is_some(), "carrier_radius"),
            has(angles.is_some(), "vibration.pressure_angles"),
            has(meshes.is_some(), "vibration.mesh_stiffness"),
            has(planet.0.is_some(), "planet_mass"),
            has(planet.1.is_some(), "vibration.planet.inertia"),
        ]
        .into_iter()
        .flatten()
        .collect();
        // Several values may lack the same key, which is then named once.
        missing.dedup();
        Ok(Err(missing))
    }

    fn planet(
        &self,
        vibration: &VibrationEntry,
        by_teeth: Option<((&ToothedSet, Length), Length)>,
        radii: Option<[Length; 3]>,
    ) -> Result<Inertias, Error> {
        let bore = self.entry.planet_bore.map_or_else(Length::default, |bore| bore.0);
        let shape = by_teeth.map(|((set, module), width)| {
            let gear = set.gears()[1];
            let diameters = [gear.tip_diameter(), gear.root_diameter()].map(|diameter| module * diameter);
            self.shape(diameters, bore, width, &["planet_bore"])
        });
        let shape = shape.transpose()?;
        let keys = ["vibration", "planet"];
        let of = vibration.planet.clone();
        let inertia = self.inertia(&keys, of.inertia, of.rotary_mass, radii.map(|radii| radii[1]))?;
        let mass = self.entry.planet_mass.map(|mass| mass.0);
        Ok(with_shape((mass, inertia), shape))
    }

    /// Sun, ring and carrier with the radii of their coordinates.
    fn members(
        &self,
        vibration: &VibrationEntry,
        by_teeth: Option<((&ToothedSet, Length), Length)>,
        [sun_radius, ring_radius, circle]: [Length; 3],
    ) -> Result<[MemberBody; 3], Error> {
        let (sun, ring, carrier) = (&vibration.sun, &vibration.ring, &vibration.carrier);
        let diameters = |gear: usize| {
            by_teeth.map(|((set, module), width)| {
                let gear = set.gears()[gear];
                ([gear.tip_diameter(), gear.root_diameter()].map(|diameter| module * diameter), width)
            })
        };
        let bore = sun.bore.map_or_else(Length::default, |bore| bore.0);
        let solid =
            diameters(0).map(|(of, width)| self.shape(of, bore, width, &["vibration", "sun", "bore"]));
        let rim = diameters(2).zip(ring.outside_diameter).map(|((of, width), outside)| {
            let keys = ["vibration", "ring", "outside_diameter"];
            self.rim(of, outside.0, width, &keys)
        });
        let own = |part: &str, inertia, rotary, radius| {
            self.inertia(&["vibration", part], inertia, rotary, Some(radius))
        };
        let value = |stiffness: Option<Quantity<Stiffness>>| stiffness.map(|one| one.0);
        let of_sun = own("sun", sun.inertia, sun.rotary_mass, sun_radius)?;
        let of_ring = own("ring", ring.inertia, ring.rotary_mass, ring_radius)?;
        let of_carrier = own("carrier", carrier.inertia, carrier.rotary_mass, circle)?;
        let (sun_mass, sun_inertia) = with_shape((sun.mass.map(|mass| mass.0), of_sun), solid.transpose()?);
        let (ring_mass, ring_inertia) = with_shape((ring.mass.map(|mass| mass.0), of_ring), rim.transpose()?);
        Ok([
            MemberBody {
                of: Part::Sun,
                radius: sun_radius,
                mass: sun_mass,
                inertia: sun_inertia,
                support: value(sun.support),
                tangential: value(sun.tangential_support),
            },
            MemberBody {
                of: Part::Ring,
                radius: ring_radius,
                mass: ring_mass,
                inertia: ring_inertia,
                support: value(ring.support),
                tangential: value(ring.tangential_support),
            },
            MemberBody {
                of: Part::Carrier,
                radius: circle,
                mass: carrier.mass.map(|mass| mass.0),
                inertia: of_carrier,
                support: value(carrier.support),
                tangential: value(carrier.tangential_support),
            },
        ])
    }

    /// Inertia in one of the two forms in which it can be given.
    fn inertia(
        &self,
        keys: &[&str],
        inertia: Option<Quantity<MomentOfInertia>>,
        rotary: Option<Quantity<Mass>>,
        radius: Option<Length>,
    ) -> Result<Option<MomentOfInertia>, Error> {
        match (inertia, rotary, radius) {
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
        refused(&self.subject.document, &self.path, keys, why)
    }
}

fn with_shape(given: Inertias, shape: Option<MassProperties>) -> Inertias {
    (given.0.or(shape.map(|shape| shape.mass)), given.1.or(shape.map(|shape| shape.polar_inertia)))
}

impl Prepared {
    /// Set with these held members of sun, ring and carrier, or the keys that are missing.
    pub(super) fn built(&self, held: [bool; 3]) -> Result<Built, Vec<String>> {
        let mut missing = vec![];
        let mut built = self.members.iter().zip(held).map(|(member, held)| member.built(held, &mut missing));
        let mut next = || built.next();
        let (Some((sun, sun_body)), Some((ring, ring_body)), Some((carrier, carrier_body))) =
            (next(), next(), next())
        else {
            return Err(vec![]);
        };
        drop(built);
        if !missing.is_empty() {
            return Err(missing);
        }
        let [sun_mesh, ring_mesh] = self.meshes;
        let planet_body = VibratingBody {
            body: Part::Planet,
            mass_kg: Some(self.planet.mass.si()),
            inertia_kg_m2: Some(self.planet.inertia.si()),
            radius_m: self.planet.radius.si(),
        };
        let radial = |member: usize| self.members[member].support.map(Physical::si);
        let tangential =
            |member: usize| self.members[member].tangential.filter(|_| held[member]).map(Physical::si);
        let stiffness = Stiffnesses {
            meshes_by: self.meshes_by,
            sun_mesh_n_m: sun_mesh.si(),
            ring_mesh_n_m: ring_mesh.si(),
            planet_bearing_n_m: self.bearing.si(),
            sun_support_n_m: radial(0),
            ring_support_n_m: radial(1),
            carrier_support_n_m: radial(2),
            sun_tangential_support_n_m: tangential(0),
            ring_tangential_support_n_m: tangential(1),
            carrier_tangential_support_n_m: tangential(2),
        };
        Ok(Built {
            set: self.with(sun, ring, carrier),
            bodies: vec![sun_body, ring_body, carrier_body, planet_body],
            stiffness,
        })
    }
}

impl Prepared {
    /// Set for a torsional model with these held members of sun, ring and carrier, or the keys that are
    /// missing.
    pub(super) fn torsional(&self, held: [bool; 3]) -> Result<PlanetarySet, Vec<String>> {
        let mut missing = vec![];
        let [sun, ring, carrier] = [0, 1, 2].map(|member| {
            let (own, held) = (&self.members[member], held[member]);
            // A member that is held rotates only against an elastic support.
            let rotates = !held || own.tangential.is_some();
            if rotates && own.inertia.is_none() {
                missing.push(own.needed("inertia"));
            }
            let inertia = own.inertia.filter(|_| rotates).unwrap_or_default();
            let body = Body { mass: Mass::default(), inertia, radius: own.radius };
            Central { body, support: Support::default(), freedom: Freedom::Rotation }
        });
        if missing.is_empty() { Ok(self.with(sun, ring, carrier)) } else { Err(missing) }
    }

    /// Whether the planets are equally spaced.
    pub(super) fn is_equally_spaced(&self) -> bool {
        self.spacing.is_equal
    }

    /// Whether sun, ring or carrier has a tangential support.
    pub(super) fn is_elastic(&self, member: usize) -> bool {
        self.members[member].tangential.is_some()
    }

    /// Radial stiffness of the support of sun, ring or carrier; `None` if its centre is held.
    pub(super) fn radial_support(&self, member: usize) -> Option<Stiffness> {
        self.members[member].support
    }

    /// Torsional stiffness of the support that holds sun, ring or carrier; `None` for a rigid support.
    pub(super) fn support(&self, member: usize) -> Option<Torque> {
        let own = &self.members[member];
        let radius = own.radius.si();
        own.tangential.map(|stiffness| Torque::from_si(stiffness.si() * radius * radius))
    }

    fn with(&self, sun: Central, ring: Central, carrier: Central) -> PlanetarySet {
        let [sun_mesh, ring_mesh] = self.meshes;
        let planet = Planet {
            body: self.planet,
            angle: Angle::default(),
            bearing: self.bearing.into(),
            sun_mesh: sun_mesh.into(),
            ring_mesh: ring_mesh.into(),
        };
        PlanetarySet {
            sun,
            ring,
            carrier,
            planets: self
                .spacing
                .angles_rad
                .iter()
                .map(|at| Planet { angle: Angle::from_si(*at), ..planet })
                .collect(),
            sun_pressure_angle: self.angles[0],
            ring_pressure_angle: self.angles[1],
        }
    }
}

impl MemberBody {
    /// Name of the missing key, with the keys that can replace it.
    fn needed(&self, key: &str) -> String {
        match self.of {
            Part::Sun => format!("vibration.sun.{key} (or face_width)"),
            Part::Ring => format!("vibration.ring.{key} (or vibration.ring.outside_diameter)"),
            _ => format!("vibration.carrier.{key}"),
        }
    }

    /// Part with its mobile parts; missing keys are added to the list.
    fn built(&self, held: bool, missing: &mut Vec<String>) -> (Central, VibratingBody) {
        let translates = self.support.is_some();
        let rotates = !held || self.tangential.is_some();
        let mut need = |is_known: bool, key: &str| {
            if !is_known {
                missing.push(self.needed(key));
            }
        };
        need(!translates || self.mass.is_some(), "mass");
        need(!rotates || self.inertia.is_some(), "inertia");
        let (mass, inertia) = (self.mass.filter(|_| translates), self.inertia.filter(|_| rotates));
        let central = Central {
            body: Body {
                mass: mass.unwrap_or_default(),
                inertia: inertia.unwrap_or_default(),
                radius: self.radius,
            },
            support: Support {
                radial: self.support.unwrap_or_default().into(),
                tangential: self.tangential.filter(|_| held).unwrap_or_default().into(),
            },
            freedom: match (translates, rotates) {
                (true, true) => Freedom::Planar,
                (true, false) => Freedom::Translation,
                (false, true) => Freedom::Rotation,
                (false, false) => Freedom::Held,
            },
        };
        let body = VibratingBody {
            body: self.of,
            mass_kg: mass.map(Physical::si),
            inertia_kg_m2: inertia.map(Physical::si),
            radius_m: self.radius.si(),
        };
        (central, body)
    }
}
