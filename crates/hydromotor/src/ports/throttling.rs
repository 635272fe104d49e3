//! The pressure drop over the openings.
//!
//! All openings to a pressure lie side by side between it and the chambers. The motor's flow `Q·ω` through
//! their sum `A_o` makes the drop
//!
//! ```text
//! Δp_o = ½·ϱ·(Q·ω/(C_d·A_o))²
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `ϱ` | `density` | density of the fluid | kg/m³ |
//! | `C_d` | `discharge` | discharge coefficient of the openings, an input | 1 |
//! | `ω` | `speed` | speed of the rotor | rad/s |
//!
//! The discharge coefficient depends on edges and channels. One drop for all openings is the model: the
//! chamber that is just opening has a greater one of its own, until compression of its oil limits it. The
//! channels beyond the plate are left out.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Area, Length, MassDensity, Power, Pressure};

use crate::Error;
use crate::modules::area;
use crate::ports::{PortPlate, of};
use crate::quantity::{PortSide, Quantity};
use crate::ranges::{self, positive};
use crate::tolerance::OPEN;

/// Number of rotations of a period that are evaluated.
const PLACES: u32 = 60;

/// A fluid through ports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Through {
    /// Width of the motor, `b`.
    pub width: Length,
    /// Speed of the rotor, above 0.
    pub speed: AngularVelocity,
    /// Density of the fluid.
    pub density: MassDensity,
    /// Discharge coefficient, above 0 and at most 1.
    pub discharge: f64,
}

/// The throttling by the ports of a pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throttling {
    /// The smallest sum of the openings.
    pub smallest_opening: Area,
    /// The rotation of the rotor at which it is so.
    pub rotation: Angle,
    /// The drop there.
    pub drop: Pressure,
    /// The greatest drop over a revolution.
    pub greatest_drop: Pressure,
    /// The mean of drop times flow over a revolution.
    pub power: Power,
}

impl PortPlate {
    /// The throttling by the ports of a pressure, at 60 rotations of a period.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for width, speed and density, [`Error::OutOfRange`] for the discharge
    /// coefficient, [`Error::NoOpening`] where all ports of the pressure are closed at once.
    pub fn throttling(&self, side: PortSide, through: Through) -> Result<Throttling, Error> {
        let width = crate::machine::width(through.width)?.si();
        let speed = positive(Quantity::Speed, through.speed.si(), "rad/s")?;
        let density = ranges::density(through.density)?;
        let discharge = ranges::discharge_coefficient(through.discharge)?;
        let module = self.motor.module();
        let period = self.motor.period();
        let (mut smallest, mut greatest, mut sum) = ((f64::INFINITY, 0.0, 0.0), 0.0_f64, 0.0);
        for i in 0..PLACES {
            // From where a chamber changes over on, and there too.
            let rotation = period * f64::from(i) / f64::from(PLACES);
            let opening = self.opening_sum(side, rotation);
            if opening <= OPEN * self.ports[of(side)].area() {
                return Err(Error::NoOpening { side, rotation_deg: Angle::from_si(rotation).degrees() });
            }
            let flow = self.motor.flow_per_width(Angle::from_si(rotation))?.si() * width * speed;
            let velocity = flow / (discharge * area(opening, module).si());
            let drop = 0.5 * density * velocity * velocity;
            if opening < smallest.0 {
                smallest = (opening, rotation, drop);
            }
            greatest = greatest.max(drop);
            sum += drop * flow;
        }
        Ok(Throttling {
            smallest_opening: area(smallest.0, module),
            rotation: Angle::from_si(smallest.1),
            drop: Pressure::from_si(smallest.2),
            greatest_drop: Pressure::from_si(greatest),
            power: Power::from_si(sum / f64::from(PLACES)),
        })
    }

    /// The sum of the openings of all chambers to a pressure, in units of the module.
    fn opening_sum(&self, side: PortSide, rotation: f64) -> f64 {
        let chambers = 0..self.motor.numbers().satellites();
        chambers
            .map(|j| self.opening(side, rotation + self.motor.chamber_phase() * (f64::from(j) + 0.5)))
            .sum()
    }
}
