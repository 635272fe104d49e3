//! A planet set with profile shift: geometry with all interferences, and the shifts that an aim picks.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::closing::Closing;
use epicyclic_gears::involute::set::{Limits, PlanetSet};
use epicyclic_gears::involute::{InvoluteGear, Profile};
use std::hint::black_box;

fn involute(c: &mut Criterion) {
    let count = |teeth| ToothCount::new(teeth).expect("teeth");
    let teeth = [count(18), count(36), count(93)];
    let geometry = |shifts: [f64; 3]| {
        let [sun, planet, ring] = teeth;
        let external = |teeth, shift| InvoluteGear::new(GearKind::External, teeth, Profile::default(), shift);
        let ring = InvoluteGear::new(GearKind::Internal, ring, Profile::default(), shifts[2])?;
        let gears = [external(sun, shifts[0])?, external(planet, shifts[1])?, ring];
        let set = PlanetSet::new(gears, 3, 584.0 / 21.0)?.with_tip_clearance()?;
        Ok::<_, epicyclic_gears::Error>((set, set.faults(&Limits::default())))
    };
    let shifts = [0.3890, 0.5038, 0.1171];
    assert_eq!(geometry(shifts).map(|(_, faults)| faults), Ok(vec![]));
    c.bench_function("gears/involute/set", |b| b.iter(|| geometry(black_box(shifts))));

    let closing = Closing::default();
    assert!(closing.close(teeth).is_ok());
    c.bench_function("gears/involute/close", |b| b.iter(|| closing.close(black_box(teeth))));
}

criterion_group!(benches, involute);
criterion_main!(benches);
