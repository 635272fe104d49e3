//! Layouts of schemes, found once for each structure: another `k` does not change them.

use epicyclic_layout::{Options, Verdict, draw};
use epicyclic_train::{Gearbox, LinkId};
use std::cell::RefCell;
use std::rc::Rc;

/// Structures whose layouts are kept.
const KEPT: usize = 16;

thread_local! {
    static FOUND: RefCell<Vec<(String, Rc<Verdict>)>> = const { RefCell::new(vec![]) };
}

/// The layout of a gearbox, or what cannot be drawn together.
pub(crate) fn of(gearbox: &Gearbox) -> Rc<Verdict> {
    let key = structure(gearbox);
    FOUND.with_borrow_mut(|found| {
        if let Some(place) = found.iter().position(|(known, _)| *known == key) {
            let (_, verdict) = &found[place];
            return Rc::clone(verdict);
        }
        let verdict = Rc::new(draw(gearbox, Options::default()));
        if found.len() == KEPT {
            found.remove(0);
        }
        found.push((key, Rc::clone(&verdict)));
        verdict
    })
}

/// Text of everything that a layout depends on: gearboxes of equal text have equal layouts.
fn structure(gearbox: &Gearbox) -> String {
    let members: Vec<&[LinkId]> = gearbox.sets().iter().map(epicyclic_train::PlanetSet::members).collect();
    let ends: Vec<[LinkId; 2]> = gearbox.gears().iter().map(|gear| [gear.input(), gear.output()]).collect();
    format!(
        "{:?} {:?} {:?} {:?} {:?} {:?} {:?}",
        gearbox.links(),
        gearbox.drawn_sets(),
        members,
        gearbox.shift_elements(),
        gearbox.permanent(),
        ends,
        [gearbox.input(), gearbox.output()],
    )
}
