//! The command `motor search`: the Pareto front of hydromotors for a displacement or torque.

use super::design::refuse;
use super::sought::{Shown, Sought};
use crate::desk::Call;
use crate::failure::Failure;
use crate::progress::Progress;
use epicyclic_answers as answers;
use epicyclic_answers::motor_search::Wanted;
use epicyclic_formats::{Physical, Quantity};
use epicyclic_hydromotor::checks::ToothHeights;
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_hydromotor::search::MotorSearch;
use uom::si::f64::Ratio;

/// Places of families that are tried in a second, about.
const PLACES_IN_A_SECOND: f64 = 2e4;

/// Non-dominated motors for a displacement or torque.
///
/// Every set of lobes and teeth is tried at places along its whole family; of those that pass the checks and limits, the motors
/// remain that no other surpasses in displacement over volume, ripple and least curvature radius together. The module is
/// chosen from a list and the width follows, or the other way round. Between the places tried a motor may be better: by how much is
/// estimated and said. Checks take the default teeth of `motor`. Ranges include both ends and may be open: 3..6, ..90.
#[derive(Debug, clap::Args)]
#[command(override_usage = "\
epicyclic motor search [OPTIONS] --displacement <DISPLACEMENT>
       epicyclic motor search [OPTIONS] --torque <TORQUE> --pressure <PRESSURE>")]
#[command(after_help = "\
Example:
  epicyclic motor search --torque '600 N·m' --pressure '20 MPa' \\
      --module '2 mm' --stator 5..6 --z3 ..66 --ripple '10 %'")]
pub(crate) struct Args {
    #[command(flatten)]
    sought: Sought,

    /// Only designs on which the default teeth of `motor` keep their limits. They are taken from the front: motors that it
    /// surpasses are not brought back for their teeth.
    #[arg(long)]
    with_teeth: bool,

    /// What the designs are ordered by; the first is the one that is drawn.
    #[arg(long, value_enum, default_value_t = Order::Volume)]
    by: Order,

    /// Places along each interval of a family, before refinement.
    #[arg(long, value_name = "NUMBER", default_value_t = 16)]
    places: u32,

    /// Difference in the objectives below which motors of one set count as one.
    #[arg(long, default_value = "2%", allow_hyphen_values = true)]
    resolution: Quantity<Ratio>,

    #[command(flatten)]
    shown: Shown,
}

/// What the designs are ordered by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Order {
    /// The most displacement over volume first.
    Volume,
    /// The least ripple first.
    Ripple,
    /// The greatest least curvature radius first.
    Radius,
}

/// Runs the command.
pub(super) fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let outlet = args.shown.outlet()?;
    let wanted = Wanted {
        search: search(args)?,
        with_teeth: args.with_teeth,
        order: match args.by {
            Order::Volume => answers::motor_search::Order::Volume,
            Order::Ripple => answers::motor_search::Order::Ripple,
            Order::Radius => answers::motor_search::Order::Radius,
        },
        first_of_each_set: outlet.first_of_each_set(),
        most: outlet.most(),
    };
    let shown = Progress::new(call);
    let searched = answers::motor_search::search(&wanted, &|at| {
        let share = at.done as f64 / at.of.max(1) as f64;
        if at.pass == 0 {
            let places = at.of as f64 * f64::from(wanted.search.points);
            shown.size(places, PLACES_IN_A_SECOND, || {
                format!("{} sets of lobes and teeth, {places:.1e} places at least", at.of)
            });
            shown.at(share);
        } else {
            shown.at_pass(at.pass, share);
        }
    });
    drop(shown);
    let searched = searched.map_err(refuse)?;
    let files = outlet.files(|design, angle| searched.motor(design, angle))?;
    let answer = searched.answer();
    outlet.output.deliver_with(call, files, &answer)?;
    if !outlet.is_table() && answer.hidden > 0 {
        call.complain(&format!("note: {}", epicyclic_views::motor_search::count(&answer)));
    }
    Ok(())
}

fn search(args: &Args) -> Result<MotorSearch, Failure> {
    // The teeth that `motor` makes by default.
    let form = ToothForm::default();
    let addendum = form.addendum + form.shift;
    Ok(MotorSearch {
        bounds: args.sought.bounds()?,
        heights: ToothHeights { addendum, dedendum: addendum + form.clearance },
        limits: args.sought.limits()?,
        points: args.places,
        resolution: Some(args.resolution.0.si()),
        ..MotorSearch::new(args.sought.requirements()?)
    })
}
