//! Larger sizes than usual: when they are tried, and when they are taken.

use super::making::BEARINGS_DECIDE;
use super::masses::Masses;
use crate::analyze::answer::pins::PLANET_SPEED;
use crate::answer::Warning;

/// Whole mass with larger sizes over that with usual ones up to which they are taken where they miss as many rules.
const BEARINGS_PAY: f64 = 0.8;

/// Gearbox with usual or larger sizes, as they are compared.
#[derive(Debug, Clone, Copy)]
pub(super) struct Compared {
    /// Rules of usual practice that it misses; `None` without a gearbox.
    rules_missed: Option<u32>,
    whole_kg: f64,
    /// Whether the bearings that can be bought decide a size, or turn faster than is usual.
    is_of_bearings: bool,
}

impl Compared {
    pub(super) fn new(rules_missed: Option<u32>, masses: Option<Masses>, warnings: &[Warning]) -> Self {
        Self {
            rules_missed: rules_missed.filter(|_| masses.is_some()),
            whole_kg: masses.map_or(f64::INFINITY, |masses| masses.whole_kg),
            is_of_bearings: warnings.iter().any(|one| [BEARINGS_DECIDE, PLANET_SPEED].contains(&one.name)),
        }
    }

    /// Whether larger sizes are tried. Bearings of a table that are just large enough may make a gearbox several
    /// times heavier.
    pub(super) fn is_open(self) -> bool {
        self.rules_missed.is_none() || self.is_of_bearings
    }

    /// Whether a gearbox with larger sizes is taken instead: it misses fewer rules and is no heavier, or misses no
    /// more and is much lighter. Without a gearbox of usual sizes it is taken in any case.
    pub(super) fn gives_way_to(self, larger: Self) -> bool {
        let (Some(own), other) = (self.rules_missed, larger.rules_missed.unwrap_or(u32::MAX)) else {
            return true;
        };
        other < own && larger.whole_kg <= self.whole_kg
            || other <= own && larger.whole_kg < BEARINGS_PAY * self.whole_kg
    }
}
