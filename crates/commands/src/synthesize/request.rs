//! The command `synthesize`: every gearbox that has a list of ratios.

use crate::desk::{Call, Content, Hearing};
use crate::failure::Failure;
use crate::input;
use crate::output::{Format, NO_HEADING, OutputArgs};
use crate::progress::Progress;
use crate::shared::gearbox::{Choice, Gearbox, one};
use crate::shared::lists::List;
use crate::shared::options;
use crate::shared::page_options::{self as imprint, PageArgs};
use crate::shared::ratios::Ratios;
use crate::synthesize::answer::near_miss::near_miss;
use crate::synthesize::answer::page::drawn;
use crate::synthesize::answer::{
    self as synthesize, Kept, LeftOut, MOST_SOLUTIONS, Means, Searching, Synthesis, Wanted, saved, solve_by,
};
use crate::synthesize::search_size as size;
use crate::synthesize::shards;
use crate::synthesize::teeth_wanted::{ANY_K, TeethOptions};
use crate::synthesize::usable::{GearShare, UsableOptions, shares_of};
use epicyclic_formats::Span;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_synthesis::Kind;
use epicyclic_synthesis::class::{MOST_ELEMENTS, MOST_ENGAGED, MOST_LINKS, MOST_SETS};
use epicyclic_synthesis::limits::Limits;
use epicyclic_synthesis::rank::Objective;
use epicyclic_synthesis::rules::Rules;
use epicyclic_synthesis::run::{self, search};
use epicyclic_synthesis::shifts::Shifts;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::work::Share;
use epicyclic_train as train;
use epicyclic_units::{Number, Physical as _, Quantity};
use std::ops::{ControlFlow, RangeInclusive};
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use uom::si::f64::{Ratio, Time};

/// Solutions in a table unless said otherwise.
const SHOWN_IN_TABLE: usize = 20;

/// Schemes drawn on a page.
const DRAWN: usize = 10;

/// Every gearbox of simple planet sets, brakes and clutches that has a list of ratios.
///
/// All structures of so many sets are searched, over all ring-to-sun ratios k in the range, not a grid of
/// them. Numbers of sets and shift elements that are a range are tried from the smallest up, until one has a
/// gearbox of use: one that can be drawn and keeps --least-efficiency, --least-reverse-efficiency and
/// --most-circulating.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(flatten)]
    request: Request,

    /// Write the best gearbox as a file that analyze, draw and report read, with its tooth numbers where
    /// --teeth found any.
    #[arg(long, value_name = "FILE", help_heading = NO_HEADING)]
    save: Option<PathBuf>,

    /// With --save: the gearbox with this number, of all found, in place of the best.
    #[arg(long, value_name = "N", requires = "save", default_value = "1", help_heading = NO_HEADING)]
    nth: usize,

    /// A gearbox to be placed beside the search: which ratio it misses, its number among those found, or why
    /// it is not found.
    #[arg(long, value_name = "FILE", help_heading = NO_HEADING)]
    explain: Option<PathBuf>,

    /// With --explain: one transmission of a list, its name or a part that no other name has.
    #[arg(long, value_name = "NAME", requires = "explain", help_heading = NO_HEADING)]
    transmission: Option<String>,

    /// Search a share of the structures, the first of eight: 1/8. What it finds is a part, a Parquet table,
    /// in the file of --output. If it is ended, the same command goes on from --output with .progress at its
    /// end.
    #[arg(long, value_name = "I/N", requires = "output", conflicts_with_all = ["merge", "format", "limit"], help_heading = NO_HEADING)]
    shard: Option<Share>,

    /// Begin a search only if it is estimated to take at most this long. Default: 1 h, and at most 4 GB.
    #[arg(long, value_name = "TIME", conflicts_with_all = ["shard", "merge"], help_heading = NO_HEADING)]
    longest: Option<Quantity<Time>>,

    /// Take what was found from these parts of a search, all of its shares, instead of searching.
    #[arg(long, value_name = "PART", num_args = 1.., value_hint = clap::ValueHint::FilePath, help_heading = NO_HEADING)]
    merge: Vec<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    page: PageArgs,
}

