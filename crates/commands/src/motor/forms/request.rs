//! The command `motor forms`: the Pareto front of hydromotors with the tooth form free.

use crate::desk::Call;
use crate::failure::Failure;
use crate::motor::designs::answer::{Listing, Searched as _};
use crate::motor::designs::request::{Goal, Shown};
use crate::motor::forms::answer::{
    self as answers, Crest, Family, MotorForms, Objective, SearchedForms, material,
};
use crate::motor::options::FlankLimits;
use crate::motor::options::design::refuse as refuse_motor;
use crate::motor::options::steps::{Stepped, each_once};
use crate::progress::Progress;
use crate::shared::lists::List;
use epicyclic_formats::motor::MaterialGroup;
use epicyclic_hydromotor as hydromotor;
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::quantity::Quantity as Of;
use epicyclic_hydromotor::search::Watch;
use epicyclic_hydromotor::search::forms::{FlankOrder, FormSearch, FormSpace};
use epicyclic_units::{Number, Physical, Quantity};
use uom::si::f64::{Angle, Pressure, Ratio};

/// Points that are judged in a second, about.
const POINTS_IN_A_SECOND: f64 = 1e6;

/// The share of the time in which the motors are found, about; in the rest forms are tried on them.
const SHARE_OF_MOTORS: f64 = 0.1;

/// Non-dominated motors with their tooth forms for a displacement or torque.
///
/// Every set of lobes and teeth is tried at places of its families with every tooth form within the steps; of
/// the points that keep all checks, limits of the teeth and bounds, those remain that no other surpasses in
/// all objectives together. What cannot be better than a design by more than the resolution is left out, and
/// counted. Steps have both ends and how many values: 20deg..30deg/5. Other ranges include both ends and may
/// be open: 3..6, ..90.
#[derive(Debug, clap::Args)]
#[command(override_usage = "\
epicyclic motor forms [OPTIONS] --displacement <DISPLACEMENT>
       epicyclic motor forms [OPTIONS] --torque <TORQUE> --pressure <PRESSURE>")]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    shown: Shown,
}

/// Requirements of motors with the tooth form free, and objectives of their search.
#[derive(Debug, Clone, clap::Args)]
pub struct Request {
    /// Requirements of a motor, and bounds of its numbers.
    #[command(flatten)]
    pub goal: Goal,

    /// Families of motors: arcs, cosine, second-harmonic.
    #[arg(long, value_name = "FAMILIES", default_value = "arcs, cosine, second-harmonic")]
    pub families: List<Family>,

    /// Places along each interval of a family.
    #[arg(long, value_name = "NUMBER", default_value_t = 16)]
    pub places: u32,

    /// Steps of the tooth form.
    #[command(flatten)]
    pub teeth: Teeth,

    /// Material and flanks under load.
    #[command(flatten)]
    pub flanks: Flanks,

    /// What the designs are held against each other by: see below.
    #[arg(long, value_name = "OBJECTIVES", default_value = "volume, ripple, contact-ratio")]
    pub objectives: List<Objective>,

    /// Difference in the objectives up to which a design is as good as another.
    #[arg(long, default_value = "2%", allow_hyphen_values = true)]
    pub resolution: Quantity<Ratio>,

    /// The exact front, without a resolution.
    #[arg(long, conflicts_with = "resolution")]
    pub exact: bool,

    /// What the designs are ordered by, an objective; the first is the one that is drawn.
    #[arg(long, value_name = "OBJECTIVE", default_value = "volume")]
    pub by: Objective,
}

/// Steps of the tooth form; lengths in modules.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Teeth, lengths in modules, each one value or steps")]
pub struct Teeth {
    /// Pressure angle of the satellites.
    #[arg(
        long,
        value_name = "FROM..TO/VALUES",
        default_value = "20deg..30deg/5",
        allow_hyphen_values = true
    )]
    pub pressure_angle: Stepped<Quantity<Angle>>,

    /// Addendum h_a*.
    #[arg(long, value_name = "FROM..TO/VALUES", default_value = "0.7..1/7", allow_hyphen_values = true)]
    pub addendum: Stepped<Number>,

    /// Profile shift x of the satellites; the wheels have −x.
    #[arg(long, value_name = "FROM..TO/VALUES", default_value = "0..0.4/5", allow_hyphen_values = true)]
    pub shift: Stepped<Number>,

    /// Clearance c* of tips over roots.
    #[arg(long, value_name = "FROM..TO/VALUES", default_value = "0.25", allow_hyphen_values = true)]
    pub clearance: Stepped<Number>,

    /// Radius ρ* of the rounded tips of the cutters.
    #[arg(long, value_name = "FROM..TO/VALUES", default_value = "0.1", allow_hyphen_values = true)]
    pub fillet: Stepped<Number>,

    /// Backlash j* along the pitch curves, one value.
    #[arg(long, value_name = "NUMBER", default_value = "0.04", allow_hyphen_values = true)]
    pub backlash: Number,

    /// What lies in the middle of the stator's crests: space (as of `motor`), tooth.
    #[arg(long, value_name = "CRESTS", default_value = "space, tooth")]
    pub crests: List<Crest>,

    /// Least contact ratio: the shortest path of contact of any flank over the base pitch.
    #[arg(long, value_name = "NUMBER", default_value = "1", allow_hyphen_values = true)]
    pub contact_ratio: Number,
}

