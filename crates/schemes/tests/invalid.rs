//! Bad descriptions, one fault each, and the answer each gets.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod common;

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::row::Member;
use epicyclic_gears::teeth::ToothCount;
use epicyclic_schemes::row::{MeshLoss, RowKind, RowSpec};
use epicyclic_schemes::{
    CompiledGear, Direction, Error, GearSpec, Gearbox, GearboxBuilder, InputLoad, Named, Solution, Warning,
};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, Power, Torque};
use uom::si::power::watt;
use uom::si::torque::newton_meter;

fn sound() -> GearboxBuilder {
    Gearbox::builder("box")
        .links(["drive", "ring", "driven"])
        .row(RowSpec::simple("1", ["drive", "ring", "driven"], 3.0))
        .brake("K1", "ring")
        .input("drive")
        .output("driven")
        .gear("1", ["K1"])
}

fn fault(builder: GearboxBuilder) -> Error {
    builder.build().unwrap_err()
}

#[test]
fn the_sound_description_is_accepted() {
    assert!(sound().build().is_ok());
}

#[test]
fn an_unknown_link_is_named_with_its_nearest() {
    let found = fault(sound().brake("K2", "rign"));
    assert_eq!(
        found.to_string(),
        "control `K2` names the link `rign`, which does not exist; did you mean `ring`?"
    );
    assert!(matches!(found, Error::Unknown { what: Named::Link, .. }));
    let far = fault(sound().row(RowSpec::simple("2", ["drive", "wheelhouse", "driven"], 2.0)));
    assert_eq!(far.to_string(), "row `2` names the link `wheelhouse`, which does not exist");
}

#[test]
fn an_unknown_control_of_a_gear_is_named() {
    let found = fault(sound().gear("2", ["K2"]));
    assert_eq!(
        found.to_string(),
        "gear `2` names the control `K2`, which does not exist; did you mean `K1`?"
    );
    let gearbox = sound().build().unwrap();
    assert!(matches!(gearbox.analyze("3"), Err(Error::Unknown { what: Named::Gear, .. })));
    assert!(matches!(gearbox.gear_of(&["K9"], "drive", "driven"), Err(Error::Unknown { .. })));
}

#[test]
fn members_on_one_link_are_refused() {
    let on_one = fault(sound().row(RowSpec::simple("2", ["drive", "drive", "driven"], 2.0)));
    let expected = Error::CoincidentMembers {
        row: "2".into(),
        first: Member::Sun,
        second: Member::Ring,
        link: "drive".into(),
    };
    assert_eq!(on_one, expected);
    // The same by a permanent connection, and by two permanent grounds.
    assert!(matches!(fault(sound().tie("drive", "ring")), Error::CoincidentMembers { .. }));
    assert!(matches!(fault(sound().ground("drive").ground("ring")), Error::CoincidentMembers { .. }));
}

#[test]
fn a_row_parameter_of_one_is_refused_of_a_simple_row_only() {
    for k in [1.0, 0.5, 0.0, -2.0, f64::NAN, f64::INFINITY] {
        let row = RowSpec::simple("2", ["drive", "ring", "driven"], k);
        assert!(matches!(fault(sound().row(row)), Error::RowParameter { kind: RowKind::Simple, .. }), "{k}");
    }
    let teeth = RowSpec::teeth("2", RowKind::Simple, ["drive", "ring", "driven"], 60, 60).unwrap();
    assert!(matches!(fault(sound().row(teeth)), Error::RowParameter { .. }));
    for kind in [RowKind::Bevel, RowKind::MeshingSuns, RowKind::DoublePlanet, RowKind::SteppedSuns] {
        assert!(sound().row(RowSpec::new("2", kind, ["drive", "ring", "driven"], 0.8)).build().is_ok());
        let none = RowSpec::new("2", kind, ["drive", "ring", "driven"], 0.0);
        assert!(matches!(fault(sound().row(none)), Error::RowParameter { .. }));
    }
}

