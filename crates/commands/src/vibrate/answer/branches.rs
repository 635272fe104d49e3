//! Natural frequencies over the input speed, and their intersections with orders of excitation.
//!
//! In coordinates that rotate with the carrier, the frequencies change with its speed by the gyroscopic
//! effect ([`epicyclic_vibration::gyroscopic`]). A mode keeps its kind, so modes of one kind are identified
//! by their order. An intersection between two speeds is found by the false position method, with the modes
//! solved at each step.

use super::records::{Branch, Campbell, Order, Resonance};
use super::{Found, number};
use crate::tolerance::MET;
use epicyclic_units::Physical;
use epicyclic_vibration::Kind;
use epicyclic_vibration::{Centripetal, Error};
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use uom::si::f64::AngularVelocity;

/// Maximum number of steps of the false position method; about eight are usual.
const STEPS: u32 = 100;

/// Label of a mode: its number at rest, from 1, and its kind.
type Label = (u32, Kind);

/// Frequencies over the speeds.
pub(super) struct Branches<'a> {
    /// Called before each speed; a break ends the calculation.
    goes_on: &'a dyn Fn() -> ControlFlow<()>,
    /// Speed of the carrier relative to the input speed.
    carrier: f64,
    labels: Vec<Label>,
    /// Input speeds in rad/s with the frequencies in Hz.
    places: Vec<(f64, Vec<f64>)>,
}

impl<'a> Branches<'a> {
    /// Solves the modes at these input speeds in rad/s.
    pub(super) fn new(
        found: &Found,
        carrier: f64,
        speeds: &[f64],
        goes_on: &'a dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        let mut labels: Vec<Label> = vec![];
        for (index, group) in found.groups.iter().enumerate() {
            labels.extend(group.shapes.iter().map(|_| (number(index), group.kind)));
        }
        let mut all = Self { goes_on, carrier, labels, places: vec![] };
        for &speed in speeds {
            let at = all.at(found, speed)?;
            all.places.push((speed, at));
        }
        Ok(all)
    }

    /// Error if the caller ended the calculation.
    pub(super) fn check(&self) -> Result<(), Error> {
        if (self.goes_on)().is_break() { Err(Error::Cancelled) } else { Ok(()) }
    }

    /// Frequencies at an input speed in Hz, in the order of the labels.
    fn at(&self, found: &Found, speed: f64) -> Result<Vec<f64>, Error> {
        self.check()?;
        let turning = AngularVelocity::from_si(self.carrier * speed);
        if self.carrier == 0.0 {
            return Ok(found
                .groups
                .iter()
                .flat_map(|group| group.shapes.iter().map(|_| group.frequency.si()))
                .collect());
        }
        let central = &found.parts.members;
        let modes = found.model.whirl_modes(turning, Centripetal::WithBearingLoad, central)?;
        let of_kind = |kind: Kind| -> Vec<f64> {
            let own = modes.iter().filter(|mode| mode.kind == kind);
            own.map(|mode| mode.frequency.si()).collect()
        };
        let mut frequencies = vec![0.0; self.labels.len()];
        let kinds = [Kind::Rotational, Kind::Translational, Kind::Planet, Kind::Mixed];
        let mut is_sorted_by_kind = true;
        for kind in kinds {
            let places: Vec<usize> =
                (0..self.labels.len()).filter(|&place| self.labels[place].1 == kind).collect();
            let own = of_kind(kind);
            is_sorted_by_kind &= own.len() == places.len();
            places.into_iter().zip(own).for_each(|(place, frequency)| frequencies[place] = frequency);
        }
        // Modes of two kinds with equal frequency are classified as mixed; the modes are then matched in one
        // common order.
        if !is_sorted_by_kind {
            let mut order: Vec<usize> = (0..self.labels.len()).collect();
            if let Some((_, before)) = self.places.last() {
                order.sort_by(|a, b| before[*a].total_cmp(&before[*b]));
            }
            for (place, mode) in order.into_iter().zip(&modes) {
                frequencies[place] = mode.frequency.si();
            }
        }
        Ok(frequencies)
    }

    /// Speeds at which an order meets a mode that it can excite.
    pub(super) fn resonances(&self, found: &Found, order: &Order) -> Result<Vec<Resonance>, Error> {
        let mut all = vec![];
        for (place, &(mode, kind)) in self.labels.iter().enumerate() {
            if order.excites.is_some_and(|excited| excited != kind) && kind != Kind::Mixed {
                continue;
            }
            let above = |speed: f64, frequency: f64| frequency - order.of_input * speed.abs() / TAU;
            for pair in self.places.windows(2) {
                let [(low, at_low), (high, at_high)] = pair else { continue };
                let ends = [(*low, above(*low, at_low[place])), (*high, above(*high, at_high[place]))];
                // A zero mode meets every order at rest, which is not a resonance.
                if at_low[place] == 0.0 && at_high[place] == 0.0
                    || ends[0].1 * ends[1].1 > 0.0
                    || ends[0].1 == 0.0
                {
                    continue;
                }
                let (speed, frequency) = self.meeting(found, place, ends, &above)?;
                all.push(Resonance {
                    set: order.set.clone(),
                    gear: order.gear.clone(),
                    input_speed_rad_s: speed,
                    source: order.source,
                    part: order.part.clone(),
                    harmonic: order.harmonic,
                    mode,
                    kind,
                    frequency_hz: frequency,
                });
            }
        }
        // Modes of equal frequency that the speed does not separate count as one.
        all.dedup_by(|b, a| {
            let near = (a.input_speed_rad_s - b.input_speed_rad_s).abs();
            a.mode == b.mode && near <= MET.sqrt() * a.input_speed_rad_s.abs()
        });
        Ok(all)
    }

    /// Zero of a function of speed and frequency between two ends of opposite sign: the speed and the
    /// frequency, by the false position method (Illinois variant).
    fn meeting(
        &self,
        found: &Found,
        place: usize,
        [mut one, mut other]: [(f64, f64); 2],
        above: &impl Fn(f64, f64) -> f64,
    ) -> Result<(f64, f64), Error> {
        let mut last = (other.0, 0.0);
        for _ in 0..STEPS {
            let speed = (one.0 * other.1 - other.0 * one.1) / (other.1 - one.1);
            let frequency = self.at(found, speed)?[place];
            let error = above(speed, frequency);
            last = (speed, frequency);
            if error.abs() <= MET * frequency.abs() || (one.0 - other.0).abs() <= MET * speed.abs() {
                break;
            }
            if error * other.1 < 0.0 {
                one = other;
            } else {
                one.1 /= 2.0;
            }
            other = (speed, error);
        }
        Ok(last)
    }

    /// Converts the frequencies over the speeds into a record.
    pub(super) fn told(&self, set: &str, gear: &str, carrier: f64) -> Campbell {
        let branch = |(place, &(mode, kind)): (usize, &Label)| Branch {
            mode,
            kind,
            frequencies_hz: self.places.iter().map(|(_, frequencies)| frequencies[place]).collect(),
        };
        Campbell {
            set: set.to_owned(),
            gear: gear.to_owned(),
            carrier_speed_of_input: carrier,
            input_speeds_rad_s: self.places.iter().map(|(speed, _)| *speed).collect(),
            branches: self.labels.iter().enumerate().map(branch).collect(),
        }
    }
}
