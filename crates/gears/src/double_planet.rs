//! Tooth numbers of a double-planet set: sun, ring, and pairs of planets that mesh with each other.
//!
//! The *inner* planet of a pair meshes with the sun, the *outer* one with the ring. One carrier holds both.
//!
//! ```text
//! centres          R_g = (z_a + z_g)/2    R_f = (z_b − z_f)/2    d = (z_g + z_f)/2
//! triangle         R_f − R_g ≤ d                          is  z_b − z_a ≤ 2·(z_g + z_f)
//! angle of a pair  cos ψ = (R_g² + R_f² − d²)/(2·R_g·R_f)
//! inner and ring   z_b/2 − h_a* > R_g + z_g/2 + h_a* + s
//! outer and sun    R_f − z_f/2 − h_a* > z_a/2 + h_a* + s
//! inner planets    2·R_g·sin(γ/2) > z_g + 2·h_a* + s
//! outer planets    2·R_f·sin(γ/2) > z_f + 2·h_a* + s
//! inner and the next pair's outer
//!                  √(R_g² + R_f² − 2·R_g·R_f·cos(γ − ψ)) > d + 2·h_a* + s
//! assembly         (z_b − z_a)/N integer, for equal spacing γ = 2π/N
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `z_a`, `z_g`, `z_f`, `z_b` | teeth of sun, inner planet, outer planet, ring | 1 |
//! | `R_g`, `R_f` | radii of the centres of the inner and the outer planets | modules |
//! | `d` | distance of the centres of a pair | modules |
//! | `ψ` | angle from the inner planet of a pair to its outer one, about the main axis | rad |
//! | `N`, `γ` | number of pairs, the smallest angle between neighbouring pairs | 1, rad |
//! | `h_a*` | addendum coefficient | modules |
//! | `s` | required gap between tip circles of gears that do not mesh | modules |
//!
//! All gears have one module and no profile shift. In a simple set sun and ring fix the planet by
//! `z_b = z_a + 2·z_g`; here they only limit both planets by an inequality. `i₀ = +z_b/z_a` does not depend
//! on the planets.
//!
//! # Assembly
//! Move a pair by an angle `α` about the axis. From the pair, the sun then appears turned back by `z_a·α/2π`
//! teeth and the ring by `z_b·α/2π` teeth. To mesh with the sun again the inner planet turns by `z_a·α/2π`
//! teeth. The outer planet turns by the same number of teeth in the opposite direction, which is the
//! direction of the ring. The pair therefore fits again where the difference `(z_b − z_a)·α/2π` is an
//! integer: at `z_b − z_a` angles per turn. Equal spacing needs `(z_b − z_a)/N` to be an integer.
//!
//! # Fewer teeth clear better
//! If a pair fits, a pair with fewer teeth on either planet fits too, as long as the triangle closes. For the
//! conditions on one planet alone this is obvious. By the clearances to ring and sun both planets have fewer
//! than `(z_b − z_a)/2` teeth, so `R_f > R_g`. By the last clearance `ψ < γ/2`, since the planets of one pair
//! are nearer to each other than those of neighbouring pairs. Let `e` be the distance in the last clearance:
//!
//! - Fewer teeth on the outer planet move its centre on the ellipse `R_f + d = const` about the axis and the
//!   inner planet. It moves away from the next inner planet, which lies on the axis' side of the line through
//!   the pair: `e − d` rises.
//! - Fewer teeth on the inner planet move its centre on the hyperbola `R_g − d = const`. The direction is
//!   that of the bisector of the directions from the axis and from the outer planet. The previous outer
//!   planet lies outside the angle between them: `e − d` rises.
//!
//! The search for pairs that fit a sun, a ring and a number of pairs may therefore stop at the first that
//! does not fit.
//!
//! # Source
//! None of the documents: derived here. The tests place every gear by coordinates and turn every tooth.

use crate::Error;
use crate::involute::check::Check;
use crate::involute::left_out::LeftOut;
use crate::involute::plain::DoublePlanetMeshes;
use crate::mesh::{Gear, Mesh, TipCircle};
use crate::mode::Mode;
use crate::rack::BasicRack;
use crate::simple_set::{BasicRatio, Fraction};
use crate::spacing::PlanetSpacing;
use crate::synthesis::{Bounds, Placement, Ranked, Search};
use crate::teeth::ToothCount;
use crate::tolerance::TOUCH;
use epicyclic_units::Physical;
use std::fmt;
use std::ops::{ControlFlow, RangeInclusive};

