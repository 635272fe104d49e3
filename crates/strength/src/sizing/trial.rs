//! Flanks and cross-sections of a set at one module and one face width, at every centre distance.

use super::gear_masses::Masses;
use super::practice::Misses;
use super::rated::{Place, Ratings};
use super::simple::{SetStep, SetTeeth, Sizing, layouts};
use super::task::Task;
use crate::Error;
use crate::contact::over_full_overlap;
use crate::spectrum::flank_safeties;
use epicyclic_units::Physical;
use std::ops::ControlFlow;
use uom::si::f64::Length;

/// Strength and mass of a set at one centre distance, or between two.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Trial {
    misses: Misses,
    /// Least safety of the flanks for each size and duty; of helical teeth as at full overlap, which wider
    /// faces may have. 0 of teeth that the standard does not hold for.
    pub(crate) flanks: Vec<Vec<f64>>,
    /// Cross-section of all gears times their density for each number of planets, with planets of the largest
    /// bore that their rim allows, kg/m.
    pub(crate) sections: Vec<f64>,
    /// Cross-section of a planet of this bore times its density, kg/m; 0 of a pair.
    pub(crate) planet: f64,
    /// Outside diameter of the ring, of a pair that of the larger gear.
    pub(crate) ring: Length,
    /// Bore of the planets that leaves the least rim; 0 of a pair.
    pub(crate) bore: Length,
    /// Radius of the circle of the planets' centres, of a pair its centre distance.
    pub(crate) radius: Length,
}

impl Trial {
    /// Number of rules of usual practice that gears and meshes miss.
    pub(crate) const fn missed(&self) -> u32 {
        self.misses.count()
    }

    /// The best of what sets between two neighbouring centre distances may have; rules that one of the ends
    /// holds may hold there.
    fn between([one, other]: [&Self; 2]) -> Self {
        let each = |better: fn(f64, f64) -> f64| {
            move |(one, other): (&Vec<f64>, &Vec<f64>)| -> Vec<f64> {
                one.iter().zip(other).map(|(one, other)| better(*one, *other)).collect()
            }
        };
        Self {
            misses: one.misses.of_both(other.misses),
            flanks: one.flanks.iter().zip(&other.flanks).map(each(f64::max)).collect(),
            sections: each(f64::min)((&one.sections, &other.sections)),
            planet: one.planet.min(other.planet),
            ring: one.ring.min(other.ring),
            bore: one.bore.max(other.bore),
            radius: one.radius.min(other.radius),
        }
    }

    fn is_refused(&self) -> bool {
        self.misses.is_refused() || self.flanks.iter().flatten().any(|safety| *safety == 0.0)
    }
}

impl Sizing {
    /// Tries the first module and number of planets of the space at every centre distance whose gears have no
    /// fault; flanks at several sizes, each a module and a face width, under several duties.
    pub(crate) fn trials(
        &self,
        sizes: &[[Length; 2]],
        duties: &[Vec<SetStep>],
        planets: &[u32],
    ) -> Result<Vec<Trial>, Error> {
        let faces = sizes.iter().map(|[_, face]| *face).collect();
        // Narrower faces have no more than the given factor.
        let task = Task { widens_face_load: false, ..self.general(faces) };
        let modules_mm = [self.space.modules[0].mm()];
        let (mut all, _) = layouts(self, &modules_mm, &task, &|| ControlFlow::Continue(()))?;
        let mut trials = vec![];
        for own in &all {
            let limits = task.practice.as_ref();
            let misses =
                limits.map_or_else(Misses::default, |limits| Misses::of_geometry(&task, own, limits));
            let bore = match self.teeth {
                SetTeeth::Simple(_) => {
                    own.modules[0] * (own.gears[1].root_diameter() - 2.0 * self.planet_rim).max(0.0)
                }
                SetTeeth::Pair(_) => Length::default(),
            };
            let masses = Masses::new(&task, own);
            let bores = || task.planets.iter().map(|_| bore.si());
            let section = |count: &u32| masses.all(*count, bores(), &[1.0]);
            let planet = |kind: usize| masses.planet(kind, bore.si(), &[1.0]).max(0.0);
            trials.push(Trial {
                misses,
                flanks: vec![],
                sections: planets.iter().map(section).collect(),
                planet: (0..task.planets.len()).map(planet).sum(),
                ring: Length::from_si(masses.largest),
                bore,
                radius: own.radii[0],
            });
        }
        let loads = duties.iter().map(|duty| {
            let of = Self { duty: duty.clone(), ..self.clone() };
            Ok(of.loads(self.space.planets[0])?.0)
        });
        let loads = loads.collect::<Result<Vec<_>, Error>>()?;
        for (width, [module, face]) in sizes.iter().enumerate() {
            all.iter_mut().for_each(|layout| layout.modules = vec![*module]);
            let ratings = Ratings::new(&task, &all);
            for (layout, trial) in trials.iter_mut().enumerate() {
                let mut weakest = vec![f64::INFINITY; duties.len()];
                for (mesh, pair) in all[layout].pairs.iter().enumerate() {
                    let (rated, method) = ratings.mesh(Place { layout, widths: &[width] }, mesh, [None; 2]);
                    let steps = loads.iter().map(|loads| (&loads[mesh].steps[..], loads[mesh].contacts));
                    let [first, second] = over_full_overlap(pair, pair.overlap_ratio((*face / *module).si()));
                    match flank_safeties(&rated, &method, steps, self.life) {
                        Ok(safeties) => {
                            for (weakest, [one, other]) in weakest.iter_mut().zip(safeties) {
                                *weakest = weakest.min(one * first).min(other * second);
                            }
                        }
                        // Teeth that the standard does not hold for bear nothing.
                        Err(error) if error.is_beyond_standard() => weakest.fill(0.0),
                        Err(error) => return Err(error),
                    }
                }
                trial.flanks.push(weakest);
            }
        }
        let between = trials.windows(2).map(|pair| [&pair[0], &pair[1]]);
        let alone = trials.iter().filter(|_| trials.len() == 1).map(|one| [one; 2]);
        let all = between.chain(alone).filter(|ends| !ends.iter().all(|end| end.is_refused()));
        Ok(all.map(Trial::between).collect())
    }
}
