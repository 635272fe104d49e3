//! What is wanted of a gearbox, and whether any can have it.

use crate::choices::choose;
use crate::class::Class;
use crate::error::Error;
use crate::motion::elements;
use crate::parts::Bounds;
use crate::rules::Rules;
use std::ops::RangeInclusive;

/// The most gears of a wish: one bit each.
pub const MOST_GEARS: usize = 30;

/// What is wanted of a gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct Wish {
    /// The bounds of each gear's ratio.
    pub gears: Vec<Bounds>,
    /// How many elements.
    pub elements: usize,
    /// The range of each set's ring-to-sun ratio, of a double-planet set that of `k′ = k − 1`.
    pub k: Vec<RangeInclusive<f64>>,
    /// How many of the sets, the last of them, are double-planet sets; any sets of a structure may be.
    pub double_planets: usize,
    /// What else a gearbox has to keep.
    pub rules: Rules,
}

impl Wish {
    /// A wish without further rules.
    #[must_use]
    pub fn new(gears: Vec<Bounds>, elements: usize, k: Vec<RangeInclusive<f64>>) -> Self {
        Self { gears, elements, k, double_planets: 0, rules: Rules::default() }
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
            if !ordered || gear.least * gear.most <= 0.0 {
                let Bounds { least, most } = gear;
                return fault(format!(
                    "gear {} from {least} to {most}: the bounds need one sign, the lower first",
                    place + 1
                ));
            }
            if let Some(other) = self.gears[..place]
                .iter()
                .position(|other| other.least <= gear.most && gear.least <= other.most)
            {
                return fault(format!(
                    "gears {} and {} overlap: {}…{} and {}…{}; make the tolerance smaller",
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
        self.rules.check(&self.gears, self.elements)
    }
}

/// The forward gears, the highest ratio first.
#[must_use]
pub fn forward(gears: &[Bounds]) -> Vec<usize> {
    let mut forward: Vec<usize> = (0..gears.len()).filter(|gear| gears[*gear].least > 0.0).collect();
    forward.sort_by(|one, other| gears[*other].most.total_cmp(&gears[*one].most));
    forward
}
