//! Window of ring-to-sun ratios `k₂` that are worth trying with a given `k₁`: every bound that prunes.
//!
//! With `k₁` given every minor of [`pair`](epicyclic_schemes::pair) is linear in `k₂`, so ratios and link
//! speeds are quotients of linear functions of `k₂`. Such a quotient is monotonous on either side of its pole
//! and passes each limit at most once. Between limits and pole it therefore keeps to its limits or breaks
//! them throughout. A look into the middle of each part decides. The window is the least interval that holds
//! the parts within the limits for all of
//!
//! 1. both ratios within tolerance;
//! 2. both free braked links within the limit of link speeds (D has 1, and B the reciprocal of a ratio);
//! 3. planets of set 1 within theirs: `(ω_a − ω_H)/r₁`, of the same kind;
//! 4. planets of set 2: for `k₂` up to the window's end `e` they have `r₂ ≤ (e − 1)/2 + δ`. Here `δ` is the
//!    most by which an offset of the ring puts `r` above `(k − 1)/2`. The condition is
//!    `|ω_a − ω_H| ≤ limit·((e − 1)/2 + δ)`.
//!
//! Outside the window some required criterion fails; inside, every pair is tried in full. Limits are widened
//! by 2·10⁻⁹ of themselves, twice what the trial allows for rounding. Rounding can therefore only let too
//! many pairs through.

use crate::requirements::Limits;
use crate::tolerance::{HAIR, WIDER};
use epicyclic_schemes::pair::{Coefficients, minor};
use epicyclic_schemes::structures::{Role, SetRoles};

/// `[m, n]` of `m + n·k`.
type Linear = [f64; 2];

/// Target ratios of a structure's gears, and their tolerance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wanted {
    pub(crate) ratios: [f64; 2],
    pub(crate) tolerance: f64,
}

/// Known limits of the planets' teeth over the sun's, `r`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Planets {
    /// `r` of set 1.
    pub(crate) first: f64,
    /// The most by which that of any set 2 is above `(k₂ − 1)/2`, 0 or more.
    pub(crate) above: f64,
}

/// The window of `k₂` within `range`, beside a set 1 of these coefficients.
pub(crate) fn window(
    sets: [SetRoles; 2],
    first: &Coefficients,
    planets: Planets,
    wanted: Wanted,
    limits: &Limits,
    range: [f64; 2],
) -> Option<[f64; 2]> {
    let (mut at_zero, mut slope) = ([0.0; 4], [0.0; 4]);
    for (role, [zero, one]) in sets[1].into_iter().zip([[1.0, 0.0], [0.0, 1.0], [-1.0, -1.0]]) {
        (at_zero[role.index()], slope[role.index()]) = (zero, one);
    }
    let linear = |x: Role, y: Role| {
        let (x, y) = (x.index(), y.index());
        [minor(first, &at_zero, x, y), minor(first, &slope, x, y)]
    };
    let minus = |[m, n]: Linear| [-m, -n];
    let mut window = range;
    let free = [Role::T2, Role::T1];
    let on_b = free.map(|x| linear(Role::B, x));
    let on_d = free.map(|x| linear(Role::D, x));
    for gear in 0..2 {
        let ratio = wanted.ratios[gear];
        let ends = [1.0 - wanted.tolerance - WIDER, 1.0 + wanted.tolerance + WIDER].map(|part| ratio * part);
        let [low, high] = if ratio > 0.0 { ends } else { [ends[1], ends[0]] };
        window = part_within(minus(on_b[gear]), on_d[gear], [low, high], window)?;
    }
    let d_b = linear(Role::D, Role::B);
    let wide = |limit: f64| limit + WIDER * (1.0 + limit);
    for (gear, &link) in free.iter().enumerate() {
        let limit = wide(limits.link_speed);
        if limit.is_finite() {
            window = part_within(d_b, on_b[gear], [-limit, limit], window)?;
        }
        // Speeds times [BX].
        let speed = |role: Role| match role {
            Role::D => on_b[gear],
            Role::B => minus(on_d[gear]),
            braked if braked == link => d_b,
            _ => [0.0; 2],
        };
        for (set, [a, _, h]) in sets.into_iter().enumerate() {
            let (a, h) = (speed(a), speed(h));
            let largest = if set == 0 { planets.first } else { (window[1] - 1.0) / 2.0 + planets.above };
            let limit = wide(limits.planet_speed) * largest;
            if limit.is_finite() {
                window = part_within([a[0] - h[0], a[1] - h[1]], on_b[gear], [-limit, limit], window)?;
            }
        }
    }
    Some(window)
}

/// The least interval that holds the part of `[from, to]` where `num/den` is within limits.
fn part_within(num: Linear, den: Linear, [low, high]: [f64; 2], [from, to]: [f64; 2]) -> Option<[f64; 2]> {
    let root = |limit: f64| -(num[0] - limit * den[0]) / (num[1] - limit * den[1]);
    let mut cuts = [from, root(low), root(high), -den[0] / den[1], to];
    for cut in &mut cuts[1..4] {
        // A cut outside, or none at all, cuts nothing.
        *cut = if *cut > from && *cut < to { *cut } else { from };
    }
    // Three inner cuts, in order.
    if cuts[1] > cuts[2] {
        cuts.swap(1, 2);
    }
    if cuts[2] > cuts[3] {
        cuts.swap(2, 3);
    }
    if cuts[1] > cuts[2] {
        cuts.swap(1, 2);
    }
    let within = |place: &usize| {
        let middle = f64::midpoint(cuts[*place], cuts[*place + 1]);
        let value = (num[0] + num[1] * middle) / (den[0] + den[1] * middle);
        value >= low && value <= high
    };
    let parts = (0..4).filter(|&place| cuts[place + 1] > cuts[place] || from == to);
    let mut within = parts.filter(within);
    let first = within.next()?;
    let last = within.next_back().unwrap_or(first);
    // Roots are rounded: a hair more on both sides.
    Some([cuts[first] * (1.0 - HAIR), cuts[last + 1] * (1.0 + HAIR)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_interval_holds_every_value_within(
            num in proptest::array::uniform2(-5.0..5.0_f64),
            den in proptest::array::uniform2(-5.0..5.0_f64),
            ends in proptest::array::uniform2(-3.0..3.0_f64),
            at in 1.3..10.0_f64,
        ) {
            let limits = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            let value = (num[0] + num[1] * at) / (den[0] + den[1] * at);
            if value > limits[0] + 1e-9 && value < limits[1] - 1e-9 {
                let [from, to] = part_within(num, den, limits, [1.3, 10.0]).unwrap();
                prop_assert!(from <= at && at <= to, "{from} {at} {to}");
            }
        }
    }
}
