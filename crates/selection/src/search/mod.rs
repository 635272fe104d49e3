//! Search over teeth: the exact Pareto front and the best designs for given ratios, with nothing missed.
//!
//! It covers all tooth numbers of both sets and all two-set structures. For two speeds [`OneSetSearch`]
//! covers all tooth numbers of one set and all ways to use it.
//!
//! # Why nothing is missed
//! 6.4·10⁷ pairs of tooth numbers for each structure, 111 structures, both orders and signs of the ratios
//! make 2.8·10¹⁰ designs. Designs are left out only for reasons that hold for each of them:
//!
//! 1. **Levels.** Objectives and criteria depend on `k₁`, `k₂`. Planet speeds and size also depend on the
//!    ratios of planet to sun `r₁`, `r₂`, and the size on the number of planets. Tooth numbers of one `k` and
//!    one `r` are one level, represented by the best share of planets. Others of the level are no better;
//!    equal ones are members of the same entry.
//! 2. **Reach.** A structure is left out if a ratio cannot come within tolerance, by the corners of the range
//!    of `k`. The ratio is a quotient of bilinear functions, monotonous in each between zeros and poles.
//! 3. **Windows.** For each `k₁` only an interval of `k₂` is tried. Outside it a ratio, a link speed or a
//!    planet speed breaks its limit: quotients of linear functions of `k₂`.
//! 4. **Drawing.** Structures that cannot be drawn without self-crossing are left out, and of the options for
//!    the direct-drive clutch those that cannot be drawn with the rest. The limits may lift this criterion.
//! 5. **Symmetry.** Six structures are their own mirror image under exchange of sets and brakes. Only one
//!    order of the ratios is tried for them: the other is the same design.
//!
//! All remaining designs are measured and judged in full. A design is on the front if no other dominates it
//! ([`epicyclic_numerics::front`]). Brute force over reduced ranges is the reference of tests and benches.
//!
//! # Sets with profile shift
//! With [`ToothSearch::shift`] the tooth numbers are those of sets that some shifts close without a fault,
//! found set by set before levels are made. Sets without an offset of the ring are closed in the same way.
//! With the default bounds and offsets of −3 to 3 there are 38 437 sets with 21 380 levels instead of 8016
//! with 2696, and 60 times as many pairs.
//!
//! # The first designs without the rest
//! A design that dominates another comes before it in any order of objectives. Whether a design before some
//! bound is on the front therefore depends only on the designs before that bound. [`ToothSearch::best`] need
//! not hold later designs, nor compute them to the point of the grid. The bound is the costs of a design,
//! first of a sample, then of those tried. It lies so far down their front that more entries than required
//! come before it. A first look (`screen`) decides for most pairs that they come after it and whether they
//! meet the criteria; all others are measured. If later designs dominate so many that fewer entries than
//! required remain, the search is repeated with a farther bound, at last without one. The result is therefore
//! that of the whole front; the bound only changes the time.
//!
//! # Equal designs
//! Objectives often do not depend on one of the sets, or do so through a product. Many designs therefore have
//! an objective in common, reached by different figures. Rounding must not separate them, or one would
//! dominate the other. Numerators and denominators of ratios and speeds are whole numbers, as teeth are. Only
//! the quotient is rounded, and equal ones are equal to the bit. The rounding of efficiencies and sizes is
//! bounded. Where it could lead to the next point of the grid of [objectives](crate::objectives), the value
//! is computed with twice the digits. The point is then that of the exact value, however it was computed.
//!
//! # Effort
//! For three speeds 0.76, 1.33, 1.95, tolerance 10 %, default limits, six of 432 patches have anything to
//! try, and 1.5·10⁶ pairs of ring-to-sun ratios are tried. 1.2·10⁶ meet the criteria, and of these 215 087
//! entries are on the front: five objectives over two ring-to-sun ratios leave many non-dominated designs.
//! Most dominated designs are dominated by neighbours within a strip and are left out at once. The first of
//! the front ([`ToothSearch::best`]) needs a sort.
//!
//! # Limits
//! The search refuses more than [`MOST_TOOTH_SETS`] combinations of tooth numbers for each set,
//! [`MOST_WINDOWS`] windows or [`MOST_PAIRS`] pairs of ring-to-sun ratios. All are counted before anything is
//! tried. Within these limits a search takes less than 1 GiB, since patches are tried one after another. If
//! more than 4·10⁶ designs are held, those that cannot be among the first entries ([`ToothSearch::best`]) or
//! that others dominate ([`ToothSearch::front`]) are left out. If too few would remain, the search is
//! refused; nothing is left out without a message.
//!
//! Results do not depend on the number of threads: work is divided by content and joined in order. With the
//! feature `parallel` (default) a `rayon::ThreadPool` around the search sets the number of threads.
//!
//! ```
//! use epicyclic_selection::search::ToothSearch;
//! use epicyclic_selection::Requirements;
//! use epicyclic_schemes::RatioSeries;
//! use epicyclic_gears::synthesis::Bounds;
//! # fn main() -> Result<(), epicyclic_selection::Error> {
//! let requirements = Requirements::new(RatioSeries::of_range(2.566, Some(1.466))?);
//! let mut search = ToothSearch::new(requirements);
//! search.bounds = Bounds { ring: 12..=80, ..Bounds::default() };
//! let found = search.best(3)?;
//! let best = found.entries()[0].clone();
//! assert!(best.objectives.efficiency > 0.98);
//! let design = &found.designs(&best)[0];
//! assert_eq!(design.structure.to_string(), "D.T1.B+T2.B.T1"); // which the source missed
//! # Ok(())
//! # }
//! ```

