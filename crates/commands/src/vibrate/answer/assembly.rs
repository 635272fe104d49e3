//! Set as bodies and springs, with its held members and loaded flanks in some gears.

use super::prepared::{MemberBody, Mesh, Prepared};
use super::records::{Spring, StiffnessOrigin, VibratingBody};
use epicyclic_formats::gearbox::Stiffness;
use epicyclic_pictures::modes::Part;
use epicyclic_train::planet_set::GearOf;
use epicyclic_units::Physical;
use epicyclic_vibration::{
    Body, BodyOf, Central, Freedom, Gear, GearMesh, GearSet, Member, PlanetBody, Support,
};
use std::f64::consts::TAU;
use uom::si::f64::{Angle, Mass, Torque};

/// Held members and loaded flanks of a set in some gears.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Case {
    /// Whether the link of each member is held, the carrier last.
    pub(super) held: Vec<bool>,
    /// Whether the first gear of each mesh drives in the positive direction.
    pub(super) forward: Vec<bool>,
}

/// Set with its held members in some gears.
pub(super) struct Built {
    pub(super) set: GearSet,
    pub(super) bodies: Vec<VibratingBody>,
    pub(super) springs: Vec<Spring>,
}

impl Prepared {
    /// Set with its held members, or the keys that are missing.
    pub(super) fn built(&self, case: &Case) -> Result<Built, Vec<String>> {
        let mut missing = vec![];
        let (mut members, mut bodies, mut springs) = (vec![], vec![], self.own_springs());
        for (member, held) in self.members.iter().zip(&case.held) {
            let (central, body) = member.built(*held, &mut missing);
            members.push(Member { name: member.name.clone(), central });
            bodies.push(body);
        }
        if !missing.is_empty() {
            return Err(missing);
        }
        let given = |spring: String, stiffness: Option<Stiffness>| {
            stiffness.map(|stiffness| Spring {
                spring,
                stiffness_n_m: stiffness.si(),
                by: StiffnessOrigin::Given,
                pressure_angle_rad: None,
                helix_angle_rad: None,
            })
        };
        springs.extend(
            self.members.iter().filter_map(|one| given(format!("{} support", one.name), one.support)),
        );
        springs.extend(self.members.iter().zip(&case.held).filter_map(|(one, held)| {
            given(format!("{}, tangential", one.name), one.tangential.filter(|_| *held))
        }));
        let set = self.with(members, &case.forward);
        bodies.extend(self.planet_kinds.iter().enumerate().map(|(kind, one)| {
            let first = &set.planets[kind * self.copies()];
            let (distance, psi) = (first.distance.si(), first.angle.si());
            VibratingBody {
                body: one.name.clone(),
                part: Part::Planet,
                mass_kg: Some(one.body.mass.si()),
                inertia_kg_m2: Some(one.body.inertia.si()),
                radius_m: one.body.radius.si(),
                centre_m: [distance * libm::cos(psi), distance * libm::sin(psi)],
            }
        }));
        if let ([first, second], []) = (&mut bodies[..], &self.planet_kinds[..]) {
            second.centre_m = [pair_distance(first.radius_m, second.radius_m, &self.meshes[0]), 0.0];
        }
        Ok(Built { set, bodies, springs })
    }

    /// Set for a torsional model with its held members, or the keys that are missing.
    pub(super) fn torsional(&self, case: &Case) -> Result<GearSet, Vec<String>> {
        let mut missing = vec![];
        let member = |(own, held): (&MemberBody, &bool)| {
            // A member that is held rotates only against an elastic support.
            let rotates = !held || own.tangential.is_some();
            if rotates && own.inertia.is_none() {
                missing.push(own.needed("inertia"));
            }
            let inertia = own.inertia.filter(|_| rotates).unwrap_or_default();
            let body = Body { mass: Mass::default(), inertia, radius: own.radius };
            let central = Central { body, support: Support::default(), freedom: Freedom::Rotation };
            Member { name: own.name.clone(), central }
        };
        let members: Vec<Member> = self.members.iter().zip(&case.held).map(member).collect();
        if missing.is_empty() { Ok(self.with(members, &case.forward)) } else { Err(missing) }
    }

    /// Whether it has a sun, a ring and planets with one gear, as the sources of vibration describe sets.
    pub(super) fn is_simple(&self) -> bool {
        let parts: Vec<Part> = self.members.iter().map(|member| member.part).collect();
        parts == [Part::Sun, Part::Ring, Part::Carrier]
            && self.planet_kinds.len() == 1
            && self.meshes.iter().all(|mesh| mesh.gears[1].0 == GearOf::Planet(0, 0))
    }

