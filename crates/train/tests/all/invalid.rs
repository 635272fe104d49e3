//! Bad descriptions, one fault each, and the answer each gets.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::teeth::ToothCount;
use epicyclic_train::compound::{CentralKind, CompoundSpec, SetMember};
use epicyclic_train::set::{MeshLoss, SetKind, SetSpec, Shifts};
use epicyclic_train::tolerance::MOST_SETS;
use epicyclic_train::{
    CompiledGear, Direction, Error, GearPart, GearSpec, Gearbox, GearboxBuilder, InputLoad, Named, Place,
    SetPart, Site, Solution, Terminal, Values, Warning,
};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, Power, Torque};
use uom::si::power::watt;
use uom::si::torque::newton_meter;

fn sound() -> GearboxBuilder {
    Gearbox::builder("box")
        .links(["drive", "ring", "driven"])
        .set(SetSpec::simple("1", ["drive", "ring", "driven"], 3.0))
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
        "shift element `K2` names the link `rign`, which does not exist; did you mean `ring`?"
    );
    assert!(matches!(found, Error::Unknown { what: Named::Link, .. }));
    let far = fault(sound().set(SetSpec::simple("2", ["drive", "wheelhouse", "driven"], 2.0)));
    assert_eq!(far.to_string(), "set `2` names the link `wheelhouse`, which does not exist");
}

#[test]
fn an_unknown_shift_element_of_a_gear_is_named() {
    let found = fault(sound().gear("2", ["K2"]));
    assert_eq!(
        found.to_string(),
        "gear `2` names the shift element `K2`, which does not exist; did you mean `K1`?"
    );
    let gearbox = sound().build().unwrap();
    assert!(matches!(gearbox.analyze("3"), Err(Error::Unknown { what: Named::Gear, .. })));
    assert!(matches!(gearbox.gear_of(&["K9"], "drive", "driven"), Err(Error::Unknown { .. })));
}

#[test]
fn a_shift_element_stands_in_a_gear_once() {
    let expected = |place| Error::EngagedTwice { place, name: "K1".into() };
    assert_eq!(fault(sound().gear("2", ["K1", "K1"])), expected(Place::Gear("2".into())));
    let found = sound().build().unwrap().gear_of(&["K1", "K1"], "drive", "driven");
    assert_eq!(found.unwrap_err(), expected(Place::UnnamedGear));
}

#[test]
fn members_on_one_link_are_refused() {
    let on_one = fault(sound().set(SetSpec::simple("2", ["drive", "drive", "driven"], 2.0)));
    let expected = Error::CoincidentMembers {
        set: "2".into(),
        first: SetMember::Central(CentralKind::Sun),
        second: SetMember::Central(CentralKind::Ring),
        link: "drive".into(),
        is_pair: false,
        is_held: false,
    };
    assert_eq!(on_one, expected);
    // The same by a permanent connection, and by two permanent grounds.
    assert!(matches!(fault(sound().tie("drive", "ring")), Error::CoincidentMembers { .. }));
    let held = fault(sound().ground("drive").ground("ring"));
    assert!(held.to_string().contains("both held to the housing, so that the set cannot turn"), "{held}");
    let pair = |gears| fault(sound().set(SetSpec::pair("p", gears, 20, 41).unwrap()));
    let at_rest = pair(["driven", "ground"]);
    assert!(at_rest.to_string().starts_with("a gear of the pair `p` is held to the housing"), "{at_rest}");
    let fused = pair(["driven", "driven"]);
    assert!(fused.to_string().starts_with("both gears of the pair `p` are `driven`"), "{fused}");
}

