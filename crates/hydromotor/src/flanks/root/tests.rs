//! Tests of the bending at the roots.

use super::*;
use crate::flanks::effective_modulus;
use crate::flanks::forces::tests::{mm, motor, mpa};
use crate::profile::ToothForm;
use uom::si::pressure::{gigapascal, megapascal};

fn limits() -> MaterialLimits {
    let modulus = effective_modulus([Pressure::new::<gigapascal>(206.0); 2], [0.3; 2]).unwrap();
    MaterialLimits { contact: mpa(1500.0), root: mpa(400.0), modulus }
}

#[test]
fn shows() {
    for numbers in [(5, 3, 55, 10), (6, 4, 66, 10)] {
        let motor = motor(numbers, 1.0, 40.0);
        let profile = Profile::new(&motor, ToothForm::default()).unwrap();
        for points in [12, 24, 48, 400, 2000] {
            for (wheel, w) in profile.bent(points).unwrap() {
                println!("{numbers:?} {points} {wheel:?} {w:?}");
            }
        }
        println!("{:?}", profile.allowed_pressure(&limits()));
    }
}
