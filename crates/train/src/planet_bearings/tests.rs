//! Planet bearings against hand calculations and balances.

use super::*;
use crate::set::{MeshLoss, SetSpec};
use epicyclic_gears::Quantity;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Force, Length, Mass, Torque};

fn mm(value: f64) -> Length {
    Length::from_mm(value)
}

fn gearbox(set: SetSpec) -> Gearbox {
    Gearbox::builder("one set")
        .links(["a", "b", "H"])
        .set(set)
        .brake("K", "b")
        .input("a")
        .output("H")
        .gear("1", ["K"])
        .build()
        .unwrap()
}

fn only(gearbox: &Gearbox, size: &SetSize) -> PlanetBearing {
    let mut bearings = gearbox.planet_bearings(0, size).unwrap().unwrap();
    assert_eq!(bearings.len(), 1);
    bearings.remove(0)
}

fn teeth(count: u32) -> ToothCount {
    ToothCount::new(count).unwrap()
}

/// Sun 20, planet 20, ring 60, module 3 mm: r_w = 60 mm, r_a = 30 mm, r_b = 90 mm; 100 N·m on the sun.
#[test]
fn a_simple_set_by_hand() {
    let set = SetSpec::teeth("P", SetKind::Simple, ["a", "b", "H"], 20, 60).unwrap().planet_count(3);
    let gearbox = gearbox(set);
    let size = SetSize { module: Some(mm(3.0)), planet_mass: Some(Mass::from_si(0.5)), ..SetSize::default() };
    let bearing = only(&gearbox, &size);
    assert_eq!(bearing.lacks, []);
    assert!((bearing.radius.unwrap().si() - 0.06).abs() < 1e-15);
    let forces = bearing
        .forces(Some(&[100.0, 300.0, -400.0].map(Torque::from_si)), Some(AngularVelocity::from_si(100.0)))
        .unwrap();
    let newtons = |force: Option<Force>| force.unwrap().si();
    // 400/(3·0.06) = 2·100/(3·0.03); 0.5·0.06·100².
    assert!((newtons(forces.tangential) - 20_000.0 / 9.0).abs() < 1e-9);
    assert!(newtons(forces.radial).abs() < 1e-9);
    assert!((newtons(forces.centrifugal) - 300.0).abs() < 1e-9);
    assert!((newtons(forces.total) - libm::hypot(20_000.0_f64 / 9.0, 300.0)).abs() < 1e-9);
}

#[test]
fn without_a_size_the_lacks_are_named() {
    let gearbox = gearbox(SetSpec::simple("P", ["a", "b", "H"], 3.0));
    let bearing = only(&gearbox, &SetSize::default());
    assert_eq!(bearing.lacks, [Lack::Planets, Lack::Radius, Lack::Mass]);
    assert_eq!(bearing.forces(Some(&[Torque::from_si(1.0); 3]), None).unwrap(), BearingForces::default());
    let refused =
        gearbox.planet_bearings(0, &SetSize { module: Some(mm(-1.0)), ..SetSize::default() }).unwrap();
    assert_eq!(refused.unwrap_err().to_string(), "module is -1 mm; it must be finite and above 0");
    let double = SetSpec::teeth("P", SetKind::DoublePlanet, ["a", "b", "H"], 20, 60).unwrap();
    let gearbox = self::gearbox(double);
    let size = SetSize { carrier_radius: Some(mm(50.0)), ..SetSize::default() };
    let bearings = gearbox.planet_bearings(0, &size).unwrap().unwrap();
    let radius_of_other = Lack::OtherRadius { other: 0 };
    let first = [Lack::Planets, Lack::CommonRadius, Lack::Radius, Lack::Mass];
    assert_eq!(bearings[0].lacks, first);
    // The planets' teeth are missing, so no size helps but the radii; then the distance is missing.
    let own = |radius| PlanetSize { carrier_radius: Some(mm(radius)), ..PlanetSize::default() };
    let size = SetSize { planets: vec![PlanetSize::default(), own(60.0)], ..SetSize::default() };
    let bearings = gearbox.planet_bearings(0, &size).unwrap().unwrap();
    assert_eq!(bearings[0].lacks, [Lack::Planets, Lack::Radius, Lack::Mass]);
    assert_eq!(bearings[1].lacks, [Lack::Planets, radius_of_other, Lack::Mass]);
    let size = SetSize { planets: vec![own(50.0), own(60.0)], ..SetSize::default() };
    let bearings = gearbox.planet_bearings(0, &size).unwrap().unwrap();
    let distance = Lack::Distance { other: 1 };
    assert_eq!(bearings[0].lacks, [Lack::Planets, distance, Lack::Mass]);
    let bevel = SetSpec::teeth("P", SetKind::Bevel, ["a", "b", "H"], 20, 60).unwrap();
    assert_eq!(only(&self::gearbox(bevel), &SetSize::default()).lacks, [Lack::Bevel]);
}