/// Tooth numbers and number of planet pairs of a double-planet set that goes together.
///
/// ```
/// use epicyclic_gears::double_planet::DoublePlanetNumbers;
/// use epicyclic_gears::{ToothCount, rack::BasicRack};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let [sun, inner, outer, ring] = [31, 21, 21, 85].map(ToothCount::new);
/// let set = DoublePlanetNumbers { sun: sun?, inner: inner?, outer: outer?, ring: ring?, pairs: 3 };
/// assert!(set.fits(&BasicRack::default(), 0.0));
/// // 85 − 31 = 54 is no multiple of 4.
/// assert!(!DoublePlanetNumbers { pairs: 4, ..set }.fits(&BasicRack::default(), 0.0));
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DoublePlanetNumbers {
    /// Teeth of the sun, `z_a`.
    pub sun: ToothCount,
    /// Teeth of the ring, `z_b`.
    pub ring: ToothCount,
    /// Teeth of the planet in mesh with the sun, `z_g`.
    pub inner: ToothCount,
    /// Teeth of the planet in mesh with the ring, `z_f`.
    pub outer: ToothCount,
    /// Number of pairs of planets, `N`.
    pub pairs: u32,
}

/// Number of rings of one sun between two reports of progress.
const RINGS: u32 = 64;

/// Sun, inner planet, outer planet, ring and how many pairs: `31/21+21/85 ×3`.
impl fmt::Display for DoublePlanetNumbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}+{}/{} ×{}", self.sun, self.inner, self.outer, self.ring, self.pairs)
    }
}

/// Positions of the planets of a pair, in modules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// The inner planet, at `R_g`.
    pub inner: TipCircle,
    /// The outer planet, at `R_f`.
    pub outer: TipCircle,
    /// Angle `ψ` from the inner planet to the outer one about the main axis, in radians.
    pub angle_rad: f64,
}

impl Pair {
    /// Positions of a pair between a sun and a ring by the teeth of sun, inner planet, outer planet and ring.
    /// The teeth need not be whole numbers. `None` where no triangle has the sides `R_g`, `R_f` and `d`.
    #[must_use]
    pub fn of([sun, inner, outer, ring]: [f64; 4], rack: &BasicRack) -> Option<Self> {
        let circle = |mesh: Mesh, planet: f64| TipCircle {
            centre_radius: mesh.centre_distance(),
            tip_radius: Gear::external(planet).tip_radius(rack),
        };
        let of_inner = circle(Mesh::external(sun, inner), inner);
        let of_outer = circle(Mesh::internal(ring, outer), outer);
        let distance = Mesh::external(inner, outer).centre_distance();
        let (r1, r2) = (of_inner.centre_radius, of_outer.centre_radius);
        // Halves of whole numbers: exact.
        let closes = r2 > 0.0 && (r1 - r2).abs() <= distance && distance <= r1 + r2;
        closes.then(|| {
            let cosine = (r1 * r1 + r2 * r2 - distance * distance) / (2.0 * r1 * r2);
            Self { inner: of_inner, outer: of_outer, angle_rad: libm::acos(cosine.clamp(-1.0, 1.0)) }
        })
    }

    /// Whether `pairs` pairs at equal angles are clear of a sun and a ring with these teeth, and of each
    /// other, by more than `gap` modules.
    #[must_use]
    pub fn fits(&self, sun_and_ring: [f64; 2], pairs: u32, rack: &BasicRack, gap: f64) -> bool {
        let whole_rad = std::f64::consts::TAU / f64::from(pairs);
        self.clears(sun_and_ring, rack, gap, &Angle { whole_rad, half_sine: libm::sin(whole_rad / 2.0) })
    }

