//! The search for hydromotors with the tooth form free: families, forms and flanks under load, for a
//! displacement or torque.

mod choices;
pub(crate) mod funnel;

pub use choices::{Crest, Family, Objective};
pub use funnel::{Funnel, Refused};

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::motor::answer::practice::{self, Borne};
use crate::motor::answer::{Designed, GoverningLimit, Groups};
use crate::motor::designs::answer::{Drawn, Listed, Origin, nearest_half, nth};
use crate::shared::number::{maybe_si, plain, si};
use epicyclic_hydromotor::flanks::{MaterialLimits, effective_modulus};
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::search::forms::{FlankFigures, FormDesign, FormFound, FormSearch, FormSize};
use epicyclic_hydromotor::search::{Progress, Watch};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Angle, Pressure};

/// What is wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// What is searched.
    pub search: FormSearch,
    /// Whether its material has limits; without them no allowed pressure is told.
    pub has_limits: bool,
    /// What the designs are ordered by.
    pub order: Objective,
    /// Whether only the first design of each set of lobes and teeth is told.
    pub first_of_each_set: bool,
    /// How many designs are told, at most.
    pub most: usize,
    /// What a maker says of the motor that is drawn: its material.
    pub made: Groups,
}

/// Satellites and wheels of one material, with its limits of contact and root stress. Without limits any do:
/// stresses do not depend on them, and what they would allow is not told.
///
/// # Errors
/// [`Error::Motor`] for a modulus that is not above 0, or a Poisson's ratio outside 0 to 0.5.
pub fn material(
    youngs_modulus: Pressure,
    poissons_ratio: f64,
    limits: Option<[Pressure; 2]>,
) -> Result<MaterialLimits, Error> {
    let modulus = effective_modulus([youngs_modulus; 2], [poissons_ratio; 2])?;
    let [contact, root] = limits.unwrap_or([modulus; 2]);
    Ok(MaterialLimits { contact, root, modulus })
}

/// Hydromotors with their tooth forms for a displacement: designs that no other surpasses in all objectives
/// together.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MotorForms {
    /// The displacement wanted, a revolution.
    pub displacement_m3: f64,
    /// What the designs are held against each other by.
    pub objectives: Vec<Objective>,
    /// What they are ordered by.
    pub order: Objective,
    /// Every admissible point of the space, tried or not, is in no objective better than some design by more
    /// than this, relative; null where the designs are the exact front of all admissible points.
    pub resolution: Option<f64>,
    /// How many non-dominated designs there are.
    pub found: usize,
    /// Whether only the first of each set of lobes and teeth is told.
    pub first_of_each_set: bool,
    /// How many more designs could be told so.
    pub hidden: usize,
    /// The designs.
    pub designs: Vec<Design>,
    /// The space of motors and tooth forms, and what became of its points.
    pub funnel: Funnel,
    /// Contact stress and pressure beyond what the material allows or limits of practice.
    pub warnings: Vec<Warning>,
}

/// A design: a motor with a tooth form, and the size shown of it.
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
    /// The family.
    pub family: Family,
    /// The place in the family of two arcs: distance of the centres of the arcs at the troughs over the
    /// module; null elsewhere.
    pub l_over_module: Option<f64>,
    /// The relative amplitude of the rotor's second harmonic, `ε₂`: 0 by the cosine law; null for two arcs.
    pub second_amplitude: Option<f64>,
    /// The tooth form.
    pub form: Form,
    /// Displacement over the volume of the cylinder about the stator's centrode.
    pub displacement_by_volume: f64,
    /// Ripple of flow and torque, satellites sealing at the pitch points.
    pub ripple: f64,
    /// Least curvature radius of both centrodes over the module.
    pub least_radius_in_modules: f64,
    /// The shortest path of contact of any flank over the base pitch.
    pub contact_ratio: f64,
    /// The flanks under load; null where they cannot hold a satellite.
    pub flanks: Option<Flanks>,
    /// The modules that serve.
    pub modules_m: Vec<f64>,
    /// Of the sizes with these modules the one whose width is nearest to half its diameter.
    pub size: Size,
}

/// A tooth form; lengths in modules.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Form {
    /// Pressure angle of the satellites, `α`.
    pub pressure_angle_rad: f64,
    /// Addendum `h_a*`.
    pub addendum: f64,
    /// Profile shift `x` of the satellites; the wheels have `−x`.
    pub shift: f64,
    /// Clearance `c*` of tips over roots.
    pub clearance: f64,
    /// Radius `ρ*` of the rounded tips of the cutters.
    pub fillet: f64,
    /// Backlash `j*` along the pitch curves.
    pub backlash: f64,
    /// What lies in the middle of the stator's crests.
    pub crest: Crest,
}

/// Flanks under load, of rigid teeth with all load on one pair on its whole path: bounds, for comparison.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Flanks {
    /// Ripple of flow and torque, satellites sealing at the flanks.
    pub ripple: f64,
    /// Least over mean flow, which is that of the torque.
    pub least_over_mean: f64,
    /// Greatest contact stress of Hertz; null without a pressure.
    pub contact_on_path_pa: Option<f64>,
    /// Greatest bending stress at a root; null without a pressure.
    pub root_on_path_pa: Option<f64>,
    /// The pressure drop that the material allows; null without limits of it.
    pub allowed: Option<Allowed>,
}

