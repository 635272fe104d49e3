//! How many places round the axis there are for identical planets: what their number must divide.

use crate::compound::CentralKind;
use crate::planet_set::{GearOf, PlanetSet};

/// `G`, which the number of planets at equal angles must divide; 0 where any number does, `None` where it is not
/// known.
pub(super) fn slots(set: &PlanetSet) -> Option<u128> {
    if set.centrals().iter().any(|central| central.kind == CentralKind::PlanetShaft) {
        return None;
    }
    // A planet with one gear may be turned to any of its teeth: `z_p·x_p` is as free as `x_p`.
    let coefficient = |gear: GearOf| match gear {
        GearOf::Planet(planet, _) if set.planets()[planet].gears.len() == 1 => Some(1),
        gear => set.teeth(gear).map(|teeth| i128::from(teeth.get())),
    };
    // One line of each mesh: coefficients of the planets, and what stands on the right, times N.
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
