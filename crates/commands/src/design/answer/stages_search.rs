//! Trains of each number of stages; with a limit of the length the lightest that a price of the length finds.
//!
//! The search adds a price of the length to the mass. The train found is the lightest of all that are no longer.
//! The price is raised until a train fits, then lowered by bisection to the least that suffices. A price λ proves:
//! no train within the limit `L_max` costs less than `min(P + λ·L) − λ·L_max`.

use super::stages_file::order;
use super::stages_wanted::WantedStages;
use crate::error::Error;
use epicyclic_strength::series::{Found, KnownSets, Order, Train, Trains, search};
use std::ops::{ControlFlow, RangeInclusive};

/// Searches with a price of the length, for each number of stages.
const MOST_PRICES: usize = 10;

/// Factor of the price as long as no train is short enough.
const DEARER: f64 = 8.0;

/// Highest price over mass by length of the free train: beyond it trains get no shorter.
const DEAREST: f64 = 512.0;

/// Width of the interval of the price, over its end, that is narrow enough.
const NARROW: f64 = 0.03;

/// Trains, with what was found of lengths.
pub(super) struct Searched {
    pub(super) found: Found,
    /// Price of the length at which the trains of each number of stages were found.
    pub(super) prices: Vec<f64>,
    /// Length of the shortest train above the limit, in m.
    pub(super) shortest: Option<f64>,
}

/// Stages beyond usual practice of the best train; `None` without a train.
pub(super) fn unusual(found: &Found) -> Option<u32> {
    found.all.iter().filter_map(|trains| trains.found.first()).map(|train| train.unusual_stages).min()
}

/// Searches the best trains of each number of stages within a tolerance, with so many stages beyond usual
/// practice at most.
pub(super) fn searched(
    wanted: &WantedStages,
    (tolerance, most_unusual): (f64, Option<u32>),
    most: usize,
    (known, goes_on): (&mut KnownSets, &dyn Fn() -> ControlFlow<()>),
) -> Result<Searched, Error> {
    let mut of = |stages: RangeInclusive<usize>, length_price: f64| {
        let mut order = Order { most_unusual, ..order(wanted, tolerance, stages)? };
        let pair = order.first_pair.as_mut().map(|pair| &mut pair.of_pair);
        for sizing in [&mut order.of_stage].into_iter().chain(pair) {
            sizing.space.length_price = length_price;
        }
        Ok::<_, Error>(search(&order, most, known, goes_on)?)
    };
    if !wanted.is_of_output && wanted.limits.length_m.is_none() {
        let found = of(wanted.stages.clone(), 0.0)?;
        let prices = vec![0.0; found.all.len()];
        return Ok(Searched { found, prices, shortest: None });
    }
    // More stages lose more, so each number of them has its own torque on the input, and its own price.
    let mut all = Searched { found: Found { sets: 0, all: vec![] }, prices: vec![], shortest: None };
    for stages in wanted.stages.clone() {
        let mut at = |price| of(stages..=stages, price);
        let free = at(0.0)?;
        all.found.sets = all.found.sets.max(free.sets);
        let (mut trains, mut price, mut shortest) = (free.all, 0.0, None);
        if let Some(most) = wanted.limits.length_m {
            for own in &mut trains {
                (price, shortest) = shortened(own, most, &mut at)?;
            }
        }
        all.prices.extend(trains.iter().map(|_| price));
        all.shortest = all.shortest.into_iter().chain(shortest).reduce(f64::min);
        all.found.all.extend(trains);
    }
    Ok(all)
}

/// Replaces the trains by those within a length. Returns the price of the length that finds them, and where none
/// is short enough the length of the shortest.
fn shortened(
    trains: &mut Trains,
    most: f64,
    at: &mut dyn FnMut(f64) -> Result<Found, Error>,
) -> Result<(f64, Option<f64>), Error> {
    let fits = |train: &Train| train.length_m <= most;
    let Some(free) = trains.found.first().cloned() else { return Ok((0.0, None)) };
    if fits(&free) {
        trains.found.retain(fits);
        return Ok((0.0, None));
    }
    trains.found.clear();
    let unit = free.mass_kg / free.length_m;
    let [mut low, mut high] = [0.0, unit];
    let (mut of_best, mut shortest) = (None, free.length_m);
    for _ in 0..MOST_PRICES {
        let price = if of_best.is_none() { high } else { f64::midpoint(low, high) };
        let Some(mut next) = at(price)?.all.into_iter().next() else { break };
        (trains.sized, trains.is_complete) =
            (trains.sized + next.sized, trains.is_complete && next.is_complete);
        let Some(train) = next.found.first().cloned() else { break };
        if fits(&train) {
            high = price;
            let cost = |of: &Train| (of.unusual_stages, of.price_kg);
            if trains.found.first().is_none_or(|best| cost(&train) < cost(best)) {
                next.found.retain(fits);
                (trains.found, of_best) = (next.found, Some(price));
            }
        } else {
            (low, shortest) = (price, shortest.min(train.length_m));
            if of_best.is_none() {
                if price >= DEAREST * unit {
                    break;
                }
                high *= DEARER;
            }
        }
        if of_best.is_some() && high - low < NARROW * high {
            break;
        }
    }
    Ok((of_best.unwrap_or(0.0), Some(shortest).filter(|_| of_best.is_none())))
}
