//! Planetary gearboxes: rows tied by links and controls. Nothing is here yet.