/// Request for a search for gearboxes.
#[derive(Debug, Clone, clap::Args)]
pub struct Request {
    /// Wanted ratios, input speed over output speed; negative for reverse. Commas, semicolons or spaces part
    /// them. Of a gear 4.714, 4.714±0.5%, 4.714±0.02, 4.5..4.9, ? (any between its neighbours), or in
    /// brackets where it may be missing: (-3.295).
    #[arg(long, allow_hyphen_values = true)]
    pub ratios: Ratios,

    /// How far a ratio may be off that has no tolerance of its own: 1%, or 0.01.
    #[arg(long, default_value = "1%", allow_hyphen_values = true)]
    pub tolerance: Quantity<Ratio>,

    /// Which structures are searched.
    #[arg(long, value_enum, default_value_t = Kind::Core)]
    pub class: Kind,

    // The limits are those of the library; their help is made of them.
    /// Number of planet sets.
    #[arg(long, default_value = "1..3", help = format!("Number of planet sets, at most {MOST_SETS}"))]
    pub sets: Span<u32>,

    /// Number of shift elements.
    #[arg(long, default_value = "1..6", help = format!("Number of shift elements, at most {MOST_ELEMENTS}"))]
    pub elements: Span<u32>,

    /// Shift elements that a gear engages.
    #[arg(
        long,
        help = format!(
            "Shift elements that a gear engages, at most {MOST_ENGAGED}. Default: 1..3; with --links or --open 1..{MOST_ENGAGED}"
        )
    )]
    pub engaged: Option<Span<u32>>,

    /// Number of moving links: sets, engaged elements and one more.
    #[arg(long, help = format!("Number of moving links: sets, engaged elements and one more; at most {MOST_LINKS}"))]
    pub links: Option<Span<u32>>,

    /// Shift elements that are open in a gear: those not engaged.
    #[arg(long)]
    pub open: Option<Span<u32>>,

    /// Ring-to-sun ratio k of every simple set.
    #[arg(long, default_value = "1.4..4.5")]
    pub k: Span<f64>,

    /// What else is wanted.
    #[command(flatten)]
    pub wishes: Wishes,

    /// How many of the sets are double-planet sets, with two planets in mesh between sun and ring; each
    /// number is searched.
    #[arg(long, default_value = "0")]
    pub double_planets: Span<u32>,

    /// Ring-to-sun ratio k of every double-planet set.
    #[arg(long, default_value = "1.6..4.5")]
    pub k_double: Span<f64>,

    /// At least so many sets of one kind have equal k.
    #[arg(long, value_name = "N", default_value = "1")]
    pub equal_k: u32,

    /// Efficiency of the two meshes of a simple set: 0.97, or 97%; each of the three of a double-planet set
    /// loses as much.
    #[arg(long, default_value = "0.97", allow_hyphen_values = true)]
    pub efficiency: Quantity<Ratio>,

    /// Shares of time of forward gears, by their numbers in --ratios: '1:5%, 2:10%, 3:85%'; other gears have
    /// none. Gearboxes are ordered by the mean efficiency of the forward gears by these shares, in place of
    /// the least.
    #[arg(long, value_name = "GEAR:SHARE,…")]
    pub shares: Option<List<GearShare>>,

    /// What a gearbox of use keeps.
    #[command(flatten)]
    pub usable: UsableOptions,

    /// Show at most this many gearboxes, of each family the best. Default: 20 in a table, otherwise all, up
    /// to 10000.
    #[arg(long, value_name = "N")]
    pub limit: Option<usize>,

    /// Show every gearbox, not the best of each family alone. Gearboxes of a family have equal formulas for
    /// all gears, up to an exchange of sets of one kind.
    #[arg(long)]
    pub all_gearboxes: bool,

    /// The objectives that decide first which gearbox is the best; the others follow.
    #[arg(
        long,
        value_name = "OBJECTIVES",
        default_value = "drawable, shifts, efficiency, drag, torque, speed"
    )]
    pub order: List<Objective>,

    /// The objectives of the Pareto front. Default: all.
    #[arg(long, value_name = "OBJECTIVES")]
    pub objectives: Option<List<Objective>>,

    /// Tooth numbers of the gearboxes shown.
    #[command(flatten)]
    pub teeth: TeethOptions,
}

