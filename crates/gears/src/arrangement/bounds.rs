//! Bounds of a search for tooth numbers of an arrangement.

use super::Arrangement;
use super::numbers::{ModuleRatio, least_angle_rad};
use crate::checks::not_negative;
use crate::error::Error;
use crate::involute::family::Aim;
use crate::involute::search::MOST_OFFSET;
use crate::involute::set::Limits;
use crate::quantity::{Quantity, SimpleGear};
use crate::rack::BasicRack;
use crate::synthesis::{Bounds, MOST_TEETH, Placement};
use std::ops::RangeInclusive;
use uom::si::f64::Angle;

/// Bounds of a search for tooth numbers of an arrangement. All ranges include their ends.
#[derive(Debug, Clone, PartialEq)]
pub struct ArrangementBounds {
    /// Arrangement of the gears.
    pub arrangement: Arrangement,
    /// Teeth of each gear, in the order of the gears.
    pub teeth: Vec<RangeInclusive<u32>>,
    /// Number of planets, from 2 to 8; without effect on pairs.
    pub planets: RangeInclusive<u32>,
    /// Modules of the second step over that of the first.
    pub module_ratios: Vec<ModuleRatio>,
    /// Differences of the doubled centre distances of a planet's meshes from the first of them, in modules of
    /// the first step, that profile shift closes.
    pub offsets: RangeInclusive<i32>,
    /// Aim of the profile shifts.
    pub aim: Aim,
    /// Limits of the gears with profile shift; their gap between planets is `tip_gap`.
    pub limits: Limits,
    /// Basic rack of all gears.
    pub rack: BasicRack,
    /// Least gap between tip circles of gears that do not mesh, in modules.
    pub tip_gap: f64,
    /// Permissible placement of the planets.
    pub placement: Placement,
    /// Stated angles of the planets about the axis, which then give their number; empty for those of the
    /// placement.
    pub angles: Vec<Angle>,
    /// Leaves out sets with undercut gears; those with profile shift never have any.
    pub no_undercut: bool,
}

impl ArrangementBounds {
    /// Bounds with the teeth, rack, gap and planets of `bounds`, equal modules and no profile shift.
    #[must_use]
    pub fn of(arrangement: Arrangement, bounds: &Bounds) -> Self {
        let teeth = arrangement.gears().iter().map(|gear| match gear.role {
            SimpleGear::Sun => bounds.sun.clone(),
            SimpleGear::Planet => bounds.planet.clone(),
            SimpleGear::Ring => bounds.ring.clone(),
        });
        Self {
            arrangement,
            teeth: teeth.collect(),
            planets: bounds.planets.clone(),
            module_ratios: vec![ModuleRatio::from(1)],
            offsets: 0..=0,
            aim: Aim::default(),
            limits: Limits::default(),
            rack: bounds.rack,
            tip_gap: bounds.tip_gap,
            placement: bounds.placement,
            angles: vec![],
            no_undercut: false,
        }
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        let gears = self.arrangement.gears();
        // Ranges that hold a gear each, of the rest the same as for simple sets.
        let usual = Bounds { planets: self.planets.clone(), rack: self.rack, ..Bounds::default() };
        usual.check()?;
        for (place, gear) in gears.iter().enumerate() {
            let range = self.teeth.get(place).ok_or(Error::NoTeeth)?;
            let (from, to) = (*range.start(), *range.end());
            if from == 0 {
                return Err(Error::NoTeeth);
            }
            if range.is_empty() || to > MOST_TEETH {
                return Err(Error::ToothRange { gear: gear.role, from, to, most: MOST_TEETH });
            }
        }
        if !self.angles.is_empty() && least_angle_rad(&self.angles).is_none_or(|least| least <= 0.0) {
            return Err(Error::PlanetAngles { given: self.angles.len() });
        }
        for &ratio in &self.module_ratios {
            let is_one = ratio == ModuleRatio::from(1);
            if *ratio.numer() == 0 || !is_one && !self.arrangement.has_steps() {
                return Err(Error::ModuleRatio { arrangement: self.arrangement, ratio });
            }
        }
        let (from, to) = (*self.offsets.start(), *self.offsets.end());
        if from > to || from < -MOST_OFFSET || to > MOST_OFFSET {
            return Err(Error::RingOffset { from, to, most: MOST_OFFSET });
        }
        self.limits.check()?;
        not_negative(Quantity::TipGap, self.tip_gap, "modules")?;
        Ok(())
    }

    /// Number of combinations of the gears that are gone through.
    ///
    /// # Errors
    /// Those of invalid bounds as for [`for_ratio`](Self::for_ratio).
    pub fn space(&self) -> Result<u64, Error> {
        self.check()?;
        let count = |gear: usize| u64::from(self.teeth[gear].end() - self.teeth[gear].start()) + 1;
        let offsets = u64::from(self.offsets.end().abs_diff(*self.offsets.start())) + 1;
        Ok(match self.arrangement {
            Arrangement::Ravigneaux => count(2) * count(3) * offsets,
            Arrangement::ExternalPair | Arrangement::InternalPair => count(0),
            Arrangement::Wolfrom => count(0) * count(1) * offsets * offsets,
            _ => count(0) * count(1) * offsets * self.module_ratios.len() as u64,
        })
    }
}
