//! Limits of a usable gearbox. A search goes on to larger classes as long as no gearbox found keeps them.

use crate::judge::Judged;
use crate::rank::Rating;

/// Limits of a usable gearbox.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Usable {
    /// The least efficiency of a forward gear.
    pub forward: f64,
    /// The least efficiency of a reverse gear.
    pub reverse: f64,
    /// The greatest circulating power of a forward gear, over the power that enters.
    pub circulation: f64,
}

impl Default for Usable {
    fn default() -> Self {
        Self { forward: 0.9, reverse: 0.8, circulation: 1.0 }
    }
}

/// Reason why a gearbox is of no use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fault {
    /// Links would cross in its scheme.
    NotDrawable,
    /// A forward gear has a lower efficiency.
    Forward,
    /// A reverse gear has a lower efficiency.
    Reverse,
    /// A forward gear has more circulating power.
    Circulation,
}

impl Usable {
    /// The first fault of a gearbox, in the order of [`Fault`].
    #[must_use]
    pub fn fault(&self, judged: &Judged, rating: &Rating) -> Option<Fault> {
        let forward = rating.gears.iter().enumerate().filter(|(gear, _)| judged.is_forward(*gear));
        let circulation = forward.map(|(_, gear)| gear.circulation).fold(0.0, f64::max);
        [
            (Fault::NotDrawable, !rating.is_drawable()),
            (Fault::Forward, judged.forward_efficiency() < self.forward),
            (Fault::Reverse, judged.reverse_efficiency().is_some_and(|reverse| reverse < self.reverse)),
            (Fault::Circulation, circulation > self.circulation),
        ]
        .into_iter()
        .find(|(_, is_so)| *is_so)
        .map(|(fault, _)| fault)
    }
}
