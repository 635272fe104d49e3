//! Options of what the input of a gearbox does.

use crate::analyze::answer::Input;
use epicyclic_train::InputLoad;
use epicyclic_units::Quantity;
use uom::si::f64::{AngularVelocity, Power, Torque};

/// Options of the speed and load of the input.
#[derive(Debug, Clone, Copy, Default, clap::Args)]
pub struct Load {
    /// Torque on the input: 500 N·m.
    #[arg(long, conflicts_with = "power", allow_hyphen_values = true)]
    pub torque: Option<Quantity<Torque>>,

    /// Power into the input: 75 kW; needs --speed.
    #[arg(long, requires = "speed", allow_hyphen_values = true)]
    pub power: Option<Quantity<Power>>,

    /// Speed of the input: 1475 rpm.
    #[arg(long, visible_alias = "input", allow_hyphen_values = true)]
    pub speed: Option<Quantity<AngularVelocity>>,
}

impl Load {
    /// An option that is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let torque = self.torque.map(|_| "--torque");
        torque.or(self.power.map(|_| "--power")).or(self.speed.map(|_| "--speed"))
    }

    pub(crate) fn input(&self) -> Input {
        let torque = self.torque.map(|torque| InputLoad::Torque(torque.0));
        let load = torque.or(self.power.map(|power| InputLoad::Power(power.0)));
        Input { speed: self.speed.map(|speed| speed.0), load }
    }
}
