//! Costs as small whole numbers in the same order, sixteen at a time.
//!
//! A cost that is at or below another has a rank at or below its rank. Costs therefore need to be compared
//! only where ranks do not decide.

/// Number of designs from which the steps of a scale are chosen.
const SAMPLE: usize = 2048;

/// Steps of a scale.
const STEPS: usize = 256;

/// Ranks of a step.
const OF_STEP: u16 = 255;

/// Scale from costs to ranks: steps that divide the designs evenly, and a straight line between two of them.
#[derive(Debug)]
struct Scale {
    steps: Vec<f64>,
    slopes: Vec<f64>,
}

impl Scale {
    fn new(mut sample: Vec<f64>) -> Self {
        sample.sort_unstable_by(f64::total_cmp);
        let steps: Vec<f64> = sample.into_iter().step_by(SAMPLE / STEPS).collect();
        let slope = |pair: &[f64]| f64::from(OF_STEP) / (pair[1] - pair[0]);
        let slopes = steps.windows(2).map(slope).chain([0.0]).collect();
        Self { steps, slopes }
    }

    /// Rank of a cost, which never falls where the cost rises: the steps are in order, and differences,
    /// products and their integer parts keep that order. NaN, the result for an infinite cost, counts as 0
    /// within its step.
    #[inline]
    fn rank(&self, cost: f64) -> u16 {
        let Some(step) = self.steps.partition_point(|step| *step <= cost).checked_sub(1) else { return 0 };
        let part = (cost - self.steps[step]) * self.slopes[step];
        (step as u16 + 1) * OF_STEP + (part as u16).min(OF_STEP - 1)
    }
}

/// Scales of all costs.
#[derive(Debug)]
pub(crate) struct Scales<const N: usize>([Scale; N]);

impl<const N: usize> Scales<N> {
    /// Scales that suit a sample of the designs.
    pub(crate) fn new(costs: &[[f64; N]], places: &[u32]) -> Self {
        let step = places.len() / SAMPLE + 1;
        let sample =
            |cost: usize| places.iter().step_by(step).map(|&place| costs[place as usize][cost]).collect();
        Self(std::array::from_fn(|cost| Scale::new(sample(cost))))
    }

    #[inline]
    pub(crate) fn ranks(&self, costs: &[f64; N]) -> [u16; N] {
        std::array::from_fn(|cost| self.0[cost].rank(costs[cost]))
    }
}

/// Number of designs that are compared at once.
pub(crate) const WIDE: usize = 16;

/// A rank above that of any cost.
const NONE: u16 = u16::MAX;

/// Ranks by cost, of sixteen.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Columns<const N: usize>([[u16; WIDE]; N]);

impl<const N: usize> Columns<N> {
    /// No designs: ranks above those of any cost.
    pub(crate) const EMPTY: Self = Self([[NONE; WIDE]; N]);

    #[inline]
    pub(crate) fn set(&mut self, lane: usize, ranks: &[u16; N]) {
        for (column, rank) in self.0.iter_mut().zip(ranks) {
            column[lane] = *rank;
        }
    }

    #[inline]
    pub(crate) fn get(&self, lane: usize) -> [u16; N] {
        std::array::from_fn(|cost| self.0[cost][lane])
    }

    /// Designs whose ranks are all at or below the given ones, as bits.
    #[inline]
    pub(crate) fn at_or_below(&self, ranks: &[u16; N]) -> u32 {
        self.lanes(|cost, rank| rank.saturating_sub(ranks[cost]))
    }

    /// Designs whose ranks are all at or above the given ones, as bits.
    #[inline]
    pub(crate) fn at_or_above(&self, ranks: &[u16; N]) -> u32 {
        self.lanes(|cost, rank| ranks[cost].saturating_sub(rank))
    }

    /// Designs for which every excess is 0, as bits.
    #[inline]
    fn lanes(&self, excess: impl Fn(usize, u16) -> u16) -> u32 {
        // Lane by lane and without a branch: for instructions that take several at once.
        let mut above = [0_u16; WIDE];
        for (cost, column) in self.0.iter().enumerate() {
            for (above, rank) in above.iter_mut().zip(column) {
                *above |= excess(cost, *rank);
            }
        }
        above.iter().enumerate().fold(0, |found, (lane, above)| found | u32::from(*above == 0) << lane)
    }
}
