//! Pictures of planetary gearboxes.
