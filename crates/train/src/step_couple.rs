//! Moment that the forces of a stepped planet's gears have about its middle, since they lie in different planes.
//!
//! ```text
//! F = τ/r_w across the line of centres,   |F|·tan α_w away from the mate        M = Σ z⃗·z_k × F⃗_k
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `τ` | torque of one mesh on a gear of the planet ([`mesh_loads`](crate::mesh_loads)) | N·m |
//! | `r_w`, `α_w` | working pitch radius and working pressure angle in the transverse section | m, rad |
//! | `z_k` | place of the gear's middle along the axis, from the middle of all gears, which lie side by side | m |
//! | `M` | moment that tilts the planet, about the direction outwards and about that of its motion | N·m |
//!
//! Left out: gaps between the gears, and the axial forces, which have [a moment of their own](crate::axial_forces).

use crate::planet_set::{GearOf, PlanetSet};
use crate::toothed::ToothedSet;
use epicyclic_units::Physical;
use uom::si::f64::{Length, Torque};

impl PlanetSet {
    /// Whether a planet has several gears.
    #[must_use]
    pub fn has_stepped_planets(&self) -> bool {
        (0..self.planets().len()).any(|planet| self.is_stepped(planet))
    }

    /// Whether a planet has several gears.
    #[must_use]
    pub fn is_stepped(&self, planet: usize) -> bool {
        let is_own = |gear: &&GearOf| matches!(gear, GearOf::Planet(of, _) if *of == planet);
        self.gears().iter().filter(is_own).count() > 1
    }

    /// Moment of the gears' forces about the middle of a planet at these torques on the members of its set, N·m;
    /// `widths` in the order of [`gears`](Self::gears). `None` where the loads of its meshes do not follow, and where
    /// two planets in mesh do not reach each other.
    #[must_use]
    pub fn step_couple(
        &self,
        planet: usize,
        (toothed, is_behind): (&ToothedSet, &[bool]),
        torques: &[Torque],
        widths: &[Length],
    ) -> Option<[f64; 2]> {
        let loads = self.mesh_loads(&torques.iter().map(|torque| torque.si()).collect::<Vec<_>>())?;
        let angles = self.angles_between(toothed, is_behind)?;
        let order = self.gears();
        let is_own = |gear: &GearOf| matches!(gear, GearOf::Planet(of, _) if *of == planet);
        let own: Vec<(GearOf, f64)> = order
            .iter()
            .zip(widths)
            .filter(|(gear, _)| is_own(gear))
            .map(|(gear, width)| (*gear, width.si()))
            .collect();
        let length: f64 = own.iter().map(|(_, width)| width).sum();
        let place = |gear: GearOf| {
            let at = own.iter().position(|(one, _)| *one == gear)?;
            let before: f64 = own[..at].iter().map(|(_, width)| width).sum();
            Some(before + own[at].1 / 2.0 - length / 2.0)
        };
        let mut moment = [0.0; 2];
        for (mesh, (made, load)) in toothed.meshes.iter().zip(&loads).enumerate() {
            for (end, gear) in made.gears.into_iter().enumerate().filter(|(_, gear)| is_own(gear)) {
                let radius = made.module * made.pair.working_diameters()[end] / 2.0;
                let [out, along] = self.pitch_point(toothed, &angles, mesh, end)?;
                let across = load.torques[end] / radius * load.contacts[end];
                let apart = across.abs() * libm::tan(made.pair.working_angle_rad());
                let force = [-across * along - apart * out, across * out - apart * along];
                let place = place(gear)?;
                moment[0] -= place * force[1];
                moment[1] += place * force[0];
            }
        }
        Some(moment)
    }
}

#[cfg(test)]
mod tests {
    use crate::compound::{CentralKind, CompoundSpec};
    use crate::{GROUND, Gearbox};
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_gears::rack::BasicRack;
    use uom::si::f64::{Length, Torque};
    use uom::si::{length::millimeter, torque::newton_meter};

    fn near(one: f64, other: f64) {
        assert!((one - other).abs() < 1e-9 * other.abs().max(1.0), "{one} for {other}");
    }

    /// A Wolfrom set by hand: both rings' forces, a plane apart, against each other.
    #[test]
    fn the_rings_of_a_wolfrom_set_tilt_its_planets() {
        let ideal = MeshEfficiency::IDEAL;
        let set = CompoundSpec::new("W", "arm")
            .central(CentralKind::Sun, "sun", 34.0)
            .central(CentralKind::Ring, GROUND, 102.0)
            .central(CentralKind::Ring, "out", 100.0)
            .planet("p", &[34, 32])
            .mesh("sun", "p.1", ideal)
            .mesh("p.1", GROUND, ideal)
            .mesh("p.2", "out", ideal)
            .planet_count(3);
        let gearbox = Gearbox::builder("W")
            .links(["sun", "out", "arm"])
            .compound_set(set)
            .input("sun")
            .output("out")
            .gear("only", [""; 0])
            .build()
            .unwrap();
        let set = &gearbox.sets()[0];
        let toothed = set.toothed(&BasicRack::default(), &[Some(0.002); 3]).unwrap();
        // 10 N·m on the sun, so 1000 N·m on the output and 990 on the housing; nothing on the arm.
        let torques = [10.0, 990.0, -1000.0, 0.0].map(Torque::new::<newton_meter>);
        let widths = [34.0, 34.0, 34.0, 34.0, 20.0].map(Length::new::<millimeter>);
        let moment = set.step_couple(0, (&toothed, &[false; 3]), &torques, &widths).unwrap();
        let [of_sun, of_first, of_second] =
            [10.0 / (3.0 * 0.034), 990.0 / (3.0 * 0.102), 1000.0 / (3.0 * 0.1)];
        near(of_sun + of_first, of_second);
        // Middles of 34 and 20 mm side by side.
        let apart = 0.027;
        let tan = libm::tan(20.0_f64.to_radians());
        let [z_first, z_second] = [-0.01, 0.017];
        near(z_second - z_first, apart);
        near(moment[0].abs(), of_second * apart);
        let radial = [(of_sun - of_first) * tan, -of_second * tan];
        near(moment[1].abs(), (z_first * radial[0] + z_second * radial[1]).abs());
    }
}
