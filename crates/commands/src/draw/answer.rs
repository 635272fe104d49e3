//! A drawing: of what it is, what it shows, and which files hold it.

use crate::analyze::answer::elements::ShiftElement;
use crate::analyze::answer::records::Kind;
use crate::answer::Answer;
use crate::motor::answer::Numbers;
use crate::shared::drawability::answer::Conflict;
use crate::shared::tooth_checks::answer::ToothChecks;
use epicyclic_train::Gearbox;
use epicyclic_units::Physical as _;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Length;

/// A drawing of a gearbox or hydromotor.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Drawing {
    /// What is drawn.
    pub subject: Subject,
    /// How it is looked at.
    pub view: View,
    /// The gear that is shown, by its name in the gearbox; `null` where the structure or all gears are.
    pub gear: Option<String>,
    /// Whether widths of lines show the power through them.
    pub power: bool,
    /// Whether a scheme has both halves.
    pub whole: bool,
    /// Whether input and output of a scheme are on the same side.
    pub same_side: bool,
    /// Whether gears and planet axes of a scheme stand at heights in proportion to their pitch radii.
    pub to_scale: bool,
    /// The sheet; `null` where the gearbox cannot be drawn.
    pub sheet: Option<Sheet>,
    /// Why the gearbox cannot be drawn in this view; `null` where it is drawn.
    pub conflict: Option<Conflict>,
    /// Files that are written.
    pub files: Vec<File>,
    /// The checks of the teeth that a view of teeth shows; `null` of others.
    pub tooth_checks: Option<ToothChecks>,
}

/// What is drawn.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Subject {
    /// Where it comes from.
    pub origin: Origin,
    /// Name of the gearbox, or title of the motor's file.
    pub name: Option<String>,
    /// Planet sets of a gearbox.
    pub sets: Vec<Set>,
    /// Shift elements of a gearbox; of a structure the direct-drive clutch stands between the first links
    /// that leave room for it.
    pub shift_elements: Vec<ShiftElement>,
    /// Lobes, teeth and module of a motor.
    pub motor: Option<Numbers>,
}

/// Where what is drawn comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// A scheme of the catalogue.
    Catalogue,
    /// A structure of two sets by its name.
    Structure,
    /// The gearbox of a file.
    GearboxFile,
    /// The hydromotor of a file.
    MotorFile,
}

/// A planet set that is drawn.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Set {
    /// Its name.
    pub set: String,
    /// How it is made.
    pub kind: Kind,
    /// Basic ratio i₀: with the carrier fixed, speed of the first central gear over that of the second.
    /// `null` where it is not given, and of a set with more than two central gears.
    pub basic_ratio: Option<f64>,
}

/// How something is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum View {
    /// The kinematic scheme of a gearbox.
    Scheme,
    /// The speed diagram of a gear.
    Speeds,
    /// The lever diagram of a gearbox.
    Levers,
    /// The ratios of all gears on a logarithmic scale.
    Ladder,
    /// The efficiency of a gear over speed and torque of its input, with all losses.
    Map,
    /// Of a motor: its centrodes.
    Centrodes,
    /// Of a motor: the construction of its arcs and of the point where the rotor's arcs meet.
    Construction,
    /// Every tooth in mesh, of a motor or of the simple sets of a gearbox.
    Teeth,
    /// Of a motor: the motor in its housing with its ports.
    Motor,
    /// Of a motor: its chambers by pressure.
    Chambers,
    /// Of a motor: its dimensions and a table of wheel data.
    Dimensions,
    /// Forces on the satellites and on the bearing of a motor.
    Forces,
    /// Ports of a motor as made.
    Ports,
    /// Pressure in a chamber of a motor over its cycle.
    Pressure,
    /// Contact stress of a satellite of a motor over its cycle.
    Stress,
    /// Total efficiency of a motor over speed and pressure.
    Efficiency,
}

/// The sheet that a drawing fills.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Sheet {
    /// Title of the drawing.
    pub title: String,
    /// Its width.
    pub width_m: f64,
    /// Its height.
    pub height_m: f64,
}

/// A file that holds the drawing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct File {
    /// Where it is, as it was named.
    pub path: String,
    /// How it is written.
    pub format: FileFormat,
}

/// How a drawing is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FileFormat {
    /// An image, one unit a millimetre.
    Svg,
    /// A drawing in millimetres for CAD.
    Dxf,
    /// A page of the drawing's size.
    Pdf,
    /// An image of pixels.
    Png,
}

impl Answer for Drawing {
    const NAME: &'static str = "draw";
}

impl Subject {
    /// A gearbox; `has_sizes` unless its sets have any sizes because only the structure is drawn.
    #[must_use]
    pub fn of_gearbox(gearbox: &Gearbox, origin: Origin, has_sizes: bool) -> Self {
        let set = |set: &epicyclic_train::PlanetSet| Set {
            set: set.id().to_owned(),
            kind: Kind::of(set),
            basic_ratio: (has_sizes && set.short().is_some()).then(|| set.basic_ratio().get()),
        };
        Self {
            origin,
            name: Some(gearbox.name().to_owned()),
            sets: gearbox.sets().iter().map(set).collect(),
            shift_elements: ShiftElement::all(gearbox),
            motor: None,
        }
    }

    /// The hydromotor of a file.
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
    /// A sheet of this size in millimetres.
    #[must_use]
    pub fn of(title: &str, [width_mm, height_mm]: [f64; 2]) -> Self {
        let length = |mm| Length::from_mm(mm).si();
        Self { title: title.to_owned(), width_m: length(width_mm), height_m: length(height_mm) }
    }
}
