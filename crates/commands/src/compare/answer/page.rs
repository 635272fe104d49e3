//! What a page of a comparison draws.

use super::Candidate;
use epicyclic_layout::{Layout, Options, Verdict, draw};
use epicyclic_train::Gearbox;

/// A gearbox to be drawn.
#[derive(Debug)]
pub struct Drawn<'g> {
    /// The gearbox.
    pub gearbox: &'g Gearbox,
    /// Its layout, if it is drawable.
    pub layout: Option<Box<Layout>>,
}

/// The gearboxes, laid out.
#[must_use]
pub fn drawn<'g>(candidates: &[Candidate<'g, '_>]) -> Vec<Drawn<'g>> {
    let one = |candidate: &Candidate<'g, '_>| {
        let gearbox = &candidate.subject.gearbox;
        let layout = match draw(gearbox, Options::default()) {
            Verdict::Drawable(layout) => Some(layout),
            Verdict::SelfCrossing(_) => None,
        };
        Drawn { gearbox, layout }
    };
    candidates.iter().map(one).collect()
}
