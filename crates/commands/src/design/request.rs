//! The command `design`: from speeds and power to a gearbox whose sizes hold.

use crate::answer::Warning;
use crate::design::answer::axes::Axes;
use crate::design::answer::stage_kind::StageKind;
use crate::design::answer::stages::MOST_STAGES;
use crate::design::answer::transmission::Transmission;
use crate::design::answer::ways_out::rounded;
use crate::design::answer::{Design, Wanted, answer};
use crate::design::table::stages::why_no_stages;
use crate::design::table::way_out;
use crate::design::values::{greatest, helix_angle, life, named, positive, sharing, whole};
use crate::design::{Factor, LoadStep};
use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::{NO_HEADING, OutputArgs, Reply};
use crate::page::sheet::Sheet;
use crate::progress::Progress;
use crate::report::answer::gearbox;
use crate::select::answer as select;
use crate::select::answer::duty::{Duty, Load};
use crate::select::answer::teeth::Watch;
use crate::shared::application::{Application, FULL_LOAD};
use crate::shared::basis::Basis;
use crate::shared::gearbox::one;
use crate::shared::gearbox_choice::refuse;
use crate::shared::lists::List;
use crate::shared::options;
use crate::shared::page_options::{self as imprint, PageArgs};
use crate::shared::profile_shift::offsets;
use crate::shared::selection::{Criteria, RatioOptions, Speeds, refuse_selection, requirements};
use crate::size::Request as SizeRequest;
use crate::size::request::{self as sizing, BearingsFile};
use crate::strength::answer::factors::twice;
use crate::tolerance::SHARES;
use epicyclic_formats::{Document, RangeError, Span};
use epicyclic_gears::synthesis::Bounds;
use epicyclic_selection::{Mechanism, Order, Rating, Signs};
use epicyclic_strength::factor::Symbol;
use epicyclic_strength::sizing::Objective as MinimisedSize;
use epicyclic_units::format::trimmed;
use epicyclic_units::{Number, Physical, Quantity};
use std::ops::RangeInclusive;
use std::path::PathBuf;
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Mass, Power, Ratio, Time, Torque};

/// A gearbox for one ratio, for speeds or for a list of gears, from power to sizes that hold.
///
/// --ratio, --output-speed: stages in series, whose split, teeth and sizes are chosen together. --ratios with
/// three and more, or with a reverse gear: a structure of synthesize with its teeth and sizes. --speeds, or
/// one or two --ratios beside direct drive: a scheme of select, or else a structure of synthesize.
///
/// The answer begins with the speeds asked for and reached. Schemes, tooth numbers and sizes are chosen
/// together, over a duty with the load in every gear: the fewest sets beyond usual practice, then the lightest
/// gearbox. Deviations count in classes: a tenth of --tolerance, a third, all of it; a wider class is taken
/// only if it misses less of usual practice. Every step tells the choice, among how many, the next best, and
/// the option to choose otherwise. Assumed values, such as materials and load factors, are listed;
/// --basis and --factors change them. Where nothing is left, limits to relax are listed, each with its option
/// and the gearbox found with it.
#[derive(Debug, clap::Args)]
#[command(
    after_help = include_str!("examples.txt"),
    group(clap::ArgGroup::new("asked").required(true).args(["speeds", "ratios", "ratio", "output_speed"])),
    group(clap::ArgGroup::new("load").required(true).args(["power", "torque", "output_torque"])),
)]
pub struct Args {
    #[command(flatten)]
    request: Request,

    /// A gearbox file whose strength, materials, oil, life and required safeties are taken; what it lacks is
    /// as without it.
    #[arg(long, value_name = "FILE", value_hint = clap::ValueHint::FilePath, help_heading = NO_HEADING)]
    basis: Option<PathBuf>,

    #[command(flatten)]
    bearings: BearingsFile,

    /// Write the gearbox with its sizes, its duty and the assumed values; size, strength, analyze, draw and
    /// report read it.
    #[arg(long, value_name = "FILE", help_heading = NO_HEADING)]
    save: Option<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    page: PageArgs,
}

