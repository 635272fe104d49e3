//! Speeds of cutters: what the bits of a mining machine need.
//!
//! # Source
//! multispeed-gearboxes (2.1)–(2.4).

use crate::Error;
use crate::quantity::Quantity;
use epicyclic_units::Physical;
use uom::si::f64::{Force, Length, Velocity};

/// Cutting speed of a chain cutter.
///
/// ```text
/// v_p = 1.07·l_cp·v_n/h_cp        l_cp in m, v_n in m/min, h_cp in cm
///     = 0.642·l_cp·v_n/h_cp       in one set of units
/// ```
///
/// | symbol | argument | meaning |
/// |---|---|---|
/// | `l_cp` | `pick_spacing` | mean spacing of picks in a cutting line |
/// | `v_n` | `feed` | feed of the machine |
/// | `h_cp` | `mean_chip` | mean thickness of the chip |
///
/// The factor is the source's. A chip of greatest thickness `h = l·v_n/v_p` and mean `2h/π` would give
/// `(100/60)·(2/π) = 1.061`.
///
/// # Errors
/// [`Error::NotPositive`].
///
/// # Source
/// (2.1).
pub fn chain_speed(pick_spacing: Length, feed: Velocity, mean_chip: Length) -> Result<Velocity, Error> {
    lengths([(Quantity::PickSpacing, pick_spacing), (Quantity::MeanChip, mean_chip)])?;
    speed(Quantity::Feed, feed)?;
    Ok(feed * (pick_spacing / mean_chip).value * (1.07 * 60.0 / 100.0))
}

/// Cutting speed of a drum or auger.
///
/// ```text
/// v_p = 5.24·D·v_n/(h_max·m_p)    D in m, v_n in m/min, h_max in cm
///     = π·D·v_n/(h_max·m_p)       in one set of units, 5.24 being 100·π/60 = 5.236
/// ```
///
/// | symbol | argument | meaning |
/// |---|---|---|
/// | `D` | `diameter` | diameter over the picks |
/// | `v_n` | `feed` | feed of the machine |
/// | `h_max` | `greatest_chip` | greatest thickness of the chip |
/// | `m_p` | `picks_per_line` | picks in a cutting line |
///
/// ```
/// use epicyclic_schemes::cutting::drum_speed;
/// use uom::si::f64::{Length, Velocity};
/// use uom::si::length::{centimeter, meter};
/// use uom::si::velocity::meter_per_second;
/// # fn main() -> Result<(), epicyclic_schemes::Error> {
/// let (drum, chip) = (Length::new::<meter>(1.4), Length::new::<centimeter>(5.0));
/// let speed = drum_speed(drum, Velocity::new::<meter_per_second>(4.0 / 60.0), chip, 2)?;
/// assert!((speed.get::<meter_per_second>() - 5.24 * 1.4 * 4.0 / (5.0 * 2.0)).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Error::NotPositive`].
///
/// # Source
/// (2.2), with its 5.24.
pub fn drum_speed(
    diameter: Length,
    feed: Velocity,
    greatest_chip: Length,
    picks_per_line: u32,
) -> Result<Velocity, Error> {
    lengths([(Quantity::DrumDiameter, diameter), (Quantity::GreatestChip, greatest_chip)])?;
    speed(Quantity::Feed, feed)?;
    positive(Quantity::PicksPerLine, f64::from(picks_per_line), "")?;
    let turns = (diameter / greatest_chip).value / f64::from(picks_per_line);
    Ok(feed * turns * (5.24 * 60.0 / 100.0))
}

/// Cutting speed in other rock, at the power of the first: `v_p′ = v_p·P_cp/P_cp′`.
///
/// | symbol | argument | meaning |
/// |---|---|---|
/// | `v_p` | `speed` | cutting speed |
/// | `P_cp`, `P_cp′` | `force`, `other_force` | mean cutting forces there and here |
///
/// # Errors
/// [`Error::NotPositive`].
///
/// # Source
/// (2.3).
pub fn speed_at_force(cutting: Velocity, force: Force, other_force: Force) -> Result<Velocity, Error> {
    speed(Quantity::CuttingSpeed, cutting)?;
    positive(Quantity::CuttingForce, force.si(), "N")?;
    positive(Quantity::OtherCuttingForce, other_force.si(), "N")?;
    Ok(cutting * (force / other_force).value)
}

/// Feed that keeps the chip at another cutting speed: `v_n′/v_p′ = v_n/v_p`.
///
/// # Errors
/// [`Error::NotPositive`].
///
/// # Source
/// (2.4).
pub fn matching_feed(feed: Velocity, cutting: Velocity, other_cutting: Velocity) -> Result<Velocity, Error> {
    speed(Quantity::Feed, feed)?;
    speed(Quantity::CuttingSpeed, cutting)?;
    speed(Quantity::OtherCuttingSpeed, other_cutting)?;
    Ok(feed * (other_cutting / cutting).value)
}

fn lengths(of: [(Quantity, Length); 2]) -> Result<(), Error> {
    of.into_iter().try_for_each(|(what, length)| positive(what, length.si(), "m"))
}

fn speed(what: Quantity, speed: Velocity) -> Result<(), Error> {
    positive(what, speed.si(), "m/s")
}

pub(crate) fn positive(quantity: Quantity, value: f64, unit: &'static str) -> Result<(), Error> {
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(Error::NotPositive { quantity, value, unit }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use uom::si::length::centimeter;

    #[test]
    fn the_sources_units_give_its_factors() {
        let (feed, chip) = (Velocity::from_si(5.0 / 60.0), Length::new::<centimeter>(4.0));
        let chain = chain_speed(Length::from_si(0.4), feed, chip).unwrap();
        assert!((chain.si() - 1.07 * 0.4 * 5.0 / 4.0).abs() < 1e-12);
        let drum = drum_speed(Length::from_si(1.25), feed, chip, 3).unwrap();
        assert!((drum.si() - 5.24 * 1.25 * 5.0 / (4.0 * 3.0)).abs() < 1e-12);
    }

    #[test]
    fn harder_rock_is_cut_slower_at_the_same_chip() {
        let v = Velocity::from_si;
        let slower = speed_at_force(v(3.0), Force::from_si(4e3), Force::from_si(6e3)).unwrap();
        assert!((slower.si() - 2.0).abs() < 1e-12);
        let feed = matching_feed(v(0.09), v(3.0), slower).unwrap();
        assert!((feed.si() - 0.06).abs() < 1e-12);
    }

    #[test]
    fn what_does_not_cut_is_refused() {
        let (v, l) = (Velocity::from_si, Length::from_si);
        assert!(chain_speed(l(0.4), v(0.0), l(0.04)).is_err());
        assert!(drum_speed(l(1.4), v(0.1), l(-1.0), 2).is_err());
        assert!(drum_speed(l(1.4), v(0.1), l(0.05), 0).is_err());
        assert!(speed_at_force(v(1.0), Force::from_si(f64::NAN), Force::from_si(1.0)).is_err());
        assert!(matching_feed(v(1.0), v(0.0), v(1.0)).is_err());
    }
}