#[test]
fn a_ring_to_sun_ratio_of_one_is_refused_of_a_simple_set_only() {
    for k in [1.0, 0.5, 0.0, -2.0, f64::NAN, f64::INFINITY] {
        let set = SetSpec::simple("2", ["drive", "ring", "driven"], k);
        assert!(
            matches!(fault(sound().set(set)), Error::RingToSunRatio { kind: SetKind::Simple, .. }),
            "{k}"
        );
    }
    let teeth = SetSpec::teeth("2", SetKind::Simple, ["drive", "ring", "driven"], 60, 60).unwrap();
    assert!(matches!(fault(sound().set(teeth)), Error::RingToSunRatio { .. }));
    for kind in [SetKind::Bevel, SetKind::MeshingSuns, SetKind::DoublePlanet, SetKind::SteppedSuns] {
        assert!(sound().set(SetSpec::new("2", kind, ["drive", "ring", "driven"], 0.8)).build().is_ok());
        let none = SetSpec::new("2", kind, ["drive", "ring", "driven"], 0.0);
        assert!(matches!(fault(sound().set(none)), Error::RingToSunRatio { .. }));
    }
}

#[test]
fn a_stepped_set_needs_its_steps() {
    let set = SetSpec::teeth("2", SetKind::SteppedRings, ["drive", "ring", "driven"], 60, 63).unwrap();
    assert!(matches!(fault(sound().set(set.clone())), Error::StepsMissing { .. }));
    let teeth = |n| ToothCount::new(n).unwrap();
    let gearbox = sound().set(set.planet_teeth(teeth(20), Some(teeth(21)))).build().unwrap();
    assert!((gearbox.sets()[1].basic_ratio().get() - 1.0).abs() < 1e-15);
}

#[test]
fn names_are_unique() {
    assert_eq!(fault(sound().links(["ring"])), Error::Duplicate { what: Named::Link, name: "ring".into() });
    assert!(matches!(fault(sound().links(["ground"])), Error::Duplicate { what: Named::Link, .. }));
    assert!(matches!(
        fault(sound().brake("K1", "driven")),
        Error::Duplicate { what: Named::ShiftElement, .. }
    ));
    assert!(matches!(fault(sound().gear("1", ["K1"])), Error::Duplicate { what: Named::Gear, .. }));
    let set = SetSpec::simple("1", ["drive", "ring", "driven"], 2.0);
    assert!(matches!(fault(sound().set(set)), Error::Duplicate { what: Named::Set, .. }));
}

#[test]
fn a_shift_element_joins_two_links() {
    let found = fault(sound().clutch("K2", "ring", "ring"));
    assert_eq!(found, Error::ShiftElementJoinsItself { shift_element: "K2".into(), link: "ring".into() });
    assert!(matches!(fault(sound().brake("K2", "ground")), Error::ShiftElementJoinsItself { .. }));
}

#[test]
fn permanent_connections_close_no_loop() {
    let loops = sound().links(["x", "y"]).ground("x").tie("x", "y").ground("y");
    assert_eq!(fault(loops), Error::CyclicGrounds { number: 2, first: "y".into(), second: "ground".into() });
    assert!(matches!(fault(sound().ground("ground")), Error::CyclicGrounds { .. }));
}

#[test]
fn power_does_not_enter_at_the_housing() {
    assert_eq!(
        fault(sound().input("ground")),
        Error::GroundedTerminal { place: Place::Terminal(Terminal::Input) }
    );
    let gear = GearSpec { name: "2".into(), engaged: vec![], input: None, output: Some("ground".into()) };
    assert_eq!(
        fault(sound().gear_spec(gear)),
        Error::GroundedTerminal { place: Place::TerminalOf(Terminal::Output, "2".into()) }
    );
    let unfinished = Gearbox::builder("box").set(SetSpec::simple("1", ["a", "b", "c"], 2.0));
    assert_eq!(fault(unfinished), Error::NoTerminal { terminal: Terminal::Input });
    assert_eq!(fault(Gearbox::builder("nothing")), Error::NoSets);
}

