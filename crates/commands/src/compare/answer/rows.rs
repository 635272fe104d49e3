//! Pairing of the gears of several gearboxes.
//!
//! If all gearboxes have gears of the same names in the same order of their ratios, gears are paired by name.
//! Otherwise they are paired by ratio. The gears of one gearbox after the other are aligned with the rows of
//! those before. Both lists are sorted by decreasing absolute ratio, separately for each sign.
//!
//! The alignment minimizes the sum of `|ln(i/i')|` over all pairs; a gear without a partner costs half of
//! `ln 1.2`. Gears whose ratios differ by more than a fifth are never paired.

use crate::analyze::answer::overview::{Gear, Overview};
use crate::error::Error;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeSet;

/// Maximum number of gears of a gearbox in a comparison, because the alignment takes their product.
pub const MOST_GEARS: usize = 1000;

/// Largest factor between the ratios of paired gears.
const FARTHEST: f64 = 1.2;

/// Properties by which gears are paired.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum GearsBy {
    /// By names, which are the same in all gearboxes and in the same order of the ratios.
    Name,
    /// By ratios.
    Ratio,
}

/// Gear of each gearbox by its place, or `None`.
type Row = Vec<Option<usize>>;

/// Computes the rows of a comparison.
pub(super) fn of(overviews: &[Overview]) -> Result<(GearsBy, Vec<Row>), Error> {
    for overview in overviews {
        if overview.gears.len() > MOST_GEARS {
            return Err(Error::ManyGears { gears: overview.gears.len(), most: MOST_GEARS });
        }
    }
    let names = |overview: &Overview| -> Vec<String> {
        overview.gears.iter().map(|gear| gear.facts.gear.clone()).collect()
    };
    let all: Vec<Vec<String>> = overviews.iter().map(names).collect();
    let sets: Vec<BTreeSet<&String>> = all.iter().map(|names| names.iter().collect()).collect();
    let orders: Vec<Vec<&str>> = overviews.iter().map(by_falling_ratio).collect();
    let is_same = |pair: &[Vec<&str>]| pair[0] == pair[1];
    if sets.windows(2).all(|pair| pair[0] == pair[1]) && orders.windows(2).all(is_same) {
        let first = all.first().map_or(&[][..], Vec::as_slice);
        let place =
            |name: &String| all.iter().map(|names| names.iter().position(|other| other == name)).collect();
        return Ok((GearsBy::Name, first.iter().map(place).collect()));
    }
    let ratios: Vec<Vec<Option<f64>>> = overviews
        .iter()
        .map(|overview| overview.gears.iter().map(|gear| gear.facts.ratio).collect())
        .collect();
    Ok((GearsBy::Ratio, by_ratio(&ratios)))
}

/// Names of the gears that have a ratio, in decreasing order with reverse gears last; equal ratios by name.
fn by_falling_ratio(overview: &Overview) -> Vec<&str> {
    let of = |gear: &'_ Gear| gear.facts.ratio;
    let mut gears: Vec<&Gear> = overview.gears.iter().filter(|gear| of(gear).is_some()).collect();
    gears.sort_by(|one, other| {
        let key = |gear: &Gear| of(gear).unwrap_or_default();
        key(other).total_cmp(&key(one)).then_with(|| one.facts.gear.cmp(&other.facts.gear))
    });
    gears.into_iter().map(|gear| gear.facts.gear.as_str()).collect()
}

/// Computes rows by ratio: forward gears, then those of negative ratio, then gears without a ratio, each
/// alone.
fn by_ratio(ratios: &[Vec<Option<f64>>]) -> Vec<Row> {
    let mut rows = vec![];
    for sign in [1.0, -1.0] {
        // Absolute value of the first ratio of each row, and the row.
        let mut beside: Vec<(f64, Row)> = vec![];
        for (gearbox, ratios) in ratios.iter().enumerate() {
            let of_sign =
                |(place, ratio): (usize, &Option<f64>)| Some((ratio.map(|ratio| sign * ratio)?, place));
            let mut gears: Vec<(f64, usize)> =
                ratios.iter().enumerate().filter_map(of_sign).filter(|(ratio, _)| *ratio > 0.0).collect();
            gears.sort_by(|one, other| other.0.total_cmp(&one.0));
            beside = laid(&beside, &gears, gearbox);
        }
        rows.extend(beside.into_iter().map(|(_, row)| row));
    }
    for (gearbox, gears) in ratios.iter().enumerate() {
        let without = (0..gears.len()).filter(|place| gears[*place].is_none());
        rows.extend(without.map(|place| {
            let mut row = vec![None; gearbox];
            row.push(Some(place));
            row
        }));
    }
    for row in &mut rows {
        row.resize(ratios.len(), None);
    }
    rows
}