/// Request for the design of a gearbox.
#[derive(Debug, Clone, clap::Args)]
pub struct Request {
    /// Speeds or ratios, and the mechanisms to choose among.
    #[command(flatten)]
    pub speeds: Speeds,

    /// Speed of the input.
    #[arg(long, visible_alias = "speed", value_name = "SPEED", allow_hyphen_values = true)]
    pub input: Quantity<AngularVelocity>,

    /// One ratio, input speed over output speed: planetary stages in series, whose split, teeth and sizes are
    /// chosen together. With a minus the output turns against the input: the rings turn with the slow shaft
    /// and its carrier is held, as where the housing of a travel drive turns.
    #[arg(long, value_name = "NUMBER", conflicts_with_all = OF_SPEEDS, allow_hyphen_values = true, help_heading = STAGES)]
    pub ratio: Option<Number>,

    /// Speed of the output, in place of --ratio.
    #[arg(long, value_name = "SPEED", conflicts_with_all = OF_SPEEDS, allow_hyphen_values = true, help_heading = STAGES)]
    pub output_speed: Option<Quantity<AngularVelocity>>,

    /// Torque on the output at --ratio, in place of --power; the input gives the losses of the meshes as well.
    /// --efficiency sets them.
    #[arg(long, value_name = "TORQUE", conflicts_with_all = ["speeds", "ratios"], allow_hyphen_values = true, help_heading = STAGES)]
    pub output_torque: Option<Quantity<Torque>>,

    /// Numbers of stages, from 1 to 4. Default: 1..4; with --application wind 1..3.
    #[arg(long, value_name = "RANGE", conflicts_with_all = ["speeds", "ratios"], value_parser = stages, help_heading = STAGES)]
    pub stages: Option<RangeInclusive<u32>>,

    /// Kinds of stages to choose the best from, as in simple,stepped,wolfrom.
    #[arg(long, value_name = "KINDS", conflicts_with_all = ["speeds", "ratios"], value_enum, value_delimiter = ',', default_value = "simple", help_heading = STAGES)]
    pub kind: Vec<StageKind>,

    /// Axes of input and output. Parallel: the smaller gear of the pair has 17 to 30 teeth, the larger one up to
    /// 150 and 1.1 to 5 times as many. Default: coaxial; with --application wind either.
    #[arg(long, value_name = "AXES", conflicts_with_all = ["speeds", "ratios"], value_enum, help_heading = STAGES)]
    pub axes: Option<Axes>,

    /// Only gears that have no common divisor with their mates, as is usual of wind turbines.
    #[arg(long, conflicts_with_all = ["speeds", "ratios"], help_heading = STAGES)]
    pub hunting_teeth: bool,

    /// Power into the input in every gear.
    #[arg(long, allow_hyphen_values = true)]
    pub power: Option<Quantity<Power>>,

    /// Torque on the input in every gear, in place of --power.
    #[arg(long, allow_hyphen_values = true)]
    pub torque: Option<Quantity<Torque>>,

    /// Shares of the time of the gears, the slowest first, then reverse gears. Default: equal.
    #[arg(long, value_name = "SHARES")]
    pub shares: Option<List<Quantity<Ratio>>>,

    /// Steps of the load in every gear: each its share of the time, its torque and its speed over those of the
    /// load, '10% 1 1, 90% 0.5 1.2'; without a speed that of the load. Default: full torque and speed for the whole life; lists of gears with
    /// --application automatic have half of both for 95 % of the time.
    #[arg(long, value_name = "STEPS")]
    pub spectrum: Option<List<LoadStep>>,

