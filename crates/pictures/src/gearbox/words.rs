//! Numbers and rows in words.

use epicyclic_schemes::row::{Gearing, Row, RowKind};

/// A number to three decimals, its minus a real one; what rounds to 0 has none.
pub(super) fn decimal(value: f64) -> String {
    let text = format!("{value:.3}");
    if text == "-0.000" { "0.000".into() } else { text.replace('-', "−") }
}

/// A row by its number, name, kind and gearing: `1 (P1): simple, z 48/96, k = 2.000`.
pub(super) fn row(place: usize, row: &Row, gearing: bool) -> String {
    let number = (place + 1).to_string();
    let name = if row.id() == number { String::new() } else { format!(" ({})", row.id()) };
    let mut words = format!("row {number}{name}: {}", row.spec().kind);
    if gearing {
        if let Gearing::Teeth(first, second) = row.spec().gearing {
            words += &format!(", z {}/{}", first.get(), second.get());
        }
        let (symbol, size) = match row.spec().kind {
            RowKind::Simple => ("k", -row.stationary_ratio().get()),
            _ => ("i0", row.stationary_ratio().get()),
        };
        words += &format!(", {symbol} = {}", decimal(size));
    }
    words
}
