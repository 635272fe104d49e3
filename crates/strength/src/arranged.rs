//! Estimated mass of sets with planets of two gears, by which the most promising are sized first.
//!
//! Forces follow from the teeth alone. With a radius of the planets of 1 and a torque of 1 on the sun, of `N`
//! planets:
//!
//! ```text
//! sun             F_a = 1/(N·r_a)
//! stepped         F_b = F_a·r_g/r_f
//! Wolfrom         F_e = 2·F_a·r_g/(r_g − r_f)     F_b = F_e − F_a      by amount: the carrier is free
//! width           b ≥ F/d·(u ± 1)/u/K*            b ≥ F/(m·U)          the greatest of a family's meshes
//! ```
//!
//! `d` is the diameter of the smaller gear, `K*` and `U` what flanks and roots usually bear. All widths go with
//! the inverse square of the radius, which is the least that keeps to the usual width over diameter. Modules,
//! bearings and shifts are left out: the estimate is an order, no bound.

use crate::sizing::{STEEL, structure};
use epicyclic_gears::arrangement::{ArrangedTeeth, Arrangement};
use epicyclic_gears::quantity::SimpleGear;
use std::f64::consts::PI;

/// Usual `K*` of case-hardened external gears in N/mm²; rings are softer.
const FLANK: [f64; 2] = [6.0, 4.0];

/// Usual `F/(b·m)` in N/mm².
const ROOT: f64 = 45.0;

/// Usual greatest face width over the diameter of the smaller gear.
const PROPORTION: f64 = 1.0;

/// Radial thickness of a ring in its modules.
const RING: f64 = 5.0;

/// Estimated volume of gears, carrier and housing for a torque on the sun, up to a factor; `None` of other
/// arrangements, and of teeth that bear no torque.
///
/// ```
/// use epicyclic_gears::arrangement::{ArrangedTeeth, Arrangement};
/// use epicyclic_strength::arranged::estimated_volume;
///
/// let set = |planets| ArrangedTeeth::new(Arrangement::Stepped, &[18, 54, 27, 99], 1.into(), planets);
/// let [few, many] = [3, 5].map(|planets| set(planets).ok().as_ref().and_then(estimated_volume));
/// assert!(many < few);
/// ```
#[must_use]
pub fn estimated_volume(set: &ArrangedTeeth) -> Option<f64> {
    let arrangement = set.arrangement();
    let (gears, meshes) = (arrangement.gears(), arrangement.meshes());
    let teeth: Vec<f64> = set.teeth().iter().map(|teeth| f64::from(*teeth)).collect();
    let is_ring = |gear: usize| gears[gear].role == SimpleGear::Ring;
    // The meshes of a step are equally far from the axis, so any of them gives its module.
    let module = |step: usize| {
        let own = meshes.iter().find(|[gear, _]| gears[*gear].step == step)?;
        let [first, second] = own.map(|gear| teeth[gear]);
        Some(2.0 / if is_ring(own[1]) { second - first } else { first + second })
    };
    let modules = [module(0)?, module(1)?];
    let module = |gear: usize| modules[gears[gear].step];
    let radius = |gear: usize| module(gear) * teeth[gear] / 2.0;
    let planets = f64::from(set.planets());
    let forces = forces(arrangement, planets, radius)?;
    let mut widths = [0.0_f64; 2];
    for (mesh, force) in meshes.iter().zip(forces) {
        let [first, second] = mesh.map(|gear| teeth[gear]);
        let (sign, flank) = if is_ring(mesh[1]) { (-1.0, FLANK[1]) } else { (1.0, FLANK[0]) };
        let [small, large] = [first.min(second), first.max(second)];
        let module = module(mesh[0]);
        let by_flank = force.abs() / (module * small) * (large / small + sign) / (large / small) / flank;
        let by_root = force.abs() / (module * ROOT);
        let own = &mut widths[gears[mesh[0]].step];
        *own = own.max(by_flank).max(by_root);
    }
    // With a radius of 1; widths over diameters go with the inverse third power of the radius.
    let smallest = |step: usize| {
        let own = (0..gears.len()).filter(|gear| gears[*gear].step == step && !is_ring(*gear));
        own.map(|gear| 2.0 * radius(gear)).fold(f64::INFINITY, f64::min)
    };
    let scale = libm::cbrt(
        [0, 1].map(|step| widths[step] / (PROPORTION * smallest(step))).into_iter().fold(0.0, f64::max),
    );
    let widths = widths.map(|width| width / (scale * scale));
    let volume = |gear: usize| {
        let own = scale * radius(gear);
        let square = if is_ring(gear) { 2.0 * own * RING * scale * module(gear) } else { own * own };
        let count = if gears[gear].role == SimpleGear::Planet { planets } else { 1.0 };
        PI * count * widths[gears[gear].step] * square
    };
    let all: f64 = (0..gears.len()).map(volume).sum();
    let reach = |gear: usize| match gears[gear].role {
        SimpleGear::Ring => radius(gear) + RING * module(gear),
        SimpleGear::Planet => 1.0 + radius(gear) + module(gear),
        _ => 0.0,
    };
    let diameter = 2.0 * scale * (0..gears.len()).map(reach).fold(0.0, f64::max);
    let whole = all + structure(diameter, widths.iter().sum()) / STEEL;
    whole.is_finite().then_some(whole)
}

