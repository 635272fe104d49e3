//! Direction of power through each segment of meshes: the signs continuous with vanishing losses.
//!
//! The same search serves the kernel of fixed size and the general solver.

use crate::tolerance::{POLE, POWER};
use epicyclic_numerics::roots::bisected;

/// A gear whose torques follow from the signs of its rolling powers.
pub(crate) trait Lossy<Signs> {
    /// Torques and powers.
    type Found;
    /// Torques with losses at `share` of their full size, under these signs; `None` where they run to
    /// infinity.
    fn at(&self, signs: &Signs, share: f64) -> Option<Self::Found>;
    /// Rolling power of each segment, and the largest power inside.
    fn powers<'f>(&self, found: &'f Self::Found) -> (&'f [f64], f64);
    /// The largest torque.
    fn largest_torque(&self, found: &Self::Found) -> f64;
}

/// Signs of powers, the largest inside given; written over the first of `signs`.
pub(crate) fn signs<Signs: AsMut<[i8]>>(powers: &[f64], largest: f64, mut signs: Signs) -> Signs {
    let zero = POWER * largest;
    for (sign, &power) in signs.as_mut().iter_mut().zip(powers) {
        *sign = i8::from(power > zero) - i8::from(power < -zero);
    }
    signs
}

/// `η^w` of a segment at `share` of its loss.
#[inline]
pub(crate) fn part(eta: f64, sign: i8, share: f64) -> f64 {
    let eta = if share < 1.0 { libm::pow(eta, share) } else { eta };
    match sign {
        1 => eta,
        -1 => 1.0 / eta,
        _ => 1.0,
    }
}

fn agree(signs: &[i8], powers: &[f64], largest: f64) -> bool {
    let zero = POWER * largest;
    signs.iter().zip(powers).all(|(&sign, &power)| power.abs() <= zero || f64::from(sign) * power > 0.0)
}

/// The torques on the branch that starts with these signs, of the gear without losses; they become its own.
pub(crate) fn find<Signs: AsMut<[i8]> + AsRef<[i8]>, L: Lossy<Signs>>(
    gear: &L,
    signs: &mut Signs,
) -> Option<L::Found> {
    let agrees = |found: &L::Found, signs: &Signs| {
        let (powers, largest) = gear.powers(found);
        agree(signs.as_ref(), powers, largest)
    };
    match gear.at(signs, 1.0) {
        Some(found) if agrees(&found, signs) => Some(found),
        _ => follow(gear, signs),
    }
}

/// Raises the losses from nothing and turns a sign where its power passes through zero.
#[cold]
fn follow<Signs: AsMut<[i8]> + AsRef<[i8]>, L: Lossy<Signs>>(
    gear: &L,
    signs: &mut Signs,
) -> Option<L::Found> {
    const STEPS: u32 = 64;
    let agrees = |found: &L::Found, signs: &Signs| {
        let (powers, largest) = gear.powers(found);
        agree(signs.as_ref(), powers, largest)
    };
    let base = gear.largest_torque(&gear.at(signs, 0.0)?);
    let mut from = 0.0;
    for _ in 0..16 * (1 + signs.as_ref().len()) {
        let first_step = (from * f64::from(STEPS)) as u32 + 1;
        let mut last = from;
        let mut crossing = None;
        for step in first_step..=STEPS {
            let share = f64::from(step) / f64::from(STEPS);
            match gear.at(signs, share) {
                Some(found) if agrees(&found, signs) => last = share,
                _ => {
                    crossing = Some(share);
                    break;
                }
            }
        }
        let Some(crossing) = crossing else { return gear.at(signs, 1.0) };
        let confirms = |share: f64| gear.at(signs, share).is_some_and(|found| agrees(&found, signs));
        let [_, high] = bisected([last, crossing], 60, confirms);
        let found = gear.at(signs, high)?;
        let most = gear.largest_torque(&found);
        if !most.is_finite() || most > POLE * base {
            return None;
        }
        let (powers, largest) = gear.powers(&found);
        let zero = POWER * largest;
        let mut any = false;
        for (sign, &power) in signs.as_mut().iter_mut().zip(powers) {
            let turned = i8::from(power > zero) - i8::from(power < -zero);
            if turned != 0 && turned != *sign {
                *sign = turned;
                any = true;
            }
        }
        if !any {
            return None;
        }
        from = high;
    }
    None
}
