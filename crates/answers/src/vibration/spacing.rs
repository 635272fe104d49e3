//! Where the planets of a set stand on its carrier.
//!
//! Sun and ring of `z_s` and `z_r` teeth let a planet stand at the angles `2π·κ/(z_s + z_r)` from another, `κ` an integer.

use crate::number::short;
use crate::tolerance::{AT_TEETH, EQUAL_SPACING};
use std::f64::consts::TAU;

/// The places of the planets.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spacing {
    /// Angles from `x`, of the first planet 0 where they are equally spaced.
    pub(super) angles_rad: Vec<f64>,
    pub(super) is_equal: bool,
    /// `κ` of each planet; of sets with teeth alone.
    pub(super) places: Vec<u64>,
}

impl Spacing {
    /// Of so many planets at given angles, rad, or equally spaced.
    ///
    /// Equally spaced planets that the teeth do not let stand so have no `places`.
    pub(super) fn new(planets: u32, teeth: Option<[u32; 3]>, given: Option<&[f64]>) -> Result<Self, String> {
        let count = planets as usize;
        let all = teeth.map(|[sun, _, ring]| u64::from(sun) + u64::from(ring));
        let Some(given) = given else {
            let step = all.filter(|all| planets > 0 && all.is_multiple_of(planets.into()));
            let step = step.map(|all| all / u64::from(planets));
            let angles_rad = (0..count).map(|n| TAU * n as f64 / count as f64).collect();
            let places =
                step.map_or_else(Vec::new, |step| (0..u64::from(planets)).map(|n| n * step).collect());
            return Ok(Self { angles_rad, is_equal: true, places });
        };
        if given.len() != count {
            return Err(format!("{} angles of {count} planets", given.len()));
        }
        let Some(first) = given.first().copied() else { return Err("no planets".to_owned()) };
        let mut angles_rad: Vec<f64> = given.to_vec();
        let mut places = vec![];
        if let Some(all) = all {
            for (number, angle) in angles_rad.iter_mut().enumerate() {
                let place = (*angle - first).rem_euclid(TAU) / TAU * all as f64;
                let nearest = place.round();
                let at = first + TAU * nearest / all as f64;
                if (place - nearest).abs() > AT_TEETH {
                    let [given, at] = [*angle, at].map(|angle| short(angle.to_degrees()));
                    let number = number + 1;
                    return Err(format!(
                        "planet {number} at {given} deg: the {all} teeth of sun and ring let it stand at multiples of 360/{all} deg from the first, such as {at} deg"
                    ));
                }
                *angle = at;
                places.push(nearest as u64 % all);
            }
        }
        let mut sorted: Vec<f64> = angles_rad.iter().map(|angle| (angle - first).rem_euclid(TAU)).collect();
        sorted.sort_by(f64::total_cmp);
        let step = TAU / count as f64;
        let is_equal =
            sorted.iter().enumerate().all(|(n, angle)| (angle - step * n as f64).abs() < EQUAL_SPACING);
        Ok(Self { angles_rad, is_equal, places })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planets_stand_where_the_teeth_let_them() {
        // 25 + 83 = 108 places of 3.333… degrees.
        let teeth = Some([25, 29, 83]);
        let degrees = |all: [f64; 4]| all.map(f64::to_radians);
        let equal = Spacing::new(4, teeth, None).unwrap();
        assert_eq!((equal.places.as_slice(), equal.is_equal), (&[0, 27, 54, 81][..], true));
        let same = Spacing::new(4, teeth, Some(&degrees([0.0, 90.0, 180.0, 270.0]))).unwrap();
        assert_eq!((same.places, same.is_equal), (equal.places, true));
        let pairs = Spacing::new(4, teeth, Some(&degrees([0.0, 86.67, 180.0, 266.67]))).unwrap();
        assert_eq!((pairs.places.as_slice(), pairs.is_equal), (&[0, 26, 54, 80][..], false));
        assert!((pairs.angles_rad[1] - TAU * 26.0 / 108.0).abs() < 1e-12);
        let refused = Spacing::new(4, teeth, Some(&degrees([0.0, 88.0, 180.0, 270.0]))).unwrap_err();
        assert!(refused.starts_with("planet 2 at 88 deg: the 108 teeth"), "{refused}");
        assert!(Spacing::new(3, teeth, Some(&degrees([0.0, 90.0, 180.0, 270.0]))).is_err());
        let free = Spacing::new(4, None, Some(&degrees([0.0, 88.0, 180.0, 270.0]))).unwrap();
        assert!(free.places.is_empty() && !free.is_equal);
        // 108 teeth and five planets.
        assert!(Spacing::new(5, teeth, None).unwrap().places.is_empty());
    }
}
