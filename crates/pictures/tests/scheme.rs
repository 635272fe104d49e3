//! Schemes of the catalogue and of gearboxes in service: no label meets anything.

mod common;

use common::{catalogue, check, in_service, layout};
use epicyclic_pictures::gearbox::scheme::{Options, Show, scene};
use epicyclic_schemes::Gearbox;

fn all() -> impl Iterator<Item = Gearbox> {
    catalogue().into_iter().chain(in_service())
}

#[test]
fn no_label_of_a_structure_meets_anything() {
    for gearbox in all() {
        let layout = layout(&gearbox);
        for whole in [false, true] {
            let title = whole.then(|| format!("{}, whole", gearbox.name()));
            let options = Options { whole, title, ..Options::default() };
            check(&scene(&gearbox, &layout, Show::Structure, &options).unwrap());
        }
    }
}

#[test]
fn no_label_of_a_gear_meets_anything() {
    for gearbox in all() {
        let layout = layout(&gearbox);
        for gear in gearbox.gears() {
            let analysis = gearbox.analyze(gear.name()).unwrap();
            let title = format!("{} gear {}", gearbox.name(), gear.name());
            for (show, title) in [
                (Show::Gear(&analysis), format!("{title} state")),
                (Show::Power(&analysis), format!("{title} power")),
            ] {
                let options = Options { title: Some(title), ..Options::default() };
                check(&scene(&gearbox, &layout, show, &options).unwrap());
            }
        }
    }
}
