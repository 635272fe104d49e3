//! Search over teeth for two speeds: all tooth numbers of one set, in all ways to use it.
//!
//! With one set every objective is a function of one ring-to-sun ratio, so the search is fast without leaving
//! anything out. All tooth numbers whose ratio is within tolerance in any of the ways are tried, once for
//! each `k`. Ratios and speeds are quotients of whole numbers, and efficiency and size are placed on their
//! grid by twice a double's digits. Equal values are therefore equal to the bit ([`super`]).
//!
//! With coefficients `c = (z_a, z_b, −(z_a + z_b))` at the links of sun, ring and carrier, and T₁ at rest,
//!
//! ```text
//! i = −c_B/c_D      ω_D = 1      ω_B = 1/i      T_a = z_a/c_D      η = î/i
//! ```
//!
//! Speeds and torques are multiples of the input's. `î` and `T_a` with losses are those of a set with
//! `k·η₀^x`, where `x` is the sign of its rolling power.

use super::double::Double;
use super::exact;
use super::found::{Counts, SizeLimits};
use super::levels::{Level, levels};
use super::patch::Allowed;
use super::shifted::{shifted, that_turn};
use super::{Directions, MOST_TOOTH_SETS, check_order};
use crate::drawing::drawable_direct_clutches;
use crate::front::{Entry, front};
use crate::mechanism::{Mechanism, Space};
use crate::objectives::{Costs, Objectives, Order, on_grid};
use crate::requirements::Requirements;
use crate::{Error, Rating};
use epicyclic_gears::involute::left_out::LeftOut;
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::{Bounds, ToothNumbers};
use epicyclic_numerics::front::non_dominated;
use epicyclic_schemes::structures::{Role, SetRoles};
use std::ops::{ControlFlow, RangeInclusive};
use uom::si::f64::Length;

/// A search over the teeth of one set.
#[derive(Debug, Clone)]
pub struct OneSetSearch {
    /// Requirements with one ratio.
    pub requirements: Requirements,
    /// Signs that are searched, of those that the requirements allow; by default all.
    pub directions: Directions,
    /// Ways to use the set, all six by default.
    pub sets: Vec<SetRoles>,
    /// Bounds of the tooth numbers.
    pub bounds: Bounds,
    /// Sets with profile shift in place of those without; `None` by default.
    pub shift: Option<ProfileShift>,
    /// Order of objectives by which entries are sorted. Circulating power, which one set does not have, must
    /// be last.
    pub order: Order,
    /// Module that the set needs at the load factor K, limits included.
    pub module: Option<RangeInclusive<Length>>,
    /// Greatest pitch diameter of the ring.
    pub ring_diameter: Option<Length>,
}

/// Result of a search over the teeth of one set.
#[derive(Debug, Clone)]
pub struct OneSetFound {
    entries: Vec<Entry>,
    points: Vec<Point>,
    ways: Vec<Way>,
    levels: Vec<Level>,
    tooth_sets: Vec<ToothNumbers>,
    left_out: Option<Box<LeftOut>>,
    counts: Counts,
    size: SizeLimits,
    rating: Rating,
}

/// Designs of one way to use a set that share objectives.
#[derive(Debug, Clone, PartialEq)]
pub struct OneSetDesign {
    /// Links of sun, ring and carrier.
    pub set: SetRoles,
    /// Target ratio.
    pub wanted: f64,
    /// Ring-to-sun ratio.
    pub k: f64,
    /// Tooth numbers, each a design.
    pub teeth: Vec<ToothNumbers>,
}

/// A way to use a set, with its target ratio.
#[derive(Debug, Clone)]
struct Way {
    set: SetRoles,
    wanted: f64,
    /// Options for the direct-drive clutch; only those that can be drawn, unless that does not matter.
    direct_clutches: Vec<[Role; 2]>,
    eta0: f64,
}

#[derive(Debug, Clone, Copy)]
struct Point {
    way: u32,
    level: u32,
}

