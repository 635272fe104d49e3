//! A case as it is written.

use crate::cases::tolerance::Rounding;
use epicyclic_formats::yaml::Value as Yaml;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A case: inputs, a calculation, and what the source publishes of its results.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Name, unique within the source.
    pub case: String,
    /// Places in the source, by the names of its index: `§3.3, table 3.1`.
    pub cite: String,
    /// Name of a registered calculation.
    pub calculation: String,
    /// Its inputs. A value may be taken from another case: `{ from: case/quantity, as: exact }`, or
    /// `as: published`.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, serde_json::Value>")]
    pub given: Yaml,
    /// What the source publishes, by the calculation's results.
    #[serde(default)]
    pub expect: BTreeMap<String, Expectation>,
    /// Name of the error that these inputs must raise, in place of `expect`.
    #[serde(default)]
    pub expect_error: Option<String>,
    /// Where the figures were read, if not in the source itself.
    #[serde(default)]
    pub evidence: Option<Evidence>,
    /// How a formula was inferred that the copy of the source lost.
    #[serde(default)]
    pub restored: Option<String>,
    /// What a reader should know besides.
    #[serde(default)]
    pub note: Option<String>,
}

/// What becomes of a published figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It follows from the source's inputs.
    #[default]
    Agrees,
    /// It does not follow from the source's own inputs.
    Contradicted,
    /// The figure follows from the source's inputs by a restored reading: the copy lost or garbled the
    /// formula, or the document never had it. Judged as [`Verdict::Agrees`], counted apart.
    Reconstructed,
    /// The figure repeats the definition of its own quantity, our copy of a table, or an input that was
    /// solved for; or it is the value of a closed form or of another program, which no source prints. Judged
    /// as [`Verdict::Agrees`], counted apart. Needs `because`.
    Definition,
    /// The source sets it: an input, not a result.
    Given,
    /// The copy lost it.
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

/// Why a tolerance is loose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Cause {
    /// The source rounds a constant, such as π = 3.14.
    Constant,
    /// The source rounds or truncates figures on the way.
    Rounding,
    /// The source states the figure roughly.
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

/// Where a figure was read, if not in the source that it is cited from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Evidence {
    /// In another publication that quotes the source.
    Secondary,
    /// In none that is named.
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
    /// What becomes of the figure.
    #[serde(default)]
    pub verdict: Verdict,
    /// Of a contradicted figure, the right value by an independent calculation, to 1e-6.
    #[serde(default)]
    pub computed: Option<String>,
    /// That calculation as arithmetic, in the unit of `computed`: `(16*521.8/(PI*20e6))^(1/3)*1000`; of a yes
    /// or no the margin, above 0 for yes.
    #[serde(default)]
    pub arithmetic: Option<String>,
    /// Why: the derivation of a contradiction, the reason for a tolerance.
    #[serde(default)]
    pub because: Option<String>,
    /// The unit that the source prints, where it is not the right one of `published`.
    #[serde(default)]
    pub printed_unit: Option<String>,
    /// Of an unrecoverable figure, what is legible.
    #[serde(default)]
    pub legible: Option<String>,
    /// Where this figure was read, if not as those of the case.
    #[serde(default)]
    pub evidence: Option<Evidence>,
    /// Places of this figure, where they are not those of the case.
    #[serde(default)]
    pub cite: Option<String>,
}

/// A value taken from another case.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct From {
    /// The case and its result: `case/quantity`.
    pub from: String,
    /// Which value of it.
    #[serde(rename = "as")]
    pub taken: Taken,
}

/// Which value of a linked result is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Taken {
    /// As computed, to the last bit.
    Exact,
    /// As the source prints it.
    Published,
}
