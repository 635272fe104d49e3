//! A set as the search sees it: gears and meshes of any kind of set, and what each design must meet.
//!
//! Gears that mesh with one another are one *family*: they have one module and one face width. A planet of
//! several gears joins families: a stepped planet has two, a planet between sun and ring one.

use super::bearing::Bearing;
use super::{Objective, Requirement};
use crate::checks::{not_negative, positive, within};
use crate::factor::{Side, Symbol};
use crate::mesh::{Gear, Method};
use crate::plain_bearing::viscosity;
use crate::root::factors::MOST_ROOT_ROUGHNESS;
use crate::spectrum::{GearDuty, Step, Worn, check_shares};
use crate::{Error, Quantity};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::practice::least_face_load;
use epicyclic_gears::involute::{InvoluteGear, Pair};
use epicyclic_gears::life::Rolling;
use epicyclic_judge::Limits;
use epicyclic_units::Physical;
use std::sync::Arc;
use uom::si::f64::{Angle, AngularVelocity, Force, KinematicViscosity, Length, Mass, Time, Torque};

/// Part of the gearbox that a gear turns with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    /// A central gear, or a gear of a pair: there is one of it.
    Central,
    /// The planets of a kind, by their index.
    Planet(usize),
}

/// A gear of a set to size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizedGear {
    /// Material, roughness, tool. A rim that is stated is kept by a ring; planets have at least that.
    pub gear: Gear,
    /// Part that the gear turns with.
    pub body: Body,
    /// Index of its family.
    pub family: usize,
}

/// A mesh of a set to size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizedMesh {
    /// Indices of its gears, in the order of the pair.
    pub gears: [usize; 2],
    /// Method of calculation. Data of method B hold for one size, so they are not used here.
    pub method: Method,
}

/// Planets of a kind.
#[derive(Debug, Clone, PartialEq)]
pub struct SizedPlanet {
    /// Bearings to choose from; empty if planets have no bearing of a table.
    pub bearings: Arc<[Bearing]>,
    /// Whether axial forces of helical teeth tilt the planets, which then turn on pairs of bearings.
    pub is_tilted: bool,
    /// Bore if no bearing is chosen; `None` of solid planets.
    pub bore: Option<Length>,
    /// Mass of one planet for the force on its bearing, in place of that of its shape.
    pub mass: Option<Mass>,
    /// Mesh load factor `K_γ` for its bearing, in place of that of the layout.
    pub sharing: Option<f64>,
    /// Stated values of the bearing on its pin.
    pub pin: Pin,
}

impl SizedPlanet {
    /// Refuses bearings of one row alone for planets that a moment tilts.
    ///
    /// # Errors
    /// [`Error::OneBearingRow`].
    pub fn check_rows(&self) -> Result<(), Error> {
        let is_held = self.bearings.is_empty() || self.eligible().next().is_some();
        if is_held { Ok(()) } else { Err(Error::OneBearingRow) }
    }

    /// Bearings to choose from that hold the planets.
    pub(crate) fn eligible(&self) -> impl Iterator<Item = &Bearing> {
        eligible(&self.bearings, self.is_tilted)
    }
}

/// Bearings that hold planets, which a moment may tilt.
pub(crate) fn eligible(all: &[Bearing], is_tilted: bool) -> impl Iterator<Item = &Bearing> {
    all.iter().filter(move |bearing| !is_tilted || bearing.holds_moment())
}

/// Rolling elements and bearing of planets for which no bearing of a table is chosen, and the distance of its
/// rows, which is kept whatever the bearing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Pin {
    /// Rolling elements.
    pub rolling: Rolling,
    /// Mean diameter of the bearing.
    pub mean_diameter: Option<Length>,
    /// Distance of the middles of both rows; `None` where it follows from the bearing and the planet's width
    /// ([`Bearing::span`]).
    pub span: Option<Length>,
}

/// Safeties required against a torque that comes a few times in the life.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StaticDemand {
    /// Torque of one mesh on its first gear, 0 or more; a torque of 0 sets no requirement.
    pub torque: Torque,
    /// Required static safety of the flanks.
    pub required_contact: f64,
    /// Required static safety of the roots.
    pub required_root: f64,
}

