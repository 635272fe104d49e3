//! Loads of planet bearings in a layout, without face widths.

use super::Making;
use crate::analyze::answer::Worked;
use crate::error::Error;
use crate::strength::answer::duty::WorkedStep;
use epicyclic_strength::sizing::PlanetStep;
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_bearings::{MeshSize, PlanetBearing, PlanetSize, SetSize};
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::toothed::ToothedSet;
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Length, Torque};

impl Making<'_> {
    /// Whether a gear is one of a planet.
    fn is_of(&self, gear: usize, planet: usize) -> bool {
        matches!(self.set.data.of[gear], GearOf::Planet(of, _) if of == planet)
    }

    /// Loads of the bearings of each kind of planets; `None` where they do not follow.
    pub(super) fn bearing_loads(
        &self,
        set: &PlanetSet,
        toothed: &ToothedSet,
    ) -> Result<Option<Vec<Vec<PlanetStep>>>, Error> {
        let behind = |(size, is_behind): (MeshSize, &bool)| MeshSize { is_behind: *is_behind, ..size };
        let planet = |radius: &Option<f64>| PlanetSize {
            carrier_radius: radius.map(Length::from_si),
            ..PlanetSize::default()
        };
        let size = SetSize {
            meshes: set
                .mesh_sizes(toothed, true)
                .into_iter()
                .zip(&self.set.data.is_behind)
                .map(behind)
                .collect(),
            planets: toothed.radii.iter().map(planet).collect(),
            // Of planets in mesh, as for the bearings of the file.
            pressure_angle: self.rack.pressure_angle,
            ..SetSize::default()
        };
        let still = AngularVelocity::default();
        let mut all = vec![];
        for bearing in set.bearings(self.set.place, &size)? {
            let gears: Vec<usize> = match set.is_stepped(bearing.planet) {
                true => {
                    (0..self.set.data.of.len()).filter(|gear| self.is_of(*gear, bearing.planet)).collect()
                }
                false => vec![],
            };
            let teeth = (toothed, &self.set.data.is_behind[..]);
            // The moment is a linear function of the widths.
            let of_width = |gear: usize, torques: &[Torque]| {
                let mut widths = vec![Length::default(); self.set.data.of.len()];
                widths[gear] = Length::from_si(1.0);
                set.step_couple(bearing.planet, teeth, torques, &widths).unwrap_or_default()
            };
            let loaded = |worked: &Worked<'_>, share: f64| {
                let torques = worked.member_torques(self.set.place);
                let forces = bearing.forces(torques.as_deref(), Some(still))?;
                Ok::<_, Error>(forces.tangential.zip(forces.radial).map(|(tangential, radial)| {
                    let torques = torques.unwrap_or_default();
                    let axial = set.planet_axial_load(bearing.planet, teeth, &torques);
                    let moment = axial.map_or([0.0; 2], |axial| axial.moment).map(Torque::from_si);
                    let tangential = PlanetBearing::push_direction(&torques) * tangential;
                    let of_widths = gears.iter().map(|gear| (*gear, of_width(*gear, &torques))).collect();
                    PlanetStep { share, tangential, radial, moment, of_widths, ..PlanetStep::default() }
                }))
            };
            let mut own = vec![];
            for WorkedStep(entry, worked) in self.steps {
                let share = entry.share.0.si();
                let Some(worked) = worked else {
                    own.push(PlanetStep { share, ..PlanetStep::default() });
                    continue;
                };
                let turning = worked.analysis.sets()[self.set.place].planets[bearing.planet];
                let (Some(step), Some(turning)) = (loaded(worked, share)?, turning) else {
                    return Ok(None);
                };
                let carrier = worked.analysis.speed(set.carrier()).unwrap_or_default();
                let relative = crate::tolerance::rounded(turning.relative);
                own.push(PlanetStep {
                    carrier_speed: entry.speed.0 * carrier,
                    speed: (entry.speed.0 * relative).abs(),
                    ..step
                });
            }
            for peak in self.peaks {
                own.extend(loaded(&peak.worked, 0.0)?);
            }
            all.push(own);
        }
        Ok(Some(all))
    }
}
