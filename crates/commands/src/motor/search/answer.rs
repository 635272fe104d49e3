//! The search for hydromotors: non-dominated designs for a displacement or torque.

pub(crate) mod funnel;
mod objective;
mod teeth;

pub use funnel::{Funnel, Reason, Refused};
pub use objective::Objective;
pub use teeth::{AtFlanks, TeethLimits};

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::motor::answer::practice::{self, Borne};
use crate::motor::answer::{Designed, Groups, Subject};
use crate::motor::designs::answer::{Drawn, Listed, Origin, nearest_half, nth};
use crate::motor::forms::answer::Form;
use crate::shared::number::{maybe_si, plain, si};
use epicyclic_hydromotor::search::{self, Found, MotorSearch as Search};
use schemars::JsonSchema;
use serde::Serialize;
use teeth::Teeth;
use uom::si::f64::Angle;

/// What is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// What is searched; the teeth of its flanks are also those of limits and drawings.
    pub search: Search,
    /// What the designs are ordered by.
    pub order: Objective,
    /// Whether only the first design of each set of lobes and teeth is told.
    pub first_of_each_set: bool,
    /// How many designs are told, at most.
    pub most: usize,
}

/// Hydromotors for a displacement: designs that no other surpasses in all objectives together.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MotorSearch {
    /// The displacement wanted, a revolution.
    pub displacement_m3: f64,
    /// What the designs are held against each other by.
    pub objectives: Vec<Objective>,
    /// What they are ordered by.
    pub order: Objective,
    /// The tooth form.
    pub form: Form,
    /// Whether every design has teeth that keep their limits and ideal ports; else teeth and ports were not
    /// judged.
    pub made: bool,
    /// How many non-dominated designs there are.
    pub found: usize,
    /// Whether only the first of each set of lobes and teeth is told.
    pub first_of_each_set: bool,
    /// How many more designs could be told so.
    pub hidden: usize,
    /// The designs.
    pub designs: Vec<Design>,
    /// Motors tried, and why the others were refused.
    pub funnel: Funnel,
    /// By how much an admissible motor between the places tried may be better than every design, by estimate.
    pub spacing_error: SpacingError,
    /// By how much refinement found better motors than there are at even places.
    pub refinement_gain: SpacingError,
    /// Contact stress and pressure beyond limits of practice.
    pub warnings: Vec<Warning>,
}

/// A design: a shape, and the size shown of it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Design {
    /// Its number in the order.
    pub design: usize,
    /// How many designs have the same lobes and teeth.
    pub designs_of_the_set: usize,
    /// Lobes of the stator, `N`.
    pub stator_lobes: u32,
    /// Lobes of the rotor, `n`.
    pub rotor_lobes: u32,
    /// Teeth of the stator, `Z₃`.
    pub stator_teeth: u32,
    /// Teeth of the rotor, `Z₁`.
    pub rotor_teeth: u32,
    /// Teeth of a satellite, `Z_s`.
    pub satellite_teeth: u32,
    /// The place in the family: distance of the centres of the arcs at the troughs over the module.
    pub l_over_module: f64,
    /// Displacement over the volume of the cylinder about the stator's centrode.
    pub displacement_by_volume: f64,
    /// Ripple of flow and torque, satellites sealing at the pitch points.
    pub ripple: f64,
    /// Least over mean flow, which is that of the torque, satellites sealing at the pitch points.
    pub least_over_mean: f64,
    /// Both, satellites sealing at the flanks; null where there are none.
    pub at_flanks: Option<AtFlanks>,
    /// Why there are none.
    pub without_flanks: Option<String>,
    /// Least curvature radius of both centrodes over the module.
    pub least_radius_in_modules: f64,
    /// Whether the teeth keep their limits.
    pub teeth_limits: TeethLimits,
    /// The greatest contact stress of steel teeth where one pair of flanks carries alone, at the pressure;
    /// null without it or without teeth.
    pub contact_stress_pa: Option<f64>,
    /// The check of the centrodes with least to spare.
    pub nearest_check: Subject,
    /// How much that is, relative to the limit.
    pub nearest_margin: f64,
    /// By how much a motor between the places tried may be better, by estimate.
    pub spacing_error: SpacingError,
    /// The modules that serve.
    pub modules_m: Vec<f64>,
    /// Of the sizes with these modules the one whose width is nearest to half its diameter.
    pub size: Size,
}

