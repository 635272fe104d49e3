//! A gear set of two central gears and a carrier, joined by planets of any kind; the simple set first of all.

use crate::Error;
pub use crate::mode::{Member, Mode};
use crate::teeth::ToothCount;
use num_rational::Ratio;
use std::fmt;

/// A ratio of tooth counts, exactly.
pub type Fraction = Ratio<i128>;

impl Mode {
    /// The mode in which `input` drives `output` and the third member rests.
    ///
    /// # Errors
    /// [`Error::SameMember`] where input and output coincide.
    pub fn new(input: Member, output: Member) -> Result<Self, Error> {
        Self::between(input, output).ok_or(Error::SameMember(input))
    }
}

/// Ring-to-sun ratio `k = z_b/z_a` of a simple set, greater than 1.
///
/// The ring encloses the sun and the planets between them, so no gear set has `k ≤ 1`.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct RingToSunRatio(f64);

impl fmt::Display for RingToSunRatio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl RingToSunRatio {
    /// A ring-to-sun ratio.
    ///
    /// # Errors
    /// [`Error::RingToSunRatio`] unless `1 < k < ∞`.
    pub fn new(k: f64) -> Result<Self, Error> {
        if k > 1.0 && k.is_finite() { Ok(Self(k)) } else { Err(Error::RingToSunRatio { k }) }
    }

    /// `k` as a number.
    #[must_use]
    pub fn get(self) -> f64 {
        self.0
    }

    /// Planet to sun, `z_g/z_a = (k − 1)/2`, by equal centre distances `z_b = z_a + 2·z_g`.
    #[must_use]
    pub fn planet_to_sun(self) -> f64 {
        (self.0 - 1.0) / 2.0
    }
}

impl From<RingToSunRatio> for BasicRatio {
    /// `i₀ = −k`.
    fn from(k: RingToSunRatio) -> Self {
        Self(-k.0)
    }
}

/// Basic ratio `i₀` of a gear set: speed of the first central gear over the second, both relative
/// to the carrier (the ratio with the carrier fixed).
///
/// ```text
/// i₀ = (ω_a − ω_H)/(ω_b − ω_H)
/// ```
///
/// Any finite value but 0. With `i₀ = 1` the central gears always turn alike and the carrier is
/// free of both (a pointer that keeps its direction, as in a south-pointing chariot): legitimate, but
/// no speed or torque of its carrier follows from theirs.
///
/// | kind | constructor | `i₀` |
/// |---|---|---|
/// | simple | [`simple`](Self::simple) | `−z_b/z_a` |
/// | double planet | [`double_planet`](Self::double_planet) | `+z_b/z_a` |
/// | stepped planet, sun and ring | [`stepped_sun_ring`](Self::stepped_sun_ring) | `−(z_g/z_a)·(z_b/z_f)` |
/// | stepped planet, two suns or rings | [`stepped_alike`](Self::stepped_alike) | `+(z_g/z_1)·(z_2/z_f)` |
/// | two suns of meshing planets, external pair, bevel | [`external`](Self::external) | `−z_2/z_1` |
/// | internal pair | [`internal`](Self::internal) | `+z_2/z_1` |
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BasicRatio(f64);

impl fmt::Display for BasicRatio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl BasicRatio {
    /// A basic ratio from its value.
    ///
    /// # Errors
    /// [`Error::BasicRatio`] for 0 and what is not finite.
    pub fn new(i0: f64) -> Result<Self, Error> {
        if i0 != 0.0 && i0.is_finite() { Ok(Self(i0)) } else { Err(Error::BasicRatio { i0 }) }
    }

