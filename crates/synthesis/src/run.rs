//! A search through a whole class, or a share of it: on all threads of the pool with the feature `parallel`, else on one.

use crate::choices::choose;
use crate::class::Class;
use crate::enumerate;
use crate::error::Error;
use crate::motion::elements;
use crate::parts::Bounds;
use crate::search::{Search, Solution, Tally, Wish};
use crate::structure::Structure;
use crate::ternary::Word;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// The most gears of a wish: one bit each.
pub const MOST_GEARS: usize = 30;

/// A solution and its structure.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The structure.
    pub structure: Structure,
    /// Elements, ring-to-sun ratios and gears.
    pub solution: Solution,
}

/// How far a search is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Structures that were searched.
    pub done: usize,
    /// Structures to search.
    pub of: usize,
    /// Solutions so far.
    pub found: usize,
}

/// Which structures of a class are searched: of `of` shares the one with this number, from 0. The structures are dealt out in
/// turn in the order of their canonical words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Share {
    /// The number of the share.
    pub number: usize,
    /// How many shares there are.
    pub of: usize,
}

impl Share {
    /// The whole class.
    pub const WHOLE: Self = Self { number: 0, of: 1 };
}

/// What a search found.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Structures in the class.
    pub class_size: usize,
    /// Solutions in the order of their structures and elements.
    pub found: Vec<Found>,
    /// What was searched.
    pub tally: Tally,
    /// Whether all structures were searched, not ended by `progress`.
    pub complete: bool,
}