/// Flanks under load: the material, and requirements.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Flanks under load, of rigid teeth with all load on one pair")]
pub struct Flanks {
    /// Contact stress that the material bears; with --root-limit the allowed pressure follows.
    #[arg(long, value_name = "STRESS", requires = "root_limit", allow_hyphen_values = true)]
    pub contact_limit: Option<Quantity<Pressure>>,

    /// Stress that the roots of the teeth bear.
    #[arg(long, value_name = "STRESS", requires = "contact_limit", allow_hyphen_values = true)]
    pub root_limit: Option<Quantity<Pressure>>,

    /// Young's modulus of the material.
    #[arg(long, value_name = "MODULUS", default_value = "206 GPa", allow_hyphen_values = true)]
    pub youngs_modulus: Quantity<Pressure>,

    /// Poisson's ratio of the material.
    #[arg(long, value_name = "NUMBER", default_value = "0.3", allow_hyphen_values = true)]
    pub poissons_ratio: Number,

    /// Requirements of satellites that seal at the flanks.
    #[command(flatten)]
    pub limits: FlankLimits,

    /// Greatest contact stress at --pressure.
    #[arg(long, value_name = "STRESS", requires = "pressure", allow_hyphen_values = true)]
    pub contact_stress: Option<Quantity<Pressure>>,

    /// Greatest bending stress at a root at --pressure.
    #[arg(long, value_name = "STRESS", requires = "pressure", allow_hyphen_values = true)]
    pub root_stress: Option<Quantity<Pressure>>,

    /// Least pressure drop that the material must allow.
    #[arg(long, value_name = "PRESSURE", requires_all = ["contact_limit", "root_limit"], allow_hyphen_values = true)]
    pub allowed_pressure: Option<Quantity<Pressure>>,
}

/// Runs the command.
pub(crate) fn run(call: &Call<'_>, Args { request, shown }: &Args) -> Result<(), Failure> {
    let outlet = shown.outlet()?;
    let forms = request.tooth_forms()?;
    let progress = Progress::new(call);
    let searched = request.search(&|at| {
        let share = at.done as f64 / at.of.max(1) as f64;
        // Pass 0 finds the motors. Their number, and so the number of points with tooth forms, is known only
        // then.
        if at.pass == 0 {
            progress.at(SHARE_OF_MOTORS * share)
        } else {
            let points = at.of as f64 * forms as f64;
            progress.size(points, POINTS_IN_A_SECOND, || {
                format!("{} motors, {forms} tooth forms, {points:.1e} points", at.of)
            });
            progress.at(SHARE_OF_MOTORS + (1.0 - SHARE_OF_MOTORS) * share)
        }
    });
    drop(progress);
    outlet.deliver(call, &searched?)
}

impl Request {
    /// Searches for designs; `watch` receives the progress from any thread, and may end the search.
    ///
    /// # Errors
    /// [`Failure::Range`], [`Failure::Option`] for impossible options; a search that finds no motor, or that
    /// `watch` ended.
    pub fn search(&self, watch: &Watch) -> Result<SearchedForms, Failure> {
        answers::search(self.settled()?, self.by, self.flanks.material(), watch).map_err(refuse)
    }

    /// Searches for designs, and lists all of them; `watch` as in [`Self::search`].
    ///
    /// # Errors
    /// Those of [`Self::search`].
    pub fn answer(&self, watch: &Watch) -> Result<MotorForms, Failure> {
        Ok(self.search(watch)?.answer(Listing::default()))
    }

    /// Number of tooth forms to try.
    ///
    /// # Errors
    /// [`Failure::Range`], [`Failure::Option`] for impossible options.
    pub fn tooth_forms(&self) -> Result<usize, Failure> {
        Ok(self.settled()?.forms.forms().map_err(|error| refuse(error.into()))?.len())
    }

