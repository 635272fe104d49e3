//! The members of a gear set of two central gears, and the six modes in which it is used.

use std::fmt;

/// A basic member of a gear set: the three that turn about its axis.
///
/// In a set of two suns or two rings (stepped planets, meshing suns) and in a bevel set, `Sun` is
/// the first central gear and `Ring` the second.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Member"))]
pub enum Member {
    /// Central gear `a`, the sun.
    Sun,
    /// Central gear `b`, the ring.
    Ring,
    /// Carrier `H`.
    Carrier,
}

impl Member {
    /// The three members, in the order of the set's equation.
    pub const ALL: [Self; 3] = [Self::Sun, Self::Ring, Self::Carrier];

    /// The source's letter: `a`, `b` or `H`.
    #[must_use]
    pub fn symbol(self) -> char {
        match self {
            Self::Sun => 'a',
            Self::Ring => 'b',
            Self::Carrier => 'H',
        }
    }
}

impl fmt::Display for Member {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sun => "sun",
            Self::Ring => "ring",
            Self::Carrier => "carrier",
        })
    }
}

/// Mode of a gear set with one member at rest: which member drives and which is driven; one of six.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Mode {
    input: Member,
    output: Member,
}

impl Mode {
    /// `aH^b`: from the sun to the carrier, ring at rest.
    pub const SUN_TO_CARRIER: Self = Self { input: Member::Sun, output: Member::Carrier };

    /// The six modes in the order of multispeed-gearboxes, table 2.2:
    /// `ab^H`, `aH^b`, `bH^a`, `ba^H`, `Ha^b`, `Hb^a`.
    pub const ALL: [Self; 6] = {
        use Member::{Carrier, Ring, Sun};
        [
            Self { input: Sun, output: Ring },
            Self { input: Sun, output: Carrier },
            Self { input: Ring, output: Carrier },
            Self { input: Ring, output: Sun },
            Self { input: Carrier, output: Sun },
            Self { input: Carrier, output: Ring },
        ]
    };

    /// The mode from one member to another; none from a member to itself.
    pub(crate) fn between(input: Member, output: Member) -> Option<Self> {
        (input != output).then_some(Self { input, output })
    }

    /// The driving member.
    #[must_use]
    pub fn input(self) -> Member {
        self.input
    }

    /// The driven member.
    #[must_use]
    pub fn output(self) -> Member {
        self.output
    }

    /// The member at rest.
    #[must_use]
    pub fn fixed(self) -> Member {
        match (self.input, self.output) {
            (Member::Sun, Member::Ring) | (Member::Ring, Member::Sun) => Member::Carrier,
            (Member::Sun, _) | (_, Member::Sun) => Member::Ring,
            _ => Member::Sun,
        }
    }
}

impl fmt::Display for Mode {
    /// The field's notation: `aH^b` reads "from the sun to the carrier, ring at rest".
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { input, output } = self;
        write!(f, "{}{}^{}", input.symbol(), output.symbol(), self.fixed().symbol())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fixed_member_is_the_third() {
        let named: Vec<String> = Mode::ALL.iter().map(ToString::to_string).collect();
        assert_eq!(named, ["ab^H", "aH^b", "bH^a", "ba^H", "Ha^b", "Hb^a"]);
    }
}