    fn clears(&self, [sun, ring]: [f64; 2], rack: &BasicRack, gap: f64, angle: &Angle) -> bool {
        let Self { inner, outer, angle_rad } = *self;
        let (sun, ring) = (Gear::external(sun).tip_radius(rack), Gear::internal(ring).tip_radius(rack));
        let gap = gap + TOUCH;
        ring - inner.centre_radius - inner.tip_radius > gap
            && outer.centre_radius - outer.tip_radius - sun > gap
            && inner.gap_to_alike(angle.half_sine) > gap
            && outer.gap_to_alike(angle.half_sine) > gap
            && inner.gap(outer, angle.whole_rad - angle_rad) > gap
    }
}

impl DoublePlanetNumbers {
    /// Ring-to-sun ratio `k = z_b/z_a`.
    #[must_use]
    pub fn ring_to_sun_ratio(&self) -> f64 {
        self.ring.as_f64() / self.sun.as_f64()
    }

    /// Basic ratio `+z_b/z_a`.
    #[must_use]
    pub fn basic_ratio(&self) -> BasicRatio {
        BasicRatio::double_planet(self.sun, self.ring)
    }

    /// The ratio of a mode, exactly, from `z_a·ω_a − z_b·ω_b − (z_a − z_b)·ω_H = 0`.
    ///
    /// ```
    /// use epicyclic_gears::simple_set::{Fraction, Member, Mode};
    /// use epicyclic_gears::synthesis::Bounds;
    /// # fn main() -> Result<(), epicyclic_gears::Error> {
    /// let bounds = Bounds { sun: 30..=30, ring: 80..=80, ..Bounds::default() };
    /// let set = bounds.double_planet_choices()?.0[0];
    /// // From the ring to the sun with the carrier at rest, and from the sun to the carrier.
    /// assert_eq!(set.exact_ratio(Mode::new(Member::Ring, Member::Sun)?), Fraction::new(3, 8));
    /// assert_eq!(set.exact_ratio(Mode::SUN_TO_CARRIER), Fraction::new(-5, 3));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn exact_ratio(&self, mode: Mode) -> Fraction {
        let (a, b) = (i128::from(self.sun.get()), i128::from(self.ring.get()));
        let factors = [a, -b, b - a];
        -Fraction::new(factors[mode.output() as usize], factors[mode.input() as usize])
    }

    /// The places of a pair; `None` where no triangle has the sides `R_g`, `R_f` and `d`.
    #[must_use]
    pub fn pair(&self, rack: &BasicRack) -> Option<Pair> {
        Pair::of([self.sun, self.inner, self.outer, self.ring].map(ToothCount::as_f64), rack)
    }

    /// Spacing of the pairs, as near to equal angles as assembly allows; `None` where the ring has no more
    /// teeth than the sun.
    #[must_use]
    pub fn spacing(&self) -> Option<PlanetSpacing> {
        PlanetSpacing::of_pairs(self.sun, self.ring, self.pairs)
    }

    /// Whether a set with pairs at equal angles goes together: the triangle closes, they assemble, and tip
    /// circles of gears that do not mesh are apart by more than `gap` modules.
    #[must_use]
    pub fn fits(&self, rack: &BasicRack, gap: f64) -> bool {
        self.spacing()
            .is_some_and(|spacing| spacing.is_equal() && self.clears(rack, gap, &Angle::of(&spacing)))
    }

    /// The triangle and all clearances.
    fn clears(&self, rack: &BasicRack, gap: f64, angle: &Angle) -> bool {
        let gears = [self.sun, self.ring].map(ToothCount::as_f64);
        self.pair(rack).is_some_and(|pair| pair.clears(gears, rack, gap, angle))
    }
}

/// A double-planet set that meets a target ratio, with its ratio, ratio error and number of choices.
#[derive(Debug, Clone, PartialEq)]
pub struct DoublePlanetCandidate {
    /// The teeth and the number of pairs.
    pub teeth: DoublePlanetNumbers,
    /// The ratio it has.
    pub ratio: f64,
    /// The ratio as a fraction.
    pub exact_ratio: Fraction,
    /// Relative error of the ratio, `i/i_wanted − 1`.
    pub ratio_error: f64,
    /// Number of choices of both planets and of the number of pairs for this sun and ring within the bounds,
    /// this one included. The choices close, assemble and clear each other; their teeth are not checked.
    pub choices: u64,
    /// Whether a rack would undercut the sun.
    pub undercut_sun: bool,
    /// Whether a rack would undercut the inner planets.
    pub undercut_inner: bool,
    /// Whether a rack would undercut the outer planets.
    pub undercut_outer: bool,
    /// Spacing of the pairs.
    pub spacing: PlanetSpacing,
}

