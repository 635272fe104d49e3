//! The progression of the gears: spread, steps, and how far each ratio is from an ideal progression.
//!
//! Gears are of one progression where they have the same input and output and turn the output in the same
//! direction. Ordered by falling ratio, each ratio counted once, they are `i_1 … i_n`:
//!
//! ```text
//! φ_G = i_1/i_n                                              spread
//! geometric:   i_j = i_n·φ^(n−j),  φ = φ_G^(1/(n−1))         equal steps
//! progressive: i_j = i_n·φ_1^(n−j)·φ_2^((n−j)·(n−j−1)/2)     each step φ_2 times the next one
//! ```
//!
//! Both ideals have the first and the last ratio of the gearbox, so that `φ_1 = φ/φ_2^((n−2)/2)`. All steps
//! are above 1 where `φ_2` is between `φ_G^(−2/((n−1)(n−2)))` and its inverse. Where no `φ_2` is given it is
//! the one that fits best: with `r_j = ln(i_j/i_j,geometric)` and `c_j = −(n−j)(j−1)/2` the sum of
//! `(r_j − c_j·ln φ_2)²` is least at `ln φ_2 = Σ r_j·c_j/Σ c_j²`.

use crate::error::Error;
use crate::tolerance::SAME_RATIO;
use epicyclic_train::Analysis;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Gears between the same two links that turn the output in the same direction.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Progression {
    /// Link where power enters.
    pub input: String,
    /// Link where power leaves.
    pub output: String,
    /// Whether the output turns against the input.
    pub reverses: bool,
    /// Names of the gears by decreasing absolute ratio; gears of equal ratio are neighbours in the list.
    pub gears: Vec<String>,
    /// Number of different ratios.
    pub ratios: usize,
    /// Spread: first ratio over last ratio.
    pub spread: f64,
    /// Step of the geometric progression between first and last ratio.
    pub geometric_step: f64,
    /// Progression factor φ_2: each step of the progressive progression over the next one; null for two
    /// ratios.
    pub progression_factor: Option<f64>,
    /// Whether the progression factor was given; otherwise it is the best fit to the ratios.
    pub progression_factor_is_given: bool,
}

/// Relative deviation of a gear's ratio from the ideal progressions.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Deviation {
    /// Ratio over that of the geometric progression, minus 1.
    pub(super) geometric: Option<f64>,
    /// Ratio over that of the progressive progression, minus 1.
    pub(super) progressive: Option<f64>,
}

/// Gears of a progression by their places in the gearbox.
pub(super) struct Ordered {
    reverses: bool,
    /// Places by decreasing absolute ratio; gears of equal ratio are one entry.
    pub(super) ranks: Vec<Vec<usize>>,
}

