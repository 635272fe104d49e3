//! Six objectives, the Pareto front over them, and an order that picks the best.
//!
//! | objective | better | meaning |
//! |---|---|---|
//! | [`Efficiency`](Objective::Efficiency) | more | the least η over the braked gears |
//! | [`Speed`](Objective::Speed) | less | the largest \|ω\| of links, planets relative, over the input's |
//! | [`RingToSun`](Objective::RingToSun) | less | Σ distance of ln k from [ln 2.5, ln 3] |
//! | [`RatioError`](Objective::RatioError) | less | the largest relative error of a ratio |
//! | [`Size`](Objective::Size) | less | the largest ring diameter, [`size`](super::size) |
//! | [`Circulation`](Objective::Circulation) | less | the largest circulating power of a braked gear |
//!
//! Circulating power is taken over the power that enters. Objectives are not weighed against each other. One
//! design dominates another if no objective is worse and at least one is better; the front holds all designs
//! that no other dominates. Designs whose objectives are all equal are one entry. Equality is decided on a
//! grid of 2⁻⁴⁰ ≈ 10⁻¹². For the size the grid applies to its cube, relative; for the distance, a logarithm,
//! it applies to the ratio itself.
//!
//! The search over teeth knows the first five alone; there circulating power can have a limit.
//!
//! A grid alone does not decide equality. If a value lies half-way between two points, the last bit decides,
//! and it depends on the way the value was computed. The search over teeth therefore places each value where
//! its exact value belongs ([`search`](super::search)).

pub use super::objective::Objective;

use super::Error;
use super::tolerance::{GRID_END, GRID_SHIFT, RELATIVE_GRID};
use epicyclic_numerics::front::dominates;
use std::str::FromStr;

impl FromStr for Objective {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|objective| objective.name() == name).ok_or_else(|| {
            Error::UnknownObjective { name: name.into(), known: Self::ALL.map(Self::name).to_vec() }
        })
    }
}

/// An order of the objectives: the first decides, the next where it is equal, and so on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Order([Objective; Objective::ALL.len()]);

impl Order {
    /// Order of the given objectives, followed by the others in the order of [`Objective::ALL`].
    ///
    /// # Errors
    /// [`Error::RepeatedObjective`].
    pub fn new(first: &[Objective]) -> Result<Self, Error> {
        let mut all = first.to_vec();
        all.extend(Objective::ALL.into_iter().filter(|objective| !first.contains(objective)));
        if let Some(place) = (0..first.len()).find(|&place| first[..place].contains(&first[place])) {
            return Err(Error::RepeatedObjective { objective: first[place] });
        }
        all.try_into().map(Self).map_err(|_| unreachable!("each of them once"))
    }

    /// The objectives, the decisive one first.
    #[must_use]
    pub fn objectives(self) -> [Objective; Objective::ALL.len()] {
        self.0
    }

    /// Indices of `N` costs, the decisive one first.
    pub(crate) fn of_costs<const N: usize>(self) -> [usize; N] {
        let mut places = self.0.into_iter().map(|objective| objective as usize).filter(|place| *place < N);
        std::array::from_fn(|_| places.next().unwrap_or(0))
    }

    /// Compares two costs in this order, as far as both have entries.
    pub(crate) fn compare<const N: usize>(self, one: &[f64; N], other: &[f64; N]) -> std::cmp::Ordering {
        let by = |objective: &Objective| {
            let place = *objective as usize;
            one.get(place)
                .zip(other.get(place))
                .map_or(std::cmp::Ordering::Equal, |(one, other)| one.total_cmp(other))
        };
        self.0.iter().map(by).find(|found| found.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    }
}

impl Default for Order {
    /// Efficiency, speed, ring-to-sun ratio, error, size, circulation.
    fn default() -> Self {
        Self(Objective::ALL)
    }
}

/// Values of the objectives of a design.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Objectives {
    /// The least efficiency over the braked gears.
    pub efficiency: f64,
    /// The largest speed over the input's: of links, and of planets relative to their carriers.
    pub speed: f64,
    /// Σ distance of ln k from the preferred range.
    pub ring_to_sun: f64,
    /// The largest relative error of a ratio.
    pub ratio_error: f64,
    /// The largest ring's relative diameter; times [`Rating::unit`](super::size::Rating::unit) in metres.
    pub size: f64,
    /// The largest circulating power of a braked gear over the power that enters; `None` where it was not
    /// calculated, as in a search over teeth.
    pub circulation: Option<f64>,
}

