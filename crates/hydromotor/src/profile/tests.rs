//! Checks of the profiles by ways that do not share their formulas.
