//! Classes that are searched for a list of ratios, in their order.

use super::Wanted;
use crate::error::Error;
use epicyclic_synthesis::Class;
use epicyclic_synthesis::motion::elements;
use epicyclic_synthesis::wish::Wish;

/// Class that may be searched, with the requirements for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Tried {
    /// Class to be searched.
    pub searching: Searching,
    /// Requirements for this class.
    pub wish: Wish,
    /// Gears of the requirements, by their places in the list of required gears.
    pub selection: Vec<usize>,
}

/// Classes that may be searched, in their order, with the requirements for each. Classes that cannot have the
/// ratios are left out.
///
/// # Errors
/// [`Error::Synthesis`] if there is no class, and for inconsistent gears.
pub fn tried(wanted: &Wanted) -> Result<Vec<Tried>, Error> {
    let gears = wanted.gears()?;
    let (mut tried, mut refused) = (Vec::new(), None);
    for (sets, shift_elements, engaged) in wanted.numbers() {
        for selection in wanted.selections() {
            for double_planets in wanted.double_planets.clone().take_while(|count| *count <= sets) {
                let bounds = selection.iter().map(|gear| gears[*gear].bounds()).collect();
                let mut wish = Wish::new(bounds, shift_elements, wanted.ranges(sets, double_planets));
                wish.double_planets = double_planets;
                wish.equal_k = wanted.equal_k;
                wish.side_by_side = wanted.side_by_side(&selection, &gears);
                wish.rules = wanted.rules.clone();
                let class = Class::new(wanted.kind, sets, sets + engaged + 1);
                match class.and_then(|class| wish.check(class).map(|()| class)) {
                    Ok(class) => {
                        let searching = Searching { class, shift_elements, double_planets };
                        tried.push(Tried { searching, wish, selection: selection.clone() });
                    }
                    Err(error) => {
                        // The error of the largest class is the most informative one.
                        refused = Some(error);
                    }
                }
            }
        }
    }
    if !tried.is_empty() {
        return Ok(tried);
    }
    let why = "no number of sets, links, shift elements, engaged and open ones is within all ranges: links are sets, engaged \
               elements and 1, open elements those not engaged";
    Err(refused.unwrap_or_else(|| epicyclic_synthesis::Error::Wish { why: why.into() }).into())
}

/// Class that is being searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Searching {
    /// Class of structures.
    pub class: Class,
    /// Number of shift elements.
    pub shift_elements: usize,
    /// Number of double-planet sets among the sets.
    pub double_planets: usize,
}

impl Searching {
    /// Size of the search space: structures times choices of double-planet sets times sets of shift elements.
    #[must_use]
    pub fn space(&self, structures: f64) -> f64 {
        let choose = |count: usize, of: usize| {
            (0..of).fold(1.0, |all, place| all * (count - place) as f64 / (place + 1) as f64)
        };
        let pairs = elements(self.class.links()).len();
        let structures = structures * choose(self.class.sets(), self.double_planets);
        (0..self.shift_elements)
            .fold(structures, |all, place| all * pairs.saturating_sub(place) as f64 / (place + 1) as f64)
    }
}