#[test]
fn a_stepped_row_needs_its_steps() {
    let row = RowSpec::teeth("2", RowKind::SteppedRings, ["drive", "ring", "driven"], 60, 63).unwrap();
    assert!(matches!(fault(sound().row(row.clone())), Error::StepsMissing { .. }));
    let teeth = |n| ToothCount::new(n).unwrap();
    let gearbox = sound().row(row.planet_teeth(teeth(20), Some(teeth(21)))).build().unwrap();
    assert!((gearbox.rows()[1].stationary_ratio().get() - 1.0).abs() < 1e-15);
}

#[test]
fn names_are_unique() {
    assert_eq!(fault(sound().links(["ring"])), Error::Duplicate { what: Named::Link, name: "ring".into() });
    assert!(matches!(fault(sound().links(["ground"])), Error::Duplicate { what: Named::Link, .. }));
    assert!(matches!(fault(sound().brake("K1", "driven")), Error::Duplicate { what: Named::Control, .. }));
    assert!(matches!(fault(sound().gear("1", ["K1"])), Error::Duplicate { what: Named::Gear, .. }));
    let row = RowSpec::simple("1", ["drive", "ring", "driven"], 2.0);
    assert!(matches!(fault(sound().row(row)), Error::Duplicate { what: Named::Row, .. }));
}

#[test]
fn a_control_joins_two_links() {
    let found = fault(sound().clutch("K2", "ring", "ring"));
    assert_eq!(found, Error::ControlJoinsItself { control: "K2".into(), link: "ring".into() });
    assert!(matches!(fault(sound().brake("K2", "ground")), Error::ControlJoinsItself { .. }));
}

#[test]
fn permanent_connections_close_no_loop() {
    let loops = sound().links(["x", "y"]).ground("x").tie("x", "y").ground("y");
    assert_eq!(fault(loops), Error::CyclicGrounds { first: "y".into(), second: "ground".into() });
    assert!(matches!(fault(sound().ground("ground")), Error::CyclicGrounds { .. }));
}

#[test]
fn power_does_not_enter_at_the_housing() {
    assert_eq!(fault(sound().input("ground")), Error::GroundedTerminal { place: "input".into() });
    let gear = GearSpec { name: "2".into(), engaged: vec![], input: None, output: Some("ground".into()) };
    assert_eq!(
        fault(sound().gear_spec(gear)),
        Error::GroundedTerminal { place: "output of gear `2`".into() }
    );
    let unfinished = Gearbox::builder("box").row(RowSpec::simple("1", ["a", "b", "c"], 2.0));
    assert_eq!(fault(unfinished), Error::NoTerminal { terminal: "input" });
    assert_eq!(fault(Gearbox::builder("nothing")), Error::NoRows);
}

#[test]
fn shifted_profiles_are_a_warning() {
    let row = RowSpec::teeth("2", RowKind::Simple, ["drive", "ring", "driven"], 22, 58).unwrap();
    let gearbox = sound().row(row.planet_teeth(ToothCount::new(17).unwrap(), None)).build().unwrap();
    let expected = Warning::Coaxiality { row: "2".into(), ring: 58, unshifted: 56 };
    assert_eq!(gearbox.warnings(), std::slice::from_ref(&expected));
    assert_eq!(
        expected.to_string(),
        "row `2`: z_b = 58, but z_a + 2·z_g = 56: coaxial only with shifted profiles"
    );
}

#[test]
fn a_terminal_that_nothing_reaches_is_a_warning() {
    let gearbox = sound().links(["pto"]).output("pto").build().unwrap();
    assert_eq!(gearbox.warnings(), [Warning::Unreachable { link: "pto".into() }]);
}