/// Finds the progressions of more than one ratio, in the order of their first gears.
pub(super) fn ordered(gears: &[&Analysis<'_>]) -> Vec<Ordered> {
    let mut groups: BTreeMap<_, Vec<(usize, f64)>> = BTreeMap::new();
    for (place, gear) in gears.iter().enumerate() {
        if let Some(ratio) = gear.ratio() {
            let key = (gear.gear().input().index(), gear.gear().output().index(), ratio < 0.0);
            groups.entry(key).or_default().push((place, ratio.abs()));
        }
    }
    let mut groups: Vec<_> = groups.into_iter().map(|((.., reverses), gears)| (reverses, gears)).collect();
    groups.sort_by_key(|(_, gears)| gears[0].0);
    let one = |(reverses, mut gears): (bool, Vec<(usize, f64)>)| {
        gears.sort_by(|one, other| other.1.total_cmp(&one.1));
        let mut ranks: Vec<(f64, Vec<usize>)> = vec![];
        for (place, ratio) in gears {
            match ranks.last_mut() {
                Some((same, places)) if *same - ratio <= SAME_RATIO * *same => places.push(place),
                _ => ranks.push((ratio, vec![place])),
            }
        }
        Ordered { reverses, ranks: ranks.into_iter().map(|(_, places)| places).collect() }
    };
    groups.into_iter().map(one).filter(|ordered| ordered.ranks.len() > 1).collect()
}

/// Computes the progressions of a gearbox, and the deviation of each of its gears.
pub(super) fn of(
    gears: &[&Analysis<'_>],
    ordered: &[Ordered],
    factor: Option<f64>,
) -> Result<(Vec<Progression>, Vec<Deviation>), Error> {
    let mut deviations = vec![Deviation::default(); gears.len()];
    let mut all = vec![];
    for one in ordered {
        let size = |places: &Vec<usize>| gears[places[0]].ratio().map_or(0.0, f64::abs);
        let ratios: Vec<f64> = one.ranks.iter().map(size).collect();
        let name = |place: usize| gears[place].gear().name().to_owned();
        let ideal = Ideal::of(&ratios, factor).map_err(|[least, most]| Error::ProgressionFactor {
            factor: factor.unwrap_or_default(),
            first: name(one.ranks[0][0]),
            last: one.ranks.last().map_or_else(String::new, |places| name(places[0])),
            least,
            most,
        })?;
        for (rank, places) in one.ranks.iter().enumerate() {
            for &place in places {
                deviations[place] = ideal.deviation(&ratios, rank);
            }
        }
        let first = gears[one.ranks[0][0]];
        let link = |link| first.gearbox().link_name(link).to_owned();
        all.push(Progression {
            input: link(first.gear().input()),
            output: link(first.gear().output()),
            reverses: one.reverses,
            gears: one.ranks.iter().flatten().map(|place| name(*place)).collect(),
            ratios: ratios.len(),
            spread: ideal.spread,
            geometric_step: ideal.step,
            progression_factor: ideal.factor,
            progression_factor_is_given: factor.is_some() && ideal.factor.is_some(),
        });
    }
    Ok((all, deviations))
}

/// Step to each gear from the next larger ratio of its progression.
pub(super) fn steps(gears: &[&Analysis<'_>], ordered: &[Ordered]) -> Vec<Option<f64>> {
    let mut steps = vec![None; gears.len()];
    for pair in ordered.iter().flat_map(|one| one.ranks.windows(2)) {
        for &place in &pair[1] {
            steps[place] =
                gears[pair[0][0]].ratio().zip(gears[place].ratio()).map(|(one, other)| one / other);
        }
    }
    steps
}

/// Ideal progressions between the first and the last of the given ratios.
#[derive(Debug)]
struct Ideal {
    spread: f64,
    step: f64,
    factor: Option<f64>,
}

impl Ideal {
    /// Ideal progressions; the error is the allowed range of a factor outside it.
    fn of(ratios: &[f64], factor: Option<f64>) -> Result<Self, [f64; 2]> {
        let steps = ratios.len() as f64 - 1.0;
        let spread = ratios[0] / ratios[ratios.len() - 1];
        let step = libm::pow(spread, steps.recip());
        let mut ideal = Self { spread, step, factor: None };
        if ratios.len() > 2 {
            let most = libm::pow(spread, 2.0 / (steps * (steps - 1.0)));
            if factor.is_some_and(|factor| !(factor > most.recip() && factor < most)) {
                return Err([most.recip(), most]);
            }
            ideal.factor = Some(factor.unwrap_or_else(|| ideal.best(ratios)));
        }
        Ok(ideal)
    }

    /// Factor of the progression that fits best (least squares of the logarithms).
    fn best(&self, ratios: &[f64]) -> f64 {
        let (mut above, mut below) = (0.0, 0.0);
        for (rank, ratio) in ratios.iter().enumerate() {
            let bend = bend(ratios.len(), rank);
            above += libm::log(ratio / self.geometric(ratios, rank)) * bend;
            below += bend * bend;
        }
        libm::exp(above / below)
    }

    fn geometric(&self, ratios: &[f64], rank: usize) -> f64 {
        ratios[0] / libm::pow(self.step, rank as f64)
    }

    fn deviation(&self, ratios: &[f64], rank: usize) -> Deviation {
        let geometric = self.geometric(ratios, rank);
        let progressive = |factor: f64| geometric * libm::pow(factor, bend(ratios.len(), rank));
        // The first and last ratio are equal in all progressions by definition.
        let is_end = rank == 0 || rank + 1 == ratios.len();
        let over = |ideal: f64| if is_end { 0.0 } else { ratios[rank] / ideal - 1.0 };
        Deviation {
            geometric: self.factor.map(|_| over(geometric)),
            progressive: self.factor.map(|factor| over(progressive(factor))),
        }
    }
}

/// Exponent of φ_2 in the progressive ratio over the geometric one, for a rank from 0.
fn bend(ratios: usize, rank: usize) -> f64 {
    -0.5 * (ratios - 1 - rank) as f64 * rank as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ratios with steps in a constant proportion, multiplied one after the other.
    fn progressive(last: f64, base: f64, factor: f64, count: usize) -> Vec<f64> {
        let mut ratios = vec![last];
        let mut step = base;
        while ratios.len() < count {
            ratios.push(ratios[ratios.len() - 1] * step);
            step *= factor;
        }
        ratios.reverse();
        ratios
    }

    #[test]
    fn a_progression_is_found_with_its_factor() {
        for (base, factor, count) in [(1.2, 1.1, 6), (1.4, 1.0, 5), (1.5, 0.95, 4), (1.3, 1.07, 3)] {
            let ratios = progressive(0.7, base, factor, count);
            let ideal = Ideal::of(&ratios, None).unwrap();
            assert!((ideal.factor.unwrap() / factor - 1.0).abs() < 1e-12, "{base} {factor} {count}");
            let given = Ideal::of(&ratios, Some(factor)).unwrap();
            for rank in 0..count {
                for ideal in [&ideal, &given] {
                    assert!(ideal.deviation(&ratios, rank).progressive.unwrap().abs() < 1e-12);
                }
            }
        }
    }

    /// No nearby factor has a smaller sum of squares.
    #[test]
    fn the_factor_that_is_found_fits_best() {
        let ratios = [4.714, 3.143, 2.106, 1.667, 1.285, 1.0, 0.839, 0.667];
        let sum = |factor: f64| {
            let base = libm::pow(ratios[0] / ratios[7] / factor.powi(21), 1.0 / 7.0);
            let ideal = progressive(ratios[7], base, factor, 8);
            ratios.iter().zip(ideal).map(|(ratio, ideal)| libm::log(ratio / ideal).powi(2)).sum::<f64>()
        };
        let best = Ideal::of(&ratios, None).unwrap().factor.unwrap();
        assert!(best > 1.0 && sum(best) < sum(best * 1.001) && sum(best) < sum(best / 1.001), "{best}");
    }

    #[test]
    fn a_factor_that_leaves_a_step_below_1_is_refused() {
        let ratios = [4.0, 2.5, 1.6, 1.0];
        let [least, most] = Ideal::of(&ratios, Some(2.0)).unwrap_err();
        assert!((least * most - 1.0).abs() < 1e-12);
        for (factor, smallest) in [(most * 0.999, 2), (least / 0.999, 0)] {
            let base = libm::cbrt(4.0 / factor.powi(3));
            let ideal = progressive(1.0, base, factor, 4);
            let step = ideal[smallest] / ideal[smallest + 1];
            assert!(step > 1.0 && step < 1.01, "{step}");
            assert!(Ideal::of(&ratios, Some(factor)).is_ok());
        }
        assert!(Ideal::of(&ratios, Some(most * 1.001)).is_err());
        // Two ratios have one step.
        assert_eq!(Ideal::of(&[2.0, 1.0], Some(9.0)).unwrap().factor, None);
    }
}
