//! First look at pairs of levels: finds those that need no measuring, because rounding cannot change the
//! decision.
//!
//! The first designs in an order ([`best`](super::ToothSearch::best)) are few, and the rest need only be
//! counted. For one set 1 the look takes several sets 2 at once, from columns. Minors of teeth are exact here
//! as in a measure, and minors with losses are the same to the bit. All further values are wrong by less than
//! 1e-14 of themselves. Therefore
//!
//! - a figure beyond its limit by [`LOOK`] breaks the limit in a measure too. If all figures keep to their
//!   limits by as much, the pair is feasible.
//! - a first objective beyond that of a bound by [`BEHIND`] is beyond it on the grid of objectives as well,
//!   whose step is 1e-12. Torques and ratios with losses lose digits where their terms cancel. A pair in
//!   which more than [`CANCELLED`] cancels is measured; for the others the loss is below 2e-10.
//!
//! All other pairs are measured, so every judgement is that of a measure.

use super::levels::Level;
use super::patch::{Allowed, Patch, Side};
use crate::objective::Objective;
use crate::objectives::{Costs, Order};
use crate::tolerance::{BEHIND, CANCELLED, LOOK};
use epicyclic_numerics::values::{larger, smaller};
use epicyclic_schemes::structures::Role;

const EFFICIENCY: usize = Objective::Efficiency as usize;
const SPEED: usize = Objective::Speed as usize;
const RING_TO_SUN: usize = Objective::RingToSun as usize;
const RATIO_ERROR: usize = Objective::RatioError as usize;
const SIZE: usize = Objective::Size as usize;

const D: usize = Role::D.index();
const B: usize = Role::B.index();
/// The braked link that turns, in gears 1 and 2.
const FREE: [usize; 2] = [Role::T2.index(), Role::T1.index()];

/// Sets 2 in one look.
pub(super) const AT_ONCE: usize = 16;

type Column = [f64; AT_ONCE];

/// Result of a look at a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Verdict {
    /// A limit is broken.
    Infeasible,
    /// The criteria are all met, and the bound comes first.
    Behind,
    /// The pair has to be measured.
    Open,
}

/// A set 2 at all levels, by column.
#[derive(Debug)]
pub(super) struct Columns {
    ideal: [Vec<f64>; 4],
    loaded: [[Vec<f64>; 4]; 2],
    planet: Vec<f64>,
    distance: Vec<f64>,
    cube: Vec<f64>,
}

impl Columns {
    pub(super) fn new(sides: &[Side], levels: &[Level]) -> Self {
        // The last look may reach beyond the end; its results there are not used.
        let padded = |values: &mut dyn Iterator<Item = f64>| -> Vec<f64> {
            values.chain(std::iter::repeat_n(0.0, AT_ONCE)).collect()
        };
        let of = |value: &dyn Fn(&Side) -> f64| padded(&mut sides.iter().map(value));
        let at = |value: &dyn Fn(&Level) -> f64| padded(&mut levels.iter().map(value));
        Self {
            ideal: std::array::from_fn(|role| of(&|side| side.ideal[role])),
            loaded: std::array::from_fn(|gear| {
                std::array::from_fn(|role| of(&|side| side.loaded[gear][role]))
            }),
            planet: at(&planet),
            distance: at(&distance),
            cube: at(&cube),
        }
    }
}

/// The planet's speed over that of the sun, both relative to the carrier: `1/r`.
fn planet(level: &Level) -> f64 {
    let [sun, _] = level.teeth;
    sun / level.planet
}

fn distance(level: &Level) -> f64 {
    level.distance.value()
}

/// Cube of the relative ring diameter over the torque on the sun.
fn cube(level: &Level) -> f64 {
    level.cube * level.share
}

/// A limit: `scale·value + offset` is how far a value is beyond it, over 1 and the limit; of no limit −1.
#[derive(Debug, Clone, Copy)]
struct Ceiling {
    scale: f64,
    offset: f64,
}

impl Ceiling {
    fn new(limit: f64) -> Self {
        if limit.is_finite() {
            let scale = 1.0 / (1.0 + limit.abs());
            Self { scale, offset: -limit * scale }
        } else {
            Self { scale: 0.0, offset: -1.0 }
        }
    }

    #[inline]
    fn beyond(self, value: f64) -> f64 {
        value * self.scale + self.offset
    }
}

/// A look at the pairs of a patch, for a bound of costs.
#[derive(Debug)]
pub(super) struct Screen<'a> {
    columns: &'a Columns,
    over_wanted: [f64; 2],
    /// Speeds of planets relative to the sun's carrier, by gear and set, and slip of the direct-drive clutch
    /// by gear: the share in them of the numerator of the ratio, its denominator, and the minor of D and B.
    planets: [[[f64; 3]; 2]; 2],
    slip: [[f64; 3]; 2],
    ratio_error: Ceiling,
    link_speed: Ceiling,
    planet_speed: Ceiling,
    clutch_slip: Ceiling,
    /// Limit of `1 − η`.
    loss: Ceiling,
    /// Value above 0 where circulating power has a limit, which a look does not judge.
    circulation: f64,
    first: Objective,
    /// A first objective as a cost is behind the bound from here on.
    behind: f64,
}

