//! Tests of the sealing at the flanks.

use super::*;
use crate::flanks::forces::tests::{mm, motor};
use crate::profile::ToothForm;
use uom::si::area::square_millimeter;

fn plain() -> ToothForm {
    ToothForm { shift: 0.0, backlash: 0.0, ..ToothForm::default() }
}

#[test]
fn the_ripples_of_the_derivation_are_met() {
    for numbers in [(6, 4, 66, 10), (5, 3, 55, 10)] {
        let motor = motor(numbers, 1.0, 40.0);
        for form in
            [plain(), ToothForm { crest: crate::profile::Crest::Tooth, ..plain() }, ToothForm::default()]
        {
            let Ok(profile) = Profile::new(&motor, form) else {
                println!("none");
                continue;
            };
            for rule in [SealingContact::Nearest, SealingContact::NearestInMesh] {
                let ripple = profile.flank_ripple(rule);
                println!(
                    "{numbers:?} {} {rule:?} {} {} {} mean {}",
                    form.shift,
                    ripple.at_flanks.delta,
                    ripple.at_pitch_points.delta,
                    ripple.least_over_mean,
                    (ripple.at_flanks.mean / ripple.at_pitch_points.mean).value - 1.0
                );
            }
        }
        let Ok(profile) = Profile::new(&motor, ToothForm::default()) else { continue };
        for side in Side::BOTH {
            for sign in [1.0, -1.0] {
                for p in profile.paths(side, sign) {
                    println!("{side:?} {sign} {p:?}");
                }
            }
        }
    }
}
