//! Values for the rules of practice, and which rules gears and meshes have.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::practice::{
    of_face_load, of_gap, of_gear, of_mesh, of_speed, of_total_contact, orbit_acceleration, orbit_rule,
    pin_speed, pin_speed_rule, shift_rule,
};
use epicyclic_gears::involute::tool::{Shaper, Tool};
use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
use epicyclic_gears::life::Rolling;
use epicyclic_gears::rack::BasicRack;
use epicyclic_judge::{Limits, Rule, Severity};
use std::f64::consts::TAU;
use uom::si::angle::degree;
use uom::si::f64::Angle;

fn gear(kind: GearKind, teeth: u32, shift: f64) -> InvoluteGear {
    InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), Profile::default(), shift).unwrap()
}

#[test]
fn values_of_rules_as_worked_out_by_hand() {
    let limits = Limits::default();
    let planet = gear(GearKind::External, 30, 0.0);
    let gaps = of_gap(&limits, &planet, 25.0, TAU / 3.0, Some(0.002));
    for (value, due) in [
        (orbit_acceleration(0.1, 100.0), 101.971_621),
        (pin_speed(100.0, 0.05), 47_746.482_9),
        (of_face_load(&limits, 1.2, 1.5).limit, 1.576),
        (gaps[0].value, 11.301_27),
        (gaps[1].value, 22.602_54),
    ] {
        assert!((value / due - 1.0).abs() < 1e-6, "{value} {due}");
    }
    assert_eq!([gaps[0].rule, gaps[1].rule], [Rule::NeighbourGap, Rule::NeighbourGapLength]);
    assert_eq!(of_gap(&limits, &planet, 25.0, TAU / 3.0, None).len(), 1);
    for (rolling, pin, orbit) in [
        (Rolling::Balls, Rule::PinSpeed, Rule::OrbitAcceleration),
        (Rolling::Rollers, Rule::PinSpeed, Rule::OrbitAcceleration),
        (Rolling::Needles, Rule::PinSpeed, Rule::NeedleAcceleration),
        (Rolling::FullComplement, Rule::FullPinSpeed, Rule::OrbitAcceleration),
    ] {
        assert_eq!((pin_speed_rule(rolling), orbit_rule(rolling)), (Some(pin), Some(orbit)));
    }
    assert_eq!((pin_speed_rule(Rolling::Plain), orbit_rule(Rolling::Plain)), (None, None));
}

