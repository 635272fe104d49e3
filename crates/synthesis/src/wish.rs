//! Requirements for a gearbox, and whether any gearbox can fulfil them.

use crate::choices::choose;
use crate::class::{Class, MOST_ELEMENTS};
use crate::equal::Equal;
use crate::error::Error;
use crate::motion::elements;
use crate::parts::Bounds;
use crate::ratio::Ratio;
use crate::refine::{Refined, refine};
use crate::rules::Rules;
use std::ops::RangeInclusive;

/// The most gears of a wish: one bit each.
pub const MOST_GEARS: usize = 30;

/// Requirements for a gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct Wish {
    /// The bounds of each gear's ratio.
    pub gears: Vec<Bounds>,
    /// Number of shift elements.
    pub elements: usize,
    /// The range of each set's ring-to-sun ratio, of a double-planet set that of `k′ = k − 1`.
    pub k: Vec<RangeInclusive<f64>>,
    /// Number of double-planet sets, which are the last; any sets of a structure may be.
    pub double_planets: usize,
    /// Least number of sets of one kind with equal `k`; 0 and 1 require nothing.
    pub equal_k: usize,
    /// Gears side by side, by their places, each list the highest ratio first: their bounds may overlap, and
    /// their ratios fall. Of these any ratio within the bounds is as good.
    pub side_by_side: Vec<Vec<usize>>,
    /// Further rules for the gearbox.
    pub rules: Rules,
}

impl Wish {
    /// A wish without further rules.
    #[must_use]
    pub fn new(gears: Vec<Bounds>, elements: usize, k: Vec<RangeInclusive<f64>>) -> Self {
        Self {
            gears,
            elements,
            k,
            double_planets: 0,
            equal_k: 0,
            side_by_side: Vec::new(),
            rules: Rules::default(),
        }
    }

    /// Whether gearboxes of a class can have these gears at all.
    ///
    /// # Errors
    /// [`Error::Wish`].
    pub fn check(&self, class: Class) -> Result<(), Error> {
        let (gears, engaged) = (self.gears.len(), class.engaged());
        let fault = |why: String| Err(Error::Wish { why });
        if !(1..=MOST_GEARS).contains(&gears) {
            return fault(format!("{gears} gears: there may be 1 to {MOST_GEARS}"));
        }
        for (place, gear) in self.gears.iter().enumerate() {
            let ordered = gear.least.is_finite() && gear.most.is_finite() && gear.least <= gear.most;
            // The product is positive only if both bounds have one sign and neither is 0.
            if !ordered || gear.least * gear.most <= 0.0 {
                let Bounds { least, most } = gear;
                return fault(format!(
                    "gear {} from {least} to {most}: the bounds need one sign, the lower first",
                    place + 1
                ));
            }
            if let Some(other) = self.gears[..place].iter().enumerate().position(|(before, other)| {
                other.least <= gear.most && gear.least <= other.most && !self.are_side_by_side(before, place)
            }) {
                return fault(format!(
                    "gears {} and {} overlap: {}…{} and {}…{}; make the tolerance smaller, or part the ranges",
                    other + 1,
                    place + 1,
                    self.gears[other].least,
                    self.gears[other].most,
                    gear.least,
                    gear.most
                ));
            }
        }
        if self.elements < engaged {
            return fault(format!(
                "{} shift elements, yet a gear of {class} engages {engaged}",
                self.elements
            ));
        }
        if self.elements > MOST_ELEMENTS {
            return fault(format!("{} shift elements: there may be {MOST_ELEMENTS} at most", self.elements));
        }
        let pairs = elements(class.links()).len();
        if self.elements > pairs {
            return fault(format!(
                "{} shift elements, yet {class} have {pairs} pairs of links",
                self.elements
            ));
        }
        let choices = choose(self.elements, engaged);
        if choices < gears {
            return fault(format!(
                "{gears} gears, yet {} shift elements, {engaged} of them engaged, give {choices} at most",
                self.elements
            ));
        }
        if self.k.len() != class.sets() {
            return fault(format!("{} ranges of k for {} planet sets", self.k.len(), class.sets()));
        }
        if self.double_planets > class.sets() {
            return fault(format!(
                "{} double-planet sets of {} planet sets",
                self.double_planets,
                class.sets()
            ));
        }
        for (place, range) in self.k.iter().enumerate() {
            let (least, most) = (*range.start(), *range.end());
            if !(least.is_finite() && most.is_finite() && least > 0.0 && least <= most) {
                return fault(format!(
                    "k of set {} from {least} to {most}: the range is empty or not above 0",
                    place + 1
                ));
            }
        }
        self.check_side_by_side()?;
        self.check_equal_k()?;
        self.rules.check(&self.gears, self.elements)
    }

