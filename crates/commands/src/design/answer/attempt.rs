//! Tooth numbers and sizes of one scheme.

use super::making::{Load, MAKING, for_each_set, shared, warnings, with_load};
use super::records::{SizesStep, TeethStep, TeethTaken};
use super::{Wanted, order_of_teeth};
use crate::answer::Warning;
use crate::error::Error;
use crate::select::answer::reached::{ReachedSpeed, largest_deviation};
use crate::select::answer::saved::Saved;
use crate::select::answer::teeth::{self, Searches, SizeLimits, Watch};
use crate::shared::application::FULL_LOAD;
use crate::shared::gearbox::{Choice, one};
use crate::shared::profile_shift::WantedShifts;
use crate::size::answer::{self as size, Size};
use crate::tolerance::OBJECTIVE;
use epicyclic_formats::Document;
use epicyclic_formats::yaml::to_string;
use epicyclic_selection::{Mechanism, Space};
use epicyclic_strength::sizing::Objective;
use epicyclic_train::Gear;
use std::ops::ControlFlow;
use uom::si::f64::{AngularVelocity, Torque};

/// Parts of the tolerance within which all deviations count as equal, in increasing order. The next class is
/// searched only if no design of a class has sizes. So beyond a tenth of the tolerance, accuracy is never
/// traded for mass.
pub(super) const CLASSES: [f64; 3] = [0.1, 1.0 / 3.0, 1.0];

/// Tooth numbers and sizes of a scheme.
pub(super) struct Attempt {
    pub(super) teeth: TeethStep,
    pub(super) sizes: Option<SizesStep>,
    /// Gearbox file with sizes; `None` unless every set has one.
    pub(super) file: Option<String>,
    /// Speeds reached with the chosen tooth numbers.
    pub(super) speeds: Vec<ReachedSpeed>,
    pub(super) warnings: Vec<Warning>,
}

impl Attempt {
    /// Designs one scheme: the class of least deviation in which a design has sizes, the best design first.
    pub(super) fn of(wanted: &Wanted, mechanism: Mechanism, watch: &Watch) -> Result<Self, Error> {
        let duty = &wanted.selection.duty;
        let torque = duty.torque()?.ok_or(Error::NoLoad)?;
        let speed = duty.input_speed.ok_or(Error::LoadWithoutSpeed)?;
        let tolerance = wanted.selection.requirements.tolerance;
        let (mut tried, mut listed, mut closer): (Vec<Tried>, usize, Option<f64>) = (vec![], 0, None);
        let (mut accepted, mut within) = (0, 0.0);
        for part in CLASSES {
            within = part * tolerance;
            // The search also lists the designs of the closer classes again.
            let of_teeth = of_teeth(wanted, mechanism, within, wanted.tries + listed);
            let found = teeth::search(&of_teeth, watch)?;
            accepted = found.searched().accepted;
            for place in 0..found.shown() {
                let speeds = found.speeds(place);
                let deviation = largest_deviation(&speeds);
                // A ratio at the edge of the tolerance may lead to a speed just beyond it.
                if deviation > within + OBJECTIVE
                    || closer.is_some_and(|closer| deviation <= closer + OBJECTIVE)
                {
                    continue;
                }
                listed += 1;
                if wanted.tooth_design.is_none_or(|wanted| wanted == listed) {
                    let goes_on = || watch(teeth::At { share: 1.0, searched: None });
                    let of_input = (torque, speed);
                    tried.push(Tried::of((&found, place), listed, speeds, wanted, of_input, &goes_on)?);
                }
            }
            let is_found = |one: &Tried| wanted.tooth_design.is_some() || one.is_whole();
            if tolerance == 0.0 || tried.iter().any(is_found) {
                break;
            }
            closer = Some(within);
        }
        if let Some(design) = wanted.tooth_design.filter(|_| tried.is_empty() && listed > 0) {
            return Err(Error::NoSuchDesign { design, designs: listed });
        }
        tried.sort_by(|one, other| {
            let practice = one.beyond_practice().cmp(&other.beyond_practice());
            practice.then(one.objective().total_cmp(&other.objective()))
        });
        let mut taken = tried.iter().map(|one| one.taken.clone());
        let teeth = TeethStep {
            accepted,
            tolerance: within,
            tried: tried.len(),
            taken: taken.next(),
            next: taken.next(),
        };
        let Some(best) = tried.into_iter().next() else {
            return Ok(Self { teeth, sizes: None, file: None, speeds: vec![], warnings: vec![] });
        };
        let file = if best.is_whole() {
            let document = Document::parse_one(MAKING, best.file.as_bytes())?;
            Some(size::saved(&document, &best.size)?)
        } else {
            None
        };
        let Tried { size, speeds, .. } = best;
        let warnings = warnings(&size, file.as_deref())?;
        Ok(Self { teeth, sizes: Some(SizesStep::of(size)), file, speeds, warnings })
    }
}

