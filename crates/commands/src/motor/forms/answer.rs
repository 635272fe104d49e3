//! Search for hydromotors with free tooth form: families, forms and flanks under load, for a displacement or
//! torque.

mod choices;
pub(crate) mod funnel;

pub use choices::{Crest, Family, Objective};
pub use funnel::{Funnel, Refused};

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::motor::answer::practice::{self, Borne};
use crate::motor::answer::{Designed, GoverningLimit, Groups};
use crate::motor::designs::answer::{Drawn, Listed, Listing, Searched, nearest_half, nth};
use crate::shared::judgement::answer::Judgement;
use crate::shared::number::{maybe_si, plain, si};
use epicyclic_formats::motor::MaterialGroup;
use epicyclic_hydromotor::flanks::{MaterialLimits, effective_modulus};
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::search::forms::{FlankFigures, FormDesign, FormFound, FormSearch};
use epicyclic_hydromotor::search::{Dimensions, Watch};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Angle, Pressure};

/// Material of satellites and wheels with its limits of contact and root stress. Without given limits any
/// will do: stresses do not depend on them, and allowed pressures are not listed.
///
/// # Errors
/// [`Error::Motor`] for a modulus that is not above 0, or a Poisson's ratio outside 0 to 0.5.
pub(super) fn material(
    youngs_modulus: Pressure,
    poissons_ratio: f64,
    limits: Option<[Pressure; 2]>,
) -> Result<MaterialLimits, Error> {
    let modulus = effective_modulus([youngs_modulus; 2], [poissons_ratio; 2])?;
    let [contact, root] = limits.unwrap_or([modulus; 2]);
    Ok(MaterialLimits { contact, root, modulus })
}

/// Hydromotors with their tooth forms for a displacement: the non-dominated (Pareto) designs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MotorForms {
    /// Required displacement per revolution in m³.
    pub displacement_m3: f64,
    /// Objectives by which designs are compared.
    pub objectives: Vec<Objective>,
    /// Objective by which the designs are ordered.
    pub order: Objective,
    /// Resolution of the front: no admissible point of the space is better than every design by more than
    /// this, relative, in any objective. Null if the designs are the exact front.
    pub resolution: Option<f64>,
    /// Number of non-dominated designs.
    pub found: usize,
    /// Whether only the first design of each set of lobes and teeth is listed.
    pub first_of_each_set: bool,
    /// Number of further designs that are not listed.
    pub hidden: usize,
    /// Listed designs.
    pub designs: Vec<Design>,
    /// Space of motors and tooth forms, with the numbers of points refused and accepted.
    pub funnel: Funnel,
    /// Judgement of the listed designs by rules of practice.
    pub judgement: Judgement,
    /// Warnings: a miss of each rule.
    pub warnings: Vec<Warning>,
}

/// Design: a motor with a tooth form, and the size shown for it.
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
    /// Family of the motor.
    pub family: Family,
    /// Place in the family of two arcs: distance of the centres of the arcs at the troughs over the module;
    /// null in other families.
    pub l_over_module: Option<f64>,
    /// Relative amplitude of the rotor's second harmonic, `ε₂`: 0 by the cosine law; null for two arcs.
    pub second_amplitude: Option<f64>,
    /// Tooth form of the design.
    pub form: Form,
    /// Displacement per volume of the cylinder around the stator's centrode.
    pub displacement_by_volume: f64,
    /// Ripple of flow and torque if satellites seal at the pitch points.
    pub ripple: f64,
    /// Least curvature radius of both centrodes, in modules.
    pub least_radius_in_modules: f64,
    /// Contact ratio: the shortest path of contact of any flank over the base pitch.
    pub contact_ratio: f64,
    /// Flanks under load; null if they cannot hold a satellite.
    pub flanks: Option<Flanks>,
    /// Modules that meet the requirements, in m.
    pub modules_m: Vec<f64>,
    /// Size of the design: among these modules, the one whose width is closest to half its diameter.
    pub size: Size,
}

/// Tooth form; lengths in modules.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Form {
    /// Pressure angle of the satellites, `α`, in rad.
    pub pressure_angle_rad: f64,
    /// Addendum `h_a*`, in modules.
    pub addendum: f64,
    /// Profile shift `x` of the satellites, in modules; the wheels have `−x`.
    pub shift: f64,
    /// Clearance `c*` between tips and roots, in modules.
    pub clearance: f64,
    /// Tip radius `ρ*` of the cutters, in modules.
    pub fillet: f64,
    /// Backlash `j*` along the pitch curves, in modules.
    pub backlash: f64,
    /// Tooth or space in the middle of the stator's crests.
    pub crest: Crest,
}

