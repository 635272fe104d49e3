//! Shifts as courses of torque capacities.
//!
//! A shift at time `t` has a release ramp of duration `r`, an apply ramp of duration `a`, and an overlap `o`:
//!
//! ```text
//! o ≤ r   released from t to t + r              applied from t + r − o to t + r − o + a
//! o > r   released from t + o − r to t + o      applied from t to t + a
//! ```

use super::parts::{Ramps, Scenario};
use super::{ABOVE_0, AT_LEAST_0, refused, root};
use crate::error::Error;
use crate::shared::fault::Named;
use epicyclic_formats::scenario::{ElementEntry, ShiftEntry};
use epicyclic_motion::{self as motion, Course};
use epicyclic_units::{Physical, Quantity};
use uom::si::f64::{Time, Torque};

/// Shifts of a scenario, and the elements engaged at the start.
pub(super) struct Program {
    engaged: Vec<String>,
    pub(super) shifts: Vec<Ramps>,
}

impl Program {
    pub(super) fn of(scenario: &Scenario<'_>) -> Result<Self, Error> {
        let (document, file) = (scenario.document, scenario.file);
        let has_holding = file.elements.iter().position(|one| one.holding.is_some());
        let Some(gear) = &file.gear else {
            let why = Named("no-gear", "it needs the gear at the start: give the key gear, too");
            return match has_holding {
                _ if !file.shifts.is_empty() => Err(refused(document, &root("shifts"), &why)),
                Some(place) => Err(refused(document, &root("elements").index(place).key("holding"), &why)),
                None => Ok(Self { engaged: vec![], shifts: vec![] }),
            };
        };
        let mut engaged = Self::engaged(scenario, gear, &root("gear"))?;
        let (first, mut from) = (engaged.clone(), gear.clone());
        let mut shifts: Vec<Ramps> = vec![];
        for (place, entry) in file.shifts.iter().enumerate() {
            let path = root("shifts").index(place);
            let next = Self::engaged(scenario, &entry.to, &path.clone().key("to"))?;
            let without = |all: &[String], others: &[String]| {
                all.iter().filter(|one| !others.contains(one)).cloned().collect::<Vec<_>>()
            };
            let [release, apply] = times(scenario, place, entry)?;
            let at = entry.at.0.si();
            if let Some(before) = shifts.last()
                && at < before.end()
            {
                let message = format!(
                    "at {} the shift before is not over: its ramps end at {}, and shifts do not overlap",
                    Quantity(Time::from_si(at)),
                    Quantity(Time::from_si(before.end()))
                );
                return Err(refused(document, &path.key("at"), &Named("overlap", message)));
            }
            if next == engaged {
                let message =
                    format!("gear {} engages what gear {from} engages: nothing is shifted", entry.to);
                return Err(refused(document, &path.key("to"), &Named("no-shift", message)));
            }
            shifts.push(Ramps {
                at,
                from: std::mem::replace(&mut from, entry.to.clone()),
                to: entry.to.clone(),
                released: without(&engaged, &next),
                release,
                applied: without(&next, &engaged),
                apply,
            });
            engaged = next;
        }
        Ok(Self { engaged: first, shifts })
    }

    /// Elements that a gear engages by friction.
    fn engaged(
        scenario: &Scenario<'_>,
        gear: &str,
        path: &epicyclic_formats::Path,
    ) -> Result<Vec<String>, Error> {
        let (document, file, gearbox) = (scenario.document, scenario.file, &scenario.subject.train);
        let found = gearbox.gear(gear).map_err(|why| refused(document, path, &why))?;
        let mut all = vec![];
        for &place in found.engaged() {
            let element = &gearbox.shift_elements()[place];
            let id = element.id();
            if element.is_one_way() || file.engaged.iter().any(|one| one == id) {
                continue;
            }
            match file.elements.iter().find(|one| one.id == id) {
                Some(entry) if entry.holding.is_some() => all.push(id.to_owned()),
                Some(_) => {}
                None => {
                    let message = format!(
                        "gear {gear} engages {id}: give it an entry in elements, or name it in engaged"
                    );
                    return Err(refused(document, path, &Named("no-element", message)));
                }
            }
        }
        all.sort();
        Ok(all)
    }

    /// Torque capacity over time of an element that is engaged and released by shifts.
    pub(super) fn course(&self, entry: &ElementEntry) -> Result<Course, motion::Error> {
        let holding = entry.holding.map_or(Torque::from_si(0.0), |torque| torque.0);
        let open = Torque::from_si(0.0);
        let begins = if self.engaged.contains(&entry.id) { holding } else { open };
        let mut points = vec![(Time::from_si(0.0), begins)];
        for shift in &self.shifts {
            let ramp = if shift.released.contains(&entry.id) {
                [(shift.release[0], holding), (shift.release[1], open)]
            } else if shift.applied.contains(&entry.id) {
                [(shift.apply[0], open), (shift.apply[1], holding)]
            } else {
                continue;
            };
            for (time, torque) in ramp {
                let point = (Time::from_si(time), torque);
                if points.last() != Some(&point) {
                    points.push(point);
                }
            }
        }
        Course::table(&points)
    }
}

/// Start and end of the release ramp and of the apply ramp of a shift.
fn times(scenario: &Scenario<'_>, place: usize, entry: &ShiftEntry) -> Result<[[f64; 2]; 2], Error> {
    let path = root("shifts").index(place);
    let positive = |key: &str, time: f64| {
        let refuse = || refused(scenario.document, &path.clone().key(key), &ABOVE_0);
        if time > 0.0 { Ok(time) } else { Err(refuse()) }
    };
    let (at, overlap) = (entry.at.0.si(), entry.overlap.map_or(0.0, |time| time.0.si()));
    if at < 0.0 {
        return Err(refused(scenario.document, &path.clone().key("at"), &AT_LEAST_0));
    }
    let release = positive("release", entry.release.0.si())?;
    let apply = positive("apply", entry.apply.0.si())?;
    let [released, applied] =
        if overlap <= release { [at, at + release - overlap] } else { [at + overlap - release, at] };
    Ok([[released, released + release], [applied, applied + apply]])
}
