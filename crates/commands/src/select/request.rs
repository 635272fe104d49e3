//! The command `select`: which gearbox gives these speeds.

mod nothing;
mod refused;

use crate::answer::write_json;
use crate::desk::{Call, Content};
use crate::error::Error;
use crate::failure::Failure;
use crate::output::{Format, OutputArgs};
use crate::progress::Progress;
use crate::select::answer::duty::{Duty, Load};
use crate::select::answer::page::drawn;
use crate::select::answer::saved::Saved;
use crate::select::answer::teeth::{self, MOST_DESIGNS, Searched, SizeLimits};
use crate::select::answer::{self as select, Wanted};
use crate::select::table::teeth::csv;
use crate::select::table::ways_out;
use crate::shared::lists::{List, Numbers, Quantities};
use crate::shared::options;
use crate::shared::page_options::{self as imprint, PageArgs};
use crate::shared::profile_shift::ShiftOptions;
use crate::shared::ratios::PlainRatios;
use crate::teeth::answer::IN_A_SECOND;
use epicyclic_formats::Span;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_schemes::RatioSeries;
use epicyclic_selection::{Limits, Objective, Order, Orders, Rating, Requirements, Signs, Space};
use epicyclic_units::{Number, Physical, Quantity};
use nothing::{nothing_found, with_teeth_more};
use refused::refuse;
pub(crate) use refused::refuse_selection;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use uom::si::f64::{AngularVelocity, Length, Power, Pressure, Ratio, Torque, Velocity};

/// Designs shown unless said otherwise: in a table, and of tooth numbers.
const SHOWN: usize = 10;

/// Pairs of ring-to-sun ratios that are tried in a second, about.
const PAIRS_IN_A_SECOND: f64 = 3e6;

/// The planetary gearbox for two or three speeds: every scheme measured, judged and compared.
///
/// The fastest speed is direct drive; the others give the ratios wanted of one or two braked gears. Each
/// mechanism is tried with both orders of the ratios and both signs, its ring-to-sun ratios follow, and every
/// required criterion is stated with what it found. There are no weights: of the designs that meet the
/// criteria, the order of objectives chooses the first. The non-dominated designs are those that no other
/// beats in everything.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(flatten)]
    speeds: Speeds,

    /// Tooth numbers of the one set or of both: all combinations.
    #[arg(long)]
    teeth: bool,

    /// Show at most this many designs. Default: 10 in a table, otherwise all; of tooth numbers 10, in a table
    /// up to 10000.
    #[arg(long, value_name = "N")]
    limit: Option<usize>,

    /// The objective that decides first, then the next for equal values: size, efficiency. Default:
    /// efficiency, speed, k, error, size; with --teeth error, efficiency, speed, k, size.
    #[arg(long, value_name = "OBJECTIVES")]
    order: Option<List<Objective>>,

    /// Write the best design as a gearbox file that analyze, draw and report read.
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    /// The design that is shown in full and saved, by its number.
    #[arg(long, value_name = "N", default_value = "1")]
    nth: usize,

    /// How far a ratio may be off: 10%, or 0.1.
    #[arg(long, default_value = "10%", allow_hyphen_values = true, help_heading = "Ratios")]
    tolerance: Quantity<Ratio>,

    #[command(flatten)]
    ratios: RatioOptions,

    #[command(flatten)]
    criteria: Criteria,

    /// Refuse mixed directions of rotation: the output turns one way in a braked gear and the other way in
    /// direct drive. Default: such schemes are marked and ranked last.
    #[arg(long, help_heading = "Criteria")]
    same_direction: bool,

    #[command(flatten)]
    duty: DutyOptions,

    #[command(flatten)]
    size: Size,

    #[command(flatten)]
    teeth_bounds: BoundOptions,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    page: PageArgs,
}

/// What the gearbox shall give, and of which mechanisms.
#[derive(Debug, clap::Args)]
pub(crate) struct Speeds {
    /// Speeds of the machine, the slowest first.
    #[arg(long, required_unless_present = "ratios", conflicts_with = "ratios", allow_hyphen_values = true)]
    speeds: Option<Quantities<Velocity>>,

    /// Ratios of the braked gears, in place of speeds: one or two. 2.5,1.5 or 2,5; 1,5.
    #[arg(long, allow_hyphen_values = true)]
    ratios: Option<PlainRatios>,

    /// All 111 structures of two sets (or the 6 of one), and not only the source's.
    #[arg(long)]
    all_structures: bool,
}

