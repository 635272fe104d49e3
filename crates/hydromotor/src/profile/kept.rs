//! Fast test whether a motor keeps all limits in a form, for searches that try many: the quickest tests come
//! first, with an end at the first failure.
//!
//! Results that depend only on the form and the satellite's teeth are computed once ([`SatelliteForm`]),
//! those that depend only on the motor once ([`Room`]). For a motor in a form flanks are cut one by one. The
//! results are those of [`Profile`](super::Profile) and its limits, from the flanks on one side of the spaces
//! alone, as those on the other are mirror images. The tests compare them.

use super::Part;
use super::cut::Cut;
use super::form::{Teeth, ToothForm};
use super::limits::{LEAST_TIP, Mesh, Worsts};
use super::phases;
use super::satellite::SatelliteTooth;
use super::track::{Side, Track};
use crate::contact::{By, Conjugate};
use crate::motor::Motor;
use crate::reason::Reason;
use std::f64::consts::PI;

/// A form on satellites of a number of teeth.
#[derive(Debug, Clone)]
pub(crate) struct SatelliteForm {
    teeth: Teeth,
    satellite: SatelliteTooth,
    offsets: [f64; 2],
}

impl SatelliteForm {
    /// Form on satellites of this number of teeth, if the limits of the satellite are kept.
    pub(crate) fn new(form: ToothForm, satellite_teeth: u32) -> Result<Self, Reason> {
        let offsets = phases(form.crest, satellite_teeth);
        let teeth = Teeth::new(form, satellite_teeth).map_err(|_| Reason::NoTeeth)?;
        let satellite = SatelliteTooth::new(&teeth, satellite_teeth, offsets[0] / teeth.r);
        let satellite = satellite.map_err(|_| Reason::NoTeeth)?;
        if -teeth.rack_roll * teeth.cos > teeth.r * teeth.sin {
            return Err(Reason::Undercut);
        }
        if 2.0 * teeth.tip * teeth.tip_angle() < LEAST_TIP {
            return Err(Reason::TipThickness);
        }
        let formed = Self { teeth, satellite, offsets };
        if formed.greatest_contact_ratio() < 1.0 {
            return Err(Reason::ContactPath);
        }
        Ok(formed)
    }

    /// Upper bound of the contact ratio on any motor: the whole involute of the satellite.
    pub(crate) fn greatest_contact_ratio(&self) -> f64 {
        let mesh = Mesh { teeth: &self.teeth, satellite: &self.satellite };
        (mesh.satellite_path() + mesh.satellite_tip()) / (PI * self.teeth.cos)
    }

    /// Heights that the centrodes must leave room for: the satellite's addendum, the cutter's.
    fn heights(&self) -> [f64; 2] {
        [self.teeth.tip - self.teeth.r, self.teeth.cutter_addendum]
    }
}

/// The room that a motor's centrodes leave for teeth, in modules.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Room {
    /// Least radii of the stator's and the rotor's bulges towards the satellites' roots; infinite where there
    /// are none.
    bulges: [f64; 2],
    /// The rotor's least radius.
    least_radius: f64,
    /// Least distance of neighbouring satellites.
    neighbours: f64,
    /// Stator's least radius less rotor's greatest.
    gap: f64,
}

impl Room {
    /// Room of a motor whose curvature extremes are known.
    pub(crate) fn of(motor: &Motor, curvatures: [f64; 4]) -> Self {
        Self {
            bulges: [curvatures[0].recip(), curvatures[2].recip()],
            least_radius: motor.shape.trough().rho1,
            neighbours: motor.least_neighbour_kernel().0,
            gap: motor.shape.trough().rho3 - motor.shape.at(By::Phase, 0.0).rho1,
        }
    }

    /// The first check of the centrodes, or limit of the whole wheels, that a form fails.
    fn failing(&self, form: &SatelliteForm) -> Option<Reason> {
        let [_, dedendum] = form.heights();
        let teeth = &form.teeth;
        let checks = [
            (self.bulges[0] > dedendum, Reason::StatorBulge),
            (self.bulges[1] > dedendum, Reason::RotorBulge),
            (self.least_radius > dedendum, Reason::RotorLeastRadius),
            (self.neighbours > 2.0 * teeth.tip, Reason::Neighbours),
            (self.gap >= 2.0 * teeth.wheel_addendum, Reason::Wheels),
        ];
        checks.into_iter().find(|(holds, _)| !holds).map(|(_, reason)| reason)
    }
}