#[test]
fn rows_share_a_mesh_only_where_they_can() {
    let eta = |e| MeshEfficiency::new(e).unwrap();
    let mesh = |ring| MeshLoss::sun_and_ring(eta(0.98), eta(ring));
    let with = |first, second| common::machines::ravigneaux_builder([first, second]);
    assert!(with(mesh(0.99), mesh(0.99)).shared_ring_mesh(["RAVa", "RAVb"]).build().is_ok());
    let refused = [
        with(mesh(0.99), mesh(0.985)).shared_ring_mesh(["RAVa", "RAVb"]),
        with(mesh(0.99), MeshLoss::Row(eta(0.97))).shared_ring_mesh(["RAVa", "RAVb"]),
        with(mesh(0.99), mesh(0.99)).shared_ring_mesh(["RAVa", "RAVa"]),
        with(mesh(0.99), mesh(0.99)).shared_ring_mesh(["RAVa", "RAVb"]).shared_ring_mesh(["RAVb"]),
    ];
    for builder in refused {
        assert!(matches!(fault(builder), Error::SharedMesh { .. }));
    }
    let apart = sound()
        .links(["x"])
        .row(RowSpec::simple("2", ["drive", "x", "driven"], 2.0).with_loss(mesh(0.99)))
        .row(RowSpec::simple("3", ["x", "ring", "driven"], 2.0).with_loss(mesh(0.99)))
        .shared_ring_mesh(["2", "3"]);
    assert!(matches!(fault(apart), Error::SharedMesh { .. }));
    let unknown = with(mesh(0.99), mesh(0.99)).shared_ring_mesh(["RAVa", "RAVc"]);
    assert!(matches!(fault(unknown), Error::Unknown { what: Named::Row, .. }));
}

#[test]
fn what_outgrows_the_solver_is_named() {
    let links: Vec<String> = (0..15).map(|l| format!("w{l}")).collect();
    let mut train = Gearbox::builder("train").links(&links).input("w0").output("w14");
    for (place, pair) in links.windows(2).enumerate() {
        train = train.row(RowSpec::pair(&place.to_string(), [&pair[0], &pair[1]], 20, 21).unwrap());
    }
    let train = train.gear("1", [""; 0]).build().unwrap();
    assert_eq!(train.analyze("1"), Err(Error::TooMany { what: Named::Row, count: 14, limit: 12 }));
    let many = (0..17).fold(sound(), |builder, c| builder.brake(&format!("B{c}"), "ring")).build().unwrap();
    assert!(matches!(many.combinations(0..=1), Err(Error::TooMany { what: Named::Control, .. })));
}

#[test]
fn a_compiled_gear_takes_one_entry_a_row() {
    let gearbox = sound().gear("0", [""; 0]).build().unwrap();
    let compiled = CompiledGear::new(&gearbox, gearbox.gear("1").unwrap()).unwrap();
    let found = compiled.solve(&[], &[], Direction::Drive, &mut Solution::default());
    assert_eq!(found, Err(Error::RowCount { given: 0, expected: 1 }));
    let open = CompiledGear::new(&gearbox, gearbox.gear("0").unwrap()).unwrap_err();
    assert_eq!(open.to_string(), "the gear is not driven: underdetermined (ring, driven)");
}

#[test]
fn an_operating_point_is_finite_and_moves() {
    let found = sound().build().unwrap().analyze("1").unwrap();
    let rad = AngularVelocity::new::<radian_per_second>;
    let nm = |t| InputLoad::Torque(Torque::new::<newton_meter>(t));
    let w = |p| InputLoad::Power(Power::new::<watt>(p));
    assert!(matches!(found.at(rad(0.0), w(10.0)), Err(Error::OperatingPoint { .. })));
    assert!(matches!(found.at(rad(f64::NAN), nm(1.0)), Err(Error::OperatingPoint { .. })));
    assert!(matches!(found.at(rad(1.0), nm(f64::INFINITY)), Err(Error::OperatingPoint { .. })));
    let work = found.at(rad(100.0), w(5000.0)).unwrap();
    assert!((work.input.get::<newton_meter>() - 50.0).abs() < 1e-12);
    assert!((work.output.get::<newton_meter>() - -200.0).abs() < 1e-12);
    let free = sound().gear("0", [""; 0]).build().unwrap().analyze("0").unwrap();
    assert!(matches!(free.at(rad(1.0), nm(1.0)), Err(Error::NotDriven { .. })));
}
