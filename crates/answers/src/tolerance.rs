//! Every number below which something counts as nothing, and every limit of size that is small.
//!
//! | constant | of | why this size |
//! |---|---|---|
//! | `ROUNDED` | the loss of a balance of powers, over the power that enters; the imbalance of planets, over that of one | rounding of the sums leaves 1e-15 to 1e-13 |
//! | `CLOSED` | the angle by which a hydromotor's wheel fails to close, in rad, where the telling begins | rounding of the quadrature |
//! | `SAME_SPEED` | the error of a member of a printed series of speeds, relative | beyond the rounding of its powers, and far below what is printed |
//! | `OBJECTIVE` | a difference of two objectives | the order compares on a grid of this size |
//! | `LEAST_MODULE_M` | the module, in m, where no least one is given | a micrometre: no gear has less |

pub(crate) const ROUNDED: f64 = 1e-12;
pub(crate) const CLOSED: f64 = 1e-12;
pub(crate) const SAME_SPEED: f64 = 1e-9;
pub(crate) const OBJECTIVE: f64 = 2e-12;
pub(crate) const LEAST_MODULE_M: f64 = 1e-6;
