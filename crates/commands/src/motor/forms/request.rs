//! The command `motor forms`: the Pareto front of hydromotors with the tooth form free.

use crate::desk::Call;
use crate::failure::Failure;
use crate::motor::answer::Groups;
use crate::motor::designs::request::{Shown, Sought};
use crate::motor::forms::answer::{Crest, Family, Objective, Wanted, material};
use crate::motor::options::design::refuse as refuse_motor;
use crate::motor::options::steps::{Stepped, each_once};
use crate::progress::Progress;
use crate::shared::lists::List;
use epicyclic_formats::motor::MaterialGroup;
use epicyclic_hydromotor as hydromotor;
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::quantity::Quantity as Of;
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
    sought: Sought,

    /// Families of motors: arcs, cosine, second-harmonic.
    #[arg(long, value_name = "FAMILIES", default_value = "arcs, cosine, second-harmonic")]
    families: List<Family>,

    /// Places along each interval of a family.
    #[arg(long, value_name = "NUMBER", default_value_t = 16)]
    places: u32,

    #[command(flatten)]
    teeth: Teeth,

    #[command(flatten)]
    flanks: Flanks,

    /// What the designs are held against each other by: see below.
    #[arg(long, value_name = "OBJECTIVES", default_value = "volume, ripple, contact-ratio")]
    objectives: List<Objective>,

    /// Difference in the objectives up to which a design is as good as another.
    #[arg(long, default_value = "2%", allow_hyphen_values = true)]
    resolution: Quantity<Ratio>,

    /// The exact front, without a resolution.
    #[arg(long, conflicts_with = "resolution")]
    exact: bool,

    /// What the designs are ordered by, an objective; the first is the one that is drawn.
    #[arg(long, value_name = "OBJECTIVE", default_value = "volume")]
    by: Objective,

    #[command(flatten)]
    shown: Shown,
}

/// Steps of the tooth form; lengths in modules.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Teeth, lengths in modules, each one value or steps")]
struct Teeth {
    /// Pressure angle of the satellites.
    #[arg(
        long,
        value_name = "FROM..TO/VALUES",
        default_value = "20deg..30deg/5",
        allow_hyphen_values = true
    )]
    pressure_angle: Stepped<Quantity<Angle>>,

    /// Addendum h_a*.
    #[arg(long, value_name = "FROM..TO/VALUES", default_value = "0.7..1/7", allow_hyphen_values = true)]
    addendum: Stepped<Number>,

    /// Profile shift x of the satellites; the wheels have −x.
    #[arg(long, value_name = "FROM..TO/VALUES", default_value = "0..0.4/5", allow_hyphen_values = true)]
    shift: Stepped<Number>,

    /// Clearance c* of tips over roots.
    #[arg(long, value_name = "FROM..TO/VALUES", default_value = "0.25", allow_hyphen_values = true)]
    clearance: Stepped<Number>,

    /// Radius ρ* of the rounded tips of the cutters.
    #[arg(long, value_name = "FROM..TO/VALUES", default_value = "0.1", allow_hyphen_values = true)]
    fillet: Stepped<Number>,

    /// Backlash j* along the pitch curves, one value.
    #[arg(long, value_name = "NUMBER", default_value = "0.04", allow_negative_numbers = true)]
    backlash: Number,

    /// What lies in the middle of the stator's crests: space (as of `motor`), tooth.
    #[arg(long, value_name = "CRESTS", default_value = "space, tooth")]
    crests: List<Crest>,

    /// Least contact ratio: the shortest path of contact of any flank over the base pitch.
    #[arg(long, value_name = "NUMBER", default_value = "1", allow_negative_numbers = true)]
    contact_ratio: Number,
}

/// Flanks under load: the material, and what is asked.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Flanks under load, of rigid teeth with all load on one pair")]
struct Flanks {
    /// Contact stress that the material bears; with --root-limit the allowed pressure follows.
    #[arg(long, value_name = "STRESS", requires = "root_limit", allow_hyphen_values = true)]
    contact_limit: Option<Quantity<Pressure>>,

    /// Stress that the roots of the teeth bear.
    #[arg(long, value_name = "STRESS", requires = "contact_limit", allow_hyphen_values = true)]
    root_limit: Option<Quantity<Pressure>>,

    /// Young's modulus of the material.
    #[arg(long, value_name = "MODULUS", default_value = "206 GPa", allow_hyphen_values = true)]
    youngs_modulus: Quantity<Pressure>,

    /// Poisson's ratio of the material.
    #[arg(long, value_name = "NUMBER", default_value = "0.3", allow_negative_numbers = true)]
    poissons_ratio: Number,

    /// Greatest ripple of flow and torque, satellites sealing at the flanks: 8%, or 0.08.
    #[arg(long, value_name = "RIPPLE", allow_hyphen_values = true)]
    flank_ripple: Option<Quantity<Ratio>>,

    /// Least torque over the mean, satellites sealing at the flanks: 94%, or 0.94.
    #[arg(long, value_name = "PART", allow_hyphen_values = true)]
    least_torque: Option<Quantity<Ratio>>,

