//! Pressure in a chamber that is closed to both pressures.
//!
//! About an extreme the area of a chamber is `A = A_ext + ½·A″·u²` in the rotation `u` from it. A chamber
//! that closes a rotation `ε` before the extreme holds the oil of that instant. So its pressure changes until
//! the extreme by:
//!
//! ```text
//! p = K·½·|A″|·ε²/(A_ext + A_dead)
//! ```
//!
//! The pressure rises at the least area and falls at the greatest. The angle in which it rises on its own by
//! `p` is `ε = √(2·p·(A + A_dead)/(K·|A″|))`. The volume that a chamber still has at its least must be
//! brought from the low to the high pressure as it opens. This takes per revolution:
//!
//! ```text
//! V = N·n·(A_min + A_dead)·b·Δp/K
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `K` | `bulk_modulus` | bulk modulus of the fluid, with the air in it | Pa |
//! | `A_dead` | `dead_area` | volume of port and gaps that stays joined with a chamber, over the width | m² |
//! | `A″` | | second derivative of the area by the rotation | m²/rad² |
//!
//! All are of first order in `p/K`. Leaks, which relieve a slow motor, and the flow through the gaps of the
//! teeth are left out.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Area, Length, Pressure, Volume};

use crate::Error;
use crate::contact::Conjugate;
use crate::modules::area;
use crate::motor::Motor;
use crate::ports::PortPlate;
use crate::ports::timing::{AtExtreme, Closed, Stretch, Timing};
use crate::quantity::Quantity;
use crate::ranges::{self, finite_angle, finite_pressure, positive, positive_pressure, ranging};
use crate::tolerance::WITHIN;

/// A chamber at its greatest or least.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// Area of the chamber.
    pub area: Area,
    /// `A″`, the second derivative of its area by the rotation, a squared radian.
    pub bend: Area,
}

impl Extreme {
    /// The change of pressure that a closed angle on one side of the extreme makes; not below 0.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for the closed angle, which is not below 0, and the dead area;
    /// [`Error::NotPositive`] for the others.
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::ports::trapped::Extreme;
    /// use uom::si::f64::{Angle, Area, Pressure};
    /// use uom::si::{angle::degree, area::square_millimeter, pressure::gigapascal};
    /// use uom::si::pressure::megapascal;
    ///
    /// let mm2 = Area::new::<square_millimeter>;
    /// let least = Extreme { area: mm2(27.84), bend: mm2(156.7) };
    /// let bulk_modulus = Pressure::new::<gigapascal>(1.4);
    /// let rise = least.trapped_pressure(Angle::new::<degree>(1.38), bulk_modulus, mm2(0.0))?;
    /// assert!((rise.get::<megapascal>() - 2.3).abs() < 0.05);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn trapped_pressure(
        &self,
        closed: Angle,
        bulk_modulus: Pressure,
        dead_area: Area,
    ) -> Result<Pressure, Error> {
        let (own, bend) = self.checked()?;
        let closed = from_zero(closed)?;
        let modulus = ranges::bulk_modulus(bulk_modulus)?;
        let dead = ranges::dead_area(dead_area)?;
        Ok(Pressure::from_si(modulus * 0.5 * bend * closed * closed / (own + dead)))
    }

    /// The closed angle before the extreme in which a chamber changes its pressure by so much.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::OutOfRange`] for the dead area.
    pub fn precompression_angle(
        &self,
        rise: Pressure,
        bulk_modulus: Pressure,
        dead_area: Area,
    ) -> Result<Angle, Error> {
        let (own, bend) = self.checked()?;
        let rise = positive_pressure(Quantity::PressureDrop, rise)?.si();
        let modulus = ranges::bulk_modulus(bulk_modulus)?;
        let dead = ranges::dead_area(dead_area)?;
        Ok(Angle::from_si((2.0 * rise * (own + dead) / (modulus * bend)).sqrt()))
    }

    fn checked(&self) -> Result<(f64, f64), Error> {
        let own = positive(Quantity::ChamberArea, self.area.mm2(), "mm²").map(|_| self.area.si())?;
        let bend = self.bend.si().abs();
        Ok((own, positive(Quantity::ChamberBend, bend, "m²/rad²")?))
    }
}

fn from_zero(closed: Angle) -> Result<f64, Error> {
    let value = closed.degrees();
    ranging(Quantity::ClosedAngle, value, [0.0, f64::INFINITY], "°")?;
    Ok(closed.si())
}

/// Effect of a closed stretch on the pressure in a chamber.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trapped {
    /// The stretch.
    pub stretch: Stretch,
    /// The extreme within it.
    pub extreme: Option<AtExtreme>,
    /// The greatest change of the pressure since the chamber was closed; below 0 where it falls.
    pub change: Pressure,
}

