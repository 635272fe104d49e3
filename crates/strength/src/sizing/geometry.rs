//! The gears of a set at every centre distance of the space, and their masses.

use super::{LeftOut, Sizing};
use crate::tolerance::EDGE;
use crate::{Error, Quantity};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::check::{Check, Rule};
use epicyclic_gears::involute::family::{Family, natural_centre_distance};
use epicyclic_gears::involute::profile::Profiles;
use epicyclic_gears::involute::{InvoluteGear, Pair, PlanetSet};
use epicyclic_gears::mesh::TipCircle;
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_units::Physical;
use std::f64::consts::FRAC_PI_4;
use std::ops::ControlFlow;

/// A module, a number of planets, a centre distance, and the gears there; lengths in mm.
#[derive(Debug, Clone)]
pub(super) struct Geometry {
    /// Place of the module in the space.
    pub(super) module: usize,
    pub(super) module_mm: f64,
    pub(super) planets: u32,
    pub(super) centre_mm: f64,
    pub(super) set: PlanetSet,
    pub(super) limited_by: Option<Check>,
    /// Meshes of sun and planets, and of planets and ring.
    pub(super) pairs: [Pair; 2],
    pub(super) planet_root_mm: f64,
    pub(super) planet_height_mm: f64,
    pub(super) ring_rim_mm: f64,
    pub(super) ring_mm: f64,
    /// Mass over face width of all gears, planets solid, and of one solid planet, kg/mm.
    pub(super) solid: f64,
    pub(super) planet: f64,
    /// Density of the planets, kg/mm³.
    pub(super) planet_density: f64,
}

/// Cubic millimetres in a cubic metre.
const MM3: f64 = 1e9;

impl Geometry {
    fn new(
        task: &Sizing,
        [module, planets]: [usize; 2],
        module_mm: f64,
        set: PlanetSet,
        limited_by: Option<Check>,
    ) -> Result<Self, Error> {
        let [sun, planet, ring] = set.gears();
        let ring_rim_mm = task.held_ring_rim.map_or(task.ring_rim * module_mm, Physical::mm);
        let ring_mm = ring.root_diameter() * module_mm + 2.0 * ring_rim_mm;
        let [sun_rho, planet_rho, ring_rho] = task.gears.map(|gear| gear.material.density.si() / MM3);
        // A circle with the mean area of those of tips and roots.
        let filled = |gear: &InvoluteGear| {
            let square = |diameter: f64| (diameter * module_mm).powi(2);
            FRAC_PI_4 * f64::midpoint(square(gear.tip_diameter()), square(gear.root_diameter()))
        };
        let one_planet = planet_rho * filled(planet);
        let count = planets as f64;
        let ring_mass = ring_rho * (FRAC_PI_4 * ring_mm.powi(2) - filled(ring));
        Ok(Self {
            module,
            module_mm,
            planets: planets as u32,
            centre_mm: set.centre_distance() * module_mm,
            limited_by,
            pairs: [*set.sun_mesh(), *set.ring_mesh()],
            planet_root_mm: planet.root_diameter() * module_mm,
            planet_height_mm: (planet.tip_diameter() - planet.root_diameter()) / 2.0 * module_mm,
            ring_rim_mm,
            ring_mm,
            solid: sun_rho * filled(sun) + count * one_planet + ring_mass,
            planet: one_planet,
            planet_density: planet_rho,
            set,
        })
    }

    /// Mass of the bore of one planet over face width, kg/mm.
    fn bore(&self, bore_mm: f64) -> f64 {
        self.planet_density * FRAC_PI_4 * bore_mm.powi(2)
    }

    /// Mass of all gears, kg.
    pub(super) fn mass(&self, bore_mm: f64, face_mm: f64) -> f64 {
        face_mm * (self.solid - f64::from(self.planets) * self.bore(bore_mm))
    }

    /// Mass of a planet, kg.
    pub(super) fn planet_mass(&self, bore_mm: f64, face_mm: f64) -> f64 {
        face_mm * (self.planet - self.bore(bore_mm))
    }
}

/// The centre distances of a module, in modules.
fn centres(task: &Sizing, natural: f64, module_mm: f64) -> Vec<f64> {
    let step = task.space.centre_distance_step.mm() / module_mm;
    let first = ((natural - task.space.reach) / step - EDGE).ceil() as i64;
    let last = ((natural + task.space.reach) / step + EDGE).floor() as i64;
    (first..=last).map(|count| count as f64 * step).collect()
}

/// Centre distances with face widths that are searched at most: a search then ends within minutes.
const MOST: u32 = 300_000;

