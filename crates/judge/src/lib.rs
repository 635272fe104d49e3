//! Rules of practice for gearboxes and hydromotors: the quantity of each, its limits by severity, their
//! source, a remedy.
//!
//! A [`Rule`] has [`Bounds`]: a range for each [`Severity`]. A value inside all of them holds. Outside one it
//! is a remark, a warning or an error, whichever is worst. [`Limits`] judge values, and may hold ranges of
//! their own in place of the usual ones.
//!
//! ```
//! use epicyclic_judge::{Limits, Rule, Severity};
//! let verdict = Limits::default().judge(Rule::SpecificSliding, 3.4);
//! assert_eq!(verdict.severity, Some(Severity::Warning));
//! assert_eq!(verdict.miss().unwrap(), "specific sliding 3.4, at most 3 by usual practice");
//! ```

mod bounds;
mod rule;
mod severity;
mod tolerance;
mod verdict;

pub use bounds::{Bounds, Range};
pub use rule::Rule;
pub use severity::Severity;
pub use verdict::{Limits, Verdict};
