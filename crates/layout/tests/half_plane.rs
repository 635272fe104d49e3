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
//! connections, and the colours that are finished.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use epicyclic_layout as drawability;
use epicyclic_schemes::structures::{Role, Structure};
use epicyclic_train::set::SetSpec;
use epicyclic_train::{Gearbox, LinkId};

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

    fn unpacked(bits: u64) -> Self {
        let low = |bits: u64, mask: u8| (bits & u64::from(mask)) as u8;
        let cell = |y: usize| low(bits >> (8 + 5 * (H - 1 - y)), 31);
        let cells: [u8; H] = std::array::from_fn(cell);
        Self {
            colour: cells.map(|cell| cell >> 3),
            region: cells.map(|cell| cell & 7),
            finished: low(bits >> 4, 15),
            met: low(bits, 15),
        }
    }
}

/// Whether these sets (sun, ring, carrier; left set first) can be drawn on the paper.
fn fits<const H: usize>(paper: &Paper, sets: [[usize; 3]; 2], clutch: Option<[usize; 2]>) -> bool {
    let fixed = |x: usize, y: usize| {
        let stack = paper.suns.iter().zip(sets).find(|([column, _], _)| *column == x);
        let member = stack.and_then(|([_, sun], [a, b, h])| [a, h, b].get(y.wrapping_sub(*sun)).copied());
        match (x, y) {
            (0, 0) => Some(Role::D as usize),
            (x, 0) if x == paper.width - 1 => Some(Role::B as usize),
            _ => member,
        }
    };
    let all_met = if clutch.is_some() { 0b111 } else { 0b011 };
    let mut fronts = vec![Front::<H> { colour: [0; H], region: [NONE; H], finished: 0, met: 0 }.packed()];
    for x in 0..paper.width {
        for y in 0..H {
            let colours = fixed(x, y).map_or(0..LINKS, |link| link..link + 1);
            let corner = y == 0 && (x == 0 || x == paper.width - 1);
            let on_wall = !corner && (x == 0 || x == paper.width - 1 || y == H - 1);
            let mut next = Vec::with_capacity(fronts.len() * colours.len());
            for &front in &fronts {
                for colour in colours.clone() {
                    let colour = u8::try_from(colour).unwrap();
                    next.extend(
                        step(Front::<H>::unpacked(front), x, y, colour, on_wall, clutch).map(Front::packed),
                    );
                }
            }
            next.sort_unstable();
            next.dedup();
            fronts = next;
        }
    }
    let mut fronts = fronts.into_iter().map(Front::<H>::unpacked);
    fronts.any(|front| {
        front.met == all_met
            && (0..H).all(|a| {
                (0..H).all(|b| front.colour[a] != front.colour[b] || front.region[a] == front.region[b])
            })
    })
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
    both.iter().any(|sets| fits::<6>(&SMALL, *sets, clutch))
        || also_large && both.iter().any(|sets| fits::<7>(&LARGE, *sets, clutch))
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