    /// Tooth number of a gear, if it is known.
    pub(super) fn teeth_of(&self, gear: GearOf) -> Option<u32> {
        self.teeth.iter().find(|(own, _)| *own == gear).map(|(_, teeth)| *teeth)
    }

    /// Values of one kind of mesh among those of all meshes, which are in the order of [`GearSet::meshes`].
    pub(super) fn of_mesh<T: Copy>(&self, all: &[T], mesh: usize) -> Vec<T> {
        all.iter().copied().skip(mesh).step_by(self.meshes.len()).collect()
    }

    /// Number of equal planets and meshes of each kind; 1 of a pair.
    pub(super) fn copies(&self) -> usize {
        self.spacing.angles_rad.len()
    }

    /// Whether the planets are equally spaced.
    pub(super) fn is_equally_spaced(&self) -> bool {
        self.spacing.is_equal
    }

    /// Whether a member has a tangential support.
    pub(super) fn is_elastic(&self, member: usize) -> bool {
        self.members.get(member).is_some_and(|member| member.tangential.is_some())
    }

    /// Torsional stiffness of the support that holds a member; `None` for a rigid support.
    pub(super) fn support(&self, member: usize) -> Option<Torque> {
        let own = &self.members[member];
        let radius = own.radius.si();
        own.tangential.map(|stiffness| Torque::from_si(stiffness.si() * radius * radius))
    }

    /// Springs of meshes and planets.
    fn own_springs(&self) -> Vec<Spring> {
        let meshes = self.meshes.iter().map(|mesh| Spring {
            spring: format!("{} mesh", mesh.name),
            stiffness_n_m: mesh.stiffness.si(),
            by: mesh.by,
            pressure_angle_rad: Some(mesh.pressure_angle.si()),
            helix_angle_rad: Some(mesh.helix_angle.si()),
        });
        let bearings = self.planet_kinds.iter().map(|planet| Spring {
            spring: format!("{} bearing", planet.name),
            stiffness_n_m: planet.bearing.si(),
            by: StiffnessOrigin::Given,
            pressure_angle_rad: None,
            helix_angle_rad: None,
        });
        meshes.chain(bearings).collect()
    }

    /// The set with its planets, those of one kind in a row, and all meshes, those of one planet or planets
    /// in mesh in a row.
    fn with(&self, members: Vec<Member>, forward: &[bool]) -> GearSet {
        let copies = self.copies();
        let planets = self.planet_kinds.iter().flat_map(|planet| {
            self.spacing.angles_rad.iter().zip(1..).map(move |(at, number)| PlanetBody {
                name: format!("{} {number}", planet.name),
                body: planet.body,
                distance: planet.distance,
                angle: Angle::from_si(match planet.offset_rad {
                    0.0 => *at,
                    offset => (at + offset).rem_euclid(TAU),
                }),
                bearing: planet.bearing.into(),
            })
        });
        let meshes = (0..copies).flat_map(|copy| {
            self.meshes.iter().zip(forward).map(move |(mesh, is_forward)| GearMesh {
                gears: [0, 1].map(|end| {
                    let (gear, base_radius) = mesh.gears[end];
                    let of = match gear {
                        GearOf::Central(central) => BodyOf::Member(central),
                        GearOf::Planet(planet, _) => BodyOf::Planet(planet * copies + copy),
                    };
                    Gear { of, base_radius, is_internal: mesh.is_internal && end == 0 }
                }),
                stiffness: mesh.stiffness.into(),
                pressure_angle: mesh.pressure_angle,
                is_forward: *is_forward,
            })
        });
        let carrier = (!self.planet_kinds.is_empty()).then(|| members.len() - 1);
        GearSet { carrier, planets: planets.collect(), meshes: meshes.collect(), members }
    }
}

/// Distance of the centres of a pair, whose second gear lies in the direction of `x`, also a pinion in its
/// ring.
fn pair_distance(first: f64, second: f64, mesh: &Mesh) -> f64 {
    let cosine = libm::cos(mesh.pressure_angle.si());
    if mesh.is_internal { (first - second) / cosine } else { (first + second) / cosine }
}

impl MemberBody {
    /// Name of the missing key, with the keys that can replace it.
    fn needed(&self, key: &str) -> String {
        let Self { keys, .. } = self;
        match self.part {
            Part::Sun => format!("{keys}.{key} (or face_width)"),
            Part::Ring => format!("{keys}.{key} (or {keys}.outside_diameter)"),
            _ => format!("{keys}.{key}"),
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
            body: self.name.clone(),
            part: self.part,
            mass_kg: mass.map(Physical::si),
            inertia_kg_m2: inertia.map(Physical::si),
            radius_m: self.radius.si(),
            centre_m: [0.0, 0.0],
        };
        (central, body)
    }
}
