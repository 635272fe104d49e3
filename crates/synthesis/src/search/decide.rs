//! The last step of a search: whether a set of elements has all gears at one point, and with which functions.

use super::{Gear, Search, Solution};
use crate::equal::Equal;
use crate::motion::Element;
use crate::parts::{Parts, places};
use crate::ratio::Ratio;
use crate::shifts::fewest;
use crate::solve::{Function, Outcome, Solver};
use crate::table::Local;
use crate::ternary::Word;
use crate::watch::Watch;
use crate::wish::forward;

/// Decision on a candidate.
enum Verdict {
    /// The candidate has all gears.
    Solution(Solution),
    /// The candidate has all gears, but does not meet the demand of this number.
    Misses(usize),
    /// Neither a point nor the proof that no point exists.
    Undecided,
    /// No point exists.
    None,
}

/// Condition that the functions have to meet together.
type Demand<'a> = &'a dyn Fn(&[usize]) -> bool;

impl<W: Word> Search<W> {
    /// The solution of a candidate, if it has all gears at one point; where several choices of sets with
    /// equal `k` have such points, with the one that has the least deviation at its best.
    pub(super) fn decide(&mut self, chosen: u64, parts: Parts, watch: &Watch<'_>) -> Option<Solution> {
        self.tally.candidates += 1;
        let mut locals: Vec<Local> = Vec::new();
        let mut choices: Vec<Vec<u64>> = Vec::new();
        self.table.for_each_choice(chosen, &mut |function, choice| match locals
            .iter()
            .position(|known| *known == function)
        {
            Some(place) => choices[place].push(choice),
            None => {
                locals.push(function);
                choices.push(vec![choice]);
            }
        });
        let (mut found, mut missed, mut undecided) = (Vec::new(), None, false);
        for place in 0..self.equals.len() {
            let (equal, on_it) = self.equals[place];
            let mut choices = choices.clone();
            if equal != Equal::NONE {
                // If input or output are at rest wherever these k are equal, no ratio exists, whatever
                // formula remains.
                let motion = &mut self.motion;
                let mut drives = |choice: &u64| {
                    let speeds = motion.gear(&places(*choice).collect::<Vec<_>>());
                    !equal.vanishes(speeds.input) && !equal.vanishes(speeds.output)
                };
                choices.iter_mut().for_each(|choices| choices.retain(&mut drives));
            }
            match self.decide_with(chosen, parts.and(on_it), equal, (&locals, &choices), watch) {
                Verdict::Solution(solution) => found.push(solution),
                Verdict::Misses(demand) => missed = missed.max(Some(demand)),
                Verdict::Undecided => undecided = true,
                Verdict::None => {}
            }
        }
        if found.is_empty() {
            match missed {
                Some(1) => self.tally.reducible += 1,
                Some(2) => self.tally.without_direct += 1,
                Some(_) => self.tally.without_single_shifts += 1,
                None => self.tally.undecided += u64::from(undecided),
            }
        }
        self.best(found)
    }

    /// Returns the solution with the least deviation at its best point, of those that differ in which `k` are
    /// equal.
    fn best(&self, mut found: Vec<Solution>) -> Option<Solution> {
        if found.len() <= 1 {
            return found.pop();
        }
        let deviation = |solution: &Solution| {
            let ratios: Vec<Ratio> = solution.gears.iter().map(|gear| gear.ratio).collect();
            self.wish.refine(&ratios, &solution.k, solution.equal).deviation
        };
        let deviations: Vec<f64> = found.iter().map(deviation).collect();
        let best = (0..found.len()).min_by(|one, other| deviations[*one].total_cmp(&deviations[*other]))?;
        Some(found.swap_remove(best))
    }

    /// Returns a point and functions with which gears side by side fall at the best `k` too, if some exchange
    /// of their functions gives one. The best `k` of all exchanges are the same, since any ratio of these
    /// gears is as good. Otherwise the point and functions are returned as given.
    fn falling_at_best(
        &self,
        k: Vec<f64>,
        assigned: Vec<usize>,
        equal: Equal,
        ratios: &[Ratio],
        accept: Demand<'_>,
    ) -> (Vec<f64>, Vec<usize>) {
        let of = |assigned: &[usize]| assigned.iter().map(|function| ratios[*function]).collect::<Vec<_>>();
        let best = self.wish.refine(&of(&assigned), &k, equal).k;
        let mut sorted = assigned.clone();
        for run in &self.wish.side_by_side {
            let mut functions: Vec<usize> = run.iter().map(|gear| assigned[*gear]).collect();
            functions.sort_by(|one, other| ratios[*other].value(&best).total_cmp(&ratios[*one].value(&best)));
            run.iter().zip(functions).for_each(|(gear, function)| sorted[*gear] = function);
        }
        let values: Vec<f64> = of(&sorted).iter().map(|ratio| ratio.value(&best)).collect();
        let within = values.iter().zip(&self.wish.gears).all(|(value, gear)| gear.contain(*value));
        if sorted != assigned && within && self.wish.are_falling(&values) && accept(&sorted) {
            (best, sorted)
        } else {
            (k, assigned)
        }
    }

