//! The gears of a scheme, and what is engaged in them.

/// A gear of a scheme.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", schemars(rename = "GearName"))]
pub enum SchemeGear {
    /// T₁ is braked.
    #[cfg_attr(feature = "names", serde(rename = "1"))]
    First,
    /// T₂ is braked.
    #[cfg_attr(feature = "names", serde(rename = "2"))]
    Second,
    /// Direct drive.
    #[cfg_attr(feature = "names", serde(rename = "direct"))]
    Direct,
}

impl SchemeGear {
    /// The braked gears.
    pub const BRAKED: [Self; 2] = [Self::First, Self::Second];

    /// The gear of this name in a scheme's gearbox.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        [Self::First, Self::Second, Self::Direct].into_iter().find(|gear| gear.name() == name)
    }

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

impl std::fmt::Display for SchemeGear {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.name())
    }
}

/// A shift element of a scheme.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", schemars(rename = "ShiftElement"))]
pub enum SchemeElement {
    /// The brake of T₁, engaged in gear 1.
    #[cfg_attr(feature = "names", serde(rename = "K1"))]
    FirstBrake,
    /// The brake of T₂, engaged in gear 2.
    #[cfg_attr(feature = "names", serde(rename = "K2"))]
    SecondBrake,
    /// The direct-drive clutch.
    #[cfg_attr(feature = "names", serde(rename = "L"))]
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
