//! Which mechanisms can be drawn, and locked in which ways.

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::Gearbox;
use epicyclic_schemes::drawability::{Options, Verdict, draw, is_drawable};
use epicyclic_schemes::locking::LOCKING_PAIRS;
use epicyclic_schemes::selection::Mechanism;
use epicyclic_schemes::structures::Role;

/// Whether a mechanism can be drawn without self-crossing, locked in one way or another; if not, what cannot be drawn
/// together when its shafts are locked.
pub(super) fn of(mechanism: Mechanism) -> Result<(), String> {
    if LOCKING_PAIRS.iter().any(|pair| is_lock_drawable(mechanism, *pair)) {
        return Ok(());
    }
    let Some(gearbox) = gearbox(mechanism, [Role::D, Role::B]) else { return Ok(()) };
    match draw(&gearbox, Options { attempts: 1, ..Options::default() }) {
        Verdict::Drawable(_) => Ok(()),
        Verdict::SelfCrossing(witness) => Err(witness.describe(&gearbox)),
    }
}

/// Whether it can be drawn with this clutch for direct drive.
pub(super) fn is_lock_drawable(mechanism: Mechanism, pair: [Role; 2]) -> bool {
    gearbox(mechanism, pair).is_some_and(|gearbox| is_drawable(&gearbox))
}

/// The mechanism with any parameters: a drawing does not depend on them.
fn gearbox(mechanism: Mechanism, pair: [Role; 2]) -> Option<Gearbox> {
    let k = vec![2.5; mechanism.rows().len()];
    mechanism.gearbox(&k, MeshEfficiency::IDEAL, pair).ok()
}
