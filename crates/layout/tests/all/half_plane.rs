//! The verdict against drawings on squared paper: every way to colour a grid, by exhaustion.
//!
//! This oracle shares nothing with the test of the graph. The half-plane is a grid of cells. Two sets are
//! columns of three cells, sun below planet below ring. Input and output are the lower corners; a region that
//! touches the upper or a side edge (but for these corners) touches the housing. Every cell is coloured with
//! a link: a drawing leaves gaps, but a gap can be given to a neighbour.
//!
//! The scheme can be drawn on this paper under three conditions. Each colour is one connected region with the
//! right cells in it, the braked ones touch the housing, and those of a clutch touch each other. All
//! colourings are tried column by column. The coloured part is remembered only by its last cells, their
//! connections, and the colours that are finished. A beginning that leads to no drawing is not tried twice.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use epicyclic_layout as drawability;
use epicyclic_schemes::structures::{Role, Structure};
use epicyclic_train::set::SetSpec;
use epicyclic_train::{Gearbox, LinkId};
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::{LazyLock, Mutex};

/// Width of the paper and the cells of the two suns; planets and rings are above them.
struct Paper {
    width: usize,
    suns: [[usize; 2]; 2],
}

const SMALL: Paper = Paper { width: 8, suns: [[2, 2], [5, 2]] };
const LARGE: Paper = Paper { width: 10, suns: [[2, 2], [7, 2]] };

/// Links D, B, T1, T2, as [`Role`] counts them.
const LINKS: usize = 4;

/// The last `H` cells, upwards: colour and region; colours that are finished; demands met.
#[derive(Debug, Clone, Copy)]
struct Front<const H: usize> {
    colour: [u8; H],
    region: [u8; H],
    finished: u8,
    met: u8,
}

/// Region of a cell before the first column, and of the one just coloured.
const NONE: u8 = 7;
const NEW: u8 = 8;

impl<const H: usize> Front<H> {
    fn packed(self) -> u64 {
        let cells = self.colour.iter().zip(self.region);
        let bits = cells.fold(0, |bits, (&colour, region)| bits << 5 | u64::from(colour << 3 | region));
        bits << 8 | u64::from(self.finished << 4 | self.met)
    }
}

/// A drawing of these sets (sun, ring, carrier; left set first) that is begun, cell by cell.
struct Attempt<'a, const H: usize> {
    paper: &'a Paper,
    sets: [[usize; 3]; 2],
    clutch: Option<[usize; 2]>,
    /// Beginnings met at each cell.
    met: Vec<FxHashSet<u64>>,
}

impl<const H: usize> Attempt<'_, H> {
    /// The link of a cell that has one for certain.
    fn fixed(&self, x: usize, y: usize) -> Option<usize> {
        let stack = self.paper.suns.iter().zip(self.sets).find(|([column, _], _)| *column == x);
        let member = stack.and_then(|([_, sun], [a, b, h])| [a, h, b].get(y.wrapping_sub(*sun)).copied());
        match (x, y) {
            (0, 0) => Some(Role::D as usize),
            (x, 0) if x == self.paper.width - 1 => Some(Role::B as usize),
            _ => member,
        }
    }

    /// Whether the cells from this one on can be coloured.
    fn goes_on(&mut self, cell: usize, front: Front<H>) -> bool {
        if cell == self.met.len() {
            let all_met = if self.clutch.is_some() { 0b111 } else { 0b011 };
            return front.met == all_met
                && (0..H).all(|a| {
                    (0..H).all(|b| front.colour[a] != front.colour[b] || front.region[a] == front.region[b])
                });
        }
        if !self.met[cell].insert(front.packed()) {
            return false;
        }
        let (x, y) = (cell / H, cell % H);
        let at_side = x == 0 || x == self.paper.width - 1;
        let on_wall = (at_side || y == H - 1) && !(at_side && y == 0);
        let colours = self.fixed(x, y).map_or(0..LINKS, |link| link..link + 1);
        colours.into_iter().any(|colour| {
            let next = step(front, x, y, u8::try_from(colour).unwrap(), on_wall, self.clutch);
            next.is_some_and(|next| self.goes_on(cell + 1, next))
        })
    }
}

/// A question to the paper: which paper, the sets, the clutch.
type Question = (bool, [[usize; 3]; 2], Option<[usize; 2]>);

/// A question with every link renamed.
fn renamed((large, sets, clutch): Question, names: [usize; LINKS]) -> Question {
    let mut clutch = clutch.map(|pair| pair.map(|link| names[link]));
    clutch.iter_mut().for_each(|pair| pair.sort_unstable());
    (large, sets.map(|set| set.map(|link| names[link])), clutch)
}

/// [`fits`] of a question, once for all that are the same: T1 and T2 exchanged, or the paper seen from behind
/// with the sets and D and B exchanged.
fn fits_on((large, sets, clutch): Question) -> bool {
    static KNOWN: LazyLock<Mutex<FxHashMap<Question, bool>>> = LazyLock::new(Mutex::default);
    let [d, b, t1, t2] = [Role::D, Role::B, Role::T1, Role::T2].map(|role| role as usize);
    let straight = renamed((large, sets, clutch), [d, b, t1, t2]);
    let behind = renamed((large, [sets[1], sets[0]], clutch), [b, d, t1, t2]);
    let same = [straight, behind].into_iter().flat_map(|one| [one, renamed(one, [d, b, t2, t1])]);
    let question = same.min().unwrap();
    if let Some(known) = KNOWN.lock().unwrap().get(&question) {
        return *known;
    }
    let (_, sets, clutch) = question;
    let fits = if large { fits::<7>(&LARGE, sets, clutch) } else { fits::<6>(&SMALL, sets, clutch) };
    KNOWN.lock().unwrap().insert(question, fits);
    fits
}

