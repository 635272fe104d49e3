//! `machine`: speeds of mining machines.

pub mod answer;
pub mod options;
pub mod request;
pub mod table;

pub use answer::{MachineSpeeds, Machines};
pub use options::{ChainCutter, Drum, List, Rotor, Speeds};
