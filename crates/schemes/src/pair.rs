//! Two sets between four links, as numbers: ratios, speeds, sun torques and losses of both gears.
//!
//! Set `j` has coefficients `c_j = (1, k_j, −(1 + k_j))` at the roles of its sun, ring and carrier and 0 at
//! the role it lacks. The minors are `[xy] = c₁x·c₂y − c₁y·c₂x`. In gear 1 T₁ is at rest and `X` = T₂; in
//! gear 2 T₂ is at rest and `X` = T₁. By Cramer's rule
//!
//! ```text
//! i = −[BX]/[DX]      ω_B = 1/i      ω_X = [DB]/[BX]      T_a1 = c₂X/[DX]      T_a2 = −c₁X/[DX]
//! ```
//!
//! with speeds and torques as multiples of the input's. The minors are linear in each `k`, so both ratios are
//! quotients of bilinear functions.
//!
//! # Losses
//! Torques with losses are those of sets with `k̂ = k·η₀^x`, `x` the sign of the set's rolling power, so
//! `η = î/i`, which is Kreines' rule. The sign is that of the ideal power in every two-set structure:
//!
//! - A set alone, or two sets in series: power runs from D to B.
//! - Connected to B: D belongs to set 1 alone. Its torque gives all torques of set 1, and through T₁ those of
//!   set 2, with signs that do not depend on the size of `k̂`.
//! - Connected to D: the same from the torque on B, whose sign is that of power leaving.
//!
//! `x` is constant where `i` keeps its sign, because it is the sign of `∂ln|i|/∂ln k`. Connected to B,
//! `i₂ = i₁ + (1 − i₁)·i_c`; connected to D the reciprocals obey the same equation. Therefore `∂i₂/∂k₁` is
//! `(1 − i_c)·i₁′` and `∂i₂/∂k₂` is `(1 − i₁)·i_c′`. No factor of these vanishes for finite `k`. It follows
//! that **each ratio is monotonous in each `k`** between its zeros and poles, always in the same direction.

use crate::structures::{Role, SetRoles};
use crate::tolerance::IDLE;

/// Coefficients of a set by role.
pub type Coefficients = [f64; 4];

/// Coefficients of a set in the equation of its speeds.
#[must_use]
pub fn coefficients(set: SetRoles, k: f64) -> Coefficients {
    let mut found = [0.0; 4];
    for (role, value) in set.into_iter().zip([1.0, k, -(1.0 + k)]) {
        found[role.index()] = value;
    }
    found
}

const D: usize = Role::D.index();
const B: usize = Role::B.index();
/// `X` of gears 1 and 2: the braked link that turns.
const FREE: [usize; 2] = [Role::T2.index(), Role::T1.index()];

/// `[xy]`, of the links in places `x` and `y`.
#[inline]
#[must_use]
pub fn minor(first: &Coefficients, second: &Coefficients, x: usize, y: usize) -> f64 {
    first[x] * second[y] - first[y] * second[x]
}

/// `[−[BX], [DX]]` of a gear, whose quotient is its ratio.
#[inline]
#[must_use]
pub fn fraction(first: &Coefficients, second: &Coefficients, gear: usize) -> [f64; 2] {
    let x = FREE[gear];
    [-minor(first, second, B, x), minor(first, second, D, x)]
}

/// Ratios of both gears.
#[inline]
#[must_use]
pub fn ratios(first: &Coefficients, second: &Coefficients) -> [f64; 2] {
    [0, 1].map(|gear| {
        let [n, d] = fraction(first, second, gear);
        n / d
    })
}

/// Speeds of the links in a gear.
#[inline]
#[must_use]
pub fn speeds(first: &Coefficients, second: &Coefficients, gear: usize) -> [f64; 4] {
    let x = FREE[gear];
    let over_b = 1.0 / minor(first, second, B, x);
    let mut found = [1.0, -minor(first, second, D, x) * over_b, 0.0, 0.0];
    found[x] = minor(first, second, D, B) * over_b;
    found
}

/// Torques on both suns in a gear.
#[inline]
#[must_use]
pub fn sun_torques(first: &Coefficients, second: &Coefficients, gear: usize) -> [f64; 2] {
    let x = FREE[gear];
    let over_d = 1.0 / minor(first, second, D, x);
    [second[x] * over_d, -first[x] * over_d]
}

