//! Search for tooth numbers of an arrangement: *every* set within bounds that has a ratio.
//!
//! All gears but one planet step and its central gear are gone through, and the doubled centre distance of
//! these two; of a Ravigneaux set all but the small sun and its planet. One tooth number `t` is left. With
//! the ratio in the form
//!
//! ```text
//! i = N/D       F(t, w) = N·P − w·D·P        P > 0 the product of the denominators of both speeds
//! ```
//!
//! `F` is linear in `t`. A ratio is between the ends `w_1` and `w_2` of the tolerance where
//! `F(t, w_1)·F(t, w_2) ≤ 0`. The zeros of both therefore bound the pieces in which `t` lies. Every `t` in such
//! a piece and beside a zero is tried by its exact ratio: rounding loses none.

use super::bounds::ArrangementBounds;
use super::numbers::{ArrangedTeeth, ModuleRatio, least_angle_rad};
use super::shifts::{ArrangedShifts, Choices, Spot};
use super::{Arrangement, ArrangementMode, MOST_GEARS};
use crate::error::Error;
use crate::involute::check::Check;
use crate::involute::left_out::LeftOut;
use crate::involute::plain::{Places, pair_miss};
use crate::nearest::Search;
use crate::quantity::SimpleGear;
use crate::simple_set::Fraction;
use crate::synthesis::{Placement, Ranked};
use crate::tolerance::{BESIDE, TOUCH, WITHIN};
use epicyclic_units::Physical;
use std::collections::BTreeMap;
use std::ops::{ControlFlow, RangeInclusive};

/// Set that meets a target ratio, with its ratio and ratio error.
#[derive(Debug, Clone, PartialEq)]
pub struct ArrangedCandidate {
    /// Tooth numbers and number of planets.
    pub teeth: ArrangedTeeth,
    /// Exact ratio.
    pub exact_ratio: Fraction,
    /// Ratio.
    pub ratio: f64,
    /// Relative error of the ratio, `i/i_wanted − 1`.
    pub ratio_error: f64,
    /// Profile shifts; `None` where equal centre distances need none.
    pub shifts: Option<ArrangedShifts>,
}

