//! A load factor of the command line.

use epicyclic_strength::factor::Symbol;
use epicyclic_units::Number;
use std::str::FromStr;

/// A factor by its symbol: `K_A 1.5`, `K_A=1.5` or `K_A: 1.5`.
#[derive(Debug, Clone, PartialEq)]
pub struct Factor {
    /// Symbol as it was written; a symbol has several spellings.
    pub name: String,
    pub(super) symbol: Symbol,
    /// Value of the factor.
    pub value: f64,
}

impl FromStr for Factor {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = || format!("{text}: write a symbol and a number, as K_A 1.5");
        let (name, value) =
            text.rsplit_once(['=', ':']).or_else(|| text.trim().rsplit_once(' ')).ok_or_else(form)?;
        let value: Number = value.trim().parse().map_err(|_| form())?;
        let name = name.trim();
        let symbol = Symbol::named(name).ok_or_else(|| {
            let all: Vec<String> = Symbol::ALL.iter().map(Symbol::to_string).collect();
            format!("{text}: no factor is called `{name}`; there are {}", all.join(", "))
        })?;
        let value = symbol.checked(value.get()).map_err(|error| format!("{text}: {error}"))?;
        Ok(Self { name: name.to_owned(), symbol, value })
    }
}