#[test]
fn each_kind_of_gear_and_mesh_has_its_rules() {
    use Rule::*;
    let limits = Limits::default();
    let of = |kind, teeth, shift, angle: f64, helix: f64| {
        let [pressure_angle, helix_angle] = [angle, helix].map(Angle::new::<degree>);
        let rack = BasicRack { pressure_angle, ..BasicRack::default() };
        let profile = Profile { rack, helix_angle, ..Profile::default() };
        InvoluteGear::new(kind, ToothCount::new(teeth).unwrap(), profile, shift).unwrap()
    };
    // Kind of the second gear, pressure angle, helix angle, rules without clearances, limit of the angle.
    let rows: [(GearKind, f64, f64, &[Rule], f64); 4] = [
        (GearKind::External, 20.0, 0.0, &[SpecificSliding, ExternalAngle, ShiftSum, SpurContact], 20.0),
        (GearKind::External, 22.5, 0.0, &[SpecificSliding, ExternalAngle, ShiftSum, SpurContact], 22.5),
        (GearKind::External, 20.0, 15.0, &[SpecificSliding, ExternalAngle, ShiftSum], 20.646_9),
        (GearKind::Internal, 17.5, 0.0, &[SpecificSliding, InternalAngle, SpurContact], 19.5),
    ];
    for (kind, angle, helix, rules, limit) in rows {
        let pair = Pair::without_backlash(
            of(GearKind::External, 30, 0.1, angle, helix),
            of(kind, 90, 0.05, angle, helix),
        );
        let pair = pair.unwrap();
        let all = of_mesh(&limits, &pair);
        let found: Vec<Rule> = all.iter().map(|(_, one)| one.rule).collect();
        assert_eq!(found, [rules, &[RootClearance; 2]].concat());
        assert!((all[1].1.limit - limit).abs() < 1e-3, "{:?}", all[1].1);
        let sliding = pair.specific_sliding().into_iter().flatten().map(f64::abs).reduce(f64::max);
        assert_eq!(Some(all[0].1.value), sliding);
        if rules.contains(&ShiftSum) {
            assert!((all[2].1.value - 0.15).abs() < 1e-12);
        }
        let is_helical = helix != 0.0;
        let total = pair.transverse_contact_ratio() + pair.overlap_ratio(10.0);
        assert_eq!(of_total_contact(&limits, &pair, 10.0).map(|one| one.value), is_helical.then_some(total));
        let speed = of_speed(&limits, &pair, 10.0).rule;
        assert_eq!(speed, if is_helical { HelicalSpeed } else { SpurSpeed });
    }
    // Teeth by which the ring exceeds its planet, severity of a shift beyond 1.
    for (more, severity) in [(6, Severity::Warning), (7, Severity::Error)] {
        let ring = gear(GearKind::Internal, 90, -1.3);
        let pair = Pair::without_backlash(gear(GearKind::External, 90 - more, 1.2), ring).unwrap();
        let judged = of_gear(&limits, RingShift, &ring, [pair].iter(), true);
        assert_eq!((judged[0].severity, judged[1].rule), (Some(severity), HardenedTips), "{more}");
    }
    for (kind, is_planet, is_of_pair, rule) in [
        (GearKind::External, false, false, SunShift),
        (GearKind::External, true, false, PlanetShift),
        (GearKind::Internal, false, false, RingShift),
        (GearKind::Internal, false, true, GearShift),
    ] {
        assert_eq!(shift_rule(&gear(kind, 60, 0.0), is_planet, is_of_pair), rule);
    }
}

/// Rings of fewer than 42 teeth have a form tool, others a shaper of 18 teeth less, of 30 at most; corners are
/// rounded by 0.3 modules. Practice of gear cutting.
#[test]
fn usual_tools_change_at_their_numbers_of_teeth() {
    let of = |ring| Tool::usual(GearKind::Internal, ToothCount::new(ring).unwrap());
    let shaper = |teeth| {
        let teeth = ToothCount::new(teeth).unwrap();
        Tool::Shaper(Shaper { teeth, shift: 0.0, addendum: None, tip_radius: 0.3 })
    };
    assert_eq!(of(41), Tool::Form { fillet: 0.3 });
    for (ring, cutter) in [(42, 24), (43, 25), (47, 29), (48, 30), (49, 30), (200, 30)] {
        assert_eq!(of(ring), shaper(cutter), "{ring}");
    }
    for (shift, is_allowed) in [(0.999, true), (1.001, false), (-0.999, true), (-1.001, false)] {
        let tool = Tool::Shaper(Shaper { shift, ..Shaper::of_teeth(ToothCount::new(24).unwrap()) });
        assert_eq!(tool.check(GearKind::Internal).is_ok(), is_allowed, "{shift}");
    }
}

/// A failed check of teeth is an error where gears cannot be cut, assembled or turned.
#[test]
fn severities_of_failed_checks_of_teeth() {
    use epicyclic_gears::involute::check::Rule::*;
    let errors = [
        Tool,
        TipThickness,
        ToolTips,
        ToolTrochoidal,
        ToolFeed,
        ContactRatio,
        TipClearance,
        Backlash,
        Involute,
        Fillet,
        Trochoidal,
        PlanetGap,
    ];
    assert!(errors.iter().all(|rule| rule.severity() == Severity::Error));
    assert_eq!((Undercut.severity(), RadialAssembly.severity()), (Severity::Warning, Severity::Remark));
    // Half a module between neighbouring planets is usual.
    assert_eq!(epicyclic_gears::mesh::USUAL_PLANET_GAP, 0.5);
}
