//! The tooth root: its critical section, and the factors of root stress and of its limit.
//!
//! | file | answers |
//! |---|---|
//! | [`section`] | thickness, lever arm and fillet radius of the critical section |
//! | [`factors`] | `Y_F`, `Y_S`, `Y_β`, `Y_B`, `Y_DT`, and of the limit `Y_δrelT`, `Y_RrelT`, `Y_X`, `Y_M` |
//!
//! The critical section is where the fillet's tangent makes 30° (60° of a ring) with the tooth's centre line.

pub mod factors;
#[cfg(test)]
mod generated;
pub mod section;
