//! Speed plans, levers and ladders of the catalogue and of gearboxes in service: no label meets anything.

mod common;

use common::{catalogue, check, in_service};
use epicyclic_pictures::gearbox::{ladder, levers, speeds};
use epicyclic_schemes::{Analysis, Gearbox};

fn all() -> impl Iterator<Item = Gearbox> {
    catalogue().into_iter().chain(in_service())
}

fn gears(gearbox: &Gearbox) -> Vec<Analysis> {
    gearbox.gears().iter().map(|gear| gearbox.analyze(gear.name()).unwrap()).collect()
}

#[test]
fn no_label_of_a_speed_plan_meets_anything() {
    for gearbox in all() {
        for gear in gears(&gearbox) {
            let title = format!("{} gear {} speeds", gearbox.name(), gear.gear().name());
            check(&speeds::scene(&gearbox, &gear, Some(&title)).unwrap());
        }
    }
}

#[test]
fn no_label_of_a_lever_meets_anything() {
    for gearbox in all() {
        check(&levers::scene(&gearbox, None, Some(&format!("{} levers", gearbox.name()))).unwrap());
        for gear in gears(&gearbox) {
            let title = format!("{} gear {} levers", gearbox.name(), gear.gear().name());
            check(&levers::scene(&gearbox, Some(&gear), Some(&title)).unwrap());
        }
    }
}

#[test]
fn no_label_of_a_ladder_meets_anything() {
    for gearbox in all() {
        let title = format!("{} ladder", gearbox.name());
        check(&ladder::scene(&gearbox, &gears(&gearbox), Some(&title)).unwrap());
    }
}
