//! Sets and rings that others calculated. Circles, measures and meshes of pairs are cases:
//! `spec-cases/wind-gearbox`, `involute-gears`, `fzg-test-gears`.

use super::family::Family;
use super::profile::{Cutting, Iso53};
use super::set::Limits;
use super::tool::{Shaper, Tool};
use super::{InvoluteGear, Pair, PlanetSet, Profile};
use crate::ToothCount;
use crate::gear_kind::GearKind::{External, Internal};
use epicyclic_units::Physical;
use uom::si::f64::Angle;

fn gear(teeth: i32, shift: f64) -> InvoluteGear {
    shaped(teeth, shift, Profile::default())
}

/// A gear with less than no teeth is internal.
fn shaped(teeth: i32, shift: f64, profile: Profile) -> InvoluteGear {
    let kind = if teeth < 0 { Internal } else { External };
    InvoluteGear::new(kind, ToothCount::new(teeth.unsigned_abs()).unwrap(), profile, shift).unwrap()
}

/// Whether a value rounds to what is printed.
fn is(value: f64, printed: &str) {
    is_but_for(value, 0.0, printed);
}

/// Whether a value rounds to the printed one, given that rounded inputs may move it by `inputs`.
fn is_but_for(value: f64, inputs: f64, printed: &str) {
    let digits = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let unit = 10_f64.powi(-i32::try_from(digits).unwrap());
    let published: f64 = printed.parse().unwrap();
    assert!((value - published).abs() <= 0.5001 * unit + inputs, "{value}, printed {printed}");
}

/// Second stage of the NREL reference gearbox: 18/36/93 teeth, 18 + 2·36 ≠ 93, m = 21 mm, a = 584 mm.
fn wind() -> [Pair; 2] {
    let m = 21.0;
    let [sun, planet, ring] = [gear(18, 0.3890), gear(36, 0.5039), gear(-93, 0.1171)];
    let pair = |one, other| Pair::at_centre_distance(one, other, 584.0 / m).unwrap();
    // The shifts are printed to four digits: of those that round so, the ones that leave no backlash.
    let shift = Pair::shift_sum(&sun, &planet, 584.0 / m).unwrap() - sun.shift();
    let planet = planet.with_shift(shift).unwrap();
    is(planet.shift(), "0.5039");
    let ring = ring.with_shift(Pair::shift_sum(&planet, &ring, 584.0 / m).unwrap() - shift).unwrap();
    is(ring.shift(), "0.1171");
    let k = pair(sun, planet).tip_alteration();
    is(m * k, "-1.750");
    let [sun, planet] = [sun, planet].map(|gear| gear.with_tip_alteration(k).unwrap());
    [pair(sun, planet), pair(planet, ring)]
}

/// Sets that break `z_r = z_s + 2·z_p`: each is a member of its family, with its printed shifts and without a
/// fault.
#[test]
fn published_sets_are_members_of_their_families() {
    let [straight, helical] =
        [0.0, 8.0].map(|helix| Profile { helix_angle: Angle::from_degrees(helix), ..Profile::default() });
    for (teeth, planets, profile, a, printed) in [
        ([18, 36, 93], 3, straight, 584.0 / 21.0, [0.3890, 0.5039, 0.1171]),
        ([21, 43, 108], 3, straight, 56.8 / 1.75, [0.4380, 0.0426, 0.0]),
        ([26, 31, 89], 5, helical, 877.033 / 30.0, [0.2702, 0.2093, -0.1591]),
    ] {
        let teeth = teeth.map(|count| ToothCount::new(count).unwrap());
        let family = Family::new(teeth, planets, profile, a).unwrap();
        let shifts = family.shifts(printed[0]);
        for (shift, printed) in shifts.into_iter().zip(printed) {
            // Two printed shifts make a sum: one unit of the last digit.
            assert!((shift - printed).abs() < 1.01e-4, "{teeth:?}: {shift}, printed {printed}");
        }
        let set = family.at(printed[0]).unwrap();
        assert_eq!(set.faults(&Limits { tip_thickness: 0.4, ..Limits::default() }), []);
        // The tips of two rings reach into the fillets that a hob of profile A leaves on planets: they are
        // shortened a little.
        let [sun, planet, ring] = set.gears().map(InvoluteGear::tip_alteration);
        assert_eq!([sun, planet], [family.tip_alteration(); 2]);
        assert!((-0.08..=0.0).contains(&ring) && (ring < 0.0) == (printed[2] <= 0.0), "{ring}");
        assert!(set.spacing().is_equal());
    }
}

#[test]
fn a_stage_of_a_wind_gearbox_is_a_set() {
    let [outer, inner] = wind();
    let ([sun, planet], ring) = (*outer.gears(), inner.gears()[1]);
    let bare = [sun, planet, ring].map(|gear| gear.with_tip_alteration(0.0).unwrap());
    let set = PlanetSet::new(bare, 3, 584.0 / 21.0).unwrap().with_tip_clearance().unwrap();
    assert_eq!([*set.sun_mesh(), *set.ring_mesh()], [outer, inner]);
    // 2·584·sin 60° − 815.663 mm
    is_but_for(21.0 * set.planet_gap(), 1e-3, "195.855");
}