/// Loads of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshLoads {
    /// Steps of the duty.
    pub steps: Vec<Step>,
    /// Sign of the torque on each gear in each step, which says which flank it loads; 0 without torque.
    pub flanks: Vec<[f64; 2]>,
    /// Contacts of a flank per revolution, of each gear.
    pub contacts: [f64; 2],
    /// Overloads.
    pub overloads: Vec<StaticDemand>,
}

/// Load of a planet's bearing in a step of the duty.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PlanetStep {
    /// Share of the time.
    pub share: f64,
    /// Tangential force of the meshes, along the orbit.
    pub tangential: Force,
    /// Radial force of the meshes, outwards above 0.
    pub radial: Force,
    /// Moment of the axial forces that tilts the planet, about the directions outwards and of `tangential`.
    pub moment: [Torque; 2],
    /// Gears of a stepped planet, each with the moment that its face width adds, over the width in N, about the same
    /// directions; empty of planets with one gear.
    pub of_widths: Vec<(usize, [f64; 2])>,
    /// Speed of the carrier.
    pub carrier_speed: AngularVelocity,
    /// Speed of the planet relative to the carrier.
    pub speed: AngularVelocity,
}

/// The gears of a set at certain modules, number of planets and centre distances, without face widths and
/// bearings.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// Number of planets of each kind; 1 of a pair.
    pub planets: u32,
    /// Module of each family.
    pub modules: Vec<Length>,
    /// The gears, in modules.
    pub gears: Arc<[InvoluteGear]>,
    /// The meshes, in modules.
    pub pairs: Arc<[Pair]>,
    /// Distance of the centres of each kind of planets from the main axis.
    pub radii: Vec<Length>,
    /// Whether the aim of the profile shifts is met in full.
    pub is_aim_met: bool,
    /// Loads of the meshes.
    pub loads: Arc<[MeshLoads]>,
    /// Mesh load factor `K_γ` for the bearings.
    pub sharing: f64,
    /// Loads of the bearings of each kind of planets, over the duty and, without a share, against overloads.
    pub bearing_loads: Vec<Vec<PlanetStep>>,
}

/// A set to size.
#[derive(Debug, Clone, PartialEq)]
pub struct Task {
    /// The gears.
    pub gears: Vec<SizedGear>,
    /// The meshes.
    pub meshes: Vec<SizedMesh>,
    /// The kinds of planets.
    pub planets: Vec<SizedPlanet>,
    /// Whether all kinds have the same bearing, of those of the first.
    pub has_one_bearing: bool,
    /// Face widths of each family.
    pub face_widths: Vec<Vec<Length>>,
    /// The greatest face width over the reference diameter of the smallest central gear with external teeth
    /// of the family, or of its smallest gear; `None` without bound.
    pub width_ratio: Option<f64>,
    /// The greatest outside diameter of a ring; `None` without bound.
    pub largest_ring: Option<Length>,
    /// Price of the [length](super::length) in kg/m, which counts beside the objective: the dearer, the shorter
    /// are the designs.
    pub length_price: f64,
    /// Viscosity of the oil at 40 °C.
    pub viscosity: KinematicViscosity,
    /// Viscosity of the oil in the planets' bearings; `None` for the usual one of plain bearings.
    pub working_viscosity: Option<KinematicViscosity>,
    /// Required life of teeth and bearings.
    pub life: Time,
    /// Required safety of the flanks.
    pub required_contact: f64,
    /// Required safety of the roots.
    pub required_root: f64,
    /// Least rim of the planets between root circle and bore, in modules.
    pub planet_rim: f64,
    /// Rim of rings outside the root circle, in modules.
    pub ring_rim: f64,
    /// Objective that is minimized.
    pub objective: Objective,
    /// The least angle between neighbouring planets; `None` if they are at equal angles.
    pub least_planet_angle: Option<Angle>,
    /// Whether the profile shifts are stated, not chosen.
    pub has_stated_shifts: bool,
    /// Whether the given `K_Hβ` is the least one, which grows with the face width, to `1 + 0.4·(b/d)²`.
    pub widens_face_load: bool,
    /// Whether the design that misses least is asked for where none holds.
    pub asks_nearest: bool,
    /// Limits of usual practice: designs that miss fewer of its rules come first, and those with an error are
    /// left out. `None` does not look at them.
    pub practice: Option<Limits>,
}

