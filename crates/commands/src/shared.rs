//! Parts that several commands share.

pub mod catalogue;
pub mod drawability;
pub mod exciting;
pub mod fault;
pub mod gearbox;
pub(crate) mod gearbox_choice;
pub mod judgement;
pub mod lists;
pub mod load;
pub mod named;
pub mod named_gearbox;
pub mod number;
pub mod options;
pub mod page_options;
pub mod places;
pub mod profile_shift;
pub mod ratios;
pub mod records;
pub mod saved;
pub mod scenario;
pub mod selection;
pub mod tool;
pub mod tooth_checks;
pub mod toothed;
pub mod transmissions;
