//! Every combination of shift elements, with its state.

use super::records::{Indeterminate, State, concerned, is_same, state};
use super::{engaged, moving, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::gearbox::Subject;
use crate::shared::records::Fraction;
use epicyclic_train::{Analysis, Gearbox};
use schemars::JsonSchema;
use serde::Serialize;

/// All combinations of the shift elements of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Combinations {
    /// Name of the gearbox.
    pub gearbox: String,
    /// How many combinations have a ratio.
    pub with_ratio: usize,
    /// All of them.
    pub combinations: Vec<Combination>,
    /// What the reader should know.
    pub warnings: Vec<Warning>,
}

/// Some shift elements engaged together.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Combination {
    /// Shift elements engaged.
    pub engaged: Vec<String>,
    /// The gear of the gearbox that engages these.
    pub gear: Option<String>,
    /// What the gearbox then does.
    pub state: State,
    /// Links that the state concerns.
    pub state_links: Vec<String>,
    /// Where underdetermined: how many further speeds must be given.
    pub missing_speeds: Option<usize>,
    /// Where torques are indeterminate: the redundant parts.
    pub indeterminate: Option<Indeterminate>,
    /// Ratio, input speed over output speed.
    pub ratio: Option<f64>,
    /// The same, exactly, where the teeth are known.
    pub exact_ratio: Option<Fraction>,
    /// Efficiency driven from the input; none where the mesh losses hold it.
    pub efficiency: Option<f64>,
}

impl Answer for Combinations {
    const NAME: &'static str = "analyze-combinations";
}

/// The state of every combination, those of fewer elements first.
///
/// # Errors
/// [`Error::Gearbox`] where there are more combinations than are solved.
pub fn answer(subject: &Subject<'_>) -> Result<Combinations, Error> {
    let gearbox = &subject.gearbox;
    let all = gearbox.combinations(0..=gearbox.shift_elements().len())?;
    Ok(Combinations {
        gearbox: gearbox.name().to_owned(),
        with_ratio: all.iter().filter(|analysis| analysis.state().has_ratio()).count(),
        combinations: all.iter().map(|analysis| Combination::of(gearbox, analysis)).collect(),
        warnings: warnings::of_gearbox(subject),
    })
}

impl Combination {
    fn of(gearbox: &Gearbox, analysis: &Analysis<'_>) -> Self {
        let gear = gearbox.gears().iter().find(|gear| is_same(gear, analysis.gear()));
        let (state_links, missing_speeds, indeterminate) = concerned(analysis.state());
        Self {
            engaged: engaged(gearbox, analysis.gear()),
            gear: gear.map(|gear| gear.name().to_owned()),
            state: state(analysis),
            state_links,
            missing_speeds,
            indeterminate,
            ratio: analysis.ratio(),
            exact_ratio: analysis.exact_ratio().map(Fraction::of),
            efficiency: moving(analysis.efficiency()),
        }
    }
}
