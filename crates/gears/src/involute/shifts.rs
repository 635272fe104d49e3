//! Profile shifts that follow from stated centre distances.
//!
//! A mesh without backlash at the centre distance `a` fixes the sum of the shifts of its gears:
//!
//! ```text
//! x_1 + x_2 = (z_1 + z_2)·(inv α_wt − inv α_t)/(2·tan α_n)    cos α_wt = (z_1 + z_2)·m_t·cos α_t/(2·a)
//! ```
//!
//! with the teeth of an internal gear below 0, and its shift above 0 where its tips move inwards. A stated
//! shift gives that of the other gear, and with it the next mesh of that gear has one open shift less: of
//! sun, planets and ring at one distance a single shift decides all. Angles in rad, lengths in modules of the
//! mesh. Source: ISO 21771-1, working transverse pressure angle; the errors are those of [`Pair::shift_sum`].

use super::{InvoluteGear, Pair};
use crate::Error;

/// How far stated shifts may be from the sum that their centre distance requires: as if printed with three
/// decimals.
const AGREES: f64 = 1e-3;

/// Mesh at a stated centre distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatedDistance {
    /// Indices of its gears, an internal one second.
    pub gears: [usize; 2],
    /// Centre distance in modules of the mesh.
    pub distance: f64,
}

/// Why shifts do not follow from centre distances.
#[derive(Debug, Clone, PartialEq)]
pub enum Unclosed {
    /// Neither shift of a mesh is stated, nor follows from another mesh.
    Open {
        /// Index of the mesh.
        mesh: usize,
        /// Sum of both shifts.
        sum: f64,
    },
    /// A mesh whose shifts, stated or from other meshes, contradict its centre distance.
    Fixed {
        /// Index of the mesh.
        mesh: usize,
        /// Sum of both shifts that its centre distance requires.
        required: f64,
        /// Sum of both shifts.
        sum: f64,
    },
    /// A mesh that cannot be.
    Refused {
        /// Index of the mesh.
        mesh: usize,
        /// Why.
        error: Error,
    },
}

/// Shifts of gears whose meshes have stated centre distances. `shifts` are the stated ones; an open one that
/// no mesh with a stated distance decides is 0. Of the gears the own shifts do not matter.
///
/// ```
/// use epicyclic_gears::involute::shifts::{StatedDistance, closing_shifts};
/// use epicyclic_gears::involute::{InvoluteGear, Profile};
/// use epicyclic_gears::{ToothCount, geometry::GearKind};
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let gear = |teeth| InvoluteGear::new(GearKind::External, ToothCount::new(teeth)?, Profile::default(), 0.0);
/// let gears = [gear(57)?, gear(54)?];
/// let mesh = StatedDistance { gears: [0, 1], distance: 155.0 / 2.75 };
/// let shifts = closing_shifts(&gears, &[None, Some(0.45)], &[mesh]).unwrap();
/// assert!((shifts[0] - 0.4618).abs() < 5e-5);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Unclosed`].
pub fn closing_shifts(
    gears: &[InvoluteGear],
    shifts: &[Option<f64>],
    meshes: &[StatedDistance],
) -> Result<Vec<f64>, Unclosed> {
    let mut known = shifts.to_vec();
    known.resize(gears.len(), None);
    let sum = |mesh: usize| {
        let StatedDistance { gears: [first, second], distance } = meshes[mesh];
        let sum = Pair::shift_sum(&gears[first], &gears[second], distance);
        sum.map_err(|error| Unclosed::Refused { mesh, error })
    };
    let mut open: Vec<usize> = (0..meshes.len()).collect();
    while !open.is_empty() {
        let count = |mesh: usize| meshes[mesh].gears.iter().filter(|gear| known[**gear].is_none()).count();
        // A mesh with two open shifts waits for a neighbour to decide one.
        let Some(place) = open.iter().position(|mesh| count(*mesh) < 2) else {
            return Err(Unclosed::Open { mesh: open[0], sum: sum(open[0])? });
        };
        let mesh = open.remove(place);
        let required = sum(mesh)?;
        let ends = meshes[mesh].gears;
        match ends.map(|gear| known[gear]) {
            [Some(one), Some(other)] if (one + other - required).abs() > AGREES => {
                return Err(Unclosed::Fixed { mesh, required, sum: one + other });
            }
            [Some(_), Some(_)] => {}
            [first, second] => {
                let follows = required - first.or(second).unwrap_or_default();
                known[ends[usize::from(first.is_some())]] = Some(follows);
            }
        }
    }
    Ok(known.into_iter().map(Option::unwrap_or_default).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ToothCount;
    use crate::geometry::GearKind;
    use crate::involute::Profile;
    use proptest::prelude::*;

    fn gear(kind: GearKind, teeth: u32) -> InvoluteGear {
        InvoluteGear::searched(kind, ToothCount::new(teeth).unwrap(), Profile::default()).unwrap()
    }

    /// A twin-rotor stage of the literature: 57 and 54 teeth of 2.75 mm, 18 and 107 of 3.5 mm, at 155 mm.
    #[test]
    fn one_stated_shift_decides_a_published_stage() {
        let gears = [gear(GearKind::External, 18), gear(GearKind::Internal, 107)];
        let mesh = StatedDistance { gears: [0, 1], distance: 155.0 / 3.5 };
        let shifts = closing_shifts(&gears, &[Some(0.5038)], &[mesh]).unwrap();
        assert!((shifts[1] + 0.2935).abs() < 5e-5, "{shifts:?}");
        let open = closing_shifts(&gears, &[], &[mesh]).unwrap_err();
        assert!(matches!(open, Unclosed::Open { mesh: 0, sum } if (sum - 0.2103).abs() < 1e-4), "{open:?}");
        let fixed = closing_shifts(&gears, &[Some(0.5), Some(0.0)], &[mesh]).unwrap_err();
        assert!(matches!(fixed, Unclosed::Fixed { mesh: 0, sum, .. } if sum == 0.5), "{fixed:?}");
        let near = StatedDistance { distance: 30.0, ..mesh };
        let refused = closing_shifts(&gears, &[Some(0.5)], &[near]).unwrap_err();
        assert!(matches!(refused, Unclosed::Refused { mesh: 0, .. }), "{refused:?}");
    }

    proptest! {
        /// Of sun, planets and ring any one shift decides the others: pairs without backlash of these gears
        /// are at the stated distance.
        #[test]
        fn each_mesh_closes_at_its_distance(
            sun in 17_u32..60, planet in 17_u32..60, of in 0_usize..3, shift in -0.3_f64..0.6, away in -0.3_f64..0.6,
        ) {
            let gears = [
                gear(GearKind::External, sun),
                gear(GearKind::External, planet),
                gear(GearKind::Internal, sun + 2 * planet),
            ];
            let distance = f64::from(sun + planet) / 2.0 + away;
            let meshes = [[0, 1], [1, 2]].map(|gears| StatedDistance { gears, distance });
            let mut stated = [None; 3];
            stated[of] = Some(shift);
            let shifts = closing_shifts(&gears, &stated, &meshes).unwrap();
            prop_assert_eq!(shifts[of], shift);
            let shifted: Vec<_> = gears.iter().zip(&shifts).map(|(gear, shift)| gear.with_shift(*shift)).collect();
            for mesh in meshes {
                let [Ok(one), Ok(other)] = mesh.gears.map(|gear| shifted[gear].clone()) else { continue };
                let found = Pair::without_backlash(one, other).unwrap().centre_distance();
                prop_assert!((found - distance).abs() < 1e-9, "{} {}", found, distance);
            }
        }
    }
}
