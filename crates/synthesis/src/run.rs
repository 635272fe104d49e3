//! A search through a whole class, or a share of it: on all threads of the pool with the feature `parallel`, else on one.

use crate::class::Class;
use crate::error::Error;
use crate::motion::elements;
use crate::parts::Bounds;
use crate::search::{Search, Tally, Wish, choose};
use crate::ternary::Word;
use crate::work::Work;
pub use crate::work::{Found, Progress, Share};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// The most gears of a wish: one bit each.
pub const MOST_GEARS: usize = 30;

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
    let work = go_on(class, wish, share, Work::default(), &|work| progress(work.progress()))?;
    Ok(Answer {
        class_size: work.class_size,
        complete: work.is_complete(),
        tally: work.tally,
        found: work.found.into_iter().map(|(_, found)| found).collect(),
    })
}

/// Goes on with a search from what is done of it: structures that were searched are not searched again.
///
/// `kept` is called by one thread at a time with all that is done, after some structures; a break ends the search. What is found
/// in a structure depends on the class, the wish and the structure alone, so the work that is complete is the same whether it was
/// broken off or not, and on any number of threads.
///
/// # Errors
/// As [`search`], and [`Error::OtherWork`] where `before` is not work on this share.
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

/// How many structures a thread searches before it tells and a break is seen.
const CHUNK: usize = 16;

fn go_on_with<W: Word + Send>(
    class: Class,
    wish: &Wish,
    share: Share,
    before: Work,
    kept: &(dyn Fn(&Work) -> ControlFlow<()> + Sync),
) -> Result<Work, Error> {
    let (structures, class_size) = share.structures(class);
    let work = before.on(class_size, structures.len())?;
    let left: Vec<usize> = work.left().collect();
    let next = AtomicUsize::new(0);
    let ended = AtomicBool::new(false);
    let work = Mutex::new(work);
    let on_a_thread = || {
        let mut search = Search::<W>::new(wish.clone(), class.links());
        while !ended.load(Ordering::Relaxed) {
            let from = next.fetch_add(CHUNK, Ordering::Relaxed);
            let Some(chunk) = left.get(from..left.len().min(from + CHUNK)).filter(|chunk| !chunk.is_empty())
            else {
                break;
            };
            let mut found = Vec::new();
            for place in chunk {
                let structure = &structures[*place];
                let solutions = search.structure(structure).into_iter();
                found.extend(
                    solutions.map(|solution| (*place, Found { structure: structure.clone(), solution })),
                );
            }
            let mut work = work.lock().unwrap_or_else(PoisonError::into_inner);
            work.add(chunk, found, search.take_tally());
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
