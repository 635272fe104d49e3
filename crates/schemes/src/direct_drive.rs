//! Direct drive of a two-set structure: the torque of the direct-drive clutch, for every pair of links.
//!
//! Joining any two of the four links stops all relative motion. The torque of the clutch then follows from
//! statics. Sets give torques `s·(1, k, −(1 + k))` on sun, ring, carrier, and every link is in balance with 1
//! entering at D and 1 leaving at B:
//!
//! ```text
//! s₁·c₁ + s₂·c₂ = e_D − e_B + t·(e_x − e_y)        c_j the set's coefficients by role, clutch between x, y
//! ```
//!
//! Every motion of the links is a block rotation and a multiple of one other motion `u`
//! ([`structures`](crate::structures)). The principle of virtual work therefore gives
//!
//! ```text
//! t = −(u_D − u_B)/(u_x − u_y)
//! ```
//!
//! The torque, too, follows from the two ratios, whatever the structure. Losses have no effect, since there
//! is no relative motion. A clutch between a pair with `u_x = u_y` does not give direct drive.
//!
//! # Source
//! multispeed-gearboxes, section 3.1: the smallest "blocking moment" among the options for the direct-drive
//! clutch.

use crate::structures::{Role, motion};
use crate::tolerance::TORQUE_GRID;

/// The six pairs of links that a clutch may join.
pub const DIRECT_CLUTCH_PAIRS: [[Role; 2]; 6] = [
    [Role::D, Role::B],
    [Role::D, Role::T1],
    [Role::D, Role::T2],
    [Role::B, Role::T1],
    [Role::B, Role::T2],
    [Role::T1, Role::T2],
];

/// One option for the direct-drive clutch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DirectClutch {
    /// The links joined.
    pub pair: [Role; 2],
    /// Torque of the clutch over the input torque, on the first link.
    pub torque: f64,
    /// Slip of the open clutch, first link less second, in gears 1 and 2; multiples of the input speed.
    pub slip: [f64; 2],
}

/// Every option for the direct-drive clutch of a structure whose gears have these ratios, the least torque
/// first; of equal torques the order of [`DIRECT_CLUTCH_PAIRS`] holds.
#[must_use]
pub fn direct_clutch_options(ratios: [f64; 2]) -> Vec<DirectClutch> {
    let u = motion(ratios);
    let speeds = link_speeds(ratios);
    ascending(DIRECT_CLUTCH_PAIRS.into_iter().map(|pair| {
        let [x, y] = pair.map(Role::index);
        let torque = -(u[0] - u[1]) / (u[x] - u[y]);
        DirectClutch { pair, torque, slip: speeds.map(|speed| speed[x] - speed[y]) }
    }))
}

/// Every option for the direct-drive clutch of a single set whose braked gear has this ratio, as
/// [`direct_clutch_options`]; there is no gear 2, and the slip in it is 0.
#[must_use]
pub fn direct_clutch_options_of_set(ratio: f64) -> Vec<DirectClutch> {
    let speed = [1.0, 1.0 / ratio, 0.0, 0.0];
    let option = |pair: [Role; 2]| {
        let [x, y] = pair.map(Role::index);
        DirectClutch {
            pair,
            torque: -(speed[0] - speed[1]) / (speed[x] - speed[y]),
            slip: [speed[x] - speed[y], 0.0],
        }
    };
    ascending(
        [DIRECT_CLUTCH_PAIRS[0], DIRECT_CLUTCH_PAIRS[1], DIRECT_CLUTCH_PAIRS[3]].into_iter().map(option),
    )
}

fn ascending(options: impl Iterator<Item = DirectClutch>) -> Vec<DirectClutch> {
    let mut found: Vec<DirectClutch> = options.filter(|option| option.torque.is_finite()).collect();
    // Rounding is no reason to prefer an option.
    let size = |option: &DirectClutch| (option.torque.abs() / TORQUE_GRID).round();
    found.sort_by(|one, other| size(one).total_cmp(&size(other)));
    found
}

/// Speeds of D, B, T₁, T₂ in gears 1 and 2 as multiples of the input's.
#[must_use]
pub fn link_speeds([first, second]: [f64; 2]) -> [[f64; 4]; 2] {
    [
        [1.0, 1.0 / first, 0.0, (first - second) / (first * (1.0 - second))],
        [1.0, 1.0 / second, (second - first) / (second * (1.0 - first)), 0.0],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structures::Structure;
    use epicyclic_gears::efficiency::MeshEfficiency;
    use proptest::prelude::*;
    use proptest::test_runner::TestRunner;
    use std::cell::Cell;

    /// Skipped and counted: gears without a ratio or near direct drive, and clutches that carry more than a
    /// hundredfold; what is left must be most.
    #[test]
    fn torque_and_slip_of_every_clutch_equal_the_solver() {
        let [compared, skipped, loaded] = [(); 3].map(|()| Cell::new(0_u32));
        let count = |counter: &Cell<u32>| counter.set(counter.get() + 1);
        let compare = |(a, b): (f64, f64)| {
            for structure in Structure::all() {
                let gearbox =
                    structure.gearbox([a, b], MeshEfficiency::IDEAL, DIRECT_CLUTCH_PAIRS[0]).unwrap();
                let ratio = |gear| gearbox.analyze(gear).unwrap().ratio();
                let ratios = ratio("1").zip(ratio("2")).filter(|(first, second)| {
                    [first, second]
                        .iter()
                        .all(|i| (**i - 1.0).abs() >= 1e-2 && (1e-2..=1e2).contains(&i.abs()))
                });
                let Some((first, second)) = ratios else {
                    count(&skipped);
                    continue;
                };
                for clutch in direct_clutch_options([first, second]) {
                    if clutch.torque.abs() >= 100.0 {
                        count(&loaded);
                        continue;
                    }
                    let gearbox = structure.gearbox([a, b], MeshEfficiency::IDEAL, clutch.pair).unwrap();
                    let direct = gearbox.analyze("direct").unwrap();
                    prop_assert!((direct.ratio().unwrap() - 1.0).abs() < 1e-9);
                    let torque = direct.ideal().unwrap().shift_elements[2].unwrap();
                    prop_assert!((torque - clutch.torque).abs() < 1e-6, "{structure} {clutch:?} {torque}");
                    for (gear, slip) in ["1", "2"].into_iter().zip(clutch.slip) {
                        let found = gearbox.analyze(gear).unwrap().slips()[2].unwrap();
                        prop_assert!((found - slip).abs() < 1e-6, "{structure} {clutch:?} {found}");
                    }
                    count(&compared);
                }
            }
            Ok(())
        };
        TestRunner::new(ProptestConfig::with_cases(32)).run(&(1.1..10.0, 1.1..10.0), compare).unwrap();
        let (compared, skipped, loaded) = (compared.get(), skipped.get(), loaded.get());
        assert!(skipped * 5 * 10 < compared, "{compared} compared, {skipped} structures skipped");
        assert!(loaded * 20 < compared, "{compared} compared, {loaded} clutches of more than 100 skipped");
    }
}