mod batches;
mod contenders;
mod double;
mod each;
mod exact;
mod found;
mod levels;
mod one_set;
mod patch;
mod screen;
mod shifted;
mod window;

pub use found::{Counts, Found, ToothDesign};
pub use one_set::{OneSetDesign, OneSetFound, OneSetSearch};

use crate::Error;
use crate::front::{Entry, front};
use crate::objectives::{Costs, Objective, Objectives, Order};
use crate::requirements::Requirements;
use batches::batches;
use contenders::{Bound, Contenders, first_of_front};
use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_gears::synthesis::{Bounds, ToothNumbers};
use epicyclic_numerics::front::non_dominated;
use epicyclic_numerics::threads::map;
use epicyclic_schemes::structures::Structure;
use found::{Point, SizeLimits};
use levels::levels;
use patch::{Allowed, Patch, Side};
use screen::{AT_ONCE, Columns, Screen, Verdict};
use std::ops::{ControlFlow, RangeInclusive};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use uom::si::f64::Length;

/// Progress of a search: pieces of work done, and all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Done.
    pub done: usize,
    /// Number of pieces.
    pub of: usize,
    /// Numbers of what is searched, 0 until counted; the number of feasible designs is 0 until the end.
    pub counts: Counts,
}

/// Called before anything is tried, and from any thread whenever a piece of work is done;
/// [`ControlFlow::Break`] cancels.
pub type Watch<'a> = dyn Fn(Progress) -> ControlFlow<()> + Sync + 'a;

/// Directions of rotation of the output that a search tries.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Directions {
    /// Directions that the requirements allow.
    #[default]
    Any,
    /// The output turns alike in all gears, direct drive among them.
    Same,
    /// The output turns backward in some gear.
    Mixed,
}

impl Directions {
    /// Whether the ratios of the braked gears belong to them.
    #[must_use]
    pub fn hold(self, ratios: &[f64]) -> bool {
        let mixed = ratios.iter().any(|ratio| *ratio < 0.0);
        match self {
            Self::Any => true,
            Self::Same => !mixed,
            Self::Mixed => mixed,
        }
    }
}

/// A search over teeth.
#[derive(Debug, Clone)]
pub struct ToothSearch {
    /// Requirements with two ratios.
    pub requirements: Requirements,
    /// Signs that are searched, of those that the requirements allow; by default all.
    pub directions: Directions,
    /// Structures to search, all 111 by default.
    pub structures: Vec<Structure>,
    /// Bounds of the tooth numbers of both sets.
    pub bounds: Bounds,
    /// Sets with profile shift in place of those without; `None` by default.
    pub shift: Option<ProfileShift>,
    /// Order of objectives by which entries are sorted. Circulating power, which is not compared here, must
    /// be last.
    pub order: Order,
    /// Module that each set needs at the load factor K, limits included.
    pub module: Option<RangeInclusive<Length>>,
    /// Greatest pitch diameter of a ring.
    pub ring_diameter: Option<Length>,
    /// The most designs held at a time, 52 bytes each, beside a batch of some 2·10⁶; 4·10⁶ by default.
    pub most_held: usize,
}