#[test]
fn shifted_profiles_are_a_matter_of_tooth_checks() {
    let set = SetSpec::teeth("2", SetKind::Simple, ["drive", "ring", "driven"], 22, 58).unwrap();
    let gearbox = sound().set(set.planet_teeth(ToothCount::new(17).unwrap(), None)).build().unwrap();
    assert_eq!(gearbox.warnings(), []);
    let found = gearbox.tooth_checks(&BasicRack::default());
    assert_eq!(
        found,
        [
            "set `2`: planet (17 teeth) is 19.5 modules from the axis by the sun (22 teeth) and 20.5 by the ring (58 \
          teeth): equal centre distances need shifted profiles"
        ]
    );
}

#[test]
fn shifts_given_are_checked_in_place_of_what_they_would_have_to_mend() {
    let with = |shifts: Shifts| {
        let set = SetSpec::teeth("2", SetKind::Simple, ["drive", "ring", "driven"], 18, 93).unwrap();
        let set = set.planet_teeth(ToothCount::new(36).unwrap(), None).planet_count(3).shifted(shifts);
        let gearbox = sound().set(set).build().unwrap();
        gearbox.tooth_checks(&BasicRack::default())
    };
    // As printed of a wind gearbox, to four digits.
    let shifts = Shifts { profile: vec![0.389, 0.5039, 0.1171], tips: Some(vec![-0.0833, -0.0833, 0.0]) };
    assert_eq!(with(shifts.clone()), [""; 0]);
    let long = Shifts { tips: Some(vec![0.3, -0.0833, 0.0]), ..shifts.clone() };
    assert_eq!(
        with(long)[1],
        "set `2`: the tips of the sun, mesh with the planet, clear the roots of the mate by -0.133 modules, at least 0 needed"
    );
    let pointed = with(Shifts { profile: vec![3.0, 0.5, 0.1], ..shifts.clone() });
    let start = "set `2`: external gear of 18 teeth, profile shift x = 3, tip alteration k = 0: its teeth are pointed";
    assert!(pointed.len() == 1 && pointed[0].starts_with(start), "{pointed:?}");
}

#[test]
fn a_set_has_a_planet_or_says_nothing_of_their_number() {
    let set = |count| SetSpec::simple("2", ["drive", "ring", "driven"], 3.0).planet_count(count);
    for given in [0, 1001] {
        let error = fault(sound().set(set(given)));
        assert_eq!(error, Error::PlanetCount { set: "2".into(), given });
    }
    assert_eq!(
        fault(sound().set(set(0))).to_string(),
        "set `2` has 0 planets: 1 to 1000 of each are allowed; leave the number out where it is unknown"
    );
    assert!(sound().set(set(1)).build().is_ok());
    let fault = sound().links(["small"]).compound_set(compound().planet_count(0)).build().unwrap_err();
    assert_eq!(fault, Error::PlanetCount { set: "R".into(), given: 0 });
}

#[test]
fn a_terminal_that_nothing_reaches_is_a_warning() {
    let gearbox = sound().links(["pto"]).output("pto").build().unwrap();
    assert_eq!(gearbox.warnings(), [Warning::Unreachable { link: "pto".into() }]);
}

/// A Ravigneaux set, whose faults are those of any compound set.
fn compound() -> CompoundSpec {
    let eta = MeshEfficiency::new(0.99).unwrap();
    CompoundSpec::new("R", "driven")
        .sun("small", 30)
        .sun("drive", 36)
        .ring("ring", 72)
        .planet("short", &[18])
        .planet("long", &[18])
        .mesh("small", "short", eta)
        .mesh("short", "long", eta)
        .mesh("drive", "long", eta)
        .mesh("long", "ring", eta)
}

