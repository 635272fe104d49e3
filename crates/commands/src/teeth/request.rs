//! The command `teeth`: every set of tooth numbers for a ratio.

use crate::desk::Call;
use crate::failure::Failure;
use crate::output::{Format, OutputArgs};
use crate::progress::Progress;
use crate::shared::options;
use crate::table::report::AsReport;
use crate::teeth::answer::arranged::{self, ArrangedSets};
use crate::teeth::answer::double_planet::{self, DoublePlanetTeeth};
use crate::teeth::answer::shifted::{self, ShiftedTeeth};
use crate::teeth::answer::{self as answers, IN_A_SECOND, SetList, Stages, Teeth, stages};
use crate::teeth::options::{Kind, Request};
use epicyclic_formats::Span;
use epicyclic_formats::gearbox::{WrittenSize, written_with_sizes};
use epicyclic_gears::Error;
use epicyclic_gears::arrangement::{Arrangement, ArrangementBounds};
use epicyclic_gears::involute::set::Limits;
use epicyclic_gears::quantity::SimpleGear;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::synthesis::{Bounds, Placement};
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use uom::si::f64::Length;

/// Sets shown in a table unless said otherwise.
const SHOWN_IN_TABLE: usize = 20;

/// Range of `--k` unless given.
const USUAL_K: &str = "1.3..10";

/// Range of `--planets` unless given.
const USUAL_PLANETS: &str = "3..8";

/// Every set of tooth numbers of a gear set of one kind for a ratio.
///
/// The tooth numbers of a set fit together: sun, planets and ring share one centre distance, the planets
/// clear each other and assemble. Of a double-planet set the ratio leaves the planets open: each pair of sun
/// and ring stands once, with one choice of planets. With --ring-offset the ring may depart from the rule of
/// equal centre distances, and profile shifts of all gears make up for it; with stepped planets and in
/// Ravigneaux sets it is the difference of two doubled centre distances in modules. The most exact sets come first. Ranges
/// include both ends and may be open: 12..40, 17.., ..=200, 20.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    #[command(flatten)]
    request: Request,

    /// Write the most exact set as a gearbox file without losses that analyze, draw and report read.
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    /// With --save: the set with this number in place of the most exact; the checks told are of its teeth.
    #[arg(long, value_name = "N", requires = "save", default_value = "1")]
    nth: usize,

    #[command(flatten)]
    output: OutputArgs,
}

impl Request {
    /// Finds the simple sets without profile shift. The closure `done` receives the finished part of the
    /// search, from 0 to 1, and may end it.
    ///
    /// # Errors
    /// [`Failure::Range`], [`Failure::Option`] for impossible bounds; [`Failure::NoToothNumbers`].
    pub fn answer(&self, done: impl FnMut(f64) -> ControlFlow<()>) -> Result<Teeth, Failure> {
        let bounds = self.bounds()?;
        answers::answer(self, &bounds, done).map_err(|error| refuse_one(error, self, &bounds))
    }

    /// Finds the double-planet sets; `done` as in [`Self::answer`].
    ///
    /// # Errors
    /// Those of [`Self::answer`].
    pub fn answer_double_planet(
        &self,
        done: impl FnMut(f64) -> ControlFlow<()>,
    ) -> Result<DoublePlanetTeeth, Failure> {
        double_planet::answer(self, &self.bounds()?, done).map_err(refuse_answer)
    }

    /// Finds the simple sets with profile shift; `done` as in [`Self::answer`].
    ///
    /// # Errors
    /// Those of [`Self::answer`]; [`Failure::Option`] without ring offsets.
    pub fn answer_shifted(&self, done: impl FnMut(f64) -> ControlFlow<()>) -> Result<ShiftedTeeth, Failure> {
        let shifts = self.shifts.wanted();
        let shifts =
            shifts.ok_or_else(|| Failure::missing("--ring-offset", "give the offsets of the ring"))?;
        shifted::answer(self, &self.bounds()?, &shifts, done).map_err(refuse_answer)
    }

    /// Finds the sets of an arrangement of gears; `done` as in [`Self::answer`].
    ///
    /// # Errors
    /// Those of [`Self::answer`]; [`Failure::Option`] for options of other kinds.
    pub fn answer_arranged(&self, done: impl FnMut(f64) -> ControlFlow<()>) -> Result<ArrangedSets, Failure> {
        let arrangement = self.arrangement();
        let arrangement = arrangement.ok_or_else(|| {
            Failure::missing("--kind", "give a kind of set with planets of two gears, or pair")
        })?;
        arranged::answer(self, &self.arrangement_bounds(arrangement)?, done).map_err(refuse_answer)
    }

    /// Number of combinations of teeth and planets to search.
    ///
    /// # Errors
    /// [`Failure::Range`], [`Failure::Option`] for impossible bounds.
    pub fn combinations(&self) -> Result<u64, Failure> {
        let space = match self.arrangement() {
            Some(arrangement) => self.arrangement_bounds(arrangement)?.space(),
            None => self.bounds()?.space(self.is_double()),
        };
        space.map_err(refuse)
    }

