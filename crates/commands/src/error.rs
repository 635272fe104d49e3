//! Errors of the answers: questions that are refused or have no answer.

use crate::refusal::{DutyProblem, Given, LoadQuantity, SizeName, SizeProblem};

/// A question without an answer.
#[derive(Debug, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A number of an answer that no double holds.
    #[error("not a finite number: {figure}; a given number is too small or too large for it")]
    NotFinite {
        /// Key of the number in the answer.
        figure: String,
    },
    /// An answer that cannot be put in its format.
    #[error("the answer cannot be written as text: {0}")]
    #[strum(serialize = "not-writable")]
    Json(String),
    /// A mode of another kind of set.
    #[error("{letters} is no mode of a {kind}: write one of {modes}")]
    Mode {
        /// The mode given.
        letters: String,
        /// Kind of the sets.
        kind: String,
        /// Modes of the kind.
        modes: String,
    },
    /// More things than are written at once.
    #[error("{found} are found and at most {most} are written")]
    TooMany {
        /// Number of things found.
        found: u64,
        /// Largest number that can be written.
        most: usize,
    },
    /// A fault in a file, with its line and column.
    #[error(transparent)]
    Document(#[from] epicyclic_formats::Error),
    /// A refusal at the place in a file that it is about.
    #[error("{at}")]
    Placed {
        /// The refusal with file, line and column.
        at: Box<epicyclic_formats::Error>,
        /// The refusal itself.
        why: Box<Error>,
    },
    /// An error of the design of a drive.
    #[error(transparent)]
    Drive(Box<epicyclic_dynamics::Error>),
    /// An error of the hydromotor calculation.
    #[error(transparent)]
    Motor(#[from] epicyclic_hydromotor::Error),
    /// A search that no hydromotor passes.
    #[error("no motor within the limits: {0}")]
    NoMotor(Box<crate::motor::search::answer::funnel::Funnel>),
    /// A search with free tooth forms in which no motor passes with any.
    #[error("no motor within the limits: {0}")]
    #[strum(serialize = "no-motor")]
    NoMotorForm(Box<crate::motor::forms::answer::funnel::Funnel>),
    /// A number of a design that a search has not found.
    #[error("{design}: there are designs 1 to {designs}")]
    NoSuchDesign {
        /// The number.
        design: usize,
        /// Number of designs found.
        designs: usize,
    },
    /// A pressure drop of a hydromotor that is not above 0.
    #[error("it is high less low pressure, so above 0; the motor runs counter-clockwise")]
    PressureDrop,
    /// A speed of a hydromotor's rotor that is not above 0.
    #[error("it must be above 0; a motor that runs backwards is its mirror image")]
    RotorSpeed,
    /// Distances of a stator's arcs with which there are no arcs, or none on which a satellite rolls.
    #[error("{why}; {closing}")]
    NoConstruction {
        /// Why.
        why: epicyclic_hydromotor::Error,
        /// The `a` with which the rotor closes at the given `l`, or the range of `l` in which motors close.
        closing: String,
    },
    /// A construction of arcs of a motor that has none.
    #[error("a rotor by the cosine law is not made of arcs; it has no construction (1)-(8)")]
    #[strum(serialize = "no-construction")]
    NoArcs,
    /// A stator of more teeth than a list of all its satellites takes.
    #[error(
        "{teeth} stator teeth: without the teeth of a satellite all satellites are listed, of at most {most} stator teeth; give --zs"
    )]
    TooManyToList {
        /// Teeth of the stator.
        teeth: u32,
        /// The most.
        most: u32,
    },
    /// Data of a hydromotor besides its geometry that contradict each other.
    #[error("{message}")]
    MotorKey {
        /// The key that it is about: `oil.viscosity`.
        key: &'static str,
        /// Error and allowed values.
        message: String,
    },
    /// Too few or too many points of a hydromotor's centrodes.
    #[error("{points} points of a half-lobe: from 1 to {most}")]
    CentrodePoints {
        /// How many were wanted.
        points: u32,
        /// The most there can be.
        most: u32,
    },
    /// An error of a gear or a simple set.
    #[error(transparent)]
    Gear(#[from] epicyclic_gears::Error),
    /// An error of the solver.
    #[error(transparent)]
    Gearbox(#[from] epicyclic_train::Error),
    /// A transmission chosen in a file that holds one gearbox.
    #[error("the file holds one gearbox, and no transmissions to choose from")]
    OneGearbox,
    /// A list of several transmissions without a choice of one.
    #[error("the file has {}; name one of: {}", names.len(), names.join("; "))]
    SeveralTransmissions {
        /// Names of all transmissions.
        names: Vec<String>,
    },
    /// A name that is part of no transmission's.
    #[error("no name in the file has `{name}` in it; there are: {}", names.join("; "))]
    NoTransmission {
        /// The name.
        name: String,
        /// Names of the transmissions in the file.
        names: Vec<String>,
    },
    /// A name that is part of several transmissions'.
    #[error("`{name}` is part of several names; write more of one of: {}", names.join("; "))]
    AmbiguousTransmission {
        /// The name.
        name: String,
        /// Names that contain the given one.
        names: Vec<String>,
    },
    /// A gear that the gearbox does not have.
    #[error("no gear is called `{name}`: there are {}", gears.join(", "))]
    NoGear {
        /// The name.
        name: String,
        /// Names of the gearbox's gears.
        gears: Vec<String>,
    },
    /// A load that a gear cannot take.
    #[error("{why} (gear {gear})")]
    Load {
        /// Quantity of the load.
        quantity: LoadQuantity,
        /// The gear.
        gear: String,
        /// Why.
        why: epicyclic_train::OperatingFault,
    },
    /// A progression factor that leaves a step of the ideal progression at or below 1.
    #[error(
        "{factor} leaves a step at or below 1 between the gears {first} and {last}; with their spread it is between {least:.4} and {most:.4}"
    )]
    ProgressionFactor {
        /// The factor.
        factor: f64,
        /// The first gear of the progression.
        first: String,
        /// The last gear of the progression.
        last: String,
        /// The factor must be above this.
        least: f64,
        /// The factor must be below this.
        most: f64,
    },
    /// A gearbox of more gears than are taken in pairs.
    #[error("the gearbox has {gears} gears; in pairs, as here, at most {most} are told")]
    ManyGears {
        /// How many gears it has.
        gears: usize,
        /// How many it may have.
        most: usize,
    },
    /// A link that the gearbox does not have.
    #[error("no link is called `{name}`: there are {}", links.join(", "))]
    NoLink {
        /// Where it is named.
        given: Given,
        /// The name.
        name: String,
        /// Names of the gearbox's links.
        links: Vec<String>,
    },
    /// Speeds or torques of several links that do not settle the others.
    #[error("{fault}")]
    Inputs {
        /// Kind of the given values.
        given: Given,
        /// Why.
        fault: epicyclic_train::InputsFault,
    },
    /// Too few or too many places of a range.
    #[error("{places} places: 2 to {most} are allowed")]
    Places {
        /// How many.
        places: u32,
        /// The most.
        most: u32,
    },
    /// A range from a value to itself.
    #[error("both ends of the range are equal: write two different ones")]
    EqualEnds,
    /// An error of a scheme or a machine.
    #[error(transparent)]
    Design(#[from] epicyclic_schemes::Error),
    /// A size of a scheme.
    #[error("{size}: {problem}")]
    SchemeSize {
        /// Name of the size.
        size: SizeName,
        /// Error of the size.
        problem: SizeProblem,
    },
    /// An error of a selection.
    #[error(transparent)]
    Selection(#[from] epicyclic_selection::Error),
    /// A list of ratios that no gearbox of the classes asked for can have.
    #[error(transparent)]
    Synthesis(#[from] epicyclic_synthesis::Error),
    /// A speed or load of an input.
    #[error(transparent)]
    Duty(#[from] DutyProblem),
    /// More designs than are listed in one answer.
    #[error("{wanted} designs, each measured and written in full: at most {most}")]
    TooManyDesigns {
        /// How many are wanted.
        wanted: usize,
        /// Largest number of designs listed.
        most: usize,
    },
    /// Limits of a module that leave none.
    #[error("the least module, {least_mm} mm, is above the greatest, {greatest_mm} mm")]
    ModuleRange {
        /// The least.
        least_mm: f64,
        /// The greatest.
        greatest_mm: f64,
    },
    /// A one-way clutch that lets go at a load.
    #[error("gear `{gear}` relies on the one-way clutch `{clutch}`, which lets go at this load")]
    #[strum(serialize = "one-way-clutch")]
    Released {
        /// The clutch.
        clutch: String,
        /// The gear.
        gear: String,
    },
    /// Strength without a load.
    #[error("no load: give a torque or power with a speed, or write a `duty` in the file")]
    NoLoad,
    /// Shares of the time that are not one of each gear.
    #[error("{given} shares of the time for {} gears: {}", .gears.len(), .gears.join(", "))]
    Shares {
        /// How many were given.
        given: usize,
        /// The gears in their order.
        gears: Vec<String>,
    },
    /// Strength at a load without a speed, or at rest: its cycles follow from it.
    #[error("the load cycles of teeth follow from a speed: give one other than 0")]
    LoadWithoutSpeed,
    /// An option of one operating point, given with a duty.
    #[error(
        "a gear and a speed are of one operating point: give a torque or power, or leave them out for the duty of the file"
    )]
    OfOnePoint,
    /// No set whose strength can be calculated.
    #[error("no set can be rated: {}", sets.join("; "))]
    NothingRated {
        /// Why not, set by set.
        sets: Vec<String>,
    },
    /// A data sheet of no set.
    #[error("no set has a data sheet: {}", sets.join("; "))]
    NothingDescribed {
        /// Why not, set by set.
        sets: Vec<String>,
    },
    /// No set whose vibration can be calculated.
    #[error("no set can be calculated: {}", sets.join("; "))]
    NothingVibrates {
        /// Why not, set by set.
        sets: Vec<String>,
    },
    /// No harmonic of the meshes, or too many.
    #[error("{harmonics} harmonics: 1 to {most} are allowed")]
    Harmonics {
        /// How many were wanted.
        harmonics: u32,
        /// The most there can be.
        most: u32,
    },
    /// A balance of heat with what cannot be.
    #[error("{quantity} {given} {unit}: it must be {allowed}")]
    Cooling {
        /// Of what: `conductance`, `cooler`, `allowed-rise`.
        quantity: &'static str,
        /// Given value.
        given: f64,
        /// Unit of the given value.
        unit: &'static str,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// A damping ratio with which nothing rings, or for ever.
    #[error("damping ratio {given}: {low} to {high} are allowed")]
    DampingRatio {
        /// Given damping ratio.
        given: f64,
        /// The least allowed.
        low: f64,
        /// The greatest.
        high: f64,
    },
    /// A negative or infinite amplitude of the transmission error, or amplitudes that are all zero.
    #[error("a transmission error of {} µm: amplitudes are 0 or above, and one above 0", crate::shared::number::short(given_m * 1e6))]
    TransmissionError {
        /// Given amplitude, m.
        given_m: f64,
    },
    /// An excitation option without another one that it needs.
    #[error("{given} needs {lacks}: as an option, or as a key of `vibration` of the file")]
    ExcitationWithout {
        /// Given option: `harmonics`, `transmission-error`, `ring-transmission-error`, `damping`,
        /// `without-gyroscopic`.
        given: &'static str,
        /// Missing option.
        lacks: &'static str,
    },
    /// A set that does not exist.
    #[error("no set `{name}`: there are {}", sets.join(", "))]
    NoSet {
        /// The name.
        name: String,
        /// The sets.
        sets: Vec<String>,
    },
    /// An error of the space of a size search.
    #[error(transparent)]
    Sizing(#[from] epicyclic_strength::Error),
    /// A key of a scenario that cannot be swept, or a value that it does not take.
    #[error("{why}")]
    Sweep {
        /// Why.
        why: String,
    },
    /// Columns of different lengths.
    #[error("`{name}` has {given} values, and `{first}` has {expected}: every variant takes one of each")]
    SweptLength {
        /// The set or link.
        name: String,
        /// How many values it has.
        given: usize,
        /// The first set or link.
        first: String,
        /// How many values that has.
        expected: usize,
    },
    /// A variant of a sweep that is refused.
    #[error("variant {variant}: {why}")]
    SweptVariant {
        /// Index of the variant, from 0.
        variant: usize,
        /// Why.
        why: epicyclic_train::Error,
    },
    /// An error of the simulation of motion.
    #[error(transparent)]
    Motion(#[from] epicyclic_motion::Error),
    /// Keys that a file lacks, with lines to paste into it.
    #[error("{at}\n\n{lines}")]
    #[strum(serialize = "missing-key")]
    MissingKeys {
        /// Names of the keys, at the first of their places.
        at: Box<epicyclic_formats::Error>,
        /// Lines to paste, with where they belong.
        lines: String,
    },
    /// No set whose size can be calculated.
    #[error("no set can be sized: {}", sets.join("; "))]
    NothingToSize {
        /// Why not, set by set.
        sets: Vec<String>,
    },
    /// A file of sizes where some set has none.
    #[error("set {set} has no size that meets the requirements")]
    NoSize {
        /// The set.
        set: String,
    },
    /// A throw of a bucket wheel without an angle of the chute.
    #[error("no angle of the chute: at least one is due")]
    NoChute,
}

/// Name of an error, and whether the error means that nothing was found.
impl Error {
    /// The name of the error, which does not change: `no-tooth-numbers`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Document(error) => error.name(),
            Self::Placed { why, .. } => why.name(),
            Self::Drive(error) => error.name(),
            Self::Motor(error) => error.name(),
            Self::NoConstruction { why, .. } => why.name(),
            Self::Gear(error) => error.name(),
            Self::Gearbox(error) => error.name(),
            Self::Design(error) => error.name(),
            Self::Selection(error) => error.name(),
            Self::Synthesis(error) => error.name(),
            Self::Sizing(error) => error.name(),
            Self::SweptVariant { why, .. } => why.name(),
            Self::Motion(error) => error.name(),
            named => named.into(),
        }
    }

    /// Whether the question is sound and only has no answer within its bounds.
    #[must_use]
    pub fn is_nothing_found(&self) -> bool {
        use epicyclic_gears::Error as Gear;
        match self {
            Self::Placed { why, .. } => why.is_nothing_found(),
            Self::Gear(
                Gear::NoToothNumbers { .. } | Gear::NoDoublePlanetSet { .. } | Gear::NoArrangement { .. },
            )
            | Self::NoMotor(_)
            | Self::NoMotorForm(_)
            | Self::NoSize { .. } => true,
            Self::Drive(why) => {
                matches!(**why, epicyclic_dynamics::Error::Gear(Gear::NoToothNumbers { .. }))
            }
            _ => false,
        }
    }
}