/// The most designs held at a time unless said otherwise.
const MOST_HELD: usize = 1 << 22;

/// The most combinations of tooth numbers of a set that a search takes.
pub const MOST_TOOTH_SETS: u64 = 1_000_000;

/// The most windows: ring-to-sun ratios times structures with their ratios.
pub const MOST_WINDOWS: u64 = 20_000_000;

/// The most pairs of ring-to-sun ratios that are tried, a minute or two of work.
pub const MOST_PAIRS: u64 = 1_000_000_000;

/// Share of the strips, and of the pairs in these, that are tried for a first bound: one in `SAMPLE`. If they
/// are more than some `SAMPLE_PAIRS`, fewer are tried.
const SAMPLE: usize = 8;
const SAMPLE_PAIRS: u64 = 1 << 15;

/// The most entries that are looked for before a bound.
const FEW: usize = 256;

/// Leaves out some of the designs held.
type Reduce<'a> = dyn FnMut(&mut Contenders) -> Result<(), Error> + 'a;

/// Refuses an order in which circulating power decides anything.
fn check_order(order: Order) -> Result<(), Error> {
    if order.objectives().ends_with(&[Objective::Circulation]) {
        Ok(())
    } else {
        Err(Error::NoObjectiveOfTeeth { objective: Objective::Circulation })
    }
}

impl ToothSearch {
    /// Search over all structures, with default tooth bounds and order and no limits of size.
    #[must_use]
    pub fn new(requirements: Requirements) -> Self {
        Self {
            requirements,
            directions: Directions::default(),
            structures: Structure::all(),
            bounds: Bounds::default(),
            shift: None,
            order: Order::default(),
            module: None,
            ring_diameter: None,
            most_held: MOST_HELD,
        }
    }

    /// The whole Pareto front, the best first by the order.
    ///
    /// # Errors
    /// Invalid bounds, limits and ratios, [`Error::RatioCount`] unless two ratios are
    /// wanted, [`Error::SizeWithoutTorque`], [`Error::NoObjectiveOfTeeth`].
    pub fn front(&self) -> Result<Found, Error> {
        self.front_watched(&|_| ControlFlow::Continue(()))
    }

    /// Front with reports of progress.
    ///
    /// # Errors
    /// Errors of [`front`](Self::front), and [`Error::Cancelled`].
    pub fn front_watched(&self, watch: &Watch) -> Result<Found, Error> {
        let mut found = self.prepared(watch)?;
        let held = self.each(&mut found, watch, None, &mut |held: &mut Contenders| {
            // A design on the front of all is also on the front of every part.
            held.keep(&non_dominated(&held.costs));
            let most = self.most_held / 4 * 3;
            if held.costs.len() > most {
                return Err(Error::FrontTooLarge { designs: held.costs.len(), most });
            }
            Ok(())
        })?;
        found.entries = front(&held.costs, self.order, |place| Objectives::of_costs(held.costs[place], None));
        found.points = held.points;
        Ok(found)
    }

    /// The first entries of the front, without the rest of it.
    ///
    /// In the order of objectives no design dominates an earlier one. So the designs are taken in this
    /// order, and each is on the front unless an entry before it dominates it.
    ///
    /// # Errors
    /// As [`front`](Self::front).
    pub fn best(&self, count: usize) -> Result<Found, Error> {
        self.best_watched(count, &|_| ControlFlow::Continue(()))
    }

    /// First entries of the front, with reports of progress.
    ///
    /// # Errors
    /// Errors of [`front_watched`](Self::front_watched).
    pub fn best_watched(&self, count: usize, watch: &Watch) -> Result<Found, Error> {
        self.best_of(self.prepared(watch)?, count, watch)
    }

