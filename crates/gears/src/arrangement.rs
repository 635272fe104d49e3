//! Arrangements of gears beyond the simple set: their gears, meshes, speeds and modes.
//!
//! | arrangement | gears | meshes |
//! |---|---|---|
//! | [`Stepped`](Arrangement::Stepped) | `a`, `g`–`f`, `b` | sun `a` with step `g`, step `f` with ring `b` |
//! | [`SteppedSuns`](Arrangement::SteppedSuns) | `a`, `g`–`f`, `c` | sun `a` with `g`, sun `c` with `f` |
//! | [`SteppedRings`](Arrangement::SteppedRings) | `b`, `g`–`f`, `e` | ring `b` with `g`, ring `e` with `f` |
//! | [`Wolfrom`](Arrangement::Wolfrom) | `a`, `g`–`f`, `b`, `e` | sun `a` and ring `b` with `g`, ring `e` with `f` |
//! | [`Ravigneaux`](Arrangement::Ravigneaux) | `a`, `g`, `f`, `c`, `b` | small sun `a` with short planet `g`, `g` with long planet `f`, large sun `c` and ring `b` with `f` |
//! | [`ExternalPair`](Arrangement::ExternalPair), [`InternalPair`](Arrangement::InternalPair) | `1`, `2` | both gears, on fixed axes |
//!
//! `g`–`f` are steps of one planet. A Wolfrom set, or one with two suns or rings, whose steps have the same
//! teeth and the same module has a planet with one gear.
//!
//! # Ratio
//! Every mesh gives the speed of a central gear relative to the carrier, `u`, from that of its planet. With
//! the member `x` at rest
//!
//! ```text
//! i = (u_in − u_x)/(u_out − u_x)       u_H = 0
//! ```
//!
//! | arrangement | `u`, over one factor |
//! |---|---|
//! | steps | sun `−z_p/z`, ring `+z_p/z`, with the step `p` it meshes with |
//! | Ravigneaux | `−1/z_a`, `+1/z_c`, `−1/z_b` |
//! | pairs | `1/z_1`; `−1/z_2`, internal `+1/z_2` |

mod bounds;
mod numbers;
mod search;
mod shifts;

pub use bounds::ArrangementBounds;
pub use numbers::{ArrangedTeeth, ModuleRatio, least_angle_rad};
pub use search::ArrangedCandidate;
pub use shifts::ArrangedShifts;

use crate::quantity::SimpleGear;
use std::fmt;
use std::ops::Neg;

/// Most gears of an arrangement.
pub(crate) const MOST_GEARS: usize = 5;

/// Arrangement of gears that mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Arrangement"))]
pub enum Arrangement {
    /// Stepped planet between a sun and a ring.
    Stepped,
    /// Stepped planet between two suns.
    SteppedSuns,
    /// Stepped planet between two rings.
    SteppedRings,
    /// Sun and ring on one step of the planet, a second ring on the other.
    Wolfrom,
    /// Two suns and a ring on short and long planets.
    Ravigneaux,
    /// Two external gears.
    ExternalPair,
    /// An external gear in an internal one.
    InternalPair,
}

/// Gear of an arrangement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GearPlace {
    /// Name of the gear as a key, `first_ring`; displays as words.
    pub name: &'static str,
    /// Letter of the gear.
    pub symbol: char,
    /// Sun for every external central gear, ring for every internal one, or planet.
    pub role: SimpleGear,
    /// Step of the planet that it belongs to or meshes with: 0 or 1.
    pub step: usize,
}

impl fmt::Display for GearPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.name.replace('_', " "))
    }
}

const fn gear(name: &'static str, symbol: char, role: SimpleGear, step: usize) -> GearPlace {
    GearPlace { name, symbol, role, step }
}

