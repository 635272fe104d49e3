//! Several sets in the plane on common links and centres: one set alone, rigid centres, kinds and their
//! numbers, order and angle of the sets.

use crate::common::{body, degrees, groups, hz, lin_parker, n_m};
use epicyclic_vibration::coupled::{Centre, CoupledParts, Placed, Shaft, planar};
use epicyclic_vibration::train::{Link, torsional};
use epicyclic_vibration::{Error, Group, Kind, Model, PlanetarySet, Support, train};
use uom::si::angle::radian;
use uom::si::f64::{Angle, Mass, MomentOfInertia, Torque};
use uom::si::length::meter;
use uom::si::torque::newton_meter;

fn links(count: usize, held: &[usize]) -> Vec<Link> {
    (0..count)
        .map(|index| Link {
            name: format!("link {index}"),
            inertia: MomentOfInertia::default(),
            support: Torque::default(),
            held: held.contains(&index),
        })
        .collect()
}

fn centres(count: usize, held: &[usize]) -> Vec<Centre> {
    (0..count)
        .map(|index| Centre {
            name: format!("centre {index}"),
            mass: Mass::default(),
            held: held.contains(&index),
        })
        .collect()
}

fn placed(name: &str, set: &PlanetarySet, links: [usize; 3], centres: [usize; 3]) -> Placed {
    let (links, centres) = (links.to_vec(), centres.to_vec());
    Placed { name: format!("{name} "), set: set.gear_set(), links, centres }
}

/// Frequencies with kind and multiplicity.
fn told(groups: &[Group]) -> Vec<(f64, Kind, usize)> {
    groups.iter().map(|group| (hz(group.frequency), group.kind, group.multiplicity())).collect()
}

fn same(one: &[(f64, Kind, usize)], other: &[(f64, Kind, usize)], tolerance: f64) {
    assert_eq!(one.len(), other.len(), "{one:?}\n{other:?}");
    for (one, other) in one.iter().zip(other) {
        assert!((one.0 - other.0).abs() <= tolerance * other.0.max(1.0), "{one:?} {other:?}");
        assert_eq!((one.1, one.2), (other.1, other.2), "{one:?} {other:?}");
    }
}

fn solved(model: &Model, parts: &CoupledParts) -> Vec<Group> {
    model.groups(&parts.central()).unwrap()
}

#[test]
fn one_set_on_its_own_links_and_centres_is_the_set() {
    for planets in 3..=6 {
        let set = lin_parker(planets);
        let wanted = told(&groups(&set));
        let mut links = links(3, &[]);
        // 1e9 N/m at the base radius of the ring.
        let radius = set.ring.body.radius.get::<meter>();
        links[1].support = Torque::new::<newton_meter>(1e9 * radius * radius);
        let sets = [placed("P", &set, [0, 1, 2], [0, 1, 2])];
        let (model, parts) = planar(&links, &centres(3, &[]), &sets, &[]).unwrap();
        same(&told(&solved(&model, &parts)), &wanted, 1e-9);
    }
}

/// Simpson's wiring: one sun, the ring of the first on the carrier of the second, which are one piece in the
/// plane, too.
const LINKS: [[usize; 3]; 2] = [[0, 1, 2], [0, 3, 1]];

fn second() -> PlanetarySet {
    let mut set = lin_parker(3);
    set.sun.body = body(0.7, 0.5, 0.05);
    set.carrier.body = body(6.5, 7.0, 0.12);
    for planet in &mut set.planets {
        planet.body = body(0.9, 0.8, 0.06);
        planet.sun_mesh = n_m(4e8);
    }
    set
}

fn simpson(first: &PlanetarySet, second: &PlanetarySet) -> (Model, CoupledParts) {
    let sets = [placed("1", first, LINKS[0], LINKS[0]), placed("2", second, LINKS[1], LINKS[1])];
    planar(&links(4, &[3]), &centres(4, &[]), &sets, &[]).unwrap()
}

