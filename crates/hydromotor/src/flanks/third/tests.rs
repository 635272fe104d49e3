//! Tests of the third contact.

use super::*;
use crate::flanks::forces::tests::{alpha, mm, motor, mpa};
use crate::profile::ToothForm;
use uom::si::force::newton;

#[test]
fn the_forces_of_the_derivation_are_met() {
    let motor = motor((6, 4, 66, 10), 1.0, 40.0);
    let held =
        motor.third_contact(alpha(), angle(0.0), mm(-0.8), mm(0.9), mm(1.0), mpa(1.0)).unwrap().unwrap();
    println!("{held:?}");
    let profile = Profile::new(&motor, ToothForm::default()).unwrap();
    println!("{:?}", profile.third_contact_bounds(SealingContact::Nearest, mm(1.0), mpa(1.0)));
    println!("{:?}", profile.third_contact_bounds(SealingContact::NearestInMesh, mm(1.0), mpa(1.0)));
    for (force, expected) in [(held.stator, 5.8806), (held.rotor, 7.3164), (held.back, 2.2098)] {
        assert!((force.get::<newton>() - expected).abs() < 5e-5, "{held:?}");
    }
    assert_eq!(held.back_wheel, Mesh::Rotor);
}