    /// The set that has the ratio `i = ω_in/ω_out` in a mode.
    ///
    /// ```text
    /// ab^H  i₀ = i      aH^b  i₀ = 1 − i      bH^a  i₀ = 1/(1 − i)      each inverse with 1/i
    /// ```
    ///
    /// ```
    /// use epicyclic_gears::simple_set::{Member, Mode, BasicRatio};
    /// # fn main() -> Result<(), epicyclic_gears::Error> {
    /// let sun_to_carrier = Mode::new(Member::Sun, Member::Carrier)?;
    /// assert_eq!(BasicRatio::with_ratio(6.0, sun_to_carrier)?.get(), -5.0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`Error::Ratio`] where no set has this ratio: for 0, what is not finite, and 1 with the
    /// carrier driving or driven.
    pub fn with_ratio(ratio: f64, mode: Mode) -> Result<Self, Error> {
        let i0 = match (mode.input(), mode.output()) {
            (Member::Sun, Member::Ring) => ratio,
            (Member::Ring, Member::Sun) => 1.0 / ratio,
            (Member::Sun, _) => 1.0 - ratio,
            (_, Member::Sun) => 1.0 - 1.0 / ratio,
            (Member::Ring, _) => 1.0 / (1.0 - ratio),
            _ => 1.0 / (1.0 - 1.0 / ratio),
        };
        if ratio == 0.0 || !ratio.is_finite() {
            return Err(Error::Ratio { ratio });
        }
        Self::new(i0).map_err(|_| Error::Ratio { ratio })
    }

    /// Sun, planets in one mesh with it and with the ring: `i₀ = −z_b/z_a`.
    #[must_use]
    pub fn simple(sun: ToothCount, ring: ToothCount) -> Self {
        Self(-ring.as_f64() / sun.as_f64())
    }

    /// Sun, ring and two planets in mesh between them: `i₀ = +z_b/z_a`.
    #[must_use]
    pub fn double_planet(sun: ToothCount, ring: ToothCount) -> Self {
        Self(ring.as_f64() / sun.as_f64())
    }

    /// Stepped planet: `z_g` meshes with the sun `z_a`, `z_f` on the same pin with the ring `z_b`.
    #[must_use]
    pub fn stepped_sun_ring(sun: ToothCount, g: ToothCount, f: ToothCount, ring: ToothCount) -> Self {
        Self(-(g.as_f64() / sun.as_f64()) * (ring.as_f64() / f.as_f64()))
    }

    /// Stepped planet between two suns or two rings: `z_g` meshes with `z_1`, `z_f` with `z_2`.
    #[must_use]
    pub fn stepped_alike(first: ToothCount, g: ToothCount, f: ToothCount, second: ToothCount) -> Self {
        Self((g.as_f64() / first.as_f64()) * (second.as_f64() / f.as_f64()))
    }

    /// Two gears that turn against each other with the carrier fixed: an external pair, two suns
    /// whose planets mesh (Ravigneaux), a bevel set (`z_1 = z_2` gives −1).
    #[must_use]
    pub fn external(first: ToothCount, second: ToothCount) -> Self {
        Self(-second.as_f64() / first.as_f64())
    }

    /// A pinion in a ring: both turn the same way with the carrier fixed.
    #[must_use]
    pub fn internal(pinion: ToothCount, ring: ToothCount) -> Self {
        Self(ring.as_f64() / pinion.as_f64())
    }

    /// `i₀` as a number.
    #[must_use]
    pub fn get(self) -> f64 {
        self.0
    }

    /// Factors of `ω_a`, `ω_b`, `ω_H` in the set's equation `ω_a − i₀·ω_b − (1 − i₀)·ω_H = 0`.
    /// They sum to zero: a set that turns as a block satisfies it.
    #[must_use]
    pub fn coefficients(self) -> [f64; 3] {
        [1.0, -self.0, self.0 - 1.0]
    }

    /// Ratio of speeds `i = ω_in/ω_out` in a mode, the third member at rest.
    ///
    /// For a simple set these are the six ratios `−k`, `1 + k`, `(1 + k)/k` and their inverses.
    ///
    /// # Errors
    /// [`Error::CarrierUndetermined`] with the carrier driving or driven at `i₀ = 1`.
    ///
    /// # Source
    /// multispeed-gearboxes, table 2.2.
    pub fn ratio(self, mode: Mode) -> Result<f64, Error> {
        let factor = |member: Member| self.coefficients()[member as usize];
        let (of_input, of_output) = (factor(mode.input()), factor(mode.output()));
        // With one member at rest the equation is c_in·ω_in + c_out·ω_out = 0.
        if of_input == 0.0 || of_output == 0.0 {
            return Err(Error::CarrierUndetermined);
        }
        Ok(-of_output / of_input)
    }
}