/// `K_Hβ` that is at least a given one and fits a face width over the diameter of the smaller gear.
pub(crate) fn widened(given: f64, width_ratio: f64) -> f64 {
    given.max((1e3 * least_face_load(width_ratio)).ceil() / 1e3)
}

impl Task {
    /// `K_Hβ` of a family at a face width in m, where the given one is the least: that of the
    /// [width](least_face_load) of the smallest external gear, rounded up to thousandths. `None` where the
    /// given factor holds for every width.
    pub(super) fn face_load(&self, layout: &Layout, family: usize, width: f64) -> Option<f64> {
        let own = |mesh: &&SizedMesh| self.gears[mesh.gears[0]].family == family;
        let mesh = self.meshes.iter().find(own).filter(|_| self.widens_face_load)?;
        let given = mesh.method.given.of(Side::First, Symbol::FaceContact)?;
        let gears = self.gears.iter().zip(layout.gears.iter()).filter(|(gear, _)| gear.family == family);
        let external = gears.filter(|(_, gear)| gear.kind() == GearKind::External);
        let smallest = external.map(|(_, gear)| gear.reference_diameter()).fold(f64::INFINITY, f64::min);
        Some(widened(given, width / (smallest * layout.modules[family].si())))
    }

    /// Dynamic viscosity of the oil in plain bearings, Pa·s.
    pub(super) fn bearing_oil(&self) -> f64 {
        viscosity(self.viscosity, self.working_viscosity)
    }

    /// Refuses quantities that are no requirement.
    pub(super) fn check(&self) -> Result<(), Error> {
        positive(Quantity::Life, self.life.hours(), "h")?;
        for required in [self.required_contact, self.required_root] {
            positive(Quantity::RequiredSafety, required, "")?;
        }
        for SizedGear { gear, .. } in &self.gears {
            within(Quantity::RootRoughness, gear.root_roughness.um(), [0.0, MOST_ROOT_ROUGHNESS], "µm")?;
            if let Some(rim) = gear.rim {
                positive(Quantity::LeastRim, rim.mm(), "mm")?;
            }
        }
        not_negative(Quantity::LeastRim, self.planet_rim, "modules")?;
        positive(Quantity::RingRimInModules, self.ring_rim, "modules")?;
        self.planets.iter().try_for_each(SizedPlanet::check_rows)?;
        for bore in self.planets.iter().filter_map(|planet| planet.bore) {
            positive(Quantity::PlanetBore, bore.mm(), "mm")?;
        }
        Ok(())
    }

    /// Refuses loads that are no duty, or no overload.
    pub(super) fn check_loads(&self, loads: &[MeshLoads]) -> Result<(), Error> {
        for of_mesh in loads {
            check_shares(of_mesh.steps.iter().map(|step| step.share))?;
            for one in &of_mesh.overloads {
                positive(Quantity::RequiredSafety, one.required_contact, "")?;
                positive(Quantity::RequiredSafety, one.required_root, "")?;
            }
        }
        let does = |step: &Step| step.share > 0.0 && step.torque.si() != 0.0 && step.speed.si() != 0.0;
        if loads.iter().any(|of_mesh| of_mesh.steps.iter().any(does)) { Ok(()) } else { Err(Error::IdleDuty) }
    }

    /// Designs of each layout: the combinations of face widths.
    pub(super) fn designs_of_layout(&self) -> u64 {
        self.face_widths.iter().map(|widths| widths.len() as u64).product()
    }

    /// Rim of a ring at a module.
    pub(super) fn ring_rim(&self, gear: usize, module: Length) -> Length {
        self.gears[gear].gear.rim.unwrap_or(module * self.ring_rim)
    }

    /// Gears of a kind of planets.
    pub(super) fn gears_of(&self, planet: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.gears.len()).filter(move |gear| self.gears[*gear].body == Body::Planet(planet))
    }
}

impl Layout {
    /// Module of a gear.
    pub(super) fn module(&self, task: &Task, gear: usize) -> Length {
        self.modules[task.gears[gear].family]
    }

