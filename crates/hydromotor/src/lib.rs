//! Hydromotors with non-circular wheels and floating satellites. Nothing is here yet.
