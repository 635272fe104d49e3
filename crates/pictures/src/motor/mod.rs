//! Pictures of hydromotors.
