//! Tests of the pressures of Hertz.

use super::*;
use crate::flanks::forces::tests::{alpha, mm, motor, mpa};
use crate::profile::ToothForm;
use uom::si::pressure::{gigapascal, megapascal};

#[test]
fn the_pressures_of_the_derivation_are_met() {
    for e in [206.0, 210.0] {
        let steel = effective_modulus([Pressure::new::<gigapascal>(e); 2], [0.3; 2]).unwrap();
        for numbers in [(5, 3, 55, 10), (6, 4, 66, 10)] {
            let motor = motor(numbers, 1.0, 40.0);
            let profile = Profile::new(&motor, ToothForm::default()).unwrap();
            for s in profile.contact_stresses(mpa(20.0), steel).unwrap() {
                let show = |p: PeakPressure| {
                    (p.pressure.get::<megapascal>(), p.rotation.value, p.offset.value * 1e3)
                };
                let at = motor
                    .contact_pressure(
                        alpha(),
                        s.mesh,
                        s.at_pitch_point.rotation * 0.9999999,
                        mm(1.34),
                        mpa(20.0),
                        steel,
                    )
                    .unwrap();
                println!(
                    "{e} {numbers:?} {:?} {:?} {:?} {:?} {:?} {}",
                    s.mesh,
                    s.push,
                    show(s.at_pitch_point),
                    s.in_single_contact.map(show),
                    s.on_path.map(show),
                    at.get::<megapascal>()
                );
            }
        }
    }
}
