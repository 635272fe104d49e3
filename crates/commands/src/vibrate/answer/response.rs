//! Mesh forces caused by transmission errors, over the input speed.
//!
//! In coordinates on the carrier, the tooth `l·z_c·(θ_c − ψ_n)/2π` of a central gear `c` is at the mesh with
//! planet `n`. The error of harmonic `l` therefore reaches the planets one after the other. With `d = 1` if
//! the sun of a simple set drives the planets, and `d = −1` if they drive it, the errors are:
//!
//! ```text
//! e_s,n = a_s·cos(ω·t − d·l·z_s·ψ_n)     e_r,n = a_r·cos(ω·t − d·l·z_s·ψ_n + π·l·(z_p + 1))
//! ```
//!
//! The last term follows because from the sun's pitch point to the ring's a planet has half its teeth and,
//! from one flank to the other, half a pitch. The number of planets divides `z_s + z_r`, so the phases at the
//! ring are those at the sun. Of other sets each mesh that shares its frequency with none excites by itself.
//! Where several meshes do, the phase between them depends on the angles of planets in mesh, and no forces
//! are calculated.
//!
//! If the carrier turns, the matrices are those at its speed ([`epicyclic_vibration::response`]), with the
//! damping of the modes at rest. The model has the flanks that carry at a positive torque on the sun. At a
//! negative torque the set is seen from the other side, which also reverses the carrier speed. A peak between
//! two speeds is searched near the intersection of order and mode by the golden section method.

use super::branches::Branches;
use super::orders::Phased;
use super::prepared::Mesh;
use super::records::{Greatest, HarmonicResponse, MeshResponse, Response, Source};
use super::settled::Excitation;
use super::spacing::Spacing;
use super::{Found, Of, Prepared};
use crate::error::Error;
use crate::shared::number::plain;
use crate::tolerance::PEAK;
use epicyclic_numerics::extremes::{Sections, try_golden_while};
use epicyclic_train::planet_set::GearOf;
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
    /// Speeds of the members relative to the input speed, seen from the side from which the first loaded mesh
    /// drives in the positive direction.
    pub(super) speeds: Vec<f64>,
    /// Speed of the carrier among them; 0 without gyroscopic effect.
    pub(super) frame: f64,
    pub(super) branches: &'a Branches<'a>,
    pub(super) excitation: &'a Excitation,
}

