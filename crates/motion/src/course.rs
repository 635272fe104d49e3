//! A torque over time: constant, a table, harmonic.

use crate::Error;
use epicyclic_units::Physical;
use std::f64::consts::{FRAC_PI_2, TAU};
use uom::si::f64::{Angle, AngularVelocity, Time, Torque};

/// A torque over time.
///
/// Tables are linear between their points and constant before the first and after the last. Two points at one
/// time are a jump: before it holds the first, at it and after it the second.
///
/// ```
/// use epicyclic_motion::Course;
/// use uom::si::f64::{Time, Torque};
/// use uom::si::{time::second, torque::newton_meter};
/// # fn main() -> Result<(), epicyclic_motion::Error> {
/// let (s, n_m) = (Time::new::<second>, Torque::new::<newton_meter>);
/// let filled = Course::table(&[(s(0.1), n_m(0.0)), (s(0.1), n_m(20.0)), (s(0.5), n_m(100.0))])?;
/// assert_eq!(filled.at(s(0.05)), n_m(0.0));
/// assert_eq!(filled.at(s(0.1)), n_m(20.0));
/// assert_eq!(filled.at(s(0.3)), n_m(60.0));
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    form: Form,
    /// Whether values below 0 count as 0.
    is_clipped: bool,
}

#[derive(Debug, Clone, PartialEq)]
enum Form {
    Constant(f64),
    /// Times and torques.
    Table(Vec<[f64; 2]>),
    Harmonic {
        mean: f64,
        amplitude: f64,
        frequency: f64,
        phase: f64,
    },
}

/// A course where it has neither kink nor jump.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Piece {
    Line { from: f64, value: f64, slope: f64 },
    Harmonic { mean: f64, amplitude: f64, frequency: f64, phase: f64 },
}

impl Piece {
    pub(crate) const ZERO: Self = Self::Line { from: 0.0, value: 0.0, slope: 0.0 };

    pub(crate) fn at(&self, t: f64) -> f64 {
        match *self {
            Self::Line { from, value, slope } => value + slope * (t - from),
            Self::Harmonic { mean, amplitude, frequency, phase } => {
                mean + amplitude * libm::sin(frequency * t + phase)
            }
        }
    }
}

impl Course {
    /// Always the same.
    ///
    /// # Errors
    /// [`Error::Value`] unless finite.
    pub fn constant(torque: Torque) -> Result<Self, Error> {
        Ok(Self { form: Form::Constant(finite("the torque in N·m", torque.si())?), is_clipped: false })
    }

    /// Linear between points in order of time.
    ///
    /// # Errors
    /// [`Error::NoPoints`]; [`Error::Value`] of a number that is not finite; [`Error::Order`] of a time
    /// before that of the point before, or of three points at one time.
    pub fn table(points: &[(Time, Torque)]) -> Result<Self, Error> {
        let points: Vec<[f64; 2]> = points.iter().map(|(time, torque)| [time.si(), torque.si()]).collect();
        if points.is_empty() {
            return Err(Error::NoPoints { field: "a torque over time".into() });
        }
        for [time, torque] in &points {
            finite("a time in s", *time)?;
            finite("a torque in N·m", *torque)?;
        }
        for place in 1..points.len() {
            let is_third = place >= 2 && points[place][0] == points[place - 2][0];
            if points[place][0] < points[place - 1][0] || is_third {
                return Err(Error::Order {
                    field: "a torque over time".into(),
                    place: place + 1,
                    value: points[place][0],
                    before: points[place - 1][0],
                    unit: "s",
                    allowed: "times ascend, and a jump has two points at its time",
                });
            }
        }
        Ok(Self { form: Form::Table(points), is_clipped: false })
    }

    /// `mean + amplitude·sin(ω·t + φ)`.
    ///
    /// # Errors
    /// [`Error::Value`] of a number that is not finite, and of an angular frequency that is not above 0.
    pub fn harmonic(
        mean: Torque,
        amplitude: Torque,
        frequency: AngularVelocity,
        phase: Angle,
    ) -> Result<Self, Error> {
        let frequency = finite("the angular frequency in rad/s", frequency.si())?;
        if frequency <= 0.0 {
            let field = "the angular frequency in rad/s".into();
            return Err(Error::Value { field, value: frequency, allowed: "it is above 0" });
        }
        let form = Form::Harmonic {
            mean: finite("the mean torque in N·m", mean.si())?,
            amplitude: finite("the amplitude in N·m", amplitude.si())?,
            frequency,
            phase: finite("the phase in rad", phase.si())?,
        };
        Ok(Self { form, is_clipped: false })
    }

    /// The torque at a time.
    #[must_use]
    pub fn at(&self, time: Time) -> Torque {
        Torque::from_si(self.piece(time.si()).at(time.si()))
    }

    /// Returns the course as the capacity of a friction element: a harmonic below 0 is 0, and a constant or a
    /// table below 0 is refused.
    pub(crate) fn into_capacity(mut self, element: &str) -> Result<Self, Error> {
        let least = match &self.form {
            Form::Constant(value) => *value,
            Form::Table(points) => points.iter().map(|point| point[1]).fold(f64::INFINITY, f64::min),
            Form::Harmonic { .. } => 0.0,
        };
        self.is_clipped = true;
        crate::mechanism::not_negative(format!("the capacity of {element} in N·m"), least)?;
        Ok(self)
    }

