//! All factors of a set in one table: a column for each gear in each of its meshes.

use super::words::{OF_STEPS, extent, from};
use crate::strength::answer::Strength;
use crate::strength::answer::records::{OverDuty, Rated};
use crate::table::columns::Table;
use crate::table::report::Records;

/// A factor of a gear in a mesh: symbol, value as it is shown, and formula.
struct Told {
    symbol: String,
    value: String,
    formula: Option<String>,
}

/// A gear in a mesh with its factors.
struct InMesh {
    heading: String,
    factors: Vec<Told>,
}

/// A table for each set; none where no factors are told.
pub(super) fn factors(strength: &Strength) -> Vec<Records> {
    let of_point = at_point(strength).into_iter().map(|(title, all)| table(title, "", &all));
    let of_duty = over_duty(&strength.over_duty).into_iter();
    of_point.chain(of_duty.map(|(title, all)| table(title, OF_STEPS, &all))).collect()
}

/// Of each set the gear in which a safety of it is least over what is required.
fn at_point(strength: &Strength) -> Vec<(String, Vec<InMesh>)> {
    let over = |one: &Rated| {
        let required = strength.required;
        let over =
            |safety: Option<f64>, required: f64| safety.map_or(f64::INFINITY, |safety| safety / required);
        over(one.flank_safety, required.flank).min(over(one.root_safety, required.root))
    };
    let mut sets: Vec<&str> = strength.at_point.iter().map(|one| one.set.as_str()).collect();
    sets.sort_unstable();
    sets.dedup();
    let of_set = |set: &str| {
        let own = || strength.at_point.iter().filter(|one| one.set == set);
        let gear = &own().min_by(|one, other| over(one).total_cmp(&over(other)))?.gear;
        let in_mesh = |one: &Rated| InMesh {
            heading: one.mesh.gear_among(&one.toothed_gear, own().map(|one| &one.mesh)),
            factors: one
                .factors
                .iter()
                .map(|factor| Told {
                    symbol: factor.symbol.clone(),
                    value: format!("{:.4}", factor.value),
                    formula: factor.formula.clone(),
                })
                .collect(),
        };
        let all = own().filter(|one| one.gear == *gear).map(in_mesh).collect();
        Some((format!("Factors of set {set} in gear {gear}"), all))
    };
    sets.into_iter().filter_map(of_set).collect()
}

fn over_duty(all: &[OverDuty]) -> Vec<(String, Vec<InMesh>)> {
    let of_set = |set: &[OverDuty]| {
        let in_mesh = |one: &OverDuty| InMesh {
            heading: one.mesh.gear_among(&one.toothed_gear, set.iter().map(|one| &one.mesh)),
            factors: one
                .factors
                .iter()
                .map(|factor| Told {
                    symbol: factor.symbol.clone(),
                    value: extent(factor),
                    formula: factor.formula.clone(),
                })
                .collect(),
        };
        (format!("Factors of set {} over the duty", set[0].set), set.iter().map(in_mesh).collect())
    };
    all.chunk_by(|one, other| one.set == other.set).map(of_set).collect()
}

/// A row for each factor, and for each formula where the gears have it by several.
fn table(title: String, note: &str, all: &[InMesh]) -> Records {
    let mut rows = vec![];
    // A flank or root that is not rated has no factors: the gear with most of them has the whole chain in
    // order.
    let longest = all.iter().max_by_key(|one| one.factors.len());
    for Told { symbol, .. } in longest.map_or(&[][..], |one| &one.factors[..]) {
        let told: Vec<Option<&Told>> =
            all.iter().map(|one| one.factors.iter().find(|own| own.symbol == *symbol)).collect();
        let mut formulas: Vec<Option<&str>> = vec![];
        for one in told.iter().flatten() {
            if !formulas.contains(&one.formula.as_deref()) {
                formulas.push(one.formula.as_deref());
            }
        }
        rows.extend(formulas.into_iter().map(|formula| (symbol, formula, told.clone())));
    }
    Table::new("factors", rows)
        .text("symbol", "factor", |(symbol, ..)| symbol)
        .each(all.iter().enumerate(), |table, (place, one)| {
            table.number("value", &one.heading, |(_, formula, told)| {
                told[place].filter(|one| one.formula.as_deref() == *formula).map(|one| &*one.value)
            })
        })
        .words("formula", "from", |(_, formula, _)| from(*formula))
        .all(title)
        .note(note)
        .records()
}