/// The smallest angle between neighbouring pairs.
struct Angle {
    whole_rad: f64,
    half_sine: f64,
}

impl Angle {
    fn of(spacing: &PlanetSpacing) -> Self {
        Self { whole_rad: spacing.smallest_gap().si(), half_sine: spacing.half_gap_sine() }
    }
}

/// A set, and the check that its teeth do not pass.
type Missed = (DoublePlanetNumbers, Check<&'static str>);

/// Sun, ring and number of pairs at the angles where they assemble, and the bounds of their planets.
struct Frame<'a> {
    bounds: &'a Bounds,
    sun: ToothCount,
    ring: ToothCount,
    pairs: u32,
    angle: Angle,
}

impl<'a> Frame<'a> {
    /// Frame of the bounds; `None` where the pairs do not assemble.
    fn new(bounds: &'a Bounds, sun: ToothCount, ring: ToothCount, pairs: u32) -> Option<Self> {
        let spacing = PlanetSpacing::of_pairs(sun, ring, pairs)?;
        let is_placed = spacing.is_equal() || bounds.placement == Placement::LeastUnequal;
        is_placed.then(|| Self { bounds, sun, ring, pairs, angle: Angle::of(&spacing) })
    }

    /// The least teeth of the two planets together.
    fn together(&self) -> u32 {
        (self.ring.get() - self.sun.get()).div_ceil(2)
    }

    /// The teeth that a planet may have: fewer than half the difference of ring and sun.
    fn planets(&self) -> RangeInclusive<u32> {
        let most = ((self.ring.get() - self.sun.get()).div_ceil(2)).saturating_sub(1);
        *self.bounds.planet.start()..=most.min(*self.bounds.planet.end())
    }

    fn with(&self, inner: u32, outer: u32) -> Option<DoublePlanetNumbers> {
        let (inner, outer) = (ToothCount::new(inner).ok()?, ToothCount::new(outer).ok()?);
        let set = DoublePlanetNumbers { sun: self.sun, ring: self.ring, inner, outer, pairs: self.pairs };
        set.clears(&self.bounds.rack, self.bounds.tip_gap, &self.angle).then_some(set)
    }

    /// Sets of all planets that fit, ascending by the inner and the outer planet.
    fn all(&self) -> impl Iterator<Item = DoublePlanetNumbers> + '_ {
        let planets = self.planets();
        let (least, most) = (*planets.start(), *planets.end());
        planets.flat_map(move |inner| {
            let from = least.max(self.together().saturating_sub(inner));
            // After the first outer planet that does not fit no other fits.
            (from..=most).map_while(move |outer| self.with(inner, outer))
        })
    }

    /// Number of planets that fit, by halving: after the first that does not fit no other fits.
    fn count(&self) -> u64 {
        let planets = self.planets();
        let (least, most) = (*planets.start(), *planets.end());
        let of_inner = |inner: u32| {
            let from = least.max(self.together().saturating_sub(inner));
            let (mut low, mut high) = (from, (most + 1).max(from));
            while low < high {
                let middle = low.midpoint(high);
                if self.with(inner, middle).is_some() { low = middle + 1 } else { high = middle }
            }
            u64::from(low - from)
        };
        planets.map(of_inner).sum()
    }

    /// Planets that fit, in the order in which [`Bounds::double_planet_choices`] prefers them.
    fn by_preference(&self) -> impl Iterator<Item = DoublePlanetNumbers> + '_ {
        let planets = self.planets();
        let (least, most) = (*planets.start(), *planets.end());
        planets.rev().flat_map(move |smaller| {
            let from = smaller.max(self.together().saturating_sub(smaller)).max(least);
            let alike = move |larger: u32| {
                let outside = self.with(smaller, larger);
                let inside = (larger != smaller).then(|| self.with(larger, smaller)).flatten();
                // After the first larger planet that fits on neither side no other fits.
                (outside.is_some() || inside.is_some()).then_some([outside, inside])
            };
            (from..=most).map_while(alike).flatten().flatten()
        })
    }
}

