//! Size of a simple set of given teeth: the best design of a discrete space that is strong enough over a
//! duty.
//!
//! # Space
//! Every combination of
//!
//! - modules `m`: [`Space::modules`];
//! - face widths `b`: [`Space::face_widths`];
//! - numbers of planets `p`: [`Space::planets`];
//! - centre distances `a`, integer multiples of a step from `a_0 − r·m` to `a_0 + r·m`:
//!   [`Space::centre_distance_step`], [`Space::reach`];
//! - planet bearings `D`, `B`, `C`, or none: [`Space::bearings`].
//!
//! `a_0` is the [natural centre distance](epicyclic_gears::involute::family::natural_centre_distance).
//! Profile shifts are not varied: at a centre distance they are the ones that the aim picks among those
//! without faults ([`Family::choose`]). Given shifts are kept; then each module has the one centre distance
//! at which they have no backlash.
//!
//! # Requirements of a design
//!
//! - Spacing: the planets are at equal angles, `(z_s + z_r)/p` is an integer, or at given ones
//!   ([`Sizing::least_planet_angle`]).
//! - Geometry: some shifts at this centre distance have no fault by [`Limits`], such as undercut, thin tips,
//!   interference or planets that touch.
//! - Face width: `b ≤ (b/d_s)_max·m·z_s`, where [`Space::width_ratio`] bounds it.
//! - Bearing fits: `(d_fp − D)/2 ≥` the least rim of the planets, `B ≤ b`.
//! - Flanks, roots: `S_H`, `S_F` of both gears of both meshes over the duty ([`rate_duty`]).
//! - Overload: `S_H`, `S_F` of the same gears against the greatest torques of the life, static
//!   ([`overload`]).
//! - Bearing life: `L_10` over the duty, of 90 % ([`life_over_duty`]).
//!
//! # Objective
//! The mass of the gears or the ring's outside diameter `D_r`:
//!
//! ```text
//! M   = b·π/4·(ρ_s·Ø_s² + p·ρ_p·(Ø_p² − D²) + ρ_r·(D_r² − Ø_r²))
//! Ø²  = (d_a² + d_f²)/2,   D_r = d_fr + 2·s_r
//! ```
//!
//! Teeth fill half of the annulus between tip and root circle. The sun is solid, the planets are bored to the
//! bearing's outside diameter `D`, the ring has the rim `s_r`. Designs of equal objective are ordered by the
//! other objective. After that come fewer planets, smaller module, face width and centre distance, and the
//! bearing that is first in the table.
//!
//! # Why the best design is found
//! The geometry of every centre distance is calculated first. The objective of every design is then known
//! before its strength is. The search checks designs in ascending order of the objective against all
//! requirements and ends at the first that meets them: every design of a smaller objective was checked and
//! failed. [`LeftOut`] counts the designs that each requirement left out. These, the designs found and those
//! not reached add up to the space.
//!
//! Sets of a gearbox are sized one by one. Speeds and torques without losses follow from the tooth numbers
//! and the links alone: by Willis's equation, and by the balance `T_s/z_s = T_r/z_r` of a planet. Module,
//! width, planets and centre distance of one set therefore do not change the load of another. Mass is a sum
//! over the sets; the largest ring is the largest of the smallest ones.
//!
//! # Bearings
//! The force on a planet's bearing follows from both meshes and the planet's mass `M_p`:
//!
//! ```text
//! F_1 = |T_s|·(z_s + z_p)/(p·a·z_s)         F_2 = |T_s|·(z_r − z_p)/(p·a·z_s)
//! F = √((K_γ·(F_1 + F_2))² + (K_γ·(F_1·tan α_w1 − F_2·tan α_w2) + M_p·a·ω_H²)²)
//! n = |n_s − n_H|·z_s/z_p
//! ```
//!
//! Left out: the mass of the bearing, weight, and modified life, whose factor would need contamination and
//! viscosity in operation. Also left out are plain bearings and more than two bearings side by side (two:
//! [`Bearing::pair`](bearing::Bearing::pair)).

pub mod bearing;
mod geometry;
mod search;