/// How the ratios are taken.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Ratios")]
pub(crate) struct RatioOptions {
    /// Which brake gives which ratio.
    #[arg(long, value_enum, default_value_t = Brakes::Either)]
    brakes: Brakes,

    /// Which signs the ratios may have; direct drive is positive. Default: as-given where a ratio has a
    /// minus, otherwise alike.
    #[arg(long, value_enum)]
    signs: Option<SignChoice>,
}

/// Which brake gives which ratio.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Brakes {
    /// Either brake gives either ratio.
    Either,
    /// The first brake gives the first ratio.
    AsGiven,
}

/// Which signs the ratios may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum SignChoice {
    /// All positive, or all negative.
    Alike,
    /// Each by itself.
    Any,
    /// Those of --ratios.
    AsGiven,
}

/// What a design has to meet.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Criteria")]
pub(crate) struct Criteria {
    /// Ring-to-sun ratios allowed.
    #[arg(long, value_name = "RANGE", default_value = "1.3..10")]
    k: Span<f64>,

    /// Ring-to-sun ratios preferred.
    #[arg(long, value_name = "RANGE", default_value = "2.5..3")]
    prefer: Span<f64>,

    /// Efficiency of each set with its carrier fixed, 0.97 or 97%.
    #[arg(long, value_name = "NUMBER", default_value = "0.9702", allow_hyphen_values = true)]
    efficiency: Quantity<Ratio>,

    /// Least efficiency of a gear.
    #[arg(long, value_name = "NUMBER", default_value = "0.9", allow_hyphen_values = true)]
    least_efficiency: Quantity<Ratio>,

    /// Greatest speed of a link over the input's.
    #[arg(long, value_name = "NUMBER", default_value = "2", allow_negative_numbers = true)]
    link_speed: Number,

    /// Greatest speed of a planet relative to its carrier over the input's.
    #[arg(long, value_name = "NUMBER", default_value = "2", allow_negative_numbers = true)]
    planet_speed: Number,

    /// Greatest slip of the open direct-drive clutch over the input's speed.
    #[arg(long, value_name = "NUMBER", default_value = "2", allow_negative_numbers = true)]
    clutch_slip: Number,

    /// Greatest circulating power of a gear over what enters, 0.5 or 50%. Not given: more than half is an
    /// objection.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    circulation: Option<Quantity<Ratio>>,

    /// Accept schemes that are not drawable: a link would cross another.
    #[arg(long)]
    allow_crossing: bool,
}

/// What sizes are measured by.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Size")]
struct Size {
    /// Load factor K of the sun's teeth, 2 MPa: with --torque or --power sizes are lengths.
    #[arg(long, requires = "load", allow_hyphen_values = true)]
    load_factor: Option<Quantity<Pressure>>,

    /// Face width over the pitch diameter of the smaller of sun and planet; with --load-factor.
    #[arg(
        long,
        value_name = "NUMBER",
        requires = "load_factor",
        default_value = "1",
        allow_negative_numbers = true
    )]
    face_width_ratio: Number,

    /// Planets of each set, without --teeth.
    #[arg(long, value_name = "N", default_value = "3")]
    planets: u32,

    /// Mesh load factors K_γ with 2, 3, … 8 planets: seven numbers; how much more than its share the most
    /// loaded mesh carries.
    #[arg(long, value_name = "NUMBERS")]
    mesh_load_factors: Option<Numbers>,

    /// Greatest pitch diameter of a ring; with --teeth.
    #[arg(long, requires = "load_factor", requires = "teeth", allow_hyphen_values = true)]
    ring_diameter: Option<Quantity<Length>>,

    /// Least module that a set may need; with --teeth.
    #[arg(long, requires = "load_factor", requires = "teeth", allow_hyphen_values = true)]
    least_module: Option<Quantity<Length>>,

    /// Greatest module that a set may need; with --teeth.
    #[arg(long, requires = "load_factor", requires = "teeth", allow_hyphen_values = true)]
    greatest_module: Option<Quantity<Length>>,
}

/// What is known of the input.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Duty")]
#[group(id = "duty")]
struct DutyOptions {
    /// Speed of the input, 1475 rpm: gives the speed of the output in each gear.
    #[arg(long, visible_alias = "speed", value_name = "SPEED", allow_hyphen_values = true)]
    input: Option<Quantity<AngularVelocity>>,

    /// Power into the input, 75 kW; needs --input. Gives torques and losses in each gear.
    #[arg(long, requires = "input", conflicts_with = "torque", group = "load", allow_hyphen_values = true)]
    power: Option<Quantity<Power>>,

