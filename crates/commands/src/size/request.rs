//! The command `size`: module, face width, planets, centre distance and bearing of each set.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::shared::gearbox_choice as analyze;
use crate::shared::lists::Quantities;
use crate::shared::options;
use crate::size::answer::{Wanted, answer, bearings, listed, listed_rollers, saved, subject};
use epicyclic_formats::Span;
use epicyclic_gears::involute::family::Aim;
use epicyclic_strength::Quantity as Of;
use epicyclic_strength::sizing::Objective;
use epicyclic_units::{Number, Quantity};
use std::path::PathBuf;
use uom::si::f64::Length;

/// Sizes of the simple sets of a gearbox that hold over the duty of its file, with the least mass or ring.
///
/// Complete over the stated modules, face widths, numbers of planets, centre distances and bearings; shifts
/// follow from the centre distance and the aim. Each design must have faultless gears, the required safeties
/// of flanks and roots by ISO 6336 and bearings that live as long as required. What the file gives of a set
/// is held: module, face_width, planets, profile_shifts, planet_bore, load_rating, ring_rim.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// The file, in YAML, or - for standard input: what strength reads, but sizes may be missing in its sets.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    file: PathBuf,

    #[command(flatten)]
    space: Options,

    /// Write the file with the best design of each set, which strength, analyze, draw and report read.
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,
}

/// The space of sizes.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Sizes")]
pub(crate) struct Options {
    /// Modules. Default: series I of ISO 54 to 20 mm.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    modules: Option<Quantities<Length>>,

    /// Face widths. Default: 10 to 80 mm in steps of 5 mm.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    face_widths: Option<Quantities<Length>>,

    /// Numbers of planets, from 1 to 8.
    #[arg(long, value_name = "RANGE", default_value = "3..6")]
    planets: Span<u32>,

    /// Step of the centre distances, which are its multiples within one module of the natural one.
    #[arg(long, value_name = "LENGTH", default_value = "0.5mm", allow_hyphen_values = true)]
    centre_distance_step: Quantity<Length>,

    /// The greatest face width over the sun's reference diameter. Default: no bound.
    #[arg(long, value_name = "RATIO", allow_negative_numbers = true)]
    width_ratio: Option<Number>,

    /// What picks the shifts, of which the sums are fixed.
    #[arg(long, value_enum, default_value_t = Aim::BalancedSliding)]
    aim: Aim,

    /// Least thickness of the tips, in modules; 0.4 is usual of case-hardened teeth.
    #[arg(long, value_name = "MODULES", default_value = "0.2", allow_negative_numbers = true)]
    tip_thickness: Number,

    /// Least rim of the planets between root circle and bearing, in modules.
    #[arg(long, value_name = "MODULES", default_value = "3", allow_negative_numbers = true)]
    planet_rim: Number,

    /// Rim of the ring outside its root circle, in modules.
    #[arg(long, value_name = "MODULES", default_value = "3.5", allow_negative_numbers = true)]
    ring_rim: Number,

    /// Bearings of the planets, as CSV with the columns designation, rolling (balls or rollers), d_mm, D_mm,
    /// B_mm, C_kN, C0_kN. Default: a table, by --bearing-type.
    #[arg(long, value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    bearings: Option<PathBuf>,

    /// Which bearings of the tables are taken: deep groove ball bearings, cylindrical roller bearings, or
    /// both.
    #[arg(long, value_enum, default_value_t = BearingType::Balls, conflicts_with_all = ["bearings", "no_bearings"])]
    bearing_type: BearingType,

    /// Bearings side by side in a planet, at most: 1 or 2; a pair is rated by ISO 281 as one double-row
    /// bearing.
    #[arg(long, value_name = "N", default_value = "2", value_parser = clap::value_parser!(u32).range(1..=2))]
    bearing_rows: u32,

    /// Seek no bearings: the planets are solid.
    #[arg(long, conflicts_with = "bearings")]
    no_bearings: bool,

