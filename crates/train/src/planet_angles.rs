//! Angles of the planets of a set on its carrier.
//!
//! Planets are at equal angles unless a set gives others. Every kind of planet has the same number of
//! planets, at the same angles.
//!
//! ```text
//! θ_j = 2π·p_j/G         p_j an integer: an assembly position
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `θ_j` | angle of planet `j` from the first, about the main axis | rad |
//! | `G` | assembly positions in a turn, [`PlanetSet::assembly_positions`] | 1 |
//!
//! A simple set has `G = z_a + z_b`, a double planet `G = z_b − z_a`. Planets at equal angles fit if their
//! number divides `G`. Planets at given angles fit if each is at an assembly position, counted from the first
//! planet.

use crate::compound::CentralKind;
use crate::planet_set::{GearOf, PlanetSet};
use crate::spacing::Spacing;
use crate::tolerance::{APART, AT_ANGLE, AT_POSITION};
use crate::{Error, SpacingFault};
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_gears::synthesis::Placement;
use epicyclic_units::Physical;
use std::f64::consts::TAU;
use uom::si::f64::Angle;

/// Refuses a spacing that a set cannot have.
///
/// # Errors
/// [`Error::Spacing`].
pub(crate) fn check(set: &PlanetSet) -> Result<(), Error> {
    let refuse = |fault| Err(Error::Spacing { set: set.id().to_owned(), fault });
    match set.spacing() {
        Spacing::Placed(Placement::Equal) => Ok(()),
        _ if set.is_pair() => refuse(SpacingFault::Pair),
        Spacing::Placed(Placement::LeastUnequal) => match (set.planet_count(), set.assembly_positions()) {
            (Some(planets), Some(positions)) if positions > 0 && u64::from(planets) > positions => {
                refuse(SpacingFault::TooFewPositions { planets, positions })
            }
            (Some(_), Some(_)) => Ok(()),
            _ => refuse(SpacingFault::Unknown),
        },
        Spacing::At(angles) => {
            if let Some(planets) = set.planet_count().filter(|count| *count as usize != angles.len()) {
                return refuse(SpacingFault::Count { angles: angles.len(), planets });
            }
            let mut turns: Vec<(usize, f64)> = vec![];
            for (place, angle) in angles.iter().enumerate() {
                let turn = (angle.si() / TAU).rem_euclid(1.0);
                if !turn.is_finite() {
                    return refuse(SpacingFault::NotFinite { planet: place + 1 });
                }
                let is_same = |other: f64| {
                    let apart = (turn - other).abs();
                    apart.min(1.0 - apart) < APART
                };
                if let Some((other, _)) = turns.iter().find(|(_, other)| is_same(*other)) {
                    return refuse(SpacingFault::SameAngle { planets: [other + 1, place + 1] });
                }
                turns.push((place, turn));
            }
            Ok(())
        }
    }
}

/// A planet that cannot be put in at its angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Misplaced {
    /// Number of the planet, from 1.
    pub planet: usize,
    /// Angle of the planet from the first, from 0 to a turn.
    pub angle: Angle,
    /// The nearest assembly position.
    pub nearest: Angle,
    /// Assembly positions in a turn, `G`.
    pub positions: u64,
}

impl PlanetSet {
    /// Spacing of the planets on the carrier.
    #[must_use]
    pub fn spacing(&self) -> &Spacing {
        self.description().spacing()
    }