/// Contact ratio of a motor in a form, its shortest path of contact over the base pitch, or the first
/// failure. `None` as soon as it is known to be at most one that is not `wanted`.
pub(crate) fn contact_ratio(
    motor: &Motor,
    room: &Room,
    form: &SatelliteForm,
    wanted: impl Fn(f64) -> bool,
) -> Result<Option<f64>, Reason> {
    if let Some(reason) = room.failing(form) {
        return Err(reason);
    }
    let teeth = &form.teeth;
    let mesh = Mesh { teeth, satellite: &form.satellite };
    let count = motor.numbers().teeth_per_lobe();
    // The rotor's crests and the stator's troughs bend most: the flanks there first.
    let sides = [(Side::Rotor, form.offsets[1], 0), (Side::Stator, form.offsets[0], count / 2)];
    // The path of one flank on the rotor's crest bounds the shortest of all.
    let base_pitch = PI * teeth.cos;
    let (track, pitch) =
        (Track { shape: &motor.shape, side: Side::Rotor }, form.offsets[1] + teeth.half_space);
    let Some((tip, ..)) = Cut::tip(&track, teeth, pitch, 1.0, teeth.wheel_addendum) else {
        return Err(Reason::NoTeeth);
    };
    let longest = ((tip - pitch) * teeth.cos).min(mesh.satellite_path()) + mesh.satellite_tip();
    if !wanted(longest / base_pitch) {
        return Ok(None);
    }
    // Most forms fail by undercut, and mostly there: the end of every flank, before any is cut.
    for (side, offset, first) in sides {
        let track = Track { shape: &motor.shape, side };
        for i in outward(first, count) {
            let kappa = track.at(offset + PI * f64::from(i) + teeth.half_space + teeth.cutter_roll).curvature;
            if kappa < 0.0 && teeth.cutter_roll * teeth.cos * kappa > teeth.sin {
                return Err(Reason::Undercut);
            }
        }
    }
    let mut cuts = Vec::with_capacity(2);
    let mut shortest = f64::INFINITY;
    for (side, offset, first) in sides {
        let track = Track { shape: &motor.shape, side };
        let mut worsts = Worsts::default();
        let mut after = vec![None; count as usize];
        for i in outward(first, count) {
            let flank = Cut::flank(&track, teeth, offset + PI * f64::from(i), 1.0);
            let flank = flank.map_err(|_| Reason::NoTeeth)?;
            worsts.flank(mesh, &track, &flank);
            if let Some(kind) = worsts.failing() {
                return Err(kind.into());
            }
            after[i as usize] = Some(flank);
            // The shortest of all paths is no longer than the shortest of some.
            let so_far = worsts.contact_path().map_or(shortest, |path| shortest.min(path));
            if !wanted(so_far / base_pitch) {
                return Ok(None);
            }
        }
        let after: Vec<_> = after.into_iter().flatten().collect();
        let cut = Cut::of_flanks(&track, teeth, offset, &after).map_err(|_| Reason::NoTeeth)?;
        for piece in cut.pieces.iter().filter(|piece| piece.part == Part::Tip) {
            worsts.tip(mesh, &track, piece);
            if let Some(kind) = worsts.failing() {
                return Err(kind.into());
            }
        }
        shortest = shortest.min(worsts.contact_path().unwrap_or(0.0));
        cuts.push((track, after, worsts));
    }
    for (track, after, worsts) in &mut cuts {
        for flank in after.iter() {
            worsts.fillet(mesh, track, flank);
            if let Some(kind) = worsts.failing() {
                return Err(kind.into());
            }
        }
    }
    Ok(Some(shortest / base_pitch))
}

/// Places of a lobe from one on, to both sides in turn.
fn outward(first: u32, count: u32) -> impl Iterator<Item = u32> {
    (0..count).map(move |k| {
        let away = k.div_ceil(2);
        (if k % 2 == 0 { first + away } else { first + count - away }) % count
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::centrode::tests::any_motor;
    use crate::checks::{Check, ToothHeights};
    use crate::profile::limits::{Limit, LimitKind};
    use crate::profile::{Crest, Profile};
    use epicyclic_units::Physical;
    use proptest::prelude::*;
    use uom::si::f64::Angle;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(160))]

        /// The fast test agrees with the profile and all its limits, and returns its contact ratio.
        #[test]
        fn a_form_is_kept_where_the_profile_keeps_every_limit(
            motor in any_motor(), degrees in 20.0..30.0, heights in (0.5..0.9, 0.15..0.3, 0.0..0.4), tooth in any::<bool>(),
        ) {
            let (addendum, clearance, shift) = heights;
            let crest = if tooth { Crest::Tooth } else { Crest::Space };
            let form = ToothForm {
                pressure_angle: Angle::from_degrees(degrees), addendum, clearance, shift, crest, ..ToothForm::default()
            };
            let asked = ToothHeights { addendum: addendum + shift, dedendum: addendum + clearance + shift };
            let profile = Profile::new(&motor, form).ok().filter(|profile| {
                profile.limits().iter().all(Limit::holds)
                    && motor.checks(asked).is_ok_and(|checks| checks.iter().all(Check::holds))
            });
            let room = Room::of(&motor, motor.shape.curvature_extremes());
            let short = SatelliteForm::new(form, motor.numbers().satellite_teeth())
                .and_then(|form| contact_ratio(&motor, &room, &form, |_| true).map(|ratio| (ratio, form)));
            prop_assert_eq!(profile.is_some(), short.is_ok(), "{:?}", short.map(|(ratio, _)| ratio));
            if let (Some(profile), Ok((ratio, form))) = (profile, short) {
                let ratio = ratio.unwrap();
                let paths = profile.limits().into_iter().filter(|limit| limit.kind == LimitKind::ContactPath);
                let least = paths.map(|limit| (limit.value / limit.bound).value).fold(f64::INFINITY, f64::min);
                prop_assert!((ratio / least - 1.0).abs() < 1e-9 && ratio <= form.greatest_contact_ratio() * (1.0 + 1e-12));
                // A contact ratio that is not wanted ends the trial.
                prop_assert_eq!(contact_ratio(&motor, &room, &form, |most| most > ratio * 1.001), Ok(None));
            }
        }
    }
}
