//! Sets of any kind: pairs, stepped planets, planets in mesh.

use crate::common::{body, degrees, hz, n_m};
use epicyclic_vibration::{
    BodyOf, Central, Error, Gear, GearMesh, GearSet, Member, Model, PlanetBody, Support,
};
use proptest::prelude::*;
use uom::si::angle::radian;
use uom::si::f64::{Angle, Length};
use uom::si::length::meter;

const ALPHA: f64 = 20.0;

fn meters(value: f64) -> Length {
    Length::new::<meter>(value)
}

/// Base radius of a gear of so many teeth, of modules of 4 mm.
fn base(teeth: u32) -> f64 {
    0.002 * f64::from(teeth) * libm::cos(ALPHA.to_radians())
}

fn member(name: &str, teeth: u32, support: f64) -> Member {
    let support = Support { radial: n_m(support), tangential: n_m(0.0) };
    Member { name: name.to_owned(), central: Central::new(body(3.0, 2.0, base(teeth)), support) }
}

fn gear(of: BodyOf, teeth: u32, is_internal: bool) -> Gear {
    Gear { of, base_radius: meters(base(teeth)), is_internal }
}

fn mesh(gears: [Gear; 2], stiffness: f64, is_forward: bool) -> GearMesh {
    GearMesh { gears, stiffness: n_m(stiffness), pressure_angle: degrees(ALPHA), is_forward }
}

fn pair(teeth: [u32; 2], is_internal: bool, support: f64) -> GearSet {
    let [one, other] =
        [0, 1].map(|place| gear(BodyOf::Member(place), teeth[place], is_internal && place == 1));
    GearSet {
        members: vec![member("gear 1", teeth[0], support), member("gear 2", teeth[1], support)],
        meshes: vec![mesh([one, other], 5e8, true)],
        ..GearSet::default()
    }
}

/// A set of planets with two gears each, or of two planets in mesh: a sun, a ring, a carrier.
fn planetary(sun: u32, steps: [u32; 2], planets: u32, is_stepped: bool, forward: [bool; 3]) -> GearSet {
    let mut set = GearSet { carrier: Some(2), ..GearSet::default() };
    let [first, second] = steps;
    let r_1 = 0.002 * f64::from(sun + first);
    // The second gear of a stepped planet has the ring that its place requires.
    let ring = if is_stepped { sun + first + second } else { sun + first + second + 8 };
    let r_2 = 0.002 * f64::from(ring - second);
    let apart = 0.002 * f64::from(first + second);
    let ahead = libm::acos((r_1 * r_1 + r_2 * r_2 - apart * apart) / (2.0 * r_1 * r_2));
    set.members = vec![member("sun", sun, 2e7), member("ring", ring, 3e8), member("carrier", sun, 2e8)];
    set.members[2].central.body.radius = meters(r_1);
    for place in 0..planets {
        let at = std::f64::consts::TAU * f64::from(place) / f64::from(planets);
        let planet = |name: &str, teeth, distance, angle: f64| PlanetBody {
            name: format!("{name} {}", place + 1),
            body: body(0.7, 0.5, base(teeth)),
            distance: meters(distance),
            angle: Angle::new::<radian>(angle.rem_euclid(std::f64::consts::TAU)),
            bearing: n_m(3e8),
        };
        let own = set.planets.len();
        set.planets.push(planet("planet", first, r_1, at));
        let mut last = own;
        let of_sun = [gear(BodyOf::Member(0), sun, false), gear(BodyOf::Planet(own), first, false)];
        set.meshes.push(mesh(of_sun, 5e8, forward[0]));
        if !is_stepped {
            last += 1;
            set.planets.push(planet("second", second, r_2, at + ahead));
            let between =
                [gear(BodyOf::Planet(own), first, false), gear(BodyOf::Planet(last), second, false)];
            set.meshes.push(mesh(between, 4e8, forward[1]));
        }
        // A planet may stand before or after its ring.
        let of_ring = [gear(BodyOf::Member(1), ring, true), gear(BodyOf::Planet(last), second, false)];
        set.meshes.push(mesh(of_ring, 6e8, forward[2]));
    }
    set
}

fn frequencies(model: &Model) -> Vec<f64> {
    model.modes().unwrap().modes.iter().map(|mode| hz(mode.frequency)).collect()
}