impl Bounds {
    /// Every double-planet set within the bounds, ascending by sun, ring, number of pairs, inner and outer
    /// planet.
    ///
    /// The bounds of the planet apply to both planets, and the number of planets is that of the pairs.
    /// `tip_gap` is the gap between the tip circles of any gears that do not mesh.
    ///
    /// ```
    /// use epicyclic_gears::synthesis::Bounds;
    /// let bounds = Bounds { sun: 31..=31, ring: 85..=85, ..Bounds::default() };
    /// let all = bounds.double_planet_numbers()?;
    /// assert!(all.iter().any(|set| set.to_string() == "31/21+21/85 ×3"));
    /// # Ok::<(), epicyclic_gears::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`tooth_numbers`](Self::tooth_numbers).
    pub fn double_planet_numbers(&self) -> Result<Vec<DoublePlanetNumbers>, Error> {
        let mut found = Vec::new();
        self.each_sun_and_ring(|sun, ring| {
            let frames = self.planets.clone().filter_map(|pairs| Frame::new(self, sun, ring, pairs));
            frames.for_each(|frame| found.extend(frame.all()));
            Ok(())
        })?;
        Ok(found)
    }

    /// One choice of planets for each sun and ring within the bounds that some pairs of planets fit; the
    /// ratio does not depend on the planets.
    ///
    /// The choice has the most pairs, then the most teeth on the smaller planet, so that the planets turn as
    /// slowly as possible, then the fewest on the larger. Of two such choices the larger planet is outside.
    /// Of these the first whose teeth can be cut and turned together is taken. Pairs of sun and ring without
    /// such planets are left out, and counted.
    ///
    /// ```
    /// use epicyclic_gears::synthesis::Bounds;
    /// let (sets, left_out) = Bounds::default().double_planet_choices()?;
    /// assert_eq!((sets.len(), left_out), (7566, None));
    /// # Ok::<(), epicyclic_gears::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`tooth_numbers`](Self::tooth_numbers).
    pub fn double_planet_choices(&self) -> Result<(Vec<DoublePlanetNumbers>, Option<Box<LeftOut>>), Error> {
        let (mut found, mut left_out) = (Vec::new(), None);
        let mut meshes = DoublePlanetMeshes::new(&self.rack);
        self.each_sun_and_ring(|sun, ring| {
            match self.best_planets(sun, ring, &mut meshes)? {
                Ok(set) => found.push(set),
                Err(Some((set, check))) => LeftOut::add(&mut left_out, || set.to_string(), &check),
                Err(None) => {}
            }
            Ok(())
        })?;
        Ok((found, left_out))
    }

