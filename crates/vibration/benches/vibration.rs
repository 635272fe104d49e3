//! Modes of a set of four planets.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_vibration::{Body, Central, Planet, PlanetarySet, Support, newtons_per_meter};
use std::hint::black_box;
use uom::si::f64::{Angle, Length, Mass};
use uom::si::{angle::degree, frequency::hertz, length::millimeter, mass::kilogram};

fn set(planets: usize) -> PlanetarySet {
    let kg = Mass::new::<kilogram>;
    let body = |mass, rotary, radius_mm| {
        Body::with_rotary_mass(kg(mass), kg(rotary), Length::new::<millimeter>(radius_mm))
    };
    let support = |radial, tangential| Support {
        radial: newtons_per_meter(radial),
        tangential: newtons_per_meter(tangential),
    };
    let planet = Planet {
        body: body(0.66, 0.61, 50.0),
        angle: Angle::new::<degree>(0.0),
        bearing: newtons_per_meter(1e8),
        sun_mesh: newtons_per_meter(5e8),
        ring_mesh: newtons_per_meter(5e8),
    };
    PlanetarySet {
        sun: Central::new(body(0.4, 0.39, 40.0), support(1e8, 0.0)),
        ring: Central::new(body(2.35, 3.0, 140.0), support(1e8, 1e9)),
        carrier: Central::new(body(5.43, 6.29, 99.0), support(1e8, 0.0)),
        planets: planet.equally_spaced(planets),
        sun_pressure_angle: Angle::new::<degree>(24.6),
        ring_pressure_angle: Angle::new::<degree>(24.6),
    }
}

fn vibration(c: &mut Criterion) {
    let set = set(4);
    let (model, parts) = set.planar().expect("a set");
    let modes = model.modes().expect("modes");
    let highest = modes.modes.last().expect("a mode").frequency.get::<hertz>();
    assert!((highest - 13071.1).abs() < 0.1, "{highest}");
    let mut group = c.benchmark_group("vibration/modes");
    group.bench_function("four_planets", |b| b.iter(|| black_box(&model).modes()));
    group.bench_function("four_planets_from_the_set_with_kinds", |b| {
        b.iter(|| {
            let (model, parts) = black_box(&set).planar()?;
            model.groups(&parts.central())
        });
    });
    group.finish();
    black_box(parts);
}

criterion_group!(benches, vibration);
criterion_main!(benches);