/// A way at a ring-to-sun ratio, before sizes.
struct Measured {
    efficiency: Double,
    speed: f64,
    ratio_error: f64,
    /// Cube of the relative ring diameter, one planet carrying all.
    cube: Double,
}

/// Tooth numbers whose ratio is near the target.
struct Nearby {
    /// Tooth numbers near the ratio whose gears can be cut and turned together.
    near: Vec<ToothNumbers>,
    /// Number of sets of tooth numbers within the bounds, near or not.
    tooth_sets: usize,
    /// Tooth numbers near the ratio whose gears cannot be cut or turned together.
    left_out: Option<Box<LeftOut>>,
}

/// Number of designs from which on those that others dominate are left out before all are known.
const MANY: usize = 1 << 20;

/// Number of sets of tooth numbers between two reports of progress.
const LEVELS: u32 = 256;

impl OneSetSearch {
    /// Search over all six ways, with default tooth bounds and order and no limits of size.
    #[must_use]
    pub fn new(requirements: Requirements) -> Self {
        Self {
            requirements,
            directions: Directions::default(),
            sets: Space::All.sets(),
            bounds: Bounds::default(),
            shift: None,
            order: Order::default(),
            module: None,
            ring_diameter: None,
        }
    }

    /// The whole Pareto front, the best first by the order.
    ///
    /// # Errors
    /// Invalid bounds, limits and ratios, [`Error::OneRatio`] unless one ratio is wanted,
    /// [`Error::SizeWithoutTorque`], [`Error::NoObjectiveOfTeeth`], [`Error::TooManyNear`].
    pub fn front(&self) -> Result<OneSetFound, Error> {
        self.front_watched(|_| ControlFlow::Continue(()))
    }

    /// Front with reports of progress: `done` receives the completed share of the bounds, from 0 to 1; a
    /// break ends the search.
    ///
    /// # Errors
    /// Errors of [`front`](Self::front).
    pub fn front_watched(&self, mut done: impl FnMut(f64) -> ControlFlow<()>) -> Result<OneSetFound, Error> {
        self.requirements.check()?;
        check_order(self.order)?;
        let Requirements { limits, rating, .. } = &self.requirements;
        let size = SizeLimits::new(self.module.as_ref(), self.ring_diameter, rating)?;
        let allowed = Allowed::new(&self.requirements);
        let ways = self.ways()?;
        let Nearby { near, tooth_sets, left_out } = self.near(&ways, &allowed, &mut done)?;
        let (levels, near) = levels(near, limits, rating, self.shift.as_ref())?;
        let mut counts = Counts {
            tooth_sets,
            levels: levels.len(),
            patches: ways.len(),
            patches_tried: 0,
            designs: tooth_sets as u128 * ways.len() as u128,
            tried: 0,
            feasible: 0,
        };
        let (mut costs, mut points): (Vec<Costs>, Vec<Point>) = (vec![], vec![]);
        let mut enough = MANY;
        for (place, way) in (0_u32..).zip(&ways) {
            let before = counts.tried;
            for (of_level, level) in (0_u32..).zip(&levels) {
                if of_level % LEVELS == 0 && done(1.0).is_break() {
                    return Err(Error::Cancelled);
                }
                if !way.is_near(level.teeth, &allowed) {
                    continue;
                }
                counts.tried += 1;
                let Some(measured) = way.measure(level, &allowed) else { continue };
                let Some(share) = fitting(level.of(&near), &measured, size, rating).min_by(f64::total_cmp)
                else {
                    continue;
                };
                counts.feasible += 1;
                costs.push(measured.costs(level, share));
                points.push(Point { way: place, level: of_level });
            }
            counts.patches_tried += usize::from(counts.tried > before);
            if costs.len() > enough {
                let kept = non_dominated(&costs);
                costs = kept.iter().map(|&place| costs[place as usize]).collect();
                points = kept.iter().map(|&place| points[place as usize]).collect();
                enough = MANY.max(2 * costs.len());
            }
        }
        let entries = front(&costs, self.order, |place| Objectives::of_costs(costs[place], None));
        let rating = rating.clone();
        Ok(OneSetFound { entries, points, ways, levels, tooth_sets: near, left_out, counts, size, rating })
    }

