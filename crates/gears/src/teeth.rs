//! A number of teeth that is at least one.

use std::fmt;
use std::num::NonZeroU32;

use crate::Error;

/// Number of teeth `z` of a wheel, never zero.
///
/// Internal wheels have positive counts too: what is internal is said by [`Toothing`](crate::geometry::Toothing), not
/// by a sign.
///
/// ```
/// use epicyclic_gears::{Error, ToothCount};
///
/// assert_eq!(ToothCount::new(20)?.get(), 20);
/// assert_eq!(ToothCount::new(0), Err(Error::TooFew { what: "teeth", count: 0, at_least: 1 }));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ToothCount(NonZeroU32);

impl ToothCount {
    /// A count of `teeth`.
    ///
    /// # Errors
    /// [`Error::TooFew`] for 0.
    pub fn new(teeth: u32) -> Result<Self, Error> {
        NonZeroU32::new(teeth).map(Self).ok_or(Error::TooFew {
            what: "teeth",
            count: teeth,
            at_least: 1,
        })
    }

    /// The count as a plain number.
    #[must_use]
    pub const fn get(self) -> u32 {
        self.0.get()
    }
}

impl TryFrom<u32> for ToothCount {
    type Error = Error;

    fn try_from(teeth: u32) -> Result<Self, Error> {
        Self::new(teeth)
    }
}

impl fmt::Display for ToothCount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
