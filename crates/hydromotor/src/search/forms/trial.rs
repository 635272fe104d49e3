//! Forms on one motor: which are admissible, and which need not be tried.

use std::collections::BTreeMap;

use super::cover::{Cover, Value};
use super::found::Counts;
use super::shape::Shape;
use super::{FormSearch, Objective};
use crate::profile::ToothForm;
use crate::profile::kept::{Room, SatelliteForm, contact_ratio};

/// The forms on satellites of each number of teeth, those that may have the greatest contact ratio first, and why others fail.
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
                        Err(failure) => counts.fail(failure),
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

/// What became of the forms on a motor.
pub(super) struct Tried {
    pub(super) counts: Counts,
    /// Admissible points that nothing found before is as good as: place of the form, contact ratio, objectives.
    pub(super) admissible: Vec<(usize, f64, Value)>,
}

pub(super) fn tried(
    search: &FormSearch,
    shape: &Shape,
    of_shape: Value,
    forms: &Forms,
    cover: &Cover,
    slack: f64,
) -> Tried {
    let mut admissible = Vec::new();
    let Some((forms, failed)) = forms.of.get(&shape.numbers.satellite_teeth()) else {
        return Tried { counts: Counts::default(), admissible };
    };
    let mut counts = failed.clone();
    let best = |form: &SatelliteForm| search.value(of_shape, form.greatest_contact_ratio());
    // The first form may have the greatest contact ratio of all.
    if forms.first().is_none_or(|(_, form)| cover.is_as_good(&best(form), slack)) {
        counts.as_good += forms.len() as u64;
        return Tried { counts, admissible };
    }
    let mut near = cover.near(&of_shape, slack, |i| i != Objective::ContactRatio as usize);
    let motor = shape.motor();
    let mut room = None;
    for (place, form) in forms {
        if near.is_as_good(&best(form), slack) {
            counts.as_good += 1;
            continue;
        }
        let room = room.get_or_insert_with(|| Room::of(&motor, shape.curvatures));
        let least = search.least_contact_ratio;
        let wanted = |ratio: f64| ratio >= least && !near.is_as_good(&search.value(of_shape, ratio), slack);
        match contact_ratio(&motor, room, form, wanted) {
            Ok(Some(ratio)) => {
                counts.admissible += 1;
                let value = search.value(of_shape, ratio);
                near.add(value);
                admissible.push((*place, ratio, value));
            }
            Ok(None) => counts.as_good += 1,
            Err(failure) => counts.fail(failure),
        }
    }
    Tried { counts, admissible }
}