    /// The greatest torque of the life over that of the load, in every gear: teeth are held against it
    /// statically.
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true)]
    pub overload: Option<Quantity<Ratio>>,

    /// The greatest speed of the input without load over --input: bearings, planets and gears are judged at it.
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true)]
    pub runaway: Option<Quantity<Ratio>>,

    /// Radial force on the output. Not judged: the bearings of the output are not in the design.
    #[arg(long, value_name = "FORCE", value_parser = positive::<Force>, allow_hyphen_values = true)]
    pub side_load: Option<Quantity<Force>>,

    /// The greatest mass of the whole gearbox, by the rules of its parts. Default: no bound.
    #[arg(long, value_name = "MASS", value_parser = positive::<Mass>, allow_hyphen_values = true)]
    pub max_mass: Option<Quantity<Mass>>,

    /// The greatest length of the stages along the axis, with carriers and covers, without shafts. Default: no
    /// bound.
    #[arg(long, value_name = "LENGTH", value_parser = positive::<Length>, conflicts_with_all = ["speeds", "ratios"], allow_hyphen_values = true, help_heading = STAGES)]
    pub max_length: Option<Quantity<Length>>,

    /// The greatest backlash of the output while the input is held, such as 3arcmin: thickness allowances of all
    /// gears that keep it are in the file of --save. Default: none, teeth without allowances.
    #[arg(long, value_name = "ANGLE", value_parser = positive::<Angle>, conflicts_with_all = ["speeds", "ratios"], allow_hyphen_values = true, help_heading = STAGES)]
    pub backlash: Option<Quantity<Angle>>,

    /// Also the best gearboxes with smaller and smaller rings, each at least 5 % smaller than the one before.
    #[arg(long)]
    pub front: bool,

    /// This scheme or structure in place of the best: II-3, D.T1.B+T2.B.T1.
    #[arg(long, value_name = "NAME", value_parser = named)]
    pub scheme: Option<Mechanism>,

    /// The design with this number in place of the best: 2 for the next one.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub tooth_design: Option<u64>,

    /// Teeth of the suns. Default: 17..60; of stages in series whose ratio is 40 or more 17..30, below 3.2
    /// 17..80.
    #[arg(long, value_name = "RANGE")]
    pub sun: Option<Span<u32>>,

    /// Teeth of the planets. Default: 17..80.
    #[arg(long, value_name = "RANGE")]
    pub planet: Option<Span<u32>>,

    /// Teeth of the rings. Default: 50..140; of stages in series 50..160.
    #[arg(long, value_name = "RANGE")]
    pub ring: Option<Span<u32>>,

    /// Simple sets with profile shift: teeth of the ring less those of the sun and twice those of a planet, a
    /// range from -9 to 9; --aim and --tip-thickness decide which close. Without it only sets that need no
    /// shift get sizes.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, value_parser = offsets)]
    pub ring_offset: Option<RangeInclusive<i32>>,

    /// Helix angle of the teeth of all sets, such as 20deg, as `helix_angle` of a set in a gearbox file; modules
    /// are then normal ones, and below 0 the planets are left-handed. Default: 0deg, spur teeth; with
    /// --application automatic 20deg.
    #[arg(long, value_name = "ANGLE", value_parser = helix_angle, allow_hyphen_values = true)]
    pub helix_angle: Option<Quantity<Angle>>,

    /// Factors of both meshes by their symbols, 'K_A 1.5, K_v 1.1', in place of those of --basis; each once.
    #[arg(long, value_name = "FACTORS")]
    pub factors: Option<List<Factor>>,

    /// Required life.
    #[arg(long, value_name = "TIME", value_parser = life, allow_hyphen_values = true)]
    pub life: Option<Quantity<Time>>,

    /// Greatest deviation of a ratio, and of a speed, from the one asked for: 3%, or 0.03.
    #[arg(long, default_value = "3%", allow_hyphen_values = true, help_heading = "Ratios")]
    pub tolerance: Quantity<Ratio>,

    /// How the ratios are taken.
    #[command(flatten)]
    pub ratios: RatioOptions,

    /// Criteria of a design.
    #[command(flatten)]
    pub criteria: Criteria,

    /// Allow schemes whose output turns forward in some gears and backward in others; they are taken where no
    /// other is left. Default: refused, unless a ratio is given with a minus.
    #[arg(long, help_heading = "Criteria")]
    pub may_reverse: bool,

    /// Refuse such schemes even where a ratio has a minus.
    #[arg(long, hide = true, conflicts_with = "may_reverse")]
    pub same_direction: bool,

    /// Space of the sizes.
    #[command(flatten)]
    pub sizes: SizeRequest,

    /// Materials, load factors, oil, life and required safeties; `None` for the usual ones.
    #[arg(skip)]
    pub basis: Option<Basis>,
}

