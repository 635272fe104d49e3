//! A search through a whole class, or a share of it: on all threads of the pool with the feature `parallel`, else on one.

use crate::class::Class;
use crate::enumerate;
use crate::error::Error;
use crate::search::{Search, Solution};
use crate::structure::Structure;
use crate::tally::Tally;
use crate::ternary::Word;
use crate::wish::Wish;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

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
/// use epicyclic_synthesis::wish::Wish;
/// use epicyclic_synthesis::{Class, Kind};
/// use std::ops::ControlFlow;
/// # fn main() -> Result<(), epicyclic_synthesis::Error> {
/// // Two gears, 2.56 and 1.465, of two sets with one brake each.
/// let gears = [2.56, 1.465].map(|ratio| Bounds { least: 0.999 * ratio, most: 1.001 * ratio });
/// let wish = Wish::new(gears.into(), 2, vec![1.4..=4.5; 2]);
/// let class = Class::new(Kind::Core, 2, 4)?;
/// let answer = search(class, &wish, Share::WHOLE, &|_| ControlFlow::Continue(()))?;
/// assert!(answer.found.iter().any(|found| found.structure == "c-1-2 c-2-d".parse().unwrap()));
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Error::Wish`] where nothing can be had: no gears, gears whose bounds overlap, hold 0 or exceed [`MOST_GEARS`](crate::wish::MOST_GEARS), more gears
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
    let mut structures: Vec<Structure> =
        all.into_iter().skip(share.number).step_by(share.of.max(1)).collect();
    if wish.double_planets > 0 {
        let tagged = |structure: Structure| structure.with_double_planets(wish.double_planets);
        structures = structures.into_iter().flat_map(tagged).collect();
    }
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
