//! Options common to both searches for motors: requirements, numbers and size, and how designs are shown,
//! drawn and written.

use crate::answer::Answer;
use crate::desk::{Call, Content};
use crate::failure::Failure;
use crate::motor::designs::answer::{Listing, Searched};
use crate::motor::designs::table::found_and_shown;
use crate::motor::options::design::refuse;
use crate::motor::options::{Files, files};
use crate::output::{Format, OutputArgs};
use crate::shared::lists::Quantities;
use crate::table::report::AsReport;
use epicyclic_formats::Span;
use epicyclic_hydromotor::numbers::Bounds;
use epicyclic_hydromotor::search::{Limits, LobeDivisor, Requirements, Size, SizeLimits};
use epicyclic_units::{Module, Number, Physical, Quantity};
use std::path::PathBuf;
use std::str::FromStr;
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure, Ratio, Torque, Volume};

/// Designs shown in a table unless said otherwise.
const SHOWN_IN_TABLE: usize = 12;

/// Requirements of a motor, and bounds of its numbers.
#[derive(Debug, Clone, clap::Args)]
#[command(group = clap::ArgGroup::new("wanted").required(true))]
pub struct Goal {
    /// Displacement wanted: '250 cm3/rev'.
    #[arg(long, group = "wanted", allow_hyphen_values = true)]
    pub displacement: Option<Displacement>,

    /// Mean torque wanted, without losses.
    #[arg(long, group = "wanted", requires = "pressure", allow_hyphen_values = true)]
    pub torque: Option<Quantity<Torque>>,

    /// Pressure drop, high less low.
    #[arg(long, allow_hyphen_values = true)]
    pub pressure: Option<Quantity<Pressure>>,

    /// Speed of the rotor, for flow and power.
    #[arg(long, allow_hyphen_values = true)]
    pub speed: Option<Quantity<AngularVelocity>>,

    /// Modules to choose from: '2 mm, 2.5 mm'. Default: the first series of ISO 54, unless the width is
    /// given.
    #[arg(long, value_name = "MODULES", allow_hyphen_values = true)]
    pub module: Option<Quantities<Module>>,

    /// Width; alone it gives the module, with --module the displacement.
    #[arg(long, allow_hyphen_values = true)]
    pub width: Option<Quantity<Length>>,

    /// How far the displacement may lie from the wanted one, where module and width are given: 2%, or 0.02.
    #[arg(long, default_value = "2%", requires = "module", requires = "width", allow_hyphen_values = true)]
    pub tolerance: Quantity<Ratio>,

    /// Width over the stator's diameter, which then gives both module and width.
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["module", "width"], allow_hyphen_values = true)]
    pub width_over_diameter: Option<Number>,

    /// Greatest diameter of the stator's centrode.
    #[arg(long, allow_hyphen_values = true)]
    pub outer_diameter: Option<Quantity<Length>>,

    /// Greatest ripple of flow and torque, satellites sealing at the pitch points: 8%, or 0.08.
    #[arg(long, allow_hyphen_values = true)]
    pub ripple: Option<Quantity<Ratio>>,

    /// Lobes of the stator.
    #[arg(long, value_name = "LOBES", default_value = "2..10")]
    pub stator: Span<u32>,

    /// Lobes of the rotor.
    #[arg(long, value_name = "LOBES", default_value = "1..10")]
    pub rotor: Span<u32>,

    /// Teeth of the stator.
    #[arg(long, value_name = "TEETH", default_value = "1..120")]
    pub z3: Span<u32>,

    /// Teeth of a satellite.
    #[arg(long, value_name = "TEETH", default_value = "8..60")]
    pub zs: Span<u32>,

    /// Common divisor of N and n: above 1 the wheels' bearings are unloaded, 1 makes for little ripple at the
    /// pitch points.
    #[arg(long, value_enum, default_value_t = Divisor::Any)]
    pub divisor: Divisor,
}

/// What is shown of the designs, drawn and written.
#[derive(Debug, clap::Args)]
// After the options of any request, wherever these are declared.
#[command(next_display_order = 500)]
pub struct Shown {
    /// Show every design in the table, not only the first of each set of lobes and teeth.
    #[arg(long)]
    every: bool,

    /// Show at most this many designs. Default: 12 in a table, otherwise all.
    #[arg(long, value_name = "N")]
    limit: Option<usize>,

    /// Number of the design that is drawn, saved, or whose centrodes are written. Default: 1.
    #[arg(long, value_name = "N")]
    design: Option<usize>,

    /// File for the design as a motor, which `motor FILE`, `report` and `serve` read.
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    /// Angle of the rotor in the drawing. Default: 0.
    #[arg(long, allow_hyphen_values = true)]
    angle: Option<Quantity<Angle>>,

    #[command(flatten)]
    files: Files,

    #[command(flatten)]
    output: OutputArgs,
}

/// A volume a revolution, with or without `/rev`.
#[derive(Debug, Clone, Copy)]
pub struct Displacement(pub Volume);

impl FromStr for Displacement {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let volume = text.trim();
        let volume = ["/rev", "/r"].iter().find_map(|mark| volume.strip_suffix(mark)).unwrap_or(volume);
        let volume: Quantity<Volume> =
            volume.parse().map_err(|error| format!("{error}; as in 250 cm3/rev"))?;
        Ok(Self(volume.0))
    }
}

/// Requirements of the common divisor of the numbers of lobes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Divisor {
    /// Nothing.
    Any,
    /// That it is 1.
    One,
    /// That it is above 1.
    Common,
}

impl Goal {
    /// The pressure drop.
    pub(crate) fn pressure(&self) -> Option<Pressure> {
        self.pressure.map(|pressure| pressure.0)
    }

