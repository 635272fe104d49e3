//! Leakage through the gaps at the end faces of satellites and rotor.
//!
//! A face is at a gap `h` before a plate. The mean of a slow flow across the gap follows the pressure as in a
//! Hele-Shaw cell, `q = −h³/(12η)·∇p` over the width of the flow. So the pressure is harmonic on the face. On
//! the rim of a satellite high and low pressure meet at the two contacts, and no oil enters along the sealed
//! angle `δ` at each. A conformal map takes the disc to a rectangle:
//!
//! ```text
//! Q = G(δ)·h³·Δp/(12·η)        G = K′(k)/(2·K(k))        k = tan²(δ/4)
//! ```
//!
//! with the complete elliptic integrals `K(k)` and `K′(k) = K(√(1 − k²))`, by the arithmetic-geometric mean
//! `agm`: `G = agm(1, √(1 − k²))/(2·agm(1, k))`. The rotor's face has `2n` such contacts. As a disc with
//! evenly spaced contacts it is the `n`-fold cover of the other by `z → zⁿ`, and passes `n·G(n·δ₁)`.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `h` | gap at one face | m |
//! | `η` | dynamic viscosity | Pa·s |
//! | `δ`, `δ₁` | sealed angle at a contact of a satellite, `2π/Z_s`, and of the rotor, `2π/Z₁` | rad |
//!
//! The sealed angle is a tooth pitch. Of the satellites `2n` part high from low pressure at any angle; the
//! others have one pressure on both sides.
//!
//! # Reynolds number
//! The Reynolds number is `Re = 2·ϱ·u·h/η`, with the hydraulic diameter `2h` and the mean velocity `u` across
//! the lines from the centre to the contacts. These lines are `2r` together on a satellite and `2n·R` on the
//! rotor with `R = m·Z₁/2`. Up to [`LAMINAR`] the law above holds. Beyond, the user's law of friction
//! `λ = C·Re^(−s)` takes its place on a path of the same mean length `ℓ`:
//!
//! ```text
//! Δp = λ·ℓ·ϱ·u²/(4·h)        ℓ = 2r/G for a satellite
//! ```
//!
//! which with `C = 96`, `s = 1` is the laminar law again.
//!
//! # Left out
//! - Leaks at the flanks and past the tips of the teeth.
//! - Tilted faces, and gaps that pressure widens.
//! - The bore of the rotor's face, which lets still less through.
//! - The drag of the moving faces on the oil, which carries as much to the one side as to the other.

use epicyclic_units::Physical;
use uom::si::f64::{
    Angle, DynamicViscosity, Length, MassDensity, Pressure, TemperatureCoefficient, TemperatureInterval,
    VolumeRate,
};

use crate::Error;
use crate::motor::Motor;
use crate::quantity::{Quantity, WheelKind};
use crate::ranges::{self, finite, positive_length, positive_pressure, ranging};
use std::f64::consts::{PI, TAU};

/// The greatest Reynolds number, with twice the gap as diameter, at which the laminar law is used; between
/// plates the flow stays laminar up to about this.
pub const LAMINAR: f64 = 2000.0;

/// The gaps at one face of each kind of wheel; 0 of a face that seals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndGaps {
    /// Gap at one face of a satellite: half the axial play of one that floats in the middle.
    pub satellite: Length,
    /// Gap at one face of the rotor.
    pub rotor: Length,
}

/// Fluid in the gaps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapFluid {
    /// Dynamic viscosity `η`.
    pub viscosity: DynamicViscosity,
    /// Density `ϱ`.
    pub density: MassDensity,
    /// The law beyond the laminar range, where the user has one.
    pub turbulent: Option<TurbulentLaw>,
}

/// A law of friction `λ = C·Re^(−s)` for turbulent flow between plates; an input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurbulentLaw {
    /// `C`, above 0.
    pub factor: f64,
    /// `s`, from 0 to 1.
    pub exponent: f64,
}

/// The law that a flow follows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Regime {
    /// Laminar.
    Laminar,
    /// The user's turbulent law.
    Turbulent,
}

/// The flow through the gaps of one wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapFlow {
    /// Flow through both faces.
    pub flow: VolumeRate,
    /// The Reynolds number.
    pub reynolds: f64,
    /// The law.
    pub regime: Regime,
}

