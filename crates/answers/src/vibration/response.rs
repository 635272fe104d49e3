//! The forces of the meshes that transmission errors make, over the speed of the input.
//!
//! In axes on the carrier the tooth `l·z_s·(θ_s − ψ_n)/2π` of the sun is at the mesh with planet `n`, and what its harmonic `l` does meets the planets
//! one after the other. With `d = 1` where the sun drives the planets, and −1 where they drive it,
//!
//! ```text
//! e_s,n = a_s·cos(ω·t − d·l·z_s·ψ_n)     e_r,n = a_r·cos(ω·t − d·l·z_s·ψ_n + π·l·(z_p + 1))
//! ```
//!
//! since from the pitch point of the sun to that of the ring a planet has half its teeth and, from one flank to the other, half a pitch. `z_s + z_r` is
//! divisible by the number of planets, so the phases of the ring are those of the sun.
//!
//! The modes are those at rest. A peak between two speeds is looked for where a mode has the frequency of the harmonic, and found by the golden section.

use super::records::{Greatest, HarmonicResponse, Order, Response, Source};
use super::{Found, Of, Prepared};
use crate::Error;
use crate::number::plain;
use crate::tolerance::PEAK;
use epicyclic_formats::Physical;
use epicyclic_vibration::model::SpringId;
use epicyclic_vibration::response::Displacement;
use epicyclic_vibration::{Error as Refusal, Modes};
use std::f64::consts::{PI, TAU};
use uom::si::f64::{Angle, AngularVelocity, Length};

/// Speeds beside that of a resonance at which a curve is taken, over the damping ratio: where it bends.
const BESIDE_PEAK: [f64; 17] =
    [-16.0, -8.0, -4.0, -2.0, -1.0, -0.7, -0.4, -0.2, 0.0, 0.2, 0.4, 0.7, 1.0, 2.0, 4.0, 8.0, 16.0];

/// What the teeth do, and how the set is damped.
#[derive(Debug, Clone, PartialEq)]
pub struct Excitation {
    /// Amplitudes of the transmission error of a mesh of the sun, the first harmonic first.
    pub sun: Vec<Length>,
    /// The same of the ring.
    pub ring: Vec<Length>,
    /// Damping ratio of every mode.
    pub damping_ratio: f64,
}

impl Excitation {
    /// Damping ratios that are taken: a set with less would ring for thousands of periods, and one with more does not vibrate.
    pub const DAMPING_RATIOS: [f64; 2] = [1e-4, 1.0];

    /// Checks the numbers.
    ///
    /// # Errors
    /// [`Error::Harmonics`], [`Error::DampingRatio`], [`Error::TransmissionError`].
    pub(super) fn check(&self, most: u32) -> Result<(), Error> {
        let harmonics = self.sun.len().max(self.ring.len()) as u32;
        if !(1..=most).contains(&harmonics) {
            return Err(Error::Harmonics { harmonics, most });
        }
        let [low, high] = Self::DAMPING_RATIOS;
        if !(low..=high).contains(&self.damping_ratio) {
            return Err(Error::DampingRatio { given: self.damping_ratio, low, high });
        }
        let amplitudes = || self.sun.iter().chain(&self.ring).map(|amplitude| amplitude.si());
        if let Some(given_m) = amplitudes().find(|amplitude| !(0.0..f64::INFINITY).contains(amplitude)) {
            return Err(Error::TransmissionError { given_m });
        }
        if amplitudes().all(|amplitude| amplitude == 0.0) {
            return Err(Error::TransmissionError { given_m: 0.0 });
        }
        Ok(())
    }

    /// Amplitudes of a harmonic, from 1: of sun and ring.
    fn of(&self, harmonic: u32) -> [Length; 2] {
        let place = harmonic as usize - 1;
        [&self.sun, &self.ring].map(|all| all.get(place).copied().unwrap_or_default())
    }

    /// Harmonics that are given.
    pub(super) fn harmonics(&self) -> u32 {
        self.sun.len().max(self.ring.len()) as u32
    }
}

/// A set in a gear with what excites it.
pub(super) struct Excited<'a> {
    pub(super) of: &'a Of<'a>,
    pub(super) prepared: &'a Prepared,
    pub(super) found: &'a Found,
    pub(super) teeth: [u32; 3],
    /// Whether the sun drives the planets.
    pub(super) sun_drives: bool,
    pub(super) excitation: &'a Excitation,
}

