//! Planet phasing: the modes of a set of equally spaced planets that an excitation can drive.
//!
//! Planet `n` is at `ψ_n = 2π·n/N`. An excitation that goes around the set with `p` periods per turn meets
//! the planet with the phase `p·ψ_n`. The harmonic `l` of the meshes of a gear with `z` teeth has `p = l·z`.
//! A deviation of sun or ring with `h` periods on its circumference has `p = h`. Let the meshes of planet `n`
//! have the force `f·exp(i·(ω·t + p·ψ_n))`. Consider a mode in which the motion of planet `n` follows from
//! planet 0 by the factor `exp(−i·j·ψ_n)`. It takes the work:
//!
//! ```text
//! Σ exp(i·(p − j)·ψ_n) = N where p ≡ j (mod N), else 0
//! ```
//!
//! In rotational modes all planets do the same, `j = 0`; in translational ones `j = ±1`; in planet modes `j`
//! is any other. So with `k = p mod N`:
//!
//! | `k` | modes that are excited |
//! |---|---|
//! | 0 | rotational |
//! | 1, `N − 1` | translational |
//! | other | planet |
//!
//! In a torsional model centres are at rest, and a set has two kinds of modes: those in which its members
//! rotate, `j = 0`, and those of its planets alone, any other `j`. This holds for two planets, too, and for
//! each set of several on common links: the meshes of a set take work from its own planets and members alone.
//!
//! If sun and ring have `z_s + z_r` divisible by `N`, the meshes of both have the same or the opposite `k`,
//! so one rule holds for both.
//!
//! # Source
//! R. G. Parker, A physical explanation for the effectiveness of planet phasing to suppress planetary gear
//! vibration, Journal of Sound and Vibration 236 (2000) 561–573; D. L. Seager, Conditions for the
//! neutralization of excitation by the teeth in epicyclic gearing, Journal of Mechanical Engineering Science
//! 17 (1975) 293–298.

use crate::Error;
use crate::modes::Kind;

/// The modes that an excitation of `periods` a turn can drive in a set of equally spaced planets.
///
/// ```
/// use epicyclic_vibration::{Kind, phasing};
///
/// // 27 teeth of the sun, four planets: harmonics 1, 2 and 4 of the meshes.
/// assert_eq!(phasing::excited(27, 4)?, Kind::Translational);
/// assert_eq!(phasing::excited(2 * 27, 4)?, Kind::Planet);
/// assert_eq!(phasing::excited(4 * 27, 4)?, Kind::Rotational);
/// # Ok::<(), epicyclic_vibration::Error>(())
/// ```
///
/// # Errors
/// [`Error::TooFew`] below three planets, which have no such kinds of modes.
pub fn excited(periods: u64, planets: u32) -> Result<Kind, Error> {
    if planets < 3 {
        return Err(Error::TooFew { of: "planets", count: planets as usize, least: 3 });
    }
    let planets = u64::from(planets);
    Ok(match periods % planets {
        0 => Kind::Rotational,
        k if k == 1 || k == planets - 1 => Kind::Translational,
        _ => Kind::Planet,
    })
}

/// The torsional modes that an excitation of `periods` a turn can drive by the meshes of a set of equally
/// spaced planets: [`Kind::Rotational`] those in which its members rotate, [`Kind::Planet`] those of its
/// planets alone.
///
/// # Errors
/// [`Error::TooFew`] without planets.
pub fn torsional(periods: u64, planets: u32) -> Result<Kind, Error> {
    if planets == 0 {
        return Err(Error::TooFew { of: "planets", count: 0, least: 1 });
    }
    Ok(if periods.is_multiple_of(u64::from(planets)) { Kind::Rotational } else { Kind::Planet })
}