    /// Ways to use the set, with the target ratio of each; without those that cannot be drawn, unless that
    /// does not matter.
    fn ways(&self) -> Result<Vec<Way>, Error> {
        let limits = &self.requirements.limits;
        let mut found = vec![];
        for target in self.requirements.targets() {
            let [wanted] = target[..] else { return Err(Error::OneRatio { count: target.len() }) };
            if !(self.requirements.allows_directions_of(&target) && self.directions.hold(&target)) {
                continue;
            }
            for &set in &self.sets {
                let direct_clutches = if limits.drawable {
                    let Ok(drawable) = drawable_direct_clutches(Mechanism::OneSet(set)) else { continue };
                    drawable
                } else {
                    vec![[Role::D, Role::B], [Role::D, Role::T1], [Role::B, Role::T1]]
                };
                found.push(Way { set, wanted, direct_clutches, eta0: self.requirements.eta0.get() });
            }
        }
        Ok(found)
    }

    /// Tooth numbers whose ratio is near the target of any way.
    fn near(
        &self,
        ways: &[Way],
        allowed: &Allowed,
        mut done: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Nearby, Error> {
        let k = &self.requirements.limits.ring_to_sun;
        if let Some(shift) = &self.shift {
            let all: Vec<ToothNumbers> = shifted(&self.bounds, shift, done)?;
            let is_near = |teeth: &ToothNumbers| {
                let of = [teeth.sun, teeth.ring].map(|teeth| f64::from(teeth.get()));
                ways.iter().any(|way| way.is_near(of, allowed))
            };
            let within = all.into_iter().filter(|teeth| k.contains(&teeth.ring_to_sun_ratio()));
            let (near, far): (Vec<ToothNumbers>, Vec<ToothNumbers>) = within.partition(is_near);
            let tooth_sets = near.len() + far.len();
            return Ok(Nearby { near, tooth_sets, left_out: None });
        }
        let (mut near, mut count, mut of_near) = (vec![], 0, 0);
        self.bounds.each(&mut done, |teeth| {
            if !k.contains(&teeth.ring_to_sun_ratio()) {
                return;
            }
            count += 1;
            let [sun, ring] = [teeth.sun, teeth.ring].map(|teeth| f64::from(teeth.get()));
            if ways.iter().any(|way| way.is_near([sun, ring], allowed)) {
                of_near += 1;
                if of_near <= MOST_TOOTH_SETS {
                    near.push(teeth);
                }
            }
        })?;
        if of_near > MOST_TOOTH_SETS {
            return Err(Error::TooManyNear { tooth_sets: of_near, most: MOST_TOOTH_SETS });
        }
        let (near, left_out) = that_turn(&self.bounds, &near, |_| done(1.0))?;
        Ok(Nearby { near, tooth_sets: count, left_out })
    }
}

/// Shares `K_γ/N` of the tooth numbers that keep to limits of size.
fn fitting<'a>(
    teeth: &'a [ToothNumbers],
    measured: &Measured,
    size: SizeLimits,
    rating: &'a Rating,
) -> impl Iterator<Item = f64> + use<'a> {
    let cube = measured.cube.high;
    let of = move |teeth: &ToothNumbers| (rating.share(teeth.planets), *teeth);
    teeth
        .iter()
        .map(of)
        .filter(move |(share, teeth)| !size.are_any() || size.fits(cube * share, teeth))
        .map(|(share, _)| share)
}

impl Way {
    /// Coefficients at D and B, times the teeth of the sun: whole numbers.
    fn of_shafts(&self, [sun, ring]: [f64; 2]) -> [f64; 2] {
        let mut found = [0.0; 4];
        for (role, value) in self.set.into_iter().zip([sun, ring, -(sun + ring)]) {
            found[role.index()] = value;
        }
        [found[Role::D.index()], found[Role::B.index()]]
    }

    fn ratio_error(&self, [d, b]: [f64; 2]) -> f64 {
        (-b / d / self.wanted - 1.0).abs()
    }

