//! The program `epicyclic`.
fn main() {}
