//! Search for hydromotors: non-dominated designs for a displacement or torque.

pub(crate) mod funnel;
mod objective;
mod teeth;

pub use funnel::{Funnel, Refused};
pub use objective::Objective;
pub use teeth::{AtFlanks, TeethLimits};

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::motor::answer::practice::{self, Borne};
use crate::motor::answer::{Designed, Groups};
use crate::motor::designs::answer::{Drawn, Listed, Listing, Searched, nearest_half, nth};
use crate::motor::forms::answer::Form;
use crate::shared::judgement::answer::Judgement;
use crate::shared::number::{maybe_si, plain, si};
use epicyclic_formats::motor::MaterialGroup;
use epicyclic_hydromotor::arcs::StatorArcs;
use epicyclic_hydromotor::checks::Subject;
use epicyclic_hydromotor::search::{self, Found, MotorSearch as Search};
use schemars::JsonSchema;
use serde::Serialize;
use teeth::Teeth;
use uom::si::f64::Angle;

/// Hydromotors for a displacement: the non-dominated (Pareto) designs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MotorSearch {
    /// Required displacement per revolution in m³.
    pub displacement_m3: f64,
    /// Objectives by which designs are compared.
    pub objectives: Vec<Objective>,
    /// Objective by which the designs are ordered.
    pub order: Objective,
    /// Tooth form of the designs.
    pub form: Form,
    /// Whether every design has teeth within their limits and ideal ports; otherwise teeth and ports were not
    /// checked.
    pub made: bool,
    /// Number of non-dominated designs.
    pub found: usize,
    /// Whether only the first design of each set of lobes and teeth is listed.
    pub first_of_each_set: bool,
    /// Number of further designs that are not listed.
    pub hidden: usize,
    /// Listed designs.
    pub designs: Vec<Design>,
    /// Number of motors computed, and the reasons why others were refused.
    pub funnel: Funnel,
    /// Estimated relative improvement of an admissible motor between the computed places over every design.
    pub spacing_error: SpacingError,
    /// Relative improvement by refinement over motors at even places.
    pub refinement_gain: SpacingError,
    /// Judgement of the listed designs by rules of practice.
    pub judgement: Judgement,
    /// Warnings: a miss of each rule.
    pub warnings: Vec<Warning>,
}

/// Design: a shape, and the size shown for it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Design {
    /// Number of the design in the order.
    pub design: usize,
    /// Number of designs with the same lobes and teeth.
    pub designs_of_the_set: usize,
    /// Number of lobes of the stator, `N`.
    pub stator_lobes: u32,
    /// Number of lobes of the rotor, `n`.
    pub rotor_lobes: u32,
    /// Tooth number of the stator, `Z₃`.
    pub stator_teeth: u32,
    /// Tooth number of the rotor, `Z₁`.
    pub rotor_teeth: u32,
    /// Tooth number of a satellite, `Z_s`.
    pub satellite_teeth: u32,
    /// Place in the family: distance of the centres of the arcs at the troughs over the module.
    pub l_over_module: f64,
    /// Displacement per volume of the cylinder around the stator's centrode.
    pub displacement_by_volume: f64,
    /// Ripple of flow and torque if satellites seal at the pitch points.
    pub ripple: f64,
    /// Least over mean flow, equal to least over mean torque, if satellites seal at the pitch points.
    pub least_over_mean: f64,
    /// Ripple and least over mean flow if satellites seal at the flanks; null if there are no such values.
    pub at_flanks: Option<AtFlanks>,
    /// Reason why there are no values at the flanks; null if there are.
    pub without_flanks: Option<String>,
    /// Least curvature radius of both centrodes, in modules.
    pub least_radius_in_modules: f64,
    /// Whether the teeth are within their limits.
    pub teeth_limits: TeethLimits,
    /// Greatest contact stress of steel teeth at the given pressure while a single pair of flanks carries, in
    /// Pa; null without a pressure or teeth.
    pub contact_stress_pa: Option<f64>,
    /// Check of the centrodes with the least margin.
    pub nearest_check: Subject,
    /// Least margin relative to the limit.
    pub nearest_margin: f64,
    /// Estimated relative improvement of a motor between the computed places.
    pub spacing_error: SpacingError,
    /// Modules that meet the requirements, in m.
    pub modules_m: Vec<f64>,
    /// Size of the design: among these modules, the one whose width is closest to half its diameter.
    pub size: Size,
}