/// Tangential forces by amount of one planet's meshes for a torque of 1 on the sun; `None` of other arrangements.
fn forces(arrangement: Arrangement, planets: f64, radius: impl Fn(usize) -> f64) -> Option<Vec<f64>> {
    let of_sun = 1.0 / (planets * radius(0));
    match arrangement {
        Arrangement::Stepped => Some(vec![of_sun, of_sun * radius(1) / radius(2)]),
        Arrangement::Wolfrom => {
            let [first, second] = [1, 3].map(radius);
            let of_second_ring = 2.0 * of_sun * first / (first - second);
            Some(vec![of_sun, (of_second_ring - of_sun).abs(), of_second_ring.abs()])
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Radii of the gears with a radius of the planets of 1.
    fn radii(teeth: [f64; 5]) -> [f64; 5] {
        let [first, second] = [2.0 / (teeth[0] + teeth[1]), 2.0 / (teeth[4] - teeth[3])];
        [0, 1, 2, 3, 4].map(|gear| teeth[gear] / 2.0 * if gear < 3 { first } else { second })
    }

    /// Forces and moments of a planet balance, and the output has the torque of the ratio.
    #[test]
    fn forces_of_a_wolfrom_set_balance() {
        for (teeth, ratio) in
            [([34.0, 34.0, 102.0, 32.0, 100.0], 100.0), ([12.0, 48.0, 108.0, 40.0, 100.0], 100.0)]
        {
            let own = radii(teeth);
            let all = forces(Arrangement::Wolfrom, 3.0, |gear| own[gear]).unwrap();
            let &[of_sun, of_first_ring, of_second_ring] = &all[..] else { panic!("{all:?}") };
            assert!((of_sun + of_first_ring - of_second_ring).abs() < 1e-12, "{all:?}");
            let moment = (of_sun - of_first_ring) * own[1] + of_second_ring * own[3];
            assert!(moment.abs() < 1e-12, "{moment}");
            assert!((of_second_ring * 3.0 * own[4] - ratio).abs() < 1e-9, "{all:?}");
        }
    }

    #[test]
    fn arrangements_without_a_rule_have_no_estimate() {
        let pair = ArrangedTeeth::new(Arrangement::ExternalPair, &[20, 30], 1.into(), 1).unwrap();
        assert_eq!(estimated_volume(&pair), None);
        let lone = ArrangedTeeth::new(Arrangement::Wolfrom, &[34, 34, 102, 34, 102], 1.into(), 3).unwrap();
        assert_eq!(estimated_volume(&lone), None);
    }
}