impl<'a> Screen<'a> {
    pub(super) fn new(
        patch: &Patch,
        columns: &'a Columns,
        allowed: &Allowed,
        bound: &Costs,
        order: Order,
    ) -> Self {
        // Speeds of the links times the numerator of the ratio: D, the braked link at rest, B and the free
        // link.
        let speed = |role: Role, gear: usize| match role {
            Role::D => [1.0, 0.0, 0.0],
            Role::B => [0.0, 1.0, 0.0],
            braked if braked.index() == FREE[gear] => [0.0, 0.0, -1.0],
            _ => [0.0; 3],
        };
        let less = |x: Role, y: Role, gear: usize| {
            let (x, y) = (speed(x, gear), speed(y, gear));
            [0, 1, 2].map(|place| x[place] - y[place])
        };
        let first = order.objectives()[0];
        let cost = bound[first as usize];
        let [x, y] = patch.direct_clutches[0];
        Self {
            columns,
            over_wanted: patch.wanted.map(|ratio| 1.0 / ratio),
            planets: [0, 1].map(|gear| patch.sets.map(|[a, _, h]| less(a, h, gear))),
            slip: [0, 1].map(|gear| less(x, y, gear)),
            ratio_error: Ceiling::new(allowed.ratio_error),
            link_speed: Ceiling::new(allowed.link_speed),
            planet_speed: Ceiling::new(allowed.planet_speed),
            clutch_slip: Ceiling::new(allowed.clutch_slip),
            loss: Ceiling::new(1.0 - allowed.efficiency),
            circulation: if allowed.circulation.is_finite() { 1.0 } else { -1.0 },
            first,
            behind: cost + BEHIND * (1.0 + cost.abs()),
        }
    }

    /// Verdicts on the pairs of a set 1 with [`AT_ONCE`] sets 2 from a place on.
    pub(super) fn look(&self, side: &Side, level: &Level, from: usize) -> [Verdict; AT_ONCE] {
        let [excess, behind] = match self.first {
            Objective::Efficiency => self.figures::<EFFICIENCY>(side, level, from),
            Objective::Speed => self.figures::<SPEED>(side, level, from),
            Objective::RingToSun => self.figures::<RING_TO_SUN>(side, level, from),
            Objective::RatioError => self.figures::<RATIO_ERROR>(side, level, from),
            // The order of a search over teeth has circulation last.
            Objective::Size | Objective::Circulation => self.figures::<SIZE>(side, level, from),
        };
        // A value that is not a number leaves the pair open.
        std::array::from_fn(|place| {
            if excess[place] > LOOK {
                Verdict::Infeasible
            } else if excess[place] < -LOOK && behind[place] > 0.0 {
                Verdict::Behind
            } else {
                Verdict::Open
            }
        })
    }

    /// Largest excess over the limits, and the distance of the first objective behind the bound.
    #[inline]
    fn figures<const FIRST: usize>(&self, one: &Side, level: &Level, from: usize) -> [Column; 2] {
        let at = |column: &'a [f64]| -> &'a Column {
            column[from..].first_chunk().unwrap_or(&[f64::NAN; AT_ONCE])
        };
        let ideal = [0, 1, 2, 3].map(|role| at(&self.columns.ideal[role]));
        let loaded = [0, 1].map(|gear| [0, 1, 2, 3].map(|role| at(&self.columns.loaded[gear][role])));
        let planets = at(&self.columns.planet);
        let distances = at(&self.columns.distance);
        let cubes = at(&self.columns.cube);
        let (planet, distance, cube) = (planet(level), distance(level), cube(level));
        let (mut excess, mut behind) = ([0.0; AT_ONCE], [0.0; AT_ONCE]);
        for place in 0..AT_ONCE {
            let minor = |x: usize, y: usize| one.ideal[x] * ideal[y][place] - one.ideal[y] * ideal[x][place];
            let d_b = minor(D, B);
            let (mut error, mut links, mut planet_speed, mut slip) = (0.0, 1.0, 0.0, 0.0);
            let (mut efficiency, mut torques, mut cancelled) = (f64::INFINITY, [0.0; 2], -1.0);
            let mut number = 0.0;
            for gear in 0..2 {
                let x = FREE[gear];
                let (n, d) = (-minor(B, x), minor(D, x));
                let (over_n, over_d) = (1.0 / n, 1.0 / d);
                let (ratio, over_ratio) = (n * over_d, d * over_n);
                error = larger(error, (ratio * self.over_wanted[gear] - 1.0).abs());
                links = larger(links, larger(d.abs(), d_b.abs()) * over_n.abs());
                let speed = |[of_n, of_d, of_minor]: [f64; 3]| {
                    ((of_n * n + of_d * d + of_minor * d_b) * over_n).abs()
                };
                planet_speed = larger(planet_speed, speed(self.planets[gear][0]) * planet);
                planet_speed = larger(planet_speed, speed(self.planets[gear][1]) * planets[place]);
                slip = larger(slip, speed(self.slip[gear]));
                // With losses.
                let (of, two) = (&one.loaded[gear], loaded[gear].map(|column| column[place]));
                let products = |y: usize| (of[y] * two[x], of[x] * two[y]);
                let ((b, b_less), (e, e_less)) = (products(B), products(D));
                let (n, d) = (-(b - b_less), e - e_less);
                let over = 1.0 / d;
                let found = n * over * over_ratio;
                efficiency = smaller(efficiency, found);
                torques =
                    [larger(torques[0], (two[x] * over).abs()), larger(torques[1], (of[x] * over).abs())];
                cancelled = larger(cancelled, b.abs() + b_less.abs() - CANCELLED * n.abs());
                cancelled = larger(cancelled, e.abs() + e_less.abs() - CANCELLED * d.abs());
                number += over_n + over_d + over;
            }
            let beyond = larger(self.ratio_error.beyond(error), self.link_speed.beyond(links));
            let beyond = larger(beyond, self.planet_speed.beyond(planet_speed));
            let beyond = larger(beyond, self.loss.beyond(1.0 - efficiency));
            let first = match FIRST {
                EFFICIENCY => -efficiency,
                SPEED => larger(links, planet_speed),
                RING_TO_SUN => distance * distances[place],
                RATIO_ERROR => error,
                _ => larger(cube * torques[0], cubes[place] * torques[1]),
            };
            // Another clutch may fit where the first does not.
            let open = larger(larger(self.clutch_slip.beyond(slip) + LOOK, cancelled), self.circulation);
            // A quotient by 0 makes this not a number.
            let nothing = 0.0 * number;
            excess[place] = beyond + nothing;
            behind[place] = smaller(first - self.behind, -open) + nothing;
        }
        [excess, behind]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::requirements::Requirements;
    use crate::search::ToothSearch;
    use epicyclic_gears::synthesis::Bounds;
    use epicyclic_schemes::RatioSeries;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]

