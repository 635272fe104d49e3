//! The checks of interference against the outlines of planet and ring, as their tools leave them, at every
//! position: points of one within the other.

use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::check::{Place, Rule, SetMesh};
use epicyclic_gears::involute::closing::Closing;
use epicyclic_gears::involute::curve::ToothCurve;
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::involute::tool::{Shaper, Tool};
use epicyclic_gears::involute::{InvoluteGear, PlanetSet, Profile};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// Positions of a pitch.
const STEPS: u32 = 36;

/// Conjugate flanks without backlash touch but for this, in modules.
const ROUNDING: f64 = 1e-6;

/// Misses of a check by less may lie between the positions and points that are tried.
const GRAZE: f64 = 0.03;

/// Greatest depth of a point of planet or ring inside a tooth of the other, as an arc in modules.
fn deepest(set: &PlanetSet) -> Option<f64> {
    let [_, planet, ring] = set.gears();
    let planet = ToothCurve::new(*planet).ok()?;
    let ring = ToothCurve::new(*ring).ok()?;
    let a = set.centre_distance();
    let [z1, z2] = [&planet, &ring].map(|curve| curve.gear().teeth().as_f64());
    let [of_planet, of_ring] = [&planet, &ring].map(|curve| curve.half(1e-3).expect("a curve"));
    let inside = |curve: &ToothCurve, radius: f64, angle: f64| {
        let pitch = TAU / curve.gear().teeth().as_f64();
        let from_tooth = (angle - (angle / pitch).round() * pitch).abs();
        (curve.half_angle(radius) - from_tooth) * radius
    };
    let mut deepest = f64::NEG_INFINITY;
    for step in 0..STEPS {
        let turn1 = TAU / z1 * f64::from(step) / f64::from(STEPS);
        let turn2 = turn1 * z1 / z2 + PI / z2;
        for side in [-1.0, 1.0] {
            for tooth in 0..planet.gear().teeth().get() {
                let turned = turn1 + TAU * f64::from(tooth) / z1;
                for point in &of_planet {
                    let angle = turned + side * point.angle;
                    let (x, y) = (point.radius * libm::cos(angle) + a, point.radius * libm::sin(angle));
                    let radius = libm::hypot(x, y);
                    if radius > ring.tip_radius() {
                        deepest = deepest.max(inside(&ring, radius, libm::atan2(y, x) - turn2));
                    }
                }
            }
            for tooth in 0..ring.gear().teeth().get() {
                let turned = turn2 + TAU * f64::from(tooth) / z2;
                for point in &of_ring {
                    let angle = turned + side * point.angle;
                    let (x, y) = (point.radius * libm::cos(angle) - a, point.radius * libm::sin(angle));
                    let radius = libm::hypot(x, y);
                    if radius < planet.tip_radius() {
                        deepest = deepest.max(inside(&planet, radius, libm::atan2(y, x) - turn1));
                    }
                }
            }
        }
    }
    Some(deepest)
}

/// Whether the checks say that planet and ring interfere; `None` where one of them is a near thing, or the
/// tool spoils the ring.
fn interferes(set: &PlanetSet) -> Option<bool> {
    let rules = [Rule::Involute, Rule::Fillet, Rule::Trochoidal, Rule::TipClearance];
    let of_ring = |place: Place| match place {
        Place::Tips(_, mesh) | Place::Mesh(mesh) => mesh == SetMesh::PlanetRing,
        _ => false,
    };
    let mut found = false;
    for check in set.checks(&Limits::default()) {
        match check.rule {
            Rule::Tool | Rule::ToolTips | Rule::ToolTrochoidal | Rule::ToolFeed if !check.holds() => {
                return None;
            }
            rule if rules.contains(&rule) && of_ring(check.place) => {
                if (check.value - check.limit).abs()
                    < GRAZE * if rule == Rule::Trochoidal { 0.05 } else { 1.0 }
                {
                    return None;
                }
                found |= !check.holds();
            }
            _ => {}
        }
    }
    Some(found)
}

fn tool(cutter: u32, tip_radius: f64) -> Tool {
    let teeth = ToothCount::new(cutter).expect("teeth");
    Tool::Shaper(Shaper { addendum: Some(1.25), tip_radius, ..Shaper::of_teeth(teeth) })
}

fn set(teeth: [u32; 3], shift: f64, ring: Tool) -> Option<PlanetSet> {
    let [sun, planet, internal] = teeth.map(|teeth| ToothCount::new(teeth).expect("teeth"));
    let gear = |kind, teeth, shift| InvoluteGear::new(kind, teeth, Profile::default(), shift).ok();
    let gears = [
        gear(GearKind::External, sun, -shift)?,
        gear(GearKind::External, planet, shift)?,
        gear(GearKind::Internal, internal, -shift)?.with_tool(ring).ok()?,
    ];
    PlanetSet::new(gears, 3, (sun.as_f64() + planet.as_f64()) / 2.0).ok()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases / 8, ..ProptestConfig::default() })]
    /// Compares the verdicts for usual and for shortened tips: clear if the outlines are clear, and not if
    /// they overlap.
    #[test]
    fn verdicts_are_those_of_the_outlines(
        sun in 12..50_u32, planet in 14..50_u32, shift in -0.5..0.5_f64, cutter in 18..40_u32, radius in 0.1..0.38_f64, shortened: bool,
    ) {
        let Some(set) = set([sun, planet, sun + 2 * planet], shift, tool(cutter, radius)) else { return Ok(()) };
        let set = if shortened { set.with_clear_ring_tips().unwrap_or(set) } else { set };
        let (Some(verdict), Some(deepest)) = (interferes(&set), deepest(&set)) else { return Ok(()) };
        if verdict {
            prop_assert!(deepest > ROUNDING, "said to interfere, {deepest} modules: {set:?}");
        } else {
            prop_assert!(deepest < ROUNDING, "said to be clear, {deepest} modules deep: {set:?}");
        }
    }

    /// Sets that a search offers.
    #[test]
    fn sets_that_close_do_not_collide(sun in 12..40_u32, planet in 14..45_u32, offset in -4..=4_i32) {
        let Some(ring) = (sun + 2 * planet).checked_add_signed(offset) else { return Ok(()) };
        let teeth = [sun, planet, ring].map(|teeth| ToothCount::new(teeth).expect("teeth"));
        let Ok(choice) = Closing::default().close(teeth) else { return Ok(()) };
        let Some(deepest) = deepest(&choice.set) else { panic!("a set that no tool cuts was offered") };
        prop_assert!(deepest < ROUNDING, "{deepest} modules deep: {:?}", choice.set);
    }
}