    /// Torque on the input, 500 N·m, in place of --power.
    #[arg(long, group = "load", allow_hyphen_values = true)]
    torque: Option<Quantity<Torque>>,
}

/// Tooth numbers tried.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Tooth numbers, with --teeth")]
struct BoundOptions {
    /// Teeth of the suns.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    sun: Span<u32>,

    /// Teeth of the planets.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    planet: Span<u32>,

    /// Teeth of the rings.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    ring: Span<u32>,

    /// Number of planets of a set, from 2 to 8.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "3..8")]
    planet_count: Span<u32>,

    #[command(flatten)]
    shifts: ShiftOptions,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    args.page.only_of_a_page(args.output.is_page())?;
    args.teeth_bounds.shifts.only_with_teeth(args.teeth)?;
    let duty = args.duty.duty();
    duty.torque().map_err(|error| refuse(args, error))?;
    let rating = rating(args, &duty)?;
    let (tolerance, same_direction) = (args.tolerance, args.same_direction);
    let requirements =
        requirements(&args.speeds, tolerance, &args.ratios, &args.criteria, same_direction, rating)?;
    let order = args.order.as_ref().map_or(usual_order(args.teeth), |order| order.0.as_slice());
    let order = Order::new(order).map_err(|error| refuse(args, error.into()))?;
    if args.teeth {
        return with_teeth(call, args, requirements, order, duty);
    }
    let most = match (args.limit, args.output.format()) {
        (Some(limit), _) => limit,
        (None, Format::Table) => SHOWN,
        (None, _) => usize::MAX,
    };
    let space = args.speeds.space();
    let eta0 = requirements.eta0;
    let (nth, speeds) = (args.nth, args.speeds.of_machine());
    let wanted = Wanted { requirements, order, space, speeds, most, nth, duty };
    let found = select::solve(&wanted, args.save.is_some());
    let (found, saved) = found.map_err(|error| refuse(args, error))?;
    let designs = found.accepted + found.rejected;
    if found.shown_in_full.is_none() && args.nth != 1 {
        return Err(no_such_design(args, designs));
    }
    let files = save(call, args, saved, found.accepted, designs)?;
    if args.output.is_page() {
        let best = found.in_full();
        let drawn = best.map(|best| drawn(best, eta0)).transpose()?;
        let sheet = crate::select::page::sheet(&found, drawn.as_ref(), imprint::command(call));
        args.output.deliver_page(call, files, &found, sheet, &args.page.imprint())?;
    } else {
        args.output.deliver_with(call, files, &found)?;
    }
    if found.accepted == 0 { Err(nothing_found(ways_out(&found).first())) } else { Ok(()) }
}

impl Criteria {
    /// The ring-to-sun ratios allowed, within these.
    pub(crate) fn k(&self, usual: RangeInclusive<f64>) -> Result<RangeInclusive<f64>, Failure> {
        self.k.closed(usual).map_err(|error| Failure::Range { option: "--k", error })
    }
}

impl Speeds {
    /// The mechanisms to choose among.
    pub(crate) fn space(&self) -> Space {
        if self.all_structures { Space::All } else { Space::Catalogue }
    }

    /// The speeds of the machine; none where ratios are given.
    pub(crate) fn of_machine(&self) -> Vec<Velocity> {
        self.speeds.iter().flat_map(crate::shared::lists::List::values).collect()
    }
}

