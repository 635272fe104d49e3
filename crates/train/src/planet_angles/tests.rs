use super::*;
use crate::Gearbox;
use crate::set::{SetKind, SetSpec};
use epicyclic_gears::ToothCount;
use epicyclic_gears::rack::BasicRack;
use epicyclic_units::Physical;
use proptest::prelude::*;
use uom::si::f64::Angle;

fn built(spec: SetSpec) -> Result<PlanetSet, Error> {
    let gearbox = Gearbox::builder("one").links(["s", "H"]).set(spec).input("s").output("H").build()?;
    Ok(gearbox.sets()[0].clone())
}

fn simple(sun: u32, ring: u32) -> SetSpec {
    SetSpec::teeth("P", SetKind::Simple, ["s", "ground", "H"], sun, ring).unwrap()
}

fn double(sun: u32, inner: u32, outer: u32, ring: u32) -> SetSpec {
    let [inner, outer] = [inner, outer].map(|teeth| ToothCount::new(teeth).unwrap());
    SetSpec::teeth("P", SetKind::DoublePlanet, ["s", "ground", "H"], sun, ring)
        .unwrap()
        .planet_teeth(inner, Some(outer))
}

fn at(degrees_of: &[f64]) -> Spacing {
    Spacing::At(degrees_of.iter().map(|angle| Angle::from_degrees(*angle)).collect())
}

/// Phase, in teeth, that the teeth of the sun and of the ring require of a planet of a simple set at an angle
/// in turns. A planet at 0 has phase 0 in both. Independent of the code under test: it counts teeth along the
/// pitch circles, without any divisor.
fn phases([sun, ring]: [f64; 2], turn: f64) -> [f64; 2] {
    [-sun * turn, ring * turn]
}

proptest! {
    /// A planet fits if both meshes require the same phase of it, up to whole teeth, and only then.
    #[test]
    fn planets_fit_where_both_meshes_ask_for_one_phase(sun in 12..60_u32, planet in 12..60_u32, steps in 1..400_u32, beside in 0.1..0.9_f64) {
        let ring = sun + 2 * planet;
        let fits = |turn: f64| {
            let [one, other] = phases([f64::from(sun), f64::from(ring)], turn);
            let apart = (one - other).rem_euclid(1.0);
            apart.min(1.0 - apart) < 1e-6
        };
        let positions = f64::from(sun + ring);
        for place in [f64::from(steps % (sun + ring - 1) + 1), f64::from(steps % (sun + ring - 1)) + beside] {
            let set = built(simple(sun, ring).spaced(at(&[0.0, 360.0 * place / positions]))).unwrap();
            prop_assert_eq!(set.misplaced().is_empty(), fits(place / positions), "{}", place);
            let fit = set.planet_fit(&BasicRack::default());
            prop_assert_eq!(fit.assembles, Some(fits(place / positions)));
        }
    }

    /// Angles without any order or zero, rounded to a hundredth of a degree, are the same set.
    #[test]
    fn rounding_turning_and_order_change_nothing(sun in 12..40_u32, planet in 12..40_u32, planets in 2..6_u32, turn in -400.0..400.0_f64, shift in 0..6_usize) {
        let ring = sun + 2 * planet;
        let spec = || simple(sun, ring).planet_count(planets);
        let least = built(spec().spaced(Spacing::Placed(Placement::LeastUnequal))).unwrap();
        let mut angles: Vec<f64> = least.planet_angles().unwrap().iter().map(|one| one.si().to_degrees()).collect();
        let turned = |one: &f64| ((one + turn) * 100.0).round() / 100.0;
        angles.rotate_left(shift % planets as usize);
        let given = built(spec().spaced(at(&angles.iter().map(turned).collect::<Vec<_>>()))).unwrap();
        prop_assert!(given.misplaced().is_empty(), "{:?}", given.misplaced());
        let rack = BasicRack::default();
        prop_assert_eq!(given.planet_fit(&rack), least.planet_fit(&rack));
        let [one, other] = [&given, &least].map(|set| set.least_planet_angle().unwrap().si());
        prop_assert!((one - other).abs() < 1e-12, "{} {}", one, other);
    }

    /// Neighbours clear where no two tip circles overlap: every pair of planets, their centres as points.
    #[test]
    fn the_nearest_two_planets_decide_whether_they_clear(sun in 14..40_u32, planet in 14..60_u32, places in prop::collection::btree_set(1..200_u32, 1..5)) {
        let ring = sun + 2 * planet;
        let positions = sun + ring;
        let turns: std::collections::BTreeSet<u32> = places.iter().map(|place| place % positions).chain([0]).collect();
        let angles: Vec<f64> = turns.iter().map(|place| 360.0 * f64::from(*place) / f64::from(positions)).collect();
        prop_assume!(angles.len() > 1);
        let set = built(simple(sun, ring).spaced(at(&angles))).unwrap();
        let radius = f64::from(sun + planet) / 2.0;
        let centre = |angle: f64| (radius * libm::cos(angle.to_radians()), radius * libm::sin(angle.to_radians()));
        let mut nearest = f64::INFINITY;
        for (place, one) in angles.iter().enumerate() {
            for other in &angles[..place] {
                let ((x, y), (u, v)) = (centre(*one), centre(*other));
                nearest = nearest.min(libm::hypot(x - u, y - v));
            }
        }
        prop_assume!((nearest - f64::from(planet + 2)).abs() > 1e-6);
        prop_assert_eq!(set.planet_fit(&BasicRack::default()).clears, Some(nearest > f64::from(planet + 2)));
        // The same with shifts of 0, which are checked by their involutes.
        let planet = ToothCount::new(planet).unwrap();
        let shifted = simple(sun, ring).planet_teeth(planet, None).shifted(Default::default()).spaced(at(&angles));
        prop_assert_eq!(built(shifted).unwrap().planet_fit(&BasicRack::default()).clears, Some(nearest > planet.as_f64() + 2.0));
    }
}