    /// Pairs of gears side by side, the first with the higher ratio.
    #[must_use]
    pub fn falling(&self) -> Vec<[usize; 2]> {
        self.side_by_side.iter().flat_map(|run| run.windows(2).map(|pair| [pair[0], pair[1]])).collect()
    }

    /// Whether ratios of gears side by side fall.
    #[must_use]
    pub fn are_falling(&self, ratios: &[f64]) -> bool {
        self.falling().iter().all(|[higher, lower]| ratios[*higher] > ratios[*lower])
    }

    fn are_side_by_side(&self, one: usize, other: usize) -> bool {
        self.side_by_side.iter().any(|run| run.contains(&one) && run.contains(&other))
    }

    /// The best `k` of a solution with these ratios and this point.
    #[must_use]
    pub fn refine(&self, ratios: &[Ratio], point: &[f64], equal: Equal) -> Refined {
        let whole = self.k.iter().map(|range| [*range.start(), *range.end()]).collect();
        refine(ratios, &self.gears, &self.side_by_side.concat(), &whole, point, equal)
    }

    /// Whether gears side by side are gears of the wish, each once, with falling bounds.
    fn check_side_by_side(&self) -> Result<(), Error> {
        let mut all = self.side_by_side.concat();
        all.sort_unstable();
        let once = all.windows(2).all(|pair| pair[0] < pair[1]);
        let bounds = |gear: usize| self.gears.get(gear).copied();
        let falls = |[higher, lower]: &[usize; 2]| {
            let (Some(higher), Some(lower)) = (bounds(*higher), bounds(*lower)) else { return false };
            higher.least >= lower.least && higher.most >= lower.most
        };
        if once && all.iter().all(|gear| *gear < self.gears.len()) && self.falling().iter().all(falls) {
            return Ok(());
        }
        let why = format!("gears side by side {:?}: each once, with falling bounds", self.side_by_side);
        Err(Error::Wish { why })
    }

    /// Whether this number of sets can have equal `k`.
    fn check_equal_k(&self) -> Result<(), Error> {
        if self.equal_k <= 1 {
            return Ok(());
        }
        let (simple, double) = self.k.split_at(self.k.len() - self.double_planets);
        let most = simple.len().max(double.len());
        if most < self.equal_k {
            let why =
                format!("{} sets of one kind with equal k, yet there are {most} of one kind", self.equal_k);
            return Err(Error::Wish { why });
        }
        // The boxes of the solver have one range for all sets with equal k.
        if [simple, double].iter().any(|ranges| ranges.windows(2).any(|pair| pair[0] != pair[1])) {
            let why = "equal k are searched among sets of one kind: these need one range of k".into();
            return Err(Error::Wish { why });
        }
        Ok(())
    }
}

/// The forward gears, the highest ratio first.
#[must_use]
pub fn forward(gears: &[Bounds]) -> Vec<usize> {
    let mut forward: Vec<usize> = (0..gears.len()).filter(|gear| gears[*gear].least > 0.0).collect();
    forward.sort_by(|one, other| gears[*other].most.total_cmp(&gears[*one].most));
    forward
}
