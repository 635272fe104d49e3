//! Torque converters by their characteristic.
//!
//! ```text
//! ν = ω_t/ω_p    T_p = λ(ν)·ω_p²    T_t = μ(ν)·T_p    T_reactor = (μ − 1)·T_p
//! heat = T_p·ω_p − T_t·ω_t = T_p·ω_p·(1 − μ·ν)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `ω_p`, `ω_t` | speeds of impeller and turbine | rad/s |
//! | `T_p` | torque that the impeller takes | N·m |
//! | `T_t` | torque of the turbine | N·m |
//! | `λ` | capacity, `1/K²` with the K-factor `ω_p/√T_p` | N·m·s²/rad² |
//! | `μ` | torque ratio | 1 |
//!
//! `T_p` acts on the impeller's link as `−T_p`, `T_t` on the turbine's link as `T_t`. The characteristic is
//! that of a driven impeller: `λ` and `μ` are linear between the points of a table and level beyond them.
//! While the impeller is at rest or turns backwards the torque is 0. The oil keeps no energy. A lock-up
//! clutch is a friction element between the same links.

use crate::Error;
use crate::course::finite;
use crate::mechanism::Place;
use crate::tolerance::RANK;
use epicyclic_numerics::values::dot;

/// The characteristic of a torque converter.
#[derive(Debug, Clone, PartialEq)]
pub struct Converter {
    points: Vec<[f64; 3]>,
}

impl Converter {
    /// Converter from points of speed ratio `ν`, torque ratio `μ`, and capacity `λ` in N·m·s²/rad², in order
    /// of `ν`.
    ///
    /// # Errors
    /// - [`Error::NoPoints`];
    /// - [`Error::Value`] for a number that is not finite;
    /// - [`Error::Value`] also for an efficiency `μ·ν` at which the converter would give more power than it
    ///   takes, at a point or between two;
    /// - [`Error::Order`] for speed ratios that do not ascend.
    pub fn new(points: &[[f64; 3]]) -> Result<Self, Error> {
        let field = "the characteristic of a converter";
        if points.is_empty() {
            return Err(Error::NoPoints { field: field.into() });
        }
        for (place, point) in points.iter().enumerate() {
            finite("a speed ratio", point[0])?;
            finite("a torque ratio", point[1])?;
            finite("a capacity in N·m·s²/rad²", point[2])?;
            if place > 0 && point[0] <= points[place - 1][0] {
                return Err(Error::Order {
                    field: field.into(),
                    place: place + 1,
                    value: point[0],
                    before: points[place - 1][0],
                    unit: "",
                    allowed: "speed ratios ascend",
                });
            }
        }
        let made = Self { points: points.to_vec() };
        made.check_power()?;
        Ok(made)
    }

    /// `λ·(1 − μ·ν) ≥ 0` everywhere: where `λ` has one sign, the ends and the vertex of the parabola `μ·ν`
    /// decide; beyond the table, where `μ` and `λ` are level, its sign far out.
    fn check_power(&self) -> Result<(), Error> {
        let [first, last] = [self.points[0], self.points[self.points.len() - 1]];
        for (point, sign) in [(first, 1.0), (last, -1.0)] {
            if sign * point[1] * point[2] < 0.0 {
                return Err(Error::Value {
                    field: format!("the capacity of a converter at its outer speed ratio {}", point[0]),
                    value: point[2],
                    allowed: "it is 0 at the last point or, with a torque ratio above 0, below 0, and not below 0 at the first: \
                              it is level beyond them, and would give power there",
                });
            }
        }
        for point in [first, last].into_iter().filter(|point| point[2] != 0.0) {
            self.check_at(point[0], point[1], point[2].signum())?;
        }
        for pair in self.points.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let width = to[0] - from[0];
            let slope = (to[1] - from[1]) / width;
            let ratio = |at: f64| from[1] + slope * (at - from[0]);
            // Where d(μ·ν)/dν = 0, and where λ = 0.
            let vertex = 0.5 * (from[0] - from[1] / slope);
            let zero = from[0] - from[2] * width / (to[2] - from[2]);
            let mut ends = vec![from[0], to[0]];
            if zero > from[0] && zero < to[0] {
                ends.insert(1, zero);
            }
            for part in ends.windows(2) {
                let middle = 0.5 * (part[0] + part[1]);
                let sign = from[2] + (to[2] - from[2]) * (middle - from[0]) / width;
                let inside = Some(vertex).filter(|at| *at > part[0] && *at < part[1]);
                for at in [part[0], part[1]].into_iter().chain(inside) {
                    self.check_at(at, ratio(at), if sign == 0.0 { 0.0 } else { sign.signum() })?;
                }
            }
        }
        Ok(())
    }

    fn check_at(&self, speed_ratio: f64, torque_ratio: f64, sign: f64) -> Result<(), Error> {
        let efficiency = torque_ratio * speed_ratio;
        if sign * (1.0 - efficiency) < -RANK {
            let field = format!("the efficiency μ·ν of a converter at the speed ratio {speed_ratio}");
            let allowed = "it is at most 1 where the capacity is above 0, and at least 1 where it is below 0";
            return Err(Error::Value { field, value: efficiency, allowed });
        }
        Ok(())
    }

    /// Segment of a speed ratio, one at a point counted as `is_rising` says.
    pub(crate) fn segment(&self, ratio: f64, is_rising: bool) -> usize {
        self.points.partition_point(|point| if is_rising { point[0] <= ratio } else { point[0] < ratio })
    }

    /// `μ` and `λ` at a speed ratio, in this segment.
    pub(crate) fn at(&self, segment: usize, speed_ratio: f64) -> [f64; 2] {
        match (segment.checked_sub(1).map(|one| self.points[one]), self.points.get(segment)) {
            (Some(from), Some(to)) => {
                let part = (speed_ratio - from[0]) / (to[0] - from[0]);
                [1, 2].map(|one| from[one] + part * (to[one] - from[one]))
            }
            (Some(last), None) => [last[1], last[2]],
            (None, _) => [self.points[0][1], self.points[0][2]],
        }
    }
}

