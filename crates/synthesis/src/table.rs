//! The functions of one structure, numbered anew, so that a set of them is a few words: which choices of
//! elements have them, and which gears they reach where.
//!
//! A structure of four sets with eight links has about 2300 choices of three elements, but a hundred
//! functions that reach a gear.

use crate::choices::{Choices, choose};
use crate::library::{Library, Number, USELESS};
use crate::motion::{Motion, Speeds};
use crate::parts::{Parts, places};
use crate::ternary::Word;
use crate::watch::Watch;
use rustc_hash::FxHashMap;

/// The number of a function within a structure.
pub(crate) type Local = u32;

/// Number for choices whose function no wanted gear can have.
const NONE: Local = Local::MAX;

/// A set of functions, one bit each, and a last word for choices without one.
pub(crate) type Functions = Vec<u64>;

/// The functions of a structure.
pub(crate) struct Table<W> {
    choices: Choices,
    gears: usize,
    elements: usize,
    by_speeds: FxHashMap<Speeds<W>, Local>,
    by_number: FxHashMap<Number, Local>,
    /// Function of each choice.
    of_choice: Vec<Local>,
    /// Bit of the function of each choice of one element less, completed by each element.
    completed: Vec<u32>,
    numbers: Vec<Number>,
    /// Gears that each function reaches, as bits.
    reached: Vec<u32>,
    /// Parts of each function within reach of some gear.
    useful: Vec<Parts>,
    /// Parts within reach of each function, for each gear.
    reach: Vec<Parts>,
    /// Choices that have each function, as bits.
    having: Vec<Vec<u64>>,
    /// Functions that reach each gear.
    reaching: Vec<Vec<Local>>,
    /// Sets of the functions that reach each gear, as bits.
    reaching_bits: Vec<u64>,
    /// Number of words of a set of functions without the last.
    words: usize,
}

impl<W: Word> Table<W> {
    /// Table for gears that engage this number of at most `elements` elements.
    pub(crate) fn new(engaged: usize, elements: usize, gears: usize) -> Self {
        Self {
            choices: Choices::new(engaged, elements),
            gears,
            elements: 0,
            by_speeds: FxHashMap::default(),
            by_number: FxHashMap::default(),
            of_choice: Vec::new(),
            completed: Vec::new(),
            numbers: Vec::new(),
            reached: Vec::new(),
            useful: Vec::new(),
            reach: Vec::new(),
            having: Vec::new(),
            reaching: vec![Vec::new(); gears],
            reaching_bits: Vec::new(),
            words: 0,
        }
    }

    /// Takes up a structure with this number of elements.
    pub(crate) fn take(
        &mut self,
        engaged: usize,
        elements: usize,
        motion: &mut Motion<W>,
        library: &mut Library<W>,
        watch: &Watch<'_>,
    ) {
        self.elements = elements;
        self.by_speeds.clear();
        self.by_number.clear();
        self.of_choice.clear();
        self.of_choice.resize(choose(elements, engaged), NONE);
        self.completed.clear();
        self.numbers.clear();
        self.reached.clear();
        self.useful.clear();
        self.reach.clear();
        self.having.iter_mut().for_each(Vec::clear);
        self.reaching.iter_mut().for_each(Vec::clear);
        motion.for_each_gear(&mut |first, last| {
            // Nothing is made of a structure of which the search ends.
            if watch.is_over() {
                return;
            }
            let from = first.last().map_or(0, |element| element + 1);
            let number = self.choices.number(first);
            let chosen = first.iter().fold(0u64, |chosen, element| chosen | 1 << element);
            for (element, speeds) in (from..).zip(last) {
                if speeds.input.is_zero() || speeds.output.is_zero() {
                    continue;
                }
                let local = match self.by_speeds.get(speeds) {
                    Some(local) => *local,
                    None => self.add(*speeds, library),
                };
                if local != NONE {
                    self.of_choice[number + self.choices.terms(first.len())[element]] = local;
                    self.having[local as usize].push(chosen | 1 << element);
                }
            }
        });
        self.words = self.numbers.len().div_ceil(64);
        self.reaching_bits.clear();
        self.reaching_bits.resize(self.gears * self.words, 0);
        for (gear, reaching) in self.reaching.iter().enumerate() {
            for local in reaching {
                self.reaching_bits[gear * self.words + *local as usize / 64] |= 1 << (local % 64);
            }
        }
    }

    /// The number of the function of speeds that were not met in this structure so far.
    fn add(&mut self, speeds: Speeds<W>, library: &mut Library<W>) -> Local {
        let number = library.number(speeds);
        let local = if number == USELESS {
            NONE
        } else {
            let next = self.numbers.len();
            *self.by_number.entry(number).or_insert_with(|| {
                let local = Local::try_from(next).unwrap_or(NONE);
                let gears = library.gears(number);
                self.numbers.push(number);
                self.reached.push(gears);
                let from = self.reach.len();
                self.reach.resize(from + self.gears, Parts::default());
                let mut useful = Parts::default();
                for (gear, reach) in places(gears.into()).zip(library.reach(number)) {
                    self.reach[from + gear] = *reach;
                    useful = useful.or(*reach);
                }
                self.useful.push(useful);
                if self.having.len() == next {
                    self.having.push(Vec::new());
                }
                for (gear, reaching) in self.reaching.iter_mut().enumerate() {
                    if gears >> gear & 1 == 1 {
                        reaching.push(local);
                    }
                }
                local
            })
        };
        self.by_speeds.insert(speeds, local);
        local
    }

