//! Counts of the results of a search.

/// Counts of the results of a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// Structures searched.
    pub structures: u64,
    /// Structures in which each gear is in reach of some elements.
    pub in_reach: u64,
    /// Sets of elements for which some part of the range of `k` was searched.
    pub candidates: u64,
    /// Sets that have all gears, but some `k` moves none of them: a simpler structure does the same.
    pub reducible: u64,
    /// Sets that have all gears, but no direct gear where one has to be.
    pub without_direct: u64,
    /// Sets that have all gears, but not with the single shifts that have to be.
    pub without_single_shifts: u64,
    /// Sets for which neither a point was found nor its absence proved.
    pub undecided: u64,
}

impl Tally {
    /// Names of the counts, in the order of [`Tally::counts`].
    pub const NAMES: [&str; 7] = [
        "structures",
        "in reach",
        "candidates",
        "reducible",
        "without direct gear",
        "without single shifts",
        "undecided",
    ];

    /// Counts in the order of `NAMES`.
    #[must_use]
    pub const fn counts(self) -> [u64; Self::NAMES.len()] {
        // Field by field, so that a new one is not forgotten.
        let Self {
            structures,
            in_reach,
            candidates,
            reducible,
            without_direct,
            without_single_shifts,
            undecided,
        } = self;
        [structures, in_reach, candidates, reducible, without_direct, without_single_shifts, undecided]
    }

    /// Tally of these counts.
    #[must_use]
    pub const fn of_counts(counts: [u64; Self::NAMES.len()]) -> Self {
        let [structures, in_reach, candidates, reducible, without_direct, without_single_shifts, undecided] =
            counts;
        Self { structures, in_reach, candidates, reducible, without_direct, without_single_shifts, undecided }
    }
}

impl std::ops::AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        let mut counts = self.counts();
        counts.iter_mut().zip(other.counts()).for_each(|(count, more)| *count += more);
        *self = Self::of_counts(counts);
    }
}
