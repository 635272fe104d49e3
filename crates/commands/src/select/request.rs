//! The command `select`: which gearbox gives these speeds.

mod nothing;
mod refused;

use crate::answer::write_json;
use crate::desk::{Call, Content};
use crate::error::Error;
use crate::failure::Failure;
use crate::output::{Format, NO_HEADING, OutputArgs};
use crate::progress::Progress;
use crate::select::answer::duty::{Duty, Load};
use crate::select::answer::page::drawn;
use crate::select::answer::saved::Saved;
use crate::select::answer::teeth::{self, MOST_DESIGNS, Searched, SelectTeeth, SizeLimits, Watch};
use crate::select::answer::{self as select, Select, Wanted};
use crate::select::table::teeth::csv;
use crate::select::table::ways_out;
use crate::shared::lists::{List, Numbers};
use crate::shared::options;
use crate::shared::page_options::{self as imprint, PageArgs};
use crate::shared::profile_shift::ShiftOptions;
use crate::shared::selection::{Criteria, RatioOptions, Speeds, refuse_selection, requirements};
use crate::teeth::answer::IN_A_SECOND;
use epicyclic_formats::Span;
use epicyclic_gears::synthesis::Bounds;
use epicyclic_selection::{Objective, Order, Rating, Requirements};
use epicyclic_units::{Module, Number, Quantity};
use nothing::{nothing_found, with_teeth_more};
use refused::refuse;
use std::path::PathBuf;
use uom::si::f64::{AngularVelocity, Length, Power, Pressure, Ratio, Torque};

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
#[command(
    after_help = include_str!("examples.txt"),
    group(clap::ArgGroup::new("asked").required(true).args(["speeds", "ratios"])),
)]
pub struct Args {
    #[command(flatten)]
    request: Request,

    /// Write the best design as a gearbox file that analyze, draw and report read.
    #[arg(long, value_name = "FILE", help_heading = NO_HEADING)]
    save: Option<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    page: PageArgs,
}

/// Request for a gearbox of two or three speeds.
#[derive(Debug, Clone, clap::Args)]
pub struct Request {
    /// Speeds or ratios, and the mechanisms to choose among.
    #[command(flatten)]
    pub speeds: Speeds,

    /// Tooth numbers of the one set or of both: all combinations.
    #[arg(long)]
    pub teeth: bool,

    /// Show at most this many designs. Default: 10 in a table, otherwise all; of tooth numbers 10, in a table
    /// up to 10000.
    #[arg(long, value_name = "N")]
    pub limit: Option<usize>,

    /// The objective that decides first, then the next for equal values: size, efficiency. Default:
    /// efficiency, speed, k, error, size; with --teeth error, efficiency, speed, k, size.
    #[arg(long, value_name = "OBJECTIVES")]
    pub order: Option<List<Objective>>,

    /// The design that is shown in full and saved, by its number.
    #[arg(long, value_name = "N", default_value = "1")]
    pub nth: usize,

    /// How far a ratio may be off: 10%, or 0.1.
    #[arg(long, default_value = "10%", allow_hyphen_values = true, help_heading = "Ratios")]
    pub tolerance: Quantity<Ratio>,

    /// How the ratios are taken.
    #[command(flatten)]
    pub ratios: RatioOptions,

    /// Criteria of a design.
    #[command(flatten)]
    pub criteria: Criteria,

    /// Refuse mixed directions of rotation: the output turns one way in a braked gear and the other way in
    /// direct drive. Default: such schemes are marked and ranked last.
    #[arg(long, help_heading = "Criteria")]
    pub same_direction: bool,

    /// Speed and load of the input.
    #[command(flatten)]
    pub duty: DutyOptions,

    /// Load factor and limits of sizes.
    #[command(flatten)]
    pub size: Size,

    /// Tooth numbers tried, with `teeth`.
    #[command(flatten)]
    pub teeth_bounds: BoundOptions,
}

