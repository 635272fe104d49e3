//! Whether a gearbox can be drawn in the half-plane without a link crossing another, and the drawing.
//!
//! A kinematic scheme is the section of a gearbox by a half-plane through its axis. Links are bodies of
//! revolution, so two links that cross in the section would meet in space. A braked link that other links
//! shut off from the housing cannot be held. Such a scheme is *self-crossing* and cannot be built.
//!
//! ```
//! use epicyclic_layout::{Options, Verdict, draw};
//! use epicyclic_train::{Gearbox, set::SetSpec};
//! # fn main() -> Result<(), epicyclic_train::Error> {
//! let box_of = |second: [&str; 3]| {
//!     Gearbox::builder("two sets")
//!         .links(["D", "B", "T1", "T2"])
//!         .set(SetSpec::simple("1", ["D", "B", "T1"], 2.5))
//!         .set(SetSpec::simple("2", second, 2.5))
//!         .brake("K1", "T1")
//!         .brake("K2", "T2")
//!         .input("D")
//!         .output("B")
//!         .build()
//! };
//! // III-1: both carriers, the first also the second's ring, reach the housing on the left.
//! let Verdict::Drawable(layout) = draw(&box_of(["D", "T1", "T2"])?, Options::default()) else {
//!     unreachable!("III-1 can be drawn");
//! };
//! assert!(layout.crossings().is_empty());
//! // Two sets side by side between the same shafts: the second carrier is shut in.
//! let shut_in = box_of(["D", "B", "T2"])?;
//! let Verdict::SelfCrossing(witness) = draw(&shut_in, Options::default()) else {
//!     unreachable!("the output shuts it in");
//! };
//! assert!(witness.describe(&shut_in).contains("brake `K2`"));
//! # Ok(())
//! # }
//! ```
//!
//! # The graph that is tested
//!
//! *Vertices*: every link (permanently joined links are one), the planet of every set, and four on the
//! border: input end, housing, output end, axis. *Edges*:
//!
//! - the border as a cycle in this order; nothing lies outside it;
//! - input link to input end, output link to output end;
//! - a brake from its link to the housing, a clutch between its links;
//! - planet to the sun's link and to the ring's link;
//! - planet to its carrier's link, up to twice, on either side of the two meshes.
//!
//! The scheme can be drawn if and only if this graph has a planar embedding inside the border, for
//! some choice of how the carriers' webs meet their planets:
//!
//! - *Necessary.* In a drawing each link is a connected region, the planet pin a part of its carrier's.
//!   Regions of different links are disjoint. Shrinking each web of each link to a point leaves an embedding
//!   of the graph. A central gear touches its planet in one place, so a sun or ring is a point on the edge
//!   from planet to link and needs no vertex. The carrier needs more: its region contains the planet, with
//!   the sun below and the ring above it, and continues to the left and to the right. Around the carrier the
//!   two meshes of a set are therefore the ends of a chord. The chords of several sets on one carrier do not
//!   cross: each planet cuts the carrier in two, and every other set lies wholly on one side.
//! - *Sufficient.* Every embedding yields a drawing. Bars lie at the heights of a numbering from axis to
//!   housing, joined by lines at right angles to the axis; each set is opened into a vertical stack. The
//!   order of sun below and ring above restricts nothing. A sun's shaft may be led out along the axis and up,
//!   and a ring's drum down, around everything else of the set. [`Layout::crossings`] checks the result line
//!   by line, independently of the graph.
//!
//! A planet with one carrier to itself is thus one vertex with its carrier's link. With several sets on one
//! carrier the chords decide: if they cross in the first embedding found, all choices are checked. The axis
//! has no edge but those of the border. A shaft may run along the axis inside all others, so a link passes
//! freely under a sun, but nothing passes *through* the axis. For the same reason input and output on one
//! side change no verdict, only the drawing: the border's cyclic order of input, housing and output is the
//! same, and the inner shaft returns below everything.
//!
//! # The drawing
//!
//! All sets are drawn in one band, with their planets at one height, if a sweep from left to right finds such
//! a drawing. An upright line through a drawing in one band meets a list of lines that changes only next to
//! the band. A search over these lists finds exactly the drawings without a crossing. The first search is a
//! fast one; slower ones look for cheaper drawings as far as [`Options::attempts`] allows. The drawing of
//! least cost is used.
//!
//! [`Layout::cost`] counts bands of sets, then corners, walls of the housing between sets, length, and sets
//! against the order of the power. The search gives costs ahead more weight than necessary, so it may miss
//! the cheapest drawing of all. Sets drawn for one set (a Ravigneaux set) are side by side on one level line
//! of their carrier if such a drawing is found.
//!
//! If no sweep finds a drawing, drawings with the sets at any heights are made by chance from embeddings of
//! the graph, and the cheapest is used. For one set or two this is done in addition to the sweep. The verdict
//! never depends on the search.
//!
//! # Idealised
//!
//! - Bearings, seals, oil and the actuators of shift elements take no room, and drums and hollow shafts may
//!   be nested without limit. A drawable scheme can be built in principle, not always well.
//! - All shift elements are present at once. Of a direct-drive clutch only the given pair counts;
//!   [`direct_clutch_options`] lists all pairs that can be drawn.
//! - Sets of every kind are a chain of central gear 1, planet and central gear 2. Stepped planets, two
//!   planets in mesh and bevel planets leave the same two sides free for the carrier, though their shape
//!   differs.
//! - A Ravigneaux set is two sets with common ring and carrier. Its long planet has three meshes and three
//!   gaps between them, where the two sets have four gaps. The fourth lies between ring and ring, and its
//!   contents can be moved next to it. The verdict is the same.
//! - A pair on fixed axes is a set whose carrier is the housing: its gears need to reach bearings there.
//!   Parts that turn about another axis are drawn as if they turned about this one.
//! - Where power enters or leaves in some gears only, a motor is in the housing or a pair leads away. That
//!   link has to reach the housing, as if braked.
//!
//! # Source
//! multispeed-gearboxes, section 3.1, names the criterion: links between sets may cut off braked links
//! from the housing. It gives no test; the graph is ours.

