//! What this crate refuses, and what it only remarks on.

use crate::row::RowKind;
use epicyclic_gears::row::Member;
use std::fmt;

/// What a name stands for in a gearbox.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Named {
    /// A link.
    Link,
    /// A row.
    Row,
    /// A brake or clutch.
    Control,
    /// A gear.
    Gear,
    /// A mesh that rows share.
    SharedMesh,
}

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Link => "link",
            Self::Row => "row",
            Self::Control => "control",
            Self::Gear => "gear",
            Self::SharedMesh => "shared ring mesh",
        })
    }
}

/// A description that is no gearbox, or a question that it cannot answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A name that nothing bears.
    #[error("{place} names the {what} `{name}`, which does not exist{}", hint(suggestion.as_deref()))]
    Unknown {
        /// What was looked for.
        what: Named,
        /// The name given.
        name: String,
        /// Who names it, as `row \`P1\``.
        place: String,
        /// The nearest name that exists, or all of them where none is near.
        suggestion: Option<String>,
    },
    /// Two things of one kind with one name.
    #[error("two {what}s are called `{name}`: names are unique, and `ground` is the housing")]
    Duplicate {
        /// Of which kind.
        what: Named,
        /// The name.
        name: String,
    },
    /// Two members of a row that are one piece for ever.
    #[error(
        "{first} and {second} of row `{row}` are both `{link}`: such a row turns as a block; give them two \
         links and join these by a control"
    )]
    CoincidentMembers {
        /// The row.
        row: String,
        /// The first of the two members.
        first: Member,
        /// The second.
        second: Member,
        /// The link of the first.
        link: String,
    },
    /// A row parameter outside what its kind can have.
    #[error("k = {k} of row `{row}` ({kind}): {}", allowed_k(*kind))]
    RowParameter {
        /// The row.
        row: String,
        /// Its kind.
        kind: RowKind,
        /// The value given, `|i₀|`.
        k: f64,
    },
    /// A stepped row whose teeth lack those of its planet.
    #[error("row `{row}` ({kind}) needs the teeth of both steps of its planet, z_g and z_f")]
    StepsMissing {
        /// The row.
        row: String,
        /// Its kind.
        kind: RowKind,
    },
    /// A control that joins a link with itself.
    #[error("control `{control}` joins `{link}` with itself: name two different links")]
    ControlJoinsItself {
        /// The control.
        control: String,
        /// The link named twice.
        link: String,
    },
    /// Permanent connections that close a loop.
    #[error("`{first}` and `{second}` are already one piece through other permanent connections")]
    CyclicGrounds {
        /// The link whose connection closes the loop.
        first: String,
        /// What it is connected to.
        second: String,
    },
    /// The housing named as input or output.
    #[error("{place} is `ground`: power enters and leaves at links that can turn")]
    GroundedTerminal {
        /// Which terminal, as `input of gear \`1\``.
        place: String,
    },
    /// Rows that cannot share the mesh of a planet with the ring.
    #[error("rows `{first}` and `{second}` cannot share a mesh: {why}")]
    SharedMesh {
        /// The first row of the group.
        first: String,
        /// The row that does not fit.
        second: String,
        /// What does not fit.
        why: &'static str,
    },
    /// A gearbox larger than the fixed arrays of the solver.
    #[error("{count} {what}{}s: at most {limit} are solved", if *what == Named::SharedMesh { "e" } else { "" })]
    TooMany {
        /// Of which kind.
        what: Named,
        /// How many there are.
        count: usize,
        /// How many there may be.
        limit: usize,
    },
    /// A gearbox without a single row.
    #[error("a gearbox without rows: give at least one")]
    NoRows,
    /// An input or output that was never named.
    #[error("no {terminal}: name the link where power {}", if *terminal == "input" { "enters" } else { "leaves" })]
    NoTerminal {
        /// `input` or `output`.
        terminal: &'static str,
    },
    /// A demand for numbers of a gear that is not driven.
    #[error("the gear is not driven: {state}")]
    NotDriven {
        /// Its state, in words.
        state: String,
    },
    /// An operating point without motion or without a finite load.
    #[error("operating point: {why}")]
    OperatingPoint {
        /// What is wrong with it.
        why: &'static str,
    },
    /// Stationary ratios or efficiencies that do not fit the compiled gear.
    #[error("{given} rows are given to a gear compiled with {expected}")]
    RowCount {
        /// How many were given.
        given: usize,
        /// How many there are.
        expected: usize,
    },
}

fn hint(suggestion: Option<&str>) -> String {
    suggestion.map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}

fn allowed_k(kind: RowKind) -> &'static str {
    match kind {
        RowKind::Simple => "the ring of a simple row is larger than its sun, so k = z_b/z_a is above 1",
        _ => "the size of the stationary ratio is finite and above 0",
    }
}

/// A remark on a gearbox that can be built and analysed all the same.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Warning {
    /// Teeth that break coaxiality without profile shift, `z_b ≠ z_a + 2·z_g`.
    ///
    /// Many gears in service do so on purpose, so it is no error.
    Coaxiality {
        /// The row.
        row: String,
        /// The ring's teeth.
        ring: u32,
        /// `z_a + 2·z_g`.
        unshifted: u32,
    },
    /// An input or output that no row, control or permanent connection ever reaches.
    Unreachable {
        /// The link.
        link: String,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coaxiality { row, ring, unshifted } => write!(
                f,
                "row `{row}`: z_b = {ring}, but z_a + 2·z_g = {unshifted}: coaxial only with shifted profiles"
            ),
            Self::Unreachable { link } => write!(f, "nothing ever joins `{link}` to a row"),
        }
    }
}