impl Excited<'_> {
    /// The response to the harmonics of the meshes among the orders, at speeds of the input, rad/s.
    pub(super) fn response(&self, orders: &[Order], speeds: &[f64]) -> Result<Option<Response>, Error> {
        let refuse = |error: Refusal| self.of.refused(&["vibration"], &error);
        let modes = self.found.model.modes().map_err(refuse)?;
        let mut harmonics = vec![];
        for order in orders.iter().filter(|order| order.source == Source::Mesh) {
            if self.excitation.of(order.harmonic).iter().any(|amplitude| amplitude.si() > 0.0) {
                harmonics.extend(self.harmonic(&modes, order, speeds).map_err(refuse)?);
            }
        }
        let Some(first) = orders.first().filter(|_| !harmonics.is_empty()) else { return Ok(None) };
        Ok(Some(Response {
            set: first.set.clone(),
            gear: first.gear.clone(),
            damping_ratio: self.excitation.damping_ratio,
            harmonics,
        }))
    }

    /// What the harmonic does to every mesh.
    fn displacements(&self, harmonic: u32) -> Vec<Displacement> {
        let parts = &self.found.parts;
        let phases = phases(harmonic, self.teeth, self.prepared.planets, self.sun_drives);
        let [sun, ring] = self.excitation.of(harmonic);
        let of = |spring: SpringId, amplitude: Length, phase: f64| Displacement {
            spring,
            amplitude,
            phase: Angle::from_si(phase),
        };
        let meshes = std::iter::zip(&parts.sun_meshes, &parts.ring_meshes).zip(phases);
        meshes
            .flat_map(|((of_sun, of_ring), [at_sun, at_ring])| {
                [of(*of_sun, sun, at_sun), of(*of_ring, ring, at_ring)]
            })
            .collect()
    }

    fn harmonic(
        &self,
        modes: &Modes,
        order: &Order,
        speeds: &[f64],
    ) -> Result<Option<HarmonicResponse>, Refusal> {
        let found = self.found;
        let zeta = self.excitation.damping_ratio;
        let displacements = self.displacements(order.harmonic);
        let springs: Vec<SpringId> = found.model.springs().collect();
        // The greatest amplitudes of the meshes with sun and ring at a speed of the input.
        let forces = |speed: f64| -> Result<[f64; 2], Refusal> {
            let omega = AngularVelocity::from_si(order.of_input * speed);
            let response = found.model.response(modes, &displacements, omega, zeta)?;
            let most = |own: &[SpringId]| {
                let own =
                    std::iter::zip(&springs, &response.forces).filter(|(spring, _)| own.contains(spring));
                own.map(|(_, force)| force.si()).fold(0.0, f64::max)
            };
            Ok([most(&found.parts.sun_meshes), most(&found.parts.ring_meshes)])
        };
        let (low, high) = speeds.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), speed| {
            (low.min(speed.abs()), high.max(speed.abs()))
        });
        let at_resonances = found.groups.iter().filter(|group| !group.is_zero()).flat_map(|group| {
            let speed = TAU * group.frequency.si() / order.of_input;
            BESIDE_PEAK.map(|beside| speed * (1.0 + beside * zeta))
        });
        let at_resonances = at_resonances.filter(|speed| (low..=high).contains(speed));
        let mut places: Vec<f64> = speeds.iter().map(|speed| speed.abs()).chain(at_resonances).collect();
        places.retain(|speed| *speed > 0.0);
        places.sort_by(f64::total_cmp);
        places.dedup();
        if places.is_empty() {
            return Ok(None);
        }
        let mut curve: Vec<(f64, [f64; 2])> = vec![];
        for place in places {
            curve.push((place, forces(place)?));
        }
        let mut greatest = vec![];
        for mesh in [0, 1] {
            let top = (0..curve.len()).max_by(|a, b| curve[*a].1[mesh].total_cmp(&curve[*b].1[mesh]));
            let top = top.unwrap_or_default();
            let ends = [top.saturating_sub(1), (top + 1).min(curve.len() - 1)].map(|place| curve[place].0);
            let speed = golden(ends, |speed| forces(speed).map(|both| both[mesh]))?;
            let peak = (speed, forces(speed)?);
            let (speed, both) = if peak.1[mesh] > curve[top].1[mesh] { peak } else { curve[top] };
            greatest.push((speed, both));
        }
        curve.extend(&greatest);
        curve.sort_by(|one, other| one.0.total_cmp(&other.0));
        curve.dedup_by(|one, other| one.0 == other.0);
        let radius = found.sun_radius_m();
        let told = |mesh: usize| {
            let (speed, both) = greatest[mesh];
            Greatest {
                force_n: plain(both[mesh]),
                input_speed_rad_s: speed,
                frequency_hz: order.of_input * speed / TAU,
                parts_below_sun_torque_n_m: plain(both[mesh] * f64::from(self.prepared.planets) * radius),
            }
        };
        let [sun_error_m, ring_error_m] = self.excitation.of(order.harmonic).map(Physical::si);
        Ok(Some(HarmonicResponse {
            harmonic: order.harmonic,
            sun_error_m,
            ring_error_m,
            greatest_sun: told(0),
            greatest_ring: told(1),
            input_speeds_rad_s: curve.iter().map(|(speed, _)| *speed).collect(),
            sun_forces_n: curve.iter().map(|(_, [sun, _])| plain(*sun)).collect(),
            ring_forces_n: curve.iter().map(|(_, [_, ring])| plain(*ring)).collect(),
        }))
    }
}

