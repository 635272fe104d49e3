//! Drawing: its subject, its view, and the files that hold it.

use crate::analyze::answer::elements::ShiftElement;
use crate::analyze::answer::records::Kind;
use crate::answer::Answer;
use crate::motor::answer::Numbers;
use crate::shared::drawability::answer::Conflict;
use crate::shared::gearbox::{Gearbox, Origin};
use crate::shared::judgement::answer::Judgement;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::shared::toothed::{AssumedRadius, WithoutTeeth};
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Length;

/// Drawing of a gearbox or hydromotor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Drawing {
    /// Gearbox or motor that is drawn.
    pub subject: Subject,
    /// View of the drawing.
    pub view: View,
    /// Name of the gear that is shown; null if the structure or all gears are shown.
    pub gear: Option<String>,
    /// Whether line widths show the power through the parts.
    pub power: bool,
    /// Whether a scheme shows both halves.
    pub whole: bool,
    /// Whether input and output of a scheme are on the same side.
    pub same_side: bool,
    /// Whether the heights of gears and planet axes in a scheme are proportional to their pitch radii.
    pub to_scale: bool,
    /// Title and size of the sheet; null if the gearbox cannot be drawn.
    pub sheet: Option<Sheet>,
    /// Reason why the gearbox cannot be drawn in this view; null if it is drawn.
    pub conflict: Option<Conflict>,
    /// Files that are written.
    pub files: Vec<File>,
    /// Judgement of the gearbox or motor by rules of practice.
    pub judgement: Judgement,
    /// Tooth checks in a view of teeth; null in other views.
    pub tooth_checks: Option<ToothChecks>,
    /// Sets that a view of teeth leaves out; empty in other views.
    pub left_out: Vec<WithoutTeeth>,
    /// Planets whose radius a view of teeth assumes; empty in other views.
    pub assumed_radii: Vec<AssumedRadius>,
}

/// Gearbox or motor that is drawn.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Subject {
    /// Origin of the gearbox or motor.
    pub origin: Origin,
    /// Name of the gearbox, or title of the motor's file; null if none exists.
    pub name: Option<String>,
    /// Planetary sets of a gearbox; empty for a motor.
    pub sets: Vec<Set>,
    /// Shift elements of a gearbox. In a structure the direct-drive clutch connects the first links with room
    /// for it.
    pub shift_elements: Vec<ShiftElement>,
    /// Lobes, teeth and module of a motor; null for a gearbox.
    pub motor: Option<Numbers>,
}

/// Planetary set that is drawn.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Set {
    /// Name of the set.
    pub set: String,
    /// Kind of the set.
    pub kind: Kind,
    /// Basic ratio i₀: with the carrier fixed, speed of the first central gear over that of the second. Null
    /// if it is not given, or with more than two central gears.
    pub basic_ratio: Option<f64>,
}

/// Views of a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "snake_case")]
pub enum View {
    /// The kinematic scheme.
    Scheme,
    /// The speed diagram of a gear (Kutzbach).
    Speeds,
    /// The lever diagram: each set as a lever, with the speeds of a gear.
    Levers,
    /// The ratios of all gears on a logarithmic scale.
    Ladder,
    /// The efficiency of a gear over --speeds and --torques of its input, as `losses` calculates it.
    Map,
    /// Of a motor: its centrodes, and how the arcs are constructed.
    Centrodes,
    /// Of a motor: half a lobe with the construction of its arcs, (1)-(8).
    Construction,
    /// Every tooth in mesh: of a motor, and of the sets and pairs of a gearbox with cylindrical gears, each
    /// as its tool leaves it; in DXF as arcs and splines, a layer for each gear.
    Teeth,
    /// Of a motor: the motor in its housing with its ports.
    Motor,
    /// Of a motor: its chambers coloured by pressure.
    Chambers,
    /// Of a motor: its dimensions and a table of wheel data, for a drawing office.
    Dimensions,
    /// Of a motor: forces on its satellites and on the rotor's bearing.
    Forces,
    /// Of a motor: its ports as made.
    Ports,
    /// Of a motor: pressure in a chamber over its cycle.
    Pressure,
    /// Of a motor: contact stress of a satellite over its cycle.
    Stress,
    /// Of a motor: total efficiency over speed and pressure.
    Efficiency,
}

/// Title and size of a drawing's sheet.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Sheet {
    /// Title of the drawing.
    pub title: String,
    /// Width of the sheet in m.
    pub width_m: f64,
    /// Height of the sheet in m.
    pub height_m: f64,
}

/// File that holds the drawing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct File {
    /// Path of the file as it was given.
    pub path: String,
    /// Format of the file.
    pub format: FileFormat,
}

/// File formats of a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FileFormat {
    /// SVG image, one unit per millimetre.
    Svg,
    /// DXF drawing in millimetres for CAD.
    Dxf,
    /// PDF page of the drawing's size.
    Pdf,
    /// PNG image.
    Png,
}

impl Answer for Drawing {
    const NAME: &'static str = "draw";
}

impl Subject {
    /// Subject for a gearbox. One without sizes is drawn as a structure, and its sets have no ratios.
    #[must_use]
    pub fn of_gearbox(gearbox: &Gearbox) -> Self {
        let set = |set: &epicyclic_train::PlanetSet| Set {
            set: set.id().to_owned(),
            kind: Kind::of(set),
            basic_ratio: (gearbox.is_sized && set.short().is_some()).then(|| set.basic_ratio().get()),
        };
        Self {
            origin: gearbox.origin,
            name: Some(gearbox.train.name().to_owned()),
            sets: gearbox.train.sets().iter().map(set).collect(),
            shift_elements: ShiftElement::all(&gearbox.train),
            motor: None,
        }
    }

    /// Subject for the hydromotor of a file.
    #[must_use]
    pub fn of_motor(title: Option<String>, motor: &epicyclic_hydromotor::Motor) -> Self {
        Self {
            origin: Origin::MotorFile,
            name: title,
            sets: vec![],
            shift_elements: vec![],
            motor: Some(Numbers::of(motor.numbers(), motor.module())),
        }
    }
}

impl Sheet {
    /// Sheet of this size in millimetres.
    #[must_use]
    pub fn of(title: &str, [width_mm, height_mm]: [f64; 2]) -> Self {
        let length = |mm| Length::from_mm(mm).si();
        Self { title: title.to_owned(), width_m: length(width_mm), height_m: length(height_mm) }
    }
}