#[test]
fn the_faults_of_a_compound_set_are_named() {
    let eta = MeshEfficiency::new(0.99).unwrap();
    let fault =
        |spec: CompoundSpec| sound().links(["small"]).compound_set(spec).build().unwrap_err().to_string();
    assert!(sound().links(["small"]).compound_set(compound()).build().is_ok());
    let change = |mesh: usize, between: [&str; 2]| {
        let mut spec = compound();
        spec.meshes[mesh].between = between.map(Into::into);
        spec
    };
    let without = |mesh: usize| {
        let mut spec = compound();
        spec.meshes.remove(mesh);
        spec
    };
    let mut one_member = compound();
    one_member.centrals.truncate(1);
    let mut twice = compound();
    twice.planets[1].name = "short".into();
    let mut toothless = compound();
    toothless.planets[0].teeth = vec![0];
    let mut long = compound();
    long.planets[0].teeth = vec![18; 13];
    let mut small_ring = compound();
    small_ring.centrals[2].teeth = 17.0;
    let two_shafts = compound().planet_shaft("small", "long").planet_shaft("drive", "long");
    let shaft_of_nothing = compound().planet_shaft("small", "wide");
    holds_for(
        &[
            (one_member, "set `R`: 1 central gears: at least two members besides the carrier are due"),
            (
                twice,
                "set `R`: `short` is named twice: central gears and planets of a set have names of their own",
            ),
            (
                two_shafts,
                "set `R`: `drive` is a second shaft of planet `long`: one is enough, with its link for all \
             that it joins",
            ),
            (toothless, "set `R`: gear `short` has 0 teeth: at least 1 is due"),
            (long, "set `R`: planet `short` has 13 gears: 12 at most are allowed"),
            (
                change(0, ["smal", "short"]),
                "set `R`: no gear is called `smal`; did you mean `small`?; a gear of a planet with several is \
             `planet.1`, `planet.2`…",
            ),
            (
                change(0, ["small", "drive"]),
                "set `R`: `small` and `drive` do not mesh: both are central gears, and turn about one axis",
            ),
            (
                change(1, ["long", "long"]),
                "set `R`: `long` and `long` do not mesh: they are gears of one planet, and turn as one piece",
            ),
            (
                small_ring,
                "set `R`: `long` and `ring` do not mesh: a ring has more teeth than the planet in it",
            ),
            (
                compound().mesh("short", "ring", eta),
                "set `R`: the mesh of `short` and `ring` closes a loop: other meshes tie them already; leave it out",
            ),
            (without(2), "set `R`: `drive` meshes with none of the others: add a mesh"),
            (
                shaft_of_nothing,
                "set `R`: no gear is called `wide`; a gear of a planet with several is `planet.1`, `planet.2`…",
            ),
        ],
        fault,
    );
    // On one link twice.
    let mut same = compound();
    same.centrals[0].link = "ring".into();
    assert_eq!(
        fault(same),
        "sun and ring of set `R` are both `ring`: such a set turns as a block; give them two links and join these \
         by a clutch"
    );
}

fn holds_for(cases: &[(CompoundSpec, &str)], fault: impl Fn(CompoundSpec) -> String) {
    for (spec, expected) in cases {
        assert_eq!(fault(spec.clone()), *expected);
    }
}

#[test]
fn more_than_is_solved_is_refused_with_its_number() {
    let chain = |count: usize| {
        let links: Vec<String> = (0..=count).map(|l| format!("w{l}")).collect();
        let mut train = Gearbox::builder("train").links(&links).input("w0").output(&links[count]);
        for (place, pair) in links.windows(2).enumerate() {
            train = train.set(SetSpec::pair(&place.to_string(), [&pair[0], &pair[1]], 20, 21).unwrap());
        }
        train.gear("1", [""; 0])
    };
    // As many as are allowed are solved, with their losses.
    let most =
        chain(MOST_SETS).map_sets(|set| set.with_loss(MeshLoss::Set(MeshEfficiency::new(0.99).unwrap())));
    let most = most.build().unwrap();
    let found = most.analyze("1").unwrap();
    assert!((found.ratio().unwrap() - 1.05_f64.powi(64)).abs() < 1e-12 * 1.05_f64.powi(64));
    assert!((found.efficiency().unwrap() - 0.99_f64.powi(64)).abs() < 1e-13);
    let fault = chain(1000).build().unwrap_err();
    assert_eq!(fault, Error::TooMany { what: Named::Set, count: 1000, limit: MOST_SETS });
    assert_eq!(fault.to_string(), "1000 planet sets: at most 64 are allowed");
    let many = (0..17).fold(sound(), |builder, c| builder.brake(&format!("B{c}"), "ring")).build().unwrap();
    assert!(matches!(many.combinations(0..=1), Err(Error::TooMany { what: Named::ShiftElement, .. })));
}