/// Objectives as costs on the grid, in the order of [`Objective::ALL`]; smaller is better. The distance is
/// represented by `e` to its power, the size by its cube.
pub(crate) type AllCosts = [f64; Objective::ALL.len()];

/// The costs that a search over teeth knows: all but the last.
pub(crate) type Costs = [f64; Objective::ALL.len() - 1];

/// Rounds to a multiple of 2⁻⁴⁰; of more than 2¹¹ nothing is lost that could matter.
#[inline]
pub(crate) fn on_grid(value: f64) -> f64 {
    if value.abs() < GRID_END { (value + GRID_SHIFT) - GRID_SHIFT } else { value }
}

/// Rounds to 40 bits.
#[inline]
pub(crate) fn on_relative_grid(value: f64) -> f64 {
    let shifted = RELATIVE_GRID * value;
    shifted - (shifted - value)
}

impl Objectives {
    pub(crate) fn costs(&self) -> AllCosts {
        let cube = self.size * self.size * self.size;
        let [efficiency, speed, distance, error, circulation] = [
            -self.efficiency,
            self.speed,
            libm::exp(self.ring_to_sun),
            self.ratio_error,
            self.circulation.unwrap_or(0.0),
        ]
        .map(on_grid);
        [efficiency, speed, distance, error, on_relative_grid(cube), circulation]
    }

    pub(crate) fn of_costs(
        [efficiency, speed, distance, ratio_error, cube]: Costs,
        circulation: Option<f64>,
    ) -> Self {
        let ring_to_sun = libm::log(distance);
        Self { efficiency: -efficiency, speed, ring_to_sun, ratio_error, size: libm::cbrt(cube), circulation }
    }

    /// Whether this is nowhere worse than the other and somewhere better.
    #[must_use]
    pub fn dominates(&self, other: &Self) -> bool {
        dominates(&self.costs(), &other.costs())
    }
}

/// Distance of `ln k` from the preferred range.
#[inline]
pub(crate) fn ring_to_sun_distance(k: f64, low: f64, high: f64) -> f64 {
    if k < low {
        libm::log(low / k)
    } else if k > high {
        libm::log(k / high)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_names_each_once() {
        let order = Order::new(&[Objective::Size, Objective::Speed]).unwrap();
        let names = order.objectives().map(Objective::name);
        assert_eq!(names, ["size", "speed", "efficiency", "k", "error", "circulation"]);
        let twice = Order::new(&[Objective::Size, Objective::Size]);
        assert_eq!(twice, Err(Error::RepeatedObjective { objective: Objective::Size }));
        assert_eq!("error".parse(), Ok(Objective::RatioError));
        assert!(matches!("mass".parse::<Objective>(), Err(Error::UnknownObjective { .. })));
    }

    #[test]
    fn the_grid_is_finer_than_any_datum() {
        for value in [0.0, -0.977_614, 2.5, 1_234.567_89] {
            assert!((on_grid(value) - value).abs() <= 2f64.powi(-41), "{value}");
        }
        assert_eq!(on_grid(5000.1), 5000.1);
        assert_eq!(on_grid(0.1 + 0.2), on_grid(0.3));
        for value in [1.0, 18.123_456_789, 4_321.098_765] {
            let found = on_relative_grid(value);
            assert!((found / value - 1.0).abs() <= 2f64.powi(-40), "{value}");
            assert_eq!(found.to_bits() % (1 << 13), 0);
        }
    }
}
