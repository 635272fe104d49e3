//! Rolling elements between the pin and the bore of the planet itself, without rings of their own.
//!
//! Their load ratings follow from their dimensions:
//!
//! ```text
//! C   = b_m·f_c·(i·L_we)^(7/9)·Z^(3/4)·D_we^(29/27)                    ISO 281, in N and mm
//! f_c = 208·0.83·γ^(2/9)·(1 − γ)^(29/27)/(1 + γ)^(1/4)
//!       · (1 + (1.04·((1 − γ)/(1 + γ))^(143/108))^(9/2))^(−2/9)           ISO/TR 1281-1
//! C_0 = 44·(1 − γ)·i·Z·L_we·D_we                                          ISO 76
//! γ   = D_we/D_pw,   D_pw = d + D_we,   bore of the planet d + 2·D_we
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | `D_we`, `L_we` | diameter of an element, length of its contact |
//! | `Z`, `i` | elements of a row, rows |
//! | `d` | diameter of the pin |
//! | `b_m` | 1.1 for today's steel, both raceways hardened and ground |
//!
//! # Elements
//! Diameters are those of needles and cylindrical rollers that are sold. Their number follows from their
//! spacing along the pitch circle: 1.8 diameters for needles in a cage, 1.3 for rollers in a cage, their own
//! diameter without one. A maker's cage may hold others: the rating of the chosen one counts.

use super::bearing::Bearing;
use epicyclic_gears::life::Rolling;
use epicyclic_units::Physical;
use std::f64::consts::PI;
use std::sync::LazyLock;
use uom::si::f64::{Force, Length};

/// Factor `b_m` for cylindrical rollers and needles on ground raceways.
const STEEL: f64 = 1.1;

/// Reduction for load peaks at the ends of rollers, `λ·ν`.
const EDGES: f64 = 0.83;

/// Length that washers and the rims of a cage take, in mm.
const ENDS_MM: f64 = 2.0;

/// Length that the roundings of an element take, in its diameters.
const ROUNDINGS: f64 = 0.2;

/// `f_c` by `γ = D_we/D_pw`.
///
/// ```
/// use epicyclic_strength::sizing::in_bore::geometry_factor;
///
/// // ISO 281, table of f_c for radial roller bearings: 84.2 at 0.1, 88.7 at 0.2.
/// assert!((geometry_factor(0.1) - 84.2).abs() < 0.2);
/// assert!((geometry_factor(0.2) - 88.7).abs() < 0.2);
/// ```
#[must_use]
pub fn geometry_factor(gamma: f64) -> f64 {
    let ratio = (1.0 - gamma) / (1.0 + gamma);
    let races = libm::pow(1.04 * libm::pow(ratio, 143.0 / 108.0), 4.5);
    208.0 * EDGES * libm::pow(gamma, 2.0 / 9.0) * libm::pow(1.0 - gamma, 29.0 / 27.0)
        / libm::pow(1.0 + gamma, 0.25)
        * libm::pow(1.0 + races, -2.0 / 9.0)
}

/// Load ratings `C` and `C_0` of one row of elements in N, by the diameters of element and pin and the length
/// of contact in mm.
#[must_use]
pub fn ratings(element: f64, pin: f64, contact: f64, count: u32) -> [f64; 2] {
    let gamma = element / (pin + element);
    let count = f64::from(count);
    let dynamic = STEEL
        * geometry_factor(gamma)
        * libm::pow(contact, 7.0 / 9.0)
        * libm::pow(count, 0.75)
        * libm::pow(element, 29.0 / 27.0);
    [dynamic, 44.0 * (1.0 - gamma) * count * contact * element]
}

/// A family of elements to choose from.
struct Family {
    /// Diameters of the elements in mm.
    elements: &'static [f64],
    /// Diameters of pins in those of their elements.
    pins: &'static [f64],
    /// Lengths of elements in their diameters.
    lengths: &'static [f64],
    /// Distance of neighbouring elements along the pitch circle, in their diameters.
    spacing: f64,
}

const ROLLERS_MM: &[f64] = &[
    5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 25.0, 28.0, 32.0, 36.0, 40.0, 45.0,
    50.0, 60.0, 70.0, 80.0,
];

/// Elements of one kind in bores of many sizes, by bore and width; none of balls and of plain bearings.
#[must_use]
pub fn listed(rolling: Rolling) -> &'static [Bearing] {
    static ALL: LazyLock<[Vec<Bearing>; 3]> = LazyLock::new(|| {
        [Rolling::Rollers, Rolling::Needles, Rolling::FullComplement]
            .map(|rolling| made(rolling, &family(rolling)))
    });
    match rolling {
        Rolling::Balls | Rolling::Plain => &[],
        Rolling::Rollers => &ALL[0],
        Rolling::Needles => &ALL[1],
        Rolling::FullComplement => &ALL[2],
    }
}