/// The ratio of a mode of a simple set as an exact fraction of its tooth counts.
///
/// ```
/// use epicyclic_gears::simple_set::{exact_ratio, Fraction, Member, Mode};
/// use epicyclic_gears::teeth::ToothCount;
/// # fn main() -> Result<(), epicyclic_gears::Error> {
/// let ratio =
///     exact_ratio(ToothCount::new(24)?, ToothCount::new(57)?, Mode::new(Member::Sun, Member::Carrier)?);
/// assert_eq!(ratio, Fraction::new(27, 8));
/// # Ok(())
/// # }
/// ```
#[must_use]
pub fn exact_ratio(sun: ToothCount, ring: ToothCount, mode: Mode) -> Fraction {
    let (a, b) = (i128::from(sun.get()), i128::from(ring.get()));
    // The set's equation times z_a: z_a·ω_a + z_b·ω_b − (z_a + z_b)·ω_H = 0.
    let factors = [a, b, -(a + b)];
    -Fraction::new(factors[mode.output() as usize], factors[mode.input() as usize])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn teeth(count: u32) -> ToothCount {
        ToothCount::new(count).unwrap()
    }

    #[test]
    fn six_ratios_of_a_simple_set_are_those_of_table_2_2() {
        let k = 1.7;
        let set = BasicRatio::from(RingToSunRatio::new(k).unwrap());
        let expected = [-k, 1.0 + k, (1.0 + k) / k, -1.0 / k, 1.0 / (1.0 + k), k / (1.0 + k)];
        for (mode, expected) in Mode::ALL.into_iter().zip(expected) {
            let ratio = set.ratio(mode).unwrap();
            assert!((ratio - expected).abs() < 1e-15, "{mode}: {ratio} is not {expected}");
        }
    }

    #[test]
    fn exact_ratio_is_the_floating_one() {
        for mode in Mode::ALL {
            let exact = exact_ratio(teeth(24), teeth(57), mode);
            #[allow(clippy::cast_precision_loss)] // far below 2⁵³
            let exact = *exact.numer() as f64 / *exact.denom() as f64;
            let float = BasicRatio::simple(teeth(24), teeth(57)).ratio(mode).unwrap();
            assert!((exact - float).abs() < 1e-15);
        }
    }

    #[test]
    fn kinds_of_set_have_their_basic_ratios() {
        let [z20, z40, z50, z100] = [20, 40, 50, 100].map(teeth);
        assert_eq!(BasicRatio::simple(z20, z100).get(), -5.0);
        assert_eq!(BasicRatio::double_planet(z20, z100).get(), 5.0);
        assert_eq!(BasicRatio::stepped_sun_ring(z20, z40, z20, z100).get(), -10.0);
        assert_eq!(BasicRatio::stepped_alike(z20, z40, z20, z50).get(), 5.0);
        assert_eq!(BasicRatio::external(z20, z20).get(), -1.0);
        assert_eq!(BasicRatio::internal(z20, z100).get(), 5.0);
    }

    #[test]
    fn invalid_sets_are_refused() {
        assert_eq!(RingToSunRatio::new(1.0), Err(Error::RingToSunRatio { k: 1.0 }));
        assert!(RingToSunRatio::new(f64::NAN).is_err());
        assert_eq!(BasicRatio::new(0.0), Err(Error::BasicRatio { i0: 0.0 }));
        assert_eq!(Mode::new(Member::Sun, Member::Sun), Err(Error::SameMember(Member::Sun)));
    }

    #[test]
    fn a_set_is_found_by_its_ratio_in_any_mode() {
        for mode in Mode::ALL {
            let found = BasicRatio::with_ratio(-2.6, mode).unwrap();
            assert!((found.ratio(mode).unwrap() - -2.6).abs() < 1e-14, "{mode}");
        }
        let sun_to_carrier = Mode::new(Member::Sun, Member::Carrier).unwrap();
        for none in [0.0, 1.0, f64::NAN] {
            assert!(matches!(BasicRatio::with_ratio(none, sun_to_carrier), Err(Error::Ratio { .. })));
        }
    }

    #[test]
    fn a_carrier_that_nothing_moves_has_no_ratio() {
        let paradox = BasicRatio::new(1.0).unwrap();
        let sun_to_carrier = Mode::new(Member::Sun, Member::Carrier).unwrap();
        assert_eq!(paradox.ratio(sun_to_carrier), Err(Error::CarrierUndetermined));
        assert_eq!(paradox.ratio(Mode::new(Member::Sun, Member::Ring).unwrap()), Ok(1.0));
    }
}