#[test]
fn every_mode_is_of_one_kind_as_often_as_coordinates_say() {
    let (first, second) = (lin_parker(5), second());
    let (model, parts) = simpson(&first, &second);
    // Three links that turn, four centres, eight planets.
    assert_eq!(model.size(), 3 + 2 * 4 + 3 * 8);
    let groups = solved(&model, &parts);
    let count =
        |kind| groups.iter().filter(|group| group.kind == kind).map(Group::multiplicity).sum::<usize>();
    // Rotational: the links and three coordinates of the planets of each set; translational: twice the
    // centres and three of each set; planet: what is left.
    assert_eq!(count(Kind::Rotational), 3 + 2 * 3);
    assert_eq!(count(Kind::Translational), 2 * (4 + 2 * 3));
    assert_eq!(count(Kind::Planet), 3 * (5 - 3));
    assert_eq!(count(Kind::Mixed), 0);
    for group in &groups {
        let wanted = match group.kind {
            Kind::Rotational => 1,
            _ => 2,
        };
        assert_eq!(group.multiplicity(), wanted, "{:?} {}", group.kind, hz(group.frequency));
        let energy = model.modal_energy(group).unwrap();
        let kinetic: f64 = energy.kinetic.iter().map(|one| one.translation + one.rotation).sum();
        let strain: f64 = energy.strain.iter().map(|one| one.share).sum();
        assert!((kinetic - 1.0).abs() < 1e-9 && (group.is_zero() || (strain - 1.0).abs() < 1e-9));
        if group.kind == Kind::Planet {
            // Of the first set alone, with the frequencies of this set alone.
            let of_second = energy.kinetic.iter().filter(|one| parts.sets[1].planets.contains(&one.body));
            assert!(of_second.map(|one| one.translation + one.rotation).sum::<f64>() < 1e-12);
        }
    }
    let alone: Vec<_> = told(&self::groups(&first)).into_iter().filter(|one| one.1 == Kind::Planet).collect();
    let planet: Vec<_> = told(&groups).into_iter().filter(|one| one.1 == Kind::Planet).collect();
    same(&planet, &alone, 1e-9);
    // Two motions that bend nothing less one held ring: the gearbox keeps one freedom.
    assert_eq!(groups.iter().filter(|group| group.is_zero()).map(Group::multiplicity).sum::<usize>(), 1);
}

/// The set with its planets further on by an angle.
fn turned(set: &PlanetarySet, by: f64) -> PlanetarySet {
    let mut set = set.clone();
    for planet in &mut set.planets {
        let angle = (planet.angle.get::<radian>() + by).rem_euclid(std::f64::consts::TAU);
        planet.angle = Angle::new::<radian>(angle);
    }
    set
}

#[test]
fn neither_the_order_of_the_sets_nor_the_angle_between_them_matters() {
    let (first, second) = (lin_parker(5), second());
    let (model, parts) = simpson(&first, &second);
    let wanted = told(&solved(&model, &parts));
    for by in [0.1, 0.7, 1.3] {
        let other = turned(&second, by);
        let (model, parts) = simpson(&first, &other);
        same(&told(&solved(&model, &parts)), &wanted, 1e-9);
    }
    let sets = [placed("B", &second, LINKS[1], LINKS[1]), placed("A", &first, LINKS[0], LINKS[0])];
    let (model, parts) = planar(&links(4, &[3]), &centres(4, &[]), &sets, &[]).unwrap();
    same(&told(&solved(&model, &parts)), &wanted, 1e-9);
}

/// Two planets give a centre a different stiffness in each direction. One such set may have any angle to the
/// others; two may not.
#[test]
fn the_angle_between_two_sets_of_two_planets_matters() {
    let with_two = |set: &PlanetarySet, by: f64| {
        let mut two = set.clone();
        two.planets.truncate(2);
        two.planets[1].angle = degrees(180.0);
        turned(&two, by)
    };
    let of = |first: &PlanetarySet, second: &PlanetarySet| {
        let (model, parts) = simpson(first, second);
        told(&solved(&model, &parts))
    };
    let (first, second) = (lin_parker(4), second());
    let [one, other] = [0.0, 0.4].map(|by| of(&with_two(&first, by), &second));
    same(&one, &other, 1e-9);
    let [one, other] = [0.0, 0.4].map(|by| of(&with_two(&first, by), &with_two(&second, 0.0)));
    assert!(one.iter().zip(&other).any(|(one, other)| (one.0 - other.0).abs() > 1e-3 * other.0), "{one:?}");
}