    fn best_of(&self, mut found: Found, count: usize, watch: &Watch) -> Result<Found, Error> {
        let farther = if count <= FEW { &[[2, 12], [16, 100]][..] } else { &[] };
        for [times, more] in farther {
            let kept = times * count + more;
            if self.first_before(&Bound::new(self.order, kept), &mut found, count, watch)? {
                return Ok(found);
            }
        }
        // The first design in the order that was left out. All designs before it are held, and a design that
        // dominates another comes before it. Entries before it are therefore those of the whole front.
        let mut left_out: Option<Costs> = None;
        let held = self.each(&mut found, watch, None, &mut |held: &mut Contenders| {
            let first_out = held.first(self.most_held / 2, self.order);
            // Designs left out earlier may come before those left out now.
            if left_out.is_none_or(|before| self.order.compare(&first_out, &before).is_lt()) {
                left_out = Some(first_out);
            }
            Ok(())
        })?;
        found.entries = first_of_front(&held.costs, self.order, count);
        if let Some(left_out) = left_out {
            let before = |entry: &Entry| self.order.compare(&held.costs[entry.members[0]], &left_out).is_lt();
            found.entries.retain(before);
            if found.entries.len() < count {
                return Err(Error::FrontTooLarge { designs: count, most: found.entries.len() });
            }
        }
        found.points = held.points;
        Ok(found)
    }

    /// Finds the first entries without holding the rest, if possible. All designs before the bound are held,
    /// so entries before it are those of the whole front. Returns `false` if they are fewer than required.
    fn first_before(
        &self,
        bound: &Bound,
        found: &mut Found,
        count: usize,
        watch: &Watch,
    ) -> Result<bool, Error> {
        self.sample(found, bound);
        let most = self.most_held;
        let held = self.each(found, watch, Some(bound), &mut |held: &mut Contenders| {
            held.narrow_many(bound);
            if held.costs.len() > most {
                return Err(Error::FrontTooLarge { designs: held.costs.len(), most });
            }
            Ok(())
        });
        let held = match held {
            Err(Error::FrontTooLarge { .. }) => return Ok(false),
            held => held?,
        };
        let mut entries = first_of_front(&held.costs, self.order, count);
        entries.retain(|entry| bound.is_after(&held.costs[entry.members[0]]));
        if bound.costs().is_some() && entries.len() < count {
            return Ok(false);
        }
        // The other designs held depend on the bound, and the bound on the threads.
        for member in entries.iter_mut().flat_map(|entry| &mut entry.members) {
            found.points.push(held.points[*member]);
            *member = found.points.len() - 1;
        }
        found.entries = entries;
        Ok(true)
    }

    /// Brings the bound to where a few strips of all patches put it: otherwise it would be far off until the
    /// patch with the best designs is tried.
    fn sample(&self, found: &Found, bound: &Bound) {
        let mut gathered = Contenders::default();
        let pairs: u64 = found.patches.iter().map(|patch| Patch::pairs(&patch.strips)).sum();
        let step = SAMPLE.max((pairs / SAMPLE_PAIRS).isqrt() as usize);
        for (place, patch) in (0_u32..).zip(&found.patches) {
            let of_sample = |set: usize, level: u32| patch.side(set, &found.levels[level as usize]);
            for &[one, from, to] in patch.strips.iter().skip(step / 2).step_by(step) {
                let first = of_sample(0, one);
                for two in (from..to).step_by(step) {
                    let sides = [&first, &of_sample(1, two)];
                    self.try_pair(found, place, sides, [one, two], &mut |costs, point| {
                        gathered.gather(costs, point);
                    });
                }
            }
        }
        gathered.narrow(bound);
    }

