//! Whether a search is to end, asked now and then in the middle of its work.

use std::cell::Cell;

/// Number of calls for each time that the end is asked for.
const EVERY: u32 = 64;

/// Asks now and then whether a search is to end; once it is, it stays so.
pub(crate) struct Watch<'a> {
    ended: &'a dyn Fn() -> bool,
    occasions: Cell<u32>,
    over: Cell<bool>,
}

impl<'a> Watch<'a> {
    /// A search that has not ended.
    pub(crate) const fn new(ended: &'a dyn Fn() -> bool) -> Self {
        Self { ended, occasions: Cell::new(0), over: Cell::new(false) }
    }

    /// Whether it is to end.
    #[inline]
    pub(crate) fn is_over(&self) -> bool {
        let occasions = self.occasions.get() + 1;
        if occasions < EVERY {
            self.occasions.set(occasions);
        } else {
            self.occasions.set(0);
            if !self.over.get() {
                self.over.set((self.ended)());
            }
        }
        self.over.get()
    }
}
