//! The command `motor search`: the Pareto front of hydromotors for a displacement or torque.

use crate::desk::Call;
use crate::failure::Failure;
use crate::motor::designs::answer::{Listing, Searched as _};
use crate::motor::designs::request::{Goal, Shown};
use crate::motor::options::design::{form, refuse};
use crate::motor::options::steps::each_once;
use crate::motor::options::{FlankLimits, Teeth};
use crate::motor::search::answer::{self as answers, MotorSearch, Objective, SearchedMotors};
use crate::progress::Progress;
use crate::shared::lists::List;
use epicyclic_hydromotor::checks::ToothHeights;
use epicyclic_hydromotor::search::{FlankTerms, MotorSearch as Search, Watch};
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
    // The options of `shown` are before the request's so that their heading is; see `Shown` for their order.
    #[command(flatten)]
    shown: Shown,

    #[command(flatten)]
    request: Request,
}

/// Requirements of motors with teeth of one form, and objectives of their search.
#[derive(Debug, Clone, clap::Args)]
// Not under the last heading of `Shown`, and before its options.
#[command(next_display_order = 0, next_help_heading = clap::builder::Resettable::Reset)]
pub struct Request {
    /// Requirements of a motor, and bounds of its numbers.
    #[command(flatten)]
    pub goal: Goal,

    /// Do not judge teeth and ports: list motors too whose teeth break their limits, or that can have no
    /// ideal ports (default: such motors are left out).
    #[arg(long)]
    pub any_teeth: bool,

    /// What the designs are held against each other by: see below.
    #[arg(long, value_name = "OBJECTIVES", default_value = "volume, ripple, radius")]
    pub objectives: List<Objective>,

    /// What the designs are ordered by, an objective; the first is the one that is drawn.
    #[arg(long, value_name = "OBJECTIVE", default_value = "volume")]
    pub by: Objective,

    /// Places along each interval of a family, before refinement.
    #[arg(long, value_name = "NUMBER", default_value_t = 16)]
    pub places: u32,

    /// Difference in the objectives below which motors of one set count as one.
    #[arg(long, default_value = "2%", allow_hyphen_values = true)]
    pub resolution: Quantity<Ratio>,

    /// Form of the teeth.
    #[command(flatten)]
    pub teeth: Teeth,

    /// Requirements of satellites that seal at the flanks.
    #[command(flatten, next_help_heading = "Satellites that seal at the flanks")]
    pub flanks: FlankLimits,
}

impl Request {
    /// Searches for designs; `watch` receives the progress from any thread, and may end the search.
    ///
    /// # Errors
    /// [`Failure::Range`], [`Failure::Option`] for impossible options; a search that finds no motor, or that
    /// `watch` ended.
    pub fn search(&self, watch: &Watch) -> Result<SearchedMotors, Failure> {
        answers::search(self.settled()?, self.by, watch).map_err(refuse)
    }

    /// Searches for designs, and lists all of them; `watch` as in [`Self::search`].
    ///
    /// # Errors
    /// Those of [`Self::search`].
    pub fn answer(&self, watch: &Watch) -> Result<MotorSearch, Failure> {
        Ok(self.search(watch)?.answer(Listing::default()))
    }

    fn settled(&self) -> Result<Search, Failure> {
        let form = form(&self.teeth);
        let [ripple, least_torque] = self.flanks.shares();
        let objectives = each_once("--objectives", &self.objectives.0)?;
        let addendum = form.addendum + form.shift;
        Ok(Search {
            bounds: self.goal.bounds()?,
            heights: ToothHeights { addendum, dedendum: addendum + form.clearance },
            limits: self.goal.limits()?,
            flanks: FlankTerms { form, ripple, least_torque },
            made: !self.any_teeth,
            objectives: objectives.into_iter().map(Objective::of_search).collect(),
            points: self.places,
            resolution: Some(self.resolution.0.si()),
            ..Search::new(self.goal.requirements()?)
        })
    }
}

/// Runs the command.
pub(crate) fn run(call: &Call<'_>, Args { shown, request }: &Args) -> Result<(), Failure> {
    let outlet = shown.outlet()?;
    let progress = Progress::new(call);
    let searched = request.search(&|at| {
        let share = at.done as f64 / at.of.max(1) as f64;
        if at.pass == 0 {
            let places = at.of as f64 * f64::from(request.places);
            progress.size(places, PLACES_IN_A_SECOND, || {
                format!("{} sets of lobes and teeth, {places:.1e} places at least", at.of)
            });
            progress.at(share)
        } else {
            progress.at_pass(at.pass, share)
        }
    });
    drop(progress);
    outlet.deliver(call, &searched?)
}
