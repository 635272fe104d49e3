//! Forms on one motor: which are admissible, and which need not be tried.

use std::collections::BTreeMap;

use super::super::point::ported;
use super::counts::Counts;
use super::cover::{Cover, Value};
use super::loaded::{FlankFigures, PitchBound};
use super::shape::Shape;
use super::{FormSearch, Objective};
use crate::profile::ToothForm;
use crate::profile::kept::{Room, SatelliteForm, contact_ratio};

/// The forms on satellites of each number of teeth, those that may have the greatest contact ratio first, and
/// why others fail.
pub(super) struct Forms {
    of: BTreeMap<u32, (Vec<(usize, SatelliteForm)>, Counts)>,
}

impl Forms {
    pub(super) fn new(forms: &[ToothForm], satellites: impl Iterator<Item = u32>) -> Self {
        let mut of = BTreeMap::new();
        for teeth in satellites {
            of.entry(teeth).or_insert_with(|| {
                let (mut kept, mut counts) = (Vec::new(), Counts::default());
                for (place, &form) in forms.iter().enumerate() {
                    match SatelliteForm::new(form, teeth) {
                        Ok(form) => kept.push((place, form)),
                        Err(failure) => counts.refuse(failure),
                    }
                }
                let greatest = |form: &SatelliteForm| form.greatest_contact_ratio();
                kept.sort_by(|(_, one), (_, other)| greatest(other).total_cmp(&greatest(one)));
                (kept, counts)
            });
        }
        Self { of }
    }
}

/// An admissible point.
#[derive(Debug, Clone)]
pub(super) struct Point {
    /// Place of the form.
    pub(super) form: usize,
    pub(super) contact_ratio: f64,
    /// Figures of the flanks, if an objective or a limit needs them.
    pub(super) figures: Option<FlankFigures>,
    pub(super) value: Value,
}

/// Results of the forms on a motor.
pub(super) struct Tried {
    pub(super) counts: Counts,
    /// Admissible points that nothing found before is as good as.
    pub(super) admissible: Vec<Point>,
}

pub(super) fn tried(
    search: &FormSearch,
    shape: &Shape,
    of_shape: Value,
    (all, forms): (&[ToothForm], &Forms),
    cover: &Cover,
    slack: f64,
) -> Tried {
    let mut admissible = Vec::new();
    let Some((forms, failed)) = forms.of.get(&shape.numbers.satellite_teeth()) else {
        return Tried { counts: Counts::default(), admissible };
    };
    let mut counts = failed.clone();
    // The first form may have the greatest contact ratio of all.
    let mut best =
        forms.first().map_or(of_shape, |(_, form)| search.value(of_shape, form.greatest_contact_ratio()));
    for &objective in search.objectives.iter().filter(|objective| objective.is_of_flanks()) {
        best[objective as usize] = f64::INFINITY;
    }
    if forms.is_empty() || cover.is_as_good(&best, slack) {
        counts.as_good += forms.len() as u64;
        return Tried { counts, admissible };
    }
    let of_motor = |i: usize| i < Objective::ContactRatio as usize;
    let mut near = cover.near(&of_shape, slack, of_motor);
    let motor = shape.motor();
    let pitch = PitchBound::of(&motor);
    let (least, needs_flanks) = (search.least_contact_ratio, search.needs_flanks());
    let mut room = None;
    let mut ports = None;
    for (place, form) in forms {
        let chosen = all[*place];
        let at_best = |ratio: f64| search.bound(search.value(of_shape, ratio), &pitch, chosen);
        if near.is_as_good(&at_best(form.greatest_contact_ratio()), slack) {
            counts.as_good += 1;
            continue;
        }
        if let Some(refusal) = search
            .flanks
            .as_ref()
            .and_then(|order| pitch.refusal(order, search.requirements.pressure_drop, chosen))
        {
            counts.refuse(refusal);
            continue;
        }
        let room = room.get_or_insert_with(|| Room::of(&motor, shape.curvatures));
        let wanted = |ratio: f64| ratio >= least && !near.is_as_good(&at_best(ratio), slack);
        let contact_ratio = match contact_ratio(&motor, room, form, wanted) {
            Ok(Some(ratio)) => ratio,
            Ok(None) => {
                counts.as_good += 1;
                continue;
            }
            Err(failure) => {
                counts.refuse(failure);
                continue;
            }
        };
        if let Err(refusal) = ports.get_or_insert_with(|| ported(&motor)) {
            counts.refuse(*refusal);
            continue;
        }
        let mut value = search.value(of_shape, contact_ratio);
        let figures = match needs_flanks.then(|| search.figures(shape, chosen)).flatten() {
            Some(Err(refusal)) => {
                counts.refuse(refusal);
                continue;
            }
            Some(Ok(figures)) => {
                for &objective in &search.objectives {
                    value[objective as usize] = figures.value(objective).unwrap_or(value[objective as usize]);
                }
                Some(figures)
            }
            None => None,
        };
        counts.admissible += 1;
        if !near.is_as_good(&value, slack) {
            near.add(value);
            admissible.push(Point { form: *place, contact_ratio, figures, value });
        }
    }
    Tried { counts, admissible }
}