/// Size of a design. Torque and power are without losses, for satellites that seal at the pitch points.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Size {
    /// Module in m.
    pub module_m: f64,
    /// Width in m.
    pub width_m: f64,
    /// Greatest diameter of the stator's centrode in m, without teeth and housing.
    pub outer_diameter_m: f64,
    /// Distance of the centre of arc 1, at the troughs, from the axis, in m.
    pub l_m: f64,
    /// Distance of the centre of arc 2, at the crests, from the axis, in m.
    pub a_m: f64,
    /// Radius of arc 1 in m.
    pub r1_m: f64,
    /// Radius of arc 2 in m.
    pub r2_m: f64,
    /// Displacement per revolution in m³.
    pub displacement_m3: f64,
    /// Mean torque in N·m; null without a pressure.
    pub torque_n_m: Option<f64>,
    /// Least torque in N·m; null without a pressure.
    pub least_torque_n_m: Option<f64>,
    /// Mean flow in m³/s; null without a speed.
    pub flow_m3_s: Option<f64>,
    /// Power in W; null without pressure and speed.
    pub power_w: Option<f64>,
}

/// Relative improvement in each objective; null if it is not an objective of the search.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SpacingError {
    /// Improvement of the displacement per volume.
    pub displacement_by_volume: Option<f64>,
    /// Improvement of the ripple, if satellites seal at the pitch points.
    pub ripple: Option<f64>,
    /// Improvement of the least curvature radius.
    pub least_radius: Option<f64>,
    /// Improvement of the ripple, if satellites seal at the flanks.
    pub flank_ripple: Option<f64>,
    /// Improvement of least over mean torque, if satellites seal at the flanks.
    pub least_torque: Option<f64>,
}

impl Answer for MotorSearch {
    const NAME: &'static str = "motor-search";
}

/// Finished search for motors with teeth of one form.
#[derive(Debug, Clone)]
pub struct SearchedMotors {
    search: Search,
    order: Objective,
    /// Results with the designs in the requested order.
    found: Found,
}

/// Searches for designs; `watch` receives the progress from any thread, and may end the search.
///
/// # Errors
/// [`Error::Motor`] for impossible bounds, or if `watch` ended the search; [`Error::NoMotor`] if no motor is
/// accepted.
pub(super) fn search(
    search: Search,
    order: Objective,
    watch: &search::Watch,
) -> Result<SearchedMotors, Error> {
    let mut found = search.front_watched(watch)?;
    if found.designs.is_empty() {
        return Err(Error::NoMotor(Box::new(Funnel::of(&found))));
    }
    if order.of_search().is_of_flanks() {
        // The search computes flanks only if they are an objective; the order needs them for all designs.
        for design in &mut found.designs {
            design.at_flanks = design.at_flanks.or_else(|| teeth::at_flanks(design, search.flanks.form));
        }
    }
    found.designs.sort_by(|one, other| order.cost(one).total_cmp(&order.cost(other)));
    Ok(SearchedMotors { search, order, found })
}

impl Searched for SearchedMotors {
    type Answer = MotorSearch;

    const COMMAND: &'static str = "motor search";

    fn answer(&self, listing: Listing) -> MotorSearch {
        let Self { search, found, .. } = self;
        let listed = Listed::of(&found.designs, listing, |design| design.numbers);
        let designs: Vec<Design> =
            listed.shown.iter().filter_map(|&(place, design)| self.design(place, design)).collect();
        let judged: Vec<practice::Searched> = designs
            .iter()
            .map(|design| practice::Searched {
                name: format!("design {}", design.design),
                least_chamber_m2: None,
                ripple: design.at_flanks.as_ref().map_or(design.ripple, |at| at.ripple),
                borne: design.contact_stress_pa.map(Borne::Contact),
            })
            .collect();
        let judgement = practice::of_designs(maybe_si(search.requirements.pressure_drop), &judged);
        MotorSearch {
            warnings: judgement.warnings_of_rules(),
            judgement,
            displacement_m3: si(search.requirements.displacement),
            objectives: search.objectives.iter().map(|&objective| Objective::of(objective)).collect(),
            order: self.order,
            form: Form::of(&search.flanks.form),
            made: search.made,
            found: found.designs.len(),
            first_of_each_set: listing.first_of_each_set,
            hidden: listed.hidden,
            designs,
            funnel: Funnel::of(found),
            spacing_error: self.error(found.spacing_error),
            refinement_gain: self.error(found.refinement_gain),
        }
    }

