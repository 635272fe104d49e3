//! `teeth`: tooth numbers for a ratio.

pub mod answer;
pub mod options;
pub mod request;
pub mod table;

pub use answer::arranged::{ArrangedNumbers, ArrangedSets};
pub use answer::double_planet::DoublePlanetTeeth;
pub use answer::shifted::ShiftedTeeth;
pub use answer::{Teeth, ToothNumbers};
pub use options::Request;