impl Excited<'_> {
    /// Response to the harmonics of the meshes among the orders, at input speeds in rad/s.
    pub(super) fn response(&self, orders: &[Phased], speeds: &[f64]) -> Result<Option<Response>, Error> {
        let refuse = |error: Refusal| self.of.refused(&["vibration"], &error);
        let modes = self.found.model.modes().map_err(refuse)?;
        let mut harmonics = vec![];
        for phased in orders.iter().filter(|one| one.order.source == Source::Mesh) {
            let is_excited = |mesh: &usize| self.amplitude(*mesh, phased.order.harmonic).si() > 0.0;
            if self.knows_phases(phased) && phased.meshes.iter().any(is_excited) {
                harmonics.extend(self.harmonic(&modes, phased, speeds).map_err(refuse)?);
            }
        }
        let first = orders.first().map(|one| &one.order);
        let Some(first) = first.filter(|_| !harmonics.is_empty()) else { return Ok(None) };
        Ok(Some(Response {
            set: first.set.clone(),
            gear: first.gear.clone(),
            damping_ratio: self.excitation.damping_ratio,
            gyroscopic: self.frame != 0.0,
            harmonics,
        }))
    }

    /// Whether the phases between the meshes of an order are known: of one mesh, or of a planet between a sun
    /// and a ring.
    pub(super) fn knows_phases(&self, phased: &Phased) -> bool {
        match phased.meshes[..] {
            [_] => true,
            [_, _] => self.idler(phased).is_some(),
            _ => false,
        }
    }

    /// Teeth of the planet's gear between a sun and a ring that an order's meshes share.
    fn idler(&self, phased: &Phased) -> Option<u32> {
        let [one, other] = phased.meshes[..] else { return None };
        let [one, other] = [one, other].map(|mesh| &self.prepared.meshes[mesh]);
        let shared = one.gears.iter().find(|gear| other.gears.iter().any(|mate| mate.0 == gear.0))?.0;
        let is_idler = matches!(shared, GearOf::Planet(..)) && !one.is_internal && other.is_internal;
        let has_centrals = [one, other].iter().all(|mesh| central(mesh).is_some());
        self.prepared.teeth_of(shared).filter(|_| is_idler && has_centrals)
    }

    /// Amplitude of the transmission error of a mesh.
    fn amplitude(&self, mesh: usize, harmonic: u32) -> Length {
        let [sun, ring] = self.excitation.amplitudes(harmonic);
        if self.prepared.meshes[mesh].is_internal { ring } else { sun }
    }

    /// Displacements of all meshes of an order.
    fn displacements(&self, phased: &Phased) -> Vec<Displacement> {
        let kinds = self.prepared.meshes.len();
        let harmonic = phased.order.harmonic;
        let first = central(&self.prepared.meshes[phased.meshes[0]]);
        let carrier = self.speeds.get(self.of.set.centrals().len()).copied().unwrap_or_default();
        let teeth = first.and_then(|central| self.prepared.teeth_of(GearOf::Central(central)));
        let drives = first.is_none_or(|central| self.speeds[central] >= carrier);
        let spacing = &self.prepared.spacing;
        let behind = phases(harmonic, teeth.unwrap_or_default(), spacing, drives);
        let behind: Vec<f64> = behind.collect();
        let offset = self.idler(phased).map_or(0.0, |planet| half_turns(harmonic, planet));
        let mut all = vec![];
        for (copy, behind) in behind.iter().enumerate() {
            for (place, mesh) in phased.meshes.iter().enumerate() {
                all.push(Displacement {
                    spring: self.found.parts.meshes[copy * kinds + mesh],
                    amplitude: self.amplitude(*mesh, harmonic),
                    phase: Angle::from_si(if place == 0 { *behind } else { offset + behind }),
                });
            }
        }
        all
    }

    fn harmonic(
        &self,
        modes: &Modes,
        phased: &Phased,
        speeds: &[f64],
    ) -> Result<Option<HarmonicResponse>, Refusal> {
        let (found, order) = (self.found, &phased.order);
        let zeta = self.excitation.damping_ratio;
        let displacements = self.displacements(phased);
        let springs: Vec<SpringId> = found.model.springs().collect();
        let kinds: Vec<Vec<SpringId>> = (0..self.prepared.meshes.len())
            .map(|mesh| self.prepared.of_mesh(&found.parts.meshes, mesh))
            .collect();
        // Greatest force amplitude of the meshes of each kind at an input speed.
        let forces = |speed: f64| -> Result<Vec<f64>, Refusal> {
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
            Ok(kinds.iter().map(|own| most(own)).collect())
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
        let mut curve: Vec<(f64, Vec<f64>)> = vec![];
        for place in places {
            curve.push((place, forces(place)?));
        }
        let mut greatest = vec![];
        for mesh in 0..kinds.len() {
            let top = (0..curve.len()).max_by(|a, b| curve[*a].1[mesh].total_cmp(&curve[*b].1[mesh]));
            let top = top.unwrap_or_default();
            let ends = [top.saturating_sub(1), (top + 1).min(curve.len() - 1)].map(|place| curve[place].0);
            let is_wide = |_, found: &Sections| found.ends[1] - found.ends[0] > PEAK * found.ends[1];
            let found = try_golden_while(ends, is_wide, |speed| forces(speed).map(|both| -both[mesh]))?;
            let speed = f64::midpoint(found.ends[0], found.ends[1]);
            let peak = (speed, forces(speed)?);
            greatest.push(if peak.1[mesh] > curve[top].1[mesh] { peak } else { curve[top].clone() });
        }
        curve.extend(greatest.iter().cloned());
        curve.sort_by(|one, other| one.0.total_cmp(&other.0));
        curve.dedup_by(|one, other| one.0 == other.0);
        let is_simple = self.prepared.is_simple();
        let meshes = greatest.iter().enumerate().map(|(mesh, (speed, all))| {
            let own = &self.prepared.meshes[mesh];
            let force = all[mesh];
            // Meshes of a planet between sun and ring carry the same mean force, that of the torque on the
            // sun.
            let gear = if is_simple { Some(0) } else { central(own) };
            let copies = self.prepared.copies() as f64;
            let torque = |central: usize| force * copies * self.prepared.members[central].radius.si();
            let error = phased.meshes.contains(&mesh).then(|| self.amplitude(mesh, order.harmonic));
            MeshResponse {
                mesh: own.name.clone(),
                error_m: error.unwrap_or_default().si(),
                torque_on: gear.map(|central| self.prepared.members[central].name.clone()),
                greatest: Greatest {
                    force_n: plain(force),
                    input_speed_rad_s: *speed,
                    frequency_hz: order.of_input * speed / TAU,
                    parts_below_torque_n_m: gear.map(|central| plain(torque(central))),
                    parts_below_sun_torque_n_m: is_simple.then(|| plain(torque(0))),
                },
                forces_n: curve.iter().map(|(_, all)| plain(all[mesh])).collect(),
            }
        });
        let (part, input_speeds_rad_s) = (order.part.clone(), curve.iter().map(|one| one.0).collect());
        let (harmonic, meshes) = (order.harmonic, meshes.collect());
        Ok(Some(HarmonicResponse::of(harmonic, part, input_speeds_rad_s, meshes)))
    }
}

/// The central gear of a mesh.
fn central(mesh: &Mesh) -> Option<usize> {
    mesh.gears.iter().find_map(|(gear, _)| match gear {
        GearOf::Central(central) => Some(*central),
        GearOf::Planet(..) => None,
    })
}

/// Phase between the meshes of a planet with sun and ring.
fn half_turns(harmonic: u32, planet_teeth: u32) -> f64 {
    PI * (u64::from(harmonic) * (u64::from(planet_teeth) + 1) % 2) as f64
}

/// Phases of a harmonic at the meshes of a central gear with each planet. Planets at assembly positions have
/// whole numbers of them between each other.
fn phases(harmonic: u32, teeth: u32, spacing: &Spacing, drives: bool) -> impl Iterator<Item = f64> {
    let periods = u64::from(harmonic) * u64::from(teeth);
    let angles = spacing.angles_rad.iter().enumerate();
    angles.map(move |(planet, angle)| {
        let behind = match spacing.places.get(planet) {
            Some(place) => {
                let rest = periods % spacing.positions * place % spacing.positions;
                TAU * rest as f64 / spacing.positions as f64
            }
            None => (periods as f64 * angle).rem_euclid(TAU),
        };
        if drives { -behind } else { behind }
    })
}

#[cfg(test)]
mod tests {
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
                let spacing = Spacing::of(&subject.train.sets()[0]).unwrap().unwrap();
                let offset = half_turns(harmonic, planet);
                let found = phases(harmonic, sun, &spacing, true).map(|phase| [phase, offset + phase]);
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