/// `ω² = k·(1/m_1 + 1/m_2)` with the rotary masses of two gears; on rigid supports the planar modes are
/// these.
#[test]
fn a_pair_is_two_masses_on_a_spring() {
    for is_internal in [false, true] {
        let wanted = libm::sqrt(5e8 * (0.5 + 0.5)) / std::f64::consts::TAU;
        let set = pair([20, 60], is_internal, 1e7);
        let found = frequencies(&set.torsional().unwrap().0);
        assert!(found[0] == 0.0 && (found[1] / wanted - 1.0).abs() < 1e-12, "{found:?}");
        let held = frequencies(&pair([20, 60], is_internal, 1e14).planar().unwrap().0);
        assert!((held[1] / wanted - 1.0).abs() < 1e-5, "{held:?}");
        // One mesh alone bends in one way: all other motions of six coordinates are free.
        let free = frequencies(&pair([20, 60], is_internal, 0.0).planar().unwrap().0);
        assert_eq!(free.iter().filter(|frequency| **frequency == 0.0).count(), 5);
    }
}

/// A ring that is named first or last is the same mesh.
#[test]
fn the_order_of_the_gears_of_a_mesh_does_not_matter() {
    let set = planetary(24, [20, 20], 4, true, [true; 3]);
    let mut turned = set.clone();
    for mesh in turned.meshes.iter_mut().filter(|mesh| mesh.gears[0].is_internal) {
        mesh.gears.reverse();
        // A gear in its ring is driven the way in which the ring turns.
        mesh.is_forward = !mesh.is_forward;
    }
    for mesh in turned.meshes.iter_mut().filter(|mesh| !mesh.gears[1].is_internal) {
        mesh.gears.reverse();
    }
    let [one, other] = [set, turned].map(|set| frequencies(&set.planar().unwrap().0));
    for (one, other) in one.iter().zip(&other) {
        assert!((one - other).abs() <= 1e-9 * one, "{one} {other}");
    }
}

#[test]
fn places_of_no_body_are_refused() {
    let mut set = pair([20, 60], false, 1e7);
    set.meshes[0].gears[1].of = BodyOf::Planet(0);
    assert_eq!(set.planar().unwrap_err(), Error::NoSuchBody { index: 0, count: 0 });
    set.meshes[0].gears[1].of = BodyOf::Member(2);
    assert_eq!(set.planar().unwrap_err(), Error::NoSuchBody { index: 2, count: 2 });
    let mut set = planetary(24, [20, 20], 3, true, [true; 3]);
    set.planets[1].angle = set.planets[0].angle;
    assert_eq!(set.planar().unwrap_err(), Error::SameAngle { first: 1, second: 2 });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// The stiffness is symmetric; what all turn as one and what the gears turn by their ratios bends
    /// nothing, and no other motion does; a mirror image has the same frequencies.
    #[test]
    fn sets_of_any_kind_keep_two_motions(
        sun in 18..30_u32, first in 17..26_u32, second in 17..26_u32, planets in 3..6_u32,
        is_stepped: bool, forward: [bool; 3],
    ) {
        let set = planetary(sun, [first, second], planets, is_stepped, forward);
        let (planar, parts) = set.planar().unwrap();
        let matrix = planar.stiffness_matrix_n_per_m();
        for (row, values) in matrix.iter().enumerate() {
            for (column, value) in values.iter().enumerate() {
                prop_assert_eq!(*value, matrix[column][row]);
            }
        }
        let all = frequencies(&planar);
        prop_assert_eq!(all.iter().filter(|frequency| **frequency == 0.0).count(), 2);
        for group in planar.groups(&parts.members).unwrap() {
            let energy = planar.modal_energy(&group).unwrap();
            let strain: f64 = energy.strain.iter().map(|one| one.share).sum();
            prop_assert!(group.is_zero() || (strain - 1.0).abs() < 1e-9);
        }
        let torsional = frequencies(&set.torsional().unwrap().0);
        prop_assert_eq!(torsional.iter().filter(|frequency| **frequency == 0.0).count(), 2);
        let mut mirrored = set.clone();
        for planet in &mut mirrored.planets {
            planet.angle = -planet.angle;
        }
        for mesh in &mut mirrored.meshes {
            mesh.is_forward = !mesh.is_forward;
        }
        for (one, other) in all.iter().zip(&frequencies(&mirrored.planar().unwrap().0)) {
            prop_assert!((one - other).abs() <= 1e-8 * one.max(1.0), "{one} {other}");
        }
    }
}
