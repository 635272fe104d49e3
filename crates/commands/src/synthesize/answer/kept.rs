//! A solution that is told, as the search has it.

use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_synthesis::judge::Judged;
use epicyclic_synthesis::run::Found;
use epicyclic_synthesis::teeth::Design;
use epicyclic_synthesis::usable::Fault;
use epicyclic_synthesis::{family, rank};

/// A solution that is told, as the search has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// Its structure, shift elements and ratios.
    pub found: Found,
    /// Its best ring-to-sun ratios and its gearbox.
    pub judged: Judged,
    /// The gears that it has, by their places in the wish.
    pub selection: Vec<usize>,
    /// What it is worth.
    pub rating: rank::Rating,
    /// The limit of a gearbox that is of use that it misses first.
    pub fault: Option<Fault>,
    /// Its number among all solutions, from 1, the best first.
    pub number: usize,
    /// Its family.
    pub family: family::Family,
    /// The best tooth numbers, where any were asked for.
    pub teeth: Vec<Design>,
    /// How their sets close that have profile shift.
    pub shift: Option<ProfileShift>,
}
