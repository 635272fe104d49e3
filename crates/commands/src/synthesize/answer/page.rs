//! Drawings for the page of a search.

use super::Kept;
use crate::error::Error;
use epicyclic_layout::{Layout, Options, Verdict, draw};
use epicyclic_train::Gearbox;

/// Solution to be drawn.
#[derive(Debug)]
pub struct Drawn {
    /// Gearbox of the solution.
    pub gearbox: Gearbox,
    /// Layout of the gearbox; `None` if it is not drawable.
    pub layout: Option<Box<Layout>>,
}

/// Computes the layouts of the first solutions.
///
/// # Errors
/// Errors of [`gearbox`](super::saved::gearbox).
pub fn drawn(kept: &[Kept], most: usize) -> Result<Vec<Drawn>, Error> {
    let one = |kept: &Kept| {
        let gearbox = super::saved::gearbox(kept, &format!("Gearbox {}", kept.number), None)?;
        let layout = match draw(&gearbox, Options::default()) {
            Verdict::Drawable(layout) => Some(layout),
            Verdict::SelfCrossing(_) => None,
        };
        Ok(Drawn { gearbox, layout })
    };
    kept.iter().take(most).map(one).collect()
}
