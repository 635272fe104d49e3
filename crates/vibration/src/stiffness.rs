//! Stiffness of a spring, and of one against rotation.

use epicyclic_units::Physical;
use uom::si::f64::Torque;
use uom::si::{ISQ, Quantity, SI};
use uom::typenum::{N2, P1, Z0};

/// Stiffness of a spring, N/m: what a [`Force`](uom::si::f64::Force) over a
/// [`Length`](uom::si::f64::Length) is.
///
/// ```
/// use epicyclic_vibration::{Stiffness, newtons_per_meter};
/// use uom::si::f64::{Force, Length};
/// use uom::si::{force::newton, length::micrometer};
///
/// let stiffness: Stiffness = Force::new::<newton>(500.0) / Length::new::<micrometer>(1.0);
/// assert!((stiffness / newtons_per_meter(5e8)).value - 1.0 < 1e-12);
/// ```
///
/// To the type an energy over an area is the same; that makes it [`Physical`].
pub type Stiffness = Quantity<ISQ<Z0, P1, N2, Z0, Z0, Z0, Z0>, SI<f64>, f64>;

/// A stiffness from its number in N/m.
#[must_use]
pub fn newtons_per_meter(value: f64) -> Stiffness {
    Stiffness::from_si(value)
}

/// Stiffness against rotation, N·m/rad: a torque per radian, as angles have no dimension.
pub type TorsionalStiffness = Torque;
