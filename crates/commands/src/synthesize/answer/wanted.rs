//! Requirements of a search: ratios as bounds, optional gears, structures and limits.

use super::gear::WantedGear;
use super::teeth::TeethWanted;
use epicyclic_formats::wanted_ratio::{Wanted as Ratio, WantedRatio, Within};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::limits::Limits;
use epicyclic_synthesis::parts::Bounds;
use epicyclic_synthesis::rank::Objective;
use epicyclic_synthesis::rules::Rules;
use epicyclic_synthesis::usable::Usable;
use epicyclic_synthesis::{Error, Kind};
use epicyclic_train::Gearbox;
use std::ops::{Range, RangeInclusive};

/// Maximum number of optional gears, because each doubles the number of searches.
pub const MOST_OPTIONAL: usize = 3;

/// Requirements of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// Required ratio of each gear; negative for reverse.
    pub gears: Vec<WantedRatio>,
    /// Allowed relative deviation of a ratio without a tolerance of its own.
    pub tolerance: f64,
    /// Kind of structures that are searched.
    pub kind: Kind,
    /// Numbers of planetary sets, tried in increasing order until one has solutions.
    pub sets: RangeInclusive<usize>,
    /// Numbers of shift elements, tried in increasing order until one has solutions.
    pub elements: RangeInclusive<usize>,
    /// Numbers of shift elements that a gear engages.
    pub engaged: RangeInclusive<usize>,
    /// Numbers of moving links: sets plus engaged elements plus one.
    pub links: RangeInclusive<usize>,
    /// Numbers of open shift elements in a gear.
    pub open: RangeInclusive<usize>,
    /// Range of the ring-to-sun ratios of simple sets.
    pub k: RangeInclusive<f64>,
    /// Numbers of double-planet sets; each number is searched.
    pub double_planets: RangeInclusive<usize>,
    /// Range of the ring-to-sun ratios of double-planet sets.
    pub k_double: RangeInclusive<f64>,
    /// Minimum number of sets of one kind with equal k; 0 and 1 require nothing.
    pub equal_k: usize,
    /// Rules of the search besides the ratios.
    pub rules: Rules,
    /// Limits for solutions at their best k.
    pub limits: Limits,
    /// Whether solutions must be drawable: with nested shafts, each brake reached from the housing.
    pub drawable: bool,
    /// Parts of the time in each gear, as weights of the mean efficiency; if `None`, the least efficiency
    /// counts.
    pub shares: Option<Vec<f64>>,
    /// Limits of a usable gearbox: larger classes are searched until one is found. If `None`, the search ends
    /// at the first class with gearboxes.
    pub usable: Option<Usable>,
    /// Efficiency of the two meshes of a simple set; each of the three meshes of a double-planet set has an
    /// equal loss.
    pub efficiency: MeshEfficiency,
    /// Maximum number of solutions listed.
    pub most: usize,
    /// Whether all solutions are listed; otherwise only the best of each family.
    pub all_gearboxes: bool,
    /// Number of a further solution to be listed.
    pub also: Option<usize>,
    /// Objectives that decide first about the order of solutions; the others follow.
    pub order: Vec<Objective>,
    /// Objectives of the Pareto front.
    pub objectives: Vec<Objective>,
    /// Requirements of the tooth numbers; `None` if none are requested.
    pub teeth: Option<TeethWanted>,
    /// Gearbox to be compared with the search.
    pub explain: Option<Gearbox>,
}

