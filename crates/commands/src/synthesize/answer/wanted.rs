//! What is wanted of gearboxes: ratios as bounds, and which gears may be missing.

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

/// The most gears that may be missing: each doubles the searches.
pub const MOST_OPTIONAL: usize = 3;

/// What is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// The ratio of each gear; negative for reverse.
    pub gears: Vec<WantedRatio>,
    /// How far each may be off that has no tolerance of its own, as a share of it.
    pub tolerance: f64,
    /// Which structures are searched.
    pub kind: Kind,
    /// How many planet sets; those given are tried from the fewest up, until a number has solutions.
    pub sets: RangeInclusive<usize>,
    /// How many shift elements, tried alike.
    pub elements: RangeInclusive<usize>,
    /// How many shift elements a gear engages.
    pub engaged: RangeInclusive<usize>,
    /// How many moving links: sets, engaged elements and one more.
    pub links: RangeInclusive<usize>,
    /// How many shift elements are open in a gear.
    pub open: RangeInclusive<usize>,
    /// The range of the ring-to-sun ratios of simple sets.
    pub k: RangeInclusive<f64>,
    /// How many of the sets are double-planet sets; each number is searched.
    pub double_planets: RangeInclusive<usize>,
    /// The range of the ring-to-sun ratios of double-planet sets.
    pub k_double: RangeInclusive<f64>,
    /// At least so many sets of one kind have equal k; 0 and 1 ask for nothing.
    pub equal_k: usize,
    /// What the search keeps besides the ratios.
    pub rules: Rules,
    /// What solutions keep at their best k.
    pub limits: Limits,
    /// Whether solutions are drawable: with nested shafts, each brake reached from the housing.
    pub drawable: bool,
    /// The share of time of each gear, by which the mean efficiency is weighted; without, the least
    /// efficiency counts.
    pub shares: Option<Vec<f64>>,
    /// What a gearbox of use keeps: while none found does, larger classes are searched. Without, the first
    /// class with gearboxes is the last.
    pub usable: Option<Usable>,
    /// Efficiency of a simple set's two meshes; each of the three of a double-planet set loses as much.
    pub efficiency: MeshEfficiency,
    /// How many solutions are told at most.
    pub most: usize,
    /// Whether all solutions are told, not the best of each family alone.
    pub all_gearboxes: bool,
    /// The number of a solution that is told besides, if it is none of these.
    pub also: Option<usize>,
    /// Which objectives decide first which solution is the best; the others follow.
    pub order: Vec<Objective>,
    /// The objectives of the Pareto front.
    pub objectives: Vec<Objective>,
    /// Tooth numbers, if any are wanted.
    pub teeth: Option<TeethWanted>,
    /// A gearbox to be placed beside the search.
    pub explain: Option<Gearbox>,
}

impl Wanted {
    /// The gears with their bounds.
    ///
    /// A free gear has those of its neighbours in the list, several side by side those of the neighbours of
    /// all of them. Where steps are limited, bounds of free gears and of ranges between forward neighbours
    /// are drawn in to what the steps leave: nothing that keeps the steps is lost.
    ///
    /// # Errors
    /// [`Error::Wish`] where a free gear has no neighbours of its own sign on both sides, or there are more
    /// than [`MOST_OPTIONAL`] that may be missing, or none that may not.
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

    /// The free gears side by side with a gear, it among them.
    fn run(&self, place: usize) -> Range<usize> {
        let is_free = |gear: &WantedRatio| gear.wanted == Ratio::Free;
        let before = self.gears[..place].iter().rev().take_while(|gear| is_free(gear)).count();
        let after = self.gears[place..].iter().take_while(|gear| is_free(gear)).count();
        place - before..place + after
    }

    /// Of some gears those that are free and side by side, the highest ratio first, by their places among
    /// these.
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

    /// Draws in the bounds of gears without a wanted ratio to what the steps to their neighbours leave.
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

    /// The range of the k of a set.
    pub(super) fn k_of(&self, double_planet: bool) -> &RangeInclusive<f64> {
        if double_planet { &self.k_double } else { &self.k }
    }

    /// The ranges that a search with so many double-planet sets has: of these `k′ = k − 1`.
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

    /// The gears that a search asks for, by their places: all of them, then without those that may be
    /// missing, the more the earlier.
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

/// The bounds of one of several free gears between those before and after, which they do not touch. In
/// falling order none touches the next either, so each is a number farther from the gears beyond.
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
        // 4/2.5 = 1.6 and 1·1.25 = 1.25, widened by the neighbours' tolerance; above 4/1.25 and 1·2.5 alike.
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
            // Without one of them two are left; without two the last is free alone.
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
