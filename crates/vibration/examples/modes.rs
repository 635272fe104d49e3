//! Natural frequencies of a set of four planets, with what sun, ring and carrier do in each.

use epicyclic_vibration::{Body, Central, Error, Planet, PlanetarySet, Support, newtons_per_meter};
use uom::si::f64::{Angle, Length, Mass};
use uom::si::{angle::degree, frequency::hertz, length::millimeter, mass::kilogram};

fn main() -> Result<(), Error> {
    let body = |mass, rotary_mass, radius| {
        let [mass, rotary_mass] = [mass, rotary_mass].map(Mass::new::<kilogram>);
        Body::with_rotary_mass(mass, rotary_mass, Length::new::<millimeter>(radius))
    };
    let stiff = newtons_per_meter;
    let free = Support { radial: stiff(1e8), tangential: stiff(0.0) };
    let [bearing, sun_mesh, ring_mesh] = [1e8, 5e8, 5e8].map(stiff);
    let planet =
        Planet { body: body(0.66, 0.61, 50.0), angle: Angle::default(), bearing, sun_mesh, ring_mesh };
    let set = PlanetarySet {
        sun: Central::new(body(0.4, 0.39, 38.7), free),
        ring: Central::new(body(2.35, 3.0, 137.5), Support { tangential: stiff(1e9), ..free }),
        carrier: Central::new(body(5.43, 6.29, 88.4), free),
        planets: planet.equally_spaced(4),
        sun_pressure_angle: Angle::new::<degree>(24.6),
        ring_pressure_angle: Angle::new::<degree>(24.6),
    };
    let (model, parts) = set.planar()?;
    for group in model.groups(&parts.central())? {
        println!("{:9.1} Hz  {} x {:?}", group.frequency.get::<hertz>(), group.multiplicity(), group.kind);
    }
    Ok(())
}