/// Heading of the options for one ratio.
const STAGES: &str = "One ratio: stages in series";

/// Options that concern several speeds.
const OF_SPEEDS: [&str; 17] = [
    "speeds",
    "ratios",
    "all_structures",
    "shares",
    "scheme",
    "tooth_design",
    "brakes",
    "signs",
    "prefer",
    "least_efficiency",
    "link_speed",
    "planet_speed",
    "clutch_slip",
    "circulation",
    "allow_crossing",
    "may_reverse",
    "same_direction",
];

/// Numbers of stages within those that are tried.
fn stages(text: &str) -> Result<RangeInclusive<u32>, String> {
    let range: Span<u32> = text.parse().map_err(|error: RangeError| error.to_string())?;
    range.within(1..=MOST_STAGES).map_err(|error| error.to_string())
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    args.page.only_of_a_page(args.output.is_page())?;
    let request = args.request(call)?;
    if request.is_of_stages() {
        let stages = request.answer_stages(&|| call.goes_on())?;
        let sheet = |own| crate::design::page::sheet_of_stages(&stages, own, &imprint::command(call));
        return deliver(call, args, &stages, stages.file.as_deref(), sheet, why_no_stages(&stages));
    }
    if request.is_of_gears() {
        let of_gears = request.answer_gears(&|| call.goes_on())?;
        return deliver_gears(call, args, &of_gears);
    }
    let shown = Progress::new(call);
    let design = request.answer(&|at| shown.at(at.share))?;
    drop(shown);
    // Where no scheme of the catalogue holds, some other structure may.
    if design.file.is_none() && request.may_be_of_gears(&design) {
        let mut of_gears = request.answer_gears(&|| call.goes_on())?;
        if of_gears.file.is_some() || of_gears.limits.lightest_kg.is_some() {
            of_gears.ways_out = design.ways_out.unwrap_or_default();
            return deliver_gears(call, args, &of_gears);
        }
    }
    let sheet = |own| crate::design::page::sheet(&design, own, &imprint::command(call));
    let way = design.ways_out.iter().flatten().next();
    let way = way.map(|way| format!("; {}", way_out(way))).unwrap_or_default();
    let why_none = format!("no gearbox that holds was found{way}");
    deliver(call, args, &design, design.file.as_deref(), sheet, why_none)
}

/// Delivers a gearbox for a list of gears.
fn deliver_gears(call: &Call<'_>, args: &Args, of_gears: &Transmission) -> Result<(), Failure> {
    let sheet = |own| crate::design::page::sheet_of_transmission(of_gears, own, &imprint::command(call));
    let why_none = if of_gears.gearboxes.is_empty() {
        // Stricter criteria than usual are the likeliest cause.
        let stricter = args.request.criteria.stricter().into_iter();
        let all = stricter.chain(["a larger --tolerance", "other --sun, --planet or --ring"]);
        let all: Vec<&str> = all.collect();
        format!("no gearbox with these gears was found; {} may give some", all.join(", "))
    } else {
        match of_gears.limits.lightest_kg.map(|mass| rounded(mass, f64::ceil)) {
            Some(mass) => format!(
                "no gearbox within --max-mass was found; --max-mass {mass}kg takes the lightest found"
            ),
            None => "no sizes that hold were found; other --modules, --planets or --max-ring may give some"
                .to_owned(),
        }
    };
    deliver(call, args, of_gears, of_gears.file.as_deref(), sheet, why_none)
}

