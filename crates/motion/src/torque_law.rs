//! Torques of sources and loads on a link, over time or over its speed.
//!
//! | law | torque on the link |
//! |---|---|
//! | over time | a [`Course`] |
//! | linear | `M_0·(1 − ω/ω_0)` |
//! | over speed | linear between the points of a table, level beyond them |
//! | map | `(1 − α)·M_closed(ω) + α·M_full(ω)`, both tables, with a throttle `α` over time |
//! | constant power | `P/ω` from `ω = P/M_max` on, `M_max` below |
//! | viscous | `−M_r·ω/ω_r` |
//! | quadratic | `−M_r·ω·abs(ω)/ω_r²` |
//! | Kloss | `2·M_k·s·s_k/(s² + s_k²)`, `s = 1 − ω/ω_0` |
//!
//! The Kloss motor takes `M·ω_0` through its air gap and gives `M·ω`; the rest, `M·(ω_0 − ω)`, heats the
//! rotor and is reported as its inner loss. Kloss, Arch. Elektrotechnik 5 (1916) 59, with the form
//! `2·M_k/(s/s_k + s_k/s)`, which is the same without its hole at `s = 0`; stator resistance and all
//! transients of the current are neglected.

use crate::Error;
use crate::course::{Course, Piece, finite};
use crate::table;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Power, Time, Torque};

/// A torque on a link, positive along the axis.
#[derive(Debug, Clone, PartialEq)]
pub struct TorqueLaw(pub(crate) Law);

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Law {
    Time(Course),
    Linear {
        at_rest: f64,
        slope: f64,
    },
    /// Speeds and torques.
    Speed(Vec<[f64; 2]>),
    /// Torque over speed with the throttle closed and open, at the same speeds; the throttle over time.
    Map {
        closed: Vec<[f64; 2]>,
        full: Vec<[f64; 2]>,
        throttle: Course,
    },
    Power {
        power: f64,
        limit: f64,
    },
    Quadratic {
        factor: f64,
    },
    Kloss {
        peak: f64,
        peak_slip: f64,
        synchronous: f64,
    },
}

impl TorqueLaw {
    /// Always the same.
    ///
    /// # Errors
    /// [`Error::Value`] unless finite.
    pub fn constant(torque: Torque) -> Result<Self, Error> {
        Ok(Self::over_time(Course::constant(torque)?))
    }

    /// Over time.
    #[must_use]
    pub fn over_time(course: Course) -> Self {
        Self(Law::Time(course))
    }

    /// `M_0·(1 − ω/ω_0)`: that of a shunt motor, with `M_0` at rest and none at `ω_0`.
    ///
    /// # Errors
    /// [`Error::Value`] of a number that is not finite, and of `ω_0 = 0`.
    pub fn linear(at_rest: Torque, no_load: AngularVelocity) -> Result<Self, Error> {
        let at_rest = finite("the torque at rest in N·m", at_rest.si())?;
        let no_load = not_zero("the no-load speed in rad/s", no_load.si())?;
        Ok(Self(Law::Linear { at_rest, slope: -at_rest / no_load }))
    }

    /// Linear between points in order of speed, level beyond them.
    ///
    /// # Errors
    /// [`Error::NoPoints`]; [`Error::Value`] of a number that is not finite; [`Error::Order`] of speeds that
    /// do not ascend.
    pub fn over_speed(points: &[(AngularVelocity, Torque)]) -> Result<Self, Error> {
        Ok(Self(Law::Speed(speed_table(points)?)))
    }

    /// An engine by two curves over speed, with its throttle closed and full open, and by the throttle over
    /// time, from 0 to 1: `(1 − α)·M_closed(ω) + α·M_full(ω)`. All are linear between their points and level
    /// beyond them.
    ///
    /// # Errors
    /// As [`over_speed`](Self::over_speed) and [`Course::table`]; [`Error::Value`] of a throttle that is not
    /// from 0 to 1.
    pub fn map(
        closed: &[(AngularVelocity, Torque)],
        full: &[(AngularVelocity, Torque)],
        throttle: &[(Time, f64)],
    ) -> Result<Self, Error> {
        for (_, opening) in throttle {
            if !(0.0..=1.0).contains(opening) {
                let field = "the throttle".into();
                return Err(Error::Value { field, value: *opening, allowed: "it is from 0 to 1" });
            }
        }
        let throttle: Vec<_> =
            throttle.iter().map(|&(time, opening)| (time, Torque::from_si(opening))).collect();
        let throttle = Course::table(&throttle)?;
        let [closed, full] = [speed_table(closed)?, speed_table(full)?];
        // With the speeds of both curves in both tables, one segment is enough for the two of them.
        let mut speeds: Vec<f64> = closed.iter().chain(&full).map(|point| point[0]).collect();
        speeds.sort_by(f64::total_cmp);
        speeds.dedup();
        let at_all = |points: &[[f64; 2]]| -> Vec<[f64; 2]> {
            let at = |&speed: &f64| [speed, table::value(points, table::segment(points, speed, true), speed)];
            speeds.iter().map(at).collect()
        };
        Ok(Self(Law::Map { closed: at_all(&closed), full: at_all(&full), throttle }))
    }