    /// Refuses options of other kinds of sets.
    fn check_kind(&self) -> Result<(), Failure> {
        let simple = self.arrangement().is_none();
        let refuse = |option, holds: bool, of: &str| {
            let message = || format!("only {of} have it: leave it out, or choose another --kind");
            if holds { Err(Failure::conflict(option, message())) } else { Ok(()) }
        };
        let others = "sets with a stepped planet, Ravigneaux sets and pairs";
        refuse("--gear", simple && !self.gear.is_empty(), others)?;
        refuse(
            "--angles",
            simple && !self.angles.is_empty(),
            "sets with a stepped planet and Ravigneaux sets",
        )?;
        let steps = "sets with a stepped planet";
        refuse("--module-ratio", simple && self.module_ratio != [1.into()], steps)?;
        refuse(
            "--ring-offset",
            self.is_double() && self.shifts.ring_offset.is_some(),
            "sets of other kinds than double",
        )?;
        let is_pair = self.kind == Kind::Pair;
        refuse("--ring-offset", is_pair && self.shifts.ring_offset.is_some(), "sets with planets")?;
        refuse("--angles", is_pair && !self.angles.is_empty(), "sets with planets")?;
        refuse("--planets", is_pair && self.planets.to_string() != USUAL_PLANETS, "sets with planets")?;
        refuse("--spacing", is_pair && self.spacing != Placement::Equal, "sets with planets")?;
        refuse("--k", !simple && self.k.to_string() != USUAL_K, "simple and double-planet sets")
    }

    fn arrangement_bounds(&self, arrangement: Arrangement) -> Result<ArrangementBounds, Failure> {
        let bounds = self.bounds()?;
        let usual = ArrangementBounds::of(arrangement, &bounds);
        let gears = arrangement.gears();
        let mut teeth = usual.teeth.clone();
        for (letter, span) in &self.gear {
            let place = gears.iter().position(|gear| gear.symbol == *letter).ok_or_else(|| {
                let all: Vec<String> = gears.iter().map(|gear| format!("{} ({gear})", gear.symbol)).collect();
                Failure::invalid(
                    "--gear",
                    format!("{letter} is no gear; those of this kind, {arrangement}, are {}", all.join(", ")),
                )
            })?;
            let range = options::of_wheel("--gear", *span, teeth[place].clone())?;
            let is_ring = gears[place].role == SimpleGear::Ring;
            let least =
                if self.no_undercut && !is_ring { bounds.rack.least_teeth_without_undercut() } else { 1 };
            teeth[place] = (*range.start()).max(least)..=*range.end();
        }
        let shifts = self.shifts.wanted();
        let limits = shifts.as_ref().map_or_else(Limits::default, |shifts| shifts.limits(&bounds));
        Ok(ArrangementBounds {
            teeth,
            module_ratios: self.module_ratio.iter().copied().collect::<BTreeSet<_>>().into_iter().collect(),
            offsets: self.shifts.ring_offset.clone().unwrap_or(0..=0),
            aim: self.shifts.aim,
            limits,
            angles: self.angles.iter().map(|angle| angle.0).collect(),
            no_undercut: self.no_undercut,
            ..usual
        })
    }

