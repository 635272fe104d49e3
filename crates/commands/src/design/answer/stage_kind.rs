//! Kinds of stages.

use schemars::JsonSchema;
use serde::Serialize;

/// Kind of a stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "snake_case")]
pub enum StageKind {
    /// Simple sets: sun, planets, ring
    Simple,
    /// One set with stepped planets: one step with the sun, the other with the ring
    Stepped,
    /// One Wolfrom set: sun and resting ring with one step of the planets, the output ring with the other
    Wolfrom,
}

impl StageKind {
    /// Every kind.
    pub(crate) const ALL: [Self; 3] = [Self::Simple, Self::Stepped, Self::Wolfrom];

    /// Kind of a stage by its gears.
    pub(crate) const fn of(teeth: &[u32]) -> Self {
        match teeth.len() {
            4 => Self::Stepped,
            5 => Self::Wolfrom,
            _ => Self::Simple,
        }
    }

    /// The only stage, if its planets have two gears.
    pub(crate) fn compound(stages: &[Vec<u32>]) -> Option<&[u32]> {
        match stages {
            [stage] if Self::of(stage) != Self::Simple => Some(stage),
            _ => None,
        }
    }
}