/// What a gearbox has to keep besides its ratios.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "What else is wanted")]
pub struct Wishes {
    /// Number of brakes among the shift elements.
    #[arg(long, value_name = "RANGE", default_value = "0..7")]
    pub brakes: Span<u32>,

    /// Number of clutches among the shift elements.
    #[arg(long, value_name = "RANGE", default_value = "0..7")]
    pub clutches: Span<u32>,

    /// Shifts between neighbouring forward gears: single ones open one element and engage one.
    #[arg(long, value_enum, default_value_t = ShiftChoice::Any)]
    pub shifts: ShiftChoice,

    /// Shifts that skip a gear: 1–3, 2–4 and so on.
    #[arg(long, value_enum, default_value_t = ShiftChoice::Any)]
    pub skip_shifts: ShiftChoice,

    /// A gear is direct: it turns the gearbox as one block.
    #[arg(long)]
    pub direct: bool,

    /// Ratio steps between neighbouring forward gears.
    #[arg(long, value_name = "RANGE")]
    pub step: Option<Span<f64>>,

    /// Ratio steps fall from the first gear on: none is larger than the one before it.
    #[arg(long)]
    pub falling_steps: bool,

    /// Greatest slip of an open shift element over the input's speed.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub slip: Option<Number>,

    /// Greatest speed of a link over the input's.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub link_speed: Option<Number>,

    /// Greatest speed of a planet relative to its carrier over the input's; of a double-planet set the speed
    /// that its planets exceed with any teeth.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub planet_speed: Option<Number>,

    /// Only gearboxes that can be drawn: no link across another, each brake reached from the housing.
    #[arg(long)]
    pub drawable: bool,
}

/// Which shifts are allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum ShiftChoice {
    /// All; those with fewer multiple shifts are told first.
    Any,
    /// Those that exchange one element for one.
    Single,
}

impl Request {
    /// Searches for the gearboxes that have the ratios, and lists `limit` of them, or as many as may be
    /// listed. With `explain` the answer also compares a given gearbox with the search. The closure receives
    /// the finished part of the present class, from 0 to 1, and may end the search; the answer then has the
    /// gearboxes found so far.
    ///
    /// # Errors
    /// [`Failure::Option`] for an option that cannot be, alone or with the others.
    pub fn answer(
        &self,
        explain: Option<&Gearbox>,
        goes_on: &(dyn Fn(f64) -> ControlFlow<()> + Sync),
    ) -> Result<Synthesis, Failure> {
        let explain = explain.map(|gearbox| gearbox.train.clone());
        let wanted = Wanted { explain, ..self.wanted(self.most(false))? };
        let share = |at: run::Progress| at.done as f64 / at.of.max(1) as f64;
        synthesize::answer(&wanted, &|_, at| goes_on(share(at))).map_err(options::of_synthesis)
    }

    /// How many gearboxes are shown, of a table fewer.
    fn most(&self, in_table: bool) -> usize {
        // Tooth numbers of thousands of gearboxes would take hours.
        let few = in_table || self.teeth.teeth;
        self.limit.unwrap_or(if few { SHOWN_IN_TABLE } else { MOST_SOLUTIONS })
    }

