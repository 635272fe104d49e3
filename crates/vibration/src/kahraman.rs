//! Torsional frequencies of a simple set with a held ring, in closed form.
//!
//! Coordinates are displacements along the lines of action, `u_s`, `u_n`, and `u_c = r_c·θ_c·cos α` of the
//! carrier; `N` equal planets, whatever their angles. With `δ_s = u_s + u_n − u_c` and `δ_r = −u_n − u_c` a
//! motion in which the planets' sum to 0 leaves sun and carrier at rest: `ω² = (k_r + k_s)/m_p`, `N − 1`
//! times. In the others all planets move alike, and the determinant of the three equations for `u_s`, `u_n`,
//! `u_c` gives `ω² = 0` and the roots of
//!
//! ```text
//! l_1·ω⁴ + l_2·ω² + l_3 = 0
//! l_1 = m_p·m_c·m_s
//! l_2 = −(N·k_s·m_p·m_c + (k_r + k_s)·m_c·m_s + N·(k_r + k_s)·m_p·m_s)
//! l_3 = N·k_r·k_s·(N·m_p + m_c + 4·m_s)
//! ```
//!
//! | symbol | field | meaning | unit |
//! |---|---|---|---|
//! | `m_s`, `m_p` | `sun`, `planet` | `I/r²` with the base radius | kg |
//! | `m_c` | `carrier` | `(I_c/r_c² + Σ m)/cos²α` with the planets' masses `m` | kg |
//! | `k_s`, `k_r` | `sun_mesh`, `ring_mesh` | stiffness of one mesh | N/m |
//! | `N` | `planets` | number of planets | 1 |
//!
//! # Source
//! A. Kahraman, Natural modes of planetary gear trains, Journal of Sound and Vibration 173 (1994) 125–130.

use crate::checks::positive;
use crate::modes::frequency;
use crate::{Error, Stiffness};
use epicyclic_units::Physical;
use uom::si::f64::{Frequency, Mass};

/// A set with a held ring, as masses along the lines of action.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeldRing {
    /// `I/r²` of the sun.
    pub sun: Mass,
    /// `I/r²` of a planet.
    pub planet: Mass,
    /// `(I_c/r_c² + Σ m)/cos²α` of the carrier with its planets.
    pub carrier: Mass,
    /// Stiffness of the sun's mesh with one planet.
    pub sun_mesh: Stiffness,
    /// Stiffness of the ring's mesh with one planet.
    pub ring_mesh: Stiffness,
    /// Number of planets.
    pub planets: usize,
}

/// Frequencies of a set with a held ring. The frequency 0 is not among them: all rotate by their ratios.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeldRingFrequencies {
    /// Frequencies of the modes in which sun and carrier rotate, ascending.
    pub rotational: [Frequency; 2],
    /// Frequency of the modes in which sun and carrier are at rest.
    pub planet: Frequency,
    /// Number of modes with sun and carrier at rest: `N − 1`.
    pub planet_multiplicity: usize,
}

impl HeldRing {
    /// Natural frequencies.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a mass or stiffness, [`Error::TooFew`] without planets.
    pub fn frequencies(&self) -> Result<HeldRingFrequencies, Error> {
        let mass = |name: &str, mass: Mass| positive(|| format!("I/r² of the {name}"), mass.si(), "kg");
        let mesh =
            |name: &str, k: Stiffness| positive(|| format!("stiffness of the {name}'s mesh"), k.si(), "N/m");
        let [m_s, m_p, m_c] =
            [mass("sun", self.sun)?, mass("planet", self.planet)?, mass("carrier", self.carrier)?];
        let [k_s, k_r] = [mesh("sun", self.sun_mesh)?, mesh("ring", self.ring_mesh)?];
        if self.planets == 0 {
            return Err(Error::TooFew { of: "planets", count: 0, least: 1 });
        }
        let n = self.planets as f64;
        let k = k_r + k_s;
        let l_1 = m_p * m_c * m_s;
        let l_2 = -(n * k_s * m_p * m_c + k * m_c * m_s + n * k * m_p * m_s);
        let l_3 = n * k_r * k_s * (n * m_p + m_c + 4.0 * m_s);
        // Both roots are real, as those of any symmetric problem; equal ones may miss it by rounding.
        let high = (-l_2 + (l_2 * l_2 - 4.0 * l_1 * l_3).max(0.0).sqrt()) / (2.0 * l_1);
        let low = l_3 / (l_1 * high);
        Ok(HeldRingFrequencies {
            rotational: [low, high].map(|omega2| frequency(omega2.sqrt())),
            planet: frequency((k / m_p).sqrt()),
            planet_multiplicity: self.planets - 1,
        })
    }
}
