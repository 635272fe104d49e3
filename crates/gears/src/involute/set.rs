//! A simple set as two meshes on one centre distance, and what keeps its gears from running together.
//!
//! The teeth need not obey `z_r = z_s + 2·z_p`: profile shifts make up for a ring with some teeth more or
//! fewer ([`family`](super::family)). The number of assembly positions is `z_s + z_r` all the same.
//!
//! # Checks
//! [`PlanetSet::checks`] returns every check with its numbers, by the limits of [`Limits`].
//! [`PlanetSet::faults`] returns those that fail:
//!
//! | check | condition |
//! |---|---|
//! | tool | the tool cuts the gear |
//! | undercut | `x ≥ x_min` of sun and planet |
//! | tip thickness | `s_an ≥ 0.2` of each gear, case-hardened `0.4` |
//! | tips by a shaper, of a ring | `√(r_a² − r_b²) ≥ a_0·sin α_w0`; tips of shaper and ring miss each other |
//! | radial feed of the shaper | tips of shaper and ring miss each other when it is fed radially |
//! | contact ratio | `ε_α ≥ 1.1` of both meshes |
//! | tip clearance | tips of each gear from the roots of its mates, `≥ 0` |
//! | backlash | `j_wt ≥ 0` of both meshes |
//! | involute, fillet, trochoidal interference | as in [`interference`](super::interference) |
//! | radial assembly | as in [`interference`](super::interference) |
//! | planets | `2·a·sin(γ/2) − d_a > 0` |
//!
//! Roots and fillets are those that the [`tool`](super::tool) of each gear leaves. That planets do not enter
//! the ring radially is a remark, unless the limits ask for it.

use super::check::{Check, Place, Rule, SetMesh, Severity};
pub use super::checks::Limits;
use super::checks::{gear_checks, mesh_checks};
use super::gear::InvoluteGear;
use super::pair::Pair;
use crate::Error;
use crate::mesh::TipCircle;
use crate::quantity::{Counted, SimpleGear};
use crate::spacing::PlanetSpacing;

/// Sun, planets and ring with their shifts on one centre distance; lengths in modules.
///
/// ```
/// use epicyclic_gears::involute::set::{Limits, PlanetSet};
/// use epicyclic_gears::involute::{InvoluteGear, Profile};
/// use epicyclic_gears::{ToothCount, geometry::GearKind};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let gear =
///     |kind, teeth, shift| InvoluteGear::new(kind, ToothCount::new(teeth)?, Profile::default(), shift);
/// // 18 + 2·36 ≠ 93: the second stage of a wind gearbox, module 21 mm, centre distance 584 mm.
/// let gears = [
///     gear(GearKind::External, 18, 0.3890)?,
///     gear(GearKind::External, 36, 0.5038)?,
///     gear(GearKind::Internal, 93, 0.1171)?,
/// ];
/// let set = PlanetSet::new(gears, 3, 584.0 / 21.0)?.with_tip_clearance()?;
/// assert!((set.sun_mesh().transverse_contact_ratio() - 1.370).abs() < 5e-4);
/// assert!((set.ring_mesh().transverse_contact_ratio() - 1.618).abs() < 5e-4);
/// assert!(set.faults(&Limits::default()).is_empty());
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanetSet {
    sun_mesh: Pair,
    ring_mesh: Pair,
    planets: u32,
}

impl PlanetSet {
    /// Sun, planet and ring in mesh at a centre distance, with the planets at the assembly positions nearest
    /// to equal angles.
    ///
    /// # Errors
    /// Those of [`Pair::at_centre_distance`]; [`Error::TooFew`] for no planets.
    pub fn new(gears: [InvoluteGear; 3], planets: u32, centre_distance: f64) -> Result<Self, Error> {
        if planets == 0 {
            return Err(Error::TooFew { what: Counted::Planets, count: 0, at_least: 1 });
        }
        let [sun, planet, ring] = gears;
        Ok(Self {
            sun_mesh: Pair::at_centre_distance(sun, planet, centre_distance)?,
            ring_mesh: Pair::at_centre_distance(planet, ring, centre_distance)?,
            planets,
        })
    }

    /// Set whose sun and planet tips keep the clearance of the basic rack in their mesh. The tips of the ring
    /// are not altered: towards the ring the clearance is as large or larger.
    ///
    /// ```text
    /// k_s = k_p = a − a_d − (x_s + x_p),    k_r = 0
    /// ```
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where teeth vanish.
    pub fn with_tip_clearance(self) -> Result<Self, Error> {
        let alteration = self.sun_mesh.tip_alteration();
        self.with_tip_alterations([alteration, alteration, 0.0])
    }