impl ArrangementBounds {
    /// Number of sets with a ratio within `tolerance` (relative) of `wanted`, and the first `most` of them:
    /// the most exact first, equally exact ones by size, then by teeth and number of planets.
    ///
    /// `done` receives the completed share of the bounds, from 0 to 1; a break ends the search.
    ///
    /// ```
    /// use epicyclic_gears::arrangement::{Arrangement, ArrangementBounds};
    /// use epicyclic_gears::synthesis::Bounds;
    /// use std::ops::ControlFlow;
    /// # fn main() -> Result<(), epicyclic_gears::Error> {
    /// let bounds = ArrangementBounds::of(Arrangement::Wolfrom, &Bounds::default());
    /// let mode = Arrangement::Wolfrom.mode("ae^b");
    /// let found = bounds.for_ratio(51.0, mode.unwrap(), 0.0, 1000, |_| ControlFlow::Continue(()))?;
    /// assert!(found.first.iter().any(|set| set.teeth.to_string() == "32/34/100/30/96 ×3"));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::NoTeeth`], [`Error::ToothRange`], [`Error::PlanetNumber`], [`Error::PlanetAngles`],
    /// [`Error::ModuleRatio`], [`Error::RingOffset`],
    /// [`Error::Negative`] for invalid bounds; [`Error::Tolerance`], [`Error::Ratio`];
    /// [`Error::NoArrangement`]; [`Error::Cancelled`].
    pub fn for_ratio(
        &self,
        wanted: f64,
        mode: ArrangementMode,
        tolerance: f64,
        most: usize,
        mut done: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Ranked<ArrangedCandidate>, Error> {
        self.check()?;
        let mut run = Run::new(self, wanted, mode, tolerance, most)?;
        run.all(&mut done)?;
        if run.found == 0 {
            let nearest = self.nearest(wanted, mode, tolerance, &mut done)?;
            let (arrangement, left_out) = (self.arrangement, run.left_out);
            return Err(Error::NoArrangement { arrangement, wanted, mode, tolerance, nearest, left_out });
        }
        run.rank();
        let candidate = |held: Held| {
            let exact_ratio = held.teeth.ratio(mode)?;
            Some(ArrangedCandidate {
                teeth: held.teeth,
                exact_ratio,
                ratio: as_f64(exact_ratio),
                ratio_error: held.error,
                shifts: held.shifts,
            })
        };
        let first = run.held.into_iter().filter_map(candidate).collect();
        Ok(Ranked { found: run.found, first, left_out: run.left_out })
    }

    /// Nearest ratio within the first factor of the target that holds any set.
    fn nearest(
        &self,
        wanted: f64,
        mode: ArrangementMode,
        tolerance: f64,
        done: &mut impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<f64>, Error> {
        for factor in FACTORS {
            let ends = [wanted / factor, wanted * factor];
            let run = Run::new(self, wanted, mode, tolerance, 0)?;
            let mut run = Run { ends, is_wide: true, ..run };
            run.all(done)?;
            if run.search.nearest().is_some() {
                return Ok(run.search.nearest());
            }
        }
        Ok(None)
    }
}

/// Factors off a ratio that no set has, within which the nearest one is looked for.
const FACTORS: [f64; 5] = [1.1, 2.0, 10.0, 1e3, 1e9];

fn as_f64(ratio: Fraction) -> f64 {
    *ratio.numer() as f64 / *ratio.denom() as f64
}

/// Set found, with what orders it.
struct Held {
    error: f64,
    size: f64,
    teeth: ArrangedTeeth,
    shifts: Option<ArrangedShifts>,
}

impl Held {
    fn order(&self, other: &Self) -> std::cmp::Ordering {
        let error = self.error.abs().total_cmp(&other.error.abs());
        error.then(self.size.total_cmp(&other.size)).then(self.teeth.cmp(&other.teeth))
    }
}

/// A mesh by its place and its teeth.
type MeshKey = (usize, [u32; 2]);

/// Search under way.
struct Run<'a> {
    bounds: &'a ArrangementBounds,
    mode: ArrangementMode,
    search: Search,
    /// Ends of the tolerance, a rounding wider.
    ends: [f64; 2],
    /// Whether every ratio between the ends counts.
    is_wide: bool,
    most: usize,
    held: Vec<Held>,
    found: u64,
    left_out: Option<Box<LeftOut>>,
    /// Meshes without profile shift.
    meshes: BTreeMap<MeshKey, Option<Check<Spot>>>,
    choices: Choices,
}

impl<'a> Run<'a> {
    fn new(
        bounds: &'a ArrangementBounds,
        wanted: f64,
        mode: ArrangementMode,
        tolerance: f64,
        most: usize,
    ) -> Result<Self, Error> {
        let search = Search::new(wanted, tolerance)?;
        let off = tolerance + WITHIN;
        let ends = [wanted * (1.0 - off), wanted * (1.0 + off)];
        let (held, meshes) = (vec![], BTreeMap::new());
        let is_wide = false;
        let choices = Choices::new(bounds.rack, bounds.aim, bounds.limits);
        Ok(Self {
            bounds,
            mode,
            search,
            ends,
            is_wide,
            most,
            held,
            found: 0,
            left_out: None,
            meshes,
            choices,
        })
    }

    fn range(&self, gear: usize) -> RangeInclusive<u32> {
        self.bounds.teeth[gear].clone()
    }

    /// Goes through the sets, ascending by the gear that is gone through first.
    fn all(&mut self, done: &mut impl FnMut(f64) -> ControlFlow<()>) -> Result<(), Error> {
        let arrangement = self.bounds.arrangement;
        let outer = if arrangement == Arrangement::Ravigneaux { 3 } else { 0 };
        let range = self.range(outer);
        let (from, all) = (*range.start(), f64::from(range.end() - range.start()) + 1.0);
        for teeth in range {
            match arrangement {
                Arrangement::Ravigneaux => self.ravigneaux(teeth)?,
                Arrangement::ExternalPair | Arrangement::InternalPair => self.pair(teeth)?,
                _ => self.steps(teeth)?,
            }
            if done(f64::from(teeth - from + 1) / all).is_break() {
                return Err(Error::Cancelled);
            }
        }
        Ok(())
    }

