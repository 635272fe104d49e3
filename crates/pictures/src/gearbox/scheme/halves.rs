//! Drawn sets that are halves of one set: a Ravigneaux set with its long planet, a Wolfrom drive with its
//! stepped planet.
//!
//! The layout has such a set as two, from the gear that they have in common to the two others. They are drawn
//! as one if they are side by side on one level line of their carrier.

use epicyclic_layout::Layout;
use epicyclic_layout::layout::{Point as Place, SetStack};
use epicyclic_train::Gearbox;
use epicyclic_train::set::SetKind;

/// Planet that two drawn sets have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Common {
    /// The long planet of a Ravigneaux set: in the first it is the outer of two planets, in the second the
    /// only one.
    Long,
    /// A stepped planet: in the first the step in mesh with the gear in common, in the second the other.
    Stepped,
}

/// Pair of drawn sets that are one set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pair {
    pub(super) stacks: [SetStack; 2],
    pub(super) common: Common,
    /// The member in common: 0 the first central gear, 1 the second.
    pub(super) member: usize,
    /// Index of the stack that does not draw the common member, because its line ends there.
    pub(super) without: Option<usize>,
}

impl Pair {
    /// Whether a member of a drawn set is drawn by the other.
    pub(super) fn hides(&self, set: usize, member: usize) -> bool {
        self.member == member && self.without.is_some_and(|without| self.stacks[without].set == set)
    }

    /// Sets whose power a common member of a drawn set passes on: both sets in one place, none in the other.
    /// `None` for members that are not in common.
    pub(super) fn hands_on(&self, set: usize, member: usize) -> Option<Vec<usize>> {
        let own = self.stacks.iter().position(|stack| stack.set == set)?;
        let place = match member {
            2 => 0,
            member if member == self.member => self.without.map_or(0, |without| 1 - without),
            _ => return None,
        };
        Some(if own == place { self.stacks.map(|stack| stack.set).to_vec() } else { vec![] })
    }

    /// The height of the line that carries the gear in common.
    pub(super) fn seat(&self, stack: usize) -> Place {
        let stack = &self.stacks[stack];
        Place { x: stack.x, y: if self.member == 0 { stack.sun } else { stack.ring } }
    }
}

/// Drawn sets `[first, second]` that are one set with a planet in common.
fn commons(gearbox: &Gearbox) -> Vec<([usize; 2], Common, usize)> {
    let drawn = gearbox.drawn_sets();
    let mut found = vec![];
    for first in 0..drawn.len() {
        let of = |other: &usize| drawn[*other].set == drawn[first].set;
        if (0..drawn.len()).filter(of).count() != 2 {
            continue;
        }
        let Some(second) = (0..drawn.len()).filter(of).find(|other| *other != first) else { continue };
        let common = |member: usize| drawn[first].members[member] == drawn[second].members[member];
        match [first, second].map(|set| drawn[set].kind) {
            [SetKind::DoublePlanet, SetKind::Simple] if common(1) => {
                found.push(([first, second], Common::Long, 1));
            }
            [SetKind::Simple, SetKind::SteppedSunRing] if common(0) => {
                found.push(([first, second], Common::Stepped, 0));
            }
            _ => {}
        }
    }
    found
}

/// The pairs that the layout has side by side.
pub(super) fn pairs(gearbox: &Gearbox, layout: &Layout) -> Vec<Pair> {
    let found = commons(gearbox).into_iter().filter_map(|(sets, common, member)| {
        let stacks = sets.map(|set| layout.sets[set]);
        let [left, right] = [stacks[0].x.min(stacks[1].x), stacks[0].x.max(stacks[1].x)];
        let pin = stacks[0].planet;
        let shape = layout.links.iter().find(|shape| shape.link == stacks[0].members[2])?;
        let is_joined = stacks[1].planet == pin
            && shape
                .segments
                .iter()
                .any(|s| s.from.y == pin && s.to.y == pin && s.from.x <= left && right <= s.to.x);
        let is_free =
            layout.sets.iter().all(|other| {
                sets.contains(&other.set) || other.planet != pin || other.x < left || right < other.x
            }) && !shape.segments.iter().any(|s| s.from.x == s.to.x && left < s.from.x && s.from.x < right);
        let mut pair = Pair { stacks, common, member, without: None };
        // The gear in common is drawn once where nothing lies beyond one of its two seats.
        let link = stacks[0].members[member];
        let own = layout.links.iter().find(|shape| shape.link == link)?;
        let ends = |stack: usize| {
            let seat = pair.seat(stack);
            let beyond = own.segments.iter().filter(|s| touches(s.from, s.to, seat));
            let met =
                layout.clutches.iter().flat_map(|mark| [mark.lower, mark.upper]).any(|(_, at)| at == seat);
            let mut beyond = beyond.peekable();
            let first = beyond.next();
            !met && beyond.next().is_none()
                && first.is_some_and(|s| s.from.y == s.to.y && (s.from == seat || s.to == seat))
        };
        pair.without = [1, 0].into_iter().find(|&stack| ends(stack));
        (is_joined && is_free && left < right).then_some(pair)
    });
    found.collect()
}

/// Text of the legend on sets that are drawn as one.
pub(super) fn words(gearbox: &Gearbox, layout: &Layout) -> Vec<String> {
    let pairs = pairs(gearbox, layout);
    let said = commons(gearbox).into_iter().map(|(sets, common, _)| {
        let [a, b] = [sets[0].min(sets[1]) + 1, sets[0].max(sets[1]) + 1];
        if !pairs.iter().any(|pair| sets.contains(&pair.stacks[0].set)) {
            return format!("sets {a} and {b}: one set, drawn as two");
        }
        match common {
            Common::Long => format!("sets {a} and {b}: one set with the long planet and the ring in common"),
            Common::Stepped => {
                format!("sets {a} and {b}: one set with the stepped planet and the sun in common")
            }
        }
    });
    said.collect()
}

fn touches(from: Place, to: Place, at: Place) -> bool {
    (from.x..=to.x).contains(&at.x) && (from.y..=to.y).contains(&at.y)
}

/// Whether a piece of a line leads to nothing but a gear that another stack draws.
pub(super) fn leads_nowhere(pairs: &[Pair], link: epicyclic_train::LinkId, from: Place, to: Place) -> bool {
    pairs.iter().any(|pair| {
        pair.without.is_some_and(|without| {
            let seat = pair.seat(without);
            pair.stacks[without].members[pair.member] == link
                && from.y == to.y
                && (from == seat || to == seat)
        })
    })
}