    fn bounds(&self) -> Result<Bounds, Failure> {
        self.check_kind()?;
        let usual = Bounds::default();
        let rack = BasicRack {
            addendum: self.addendum.get(),
            pressure_angle: self.pressure_angle.0,
            ..BasicRack::default()
        };
        rack.check().map_err(refuse)?;
        let least = if self.no_undercut { rack.least_teeth_without_undercut() } else { 1 };
        let external = |option, span: Span<u32>, usual: RangeInclusive<u32>| {
            let (from, most) = options::of_wheel(option, span, usual)?.into_inner();
            // Without undercut the range of teeth starts at the smallest gear that has none.
            let from = from.max(least);
            if from > most { Err(Failure::AllUndercut { option, most, least }) } else { Ok(from..=most) }
        };
        Ok(Bounds {
            sun: external("--sun", self.sun, usual.sun)?,
            planet: external("--planet", self.planet, usual.planet)?,
            ring: options::of_wheel("--ring", self.ring, usual.ring)?,
            planets: closed("--planets", self.planets, usual.planets)?,
            ring_to_sun_ratio: closed("--k", self.k, usual.ring_to_sun_ratio)?,
            rack,
            tip_gap: self.tip_gap.get(),
            placement: self.spacing,
        })
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let limit = args.request.limit.unwrap_or(match args.output.format() {
        Format::Table => SHOWN_IN_TABLE,
        _ => usize::MAX,
    });
    // The set to save may lie beyond the sets shown.
    let most = if args.save.is_some() { limit.max(args.nth) } else { limit };
    let request = &Request { limit: Some(most), checked: args.nth, ..args.request.clone() };
    let progress = Progress::new(call);
    let parts = request.combinations()? as f64;
    let gears = if request.arrangement().is_some() {
        "gears that leave one free"
    } else if request.is_double() {
        "sun, ring and pairs of planets"
    } else {
        "sun, planet and number of planets"
    };
    progress.size(parts, IN_A_SECOND, || format!("{parts:.1e} combinations of {gears}"));
    let done = |share| progress.at(share);
    if request.arrangement().is_some() {
        let found = request.answer_arranged(done)?;
        deliver(call, args, limit, progress, found)
    } else if request.shifts.ring_offset.is_some() {
        let found = request.answer_shifted(done)?;
        deliver(call, args, limit, progress, found)
    } else if request.is_double() {
        let found = request.answer_double_planet(done)?;
        deliver(call, args, limit, progress, found)
    } else {
        let found = request.answer(done)?;
        deliver(call, args, limit, progress, found)
    }
}

/// Writes the first sets of an answer, and the file of --save.
fn deliver(
    call: &Call<'_>,
    args: &Args,
    limit: usize,
    progress: Progress<'_>,
    mut answer: impl SetList + AsReport,
) -> Result<(), Failure> {
    // Removes the progress line before the answer is written to the same terminal.
    drop(progress);
    let files = match &args.save {
        Some(file) => vec![(file.clone(), saved(args, &answer)?)],
        None => vec![],
    };
    answer.truncate(limit);
    args.output.deliver_with(call, files, &answer)?;
    let (found, shown) = answer.counts();
    // A list for programs does not say itself that it is not whole.
    if args.output.format() != Format::Table && (shown as u64) < found {
        call.complain(&format!("note: {}", crate::teeth::table::count(found, shown)));
    }
    Ok(())
}

/// Content of the file of --save.
fn saved(args: &Args, answer: &impl SetList) -> Result<Vec<u8>, Failure> {
    let Args { nth, request, .. } = args;
    let (found, _) = answer.counts();
    let gearbox = answer
        .gearbox(*nth, request)?
        .ok_or_else(|| Failure::no_such_design(format!("{nth}: there are sets 1 to {found}")))?;
    let mut comment = vec![format!(
        "Set {nth} of {found} found by epicyclic teeth for the ratio {} ({}), without losses.",
        request.ratio.get(),
        match request.arrangement() {
            Some(arrangement) => request.arranged_mode(arrangement).map(|mode| mode.to_string()),
            None => request.simple_mode().map(|mode| mode.to_string()),
        }?
    )];
    let modules: Vec<Length> = answer.module_ratios(*nth).into_iter().map(Length::from_mm).collect();
    if !modules.is_empty() {
        comment.push(
            "Only the ratio of the modules is known: that of the first step stands as 1 mm.".to_owned(),
        );
    }
    let sizes = [WrittenSize { modules, face_width: None }];
    let text =
        written_with_sizes(&gearbox, &sizes, &comment).map_err(|error| Failure::Format(error.to_string()))?;
    Ok(text.into_bytes())
}

/// A ratio that one set has not may be that of several in series.
fn refuse_one(error: crate::error::Error, request: &Request, bounds: &Bounds) -> Failure {
    let crate::error::Error::Gear(error @ Error::NoToothNumbers { .. }) = error else {
        return refuse_answer(error);
    };
    let hint = match stages(request, bounds) {
        Ok(Some(Stages { sets, ratio, others })) => {
            let each = trimmed(ratio, 4);
            let others = match (others, sets) {
                (None, _) => String::new(),
                (Some(others), 2) => format!(", the other one in mode {others}"),
                (Some(others), _) => format!(", the others in mode {others}"),
            };
            format!("; {sets} sets in series have it, each with a ratio of about {each}{others}")
        }
        _ => String::new(),
    };
    Failure::NoToothNumbers { error, hint }
}

fn refuse_answer(error: crate::error::Error) -> Failure {
    match error {
        crate::error::Error::Gear(error) => refuse(error),
        error @ crate::error::Error::Mode { .. } => Failure::of_option("--mode", &error),
        error @ crate::error::Error::TooMany { found, most } => Failure::named(
            error.name(),
            "--limit",
            format!(
                "{found} sets of tooth numbers are within the tolerance and at most {most} are written: narrow --tolerance, --k \
                 or the ranges of teeth, or ask for the most exact with --limit {most}"
            ),
        ),
        error => error.into(),
    }
}

fn refuse(error: Error) -> Failure {
    match options::of_teeth(&error, "--planets") {
        Some(option) => Failure::of_option(option, &error),
        None => error.into(),
    }
}

fn closed<T: epicyclic_formats::range::End>(
    option: &'static str,
    span: Span<T>,
    usual: RangeInclusive<T>,
) -> Result<RangeInclusive<T>, Failure> {
    span.closed(usual).map_err(|error| Failure::Range { option, error })
}
