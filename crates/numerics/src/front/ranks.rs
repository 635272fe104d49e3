//! Costs as small whole numbers in the same order, sixteen at a time.
//!
//! A cost at or below another has a rank at or below its rank. So of what ranks rule out the costs need not
//! be asked; where ranks do not decide, they are.

/// Designs of which the steps are taken.
const SAMPLE: usize = 2048;

/// Steps of a scale.
const STEPS: usize = 256;

/// Ranks of a step.
const OF_STEP: u16 = 255;

/// From a cost to its rank: steps that part the designs evenly, and between two of them a straight line.
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

    /// Never falls where the cost rises: the steps are in order, and differences, products and their whole
    /// parts keep it. What is not a number there, of a cost without end, counts as 0 for all of its step.
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
    /// Those that suit some of the designs.
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

/// How many stand beside each other.
pub(crate) const WIDE: usize = 16;

/// A rank above that of any cost.
const NONE: u16 = u16::MAX;

/// Ranks by cost, of sixteen.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Columns<const N: usize>([[u16; WIDE]; N]);

impl<const N: usize> Columns<N> {
    /// Of nothing: above all.
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

    /// Which are nowhere above some ranks, by bit.
    #[inline]
    pub(crate) fn at_or_below(&self, ranks: &[u16; N]) -> u32 {
        self.lanes(|cost, rank| rank.saturating_sub(ranks[cost]))
    }

    /// Which are nowhere below some ranks, by bit.
    #[inline]
    pub(crate) fn at_or_above(&self, ranks: &[u16; N]) -> u32 {
        self.lanes(|cost, rank| ranks[cost].saturating_sub(rank))
    }

    /// Of which no excess is above 0, by bit.
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
