//! Profile shifts of gears that mesh in a tree, at stated centre distances, and the choice among them by an
//! aim.
//!
//! Each mesh fixes the sum of the shifts of its two gears ([`Pair::shift_sum`]). `n` gears in a tree have
//! `n − 1` meshes, so one shift is free. All shifts follow from that of the first gear:
//!
//! ```text
//! x_i = c_i + s_i·x_1        s_i = 1 or −1, of neighbours opposite
//! ```
//!
//! A pair is a tree of two gears. A simple set is one of three ([`family`](super::family)).
//!
//! # Tips
//! Tips of external gears are shortened by `k = a − a_d − (x_1 + x_2)` of their external meshes, where that
//! is below 0, for the clearance of the basic rack. Tips that would reach into the fillet of a mate are
//! shortened further, to where the involute of the mate ends. Lengths are in modules.

use super::check::{Check, Severity};
use super::checks::{Limits, gear_checks, mesh_checks};
use super::family::{Aim, PARTS, nearest, rising_to_zero, sliding_imbalance};
use super::gear::InvoluteGear;
use super::pair::Pair;
use super::shifts::{StatedDistance, Unclosed, closing_shifts};
use crate::Error;
use crate::gear_kind::GearKind;
use std::ops::RangeInclusive;

/// Object of a check of gears in mesh: indices of gears and meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// A gear.
    Gear(usize),
    /// A mesh.
    Mesh(usize),
    /// The tips of a gear in a mesh.
    Tips(usize, usize),
}

/// Why there are no shifts.
#[derive(Debug, Clone, PartialEq)]
pub enum NoShifts {
    /// A check that fails with the shifts that the aim would pick.
    Fault(Check<Place>),
    /// Gears that cannot mesh at these centre distances, or without teeth.
    Refused(Error),
}

/// Gears with shifts and tips, in mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Chosen {
    /// The gears.
    pub gears: Vec<InvoluteGear>,
    /// The meshes, without backlash.
    pub pairs: Vec<Pair>,
    /// Whether the aim is met in full.
    pub is_aim_met: bool,
}

/// Least and greatest shift of the first gear where no undercut bounds it.
const WIDEST: RangeInclusive<f64> = -1.0..=1.5;

/// Gears of a tree of meshes with stated centre distances.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshTree {
    gears: Vec<InvoluteGear>,
    meshes: Vec<StatedDistance>,
    /// `c_i`.
    constant: Vec<f64>,
    /// `s_i`.
    sign: Vec<f64>,
}

impl MeshTree {
    /// Gears as [`InvoluteGear::searched`] gives them, whose own shifts do not matter, and the meshes that
    /// join them all.
    ///
    /// # Errors
    /// Those of [`Pair::shift_sum`]; [`Error::NotJoined`] where the meshes do not join all gears.
    pub fn new(gears: Vec<InvoluteGear>, meshes: Vec<StatedDistance>) -> Result<Self, Error> {
        let follows = |first: f64| {
            let mut shifts = vec![None; gears.len()];
            if let Some(shift) = shifts.first_mut() {
                *shift = Some(first);
            }
            closing_shifts(&gears, &shifts, &meshes).map_err(|why| match why {
                Unclosed::Refused { error, .. } => error,
                Unclosed::Open { .. } | Unclosed::Fixed { .. } => {
                    Error::NotJoined { gears: gears.len(), meshes: meshes.len() }
                }
            })
        };
        if meshes.len() + 1 != gears.len() {
            return Err(Error::NotJoined { gears: gears.len(), meshes: meshes.len() });
        }
        let (constant, one) = (follows(0.0)?, follows(1.0)?);
        let sign = constant.iter().zip(&one).map(|(zero, one)| (one - zero).signum()).collect();
        Ok(Self { gears, meshes, constant, sign })
    }

    /// The shifts of all gears from that of the first.
    #[must_use]
    pub fn shifts(&self, first: f64) -> Vec<f64> {
        self.constant.iter().zip(&self.sign).map(|(constant, sign)| constant + sign * first).collect()
    }

