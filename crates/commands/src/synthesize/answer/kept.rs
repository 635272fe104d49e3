//! Solution of a search with its evaluation.

use epicyclic_gears::involute::search::ProfileShift;
use epicyclic_synthesis::judge::Judged;
use epicyclic_synthesis::run::Found;
use epicyclic_synthesis::teeth::Design;
use epicyclic_synthesis::usable::Fault;
use epicyclic_synthesis::{family, rank};

/// Solution of a search with its evaluation.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// Structure, shift elements and ratios.
    pub found: Found,
    /// Best ring-to-sun ratios, and the gearbox with them.
    pub judged: Judged,
    /// Gears of the solution, by their places in the list of required gears.
    pub selection: Vec<usize>,
    /// Values of the objectives.
    pub rating: rank::Rating,
    /// First limit of a usable gearbox that the solution exceeds; `None` if it exceeds none.
    pub fault: Option<Fault>,
    /// Number among all solutions, from 1, the best first.
    pub number: usize,
    /// Family of the solution.
    pub family: family::Family,
    /// Best tooth numbers; empty unless they are requested.
    pub teeth: Vec<Design>,
    /// Profile shifts for the equal centre distances of the sets; `None` without profile shift.
    pub shift: Option<ProfileShift>,
}
