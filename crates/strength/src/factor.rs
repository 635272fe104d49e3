//! A factor with its symbol and where its value comes from.

use crate::Error;
use crate::symbol::SYMBOLS;
pub use crate::symbol::Symbol;
use std::fmt;

/// Edition of ISO 6336 that a calculation follows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Edition {
    /// Parts 1 to 3 of 2006 as first printed: `Z_β = √cos β`.
    Iso2006,
    /// Parts 1 to 3 of 2006 with their corrigenda of 2007 and 2008: `Z_β = 1/√cos β`, as in 2019.
    #[default]
    Iso2006Corrected,
}

impl fmt::Display for Edition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Iso2006 => "ISO 6336:2006",
            Self::Iso2006Corrected => "ISO 6336:2006 with corrigenda of 2007 and 2008",
        })
    }
}

epicyclic_gears::words! {
    /// A document that contains a formula.
    Document {
        Iso6336Part1 "ISO 6336-1:2006"
        Iso6336Part2 "ISO 6336-2:2006"
        Iso6336Part3 "ISO 6336-3:2006"
        Iec61400Part4 "IEC 61400-4"
    }
}

/// Reference of a formula: a document and its clause or formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Reference {
    /// The document.
    pub document: Document,
    /// Clause, or number of the formula: `clause 6.1`, `formula (14)`.
    pub place: &'static str,
}

impl Reference {
    pub(crate) const fn new(document: Document, place: &'static str) -> Self {
        Self { document, place }
    }
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.document, self.place)
    }
}

/// Origin of the value of a factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Origin {
    /// Calculated by this formula.
    Formula(Reference),
    /// Given by the user.
    Given,
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Formula(reference) => reference.fmt(f),
            Self::Given => f.write_str("given"),
        }
    }
}

impl Symbol {
    /// A value given for its factor.
    ///
    /// # Errors
    /// [`Error::GivenFactor`]: not finite, not above 0, or a load factor below 1.
    pub fn checked(self, value: f64) -> Result<f64, Error> {
        let is_allowed = if self.is_at_least_one() { value >= 1.0 } else { value > 0.0 };
        if is_allowed && value.is_finite() {
            Ok(value)
        } else {
            Err(Error::GivenFactor { symbol: self, value })
        }
    }
}

/// A factor of the calculation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factor {
    /// Symbol of the factor.
    pub symbol: Symbol,
    /// Value; of `Z_E` in √(N/mm²), else without unit.
    pub value: f64,
    /// Origin of the value.
    pub origin: Origin,
}

/// One of the two gears of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The first, external gear.
    First,
    /// The second, external or internal.
    Second,
}

impl Side {
    /// Sides of a mesh, the first gear first.
    pub const BOTH: [Self; 2] = [Self::First, Self::Second];
}

/// Factors that are given instead of calculated.
///
/// ```
/// use epicyclic_strength::factor::{Given, Side, Symbol};
///
/// let given = Given::default().with(Symbol::FaceContact, 1.15).with_of(Side::Second, Symbol::Form, 1.2);
/// assert_eq!(given.of(Side::First, Symbol::FaceContact), Some(1.15));
/// assert_eq!(given.of(Side::First, Symbol::Form), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Given {
    values: [[Option<f64>; SYMBOLS]; 2],
}

impl Given {
    /// Adds a factor of both gears or of the mesh.
    #[must_use]
    pub fn with(self, symbol: Symbol, value: f64) -> Self {
        self.with_of(Side::First, symbol, value).with_of(Side::Second, symbol, value)
    }

    /// Adds a factor of one gear. For a factor of the whole mesh, such as `K_v`, the first gear's counts.
    #[must_use]
    pub fn with_of(mut self, side: Side, symbol: Symbol, value: f64) -> Self {
        self.values[side as usize][symbol as usize] = Some(value);
        self
    }

    /// The load factors of a mesh, `K_A`, `K_γ`, `K_v`, `K_Hβ` and `K_Hα` = `K_Fα`; `K_Fβ` is calculated.
    #[must_use]
    pub fn load_factors([application, sharing, dynamic, face, transverse]: [f64; 5]) -> Self {
        Self::default()
            .with(Symbol::Application, application)
            .with(Symbol::LoadSharing, sharing)
            .with(Symbol::Dynamic, dynamic)
            .with(Symbol::FaceContact, face)
            .with(Symbol::TransverseContact, transverse)
            .with(Symbol::TransverseRoot, transverse)
    }

    /// The factor given for a gear.
    #[must_use]
    pub fn of(&self, side: Side, symbol: Symbol) -> Option<f64> {
        self.values[side as usize][symbol as usize]
    }

    /// The factor as given, or as calculated.
    pub(crate) fn or(
        &self,
        side: Side,
        symbol: Symbol,
        reference: Reference,
        calculated: impl FnOnce() -> Result<f64, Error>,
    ) -> Result<Factor, Error> {
        match self.of(side, symbol) {
            Some(value) => Ok(Factor { symbol, value: symbol.checked(value)?, origin: Origin::Given }),
            None => Ok(Factor { symbol, value: calculated()?, origin: Origin::Formula(reference) }),
        }
    }
}