const SUN: GearPlace = gear("sun", 'a', SimpleGear::Sun, 0);
const RING: GearPlace = gear("ring", 'b', SimpleGear::Ring, 0);
const FIRST_RING: GearPlace = gear("first_ring", 'b', SimpleGear::Ring, 0);
const FIRST: GearPlace = gear("first_step", 'g', SimpleGear::Planet, 0);
const SECOND: GearPlace = gear("second_step", 'f', SimpleGear::Planet, 1);
const SECOND_RING: GearPlace = gear("second_ring", 'e', SimpleGear::Ring, 1);

impl Arrangement {
    /// Every arrangement.
    pub const ALL: [Self; 7] = [
        Self::Stepped,
        Self::SteppedSuns,
        Self::SteppedRings,
        Self::Wolfrom,
        Self::Ravigneaux,
        Self::ExternalPair,
        Self::InternalPair,
    ];

    /// Gears in the order of their tooth numbers.
    #[must_use]
    pub const fn gears(self) -> &'static [GearPlace] {
        use SimpleGear::{Planet, Ring, Sun};
        match self {
            Self::Stepped => const { &[SUN, FIRST, SECOND, GearPlace { step: 1, ..RING }] },
            Self::SteppedSuns => {
                const { &[gear("first_sun", 'a', Sun, 0), FIRST, SECOND, gear("second_sun", 'c', Sun, 1)] }
            }
            Self::SteppedRings => const { &[FIRST_RING, FIRST, SECOND, SECOND_RING] },
            Self::Wolfrom => const { &[SUN, FIRST, FIRST_RING, SECOND, SECOND_RING] },
            Self::Ravigneaux => {
                const {
                    &[
                        gear("small_sun", 'a', Sun, 0),
                        gear("short_planet", 'g', Planet, 0),
                        gear("long_planet", 'f', Planet, 0),
                        gear("large_sun", 'c', Sun, 0),
                        RING,
                    ]
                }
            }
            Self::ExternalPair => const { &[gear("gear_1", '1', Sun, 0), gear("gear_2", '2', Sun, 0)] },
            Self::InternalPair => const { &[gear("gear_1", '1', Sun, 0), gear("gear_2", '2', Ring, 0)] },
        }
    }

    /// Gears of each mesh, by their place in [`gears`](Self::gears); an internal gear is the second.
    #[must_use]
    pub const fn meshes(self) -> &'static [[usize; 2]] {
        match self {
            Self::Stepped => &[[0, 1], [2, 3]],
            Self::SteppedSuns => &[[0, 1], [3, 2]],
            Self::SteppedRings => &[[1, 0], [2, 3]],
            Self::Wolfrom => &[[0, 1], [1, 2], [3, 4]],
            Self::Ravigneaux => &[[0, 1], [1, 2], [3, 2], [2, 4]],
            Self::ExternalPair | Self::InternalPair => &[[0, 1]],
        }
    }

    /// Whether both gears turn on fixed axes.
    #[must_use]
    pub const fn is_pair(self) -> bool {
        matches!(self, Self::ExternalPair | Self::InternalPair)
    }

    /// Whether its planet has steps, whose modules may differ.
    #[must_use]
    pub const fn has_steps(self) -> bool {
        !self.is_pair() && !matches!(self, Self::Ravigneaux)
    }

    /// Planet in mesh with a central gear.
    pub(crate) fn planet_of(self, central: usize) -> Option<usize> {
        self.meshes().iter().find_map(|&[one, other]| match central {
            of if of == one => Some(other),
            of if of == other => Some(one),
            _ => None,
        })
    }

    /// Speed of a central gear relative to the carrier, over a factor that all have in common, as numerator
    /// and denominator.
    pub(crate) fn speed<T: Copy + Neg<Output = T> + From<i32>>(
        self,
        gear: usize,
        teeth: &[T; MOST_GEARS],
    ) -> [T; 2] {
        let role = self.gears()[gear].role;
        let (one, own) = (T::from(1), teeth[gear]);
        // A factor that all speeds have cancels in every ratio, and so is left out.
        match self {
            Self::Ravigneaux => [if gear == 3 { one } else { -one }, own],
            Self::ExternalPair if gear == 1 => [-one, own],
            Self::ExternalPair | Self::InternalPair => [one, own],
            _ => {
                let planet = self.planet_of(gear).map_or(one, |planet| teeth[planet]);
                [if role == SimpleGear::Ring { planet } else { -planet }, own]
            }
        }
    }

    /// Members that may drive, be driven or rest: the central gears, then the carrier.
    fn members(self) -> Vec<ArrangementMember> {
        let places = (0..).zip(self.gears());
        let centrals = places.filter(|(_, place)| place.role != SimpleGear::Planet);
        let centrals = centrals.map(|(place, _)| ArrangementMember { arrangement: self, gear: Some(place) });
        centrals.chain([ArrangementMember { arrangement: self, gear: None }]).collect()
    }

    /// Modes: one member drives, one is driven, one rests. Of a pair the housing, its carrier, rests.
    #[must_use]
    pub fn modes(self) -> Vec<ArrangementMode> {
        let members = self.members();
        let mut modes = vec![];
        for &fixed in &members {
            for &input in &members {
                for &output in &members {
                    let differ = input != output && fixed != input && fixed != output;
                    if differ && (!self.is_pair() || fixed.gear.is_none()) {
                        modes.push(ArrangementMode { input, output, fixed });
                    }
                }
            }
        }
        modes
    }

    /// The mode of these letters: `ae^b`.
    #[must_use]
    pub fn mode(self, letters: &str) -> Option<ArrangementMode> {
        self.modes().into_iter().find(|mode| mode.to_string() == letters)
    }

    /// Usual mode: from the first member to the last one that is driven in practice.
    #[must_use]
    pub const fn usual_mode(self) -> &'static str {
        match self {
            Self::Stepped => "aH^b",
            Self::SteppedSuns => "Ha^c",
            Self::SteppedRings => "He^b",
            Self::Wolfrom => "ae^b",
            Self::Ravigneaux => "ab^c",
            Self::ExternalPair | Self::InternalPair => "12^H",
        }
    }
}

