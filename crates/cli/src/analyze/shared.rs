//! What the tables of one input and of several have in common.

use epicyclic_train::Gearbox;
use epicyclic_train::power_flow::MeshPower;
use epicyclic_views::figure::{Figure, text};

/// Whether a shift element is engaged.
pub(super) fn state(is_engaged: bool) -> Figure {
    if is_engaged { Figure::Answer("engaged", "engaged") } else { Figure::Answer("open", "open") }
}

/// The meshes of all sets in the sense of their power, with what `power` says of those of a set.
pub(super) fn meshes(
    gearbox: &Gearbox,
    power: impl Fn(usize) -> Option<Vec<MeshPower>>,
    figure: impl Fn(Option<f64>) -> Figure,
) -> Vec<Vec<Figure>> {
    let mut rows = vec![];
    for (place, set) in gearbox.sets().iter().enumerate() {
        let powers = power(place);
        for (at, mesh) in set.meshes().iter().enumerate() {
            let through = powers.as_ref().map(|powers| powers[at]);
            let [mut from, mut to] = mesh.gears;
            if through.is_some_and(|power| power.sense < 0) {
                std::mem::swap(&mut from, &mut to);
            }
            rows.push(vec![
                text(set.id()),
                text(set.gear_name(from)),
                text(set.gear_name(to)),
                Figure::Multiple(mesh.efficiency.get()),
                figure(through.map(|power| power.enters)),
                figure(through.map(|power| power.leaves)),
            ]);
        }
    }
    rows
}
