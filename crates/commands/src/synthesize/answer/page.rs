//! What a page of a search draws.

use super::Kept;
use crate::error::Error;
use epicyclic_layout::{Layout, Options, Verdict, draw};
use epicyclic_train::Gearbox;

/// A solution to be drawn.
#[derive(Debug)]
pub struct Drawn {
    /// Its gearbox.
    pub gearbox: Gearbox,
    /// Its layout, if it is drawable.
    pub layout: Option<Box<Layout>>,
}

/// The first solutions, laid out.
///
/// # Errors
/// Those of [`gearbox`](super::saved::gearbox).
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