mod bands;
mod carriers;
mod cost;
pub mod crossings;
mod drawing;
mod grid;
pub mod layout;
mod map;
mod order;
mod planar;
#[cfg(test)]
mod samples;
mod scheme;
mod search;
mod stacks;
mod sweep;
mod to_scale;

pub use cost::Cost;
pub use crossings::{Crossing, Line};
pub use layout::Layout;
pub use to_scale::{NotToScale, SetRadii};

use epicyclic_train::{Gearbox, LinkId};
use scheme::Scheme;

/// Options of a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// Input and output both leave on the left, the input's shaft around the output's.
    pub same_side: bool,
    /// Effort of the search for the drawing of least cost after the first drawing: forty lists of lines for
    /// each attempt. If no drawing with all sets in one band is found, number of drawings that are compared,
    /// at least one. The verdict does not depend on it.
    pub attempts: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self { same_side: false, attempts: 120 }
    }
}

/// Something without which a scheme may be drawable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Element {
    /// A set, by its place in [`Gearbox::drawn_sets`].
    Set(usize),
    /// A brake or clutch, by its index in [`Gearbox::shift_elements`]; an additional direct-drive clutch has
    /// the number after the last.
    ShiftElement(usize),
    /// A link; without it its members and connections are separate.
    Link(LinkId),
    /// The input's shaft to the outside.
    Input,
    /// The output's shaft to the outside.
    Output,
    /// The way to the housing of a link where power enters or leaves in some gear only.
    TakeOff(LinkId),
}

/// Reason why a scheme cannot be drawn: elements that cannot be drawn together, though they can as soon as
/// any one of them is left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Witness {
    /// The elements.
    pub elements: Vec<Element>,
}

impl Witness {
    /// The elements by name.
    #[must_use]
    pub fn describe(&self, gearbox: &Gearbox) -> String {
        let name = |link: LinkId| gearbox.link_name(link);
        let words = self.elements.iter().map(|element| match *element {
            Element::Set(set) => format!("set `{}`", gearbox.sets()[gearbox.drawn_sets()[set].set].id()),
            Element::ShiftElement(shift_element) => match gearbox.shift_elements().get(shift_element) {
                Some(shift_element) if shift_element.is_brake() => format!("brake `{}`", shift_element.id()),
                Some(shift_element) => format!("clutch `{}`", shift_element.id()),
                None => "the direct-drive clutch".into(),
            },
            Element::Link(link) => format!("link `{}`", name(link)),
            Element::Input => format!("the input at `{}`", name(gearbox.input())),
            Element::Output => format!("the output at `{}`", name(gearbox.output())),
            Element::TakeOff(link) => format!("the way out of `{}`", name(link)),
        });
        format!("cannot be drawn together: {}", words.collect::<Vec<_>>().join(", "))
    }
}

/// Whether a scheme can be drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// The scheme can be drawn: its drawing.
    Drawable(Box<Layout>),
    /// The scheme cannot be drawn: the elements that conflict.
    SelfCrossing(Witness),
}

