//! The teeth of a design: whether they keep their limits, and flow and torque where satellites seal at their flanks.

use super::shown_size;
use crate::number::plain;
use epicyclic_hydromotor::profile::limits::Limit;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::search;
use schemars::JsonSchema;
use serde::Serialize;

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
pub(super) struct Teeth {
    pub(super) limits: TeethLimits,
    /// Or why there is none.
    pub(super) at_flanks: Result<AtFlanks, String>,
}

impl Teeth {
    pub(super) fn of(design: &search::Design, form: ToothForm) -> Self {
        let profile = profile(design, form);
        let at_flanks = match &profile {
            Err(why) => Err(why.clone()),
            Ok(profile) => search::AtFlanks::of_profile(profile)
                .map(|at| AtFlanks { ripple: plain(at.ripple), least_over_mean: plain(at.least_over_mean) })
                .ok_or_else(|| "the flanks give no ripple above 0".to_owned()),
        };
        Self { limits: TeethLimits::of_profile(profile.as_ref().ok()), at_flanks }
    }
}

/// The teeth of a design, or why there are none.
fn profile(design: &search::Design, form: ToothForm) -> Result<Profile, String> {
    let size = shown_size(design).ok_or_else(|| "no size is within the limits".to_owned())?;
    let motor = design.motor(size.module).map_err(|error| error.to_string())?;
    Profile::new(&motor, form).map_err(|error| error.to_string())
}

/// Flow and torque at the flanks, as the library has them; none without teeth.
pub(super) fn at_flanks(design: &search::Design, form: ToothForm) -> Option<search::AtFlanks> {
    search::AtFlanks::of_profile(&profile(design, form).ok()?)
}

impl TeethLimits {
    pub(super) fn of(design: &search::Design, form: ToothForm) -> Self {
        Self::of_profile(profile(design, form).ok().as_ref())
    }

    fn of_profile(profile: Option<&Profile>) -> Self {
        match profile {
            Some(profile) if profile.limits().iter().all(Limit::holds) => Self::Hold,
            Some(_) => Self::Fail,
            None => Self::None,
        }
    }
}