#[test]
fn teeth_and_ratio_give_the_same_planet() {
    let by_k = gearbox(SetSpec::simple("P", ["a", "b", "H"], 3.0).planet_count(3));
    let by_teeth =
        gearbox(SetSpec::teeth("P", SetKind::Simple, ["a", "b", "H"], 20, 60).unwrap().planet_count(3));
    let width = Some(mm(30.0));
    let size = SetSize { carrier_radius: Some(mm(60.0)), face_width: width, ..SetSize::default() };
    let one = only(&by_k, &size);
    let size = SetSize { module: Some(mm(3.0)), face_width: width, ..SetSize::default() };
    let other = only(&by_teeth, &size);
    assert_eq!(one.contacts, other.contacts);
    // A disc of the pitch diameter against a body to the root and half a tooth zone: within an eighth.
    let ratio = (one.mass.unwrap() / other.mass.unwrap()).value;
    assert!((ratio - 1.0).abs() < 0.125, "{ratio}");
}

/// The tangential force is that of the meshes too: F_1·r_1 and F_2·r_2 make up T_H, for each kind.
#[test]
fn stepped_planets_turn_about_the_axis_as_the_meshes_push_them() {
    for (kind, [z1, z2], [g, f]) in [
        (SetKind::SteppedSunRing, [20, 80], [40, 20]),
        (SetKind::SteppedSuns, [20, 30], [40, 30]),
        (SetKind::SteppedRings, [100, 90], [40, 30]),
    ] {
        let set = SetSpec::teeth("P", kind, ["a", "b", "H"], z1, z2).unwrap();
        let set = set.planet_teeth(teeth(g), Some(teeth(f))).planet_count(4);
        let gearbox = gearbox(set);
        let ideal = gearbox.analyze("1").unwrap().ideal().unwrap().members[0].clone().unwrap();
        let size = SetSize { module: Some(mm(2.0)), ..SetSize::default() };
        let bearing = only(&gearbox, &size);
        assert_eq!(bearing.lacks, [Lack::Mass], "{kind}");
        let [r1, r2] = [0, 1].map(|mesh: usize| bearing.contacts[mesh].pitch_radius.unwrap());
        let radius = bearing.radius.unwrap().si();
        // No moment about the planet's own axis: the forces stand as the inverse steps.
        let (f1, f2) = (ideal[0] / (4.0 * r1.si()), ideal[1] / (4.0 * r2.si()));
        let torques: Vec<Torque> = ideal.iter().copied().map(Torque::from_si).collect();
        let force = bearing.forces(Some(&torques), None).unwrap().tangential.unwrap();
        assert!((force.si() - (f1 + f2).abs()).abs() < 1e-9 * f1.abs(), "{kind}");
        assert!((f1 + f2 + ideal[2] / (4.0 * radius)).abs() < 1e-9 * f1.abs(), "{kind}");
    }
}