/// The leakage of a motor at rest or in motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leakage {
    /// Flow at one satellite that parts the pressures.
    pub satellite: GapFlow,
    /// Number of satellites that part the pressures: `2n`.
    pub loaded_satellites: u32,
    /// Flow at all these satellites.
    pub satellites: VolumeRate,
    /// Flow at the rotor.
    pub rotor: GapFlow,
    /// Total leakage.
    pub total: VolumeRate,
}

/// Arithmetic-geometric mean of two numbers above 0.
fn agm(mut a: f64, mut b: f64) -> f64 {
    // As many digits again with each step: eight suffice for any pair of doubles near 1, more for a small
    // one.
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        if (a - b).abs() <= f64::EPSILON * a {
            break;
        }
    }
    a
}

/// `G(δ)` of an angle between 0 and half a turn.
fn conductance(sealed: f64) -> f64 {
    let k = libm::tan(0.25 * sealed).powi(2);
    agm(1.0, ((1.0 - k) * (1.0 + k)).sqrt()) / (2.0 * agm(1.0, k))
}

/// The conductance `G(δ)` of a disc between two pressures on its rim, parted by two opposite sealed angles
/// `δ`; 1 for a right angle.
///
/// # Errors
/// [`Error::OutOfRange`] unless the angle lies between 0 and 180°, both excluded.
///
/// # Example
/// ```
/// use epicyclic_hydromotor::leakage::disc_conductance;
/// use uom::si::{angle::degree, f64::Angle};
///
/// assert!((disc_conductance(Angle::new::<degree>(90.0))? - 1.0).abs() < 1e-15);
/// assert!((disc_conductance(Angle::new::<degree>(36.0))? - 1.61434).abs() < 5e-6);
/// # Ok::<(), epicyclic_hydromotor::Error>(())
/// ```
pub fn disc_conductance(sealed: Angle) -> Result<f64, Error> {
    let value = sealed.degrees();
    ranging(Quantity::SealedAngle, value, [f64::MIN_POSITIVE, 180.0], "°")?;
    let sealed = sealed.si();
    if sealed < PI {
        Ok(conductance(sealed))
    } else {
        Err(Error::OutOfRange {
            quantity: Quantity::SealedAngle,
            value,
            low: 0.0,
            high: Angle::from_si(PI).degrees(),
            unit: "°",
        })
    }
}

/// A face: its conductance, and the length of the lines that the flow crosses in metres.
struct Face {
    wheel: WheelKind,
    conductance: f64,
    across: f64,
}

impl Motor {
    fn satellite_face(&self) -> Face {
        Face {
            wheel: WheelKind::Satellite,
            conductance: conductance(TAU / f64::from(self.numbers().satellite_teeth())),
            across: 2.0 * self.satellite_radius().si(),
        }
    }

    fn rotor_face(&self) -> Face {
        let (lobes, teeth) =
            (f64::from(self.numbers().rotor_lobes()), f64::from(self.numbers().rotor_teeth()));
        Face {
            wheel: WheelKind::Rotor,
            conductance: lobes * conductance(lobes * TAU / teeth),
            across: lobes * teeth * self.module().si(),
        }
    }

    /// The conductance of one face of the rotor, `n·G(n·2π/Z₁)`.
    #[must_use]
    pub fn rotor_face_conductance(&self) -> f64 {
        self.rotor_face().conductance
    }

    /// The leakage through the end gaps, with ideal ports.
    ///
    /// | symbol | argument | meaning | unit |
    /// |---|---|---|---|
    /// | `Δp` | `pressure_drop` | high less low pressure, above 0 | Pa |
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for gaps below 0, [`Error::NotPositive`] for pressure drop, viscosity and
    /// density; [`Error::NotLaminar`] beyond [`LAMINAR`] without a turbulent law; errors of that law's
    /// numbers.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::leakage::{EndGaps, GapFluid};
    /// use epicyclic_hydromotor::{Motor, MotorNumbers};
    /// use uom::si::f64::{DynamicViscosity, Length, MassDensity, Pressure};
    /// use uom::si::length::{micrometer, millimeter};
    /// use uom::si::{dynamic_viscosity::pascal_second, volume_rate::liter_per_minute};
    /// use uom::si::{mass_density::kilogram_per_cubic_meter, pressure::megapascal};
    ///
    /// let mm = Length::new::<millimeter>;
    /// let motor = Motor::of_two_arcs(MotorNumbers::new(6, 4, 66, 10)?, mm(0.75), mm(30.0))?;
    /// let gap = Length::new::<micrometer>(10.0);
    /// let fluid = GapFluid {
    ///     viscosity: DynamicViscosity::new::<pascal_second>(0.04),
    ///     density: MassDensity::new::<kilogram_per_cubic_meter>(870.0),
    ///     turbulent: None,
    /// };
    /// let gaps = EndGaps { satellite: gap, rotor: gap };
    /// let leakage = motor.end_leakage(gaps, fluid, Pressure::new::<megapascal>(25.0))?;
    /// assert!((leakage.satellites.get::<liter_per_minute>() - 0.081).abs() < 5e-4);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn end_leakage(
        &self,
        gaps: EndGaps,
        fluid: GapFluid,
        pressure_drop: Pressure,
    ) -> Result<Leakage, Error> {
        let drop = positive_pressure(Quantity::PressureDrop, pressure_drop)?.si();
        let satellite = self.satellite_face().flow(Quantity::SatelliteGap, gaps.satellite, fluid, drop)?;
        let rotor = self.rotor_face().flow(Quantity::RotorGap, gaps.rotor, fluid, drop)?;
        let loaded_satellites = 2 * self.numbers().rotor_lobes();
        let satellites = satellite.flow * f64::from(loaded_satellites);
        Ok(Leakage { satellite, loaded_satellites, satellites, rotor, total: satellites + rotor.flow })
    }
}