    /// Assembly positions in a turn, `G`: the number of angles from another planet at which a planet, or tree
    /// of planets in mesh, can be put in; 0 where any angle will do, `None` where it is not known.
    ///
    /// The number of planets at equal angles divides it.
    ///
    /// # Example
    /// ```
    /// use epicyclic_train::{Gearbox, set::{SetKind, SetSpec}};
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let gearbox = Gearbox::builder("26 + 96")
    ///     .links(["sun", "arm"])
    ///     .set(SetSpec::teeth("P", SetKind::Simple, ["sun", "ground", "arm"], 26, 96)?)
    ///     .input("sun")
    ///     .output("arm")
    ///     .build()?;
    /// assert_eq!(gearbox.sets()[0].assembly_positions(), Some(122));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn assembly_positions(&self) -> Option<u64> {
        slots(self).and_then(|slots| u64::try_from(slots).ok())
    }

    /// Angles of the planets about the main axis, in the order in which they are given; `None` if the number
    /// of planets is not known.
    ///
    /// A given angle near an assembly position is returned as that position.
    #[must_use]
    pub fn planet_angles(&self) -> Option<Vec<Angle>> {
        let positions = self.assembly_positions().filter(|positions| *positions > 0);
        match (self.spacing(), positions) {
            (Spacing::At(given), Some(positions)) => {
                let first = given.first().map_or(0.0, |angle| angle.si());
                Some(
                    given
                        .iter()
                        .map(|angle| match At::new(angle.si() - first, positions) {
                            at if at.is_there() => Angle::from_si(first + at.nearest_rad()),
                            _ => *angle,
                        })
                        .collect(),
                )
            }
            (Spacing::At(given), None) => Some(given.clone()),
            (Spacing::Placed(Placement::LeastUnequal), Some(positions)) => {
                Some(PlanetSpacing::of_positions(positions, self.planet_count()?).angles())
            }
            _ => {
                let planets = self.planet_count()?;
                let angle = |place| Angle::from_si(TAU * f64::from(place) / f64::from(planets));
                Some((0..planets).map(angle).collect())
            }
        }
    }

    /// The least angle between neighbouring planets where its spacing is not the usual equal one; `None` of
    /// one planet.
    #[must_use]
    pub fn least_planet_angle(&self) -> Option<Angle> {
        if *self.spacing() == Spacing::default() {
            return None;
        }
        let mut turns: Vec<f64> =
            self.planet_angles()?.iter().map(|angle| angle.si().rem_euclid(TAU)).collect();
        turns.sort_by(f64::total_cmp);
        let next = turns.iter().skip(1).copied().chain(turns.first().map(|first| first + TAU));
        let gaps = turns.iter().zip(next).map(|(here, next)| next - here);
        gaps.reduce(f64::min).filter(|_| turns.len() > 1).map(Angle::from_si)
    }

    /// Planets at given angles that are not assembly positions.
    #[must_use]
    pub fn misplaced(&self) -> Vec<Misplaced> {
        let (Spacing::At(given), Some(positions)) =
            (self.spacing(), self.assembly_positions().filter(|positions| *positions > 0))
        else {
            return vec![];
        };
        let first = given.first().map_or(0.0, |angle| angle.si());
        let misplaced = |(place, angle): (usize, &Angle)| {
            let at = At::new(angle.si() - first, positions);
            (!at.is_there()).then(|| Misplaced {
                planet: place + 1,
                angle: Angle::from_si(at.from_first_rad),
                nearest: Angle::from_si(at.nearest_rad()),
                positions,
            })
        };
        given.iter().enumerate().filter_map(misplaced).collect()
    }
}

/// A planet between assembly positions.
struct At {
    /// Angle from the first planet, from 0 to a turn.
    from_first_rad: f64,
    /// Assembly positions from the first planet, not whole.
    place: f64,
    positions: f64,
}

impl At {
    fn new(from_first_rad: f64, positions: u64) -> Self {
        let from_first_rad = from_first_rad.rem_euclid(TAU);
        let positions = positions as f64;
        Self { from_first_rad, place: from_first_rad / TAU * positions, positions }
    }

    fn is_there(&self) -> bool {
        let away = (self.place - self.place.round()).abs();
        away <= AT_POSITION && TAU * away / self.positions <= AT_ANGLE
    }

    fn nearest_rad(&self) -> f64 {
        TAU * self.place.round() / self.positions
    }
}

/// `G`, which the number of planets at equal angles must divide; 0 where any number does, `None` where it is
/// not known.
fn slots(set: &PlanetSet) -> Option<u128> {
    if set.centrals().iter().any(|central| central.kind == CentralKind::PlanetShaft) {
        return None;
    }
    // A planet with one gear may be turned to any of its teeth: `z_p·x_p` is as free as `x_p`.
    let coefficient = |gear: GearOf| match gear {
        GearOf::Planet(planet, _) if set.planets()[planet].gears.len() == 1 => Some(1),
        gear => set.teeth(gear).map(|teeth| i128::from(teeth.get())),
    };
    // One line for each mesh: coefficients of the planets, and the right side, times N.
    let mut lines: Vec<(Vec<i128>, i128)> = vec![];
    for mesh in set.meshes() {
        let mut line = (vec![0; set.planets().len()], 0);
        for (gear, sign) in mesh.gears.into_iter().zip([1, -mesh.kind.sign()]) {
            match gear {
                GearOf::Central(_) => line.1 += sign * coefficient(gear)?,
                GearOf::Planet(planet, _) => line.0[planet] += sign * coefficient(gear)?,
            }
        }
        lines.push(line);
    }
    // Euclid's algorithm on the lines, planet by planet; each settles one line.
    for planet in 0..set.planets().len() {
        loop {
            lines.sort_by_key(
                |line| if line.0[planet] == 0 { u128::MAX } else { line.0[planet].unsigned_abs() },
            );
            let ([pivot], rest) = lines.split_first_chunk_mut()?;
            if pivot.0[planet] == 0 {
                break;
            }
            let mut done = true;
            for line in rest.iter_mut().filter(|line| line.0[planet] != 0) {
                let times = line.0[planet] / pivot.0[planet];
                let less = |from: i128, what: i128| from.checked_sub(times.checked_mul(what)?);
                for (of_line, of_pivot) in line.0.iter_mut().zip(&pivot.0) {
                    *of_line = less(*of_line, *of_pivot)?;
                }
                line.1 = less(line.1, pivot.1)?;
                done &= line.0[planet] == 0;
            }
            if done {
                lines.remove(0);
                break;
            }
        }
    }
    Some(lines.iter().fold(0, |slots, line| gcd(slots, line.1.unsigned_abs())))
}

fn gcd(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests;
