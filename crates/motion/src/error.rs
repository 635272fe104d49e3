//! Errors of this crate.

use epicyclic_gears::with_unit;

/// A model that cannot be built, or a motion that does not exist.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A number that is not allowed.
    #[error("{field} is {value}: {allowed}")]
    Value {
        /// Quantity of the number, with its unit.
        field: String,
        /// The number given.
        value: f64,
        /// Values allowed.
        allowed: &'static str,
    },
    /// A name that nothing has.
    #[error("there is no {what} {name}")]
    Unknown {
        /// Kind of the unknown thing.
        what: &'static str,
        /// The name given.
        name: String,
    },
    /// A name given twice.
    #[error("the {what} {name} is there already")]
    Duplicate {
        /// Kind of thing that has the name.
        what: &'static str,
        /// The name given.
        name: String,
    },
    /// Points of a table that are not in order.
    #[error("point {place} of {field} is at {}, and the point before it at {}: {allowed}", with_unit(*value, unit), with_unit(*before, unit))]
    Order {
        /// The table.
        field: String,
        /// Place of the point, from 1.
        place: usize,
        /// Abscissa of the point, SI.
        value: f64,
        /// Abscissa of the previous point, SI.
        before: f64,
        /// Unit of both; empty of plain numbers.
        unit: &'static str,
        /// Order allowed.
        allowed: &'static str,
    },
    /// A table without points.
    #[error("{field} has no points; it needs at least one")]
    NoPoints {
        /// The table.
        field: String,
    },
    /// Planets with inertia whose speed does not follow.
    #[error("the planets of {set} have inertia or mass, and their speed does not follow: {missing}")]
    PlanetSpeed {
        /// The set.
        set: String,
        /// Missing datum.
        missing: &'static str,
    },
    /// A shift element whose links are one piece.
    #[error("{element} joins {first} and {second}, which are one piece")]
    OnePiece {
        /// The shift element.
        element: String,
        /// First link of the element.
        first: String,
        /// Second link of the element.
        second: String,
    },
    /// Nothing can move.
    #[error("nothing can move: all links are held")]
    NoFreedom,
    /// Sets that together hold more than there is to hold, so that their torques do not follow.
    #[error(
        "the speeds that {set} asks of its links follow already from the other sets: its torques are indeterminate"
    )]
    Overdetermined {
        /// A set concerned.
        set: String,
    },
    /// Links that can move while nothing with inertia does, so that no torque settles their acceleration.
    #[error(
        "{} can move while nothing with inertia moves: give {} an inertia, however small, or hold {} for good",
        .links.join(", "), inertias_needed(*.missing, .links.len()), if .links.len() == 1 { "it" } else { "them" }
    )]
    NoInertia {
        /// Links concerned, all without an inertia that counts.
        links: Vec<String>,
        /// Number of links that need one.
        missing: usize,
    },
    /// Losses under which a torque has no motion, or several.
    #[error(
        "the mesh losses of {} leave the motion open: the determinant of the loaded mass matrix over that without losses is \
         {least:.6} under one pattern of power directions and {greatest:.6} under another; both must be above 0",
        .sets.join(", ")
    )]
    NotUnique {
        /// The sets with losses that are moving.
        sets: Vec<String>,
        /// The least of the determinants over that without losses.
        least: f64,
        /// The greatest.
        greatest: f64,
    },
    /// Stuck elements that share their torque over a rolling set with losses in a way that is not determined.
    #[error(
        "at {time_s} s {} on {} hold more than there is to hold while {set} rolls with losses: how they share their torque is open, \
         and so are the losses; leave one of them open, or give {set} no losses",
        .elements.join(", "), .links.join(", ")
    )]
    OpenSplit {
        /// Time, s.
        time_s: f64,
        /// The elements.
        elements: Vec<String>,
        /// Links of the elements.
        links: Vec<String>,
        /// The set.
        set: String,
    },
    /// Lossy meshes above the number for which patterns are searched.
    #[error(
        "{given} lossy meshes move at once, and at most {most} are taken: give some sets no inertia of planets, or no losses"
    )]
    TooManyMeshes {
        /// Number of lossy meshes.
        given: usize,
        /// The limit.
        most: usize,
    },
    /// Shift elements without slip above the number for which patterns are searched.
    #[error(
        "at {time_s} s {given} shift elements, loads and sets are without slip, and at most {most} are taken: {}; engage for good \
         what never slips, or give it no capacity",
        .parts.join(", ")
    )]
    TooManyAtRest {
        /// The shift elements, loads and sets concerned.
        parts: Vec<String>,
        /// Number of shift elements, loads and sets.
        given: usize,
        /// The limit.
        most: usize,
        /// Time, s.
        time_s: f64,
    },
    /// No assumption about what holds and what slips is consistent.
    #[error(
        "at {time_s} s no pattern of {} on {} holding or slipping is consistent{}: leave one of them open, or give the sets no losses",
        .parts.join(", "), .links.join(", "),
        .violation.map_or_else(String::new, |violation| format!("; the best is off by {violation:.3e}"))
    )]
    NoMotion {
        /// Time, s.
        time_s: f64,
        /// The shift elements, loads and sets concerned.
        parts: Vec<String>,
        /// Links of the parts.
        links: Vec<String>,
        /// Violation by the best pattern, over the largest torque or acceleration; `None` if no pattern has a
        /// solution.
        violation: Option<f64>,
    },
    /// A speed at which a drag has no torque.
    #[error(
        "at {time_s} s the links of the drag {drag} turn at {slip_rad_s} rad/s against each other, and its curve is from {from_rad_s} to \
         {to_rad_s} rad/s: give points there, or beyond: constant"
    )]
    DragSpeed {
        /// The drag.
        drag: String,
        /// Place of the drag among the drags.
        place: usize,
        /// The speed of its links relative to each other, in size.
        slip_rad_s: f64,
        /// The first speed of its curve.
        from_rad_s: f64,
        /// The last speed of its curve.
        to_rad_s: f64,
        /// Time, s.
        time_s: f64,
    },
    /// Initial speeds that the sets do not allow.
    #[error(
        "the initial speeds do not fit: {link} is given {given} rad/s, and turns at {found} rad/s by the others"
    )]
    InitialSpeeds {
        /// The link.
        link: String,
        /// Speed of the link as given.
        given: f64,
        /// Speed of the link by the others.
        found: f64,
    },
    /// Initial speeds from which others do not follow.
    #[error("the initial speed of {link} does not follow from those given")]
    InitialOpen {
        /// A link whose speed does not follow.
        link: String,
    },
    /// A one-way clutch that would have to slip against its direction.
    #[error(
        "the one-way clutch {element} slips at {slip} rad/s at the start; it lets only slips above 0 pass"
    )]
    InitialSlip {
        /// The clutch.
        element: String,
        /// Slip of the clutch.
        slip: f64,
    },
    /// A dog clutch that would have to engage by an impact at the start.
    #[error(
        "the dog clutch {element} is engaged at the start and slips at {slip} rad/s: give it speeds without slip, or engage it later"
    )]
    InitialDog {
        /// The clutch.
        element: String,
        /// Slip of the clutch.
        slip: f64,
    },
    /// Events that accumulate at a time.
    #[error(
        "events accumulate at {time_s} s: {events} within {within_s:.3e} s, of {} on {}; more inertia there, softer or more damped \
         shafts, or sets without losses avoid it",
        .parts.join(", "), .links.join(", ")
    )]
    Accumulating {
        /// Time, s.
        time_s: f64,
        /// Number of events.
        events: usize,
        /// Time within which they occur, s.
        within_s: f64,
        /// The parts that had events.
        parts: Vec<String>,
        /// Links of the parts.
        links: Vec<String>,
    },
    /// A step shorter than the resolution of time.
    #[error(
        "at {time_s} s the step would have to be shorter than {step_s:.3e} s: speeds or torques grow beyond all bounds"
    )]
    StepTooShort {
        /// Time, s.
        time_s: f64,
        /// The step.
        step_s: f64,
    },
    /// Steps above the number allowed.
    #[error("more than {most} steps are needed; {time_s} s are calculated")]
    TooManySteps {
        /// The limit.
        most: usize,
        /// Time reached, s.
        time_s: f64,
    },
    /// An invalid gearbox.
    #[error(transparent)]
    Gearbox(#[from] epicyclic_train::Error),
}

/// Number of links, of these, that need an inertia, in words.
fn inertias_needed(missing: usize, links: usize) -> String {
    match (missing, links) {
        (1, 1) => "it".into(),
        (1, _) => "one of them".into(),
        (missing, links) if missing == links => "each of them".into(),
        (missing, _) => format!("{missing} of them"),
    }
}

impl Error {
    /// Names of the parts that it is about: shift elements, loads, shafts, drags, sets.
    #[must_use]
    pub fn parts(&self) -> Vec<&str> {
        match self {
            Self::NoMotion { parts, .. }
            | Self::Accumulating { parts, .. }
            | Self::TooManyAtRest { parts, .. } => parts.iter().map(String::as_str).collect(),
            Self::OpenSplit { elements, set, .. } => {
                elements.iter().chain([set]).map(String::as_str).collect()
            }
            Self::NotUnique { sets, .. } => sets.iter().map(String::as_str).collect(),
            Self::DragSpeed { drag, .. } => vec![drag],
            _ => vec![],
        }
    }

    /// Name of the fault, which does not change with the message: `no-inertia`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Gearbox(error) => error.name(),
            named => named.into(),
        }
    }
}