impl Wanted {
    /// Computes the required gears with their bounds.
    ///
    /// A free gear takes its bounds from its neighbours in the list; neighbouring free gears take those of
    /// the neighbours of the whole group. If steps are limited, the bounds of free gears and of ranges
    /// between forward neighbours are narrowed to what the steps allow. No solution within the steps is lost.
    ///
    /// # Errors
    /// [`Error::Wish`] if a free gear has no neighbours of its own sign on both sides, if more than
    /// [`MOST_OPTIONAL`] gears are optional, or if all are.
    pub fn gears(&self) -> Result<Vec<WantedGear>, Error> {
        let fault = |why: String| Err(Error::Wish { why });
        let optional = self.gears.iter().filter(|gear| gear.optional).count();
        if optional > MOST_OPTIONAL {
            return fault(format!("{optional} gears may be missing: there may be {MOST_OPTIONAL} at most"));
        }
        if optional == self.gears.len() && optional > 0 {
            return fault("every gear may be missing: write at least one without brackets".into());
        }
        let fixed: Vec<Option<Bounds>> = self.gears.iter().map(|gear| self.fixed(gear)).collect();
        let mut gears = Vec::new();
        for (place, gear) in self.gears.iter().enumerate() {
            let bounds = match fixed[place] {
                Some(bounds) => bounds,
                None => match between(&fixed, place, self.run(place)) {
                    Some(bounds) => bounds,
                    None => {
                        return fault(format!(
                            "gear {} is free and has no bounds: write it, or several side by side, between two gears of one sign, or as a range such as \
                             4.5..4.9",
                            place + 1
                        ));
                    }
                },
            };
            let wanted_ratio = match gear.wanted {
                Ratio::Around { ratio, .. } => Some(ratio),
                Ratio::Range { .. } | Ratio::Free => None,
            };
            let Bounds { least, most } = bounds;
            gears.push(WantedGear {
                wanted_ratio,
                least_ratio: least,
                greatest_ratio: most,
                may_be_missing: gear.optional,
            });
        }
        if optional == 0 {
            self.draw_in(&mut gears);
        }
        Ok(gears)
    }

    /// Group of neighbouring free gears that contains this gear.
    fn run(&self, place: usize) -> Range<usize> {
        let is_free = |gear: &WantedRatio| gear.wanted == Ratio::Free;
        let before = self.gears[..place].iter().rev().take_while(|gear| is_free(gear)).count();
        let after = self.gears[place..].iter().take_while(|gear| is_free(gear)).count();
        place - before..place + after
    }

    /// Groups of neighbouring free gears within a selection, the highest ratio first, by their places in the
    /// selection.
    pub(super) fn side_by_side(&self, selection: &[usize], gears: &[WantedGear]) -> Vec<Vec<usize>> {
        let mut runs: Vec<Vec<usize>> = Vec::new();
        let mut last = None;
        for (place, gear) in selection.iter().enumerate() {
            if self.gears[*gear].wanted != Ratio::Free {
                continue;
            }
            let run = Some(self.run(*gear));
            if run != last {
                runs.push(Vec::new());
                last = run;
            }
            runs.last_mut().into_iter().for_each(|run| run.push(place));
        }
        runs.retain(|run| run.len() > 1);
        for run in &mut runs {
            let most = |place: &usize| gears[selection[*place]].greatest_ratio;
            run.sort_by(|one, other| most(other).total_cmp(&most(one)));
        }
        runs
    }

    fn fixed(&self, gear: &WantedRatio) -> Option<Bounds> {
        match gear.wanted {
            Ratio::Around { ratio, within } => {
                let difference = within.unwrap_or(Within::Share(self.tolerance)).difference(ratio);
                Some(Bounds { least: ratio - difference, most: ratio + difference })
            }
            Ratio::Range { least, most } => Some(Bounds { least, most }),
            Ratio::Free => None,
        }
    }

    /// Narrows the bounds of gears without a required ratio to what the steps to their neighbours allow.
    fn draw_in(&self, gears: &mut [WantedGear]) {
        let Some(steps) = &self.limits.steps else { return };
        let bounds: Vec<Bounds> = gears.iter().map(WantedGear::bounds).collect();
        let order = epicyclic_synthesis::wish::forward(&bounds);
        for (place, gear) in order.iter().enumerate() {
            if gears[*gear].wanted_ratio.is_some() {
                continue;
            }
            if let Some(above) = place.checked_sub(1).map(|place| bounds[order[place]]) {
                gears[*gear].least_ratio = gears[*gear].least_ratio.max(above.least / steps.end());
                gears[*gear].greatest_ratio = gears[*gear].greatest_ratio.min(above.most / steps.start());
            }
            if let Some(below) = order.get(place + 1).map(|gear| bounds[*gear]) {
                gears[*gear].least_ratio = gears[*gear].least_ratio.max(below.least * steps.start());
                gears[*gear].greatest_ratio = gears[*gear].greatest_ratio.min(below.most * steps.end());
            }
        }
    }