    /// The piece that begins at a time, or holds there.
    pub(crate) fn piece(&self, t: f64) -> Piece {
        match &self.form {
            Form::Constant(value) => Piece::Line { from: 0.0, value: *value, slope: 0.0 },
            Form::Table(points) => {
                let after = points.partition_point(|point| point[0] <= t);
                let level = |point: [f64; 2]| Piece::Line { from: 0.0, value: point[1], slope: 0.0 };
                match (after.checked_sub(1).map(|before| points[before]), points.get(after)) {
                    (Some([from, value]), Some(next)) => {
                        Piece::Line { from, value, slope: (next[1] - value) / (next[0] - from) }
                    }
                    (Some(last), None) => level(last),
                    (None, _) => level(points[0]),
                }
            }
            &Form::Harmonic { mean, amplitude, frequency, phase } => {
                let piece = Piece::Harmonic { mean, amplitude, frequency, phase };
                let middle = self.next_kink(t).map_or(t, |next| 0.5 * (t + next));
                if self.is_clipped && piece.at(middle) <= 0.0 { Piece::ZERO } else { piece }
            }
        }
    }

    /// Whether the piece that begins at a time is nothing.
    pub(crate) fn is_zero(&self, t: f64) -> bool {
        matches!(self.piece(t), Piece::Line { value: 0.0, slope: 0.0, .. })
    }

    /// The next time at which another piece begins.
    pub(crate) fn next_kink(&self, t: f64) -> Option<f64> {
        match &self.form {
            Form::Constant(_) => None,
            Form::Table(points) => points.iter().map(|point| point[0]).find(|&time| time > t),
            &Form::Harmonic { mean, amplitude, frequency, phase } => {
                if !self.is_clipped || mean.abs() >= amplitude.abs() {
                    return None;
                }
                let zero = libm::asin(-mean / amplitude);
                // Both zeros of a period: in the middle between them stands a crest or trough.
                let half = FRAC_PI_2 - zero;
                let next = [FRAC_PI_2 - half, FRAC_PI_2 + half].map(|angle| {
                    let start = (angle - phase) / frequency;
                    let period = TAU / frequency;
                    let mut turns = ((t - start) / period).floor();
                    while start + turns * period <= t {
                        turns += 1.0;
                    }
                    start + turns * period
                });
                Some(next[0].min(next[1]))
            }
        }
    }

    /// The longest step over which it cannot hide a turn.
    pub(crate) fn longest_step(&self) -> f64 {
        match self.form {
            Form::Harmonic { frequency, .. } => FRAC_PI_2 / frequency,
            Form::Constant(_) | Form::Table(_) => f64::INFINITY,
        }
    }
}

/// A number that is finite.
pub(crate) fn finite(field: &str, value: f64) -> Result<f64, Error> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::Value { field: field.to_owned(), value, allowed: "it is finite" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_linear_between_its_points_and_level_beyond() {
        let course = Course::table(&[
            (Time::from_si(1.0), Torque::from_si(2.0)),
            (Time::from_si(3.0), Torque::from_si(6.0)),
        ])
        .unwrap();
        let at = |t| course.at(Time::from_si(t)).si();
        assert_eq!([at(0.0), at(1.0), at(2.0), at(3.0), at(9.0)], [2.0, 2.0, 4.0, 6.0, 6.0]);
        assert_eq!(course.next_kink(1.0), Some(3.0));
        assert_eq!(course.next_kink(3.0), None);
    }

    #[test]
    fn a_clipped_harmonic_has_kinks_at_its_zeros() {
        let course = Course::harmonic(
            Torque::from_si(1.0),
            Torque::from_si(2.0),
            AngularVelocity::from_si(3.0),
            Angle::from_si(0.4),
        )
        .unwrap();
        assert_eq!(course.next_kink(0.0), None);
        let course = course.into_capacity("C").unwrap();
        let mut t = 0.0;
        for _ in 0..7 {
            let next = course.next_kink(t).unwrap();
            assert!((1.0 + 2.0 * libm::sin(3.0 * next + 0.4)).abs() < 1e-12);
            let middle = 0.5 * (t + next);
            let due = (1.0 + 2.0 * libm::sin(3.0 * middle + 0.4)).max(0.0);
            assert!((course.piece(t).at(middle) - due).abs() < 1e-12);
            assert_eq!(course.is_zero(t), due == 0.0);
            t = next;
        }
    }

    #[test]
    fn what_is_no_course_is_refused() {
        let nan = Torque::from_si(f64::NAN);
        assert!(matches!(Course::constant(nan), Err(Error::Value { .. })));
        assert!(matches!(Course::table(&[]), Err(Error::NoPoints { .. })));
        let back = [(Time::from_si(1.0), Torque::from_si(0.0)), (Time::from_si(0.5), Torque::from_si(0.0))];
        assert!(matches!(Course::table(&back), Err(Error::Order { place: 2, .. })));
        let thrice = [(Time::from_si(1.0), Torque::from_si(0.0)); 3];
        assert!(matches!(Course::table(&thrice), Err(Error::Order { place: 3, .. })));
        let still = Course::harmonic(
            Torque::from_si(1.0),
            Torque::from_si(1.0),
            AngularVelocity::from_si(0.0),
            Angle::from_si(0.0),
        );
        assert!(matches!(still, Err(Error::Value { .. })));
        let negative = Course::constant(Torque::from_si(-1.0)).unwrap();
        assert!(matches!(negative.into_capacity("C"), Err(Error::Value { .. })));
    }
}
