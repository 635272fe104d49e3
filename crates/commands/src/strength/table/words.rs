//! What the tables of factors have in common.

use crate::strength::answer::records::FactorOverDuty;
use crate::table::figure::{Figure, text};

/// What factors over a duty are.
pub(super) const OF_STEPS: &str =
    "Least to greatest of the loaded steps; Z_NT and Y_NT are part of Miner's rule.";

/// Four decimals, of a factor that the steps change those of its least and greatest value.
pub(super) fn extent(factor: &FactorOverDuty) -> String {
    let [least, greatest] = [factor.least, factor.greatest].map(|value| format!("{value:.4}"));
    if least == greatest { least } else { format!("{least} to {greatest}") }
}

/// The formula of a factor, or that it is given.
pub(super) fn from(formula: Option<&str>) -> Figure {
    formula.map_or(Figure::answer("given", "given"), text)
}