    /// Range of k of a set.
    pub(super) fn k_of(&self, double_planet: bool) -> &RangeInclusive<f64> {
        if double_planet { &self.k_double } else { &self.k }
    }

    /// Ranges of k for a search with this number of double-planet sets; for these sets of `k′ = k − 1`.
    pub(super) fn ranges(&self, sets: usize, double_planets: usize) -> Vec<RangeInclusive<f64>> {
        let double = self.k_double.start() - 1.0..=self.k_double.end() - 1.0;
        let mut ranges = vec![self.k.clone(); sets - double_planets.min(sets)];
        ranges.resize(sets, double);
        ranges
    }

    /// Numbers of sets, shift elements and engaged ones within all ranges, in the order in which they are
    /// tried.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        let pairs =
            self.sets.clone().flat_map(|sets| self.elements.clone().map(move |elements| (sets, elements)));
        let all = pairs
            .flat_map(|(sets, elements)| self.engaged.clone().map(move |engaged| (sets, elements, engaged)));
        all.filter(|(sets, elements, engaged)| {
            let within = elements.checked_sub(*engaged).is_none_or(|open| self.open.contains(&open));
            within && self.links.contains(&(sets + engaged + 1))
        })
    }

    /// Gears for each search, by their places: all of them first, then without optional ones, with fewer left
    /// out first.
    #[must_use]
    pub fn selections(&self) -> Vec<Vec<usize>> {
        let optional: Vec<usize> = (0..self.gears.len()).filter(|gear| self.gears[*gear].optional).collect();
        let mut left_out: Vec<u32> = (0..1 << optional.len()).collect();
        left_out.sort_by_key(|left_out| (left_out.count_ones(), *left_out));
        let without = |left_out: u32| {
            let missing = |gear: &usize| {
                optional.iter().position(|one| one == gear).is_some_and(|place| left_out >> place & 1 == 1)
            };
            (0..self.gears.len()).filter(|gear| !missing(gear)).collect()
        };
        left_out.into_iter().map(without).collect()
    }
}

