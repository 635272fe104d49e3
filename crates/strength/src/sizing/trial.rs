//! Flanks and cross-sections of a set at one module and one face width, at every centre distance.

use super::practice::Misses;
use super::rated::{Place, Ratings};
use super::search::Masses;
use super::simple::{SetStep, Sizing, layouts};
use crate::Error;
use crate::contact::over_full_overlap;
use epicyclic_units::Physical;
use std::f64::consts::FRAC_PI_4;
use std::ops::ControlFlow;
use std::sync::Arc;
use uom::si::f64::Length;

/// Strength and mass of a set at one module, face width and centre distance.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Trial {
    /// Rules of usual practice that gears and meshes miss.
    pub(crate) missed: u32,
    /// Whether practice refuses them.
    is_refused: bool,
    /// Least safety of the flanks under each duty; of helical teeth as at full overlap, which wider faces may
    /// have.
    pub(crate) flanks: Vec<f64>,
    /// Cross-section of all gears times their density for each number of planets, with planets of the largest
    /// bore that their rim allows, kg/m.
    pub(crate) sections: Vec<f64>,
    /// Outside diameter of the ring.
    pub(crate) ring: Length,
    /// Bore of the planets that leaves the least rim.
    pub(crate) bore: Length,
    /// Radius of the circle of the planets' centres.
    pub(crate) radius: Length,
}

impl Sizing {
    /// Tries the first module and number of planets of the space with one face width, under several duties, at
    /// every centre distance whose gears have no fault.
    pub(crate) fn trials(
        &self,
        face: Length,
        duties: &[Vec<SetStep>],
        planets: &[u32],
    ) -> Result<Vec<Trial>, Error> {
        let task = self.general(vec![face]);
        let modules_mm = [self.space.modules[0].mm()];
        let (mut all, _) = layouts(self, &modules_mm, &task, &|| ControlFlow::Continue(()))?;
        let mut trials = vec![];
        for own in &all {
            let limits = task.practice.as_ref();
            let misses =
                limits.map_or_else(Misses::default, |limits| Misses::of_geometry(&task, own, limits));
            let bore = (own.gears[1].root_diameter() - 2.0 * self.planet_rim).max(0.0);
            let bored =
                FRAC_PI_4 * (bore * own.modules[0].si()).powi(2) * self.gears[1].material.density.si();
            let section = |count: &u32| {
                let layout = super::Layout { planets: *count, ..own.clone() };
                Masses::new(&task, &layout).solid[0] - f64::from(*count) * bored
            };
            trials.push(Trial {
                missed: misses.count(),
                is_refused: misses.is_refused(),
                flanks: vec![],
                sections: planets.iter().map(section).collect(),
                ring: own.ring_diameter(&task).unwrap_or_default(),
                bore: own.modules[0] * bore,
                radius: own.radii[0],
            });
        }
        for duty in duties {
            let of = Self { duty: duty.clone(), ..self.clone() };
            let (loads, _) = of.loads(self.space.planets[0])?;
            all.iter_mut().for_each(|layout| layout.loads = Arc::clone(&loads));
            let mut ratings = Ratings::new(&task, &all);
            for (layout, trial) in trials.iter_mut().enumerate() {
                let mut weakest = f64::INFINITY;
                for (mesh, pair) in all[layout].pairs.iter().enumerate() {
                    let place = Place { layout, widths: &[0] };
                    let overlap = pair.overlap_ratio((face / all[layout].modules[0]).si());
                    let gains = over_full_overlap(pair, overlap);
                    // Teeth that the standard does not hold for bear nothing.
                    let safety = ratings.rate(place, mesh, [None; 2])?.map_or(0.0, |rated| {
                        let flanks = rated.over_duty.iter().flatten().map(|gear| gear.contact.safety);
                        flanks.zip(gains).map(|(safety, gain)| safety * gain).fold(f64::INFINITY, f64::min)
                    });
                    weakest = weakest.min(safety);
                }
                trial.flanks.push(weakest);
            }
        }
        trials.retain(|trial| !trial.is_refused && trial.flanks.iter().all(|safety| *safety > 0.0));
        Ok(trials)
    }
}
