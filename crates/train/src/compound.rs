//! Description of a compound planet set: any central gears, any planets, any tree of meshes.
//!
//! Examples are Ravigneaux, Wolfrom, stepped planets with idlers, ring to ring through meshing planets, and
//! planets whose own rotation is taken out. Gears that share planets are one set, since each of its meshes
//! exists once.
//!
//! ```
//! use epicyclic_gears::efficiency::MeshEfficiency;
//! use epicyclic_train::compound::CompoundSpec;
//! use epicyclic_train::Gearbox;
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // A Wolfrom drive: sun 32, planets with steps 34 and 30, ring 100 held, ring 96 driven.
//! let eta = MeshEfficiency::new(0.99)?;
//! let wolfrom = CompoundSpec::new("wolfrom", "arm")
//!     .sun("S", 32)
//!     .ring("ground", 100)
//!     .ring("out", 96)
//!     .planet("p", &[34, 30])
//!     .mesh("S", "p.1", eta)
//!     .mesh("p.1", "ground", eta)
//!     .mesh("p.2", "out", eta)
//!     .planet_count(3);
//! let gearbox = Gearbox::builder("51 to 1")
//!     .links(["S", "arm", "out"])
//!     .compound_set(wolfrom)
//!     .input("S")
//!     .output("out")
//!     .gear("only", [""; 0])
//!     .build()?;
//! let only = gearbox.analyze("only")?;
//! assert_eq!(only.exact_ratio().unwrap().to_string(), "51");
//! assert!((only.efficiency().unwrap() - 0.8033).abs() < 1e-4);
//! # Ok(())
//! # }
//! ```

use crate::spacing::Spacing;
use crate::tooth_shape::ToothShape;
use epicyclic_gears::efficiency::MeshEfficiency;
use std::fmt;

/// Kind of a member of a set other than the carrier.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CentralKind {
    /// A gear with external teeth about the main axis.
    Sun,
    /// A gear with internal teeth about the main axis.
    Ring,
    /// A bevel gear on the one side of its planets.
    BevelLeft,
    /// A bevel gear on the other side.
    BevelRight,
    /// A shaft about the main axis that turns as fast as a planet about its own: the output of pins in the
    /// disc of a K-H-V or cycloidal drive, or of a universal joint.
    PlanetShaft,
}

impl fmt::Display for CentralKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Sun => "sun",
            Self::Ring => "ring",
            Self::BevelLeft | Self::BevelRight => "bevel gear",
            Self::PlanetShaft => "planet shaft",
        })
    }
}

/// A member of a set as errors name it: a central gear, a planet shaft or the carrier.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SetMember {
    /// A central gear or planet shaft.
    Central(CentralKind),
    /// The carrier.
    Carrier,
}

impl fmt::Display for SetMember {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Central(kind) => kind.fmt(f),
            Self::Carrier => f.pad("carrier"),
        }
    }
}

/// A member of a compound set.
#[derive(Debug, Clone, PartialEq)]
pub struct CentralSpec {
    /// Name of the member within the set, by which meshes name it.
    pub name: String,
    /// The link it belongs to.
    pub link: String,
    /// Kind of the member.
    pub kind: CentralKind,
    /// Number of teeth; for a [proportional](CompoundSpec::proportional) set a number proportional to it; 0
    /// for a planet shaft.
    pub teeth: f64,
    /// The planet that a planet shaft turns with.
    pub planet: Option<String>,
}

/// A planet of a compound set: one rigid body with one gear or several.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlanetSpec {
    /// Name of the planet. Its gears are called `name`, or `name.1`, `name.2`… if the planet has several.
    pub name: String,
    /// Teeth of its gears; empty of a planet with one gear whose teeth are not known: an idler changes no
    /// ratio of the others.
    pub teeth: Vec<u32>,
}

/// A mesh of a compound set.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshSpec {
    /// Names of the two gears.
    pub between: [String; 2],
    /// Efficiency of the mesh.
    pub efficiency: MeshEfficiency,
}

/// Description of a compound set, by names.
#[derive(Debug, Clone, PartialEq)]
pub struct CompoundSpec {
    /// Name of the set.
    pub id: String,
    /// Link of the carrier.
    pub carrier: String,
    /// The central gears and planet shafts, two or more.
    pub centrals: Vec<CentralSpec>,
    /// The planets that differ.
    pub planets: Vec<PlanetSpec>,
    /// The meshes: a tree over central gears and planets.
    pub meshes: Vec<MeshSpec>,
    /// Number of planets of each kind around the axis.
    pub planet_count: Option<u32>,
    /// Spacing of the planets on the carrier.
    pub spacing: Spacing,
    /// Shifts, helix angles and tools of its gears.
    pub tooth_shape: ToothShape,
    /// Whether the teeth are not known, only their proportions: those of central gears are any numbers above
    /// 0, those of planets are left out.
    pub proportional: bool,
}

/// The name of a gear of a set: of a central gear, of a planet, or of a step of a planet with several gears.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GearName {
    /// The central gear or planet.
    pub of: String,
    /// Number of the planet's gear, from 1, if the planet has several gears.
    pub step: Option<usize>,
}