/// Mode of a converter between two events.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Drive {
    /// The impeller is at rest or turns backwards.
    Idle,
    /// The speed ratio is in this segment.
    Segment(usize),
}

/// A converter in a model.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Coupling {
    pub(crate) name: String,
    /// Impeller and turbine.
    pub(crate) places: [Place; 2],
    pub(crate) speeds: [Vec<f64>; 2],
    pub(crate) converter: Converter,
}

impl Coupling {
    /// Mode at these speeds.
    pub(crate) fn drive(&self, y: &[f64]) -> Drive {
        let [impeller, turbine] = [0, 1].map(|one| dot(&self.speeds[one], y));
        if impeller > 0.0 {
            Drive::Segment(self.converter.segment(turbine / impeller, true))
        } else {
            Drive::Idle
        }
    }

    /// Torques on impeller and turbine, and the heat of the oil.
    pub(crate) fn torques(&self, drive: Drive, y: &[f64]) -> ([f64; 2], f64) {
        let [impeller, turbine] = [0, 1].map(|one| dot(&self.speeds[one], y));
        match drive {
            Drive::Segment(segment) if impeller > 0.0 => {
                let [ratio, capacity] = self.converter.at(segment, turbine / impeller);
                let taken = capacity * impeller * impeller;
                ([-taken, ratio * taken], taken * (impeller - ratio * turbine))
            }
            _ => ([0.0, 0.0], 0.0),
        }
    }

    /// Margins: the impeller to its rest, the speed ratio to the lower and to the upper end of its segment.
    pub(crate) fn margins(&self, drive: Drive, y: &[f64], guard: f64) -> [Option<f64>; 3] {
        let [impeller, turbine] = [0, 1].map(|one| dot(&self.speeds[one], y));
        match drive {
            Drive::Idle => [Some(guard - impeller), None, None],
            Drive::Segment(segment) => {
                let end = |place: usize| {
                    self.converter.points.get(place).map(|point| turbine - point[0] * impeller)
                };
                let lower = segment.checked_sub(1).and_then(end).map(|above| above + guard);
                [Some(impeller + guard), lower, end(segment).map(|above| guard - above)]
            }
        }
    }

    /// Mode after one of its margins has ended.
    pub(crate) fn next(&self, drive: Drive, margin: usize, y: &[f64]) -> Drive {
        match (drive, margin) {
            (Drive::Segment(segment), 1) => Drive::Segment(segment - 1),
            (Drive::Segment(segment), 2) => Drive::Segment(segment + 1),
            (Drive::Segment(_), _) => Drive::Idle,
            (Drive::Idle, _) => {
                let [impeller, turbine] = [0, 1].map(|one| dot(&self.speeds[one], y));
                let ratio = if turbine == 0.0 { 0.0 } else { turbine / impeller.max(f64::MIN_POSITIVE) };
                Drive::Segment(self.converter.segment(ratio, true))
            }
        }
    }
}
