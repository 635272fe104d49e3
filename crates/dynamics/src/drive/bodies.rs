//! Masses and inertias of the parts of a drive.

use super::finite;
use super::part::BoredGear;
use super::result::{GearMass, GearSetGeometry, Masses, ShaftDesign, Shafts};
use super::spec::{Bore, CarrierSpec, DriveSpec};
use super::warning::Warning;
use crate::Error;
use crate::planetary::{GearSet, PlanetaryDrive};
use crate::units::{inertia, kg_m2, kilograms, millimeters};
use epicyclic_gears::bearing;
use epicyclic_gears::carrier::Carrier;
use epicyclic_gears::geometry;
use epicyclic_gears::mass::GearBody;
use epicyclic_gears::synthesis::ToothNumbers;

/// Relative difference between the radius of the arms' holes and the centre distance that is worth a warning.
const OFF_CENTRE: f64 = 1e-4;

pub(super) fn masses(
    spec: &DriveSpec,
    teeth: ToothNumbers,
    gear_set: &GearSetGeometry,
    shafts: &Shafts,
    warnings: &mut Vec<Warning>,
) -> Result<Masses, Error> {
    let sun = gear_mass(spec, BoredGear::Sun, &gear_set.sun, spec.gear_set.sun_bore, &shafts.sun)?;
    let planet =
        gear_mass(spec, BoredGear::Planet, &gear_set.planet, spec.gear_set.planet_bore, &shafts.planet)?;
    let (mass, carrier_inertia) = match spec.carrier {
        CarrierSpec::Neglected => {
            warnings.push(Warning::CarrierNeglected);
            (None, inertia(0.0))
        }
        CarrierSpec::Inertia(given) => (None, given),
        CarrierSpec::Shape { arm, hub } => {
            let whole = Carrier::new(teeth.planets, arm, hub, spec.gear_set.density)?.total();
            if let Some(hole) = arm.hole {
                let hole_mm = millimeters(hub.outer_radius + arm.length - hole.from_outer_end);
                let centre_distance_mm = millimeters(gear_set.centre_distance);
                if (hole_mm / centre_distance_mm - 1.0).abs() > OFF_CENTRE {
                    warnings.push(Warning::PlanetPinOffCentre { hole_mm, centre_distance_mm });
                }
            }
            finite("mass of the carrier", kilograms(whole.mass))?;
            (Some(whole.mass), whole.polar_inertia)
        }
    };
    finite("inertia of the carrier", kg_m2(carrier_inertia))?;
    Ok(Masses { sun, planet, carrier: mass, carrier_inertia })
}

fn gear_mass(
    spec: &DriveSpec,
    name: BoredGear,
    gear: &geometry::ToothedGear,
    bore: Bore,
    shaft: &ShaftDesign,
) -> Result<GearMass, Error> {
    let bore = match bore {
        Bore::Given(bore) => bore,
        Bore::Shaft => shaft.used.diameter,
        Bore::Bearing => match shaft.used.bearing {
            Some(bearing) => bearing.outside_diameter,
            // Refused again, now that the bearing is needed.
            None => {
                bearing::smallest_for_shaft(spec.shafts.bearing_series, shaft.used.diameter)?.outside_diameter
            }
        },
    };
    if bore >= gear.root_diameter() {
        let (bore_mm, root_mm) = (millimeters(bore), millimeters(gear.root_diameter()));
        return Err(Error::BoreTooLarge { gear: name, bore_mm, root_mm });
    }
    let body = GearBody::external(gear, spec.gear_set.face_width, bore, spec.gear_set.density)?;
    finite("mass of a gear", kilograms(body.total().mass))?;
    finite("inertia of a gear", kg_m2(body.total().polar_inertia))?;
    Ok(GearMass { bore, body })
}

/// The drive with everything that turns on its shafts.
pub(super) fn planetary_drive(
    spec: &DriveSpec,
    set: GearSet,
    gear_set: &GearSetGeometry,
    masses: &Masses,
) -> PlanetaryDrive {
    let planet = masses.planet.body.total();
    PlanetaryDrive {
        set,
        sun_inertia: masses.sun.body.total().polar_inertia + spec.motor_inertia,
        planet_inertia: planet.polar_inertia,
        planet_mass: planet.mass,
        planet_radius: gear_set.centre_distance,
        carrier_inertia: masses.carrier_inertia + spec.machine_inertia,
    }
}