/// Flanks under load, for rigid teeth with all load on one pair on its whole path. The values are bounds, for
/// comparison.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Flanks {
    /// Ripple of flow and torque if satellites seal at the flanks.
    pub ripple: f64,
    /// Least over mean flow, equal to least over mean torque.
    pub least_over_mean: f64,
    /// Greatest Hertzian contact stress in Pa; null without a pressure.
    pub contact_on_path_pa: Option<f64>,
    /// Greatest bending stress at a root, in Pa; null without a pressure.
    pub root_on_path_pa: Option<f64>,
    /// Pressure drop that the material allows; null without limits of the material.
    pub allowed: Option<Allowed>,
}

impl Flanks {
    fn borne(&self) -> Option<Borne> {
        let allowed = self
            .allowed
            .as_ref()
            .map(|allowed| Borne::Allowed { pressure_pa: allowed.on_path_pa, governing: allowed.governing });
        allowed.or(self.contact_on_path_pa.map(Borne::Contact))
    }
}

/// Pressure drop that the limits of the material allow.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Allowed {
    /// Allowed pressure drop in Pa: the least by contact and root stress.
    pub on_path_pa: f64,
    /// Pressure drop allowed by contact stress, in Pa.
    pub by_contact_pa: f64,
    /// Pressure drop allowed by root bending, in Pa.
    pub by_root_pa: f64,
    /// Limit that governs the allowed pressure drop.
    pub governing: GoverningLimit,
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
    /// Place in the family of two arcs: distance of the centres of the arcs at the troughs from the axis, in
    /// m; null in other families.
    pub l_m: Option<f64>,
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

impl Answer for MotorForms {
    const NAME: &'static str = "motor-forms";
}

/// Finished search for motors with their tooth forms.
#[derive(Debug, Clone)]
pub struct SearchedForms {
    search: FormSearch,
    order: Objective,
    material: MaterialGroup,
    /// Results with the designs in the requested order.
    found: FormFound,
}

/// Searches for designs; `watch` receives the progress from any thread, and may end the search.
///
/// # Errors
/// [`Error::Motor`] for impossible bounds, or if `watch` ended the search; [`Error::NoMotorForm`] if no point
/// is admissible.
pub(super) fn search(
    search: FormSearch,
    order: Objective,
    material: MaterialGroup,
    watch: &Watch,
) -> Result<SearchedForms, Error> {
    let mut found = search.front_watched(watch)?;
    if found.designs.is_empty() {
        return Err(Error::NoMotorForm(Box::new(Funnel::of(&found))));
    }
    // The sort is stable, so equal designs keep the order of the search and their numbers are reproducible.
    found.designs.sort_by(|one, other| order.cost(one).total_cmp(&order.cost(other)));
    Ok(SearchedForms { search, order, material, found })
}

impl Searched for SearchedForms {
    type Answer = MotorForms;

    const COMMAND: &'static str = "motor forms";

    fn answer(&self, listing: Listing) -> MotorForms {
        let Self { search, found, .. } = self;
        let listed = Listed::of(&found.designs, listing, |design| design.numbers);
        let designs: Vec<Design> =
            listed.shown.iter().filter_map(|&(place, design)| self.design(place, design)).collect();
        let judged: Vec<practice::Searched> = designs
            .iter()
            .map(|design| practice::Searched {
                name: format!("design {}", design.design),
                least_chamber_m2: None,
                ripple: design.flanks.as_ref().map_or(design.ripple, |flanks| flanks.ripple),
                borne: design.flanks.as_ref().and_then(Flanks::borne),
            })
            .collect();
        let judgement = practice::of_designs(maybe_si(search.requirements.pressure_drop), &judged);
        MotorForms {
            warnings: judgement.warnings_of_rules(),
            judgement,
            displacement_m3: si(search.requirements.displacement),
            objectives: search.objectives.iter().map(|&objective| Objective::of(objective)).collect(),
            order: self.order,
            resolution: search.resolution.map(plain),
            found: found.designs.len(),
            first_of_each_set: listing.first_of_each_set,
            hidden: listed.hidden,
            designs,
            funnel: Funnel::of(found),
        }
    }