#[test]
fn a_gear_of_another_gearbox_is_refused() {
    let large = sound().brake("K2", "drive").gear("2", ["K2"]).build().unwrap();
    let small = sound().build().unwrap();
    let gear = large.gear("2").unwrap();
    assert!(matches!(small.analyze_gear(gear), Err(Error::ForeignGear { .. })));
    assert!(matches!(CompiledGear::new(&small, gear), Err(Error::ForeignGear { .. })));
}

#[test]
fn a_basic_ratio_beyond_the_limits_is_refused() {
    for k in [1e9, 1.0 + 1e-9] {
        assert!(sound().set(SetSpec::simple("2", ["drive", "ring", "driven"], k)).build().is_ok());
    }
    let fault = fault(sound().set(SetSpec::simple("2", ["drive", "ring", "driven"], 1e11)));
    assert_eq!(
        fault.to_string(),
        "k = 100000000000 of set `2` (simple): the ring of a simple set is larger than its sun, so k = z_b/z_a is \
         above 1, and 1e9 at most"
    );
}

#[test]
fn a_compiled_gear_takes_one_entry_a_set() {
    let gearbox = sound().gear("0", [""; 0]).build().unwrap();
    let compiled = CompiledGear::new(&gearbox, gearbox.gear("1").unwrap()).unwrap();
    let none = Values { ratios: vec![], ..gearbox.values() };
    let found = compiled.solve(&none, Direction::Drive, &mut Solution::default());
    assert_eq!(
        found,
        Err(Error::ValueCount { what: epicyclic_train::SetValue::BasicRatio, given: 0, expected: 1 })
    );
    let open = CompiledGear::new(&gearbox, gearbox.gear("0").unwrap()).unwrap_err();
    assert_eq!(open.to_string(), "the gear is not driven: underdetermined (ring, driven)");
}

#[test]
fn an_operating_point_is_finite_and_moves() {
    let gearbox = sound().build().unwrap();
    let found = gearbox.analyze("1").unwrap();
    let rad = AngularVelocity::new::<radian_per_second>;
    let nm = |t| InputLoad::Torque(Torque::new::<newton_meter>(t));
    let w = |p| InputLoad::Power(Power::new::<watt>(p));
    assert!(matches!(found.at(rad(0.0), w(10.0)), Err(Error::OperatingPoint { .. })));
    assert!(matches!(found.at(rad(f64::NAN), nm(1.0)), Err(Error::OperatingPoint { .. })));
    assert!(matches!(found.at(rad(1.0), nm(f64::INFINITY)), Err(Error::OperatingPoint { .. })));
    let work = found.at(rad(100.0), w(5000.0)).unwrap();
    assert!((work.input.get::<newton_meter>() - 50.0).abs() < 1e-12);
    assert!((work.output.get::<newton_meter>() - -200.0).abs() < 1e-12);
    let gearbox = sound().gear("0", [""; 0]).build().unwrap();
    let free = gearbox.analyze("0").unwrap();
    assert!(matches!(free.at(rad(1.0), nm(1.0)), Err(Error::NotDriven { .. })));
}