    /// Set with other tips of sun, planets and ring.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where teeth become pointed or vanish.
    pub fn with_tip_alterations(self, [sun, planet, ring]: [f64; 3]) -> Result<Self, Error> {
        let gears = self.gears();
        let planet = gears[1].with_tip_alteration(planet)?;
        Ok(Self {
            sun_mesh: self.sun_mesh.with_gears([gears[0].with_tip_alteration(sun)?, planet]),
            ring_mesh: self.ring_mesh.with_gears([planet, gears[2].with_tip_alteration(ring)?]),
            planets: self.planets,
        })
    }

    /// The mesh of sun and planet, the sun first.
    #[must_use]
    pub const fn sun_mesh(&self) -> &Pair {
        &self.sun_mesh
    }

    /// The mesh of planet and ring, the planet first.
    #[must_use]
    pub const fn ring_mesh(&self) -> &Pair {
        &self.ring_mesh
    }

    /// Sun, planet, ring.
    #[must_use]
    pub const fn gears(&self) -> [&InvoluteGear; 3] {
        let [sun, planet] = self.sun_mesh.gears();
        [sun, planet, &self.ring_mesh.gears()[1]]
    }

    /// Number of planets.
    #[must_use]
    pub const fn planets(&self) -> u32 {
        self.planets
    }

    /// Centre distance `a`.
    #[must_use]
    pub fn centre_distance(&self) -> f64 {
        self.sun_mesh.centre_distance()
    }

    /// Spacing of the planets.
    #[must_use]
    pub fn spacing(&self) -> PlanetSpacing {
        let [sun, _, ring] = self.gears();
        PlanetSpacing::least_unequal(sun.teeth(), ring.teeth(), self.planets)
    }

    /// A planet as its neighbours see it.
    #[must_use]
    pub fn planet_circle(&self) -> TipCircle {
        let [_, planet, _] = self.gears();
        TipCircle { centre_radius: self.centre_distance(), tip_radius: planet.tip_diameter() / 2.0 }
    }

    /// Gap between the tip circles of the two planets nearest to each other; infinite for one planet.
    #[must_use]
    pub fn planet_gap(&self) -> f64 {
        if self.planets == 1 {
            return f64::INFINITY;
        }
        self.planet_circle().gap_to_alike(self.spacing().half_gap_sine())
    }

    /// Set whose ring has tips short enough to stay out of the fillets of the planets, and within what its
    /// shaper leaves. The contact ratio does not change. With fillets by a rack of `h_FfP* = h_aP*` the tips
    /// of a ring without shift always reach 0.05 to 0.15 modules into them.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where teeth vanish.
    pub fn with_clear_ring_tips(self) -> Result<Self, Error> {
        Ok(Self { ring_mesh: self.ring_mesh.with_clear_ring_tips()?, ..self })
    }

    /// Faults that keep the gears from being cut, assembled or turned: the failed [checks](Self::checks),
    /// without remarks.
    #[must_use]
    pub fn faults(&self, limits: &Limits) -> Vec<Check> {
        let mut faults = Vec::new();
        self.each_check(limits, |check| {
            let counts = check.rule.severity() > Severity::Remark || limits.radial_assembly;
            if counts && !check.holds() {
                faults.push(check);
            }
        });
        faults
    }

    /// Checks of the teeth of the set, in the order of the module's table.
    #[must_use]
    pub fn checks(&self, limits: &Limits) -> Vec<Check> {
        let mut checks = Vec::new();
        self.each_check(limits, |check| checks.push(check));
        checks
    }

    fn each_check(&self, limits: &Limits, mut see: impl FnMut(Check)) {
        let [sun, planet, ring] = self.gears();
        let named = [(SimpleGear::Sun, sun), (SimpleGear::Planet, planet), (SimpleGear::Ring, ring)];
        for (gear, of) in named {
            gear_checks(&Place::Gear(gear), of, limits, &mut see);
        }
        for (mesh, pair, gears) in [
            (SetMesh::SunPlanet, &self.sun_mesh, [SimpleGear::Sun, SimpleGear::Planet]),
            (SetMesh::PlanetRing, &self.ring_mesh, [SimpleGear::Planet, SimpleGear::Ring]),
        ] {
            let tips = gears.map(|gear| Place::Tips(gear, mesh));
            mesh_checks(&Place::Mesh(mesh), &tips, pair, limits, &mut see);
        }
        if self.planets > 1 {
            let place = Place::Planets(self.planets);
            see(Check { rule: Rule::PlanetGap, place, value: self.planet_gap(), limit: limits.planet_gap });
        }
    }
}
