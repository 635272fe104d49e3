//! Estimate of the time of a search, from a sample of its structures.
//!
//! # Formula
//! A search learns functions as it goes, so its first structures take longer than the later ones. A sample,
//! spread evenly over the structures, is searched twice by one search; the second time it knows all functions
//! that occur. Let the class have `N` structures, the sample `m`, and let the two passes take the times `c`
//! and `w`. One thread then takes about
//!
//! ```text
//! t = w·N/m + (c − w)·√(N/m)
//! ```
//!
//! The second term assumes that functions become known as the words of a text do: their number grows with the
//! root of its length. This is a guess. For a share of the class that is large against the sample, it is the
//! smaller term. Shares that work apart each learn for themselves, so `n` of them take longer than the whole:
//! each has `N/n` structures.
//!
//! The structures of five and six sets take long to count. If the count takes longer than a budget, their
//! number is estimated by draws. A draw goes from set to set, each time to one of those that may follow. The
//! mean of the product of the numbers of sets that could follow is the number of structures. The sample is
//! then taken from the drawn structures, each as often as its product requires.

use crate::choices::choose;
use crate::class::Class;
use crate::count;
use crate::enumerate;
use crate::error::Error;
use crate::search::Search;
use crate::structure::Structure;
use crate::ternary::Word;
use crate::wish::Wish;
use crate::work::Share;

/// Number of structures of a class.
#[derive(Debug, Clone, PartialEq)]
pub struct Size {
    /// Number of structures: counted, or estimated by draws.
    pub structures: usize,
    /// Drawn structures, with the products of the numbers of sets that could follow; empty if all were
    /// counted.
    drawn: Vec<(f64, Structure)>,
}

impl Size {
    /// Whether the structures were counted.
    #[must_use]
    pub const fn is_counted(&self) -> bool {
        self.drawn.is_empty()
    }

    /// Takes `count` of the drawn structures, one of each choice of double-planet sets, each as often as its
    /// product requires, but never twice.
    fn spread(&self, count: usize, double_planets: usize) -> Vec<Structure> {
        let all: f64 = self.drawn.iter().map(|(weight, _)| weight).sum();
        let (mut reached, mut wanted) = (0.0, 0.5);
        let mut structures = Vec::new();
        for (weight, structure) in &self.drawn {
            reached += weight / all * count as f64;
            if reached <= wanted {
                continue;
            }
            let choices = structure.with_double_planets(double_planets);
            structures.extend(choices.get(structures.len() % choices.len().max(1)).cloned());
            wanted = reached.ceil().max(wanted + 1.0);
        }
        structures
    }
}

/// Number of structures of a class. They are counted if that takes at most `budget_s` seconds of `clock`, in
/// s; else their number is estimated by draws for as long. `None` if `ended`, which is called now and then,
/// ends it.
pub fn size(class: Class, budget_s: f64, clock: &dyn Fn() -> f64, ended: &dyn Fn() -> bool) -> Option<Size> {
    let begun = clock();
    if let Some(structures) = count::structures(class, &|| ended() || clock() - begun > budget_s) {
        return Some(Size { structures, drawn: Vec::new() });
    }
    let begun = clock();
    let mut state = 0;
    let mut below = |count: usize| {
        // SplitMix64: the same draws at each call.
        state = u64::wrapping_add(state, 0x9e37_79b9_7f4a_7c15);
        let mixed = (state ^ state >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((u128::from(mixed ^ mixed >> 31) * count as u128) >> 64) as usize
    };
    let (mut drawn, mut all, mut draws) = (Vec::new(), 0.0, 0);
    while draws < FEWEST_DRAWS || clock() - begun < budget_s {
        if ended() {
            return None;
        }
        let (weight, sets) = enumerate::draw(class, &mut below);
        all += weight;
        draws += 1;
        drawn.extend(sets.map(|sets| (weight, Structure::of_canonical_word(sets, class.links()))));
        if draws == MOST_DRAWS {
            break;
        }
    }
    Some(Size { structures: (all / f64::from(draws)).round() as usize, drawn })
}

/// The fewest draws of an estimate, and the most.
const FEWEST_DRAWS: u32 = 100;
const MOST_DRAWS: u32 = 20_000;

/// The most structures of a sample that are drawn.
const MOST_SAMPLED: usize = 1000;

/// A sample of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Structures in the class.
    pub class_size: usize,
    /// Structures of the share.
    pub structures: usize,
    /// Structures of the sample.
    pub sampled: usize,
    /// Time of the first pass, in s.
    pub first_s: f64,
    /// Time of the second pass, in s.
    pub again_s: f64,
    /// Memory of the functions that the search learned, bytes.
    pub learned: usize,
    /// Whether it was ended before its last structure was searched: then all times are more.
    pub is_cut: bool,
}