/// Rings by shapers and a form tool, external gears by hobs and a pinion cutter, in millimetres: root, form
/// and active root diameters calculated by trial of all positions, the first as a report prints it.
#[test]
fn roots_are_those_that_the_tools_leave() {
    let shaper = |teeth, shift, addendum, tip_radius| {
        let teeth = ToothCount::new(teeth).unwrap();
        Tool::Shaper(Shaper { teeth, shift, addendum, tip_radius })
    };
    let near = |found: f64, expected: f64, digits: f64| {
        assert!((found - expected).abs() < digits, "{found}, expected {expected}");
    };
    // 93 teeth, m 21, with the printed root circle: the addendum follows.
    let ring = gear(-93, 0.1171).with_tool(shaper(30, 0.0, None, 0.3)).unwrap();
    near(21.0 * ring.root_diameter(), 2000.581, 1e-3);
    near(ring.shaper_addendum().unwrap(), 1.2517, 5e-5);
    near(21.0 * ring.form_diameter(), 1987.880, 1e-3);
    let planet = gear(36, 0.5039).with_tip_alteration(-1.75 / 21.0).unwrap();
    let pair = Pair::at_centre_distance(planet, ring, 584.0 / 21.0).unwrap();
    near(21.0 * pair.active_root_diameters()[1], 1969.750, 2e-3);
    near(21.0 * gear(18, 0.3890).form_diameter(), 359.324, 1e-3);
    near(21.0 * gear(36, 0.5039).form_diameter(), 737.390, 1e-3);

    let ring = gear(-100, 0.0);
    for (shift, root, form) in [(0.0, 410.0, 407.690), (0.12, 409.987, 407.358), (-0.12, 409.988, 407.945)] {
        let ring = ring.with_tool(shaper(30, shift, Some(1.25), 0.3)).unwrap();
        near(4.0 * ring.root_diameter(), root, 6e-4);
        near(4.0 * ring.form_diameter(), form, 6e-4);
    }
    let pair =
        Pair::without_backlash(gear(40, 0.0), ring.with_tool(shaper(30, 0.0, Some(1.25), 0.3)).unwrap())
            .unwrap();
    near(4.0 * pair.active_root_diameters()[1], 407.365, 6e-4);
    near(4.0 * ring.with_tool(Tool::Form { fillet: 0.3 }).unwrap().form_diameter(), 408.534, 6e-4);

    // Far shifted, the tips of its planets reach into the fillets, whichever addendum.
    let far = gear(-100, 1.0742);
    for (addendum, root, form, told) in
        [(Some(1.25), 399.749, 395.051, 1.25), (None, 401.406, 396.131, 1.4571)]
    {
        let ring = far.with_tool(shaper(30, 0.0, addendum, 0.3)).unwrap();
        near(4.0 * ring.root_diameter(), root, 6e-4);
        near(4.0 * ring.form_diameter(), form, 6e-4);
        near(ring.shaper_addendum().unwrap(), told, 6e-5);
        let pair = Pair::at_centre_distance(gear(40, -0.6077), ring, 118.0 / 4.0).unwrap();
        let needed = libm::hypot(
            ring.base_diameter(),
            2.0 * pair.mate(pair.gears()[0].curvature_radius(pair.gears()[0].tip_diameter())),
        );
        near(4.0 * needed, 398.661, 2e-2);
        assert!(needed > ring.form_diameter());
    }

    let of_iso53 = |profile| shaped(20, 0.3, Cutting::from(profile).of(Profile::default())).form_diameter();
    near(of_iso53(Iso53::A), 18.9936, 6e-5);
    near(of_iso53(Iso53::D), 18.8905, 6e-5);
    let pinion = gear(40, 0.2).with_tool(shaper(25, 0.0, Some(1.25), 0.25)).unwrap();
    near(pinion.root_diameter(), 37.8913, 6e-5);
    near(pinion.form_diameter(), 38.7800, 6e-5);
}

/// Of rings without shift the smallest whose tips a shaper leaves whole, and the planets whose tip circles
/// enclose that of their ring.
#[test]
fn shapers_and_planets_that_spoil_the_tips_of_rings() {
    let ring = |teeth: i32, cutter: u32| {
        let shaper = Shaper { addendum: Some(1.25), ..Shaper::of_teeth(ToothCount::new(cutter).unwrap()) };
        gear(-teeth, 0.0).with_tool(Tool::Shaper(shaper)).unwrap()
    };
    let room = |teeth: i32, cutter: u32| {
        let ring = ring(teeth, cutter);
        ring.cut().room(ring.flank(), ring.tip_diameter() / 2.0).unwrap()
    };
    for (cutter, least) in [(19, 86), (20, 64), (21, 53), (22, 46)] {
        assert!(room(least, cutter).flank >= 0.0 && room(least - 1, cutter).flank < 0.0, "{cutter}");
    }
    assert!(room(48, 30).radial >= 0.0 && room(47, 30).radial < 0.0);
    let trochoidal = |planet: i32, ring: i32| {
        let pair = Pair::without_backlash(gear(planet, 0.0), gear(-ring, 0.0)).unwrap();
        pair.interference().unwrap().trochoidal
    };
    for ring in [41, 42, 43, 44, 48] {
        assert!(trochoidal(40, ring) < 0.0, "{ring}");
    }
    assert_eq!([41, 42].map(|ring| trochoidal(40, ring)), [f64::NEG_INFINITY; 2]);
    assert!(trochoidal(40, 49) > 0.0);
}
