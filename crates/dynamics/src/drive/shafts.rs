//! Shafts by a low allowable torsional stress, and their bearings.

use super::finite;
use super::part::{Computed, Shaft};
use super::result::{Choice, ShaftDesign, Shafts, Torques};
use super::spec::{ShaftSpec, ShaftsSpec};
use super::warning::Warning;
use crate::Error;
use crate::tolerance::DIAMETER;
use epicyclic_gears::bearing::{self, Verification};
use epicyclic_gears::shaft::{self, USUAL_ALLOWABLE_STRESS_MPA};
use epicyclic_units::Physical;
use uom::si::f64::Torque;

pub(super) fn shafts(
    wanted: &ShaftsSpec,
    torques: &Torques,
    warnings: &mut Vec<Warning>,
) -> Result<Shafts, Error> {
    let allowable_mpa = wanted.allowable_stress.mpa();
    let shafts = Shafts {
        sun: of(wanted, Shaft::Sun, &wanted.sun, torques.sun, warnings)?,
        planet: of(wanted, Shaft::Planet, &wanted.planet, torques.planets, warnings)?,
        carrier: of(wanted, Shaft::Carrier, &wanted.carrier, torques.carrier, warnings)?,
    };
    if !USUAL_ALLOWABLE_STRESS_MPA.contains(&allowable_mpa) {
        warnings.push(Warning::StressOutsideUsualRange { allowable_mpa });
    }
    Ok(shafts)
}

fn of(
    wanted: &ShaftsSpec,
    name: Shaft,
    given: &ShaftSpec,
    torque: Torque,
    warnings: &mut Vec<Warning>,
) -> Result<ShaftDesign, Error> {
    let (allowable, series) = (wanted.allowable_stress, wanted.bearing_series);
    let needed = shaft::diameter(torque, allowable)?;
    let standard = shaft::standard_diameter(needed)?;
    let standard = Choice { diameter: standard, bearing: bearing::smallest_for_shaft(series, standard).ok() };
    let diameter = given.diameter.or(given.bearing.map(|bearing| bearing.bore)).unwrap_or(standard.diameter);
    let stress = shaft::torsional_stress(torque, diameter)?;
    finite(Computed::ShaftStress, stress.si())?;
    let bearing = given.bearing.or_else(|| bearing::smallest_for_shaft(series, diameter).ok());

    let diameter_mm = diameter.mm();
    let needed_mm = needed.mm();
    if diameter_mm < needed_mm * (1.0 - DIAMETER) {
        warnings.push(Warning::ShaftTooThin {
            shaft: name,
            diameter_mm,
            needed_mm,
            stress_mpa: stress.mpa(),
            allowable_mpa: allowable.mpa(),
        });
    }
    match bearing {
        None => warnings.push(Warning::NoBearing { shaft: name, series: series.number(), diameter_mm }),
        Some(bearing) => {
            let bore_mm = bearing.bore.mm();
            if bore_mm < diameter_mm * (1.0 - DIAMETER) {
                let bearing = bearing.designation;
                warnings.push(Warning::BearingTooNarrow { shaft: name, bearing, bore_mm, diameter_mm });
            }
            if bearing.verification == Verification::Unverified {
                let bearing = bearing.designation;
                warnings.push(Warning::UnverifiedBearing { shaft: name, bearing });
            }
        }
    }
    Ok(ShaftDesign { torque, needed, standard, used: Choice { diameter, bearing }, stress })
}