/// A size of a design; torque and power without losses, satellites sealing at the pitch points.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Size {
    /// Module.
    pub module_m: f64,
    /// Width.
    pub width_m: f64,
    /// Greatest diameter of the stator's centrode; teeth and housing come on top.
    pub outer_diameter_m: f64,
    /// Distance of the centre of arc 1, at the troughs, from the axis.
    pub l_m: f64,
    /// Distance of the centre of arc 2, at the crests, from the axis.
    pub a_m: f64,
    /// Radius of arc 1.
    pub r1_m: f64,
    /// Radius of arc 2.
    pub r2_m: f64,
    /// Displacement a revolution.
    pub displacement_m3: f64,
    /// Mean torque; null without a pressure.
    pub torque_n_m: Option<f64>,
    /// Least torque.
    pub least_torque_n_m: Option<f64>,
    /// Mean flow; null without a speed.
    pub flow_m3_s: Option<f64>,
    /// Power; null without both.
    pub power_w: Option<f64>,
}

/// By how much motors may be better, relative, in each objective; null in what is none.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SpacingError {
    /// In displacement over volume.
    pub displacement_by_volume: Option<f64>,
    /// In ripple, satellites sealing at the pitch points.
    pub ripple: Option<f64>,
    /// In the least curvature radius.
    pub least_radius: Option<f64>,
    /// In ripple, satellites sealing at the flanks.
    pub flank_ripple: Option<f64>,
    /// In the least torque over the mean, satellites sealing at the flanks.
    pub least_torque: Option<f64>,
}

impl Answer for MotorSearch {
    const NAME: &'static str = "motor-search";
}

/// A search that is done: its answer, and the motor of each design.
#[derive(Debug, Clone)]
pub struct Searched {
    wanted: Wanted,
    /// With the designs in the order that is wanted.
    found: Found,
}

/// Searches; `watch` is told how far it is, from any thread, and may end it.
///
/// # Errors
/// [`Error::Motor`] for bounds that cannot be, or where the watch ended it; [`Error::NoMotor`] where no motor
/// passes.
pub fn search(wanted: &Wanted, watch: &search::Watch) -> Result<Searched, Error> {
    let mut found = wanted.search.front_watched(watch)?;
    let form = wanted.search.flanks.form;
    if found.designs.is_empty() {
        return Err(Error::NoMotor(Box::new(Funnel::of(&found))));
    }
    let order = wanted.order;
    if order.of_search().is_of_flanks() {
        for design in &mut found.designs {
            design.at_flanks = design.at_flanks.or_else(|| teeth::at_flanks(design, form));
        }
    }
    found.designs.sort_by(|one, other| order.cost(one).total_cmp(&order.cost(other)));
    Ok(Searched { wanted: wanted.clone(), found })
}

/// The answer of a search.
///
/// # Errors
/// As [`search()`].
pub fn answer(wanted: &Wanted) -> Result<MotorSearch, Error> {
    Ok(search(wanted, &|_| std::ops::ControlFlow::Continue(()))?.answer())
}

impl Searched {
    /// The answer.
    #[must_use]
    pub fn answer(&self) -> MotorSearch {
        let Self { wanted, found } = self;
        let listed =
            Listed::of(&found.designs, wanted.first_of_each_set, wanted.most, |design| design.numbers);
        let designs: Vec<Design> =
            listed.shown.iter().filter_map(|&(place, design)| self.design(place, design)).collect();
        let borne: Vec<Borne> =
            designs.iter().filter_map(|design| design.contact_stress_pa.map(Borne::Contact)).collect();
        let warnings = practice::of_designs(maybe_si(wanted.search.requirements.pressure_drop), &borne);
        MotorSearch {
            warnings,
            displacement_m3: si(wanted.search.requirements.displacement),
            objectives: wanted.search.objectives.iter().map(|&objective| Objective::of(objective)).collect(),
            order: wanted.order,
            form: Form::of(&wanted.search.flanks.form),
            made: wanted.search.made,
            found: found.designs.len(),
            first_of_each_set: wanted.first_of_each_set,
            hidden: listed.hidden,
            designs,
            funnel: Funnel::of(found),
            spacing_error: self.error(found.spacing_error),
            refinement_gain: self.error(found.refinement_gain),
        }
    }

