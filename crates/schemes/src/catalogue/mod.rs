//! The source's catalogue: schemes I, II, III of two speeds and I-1…III-3 of three.
//!
//! | module | answers |
//! |---|---|
//! | [`simple_set`] | the six ratios of a set and its four relations of speeds |
//! | [`scheme`] | any of the fourteen |
//! | [`table`] | what the fourteen are: names, links, closed forms |
//! | [`gear`] | gears and shift elements of a scheme |
//! | [`range`] | which k are used, and what a quantity does over them |
//! | [`two_speed`] | I, II, III: ratio, efficiency, k from a ratio |
//! | [`three_speed`] | I-1…III-3: the same of the second gear |
//!
//! A scheme says which link each member of its sets belongs to: driving shaft D, driven shaft B, the
//! braked links T₁, T₂. Gear 1 brakes T₁, gear 2 of a three-speed scheme brakes T₂, and a clutch between
//! D and B gives direct drive. Any two links could be joined for that; the choice changes the clutch's
//! torque, not the ratio.
//!
//! The closed forms are fast paths; the solver is the truth they are tested against.
//!
//! ```
//! use epicyclic_gears::{efficiency::MeshEfficiency, simple_set::RingToSunRatio};
//! use epicyclic_schemes::catalogue::{ThreeSpeed, TwoSpeed};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // Section 3.3, first variation: II with k₁ = 2.15, then II-3 with k₂ = 2.354.
//! let scheme: ThreeSpeed = "II-3".parse()?;
//! let k1 = scheme.first_stage().ring_to_sun_ratio(1.465)?;
//! let k2 = scheme.second_ring_to_sun_ratio(k1, 2.56)?;
//! assert!((k1.get() - 2.1505).abs() < 1e-4 && (k2.get() - 2.3548).abs() < 1e-4);
//! let eta0 = MeshEfficiency::new(0.97)?;
//! let gearbox = scheme.gearbox(k1, k2, eta0)?;
//! let second = gearbox.analyze("2")?;
//! assert!((second.ratio().unwrap() - scheme.ratio(k1, k2)).abs() < 1e-12);
//! assert!((second.efficiency().unwrap() - scheme.efficiency(k1, k2, eta0)).abs() < 1e-12);
//! # Ok(())
//! # }
//! ```
//!
//! # Source
//! multispeed-gearboxes, sections 2.3 and 2.4.

pub mod gear;
pub mod range;
pub mod scheme;
pub mod simple_set;
pub mod table;
pub mod three_speed;
pub mod two_speed;

pub use gear::{SchemeElement, SchemeGear};
pub use range::{Reach, RingToSunRange};
pub use scheme::Scheme;
pub use three_speed::ThreeSpeed;
pub use two_speed::TwoSpeed;

use epicyclic_gears::simple_set::Member;
use std::fmt;

/// Whether a name is that of a scheme, in capital or small letters, in Latin ones or in the Cyrillic ones
/// that look alike.
fn is_name(of_scheme: &str, name: &str) -> bool {
    let latin = |c: char| match c {
        'І' | 'і' | 'Ӏ' => 'I',
        '–' | '−' => '-',
        c => c,
    };
    let name: String = name.trim().chars().map(latin).collect();
    of_scheme.eq_ignore_ascii_case(&name)
}

/// Role of a link in a scheme.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", schemars(rename = "Link"))]
pub enum Role {
    /// `D`, the driving shaft.
    D,
    /// `B`, the driven shaft.
    B,
    /// `T₁`, braked in gear 1.
    T1,
    /// `T₂`, braked in gear 2.
    T2,
}

impl Role {
    /// The source's letter, and the link's name in a scheme's [`Gearbox`](epicyclic_train::Gearbox).
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::D => "D",
            Self::B => "B",
            Self::T1 => "T1",
            Self::T2 => "T2",
        }
    }

    /// The role with D and B exchanged.
    #[must_use]
    pub const fn reversed(self) -> Self {
        match self {
            Self::D => Self::B,
            Self::B => Self::D,
            brake => brake,
        }
    }
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.symbol())
    }
}

/// The member of a set that belongs to a link.
pub(crate) fn with_role(set: [Role; 3], role: Role) -> Option<Member> {
    Member::ALL.into_iter().zip(set).find_map(|(member, of)| (of == role).then_some(member))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_may_be_in_cyrillic_letters() {
        for (name, scheme) in [("ІІІ-1", "III-1"), ("ii–3", "II-3"), (" І ", "I")] {
            assert_eq!(name.parse::<Scheme>().unwrap().name(), scheme);
        }
    }
}
