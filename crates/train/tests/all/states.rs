//! The states of a gear, one by one, with the parts beside the power path.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::machines;
use epicyclic_train::set::SetSpec;
use epicyclic_train::{Gearbox, GearboxBuilder, State};

fn names(links: &[&str]) -> Vec<String> {
    links.iter().map(ToString::to_string).collect()
}

fn one_set() -> GearboxBuilder {
    Gearbox::builder("one set")
        .links(["a", "b", "H", "x", "y"])
        .set(SetSpec::simple("1", ["a", "b", "H"], 3.0))
        .brake("Kb", "b")
        .brake("Kb2", "b")
        .brake("Ka", "a")
        .brake("KH", "H")
        .brake("Kx", "x")
        .brake("Kx2", "x")
        .clutch("ab", "a", "b")
        .clutch("aH", "a", "H")
        .clutch("bH", "b", "H")
        .clutch("xH", "x", "H")
        .input("a")
        .output("H")
}

fn state(builder: GearboxBuilder, engaged: &[&str]) -> State {
    let gearbox = builder.gear("g", engaged.iter().copied()).build().unwrap();
    gearbox.analyze("g").unwrap().state().clone()
}

#[test]
fn a_held_ring_drives() {
    assert_eq!(state(one_set(), &["Kb"]), State::Driven);
}

#[test]
fn a_braked_input_is_blocked() {
    assert_eq!(state(one_set(), &["Ka"]), State::InputBlocked { links: names(&["a"]) });
}

#[test]
fn two_brakes_block_the_third_member() {
    assert_eq!(state(one_set(), &["Kb", "ab"]), State::InputBlocked { links: names(&["a", "b", "H"]) });
}

#[test]
fn a_braked_output_rests_while_the_input_turns_the_ring() {
    assert_eq!(state(one_set(), &["KH"]), State::OutputAtRest { links: names(&["H"]) });
}

#[test]
fn a_differential_without_a_shift_element_is_underdetermined() {
    assert_eq!(state(one_set(), &[]), State::Underdetermined { missing: 1, links: names(&["b", "H"]) });
}

#[test]
fn an_output_beside_the_set_is_free() {
    assert_eq!(state(one_set().output("x"), &["Kb"]), State::OutputFree { links: names(&["x"]) });
    // With the input blocked as well, nothing can be driven at all: that comes first.
    assert!(matches!(state(one_set().output("x"), &["Ka"]), State::InputBlocked { .. }));
}

#[test]
fn two_brakes_on_one_reaction_share_it_in_an_unknown_way() {
    let found = state(one_set(), &["Kb", "Kb2"]);
    let expected = State::TorquesIndeterminate {
        links: names(&["b"]),
        shift_elements: names(&["Kb", "Kb2"]),
        sets: vec![],
    };
    assert_eq!(found, expected);
    // What they hold together, and so the efficiency, is known all the same.
    let gearbox = one_set().gear("g", ["Kb", "Kb2"]).build().unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!(found.efficiency(), Some(1.0));
    let case = found.driving().unwrap();
    assert_eq!((case.output, case.housing, case.shift_elements[0]), (-4.0, 3.0, None));
}

#[test]
fn a_redundant_pair_of_brakes_beside_the_path_spoils_nothing() {
    let gearbox = one_set().gear("g", ["Kb", "Kx", "Kx2"]).build().unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!(*found.state(), State::Driven);
    let case = found.driving().unwrap();
    // The brake on the ring is known; how the idle two press against each other is not.
    assert_eq!(case.shift_elements[0], Some(3.0));
    assert_eq!((case.shift_elements[4], case.shift_elements[5]), (None, None));
}

#[test]
fn a_clutch_to_a_loose_link_carries_nothing() {
    let gearbox = one_set().gear("g", ["Kb", "xH"]).build().unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!(*found.state(), State::Driven);
    assert_eq!(found.driving().unwrap().shift_elements[9], Some(0.0));
    assert!((found.speed(gearbox.link("x").unwrap()).unwrap() - 0.25).abs() < 1e-15);
    assert_eq!(found.speed(gearbox.link("y").unwrap()), None);
}