#[test]
fn held_centres_and_rigid_bearings_leave_the_torsional_model() {
    let stiff = |set: &PlanetarySet, stiffness: f64| {
        let mut set = set.clone();
        for planet in &mut set.planets {
            planet.bearing = n_m(stiffness);
        }
        set
    };
    let (first, second) = (lin_parker(4), second());
    let sets = [("1", &first, LINKS[0]), ("2", &second, LINKS[1])];
    let of_train: Vec<train::Placed> = sets
        .iter()
        .map(|(name, set, links)| train::Placed {
            name: format!("{name} "),
            set: set.gear_set(),
            links: links.to_vec(),
        })
        .collect();
    let (model, _) = torsional(&links(4, &[3]), &of_train, &[]).unwrap();
    let wanted: Vec<f64> = model.modes().unwrap().modes.iter().map(|mode| hz(mode.frequency)).collect();
    let error = |bearing: f64, radial: Option<f64>| {
        let [first, second] = [&first, &second].map(|set| {
            let mut set = stiff(set, bearing);
            for central in [&mut set.sun, &mut set.ring, &mut set.carrier] {
                central.support = Support { radial: n_m(radial.unwrap_or(0.0)), tangential: n_m(0.0) };
            }
            set
        });
        let held: &[usize] = if radial.is_none() { &[0, 1, 2, 3] } else { &[] };
        let sets = [placed("1", &first, LINKS[0], LINKS[0]), placed("2", &second, LINKS[1], LINKS[1])];
        let (model, _) = planar(&links(4, &[3]), &centres(4, held), &sets, &[]).unwrap();
        let found = model.modes().unwrap().modes;
        let errors = found.iter().zip(&wanted).filter(|(_, wanted)| **wanted > 0.0);
        errors.map(|(found, wanted)| (hz(found.frequency) / wanted - 1.0).abs()).fold(0.0, f64::max)
    };
    // Held centres, and centres on supports as stiff; the error falls as the compliance.
    let [soft, hard] = [1e12, 1e13].map(|bearing| error(bearing, None));
    assert!(soft < 2e-3 && (libm::log10(soft / hard) - 1.0).abs() < 0.05, "{soft} {hard}");
    let [soft, hard] = [1e12, 1e13].map(|bearing| error(bearing, Some(bearing)));
    assert!(soft < 5e-3 && (libm::log10(soft / hard) - 1.0).abs() < 0.05, "{soft} {hard}");
}

/// A shaft as stiff as can be makes one link and one centre of two.
#[test]
fn a_rigid_shaft_makes_one_piece() {
    let (first, second) = (lin_parker(4), second());
    let joined = {
        let sets = [placed("1", &first, [0, 1, 2], [0, 1, 2]), placed("2", &second, [2, 3, 4], [2, 3, 4])];
        let (model, parts) = planar(&links(5, &[1, 3]), &centres(5, &[]), &sets, &[]).unwrap();
        told(&solved(&model, &parts))
    };
    let shaft = |stiffness: f64| {
        let sets = [placed("1", &first, [0, 1, 2], [0, 1, 2]), placed("2", &second, [5, 3, 4], [5, 3, 4])];
        let shaft = Shaft {
            name: "shaft".to_owned(),
            links: Some(([2, 5], Torque::new::<newton_meter>(stiffness))),
            centres: Some(([2, 5], n_m(stiffness))),
        };
        let (model, parts) = planar(&links(6, &[1, 3]), &centres(6, &[]), &sets, &[shaft]).unwrap();
        assert_eq!(parts.shafts[0].each_ref().map(Vec::len), [1, 2]);
        let found = told(&solved(&model, &parts));
        let pairs = joined.iter().zip(&found).filter(|(one, _)| one.0 > 0.0);
        pairs.map(|(one, other)| (one.0 / other.0 - 1.0).abs()).fold(0.0, f64::max)
    };
    let [soft, hard] = [1e12, 1e13].map(shaft);
    assert!(soft < 1e-2 && (libm::log10(soft / hard) - 1.0).abs() < 0.05, "{soft} {hard}");
}

#[test]
fn places_of_no_link_or_centre_and_centres_without_mass_are_refused() {
    let set = lin_parker(3);
    let of = |links_of: [usize; 3], centres_of: [usize; 3], count: usize| {
        let sets = [placed("P", &set, links_of, centres_of)];
        planar(&links(3, &[]), &centres(count, &[]), &sets, &[]).unwrap_err()
    };
    assert_eq!(of([0, 1, 3], [0, 1, 2], 3), Error::NoSuchBody { index: 3, count: 3 });
    assert_eq!(of([0, 1, 2], [0, 1, 4], 3), Error::NoSuchBody { index: 4, count: 3 });
    let fault = of([0, 1, 2], [0, 1, 2], 4);
    assert!(matches!(&fault, Error::NotPositive { field, .. } if field == "mass of centre 3"), "{fault}");
    let shaft = Shaft { name: "s".to_owned(), links: None, centres: Some(([0, 9], n_m(1.0))) };
    let sets = [placed("P", &set, [0, 1, 2], [0, 1, 2])];
    let fault = planar(&links(3, &[]), &centres(3, &[]), &sets, &[shaft]).unwrap_err();
    assert_eq!(fault, Error::NoSuchBody { index: 9, count: 3 });
}