    /// Number of pairs of sun and ring with the target ratio that some planets fit, and the first `most` of
    /// them.
    ///
    /// Each has the planets of [`double_planet_choices`](Self::double_planet_choices). The most exact come
    /// first, equally exact ones by ring and sun. `done` receives the completed share of the bounds, from 0
    /// to 1; a break ends the search.
    ///
    /// ```
    /// use epicyclic_gears::synthesis::Bounds;
    /// use epicyclic_gears::simple_set::{Member, Mode};
    /// let ring_to_carrier = Mode::new(Member::Ring, Member::Carrier)?;
    /// let found = Bounds::default().double_planets_for_ratio(0.625, ring_to_carrier, 0.0, 1, |_|
    ///     std::ops::ControlFlow::Continue(()))?;
    /// assert_eq!(found.first[0].teeth.to_string(), "18/12+12/48 ×3");
    /// # Ok::<(), epicyclic_gears::Error>(())
    /// ```
    ///
    /// # Errors
    /// Errors of [`for_ratio`](Self::for_ratio); [`Error::Cancelled`].
    pub fn double_planets_for_ratio(
        &self,
        wanted: f64,
        mode: Mode,
        tolerance: f64,
        most: usize,
        mut done: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Ranked<DoublePlanetCandidate>, Error> {
        self.check()?;
        let mut search = Search::new(wanted, tolerance)?;
        let order = |one: &(f64, DoublePlanetNumbers), other: &(f64, DoublePlanetNumbers)| {
            let key = |(_, set): &(f64, DoublePlanetNumbers)| (set.ring, set.sun);
            one.0.abs().total_cmp(&other.0.abs()).then_with(|| key(one).cmp(&key(other)))
        };
        let mut held: Vec<(f64, DoublePlanetNumbers)> = Vec::new();
        let (mut found, mut left_out) = (0, None);
        let mut meshes = DoublePlanetMeshes::new(&self.rack);
        let suns = f64::from(self.sun.end() - self.sun.start()) + 1.0;
        let mut last = 0;
        self.each_sun_and_ring(|sun, ring| {
            if sun.get() != last || ring.get() % RINGS == 0 {
                last = sun.get();
                if done(f64::from(last - self.sun.start()) / suns).is_break() {
                    return Err(Error::Cancelled);
                }
            }
            let Ok(ratio) = BasicRatio::double_planet(sun, ring).ratio(mode) else { return Ok(()) };
            // A ratio that is farther off than the nearest known one needs no planets.
            if !search.is_near(ratio) && !search.is_nearer(ratio) {
                return Ok(());
            }
            let set = match self.best_planets(sun, ring, &mut meshes)? {
                Ok(set) => set,
                Err(Some((set, check))) if search.is_near(ratio) => {
                    LeftOut::add(&mut left_out, || set.to_string(), &check);
                    return Ok(());
                }
                Err(_) => return Ok(()),
            };
            if let Some(error) = search.take(ratio) {
                found += 1;
                held.push((error, set));
                if held.len() >= most.saturating_mul(2) {
                    held.select_nth_unstable_by(most, order);
                    held.truncate(most);
                }
            }
            Ok(())
        })?;
        let _ = done(1.0);
        if found == 0 {
            return Err(Error::NoDoublePlanetSet {
                wanted,
                mode,
                tolerance,
                nearest: search.nearest(),
                left_out,
            });
        }
        held.sort_by(order);
        held.truncate(most);
        let candidate = |(ratio_error, teeth): (f64, DoublePlanetNumbers)| {
            Some(DoublePlanetCandidate {
                teeth,
                ratio: teeth.basic_ratio().ratio(mode).ok()?,
                exact_ratio: teeth.exact_ratio(mode),
                ratio_error,
                choices: self.count_of_planets(teeth.sun, teeth.ring),
                undercut_sun: self.rack.undercuts(teeth.sun),
                undercut_inner: self.rack.undercuts(teeth.inner),
                undercut_outer: self.rack.undercuts(teeth.outer),
                spacing: teeth.spacing()?,
            })
        };
        Ok(Ranked { found, left_out, first: held.into_iter().filter_map(candidate).collect() })
    }

    /// The planets that are chosen for a sun and a ring; in place of them the first that fit, and the check
    /// that their teeth do not pass.
    fn best_planets(
        &self,
        sun: ToothCount,
        ring: ToothCount,
        meshes: &mut DoublePlanetMeshes,
    ) -> Result<Result<DoublePlanetNumbers, Option<Missed>>, Error> {
        let mut first = None;
        for frame in self.planets.clone().rev().filter_map(|pairs| Frame::new(self, sun, ring, pairs)) {
            for set in frame.by_preference() {
                match meshes.miss([set.sun, set.inner, set.outer, set.ring])? {
                    None => return Ok(Ok(set)),
                    Some(check) => first = first.or(Some((set, check))),
                }
            }
        }
        Ok(Err(first))
    }

    /// Number of choices of planets and of pairs that fit a sun and a ring.
    fn count_of_planets(&self, sun: ToothCount, ring: ToothCount) -> u64 {
        let frames = self.planets.clone().filter_map(|pairs| Frame::new(self, sun, ring, pairs));
        frames.map(|frame| frame.count()).sum()
    }

    /// Pairs of sun and ring in turn.
    fn each_sun_and_ring(
        &self,
        mut each: impl FnMut(ToothCount, ToothCount) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.check()?;
        for sun in self.sun.clone() {
            for ring in self.ring.clone().filter(|ring| *ring > sun) {
                let (sun, ring) = (ToothCount::new(sun)?, ToothCount::new(ring)?);
                if self.ring_to_sun_ratio.contains(&(ring.as_f64() / sun.as_f64())) {
                    each(sun, ring)?;
                }
            }
        }
        Ok(())
    }
}