/// Writes the answer, its page around that of the gearbox, and the gearbox file. The answer is written in any
/// case; the exit code says whether a gearbox was found.
fn deliver(
    call: &Call<'_>,
    args: &Args,
    answer: &dyn Reply,
    file: Option<&str>,
    sheet: impl FnOnce(Option<Sheet>) -> Sheet,
    why_none: String,
) -> Result<(), Failure> {
    let saved = args.save.iter().zip(file).map(|(name, text)| (name.clone(), text.as_bytes().to_vec()));
    let files = saved.collect();
    if args.output.is_page() {
        let sheet = sheet(own_page(call, file)?);
        args.output.deliver_page(call, files, answer, Ok(sheet), &args.page.imprint())?;
    } else {
        args.output.deliver_with(call, files, answer)?;
    }
    file.map(|_| ()).ok_or(Failure::NothingFound(why_none))
}

/// The page of the gearbox that was designed.
fn own_page(call: &Call<'_>, file: Option<&str>) -> Result<Option<Sheet>, Failure> {
    let Some(file) = file else { return Ok(None) };
    let document = Document::parse_one("the gearbox of the design", file.as_bytes())?;
    let subject = one(&document, &crate::shared::gearbox::Choice::default())?;
    let (report, shown) =
        gearbox::answer(&subject, Default::default(), &Default::default(), &|| call.goes_on())
            .map_err(refuse)?;
    Ok(Some(crate::report::page::sheet(&report, &shown, None, file.to_owned())?))
}

impl Args {
    /// The request with what its files hold.
    fn request(&self, call: &Call<'_>) -> Result<Request, Failure> {
        let mut request = self.request.clone();
        request.sizes.bearings = self.bearings.read(call)?;
        if let Some(file) = &self.basis {
            request.basis = Some(Basis::of(&input::document(call, file)?)?);
        }
        Ok(request)
    }
}

impl Request {
    /// Designs a gearbox. The closure receives the progress, and may end the search.
    ///
    /// # Errors
    /// [`Failure::Option`] and [`Failure::Range`] for an option that cannot be, [`Failure::Answer`] if the
    /// basis lacks what the strength needs. That no gearbox was found is an answer.
    pub fn answer(&self, watch: &Watch) -> Result<Design, Failure> {
        let mut design = answer(&self.wanted()?, watch).map_err(refuse_of)?;
        design.warnings.extend(self.unused());
        Ok(design)
    }

    /// Rings of several sets do not add up: they are no objective of a gearbox.
    pub(super) fn refuse_ring(&self) -> Result<(), Failure> {
        match self.sizes.minimise {
            Some(MinimisedSize::Ring) => Err(Failure::invalid(
                "--minimise",
                "gearboxes are chosen by a mass, mass or whole; --max-ring bounds their rings",
            )),
            _ => Ok(()),
        }
    }

    fn wanted(&self) -> Result<Wanted, Failure> {
        self.refuse_ring()?;
        let duty = self.duty();
        // Direct drive is beside ratios, and the fastest of the speeds.
        let gears = self.speeds.ratios.as_ref().map(|ratios| ratios.0.len() + 1);
        let gears = gears.or(self.speeds.speeds.as_ref().map(|of| of.values().len())).unwrap_or_default();
        let rating = Rating { mesh_load_factors: sharing()?, ..Rating::default() };
        // A ratio with a minus asks for a reversing output, which is otherwise refused by default.
        let is_reverse_asked = self.ratios.signs(&self.speeds) == Signs::AsGiven;
        let same_direction = self.same_direction || (!self.may_reverse && !is_reverse_asked);
        self.tolerance()?;
        let (tolerance, speeds) = (self.tolerance, &self.speeds);
        let requirements =
            requirements(speeds, tolerance, &self.ratios, &self.criteria, same_direction, rating)?;
        let bounds = self.bounds([17..=60, 17..=80, 50..=140])?;
        Ok(Wanted {
            selection: select::Wanted {
                requirements,
                order: Order::default(),
                space: speeds.space(),
                speeds: speeds.of_machine(),
                nth: 1,
                most: usize::MAX,
                duty,
            },
            mechanism: self.scheme,
            bounds,
            ring_offsets: self.ring_offset.clone(),
            tooth_design: self.tooth_design.map(|number| usize::try_from(number).unwrap_or(usize::MAX)),
            shares: self.shares(gears)?,
            overload: self.overload()?,
            spectrum: self.spectrum(&FULL_LOAD)?,
            limits: self.limits()?,
            is_front_asked: self.front,
            basis: self.basis()?,
            size: self.sized(),
        })
    }