    /// Levels, patches and windows: all that comes before trying.
    fn prepared(&self, watch: &Watch) -> Result<Found, Error> {
        self.requirements.check()?;
        check_order(self.order)?;
        let size = SizeLimits::new(self.module.as_ref(), self.ring_diameter, &self.requirements.rating)?;
        let (all, left_out) = shifted::all(&self.bounds, self.shift.as_ref(), |_| {
            watch(Progress { done: 0, of: 1, counts: Counts::default() })
        })?;
        let (count, counted) = (all.len(), all.len() as u64);
        let (levels, tooth_sets) =
            levels(all, &self.requirements.limits, &self.requirements.rating, self.shift.as_ref())?;
        let assignments = self.assignments()?;
        let of = assignments.len();
        if levels.len() as u64 * of as u64 > MOST_WINDOWS {
            return Err(Error::TooManyWindows {
                tooth_sets: counted,
                ring_to_sun_ratios: levels.len(),
                structures: of,
                most: MOST_WINDOWS,
            });
        }
        let patches = map(&assignments, |&(structure, ratios)| {
            Patch::new(structure, ratios, &self.requirements, &levels)
        });
        let patches: Vec<Patch> = patches.into_iter().flatten().collect();
        let pairs: u64 = patches.iter().map(|patch| Patch::pairs(&patch.strips)).sum();
        if pairs > MOST_PAIRS {
            return Err(Error::TooManyPairs {
                tooth_sets: counted,
                ring_to_sun_ratios: levels.len(),
                pairs,
                most: MOST_PAIRS,
            });
        }
        let counts = Counts {
            tooth_sets: count,
            levels: levels.len(),
            patches: of,
            patches_tried: patches.len(),
            designs: count as u128 * count as u128 * of as u128,
            tried: pairs,
            feasible: 0,
        };
        let allowed = Allowed::new(&self.requirements);
        let rating = self.requirements.rating.clone();
        let (entries, points) = (vec![], vec![]);
        Ok(Found { entries, points, patches, levels, tooth_sets, left_out, counts, size, allowed, rating })
    }

    /// Offers every pair of levels that meets the criteria to the contenders of its piece of work, and puts
    /// these together in the order of the pieces. Where more come together than are held, `reduce` leaves
    /// some out; what is not before the bound may be left out at any time.
    ///
    /// Patches are tried one after another and in batches of pairs, so that memory holds no more than a batch
    /// and the designs kept.
    fn each(
        &self,
        found: &mut Found,
        watch: &Watch,
        bound: Option<&Bound>,
        reduce: &mut Reduce,
    ) -> Result<Contenders, Error> {
        let batches: Vec<(u32, Vec<&[[u32; 3]]>)> = (0_u32..)
            .zip(&found.patches)
            .flat_map(|(place, patch)| batches(&patch.strips).into_iter().map(move |batch| (place, batch)))
            .collect();
        let of = batches.iter().map(|(_, pieces)| pieces.len()).sum();
        let counts = found.counts;
        let (cancelled, done) = (AtomicBool::new(false), AtomicUsize::new(0));
        if watch(Progress { done: 0, of, counts }).is_break() {
            return Err(Error::Cancelled);
        }
        let mut held = Contenders::default();
        let [mut tried, mut feasible] = [0, 0];
        let mut sides: Option<(u32, [Vec<Side>; 2], Columns)> = None;
        for (patch, pieces) in &batches {
            if sides.as_ref().is_none_or(|(of, ..)| of != patch) {
                drop(sides.take());
                let of_patch = found.patches[*patch as usize].sides(&found.levels);
                let columns = Columns::new(&of_patch[1], &found.levels);
                sides = Some((*patch, of_patch, columns));
            }
            let Some((_, sides, columns)) = &sides else { continue };
            let try_piece = |strips: &&[[u32; 3]]| {
                let mut gathered = Contenders::default();
                if cancelled.load(Ordering::Relaxed) {
                    return (gathered, [0, 0]);
                }
                let tried_and_met =
                    self.try_strips(found, *patch, (sides, columns), strips, bound, &mut gathered);
                let progress = Progress { done: done.fetch_add(1, Ordering::Relaxed) + 1, of, counts };
                if watch(progress).is_break() {
                    cancelled.store(true, Ordering::Relaxed);
                }
                (gathered, tried_and_met)
            };
            let results: Vec<(Contenders, [u64; 2])> = map(pieces, try_piece);
            if cancelled.load(Ordering::Relaxed) {
                return Err(Error::Cancelled);
            }
            for (gathered, counts) in results {
                (tried, feasible) = (tried + counts[0], feasible + counts[1]);
                held.costs.extend(gathered.costs);
                held.points.extend(gathered.points);
            }
            if held.costs.len() > self.most_held.max(4) || bound.is_some() {
                reduce(&mut held)?;
            }
        }
        (found.counts.tried, found.counts.feasible) = (tried, feasible);
        Ok(held)
    }