/// Refuses a space of more centre distances and face widths than a search holds.
pub(super) fn check_extent(task: &Sizing, modules_mm: &[f64], widths: usize) -> Result<(), Error> {
    let step_mm = task.space.centre_distance_step.mm();
    let of_module = |module_mm: &f64| match task.held_shifts {
        Some(_) => 1.0,
        None => (2.0 * task.space.reach * module_mm / step_mm).max(1.0),
    };
    let centres: f64 = modules_mm.iter().map(of_module).sum();
    let count = centres * (task.space.planets.len() * widths) as f64;
    if count <= f64::from(MOST) { Ok(()) } else { Err(Error::SpaceTooLarge { count, most: MOST }) }
}

/// The set with shifts that are held; `None` where they leave no gears or have a fault.
fn held(task: &Sizing, planets: u32) -> Option<Result<PlanetSet, Check>> {
    let shifts = task.held_shifts?;
    let [sun, planet, ring] = task.teeth;
    let Profiles(profiles) = task.profiles;
    let tips = shifts.tips.unwrap_or_default();
    let gear = |kind, teeth, place: usize| {
        InvoluteGear::new(kind, teeth, profiles[place], shifts.profile[place])?
            .with_tip_alteration(tips[place])
    };
    let set = || {
        let sun = gear(GearKind::External, sun, 0)?;
        let planet = gear(GearKind::External, planet, 1)?;
        let ring = gear(GearKind::Internal, ring, 2)?;
        let centre = Pair::without_backlash(sun, planet)?.centre_distance();
        let set = PlanetSet::new([sun, planet, ring], planets, centre)?;
        if shifts.tips.is_some() { Ok(set) } else { set.with_clear_ring_tips() }
    };
    let set = set().ok()?;
    Some(match set.faults(&task.limits).first() {
        Some(fault) => Err(*fault),
        None => Ok(set),
    })
}

/// Whether planets at stated angles touch: the set itself knows them as near to equal angles as they
/// assemble.
fn do_touch(task: &Sizing, set: &PlanetSet) -> bool {
    let planet =
        TipCircle { centre_radius: set.centre_distance(), tip_radius: set.gears()[1].tip_diameter() / 2.0 };
    task.least_planet_angle.is_some_and(|angle| planet.gap(planet, angle.si()) <= task.limits.planet_gap)
}

/// The gears at every centre distance of the space; `others` is how many designs each of them has.
///
/// The second figure counts the centre distances that were calculated, with those left out.
pub(super) fn geometries(
    task: &Sizing,
    modules_mm: &[f64],
    others: u64,
    left_out: &mut LeftOut,
    goes_on: &dyn Fn() -> ControlFlow<()>,
) -> Result<(Vec<Geometry>, u64, u64), Error> {
    let natural = natural_centre_distance(task.teeth, *task.profiles.shared())?;
    let [sun, _, ring] = task.teeth;
    let (mut all, mut space, mut calculated) = (vec![], 0, 0);
    for &planets in &task.space.planets {
        if planets == 0 {
            return Err(Error::NotPositive { quantity: Quantity::Planets, value: 0.0, unit: "planets" });
        }
        let is_placed =
            task.least_planet_angle.is_some() || PlanetSpacing::least_unequal(sun, ring, planets).is_equal();
        for (module, &module_mm) in modules_mm.iter().enumerate() {
            let wanted: Vec<Option<f64>> = match task.held_shifts {
                Some(_) => vec![None],
                None => centres(task, natural, module_mm).into_iter().map(Some).collect(),
            };
            space += wanted.len() as u64 * others;
            if !is_placed {
                left_out.spacing += wanted.len() as u64 * others;
                continue;
            }
            for centre in wanted {
                if goes_on().is_break() {
                    return Err(Error::Cancelled);
                }
                calculated += 1;
                let found = match centre {
                    None => match held(task, planets) {
                        Some(Ok(set)) => Ok((set, None)),
                        Some(Err(fault)) => Err(Some(fault)),
                        None => Err(None),
                    },
                    Some(centre) => Family::new(task.teeth, planets, task.profiles, centre)
                        .and_then(|family| family.choose(task.aim, &task.limits))
                        .map(|choice| (choice.set, choice.limited_by))
                        .map_err(|error| match error {
                            epicyclic_gears::Error::NoShifts { fault, .. } => Some(fault),
                            _ => None,
                        }),
                };
                match found {
                    Ok((set, _)) if do_touch(task, &set) => left_out.planets_touch += others,
                    Ok((set, limited_by)) => {
                        all.push(Geometry::new(
                            task,
                            [module, planets as usize],
                            module_mm,
                            set,
                            limited_by,
                        )?);
                    }
                    Err(Some(Check { rule: Rule::PlanetGap, .. })) => left_out.planets_touch += others,
                    Err(_) => left_out.geometry += others,
                }
            }
        }
    }
    Ok((all, space, calculated))
}