    /// Speed and load of the input in every gear.
    pub(super) fn duty(&self) -> Duty {
        let power = self.power.map(|power| Load::Power(power.0));
        let load = self.torque.map(|torque| Load::Torque(torque.0)).or(power);
        Duty { input_speed: Some(self.input.0), load }
    }

    /// Space of the sizes; the whole is least unless something else is.
    pub(super) fn sized(&self) -> SizeRequest {
        let is_face_load = |factor: &Factor| factor.symbol == Symbol::FaceContact;
        let is_given = self.factors.iter().flat_map(|factors| &factors.0).any(is_face_load);
        let is_stated = self.basis.as_ref().is_some_and(|basis| basis.has_factor(Symbol::FaceContact));
        SizeRequest {
            minimise: self.sizes.minimise.or(Some(MinimisedSize::Whole)),
            widens_face_load: !is_given
                && !is_stated
                && !self.sizes.application.is_some_and(Application::corrects_flanks),
            ..self.sizes.clone()
        }
    }

    /// Shares of the time of so many gears, which are together all of it. Other numbers of shares are refused
    /// with the names of the gears, later: no sum makes them right.
    pub(super) fn shares(&self, gears: usize) -> Result<Vec<f64>, Failure> {
        let shares: Vec<f64> =
            self.shares.iter().flat_map(|shares| &shares.0).map(|share| share.0.si()).collect();
        if let Some(wrong) = shares.iter().find(|share| **share < 0.0 || share.is_nan()) {
            let message = format!("{}: a share of the time is not below 0", in_percent(*wrong));
            return Err(Failure::invalid("--shares", message));
        }
        if !shares.is_empty() && shares.len() == gears {
            are_whole("--shares", &shares)?;
        }
        Ok(shares)
    }

    /// Steps of the load in each gear, or the usual ones: share of the time, torque and speed over those of the
    /// load.
    pub(super) fn steps(&self, usual: &[[f64; 3]]) -> Result<Vec<[f64; 3]>, Failure> {
        let Some(steps) = &self.spectrum else { return Ok(usual.to_vec()) };
        let steps: Vec<[f64; 3]> = steps.0.iter().map(|step| step.0).collect();
        are_whole("--spectrum", &steps.iter().map(|[share, ..]| *share).collect::<Vec<_>>())?;
        if steps.iter().all(|step| step.contains(&0.0)) {
            let message = "no step has a share of the time, a torque and a speed above 0";
            return Err(Failure::invalid("--spectrum", message));
        }
        let greatest = steps.iter().map(|[_, torque, _]| *torque).fold(0.0, f64::max);
        if self.overload()?.is_some_and(|overload| overload < greatest) {
            let greatest = trimmed(greatest, 6);
            let message =
                format!("a step of --spectrum has more torque; write --overload {greatest} or more");
            return Err(Failure::invalid("--overload", message));
        }
        Ok(steps)
    }

    /// Allowed deviation of ratios.
    pub(super) fn tolerance(&self) -> Result<f64, Failure> {
        let tolerance = self.tolerance.0.si();
        if (0.0..1.0).contains(&tolerance) {
            return Ok(tolerance);
        }
        let percent = trimmed(tolerance, 6);
        // A number from 1 on is most likely meant in percent.
        let meant =
            if (1.0..100.0).contains(&tolerance) { format!("; write '{percent} %'") } else { String::new() };
        let message = format!("{}: allowed is 0 to below 100 %{meant}", self.tolerance);
        Err(Failure::invalid("--tolerance", message))
    }

