//! drawability
mod carriers;
pub mod crossings;
mod grid;
pub mod layout;
mod map;
mod order;
mod planar;
mod scheme;
mod stacks;

pub use crossings::{Crossing, Line};
pub use layout::Layout;

use crate::{Gearbox, LinkId};
use map::Map;
use scheme::Scheme;

/// How to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// Input and output both leave on the left, the input's shaft around the output's.
    pub same_side: bool,
    /// How many drawings are compared for the most pleasing one; at least one is made.
    pub attempts: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self { same_side: false, attempts: 100 }
    }
}

/// Something whose absence may make a scheme drawable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Element {
    /// A row, by its place in [`Gearbox::rows`].
    Row(usize),
    /// A brake or clutch, by its place in [`Gearbox::controls`].
    Control(usize),
    /// A link; without it its members and connections stand alone.
    Link(LinkId),
    /// The input's shaft to the outside.
    Input,
    /// The output's shaft to the outside.
    Output,
    /// A link where power enters or leaves in some gear only.
    TakeOff(LinkId),
}

/// Why a scheme cannot be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Witness {
    /// A least set of elements that cannot be drawn together.
    pub elements: Vec<Element>,
}

/// Whether a scheme can be drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// It can, so.
    Drawable(Layout),
    /// It cannot.
    SelfCrossing(Witness),
}

/// Draws a gearbox in the half-plane.
#[must_use]
pub fn draw(gearbox: &Gearbox, options: Options) -> Verdict {
    let scheme = Scheme::new(gearbox, &[]);
    let graph = scheme.graph(&[]);
    match Map::new(&graph) {
        Some(map) => Verdict::Drawable(layout::draw(&scheme, gearbox, &graph, &map, options)),
        None => Verdict::SelfCrossing(witness(&scheme)),
    }
}

/// The verdict alone.
#[must_use]
pub fn is_drawable(gearbox: &Gearbox) -> bool {
    carriers::arrange(&Scheme::new(gearbox, &[]).graph(&[])).is_some()
}

fn witness(scheme: &Scheme<'_>) -> Witness {
    let elements = scheme.elements();
    let mut without: Vec<Element> = vec![];
    for &element in &elements {
        without.push(element);
        if carriers::arrange(&scheme.graph(&without)).is_some() {
            without.pop();
        }
    }
    Witness { elements: elements.into_iter().filter(|element| !without.contains(element)).collect() }
}