/// All gearboxes of a class that have the wanted gears.
///
/// `progress` is called by one thread at a time, after some structures; a break ends the search, and what was found so far
/// is kept. The answer does not depend on the number of threads.
///
/// ```
/// use epicyclic_synthesis::parts::Bounds;
/// use epicyclic_synthesis::run::{Share, search};
/// use epicyclic_synthesis::search::Wish;
/// use epicyclic_synthesis::{Class, Kind};
/// use std::ops::ControlFlow;
/// # fn main() -> Result<(), epicyclic_synthesis::Error> {
/// // Two gears, 2.56 and 1.465, of two sets with one brake each.
/// let gears = [2.56, 1.465].map(|ratio| Bounds { least: 0.999 * ratio, most: 1.001 * ratio });
/// let wish = Wish { gears: gears.into(), elements: 2, k: vec![1.4..=4.5; 2] };
/// let class = Class::new(Kind::Core, 2, 4)?;
/// let answer = search(class, &wish, Share::WHOLE, &|_| ControlFlow::Continue(()))?;
/// assert!(answer.found.iter().any(|found| found.structure == "c-1-2 c-2-d".parse().unwrap()));
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Error::Wish`] where nothing can be had: no gears, gears whose bounds overlap, hold 0 or exceed [`MOST_GEARS`], more gears
/// than choices of elements, fewer elements than a gear engages, or a range of `k` that is empty or not above 0.
pub fn search(
    class: Class,
    wish: &Wish,
    share: Share,
    progress: &(dyn Fn(Progress) -> ControlFlow<()> + Sync),
) -> Result<Answer, Error> {
    wish.check(class)?;
    Ok(match class.sets() {
        1..=3 => search_with::<u8>(class, wish, share, progress),
        4 => search_with::<u16>(class, wish, share, progress),
        5 => search_with::<u32>(class, wish, share, progress),
        _ => search_with::<u64>(class, wish, share, progress),
    })
}

/// After how many structures of a thread progress is told and a break is seen.
const CHUNK: usize = 16;

fn search_with<W: Word + Send>(
    class: Class,
    wish: &Wish,
    share: Share,
    progress: &(dyn Fn(Progress) -> ControlFlow<()> + Sync),
) -> Answer {
    let all = enumerate::all(class);
    let class_size = all.len();
    let structures: Vec<Structure> = all.into_iter().skip(share.number).step_by(share.of.max(1)).collect();
    let next = AtomicUsize::new(0);
    let ended = AtomicBool::new(false);
    let told = Mutex::new(Progress { done: 0, of: structures.len(), found: 0 });
    let work = || {
        let mut search = Search::<W>::new(wish.clone(), class.links());
        let mut found: Vec<(usize, Solution)> = Vec::new();
        while !ended.load(Ordering::Relaxed) {
            let from = next.fetch_add(CHUNK, Ordering::Relaxed);
            let chunk = from..structures.len().min(from + CHUNK);
            if chunk.is_empty() {
                break;
            }
            let (length, before) = (chunk.len(), found.len());
            for place in chunk {
                found.extend(
                    search.structure(&structures[place]).into_iter().map(|solution| (place, solution)),
                );
            }
            let mut told = told.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            told.done += length;
            told.found += found.len() - before;
            if progress(*told).is_break() {
                ended.store(true, Ordering::Relaxed);
            }
        }
        (found, search.tally())
    };
    let results = on_each_thread(work);
    let mut tally = Tally::default();
    let mut found = Vec::new();
    for (part, counts) in results {
        found.extend(part);
        tally += counts;
    }
    found.sort_by(|one, other| (one.0, &one.1.elements).cmp(&(other.0, &other.1.elements)));
    let found = found
        .into_iter()
        .map(|(place, solution)| Found { structure: structures[place].clone(), solution })
        .collect();
    let complete = tally.structures == structures.len() as u64;
    Answer { class_size, found, tally, complete }
}

/// What each thread of the pool comes to, each working until nothing is left.
#[cfg(feature = "parallel")]
fn on_each_thread<T: Send>(work: impl Fn() -> T + Sync) -> Vec<T> {
    rayon::broadcast(|_| work())
}

/// What one thread comes to.
#[cfg(not(feature = "parallel"))]
fn on_each_thread<T>(work: impl Fn() -> T) -> Vec<T> {
    vec![work()]
}

impl Wish {
    /// Whether gearboxes of a class can have these gears at all.
    ///
    /// # Errors
    /// [`Error::Wish`].
    pub fn check(&self, class: Class) -> Result<(), Error> {
        let (gears, engaged) = (self.gears.len(), class.engaged());
        let fault = |why: String| Err(Error::Wish { why });
        if !(1..=MOST_GEARS).contains(&gears) {
            return fault(format!("{gears} gears: there may be 1 to {MOST_GEARS}"));
        }
        for (place, gear) in self.gears.iter().enumerate() {
            let ordered = gear.least.is_finite() && gear.most.is_finite() && gear.least <= gear.most;
            if !ordered || gear.least * gear.most <= 0.0 {
                let Bounds { least, most } = gear;
                return fault(format!(
                    "gear {} from {least} to {most}: the bounds need one sign, the lower first",
                    place + 1
                ));
            }
            if let Some(other) = self.gears[..place]
                .iter()
                .position(|other| other.least <= gear.most && gear.least <= other.most)
            {
                return fault(format!(
                    "gears {} and {} overlap: {}…{} and {}…{}; make the tolerance smaller",
                    other + 1,
                    place + 1,
                    self.gears[other].least,
                    self.gears[other].most,
                    gear.least,
                    gear.most
                ));
            }
        }
        if self.elements < engaged {
            return fault(format!(
                "{} shift elements, yet a gear of {class} engages {engaged}",
                self.elements
            ));
        }
        let pairs = elements(class.links()).len();
        if self.elements > pairs {
            return fault(format!(
                "{} shift elements, yet {class} have {pairs} pairs of links",
                self.elements
            ));
        }
        let choices = choose(self.elements, engaged);
        if choices < gears {
            return fault(format!(
                "{gears} gears, yet {} shift elements, {engaged} of them engaged, give {choices} at most",
                self.elements
            ));
        }
        if self.k.len() != class.sets() {
            return fault(format!("{} ranges of k for {} planet sets", self.k.len(), class.sets()));
        }
        for (place, range) in self.k.iter().enumerate() {
            let (least, most) = (*range.start(), *range.end());
            if !(least.is_finite() && most.is_finite() && least > 0.0 && least <= most) {
                return fault(format!(
                    "k of set {} from {least} to {most}: the range is empty or not above 0",
                    place + 1
                ));
            }
        }
        Ok(())
    }
}
