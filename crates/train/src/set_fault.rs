//! Errors in the description of a set: its meshes, the spacing of its planets, members that are one piece.

use crate::compound::SetMember;

/// Error in the spacing of planets.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SpacingFault {
    /// A pair of gears on fixed axes.
    #[error("a pair on fixed axes has no planets to place")]
    Pair,
    /// Angles of another number of planets.
    #[error("{angles} planet angles are given for {planets} planets; give one angle for each planet")]
    Count {
        /// Number of angles.
        angles: usize,
        /// Number of planets.
        planets: u32,
    },
    /// An angle that is not finite.
    #[error("the angle of planet {planet} is not finite")]
    NotFinite {
        /// The planet, from 1.
        planet: usize,
    },
    /// Two planets at one angle.
    #[error("planets {} and {} have the same angle; give each planet its own", planets[0], planets[1])]
    SameAngle {
        /// The planets, from 1.
        planets: [usize; 2],
    },
    /// Assembly positions that are not known.
    #[error(
        "the least unequal spacing needs the number of planets and the teeth of all gears; give them, or the angles of the planets"
    )]
    Unknown,
    /// More planets than assembly positions.
    #[error(
        "{planets} planets need {planets} assembly positions, and the teeth leave {positions}; give fewer planets"
    )]
    TooFewPositions {
        /// Number of planets.
        planets: u32,
        /// Number of positions.
        positions: u64,
    },
}

/// Message for two members of a set that are one piece: the effect and the remedy.
pub(crate) fn coincident(
    set: &str,
    [first, second]: [&SetMember; 2],
    link: &str,
    [is_pair, is_held]: [bool; 2],
) -> String {
    match (is_pair, is_held) {
        (true, true) => format!(
            "a gear of the pair `{set}` is held to the housing, so that neither of its gears turns; give the gear a link of its own and \
             hold it by a brake"
        ),
        (true, false) => {
            format!("both gears of the pair `{set}` are `{link}`, so that neither turns; give them two links")
        }
        (false, true) => format!(
            "{first} and {second} of set `{set}` are both held to the housing, so that the set cannot turn; give them two links and \
             hold one of these by a brake"
        ),
        (false, false) => format!(
            "{first} and {second} of set `{set}` are both `{link}`: such a set turns as a block; give them two links and join these by a \
             clutch"
        ),
    }
}
