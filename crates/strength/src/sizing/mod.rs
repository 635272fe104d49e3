//! Size of a set of given teeth: the best design of a discrete space that is strong enough over a duty.
//!
//! # Space
//! Every combination of
//!
//! - layouts: modules, numbers of planets and centre distances, with the gears there ([`Layout`]);
//! - a face width `b` of each family of gears ([`Task::face_widths`]).
//!
//! Planets have the bearing with the largest bore that meets the requirements ([`SizedPlanet::bearings`]): no
//! other makes them lighter. Where practice counts, it is the largest of those that miss the fewest rules.
//!
//! Layouts of a simple set are those of [`Space`]: modules `m`, numbers of planets `p`, and centre distances
//! `a`, integer multiples of a step from `a_0 − r·m` to `a_0 + r·m`, where `a_0` is the [natural centre
//! distance](epicyclic_gears::involute::family::natural_centre_distance). Profile shifts are not varied: at a
//! centre distance they are the ones that the aim picks among those without faults
//! ([`Family::choose`](epicyclic_gears::involute::family::Family::choose)). Given shifts are kept; then each
//! module has the one centre distance at which they have no backlash. Layouts of other sets are handed in.
//!
//! # Requirements of a design
//!
//! - Spacing: the planets are at equal angles, `(z_s + z_r)/p` is an integer, or at given ones
//!   ([`Sizing::least_planet_angle`]).
//! - Geometry: some shifts at this centre distance have no fault by
//!   [`Limits`](epicyclic_gears::involute::set::Limits), such as undercut, thin tips, interference or planets
//!   that touch.
//! - Face width: `b ≤ (b/d_s)_max·m·z_s`, where [`Task::width_ratio`] bounds it.
//! - Ring: `D_r ≤ D_max`, where [`Task::largest_ring`] bounds it. Planets that reach beyond the ring count as well.
//! - Bearing fits: `(d_fp − D)/2 ≥` the least rim of each gear of the planet, `B ≤` the sum of their widths.
//! - Flanks, roots: `S_H`, `S_F` of both gears of each mesh over the duty
//!   ([`rate_duty`](crate::spectrum::rate_duty)).
//! - Overload: `S_H`, `S_F` of the same gears against the greatest torques of the life, static
//!   ([`overload`](crate::rating::overload)).
//! - Bearing life: `L_10` over the duty, of 90 % ([`life_over_duty`](crate::bearing::life_over_duty)).
//!
//! # Objective
//! The mass of the gears, that of gears, carrier and housing ([`structure`]), or the outside diameter `D_r`
//! of the largest ring:
//!
//! ```text
//! M   = Σ b·π/4·ρ·n·Ø²        external gear, n of it; of planets Ø² − D² in place of Ø²
//!     + Σ b·π/4·ρ·(D_r² − Ø²)        ring
//! Ø²  = (d_a² + d_f²)/2,   D_r = d_fr + 2·s_r
//! ```
//!
//! Teeth fill half of the annulus between tip and root circle. Central external gears are solid, planets are
//! bored to the bearing's outside diameter `D`, rings have the rim `s_r`. Designs of equal objective are
//! ordered by the other objective, then as their layouts are, then by face widths. Where practice counts
//! ([`Task::practice`]), designs that miss fewer of its rules come before all others. A [length] may have a
//! price ([`Task::length_price`]), which counts beside the objective.
//!
//! # Why the best design is found
//! The geometry of every layout is calculated first. With the largest bore that its planets' rims allow, a
//! bound below the objective of each design is then known before its strength is; it grows with each face
//! width. The search checks designs in ascending order of the bound against all requirements. A design that
//! holds waits, with its own objective, until no bound is lower: every design that could be better was
//! checked and failed, or is worse. [`LeftOut`] counts the designs that each requirement left out. These, the
//! designs found and those not reached add up to the space.
//!
//! Sets of a gearbox are sized one by one. Speeds and torques without losses follow from the tooth numbers
//! and the links alone: by Willis's equation, and by the balance of the torques of a planet. Module, width,
//! planets and centre distance of one set therefore do not change the load of another. Mass is a sum over the
//! sets; the largest ring is the largest of the smallest ones.
//!
//! # Bearings
//! The force on a planet's bearing follows from its meshes and the planet's mass `M_p`:
//!
//! ```text
//! F = √((K_γ·F_t)² + (K_γ·F_r + M_p·R·ω_H²)²)
//! simple set   F_1 = |T_s|·(z_s + z_p)/(p·a·z_s)         F_2 = |T_s|·(z_r − z_p)/(p·a·z_s)
//!              F_t = F_1 + F_2    F_r = F_1·tan α_w1 − F_2·tan α_w2    n = |n_s − n_H|·z_s/z_p
//! ```
//!
//! Axial forces of helical teeth, and the forces of a stepped planet's gears, which lie side by side, tilt a planet by
//! the moment `M`. Its bearing then is a pair, of whose rows one
//! bears more; the load of both as a unit takes the place of `F` ([`bearing_rows`](crate::bearing_rows)). A
//! single row is left out: it has no stated rating against a moment. The distance of the rows is the stated
//! one ([`Pin::span`]), or that of two bearings at the ends of the planet
//! ([`Bearing::span`](bearing::Bearing::span)), of rollers in its bore likewise.
//!
//! ```text
//! simple set   M = 2·K_γ·T_s/(p·d_s)·tan β·(d_w1 + d_w2)/2      d_w1, d_w2 of the planet with sun and ring
//! both rows    F⃗_1,2 = F⃗/2 ± M⃗ × z⃗/s        s = b − B      width b of the planet, B of each of two bearings
//! ```
//!
//! Left out: the mass of the bearing, weight, axial forces that stepped planets leave on their bearings, the
//! moment on a bearing of which load ratings alone are stated, and modified life, whose factor would need
//! contamination and viscosity in operation. Also left out are plain bearings and more than two bearings side
//! by side (two: [`Bearing::pair`](bearing::Bearing::pair)).