#[test]
fn a_block_by_one_clutch_is_driven() {
    // aH joins input with output: the set carries nothing. ab carries what a leaves to b.
    assert_eq!(state(one_set(), &["aH"]), State::Driven);
    assert_eq!(state(one_set(), &["ab"]), State::Driven);
    assert_eq!(state(one_set(), &["bH"]), State::Driven);
}

#[test]
fn a_block_by_two_clutches_shares_the_torque_in_an_unknown_way() {
    let found = state(one_set(), &["ab", "bH"]);
    let State::TorquesIndeterminate { links, shift_elements, sets } = found else { panic!("{found}") };
    assert_eq!(links, ["a", "b", "H"]);
    assert_eq!(shift_elements, ["ab", "bH"]);
    assert_eq!(sets, ["1"]);
    // A block loses nothing, however the clutches share the torque.
    let gearbox = one_set().gear("g", ["ab", "bH"]).build().unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!((found.ratio(), found.efficiency()), (Some(1.0), Some(1.0)));
    assert_eq!(found.driving().unwrap().members[0], None);
}

#[test]
fn an_idle_set_that_spins_freely_spoils_nothing() {
    let gearbox = one_set()
        .links(["p", "q"])
        .set(SetSpec::simple("2", ["H", "p", "q"], 2.0))
        .gear("g", ["Kb"])
        .build()
        .unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!(*found.state(), State::Driven);
    assert_eq!(found.sets()[1].members, [Some(0.25), None, None]);
    assert_eq!(found.driving().unwrap().members[1], Some(vec![0.0; 3]));
    assert!((found.efficiency().unwrap() - 1.0).abs() < 1e-15);
}

#[test]
fn a_set_locked_on_its_own_spoils_nothing() {
    let gearbox = one_set()
        .links(["p", "q", "r"])
        .set(SetSpec::simple("2", ["p", "q", "r"], 2.0))
        .brake("Kp", "p")
        .brake("Kq", "q")
        .brake("Kr", "r")
        .gear("g", ["Kb", "Kp", "Kq", "Kr"])
        .build()
        .unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!(*found.state(), State::Driven);
    assert_eq!(found.driving().unwrap().members[1], None);
    assert_eq!(found.driving().unwrap().shift_elements[10], None);
    assert_eq!(found.driving().unwrap().shift_elements[0], Some(3.0));
}

#[test]
fn twin_sets_share_the_torque_in_an_unknown_way() {
    let twin = one_set().set(SetSpec::simple("2", ["a", "b", "H"], 3.0));
    let found = state(twin, &["Kb"]);
    let State::TorquesIndeterminate { sets, shift_elements, .. } = found else { panic!("{found}") };
    assert_eq!(sets, ["1", "2"]);
    assert!(shift_elements.is_empty());
    let twin = one_set().set(SetSpec::simple("2", ["a", "b", "H"], 3.0));
    let gearbox = twin.gear("g", ["Kb"]).build().unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!((found.ratio(), found.efficiency()), (Some(4.0), None));
}

#[test]
fn sets_that_differ_only_in_ratio_turn_as_a_block() {
    // Two sets on the same three links, k different: all turn alike, and nothing can be held.
    let pair = one_set().set(SetSpec::simple("2", ["a", "b", "H"], 3.5));
    assert_eq!(state(pair.clone(), &[]), State::Driven);
    assert!(matches!(state(pair, &["Kb"]), State::InputBlocked { .. }));
}

#[test]
fn central_gears_that_turn_alike_leave_their_carrier_alone() {
    use epicyclic_train::set::SetKind;
    let alike = Gearbox::builder("south-pointing")
        .links(["a", "b", "H"])
        .set(SetSpec::new("1", SetKind::SteppedSuns, ["a", "b", "H"], 1.0))
        .brake("KH", "H")
        .input("a")
        .output("b")
        .gear("held", ["KH"])
        .gear("loose", [""; 0])
        .build()
        .unwrap();
    assert_eq!(*alike.analyze("held").unwrap().state(), State::Driven);
    // The ratio is 1 either way, but what a loose carrier costs the meshes does not follow.
    let loose = alike.analyze("loose").unwrap();
    assert_eq!(*loose.state(), State::Underdetermined { missing: 1, links: names(&["H"]) });
    assert_eq!(loose.ratio(), Some(1.0));
}

