//! Counts of what a search came to.

/// Counts of what a search came to.
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

impl std::ops::AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.structures += other.structures;
        self.in_reach += other.in_reach;
        self.candidates += other.candidates;
        self.reducible += other.reducible;
        self.without_direct += other.without_direct;
        self.without_single_shifts += other.without_single_shifts;
        self.undecided += other.undecided;
    }
}