fn with_teeth(
    call: &Call<'_>,
    args: &Args,
    requirements: Requirements,
    order: Order,
    duty: Duty,
) -> Result<(), Failure> {
    let nth = args.nth;
    // What is not shown needs no search beyond the limit.
    let is_needed = args.save.is_some() || nth > 1;
    let most = args.limit.unwrap_or(SHOWN).max(if is_needed { nth } else { 0 });
    let for_programs = args.output.format() != Format::Table;
    let length = |option: Option<Quantity<Length>>| option.map(|length| length.0);
    let limits = SizeLimits {
        ring_diameter: length(args.size.ring_diameter),
        least_module: length(args.size.least_module),
        greatest_module: length(args.size.greatest_module),
    };
    if most > MOST_DESIGNS && !for_programs {
        return Err(refuse(args, Error::TooManyDesigns { wanted: most, most: MOST_DESIGNS }));
    }
    let bounds = bounds(args)?;
    let shifts = args.teeth_bounds.shifts.wanted();
    let is_shifted = shifts.is_some();
    let eta0 = requirements.eta0;
    let space = args.speeds.space();
    let speeds = args.speeds.of_machine();
    let of_one_set = requirements.series.braked().len() == 1;
    let wanted =
        teeth::Wanted { requirements, order, space, bounds, shifts, limits, most, nth, speeds, duty };
    let shown = Progress::new(call);
    if of_one_set && !is_shifted {
        let parts = wanted.bounds.space(false).map_err(|error| refuse_selection(error.into()))? as f64;
        shown.size(parts, IN_A_SECOND, || {
            format!("{parts:.1e} combinations of sun, planet and number of planets")
        });
    }
    let found = teeth::search(&wanted, &|at| {
        if let Some(Searched { designs, tooth_numbers, structures, tried, .. }) = at.searched {
            shown.size(tried as f64, PAIRS_IN_A_SECOND, || {
                format!(
                    "{:.1e} designs: {tooth_numbers} combinations of tooth numbers a set, {structures} structures with their ratios; \
                     {:.1e} pairs of ring-to-sun ratios",
                    designs as f64, tried as f64
                )
            });
        }
        shown.at(at.share)
    });
    drop(shown);
    let found = found.map_err(|error| refuse(args, error))?;
    if found.shown() > 0 && nth > found.shown() {
        return Err(no_such_design(args, found.shown()));
    }
    let saved = args.save.as_ref().map(|_| found.saved(nth)).transpose();
    let saved = saved.map_err(|error| refuse(args, error))?.flatten();
    let files = save(call, args, saved, found.shown(), found.shown())?;
    let (accepted, count) = (found.searched().accepted, found.shown());
    if for_programs {
        // Each design is made when it is written: there may be some hundred thousand of them.
        let shown = args.output.is_out_of_sight(call).then(|| Progress::of_writing(call));
        let told = |share: f64| shown.iter().for_each(|shown| _ = shown.at(share));
        if args.output.format() == Format::Json {
            let answer = found.streamed(&told)?;
            args.output.stream(call, &files, &mut |out| write_json(&answer, out))?;
        } else {
            let designs = found.designs().zip(1..).map(|(design, no)| {
                told(f64::from(no) / count as f64);
                design
            });
            let mut designs = Some(designs);
            args.output.stream(call, &files, &mut |out| {
                csv(designs.take().into_iter().flatten(), is_shifted, out)
            })?;
        }
        if !args.output.has_json_out() {
            let found = found.streamed(&|_| ())?;
            call.record(&mut |out| write_json(&found, out))?;
        }
    } else {
        let answer = found.answer().map_err(|error| refuse(args, error))?;
        if args.output.is_page() {
            let best = answer.in_full().map(|design| &design.candidate);
            let drawn = best.map(|best| drawn(best, eta0)).transpose()?;
            let sheet =
                crate::select::page::sheet_with_teeth(&answer, drawn.as_ref(), imprint::command(call));
            args.output.deliver_page(call, files, &answer, sheet, &args.page.imprint())?;
        } else {
            args.output.deliver_with(call, files, &answer)?;
        }
    }
    if accepted == 0 || (count == 0 && most > 0) {
        return Err(nothing_found(with_teeth_more(args).as_ref()));
    }
    if for_programs && count == most {
        call.complain(&format!("note: the first {most} of the non-dominated designs; --limit shows more"));
    }
    Ok(())
}

/// Tooth numbers give ratios that are off: the nearest come first. Without them the ratios are those wanted,
/// but for limits of k.
const fn usual_order(teeth: bool) -> &'static [Objective] {
    if teeth { &[Objective::RatioError] } else { &[] }
}

fn no_such_design(args: &Args, designs: usize) -> Failure {
    Failure::no_such_design(format!("{}: there are designs 1 to {designs}", args.nth))
}

/// The file of --save with its content; none without a design that meets the criteria or that --nth names.
fn save(
    call: &Call<'_>,
    args: &Args,
    saved: Option<Saved>,
    accepted: usize,
    designs: usize,
) -> Result<Vec<Content>, Failure> {
    let Some(file) = &args.save else { return Ok(vec![]) };
    let Some(saved) = saved else {
        if accepted == 0 {
            return Ok(vec![]);
        }
        return Err(no_such_design(args, designs));
    };
    let mut comments = vec![format!(
        "Design {} of epicyclic select: {}, with the direct-drive clutch chosen.",
        args.nth, saved.scheme
    )];
    if !saved.sizes.is_empty() {
        comments.push("Module and face width are what the load factor needs.".to_owned());
    }
    if args.nth > accepted {
        if args.nth == 1 {
            return Ok(vec![]);
        }
        let remark = "It was rejected: it does not meet every required criterion.";
        call.complain(&format!(
            "note: design {} is saved; it does not meet every required criterion",
            args.nth
        ));
        comments.push(remark.to_owned());
    }
    let text = saved.file(&comments).map_err(|error| Failure::Format(error.to_string()))?;
    Ok(vec![(file.clone(), text.into_bytes())])
}