/// Requirements for the search for tooth numbers of one scheme, with ratios within a tolerance.
fn of_teeth(wanted: &Wanted, mechanism: Mechanism, tolerance: f64, most: usize) -> teeth::Wanted {
    let mut requirements = wanted.selection.requirements.clone();
    requirements.tolerance = tolerance;
    teeth::Wanted {
        requirements,
        order: order_of_teeth(),
        space: Space::Mechanisms(vec![mechanism]),
        bounds: wanted.bounds.clone(),
        shifts: wanted.ring_offsets.clone().map(|offsets| WantedShifts {
            offsets,
            aim: wanted.size.aim,
            tip_thickness: wanted.size.tip_thickness.get(),
        }),
        limits: SizeLimits::default(),
        most,
        nth: 1,
        speeds: wanted.selection.speeds.clone(),
        duty: wanted.selection.duty,
    }
}

/// Design of the tooth search with its sizes.
#[derive(Debug)]
struct Tried {
    /// Tooth numbers of the design.
    taken: TeethTaken,
    /// Speeds that the design reaches.
    speeds: Vec<ReachedSpeed>,
    /// Gearbox file without sizes.
    file: String,
    /// Sizes of the design.
    size: Size,
}

impl Tried {
    /// Sizes the design at a place of a search; `listed` is its number among all listed designs.
    fn of(
        (found, place): (&Searches<'_>, usize),
        listed: usize,
        speeds: Vec<ReachedSpeed>,
        wanted: &Wanted,
        (torque, speed): (Torque, AngularVelocity),
        goes_on: &dyn Fn() -> ControlFlow<()>,
    ) -> Result<Self, Error> {
        let (design, saved) = found.saved_design(place)?;
        let file = loaded(&saved, wanted, torque, speed)?;
        let document = Document::parse_one(MAKING, file.as_bytes())?;
        let size = size::answer(&one(&document, &Choice::default())?, &wanted.size, goes_on)?;
        let mut tried = Self { taken: TeethTaken::of(&design, listed), speeds, file, size };
        tried.taken.mass_kg = tried.mass_kg();
        Ok(tried)
    }

    /// Whether every set has a size.
    fn is_whole(&self) -> bool {
        self.size.not_sized.is_empty() && self.size.mass_kg.is_some()
    }

    /// Mass of the gears in kg; `None` unless every set has a size.
    fn mass_kg(&self) -> Option<f64> {
        self.size.mass_kg.filter(|_| self.is_whole())
    }

    /// Whether a set has no size, and then numbers of errors and of warnings by usual practice.
    fn beyond_practice(&self) -> (bool, [usize; 2]) {
        let [errors, warnings, _] = self.size.judgement.misses();
        (!self.is_whole(), [errors, warnings])
    }

    /// Objective to minimize; infinite if a set has no size.
    fn objective(&self) -> f64 {
        let rings = self.size.sets.iter().filter_map(|set| set.found.first()?.ring_diameter_m);
        let objective = match self.size.minimise {
            Objective::Mass => self.size.mass_kg,
            Objective::Ring => rings.reduce(f64::max),
            Objective::Whole => self.size.whole_kg,
        };
        objective.filter(|_| self.is_whole()).unwrap_or(f64::INFINITY)
    }
}

/// Gearbox file with its duty and the data for its strength. The number of planets and the profile shifts are
/// left to the sizing.
fn loaded(saved: &Saved, wanted: &Wanted, torque: Torque, speed: AngularVelocity) -> Result<String, Error> {
    let text = saved.file(&[]).map_err(|error| Error::Json(error.to_string()))?;
    let mut file = Document::parse_one(MAKING, text.as_bytes())?.value().clone();
    for_each_set(&mut file, |set| {
        for key in ["planets", "profile_shifts", "tip_alterations"] {
            set.remove(key);
        }
    });
    let gears = shared(saved.gearbox.gears().iter().map(Gear::name).collect(), &wanted.shares)?;
    let load = Load { torque, speed, overload: wanted.overload, spectrum: &FULL_LOAD };
    with_load(&mut file, &wanted.basis, &gears, load);
    if let Some(file) = file.as_mapping_mut() {
        file.insert("gearbox".into(), saved.scheme.as_str().into());
    }
    to_string(&file).map_err(|error| Error::Json(error.to_string()))
}
