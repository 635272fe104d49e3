//! Angles at which the sun, the planets and the ring of a set are drawn so that they mesh.
//!
//! A tooth of the sun points along the first axis, where the first planet is. Planet `j` is at the angle
//! `θ_j`. A space of it faces the sun there, so it is turned by
//!
//! ```text
//! φ_j = θ_j·(1 + z_s/z_p) + π − π/z_p
//! ```
//!
//! The spaces of the ring take the teeth of the first planet. The ring is therefore turned by
//! `(π − π/z_p)·z_p/z_r + π/z_r`. At the assembly positions, `θ_j = 2π·p_j/(z_s + z_r)`, this fits all
//! planets.

use super::curve::ToothCurve;
use super::set::PlanetSet;
use crate::{Error, ToothCount};
use epicyclic_units::Physical;
use std::f64::consts::PI;

/// Position of a planet and its angle of rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedPlanet {
    /// Angle of its centre about the main axis, rad.
    pub angle_rad: f64,
    /// Angle of the centre line of one of its teeth, rad.
    pub turn_rad: f64,
}

impl PlanetSet {
    /// The teeth of sun, planet and ring as their tools leave them.
    ///
    /// # Errors
    /// Those of [`ToothCurve`] for gears that the tools do not cut.
    pub fn tooth_curves(&self) -> Result<[ToothCurve; 3], Error> {
        let [sun, planet, ring] = self.gears();
        Ok([ToothCurve::new(*sun)?, ToothCurve::new(*planet)?, ToothCurve::new(*ring)?])
    }

    /// The planets in mesh with a sun that has a tooth along the first axis.
    #[must_use]
    pub fn placed_planets(&self) -> Vec<PlacedPlanet> {
        let [sun, planet, _] = self.gears().map(|gear| gear.teeth().as_f64());
        let turn = |angle: f64| angle * (1.0 + sun / planet) + PI - PI / planet;
        let angles = self.spacing().angles().into_iter().map(Physical::si);
        angles.map(|angle_rad| PlacedPlanet { angle_rad, turn_rad: turn(angle_rad) }).collect()
    }

    /// Angle of the centre line of a tooth of the ring in mesh with these planets, rad.
    #[must_use]
    pub fn ring_turn_rad(&self) -> f64 {
        let [_, planet, ring] = self.gears().map(|gear| ToothCount::as_f64(gear.teeth()));
        (PI - PI / planet) * planet / ring + PI / ring
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::involute::closing::Closing;
    use crate::involute::tool::{Shaper, Tool};
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    /// Greatest depth of points of a gear's outline inside the teeth of another, as an arc.
    fn deepest(
        of: &ToothCurve,
        at: [f64; 2],
        turn: f64,
        within: &ToothCurve,
        centre: [f64; 2],
        mates_turn: f64,
    ) -> f64 {
        let outline = of.outline(1e-3).unwrap();
        let pitch = TAU / within.gear().teeth().as_f64();
        let points = outline.iter().filter_map(|[x, y]| {
            let (sin, cos) = libm::sincos(turn);
            let (x, y) = (x * cos - y * sin + at[0] - centre[0], x * sin + y * cos + at[1] - centre[1]);
            let (radius, angle) = (libm::hypot(x, y), libm::atan2(y, x) - mates_turn);
            // The other gear has no material beyond its tips.
            let is_within = within.gear().sign() * (within.tip_radius() - radius) > 0.0;
            let from_tooth = (angle - (angle / pitch).round() * pitch).abs();
            is_within.then(|| (within.half_angle(radius) - from_tooth) * radius)
        });
        points.fold(f64::NEG_INFINITY, f64::max)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]
        #[test]
        fn all_planets_mesh_without_overlap_where_they_are_placed(
            sun in 17..40_u32, planet in 17..50_u32, offset in -2..=3_i32, planets in 2..=5_u32,
        ) {
            let Some(ring) = (sun + 2 * planet).checked_add_signed(offset) else { return Ok(()) };
            let teeth = [sun, planet, ring].map(|count| ToothCount::new(count).unwrap());
            let Ok(choice) = (Closing { planets, ..Closing::default() }).close(teeth) else { return Ok(()) };
            let set = choice.set;
            // Thin enough that what only touches is clear of it.
            let curve = |gear: &crate::involute::InvoluteGear| gear.with_thickness_allowance(-1e-3).unwrap();
            let [sun, planet, ring] = set.gears().map(curve);
            let cutter = Shaper { teeth: ToothCount::new(20).unwrap(), shift: 0.0, addendum: Some(1.3), tip_radius: 0.05 };
            let Ok(ring) = ring.with_tool(Tool::Shaper(cutter)).and_then(ToothCurve::new) else { return Ok(()) };
            let [sun, planet] = [sun, planet].map(|gear| ToothCurve::new(gear).unwrap());
            // A shaper may leave less involute than the planet's tip needs.
            let reach = set.ring_mesh().mate(planet.gear().curvature_radius(2.0 * planet.tip_radius()));
            prop_assume!(reach <= ring.gear().curvature_radius(2.0 * ring.joint_radius()));
            prop_assert_eq!(set.placed_planets().len(), planets as usize);
            for placed in set.placed_planets() {
                let (sin, cos) = libm::sincos(placed.angle_rad);
                let at = [cos, sin].map(|of| of * set.centre_distance());
                let into_sun = deepest(&planet, at, placed.turn_rad, &sun, [0.0; 2], 0.0);
                let into_planet = deepest(&sun, [0.0; 2], 0.0, &planet, at, placed.turn_rad);
                let into_ring = deepest(&planet, at, placed.turn_rad, &ring, [0.0; 2], set.ring_turn_rad());
                prop_assert!(into_sun < 0.0 && into_planet < 0.0 && into_ring < 0.0, "{into_sun} {into_planet} {into_ring}");
                // And near enough to touch.
                prop_assert!(into_sun.max(into_planet) > -0.1 && into_ring > -0.1, "{into_sun} {into_planet} {into_ring}");
            }
        }
    }
}
