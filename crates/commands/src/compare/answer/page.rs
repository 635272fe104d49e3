//! Drawings for the page of a comparison.

use super::Candidate;
use epicyclic_layout::{Layout, Options, Verdict, draw};
use epicyclic_train::Gearbox;

/// Gearbox to be drawn.
#[derive(Debug)]
pub struct Drawn<'g> {
    /// The gearbox.
    pub gearbox: &'g Gearbox,
    /// Layout of the gearbox; `None` if it is not drawable.
    pub layout: Option<Box<Layout>>,
}

/// Computes the layouts of the gearboxes.
#[must_use]
pub fn drawn<'g>(candidates: &[Candidate<'g>]) -> Vec<Drawn<'g>> {
    let one = |candidate: &Candidate<'g>| {
        let gearbox = &candidate.subject.train;
        let layout = match draw(gearbox, Options::default()) {
            Verdict::Drawable(layout) => Some(layout),
            Verdict::SelfCrossing(_) => None,
        };
        Drawn { gearbox, layout }
    };
    candidates.iter().map(one).collect()
}
