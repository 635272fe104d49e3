//! The gears of a scheme, and what is engaged in them.

/// A gear of a scheme.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SchemeGear {
    /// T₁ is braked.
    First,
    /// T₂ is braked.
    Second,
    /// Direct drive.
    Direct,
}

impl SchemeGear {
    /// The braked gears.
    pub const BRAKED: [Self; 2] = [Self::First, Self::Second];

    /// Name of the gear in a scheme's gearbox.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::First => "1",
            Self::Second => "2",
            Self::Direct => "direct",
        }
    }

    /// The one shift element that is engaged in the gear.
    #[must_use]
    pub const fn engaged(self) -> SchemeElement {
        match self {
            Self::First => SchemeElement::FirstBrake,
            Self::Second => SchemeElement::SecondBrake,
            Self::Direct => SchemeElement::DirectClutch,
        }
    }
}

/// A shift element of a scheme.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SchemeElement {
    /// The brake of T₁.
    FirstBrake,
    /// The brake of T₂.
    SecondBrake,
    /// The direct-drive clutch.
    DirectClutch,
}

impl SchemeElement {
    /// Name of the element in a scheme's gearbox.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::FirstBrake => "K1",
            Self::SecondBrake => "K2",
            Self::DirectClutch => "L",
        }
    }
}