/// Whether these sets can be drawn on the paper.
fn fits<const H: usize>(paper: &Paper, sets: [[usize; 3]; 2], clutch: Option<[usize; 2]>) -> bool {
    let met = vec![FxHashSet::default(); paper.width * H];
    let empty = Front { colour: [0; H], region: [NONE; H], finished: 0, met: 0 };
    Attempt::<H> { paper, sets, clutch, met }.goes_on(0, empty)
}

fn step<const H: usize>(
    front: Front<H>,
    x: usize,
    y: usize,
    colour: u8,
    on_wall: bool,
    clutch: Option<[usize; 2]>,
) -> Option<Front<H>> {
    if front.finished >> colour & 1 == 1 {
        return None;
    }
    let mut next = front;
    let left = (x > 0).then(|| (front.colour[y], front.region[y]));
    let below = (y > 0).then(|| (front.colour[y - 1], front.region[y - 1]));
    next.colour[y] = colour;
    next.region[y] = NEW;
    for (_, region) in [left, below].into_iter().flatten().filter(|(other, _)| *other == colour) {
        let joined = next.region[y];
        for cell in next.region.iter_mut().filter(|cell| **cell == region || **cell == joined) {
            *cell = region;
        }
    }
    // The cell on the left is behind the front now. A region may end only if its colour does.
    if let Some((old, region)) = left
        && old != colour
        && !next.region.contains(&region)
    {
        let goes_on = (0..H).any(|cell| next.region[cell] != NONE && next.colour[cell] == old);
        if goes_on {
            return None;
        }
        next.finished |= 1 << old;
    }
    if on_wall {
        next.met |= match usize::from(colour) {
            link if link == Role::T1 as usize => 0b001,
            link if link == Role::T2 as usize => 0b010,
            _ => 0,
        };
    }
    if let Some([a, b]) = clutch {
        let pair = |other: u8| {
            let here = [usize::from(colour), usize::from(other)];
            here == [a, b] || here == [b, a]
        };
        if [left, below].into_iter().flatten().any(|(other, _)| pair(other)) {
            next.met |= 0b100;
        }
    }
    // Regions numbered as they come.
    let mut names = [NONE; 9];
    let mut count = 0;
    for region in next.region.iter_mut().filter(|region| **region != NONE) {
        let name = &mut names[usize::from(*region)];
        if *name == NONE {
            *name = count;
            count += 1;
        }
        *region = *name;
    }
    Some(next)
}

/// Six cells high is enough for nearly all that fits at all; a larger paper is slow.
fn on_paper(structure: Structure, clutch: Option<[usize; 2]>, also_large: bool) -> bool {
    let [first, second] = structure.sets().map(|set| set.map(|role| role as usize));
    let both = [[first, second], [second, first]];
    let fits = |large| both.iter().any(|sets| fits_on((large, *sets, clutch)));
    fits(false) || also_large && fits(true)
}

const NAMES: [&str; LINKS] = ["D", "B", "T1", "T2"];

fn gearbox(structure: Structure) -> Gearbox {
    let mut builder = Gearbox::builder("two sets").links(NAMES).brake("K1", "T1").brake("K2", "T2");
    for (place, set) in structure.sets().iter().enumerate() {
        builder = builder.set(SetSpec::simple(&place.to_string(), set.map(|role| NAMES[role as usize]), 2.5));
    }
    builder.input("D").output("B").build().unwrap()
}

#[test]
fn every_two_set_structure_is_judged_as_on_paper() {
    let (mut drawable, mut crossing) = (0, vec![]);
    for structure in Structure::all() {
        let ours = drawability::is_drawable(&gearbox(structure));
        assert_eq!(ours, on_paper(structure, None, true), "{structure}");
        if ours {
            drawable += 1;
        } else {
            crossing.push(structure.to_string());
        }
    }
    // Two braked carriers between the same two shafts, or two braked links between carriers that are
    // input and output: each braked link must reach input, output and housing.
    assert_eq!(drawable, 106);
    assert_eq!(
        crossing,
        ["D.B.T1+D.B.T2", "D.B.T1+B.D.T2", "B.D.T1+B.D.T2", "T1.T2.D+T1.T2.B", "T1.T2.D+T2.T1.B"]
    );
}

#[test]
fn every_lock_of_the_catalogue_is_judged_as_on_paper() {
    for structure in Structure::catalogue() {
        let direct_clutches = drawability::direct_clutch_options(&gearbox(structure));
        for a in 0..LINKS {
            for b in a + 1..LINKS {
                let ours = direct_clutches.contains(&[a, b].map(|link| link_of(structure, link)));
                assert_eq!(
                    ours,
                    on_paper(structure, Some([a, b]), ours),
                    "{structure} with a clutch between {a} and {b}"
                );
            }
        }
    }
}

fn link_of(structure: Structure, link: usize) -> LinkId {
    gearbox(structure).link(NAMES[link]).unwrap()
}