impl DutyOptions {
    fn duty(&self) -> Duty {
        let torque = self.torque.map(|torque| Load::Torque(torque.0));
        Duty {
            input_speed: self.input.map(|speed| speed.0),
            load: torque.or_else(|| self.power.map(|power| Load::Power(power.0))),
        }
    }
}

fn bounds(args: &Args) -> Result<Bounds, Failure> {
    let given = &args.teeth_bounds;
    let closed =
        |option, span: Span<u32>, usual| span.closed(usual).map_err(|error| Failure::Range { option, error });
    let k = args.criteria.k(Bounds::default().ring_to_sun_ratio)?;
    let usual = options::proposed([given.sun, given.planet, given.ring])?;
    let planets = closed("--planet-count", given.planet_count, usual.planets)?;
    Ok(Bounds { planets, ring_to_sun_ratio: k, ..usual })
}

impl RatioOptions {
    /// The signs: those given where one is negative, since it was written for a purpose.
    pub(crate) fn signs(&self, wanted: &Speeds) -> Signs {
        let mut ratios = wanted.ratios.iter().flat_map(|ratios| &ratios.0);
        match self.signs {
            Some(SignChoice::AsGiven) => Signs::AsGiven,
            Some(SignChoice::Any) => Signs::Any,
            Some(SignChoice::Alike) => Signs::Alike,
            None if ratios.any(|ratio| ratio.get() < 0.0) => Signs::AsGiven,
            None => Signs::Alike,
        }
    }
}

/// Returns the requirements given by the options.
pub(crate) fn requirements(
    wanted: &Speeds,
    tolerance: Quantity<Ratio>,
    taken: &RatioOptions,
    criteria: &Criteria,
    same_direction: bool,
    rating: Rating,
) -> Result<Requirements, Failure> {
    let series = match (&wanted.speeds, &wanted.ratios) {
        (Some(speeds), _) => RatioSeries::of_speeds(&speeds.values(), 1),
        (None, ratios) => {
            let ratios: Vec<f64> =
                ratios.iter().flat_map(|ratios| &ratios.0).map(|ratio| ratio.get()).collect();
            RatioSeries::of_braked_gears(&ratios)
        }
    };
    let range =
        |option, span: Span<f64>, usual| span.closed(usual).map_err(|error| Failure::Range { option, error });
    let usual = Limits::default();
    let eta0 = MeshEfficiency::new(criteria.efficiency.0.si())
        .map_err(|error| Failure::of_option("--efficiency", &error))?;
    Ok(Requirements {
        tolerance: tolerance.0.si(),
        orders: match taken.brakes {
            Brakes::Either => Orders::Both,
            Brakes::AsGiven => Orders::AsGiven,
        },
        signs: taken.signs(wanted),
        limits: Limits {
            ring_to_sun: range("--k", criteria.k, usual.ring_to_sun)?,
            preferred: range("--prefer", criteria.prefer, usual.preferred)?,
            efficiency: criteria.least_efficiency.0.si(),
            link_speed: criteria.link_speed.get(),
            planet_speed: criteria.planet_speed.get(),
            clutch_slip: criteria.clutch_slip.get(),
            circulation: criteria.circulation.map_or(usual.circulation, |share| share.0.si()),
            same_direction,
            drawable: !criteria.allow_crossing,
        },
        eta0,
        rating,
        ..Requirements::new(series.map_err(|error| refuse_selection(error.into()))?)
    })
}

fn rating(args: &Args, duty: &Duty) -> Result<Rating, Failure> {
    let size = &args.size;
    let usual = Rating::default();
    let mesh_load_factors = match &size.mesh_load_factors {
        None => usual.mesh_load_factors,
        Some(numbers) => {
            let numbers: Vec<f64> = numbers.0.iter().map(|number| number.get()).collect();
            let count = numbers.len();
            numbers.try_into().map_err(|_| {
                Failure::invalid(
                    "--mesh-load-factors",
                    format!("{count} numbers where seven are due, for 2 to 8 planets"),
                )
            })?
        }
    };
    Ok(Rating {
        load: duty
            .torque()
            .map_err(|error| refuse(args, error))?
            .zip(size.load_factor.map(|factor| factor.0)),
        face_width_ratio: size.face_width_ratio.get(),
        mesh_load_factors,
        planets: size.planets,
    })
}