    fn wanted(&self, most: usize) -> Result<Wanted, Failure> {
        let tolerance = self.tolerance.0.si();
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(Failure::invalid("--tolerance", "above 0 and below 100 %"));
        }
        let efficiency = MeshEfficiency::new(self.efficiency.0.si())
            .map_err(|error| Failure::of_option("--efficiency", &error))?;
        let objectives = self.objectives.as_ref().map_or(Objective::ALL.to_vec(), |list| list.0.clone());
        Ok(Wanted {
            gears: self.ratios.0.clone(),
            tolerance,
            kind: self.class,
            sets: counts("--sets", self.sets, 1..=MOST_SETS)?,
            elements: counts("--elements", self.elements, 1..=MOST_ELEMENTS)?,
            engaged: match self.engaged {
                Some(engaged) => counts("--engaged", engaged, 1..=MOST_ENGAGED)?,
                None if self.links.is_some() || self.open.is_some() => 1..=MOST_ENGAGED,
                None => 1..=3,
            },
            links: self.links.map_or(Ok(0..=usize::MAX), |links| counts("--links", links, 3..=MOST_LINKS))?,
            open: self.open.map_or(Ok(0..=usize::MAX), |open| counts("--open", open, 0..=MOST_ELEMENTS))?,
            k: self.k.within(ANY_K).map_err(|error| Failure::Range { option: "--k", error })?,
            double_planets: counts("--double-planets", self.double_planets, 0..=MOST_SETS)?,
            k_double: self
                .k_double
                .within(ANY_K)
                .map_err(|error| Failure::Range { option: "--k-double", error })?,
            equal_k: equal_k(self.equal_k)?,
            rules: self.wishes.rules()?,
            limits: self.wishes.limits()?,
            drawable: self.wishes.drawable,
            shares: self.shares.as_ref().map(|shares| shares_of(&shares.0, &self.ratios.0)).transpose()?,
            usable: self.usable.wanted()?,
            efficiency,
            most,
            all_gearboxes: self.all_gearboxes,
            also: None,
            order: self.order.0.clone(),
            objectives,
            teeth: self.teeth.wanted()?,
            explain: None,
        })
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let Args { request, save, output, page, .. } = args;
    page.only_of_a_page(output.is_page() && args.shard.is_none())?;
    let format = output.format();
    let wanted = Wanted {
        also: save.is_some().then_some(args.nth),
        explain: given(call, args)?,
        ..request.wanted(request.most(format == Format::Table))?
    };
    if let (Some(share), Some(file)) = (args.shard, output.file()) {
        return shards::search(call, &wanted, share, file);
    }
    let (mut found, kept) = if args.merge.is_empty() {
        searched(call, &wanted, args.longest.as_ref().map(|longest| longest.0))?
    } else {
        shards::merged(call, &wanted, &args.merge)?
    };
    if args.merge.is_empty() && found.complete {
        found.near_miss = near_miss(&wanted, &found, &|| call.goes_on())?;
    }
    let ended = || Failure::Interrupted("interrupted: the search was ended before it was complete".into());
    if found.found == 0 && !found.complete {
        return Err(ended());
    }
    if found.found == 0 && found.explanation.is_none() {
        let searched: Vec<String> = found
            .searched
            .iter()
            .map(|class| {
                format!(
                    "{} structures of {} sets with {} of {} shift elements engaged",
                    class.structures, class.sets, class.engaged, class.shift_elements
                )
            })
            .collect();
        return Err(Failure::NothingFound(format!(
            "no gearbox has these ratios: searched {}{}; {}try more --sets or --elements, --class all-sparse, a wider --tolerance or --k",
            searched.join(", "),
            crate::synthesize::table::left_out_in_words(&found.left_out),
            found.near_miss.as_ref().map_or_else(String::new, |near| format!(
                "{}; or ",
                crate::synthesize::table::near_miss(near).trim_end_matches('.')
            ))
        )));
    }
    let files = files(args, &found, &kept)?;
    if output.is_page() {
        let sheet = crate::synthesize::page::sheet(&found, &drawn(&kept, DRAWN)?, imprint::command(call));
        output.deliver_page(call, files, &found, sheet, &page.imprint())?;
    } else {
        output.deliver_with(call, files, &found)?;
    }
    if format != Format::Table && found.shown < found.found {
        call.complain(&format!("note: {}", crate::synthesize::table::count(&found)));
    }
    if found.complete { Ok(()) } else { Err(ended()) }
}

