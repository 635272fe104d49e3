//! Sets of teeth that a check leaves out of a search.

use super::check::Check;

/// Sets of a wanted ratio that a check leaves out: how many, and one of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatioLeftOut {
    /// How many.
    pub count: u64,
    /// Teeth of sun, planet and ring of the first.
    pub teeth: [u32; 3],
    /// The check that the first does not pass.
    pub check: Check,
}

impl RatioLeftOut {
    /// One more that a check leaves out.
    pub(crate) fn add(all: &mut Option<Box<Self>>, teeth: [u32; 3], check: Check) {
        match all {
            Some(all) => all.count += 1,
            None => *all = Some(Box::new(Self { count: 1, teeth, check })),
        }
    }
}

impl std::fmt::Display for RatioLeftOut {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [sun, planet, ring] = self.teeth;
        let (sets, are) = if self.count == 1 { ("set", "is") } else { ("sets", "are") };
        write!(
            f,
            "{} {sets} of this ratio {are} left out, {sun}/{planet}/{ring} since {} ({}: {})",
            self.count,
            self.check,
            self.check.rule.name(),
            self.check.rule.remedy()
        )
    }
}