pub mod bearing;
mod gear_masses;
pub mod in_bore;
mod pin_loads;
pub(crate) mod practice;
mod rated;
mod search;
mod simple;
pub(crate) mod task;
pub(crate) mod trial;

use bearing::Bearing;
use epicyclic_gears::involute::check::{Check, Rule};
pub use practice::priced;
pub use search::search;
pub(crate) use simple::with_rest;
pub use simple::{HeldShifts, SetOverload, SetStep, SetTeeth, Sizing, size};
use std::f64::consts::FRAC_PI_4;
use std::fmt;
use std::sync::Arc;
pub use task::{
    Body, Design, DesignedPlanet, Governing, Layout, MeshLoads, Pin, PlanetStep, SizedGear, SizedMesh,
    SizedPlanet, StaticDemand, Task,
};
use uom::si::f64::Length;

/// Share of the diameter that cheeks of the carrier and covers are thick together.
const CHEEKS: f64 = 0.12;

/// Share of the diameter that the wall of the housing is thick, times 4.
const WALL: f64 = 0.16;

/// Density of carrier and housing, kg/m³.
pub(crate) const STEEL: f64 = 7850.0;

/// Mass of carrier and housing of a set in kg, by the outside diameter of its ring and its face width, in m.
///
/// ```text
/// M = ρ·π/4·D²·(0.12·D + 0.16·b)
/// ```
///
/// Cheeks and covers are discs, the housing a tube around the ring of 0.04·D wall. With it, gears are 25 to
/// 45 % of the whole, as is usual.
#[must_use]
pub fn structure(diameter: f64, face_width: f64) -> f64 {
    STEEL * FRAC_PI_4 * diameter * diameter * (CHEEKS * diameter + WALL * face_width)
}

/// Length of a set along its axis in m, with the cheeks of its carrier and its covers. Given are the outside
/// diameter of its ring and its face width, in m.
///
/// ```text
/// L = b + 0.12·D
/// ```
#[must_use]
pub fn length(diameter: f64, face_width: f64) -> f64 {
    face_width + CHEEKS * diameter
}

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
    /// The greatest outside diameter of a ring; `None` without bound.
    pub largest_ring: Option<Length>,
    /// Price of the [length], as [`Task::length_price`].
    pub length_price: f64,
    /// Bearings of the planets; empty if planets have no bearing of a table.
    pub bearings: Arc<[Bearing]>,
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
    /// The mass of gears, carrier and housing, by a rule.
    Whole,
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

    /// Reserve of torque of a value over the required one: by its square for flanks, whose stress grows with
    /// the root of the torque.
    #[must_use]
    pub fn reserve(self, value: f64, required: f64) -> f64 {
        let ratio = value / required;
        match self {
            Self::Flank | Self::OverloadFlank => ratio * ratio,
            Self::Root | Self::OverloadRoot | Self::BearingLife => ratio,
        }
    }
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
    /// Gears that usual practice refuses.
    pub practice: u64,
    /// Face widths above the bound.
    pub width_ratio: u64,
    /// Rings above the bound.
    pub ring: u64,
    /// Planets to which no bearing leaves the least rim.
    pub rim: u64,
    /// Planets narrower than any bearing that leaves the least rim.
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
            + self.practice
            + self.width_ratio
            + self.ring
            + self.rim
            + self.bearing_width
            + self.not_calculable
            + self.flank
            + self.root
            + self.overload
            + self.bearing_life
    }
}

/// Counts of layouts calculated and designs left out before the search.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Tried {
    /// Layouts whose geometry was calculated.
    pub geometries: u64,
    /// Numbers of designs left out.
    pub left_out: LeftOut,
    /// Faults of gears: designs that each rule left out, and the first miss in words.
    faults: Vec<(Rule, u64, String)>,
}

impl Tried {
    /// Leaves out designs whose gears have a fault.
    pub fn leave_out<P: fmt::Display>(&mut self, fault: &Check<P>, designs: u64) {
        if fault.rule == Rule::PlanetGap {
            self.left_out.planets_touch += designs;
            return;
        }
        self.left_out.geometry += designs;
        match self.faults.iter_mut().find(|(rule, ..)| *rule == fault.rule) {
            Some((_, count, _)) => *count += designs,
            None => self.faults.push((fault.rule, designs, fault.to_string())),
        }
    }

    /// The miss of the rule that left out most designs.
    fn usual_fault(self) -> Option<String> {
        self.faults.into_iter().max_by_key(|(_, count, _)| *count).map(|(.., miss)| miss)
    }
}

/// Result of a search for a size.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Designs of the space.
    pub space: u64,
    /// Centre distances of all modules and numbers of planets, whose geometry was calculated.
    pub geometries: u64,
    /// Meshes that were rated.
    pub rated: u64,
    /// Designs that each requirement left out.
    pub left_out: LeftOut,
    /// A miss of the rule that left out most designs for the geometry of their gears.
    pub usual_fault: Option<String>,
    /// The rule whose stated range left out most designs, and their number.
    pub stated_limit: Option<(epicyclic_judge::Rule, u64)>,
    /// Designs whose objective is not below that of the last found.
    pub not_reached: u64,
    /// The best, in order.
    pub found: Vec<Design>,
    /// The design that misses the requirements least, of those whose teeth were rated; only if no design is
    /// found.
    pub nearest_miss: Option<Design>,
}