/// Load factor and limits of sizes.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Size")]
pub struct Size {
    /// Load factor K of the sun's teeth, 2 MPa: with --torque or --power sizes are lengths.
    #[arg(long, requires = "load", allow_hyphen_values = true)]
    pub load_factor: Option<Quantity<Pressure>>,

    /// Face width over the pitch diameter of the smaller of sun and planet; with --load-factor.
    #[arg(
        long,
        value_name = "NUMBER",
        requires = "load_factor",
        default_value = "1",
        allow_hyphen_values = true
    )]
    pub face_width_ratio: Number,

    /// Planets of each set, without --teeth.
    #[arg(long, value_name = "N", default_value = "3")]
    pub planets: u32,

    /// Mesh load factors K_γ with 2, 3, … 8 planets: seven numbers; how much more than its share the most
    /// loaded mesh carries.
    #[arg(long, value_name = "NUMBERS")]
    pub mesh_load_factors: Option<Numbers>,

    /// Greatest pitch diameter of a ring; with --teeth.
    #[arg(long, requires = "load_factor", requires = "teeth", allow_hyphen_values = true)]
    pub ring_diameter: Option<Quantity<Length>>,

    /// Least module that a set may need; with --teeth.
    #[arg(long, requires = "load_factor", requires = "teeth", allow_hyphen_values = true)]
    pub least_module: Option<Quantity<Module>>,

    /// Greatest module that a set may need; with --teeth.
    #[arg(long, requires = "load_factor", requires = "teeth", allow_hyphen_values = true)]
    pub greatest_module: Option<Quantity<Module>>,
}

/// Speed and load of the input.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Duty")]
#[group(id = "duty")]
pub struct DutyOptions {
    /// Speed of the input, 1475 rpm: gives the speed of the output in each gear.
    #[arg(long, visible_alias = "speed", value_name = "SPEED", allow_hyphen_values = true)]
    pub input: Option<Quantity<AngularVelocity>>,

    /// Power into the input, 75 kW; needs --input. Gives torques and losses in each gear.
    #[arg(long, requires = "input", conflicts_with = "torque", group = "load", allow_hyphen_values = true)]
    pub power: Option<Quantity<Power>>,

    /// Torque on the input, 500 N·m, in place of --power.
    #[arg(long, group = "load", allow_hyphen_values = true)]
    pub torque: Option<Quantity<Torque>>,
}

/// Tooth numbers tried.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Tooth numbers, with --teeth")]
pub struct BoundOptions {
    /// Teeth of the suns.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    pub sun: Span<u32>,

    /// Teeth of the planets.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    pub planet: Span<u32>,

    /// Teeth of the rings.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "12..200")]
    pub ring: Span<u32>,

    /// Number of planets of a set, from 2 to 8.
    #[arg(long, value_name = "RANGE", requires = "teeth", default_value = "3..8")]
    pub planet_count: Span<u32>,

    /// Profile shifts.
    #[command(flatten)]
    pub shifts: ShiftOptions,
}

impl Request {
    /// The designs by their ring-to-sun ratios, the accepted first; `limit` of both kinds, or all.
    ///
    /// # Errors
    /// [`Failure::Option`] for an option that cannot be, alone or with the others.
    pub fn answer(&self) -> Result<Select, Failure> {
        let wanted = self.wanted(self.limit.unwrap_or(usize::MAX))?;
        Ok(select::solve(&wanted, false).map_err(|error| refuse(self, error))?.0)
    }

    /// The non-dominated designs of tooth numbers, `limit` of them or 10. The closure is asked whether to go
    /// on, and what is found until then is the answer.
    ///
    /// # Errors
    /// As of [`Self::answer`].
    pub fn answer_teeth(&self, watch: &Watch) -> Result<SelectTeeth, Failure> {
        let wanted = self.wanted_teeth(self.limit.unwrap_or(SHOWN))?;
        let found = teeth::search(&wanted, watch).and_then(|found| found.answer());
        found.map_err(|error| refuse(self, error))
    }