    /// Number of choices that reach a gear.
    pub(crate) fn choices_for(&self, gear: usize) -> usize {
        self.reaching[gear].iter().map(|local| self.having[*local as usize].len()).sum()
    }

    /// The functions that reach a gear.
    pub(crate) fn reaching(&self, gear: usize) -> &[Local] {
        &self.reaching[gear]
    }

    /// The choices that have a function, as bits.
    pub(crate) fn having(&self, function: Local) -> &[u64] {
        &self.having[function as usize]
    }

    /// The number of a function in the library.
    pub(crate) fn number(&self, function: Local) -> Number {
        self.numbers[function as usize]
    }

    /// The parts in which a function reaches a gear.
    #[inline]
    pub(crate) fn reach(&self, function: Local, gear: usize) -> Parts {
        self.reach[function as usize * self.gears + gear]
    }

    /// Calls `visit` with the function of each choice of some elements that has one, and the choice.
    pub(crate) fn for_each_choice(&self, chosen: u64, visit: &mut impl FnMut(Local, u64)) {
        self.choices.for_each(chosen, &mut |number, choice| {
            let local = self.of_choice[number];
            if local != NONE {
                visit(local, choice);
            }
        });
    }

    /// The functions of all choices of some elements.
    pub(crate) fn functions_of(&self, chosen: u64, functions: &mut Functions) {
        functions.clear();
        functions.resize(self.words, 0);
        self.choices.for_each_number(chosen, |number| {
            let local = self.of_choice[number];
            if local != NONE {
                functions[local as usize / 64] |= 1 << (local % 64);
            }
        });
    }

    /// Functions that each element adds to those of some elements: `words + 1` words for each element.
    pub(crate) fn added(&mut self, chosen: u64, added: &mut Vec<u64>) {
        if self.completed.is_empty() {
            self.complete();
        }
        let stride = self.words + 1;
        added.clear();
        added.resize(self.elements * stride, 0);
        self.choices.for_each_of_one_less(chosen, &mut |number| {
            let row = &self.completed[number * self.elements..][..self.elements];
            for (words, bit) in added.chunks_exact_mut(stride).zip(row) {
                words[*bit as usize / 64] |= 1 << (bit % 64);
            }
        });
    }

    /// Sets up the functions that elements give with each choice of one less.
    fn complete(&mut self) {
        let without = u32::try_from(64 * self.words).unwrap_or(u32::MAX);
        let less = self.choices.count_of_one_less(self.elements);
        self.completed.resize(less * self.elements, without);
        for (local, having) in (0..).zip(&self.having) {
            for choice in having {
                self.choices.for_each_without_one(*choice, |element, others| {
                    self.completed[others * self.elements + element] = local;
                });
            }
        }
    }

    /// Number of words of a set of functions.
    pub(crate) fn words(&self) -> usize {
        self.words
    }

    /// Whether some functions reach every gear, each in some part, and are at least as many as the gears.
    #[inline]
    pub(crate) fn may_have_all(&self, functions: &[u64]) -> bool {
        let count: u32 = functions.iter().map(|word| word.count_ones()).sum();
        count as usize >= self.gears
            && (0..self.gears).all(|gear| {
                let reaching = &self.reaching_bits[gear * self.words..][..self.words];
                reaching.iter().zip(functions).any(|(one, other)| one & other != 0)
            })
    }

    /// The parts in which one of some functions reaches a gear.
    pub(crate) fn covered(&self, functions: &[u64], gear: usize) -> Parts {
        let reaching = &self.reaching_bits[gear * self.words..][..self.words];
        let mut covered = Parts::default();
        for (place, (one, other)) in reaching.iter().zip(functions).enumerate() {
            let mut both = one & other;
            while both != 0 {
                let local = place * 64 + both.trailing_zeros() as usize;
                both &= both - 1;
                covered = covered.or(self.reach[local * self.gears + gear]);
            }
        }
        covered
    }

    /// Parts of each of some functions within reach of some gear.
    pub(crate) fn useful(&self, functions: &[u64]) -> impl Iterator<Item = Parts> {
        members(functions).map(|local| self.useful[local as usize])
    }

    /// The gears that a function reaches in a part, as bits.
    pub(crate) fn reached_in(&self, function: Local, part: usize) -> u32 {
        let reach = &self.reach[function as usize * self.gears..][..self.gears];
        let gears = places(self.reached[function as usize].into());
        gears.fold(0, |all, gear| all | u32::from(reach[gear].contains(part)) << gear)
    }
}

/// The members of a set of functions.
pub(crate) fn members(functions: &[u64]) -> impl Iterator<Item = Local> {
    let of_word = |(from, word): (Local, &u64)| places(*word).map(move |bit| from + bit as Local);
    (0..).step_by(64).zip(functions).flat_map(of_word)
}