    /// The gears with a shift of the first, their tips shortened for clearance and fillets, in mesh.
    ///
    /// # Errors
    /// [`Error::ShiftOutOfRange`] where a gear has no teeth left; those of [`Pair::at_centre_distance`].
    pub fn at(&self, first: f64) -> Result<Chosen, Error> {
        let shifts = self.shifts(first);
        // Tips change neither the cut of a gear nor the working angle of a mesh: both are calculated once.
        let cut: Vec<InvoluteGear> =
            self.gears.iter().zip(&shifts).map(|(gear, shift)| gear.altered(*shift, 0.0)).collect();
        let mut tips = vec![0.0_f64; cut.len()];
        let shifted = |tips: &[f64]| -> Result<Vec<InvoluteGear>, Error> {
            cut.iter().zip(tips).map(|(gear, tip)| gear.altered(gear.shift(), *tip).checked()).collect()
        };
        let full = shifted(&tips)?;
        let pair = |mesh: &StatedDistance| {
            let [one, other] = mesh.gears;
            Pair::at_centre_distance(full[one], full[other], mesh.distance)
        };
        let mut pairs: Vec<Pair> = self.meshes.iter().map(pair).collect::<Result<_, _>>()?;
        for (mesh, pair) in self.meshes.iter().zip(&pairs) {
            for gear in mesh.gears.into_iter().filter(|_| !pair.is_internal()) {
                tips[gear] = tips[gear].min(pair.tip_alteration());
            }
        }
        let clear = shifted(&tips)?;
        for (mesh, pair) in self.meshes.iter().zip(&mut pairs) {
            let [first, second] = mesh.gears.map(|gear| clear[gear]);
            *pair = pair.with_gears([first, second]);
            let curvatures = [pair.of_mate(second.cut().end), pair.mate(first.cut().end)];
            for (gear, curvature) in mesh.gears.into_iter().zip(curvatures) {
                tips[gear] = tips[gear].min(clear[gear].shortened_to(curvature));
            }
        }
        let gears = shifted(&tips)?;
        for (mesh, pair) in self.meshes.iter().zip(&mut pairs) {
            *pair = pair.with_gears(mesh.gears.map(|gear| gears[gear]));
        }
        Ok(Chosen { gears, pairs, is_aim_met: true })
    }

    /// The gears that an aim picks among those without faults.
    ///
    /// Sliding is balanced in the first external mesh. Without an external mesh the shifts are smallest
    /// together among 64 equal steps of the range. For the least tip alteration its sum is, and of equal ones
    /// that of the shifts.
    ///
    /// # Errors
    /// [`NoShifts`].
    pub fn choose(&self, aim: Aim, limits: &Limits) -> Result<Chosen, NoShifts> {
        let range = self.searched();
        let checked = |shift: f64| {
            let chosen = self.at(shift).map_err(NoShifts::Refused)?;
            self.first_fault(&chosen, limits).map_or(Ok(chosen), |fault| Err(NoShifts::Fault(fault)))
        };
        let balanced = self
            .meshes
            .iter()
            .position(|mesh| mesh.gears.iter().all(|gear| self.gears[*gear].kind() == GearKind::External));
        let best = match balanced {
            Some(_) if aim == Aim::BalancedSliding => None,
            _ => self.least_altered(aim, &range, &checked),
        };
        // No step without faults: a shorter stretch of shifts may lie about those that balance.
        let about = || balanced.map(|mesh| self.balanced(mesh, &range));
        let wanted = best.or_else(about).unwrap_or(range.start().midpoint(*range.end()));
        let (chosen, limited_by) = nearest(wanted, &range, checked, |_| true)?;
        Ok(Chosen { is_aim_met: limited_by.is_none(), ..chosen })
    }

    /// Shift of the first gear that balances the sliding of an external mesh.
    fn balanced(&self, mesh: usize, range: &RangeInclusive<f64>) -> f64 {
        let [first, second] = self.meshes[mesh].gears;
        let sign = self.sign[first].signum();
        rising_to_zero(range, |shift| match self.at(shift) {
            Ok(chosen) => sign * sliding_imbalance(&chosen.pairs[mesh]),
            // A gear without teeth has too large a shift of its own, or its mate too small a one.
            Err(_) => sign * (self.shifts(shift)[first] - self.shifts(shift)[second]),
        })
    }

    fn least_altered(
        &self,
        aim: Aim,
        range: &RangeInclusive<f64>,
        checked: &impl Fn(f64) -> Result<Chosen, NoShifts>,
    ) -> Option<f64> {
        let step = (range.end() - range.start()) / f64::from(PARTS);
        let size = |of: fn(&InvoluteGear) -> f64, all: &[InvoluteGear]| -> f64 {
            all.iter().map(|gear| of(gear).abs()).sum()
        };
        let measured = |part: u32| {
            let shift = range.start() + f64::from(part) * step;
            let gears = checked(shift).ok()?.gears;
            let by = [size(InvoluteGear::tip_alteration, &gears), size(InvoluteGear::shift, &gears)];
            // Rings without external mates have no clearance to keep, and hardly any alteration.
            Some((shift, if aim == Aim::LeastTipAlteration { by } else { [by[1], by[0]] }))
        };
        let parts = if step > 0.0 { PARTS } else { 0 };
        let best = (0..=parts)
            .filter_map(measured)
            .min_by(|(_, one), (_, other)| one[0].total_cmp(&other[0]).then(one[1].total_cmp(&other[1])));
        best.map(|(shift, _)| shift)
    }