    /// Bounds of tooth numbers and numbers of planets, with the teeth that are usual where none are given.
    pub(super) fn bounds(&self, usual: [RangeInclusive<u32>; 3]) -> Result<Bounds, Failure> {
        let planets = self.sizes.planet_counts();
        Ok(Bounds {
            planets: (*planets.start()).max(2)..=(*planets.end()).max(2),
            ring_to_sun_ratio: self.criteria.k(Bounds::default().ring_to_sun_ratio)?,
            ..self.teeth(usual)?
        })
    }

    /// Whether stages in series are asked for.
    fn is_of_stages(&self) -> bool {
        self.ratio.is_some() || self.output_speed.is_some()
    }

    /// Bounds of tooth numbers, with those that are usual where none are given.
    pub(super) fn teeth(&self, usual: [RangeInclusive<u32>; 3]) -> Result<Bounds, Failure> {
        let [sun, planet, ring] = usual.map(Span::from);
        options::proposed([self.sun.unwrap_or(sun), self.planet.unwrap_or(planet), self.ring.unwrap_or(ring)])
    }

    /// The factor of the overload.
    pub(super) fn overload(&self) -> Result<Option<f64>, Failure> {
        greatest("--overload", self.overload, "torque", 1.5)
    }

    /// A remark on values of the application that the file of the basis states otherwise.
    pub(super) fn unused(&self) -> Option<Warning> {
        let basis = self.basis.as_ref()?;
        self.sizes.application?.not_used(&basis.file(), "the file of --basis")
    }

    /// The basis with the factors, the helix angle and the life of the request.
    pub(super) fn basis(&self) -> Result<Basis, Failure> {
        let usual = self.sizes.application.map_or_else(Basis::default, Application::basis);
        let mut basis = match &self.basis {
            Some(own) => own.clone().completed_by(usual),
            None => usual,
        };
        if let Some(factors) = &self.factors {
            // A factor has several spellings, as `K_A` and `KA`, so symbols are compared, not names.
            for (place, of) in factors.0.iter().enumerate() {
                if let Some(before) = factors.0[..place].iter().find(|before| before.symbol == of.symbol) {
                    let message = twice(of.symbol, [&before.name, &of.name]);
                    return Err(Failure::invalid("--factors", message));
                }
            }
            let all: Vec<(String, f64)> = factors.0.iter().map(|of| (of.name.clone(), of.value)).collect();
            basis = basis.with_factors(&all);
        }
        basis.helix_angle =
            self.helix_angle.or_else(|| self.sizes.application.and_then(Application::helix_angle));
        if let Some(life) = &self.life {
            basis = basis.with("life", life.to_string().into());
        }
        Ok(basis)
    }
}

/// A share of the time in words.
fn in_percent(share: f64) -> String {
    format!("{} %", trimmed(100.0 * share, 6))
}

/// Refuses shares of the time that are not together all of it.
fn are_whole(option: &'static str, shares: &[f64]) -> Result<(), Failure> {
    let sum: f64 = shares.iter().sum();
    if (sum - 1.0).abs() <= SHARES {
        return Ok(());
    }
    let whole: Vec<String> = whole(shares, sum).into_iter().map(in_percent).collect();
    let message =
        format!("the shares are {} together; they must be 100 %, as '{}'", in_percent(sum), whole.join(", "));
    Err(Failure::invalid(option, message))
}

/// Converts an error to a failure with the option that caused it.
pub(super) fn refuse_of(error: Error) -> Failure {
    match &error {
        Error::NoSuchDesign { .. } => Failure::of_option("--tooth-design", &error),
        Error::Shares { .. } => Failure::of_option("--shares", &error),
        Error::Selection(of) => refuse_selection(of.clone()),
        Error::Duty(_) => Failure::of_option("--power, --torque, --input", &error),
        _ => sizing::refuse(error),
    }
}