    /// The motor of a design, in the size shown of it; the first is 1.
    ///
    /// # Errors
    /// [`Error::NoSuchDesign`].
    pub fn motor(&self, design: usize, angle: Angle) -> Result<Designed, Error> {
        let (design, size) = nth(&self.found.designs, design, shown_size)?;
        let motor = design.motor(size.module)?;
        let (form, made) = (self.wanted.search.flanks.form, &Groups::default());
        Drawn { motor, form, width: size.width, angle, made }.designed(&self.wanted.search.requirements)
    }

    /// The file of a design, in the size shown of it; the first is 1.
    ///
    /// # Errors
    /// [`Error::NoSuchDesign`].
    pub fn saved(&self, design: usize) -> Result<String, Error> {
        let designed = self.motor(design, Angle::default())?;
        let found = Origin { design, of: self.found.designs.len(), by: "motor search" };
        found.saved(&designed, None)
    }

    /// `None` of a design without a size, of which a search finds none.
    fn design(&self, place: usize, design: &search::Design) -> Option<Design> {
        let numbers = design.numbers;
        let size = shown_size(design)?;
        let teeth = Teeth::of(design, &self.wanted.search);
        let (at_flanks, without_flanks) = match teeth.at_flanks {
            Ok(at_flanks) => (Some(at_flanks), None),
            Err(why) => (None, Some(why)),
        };
        let ripple = design.motor(size.module).ok()?.ripple();
        let found = &self.found;
        Some(Design {
            design: place + 1,
            designs_of_the_set: found.designs.iter().filter(|other| other.numbers == numbers).count(),
            stator_lobes: numbers.stator_lobes(),
            rotor_lobes: numbers.rotor_lobes(),
            stator_teeth: numbers.stator_teeth(),
            rotor_teeth: numbers.rotor_teeth(),
            satellite_teeth: numbers.satellite_teeth(),
            l_over_module: si(size.trough_distance) / si(size.module),
            displacement_by_volume: plain(design.displacement_by_volume),
            ripple: plain(design.ripple),
            least_over_mean: si(ripple.least) / si(ripple.mean),
            at_flanks,
            without_flanks,
            least_radius_in_modules: plain(design.least_radius),
            teeth_limits: teeth.limits,
            contact_stress_pa: teeth.contact_stress_pa,
            nearest_check: Subject::of(design.nearest_check),
            nearest_margin: plain(design.nearest_margin),
            spacing_error: self.error(design.spacing_error),
            modules_m: design.dimensions.iter().map(|size| si(size.module)).collect(),
            size: Size::of(size),
        })
    }

    /// In the objectives alone.
    fn error(&self, error: search::SpacingError) -> SpacingError {
        let of = |objective, value| self.wanted.search.objectives.contains(&objective).then(|| plain(value));
        SpacingError {
            displacement_by_volume: of(search::Objective::DisplacementByVolume, error.displacement_by_volume),
            ripple: of(search::Objective::Ripple, error.ripple),
            least_radius: of(search::Objective::LeastRadius, error.least_radius),
            flank_ripple: of(search::Objective::FlankRipple, error.flank_ripple),
            least_torque: of(search::Objective::LeastTorque, error.least_torque),
        }
    }
}

/// The size that is shown of a design.
fn shown_size(design: &search::Design) -> Option<&search::Dimensions> {
    nearest_half(&design.dimensions, |size| [size.width, size.outer_diameter])
}

impl Size {
    fn of(size: &search::Dimensions) -> Self {
        Self {
            module_m: si(size.module),
            width_m: si(size.width),
            outer_diameter_m: si(size.outer_diameter),
            l_m: si(size.trough_distance),
            a_m: si(size.crest_distance),
            r1_m: si(size.trough_radius),
            r2_m: si(size.crest_radius),
            displacement_m3: si(size.displacement),
            torque_n_m: maybe_si(size.torque),
            least_torque_n_m: maybe_si(size.least_torque),
            flow_m3_s: maybe_si(size.flow),
            power_w: maybe_si(size.power),
        }
    }
}
