//! Combinations of shift elements, each with its state.

use super::records::{Indeterminate, State, concerned, is_same, state};
use super::{engaged, moving, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::records::Fraction;
use epicyclic_train::{self as train, Analysis};
use schemars::JsonSchema;
use serde::Serialize;

/// Combinations of the shift elements of a gearbox, each with its state.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Combinations {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Number of combinations that have a ratio.
    pub with_ratio: usize,
    /// List of the combinations, those of fewer elements first.
    pub combinations: Vec<Combination>,
    /// Judgement of the gearbox by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the gearbox.
    pub warnings: Vec<Warning>,
}

/// Combination of engaged shift elements.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Combination {
    /// Names of the engaged shift elements.
    pub engaged: Vec<String>,
    /// Name of the gear that engages exactly these shift elements; null if none exists.
    pub gear: Option<String>,
    /// State of the gearbox in this combination.
    pub state: State,
    /// Links that the state concerns: at rest, free, or without a known speed.
    pub state_links: Vec<String>,
    /// Number of further speeds that must be given if the combination is underdetermined; otherwise null.
    pub missing_speeds: Option<usize>,
    /// Redundant parts if the torques are indeterminate; otherwise null.
    pub indeterminate: Option<Indeterminate>,
    /// Ratio, input speed over output speed; null if none exists.
    pub ratio: Option<f64>,
    /// Exact ratio as a fraction; null unless the tooth numbers are known.
    pub exact_ratio: Option<Fraction>,
    /// Efficiency when driven from the input; null if none exists or the mesh losses hold the gearbox.
    pub efficiency: Option<f64>,
}

impl Answer for Combinations {
    const NAME: &'static str = "analyze-combinations";
}

/// Finds the state of every combination, those of fewer elements first.
///
/// # Errors
/// [`Error::Gearbox`] if the gearbox has more combinations than the limit of the analysis.
pub fn answer(subject: &Gearbox) -> Result<Combinations, Error> {
    let gearbox = &subject.train;
    let all = gearbox.combinations(0..=gearbox.shift_elements().len())?;
    Ok(Combinations {
        gearbox: gearbox.name().to_owned(),
        with_ratio: all.iter().filter(|analysis| analysis.state().has_ratio()).count(),
        combinations: all.iter().map(|analysis| Combination::of(gearbox, analysis)).collect(),
        judgement: Judgement::default(),
        warnings: warnings::of_gearbox(subject),
    })
}

impl Combination {
    fn of(gearbox: &train::Gearbox, analysis: &Analysis<'_>) -> Self {
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
