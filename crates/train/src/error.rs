//! Errors and warnings of this crate.

use crate::compound::{CentralKind, SetMember};
pub use crate::compound_fault::{CompoundFault, MeshFault};
pub use crate::drag_fault::DragFault;
use crate::names::hint;
pub use crate::operating_fault::OperatingFault;
pub use crate::set_fault::SpacingFault;
use crate::set_fault::coincident;
use crate::set_kind::SetKind;
use crate::tolerance::{BASIC_RATIO, MOST_ALIKE, SPREAD};
use std::fmt;

/// Kind of thing that a name denotes in a gearbox.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Named {
    /// A link.
    Link,
    /// A planet set, or a pair on fixed axes.
    Set,
    /// A shift element.
    ShiftElement,
    /// A gear.
    Gear,
    /// A central gear or planet shaft of a set.
    Member,
    /// A planet of a set.
    Planet,
    /// A mesh of a set.
    Mesh,
    /// A drag.
    Drag,
}

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Link => "link",
            Self::Set => "set",
            Self::ShiftElement => "shift element",
            Self::Gear => "gear",
            Self::Member => "central gear",
            Self::Planet => "planet",
            Self::Mesh => "mesh",
            Self::Drag => "drag",
        })
    }
}

/// Where power enters or leaves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Terminal"))]
pub enum Terminal {
    /// Link where power enters.
    Input,
    /// Link where power leaves.
    Output,
}

impl fmt::Display for Terminal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Input => "input",
            Self::Output => "output",
        })
    }
}

/// Place in a description or a request that names a link, a shift element or a gear; displays as ``input of
/// gear `1` ``.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// The gearbox of this name.
    Gearbox(String),
    /// A set.
    Set(String),
    /// A shift element.
    ShiftElement(String),
    /// A permanent connection, by its number from 0 in the order of their description.
    Connection(usize),
    /// A gear: the shift elements engaged in it.
    Gear(String),
    /// A gear without a name.
    UnnamedGear,
    /// A terminal of the gearbox.
    Terminal(Terminal),
    /// The terminal of a gear.
    TerminalOf(Terminal, String),
    /// A drag.
    Drag(String),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Gearbox(name) => write!(f, "gearbox `{name}`"),
            Self::Set(id) => write!(f, "set `{id}`"),
            Self::ShiftElement(id) => write!(f, "shift element `{id}`"),
            Self::Connection(_) => f.write_str("a permanent connection"),
            Self::Gear(name) => write!(f, "gear `{name}`"),
            Self::UnnamedGear => f.write_str("a gear"),
            Self::Terminal(terminal) => write!(f, "{terminal}"),
            Self::TerminalOf(terminal, gear) => write!(f, "{terminal} of gear `{gear}`"),
            Self::Drag(name) => write!(f, "drag `{name}`"),
        }
    }
}