use crate::mesh::{Gear, Method};
use crate::spectrum::{GearDuty, Worn};
#[cfg(doc)]
use crate::{bearing::life_over_duty, rating::overload, spectrum::rate_duty};
use bearing::Bearing;
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::PlanetSet;
use epicyclic_gears::involute::check::Check;
use epicyclic_gears::involute::family::Aim;
#[cfg(doc)]
use epicyclic_gears::involute::family::Family;
use epicyclic_gears::involute::profile::Profiles;
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::quantity::SimpleGear;
pub use search::size;
use uom::si::f64::{Angle, AngularVelocity, KinematicViscosity, Length, Mass, Time, Torque};

/// The discrete space.
#[derive(Debug, Clone, PartialEq)]
pub struct Space {
    /// Modules.
    pub modules: Vec<Length>,
    /// Face widths.
    pub face_widths: Vec<Length>,
    /// Numbers of planets.
    pub planets: Vec<u32>,
    /// Step of the centre distances.
    pub centre_distance_step: Length,
    /// Largest distance of a centre distance from the natural one, in modules.
    pub reach: f64,
    /// The greatest face width over the sun's reference diameter; `None` without bound.
    pub width_ratio: Option<f64>,
    /// Bearings of the planets; empty if planets have no bearing of a table.
    pub bearings: Vec<Bearing>,
}

/// Modules of series I of ISO 54 from 1 to 50 mm, in mm.
pub const STANDARD_MODULES_MM: [f64; 18] =
    [1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0];

/// Objective that is minimized.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema, clap::ValueEnum))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Minimise"))]
pub enum Objective {
    /// The mass of all gears.
    #[default]
    Mass,
    /// The outside diameter of each ring.
    Ring,
}

/// A step of the duty as the set feels it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetStep {
    /// Share of the time.
    pub share: f64,
    /// Torque on the sun, without losses; its sign does not matter.
    pub sun_torque: Torque,
    /// Speed of the sun relative to the carrier; its sign does not matter.
    pub sun_speed: AngularVelocity,
    /// Speed of the carrier.
    pub carrier_speed: AngularVelocity,
}

/// The greatest torque of the life, and what is required against it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetOverload {
    /// Torque on the sun, without losses; its sign does not matter. A torque of 0 sets no requirement.
    pub sun_torque: Torque,
    /// Required static safety of the flanks.
    pub required_contact: f64,
    /// Required static safety of the roots.
    pub required_root: f64,
}

/// Shifts and tip alterations of sun, planets and ring that are held, in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeldShifts {
    /// Profile shift coefficients.
    pub profile: [f64; 3],
    /// Tip alterations; where none are given the tips of the ring are shortened to stay out of the fillets of
    /// the planets.
    pub tips: Option<[f64; 3]>,
}

/// A set to size.
#[derive(Debug, Clone, PartialEq)]
pub struct Sizing {
    /// Teeth of sun, planets and ring.
    pub teeth: [ToothCount; 3],
    /// Basic racks and tools of sun, planets and ring.
    pub profiles: Profiles,
    /// Aim that picks the shifts.
    pub aim: Aim,
    /// Shifts that are kept in place of an aim.
    pub held_shifts: Option<HeldShifts>,
    /// Limits for the checks of the geometry.
    pub limits: Limits,
    /// Sun, planets and ring. Rims of planets and ring are those of the design.
    pub gears: [Gear; 3],
    /// Methods for both meshes; `K_γ` by the number of planets where it is not given.
    pub methods: [Method; 2],
    /// Viscosity of the oil at 40 °C.
    pub viscosity: KinematicViscosity,
    /// The duty.
    pub duty: Vec<SetStep>,
    /// The overloads.
    pub overloads: Vec<SetOverload>,
    /// Required life of teeth and bearings.
    pub life: Time,
    /// Required safety of the flanks.
    pub required_contact: f64,
    /// Required safety of the roots.
    pub required_root: f64,
    /// Least rim of the planets between root circle and bore, in modules.
    pub planet_rim: f64,
    /// Least rim of the planets that is given besides.
    pub least_planet_rim: Option<Length>,
    /// Rim of the ring outside its root circle, in modules.
    pub ring_rim: f64,
    /// Rim of the ring that is given in its place.
    pub held_ring_rim: Option<Length>,
    /// Bore of the planets if no bearing is selected.
    pub planet_bore: Option<Length>,
    /// The least angle between neighbouring planets at given angles; `None` if they must be at equal angles.
    pub least_planet_angle: Option<Angle>,
    /// Objective that is minimized.
    pub objective: Objective,
    /// The space.
    pub space: Space,
}