    fn counts(answer: &MotorSearch) -> [usize; 3] {
        [answer.found, answer.designs.len(), answer.hidden]
    }

    fn motor(&self, design: usize, angle: Angle) -> Result<Designed, Error> {
        let (design, size) = nth(&self.found.designs, design, shown_size)?;
        let motor = design.motor(size.module)?;
        let (form, made) = (self.search.flanks.form, &Groups::default());
        Drawn { motor, form, width: size.width, angle, made }.designed(&self.search.requirements)
    }

    fn designs(&self) -> usize {
        self.found.designs.len()
    }

    fn material(&self) -> Option<&MaterialGroup> {
        None
    }
}

impl SearchedMotors {
    /// Record of a design; `None` if it has no size, which a search never returns.
    fn design(&self, place: usize, design: &search::Design) -> Option<Design> {
        let numbers = design.numbers;
        let size = shown_size(design)?;
        let arcs = design.arcs(size.module).ok()?;
        let teeth = Teeth::of(design, &self.search);
        let (at_flanks, without_flanks) = match teeth.at_flanks {
            Ok(at_flanks) => (Some(at_flanks), None),
            Err(why) => (None, Some(why)),
        };
        // The ratio of least to mean flow does not depend on the module, so the shown size serves for it.
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
            l_over_module: si(arcs.trough_distance()) / si(size.module),
            displacement_by_volume: plain(design.displacement_by_volume),
            ripple: plain(design.ripple),
            least_over_mean: si(ripple.least) / si(ripple.mean),
            at_flanks,
            without_flanks,
            least_radius_in_modules: plain(design.least_radius),
            teeth_limits: teeth.limits,
            contact_stress_pa: teeth.contact_stress_pa,
            nearest_check: design.nearest_check,
            nearest_margin: plain(design.nearest_margin),
            spacing_error: self.error(design.spacing_error),
            modules_m: design.dimensions.iter().map(|size| si(size.module)).collect(),
            size: Size::of(size, &arcs),
        })
    }

    /// Improvements limited to the objectives of the search.
    fn error(&self, error: search::SpacingError) -> SpacingError {
        // An estimate is meaningless for a value that the search did not optimize.
        let of = |objective, value| self.search.objectives.contains(&objective).then(|| plain(value));
        SpacingError {
            displacement_by_volume: of(search::Objective::DisplacementByVolume, error.displacement_by_volume),
            ripple: of(search::Objective::Ripple, error.ripple),
            least_radius: of(search::Objective::LeastRadius, error.least_radius),
            flank_ripple: of(search::Objective::FlankRipple, error.flank_ripple),
            least_torque: of(search::Objective::LeastTorque, error.least_torque),
        }
    }
}

/// Size that is shown for a design.
fn shown_size(design: &search::Design) -> Option<&search::Dimensions> {
    nearest_half(&design.dimensions)
}

impl Size {
    fn of(size: &search::Dimensions, arcs: &StatorArcs) -> Self {
        Self {
            module_m: si(size.module),
            width_m: si(size.width),
            outer_diameter_m: si(size.outer_diameter),
            l_m: si(arcs.trough_distance()),
            a_m: si(arcs.crest_distance()),
            r1_m: si(arcs.trough_radius()),
            r2_m: si(arcs.crest_radius()),
            displacement_m3: si(size.displacement),
            torque_n_m: maybe_si(size.torque),
            least_torque_n_m: maybe_si(size.least_torque),
            flow_m3_s: maybe_si(size.flow),
            power_w: maybe_si(size.power),
        }
    }
}