#[test]
fn a_description_of_a_thousand_sets_is_refused_at_once() {
    let builder = (0..1000).fold(Gearbox::builder("many"), |builder, place| {
        let [a, b, h] = [0, 1, 2].map(|member| format!("n{}", 3 * place + member));
        builder.links([a.clone(), b.clone(), h.clone()]).set(SetSpec::simple(
            &place.to_string(),
            [&a, &b, &h],
            3.0,
        ))
    });
    let start = std::time::Instant::now();
    let refused = builder.input("n0").output("n1").build().unwrap_err();
    assert_eq!(refused, Error::TooMany { what: Named::Set, count: 1000, limit: 64 });
    assert!(start.elapsed().as_millis() < 20, "{:?}", start.elapsed());
}

#[test]
fn all_faults_come_at_once_with_their_sites_and_without_those_that_follow() {
    use SetPart as Part;
    let eta = MeshEfficiency::IDEAL;
    let compound = CompoundSpec::new("1", "driven")
        .sun("drive", 0)
        .ring("nowhere", 60)
        .planet("p", &[20, 0])
        .mesh("drive", "p.1", eta)
        .mesh("p.3", "nowhere", eta)
        .planet_count(0);
    let own = |gear: &str, input: &str| GearSpec {
        name: gear.into(),
        engaged: ["K2", "K1", "K1", "K9"].map(String::from).into(),
        input: Some(input.into()),
        output: None,
    };
    let faulty = sound()
        .set(SetSpec::simple("2", ["drive", "rign", "driven"], 0.5))
        .compound_set(compound)
        // Its link is unknown; the gear that engages it is not refused for that.
        .brake("K2", "rign")
        .clutch("K3", "drive", "drive")
        .tie("ring", "rign")
        .ground("ground")
        .output("ground")
        .gear_spec(own("2", "ground"))
        .gear_spec(own("1", "drive"));
    let found = faulty.clone().build_all().unwrap_err();
    assert_eq!(faulty.build().unwrap_err(), found[0].error);
    let found: Vec<(Site, &str)> = found.iter().map(|one| (one.site, one.error.name())).collect();
    let expected = [
        (Site::Set(2, Part::Whole), "duplicate"),
        (Site::Gear(2, GearPart::Whole), "duplicate"),
        (Site::Terminal(Terminal::Output), "grounded-terminal"),
        (Site::Connection(0, Some(1)), "unknown"),
        (Site::Connection(1, None), "cyclic-grounds"),
        (Site::Set(1, Part::Central(1)), "unknown"),
        (Site::Set(1, Part::BasicRatio), "ring-to-sun-ratio"),
        (Site::Set(2, Part::PlanetGear(0, 1)), "compound"),
        (Site::Set(2, Part::Central(0)), "compound"),
        (Site::Set(2, Part::MeshGear(1, 0)), "compound"),
        (Site::Set(2, Part::Central(1)), "unknown"),
        (Site::Set(2, Part::PlanetCount), "planet-count"),
        (Site::ShiftElement(1, Some(0)), "unknown"),
        (Site::ShiftElement(2, None), "shift-element-joins-itself"),
        (Site::Gear(1, GearPart::Engaged(2)), "engaged-twice"),
        (Site::Gear(1, GearPart::Engaged(3)), "unknown"),
        (Site::Gear(1, GearPart::Terminal(Terminal::Input)), "grounded-terminal"),
        (Site::Gear(2, GearPart::Engaged(2)), "engaged-twice"),
        (Site::Gear(2, GearPart::Engaged(3)), "unknown"),
    ];
    assert_eq!(found, expected);
}

#[test]
fn what_is_beyond_a_limit_is_at_the_first_entry_too_many() {
    let many = (0..300).fold(sound(), |builder, _| builder.tie("drive", "ring"));
    let many = (0..70).fold(many, |builder, _| builder.set(SetSpec::simple("1", ["a", "b", "c"], 3.0)));
    let sites: Vec<Site> = many.build_all().unwrap_err().iter().map(|one| one.site).collect();
    assert_eq!(sites, [Site::Set(64, SetPart::Whole), Site::Connection(256, None)]);
}