/// A requirement that is a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Requirement"))]
pub enum Requirement {
    /// Safety of a flank.
    Flank,
    /// Safety of a root.
    Root,
    /// Static safety of a flank against an overload.
    OverloadFlank,
    /// Static safety of a root against an overload.
    OverloadRoot,
    /// Life of the planet bearings.
    BearingLife,
}

impl Requirement {
    /// Whether the requirement concerns an overload.
    #[must_use]
    pub const fn is_against_overload(self) -> bool {
        matches!(self, Self::OverloadFlank | Self::OverloadRoot)
    }
}

/// The requirement that is met least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Governing {
    /// The requirement.
    pub requirement: Requirement,
    /// Mesh of the teeth: 0 for sun and planets, 1 for planets and ring.
    pub mesh: usize,
    /// The gear.
    pub gear: SimpleGear,
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

    const fn of_teeth(requirement: Requirement, mesh: usize, side: usize, value: f64, required: f64) -> Self {
        // Sun and planet are sides 0 and 1 of mesh 0, planet and ring those of mesh 1, so the sum is the
        // gear.
        let gear = [SimpleGear::Sun, SimpleGear::Planet, SimpleGear::Ring][mesh + side];
        Self { requirement, mesh, gear, value, required }
    }
}

/// A design of the space.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Module.
    pub module: Length,
    /// Face width.
    pub face_width: Length,
    /// Centre distance.
    pub centre_distance: Length,
    /// Gears with their shifts, in modules.
    pub set: PlanetSet,
    /// Check that keeps the aim from being met in full; `None` where it is met or shifts are given.
    pub limited_by: Option<Check>,
    /// Bearing of the planets.
    pub bearing: Option<Bearing>,
    /// Bore of the planets; `None` of solid ones.
    pub planet_bore: Option<Length>,
    /// Rim between the root circle of the planets and their bore; `None` of solid ones.
    pub planet_rim: Option<Length>,
    /// Rim of the ring outside its root circle.
    pub ring_rim: Length,
    /// Outside diameter of the ring.
    pub ring_diameter: Length,
    /// Mass of all gears.
    pub mass: Mass,
    /// Ratings of both meshes over the duty.
    pub meshes: [[GearDuty<Worn>; 2]; 2],
    /// The overload requirement that is met least; `None` where no overload loads the set.
    pub overload: Option<Governing>,
    /// `L_10` of the planet bearings over the duty; `None` without a bearing, and where it never turns under
    /// load.
    pub bearing_life: Option<Time>,
    /// The requirement that is met least.
    pub governing: Governing,
}

/// Numbers of designs that each requirement left out. A design that fails several of the last four counts
/// with the one it meets least.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LeftOut {
    /// Planets that are not at equal angles.
    pub spacing: u64,
    /// Planets that touch whatever the shifts.
    pub planets_touch: u64,
    /// Centre distances without shifts that have no fault.
    pub geometry: u64,
    /// Face widths above the bound.
    pub width_ratio: u64,
    /// Bearings that leave less than the least rim.
    pub rim: u64,
    /// Bearings wider than the planet.
    pub bearing_width: u64,
    /// Teeth outside what the standard holds for.
    pub not_calculable: u64,
    /// Flanks below the required safety.
    pub flank: u64,
    /// Roots below the required safety.
    pub root: u64,
    /// Flanks and roots below the safety required against an overload.
    pub overload: u64,
    /// Bearings below the required life.
    pub bearing_life: u64,
}

impl LeftOut {
    /// Designs left out by all requirements together.
    #[must_use]
    pub const fn total(&self) -> u64 {
        self.spacing
            + self.planets_touch
            + self.geometry
            + self.width_ratio
            + self.rim
            + self.bearing_width
            + self.not_calculable
            + self.flank
            + self.root
            + self.overload
            + self.bearing_life
    }
}

/// Result of a search for a size.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Designs of the space.
    pub space: u64,
    /// Centre distances of all modules and numbers of planets, whose geometry was calculated.
    pub geometries: u64,
    /// Designs whose teeth were checked against the requirements.
    pub rated: u64,
    /// Designs that each requirement left out.
    pub left_out: LeftOut,
    /// Designs whose objective is not below that of the last found.
    pub not_reached: u64,
    /// The best, in order.
    pub found: Vec<Design>,
    /// The design that misses the requirements least, of those whose teeth were rated; only if no design is
    /// found.
    pub nearest_miss: Option<Design>,
}