    /// Sets with a stepped planet that have this first central gear.
    fn steps(&mut self, central: u32) -> Result<(), Error> {
        let arrangement = self.bounds.arrangement;
        let (gears, meshes) = (arrangement.gears(), arrangement.meshes());
        let first_is_ring = gears[0].role == SimpleGear::Ring;
        let [step, last] = [gears.len() - 2, gears.len() - 1];
        let last_is_ring = meshes[meshes.len() - 1] == [step, last];
        let offsets = self.bounds.offsets.clone();
        for planet in self.range(1) {
            let doubled = if first_is_ring {
                i64::from(central) - i64::from(planet)
            } else {
                i64::from(central) + i64::from(planet)
            };
            if doubled <= 0 {
                continue;
            }
            // Teeth of a Wolfrom set's first ring; of the others none.
            let rings: Vec<u32> = if arrangement == Arrangement::Wolfrom {
                let of = |offset| u32::try_from(doubled + i64::from(planet) + i64::from(offset)).ok();
                offsets.clone().filter_map(of).filter(|ring| self.bounds.teeth[2].contains(ring)).collect()
            } else {
                vec![0]
            };
            for ring in rings {
                let mut teeth = [0; MOST_GEARS];
                (teeth[0], teeth[1], teeth[2]) = (central, planet, ring);
                for module_ratio in self.bounds.module_ratios.clone() {
                    let (over, under) = (i64::from(*module_ratio.numer()), i64::from(*module_ratio.denom()));
                    let [low, high] = [*offsets.start(), *offsets.end()].map(|end| doubled + i64::from(end));
                    let from =
                        (low * under).div_euclid(over) + i64::from((low * under).rem_euclid(over) != 0);
                    let to = (high * under).div_euclid(over);
                    for distance in from.max(1)..=to {
                        let of_step =
                            |step: i64| if last_is_ring { distance + step } else { distance - step };
                        let [low, high] =
                            [self.range(last).start(), self.range(last).end()].map(|&end| i64::from(end));
                        let steps = if last_is_ring {
                            low - distance..=high - distance
                        } else {
                            distance - high..=distance - low
                        };
                        let own = self.range(step);
                        let steps = (*steps.start()).max(i64::from(*own.start()))
                            ..=(*steps.end()).min(i64::from(*own.end()));
                        let at = |t: f64| {
                            let mut all = teeth.map(f64::from);
                            all[step] = t;
                            all[last] = if last_is_ring { distance as f64 + t } else { distance as f64 - t };
                            all
                        };
                        for t in self.near(steps, at) {
                            let mut teeth = teeth;
                            (teeth[step], teeth[last]) = (t as u32, of_step(t) as u32);
                            self.see(teeth, module_ratio)?;
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Ravigneaux sets with this large sun.
    fn ravigneaux(&mut self, large: u32) -> Result<(), Error> {
        for long in self.range(2) {
            for offset in self.bounds.offsets.clone() {
                let Some(ring) = (large + 2 * long).checked_add_signed(offset) else { continue };
                if !self.range(4).contains(&ring) {
                    continue;
                }
                let at = |t: f64| [t, 1.0, f64::from(long), f64::from(large), f64::from(ring)];
                let smalls = self.range(0);
                for small in self.near(i64::from(*smalls.start())..=i64::from(*smalls.end()), at) {
                    let small = small as u32;
                    let [least, most] = self.short_planets([small, 0, long, large, ring]);
                    let shorts = self.range(1);
                    for short in least.max(*shorts.start())..=most.min(*shorts.end()) {
                        self.see([small, short, long, large, ring], ModuleRatio::from(1))?;
                    }
                }
            }
        }
        Ok(())
    }

    /// Pairs with this first gear.
    fn pair(&mut self, first: u32) -> Result<(), Error> {
        let seconds = self.range(1);
        let at = |t: f64| [f64::from(first), t, 1.0, 1.0, 1.0];
        for second in self.near(i64::from(*seconds.start())..=i64::from(*seconds.end()), at) {
            self.see([first, second as u32, 0, 0, 0], ModuleRatio::from(1))?;
        }
        Ok(())
    }

    /// Whole numbers `t` in a range at which the ratio of gears with the teeth `at(t)` may be within the
    /// tolerance, ascending.
    fn near(&self, range: RangeInclusive<i64>, at: impl Fn(f64) -> [f64; MOST_GEARS]) -> Vec<i64> {
        let (low, high) = (*range.start(), *range.end());
        // The first term of `F`, and the second without `w`.
        let terms = |t: f64| {
            let teeth = at(t);
            let [[n_in, d_in], [n_out, d_out], [n_x, d_x]] = self.mode.members().map(|member| {
                member.gear().map_or([0.0, 1.0], |gear| self.bounds.arrangement.speed(gear, &teeth))
            });
            [(n_in * d_x - n_x * d_in) * d_out, (n_out * d_x - n_x * d_out) * d_in]
        };
        let [from, to] = [low as f64 - 1.0, high as f64 + 1.0];
        let mut zeros = vec![];
        if low <= high {
            let (first, last) = (terms(from), terms(to));
            for w in self.ends {
                let [first, last] = [first, last].map(|[over, under]| over - w * under);
                let zero = from + (to - from) * first / (first - last);
                if zero >= from && zero <= to {
                    zeros.push(zero);
                }
            }
            zeros.sort_by(f64::total_cmp);
        }
        let whole = |from: f64, to: f64| (from - BESIDE).floor() as i64..=(to + BESIDE).ceil() as i64;
        let mut pieces: Vec<RangeInclusive<i64>> = zeros.iter().map(|zero| whole(*zero, *zero)).collect();
        let edges: Vec<f64> = [from].into_iter().chain(zeros).chain([to]).collect();
        for edge in edges.windows(2) {
            let [over, under] = terms(edge[0].midpoint(edge[1]));
            let [one, other] = self.ends.map(|w| over - w * under);
            let least = BESIDE * (over.abs() + self.ends[1].abs() * under.abs());
            if one * other <= 0.0 || one.abs() <= least || other.abs() <= least {
                pieces.push(whole(edge[0], edge[1]));
            }
        }
        pieces.sort_by_key(|piece| *piece.start());
        let (mut next, mut all) = (low, vec![]);
        for piece in pieces {
            all.extend(next.max(*piece.start())..=high.min(*piece.end()));
            next = next.max(*piece.end() + 1);
        }
        all
    }

    /// Sets with these teeth, for every number of planets.
    fn see(&mut self, teeth: [u32; MOST_GEARS], module_ratio: ModuleRatio) -> Result<(), Error> {
        let bounds = self.bounds;
        let set = ArrangedTeeth { arrangement: bounds.arrangement, teeth, module_ratio, planets: 1 };
        let Some(ratio) = set.ratio(self.mode).map(as_f64) else { return Ok(()) };
        let is_near = if self.is_wide {
            self.ends[0] * ratio > 0.0 && self.search.is_nearer(ratio)
        } else {
            self.search.is_near(ratio)
        };
        if !is_near || bounds.arrangement == Arrangement::Stepped && set.has_one_step() {
            return Ok(());
        }
        let stated = bounds.angles.len() as u32;
        let planets = match stated {
            _ if bounds.arrangement.is_pair() => 1..=1,
            0 => bounds.planets.clone(),
            stated => stated..=stated,
        };
        if set.is_coaxial() { self.plain(set, ratio, planets) } else { self.shifted(set, ratio, planets) }
    }

    /// Sets without profile shift, for every number of planets.
    fn plain(
        &mut self,
        mut set: ArrangedTeeth,
        ratio: f64,
        planets: RangeInclusive<u32>,
    ) -> Result<(), Error> {
        let mut miss: Option<Option<Check<Spot>>> = None;
        for planets in planets {
            set.planets = planets;
            if !self.is_placed(&set) || !self.is_apart(&set) {
                continue;
            }
            let miss = match miss {
                Some(known) => known,
                None => *miss.insert(match self.miss(&set)? {
                    Ok(found) => found,
                    Err(Undercut) => return Ok(()),
                }),
            };
            match miss {
                Some(check) => LeftOut::add(&mut self.left_out, || set.to_string(), &check),
                None => self.take(set, ratio, None),
            }
        }
        Ok(())
    }

    /// Sets with profile shift, for every number of planets. Without a choice of shifts a set is left out if
    /// its gears would be apart without shift; else it is none.
    fn shifted(
        &mut self,
        mut set: ArrangedTeeth,
        ratio: f64,
        planets: RangeInclusive<u32>,
    ) -> Result<(), Error> {
        let bounds = self.bounds;
        let mut choice = None;
        for planets in planets {
            set.planets = planets;
            if !self.is_placed(&set) {
                continue;
            }
            let is_apart = self.is_apart(&set);
            let Some(neighbours) = self.neighbours_rad(&set) else { continue };
            if !is_apart && !set.may_clear(&bounds.rack, bounds.tip_gap, neighbours) {
                continue;
            }
            match choice.get_or_insert_with(|| self.choices.of(&set)) {
                Err(check) if is_apart => LeftOut::add(&mut self.left_out, || set.to_string(), check),
                Err(_) => {}
                Ok(choice) => {
                    let gap = self.choices.gap(&set, choice, neighbours);
                    if gap.is_some_and(|gap| gap > bounds.tip_gap + TOUCH) {
                        let shifts = choice.shifts;
                        self.take(set, ratio, Some(shifts));
                    }
                }
            }
        }
        Ok(())
    }

    fn take(&mut self, set: ArrangedTeeth, ratio: f64, shifts: Option<ArrangedShifts>) {
        let Some(error) = self.search.take(ratio) else { return };
        self.found += 1;
        self.held.push(Held { error, size: set.size(), teeth: set, shifts });
        if self.held.len() >= self.most.saturating_mul(2).max(1) {
            self.rank();
        }
    }

    /// Whether all meshes have centre distances, and the planets can be put in at their angles.
    fn is_placed(&self, set: &ArrangedTeeth) -> bool {
        let bounds = self.bounds;
        let is_placed = || match bounds.angles.is_empty() {
            true => set
                .spacing()
                .is_some_and(|spacing| spacing.is_equal() || bounds.placement == Placement::LeastUnequal),
            false => set.assembles_at(&bounds.angles),
        };
        set.has_centres() && (set.arrangement.is_pair() || is_placed())
    }

    /// Least angle between neighbouring planets, in rad; `None` of a pair.
    fn neighbours_rad(&self, set: &ArrangedTeeth) -> Option<f64> {
        if self.bounds.angles.is_empty() {
            return Some(set.spacing()?.smallest_gap().si());
        }
        least_angle_rad(&self.bounds.angles)
    }

    /// Whether gears that do not mesh are apart without profile shift.
    fn is_apart(&self, set: &ArrangedTeeth) -> bool {
        let bounds = self.bounds;
        let gap = || match bounds.angles.is_empty() {
            true => set.planet_gap(&bounds.rack),
            false => set.gap_at(&bounds.rack, &bounds.angles),
        };
        set.arrangement.is_pair() || gap().is_some_and(|gap| gap > bounds.tip_gap + TOUCH)
    }

    /// The first check of the meshes without profile shift that does not hold and is an error; [`Undercut`]
    /// where the bounds exclude the set.
    fn miss(&mut self, set: &ArrangedTeeth) -> Result<Result<Option<Check<Spot>>, Undercut>, Error> {
        let rack = &self.bounds.rack;
        let gears = set.arrangement.gears();
        if self.bounds.no_undercut && (0..gears.len()).any(|gear| set.is_undercut(gear, rack)) {
            return Ok(Err(Undercut));
        }
        for (place, &mesh) in set.arrangement.meshes().iter().enumerate() {
            let key = (place, mesh.map(|gear| set.teeth[gear]));
            let miss = match self.meshes.get(&key) {
                Some(known) => *known,
                None => {
                    let [one, other] = mesh.map(|gear| gears[gear]);
                    let places = Places {
                        gears: [Spot::Gear(one), Spot::Gear(other)],
                        mesh: Spot::Mesh([one, other]),
                        tips: [Spot::Tips([one, other]), Spot::Tips([other, one])],
                    };
                    let miss = pair_miss(set.gears_of_mesh(mesh, rack), &places, true)?;
                    self.meshes.insert(key, miss);
                    miss
                }
            };
            if miss.is_some() {
                return Ok(Ok(miss));
            }
        }
        Ok(Ok(None))
    }

    /// Least and most teeth of a short planet between these gears, whose place is 0: it reaches the long
    /// one, and stays inside the ring. With profile shift those that may do so with any shifts count too.
    ///
    /// ```text
    /// R_f − R_g ≤ d               is  z_g ≥ (z_c + z_b)/4 − (z_a + z_f)/2
    /// R_g + z_g/2 < z_b/2         is  z_g < (z_b − z_a)/2
    /// ```
    fn short_planets(&mut self, teeth: [u32; MOST_GEARS]) -> [u32; 2] {
        let [small, _, long, large, ring] = teeth;
        let least = (large + ring).saturating_sub(2 * (small + long)) / 4;
        let most = ring.saturating_sub(small).div_ceil(2);
        let set = ArrangedTeeth {
            arrangement: Arrangement::Ravigneaux,
            teeth,
            module_ratio: ModuleRatio::from(1),
            planets: 1,
        };
        if ring == large + 2 * long {
            return [least, most];
        }
        let with_shifts = self.choices.short_planets(&set);
        with_shifts.map_or([least, most], |[low, high]| [least.min(low), most.max(high)])
    }

    fn rank(&mut self) {
        self.held.sort_by(Held::order);
        self.held.truncate(self.most);
    }
}

/// Set that the bounds exclude for undercut.
struct Undercut;