/// Phases of a harmonic at the meshes of sun and ring with each planet.
fn phases(
    harmonic: u32,
    [sun, planet, _]: [u32; 3],
    planets: u32,
    sun_drives: bool,
) -> impl Iterator<Item = [f64; 2]> {
    let [harmonic, sun, planet, planets] = [harmonic, sun, planet, planets].map(u64::from);
    let offset = PI * (harmonic * (planet + 1) % 2) as f64;
    (0..planets).map(move |number| {
        let rest = harmonic * sun % planets * number % planets;
        let behind = TAU * rest as f64 / planets as f64;
        let phase = if sun_drives { -behind } else { behind };
        [phase, offset + phase]
    })
}

/// Where a function that rises and then falls between two places is greatest.
fn golden([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> Result<f64, Refusal>) -> Result<f64, Refusal> {
    let share = (5.0_f64.sqrt() - 1.0) / 2.0;
    let [mut left, mut right] = [high - share * (high - low), low + share * (high - low)];
    let (mut at_left, mut at_right) = (of(left)?, of(right)?);
    while high - low > PEAK * high {
        if at_left >= at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - share * (high - low);
            at_left = of(left)?;
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + share * (high - low);
            at_right = of(right)?;
        }
    }
    Ok((low + high) / 2.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::front::{self, Part};
    use crate::gearbox::{Choice, one};
    use epicyclic_formats::Document;

    /// From the front, with gears in mesh: the sun drives with the flanks that lead, and a quarter of a pitch beside its middle a tooth is at the
    /// pitch point. The teeth of the ring go the other way.
    #[test]
    fn phases_are_those_of_the_teeth_in_mesh() {
        for ([sun, planet, ring], planets) in
            [([25, 29, 83], 4), ([24, 30, 84], 4), ([20, 31, 82], 3), ([21, 19, 59], 5)]
        {
            let text = format!(
                "gearbox: test\ninput: D\noutput: B\nsets:\n  - {{ id: P, sun: D, ring: ground, carrier: B, teeth: [{sun}, {ring}], planets: {planets} }}\ngears: [{{ name: only }}]\n"
            );
            let document = Document::parse_one("box.yaml", text.as_bytes()).unwrap();
            let subject = one(&document, &Choice::default()).unwrap();
            let front = front::answer(&subject, None).unwrap();
            let set = &front.sets[0];
            let turn = |part: Part| set.gears.iter().find(|gear| gear.part == part).unwrap().turn_rad;
            let first = set.planets[0].angle_rad;
            for harmonic in 1..=5 {
                let found = phases(harmonic, [sun, planet, ring], planets, true);
                let cycles = set.planets.iter().map(|planet| {
                    let at_sun = f64::from(sun) * (planet.angle_rad - turn(Part::Sun)) - PI / 2.0;
                    let at_ring = f64::from(ring) * (planet.angle_rad - turn(Part::Ring)) - PI / 2.0;
                    [-at_sun, at_ring].map(|cycle| f64::from(harmonic) * cycle)
                });
                let cycles: Vec<[f64; 2]> = cycles.collect();
                assert_eq!(set.planets.len(), planets as usize);
                assert_eq!(first, 0.0);
                for (found, cycle) in found.zip(&cycles) {
                    for mesh in [0, 1] {
                        let missed = found[mesh] - (cycle[mesh] - cycles[0][0]);
                        assert!(libm::sin(missed / 2.0).abs() < 1e-9, "{sun} {harmonic} {mesh} {missed}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_golden_section_finds_a_top() {
        let of = |x: f64| Ok(-(x - 3.2) * (x - 3.2));
        assert!((golden([1.0, 7.0], of).unwrap() - 3.2).abs() < 1e-6);
        // At an end.
        assert!((golden([1.0, 7.0], Ok).unwrap() - 7.0).abs() < 1e-6);
    }
}