impl Sample {
    /// Size of the share in samples.
    fn times(&self) -> f64 {
        self.structures as f64 / self.sampled.max(1) as f64
    }

    /// Extra time of the first pass over the second, in s.
    fn learning(&self) -> f64 {
        (self.first_s - self.again_s).max(0.0)
    }

    /// Estimated time of one thread, in s.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        let times = self.times();
        self.again_s * times + self.learning() * times.sqrt()
    }

    /// Number of shares into which the search is divided so that each takes one thread this time, in s.
    #[must_use]
    pub fn shares(&self, seconds: f64) -> f64 {
        // Of the root x of a share's structures over those of the sample: w·x² + (c − w)·x is the time of a
        // share.
        let (again, learning) = (self.again_s, self.learning());
        let root = 2.0 * seconds / (learning + (learning * learning + 4.0 * again * seconds).sqrt());
        self.times() / (root * root)
    }

    /// Approximate memory of a search on this number of threads, in bytes: the structures, and on each thread
    /// the functions learned.
    #[must_use]
    pub fn bytes(&self, threads: usize) -> f64 {
        /// Bytes of the members of a structure, which are a block of their own.
        const MEMBERS: usize = 32;
        let times = self.times();
        let of_structures = self.structures * (size_of::<Structure>() + MEMBERS);
        of_structures as f64 + threads as f64 * self.learned as f64 * times.sqrt()
    }
}

/// The fewest structures of a sample: from one to the next their times differ a hundredfold and more.
const FEWEST: usize = 8;

/// Largest multiple of its budget that a sample may take to reach the fewest structures.
const PATIENCE: f64 = 20.0;

/// Searches a sample of a share of a class of this size. The sample has as many structures as `budget_s`
/// seconds of `clock`, in s, allow, or 8 if these are searched in twenty times as long, and at least one. It
/// takes up to twice as long; if `ended`, which is called now and then, ends it, the sample is cut.
///
/// # Errors
/// As [`search`](crate::run::search).
pub fn sample(
    class: Class,
    wish: &Wish,
    share: Share,
    size: &Size,
    (budget_s, clock): (f64, &dyn Fn() -> f64),
    ended: &dyn Fn() -> bool,
) -> Result<Sample, Error> {
    wish.check(class)?;
    let cut = |structures| Sample {
        class_size: size.structures,
        structures,
        sampled: 0,
        first_s: 0.0,
        again_s: 0.0,
        learned: 0,
        is_cut: true,
    };
    let choices = choose(class.sets(), wish.double_planets);
    let (structures, count) = if size.is_counted() {
        let Some((structures, _)) = share.structures(class, wish.double_planets, ended) else {
            return Ok(cut(size.structures * choices / share.of));
        };
        let count = structures.len();
        let places = spread(count);
        (places.into_iter().map(|place| structures[place].clone()).take(MOST_SAMPLED).collect(), count)
    } else {
        let drawn = size.spread(MOST_SAMPLED, wish.double_planets);
        let places = spread(drawn.len());
        let structures: Vec<Structure> = places.into_iter().map(|place| drawn[place].clone()).collect();
        (structures, size.structures * choices / share.of)
    };
    let until = (budget_s, clock, ended);
    Ok(match class.sets() {
        1..=3 => of::<u8>(class, wish, &structures, cut(count), until),
        4 => of::<u16>(class, wish, &structures, cut(count), until),
        5 => of::<u32>(class, wish, &structures, cut(count), until),
        _ => of::<u64>(class, wish, &structures, cut(count), until),
    })
}

