//! The command `size`: module, face width, planets, centre distance and bearing of each set.

use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::shared::gearbox::{Gearbox, alone};
use crate::shared::gearbox_choice as analyze;
use crate::shared::lists::Quantities;
use crate::shared::options;
use crate::size::answer::{Search, Size, answer, saved, usual_face_widths, usual_modules};
use clap::builder::{PathBufValueParser, TypedValueParser as _};
use epicyclic_formats::Span;
use epicyclic_gears::involute::family::Aim;
use epicyclic_strength::Quantity as Of;
use epicyclic_strength::sizing::Objective;
use epicyclic_strength::sizing::bearing::{Bearing, listed, listed_rollers, parse};
use epicyclic_units::{Number, Quantity};
use std::ops::{ControlFlow, RangeInclusive};
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
    request: Request,

    /// Write the file with the best design of each set, which strength, analyze, draw and report read.
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Request for sizes of the simple sets of a gearbox: the space of the search.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Sizes")]
pub struct Request {
    /// Modules. Default: series I of ISO 54 to 20 mm.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub modules: Option<Quantities<Length>>,

    /// Face widths. Default: 10 to 80 mm in steps of 5 mm.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub face_widths: Option<Quantities<Length>>,

    /// Numbers of planets, from 1 to 8.
    #[arg(long, value_name = "RANGE", default_value = "3..6")]
    pub planets: Span<u32>,

    /// Step of the centre distances, which are its multiples within one module of the natural one.
    #[arg(long, value_name = "LENGTH", default_value = "0.5mm", allow_hyphen_values = true)]
    pub centre_distance_step: Quantity<Length>,

    /// The greatest face width over the sun's reference diameter. Default: no bound.
    #[arg(long, value_name = "RATIO", allow_negative_numbers = true)]
    pub width_ratio: Option<Number>,

    /// What picks the shifts, of which the sums are fixed.
    #[arg(long, value_enum, default_value_t = Aim::BalancedSliding)]
    pub aim: Aim,

    /// Least thickness of the tips, in modules; 0.4 is usual of case-hardened teeth.
    #[arg(long, value_name = "MODULES", default_value = "0.2", allow_negative_numbers = true)]
    pub tip_thickness: Number,

    /// Least rim of the planets between root circle and bearing, in modules.
    #[arg(long, value_name = "MODULES", default_value = "3", allow_negative_numbers = true)]
    pub planet_rim: Number,

    /// Rim of the ring outside its root circle, in modules.
    #[arg(long, value_name = "MODULES", default_value = "3.5", allow_negative_numbers = true)]
    pub ring_rim: Number,

    /// Bearings of the planets, as CSV with the columns designation, rolling (balls or rollers), d_mm, D_mm,
    /// B_mm, C_kN, C0_kN. Default: a table, by --bearing-type.
    #[arg(long, value_name = "FILE", value_hint = clap::ValueHint::FilePath, value_parser = PathBufValueParser::new().map(BearingTable::File))]
    pub bearings: Option<BearingTable>,

    /// Which bearings of the tables are taken: deep groove ball bearings, cylindrical roller bearings, or
    /// both.
    #[arg(long, value_enum, default_value_t = BearingType::Balls, conflicts_with_all = ["bearings", "no_bearings"])]
    pub bearing_type: BearingType,

    /// Bearings side by side in a planet, at most: 1 or 2; a pair is rated by ISO 281 as one double-row
    /// bearing.
    #[arg(long, value_name = "N", default_value = "2", value_parser = clap::value_parser!(u32).range(1..=2))]
    pub bearing_rows: u32,

    /// Seek no bearings: the planets are solid.
    #[arg(long, conflicts_with = "bearings")]
    pub no_bearings: bool,

    /// What is least: the mass of the gears, or the outside diameter of the rings.
    #[arg(long, value_enum, default_value_t = Objective::Mass)]
    pub minimise: Objective,

    /// How many designs of each set are shown.
    #[arg(long, value_name = "N", default_value = "3")]
    pub most: usize,
}

/// Which bearings of the tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum BearingType {
    /// Deep groove ball bearings of the series 60, 62, 63.
    Balls,
    /// Cylindrical roller bearings of the series NJ 2, NJ 22, NJ 3, NJ 23.
    Rollers,
    /// Both.
    Any,
}

/// Bearings to choose from, by --bearings.
#[derive(Debug, Clone, PartialEq)]
pub enum BearingTable {
    /// File with the table, which the command reads.
    File(PathBuf),
    /// Bearings of a table.
    Bearings(Vec<Bearing>),
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let document = input::document(call, &args.file)?;
    let gearbox = alone(&document, "size", "no teeth, materials or loads")?;
    let size = args.request.with_bearings(call)?.answer(&gearbox, &|| call.goes_on())?;
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

impl Request {
    /// Sizes the sets of a gearbox. The closure is called now and then, and may end the calculation.
    ///
    /// # Errors
    /// - [`Failure::Option`] and [`Failure::Range`] for an empty space and impossible limits.
    /// - [`Failure::Answer`] if no set can be sized, or with the place of missing or invalid data in the
    ///   file.
    pub fn answer(&self, gearbox: &Gearbox, goes_on: &dyn Fn() -> ControlFlow<()>) -> Result<Size, Failure> {
        answer(gearbox, &self.search()?, goes_on).map_err(refuse)
    }

    /// Request with the bearings of its file.
    pub(crate) fn with_bearings(&self, call: &Call<'_>) -> Result<Self, Failure> {
        let mut request = self.clone();
        if let Some(BearingTable::File(file)) = &self.bearings {
            // Faults of options come before those of files.
            self.planets()?;
            let bearings = parse(&input::text(call, file)?).map_err(|error| refuse(error.into()))?;
            request.bearings = Some(BearingTable::Bearings(bearings));
        }
        Ok(request)
    }

    fn planets(&self) -> Result<RangeInclusive<u32>, Failure> {
        self.planets.within(1..=8).map_err(|error| Failure::Range { option: "--planets", error })
    }

    /// Search space with the usual values for those that are not given.
    pub(crate) fn search(&self) -> Result<Search, Failure> {
        Ok(Search {
            modules: self.modules.as_ref().map_or_else(usual_modules, Quantities::values),
            face_widths: self.face_widths.as_ref().map_or_else(usual_face_widths, Quantities::values),
            planets: self.planets()?,
            centre_distance_step: self.centre_distance_step.0,
            width_ratio: self.width_ratio.map(Number::get),
            aim: self.aim,
            tip_thickness: self.tip_thickness.get(),
            planet_rim: self.planet_rim.get(),
            ring_rim: self.ring_rim.get(),
            bearings: match (&self.bearings, self.bearing_type) {
                _ if self.no_bearings => vec![],
                (Some(BearingTable::Bearings(bearings)), _) => bearings.clone(),
                (Some(BearingTable::File(file)), _) => {
                    let message = format!("{}: only the command reads a file of bearings", file.display());
                    return Err(Failure::invalid("--bearings", message));
                }
                (None, BearingType::Balls) => listed().to_vec(),
                (None, BearingType::Rollers) => listed_rollers().to_vec(),
                (None, BearingType::Any) => [listed(), listed_rollers()].concat(),
            },
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