/// Assembly positions of a double planet, which do not follow from the phase of one planet: every angle of a
/// fine grid is tried on both rows of teeth.
#[test]
fn a_pair_of_planets_fits_at_the_difference_of_the_teeth() {
    let set = built(double(24, 16, 17, 84).planet_count(3)).unwrap();
    assert_eq!(set.assembly_positions(), Some(60));
    let misplaced =
        |angle: f64| !built(double(24, 16, 17, 84).spaced(at(&[0.0, angle]))).unwrap().misplaced().is_empty();
    assert!(!misplaced(126.0) && misplaced(123.0));
}

#[test]
fn what_is_misplaced_is_named_with_the_nearest_position() {
    let set = simple(26, 96).spaced(at(&[10.0, 98.5, 190.0, 281.0]));
    let gearbox = Gearbox::builder("q").links(["s", "H"]).set(set).input("s").output("H").build().unwrap();
    let told: Vec<String> = gearbox
        .tooth_checks(&BasicRack::default())
        .iter()
        .map(ToString::to_string)
        .filter(|one| one.contains("assembled"))
        .collect();
    assert_eq!(
        told,
        [
            "set `P`: planet 4 cannot be assembled at 271 deg from the first: its teeth fit at multiples of 360/122 deg, the nearest 271.4754 deg"
        ]
    );
}

#[test]
fn spacings_that_no_set_has_are_refused() {
    for (spec, message) in [
        (simple(26, 96).planet_count(3).spaced(at(&[0.0, 90.0])), "2 planet angles are given for 3 planets"),
        (simple(26, 96).spaced(at(&[0.0, 90.0, 450.0])), "planets 2 and 3 have the same angle"),
        (simple(26, 96).spaced(at(&[0.0, f64::NAN])), "the angle of planet 2 is not finite"),
        (simple(26, 96).spaced(Spacing::Placed(Placement::LeastUnequal)), "needs the number of planets"),
        (
            SetSpec::simple("P", ["s", "ground", "H"], 3.0)
                .planet_count(3)
                .spaced(Spacing::Placed(Placement::LeastUnequal)),
            "needs the number of planets and the teeth",
        ),
    ] {
        let error = built(spec).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
}