        /// Of every pair: what is found infeasible is so, and what is found behind is feasible and behind.
        #[test]
        fn no_pair_is_judged_otherwise_than_by_a_measure(
            q in 1.05..2.5_f64,
            step in 1.05..3.0_f64,
            limits in (0.85..0.97_f64, 1.0..4.0_f64, 1.0..9.0_f64, 0.8..30.0_f64),
            circulation in prop_oneof![Just(f64::INFINITY), 0.0..2.0_f64],
            objective in 0..5_usize,
            bound in any::<prop::sample::Index>(),
        ) {
            let mut requirements = Requirements::new(RatioSeries::of_braked_gears(&[q, q * step]).unwrap());
            (requirements.limits.efficiency, requirements.limits.link_speed) = (limits.0, limits.1);
            (requirements.limits.planet_speed, requirements.limits.clutch_slip) = (limits.2, limits.3);
            requirements.limits.circulation = circulation;
            let mut search = ToothSearch::new(requirements);
            search.bounds = Bounds { ring: 12..=80, ..Bounds::default() };
            search.order = Order::new(&[Objective::ALL[objective]]).unwrap();
            let found = search.prepared(&|_| std::ops::ControlFlow::Continue(())).unwrap();
            for patch in &found.patches {
                let sides = patch.sides(&found.levels);
                let columns = Columns::new(&sides[1], &found.levels);
                let mut pairs = vec![];
                for &[one, from, to] in &patch.strips {
                    for two in from..to {
                        let pair = [one as usize, two as usize];
                        let at = pair.map(|place| &found.levels[place]);
                        let both = [&sides[0][pair[0]], &sides[1][pair[1]]];
                        let measured = patch.measure(&found.levels, pair, both, &found.allowed);
                        pairs.push((pair, measured.map(|one| patch.costs(&one, at, at.map(|level| level.share)))));
                    }
                }
                let feasible: Vec<&Costs> = pairs.iter().filter_map(|(_, costs)| costs.as_ref()).collect();
                if feasible.is_empty() {
                    continue;
                }
                let bound = feasible[bound.index(feasible.len())];
                let screen = Screen::new(patch, &columns, &found.allowed, bound, search.order);
                let mut open = 0;
                for ([one, two], costs) in &pairs {
                    match screen.look(&sides[0][*one], &found.levels[*one], *two)[0] {
                        Verdict::Infeasible => prop_assert!(costs.is_none()),
                        Verdict::Behind => {
                            let costs = costs.as_ref().unwrap();
                            prop_assert!(costs[objective] > bound[objective], "{costs:?} {bound:?}");
                        }
                        Verdict::Open => open += 1,
                    }
                }
                // A slip beyond its limit is open: another clutch may fit.
                let before = feasible.iter().filter(|costs| costs[objective] <= bound[objective]).count();
                prop_assert!(limits.3 < 20.0 || circulation.is_finite() || open <= before + pairs.len() / 4, "{open} {before}");
            }
        }
    }
}