/// Bounds of one of several free gears between those before and after, which they do not touch. In decreasing
/// order no two touch either, so each gear is one floating-point number farther from the end gears.
fn between(fixed: &[Option<Bounds>], place: usize, run: Range<usize>) -> Option<Bounds> {
    let before = fixed[run.start.checked_sub(1)?]?;
    let after = (*fixed.get(run.end)?)?;
    let (from_before, from_after) = (place - run.start + 1, run.end - place);
    let rises = before.most < after.least;
    let (lower, upper) = if rises { (before, after) } else { (after, before) };
    let (above, below) = if rises { (from_after, from_before) } else { (from_before, from_after) };
    let least = (0..below).fold(lower.most, |bound, _| bound.next_up());
    let most = (0..above).fold(upper.least, |bound, _| bound.next_down());
    (least <= most && least * most > 0.0).then_some(Bounds { least, most })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wanted(gears: &[&str], steps: Option<RangeInclusive<f64>>) -> Wanted {
        Wanted {
            gears: gears.iter().map(|gear| gear.parse().unwrap()).collect(),
            tolerance: 0.01,
            kind: Kind::Core,
            sets: 2..=2,
            elements: 2..=2,
            engaged: 1..=1,
            links: 4..=4,
            open: 1..=1,
            k: 1.4..=4.5,
            double_planets: 0..=0,
            k_double: 1.6..=4.5,
            equal_k: 1,
            rules: Rules::default(),
            limits: Limits { steps, ..Limits::default() },
            drawable: false,
            shares: None,
            usable: None,
            efficiency: MeshEfficiency::IDEAL,
            most: 1,
            all_gearboxes: false,
            also: None,
            order: Vec::new(),
            objectives: Vec::new(),
            teeth: None,
            explain: None,
        }
    }

    #[test]
    fn bounds_are_those_of_each_gear() {
        let gears = wanted(&["4", "3±0.5", "?", "1±2%", "-3..-2"], None).gears().unwrap();
        let bounds: Vec<[f64; 2]> =
            gears.iter().map(|gear| [gear.least_ratio, gear.greatest_ratio]).collect();
        assert_eq!(bounds[0], [3.96, 4.04]);
        assert_eq!(bounds[1], [2.5, 3.5]);
        assert_eq!(bounds[2], [1.02f64.next_up(), 2.5f64.next_down()]);
        assert_eq!(bounds[4], [-3.0, -2.0]);
        assert_eq!(gears[2].wanted_ratio, None);
    }

    #[test]
    fn steps_draw_in_what_is_free() {
        let gears = wanted(&["4", "?", "1"], Some(1.25..=2.5)).gears().unwrap();
        let [_, free, _] = gears[..] else { panic!("three gears") };
        // Bounds 4/2.5 = 1.6 and 1·1.25 = 1.25, widened by the neighbours' tolerance; likewise 4/1.25 and
        // 1·2.5 above.
        assert_eq!([free.least_ratio, free.greatest_ratio], [3.96 / 2.5, 1.01 * 2.5]);
        assert_eq!(gears[0].least_ratio, 3.96, "a wanted ratio keeps its tolerance");
    }

    #[test]
    fn free_gears_without_bounds_and_lists_without_a_gear_are_refused() {
        for (gears, why) in [
            (&["?", "3"][..], "gear 1 is free"),
            (&["3", "?"], "gear 2 is free"),
            (&["3", "?", "?"], "gear 2 is free"),
            (&["3", "?", "?", "-1"], "gear 2 is free"),
            (&["3", "?", "-2"], "gear 2 is free"),
            (&["(3)", "(2)"], "every gear may be missing"),
            (&["4", "(3)", "(2)", "(1)", "(-2)"], "4 gears may be missing: there may be 3 at most"),
        ] {
            let refused = wanted(gears, None).gears().unwrap_err().to_string();
            assert!(refused.contains(why), "{refused}");
        }
    }

    #[test]
    fn free_gears_side_by_side_are_between_the_others_and_fall() {
        for (list, falling) in [
            (&["1", "3", "?", "?", "?", "0.7"][..], [1, 2, 3]),
            (&["1", "0.7", "?", "?", "?", "3"], [3, 2, 1]),
            (&["1", "-3", "?", "?", "?", "-0.7"], [3, 2, 1]),
        ] {
            let wanted = wanted(list, None);
            let gears = wanted.gears().unwrap();
            let bounds: Vec<[f64; 2]> =
                gears.iter().map(|gear| [gear.least_ratio, gear.greatest_ratio]).collect();
            let all = wanted.side_by_side(&[0, 1, 2, 3, 4, 5], &gears);
            assert_eq!(all, [falling.map(|place| place + 1)]);
            for pair in all[0].windows(2) {
                let [higher, lower] = [pair[0], pair[1]].map(|gear| bounds[gear]);
                assert!(higher[0] > lower[0] && higher[1] > lower[1], "{list:?} {bounds:?}");
                assert!((higher[0] - lower[0]).abs() < 1e-12);
            }
            let (least, most) = if list[1].starts_with('-') { (-2.97, -0.707) } else { (0.707, 2.97) };
            assert!(bounds[2..5].iter().all(|[from, to]| *from > least && *to < most));
            // Without one of them two remain; without two the last is free on its own.
            assert_eq!(wanted.side_by_side(&[0, 1, 2, 4, 5], &gears)[0].len(), 2);
            assert!(wanted.side_by_side(&[0, 1, 3, 5], &gears).is_empty());
        }
    }

    #[test]
    fn gears_that_may_be_missing_are_left_out_the_fewest_first() {
        let selections = wanted(&["3", "(2)", "1", "(-2)"], None).selections();
        assert_eq!(selections, [vec![0, 1, 2, 3], vec![0, 2, 3], vec![0, 1, 2], vec![0, 2]]);
        assert_eq!(wanted(&["3", "2"], None).selections(), [[0, 1]]);
    }
}