/// The search, ended early by Ctrl-C.
fn searched(
    call: &Call<'_>,
    wanted: &Wanted,
    longest: Option<Time>,
) -> Result<(Synthesis, Vec<Kept>), Failure> {
    let _hearing = Hearing::new(call);
    solve_by(wanted, &mut Here { call, wanted, longest, judging: Mutex::default(), goes_on: false })
}

/// A search on this machine.
struct Here<'c, 'd> {
    call: &'c Call<'d>,
    wanted: &'c Wanted,
    longest: Option<Time>,
    /// While solutions are judged: how far that is.
    judging: Mutex<Option<Progress<'d>>>,
    /// Whether gearboxes were found, none of use, and larger classes are searched.
    goes_on: bool,
}

/// Seconds left at which solutions are no longer judged, and no longer rated: the rest is needed to write the
/// answer.
const TO_RATE: f64 = 0.3;
const TO_TELL: f64 = 0.1;

impl Here<'_, '_> {
    /// Goes on until only this many seconds are left to write the answer.
    fn until(&self, seconds: f64) -> ControlFlow<()> {
        let is_over = self.call.desk.asked_to_end().is_some_and(|left| left <= seconds);
        if is_over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl Means<Failure> for Here<'_, '_> {
    fn search(&mut self, searching: &Searching, wish: &Wish) -> Result<Option<run::Answer>, Failure> {
        let Self { call, wanted, .. } = self;
        wanted.limits.check(&wish.gears).map_err(|error| options::of_synthesis(error.into()))?;
        match size::check(call, searching, wish, self.longest) {
            // What was found in smaller classes is told all the same.
            Err(Failure::TooLong(why)) if self.goes_on => {
                call.complain(&format!("note: larger classes are not searched: {why}"));
                return Ok(None);
            }
            checked => checked?,
        }
        let shown = Progress::new(call);
        let found =
            search(searching.class, wish, Share::WHOLE, &|at| shown.at(at.done as f64 / at.of.max(1) as f64));
        *self.judging.lock().unwrap_or_else(PoisonError::into_inner) = None;
        found.map(Some).map_err(|error| options::of_synthesis(error.into()))
    }

    fn judged(&self, done: usize, of: usize) -> ControlFlow<()> {
        let mut judging = self.judging.lock().unwrap_or_else(PoisonError::into_inner);
        let shown = judging.get_or_insert_with(|| Progress::of_judging(self.call));
        // What was found is judged as long as there is time to tell it.
        let _ = shown.at(done as f64 / of.max(1) as f64);
        let goes_on = self.until(TO_RATE);
        if goes_on.is_break() || done == of {
            *judging = None;
        }
        goes_on
    }

    fn rated(&self) -> ControlFlow<()> {
        self.until(TO_TELL)
    }

    fn ended(&self) -> bool {
        self.call.goes_on().is_break()
    }

    fn nothing_kept(&mut self, searching: &Searching, left_out: &[LeftOut]) {
        self.call.complain(&format!(
            "note: up to {} sets with {} shift elements nothing is left{}",
            searching.class.sets(),
            searching.shift_elements,
            crate::synthesize::table::left_out_in_words(left_out)
        ));
    }

    fn going_on(&mut self, searching: &Searching, faults: &[LeftOut]) {
        self.goes_on = true;
        self.call.complain(&format!(
            "note: up to {} sets with {} shift elements no gearbox is of use: {}; larger classes are searched, with --first-class not",
            searching.class.sets(),
            searching.shift_elements,
            crate::synthesize::table::counts_in_words(faults)
        ));
    }
}

impl Wishes {
    fn rules(&self) -> Result<Rules, Failure> {
        let single = |choice| choice == ShiftChoice::Single;
        Ok(Rules {
            brakes: counts("--brakes", self.brakes, 0..=MOST_ELEMENTS)?,
            clutches: counts("--clutches", self.clutches, 0..=MOST_ELEMENTS)?,
            shifts: Shifts { neighbours: single(self.shifts), skips: single(self.skip_shifts) },
            direct: self.direct,
        })
    }

    fn limits(&self) -> Result<Limits, Failure> {
        let steps = self.step.map(|step| step.closed(1.0..=f64::INFINITY)).transpose();
        let steps = steps.map_err(|error| Failure::Range { option: "--step", error })?;
        if steps.as_ref().is_some_and(|steps| *steps.start() < 1.0) {
            let message = "a step is the higher ratio over the next lower, at least 1";
            return Err(Failure::invalid("--step", message));
        }
        Ok(Limits {
            steps,
            falling_steps: self.falling_steps,
            slip: greatest("--slip", self.slip)?,
            link_speed: greatest("--link-speed", self.link_speed)?,
            planet_speed: greatest("--planet-speed", self.planet_speed)?,
        })
    }
}

/// How many sets have equal k.
fn equal_k(count: u32) -> Result<usize, Failure> {
    if !(1..=MOST_SETS).contains(&(count as usize)) {
        let message = format!("from 1, which asks for nothing, to {MOST_SETS}");
        return Err(Failure::invalid("--equal-k", message));
    }
    Ok(count as usize)
}

fn greatest(option: &'static str, value: Option<Number>) -> Result<Option<f64>, Failure> {
    let value = value.map(Number::get);
    if value.is_some_and(|value| value <= 0.0) {
        return Err(Failure::invalid(option, "must be above 0"));
    }
    Ok(value)
}

fn counts(
    option: &'static str,
    span: Span<u32>,
    within: RangeInclusive<usize>,
) -> Result<RangeInclusive<usize>, Failure> {
    let [least, most] = [within.start(), within.end()].map(|end| u32::try_from(*end).unwrap_or(u32::MAX));
    let range = span.within(least..=most).map_err(|error| Failure::Range { option, error })?;
    Ok(*range.start() as usize..=*range.end() as usize)
}

/// The gearbox of --explain.
fn given(call: &Call<'_>, args: &Args) -> Result<Option<train::Gearbox>, Failure> {
    let Some(file) = &args.explain else { return Ok(None) };
    let document = input::document(call, file)?;
    let choice = Choice { transmission: args.transmission.clone(), ..Choice::default() };
    Ok(Some(one(&document, &choice)?.train))
}

/// The file of --save with its content.
fn files(args: &Args, found: &Synthesis, kept: &[Kept]) -> Result<Vec<Content>, Failure> {
    let Some(file) = &args.save else { return Ok(vec![]) };
    let Some(one) = kept.iter().find(|kept| kept.number == args.nth) else {
        let message = format!("{}: there are gearboxes 1 to {}", args.nth, found.found);
        return Err(Failure::no_such_design(message));
    };
    let ratios: Vec<String> =
        found.wanted.iter().map(|gear| crate::synthesize::table::wanted(gear, found.tolerance)).collect();
    let (number, ratios) = (args.nth, ratios.join(", "));
    let name = format!("Gearbox {number} for {ratios}");
    let gearbox = saved::gearbox(one, &name, one.teeth.first())?;
    let mut comment = vec![format!(
        "Gearbox {number} of {} found by synthesize for the ratios {ratios}, each within {} %.",
        found.found,
        100.0 * found.tolerance
    )];
    comment.extend(one.judged.sharing.compounds.iter().map(|compound| {
        format!("Sets that share planets, as one compound set: {}.", compound.name().replace('+', " and "))
    }));
    let text = saved::file(&gearbox, &comment).map_err(|error| Failure::Format(error.to_string()))?;
    Ok(vec![(file.clone(), text.into_bytes())])
}