    /// `P/ω` from the base speed `P/M_max` on, and `M_max` below it and backwards; both below 0 of a brake
    /// that recovers power.
    ///
    /// # Errors
    /// [`Error::Value`] of a power or torque that is not finite or is 0, and of two that have different
    /// signs.
    pub fn constant_power(power: Power, limit: Torque) -> Result<Self, Error> {
        let power = not_zero("the constant power in W", power.si())?;
        let limit = not_zero("the limit torque of a constant power in N·m", limit.si())?;
        if power * limit < 0.0 {
            return Err(Error::Value {
                field: "the limit torque of a constant power in N·m".into(),
                value: limit,
                allowed: "it has the sign of the power",
            });
        }
        Ok(Self(Law::Power { power, limit }))
    }

    /// Against the speed and proportional to it: `torque` at `speed`.
    ///
    /// # Errors
    /// [`Error::Value`] of a number that is not finite, of a torque below 0, and of a speed that is not above
    /// 0.
    pub fn viscous(torque: Torque, speed: AngularVelocity) -> Result<Self, Error> {
        let [torque, speed] = resistance(torque, speed)?;
        Ok(Self(Law::Linear { at_rest: 0.0, slope: -torque / speed }))
    }

    /// Against the speed and proportional to its square: `torque` at `speed`.
    ///
    /// # Errors
    /// As [`viscous`](Self::viscous).
    pub fn quadratic(torque: Torque, speed: AngularVelocity) -> Result<Self, Error> {
        let [torque, speed] = resistance(torque, speed)?;
        Ok(Self(Law::Quadratic { factor: torque / (speed * speed) }))
    }

    /// An induction motor by Kloss' formula: its peak torque, the slip `s_k` there, its synchronous speed
    /// `ω_0`.
    ///
    /// # Errors
    /// [`Error::Value`] of a number that is not finite, of a slip that is not above 0, and of `ω_0 = 0`.
    pub fn kloss(peak: Torque, peak_slip: f64, synchronous: AngularVelocity) -> Result<Self, Error> {
        let peak = finite("the peak torque in N·m", peak.si())?;
        let field = "the slip at the peak torque";
        if finite(field, peak_slip)? <= 0.0 {
            return Err(Error::Value { field: field.into(), value: peak_slip, allowed: "it is above 0" });
        }
        let synchronous = not_zero("the synchronous speed in rad/s", synchronous.si())?;
        Ok(Self(Law::Kloss { peak, peak_slip, synchronous }))
    }
}

/// Points of a torque over speed.
fn speed_table(points: &[(AngularVelocity, Torque)]) -> Result<Vec<[f64; 2]>, Error> {
    let points: Vec<[f64; 2]> = points.iter().map(|(speed, torque)| [speed.si(), torque.si()]).collect();
    if points.is_empty() {
        return Err(Error::NoPoints { field: "a torque over speed".into() });
    }
    for (place, [speed, torque]) in points.iter().enumerate() {
        finite("a speed in rad/s", *speed)?;
        finite("a torque in N·m", *torque)?;
        if place > 0 && *speed <= points[place - 1][0] {
            return Err(Error::Order {
                field: "a torque over speed".into(),
                place: place + 1,
                value: *speed,
                before: points[place - 1][0],
                unit: "rad/s",
                allowed: "speeds ascend",
            });
        }
    }
    Ok(points)
}

fn not_zero(field: &str, value: f64) -> Result<f64, Error> {
    if finite(field, value)? == 0.0 {
        return Err(Error::Value { field: field.into(), value, allowed: "it is not 0" });
    }
    Ok(value)
}

fn resistance(torque: Torque, speed: AngularVelocity) -> Result<[f64; 2], Error> {
    let torque = crate::mechanism::not_negative("the resisting torque in N·m".into(), torque.si())?;
    let speed = finite("its speed in rad/s", speed.si())?;
    if speed <= 0.0 {
        return Err(Error::Value {
            field: "its speed in rad/s".into(),
            value: speed,
            allowed: "it is above 0",
        });
    }
    Ok([torque, speed])
}

impl Law {
    /// Torque at a time and speed, in this piece of its course or table.
    pub(crate) fn at(&self, time: &Piece, segment: usize, t: f64, speed: f64) -> f64 {
        match self {
            Self::Time(_) => time.at(t),
            Self::Linear { at_rest, slope } => at_rest + slope * speed,
            Self::Speed(points) => table::value(points, segment, speed),
            Self::Map { closed, full, .. } => {
                let [closed, full] = [closed, full].map(|points| table::value(points, segment, speed));
                closed + time.at(t) * (full - closed)
            }
            Self::Power { limit, .. } if segment == 0 => *limit,
            Self::Power { power, .. } => power / speed,
            Self::Quadratic { factor } => -factor * speed * speed.abs(),
            Self::Kloss { peak, peak_slip, synchronous } => {
                // This form has no hole at a slip of 0, as s_k/s would have.
                let slip = 1.0 - speed / synchronous;
                2.0 * peak * slip * peak_slip / (slip * slip + peak_slip * peak_slip)
            }
        }
    }