    /// Structures with the ratios of their gears, each design once.
    fn assignments(&self) -> Result<Vec<(Structure, [f64; 2])>, Error> {
        let mut targets: Vec<[f64; 2]> = vec![];
        for target in self.requirements.targets() {
            let [first, second] = target[..] else {
                return Err(Error::RatioCount { count: target.len() });
            };
            if self.requirements.allows_directions_of(&target) && self.directions.hold(&target) {
                targets.push([first, second]);
            }
        }
        let mut found = vec![];
        for &structure in &self.structures {
            for (place, &[first, second]) in targets.iter().enumerate() {
                let mirrored = structure.is_symmetric() && targets[..place].contains(&[second, first]);
                if !mirrored {
                    found.push((structure, [first, second]));
                }
            }
        }
        Ok(found)
    }

    /// Tries all pairs of some strips; how many there are, and how many meet the criteria.
    fn try_strips(
        &self,
        found: &Found,
        place: u32,
        (sides, columns): (&[Vec<Side>; 2], &Columns),
        strips: &[[u32; 3]],
        bound: Option<&Bound>,
        into: &mut Contenders,
    ) -> [u64; 2] {
        let Found { patches, levels, allowed, size, .. } = found;
        let patch = &patches[place as usize];
        let is_sized = size.are_any();
        let [mut tried, mut feasible] = [0, 0];
        for &[one, from, to] in strips {
            tried += u64::from(to - from);
            let earlier = into.costs.len();
            let bound_costs = bound.and_then(Bound::costs);
            let before =
                |costs: &Costs| bound_costs.is_none_or(|bound| self.order.compare(costs, &bound).is_lt());
            let screen = match &bound_costs {
                // Which shares fit the limits of size is known of what is measured alone.
                Some(bound) if !is_sized => Some(Screen::new(patch, columns, allowed, bound, self.order)),
                _ => None,
            };
            let mut verdicts = [Verdict::Open; AT_ONCE];
            for two in from..to {
                let pair = [one as usize, two as usize];
                let sides = [&sides[0][pair[0]], &sides[1][pair[1]]];
                let at = pair.map(|place| &levels[place]);
                if let Some(screen) = &screen {
                    let of_look = (two - from) as usize % AT_ONCE;
                    if of_look == 0 {
                        verdicts = screen.look(sides[0], at[0], pair[1]);
                    }
                    match verdicts[of_look] {
                        Verdict::Infeasible => continue,
                        Verdict::Behind => {
                            feasible += 1;
                            continue;
                        }
                        Verdict::Open => {}
                    }
                }
                let is_feasible = self.try_pair(found, place, sides, [one, two], &mut |costs, point| {
                    if bound.is_none() {
                        into.take(costs, point);
                    } else if before(&costs) {
                        into.gather(costs, point);
                    }
                });
                feasible += u64::from(is_feasible);
            }
            match bound {
                Some(bound) => into.narrow_many(bound),
                // Beside one set 1 costs change little from one set 2 to the next.
                None => into.thin(earlier),
            }
        }
        [tried, feasible]
    }

    /// Measures one pair of levels, and takes its costs if it meets the criteria; whether it does.
    #[inline]
    fn try_pair(
        &self,
        found: &Found,
        place: u32,
        sides: [&Side; 2],
        pair: [u32; 2],
        take: &mut impl FnMut(Costs, Point),
    ) -> bool {
        let Found { patches, levels, tooth_sets, allowed, size, .. } = found;
        let patch = &patches[place as usize];
        let places = pair.map(|place| place as usize);
        let Some(measured) = patch.measure(levels, places, sides, allowed) else { return false };
        let at = places.map(|place| &levels[place]);
        let mut shares = at.map(|level| level.share);
        if size.are_any() {
            let rating = &self.requirements.rating;
            shares = [0, 1].map(|set| {
                let share = |teeth: &ToothNumbers| rating.share(teeth.planets);
                let fits =
                    |teeth: &&ToothNumbers| size.fits(measured.cube(set, at[set], share(teeth)), teeth);
                at[set].of(tooth_sets).iter().filter(fits).map(share).fold(f64::INFINITY, f64::min)
            });
            if shares.iter().any(|share| share.is_infinite()) {
                return false;
            }
        }
        take(patch.costs(&measured, at, shares), Point { patch: place, levels: pair });
        true
    }
}