const fn family(rolling: Rolling) -> Family {
    match rolling {
        Rolling::Needles => Family {
            elements: &[1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0],
            pins: &[5.0, 6.0, 7.0, 8.0, 10.0],
            lengths: &[3.0, 4.0, 5.0, 6.0, 8.0],
            spacing: 1.8,
        },
        Rolling::FullComplement => Family {
            elements: ROLLERS_MM,
            pins: &[3.5, 4.5, 6.0, 8.0],
            lengths: &[1.0, 1.5, 2.0, 3.0],
            spacing: 1.0,
        },
        Rolling::Rollers | Rolling::Balls | Rolling::Plain => {
            Family { elements: ROLLERS_MM, pins: &[3.5, 4.5, 6.0], lengths: &[1.0, 1.5, 2.0], spacing: 1.3 }
        }
    }
}

fn made(rolling: Rolling, family: &Family) -> Vec<Bearing> {
    let mut all = vec![];
    for element in family.elements {
        for pin in family.pins.iter().map(|pin| (pin * element).round()) {
            // Elements side by side touch along a chord, not along the arc.
            let angle = 2.0 * libm::asin(element / (pin + element)) * family.spacing;
            let count = (2.0 * PI / angle) as u32;
            for length in family.lengths.iter().map(|length| length * element) {
                let [dynamic, fixed] = ratings(*element, pin, length - ROUNDINGS * element, count);
                all.push(Bearing {
                    designation: format!("{count} x {element}x{length} on {pin}"),
                    rolling,
                    bore: Length::from_mm(pin),
                    outside_diameter: Length::from_mm(pin + 2.0 * element),
                    width: Length::from_mm(length + ENDS_MM),
                    rows: 1,
                    load_rating: Force::from_si(dynamic),
                    static_load_rating: Some(Force::from_si(fixed)),
                });
            }
        }
    }
    let key = |bearing: &Bearing| [bearing.outside_diameter, bearing.width].map(Physical::si);
    all.sort_by(|one, other| key(one).partial_cmp(&key(other)).expect("lengths are numbers"));
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `f_c` as ISO 281 prints it for radial roller bearings.
    #[test]
    fn the_factor_is_that_of_the_standards_table() {
        let printed = [
            (0.01, 52.1),
            (0.02, 60.8),
            (0.04, 70.7),
            (0.06, 76.9),
            (0.08, 81.2),
            (0.12, 86.4),
            (0.16, 88.5),
            (0.24, 87.5),
            (0.30, 83.8),
        ];
        for (gamma, factor) in printed {
            assert!(
                (geometry_factor(gamma) / factor - 1.0).abs() < 0.006,
                "{gamma}: {}",
                geometry_factor(gamma)
            );
        }
    }

    /// Rollers of the size that fills a catalogue's bearing bear what its maker states, within a tenth and a
    /// half: makers' cages and rollers differ.
    #[test]
    fn a_bearing_of_the_catalogue_comes_out() {
        // NJ 205: 13 rollers of 7.5 x 9 mm on 31 mm; NJ 2309: 12 rollers of 15 x 24 on 58.5.
        for (designation, [element, pin, contact], count) in
            [("NJ 205", [7.5, 31.0, 8.0], 13), ("NJ 2309", [15.0, 58.5, 22.0], 12)]
        {
            let listed = super::super::bearing::listed_rollers();
            let of_maker = listed.iter().find(|one| one.designation == designation).unwrap();
            let [dynamic, fixed] = ratings(element, pin, contact, count);
            let fixed_of_maker = of_maker.static_load_rating.unwrap().si();
            for [own, of_maker] in [[dynamic, of_maker.load_rating.si()], [fixed, fixed_of_maker]] {
                assert!((own / of_maker - 1.0).abs() < 0.15, "{designation}: {own}, {of_maker}");
            }
        }
    }

    #[test]
    fn elements_have_room_on_their_pitch_circle() {
        for rolling in Rolling::ALL {
            for one in listed(rolling) {
                let [pin, bore] = [one.bore, one.outside_diameter].map(Physical::mm);
                let (element, pitch) = ((bore - pin) / 2.0, f64::midpoint(pin, bore));
                let count: f64 = one.designation.split(' ').next().unwrap().parse().unwrap();
                let chord = pitch * libm::sin(PI / count);
                assert!(chord >= element * (1.0 - 1e-12), "{one:?}");
                assert_eq!(one.rolling, rolling);
            }
        }
        assert!(listed(Rolling::Balls).is_empty());
    }
}