    /// Search with its objectives checked, because it may take long.
    fn settled(&self) -> Result<FormSearch, Failure> {
        let Teeth { pressure_angle, addendum, shift, clearance, fillet, backlash, crests, contact_ratio } =
            &self.teeth;
        let families = each_once("--families", &self.families.0)?;
        let crests = each_once("--crests", &crests.0)?;
        let objectives = each_once("--objectives", &self.objectives.0)?;
        let search = FormSearch {
            bounds: self.goal.bounds()?,
            limits: self.goal.limits()?,
            families: families.into_iter().map(Family::of_search).collect(),
            places: self.places,
            forms: FormSpace {
                pressure_angle: pressure_angle.steps(),
                addendum: addendum.steps(),
                shift: shift.steps(),
                clearance: clearance.steps(),
                fillet: fillet.steps(),
                crests: crests.into_iter().map(Crest::of_search).collect(),
                base: ToothForm { backlash: backlash.get(), ..ToothForm::default() },
            },
            least_contact_ratio: contact_ratio.get(),
            flanks: Some(self.flanks.order().map_err(refuse)?),
            objectives: objectives.into_iter().map(Objective::of_search).collect(),
            resolution: (!self.exact).then(|| self.resolution.0.si()),
            ..FormSearch::new(self.goal.requirements()?)
        };
        self.check_needs("--objectives", &self.objectives.0)?;
        self.check_needs("--by", &[self.by])?;
        Ok(search)
    }

    /// Refuses objectives that need an option that is not given.
    fn check_needs(&self, option: &'static str, objectives: &[Objective]) -> Result<(), Failure> {
        for objective in objectives {
            let lacks = match objective {
                Objective::ContactStress | Objective::RootStress if self.goal.pressure().is_none() => {
                    "--pressure"
                }
                Objective::AllowedPressure if self.flanks.stress_limits().is_none() => {
                    "--contact-limit and --root-limit"
                }
                _ => continue,
            };
            return Err(Failure::missing(option, format!("{objective} needs {lacks}")));
        }
        Ok(())
    }
}

impl Flanks {
    /// Of contact and root stress.
    fn stress_limits(&self) -> Option<[Pressure; 2]> {
        self.contact_limit.zip(self.root_limit).map(|(contact, root)| [contact.0, root.0])
    }

    /// The material, as a motor's file says it.
    fn material(&self) -> MaterialGroup {
        MaterialGroup {
            youngs_modulus: Some(self.youngs_modulus),
            poissons_ratio: Some(self.poissons_ratio),
            contact_limit: self.contact_limit,
            root_limit: self.root_limit,
        }
    }

    fn order(&self) -> Result<FlankOrder, crate::error::Error> {
        let materials = material(self.youngs_modulus.0, self.poissons_ratio.get(), self.stress_limits())?;
        let [ripple, least_torque] = self.limits.shares();
        let pressure = |pressure: Option<Quantity<Pressure>>| pressure.map(|pressure| pressure.0);
        Ok(FlankOrder {
            ripple,
            least_torque,
            contact_stress: pressure(self.contact_stress),
            root_stress: pressure(self.root_stress),
            allowed_pressure: pressure(self.allowed_pressure),
            ..FlankOrder::of(materials)
        })
    }
}

/// Converts an error to a failure with the option that caused it.
fn refuse(error: crate::error::Error) -> Failure {
    let option = match &error {
        crate::error::Error::Motor(error) => of_forms(error),
        _ => None,
    };
    match option {
        Some(option) => Failure::of_option(option, &error),
        None => refuse_motor(error),
    }
}

/// The option of what the other commands for motors have not, or in another place.
fn of_forms(error: &hydromotor::Error) -> Option<&'static str> {
    use hydromotor::Error as E;
    Some(match error {
        E::TooManyForms { .. } => "--pressure-angle, --addendum, --shift, --clearance, --fillet",
        E::EmptySteps { quantity, .. }
        | E::OutOfRange { quantity, .. }
        | E::NotPositive { quantity, .. }
        | E::NotFinite { quantity, .. } => match quantity {
            Of::PressureAngle => "--pressure-angle",
            Of::Addendum => "--addendum",
            Of::ProfileShift => "--shift",
            Of::Clearance => "--clearance",
            Of::Fillet => "--fillet",
            Of::ContactRatio => "--contact-ratio",
            Of::LeastTorque => "--least-torque",
            Of::ContactStress => "--contact-stress",
            Of::RootStress => "--root-stress",
            Of::AllowedPressure => "--allowed-pressure",
            Of::ContactLimit => "--contact-limit",
            Of::RootLimit => "--root-limit",
            Of::ElasticModulus | Of::ContactModulus => "--youngs-modulus",
            Of::PoissonRatio => "--poissons-ratio",
            _ => return None,
        },
        _ => return None,
    })
}