    /// Greatest contact stress at --pressure.
    #[arg(long, value_name = "STRESS", requires = "pressure", allow_hyphen_values = true)]
    contact_stress: Option<Quantity<Pressure>>,

    /// Greatest bending stress at a root at --pressure.
    #[arg(long, value_name = "STRESS", requires = "pressure", allow_hyphen_values = true)]
    root_stress: Option<Quantity<Pressure>>,

    /// Least pressure drop that the material must allow.
    #[arg(long, value_name = "PRESSURE", requires_all = ["contact_limit", "root_limit"], allow_hyphen_values = true)]
    allowed_pressure: Option<Quantity<Pressure>>,
}

/// Runs the command.
pub(crate) fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let outlet = args.shown.outlet()?;
    let search = search(args)?;
    // Checked before the search, which may take long.
    args.has_what_is_told("--objectives", &args.objectives.0)?;
    args.has_what_is_told("--by", &[args.by])?;
    let forms = search.forms.forms().map_err(|error| refuse(error.into()))?.len();
    let wanted = Wanted {
        search,
        has_limits: args.flanks.limits().is_some(),
        order: args.by,
        first_of_each_set: outlet.first_of_each_set(),
        most: outlet.most(),
        made: args.flanks.groups(),
    };
    let shown = Progress::new(call);
    let searched = crate::motor::forms::answer::search(&wanted, &|at| {
        let share = at.done as f64 / at.of.max(1) as f64;
        // Pass 0 finds the motors. Their number, and so the number of points with tooth forms, is known only
        // then.
        if at.pass == 0 {
            shown.at(SHARE_OF_MOTORS * share)
        } else {
            let points = at.of as f64 * forms as f64;
            shown.size(points, POINTS_IN_A_SECOND, || {
                format!("{} motors, {forms} tooth forms, {points:.1e} points", at.of)
            });
            shown.at(SHARE_OF_MOTORS + (1.0 - SHARE_OF_MOTORS) * share)
        }
    });
    drop(shown);
    let searched = searched.map_err(refuse)?;
    let files =
        outlet.files(|design, angle| searched.motor(design, angle), |design| searched.saved(design))?;
    let answer = searched.answer();
    outlet.output.deliver_with(call, files, &answer)?;
    if !outlet.is_table() && answer.hidden > 0 {
        call.complain(&format!("note: {}", crate::motor::forms::table::count(&answer)));
    }
    Ok(())
}

impl Args {
    /// Refuses objectives that need an option that is not given.
    fn has_what_is_told(&self, option: &'static str, objectives: &[Objective]) -> Result<(), Failure> {
        for objective in objectives {
            let lacks = match objective {
                Objective::ContactStress | Objective::RootStress if self.sought.pressure().is_none() => {
                    "--pressure"
                }
                Objective::AllowedPressure if self.flanks.limits().is_none() => {
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
    fn limits(&self) -> Option<[Pressure; 2]> {
        self.contact_limit.zip(self.root_limit).map(|(contact, root)| [contact.0, root.0])
    }

    /// The material, as a motor's file says it.
    fn groups(&self) -> Groups {
        let material = MaterialGroup {
            youngs_modulus: Some(self.youngs_modulus),
            poissons_ratio: Some(self.poissons_ratio),
            contact_limit: self.contact_limit,
            root_limit: self.root_limit,
        };
        Groups { material: Some(material), ..Groups::default() }
    }

    fn order(&self) -> Result<FlankOrder, crate::error::Error> {
        let materials = material(self.youngs_modulus.0, self.poissons_ratio.get(), self.limits())?;
        let share = |share: Option<Quantity<Ratio>>| share.map(|share| share.0.si());
        let pressure = |pressure: Option<Quantity<Pressure>>| pressure.map(|pressure| pressure.0);
        Ok(FlankOrder {
            ripple: share(self.flank_ripple),
            least_torque: share(self.least_torque),
            contact_stress: pressure(self.contact_stress),
            root_stress: pressure(self.root_stress),
            allowed_pressure: pressure(self.allowed_pressure),
            ..FlankOrder::of(materials)
        })
    }
}

fn search(args: &Args) -> Result<FormSearch, Failure> {
    let Teeth { pressure_angle, addendum, shift, clearance, fillet, backlash, crests, contact_ratio } =
        &args.teeth;
    let families = each_once("--families", &args.families.0)?;
    let crests = each_once("--crests", &crests.0)?;
    let objectives = each_once("--objectives", &args.objectives.0)?;
    Ok(FormSearch {
        bounds: args.sought.bounds()?,
        limits: args.sought.limits()?,
        families: families.into_iter().map(Family::of_search).collect(),
        places: args.places,
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
        flanks: Some(args.flanks.order().map_err(refuse)?),
        objectives: objectives.into_iter().map(Objective::of_search).collect(),
        resolution: (!args.exact).then(|| args.resolution.0.si()),
        ..FormSearch::new(args.sought.requirements()?)
    })
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
