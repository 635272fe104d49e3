//! Laws that every mesh keeps, and what is refused.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
use epicyclic_strength::Error;
use epicyclic_strength::factor::{Edition, Given, Side, Symbol};
use epicyclic_strength::load::{Arrangement, Dynamics, mesh_stiffness};
use epicyclic_strength::material::{self, Class, Material};
use epicyclic_strength::mesh::{Gear, Load, Mesh, Method};
use epicyclic_strength::rating::{ContactRating, GearRating, MeshRating, Place, RootRating, overload, rate};
use epicyclic_strength::root::{factors::Bending, section::Shaper};
use epicyclic_strength::spectrum::{Step, Stresses, Worn, rate_duty, stresses};
use proptest::prelude::*;
use uom::si::angle::degree;
use uom::si::angular_velocity::revolution_per_minute;
use uom::si::f64::{Angle, AngularVelocity, KinematicViscosity, Length, Pressure, Time, Torque};
use uom::si::kinematic_viscosity::square_millimeter_per_second;
use uom::si::length::{micrometer, millimeter};
use uom::si::pressure::megapascal;
use uom::si::time::hour;
use uom::si::torque::newton_meter;

fn um(value: f64) -> Length {
    Length::new::<micrometer>(value)
}

fn torque(value: f64) -> Torque {
    Torque::new::<newton_meter>(value)
}

fn speed(value: f64) -> AngularVelocity {
    AngularVelocity::new::<revolution_per_minute>(value)
}

fn life(value: f64) -> Time {
    Time::new::<hour>(value)
}

/// A pinion in an external gear or in a ring, module 4 mm.
fn mesh(z1: u32, z2: u32, ring: bool, helix_deg: f64) -> Mesh {
    let profile = Profile { helix_angle: Angle::new::<degree>(helix_deg), fillet: 0.3, ..Profile::default() };
    let gear = |kind, teeth, shift| {
        InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), profile, shift).unwrap()
    };
    let second =
        if ring { gear(GearKind::Internal, z1 + z2, -0.2) } else { gear(GearKind::External, z2, 0.1) };
    let steel = material::listed("18CrNiMo7-6").unwrap().material;
    let own = Gear::solid(steel, um(4.0), um(16.0));
    let shaper = ring.then_some(Shaper { teeth: 20, shift: 0.0 });
    Mesh {
        pair: Pair::without_backlash(gear(GearKind::External, z1, 0.2), second).unwrap(),
        module: Length::new::<millimeter>(4.0),
        face_width: Length::new::<millimeter>(50.0),
        gears: [own, Gear { shaper, ..own }],
        viscosity: KinematicViscosity::new::<square_millimeter_per_second>(220.0),
    }
}

/// Length of contact between the tip circles, modules.
fn contact_by_tips(pair: &Pair) -> f64 {
    let [first, second] = pair.gears();
    let [one, other] = [first, second].map(|gear| gear.curvature_radius(gear.tip_diameter()));
    let line = pair.centre_distance() * libm::sin(pair.working_angle_rad());
    if pair.is_internal() { one - other + line } else { one + other - line }
}

fn load(n_m: f64, rpm: f64, hours: f64) -> Load {
    Load { torque: torque(n_m), speed: speed(rpm), life: life(hours), contacts: [1.0, 1.0] }
}

fn method() -> Method {
    Method { given: Given::load_factors([1.25, 1.0, 1.1, 1.2, 1.0]), ..Method::default() }
}

fn contact(gear: &GearRating) -> &ContactRating {
    gear.contact.as_ref().unwrap()
}

fn root(gear: &GearRating) -> &RootRating {
    gear.root.as_ref().unwrap()
}

fn safeties(rating: &MeshRating) -> [f64; 4] {
    let [first, second] = &rating.gears;
    let (flank, root) = (|gear| contact(gear).safety, |gear| root(gear).safety);
    [flank(first), flank(second), root(first), root(second)]
}