    pub(crate) fn requirements(&self) -> Result<Requirements, Failure> {
        let requirements = match (self.displacement, self.torque, self.pressure) {
            (Some(displacement), ..) => Requirements::of_displacement(displacement.0),
            (_, Some(torque), Some(pressure)) => {
                Requirements::of_torque(torque.0, pressure.0).map_err(|error| refuse(error.into()))?
            }
            _ => {
                let message = "give --displacement, or --torque and --pressure";
                return Err(Failure::missing("--displacement", message));
            }
        };
        // A displacement fixes the product of squared module and width, so modules with a width need a
        // tolerance.
        let lengths =
            |modules: &Quantities<Module>| modules.values().into_iter().map(Module::length).collect();
        let size = match (&self.module, self.width, self.width_over_diameter) {
            (Some(modules), Some(width), _) => Size::ModulesAndWidth {
                modules: lengths(modules),
                width: width.0,
                tolerance: self.tolerance.0.si(),
            },
            (Some(modules), ..) => Size::Modules(lengths(modules)),
            (_, Some(width), _) => Size::Width(width.0),
            (.., Some(part)) => Size::WidthOverDiameter(part.get()),
            _ => Size::default(),
        };
        let speed = self.speed.map(|speed| speed.0);
        Ok(Requirements { pressure_drop: self.pressure(), speed, size, ..requirements })
    }

    pub(crate) fn bounds(&self) -> Result<Bounds, Failure> {
        let usual = Bounds::default();
        Ok(Bounds {
            stator_lobes: within("--stator", self.stator, usual.stator_lobes)?,
            stator_teeth: within("--z3", self.z3, usual.stator_teeth)?,
            satellite_teeth: within("--zs", self.zs, usual.satellite_teeth)?,
        })
    }

    pub(crate) fn limits(&self) -> Result<Limits, Failure> {
        Ok(Limits {
            size: SizeLimits {
                outer_diameter: self.outer_diameter.map(|diameter| diameter.0),
                ..SizeLimits::default()
            },
            ripple: self.ripple.map(|ripple| ripple.0.si()),
            rotor_lobes: within("--rotor", self.rotor, 1..=10)?,
            divisor: match self.divisor {
                Divisor::Any => LobeDivisor::Any,
                Divisor::One => LobeDivisor::One,
                Divisor::Common => LobeDivisor::Common,
            },
            ..Limits::default()
        })
    }
}

fn within(
    option: &'static str,
    span: Span<u32>,
    usual: std::ops::RangeInclusive<u32>,
) -> Result<std::ops::RangeInclusive<u32>, Failure> {
    span.closed(usual).map_err(|error| Failure::Range { option, error })
}

/// Where the answer and drawings go.
pub(crate) struct Outlet<'a> {
    shown: &'a Shown,
    drawings: files::Wanted,
    output: OutputArgs,
}

impl Shown {
    /// Resolves the outputs; refuses options for drawings without any drawing. Called before the search so
    /// that a wrong option fails at once.
    pub(crate) fn outlet(&self) -> Result<Outlet<'_>, Failure> {
        let drawings = files::wanted(&self.files, &self.output);
        drawings.check(&self.files)?;
        if self.angle.is_some() {
            drawings.needed_by("--angle")?;
        }
        let outlet = Outlet { shown: self, drawings, output: self.output.but_for_drawings() };
        if self.design.is_some() && !outlet.has_files() {
            let message = "it is for drawings, centrodes and the file of a motor; give --svg, --dxf, --csv or --save, or an --output \
                           that ends in .svg, .dxf, .pdf or .png";
            return Err(Failure::conflict("--design", message));
        }
        Ok(outlet)
    }
}

impl Outlet<'_> {
    fn has_files(&self) -> bool {
        !self.drawings.is_empty() || self.shown.files.csv.is_some() || self.shown.save.is_some()
    }

    /// Designs to list. A table has by default the first ones of each set.
    fn listing(&self) -> Listing {
        let is_table = self.output.format() == Format::Table;
        let most = self.shown.limit.unwrap_or(if is_table { SHOWN_IN_TABLE } else { usize::MAX });
        Listing { first_of_each_set: is_table && !self.shown.every, most }
    }

    /// Writes the answer of a search, and the files of the chosen design.
    pub(crate) fn deliver<Found>(&self, call: &Call<'_>, searched: &Found) -> Result<(), Failure>
    where
        Found: Searched<Answer: Answer + AsReport>,
    {
        let files = self.files(searched)?;
        let answer = searched.answer(self.listing());
        self.output.deliver_with(call, files, &answer)?;
        let [found, listed, hidden] = Found::counts(&answer);
        if self.output.format() != Format::Table && hidden > 0 {
            call.complain(&format!("note: {}", found_and_shown(found, listed)));
        }
        Ok(())
    }

    /// The drawings, the centrodes and the file of the design that is chosen.
    fn files(&self, searched: &impl Searched) -> Result<Vec<Content>, Failure> {
        // Without a file no design has to exist: a search that finds none still gives its answer.
        if !self.has_files() {
            return Ok(vec![]);
        }
        let angle = self.shown.angle.map_or_else(Angle::default, |angle| angle.0);
        let design = self.shown.design.unwrap_or(1);
        let designed = searched.motor(design, angle).map_err(refuse)?;
        let mut written = files::content(&self.shown.files, &self.drawings, &designed, &refuse)?;
        if let Some(file) = &self.shown.save {
            written.push((file.clone(), searched.saved(design).map_err(refuse)?.into_bytes()));
        }
        Ok(written)
    }
}
