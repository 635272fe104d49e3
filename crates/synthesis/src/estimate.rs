//! How long a search will take, from a sample of its structures.
//!
//! # Formula
//! A search learns functions as it goes, so its first structures take longer than the later ones. A sample, spread evenly over the
//! structures, is searched twice by one search; the second time it knows all functions that occur. With `m` structures of `N`, and
//! the times `c` and `w` of the two passes, one thread takes about
//!
//! ```text
//! t = w·N/m + (c − w)·√(N/m)
//! ```
//!
//! The second term supposes that functions become known as the words of a text do: their number grows with the root of its
//! length. It is a guess, but for a share of the class that is not small against the sample, it is the lesser term. Shares that work
//! apart each learn for themselves, so `n` of them take longer than the whole: in one of them stand `N/n` structures.

use crate::class::Class;
use crate::error::Error;
use crate::search::Search;
use crate::structure::Structure;
use crate::ternary::Word;
use crate::wish::Wish;
use crate::work::Share;

/// A sample of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Structures in the class.
    pub class_size: usize,
    /// Structures of the share.
    pub structures: usize,
    /// Structures of the sample.
    pub sampled: usize,
    /// How long it took, in s.
    pub first_s: f64,
    /// How long it took again, in s.
    pub again_s: f64,
    /// Bytes of what the search learned.
    pub learned: usize,
}

impl Sample {
    /// How many samples the share is.
    fn times(&self) -> f64 {
        self.structures as f64 / self.sampled.max(1) as f64
    }

    /// What the search took longer the first time, in s.
    fn learning(&self) -> f64 {
        (self.first_s - self.again_s).max(0.0)
    }

    /// How long one thread will take, in s.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        let times = self.times();
        self.again_s * times + self.learning() * times.sqrt()
    }

    /// Into how many shares the search is divided so that each takes one thread so many seconds.
    #[must_use]
    pub fn shares(&self, seconds: f64) -> f64 {
        // Of the root x of a share's structures over those of the sample: w·x² + (c − w)·x is the time of a share.
        let (again, learning) = (self.again_s, self.learning());
        let root = 2.0 * seconds / (learning + (learning * learning + 4.0 * again * seconds).sqrt());
        self.times() / (root * root)
    }

    /// About how many bytes a search on so many threads holds: the structures, and on each thread what it learned.
    #[must_use]
    pub fn bytes(&self, threads: usize) -> f64 {
        /// The members of a structure stand in a block of their own.
        const MEMBERS: usize = 32;
        let times = self.times();
        let of_structures = self.structures * (size_of::<Structure>() + MEMBERS);
        of_structures as f64 + threads as f64 * self.learned as f64 * times.sqrt()
    }
}

/// The fewest structures of a sample: from one to the next their times differ a hundredfold and more.
const FEWEST: usize = 8;

/// How many times its budget a sample may take to have so many.
const PATIENCE: f64 = 20.0;

/// A sample of the search through a share: as many structures as `budget_s` seconds of `clock`, in s, allow, or 8 where that many are
/// searched in twenty times as long, and at least one. It takes up to twice as long, and a structure that is begun is searched to its end.
///
/// # Errors
/// As [`search`](crate::run::search).
pub fn sample(
    class: Class,
    wish: &Wish,
    share: Share,
    budget_s: f64,
    clock: &dyn Fn() -> f64,
) -> Result<Sample, Error> {
    wish.check(class)?;
    let (structures, class_size) = share.structures(class, wish.double_planets);
    Ok(match class.sets() {
        1..=3 => of::<u8>(class, wish, &structures, class_size, budget_s, clock),
        4 => of::<u16>(class, wish, &structures, class_size, budget_s, clock),
        5 => of::<u32>(class, wish, &structures, class_size, budget_s, clock),
        _ => of::<u64>(class, wish, &structures, class_size, budget_s, clock),
    })
}