#[test]
fn losses_leave_a_little_of_the_radial_forces() {
    let eta = MeshEfficiency::new(0.97).unwrap();
    let set = SetSpec::simple("P", ["a", "b", "H"], 3.0).with_loss(MeshLoss::Set(eta)).planet_count(3);
    let gearbox = gearbox(set);
    let members = gearbox.analyze("1").unwrap().driving().unwrap().members[0].clone().unwrap();
    let size = SetSize { carrier_radius: Some(mm(60.0)), ..SetSize::default() };
    let bearing = only(&gearbox, &size);
    let torques: Vec<Torque> = members.into_iter().map(Torque::from_si).collect();
    let forces = bearing.forces(Some(&torques), None).unwrap();
    let share = forces.radial.unwrap() / forces.tangential.unwrap();
    // F_a − F_b = 0.03·F_a of F_a + F_b.
    assert!((share.value - libm::tan(20_f64.to_radians()) * 0.03 / 1.97).abs() < 1e-3, "{}", share.value);
}

/// Sun 20, planets 20 and 20, ring 60, module 2 mm: all centres 40 mm apart and 40 mm from the axis, ψ = 60°.
fn double() -> (SetSpec, SetSize) {
    let set = SetSpec::teeth("P", SetKind::DoublePlanet, ["a", "b", "H"], 20, 60).unwrap();
    let size = SetSize { module: Some(mm(2.0)), ..SetSize::default() };
    (set.planet_teeth(teeth(20), Some(teeth(20))).planet_count(3), size)
}

#[test]
fn a_double_planet_by_hand() {
    let (set, size) = double();
    let gearbox = gearbox(set);
    let bearings = gearbox.planet_bearings(0, &size).unwrap().unwrap();
    assert_eq!([&*bearings[0].name, &*bearings[1].name], ["planet 1", "planet 2"]);
    // i₀ = 3: 100 N·m on the sun, −300 on the ring, 200 on the carrier.
    let torques = [100.0, -300.0, 200.0].map(Torque::from_si);
    // Every mesh carries F = 100/(3·0.02) N.
    let f = 100.0 / 0.06;
    let (sin, cos) = libm::sincos(60_f64.to_radians());
    let s = f * libm::tan(20_f64.to_radians());
    // Planet 1 in (outwards, along): the sun (s, f); planet 2 in the direction u = (−cos, sin) with f across,
    // (−sin, −cos), and s against u. The carrier's torque is positive, so its direction is −1.
    let expected = [
        [s - f * sin + s * cos, -(f - f * cos - s * sin)],
        [-s + f * sin + s * cos, -(-f - f * cos + s * sin)],
    ];
    for (bearing, [radial, tangential]) in bearings.iter().zip(expected) {
        assert_eq!(bearing.lacks, [Lack::Mass]);
        let forces = bearing.forces(Some(&torques), None).unwrap();
        assert!((forces.radial.unwrap().si() - radial).abs() < 1e-9);
        assert!((forces.tangential.unwrap().si() - tangential).abs() < 1e-9);
    }
    // The other way round the along parts of the separating forces change sides.
    let meshes = vec![MeshSize::default(), MeshSize { is_behind: true, ..MeshSize::default() }];
    let bearings = gearbox.planet_bearings(0, &SetSize { meshes, ..size }).unwrap().unwrap();
    let forces = bearings[0].forces(Some(&torques), None).unwrap();
    assert!((forces.radial.unwrap().si() - (s + f * sin + s * cos)).abs() < 1e-9);
    assert!((forces.tangential.unwrap().si() + (f - f * cos + s * sin)).abs() < 1e-9);
}