    /// Outside diameter of the largest ring, or of the circle that tips of planets reach to where that is larger;
    /// `None` of a set without a ring.
    #[must_use]
    pub(super) fn ring_diameter(&self, task: &Task) -> Option<Length> {
        let rings = (0..self.gears.len()).filter(|gear| self.gears[*gear].kind() == GearKind::Internal);
        let outside = rings.map(|gear| {
            let module = self.module(task, gear);
            module * self.gears[gear].root_diameter() + 2.0 * task.ring_rim(gear, module)
        });
        let greater = |one: Length, other: Length| if one > other { one } else { other };
        Some(greater(outside.reduce(greater)?, self.swept_diameter(task)))
    }

    /// Diameter of the circle that tips of planets reach to; 0 without planets.
    pub(super) fn swept_diameter(&self, task: &Task) -> Length {
        let planets = task.gears.iter().enumerate().filter_map(|(gear, of)| match of.body {
            Body::Planet(planet) => Some((gear, self.radii[planet])),
            Body::Central => None,
        });
        let reach = |(gear, radius): (usize, Length)| {
            2.0 * radius + self.module(task, gear) * self.gears[gear].tip_diameter()
        };
        planets.map(reach).fold(Length::default(), |one, other| if one > other { one } else { other })
    }
}

/// The requirement with the least reserve of torque.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Governing {
    /// The requirement.
    pub requirement: Requirement,
    /// Mesh of the teeth; `None` for a bearing.
    pub mesh: Option<usize>,
    /// The gear; for a bearing the first of its planet.
    pub gear: usize,
    /// Safety, or the load that the bearing carries for the required life over its load.
    pub value: f64,
    /// Value that is required: the safety, or 1.
    pub required: f64,
}

impl Governing {
    /// Value over the required one: 1 and more is enough.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.value / self.required
    }

    /// Reserve of torque: 1 and more is enough.
    #[must_use]
    pub fn reserve(&self) -> f64 {
        self.requirement.reserve(self.value, self.required)
    }

    /// The requirement with the least reserve of torque; of equal ones the first.
    pub(super) fn least(all: impl IntoIterator<Item = Self>) -> Option<Self> {
        all.into_iter().reduce(|least, one| if one.reserve() < least.reserve() { one } else { least })
    }
}

/// Planets of a kind in a design.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignedPlanet {
    /// Bearing of each planet.
    pub bearing: Option<Bearing>,
    /// Bore of each planet; `None` of solid ones.
    pub bore: Option<Length>,
    /// The least rim between root circle and bore; `None` of solid ones.
    pub rim: Option<Length>,
    /// Distance of the rows of the bearing, with which it is rated; `None` where nothing tilts the planet, and
    /// where the rows are not known.
    pub span: Option<Length>,
    /// `L_10` of the bearing over the duty; `None` without a bearing, of plain ones, and where it never turns under
    /// load.
    pub life: Option<Time>,
}

/// A design of the space.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Gears, modules and radii.
    pub layout: Layout,
    /// Face width of each family.
    pub face_widths: Vec<Length>,
    /// The kinds of planets.
    pub planets: Vec<DesignedPlanet>,
    /// Rim under the teeth of each gear: of rings, and of bored planets.
    pub rims: Vec<Option<Length>>,
    /// Face width of each family over the diameter that the width ratio counts on.
    pub width_ratios: Vec<f64>,
    /// `K_Hβ` of each family where the given one is the least.
    pub face_loads: Vec<Option<f64>>,
    /// Outside diameter of the largest ring, or of the circle that tips of planets reach to where that is larger;
    /// `None` of a set without a ring.
    pub ring_diameter: Option<Length>,
    /// Mass of all gears.
    pub mass: Mass,
    /// Mass of carrier and housing, by a [rule](super::structure).
    pub structure: Mass,
    /// Length along the axis with the carrier's cheeks and covers, by the same [rule](super::length).
    pub length: Length,
    /// Ratings of the meshes over the duty; `None` of a mesh that the duty does not load.
    pub meshes: Vec<Option<[GearDuty<Worn>; 2]>>,
    /// The overload requirement that is met least; `None` where no overload loads the set.
    pub overload: Option<Governing>,
    /// Number of rules of practice that the design misses with a warning; 0 where nothing looks at them.
    pub rules_missed: u32,
    /// The requirement that is met least.
    pub governing: Governing,
}
