//! Tooth forms to choose from: ranges and steps.

use crate::quantity::{Choice, Quantity};
use epicyclic_units::Physical;
use uom::si::f64::Angle;

use crate::Error;
use crate::profile::{Crest, ToothForm};
use crate::tolerance::STEP_SLACK;

/// The greatest number of tooth forms that a search takes.
pub const MOST_FORMS: u64 = 10_000;

/// Values from one to another in equal steps, the first included, the last where a step meets it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steps<T> {
    /// First value.
    pub from: T,
    /// No value above it.
    pub to: T,
    /// Step; of no account where both ends are one.
    pub step: T,
}

impl<T: Copy> Steps<T> {
    /// One value alone.
    pub fn fixed(value: T) -> Self {
        Self { from: value, to: value, step: value }
    }
}

impl Steps<f64> {
    /// The values within the bounds of a quantity.
    pub(super) fn values(
        self,
        quantity: Quantity,
        bounds: [f64; 2],
        unit: &'static str,
    ) -> Result<Vec<f64>, Error> {
        let Self { from, to, step } = self;
        for value in [from, to] {
            if !(value >= bounds[0] && value <= bounds[1]) {
                let [low, high] = bounds;
                return Err(Error::OutOfRange { quantity, value, low, high, unit });
            }
        }
        let sound = from == to || from < to && step > 0.0 && step.is_finite();
        if !sound {
            return Err(Error::EmptySteps { quantity, from, to, step, unit });
        }
        let steps = if from == to { 0.0 } else { ((to - from) / step + STEP_SLACK).floor() };
        if steps >= MOST_FORMS as f64 {
            return Err(Error::TooManyForms { forms: steps.min(1e18) as u64 + 1, most: MOST_FORMS });
        }
        Ok((0..=steps as u32).map(|i| (from + step * f64::from(i)).min(to)).collect())
    }
}

/// The tooth forms to choose from: every combination of the values. Backlash and its share are those of
/// [`base`](Self::base).
#[derive(Debug, Clone, PartialEq)]
pub struct FormSpace {
    /// Pressure angle `α`, from 10° to 40°.
    pub pressure_angle: Steps<Angle>,
    /// Addendum `h_a*`, above 0 and at most 2.
    pub addendum: Steps<f64>,
    /// Profile shift `x` of the satellite, within ±2; forms with `|x| ≥ h_a*` have no teeth.
    pub shift: Steps<f64>,
    /// Clearance `c*`, from 0 to 1.
    pub clearance: Steps<f64>,
    /// Radius `ρ*` of the rounded tips of the tools, from 0 to 1.
    pub fillet: Steps<f64>,
    /// Parts of a tooth that may be in the middle of the stator's crests.
    pub crests: Vec<Crest>,
    /// The rest of the form.
    pub base: ToothForm,
}

impl Default for FormSpace {
    /// `α` from 20° to 30° by 2.5°, `h_a*` from 0.7 to 1 by 0.05, `x` from 0 to 0.4 by 0.1, `c*` 0.25, `ρ*`
    /// 0.1, both crests: 350 forms.
    fn default() -> Self {
        let base = ToothForm::default();
        Self {
            pressure_angle: Steps {
                from: Angle::from_degrees(20.0),
                to: Angle::from_degrees(30.0),
                step: Angle::from_degrees(2.5),
            },
            addendum: Steps { from: 0.7, to: 1.0, step: 0.05 },
            shift: Steps { from: 0.0, to: 0.4, step: 0.1 },
            clearance: Steps::fixed(base.clearance),
            fillet: Steps::fixed(base.fillet),
            crests: vec![Crest::Space, Crest::Tooth],
            base,
        }
    }
}

impl FormSpace {
    /// One form alone.
    #[must_use]
    pub fn of(form: ToothForm) -> Self {
        Self {
            pressure_angle: Steps::fixed(form.pressure_angle),
            addendum: Steps::fixed(form.addendum),
            shift: Steps::fixed(form.shift),
            clearance: Steps::fixed(form.clearance),
            fillet: Steps::fixed(form.fillet),
            crests: vec![form.crest],
            base: form,
        }
    }

    /// Every form, by rising `α`, `h_a*`, `x`, `c*`, `ρ*`, and the crests as given.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for an end outside the quantity's range, [`Error::EmptySteps`],
    /// [`Error::TooManyForms`] above [`MOST_FORMS`], [`Error::NothingToChoose`] without crests, and for the
    /// base's backlash and share [`Error::OutOfRange`].
    ///
    /// # Example
    /// ```
    /// use epicyclic_hydromotor::search::forms::FormSpace;
    ///
    /// assert_eq!(FormSpace::default().forms()?.len(), 5 * 7 * 5 * 2);
    /// # Ok::<(), epicyclic_hydromotor::Error>(())
    /// ```
    pub fn forms(&self) -> Result<Vec<ToothForm>, Error> {
        let Steps { from, to, step } = self.pressure_angle;
        let degrees = Steps { from: from.degrees(), to: to.degrees(), step: step.degrees() };
        let angles = degrees.values(Quantity::PressureAngle, [10.0, 40.0], "°")?;
        let addenda = self.addendum.values(Quantity::Addendum, [1e-3, 2.0], "modules")?;
        let shifts = self.shift.values(Quantity::ProfileShift, [-2.0, 2.0], "modules")?;
        let clearances = self.clearance.values(Quantity::Clearance, [0.0, 1.0], "modules")?;
        let fillets = self.fillet.values(Quantity::Fillet, [0.0, 1.0], "modules")?;
        for (quantity, value, high) in [
            (Quantity::Backlash, self.base.backlash, 0.5),
            (Quantity::BacklashShare, self.base.satellite_share, 1.0),
        ] {
            Steps::fixed(value).values(quantity, [0.0, high], "")?;
        }
        let mut crests = self.crests.clone();
        crests.dedup();
        if crests.is_empty() {
            return Err(Error::NothingToChoose { what: Choice::Crests });
        }
        let lists =
            [angles.len(), addenda.len(), shifts.len(), clearances.len(), fillets.len(), crests.len()];
        let count = lists.iter().map(|&length| length as u64).product();
        if count > MOST_FORMS {
            return Err(Error::TooManyForms { forms: count, most: MOST_FORMS });
        }
        let mut forms = Vec::with_capacity(count as usize);
        for &angle in &angles {
            for &addendum in &addenda {
                for &shift in &shifts {
                    for &clearance in &clearances {
                        for &fillet in &fillets {
                            forms.extend(crests.iter().map(|&crest| ToothForm {
                                pressure_angle: Angle::from_degrees(angle),
                                addendum,
                                shift,
                                clearance,
                                fillet,
                                crest,
                                ..self.base
                            }));
                        }
                    }
                }
            }
        }
        Ok(forms)
    }
}