/// A set with its central gears tied turns as a block, unless they turn alike anyway: then nothing ties the
/// carrier.
#[test]
fn tied_central_gears_hold_their_carrier_unless_they_turn_alike() {
    use epicyclic_train::set::SetKind;
    let tied = |i0: f64| {
        let builder =
            Gearbox::builder("tied").links(["a", "b", "H"]).clutch("L", "a", "b").input("a").output("b");
        let set = SetSpec::new("1", SetKind::SteppedSuns, ["a", "b", "H"], i0);
        let gearbox = builder.set(set).gear("g", ["L"]).build().unwrap();
        let found = gearbox.analyze("g").unwrap();
        assert_eq!(found.ratio(), Some(1.0));
        found.speed(gearbox.link("H").unwrap())
    };
    assert_eq!(tied(1.0), None);
    for i0 in [0.5, 1.25, 3.0] {
        assert_eq!(tied(i0), Some(1.0), "{i0}");
    }
}

/// Two suns on one shaft that mesh with one piece of planets at one ratio: the second mesh is redundant, and
/// nothing turns as a block. With any other ratio it does.
#[test]
fn fused_suns_of_one_ratio_run_and_others_are_a_block() {
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_train::compound::{CompoundSpec, MeshSpec};
    let fused = |second: u32| {
        let mut set = CompoundSpec::new("T", "arm")
            .sun("core", 9)
            .sun("core2", second)
            .ring("ground", 33)
            .ring("r2", 63)
            .planet("p", &[12, 24]);
        for (central, gear) in [("core", "p.1"), ("ground", "p.1"), ("core2", "p.2"), ("r2", "p.2")] {
            set.meshes
                .push(MeshSpec { between: [central.into(), gear.into()], efficiency: MeshEfficiency::IDEAL });
        }
        Gearbox::builder("solid core")
            .links(["core", "core2", "arm", "r2"])
            .compound_set(set)
            .tie("core", "core2")
            .input("core")
            .output("r2")
            .gear("only", [""; 0])
            .build()
    };
    let gearbox = fused(18).unwrap();
    let found = gearbox.analyze("only").unwrap();
    // By hand: ω_H = ω_s/(1 + 33/9), ω_p = ω_H·(1 − 33/12), ω_r2 = ω_H + (ω_p − ω_H)·24/63.
    let carrier = 1.0 / (1.0 + 33.0 / 9.0);
    let planet = carrier * (1.0 - 33.0 / 12.0);
    let ring = carrier + (planet - carrier) * 24.0 / 63.0;
    assert!((found.ratio().unwrap() * ring - 1.0).abs() < 1e-12, "{:?} {ring}", found.ratio());
    assert!(fused(20).unwrap_err().to_string().contains("turns as a block"));
}

#[test]
fn a_simpson_set_with_one_clutch_is_neutral_for_want_of_one_shift_element() {
    let gearbox = machines::simpson().gearbox;
    let gear = gearbox.gear_of(&["FWD"], "in", "out").unwrap();
    let found = gearbox.analyze_gear(&gear).unwrap();
    assert!(matches!(found.state(), State::Underdetermined { missing: 1, .. }), "{}", found.state());
    // With nothing engaged the input touches no set at all.
    let gear = gearbox.gear_of(&[], "in", "out").unwrap();
    assert!(matches!(gearbox.analyze_gear(&gear).unwrap().state(), State::OutputFree { .. }));
}

#[test]
fn every_combination_of_the_eight_speed_has_a_state() {
    let gearbox = machines::eight_speed().gearbox;
    let all = gearbox.combinations(0..=5).unwrap();
    assert_eq!(all.len(), 32);
    let states = |size: usize| -> Vec<&str> {
        let of_size = all.iter().filter(|found| found.gear().engaged().len() == size);
        of_size.map(|found| found.state().name()).collect()
    };
    // Every triple is a gear but A+C+E, which turns set 2 into a block and holds its sun.
    let blocked: Vec<&str> = all
        .iter()
        .filter(|f| f.gear().engaged().len() == 3 && !f.state().has_ratio())
        .map(|f| f.gear().name())
        .collect();
    assert_eq!(blocked, ["A+C+E"]);
    assert!(states(2).iter().chain(&states(1)).chain(&states(0)).all(|state| *state == "underdetermined"));
    assert!(states(4).iter().chain(&states(5)).all(|state| *state == "input blocked"));
}