/// Aligns the gears of one more gearbox with the rows at the least cost.
fn laid(rows: &[(f64, Row)], gears: &[(f64, usize)], gearbox: usize) -> Vec<(f64, Row)> {
    let alone = 0.5 * libm::log(FARTHEST);
    let pair = |row: usize, gear: usize| f64::abs(libm::log(rows[row].0 / gears[gear].0));
    let width = gears.len() + 1;
    // Least cost of the first rows and the first gears (dynamic programming).
    let mut least = vec![0.0; (rows.len() + 1) * width];
    for row in 0..=rows.len() {
        for gear in 0..=gears.len() {
            let ways = [
                (row > 0 && gear > 0).then(|| least[(row - 1) * width + gear - 1] + pair(row - 1, gear - 1)),
                (row > 0).then(|| least[(row - 1) * width + gear] + alone),
                (gear > 0).then(|| least[row * width + gear - 1] + alone),
            ];
            least[row * width + gear] = ways.into_iter().flatten().reduce(f64::min).unwrap_or(0.0);
        }
    }
    // The path is traced back along the least cost.
    let (mut row, mut gear, mut all) = (rows.len(), gears.len(), vec![]);
    while row > 0 || gear > 0 {
        let here = least[row * width + gear];
        // Of paths with equal cost, the one whose pairs come first is taken.
        let taken = if row > 0 && here == least[(row - 1) * width + gear] + alone {
            (Some(row - 1), None)
        } else if gear > 0 && here == least[row * width + gear - 1] + alone {
            (None, Some(gear - 1))
        } else {
            (Some(row - 1), Some(gear - 1))
        };
        row -= usize::from(taken.0.is_some());
        gear -= usize::from(taken.1.is_some());
        all.push(taken);
    }
    let one = |(row, gear): (Option<usize>, Option<usize>)| {
        let own = gear.map(|gear| gears[gear]);
        let (ratio, mut cells) = match (row, own) {
            (Some(row), _) => rows[row].clone(),
            (None, Some((ratio, _))) => (ratio, vec![None; gearbox]),
            (None, None) => unreachable!("a step takes a row or a gear"),
        };
        cells.push(own.map(|(_, place)| place));
        (ratio, cells)
    };
    all.into_iter().rev().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gears_stand_beside_those_of_like_ratio() {
        let some = |ratios: &[f64]| ratios.iter().map(|ratio| Some(*ratio)).collect::<Vec<_>>();
        let eight = some(&[4.7143, 3.1429, 2.1064, 1.6667, 1.2854, 1.0, 0.8387, 0.6667, -3.295]);
        let three = some(&[1.0, 1.4815, 2.4815, -2.0769]);
        let rows = by_ratio(&[eight, three]);
        let beside: Vec<(usize, usize)> = rows.iter().filter_map(|row| Some((row[0]?, row[1]?))).collect();
        // The first of two gears with equal ratio gets the partner.
        let low = by_ratio(&[some(&[2.4, 2.4, 1.0]), some(&[2.5, 1.0])]);
        assert_eq!(low, [[Some(0), Some(0)], [Some(1), None], [Some(2), Some(1)]]);
        // 2.1064 and 2.4815, 1.6667 and 1.4815 differ by less than a fifth.
        assert_eq!(beside, [(2, 2), (3, 1), (5, 0)]);
        assert_eq!(rows.len(), 9 + 4 - 3);
        assert!(rows.iter().all(|row| row.len() == 2));
    }

    /// Checks the cost against all possible alignments.
    #[test]
    fn the_cost_is_the_least_of_all_ways() {
        fn trial(one: &[f64], other: &[f64], alone: f64) -> f64 {
            let skip = |rest: &[f64]| alone * rest.len() as f64;
            let ([first, rest @ ..], [start, others @ ..]) = (one, other) else {
                return skip(one) + skip(other);
            };
            let pair = libm::log(first / start).abs() + trial(rest, others, alone);
            pair.min(alone + trial(rest, other, alone)).min(alone + trial(one, others, alone))
        }
        let alone = 0.5 * libm::log(FARTHEST);
        for (one, other) in [
            (vec![4.0, 2.5, 1.5, 1.0, 0.7], vec![3.8, 2.2, 2.0, 1.4, 1.0]),
            (vec![2.4, 2.4, 1.0], vec![2.5, 2.3, 2.1, 0.9]),
            (vec![1.0], vec![]),
        ] {
            let gears: Vec<(f64, usize)> = other.iter().copied().zip(0..).collect();
            let rows: Vec<(f64, Row)> =
                one.iter().enumerate().map(|(place, ratio)| (*ratio, vec![Some(place)])).collect();
            let laid = laid(&rows, &gears, 1);
            let cost: f64 = laid
                .iter()
                .map(|(_, row)| match row[..] {
                    [Some(row), Some(gear)] => f64::abs(libm::log(one[row] / other[gear])),
                    _ => alone,
                })
                .sum();
            assert!((cost - trial(&one, &other, alone)).abs() < 1e-12, "{one:?} {other:?}");
        }
    }
}
