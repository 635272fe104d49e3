//! A drive cycle of a gearbox of four sets with losses and planets.

use crate::common;

use common::{drive_cycle, end_speed, s};
use epicyclic_motion::Start;

#[test]
fn ten_seconds_of_driving_balance_their_energies() {
    let run = drive_cycle().run(&Start::at_rest(), s(10.0), Some(s(0.5))).unwrap();
    assert!(run.audit.residual().abs() < 1e-9);
    assert_eq!(run.samples.len(), 21);
    // Fourth gear at the end.
    assert!((end_speed(&run, "in") / end_speed(&run, "out") - 5.0 / 3.0).abs() < 1e-9);
}
