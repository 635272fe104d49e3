//! Orders of excitation of a set in a gear, in coordinates on the carrier.
//!
//! In these coordinates planets are at rest, and parts that turn with the sun or the ring pass them. With the
//! speeds `n` of the members:
//!
//! | source | frequency | periods a turn `p` |
//! |---|---|---|
//! | harmonic `l` of the meshes | `l·z_s·|n_s − n_c| = l·z_r·|n_r − n_c|` | `l·z_s` |
//! | a turn of the sun, of the ring | `|n_s − n_c|`, `|n_r − n_c|` | 1 |
//! | `N` planets that pass a place of sun or ring | `N·|n_s − n_c|`, `N·|n_r − n_c|` | `N` |
//! | a turn of a planet | `|n_p − n_c|` | each planet has its own phase |
//!
//! The modes that `p` excites are given by [`phasing`] for equally spaced planets; with other spacings it may
//! excite all. A planet turns `z_s/z_p` times as fast on the carrier as the sun.

use super::records::{Order, Source};
use epicyclic_vibration::phasing;

/// Lists the orders whose frequency is not 0, harmonics of the meshes last.
pub(super) fn all(
    set: &str,
    gear: &str,
    [sun_teeth, planet_teeth, _]: [u32; 3],
    planets: u32,
    is_equally_spaced: bool,
    [sun, ring, carrier]: [f64; 3],
    harmonics: u32,
) -> Vec<Order> {
    let excited = |periods: u64| phasing::excited(periods, planets).ok().filter(|_| is_equally_spaced);
    let [of_sun, of_ring] = [sun - carrier, ring - carrier].map(f64::abs);
    let of_teeth = f64::from(sun_teeth) * of_sun;
    let mut orders = vec![
        (Source::SunTurn, 1, of_sun, excited(1)),
        (Source::RingTurn, 1, of_ring, excited(1)),
        (Source::PlanetTurn, 1, of_teeth / f64::from(planet_teeth), None),
        (Source::SunPlanetPass, 1, f64::from(planets) * of_sun, excited(planets.into())),
        (Source::RingPlanetPass, 1, f64::from(planets) * of_ring, excited(planets.into())),
    ];
    orders.extend((1..=harmonics).map(|harmonic| {
        let excites = excited(u64::from(harmonic) * u64::from(sun_teeth));
        (Source::Mesh, harmonic, f64::from(harmonic) * of_teeth, excites)
    }));
    let turns = orders.into_iter().filter(|(_, _, of_input, _)| *of_input > crate::tolerance::ROUNDED);
    turns
        .map(|(source, harmonic, of_input, excites)| Order {
            set: set.to_owned(),
            gear: gear.to_owned(),
            source,
            harmonic,
            of_input,
            excites,
        })
        .collect()
}
