//! Backend that searches the classes of a synthesis.

use super::left_out::LeftOut;
use super::tried::Searching;
use epicyclic_synthesis::run;
use epicyclic_synthesis::wish::Wish;
use std::ops::ControlFlow;

/// Backend that searches each class, and receives reports about the progress.
pub trait Means<E>: Sync {
    /// Searches a class; it first checks the [limits](super::Wanted::limits) with the gears of the class.
    /// Returns `None` if the class after [`going_on`](Self::going_on) is not to be searched.
    ///
    /// # Errors
    /// Those of the search.
    fn search(&mut self, searching: &Searching, wish: &Wish) -> Result<Option<run::Answer>, E>;

    /// Receives the number of evaluated solutions of a class; a break leaves out the others and ends the
    /// search.
    fn judged(&self, done: usize, of: usize) -> ControlFlow<()> {
        let _ = (done, of);
        ControlFlow::Continue(())
    }

    /// Called before evaluated solutions are rated; a break leaves out the others and ends the search.
    fn rated(&self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Whether the search is to end, so that no tooth numbers are searched.
    fn ended(&self) -> bool {
        false
    }

    /// Receives the reasons if all solutions so far were left out, and larger classes follow.
    fn nothing_kept(&mut self, searching: &Searching, left_out: &[LeftOut]) {
        let _ = (searching, left_out);
    }

    /// Receives the reasons if no gearbox found so far, in classes up to this one, is usable, and larger
    /// classes follow.
    fn going_on(&mut self, searching: &Searching, faults: &[LeftOut]) {
        let _ = (searching, faults);
    }
}

impl<E, F: FnMut(&Searching, &Wish) -> Result<run::Answer, E> + Sync> Means<E> for F {
    fn search(&mut self, searching: &Searching, wish: &Wish) -> Result<Option<run::Answer>, E> {
        self(searching, wish).map(Some)
    }
}
