//! Selection of the solutions of a search.

use super::drawn;
use super::kept::Kept;
use super::left_out::{LeftOuts, Reason};
use super::wanted::Wanted;
use crate::error::Error;
use epicyclic_synthesis::judge::judge_all;
use epicyclic_synthesis::run::Found;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::{family, rank};
use std::ops::ControlFlow;

/// Evaluates solutions and keeps those within all limits; the others are counted by reason.
pub(super) fn keep(
    mut found: Vec<Found>,
    wish: &Wish,
    wanted: &Wanted,
    selection: &[usize],
    left_out: &mut LeftOuts,
    judged: &(dyn Fn(usize) -> ControlFlow<()> + Sync),
    rated: &dyn Fn() -> ControlFlow<()>,
) -> Result<Vec<Kept>, Error> {
    if wanted.drawable {
        let mut drawable = Vec::new();
        for mut one in found {
            if drawn::choose(&mut one, &wish.rules)? {
                drawable.push(one);
            } else {
                left_out.add(Reason::Drawable, 1);
            }
        }
        found = drawable;
    }
    let mut kept = Vec::new();
    let judgements = judge_all(&found, wish, wanted.efficiency, judged)?;
    for (found, judged) in found.into_iter().zip(judgements) {
        let Some(judged) = judged.filter(|_| rated().is_continue()) else {
            left_out.add(Reason::Unjudged, 1);
            continue;
        };
        if !wish.are_falling(&judged.ratios) {
            left_out.add(Reason::Order, 1);
            continue;
        }
        match wanted.limits.missed(&wish.gears, &judged) {
            Some(limit) => left_out.add(Reason::of(limit), 1),
            None => {
                let shares: Option<Vec<f64>> =
                    wanted.shares.as_ref().map(|of| selection.iter().map(|gear| of[*gear]).collect());
                let rating = rank::Rating::of(&judged, shares.as_deref())?;
                let fault = wanted.usable.and_then(|usable| usable.fault(&judged, &rating));
                let family = family::Family::of(&found, wish, selection);
                let selection = selection.to_vec();
                kept.push(Kept {
                    found,
                    judged,
                    selection,
                    rating,
                    fault,
                    number: 0,
                    family,
                    teeth: Vec::new(),
                    shift: None,
                });
            }
        }
    }
    Ok(kept)
}
