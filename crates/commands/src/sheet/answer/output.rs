//! Backlash and torsional stiffness at the output in each gear while the input is held.

use super::records::{Allowed, AtOutput, Limits};
use crate::analyze::answer::analysis;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::tolerance::ROUNDED;
use epicyclic_gears::involute::PlanetSet as ToothedSet;
use epicyclic_gears::involute::play::{Deviation, Part, at_output};
use epicyclic_gears::simple_set::Member;
use epicyclic_strength::load::mesh_stiffness;
use epicyclic_train::{Analysis, Gear};
use epicyclic_units::Physical;
use uom::si::f64::{Length, Torque};

/// Set with known tooth numbers.
pub(super) struct Known {
    /// Place of the set in the gearbox.
    pub(super) place: usize,
    pub(super) set: ToothedSet,
    pub(super) module: Length,
    /// Face width; `None` unless the number of planets is known too, because the stiffness needs both.
    pub(super) face_width: Option<Length>,
    pub(super) allowed: Option<Allowed>,
}

/// Results for every gear of a gearbox.
pub(super) fn of_gears(subject: &Gearbox, known: &[Known]) -> Result<Vec<AtOutput>, Error> {
    let gears = subject.train.gears().iter().map(Gear::name);
    gears.map(|name| of_gear(subject, known, name, &analysis(&subject.train, name)?)).collect()
}

fn of_gear(
    subject: &Gearbox,
    known: &[Known],
    name: &str,
    analysis: &Analysis<'_>,
) -> Result<AtOutput, Error> {
    let mut row =
        AtOutput { gear: name.to_owned(), backlash_rad: None, stiffness_n_m: None, missing: vec![] };
    let Some(case) = analysis.ideal().filter(|case| case.output != 0.0) else {
        row.missing.push("no torques follow".to_owned());
        return Ok(row);
    };
    let (mut parts, mut is_whole) = (vec![], true);
    for (place, members) in case.members.iter().enumerate() {
        let share = members.as_ref().map_or(0.0, |members| members[0] / case.output);
        if share.abs() < ROUNDED {
            continue;
        }
        let id = subject.train.sets()[place].id();
        let Some(one) = known.iter().find(|one| one.place == place) else {
            row.missing.push(format!("the teeth of set {id}"));
            is_whole = false;
            continue;
        };
        let stiffness = match one.face_width {
            Some(width) => Some(one.stiffness(width)?),
            None => {
                row.missing.push(format!("planets or face_width of set {id}, for the stiffness"));
                None
            }
        };
        let (thickness, centre) = one.allowed.as_ref().map_or_else(Default::default, |all| {
            let [lower, upper] = all.centre_distance_m.map(|limit| limit / one.module.si());
            ([0, 1, 2].map(|gear: usize| all.thickness[gear]), Deviation { lower, upper })
        });
        let backlash = one.set.backlash_at(Member::Sun, thickness, centre)?;
        parts.push(Part { torque_share: share, stiffness, backlash });
    }
    if is_whole {
        let (stiffness, backlash) = at_output(&parts)?;
        row.backlash_rad = Some(Limits { lower: backlash.least, upper: backlash.greatest });
        row.stiffness_n_m = stiffness.map(Physical::si).filter(|si| si.is_finite());
    }
    Ok(row)
}

impl Known {
    /// Torsional stiffness at the sun in N·m per radian.
    fn stiffness(&self, width: Length) -> Result<Torque, Error> {
        let of = |pair| mesh_stiffness(pair, width).map(|stiffness| stiffness / width);
        let both = [of(self.set.sun_mesh())?, of(self.set.ring_mesh())?];
        Ok(self.set.torsional_stiffness(Member::Sun, self.module, both, [width; 2])?)
    }
}