/// `x_j` of both sets in a gear: 1 where the set's rolling power runs from sun to ring, −1 the other
/// way, 0 where the set is idle.
#[must_use]
pub fn exponents(sets: [SetRoles; 2], k: [f64; 2], gear: usize) -> [i8; 2] {
    let [first, second] = [0, 1].map(|set| coefficients(sets[set], k[set]));
    let speeds = speeds(&first, &second, gear);
    let torques = sun_torques(&first, &second, gear);
    [0, 1].map(|set| {
        let [a, _, h] = sets[set].map(|role| speeds[role.index()]);
        let power = torques[set] * (a - h);
        // An idle set has no torque at all; one at work has a share of the power that does not vanish.
        if power.abs() <= IDLE { 0 } else { power.signum() as i8 }
    })
}

/// `k·η₀^x`.
#[inline]
#[must_use]
pub fn effective(k: f64, eta0: f64, exponent: i8) -> f64 {
    match exponent {
        1 => k * eta0,
        -1 => k / eta0,
        _ => k,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::direct_drive::DIRECT_CLUTCH_PAIRS;
    use crate::structures::Structure;
    use epicyclic_gears::efficiency::MeshEfficiency;
    use proptest::prelude::*;
    use proptest::test_runner::TestRunner;
    use std::cell::Cell;

    /// Efficiency of a gear.
    fn efficiency(structure: Structure, k: [f64; 2], eta0: f64, gear: usize) -> f64 {
        let sets = structure.sets();
        let exponents = exponents(sets, k, gear);
        let at = |k: [f64; 2]| {
            let [n, d] = fraction(&coefficients(sets[0], k[0]), &coefficients(sets[1], k[1]), gear);
            n / d
        };
        at([0, 1].map(|set| effective(k[set], eta0, exponents[set]))) / at(k)
    }

    /// A gear whose ratio is beyond 1/100 to 100, or that is not driven, has no figures to compare: counted,
    /// and few.
    #[test]
    fn every_structure_equals_the_solver() {
        let (compared, skipped) = (Cell::new(0_u32), Cell::new(0_u32));
        let count = |counter: &Cell<u32>| counter.set(counter.get() + 1);
        let strategy = (1.05..12.0, 1.05..12.0, 0.85..=1.0);
        let compare = |(a, b, eta): (f64, f64, f64)| {
            for structure in Structure::all() {
                let sets = structure.sets();
                let (first, second) = (coefficients(sets[0], a), coefficients(sets[1], b));
                let eta0 = MeshEfficiency::new(eta).unwrap();
                let gearbox = structure.gearbox([a, b], eta0, DIRECT_CLUTCH_PAIRS[0]).unwrap();
                for (gear, name) in ["1", "2"].into_iter().enumerate() {
                    let found = gearbox.analyze(name).unwrap();
                    let Some(ratio) = found.ratio().filter(|i| i.abs() > 1e-2 && i.abs() < 1e2) else {
                        count(&skipped);
                        continue;
                    };
                    let ours = ratios(&first, &second)[gear];
                    prop_assert!((ours / ratio - 1.0).abs() < 1e-9, "{structure} {name} {ours} {ratio}");
                    for (role, speed) in Role::ALL.into_iter().zip(speeds(&first, &second, gear)) {
                        let exact = found.speed(gearbox.link(role.symbol()).unwrap()).unwrap();
                        prop_assert!(
                            (speed - exact).abs() < 1e-9 * (1.0 + exact.abs()),
                            "{structure} {role}"
                        );
                    }
                    let Some(driving) = found.driving() else {
                        count(&skipped);
                        continue;
                    };
                    let ours = efficiency(structure, [a, b], eta, gear);
                    prop_assert!(
                        (ours - driving.efficiency).abs() < 1e-8,
                        "{structure} {name} {ours} {driving:?}"
                    );
                    let hats: [f64; 2] =
                        [0, 1].map(|set| effective([a, b][set], eta, exponents(sets, [a, b], gear)[set]));
                    let torques =
                        sun_torques(&coefficients(sets[0], hats[0]), &coefficients(sets[1], hats[1]), gear);
                    for (set, torque) in torques.into_iter().enumerate() {
                        let exact = driving.members[set].as_ref().unwrap()[0];
                        prop_assert!(
                            (torque - exact).abs() < 1e-8 * (1.0 + exact.abs()),
                            "{structure} {name} {set}"
                        );
                    }
                    count(&compared);
                }
            }
            Ok(())
        };
        TestRunner::new(ProptestConfig::with_cases(64)).run(&strategy, compare).unwrap();
        let (compared, skipped) = (compared.get(), skipped.get());
        assert!(skipped * 20 < compared, "{compared} compared, {skipped} skipped");
    }
}