#[test]
fn planets_that_cannot_stand_so_far_apart_are_named() {
    let (set, size) = double();
    let gearbox = gearbox(set);
    let own = PlanetSize { carrier_radius: Some(mm(81.0)), ..PlanetSize::default() };
    let bearings = gearbox.planet_bearings(0, &SetSize { planets: vec![own], ..size }).unwrap().unwrap();
    let Lack::Triangle { other: 1, radii, distance } = bearings[0].lacks[0] else {
        unreachable!("{:?}", bearings[0].lacks)
    };
    let in_mm = [radii[0], radii[1], distance].map(|length| (1e3 * length.si()).round());
    assert_eq!(in_mm, [81.0, 40.0, 40.0]);
    let torques = [100.0, -300.0, 200.0].map(Torque::from_si);
    let forces = bearings[1].forces(Some(&torques), Some(AngularVelocity::from_si(0.0))).unwrap();
    assert_eq!((forces.tangential, forces.radial, forces.total), (None, None, None));
    assert_eq!(forces.centrifugal, Some(Force::default()));
    let refused = bearings[1].forces(Some(&torques[..2]), None).unwrap_err();
    assert!(matches!(refused, Error::OutOfRange { quantity: Quantity::MemberTorques, .. }));
}

#[test]
fn masses_follow_from_the_shape_of_every_planet_with_one_width() {
    let (set, size) = double();
    let size = SetSize { face_width: Some(mm(20.0)), planet_bore: Some(mm(10.0)), ..size };
    let body = |module_mm: f64| {
        let gear = ToothedGear::external(mm(module_mm), teeth(20)).unwrap();
        GearBody::external(&gear, mm(20.0), mm(10.0), size.density).unwrap().total().mass
    };
    let bearings = gearbox(set).planet_bearings(0, &size).unwrap().unwrap();
    assert!(bearings.iter().all(|bearing| bearing.mass == Some(body(2.0)) && bearing.lacks.is_empty()));
    // Of a stepped planet each step has its width and module: here 2 mm and 2·60/40 mm.
    let set = SetSpec::teeth("P", SetKind::SteppedSuns, ["a", "b", "H"], 40, 20).unwrap();
    let set = set.planet_teeth(teeth(20), Some(teeth(20))).planet_count(3);
    let gearbox = gearbox(set);
    assert_eq!(only(&gearbox, &size).lacks, [Lack::Mass]);
    let own = PlanetSize { face_widths: vec![Some(mm(20.0)); 2], ..PlanetSize::default() };
    let meshes = vec![MeshSize { module: Some(mm(2.0)), ..MeshSize::default() }];
    let stepped = SetSize { module: None, planets: vec![own], meshes, ..size.clone() };
    let mass = only(&gearbox, &stepped).mass.unwrap();
    assert!(((mass / (body(2.0) + body(3.0))).value - 1.0).abs() < 1e-12);
}

/// Power through each mesh from torques alone, against that of the power flow: a Ravigneaux set in its second
/// gear.
#[test]
fn torques_say_what_the_power_flow_says_of_each_mesh() {
    let eta = MeshEfficiency::new(0.98).unwrap();
    let set = crate::compound::CompoundSpec::new("R", "H")
        .sun("a", 30)
        .sun("c", 36)
        .ring("b", 72)
        .planet("short", &[15])
        .planet("long", &[18])
        .mesh("a", "short", eta)
        .mesh("short", "long", eta)
        .mesh("c", "long", eta)
        .mesh("long", "b", eta);
    let gearbox = Gearbox::builder("second")
        .links(["a", "b", "c", "H"])
        .compound_set(set)
        .brake("K", "c")
        .input("a")
        .output("b")
        .gear("2", ["K"])
        .build()
        .unwrap();
    let found = gearbox.analyze("2").unwrap();
    let set = &gearbox.sets()[0];
    let first = found.sets()[0].relative.unwrap();
    for case in [found.ideal().unwrap(), found.driving().unwrap()] {
        let power = case.power.sets[0].as_ref().unwrap();
        for (mesh, flow) in case.meshes(&gearbox, 0).unwrap().iter().enumerate() {
            let torques = case.members[0].as_ref().unwrap();
            let through = set.flows().through(mesh, torques);
            let middle = f64::from(flow.sense) * (flow.enters + flow.leaves) / 2.0;
            assert!((through * first - middle).abs() <= 1e-12, "{mesh}: {}", power.loss);
        }
    }
}
