//! The power through each mesh of a set, from the torques on its central gears alone.

use crate::tolerance::POWER;

/// Path of a set's power through its meshes, a tree of central gears and planets.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Flows {
    /// Speed of each central gear relative to the carrier, over that of the first.
    pub(crate) speeds: Vec<f64>,
    /// Body of each central gear: planet shafts turn with their planets.
    pub(super) bodies: Vec<usize>,
    /// Bodies of the gears of each mesh, the one nearer to the root first, and its efficiency.
    pub(super) meshes: Vec<([usize; 2], f64)>,
}

/// Part of the torques on the central gears that a mesh transmits to a planet.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Part {
    /// The whole torque of one central gear, whose only mesh it is.
    Whole(usize),
    /// Part of a central gear in several meshes. `all` holds the meshes of the gear, each with 1 if the gear
    /// is the one nearer to the root, else −1. A share that losses leave open is divided equally.
    Shared { central: usize, mesh: usize, all: Vec<(usize, f64)> },
    /// Mesh between two planets: the power through it times this factor.
    Between { mesh: usize, factor: f64 },
}

impl Flows {
    pub(super) fn torque(&self, part: &Part, torques: &[f64]) -> f64 {
        match part {
            Part::Whole(central) => torques[*central],
            Part::Shared { central, mesh, all } => {
                let of = |one: &(usize, f64)| one.1 * self.through(one.0, torques) / self.speeds[*central];
                let sum: f64 = all.iter().map(of).sum();
                let own = all.iter().find(|one| one.0 == *mesh).map_or(0.0, of);
                own + (torques[*central] - sum) / all.len() as f64
            }
            Part::Between { mesh, factor } => factor * self.through(*mesh, torques),
        }
    }

    /// Power that a mesh carries from its first gear's side, for a speed of 1 of the first central gear
    /// relative to the carrier: the mean of the powers that enter and leave the mesh.
    pub(crate) fn through(&self, mesh: usize, torques: &[f64]) -> f64 {
        let powers = || self.speeds.iter().zip(torques).map(|(speed, torque)| speed * torque);
        let (sum, largest) = (powers().sum::<f64>(), powers().map(f64::abs).fold(0.0, f64::max));
        // More power enters than leaves, so the sum has the sign of the set's rotation. If it is 0, nothing
        // is lost.
        let sense = if sum.abs() <= POWER * largest { 0.0 } else { sum.signum() };
        let [first, second] = self.meshes[mesh].0;
        (self.out_of(first, mesh, torques, sense) - self.out_of(second, mesh, torques, sense)) / 2.0
    }

    /// Power that a body passes into one of its meshes: its own power, and that from its other meshes.
    fn out_of(&self, body: usize, into: usize, torques: &[f64], sense: f64) -> f64 {
        let own = (0..self.bodies.len()).filter(|&central| self.bodies[central] == body);
        let own: f64 = own.map(|central| self.speeds[central] * torques[central]).sum();
        let others = (0..self.meshes.len()).filter(|&mesh| mesh != into);
        let brought = others.filter_map(|mesh| {
            let (ends, efficiency) = self.meshes[mesh];
            let from = match ends {
                [one, other] if one == body => other,
                [one, other] if other == body => one,
                _ => return None,
            };
            let power = self.out_of(from, mesh, torques, sense);
            Some(if power * sense >= 0.0 {
                power * libm::pow(efficiency, sense.abs())
            } else {
                power / efficiency
            })
        });
        own + brought.sum::<f64>()
    }
}