    /// Power that the source turns into heat within itself.
    pub(crate) fn inner_loss(&self, torque: f64, speed: f64) -> f64 {
        match self {
            Self::Kloss { synchronous, .. } => torque * (synchronous - speed),
            _ => 0.0,
        }
    }

    /// Course over time of the law: its torque, or a throttle.
    pub(crate) fn course(&self) -> Option<&Course> {
        match self {
            Self::Time(course) | Self::Map { throttle: course, .. } => Some(course),
            _ => None,
        }
    }

    /// The piece of this that begins at a time.
    pub(crate) fn piece(&self, t: f64) -> Piece {
        self.course().map_or(Piece::ZERO, |course| course.piece(t))
    }

    /// Segment of a table over speed: how many points are below this speed, one on a point counted as
    /// `is_rising` says.
    pub(crate) fn segment(&self, speed: f64, is_rising: bool) -> usize {
        match self {
            Self::Speed(points) | Self::Map { closed: points, .. } => {
                table::segment(points, speed, is_rising)
            }
            Self::Power { power, limit } => usize::from(speed >= power / limit),
            _ => 0,
        }
    }

    /// Speeds at which a segment begins and ends.
    pub(crate) fn ends(&self, segment: usize) -> [Option<f64>; 2] {
        match self {
            Self::Speed(points) | Self::Map { closed: points, .. } => table::ends(points, segment),
            Self::Power { power, limit } if segment == 0 => [None, Some(power / limit)],
            Self::Power { power, limit } => [Some(power / limit), None],
            _ => [None, None],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(law: &TorqueLaw, speed: f64) -> f64 {
        law.0.at(&law.0.piece(0.0), law.0.segment(speed, true), 0.0, speed)
    }

    #[test]
    fn every_law_by_hand() {
        let omega = AngularVelocity::from_si;
        assert_eq!(at(&TorqueLaw::constant(Torque::from_si(7.0)).unwrap(), 3.0), 7.0);
        assert_eq!(at(&TorqueLaw::linear(Torque::from_si(40.0), omega(100.0)).unwrap(), 25.0), 30.0);
        assert_eq!(at(&TorqueLaw::viscous(Torque::from_si(8.0), omega(2.0)).unwrap(), -3.0), 12.0);
        assert_eq!(at(&TorqueLaw::quadratic(Torque::from_si(8.0), omega(2.0)).unwrap(), -3.0), 18.0);
        let motor = TorqueLaw::kloss(Torque::from_si(60.0), 0.2, omega(100.0)).unwrap();
        assert!((at(&motor, 80.0) - 60.0).abs() < 1e-12);
        assert_eq!(at(&motor, 100.0), 0.0);
        let power = TorqueLaw::constant_power(Power::from_si(600.0), Torque::from_si(30.0)).unwrap();
        assert_eq!([-5.0, 10.0, 20.0, 40.0].map(|speed| at(&power, speed)), [30.0, 30.0, 30.0, 15.0]);
        let table = [
            (omega(0.0), Torque::from_si(1.0)),
            (omega(2.0), Torque::from_si(5.0)),
            (omega(4.0), Torque::from_si(0.0)),
        ];
        let table = TorqueLaw::over_speed(&table).unwrap();
        let found = [-1.0, 0.0, 1.0, 2.0, 3.0, 9.0].map(|speed| at(&table, speed));
        assert_eq!(found, [1.0, 1.0, 3.0, 5.0, 2.5, 0.0]);
    }

    #[test]
    fn what_is_no_law_is_refused() {
        let omega = AngularVelocity::from_si;
        assert!(matches!(TorqueLaw::linear(Torque::from_si(1.0), omega(0.0)), Err(Error::Value { .. })));
        assert!(matches!(TorqueLaw::viscous(Torque::from_si(-1.0), omega(1.0)), Err(Error::Value { .. })));
        assert!(matches!(TorqueLaw::quadratic(Torque::from_si(1.0), omega(0.0)), Err(Error::Value { .. })));
        assert!(matches!(TorqueLaw::kloss(Torque::from_si(1.0), 0.0, omega(1.0)), Err(Error::Value { .. })));
        let curve = [(omega(0.0), Torque::from_si(1.0))];
        let wide = TorqueLaw::map(&curve, &curve, &[(Time::from_si(0.0), 1.1)]);
        assert!(matches!(wide, Err(Error::Value { .. })));
        assert!(matches!(
            TorqueLaw::map(&curve, &[], &[(Time::from_si(0.0), 1.0)]),
            Err(Error::NoPoints { .. })
        ));
        let power = TorqueLaw::constant_power(Power::from_si(600.0), Torque::from_si(-30.0));
        assert!(matches!(power, Err(Error::Value { .. })));
        assert!(matches!(TorqueLaw::over_speed(&[]), Err(Error::NoPoints { .. })));
        let level = [(omega(1.0), Torque::from_si(1.0)), (omega(1.0), Torque::from_si(2.0))];
        assert!(matches!(TorqueLaw::over_speed(&level), Err(Error::Order { .. })));
    }
}
