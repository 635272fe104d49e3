//! Masses and inertias of the parts of a drive.

use super::part::{BoredGear, Computed};
use super::result::{GearMass, GearSetGeometry, Masses, ShaftDesign, Shafts};
use super::spec::{Bore, CarrierSpec, GearSetSpec};
use super::warning::Warning;
use super::{Faults, finite};
use crate::Error;
use crate::planetary::{GearSet, PlanetaryDrive};
use epicyclic_gears::bearing::{self, Series};
use epicyclic_gears::carrier::Carrier;
use epicyclic_gears::geometry;
use epicyclic_gears::mass::GearBody;
use epicyclic_units::Physical;
use uom::si::f64::{Length, MassDensity, MomentOfInertia};

/// Relative difference between the radius of the arms' holes and the centre distance that is worth a warning.
const OFF_CENTRE: f64 = 1e-4;

/// Inertias on the shafts outside the gear set.
#[derive(Clone, Copy)]
pub(super) struct Ends {
    pub(super) motor: MomentOfInertia,
    pub(super) machine: MomentOfInertia,
}

pub(super) fn masses(
    wanted: &GearSetSpec,
    carrier: &CarrierSpec,
    series: Series,
    planets: u32,
    gear_set: &GearSetGeometry,
    shafts: &Shafts,
    warnings: &mut Vec<Warning>,
) -> Result<Masses, Faults> {
    let (width, density) = (gear_set.face_width, wanted.density);
    let sun = bore(wanted.sun_bore, &shafts.sun, series)
        .and_then(|bore| gear_mass(BoredGear::Sun, &gear_set.sun, bore, width, density));
    let planet_bore = match wanted.planet_bore {
        Bore::BearingOrSolid => {
            Ok(bearing_or_solid(&shafts.planet, gear_set.planet.root_diameter(), warnings))
        }
        given => bore(given, &shafts.planet, series),
    };
    if let Bore::Given(given) = wanted.planet_bore {
        warnings.extend(too_narrow(given, &shafts.planet));
    }
    let planet =
        planet_bore.and_then(|bore| gear_mass(BoredGear::Planet, &gear_set.planet, bore, width, density));
    let carrier = carrier_mass(carrier, density, planets, gear_set, warnings);
    match (sun, planet, carrier) {
        (Ok(sun), Ok(planet), Ok((carrier_shape, carrier_inertia))) => {
            let carrier = carrier_shape.map(|shape| shape.total().mass);
            Ok(Masses { sun, planet, carrier, carrier_inertia, carrier_shape })
        }
        (sun, planet, carrier) => {
            let faults = [sun.err(), planet.err(), carrier.err()];
            Err(Faults(faults.into_iter().flatten().collect()))
        }
    }
}

/// Shape of the carrier, if it has one, and its inertia.
fn carrier_mass(
    carrier: &CarrierSpec,
    density: MassDensity,
    planets: u32,
    gear_set: &GearSetGeometry,
    warnings: &mut Vec<Warning>,
) -> Result<(Option<Carrier>, MomentOfInertia), Error> {
    let (shape, inertia) = match *carrier {
        CarrierSpec::Neglected => {
            warnings.push(Warning::CarrierNeglected);
            (None, MomentOfInertia::from_si(0.0))
        }
        CarrierSpec::Inertia(given) => (None, given),
        CarrierSpec::Shape { arm, hub } => {
            let shape = Carrier::new(planets, arm, hub, density)?;
            let whole = shape.total();
            if let Some(hole) = arm.hole {
                let hole_mm = (hub.outer_radius + arm.length - hole.from_outer_end).mm();
                let centre_distance_mm = gear_set.centre_distance.mm();
                if (hole_mm / centre_distance_mm - 1.0).abs() > OFF_CENTRE {
                    warnings.push(Warning::PlanetPinOffCentre { hole_mm, centre_distance_mm });
                }
            }
            finite(Computed::CarrierMass, whole.mass.si())?;
            (Some(shape), whole.polar_inertia)
        }
    };
    finite(Computed::CarrierInertia, inertia.si())?;
    Ok((shape, inertia))
}

/// Diameter of the hole in a gear.
fn bore(wanted: Bore, shaft: &ShaftDesign, series: Series) -> Result<Length, Error> {
    Ok(match wanted {
        Bore::Given(bore) => bore,
        Bore::Shaft => shaft.used.diameter,
        Bore::Bearing | Bore::BearingOrSolid => match shaft.used.bearing {
            Some(bearing) => bearing.outside_diameter,
            // Refused again, now that the bearing is needed.
            None => bearing::smallest_for_shaft(series, shaft.used.diameter)?.outside_diameter,
        },
    })
}

/// The bearing's outside diameter; none where no bearing goes into the planet, which is said.
fn bearing_or_solid(pin: &ShaftDesign, root: Length, warnings: &mut Vec<Warning>) -> Length {
    match pin.used.bearing {
        Some(bearing) if bearing.outside_diameter < root => bearing.outside_diameter,
        Some(bearing) => {
            warnings.push(Warning::PlanetBearingTooLarge {
                bearing: bearing.designation,
                outside_mm: bearing.outside_diameter.mm(),
                pin_mm: pin.used.diameter.mm(),
                root_mm: root.mm(),
            });
            Length::default()
        }
        // The missing bearing already has a warning.
        None => Length::default(),
    }
}

/// Warning for a given bore that is too narrow for the pin or its bearing; a solid gear has no chosen hole
/// and needs none.
fn too_narrow(bore: Length, pin: &ShaftDesign) -> Option<Warning> {
    let needs = pin.used.bearing.map_or(pin.used.diameter, |bearing| bearing.outside_diameter);
    (bore > Length::default() && bore < needs).then(|| Warning::PlanetBoreTooNarrow {
        bore_mm: bore.mm(),
        pin_mm: pin.used.diameter.mm(),
        bearing: pin.used.bearing.map(|bearing| (bearing.designation, bearing.outside_diameter.mm())),
    })
}

fn gear_mass(
    name: BoredGear,
    gear: &geometry::ToothedGear,
    bore: Length,
    width: Length,
    density: MassDensity,
) -> Result<GearMass, Error> {
    if bore >= gear.root_diameter() {
        let (bore_mm, root_mm) = (bore.mm(), gear.root_diameter().mm());
        return Err(Error::BoreTooLarge { gear: name, bore_mm, root_mm });
    }
    let body = GearBody::external(gear, width, bore, density)?;
    let total = body.total();
    finite(Computed::GearMass, total.mass.si())?;
    finite(Computed::GearInertia, total.polar_inertia.si())?;
    Ok(GearMass { bore, body, mass: total.mass, inertia: total.polar_inertia })
}

/// The drive with everything that turns on its shafts.
pub(super) fn planetary_drive(
    set: GearSet,
    centre_distance: Length,
    masses: &Masses,
    ends: Ends,
) -> PlanetaryDrive {
    PlanetaryDrive {
        set,
        sun_inertia: masses.sun.inertia + ends.motor,
        planet_inertia: masses.planet.inertia,
        planet_mass: masses.planet.mass,
        planet_radius: centre_distance,
        carrier_inertia: masses.carrier_inertia + ends.machine,
    }
}
