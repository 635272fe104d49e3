//! Verification of the project against its source documents.
fn main() {}