/// A description that is not a gearbox, or a request that the gearbox cannot answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// An unknown name.
    #[error("{place} names the {what} `{name}`, which does not exist{}", hint(suggestion.as_deref()))]
    Unknown {
        /// Kind of the unknown thing.
        what: Named,
        /// The name given.
        name: String,
        /// Place in the description where the name occurs.
        place: Place,
        /// The nearest name that exists, or all of them where none is near.
        suggestion: Option<String>,
    },
    /// A shift element that a gear names twice.
    #[error("{place} engages `{name}` twice; name it once")]
    EngagedTwice {
        /// The gear.
        place: Place,
        /// The shift element.
        name: String,
    },
    /// Two things of one kind with one name.
    #[error("two {what}s are called `{name}`: names are unique, and `ground` is the housing")]
    Duplicate {
        /// Kind of the two things.
        what: Named,
        /// The name.
        name: String,
    },
    /// Two members of a set that are permanently one piece.
    #[error("{}", coincident(set, [first, second], link, [*is_pair, *is_held]))]
    CoincidentMembers {
        /// The set.
        set: String,
        /// The first of the two members.
        first: SetMember,
        /// The second.
        second: SetMember,
        /// The link of the first.
        link: String,
        /// Whether the set is a pair on fixed axes.
        is_pair: bool,
        /// Whether they are the housing.
        is_held: bool,
    },
    /// A ring-to-sun ratio outside the range of its kind.
    #[error("k = {k} of set `{set}` ({kind}): {}", allowed_k(*kind))]
    RingToSunRatio {
        /// The set.
        set: String,
        /// Kind of the set.
        kind: SetKind,
        /// The value given, `|i₀|`.
        k: f64,
    },
    /// A basic ratio of a compound set beyond the limits.
    #[error(
        "set `{set}`: the basic ratio of {first} to {second} is {ratio:.3e}; between {:e} and {BASIC_RATIO:e} in \
         size is solved", 1.0 / BASIC_RATIO
    )]
    BasicRatio {
        /// The set.
        set: String,
        /// One gear.
        first: String,
        /// The other.
        second: String,
        /// The ratio.
        ratio: f64,
    },
    /// Basic ratios whose product is above the largest allowed.
    #[error("the basic ratios of all sets multiply to 1e{exponent:.0}: up to {SPREAD:e} is solved")]
    Spread {
        /// Decimal exponent of the product.
        exponent: f64,
    },
    /// A stepped set whose teeth lack those of its planet.
    #[error("set `{set}` ({kind}) needs the teeth of both steps of its planet, z_g and z_f")]
    StepsMissing {
        /// The set.
        set: String,
        /// Kind of the set.
        kind: SetKind,
    },
    /// A number of planets that no set has.
    #[error(
        "set `{set}` has {given} planets: 1 to {MOST_ALIKE} of each are allowed; leave the number out where it is unknown"
    )]
    PlanetCount {
        /// The set.
        set: String,
        /// The number given.
        given: u32,
    },
    /// A spacing of planets that a set cannot have.
    #[error("set `{set}`: {fault}")]
    Spacing {
        /// The set.
        set: String,
        /// Error in the spacing.
        fault: SpacingFault,
    },
    /// An invalid compound set.
    #[error("set `{set}`: {fault}")]
    Compound {
        /// The set.
        set: String,
        /// Error in the set.
        fault: CompoundFault,
    },
    /// A shift element that joins a link with itself.
    #[error("shift element `{shift_element}` joins `{link}` with itself: name two different links")]
    ShiftElementJoinsItself {
        /// The shift element.
        shift_element: String,
        /// The link named twice.
        link: String,
    },
    /// Permanent connections that close a loop.
    #[error("`{first}` and `{second}` are already one piece through other permanent connections")]
    CyclicGrounds {
        /// The number of the connection, from 0 in the order of their description.
        number: usize,
        /// The link whose connection closes the loop.
        first: String,
        /// The link it is connected to.
        second: String,
    },
    /// The housing named as input or output.
    #[error("{place} is `ground`: power enters and leaves at links that can turn")]
    GroundedTerminal {
        /// The terminal.
        place: Place,
    },
    /// A gearbox larger than is solved.
    #[error("{count} {}: at most {limit} are allowed", plural(*what))]
    TooMany {
        /// Kind of the things.
        what: Named,
        /// Number in the description.
        count: usize,
        /// Largest number allowed.
        limit: usize,
    },
    /// A gearbox without a single set.
    #[error("a gearbox without planet sets: give at least one")]
    NoSets,
    /// A gear that was made by another gearbox.
    #[error("gear `{gear}` names shift elements or links that this gearbox has not: it is another gearbox's")]
    ForeignGear {
        /// The gear.
        gear: String,
    },
    /// An invalid drag torque, or one without a value at a speed.
    #[error("drag `{drag}`: {fault}")]
    Drag {
        /// Name of the drag.
        drag: String,
        /// Error in the drag.
        fault: DragFault,
    },
    /// Speeds and torques that do not settle the state of a gear with several inputs.
    #[error("{0}")]
    Inputs(#[from] InputsFault),
    /// An input or output that was never named.
    #[error("no {terminal}: name the link where power {}", match terminal { Terminal::Input => "enters", Terminal::Output => "leaves" })]
    NoTerminal {
        /// The terminal.
        terminal: Terminal,
    },
    /// A request for numbers of a gear that is not driven.
    #[error("the gear is not driven: {state}")]
    NotDriven {
        /// State of the gear, in words.
        state: String,
    },
    /// An operating point without motion or without a finite load.
    #[error("operating point: {why}")]
    OperatingPoint {
        /// Error in the operating point.
        why: OperatingFault,
    },
    /// Basic ratios or efficiencies that do not fit the compiled gear.
    #[error("{given} {what} are given to a gear compiled with {expected}")]
    ValueCount {
        /// Kind of the values.
        what: SetValue,
        /// Number given.
        given: usize,
        /// Number required.
        expected: usize,
    },
    /// A set whose basic ratio cannot be given.
    #[error(
        "set `{set}` is described gear by gear: its basic ratios follow from its teeth and cannot be varied"
    )]
    NotVaried {
        /// The set.
        set: String,
    },
    /// A set whose basic ratio is given twice.
    #[error("k of set `{set}` is given twice")]
    VariedTwice {
        /// The set.
        set: String,
    },
}

impl Error {
    /// Name of the fault, which does not change with the message: `unknown`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.into()
    }
}

/// Values that a compiled gear is solved for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SetValue {
    /// Basic ratios.
    BasicRatio,
    /// Efficiencies.
    Efficiency,
}