    /// Shifts of the first gear with which no external gear is undercut; the middle one alone if there are
    /// none.
    fn searched(&self) -> RangeInclusive<f64> {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for ((gear, constant), sign) in self.gears.iter().zip(&self.constant).zip(&self.sign) {
            let Some(least) = gear.least_shift_without_undercut() else { continue };
            let bound = sign * (least - constant);
            if *sign > 0.0 { low = low.max(bound) } else { high = high.min(bound) }
        }
        let low = if low.is_finite() { low } else { WIDEST.start().min(high) };
        let high = if high.is_finite() { high } else { WIDEST.end().max(low) };
        if low > high { low.midpoint(high)..=low.midpoint(high) } else { low..=high }
    }

    /// The first check that fails, without remarks.
    fn first_fault(&self, chosen: &Chosen, limits: &Limits) -> Option<Check<Place>> {
        let mut first = None;
        let mut see = |check: Check<Place>| {
            let counts = check.rule.severity() > Severity::Remark || limits.radial_assembly;
            if first.is_none() && counts && !check.holds() {
                first = Some(check);
            }
        };
        for (place, gear) in chosen.gears.iter().enumerate() {
            gear_checks(&Place::Gear(place), gear, limits, &mut see);
        }
        for (place, (mesh, pair)) in self.meshes.iter().zip(&chosen.pairs).enumerate() {
            let tips = mesh.gears.map(|gear| Place::Tips(gear, place));
            mesh_checks(&Place::Mesh(place), &tips, pair, limits, &mut see);
        }
        first
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::involute::Profile;
    use crate::involute::family::Family;
    use proptest::prelude::*;

    fn gear(kind: GearKind, teeth: u32) -> InvoluteGear {
        InvoluteGear::searched(kind, ToothCount::new(teeth).unwrap(), Profile::default()).unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// Sun, planets and ring as a tree: the family's set.
        #[test]
        fn three_gears_are_the_family_of_a_simple_set(
            sun in 15_u32..60, planet in 15_u32..60, offset in -1..=1_i32, away in -0.3_f64..0.8,
        ) {
            let ring = (sun + 2 * planet).checked_add_signed(offset).unwrap();
            let teeth = [sun, planet, ring].map(|teeth| ToothCount::new(teeth).unwrap());
            let distance = f64::from(sun + planet) / 2.0 + away;
            let gears = vec![gear(GearKind::External, sun), gear(GearKind::External, planet), gear(GearKind::Internal, ring)];
            let meshes = [[0, 1], [1, 2]].map(|gears| StatedDistance { gears, distance }).to_vec();
            let limits = Limits { planet_gap: 0.0, ..Limits::default() };
            let tree = MeshTree::new(gears, meshes);
            // One planet does not touch itself.
            let family = Family::new(teeth, 1, Profile::default(), distance);
            match (tree, family) {
                (Ok(tree), Ok(family)) => match (
                    tree.choose(Aim::BalancedSliding, &limits),
                    family.choose(Aim::BalancedSliding, &limits),
                ) {
                    (Ok(tree), Ok(family)) => {
                        prop_assert_eq!(tree.is_aim_met, family.limited_by.is_none());
                        for (one, other) in tree.gears.iter().zip(family.set.gears()) {
                            prop_assert!((one.shift() - other.shift()).abs() < 1e-9, "{} {}", one.shift(), other.shift());
                            prop_assert!((one.tip_alteration() - other.tip_alteration()).abs() < 1e-9);
                        }
                    }
                    (tree, family) => prop_assert_eq!(tree.is_err(), family.is_err(), "{:?}", tree.err()),
                },
                (tree, family) => prop_assert_eq!(tree.is_err(), family.is_err()),
            }
        }
    }

    #[test]
    fn gears_that_no_mesh_joins_are_refused() {
        let gears = vec![gear(GearKind::External, 20), gear(GearKind::External, 30)];
        assert_eq!(MeshTree::new(gears, vec![]).unwrap_err().name(), "not-joined");
    }

    /// A pair of a twin-rotor stage at its distance.
    #[test]
    fn a_pair_balances_its_sliding() {
        let gears = vec![gear(GearKind::External, 24), gear(GearKind::External, 95)];
        let meshes = vec![StatedDistance { gears: [0, 1], distance: 60.5 }];
        let chosen =
            MeshTree::new(gears, meshes).unwrap().choose(Aim::BalancedSliding, &Limits::default()).unwrap();
        let [[_, one], [_, other]] = chosen.pairs[0].specific_sliding();
        assert!((one - other).abs() < 1e-9 && chosen.is_aim_met, "{one} {other}");
        assert!(chosen.pairs[0].backlash().abs() < 1e-9);
    }
}