proptest! {
    /// With all load factors given, stress grows with the root of the torque on the flank, with the torque
    /// itself at the root.
    #[test]
    fn safeties_fall_with_the_torque(
        z1 in 17..40_u32, z2 in 30..80_u32, ring in any::<bool>(), helix in 0.0..20.0_f64, n_m in 50.0..2000.0_f64, times in 1.1..4.0_f64,
    ) {
        let mesh = mesh(z1, z2, ring, helix);
        let of = |n_m| rate(&mesh, &load(n_m, 1000.0, 20e3), &method()).unwrap();
        let (light, heavy) = (safeties(&of(n_m)), safeties(&of(n_m * times)));
        for index in [0, 1] {
            prop_assert!((light[index] / heavy[index] / times.sqrt() - 1.0).abs() < 1e-9);
            prop_assert!((light[index + 2] / heavy[index + 2] / times - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn safeties_never_rise_with_the_life(
        z1 in 17..40_u32, ring in any::<bool>(), hours in 0.1..1e5_f64, times in 1.0..1e3_f64,
    ) {
        let mesh = mesh(z1, 50, ring, 0.0);
        let of = |hours| safeties(&rate(&mesh, &load(500.0, 1000.0, hours), &method()).unwrap());
        for (short, long) in of(hours).into_iter().zip(of(hours * times)) {
            prop_assert!(long <= short * (1.0 + 1e-12), "{short} {long}");
        }
    }

    /// The second way to the contact stress: Hertz's pressure of two cylinders, at the pitch point and at the
    /// inner points of single contact.
    #[test]
    fn contact_is_the_pressure_of_two_cylinders(z1 in 17..40_u32, z2 in 30..80_u32, ring in any::<bool>(), n_m in 50.0..2000.0_f64) {
        let mesh = mesh(z1, z2, ring, 0.0);
        let rating = rate(&mesh, &load(n_m, 1000.0, 20e3), &method()).unwrap();
        let first = &mesh.pair.gears()[0];
        let line = mesh.pair.centre_distance() * libm::sin(mesh.pair.working_angle_rad());
        // Lengths in modules of 4 mm; of a ring the centre of curvature lies on the other side.
        let radii = |own: f64| if ring { [own, -(own + line)] } else { [own, line - own] };
        let force = n_m * 2000.0 / (4.0 * first.base_diameter());
        let pressure = |own: f64| {
            let [one, other] = radii(own);
            let curvature = (1.0 / one + 1.0 / other) / 4.0;
            let modulus = 206_000.0 / (1.0 - 0.09) / 2.0;
            (force / 50.0 * curvature * modulus / std::f64::consts::PI).sqrt()
        };
        let z_epsilon = rating.contact_factors[2].value;
        let nominal = rating.nominal_contact.get::<megapascal>();
        let at_pitch = pressure(first.base_diameter() / 2.0 * libm::tan(mesh.pair.working_angle_rad()));
        prop_assert!((nominal / z_epsilon / at_pitch - 1.0).abs() < 1e-9);
        // If contact ends at the tips this is the standard's formula.
        let inner = pressure(mesh.pair.contact()[1] - mesh.pair.base_pitch());
        let z_b = contact(&rating.gears[0]).single_contact.value;
        prop_assert!((z_b - (inner / at_pitch).max(1.0)).abs() < 1e-9, "{z_b} {}", inner / at_pitch);
        let [tip1, tip2] = [first, &mesh.pair.gears()[1]].map(|gear| gear.tip_diameter() / gear.base_diameter());
        let ends = [
            mesh.pair.contact()[1] - first.curvature_radius(first.tip_diameter()),
            mesh.pair.transverse_contact_ratio() * mesh.pair.base_pitch() - contact_by_tips(&mesh.pair),
        ];
        if ends.iter().all(|difference| difference.abs() < 1e-9) {
            let (z1, z2) = (f64::from(z1), if ring { -f64::from(z1 + z2) } else { f64::from(z2) });
            let turn = std::f64::consts::TAU;
            let own = (tip1 * tip1 - 1.0).sqrt() - turn / z1;
            let mates = (tip2 * tip2 - 1.0).sqrt() - (mesh.pair.transverse_contact_ratio() - 1.0) * turn / z2;
            let m = libm::tan(mesh.pair.working_angle_rad()) / (own * mates).sqrt();
            prop_assert!((z_b - m.max(1.0)).abs() < 1e-9, "{z_b} {m}");
        }
        prop_assert!(!ring || contact(&rating.gears[1]).single_contact.value == 1.0);
    }

    /// A mesh turned round is the same mesh: which of two gears is called the first changes nothing.
    #[test]
    fn a_mesh_turned_round_is_the_same(
        z1 in 14..60_u32, z2 in 14..60_u32, x1 in 0.0..0.6_f64, x2 in 0.0..0.6_f64, helix in 0.0..20.0_f64, rpm in 50.0..6000.0_f64,
    ) {
        let profile = Profile { helix_angle: Angle::new::<degree>(helix), fillet: 0.3, ..Profile::default() };
        let gear = |teeth, shift| InvoluteGear::new(GearKind::External, ToothCount::new(teeth).unwrap(), profile, shift).unwrap();
        let soft = Material {
            hardness: Some(250.0),
            strength: Some(Pressure::new::<megapascal>(800.0)),
            ..Material::steel(Class::ThroughHardened, Pressure::new::<megapascal>(700.0), Pressure::new::<megapascal>(290.0))
        };
        let steel = material::listed("18CrNiMo7-6").unwrap().material;
        let bodies = [Gear::solid(steel, um(4.0), um(16.0)), Gear::solid(soft, um(6.0), um(20.0))];
        let teeth = [(z1, x1), (z2, x2)];
        let rated = |order: [usize; 2]| {
            let [first, second] = order.map(|of| gear(teeth[of].0, teeth[of].1));
            let mesh = Mesh {
                pair: Pair::without_backlash(first, second).unwrap(),
                gears: order.map(|of| bodies[of]),
                ..mesh(20, 50, false, 0.0)
            };
            let dynamics = Dynamics {
                arrangement: Arrangement::Pair,
                pitch_deviations: order.map(|of| um([8.0, 9.0][of])),
                profile_deviations: order.map(|of| um([10.0, 11.0][of])),
                tip_relief: None,
                rims: [None; 2],
                blank_factor: 1.0,
            };
            let given = Given::default().with(Symbol::Application, 1.25).with(Symbol::LoadSharing, 1.0).with(Symbol::FaceContact, 1.2)
                .with(Symbol::StaticNotchSensitivity, 1.0);
            let method = Method { given, dynamics: Some(dynamics), ..Method::default() };
            let ratio = f64::from(teeth[order[0]].0) / f64::from(z1);
            let load = Load { contacts: order.map(|of| [3.0, 1.0][of]), ..load(900.0 * ratio, rpm / ratio, 1e4) };
            (rate(&mesh, &load, &method).unwrap(), mesh_stiffness(&mesh.pair, mesh.face_width).unwrap())
        };
        let ((one, of_one), (other, of_other)) = (rated([0, 1]), rated([1, 0]));
        let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-9;
        prop_assert!(close(of_one.value, of_other.value), "{of_one:?} {of_other:?}");
        let [a, b, c, d] = safeties(&one);
        for (straight, turned) in [a, b, c, d].into_iter().zip([1, 0, 3, 2].map(|place| safeties(&other)[place])) {
            prop_assert!(close(straight, turned), "{straight} {turned}");
        }
        for side in Side::BOTH {
            let turned = if side == Side::First { Side::Second } else { Side::First };
            for (factor, same) in one.chain(side).zip(other.chain(turned)) {
                prop_assert!(close(factor.value, same.value), "{} {} {}", factor.symbol, factor.value, same.value);
            }
        }
    }

    /// Completeness of the chain of factors: their products are the stresses and limits.
    #[test]
    fn the_chain_gives_stress_and_limit(z1 in 17..40_u32, ring in any::<bool>(), helix in 0.0..20.0_f64, hours in 0.01..1e5_f64) {
        let mesh = mesh(z1, 50, ring, helix);
        let rating = rate(&mesh, &load(500.0, 1000.0, hours), &method()).unwrap();
        for side in Side::BOTH {
            let gear = &rating.gears[side as usize];
            let product = |prefix: char| -> f64 {
                root(gear).limit_factors.iter().chain(&contact(gear).limit_factors)
                    .filter(|factor| factor.symbol.to_string().starts_with(prefix)).map(|factor| factor.value).product()
            };
            let (flank, root) = (contact(gear).limit.get::<megapascal>(), root(gear).limit.get::<megapascal>());
            prop_assert!((flank / (1500.0 * product('Z')) - 1.0).abs() < 1e-9);
            prop_assert!((root / (430.0 * product('Y')) - 1.0).abs() < 1e-9);
            prop_assert_eq!(rating.chain(side).count(), 29);
        }
    }

    /// One step for the whole time is the constant load.
    #[test]
    fn a_duty_of_one_step_has_the_safeties_of_the_load(
        z1 in 17..40_u32, ring in any::<bool>(), hours in 0.1..1e5_f64, n_m in 50.0..2000.0_f64,
    ) {
        let mesh = mesh(z1, 50, ring, 0.0);
        let rating = rate(&mesh, &load(n_m, 1000.0, hours), &method()).unwrap();
        let step = Step { share: 1.0, torque: torque(n_m), speed: speed(1000.0) };
        let duty = rate_duty(&mesh, &[step], life(hours), [1.0, 1.0], &method()).unwrap().gears;
        for (gear, worn) in rating.gears.iter().zip(&duty) {
            // Beyond 10¹⁰ cycles the limit is level, and a stress below it does nothing.
            prop_assume!(gear.cycles < 1e10);
            for (safety, worn) in [(contact(gear).safety, &worn.contact), (root(gear).safety, &worn.root)] {
                let worn = worn.as_ref().unwrap();
                prop_assert!((worn.safety / safety - 1.0).abs() < 1e-9, "{} {}", worn.safety, safety);
                prop_assert_eq!(worn.damage > 1.0, safety < 1.0);
            }
        }
    }

    #[test]
    fn more_load_wears_more(n_m in 300.0..1500.0_f64, share in 0.05..0.95_f64) {
        let mesh = mesh(20, 50, false, 0.0);
        let duty = |high: f64| {
            let steps = [
                Step { share, torque: torque(high), speed: speed(1000.0) },
                Step { share: 1.0 - share, torque: torque(200.0), speed: speed(1500.0) },
            ];
            rate_duty(&mesh, &steps, life(10e3), [1.0, 1.0], &method()).unwrap().whole().unwrap()
        };
        for (light, heavy) in duty(n_m).into_iter().zip(duty(n_m * 1.3)) {
            prop_assert!(heavy.contact.damage >= light.contact.damage && heavy.root.damage >= light.root.damage);
            prop_assert!(heavy.contact.safety < light.contact.safety && heavy.root.safety < light.root.safety);
        }
    }

    /// Two equal meshes on one flank wear it as one with twice the contacts; one alone has its own safety.
    #[test]
    fn equal_meshes_on_one_flank_are_one_with_twice_the_contacts(
        n_m in 300.0..1500.0_f64, share in 0.05..0.95_f64, ring in any::<bool>(),
    ) {
        let mesh = mesh(20, 50, ring, 0.0);
        let steps = [
            Step { share, torque: torque(n_m), speed: speed(1000.0) },
            Step { share: 1.0 - share, torque: torque(200.0), speed: speed(1500.0) },
        ];
        let of = |contacts| rate_duty(&mesh, &steps, life(1e4), contacts, &method()).unwrap().whole().unwrap();
        let (one, twice) = (of([1.0, 1.0]), of([2.0, 2.0]));
        let own = stresses(&mesh, &steps, life(1e4), [1.0, 1.0], &method()).unwrap();
        let joined = |own: &Stresses, count: usize| {
            let mut all = Stresses::default();
            (0..count).for_each(|_| all.join(own.clone()));
            all.worn(life(1e4))
        };
        let alike = |one: Worn, other: Worn| {
            (one.safety / other.safety - 1.0).abs() < 1e-9
                && (one.damage - other.damage).abs() <= 1e-9 * other.damage
        };
        for (own, (one, twice)) in own.iter().zip(one.into_iter().zip(twice)) {
            let [contact, root] = [&own.contact, &own.root].map(|own| own.as_ref().unwrap());
            prop_assert!(alike(joined(contact, 1), one.contact) && alike(joined(root, 1), one.root));
            prop_assert!(alike(joined(contact, 2), twice.contact) && alike(joined(root, 2), twice.root));
            prop_assert!(twice.contact.safety <= one.contact.safety && twice.root.safety <= one.root.safety);
        }
    }

    /// Faster, with the same deviations: K_v stays at least 1 below resonance.
    #[test]
    fn the_dynamic_factor_grows_with_the_speed_below_resonance(rpm in 10.0..2000.0_f64, ring in any::<bool>()) {
        let mesh = mesh(20, 50, ring, 0.0);
        let outside = ring.then(|| Length::new::<millimeter>(340.0));
        let dynamics = Dynamics {
            arrangement: Arrangement::Pair,
            pitch_deviations: [um(8.0), um(9.0)],
            profile_deviations: [um(10.0), um(11.0)],
            tip_relief: None,
            rims: [None, outside],
            blank_factor: 1.0,
        };
        let given = Given::default().with(Symbol::Application, 1.0).with(Symbol::LoadSharing, 1.0).with(Symbol::FaceContact, 1.2);
        let method = Method { given, dynamics: Some(dynamics), ..Method::default() };
        let of = |rpm| rate(&mesh, &load(1000.0, rpm, 1e4), &method).unwrap().load_factors.dynamic.value;
        prop_assert!(of(rpm) > 1.0 && of(rpm * 1.05) > of(rpm));
    }
}

/// Over the speed the standard's ranges follow each other; where the range between resonance and the speeds
/// above begins and ends nothing jumps.
#[test]
fn the_ranges_of_the_dynamic_factor_join() {
    let mesh = mesh(20, 50, false, 0.0);
    let dynamics = Dynamics {
        arrangement: Arrangement::Pair,
        pitch_deviations: [um(8.0), um(9.0)],
        profile_deviations: [um(10.0), um(11.0)],
        tip_relief: Some(um(20.0)),
        rims: [None; 2],
        blank_factor: 1.0,
    };
    let given = Given::default()
        .with(Symbol::Application, 1.0)
        .with(Symbol::LoadSharing, 1.0)
        .with(Symbol::FaceContact, 1.2);
    let method = Method { given, dynamics: Some(dynamics), ..Method::default() };
    let of = |rpm| rate(&mesh, &load(1000.0, rpm, 1e4), &method).unwrap().load_factors.dynamic;
    let mut before = of(100.0);
    let mut places = vec![before.origin];
    for step in 1..=4000 {
        let here = of(100.0 + 10.0 * f64::from(step));
        if here.origin == before.origin || places.len() > 1 {
            assert!((here.value - before.value).abs() < 5e-3, "{} {}", before.value, here.value);
        }
        if here.origin != before.origin {
            places.push(here.origin);
        }
        before = here;
    }
    let places: Vec<String> = places.iter().map(ToString::to_string).collect();
    let part1 = |number| format!("ISO 6336-1:2006, formula ({number})");
    assert_eq!(places, [14, 20, 22, 21].map(part1));
    let light = rate(&mesh, &load(100.0, 1000.0, 1e4), &method);
    refused(
        light,
        "factor K_v is not given and cannot be calculated: below a line load of 100 N/mm method B is not offered; give it",
    );
}

#[test]
fn the_governing_safety_is_the_least_over_what_is_required() {
    let mesh = mesh(20, 50, false, 0.0);
    let rating = rate(&mesh, &load(500.0, 1000.0, 1e4), &method()).unwrap();
    let governing = rating.governing(1.0, 1.4).unwrap().unwrap();
    assert_eq!((governing.side, governing.place), (Side::First, Place::Flank));
    assert_eq!(governing.is_enough(), governing.safety >= 1.0);
    // A great demand on the roots makes the weaker of them govern.
    let governing = rating.governing(1.0, 50.0).unwrap().unwrap();
    let weaker = if root(&rating.gears[0]).safety <= root(&rating.gears[1]).safety {
        Side::First
    } else {
        Side::Second
    };
    assert_eq!((governing.side, governing.place, governing.is_enough()), (weaker, Place::Root, false));
    refused(rating.governing(0.0, 1.0), "required safety is 0; it must be finite and above 0");
}

/// ISO 6336-1, 9.3.2, by hand: 30 and 18 teeth without shift, dedendum 1.25. The pinion of the formula is the
/// gear with fewer teeth.
#[test]
fn the_stiffness_of_a_pair_is_that_of_its_smaller_gear_as_pinion() {
    let q = 0.04723 + 0.15551 / 18.0 + 0.25791 / 30.0;
    let by_hand = 0.8 / q * (1.0 + 0.5 * (1.2 - 1.25));
    assert!((by_hand - 12.10_f64).abs() < 5e-3);
    for [z1, z2] in [[18, 30], [30, 18]] {
        let gear = |teeth| {
            InvoluteGear::new(GearKind::External, ToothCount::new(teeth).unwrap(), Profile::default(), 0.0)
                .unwrap()
        };
        let pair = Pair::without_backlash(gear(z1), gear(z2)).unwrap();
        let whole = mesh_stiffness(&pair, Length::new::<millimeter>(1.0)).unwrap().value / 1e6;
        let single = whole / (0.75 * pair.transverse_contact_ratio() + 0.25);
        assert!((single - by_hand).abs() < 1e-9, "{single} {by_hand}");
    }
}

#[test]
fn editions_differ_by_the_helix_factor_alone() {
    let mesh = mesh(20, 50, false, 15.0);
    let of = |edition| rate(&mesh, &load(500.0, 1000.0, 1e4), &Method { edition, ..method() }).unwrap();
    let (first, corrected) = (of(Edition::Iso2006), of(Edition::Iso2006Corrected));
    let cos = libm::cos(15_f64.to_radians());
    assert!((first.contact_factors[3].value - cos.sqrt()).abs() < 1e-12);
    assert!((safeties(&first)[0] / safeties(&corrected)[0] * cos - 1.0).abs() < 1e-12);
    assert_eq!(safeties(&first)[2..], safeties(&corrected)[2..]);
    assert_eq!(corrected.edition.to_string(), "ISO 6336:2006 with corrigenda of 2007 and 2008");
}

#[test]
fn an_overload_is_held_against_the_static_limit() {
    let mesh = mesh(20, 50, false, 0.0);
    let [first, _] = overload(&mesh, torque(2000.0), &method()).unwrap().gears;
    // By hand from a short life: 10 h at 1 rpm are 600 cycles, within both static limits; without K_A and
    // K_v.
    let short = rate(&mesh, &load(2000.0, 1.0, 10.0), &method()).unwrap();
    let [flank, _, tooth, _] = safeties(&short);
    assert!((first.contact.unwrap() / flank / (1.25_f64 * 1.1).sqrt() - 1.0).abs() < 1e-9);
    assert!((first.root.unwrap() / tooth / (1.25 * 1.1) - 1.0).abs() < 1e-9);
}

#[track_caller]
fn refused(result: Result<impl std::fmt::Debug, Error>, message: &str) {
    assert_eq!(result.unwrap_err().to_string(), message);
}

#[test]
fn bad_input_is_refused_with_its_name_and_what_is_allowed() {
    let good = mesh(20, 50, false, 0.0);
    let of = |mesh: &Mesh| rate(mesh, &load(500.0, 1000.0, 1e4), &method());
    let millimetres = Length::new::<millimeter>;
    refused(
        of(&Mesh { face_width: millimetres(0.0), ..good }),
        "face width is 0 mm; it must be finite and above 0",
    );
    refused(
        of(&Mesh { module: millimetres(f64::NAN), ..good }),
        "module is NaN mm; it must be finite and above 0",
    );
    let with = |gear: Gear| of(&Mesh { gears: [gear, good.gears[1]], ..good });
    let own = good.gears[0];
    refused(
        with(Gear { rim: Some(millimetres(0.0)), ..own }),
        "rim thickness of the external gear is 0 mm; it must be finite and above 0",
    );
    let soft = Material { contact_limit: Pressure::new::<megapascal>(-1.0), ..own.material };
    refused(
        with(Gear { material: soft, ..own }),
        "contact stress limit σ_Hlim is -1 N/mm²; it must be finite and above 0",
    );
    refused(
        with(Gear { bending: Bending::Ratio { stress_ratio: -3.0, sensitivity: 0.4 }, ..own }),
        "stress ratio R is -3; it must lie between -1.2 and 0.5",
    );
    refused(
        rate(&good, &load(-5.0, 1000.0, 1e4), &method()),
        "torque of the mesh is -5 N·m; it must be finite and above 0",
    );
    refused(
        rate(&good, &load(5.0, 1000.0, 0.0), &method()),
        "required life is 0 h; it must be finite and above 0",
    );
    let given = |given| rate(&good, &load(500.0, 1000.0, 1e4), &Method { given, ..Method::default() });
    refused(
        given(method().given.with(Symbol::Dynamic, 0.0)),
        "factor K_v is given as 0; it must be finite and not below 1",
    );
    refused(
        given(Given::default()),
        "factor K_A is not given and cannot be calculated: it is a property of the machines that drive and are driven",
    );
    refused(
        given(Given::default().with(Symbol::Application, 1.0).with(Symbol::LoadSharing, 1.0)),
        "factor K_v is not given and cannot be calculated: give it, or the accuracy of the teeth for method B",
    );
}

/// Keeps the error of one flank or root that the standard does not cover, or that lacks a factor, and changes
/// no other rating.
#[test]
fn a_part_that_cannot_be_rated_leaves_the_others() {
    let good = mesh(20, 50, false, 0.0);
    let own = good.gears[0];
    let rim = Gear { rim: Some(Length::new::<millimeter>(3.0)), ..own };
    let rough = Gear { root_roughness: um(50.0), ..own };
    let through = Material { class: Class::ThroughHardened, strength: None, ..own.material };
    let unknown = Gear { material: Material { hardness: Some(250.0), ..through }, ..own };
    let soft = Gear {
        material: Material { hardness: None, strength: Some(own.material.root_limit), ..through },
        ..own
    };
    let roots = "root";
    for (gear, part, message) in [
        (rim, roots, "rim thickness over tooth height is 0.333333333333; it must be above 0.5"),
        (rough, roots, "roughness Rz of the root is 50 µm; it must lie between 0 and 40 µm"),
        (
            unknown,
            roots,
            "factor Y_δrelT is not given and cannot be calculated: the material's class asks for its yield or tensile strength",
        ),
        (
            soft,
            "flank",
            "factor Z_W is not given and cannot be calculated: the soft gear's Brinell hardness is needed",
        ),
    ] {
        let bad = Mesh { gears: [gear, good.gears[1]], ..good };
        let long = load(500.0, 1000.0, 1e5);
        // The same gear without what is wrong, for what its other part must be.
        let given = match part {
            "flank" => method().given.with_of(Side::First, Symbol::WorkHardening, 1.0),
            _ => method().given,
        };
        let sound =
            Mesh { gears: [Gear { rim: None, root_roughness: um(16.0), ..gear }, good.gears[1]], ..good };
        let whole = rate(&sound, &long, &Method { given, ..method() }).unwrap();
        let rating = rate(&bad, &long, &method()).unwrap();
        let step = Step { share: 1.0, torque: long.torque, speed: long.speed };
        let duty = rate_duty(&bad, &[step], long.life, [1.0; 2], &method()).unwrap();
        let peak = overload(&bad, long.torque, &method()).unwrap();
        let [first, second] = rating.gears.clone();
        if part == roots {
            refused(first.root, message);
            refused(duty.gears[0].clone().root, message);
            assert_eq!(first.contact, whole.gears[0].contact);
            assert!(peak.gears[0].contact.is_ok());
        } else {
            refused(first.contact, message);
            refused(duty.gears[0].clone().contact, message);
            assert_eq!(first.root, whole.gears[0].root);
        }
        assert!(second.contact.is_ok() && second.root.is_ok() && peak.gears[1].root.is_ok());
        assert!(duty.gears[1].contact.is_ok() && duty.gears[1].root.is_ok());
        // The governing safety is one of those that could be rated.
        let least = rating.governing(1.0, 1.0).unwrap().unwrap().safety;
        let all = rating.gears.iter().flat_map(|gear| {
            let flank = gear.contact.as_ref().ok().map(|rated| rated.safety);
            flank.into_iter().chain(gear.root.as_ref().ok().map(|rated| rated.safety))
        });
        assert_eq!(least, all.fold(f64::INFINITY, f64::min));
    }
    let ring = mesh(20, 50, true, 0.0);
    let rating = rate(&Mesh { gears: [own; 2], ..ring }, &load(500.0, 1000.0, 1e4), &method()).unwrap();
    refused(
        rating.gears[1].root.clone(),
        "no root section of 70 teeth: an internal gear needs the shaper that cuts it",
    );
    assert!(rating.gears[1].contact.is_ok() && rating.gears[0].root.is_ok());
}

#[test]
fn bad_duties_are_refused() {
    let mesh = mesh(20, 50, false, 0.0);
    let of = |steps: &[Step]| rate_duty(&mesh, steps, life(1e4), [1.0, 1.0], &method());
    let step = |share, n_m| Step { share, torque: torque(n_m), speed: speed(1000.0) };
    refused(
        of(&[step(0.5, 100.0), step(0.25, 50.0)]),
        "the shares of the duty sum to 0.75; they must sum to 1",
    );
    refused(
        of(&[step(1.5, 100.0), step(-0.5, 50.0)]),
        "share of time is -0.5; it must be finite and not below 0",
    );
    refused(of(&[step(1.0, 0.0)]), "the duty has no step with a torque and a speed; at least one is needed");
    refused(of(&[]), "the shares of the duty sum to 0; they must sum to 1");
    // Half of the time at rest halves the cycles.
    let rest = Step { share: 0.5, torque: torque(900.0), speed: speed(0.0) };
    let whole = of(&[step(1.0, 900.0)]).unwrap().whole().unwrap();
    let half = of(&[step(0.5, 900.0), rest]).unwrap().whole().unwrap();
    assert!((half[0].contact.damage / whole[0].contact.damage - 0.5).abs() < 1e-12);
}

/// A mesh of grey iron has every factor of its class, and its static root limit is an input.
#[test]
fn an_unknown_static_factor_is_an_input() {
    let mut mesh = mesh(20, 50, false, 0.0);
    for gear in &mut mesh.gears {
        let limit = Pressure::new::<megapascal>;
        gear.material = Material {
            strength: Some(limit(200.0)),
            ..Material::steel(Class::GreyIron, limit(400.0), limit(80.0))
        };
    }
    let short = |method: Method| rate(&mesh, &load(50.0, 10.0, 100.0), &method).unwrap();
    refused(
        short(method()).gears[0].root.clone(),
        "factor Y_δrelT,stat is not given and cannot be calculated: its formula is known of case- and surface-hardened steel alone; give it",
    );
    let given = method().given.with(Symbol::StaticNotchSensitivity, 1.0);
    let long = rate(&mesh, &load(50.0, 1000.0, 1e4), &method()).unwrap();
    assert!(safeties(&short(Method { given, ..method() }))[2] > safeties(&long)[2]);
}

/// The forces of both meshes on a planet as vectors: normal to helical flanks at the working cylinders, one
/// diameter apart.
#[test]
fn axial_forces_are_those_of_normal_forces_on_helical_flanks() {
    use epicyclic_strength::planets::axial_forces;
    use uom::si::{force::newton, torque::newton_meter};
    let [outer, inner] = [mesh(18, 36, false, 12.0), mesh(36, 90, true, 12.0)];
    let load = Torque::new::<newton_meter>(800.0);
    let tangential = [outer.tangential_force(load), inner.tangential_force(load * 36.0 / 18.0)];
    let told = axial_forces([&outer.pair, &inner.pair], outer.module, tangential);
    let module_m = outer.module.get::<millimeter>() / 1e3;
    let planet = outer.pair.gears()[1];
    // Torque on the planet by either mesh.
    let torque = 800.0 * 36.0 / 18.0;
    // x from the axis through the planet's centre, y along its orbit.
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    for (side, diameter) in
        [(-1.0, outer.pair.working_diameters()[1]), (1.0, inner.pair.working_diameters()[0])]
    {
        let radius = module_m * diameter / 2.0;
        let lead_tan = libm::tan(12_f64.to_radians()) * diameter / planet.reference_diameter();
        // A tooth runs along (0, side·tan β_w, 1); the force has no part along it.
        let y = torque / radius;
        let z = -side * lead_tan * y;
        force = [force[0], force[1] + y, force[2] + z];
        let x = side * radius;
        moment = [moment[0], moment[1] - x * z, moment[2] + x * y];
    }
    assert!(force[2].abs() < 1e-9 && moment[2].abs() < 1e-9, "{force:?} {moment:?}");
    let by_vectors = moment[1].abs();
    assert!((told.tilting_moment.get::<newton_meter>() / by_vectors - 1.0).abs() < 1e-12);
    let axial = told.forces[0].get::<newton>();
    let one = torque * 2.0 / (module_m * planet.reference_diameter()) * libm::tan(12_f64.to_radians());
    assert!((axial / one - 1.0).abs() < 1e-12, "{axial} {one}");
}