    /// What is least: the mass of the gears, or the outside diameter of the rings.
    #[arg(long, value_enum, default_value_t = Objective::Mass)]
    minimise: Objective,

    /// How many designs of each set are shown.
    #[arg(long, value_name = "N", default_value = "3")]
    most: usize,
}

/// Which bearings of the tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum BearingType {
    /// Deep groove ball bearings of the series 60, 62, 63.
    Balls,
    /// Cylindrical roller bearings of the series NJ 2, NJ 22, NJ 3, NJ 23.
    Rollers,
    /// Both.
    Any,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let document = input::document(call, &args.file)?;
    let subject = subject(&document)?;
    let size = answer(&subject, &args.space.wanted(call)?, &|| call.goes_on()).map_err(refuse)?;
    let without = size.sets.iter().find(|set| set.found.is_empty());
    let files = match (&args.save, without) {
        (Some(file), None) => vec![(file.clone(), saved(&document, &size)?.into_bytes())],
        _ => vec![],
    };
    args.output.deliver_with(call, files, &size)?;
    match without {
        None => Ok(()),
        Some(set) => Err(Failure::NothingFound(Error::NoSize { set: set.set.clone() }.to_string())),
    }
}

impl Options {
    /// Requirements of the search for sizes.
    pub(crate) fn wanted(&self, call: &Call<'_>) -> Result<Wanted, Failure> {
        let usual = Wanted::default();
        let lengths = |given: &Option<Quantities<Length>>, usual: Vec<Length>| {
            given.as_ref().map_or(usual, Quantities::values)
        };
        let planets =
            self.planets.within(1..=8).map_err(|error| Failure::Range { option: "--planets", error })?;
        let bearings = match &self.bearings {
            _ if self.no_bearings => vec![],
            Some(file) => bearings(&input::text(call, file)?).map_err(refuse)?,
            None => match self.bearing_type {
                BearingType::Balls => usual.bearings,
                BearingType::Rollers => listed_rollers().to_vec(),
                BearingType::Any => [listed(), listed_rollers()].concat(),
            },
        };
        Ok(Wanted {
            modules: lengths(&self.modules, usual.modules),
            face_widths: lengths(&self.face_widths, usual.face_widths),
            planets,
            centre_distance_step: self.centre_distance_step.0,
            width_ratio: self.width_ratio.map(Number::get),
            aim: self.aim,
            tip_thickness: self.tip_thickness.get(),
            planet_rim: self.planet_rim.get(),
            ring_rim: self.ring_rim.get(),
            bearings,
            bearing_rows: self.bearing_rows,
            minimise: self.minimise,
            most: self.most,
        })
    }
}

/// Converts an error to a failure with the option that caused it.
pub(crate) fn refuse(error: Error) -> Failure {
    use epicyclic_strength::Error as E;
    let option = match &error {
        Error::Gear(gear) => options::of_teeth(gear, "--planets"),
        Error::Sizing(
            E::NotPositive { quantity, .. } | E::Negative { quantity, .. } | E::NothingToSearch { quantity },
        ) => match quantity {
            Of::Module => Some("--modules"),
            Of::FaceWidth => Some("--face-widths"),
            Of::Planets => Some("--planets"),
            Of::CentreDistanceStep | Of::CentreDistance => Some("--centre-distance-step"),
            Of::WidthRatio => Some("--width-ratio"),
            Of::LeastRim => Some("--planet-rim"),
            Of::RingRimInModules => Some("--ring-rim"),
            _ => None,
        },
        Error::Sizing(E::SpaceTooLarge { .. }) => Some("--centre-distance-step"),
        Error::Sizing(E::BearingColumn { .. } | E::BearingCell { .. } | E::NoBearings) => Some("--bearings"),
        _ => None,
    };
    match option {
        Some(option) => Failure::of_option(option, &error),
        None => analyze::refuse(error),
    }
}
