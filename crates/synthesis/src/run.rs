//! A search through a whole class, or a share of it: on all threads of the pool with the feature `parallel`,
//! else on one.

use crate::class::Class;
use crate::error::Error;
use crate::search::Search;
use crate::tally::Tally;
use crate::ternary::Word;
use crate::wish::Wish;
use crate::work::Work;
pub use crate::work::{Found, Progress, Share};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Result of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Structures in the class.
    pub class_size: usize,
    /// Solutions in the order of their structures and elements.
    pub found: Vec<Found>,
    /// Counts of the search.
    pub tally: Tally,
    /// Whether all structures were searched, not ended by `progress`.
    pub complete: bool,
}

/// Searches a class for all gearboxes that have the wanted gears.
///
/// `progress` is called by one thread at a time, after some structures; a break ends the search, and what was
/// found so far is kept. The answer does not depend on the number of threads.
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
/// [`Error::Wish`] for a wish that nothing can fulfil:
/// - no gears, or more than [`MOST_GEARS`](crate::wish::MOST_GEARS);
/// - bounds of gears that overlap or hold 0;
/// - more gears than choices of elements, or fewer elements than a gear engages;
/// - a range of `k` that is empty or not above 0.
pub fn search(
    class: Class,
    wish: &Wish,
    share: Share,
    progress: &(dyn Fn(Progress) -> ControlFlow<()> + Sync),
) -> Result<Answer, Error> {
    let work = go_on(class, wish, share, Work::default(), &|work| progress(work.progress()))?;
    Ok(Answer {
        class_size: work.class_size,
        complete: work.is_complete(),
        tally: work.tally,
        found: work.found.into_iter().map(|(_, found)| found).collect(),
    })
}

/// Continues a search from previous work: structures that were searched are not searched again.
///
/// `kept` is called by one thread at a time with all that is done, after some structures; a break ends the
/// search. The result for a structure depends on the class, the wish and the structure alone. So the complete
/// work does not depend on breaks, nor on the number of threads.
///
/// # Errors
/// Errors of [`search`], and [`Error::OtherWork`] if `before` is not work on this share.
pub fn go_on(
    class: Class,
    wish: &Wish,
    share: Share,
    before: Work,
    kept: &(dyn Fn(&Work) -> ControlFlow<()> + Sync),
) -> Result<Work, Error> {
    wish.check(class)?;
    match class.sets() {
        1..=3 => go_on_with::<u8>(class, wish, share, before, kept),
        4 => go_on_with::<u16>(class, wish, share, before, kept),
        5 => go_on_with::<u32>(class, wish, share, before, kept),
        _ => go_on_with::<u64>(class, wish, share, before, kept),
    }
}

/// Number of structures that a thread searches before it adds its results to the rest.
const CHUNK: usize = 16;

fn go_on_with<W: Word + Send>(
    class: Class,
    wish: &Wish,
    share: Share,
    before: Work,
    kept: &(dyn Fn(&Work) -> ControlFlow<()> + Sync),
) -> Result<Work, Error> {
    // Of many sets the structures alone take long.
    let Some((structures, class_size)) =
        share.structures(class, wish.double_planets, &|| kept(&before).is_break())
    else {
        return Ok(before);
    };
    let work = before.on(class_size, structures.len())?;
    let left: Vec<usize> = work.left().collect();
    let next = AtomicUsize::new(0);
    let ended = AtomicBool::new(false);
    let work = Mutex::new(work);
    // Who finds another at it has nothing to add.
    let is_over = || {
        if work.try_lock().is_ok_and(|work| kept(&work).is_break()) {
            ended.store(true, Ordering::Relaxed);
        }
        ended.load(Ordering::Relaxed)
    };
    let on_a_thread = || {
        let mut search = Search::<W>::new(wish.clone(), class.links());
        while !ended.load(Ordering::Relaxed) {
            let from = next.fetch_add(CHUNK, Ordering::Relaxed);
            let Some(chunk) = left.get(from..left.len().min(from + CHUNK)).filter(|chunk| !chunk.is_empty())
            else {
                break;
            };
            let (mut done, mut found) = (0, Vec::new());
            for place in chunk {
                let structure = &structures[*place];
                // One structure of many sets may take long: then it is told, and a break seen, within it.
                let Some(solutions) = search.structure_unless(structure, &is_over) else { break };
                done += 1;
                found.extend(
                    solutions
                        .into_iter()
                        .map(|solution| (*place, Found { structure: structure.clone(), solution })),
                );
            }
            let mut work = work.lock().unwrap_or_else(PoisonError::into_inner);
            work.add(&chunk[..done], found, search.take_tally());
            if kept(&work).is_break() {
                ended.store(true, Ordering::Relaxed);
            }
        }
    };
    on_each_thread(on_a_thread);
    let mut work = work.into_inner().unwrap_or_else(PoisonError::into_inner);
    work.sort();
    Ok(work)
}

/// Works on each thread of the pool until nothing is left.
#[cfg(feature = "parallel")]
fn on_each_thread(work: impl Fn() + Sync) {
    rayon::broadcast(|_| work());
}

/// Works on one thread.
#[cfg(not(feature = "parallel"))]
fn on_each_thread(work: impl Fn()) {
    work();
}