impl GearName {
    /// The only gear of a central gear or planet.
    #[must_use]
    pub fn only(of: &str) -> Self {
        Self { of: of.to_owned(), step: None }
    }
}

impl fmt::Display for GearName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.step {
            None => f.write_str(&self.of),
            Some(step) => write!(f, "{}.{step}", self.of),
        }
    }
}

impl CompoundSpec {
    /// A set with nothing but its carrier.
    #[must_use]
    pub fn new(id: &str, carrier: &str) -> Self {
        Self {
            id: id.into(),
            carrier: carrier.into(),
            centrals: vec![],
            planets: vec![],
            meshes: vec![],
            planet_count: None,
            spacing: Spacing::default(),
            tooth_shape: ToothShape::default(),
            proportional: false,
        }
    }

    /// Names of its gears, in the order of [`PlanetSet::gears`](crate::PlanetSet::gears).
    #[must_use]
    pub fn gears(&self) -> Vec<GearName> {
        let centrals = self.centrals.iter().filter(|one| one.kind != CentralKind::PlanetShaft);
        let centrals = centrals.map(|central| GearName::only(&central.name));
        let planets = self.planets.iter().flat_map(|planet| {
            let several = planet.teeth.len() > 1;
            (1..=planet.teeth.len().max(1))
                .map(move |step| GearName { of: planet.name.clone(), step: several.then_some(step) })
        });
        centrals.chain(planets).collect()
    }

    /// Adds a sun, named as its link.
    #[must_use]
    pub fn sun(self, link: &str, teeth: u32) -> Self {
        self.central(CentralKind::Sun, link, f64::from(teeth))
    }

    /// Adds a ring, named as its link.
    #[must_use]
    pub fn ring(self, link: &str, teeth: u32) -> Self {
        self.central(CentralKind::Ring, link, f64::from(teeth))
    }

    /// Adds a central gear of any kind, named as its link.
    #[must_use]
    pub fn central(mut self, kind: CentralKind, link: &str, teeth: f64) -> Self {
        let (name, link) = (link.to_owned(), link.to_owned());
        self.centrals.push(CentralSpec { name, link, kind, teeth, planet: None });
        self
    }

    /// Adds a shaft that turns with a planet, named as its link.
    #[must_use]
    pub fn planet_shaft(mut self, link: &str, planet: &str) -> Self {
        self.centrals.push(CentralSpec {
            name: link.into(),
            link: link.into(),
            kind: CentralKind::PlanetShaft,
            teeth: 0.0,
            planet: Some(planet.into()),
        });
        self
    }

    /// Adds a planet with the teeth of its gears.
    #[must_use]
    pub fn planet(mut self, name: &str, teeth: &[u32]) -> Self {
        self.planets.push(PlanetSpec { name: name.into(), teeth: teeth.to_vec() });
        self
    }

    /// Adds a mesh between two gears: a central gear by its name, a planet's gear by `planet`, or by
    /// `planet.1`, `planet.2`… where the planet has several.
    #[must_use]
    pub fn mesh(mut self, first: &str, second: &str, efficiency: MeshEfficiency) -> Self {
        self.meshes.push(MeshSpec { between: [first.into(), second.into()], efficiency });
        self
    }

    /// Returns the set with this number of planets of each kind.
    #[must_use]
    pub fn planet_count(self, count: u32) -> Self {
        Self { planet_count: Some(count), ..self }
    }

    /// Returns the set with this spacing of its planets. Given angles also set the number of planets, unless
    /// it is already known.
    #[must_use]
    pub fn spaced(self, spacing: Spacing) -> Self {
        let planet_count = self.planet_count.or(spacing.count());
        Self { planet_count, spacing, ..self }
    }

    /// Returns the set with its teeth as proportions, for tooth numbers that are not known.
    ///
    /// ```
    /// use epicyclic_gears::efficiency::MeshEfficiency;
    /// use epicyclic_train::compound::{CentralKind, CompoundSpec};
    /// use epicyclic_train::Gearbox;
    /// # fn main() -> Result<(), epicyclic_train::Error> {
    /// let set = CompoundSpec::new("1", "arm")
    ///     .central(CentralKind::Sun, "in", 1.0)
    ///     .central(CentralKind::Ring, "out", 2.5)
    ///     .proportional()
    ///     .planet("planet", &[])
    ///     .mesh("in", "planet", MeshEfficiency::IDEAL)
    ///     .mesh("planet", "out", MeshEfficiency::IDEAL);
    /// let gearbox = Gearbox::builder("k = 2.5").links(["in", "arm", "out"]).compound_set(set);
    /// let gearbox = gearbox.brake("b", "arm").input("in").output("out").gear("1", ["b"]).build()?;
    /// assert_eq!(gearbox.analyze("1")?.ratio(), Some(-2.5));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn proportional(self) -> Self {
        Self { proportional: true, ..self }
    }

    /// Returns the set with this efficiency for every mesh.
    #[must_use]
    pub fn with_mesh_efficiency(mut self, efficiency: MeshEfficiency) -> Self {
        self.meshes.iter_mut().for_each(|mesh| mesh.efficiency = efficiency);
        self
    }
}
