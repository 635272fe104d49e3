//! The command `motor search`: the Pareto front of hydromotors for a displacement or torque.

use crate::desk::Call;
use crate::failure::Failure;
use crate::motor::designs::request::{Shown, Sought};
use crate::motor::options::Teeth;
use crate::motor::options::design::{form, refuse};
use crate::motor::options::steps::each_once;
use crate::motor::search::answer::{Objective, Wanted};
use crate::progress::Progress;
use crate::shared::lists::List;
use epicyclic_hydromotor::checks::ToothHeights;
use epicyclic_hydromotor::search::{FlankTerms, MotorSearch};
use epicyclic_units::{Physical, Quantity};
use uom::si::f64::Ratio;

/// Places of families that are tried in a second, about.
const PLACES_IN_A_SECOND: f64 = 6e3;

/// Non-dominated motors for a displacement or torque.
///
/// Every set of lobes and teeth is tried at places along its whole family; of those that pass the checks and
/// limits, the motors remain that no other surpasses in all objectives together. The module is chosen from a
/// list and the width follows, or the other way round. Between the places tried a motor may be better: by how
/// much is estimated and said. The teeth are of one form, as `motor` has it; every motor listed keeps its
/// limits and can have ideal ports. Module: 0.001 to 1000 mm; width: 0.001 to 10 000 mm; l: at most 100 times
/// the stator's nominal radius m·Z₃/2. Ranges include both ends and may be open: 3..6, ..90.
#[derive(Debug, clap::Args)]
#[command(override_usage = "\
epicyclic motor search [OPTIONS] --displacement <DISPLACEMENT>
       epicyclic motor search [OPTIONS] --torque <TORQUE> --pressure <PRESSURE>")]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(flatten)]
    sought: Sought,

    /// Do not judge teeth and ports: list motors too whose teeth break their limits, or that can have no
    /// ideal ports (default: such motors are left out).
    #[arg(long)]
    any_teeth: bool,

    /// What the designs are held against each other by: see below.
    #[arg(long, value_name = "OBJECTIVES", default_value = "volume, ripple, radius")]
    objectives: List<Objective>,

    /// What the designs are ordered by, an objective; the first is the one that is drawn.
    #[arg(long, value_name = "OBJECTIVE", default_value = "volume")]
    by: Objective,

    /// Places along each interval of a family, before refinement.
    #[arg(long, value_name = "NUMBER", default_value_t = 16)]
    places: u32,

    /// Difference in the objectives below which motors of one set count as one.
    #[arg(long, default_value = "2%", allow_hyphen_values = true)]
    resolution: Quantity<Ratio>,

    #[command(flatten)]
    shown: Shown,

    #[command(flatten)]
    teeth: Teeth,

    #[command(flatten)]
    flanks: Flanks,
}

/// What is asked of the flanks.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Satellites that seal at the flanks")]
struct Flanks {
    /// Greatest ripple of flow and torque, satellites sealing at the flanks: 8%, or 0.08.
    #[arg(long, value_name = "RIPPLE", allow_hyphen_values = true)]
    flank_ripple: Option<Quantity<Ratio>>,

    /// Least torque over the mean, satellites sealing at the flanks: 94%, or 0.94.
    #[arg(long, value_name = "PART", allow_hyphen_values = true)]
    least_torque: Option<Quantity<Ratio>>,
}

/// Runs the command.
pub(crate) fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let outlet = args.shown.outlet()?;
    let wanted = Wanted {
        search: search(args)?,
        order: args.by,
        first_of_each_set: outlet.first_of_each_set(),
        most: outlet.most(),
    };
    let shown = Progress::new(call);
    let searched = crate::motor::search::answer::search(&wanted, &|at| {
        let share = at.done as f64 / at.of.max(1) as f64;
        if at.pass == 0 {
            let places = at.of as f64 * f64::from(wanted.search.points);
            shown.size(places, PLACES_IN_A_SECOND, || {
                format!("{} sets of lobes and teeth, {places:.1e} places at least", at.of)
            });
            shown.at(share)
        } else {
            shown.at_pass(at.pass, share)
        }
    });
    drop(shown);
    let searched = searched.map_err(refuse)?;
    let files =
        outlet.files(|design, angle| searched.motor(design, angle), |design| searched.saved(design))?;
    let answer = searched.answer();
    outlet.output.deliver_with(call, files, &answer)?;
    if !outlet.is_table() && answer.hidden > 0 {
        call.complain(&format!("note: {}", crate::motor::search::table::count(&answer)));
    }
    Ok(())
}

fn search(args: &Args) -> Result<MotorSearch, Failure> {
    let form = form(&args.teeth);
    let share = |share: Option<Quantity<Ratio>>| share.map(|share| share.0.si());
    let objectives = each_once("--objectives", &args.objectives.0)?;
    let addendum = form.addendum + form.shift;
    Ok(MotorSearch {
        bounds: args.sought.bounds()?,
        heights: ToothHeights { addendum, dedendum: addendum + form.clearance },
        limits: args.sought.limits()?,
        flanks: FlankTerms {
            form,
            ripple: share(args.flanks.flank_ripple),
            least_torque: share(args.flanks.least_torque),
        },
        made: !args.any_teeth,
        objectives: objectives.into_iter().map(Objective::of_search).collect(),
        points: args.places,
        resolution: Some(args.resolution.0.si()),
        ..MotorSearch::new(args.sought.requirements()?)
    })
}
