//! Case as written in a file.

use crate::cases::tolerance::Rounding;
use epicyclic_formats::yaml::Value as Yaml;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Case: inputs, a calculation, and the published results of the source.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Name, unique within the source.
    pub case: String,
    /// Places in the source, by the names of its index: `§3.3, table 3.1`.
    pub cite: String,
    /// Name of a registered calculation.
    pub calculation: String,
    /// Inputs of the calculation. A value may be taken from another case:
    /// `{ from: case/quantity, as: exact }`, or `as: published`.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, serde_json::Value>")]
    pub given: Yaml,
    /// Published figures of the source, by the results of the calculation.
    #[serde(default)]
    pub expect: BTreeMap<String, Expectation>,
    /// Name of the error that these inputs must raise, instead of `expect`.
    #[serde(default)]
    pub expect_error: Option<String>,
    /// Place where the figures were read, if not in the source itself.
    #[serde(default)]
    pub evidence: Option<Evidence>,
    /// Explanation of how a formula was inferred that the copy of the source lost.
    #[serde(default)]
    pub restored: Option<String>,
    /// Further information for the reader.
    #[serde(default)]
    pub note: Option<String>,
}

/// Verdict on a published figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The figure follows from the source's inputs.
    #[default]
    Agrees,
    /// The figure does not follow from the source's own inputs.
    Contradicted,
    /// The figure follows from the source's inputs by a restored reading, because the copy lost or garbled
    /// the formula, or the document never had it. Judged as [`Verdict::Agrees`], counted separately.
    Reconstructed,
    /// The figure repeats the definition of its own quantity, our copy of a table, or an input that was
    /// solved for. Values of a closed form or of another program, which no source prints, also belong here.
    /// Judged as [`Verdict::Agrees`], counted separately. Needs `because`.
    Definition,
    /// The source sets the figure: an input, not a result.
    Given,
    /// The copy lost the figure.
    Unrecoverable,
}

impl Verdict {
    /// The verdict as cases write it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Contradicted => "contradicted",
            Self::Reconstructed => "reconstructed",
            Self::Definition => "definition",
            Self::Given => "given",
            Self::Unrecoverable => "unrecoverable",
        }
    }
}

/// Reason why a tolerance is loose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Cause {
    /// The source rounds a constant, such as π = 3.14.
    Constant,
    /// The source rounds or truncates figures on the way.
    Rounding,
    /// The source gives the figure roughly.
    Rough,
}

impl Cause {
    /// The cause in a sentence.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Constant => "a constant that the source rounds",
            Self::Rounding => "figures that the source rounds on the way",
            Self::Rough => "a figure that the source states roughly",
        }
    }
}

/// Place where a figure was read, if not in the source that it is cited from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Evidence {
    /// Another publication that quotes the source.
    Secondary,
    /// No named publication.
    Unverified,
}

/// A published figure.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Expectation {
    /// The figure as printed, digit for digit, with its unit: `"521.8 N·m"`.
    #[serde(default)]
    pub published: Option<String>,
    /// How the source came to the digits.
    #[serde(default)]
    pub rounding: Rounding,
    /// A tolerance wider than the digits': `2 %`, `0.1 mm`. Needs `because`.
    #[serde(default)]
    pub tolerance: Option<String>,
    /// Cause of a loose tolerance: one beyond ten half-units of the last digit, or beyond 2 %.
    #[serde(default)]
    pub cause: Option<Cause>,
    /// Another figure, `case/quantity`, that compares the same print.
    #[serde(default)]
    pub print_of: Option<String>,
    /// Verdict on the figure.
    #[serde(default)]
    pub verdict: Verdict,
    /// Right value of a contradicted figure by an independent calculation, to 1e-6.
    #[serde(default)]
    pub computed: Option<String>,
    /// Arithmetic of that calculation, in the unit of `computed`: `(16*521.8/(PI*20e6))^(1/3)*1000`. For a
    /// yes or no the margin, above 0 for yes.
    #[serde(default)]
    pub arithmetic: Option<String>,
    /// Reason: the derivation of a contradiction, or the cause of a tolerance.
    #[serde(default)]
    pub because: Option<String>,
    /// Unit that the source prints, if it is not the right one of `published`.
    #[serde(default)]
    pub printed_unit: Option<String>,
    /// Legible part of an unrecoverable figure.
    #[serde(default)]
    pub legible: Option<String>,
    /// Place where this figure was read, if it differs from that of the case.
    #[serde(default)]
    pub evidence: Option<Evidence>,
    /// Places of this figure, if they differ from those of the case.
    #[serde(default)]
    pub cite: Option<String>,
}

/// Value taken from another case.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct From {
    /// The case and its result: `case/quantity`.
    pub from: String,
    /// Form in which the value is taken.
    #[serde(rename = "as")]
    pub taken: Taken,
}

/// Form in which a linked result is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Taken {
    /// As computed, to the last bit.
    Exact,
    /// As the source prints it.
    Published,
}