impl Flanks {
    fn borne(&self) -> Option<Borne> {
        let allowed = self.allowed.as_ref().map(|allowed| Borne::Allowed(allowed.on_path_pa));
        allowed.or(self.contact_on_path_pa.map(Borne::Contact))
    }
}

/// The pressure drop that limits of the material allow.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Allowed {
    /// The least of both.
    pub on_path_pa: f64,
    /// By contact.
    pub by_contact_pa: f64,
    /// By bending.
    pub by_root_pa: f64,
    /// What limits it.
    pub governing: GoverningLimit,
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
    /// The place in the family of two arcs: distance of the centres of the arcs at the troughs from the axis;
    /// null elsewhere.
    pub l_m: Option<f64>,
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

impl Answer for MotorForms {
    const NAME: &'static str = "motor-forms";
}

/// A search that is done: its answer, and the motor of each design.
#[derive(Debug, Clone)]
pub struct Searched {
    wanted: Wanted,
    /// With the designs in the order that is wanted.
    found: FormFound,
}

/// Searches; `watch` is told how far it is, from any thread, and may end it.
///
/// # Errors
/// [`Error::Motor`] for bounds that cannot be, or where the watch ended it; [`Error::NoMotorForm`] where no
/// point is admissible.
pub fn search(wanted: &Wanted, watch: &Watch) -> Result<Searched, Error> {
    let mut found = wanted.search.front_watched(watch)?;
    if found.designs.is_empty() {
        return Err(Error::NoMotorForm(Box::new(Funnel::of(&found))));
    }
    let order = wanted.order;
    found.designs.sort_by(|one, other| order.cost(one).total_cmp(&order.cost(other)));
    Ok(Searched { wanted: wanted.clone(), found })
}

/// The answer of a search.
///
/// # Errors
/// As [`search()`].
pub fn answer(wanted: &Wanted) -> Result<MotorForms, Error> {
    Ok(search(wanted, &|_: Progress| std::ops::ControlFlow::Continue(()))?.answer())
}

impl Searched {
    /// The answer.
    #[must_use]
    pub fn answer(&self) -> MotorForms {
        let Self { wanted, found } = self;
        let listed =
            Listed::of(&found.designs, wanted.first_of_each_set, wanted.most, |design| design.numbers);
        let designs: Vec<Design> =
            listed.shown.iter().filter_map(|&(place, design)| self.design(place, design)).collect();
        let borne: Vec<Borne> = designs.iter().filter_map(|design| design.flanks.as_ref()?.borne()).collect();
        MotorForms {
            warnings: practice::of_designs(maybe_si(wanted.search.requirements.pressure_drop), &borne),
            displacement_m3: si(wanted.search.requirements.displacement),
            objectives: wanted.search.objectives.iter().map(|&objective| Objective::of(objective)).collect(),
            order: wanted.order,
            resolution: wanted.search.resolution.map(plain),
            found: found.designs.len(),
            first_of_each_set: wanted.first_of_each_set,
            hidden: listed.hidden,
            designs,
            funnel: Funnel::of(found),
        }
    }

    /// The motor of a design, in the size shown of it; the first is 1.
    ///
    /// # Errors
    /// [`Error::NoSuchDesign`].
    pub fn motor(&self, design: usize, angle: Angle) -> Result<Designed, Error> {
        let (design, size) = nth(&self.found.designs, design, shown_size)?;
        let motor = design.motor(size.module)?;
        Drawn { motor, form: design.form, width: size.width, angle, made: &self.wanted.made }
            .designed(&self.wanted.search.requirements)
    }

    /// The file of a design, in the size shown of it; the first is 1.
    ///
    /// # Errors
    /// [`Error::NoSuchDesign`].
    pub fn saved(&self, design: usize) -> Result<String, Error> {
        let designed = self.motor(design, Angle::default())?;
        let found = Origin { design, of: self.found.designs.len(), by: "motor forms" };
        found.saved(&designed, self.wanted.made.material.as_ref())
    }

    /// `None` of a design without a size, of which a search finds none.
    fn design(&self, place: usize, design: &FormDesign) -> Option<Design> {
        let numbers = design.numbers;
        let size = shown_size(design)?;
        let l_over_module = design.trough_distance_over_module().map(plain);
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
            flanks: design.flanks.as_ref().map(|flanks| Flanks::of(flanks, self.wanted.has_limits)),
            modules_m: design.sizes.iter().map(|size| si(size.module)).collect(),
            size: Size::of(size, l_over_module),
        })
    }
}

/// The size that is shown of a design.
fn shown_size(design: &FormDesign) -> Option<&FormSize> {
    nearest_half(&design.sizes, |size| [size.width, size.outer_diameter])
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
    fn of(size: &FormSize, l_over_module: Option<f64>) -> Self {
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
