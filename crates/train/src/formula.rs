//! The ratio of a gear as a formula, `i = (1 + k₁ + k₁·k₂)/(k₁·k₂)`, and the way to it.
//!
//! # Symbols
//! Each equation of a set has a symbol of its own, the size of a basic ratio:
//!
//! ```text
//! ω_1 − i₀·ω_2 − (1 − i₀)·ω_H = 0        i₀ = −k or i₀ = +k, as the meshes say
//! ```
//!
//! | set | 1, 2 | `i₀` | symbol |
//! |---|---|---|---|
//! | simple | sun, ring | `−k` | `k = z_2/z_1` |
//! | double planet | sun, ring | `+k` | `k = z_2/z_1` |
//! | any other of two central gears | as in [`SetKind`](crate::set::SetKind) | as there | `k` or `u` |
//! | compound | each central gear, the gear of reference | `±k` | `k = ∣ω_1 − ω_H∣/∣ω_2 − ω_H∣` |
//!
//! Pairs on fixed axes have the symbol `u`, other sets `k`. The gear of reference is the first ring, or the
//! first central gear if the set has no ring. The formula of `k` in teeth follows from the meshes between the
//! two gears; teeth that occur on both sides cancel. Symbols are numbered as the equations of the gearbox
//! are: without compound sets `k₁` belongs to set 1.
//!
//! # Method
//! Links joined to one piece by engaged shift elements or permanent connections are one node. The links of a
//! set that turns as a block are one node too, and so are the two gears of a basic ratio of exactly 1. Of the
//! other equations only those count that determine the output's speed. Both speeds are determinants, and each
//! `k` occurs in one equation, so numerator and denominator of
//!
//! ```text
//! i = ω_in/ω_out = det C/det C_out
//! ```
//!
//! are polynomials of the first degree in every `k`. They split into factors that share no `k`, and common
//! factors cancel ([`polynomial`]).
//!
//! # What is left out
//! Losses: this is the ratio of speeds.

pub mod polynomial;
pub mod quotient;
pub mod steps;
pub mod symbol;
mod system;

use crate::tolerance::MOST_SYMBOLS;
use crate::{Analysis, State};
use epicyclic_gears::simple_set::Fraction;
use quotient::Quotient;
use symbol::Symbol;
use system::System;

/// The ratio of a gear as a formula.
///
/// ```
/// use epicyclic_train::{Gearbox, formula::Formula, set::SetSpec};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let gearbox = Gearbox::builder("II-3")
///     .links(["D", "B", "T1", "T2"])
///     .set(SetSpec::simple("1", ["T1", "D", "B"], 2.15))
///     .set(SetSpec::simple("2", ["T1", "B", "T2"], 2.354))
///     .brake("K2", "T2")
///     .input("D")
///     .output("B")
///     .gear("2", ["K2"])
///     .build()?;
/// let second = gearbox.analyze("2")?;
/// let formula = Formula::new(&second)?;
/// assert_eq!(formula.text(), "(1 + k₁ + k₂)/k₁");
/// assert!((formula.value() - second.ratio().unwrap()).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct Formula {
    ratio: Quotient,
    symbols: Vec<Symbol>,
    spare: Vec<usize>,
    system: System,
}

/// Why a gear has no formula.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoFormula {
    /// The gear has no ratio.
    #[error("the gear has no ratio: {0}")]
    NoRatio(State),
    /// The ratio needs more symbols than allowed.
    #[error("the ratio needs {symbols} basic ratios, and a formula takes at most {most}")]
    TooLarge {
        /// Symbols that it needs.
        symbols: usize,
        /// Symbols that are taken.
        most: usize,
    },
    /// Speeds that nothing gives cancel at these numbers alone.
    #[error("the ratio exists with these numbers of teeth alone: it has no formula")]
    TheseNumbersAlone,
}

impl Formula {
    /// The formula of a gear that has a ratio.
    ///
    /// # Errors
    /// [`NoFormula`].
    pub fn new(analysis: &Analysis<'_>) -> Result<Self, NoFormula> {
        if analysis.ratio().is_none() {
            return Err(NoFormula::NoRatio(analysis.state().clone()));
        }
        let gearbox = analysis.gearbox();
        let system = System::new(gearbox, analysis.gear()).ok_or(NoFormula::TheseNumbersAlone)?;
        let symbols: Vec<Symbol> =
            system.equations().iter().map(|&equation| Symbol::of(gearbox, equation)).collect();
        if symbols.len() > MOST_SYMBOLS {
            return Err(NoFormula::TooLarge { symbols: symbols.len(), most: MOST_SYMBOLS });
        }
        let [input, output] = system.determinants(&symbols);
        let ratio = Quotient::new(&input, &output).ok_or(NoFormula::TheseNumbersAlone)?;
        let spare = system.spare(gearbox);
        Ok(Self { ratio, symbols, spare, system })
    }

    /// The quotient. Its symbols are places in [`symbols`](Self::symbols).
    #[must_use]
    pub fn ratio(&self) -> &Quotient {
        &self.ratio
    }

    /// The symbols of the equations that the output's speed needs, by the places of the equations in the
    /// gearbox.
    #[must_use]
    pub fn symbols(&self) -> &[Symbol] {
        &self.symbols
    }

    /// Places in [`symbols`](Self::symbols) of those that occur in the ratio.
    pub fn occurring(&self) -> impl Iterator<Item = usize> {
        let all = self.ratio.variables();
        (0..self.symbols.len()).filter(move |symbol| all >> symbol & 1 == 1)
    }

    /// Sets whose equations follow from those of the others in this gear and are not used. The formula then
    /// holds only at numbers of teeth for which they follow.
    #[must_use]
    pub fn spare(&self) -> &[usize] {
        &self.spare
    }

    /// `(1 + k₁ + k₂)/k₁`.
    #[must_use]
    pub fn text(&self) -> String {
        self.ratio.text(&|symbol| self.symbols[symbol].name())
    }

    /// Value of the ratio at the gearbox's numbers.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.ratio.value(&|symbol| self.symbols[symbol].value())
    }

    /// Exact value of the ratio, if the teeth are known and the integers do not overflow.
    #[must_use]
    pub fn exact_value(&self) -> Option<Fraction> {
        let exact = self.symbols.iter().map(Symbol::exact).collect::<Option<Vec<_>>>()?;
        self.ratio.exact_value(&exact)
    }

    pub(crate) fn system(&self) -> &System {
        &self.system
    }
}

/// `k₁₂` of `k` and 12.
#[must_use]
pub fn subscript(letter: char, number: usize) -> String {
    let digits = number.to_string();
    let index = digits.chars().filter_map(|digit| char::from_u32('₀' as u32 + digit.to_digit(10)?));
    std::iter::once(letter).chain(index).collect()
}