fn of<W: Word>(
    class: Class,
    wish: &Wish,
    structures: &[Structure],
    sample: Sample,
    (budget_s, clock, ended): (f64, &dyn Fn() -> f64, &dyn Fn() -> bool),
) -> Sample {
    let mut search = Search::<W>::new(wish.clone(), class.links());
    let begun = clock();
    let (mut sampled, mut is_cut) = (0, false);
    for structure in structures {
        is_cut = search.structure_unless(structure, ended).is_none();
        sampled += 1;
        let taken = clock() - begun;
        if is_cut || taken >= budget_s * PATIENCE || taken >= budget_s && sampled >= FEWEST {
            break;
        }
    }
    let between = clock();
    let first_s = between - begun;
    // A search that is cut has not learned all functions.
    let is_cut =
        is_cut || !structures[..sampled].iter().all(|one| search.structure_unless(one, ended).is_some());
    let again_s = if is_cut { first_s } else { clock() - between };
    Sample { sampled, first_s, again_s, learned: search.bytes(), is_cut, ..sample }
}

/// Places below a number, each once, in an order whose beginnings of any length are spread evenly. They are
/// sorted by the fractional part of their multiples of the golden section.
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
        let size = size(class, 1e9, &|| 0.0, &|| false).unwrap();
        assert!(size.is_counted() && size.structures == 111);
        let sample = |share, budget| sample(class, &wish, share, &size, (budget, &clock), &|| false).unwrap();
        let found = sample(Share::WHOLE, 10.0);
        assert_eq!((found.class_size, found.structures, found.sampled), (111, 111, 10));
        assert_eq!((found.first_s, found.again_s), (11.0, 1.0));
        assert!((found.seconds() - (11.1 + 10.0 * 11.1f64.sqrt())).abs() < 1e-9);
        assert!(found.learned > 0 && found.bytes(2) > found.bytes(1));
        // A greater budget has more, and where structures take longer than its patience there are fewer.
        assert_eq!(sample(Share::WHOLE, 50.0).sampled, 50);
        assert_eq!(sample(Share::WHOLE, 2.0).sampled, FEWEST);
        assert_eq!(sample(Share::WHOLE, 0.15).sampled, 3);
        // A share smaller than the budget is searched whole.
        let share = Share { number: 0, of: 40 };
        assert_eq!(sample(share, 10.0).sampled, 3);
    }

    /// Classes that are not counted in time have as many structures by draws, within a tenth.
    #[test]
    fn draws_estimate_how_many_structures_there_are() {
        for (kind, sets, links) in
            [(Kind::Core, 3, 5), (Kind::Core, 3, 6), (Kind::AllSparse, 3, 5), (Kind::Core, 4, 7)]
        {
            let class = Class::new(kind, sets, links).unwrap();
            let counted = count::structures(class, &|| false).unwrap();
            // Time stands still after a first moment: the count is over its budget, and the draws end by
            // their number.
            let moments = Cell::new(0);
            let clock = || {
                moments.set(moments.get() + 1);
                if moments.get() == 1 { -2.0 } else { 0.0 }
            };
            let drawn = size(class, 1.0, &clock, &|| false).unwrap();
            assert!(!drawn.is_counted());
            let off = drawn.structures as f64 / counted as f64 - 1.0;
            assert!(off.abs() < 0.1, "{class}: {counted}, {} by draws", drawn.structures);
            let spread = drawn.spread(100, 1);
            assert!((50..=100).contains(&spread.len()), "{}", spread.len());
        }
        let class = Class::new(Kind::Core, 3, 6).unwrap();
        assert!(size(class, 1.0, &|| 0.0, &|| true).is_none());
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
            is_cut: false,
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
