//! Errors in the description of a compound set.

use crate::compound::GearName;
use crate::names::hint;

/// Why two gears do not mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshFault {
    /// Two central gears.
    #[error("both are central gears, and turn about one axis")]
    TwoCentrals,
    /// Two gears of one planet.
    #[error("they are gears of one planet, and turn as one piece")]
    OnePlanet,
    /// A ring with no more teeth than the planet.
    #[error("a ring has more teeth than the planet in it")]
    SmallRing,
    /// A planet shaft.
    #[error("a planet shaft has no teeth")]
    PlanetShaft,
}

/// Error in the description of a compound set.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CompoundFault {
    /// Fewer than two central gears.
    #[error("{given} central gears: at least two members besides the carrier are due")]
    TooFewMembers {
        /// Number given.
        given: usize,
    },
    /// A gear without teeth.
    #[error("gear `{gear}` has 0 teeth: at least 1 is due")]
    NoTeeth {
        /// The gear.
        gear: GearName,
    },
    /// A number of teeth that is not whole.
    #[error(
        "gear `{gear}` has {given} teeth: give a whole number from 1, or the proportions of all gears with `proportional: true`"
    )]
    NotWhole {
        /// The gear.
        gear: GearName,
        /// The tooth number given.
        given: f64,
    },
    /// A proportion that is not above 0.
    #[error("gear `{gear}` has the proportion {given}: it must be above 0")]
    Proportion {
        /// The gear.
        gear: GearName,
        /// The proportion given.
        given: f64,
    },
    /// Teeth of a planet where those of the central gears are not known.
    #[error("planet `{planet}` has teeth in a proportional set: leave them out, as in `{planet}: []`")]
    PlanetTeeth {
        /// The planet.
        planet: String,
    },
    /// A planet with too many gears.
    #[error("planet `{planet}` has {given} gears: {most} at most are allowed")]
    PlanetGears {
        /// The planet.
        planet: String,
        /// Number given.
        given: usize,
        /// Largest number allowed.
        most: usize,
    },
    /// One name for two things.
    #[error("`{name}` is named twice: central gears and planets of a set have names of their own")]
    NameTwice {
        /// The name.
        name: GearName,
    },
    /// Two shafts of one planet.
    #[error(
        "`{name}` is a second shaft of planet `{planet}`: one is enough, with its link for all that it joins"
    )]
    TwoShafts {
        /// The second shaft.
        name: String,
        /// The planet.
        planet: String,
    },
    /// A gear that is not there.
    #[error("no gear is called `{name}`{}; a gear of a planet with several is `planet.1`, `planet.2`…", hint(suggestion.as_deref()))]
    UnknownGear {
        /// The name given.
        name: String,
        /// The nearest name that exists.
        suggestion: Option<String>,
    },
    /// Two gears that cannot mesh.
    #[error("`{first}` and `{second}` do not mesh: {why}")]
    Mesh {
        /// One gear.
        first: String,
        /// The other.
        second: String,
        /// Reason.
        why: MeshFault,
    },
    /// A mesh that closes a loop.
    #[error(
        "the mesh of `{first}` and `{second}` closes a loop: other meshes tie them already; leave it out"
    )]
    Loop {
        /// One gear.
        first: String,
        /// The other.
        second: String,
    },
    /// A gear or planet that no mesh ties to the first central gear.
    #[error("`{name}` meshes with none of the others: add a mesh")]
    Apart {
        /// The gear or planet.
        name: String,
    },
}
