//! The means by which the classes of a synthesis are searched.

use super::left_out::LeftOut;
use super::tried::Searching;
use epicyclic_synthesis::run;
use epicyclic_synthesis::wish::Wish;
use std::ops::ControlFlow;

/// How each class is searched, and who is told of what follows.
pub trait Means<E>: Sync {
    /// Searches a class; checks the [limits](super::Wanted::limits) with its gears first. Nothing where
    /// [more](Self::going_on) is not searched.
    ///
    /// # Errors
    /// Those of the search.
    fn search(&mut self, searching: &Searching, wish: &Wish) -> Result<Option<run::Answer>, E>;

    /// So many of a class's solutions are judged; a break leaves out the others and ends the search.
    fn judged(&self, done: usize, of: usize) -> ControlFlow<()> {
        let _ = (done, of);
        ControlFlow::Continue(())
    }

    /// Whether solutions that were judged are rated, too; a break leaves out the others and ends the search.
    fn rated(&self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Whether the search is asked to end: then no tooth numbers are looked for.
    fn ended(&self) -> bool {
        false
    }

    /// All that was found so far was left out, so that larger classes follow, if there are any.
    fn nothing_kept(&mut self, searching: &Searching, left_out: &[LeftOut]) {
        let _ = (searching, left_out);
    }

    /// None of the gearboxes found so far, in classes up to this, is of use, by these faults: larger classes
    /// follow, if there are any.
    fn going_on(&mut self, searching: &Searching, faults: &[LeftOut]) {
        let _ = (searching, faults);
    }
}

impl<E, F: FnMut(&Searching, &Wish) -> Result<run::Answer, E> + Sync> Means<E> for F {
    fn search(&mut self, searching: &Searching, wish: &Wish) -> Result<Option<run::Answer>, E> {
        self(searching, wish).map(Some)
    }
}
