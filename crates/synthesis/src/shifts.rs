//! Elements that neighbouring gears exchange.
//!
//! A shift is *single* if it opens one element and engages one. A gear may have several choices of elements
//! that give its function. Whether a shift is single therefore depends on the choices of both gears.
//!
//! # How it is computed
//! Gears are taken in turn. For each pair of choices of a gear and the previous one the least cost of a way
//! to them is kept (dynamic programming). With two choices remembered, a shift that skips a gear can be
//! judged as well.

/// Shifts between forward gears that have to be single.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Shifts {
    /// Shifts between neighbours.
    pub neighbours: bool,
    /// Shifts from each gear to the next but one: 1–3, 2–4 and so on.
    pub skips: bool,
}

impl Shifts {
    /// Whether any has to be.
    pub(crate) const fn bind(self) -> bool {
        self.neighbours || self.skips
    }
}

/// Number of elements of one choice that the other has not.
pub(crate) const fn exchanged(one: u64, other: u64) -> u32 {
    (one & !other).count_ones()
}

/// Cost of a way to two choices, and the choice before both; `None` if no way leads there.
type Way = Option<(u32, usize)>;

/// Finds, for gears in turn, the choices of elements (as bits) with the fewest exchanges beyond the first of
/// each shift between neighbours. `None` if shifts that have to be single cannot be. Of equal ones it takes
/// the least, from the last gear on.
pub(crate) fn fewest(gears: &[&[u64]], single: Shifts) -> Option<Vec<usize>> {
    let Some((first, others)) = gears.split_first() else { return Some(Vec::new()) };
    // For each step, by the choice before and the choice now: the least cost, and the choice before both.
    let mut ways: Vec<Vec<Vec<Way>>> = vec![vec![vec![Some((0, 0)); first.len()]]];
    for (step, now) in (1..).zip(others) {
        let before = gears[step - 1];
        let way = |place: usize, choice: u64| {
            let beyond = exchanged(choice, before[place]).saturating_sub(1);
            if single.neighbours && beyond > 0 {
                return None;
            }
            let reached = ways[step - 1].iter().enumerate().filter_map(|(first, row)| {
                let (cost, _) = row[place]?;
                let skips = step < 2 || !single.skips || exchanged(choice, gears[step - 2][first]) <= 1;
                skips.then_some((cost + beyond, first))
            });
            reached.min()
        };
        let table: Vec<Vec<Way>> =
            (0..before.len()).map(|place| now.iter().map(|choice| way(place, *choice)).collect()).collect();
        ways.push(table);
    }
    let last = ways.last()?;
    let ends = last.iter().enumerate().flat_map(|(before, row)| {
        row.iter().enumerate().filter_map(move |(now, way)| Some((way.as_ref()?.0, now, before)))
    });
    let (_, mut now, mut before) = ends.min()?;
    let mut choices = vec![0; gears.len()];
    for step in (0..gears.len()).rev() {
        choices[step] = now;
        let (_, first) = ways[step][before][now]?;
        (now, before) = (before, first);
    }
    Some(choices)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cost(gears: &[&[u64]], chosen: &[usize]) -> u32 {
        let choice = |gear: usize| gears[gear][chosen[gear]];
        (1..gears.len()).map(|gear| exchanged(choice(gear), choice(gear - 1)).saturating_sub(1)).sum()
    }

    fn keeps(gears: &[&[u64]], chosen: &[usize], single: Shifts) -> bool {
        let far = |gear: usize, by: usize| {
            exchanged(gears[gear][chosen[gear]], gears[gear - by][chosen[gear - by]])
        };
        (!single.neighbours || (1..gears.len()).all(|gear| far(gear, 1) <= 1))
            && (!single.skips || (2..gears.len()).all(|gear| far(gear, 2) <= 1))
    }

    #[test]
    fn the_choices_are_those_of_the_trial_of_all() {
        // Choices of three of six elements, drawn by a plain sequence.
        let threes: Vec<u64> = (0..64u64).filter(|bits| bits.count_ones() == 3).collect();
        let mut state = 1u64;
        let mut draw = |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) as usize % below
        };
        let mut none = 0;
        for _ in 0..300 {
            let gears: Vec<Vec<u64>> =
                (0..4).map(|_| (0..=draw(3)).map(|_| threes[draw(threes.len())]).collect()).collect();
            let gears: Vec<&[u64]> = gears.iter().map(Vec::as_slice).collect();
            for (neighbours, skips) in [(false, false), (true, false), (false, true), (true, true)] {
                let single = Shifts { neighbours, skips };
                let mut least = None;
                for code in 0..81 {
                    let chosen: Vec<usize> = (0..4u32).map(|gear| code / 3usize.pow(gear) % 3).collect();
                    let exists = chosen.iter().zip(&gears).all(|(place, choices)| *place < choices.len());
                    if exists && keeps(&gears, &chosen, single) {
                        let cost = cost(&gears, &chosen);
                        least = Some(least.map_or(cost, |least: u32| least.min(cost)));
                    }
                }
                let found = fewest(&gears, single);
                none += u32::from(found.is_none());
                assert_eq!(found.as_ref().map(|chosen| cost(&gears, chosen)), least);
                assert!(found.is_none_or(|chosen| keeps(&gears, &chosen, single)));
            }
        }
        assert!(none > 100, "shifts that cannot be single occur");
    }
}
