//! Teeth of a design: their limits, and flow and torque if satellites seal at their flanks.

use super::shown_size;
use crate::motor::answer::{contact_stresses, greatest_contact, steel};
use crate::shared::number::plain;
use epicyclic_hydromotor::profile::limits::Limit;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::search;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Pressure;

/// Results of the check whether teeth are within their limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TeethLimits {
    /// Within the limits.
    Hold,
    /// Beyond a limit.
    Fail,
    /// No teeth of this form.
    None,
}

/// Flow and torque if satellites seal at the flanks.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AtFlanks {
    /// Ripple of flow and torque if satellites seal at the flanks.
    pub ripple: f64,
    /// Least over mean flow, equal to least over mean torque.
    pub least_over_mean: f64,
}

/// Teeth of a design with the given form.
pub(crate) struct Teeth {
    pub(crate) limits: TeethLimits,
    /// Flow and torque at the flanks, or the reason why there are none.
    pub(crate) at_flanks: Result<AtFlanks, String>,
    /// Contact stress of steel teeth in Pa at the pressure of the search; `None` if it cannot be computed.
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

/// Greatest contact stress in Pa while a single pair of flanks carries; `None` if the flanks cannot hold a
/// satellite.
fn contact(profile: &Profile, drop: Pressure) -> Option<f64> {
    greatest_contact(&contact_stresses(profile, steel().ok()?, drop).ok()?)
}

/// Tooth profile of a design, or the reason why none exists.
fn profile(design: &search::Design, form: ToothForm) -> Result<Profile, String> {
    let size = shown_size(design).ok_or_else(|| "no size is within the limits".to_owned())?;
    let motor = design.motor(size.module).map_err(|error| error.to_string())?;
    Profile::new(&motor, form).map_err(|error| error.to_string())
}

/// Flow and torque at the flanks, as a record of the library; `None` without teeth.
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