impl Motor {
    /// The chamber at its least and at its greatest.
    #[must_use]
    pub fn extremes_of_chambers(&self) -> [Extreme; 2] {
        let half = 0.5 * self.chamber_phase();
        let bend = |middle: f64| self.shape.flow(middle + half).1 - self.shape.flow(middle - half).1;
        let [least, greatest] = self.chamber_extremes();
        let of = |own: Area, middle: f64| Extreme { area: own, bend: area(bend(middle), self.module()) };
        [of(least, self.shape.trough().phase), of(greatest, 0.0)]
    }

    /// The oil that chambers take a revolution to come from the low to the high pressure, at the width `b`;
    /// over `q` the loss of volume.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for width and bulk modulus, [`Error::NotFinite`] for the pressure,
    /// [`Error::OutOfRange`] for the dead area.
    pub fn dead_volume_charge(
        &self,
        width: Length,
        pressure_drop: Pressure,
        bulk_modulus: Pressure,
        dead_area: Area,
    ) -> Result<Volume, Error> {
        let width = crate::machine::width(width)?.si();
        let drop = finite_pressure(Quantity::PressureDrop, pressure_drop)?.si();
        let modulus = ranges::bulk_modulus(bulk_modulus)?;
        let dead = ranges::dead_area(dead_area)?;
        let lobes = f64::from(self.numbers().stator_lobes() * self.numbers().rotor_lobes());
        let least = self.chamber_extremes()[0].si();
        Ok(Volume::from_si(lobes * (least + dead) * width * drop / modulus))
    }
}

impl PortPlate {
    /// The area of a chamber at a phase, in square metres.
    fn chamber_area(&self, phase: f64) -> Result<f64, Error> {
        let rotation = Angle::from_si(phase - 0.5 * self.motor.chamber_phase());
        Ok(self.motor.chambers(rotation)?[0].area.si())
    }

    /// Effects of all closed stretches on the pressure, with the exact areas:
    /// `K·(A(closing) − A)/(A + A_dead)` where it is greatest.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the bulk modulus, [`Error::OutOfRange`] for the dead area.
    pub fn trapped(
        &self,
        timing: &Timing,
        bulk_modulus: Pressure,
        dead_area: Area,
    ) -> Result<Vec<Trapped>, Error> {
        let modulus = ranges::bulk_modulus(bulk_modulus)?;
        let dead = ranges::dead_area(dead_area)?;
        let of = |closed: &Closed| {
            let Closed { stretch, extreme, before, .. } = *closed;
            let (from, to) = (stretch.from.si(), stretch.to.si());
            let at_closing = self.chamber_area(from)?;
            // Between closing, extreme and opening the area is monotone.
            let mut change = 0.0_f64;
            for place in [to, from + before.si()] {
                let here = self.chamber_area(place)?;
                let candidate = modulus * (at_closing - here) / (here + dead);
                if candidate.abs() > change.abs() {
                    change = candidate;
                }
            }
            Ok(Trapped { stretch, extreme, change: Pressure::from_si(change) })
        };
        timing.closed.iter().map(of).collect()
    }

    /// Pressure over the low one in a chamber at a phase, which is 0 at the chamber's greatest. It is that of
    /// the open port, and while the chamber is closed the previous pressure changed by compression; `None` in
    /// a short circuit.
    ///
    /// # Errors
    /// As [`PortPlate::trapped`]; [`Error::NotPositive`] for the pressure drop, [`Error::NotFinite`] for the
    /// phase.
    pub fn chamber_pressure(
        &self,
        timing: &Timing,
        phase: Angle,
        pressure_drop: Pressure,
        bulk_modulus: Pressure,
        dead_area: Area,
    ) -> Result<Option<Pressure>, Error> {
        let drop = positive_pressure(Quantity::PressureDrop, pressure_drop)?.si();
        let modulus = ranges::bulk_modulus(bulk_modulus)?;
        let dead = ranges::dead_area(dead_area)?;
        let (phase, cycle) = (finite_angle(Quantity::Rotation, phase)?, timing.cycle.si());
        // Angles by which a phase stands behind the beginning of a stretch that it is within.
        let behind = |stretch: &Stretch| {
            let behind = (phase - stretch.from.si()).rem_euclid(cycle);
            (behind <= stretch.to.si() - stretch.from.si()).then_some(behind)
        };
        let is_in = |all: &[Stretch]| all.iter().any(|stretch| behind(stretch).is_some());
        if is_in(&timing.short_circuits) {
            return Ok(None);
        }
        for closed in &timing.closed {
            let Some(behind) = behind(&closed.stretch) else { continue };
            let from = closed.stretch.from.si();
            let ends_here = |stretch: &Stretch| {
                let gap = (stretch.to.si() - from).rem_euclid(cycle);
                gap.min(cycle - gap) < WITHIN
            };
            let before = if timing.high.iter().any(ends_here) { drop } else { 0.0 };
            let (then, now) = (self.chamber_area(from)?, self.chamber_area(from + behind)?);
            return Ok(Some(Pressure::from_si(before + modulus * (then - now) / (now + dead))));
        }
        let pressure = if is_in(&timing.high) { drop } else { 0.0 };
        Ok(Some(Pressure::from_si(pressure)))
    }
}
