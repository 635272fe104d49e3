//! `synthesize`: every gearbox that has a list of ratios.

pub mod answer;
pub mod page;
pub mod request;
pub mod search_size;
#[cfg(feature = "tables")]
pub mod shards;
#[cfg(not(feature = "tables"))]
#[path = "synthesize/no_shards.rs"]
pub mod shards;
pub mod table;
pub mod teeth_wanted;
pub mod usable;

pub use answer::Synthesis;
pub use request::Request;