    /// Whether the ratio is within tolerance.
    fn is_near(&self, teeth: [f64; 2], allowed: &Allowed) -> bool {
        self.ratio_error(self.of_shafts(teeth)) <= allowed.ratio_error
    }

    /// Measures it; `None` where a criterion is not met.
    fn measure(&self, level: &Level, allowed: &Allowed) -> Option<Measured> {
        let (teeth, [sun, _]) = (level.teeth, level.teeth);
        let [d, b] = self.of_shafts(teeth);
        // Speeds times the numerator of the ratio, -b.
        let mut above = [0.0; 4];
        (above[Role::D.index()], above[Role::B.index()]) = (-b, d);
        let speed = |x: Role, y: Role| ((above[x.index()] - above[y.index()]) / b).abs();
        let links = speed(Role::D, Role::T1).max(speed(Role::B, Role::T1));
        let [a, _, h] = self.set;
        let relative = above[a.index()] - above[h.index()];
        // The planet's speed over that of the sun, both relative to the carrier: `1/r`.
        let planets = (relative * (2.0 * sun) / (2.0 * level.planet * b)).abs();
        if links > allowed.link_speed || planets > allowed.planet_speed {
            return None;
        }
        if !self.direct_clutches.iter().any(|&[x, y]| speed(x, y) <= allowed.clutch_slip) {
            return None;
        }
        // Torque on the sun `sun/d`, speed relative to the carrier `relative/−b`.
        let exponent = if relative / (d * -b) > 0.0 { 1 } else { -1 };
        let loaded = exact::coefficients(self.set, teeth, exponent, self.eta0);
        let [over_d, over_b] = [Role::D, Role::B].map(|role| loaded[role.index()]);
        let efficiency = over_b * Double::from(d) / (over_d * Double::from(b));
        if efficiency.high < allowed.efficiency {
            return None;
        }
        let of_sun = loaded[a.index()];
        let cube = exact::cube(teeth, level.planet, level.working, (of_sun / over_d).abs());
        let ratio_error = self.ratio_error([d, b]);
        Some(Measured { efficiency, speed: links.max(planets), ratio_error, cube })
    }
}

impl Measured {
    /// Costs on the points of the grids where the exact values belong.
    fn costs(&self, level: &Level, share: f64) -> Costs {
        [
            exact::efficiency_cost(self.efficiency),
            on_grid(self.speed),
            on_grid(level.distance.value()),
            on_grid(self.ratio_error),
            exact::size_cost(self.cube * Double::from(share)),
        ]
    }
}

impl OneSetFound {
    /// Entries of the front, the best first by the search's order. Their members are for
    /// [`designs`](Self::designs).
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Numbers of designs; `tried` and `feasible` are ring-to-sun ratios in a way to use the set.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.counts
    }

    /// Tooth numbers of a set that are left out since a check of their teeth does not hold.
    #[must_use]
    pub fn left_out(&self) -> Option<&LeftOut> {
        self.left_out.as_deref()
    }

    /// The designs of an entry: all tooth numbers with its objectives.
    #[must_use]
    pub fn designs(&self, entry: &Entry) -> Vec<OneSetDesign> {
        entry.members.iter().filter_map(|&member| self.design(*self.points.get(member)?, entry)).collect()
    }

    fn design(&self, point: Point, entry: &Entry) -> Option<OneSetDesign> {
        let (way, level) = (&self.ways[point.way as usize], &self.levels[point.level as usize]);
        // The criteria were met before, so they are met again.
        let measured = way.measure(level, &Allowed::ANY)?;
        let fits = |teeth: &&ToothNumbers| {
            let share = self.rating.share(teeth.planets);
            let cube = measured.cube.high * share;
            (!self.size.are_any() || self.size.fits(cube, teeth))
                && Objectives::of_costs(measured.costs(level, share), None) == entry.objectives
        };
        let teeth = level.of(&self.tooth_sets).iter().filter(fits).copied().collect();
        Some(OneSetDesign { set: way.set, wanted: way.wanted, k: level.k, teeth })
    }
}