    /// Requirements on the designs, the order that ranks them, and the duty.
    fn required(&self) -> Result<(Requirements, Order, Duty), Failure> {
        self.teeth_bounds.shifts.only_with_teeth(self.teeth)?;
        let duty = self.duty.duty();
        duty.torque().map_err(|error| refuse(self, error))?;
        let rating = rating(self, &duty)?;
        let (tolerance, same_direction) = (self.tolerance, self.same_direction);
        let requirements =
            requirements(&self.speeds, tolerance, &self.ratios, &self.criteria, same_direction, rating)?;
        let order = self.order.as_ref().map_or(usual_order(self.teeth), |order| order.0.as_slice());
        let order = Order::new(order).map_err(|error| refuse(self, error.into()))?;
        Ok((requirements, order, duty))
    }

    fn wanted(&self, most: usize) -> Result<Wanted, Failure> {
        let (requirements, order, duty) = self.required()?;
        let (space, speeds) = (self.speeds.space(), self.speeds.of_machine());
        Ok(Wanted { requirements, order, space, speeds, most, nth: self.nth, duty })
    }

    fn wanted_teeth(&self, most: usize) -> Result<teeth::Wanted, Failure> {
        let (requirements, order, duty) = self.required()?;
        let length = |option: Option<Quantity<Length>>| option.map(|length| length.0);
        let module = |option: Option<Quantity<Module>>| option.map(|module| module.0.length());
        Ok(teeth::Wanted {
            requirements,
            order,
            space: self.speeds.space(),
            bounds: bounds(self)?,
            shifts: self.teeth_bounds.shifts.wanted(),
            limits: SizeLimits {
                ring_diameter: length(self.size.ring_diameter),
                least_module: module(self.size.least_module),
                greatest_module: module(self.size.greatest_module),
            },
            most,
            nth: self.nth,
            speeds: self.speeds.of_machine(),
            duty,
        })
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let Args { request, save, output, page } = args;
    page.only_of_a_page(output.is_page())?;
    if request.teeth {
        return with_teeth(call, args);
    }
    let most = match (request.limit, output.format()) {
        (Some(limit), _) => limit,
        (None, Format::Table) => SHOWN,
        (None, _) => usize::MAX,
    };
    let wanted = request.wanted(most)?;
    let (found, saved) = select::solve(&wanted, save.is_some()).map_err(|error| refuse(request, error))?;
    let designs = found.accepted + found.rejected;
    if found.shown_in_full.is_none() && wanted.nth != 1 {
        return Err(no_such_design(wanted.nth, designs));
    }
    let files = files(call, args, saved, found.accepted, designs)?;
    if output.is_page() {
        let best = found.in_full();
        let drawn = best.map(|best| drawn(best, wanted.requirements.eta0)).transpose()?;
        let sheet = crate::select::page::sheet(&found, drawn.as_ref(), imprint::command(call));
        output.deliver_page(call, files, &found, sheet, &page.imprint())?;
    } else {
        output.deliver_with(call, files, &found)?;
    }
    if found.accepted == 0 { Err(nothing_found(ways_out(&found).first())) } else { Ok(()) }
}

fn with_teeth(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let Args { request, save, output, page } = args;
    let nth = request.nth;
    // What is not shown needs no search beyond the limit.
    let is_needed = save.is_some() || nth > 1;
    let most = request.limit.unwrap_or(SHOWN).max(if is_needed { nth } else { 0 });
    let for_programs = output.format() != Format::Table;
    if most > MOST_DESIGNS && !for_programs {
        request.required()?;
        return Err(refuse(request, Error::TooManyDesigns { wanted: most, most: MOST_DESIGNS }));
    }
    let wanted = request.wanted_teeth(most)?;
    let is_shifted = wanted.shifts.is_some();
    let eta0 = wanted.requirements.eta0;
    let of_one_set = wanted.requirements.series.braked().len() == 1;
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
    let found = found.map_err(|error| refuse(request, error))?;
    if found.shown() > 0 && nth > found.shown() {
        return Err(no_such_design(nth, found.shown()));
    }
    let saved = save.as_ref().map(|_| found.saved(nth)).transpose();
    let saved = saved.map_err(|error| refuse(request, error))?.flatten();
    let files = files(call, args, saved, found.shown(), found.shown())?;
    let (accepted, count) = (found.searched().accepted, found.shown());
    if for_programs {
        // Each design is made when it is written: there may be some hundred thousand of them.
        let shown = output.is_out_of_sight(call).then(|| Progress::of_writing(call));
        let told = |share: f64| shown.iter().for_each(|shown| _ = shown.at(share));
        if output.format() == Format::Json {
            let answer = found.streamed(&told)?;
            output.stream(call, &files, &mut |out| write_json(&answer, out))?;
        } else {
            let designs = found.designs().zip(1..).map(|(design, no)| {
                told(f64::from(no) / count as f64);
                design
            });
            let mut designs = Some(designs);
            output.stream(call, &files, &mut |out| {
                csv(designs.take().into_iter().flatten(), is_shifted, out)
            })?;
        }
        if !output.has_json_out() {
            let found = found.streamed(&|_| ())?;
            call.record(&mut |out| write_json(&found, out))?;
        }
    } else {
        let answer = found.answer().map_err(|error| refuse(request, error))?;
        if output.is_page() {
            let best = answer.in_full().map(|design| &design.candidate);
            let drawn = best.map(|best| drawn(best, eta0)).transpose()?;
            let sheet =
                crate::select::page::sheet_with_teeth(&answer, drawn.as_ref(), imprint::command(call));
            output.deliver_page(call, files, &answer, sheet, &page.imprint())?;
        } else {
            output.deliver_with(call, files, &answer)?;
        }
    }
    if accepted == 0 || (count == 0 && most > 0) {
        return Err(nothing_found(with_teeth_more(request).as_ref()));
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

fn no_such_design(nth: usize, designs: usize) -> Failure {
    Failure::no_such_design(format!("{nth}: there are designs 1 to {designs}"))
}

/// The file of --save with its content; none without a design that meets the criteria or that --nth names.
fn files(
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
        return Err(no_such_design(args.request.nth, designs));
    };
    let mut comments = vec![format!(
        "Design {} of epicyclic select: {}, with the direct-drive clutch chosen.",
        args.request.nth, saved.scheme
    )];
    if !saved.sizes.is_empty() {
        comments.push("Module and face width are what the load factor needs.".to_owned());
    }
    if args.request.nth > accepted {
        if args.request.nth == 1 {
            return Ok(vec![]);
        }
        let remark = "It was rejected: it does not meet every required criterion.";
        call.complain(&format!(
            "note: design {} is saved; it does not meet every required criterion",
            args.request.nth
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

fn bounds(request: &Request) -> Result<Bounds, Failure> {
    let given = &request.teeth_bounds;
    let closed =
        |option, span: Span<u32>, usual| span.closed(usual).map_err(|error| Failure::Range { option, error });
    let k = request.criteria.k(Bounds::default().ring_to_sun_ratio)?;
    let usual = options::proposed([given.sun, given.planet, given.ring])?;
    let planets = closed("--planet-count", given.planet_count, usual.planets)?;
    Ok(Bounds { planets, ring_to_sun_ratio: k, ..usual })
}

fn rating(request: &Request, duty: &Duty) -> Result<Rating, Failure> {
    let size = &request.size;
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
            .map_err(|error| refuse(request, error))?
            .zip(size.load_factor.map(|factor| factor.0)),
        face_width_ratio: size.face_width_ratio.get(),
        mesh_load_factors,
        planets: size.planets,
    })
}