    /// Decides a candidate in some parts with some `k` equal, by its functions and, for each, the choices
    /// that have it.
    fn decide_with(
        &self,
        chosen: u64,
        parts: Parts,
        equal: Equal,
        (locals, choices): (&[Local], &[Vec<u64>]),
        watch: &Watch<'_>,
    ) -> Verdict {
        let sets = self.wish.k.len();
        let ratio = |function: &Local| self.library.ratio(self.table.number(*function));
        let functions: Vec<Function> =
            locals.iter().map(|function| Function::with_equal(ratio(function), sets, equal)).collect();
        let functions: Vec<&Function> = functions.iter().collect();
        let every = (1usize << self.wish.k.len()) - 1;
        let moves_all = |assigned: &[usize]| {
            assigned.iter().fold(0, |all, function| all | functions[*function].ratio.variables()) == every
        };
        let engages_all = |assigned: &[usize]| {
            assigned.iter().flat_map(|function| &choices[*function]).fold(0, |all, choice| all | choice)
                == chosen
        };
        let rules = &self.wish.rules;
        let is_direct =
            |assigned: &[usize]| assigned.iter().any(|function| functions[*function].ratio == Ratio::ONE);
        let forward = forward(&self.wish.gears);
        let shifts = |assigned: &[usize]| {
            let choices: Vec<&[u64]> =
                forward.iter().map(|gear| choices[assigned[*gear]].as_slice()).collect();
            fewest(&choices, rules.shifts).is_some()
        };
        // Demands on the functions, in the order in which a set that misses one is counted.
        let demands: [Demand<'_>; 4] =
            [&engages_all, &moves_all, &|assigned| !rules.direct || is_direct(assigned), &|assigned| {
                !rules.shifts.bind() || shifts(assigned)
            }];
        // Functions that are one where these k are equal are not two gears.
        let are_apart = |assigned: &[usize]| {
            equal == Equal::NONE
                || self.falling.iter().all(|[higher, lower]| {
                    let [one, other] = [higher, lower].map(|gear| functions[assigned[*gear]].ratio);
                    !equal.makes_equal(one, other)
                })
        };
        let mut undecided = false;
        let mut missed = [false; 4];
        // Searches with the first `kept` demands: a point with functions, and the demands that others missed
        // first.
        let mut seek = |kept: usize| {
            let mut accept =
                |assigned: &[usize]| match demands[..kept].iter().position(|keep| !keep(assigned)) {
                    None => are_apart(assigned),
                    Some(first) => {
                        missed[first] = true;
                        false
                    }
                };
            let mut solver = Solver::new(&functions, &self.wish.gears, &mut accept)
                .with_equal(equal)
                .with_falling(&self.falling)
                .with_watch(watch);
            let found = parts.iter().find_map(|part| {
                let gears = locals.iter().zip(choices).map(|(function, choices)| {
                    if choices.is_empty() { 0 } else { self.table.reached_in(*function, part) }
                });
                match solver.search_among(&self.library.grid().part(part), gears) {
                    Outcome::Found { k, functions } => Some((k, functions)),
                    Outcome::None => None,
                    Outcome::Undecided => {
                        undecided = true;
                        None
                    }
                }
            });
            (found, missed)
        };
        let (found, missed) = seek(demands.len());
        let Some((k, assigned)) = found else {
            // Functions that missed a demand were passed over: have they a point?
            let without =
                (1..demands.len()).rev().find(|demand| missed[*demand] && seek(*demand).0.is_some());
            return match without {
                Some(demand) => Verdict::Misses(demand),
                None if undecided => Verdict::Undecided,
                None => Verdict::None,
            };
        };
        let (k, assigned) = if self.falling.is_empty() {
            (k, assigned)
        } else {
            let ratios: Vec<Ratio> = functions.iter().map(|function| function.ratio).collect();
            self.falling_at_best(k, assigned, equal, &ratios, &|assigned| {
                demands.iter().all(|keep| keep(assigned)) && are_apart(assigned)
            })
        };
        let places: Vec<usize> = places(chosen).collect();
        let by_places =
            |choice: &u64| (0..places.len()).filter(|place| choice >> places[*place] & 1 == 1).collect();
        let gear = |function: &usize| Gear {
            ratio: functions[*function].ratio,
            engaged: choices[*function].iter().map(by_places).collect(),
        };
        let gears = assigned.iter().map(gear).collect();
        let mut elements: Vec<Vec<Element>> =
            places.iter().map(|place| self.elements[*place].clone()).collect();
        rules.order(&mut elements);
        Verdict::Solution(Solution { elements, k, equal, gears })
    }
}