impl fmt::Display for SetValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::BasicRatio => "basic ratios",
            Self::Efficiency => "efficiencies",
        })
    }
}

/// Why no speed or torque is given to a link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LinkFault {
    /// The link is at rest.
    #[error("is held to the housing in this gear")]
    Held,
    /// The link's speed is given already, as that of another link.
    #[error("turns as one piece with another link whose speed is given")]
    OnePiece,
}

/// Why speeds and torques given for several inputs settle no state.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum InputsFault {
    /// Too few speeds.
    #[error("{}", too_few(*given, *needed, candidates))]
    TooFewSpeeds {
        /// Number given.
        given: usize,
        /// Number required.
        needed: usize,
        /// Links whose speeds are still free.
        candidates: Vec<String>,
    },
    /// A speed that follows from the others, or contradicts them.
    #[error("the speed of `{link}` is given, but it follows from the others: leave it out")]
    DependentSpeed {
        /// The link.
        link: String,
    },
    /// A link named twice, or the housing.
    #[error("`{link}` {why}")]
    Link {
        /// The link.
        link: String,
        /// Error in the link.
        why: LinkFault,
    },
    /// Too few or too many torques.
    #[error("{}: {given} are given", of_the_torques(*needed, candidates))]
    Torques {
        /// Number given.
        given: usize,
        /// Number required.
        needed: usize,
        /// Links that may carry one.
        candidates: Vec<String>,
    },
    /// Torques that leave those at other links open, or contradict each other.
    #[error("these torques do not settle the others: give that of another of {}", candidates.join(", "))]
    DependentTorques {
        /// Links that may carry one.
        candidates: Vec<String>,
    },
    /// Sets whose torques depend on how tightly they were engaged.
    #[error("sets {} share a torque that nothing settles", sets.join(", "))]
    SharedTorques {
        /// The sets.
        sets: Vec<String>,
    },
    /// No torques keep the gear moving at these speeds.
    #[error("no torques keep it moving this way: its mesh losses hold it")]
    SelfLocking,
}

fn too_few(given: usize, needed: usize, candidates: &[String]) -> String {
    let add = match (needed - given, candidates) {
        (1, [only]) => format!("that of {only}"),
        (1, all) => format!("that of one of {}", all.join(", ")),
        (missing, all) => format!("those of {missing} of {}", all.join(", ")),
    };
    format!("the gear keeps {needed} freedoms and the speeds given are {given}: add {add}")
}

/// `1 of the torques at a, b must be given`, or that all follow.
fn of_the_torques(needed: usize, candidates: &[String]) -> String {
    let links = candidates.join(", ");
    if needed == 0 {
        format!("the torques at {links} follow, none can be given")
    } else {
        format!("{needed} of the torques at {links} must be given")
    }
}

fn allowed_k(kind: SetKind) -> &'static str {
    match kind {
        SetKind::Simple => {
            "the ring of a simple set is larger than its sun, so k = z_b/z_a is above 1, and 1e9 at most"
        }
        _ => "the size of the basic ratio is between 1e-9 and 1e9",
    }
}

fn plural(what: Named) -> &'static str {
    match what {
        Named::Link => "links",
        Named::Set => "planet sets",
        Named::ShiftElement => "shift elements",
        Named::Gear => "gears",
        Named::Member => "central gears of one set",
        Named::Planet => "planets of one set",
        Named::Mesh => "meshes of one set",
        Named::Drag => "drags",
    }
}

/// A remark on a gearbox that can be built and analysed all the same.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Warning {
    /// An input or output that no set, shift element or permanent connection ever reaches.
    Unreachable {
        /// The link.
        link: String,
    },
    /// A gearbox without gears: nothing to analyse.
    NoGears,
    /// A gear whose input is its output.
    SameTerminals {
        /// The gear.
        gear: String,
        /// The link.
        link: String,
    },
    /// Two sets with one carrier and one central gear: if they share planets, they are one set.
    SharedPlanets {
        /// One set.
        first: String,
        /// The other.
        second: String,
        /// Kind of the central gear.
        member: CentralKind,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreachable { link } => write!(f, "nothing ever joins `{link}` to a set"),
            Self::NoGears => f.write_str("no gears are described: there is nothing to analyse; of a gearbox without shift elements write gears: [{ name: only }]"),
            Self::SameTerminals { gear, link } => {
                write!(f, "input and output of gear `{gear}` are both `{link}`: its ratio is 1 by definition")
            }
            Self::SharedPlanets { first, second, member } => write!(
                f,
                "sets `{first}` and `{second}` have one carrier and one {member}: if they share planets, describe \
                 them as one compound set: as two sets the shared mesh loses twice, and what it passes on may seem to circulate"
            ),
        }
    }
}