fn of<W: Word>(
    class: Class,
    wish: &Wish,
    structures: &[Structure],
    class_size: usize,
    budget_s: f64,
    clock: &dyn Fn() -> f64,
) -> Sample {
    let mut search = Search::<W>::new(wish.clone(), class.links());
    let places = spread(structures.len());
    let begun = clock();
    let mut sampled = 0;
    for place in &places {
        search.structure(&structures[*place]);
        sampled += 1;
        let taken = clock() - begun;
        if taken >= budget_s * PATIENCE || taken >= budget_s && sampled >= FEWEST {
            break;
        }
    }
    let between = clock();
    for place in &places[..sampled] {
        search.structure(&structures[*place]);
    }
    let (first_s, again_s) = (between - begun, clock() - between);
    let learned = search.bytes();
    Sample { class_size, structures: structures.len(), sampled, first_s, again_s, learned }
}

/// All places below a number, each once, in an order of which the first so many are spread evenly for any so many: by the rest of their
/// multiples of the golden section.
fn spread(count: usize) -> Vec<usize> {
    const SECTION: f64 = 0.618_033_988_749_894_9;
    let rest = |place: usize| (place as f64 * SECTION).fract();
    let mut places: Vec<usize> = (0..count).collect();
    places.sort_by(|one, other| rest(*one).total_cmp(&rest(*other)));
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Kind;
    use crate::parts::Bounds;
    use std::cell::Cell;

    #[test]
    fn places_are_spread_evenly_and_come_once() {
        for count in [1, 2, 3, 10, 97, 1000, 1001] {
            let mut places = spread(count);
            let tenth = places.len().div_ceil(10);
            let mut first = places[..tenth].to_vec();
            first.sort_unstable();
            let gap = first.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap_or(0);
            assert!(gap <= 21, "{count}: {gap}");
            places.sort_unstable();
            assert!(places.into_iter().eq(0..count));
        }
        assert!(spread(0).is_empty());
    }

    #[test]
    fn a_sample_is_as_long_as_its_budget_and_scales_to_the_share() {
        let gears = [2.56, 1.465].map(|ratio| Bounds { least: 0.99 * ratio, most: 1.01 * ratio });
        let wish = Wish::new(gears.into(), 2, vec![1.4..=4.5; 2]);
        let class = Class::new(Kind::Core, 2, 4).unwrap();
        let ticks = Cell::new(0.0);
        let clock = || {
            ticks.set(ticks.get() + 1.0);
            ticks.get()
        };
        let found = sample(class, &wish, Share::WHOLE, 10.0, &clock).unwrap();
        assert_eq!((found.class_size, found.structures, found.sampled), (111, 111, 10));
        assert_eq!((found.first_s, found.again_s), (11.0, 1.0));
        assert!((found.seconds() - (11.1 + 10.0 * 11.1f64.sqrt())).abs() < 1e-9);
        assert!(found.learned > 0 && found.bytes(2) > found.bytes(1));
        // A greater budget has more, and where structures take longer than its patience there are fewer.
        assert_eq!(sample(class, &wish, Share::WHOLE, 50.0, &clock).unwrap().sampled, 50);
        assert_eq!(sample(class, &wish, Share::WHOLE, 2.0, &clock).unwrap().sampled, FEWEST);
        assert_eq!(sample(class, &wish, Share::WHOLE, 0.15, &clock).unwrap().sampled, 3);
        // A share smaller than the budget is searched whole.
        let share = Share { number: 0, of: 40 };
        assert_eq!(sample(class, &wish, share, 10.0, &clock).unwrap().sampled, 3);
    }

    #[test]
    fn each_share_takes_as_long_as_it_may() {
        let whole = Sample {
            class_size: 9000,
            structures: 9000,
            sampled: 10,
            first_s: 4.0,
            again_s: 1.5,
            learned: 1,
        };
        for seconds in [0.5, 20.0, 900.0] {
            let shares = whole.shares(seconds);
            let share =
                Sample { structures: 9_000_000, sampled: (10_000.0 * shares).round() as usize, ..whole };
            assert!((share.seconds() / seconds - 1.0).abs() < 1e-3, "{shares} {}", share.seconds());
        }
        // Without anything to learn the time is only divided.
        let known = Sample { first_s: 1.5, ..whole };
        assert!((known.shares(135.0) - 10.0).abs() < 1e-12);
    }
}