impl fmt::Display for Arrangement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Stepped => "set with a stepped planet",
            Self::SteppedSuns => "set with a stepped planet and two suns",
            Self::SteppedRings => "set with a stepped planet and two rings",
            Self::Wolfrom => "Wolfrom set",
            Self::Ravigneaux => "Ravigneaux set",
            Self::ExternalPair => "external pair",
            Self::InternalPair => "internal pair",
        })
    }
}

/// Member of an arrangement: a central gear or the carrier.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ArrangementMember {
    arrangement: Arrangement,
    /// Place of the central gear, in a byte since modes are parts of errors; `None` for the carrier.
    gear: Option<u8>,
}

impl ArrangementMember {
    /// Place of the central gear; `None` for the carrier.
    #[must_use]
    pub fn gear(self) -> Option<usize> {
        self.gear.map(usize::from)
    }

    /// Name of the member as a key; the carrier of a pair is the housing.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self.gear() {
            Some(gear) => self.arrangement.gears()[gear].name,
            None if self.arrangement.is_pair() => "housing",
            None => "carrier",
        }
    }

    /// Letter of the member, `H` for the carrier.
    #[must_use]
    pub fn symbol(self) -> char {
        self.gear().map_or('H', |gear| self.arrangement.gears()[gear].symbol)
    }
}

impl fmt::Display for ArrangementMember {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.name().replace('_', " "))
    }
}

/// Mode of an arrangement: which member drives, which is driven, which rests. All others turn freely.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ArrangementMode {
    /// Driving member.
    pub input: ArrangementMember,
    /// Driven member.
    pub output: ArrangementMember,
    /// Member at rest.
    pub fixed: ArrangementMember,
}

impl ArrangementMode {
    /// Driving, driven and resting member.
    #[must_use]
    pub const fn members(self) -> [ArrangementMember; 3] {
        [self.input, self.output, self.fixed]
    }
}

impl fmt::Display for ArrangementMode {
    /// `ae^b`: from `a` to `e`, `b` at rest.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [input, output, fixed] = self.members().map(ArrangementMember::symbol);
        write!(f, "{input}{output}^{fixed}")
    }
}