impl Face {
    fn flow(&self, quantity: Quantity, gap: Length, fluid: GapFluid, drop: f64) -> Result<GapFlow, Error> {
        let gap = ranges::gap(quantity, gap)?;
        let viscosity = ranges::viscosity(fluid.viscosity)?;
        let density = ranges::density(fluid.density)?;
        let law = match fluid.turbulent {
            Some(TurbulentLaw { factor, exponent }) => {
                Some((ranges::turbulent_factor(factor)?, ranges::turbulent_exponent(exponent)?))
            }
            None => None,
        };
        let of_face = self.conductance * gap.powi(3) * drop / (12.0 * viscosity);
        let reynolds = 2.0 * density * of_face / (viscosity * self.across);
        if reynolds <= LAMINAR {
            let flow = VolumeRate::from_si(2.0 * of_face);
            return Ok(GapFlow { flow, reynolds, regime: Regime::Laminar });
        }
        let Some((factor, exponent)) = law else {
            let gap_most_um = Length::from_si(gap * libm::cbrt(LAMINAR / reynolds)).um();
            return Err(Error::NotLaminar { wheel: self.wheel, reynolds, most: LAMINAR, gap_most_um });
        };
        // Δp = C·(2·ϱ·u·h/η)^(−s)·ℓ·ϱ·u²/(4·h)
        let path = self.across / self.conductance;
        let power = 4.0 * gap * drop / (factor * path * density)
            * libm::pow(2.0 * density * gap / viscosity, exponent);
        let velocity = libm::pow(power, 1.0 / (2.0 - exponent));
        Ok(GapFlow {
            flow: VolumeRate::from_si(2.0 * velocity * gap * self.across),
            reynolds: 2.0 * density * velocity * gap / viscosity,
            regime: Regime::Turbulent,
        })
    }
}

/// Axial play that remains between housing and satellite when the satellite is warmer: `j − a_T·b·ΔT`; a face
/// has half of it.
///
/// | symbol | argument | meaning | unit |
/// |---|---|---|---|
/// | `j` | `play` | the play when both have one temperature | m |
/// | `a_T` | `expansion` | coefficient of thermal expansion of both | 1/K |
/// | `b` | `width` | width of the satellite | m |
/// | `ΔT` | `warmer` | how much warmer the satellite is; below 0 the play opens | K |
///
/// # Errors
/// [`Error::NotPositive`] for play and width, [`Error::NotFinite`] for the others, [`Error::PlayClosed`] if
/// no play remains.
pub fn warm_play(
    play: Length,
    expansion: TemperatureCoefficient,
    width: Length,
    warmer: TemperatureInterval,
) -> Result<Length, Error> {
    let play = positive_length(Quantity::AxialPlay, play)?.si();
    let width = positive_length(Quantity::Width, width)?.si();
    let rate = finite(Quantity::Expansion, expansion.si(), "1/K")? * width;
    let closed = rate * finite(Quantity::TemperatureDifference, warmer.si(), "K")?;
    if closed < play {
        return Ok(Length::from_si(play - closed));
    }
    let [play_um, closed_um] = [play, closed].map(|value| Length::from_si(value).um());
    Err(Error::PlayClosed { play_um, closed_um, most_k: play / rate })
}

#[cfg(test)]
mod tests;
