//! ISO 6336 of a mesh, external and internal, every factor calculated that can be.

use criterion::{Criterion, criterion_group, criterion_main};
use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
use epicyclic_strength::factor::{Given, Symbol};
use epicyclic_strength::load::{Arrangement, Dynamics};
use epicyclic_strength::material;
use epicyclic_strength::mesh::{Gear, Load, Mesh, Method};
use epicyclic_strength::rating::rate;
use epicyclic_strength::root::{factors::Bending, section::Shaper};
use std::hint::black_box;
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::f64::{AngularVelocity, KinematicViscosity, Length, Time, Torque};
use uom::si::kinematic_viscosity::square_millimeter_per_second;
use uom::si::length::{micrometer, millimeter};
use uom::si::{time::hour, torque::newton_meter};

/// The second stage of the NREL reference wind gearbox.
fn meshes() -> [Mesh; 2] {
    let gear = |kind, teeth, shift, fillet| {
        let profile = Profile { fillet, ..Profile::default() };
        InvoluteGear::new(kind, ToothCount::new(teeth).expect("teeth"), profile, shift).expect("a gear")
    };
    let shortened = |teeth, shift| {
        gear(GearKind::External, teeth, shift, 0.38).with_tip_alteration(-1.75 / 21.0).expect("a gear")
    };
    let (sun, planet) = (shortened(18, 0.3890), shortened(36, 0.5039));
    let ring = gear(GearKind::Internal, 93, 0.1171, 0.30);
    let own = |designation, shaper, bending| Gear {
        material: material::listed(designation).expect("listed").material,
        flank_roughness: Length::new::<micrometer>(4.8),
        root_roughness: Length::new::<micrometer>(20.0),
        rim: None,
        shaper,
        bending,
    };
    let mesh = |one, other, gears| Mesh {
        pair: Pair::at_centre_distance(one, other, 584.0 / 21.0).expect("a mesh"),
        module: Length::new::<millimeter>(21.0),
        face_width: Length::new::<millimeter>(550.0),
        gears,
        viscosity: KinematicViscosity::new::<square_millimeter_per_second>(220.0),
    };
    let external = own("18CrNiMo7-6", None, Bending::OneWay);
    let reversed = Gear { bending: Bending::Reversed, ..external };
    let shaper = Some(Shaper { teeth: 30, shift: 0.0 });
    [
        mesh(sun, planet, [external, reversed]),
        mesh(planet, ring, [reversed, own("34CrNiMo6", shaper, Bending::OneWay)]),
    ]
}

fn strength(c: &mut Criterion) {
    let load = Load {
        torque: Torque::new::<newton_meter>(54_035.2),
        speed: AngularVelocity::new::<revolution_per_minute>(246.7),
        life: Time::new::<hour>(175_200.0),
        contacts: [3.0, 1.0],
    };
    let given = Given::default().with(Symbol::Application, 1.25).with(Symbol::FaceContact, 1.15);
    let dynamics = |arrangement| Dynamics {
        arrangement,
        pitch_deviations: [Length::new::<micrometer>(18.0); 2],
        profile_deviations: [Length::new::<micrometer>(23.0); 2],
        tip_relief: None,
        rims: [None; 2],
        blank_factor: 1.0,
    };
    let [outer, inner] = meshes();
    for (name, mesh, arrangement) in
        [("external", outer, Arrangement::SunAndPlanets(3)), ("internal", inner, Arrangement::PlanetInRing)]
    {
        let method =
            Method { given, planets: Some(3), dynamics: Some(dynamics(arrangement)), ..Method::default() };
        let rating = rate(&mesh, &load, &method).expect("a rating");
        assert!(rating.gears.iter().all(|gear| {
            let [flank, root] =
                [gear.contact.as_ref().map(|own| own.safety), gear.root.as_ref().map(|own| own.safety)];
            flank.is_ok_and(|safety| safety > 1.0) && root.is_ok_and(|safety| safety > 1.0)
        }));
        c.bench_function(&format!("strength/mesh/{name}"), |b| {
            b.iter(|| rate(black_box(&mesh), black_box(&load), black_box(&method)));
        });
    }
}

criterion_group!(benches, strength);
criterion_main!(benches);