    fn counts(answer: &MotorForms) -> [usize; 3] {
        [answer.found, answer.designs.len(), answer.hidden]
    }

    fn motor(&self, design: usize, angle: Angle) -> Result<Designed, Error> {
        let (design, size) = nth(&self.found.designs, design, shown_size)?;
        let motor = design.motor(size.module)?;
        let made = &Groups { material: Some(self.material.clone()), ..Groups::default() };
        Drawn { motor, form: design.form, width: size.width, angle, made }.designed(&self.search.requirements)
    }

    fn designs(&self) -> usize {
        self.found.designs.len()
    }

    fn material(&self) -> Option<&MaterialGroup> {
        Some(&self.material)
    }
}

impl SearchedForms {
    /// Record of a design; `None` if it has no size, which a search never returns.
    fn design(&self, place: usize, design: &FormDesign) -> Option<Design> {
        let numbers = design.numbers;
        let size = shown_size(design)?;
        let l_over_module = design.trough_distance_over_module().map(plain);
        // Without limits of the material no allowed pressure is listed.
        let has_limits = self.material.contact_limit.is_some() && self.material.root_limit.is_some();
        let of_the_set = self.found.designs.iter().filter(|other| other.numbers == numbers).count();
        Some(Design {
            design: place + 1,
            designs_of_the_set: of_the_set,
            stator_lobes: numbers.stator_lobes(),
            rotor_lobes: numbers.rotor_lobes(),
            stator_teeth: numbers.stator_teeth(),
            rotor_teeth: numbers.rotor_teeth(),
            satellite_teeth: numbers.satellite_teeth(),
            family: Family::of(design.family),
            l_over_module,
            second_amplitude: design.second_amplitude().map(plain),
            form: Form::of(&design.form),
            displacement_by_volume: plain(design.displacement_by_volume),
            ripple: plain(design.ripple),
            least_radius_in_modules: plain(design.least_radius),
            contact_ratio: plain(design.contact_ratio),
            flanks: design.flanks.as_ref().map(|flanks| Flanks::of(flanks, has_limits)),
            modules_m: design.sizes.iter().map(|size| si(size.module)).collect(),
            size: Size::of(size, l_over_module),
        })
    }
}

/// Size that is shown for a design.
fn shown_size(design: &FormDesign) -> Option<&Dimensions> {
    nearest_half(&design.sizes)
}

impl Form {
    pub(crate) fn of(form: &ToothForm) -> Self {
        Self {
            pressure_angle_rad: si(form.pressure_angle),
            addendum: plain(form.addendum),
            shift: plain(form.shift),
            clearance: plain(form.clearance),
            fillet: plain(form.fillet),
            backlash: plain(form.backlash),
            crest: Crest::of(form.crest),
        }
    }
}

impl Flanks {
    fn of(flanks: &FlankFigures, has_limits: bool) -> Self {
        // A loaded satellite without a path of contact has an infinite stress, which JSON cannot hold.
        let finite = |stress: &f64| stress.is_finite();
        let allowed = &flanks.allowed;
        let of_limits = || Allowed {
            on_path_pa: si(allowed.pressure),
            by_contact_pa: si(allowed.by_contact),
            by_root_pa: si(allowed.by_root),
            governing: GoverningLimit::of(allowed.governing),
        };
        Self {
            ripple: plain(flanks.ripple),
            least_over_mean: plain(flanks.least_over_mean),
            contact_on_path_pa: maybe_si(flanks.contact_stress).filter(finite),
            root_on_path_pa: maybe_si(flanks.root_stress).filter(finite),
            allowed: has_limits.then(of_limits),
        }
    }
}

impl Size {
    fn of(size: &Dimensions, l_over_module: Option<f64>) -> Self {
        Self {
            module_m: si(size.module),
            width_m: si(size.width),
            outer_diameter_m: si(size.outer_diameter),
            l_m: l_over_module.map(|l| l * si(size.module)),
            displacement_m3: si(size.displacement),
            torque_n_m: maybe_si(size.torque),
            least_torque_n_m: maybe_si(size.least_torque),
            flow_m3_s: maybe_si(size.flow),
            power_w: maybe_si(size.power),
        }
    }
}
