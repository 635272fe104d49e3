//! The options that describe a motor, its teeth, its drawings and curves.

pub(crate) mod design;
pub(crate) mod files;
pub mod made;
pub mod steps;

use crate::failure::Failure;
use crate::motor::forms::answer::Crest;
use crate::motor::table::View;
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_units::{Module, Number, Physical as _, Quantity};
use made::Made;
use std::path::PathBuf;
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure, Ratio};

/// Request for a motor by its numbers.
#[derive(Debug, Clone, clap::Args)]
#[command(group = clap::ArgGroup::new("place").multiple(true))]
pub struct Request {
    /// Lobes of the stator, N.
    #[arg(long, value_name = "N", requires_all = ["rotor", "z3", "module"])]
    pub stator: Option<u32>,

    /// Lobes of the rotor, n: 1 to 3 fewer.
    #[arg(long, value_name = "N", requires = "stator")]
    pub rotor: Option<u32>,

    /// Teeth of the stator, Z₃: a whole number for each lobe.
    #[arg(long, value_name = "TEETH", requires = "stator")]
    pub z3: Option<u32>,

    /// Teeth of the rotor, Z₁; they follow from the others and are checked where given.
    #[arg(long, value_name = "TEETH")]
    pub z1: Option<u32>,

    /// Teeth of a satellite, Z_s: fewer than (Z₃ − Z₁)/2. Without them all satellites are listed, each with
    /// a motor.
    #[arg(long, value_name = "TEETH")]
    pub zs: Option<u32>,

    /// Module of the teeth.
    #[arg(long, requires = "stator", allow_hyphen_values = true)]
    pub module: Option<Quantity<Module>>,

    /// Distance l of the centres of the stator's arcs at the troughs from the axis. Default: the middle of
    /// the family.
    #[arg(long, group = "place", allow_hyphen_values = true)]
    pub l: Option<Quantity<Length>>,

    /// Instead of --l the distance a of the centres of the arcs at the crests. Together with --l:
    /// --construction of arcs that need not close.
    #[arg(long, group = "place", allow_hyphen_values = true)]
    pub a: Option<Quantity<Length>>,

    /// Instead of --l the part of the family, from 0 (arcs at the troughs vanish) to 1, even in 1/l.
    #[arg(long, value_name = "NUMBER", group = "place", conflicts_with_all = ["l", "a"], allow_hyphen_values = true)]
    pub part: Option<Number>,

    /// A rotor by the cosine law, and the stator conjugate to it: one motor, no family.
    #[arg(long, group = "place", conflicts_with_all = ["l", "a", "part"])]
    pub cosine: bool,

    /// Relative amplitude ε₂ of a second harmonic of the cosine law.
    #[arg(long, value_name = "NUMBER", requires = "cosine", allow_hyphen_values = true)]
    pub second_harmonic: Option<Number>,

    /// The construction of the arcs in place of the motor: system (1), how far the rotor is from closing,
    /// and formulas (2)-(8). Drawings show it.
    #[arg(long)]
    pub construction: bool,

    /// Width of the wheels, for displacement, torque and forces.
    #[arg(long, allow_hyphen_values = true)]
    pub width: Option<Quantity<Length>>,

    /// Pressure drop, high less low, for torque and forces.
    #[arg(long, requires = "width", allow_hyphen_values = true)]
    pub pressure: Option<Quantity<Pressure>>,

    /// Speed of the rotor, for flow and power.
    #[arg(long, requires = "width", allow_hyphen_values = true)]
    pub speed: Option<Quantity<AngularVelocity>>,

    /// Angle of the rotor from where one of its crests faces one of the stator's, for chambers, satellites
    /// and drawings. Default: that of the file, else 0 deg.
    #[arg(long, allow_hyphen_values = true)]
    pub angle: Option<Quantity<Angle>>,

    /// Form of the teeth.
    #[command(flatten)]
    pub teeth: Teeth,

    /// Material, oil, gaps, friction, ports.
    #[command(flatten)]
    pub made: Made,
}

/// Form of the teeth; lengths in modules.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Teeth, lengths in modules")]
pub struct Teeth {
    /// Pressure angle of the satellites.
    #[arg(long, default_value = "25 deg", allow_hyphen_values = true)]
    pub pressure_angle: Quantity<Angle>,

    /// Addendum h_a*.
    #[arg(long, value_name = "NUMBER", default_value = "0.85", allow_hyphen_values = true)]
    pub addendum: Number,

