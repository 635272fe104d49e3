//! Mesh forces caused by transmission errors, over the input speed.
//!
//! In coordinates on the carrier, the tooth `l·z_s·(θ_s − ψ_n)/2π` of the sun is at the mesh with planet `n`.
//! The error of harmonic `l` therefore reaches the planets one after the other. With `d = 1` if the sun
//! drives the planets, and `d = −1` if they drive it, the errors are:
//!
//! ```text
//! e_s,n = a_s·cos(ω·t − d·l·z_s·ψ_n)     e_r,n = a_r·cos(ω·t − d·l·z_s·ψ_n + π·l·(z_p + 1))
//! ```
//!
//! The last term follows because from the sun's pitch point to the ring's a planet has half its teeth and,
//! from one flank to the other, half a pitch. The number of planets divides `z_s + z_r`, so the phases at the
//! ring are those at the sun.
//!
//! If the carrier turns, the matrices are those at its speed ([`epicyclic_vibration::response`]), with the
//! damping of the modes at rest. The model has the flanks that carry at a positive torque on the sun. At a
//! negative torque the set is seen from the other side, which also reverses the carrier speed. A peak between
//! two speeds is searched near the intersection of order and mode by the golden section method.

use super::branches::Branches;
use super::records::{Greatest, HarmonicResponse, Order, Response, Source};
use super::settled::Excitation;
use super::{Found, Of, Prepared};
use crate::error::Error;
use crate::shared::number::plain;
use crate::tolerance::PEAK;
use epicyclic_numerics::extremes::{Sections, try_golden_while};
use epicyclic_units::Physical;
use epicyclic_vibration::model::SpringId;
use epicyclic_vibration::response::Displacement;
use epicyclic_vibration::{Centripetal, Error as Refusal, Modes};
use std::f64::consts::{PI, TAU};
use uom::si::f64::{Angle, AngularVelocity, Length};

/// Speeds around a resonance at which the curve is sampled, relative to the damping ratio: there its
/// curvature is large.
const BESIDE_PEAK: [f64; 17] =
    [-16.0, -8.0, -4.0, -2.0, -1.0, -0.7, -0.4, -0.2, 0.0, 0.2, 0.4, 0.7, 1.0, 2.0, 4.0, 8.0, 16.0];

/// Set in a gear with its excitation.
pub(super) struct Excited<'a> {
    pub(super) of: &'a Of<'a>,
    pub(super) prepared: &'a Prepared,
    pub(super) found: &'a Found,
    pub(super) teeth: [u32; 3],
    /// Whether the sun drives the planets.
    pub(super) sun_drives: bool,
    /// Speed of the carrier relative to the input speed, seen from the side from which the torque on the sun
    /// is positive; 0 without gyroscopic effect.
    pub(super) frame: f64,
    pub(super) branches: &'a Branches<'a>,
    pub(super) excitation: &'a Excitation,
}

impl Excited<'_> {
    /// Response to the harmonics of the meshes among the orders, at input speeds in rad/s.
    pub(super) fn response(&self, orders: &[Order], speeds: &[f64]) -> Result<Option<Response>, Error> {
        let refuse = |error: Refusal| self.of.refused(&["vibration"], &error);
        let modes = self.found.model.modes().map_err(refuse)?;
        let mut harmonics = vec![];
        for order in orders.iter().filter(|order| order.source == Source::Mesh) {
            if self.excitation.amplitudes(order.harmonic).iter().any(|amplitude| amplitude.si() > 0.0) {
                harmonics.extend(self.harmonic(&modes, order, speeds).map_err(refuse)?);
            }
        }
        let Some(first) = orders.first().filter(|_| !harmonics.is_empty()) else { return Ok(None) };
        Ok(Some(Response {
            set: first.set.clone(),
            gear: first.gear.clone(),
            damping_ratio: self.excitation.damping_ratio,
            gyroscopic: self.frame != 0.0,
            harmonics,
        }))
    }

    /// Displacements of all meshes by a harmonic.
    fn displacements(&self, harmonic: u32) -> Vec<Displacement> {
        let parts = &self.found.parts;
        let phases = phases(harmonic, self.teeth, &self.prepared.spacing.places, self.sun_drives);
        let [sun, ring] = self.excitation.amplitudes(harmonic);
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
        // Greatest force amplitudes of the meshes with sun and ring at an input speed.
        let forces = |speed: f64| -> Result<[f64; 2], Refusal> {
            self.branches.check()?;
            let omega = AngularVelocity::from_si(order.of_input * speed);
            let response = if self.frame == 0.0 {
                found.model.response(modes, &displacements, omega, zeta)?
            } else {
                let turning = AngularVelocity::from_si(self.frame * speed);
                let load = Centripetal::WithBearingLoad;
                found.model.turning_response(modes, &displacements, omega, zeta, turning, load)?
            };
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
        // Resonances at rest, and at the speeds where the gyroscopic effect moves them.
        let at_rest = found.groups.iter().filter(|group| !group.is_zero());
        let at_rest = at_rest.map(|group| TAU * group.frequency.si() / order.of_input);
        let turning = if self.frame == 0.0 { vec![] } else { self.branches.resonances(found, order)? };
        let turning = turning.iter().map(|met| met.input_speed_rad_s.abs());
        let at_resonances =
            at_rest.chain(turning).flat_map(|speed| BESIDE_PEAK.map(|beside| speed * (1.0 + beside * zeta)));
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
            let is_wide = |_, found: &Sections| found.ends[1] - found.ends[0] > PEAK * found.ends[1];
            let found = try_golden_while(ends, is_wide, |speed| forces(speed).map(|both| -both[mesh]))?;
            let speed = f64::midpoint(found.ends[0], found.ends[1]);
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
        let [sun_error_m, ring_error_m] = self.excitation.amplitudes(order.harmonic).map(Physical::si);
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

/// Phases of a harmonic at the meshes of sun and ring with each planet. The place `κ` is the planet's
/// position among all positions allowed by the teeth.
fn phases(
    harmonic: u32,
    [sun, planet, ring]: [u32; 3],
    places: &[u64],
    sun_drives: bool,
) -> impl Iterator<Item = [f64; 2]> {
    let [harmonic, sun, planet, ring] = [harmonic, sun, planet, ring].map(u64::from);
    let (offset, all) = (PI * (harmonic * (planet + 1) % 2) as f64, sun + ring);
    places.iter().map(move |place| {
        let rest = harmonic * sun % all * place % all;
        let behind = TAU * rest as f64 / all as f64;
        let phase = if sun_drives { -behind } else { behind };
        [phase, offset + phase]
    })
}

#[cfg(test)]
mod tests {
    use super::super::spacing::Spacing;
    use super::*;
    use crate::front::{self, Part};
    use crate::shared::gearbox::{Choice, one};
    use epicyclic_formats::Document;

    /// Seen from the front, with gears in mesh: the sun drives with its leading flanks. A tooth whose middle
    /// is a quarter of a pitch away is at the pitch point. The teeth of the ring pass in the opposite
    /// direction.
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
                let places = Spacing::of(&subject.train.sets()[0]).unwrap().unwrap().places;
                let found = phases(harmonic, [sun, planet, ring], &places, true);
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
}
