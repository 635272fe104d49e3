//! The structure of modes that the literature proves. Its printed frequencies are cases:
//! `spec-cases/planetary-vibration`.

use crate::common::{groups, hz, lin_parker, of_kind};
use epicyclic_vibration::Kind::{Mixed, Planet, Rotational, Translational};

#[test]
fn equally_spaced_sets_have_six_rotational_six_double_translational_and_three_planet_frequencies() {
    let planet_frequencies = of_kind(&groups(&lin_parker(4)), Planet);
    for planets in 3..=6 {
        let groups = groups(&lin_parker(planets));
        assert_eq!(of_kind(&groups, Rotational).iter().map(|mode| mode.1).collect::<Vec<_>>(), [1; 6]);
        assert_eq!(of_kind(&groups, Translational).iter().map(|mode| mode.1).collect::<Vec<_>>(), [2; 6]);
        assert!(of_kind(&groups, Mixed).is_empty());
        let planet = of_kind(&groups, Planet);
        if planets == 3 {
            assert!(planet.is_empty());
            continue;
        }
        assert_eq!(planet.len(), 3);
        for ((frequency, times), (of_four, _)) in planet.iter().zip(&planet_frequencies) {
            assert_eq!(*times, planets - 3);
            assert!((frequency / of_four - 1.0).abs() < 1e-11, "{frequency}, {of_four} of four planets");
        }
    }
}

#[test]
fn residuals_are_of_the_size_of_rounding() {
    for planets in 3..=6 {
        let (model, _) = lin_parker(planets).planar().unwrap();
        let modes = model.modes().unwrap();
        let worst = modes.modes.iter().map(|mode| mode.residual).fold(0.0, f64::max);
        assert!(worst < 5e-15, "{worst} of {planets} planets");
        assert_eq!(modes.modes.len(), model.size());
        assert_eq!(hz(modes.modes[0].frequency), 0.0);
        assert!(hz(modes.modes[1].frequency) > 100.0);
    }
}

#[test]
fn angles_not_equally_spaced_mix_the_kinds() {
    let mut set = lin_parker(4);
    set.planets[1].angle = crate::common::degrees(84.0);
    let groups = groups(&set);
    assert!(of_kind(&groups, Mixed).len() > 10, "{:?}", of_kind(&groups, Mixed));
    assert!(groups.iter().all(|group| group.multiplicity() == 1));
}

/// Planets opposite in pairs, 80° and 100° apart: the set is mapped to itself by a half turn, under which
/// rotation is even and translation odd.
#[test]
fn diametrically_opposed_planets_keep_rotation_and_translation_apart() {
    let mut set = lin_parker(4);
    for (planet, angle) in set.planets.iter_mut().zip([0.0, 80.0, 180.0, 260.0]) {
        planet.angle = crate::common::degrees(angle);
    }
    let groups = groups(&set);
    assert!(of_kind(&groups, Mixed).is_empty());
    let count = |kind| of_kind(&groups, kind).iter().map(|mode| mode.1).sum::<usize>();
    assert_eq!(count(Translational), 12);
    assert_eq!(count(Rotational) + count(Planet), 9);
    assert!(of_kind(&groups, Translational).iter().all(|mode| mode.1 == 1), "no frequency is double");
}
