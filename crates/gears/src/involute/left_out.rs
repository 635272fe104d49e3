//! Sets of teeth that a check leaves out of a search.

use super::check::{Check, Rule};
use std::fmt;

/// Sets that a check leaves out of a search: how many, and one of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    /// Number of sets.
    pub count: u64,
    /// Teeth of the first, as `18/12/42`.
    pub teeth: String,
    /// The rule that the first does not keep.
    pub rule: Rule,
    /// The check that the first does not pass, with its figures.
    pub miss: String,
}

impl LeftOut {
    /// Adds a set that a check leaves out.
    pub fn add<P: fmt::Display>(
        all: &mut Option<Box<Self>>,
        teeth: impl FnOnce() -> String,
        check: &Check<P>,
    ) {
        match all {
            Some(all) => all.count += 1,
            None => {
                let (teeth, rule, miss) = (teeth(), check.rule, check.to_string());
                *all = Some(Box::new(Self { count: 1, teeth, rule, miss }));
            }
        }
    }
}

impl fmt::Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { count, teeth, rule, miss } = self;
        let (sets, are) = if *count == 1 { ("set", "is") } else { ("sets", "are") };
        let (rule, remedy) = (rule.name(), rule.remedy());
        write!(f, "{count} {sets} {are} left out, first {teeth}: {miss} ({rule}: {remedy})")
    }
}