/// Draws a gearbox in the half-plane, or says what cannot be drawn together.
///
/// The same gearbox and options always give the same drawing.
#[must_use]
pub fn draw(gearbox: &Gearbox, options: Options) -> Verdict {
    judge(gearbox, &[], options)
}

/// Draws a gearbox with an additional direct-drive clutch between two links.
///
/// # Panics
/// With a link of another, larger gearbox.
#[must_use]
pub fn draw_with_direct_clutch(gearbox: &Gearbox, direct_clutch: [LinkId; 2], options: Options) -> Verdict {
    judge(gearbox, &[direct_clutch], options)
}

/// Whether a gearbox can be drawn, without the drawing: the same verdict in a few microseconds.
#[must_use]
pub fn is_drawable(gearbox: &Gearbox) -> bool {
    fits(&Scheme::new(gearbox, &[]), &[])
}

/// Pairs of links between which a further clutch can be drawn: the options for a direct-drive clutch.
///
/// Not every such clutch gives a direct drive: two links of sets that are not otherwise tied together leave
/// the rest free.
#[must_use]
pub fn direct_clutch_options(gearbox: &Gearbox) -> Vec<[LinkId; 2]> {
    let moving = gearbox.link_ids().skip(1);
    let pairs = moving.clone().flat_map(|a| moving.clone().filter(move |b| *b > a).map(move |b| [a, b]));
    pairs
        .filter(|pair| {
            let pair = [*pair];
            let scheme = Scheme::new(gearbox, &pair);
            let [a, b] = pair[0].map(|link| scheme.piece(link));
            // Links that are permanently joined are one piece, between which a clutch would lock nothing.
            a != b && a != LinkId::GROUND && b != LinkId::GROUND && fits(&scheme, &[])
        })
        .collect()
}

fn judge(gearbox: &Gearbox, direct_clutches: &[[LinkId; 2]], options: Options) -> Verdict {
    let scheme = Scheme::new(gearbox, direct_clutches);
    match drawing::draw(&scheme, gearbox, options) {
        Some(layout) => Verdict::Drawable(Box::new(layout)),
        None => Verdict::SelfCrossing(witness(&scheme)),
    }
}

fn fits(scheme: &Scheme<'_>, without: &[Element]) -> bool {
    carriers::arrange(&scheme.graph(without), 0).is_some()
}

/// Smallest self-crossing remainder: every element that is not needed for the crossing has been removed.
/// Removing elements never makes a drawable remainder self-crossing, so one round is enough.
fn witness(scheme: &Scheme<'_>) -> Witness {
    let elements = scheme.elements();
    let mut without: Vec<Element> = vec![];
    for &element in &elements {
        without.push(element);
        if fits(scheme, &without) {
            without.pop();
        }
    }
    Witness { elements: elements.into_iter().filter(|element| !without.contains(element)).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_train::set::SetSpec;

    #[test]
    fn a_witness_holds_nothing_that_could_be_left_out() {
        let gearbox = Gearbox::builder("three sets")
            .links(["D", "B", "T1", "T2", "T3"])
            .set(SetSpec::simple("1", ["D", "B", "T1"], 2.5))
            .set(SetSpec::simple("2", ["D", "B", "T2"], 2.5))
            .set(SetSpec::simple("3", ["D", "T3", "B"], 2.5))
            .brake("K1", "T1")
            .brake("K2", "T2")
            .brake("K3", "T3")
            .clutch("direct", "D", "B")
            .input("D")
            .output("B")
            .build()
            .unwrap();
        let scheme = Scheme::new(&gearbox, &[]);
        let witness = witness(&scheme);
        assert!(!witness.elements.contains(&Element::Set(2)));
        let others: Vec<Element> =
            scheme.elements().into_iter().filter(|element| !witness.elements.contains(element)).collect();
        assert!(!fits(&scheme, &others));
        for &element in &witness.elements {
            assert!(fits(&scheme, &[others.clone(), vec![element]].concat()), "{element:?}");
        }
    }

    #[test]
    fn direct_clutch_options_of_scheme_one_are_all_pairs() {
        let gearbox = crate::samples::scheme_one();
        let link = |name| gearbox.link(name).unwrap();
        let [d, b, t] = ["D", "B", "T1"].map(link);
        assert_eq!(direct_clutch_options(&gearbox), [[d, b], [d, t], [b, t]]);
        let Verdict::Drawable(layout) = draw_with_direct_clutch(&gearbox, [d, b], Options::default()) else {
            panic!("every direct-drive clutch of scheme I can be drawn");
        };
        assert_eq!(layout.clutches.len(), 1);
        assert!(layout.crossings().is_empty());
    }
}
