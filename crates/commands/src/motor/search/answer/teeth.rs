//! The teeth of a design: whether they keep their limits, and flow and torque where satellites seal at their
//! flanks.

use super::shown_size;
use crate::motor::answer::{contact_stresses, practice, steel};
use crate::shared::number::plain;
use epicyclic_hydromotor::profile::limits::Limit;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::search;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Pressure;

/// Whether teeth of the form keep their limits on a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TeethLimits {
    /// They do.
    Hold,
    /// They do not.
    Fail,
    /// There are no teeth of that form.
    None,
}

/// Flow and torque, satellites sealing at the flanks.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AtFlanks {
    /// Ripple of flow and torque, satellites sealing at the flanks.
    pub ripple: f64,
    /// Least over mean flow, which is that of the torque.
    pub least_over_mean: f64,
}

/// What the form makes of a design.
pub(crate) struct Teeth {
    pub(crate) limits: TeethLimits,
    /// Or why there is none.
    pub(crate) at_flanks: Result<AtFlanks, String>,
    /// Of steel, at the pressure of the search.
    pub(crate) contact_stress_pa: Option<f64>,
}

impl Teeth {
    pub(crate) fn of(design: &search::Design, search: &search::MotorSearch) -> Self {
        let profile = profile(design, search.flanks.form);
        let at_flanks = match &profile {
            Err(why) => Err(why.clone()),
            Ok(profile) => search::AtFlanks::of_profile(profile)
                .map(|at| AtFlanks { ripple: plain(at.ripple), least_over_mean: plain(at.least_over_mean) })
                .ok_or_else(|| "the flanks give no ripple above 0".to_owned()),
        };
        let drop = search.requirements.pressure_drop;
        let contact_stress_pa =
            profile.as_ref().ok().zip(drop).and_then(|(profile, drop)| contact(profile, drop));
        Self { limits: TeethLimits::of_profile(profile.as_ref().ok()), at_flanks, contact_stress_pa }
    }
}

/// The greatest contact stress where one pair of flanks carries alone; none where the flanks cannot hold a
/// satellite.
fn contact(profile: &Profile, drop: Pressure) -> Option<f64> {
    practice::greatest_contact(&contact_stresses(profile, steel().ok()?, drop).ok()?)
}

/// The teeth of a design, or why there are none.
fn profile(design: &search::Design, form: ToothForm) -> Result<Profile, String> {
    let size = shown_size(design).ok_or_else(|| "no size is within the limits".to_owned())?;
    let motor = design.motor(size.module).map_err(|error| error.to_string())?;
    Profile::new(&motor, form).map_err(|error| error.to_string())
}

/// Flow and torque at the flanks, as the library has them; none without teeth.
pub(crate) fn at_flanks(design: &search::Design, form: ToothForm) -> Option<search::AtFlanks> {
    search::AtFlanks::of_profile(&profile(design, form).ok()?)
}

impl TeethLimits {
    fn of_profile(profile: Option<&Profile>) -> Self {
        match profile {
            Some(profile) if profile.limits().iter().all(Limit::holds) => Self::Hold,
            Some(_) => Self::Fail,
            None => Self::None,
        }
    }
}