    /// Clearance c* of tips over roots.
    #[arg(long, value_name = "NUMBER", default_value = "0.25", allow_hyphen_values = true)]
    pub clearance: Number,

    /// Profile shift x of the satellites; the wheels have −x.
    #[arg(long, value_name = "NUMBER", default_value = "0.2", allow_hyphen_values = true)]
    pub shift: Number,

    /// Backlash j* along the pitch curves.
    #[arg(long, value_name = "NUMBER", default_value = "0.04", allow_hyphen_values = true)]
    pub backlash: Number,

    /// Radius ρ* of the rounded tips of the cutters.
    #[arg(long, value_name = "NUMBER", default_value = "0.1", allow_hyphen_values = true)]
    pub fillet: Number,

    /// What lies in the middle of the stator's crests: space, tooth.
    #[arg(long, value_name = "CREST", default_value = "space")]
    pub crest: Crest,
}

/// Requirements of satellites that seal at the flanks.
#[derive(Debug, Clone, clap::Args)]
pub struct FlankLimits {
    /// Greatest ripple of flow and torque, satellites sealing at the flanks: 8%, or 0.08.
    #[arg(long, value_name = "RIPPLE", allow_hyphen_values = true)]
    pub flank_ripple: Option<Quantity<Ratio>>,

    /// Least torque over the mean, satellites sealing at the flanks: 94%, or 0.94.
    #[arg(long, value_name = "PART", allow_hyphen_values = true)]
    pub least_torque: Option<Quantity<Ratio>>,
}

impl FlankLimits {
    /// Greatest ripple and least torque over the mean, if given.
    pub(crate) fn shares(&self) -> [Option<f64>; 2] {
        [self.flank_ripple, self.least_torque].map(|share| share.map(|share| share.0.si()))
    }
}

/// Drawings and curves.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Drawings and curves, each file written whole or not at all")]
pub(crate) struct Files {
    /// What is drawn into --svg, --dxf, or an --output that ends in .svg, .dxf, .pdf or .png. Default: the
    /// whole motor.
    #[arg(long, value_enum)]
    pub(crate) view: Option<View>,

    /// Pixels to an inch of a PNG image, 20 to 2400; an image has at most 100 million pixels. Default: 300,
    /// or fewer where the image would have more.
    #[arg(long, value_name = "NUMBER", requires = "output")]
    pub(crate) dpi: Option<Number>,

    /// File for the drawing as an SVG image, one unit a millimetre.
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,

    /// File for the drawing as DXF in millimetres, for CAD.
    #[arg(long, value_name = "FILE")]
    pub(crate) dxf: Option<PathBuf>,

    /// File for points of the centrodes with direction and curvature, in millimetres and degrees.
    #[arg(long, value_name = "FILE")]
    pub(crate) csv: Option<PathBuf>,

    /// Points of each half-lobe in that file.
    #[arg(long, value_name = "NUMBER", requires = "csv", default_value_t = 100)]
    pub(crate) points: u32,
}

impl Request {
    /// Options of a closed motor that say nothing of its arcs or teeth, and whether each is given.
    pub(crate) fn beyond_the_arcs(&self) -> impl Iterator<Item = (&'static str, bool)> {
        let own = [("--width", self.width.is_some()), ("--angle", self.angle.is_some())];
        own.into_iter().chain(self.made.given())
    }
}

impl Teeth {
    /// Options of the teeth, and whether each differs from its default.
    pub(crate) fn given(&self) -> [(&'static str, bool); 7] {
        let (given, usual) = (design::form(self), ToothForm::default());
        [
            ("--pressure-angle", given.pressure_angle != usual.pressure_angle),
            ("--addendum", given.addendum != usual.addendum),
            ("--clearance", given.clearance != usual.clearance),
            ("--shift", given.shift != usual.shift),
            ("--backlash", given.backlash != usual.backlash),
            ("--fillet", given.fillet != usual.fillet),
            ("--crest", given.crest != usual.crest),
        ]
    }
}

/// Refuses the first option that is given in vain.
pub(crate) fn refuse_given(
    options: impl IntoIterator<Item = (&'static str, bool)>,
    message: &str,
) -> Result<(), Failure> {
    match options.into_iter().find(|(_, is_given)| *is_given) {
        Some((option, _)) => Err(Failure::conflict(option, message)),
        None => Ok(()),
    }
}
