//! A simple planetary drive: the sun drives, the ring is at rest, the load acts on the carrier.
//!
//! # With mesh losses
//!
//! Losses act in the motion relative to the carrier. The inertia of the planets lies between the two meshes,
//! so the meshes carry different powers while the drive accelerates:
//!
//! ```text
//! sun      T_1 = M_1 − J_1·ε_1                                into the mesh sun–planet
//! planets  N·J_2·ε_2 = T_2 − e_12·T_1·z_2/z_1                 T_2 torque of the ring's teeth on them
//! ring     R = e_23·T_2·z_3/z_2                               torque of the housing on the ring
//! whole    M_1 − M_H + R = J_1·ε_1 + N·J_2·ε_2 + (N·m·r² + J_H)·ε_H
//! ```
//!
//! `e` is the efficiency of the mesh if power flows from the sun towards the ring, else its inverse. In
//! forward rotation power flows this way if the torque of the mesh (`T_1`, `T_2`) is above 0, in backward
//! rotation if it is below 0. In one line, with `k = z_3/z_1` and `η_0 = e_12·e_23`:
//!
//! ```text
//! J_η·ε_1 = M_1 − M_H/(1 + η_0·k)
//! J_η = J_1 + [N·J_2·u_2·(1 − e_23·z_3/z_2) + (N·m·r² + J_H)·u_H]/(1 + η_0·k)
//! ```
//!
//! # From rest
//!
//! At rest friction has no direction of its own: it opposes the motion that the torques would begin. Forward
//! motion begins if the force with the losses of forward motion is above 0. Backward motion begins if the
//! force with the losses of backward motion is below 0. With `M_1` ≥ 0 the first force has `η_0` in place of
//! `e_12·e_23`, the second `1/η_0`. This gives
//!
//! ```text
//! M_H < M_1·(1 + η_0·k)        starts forward
//! M_H > M_1·(1 + k/η_0)        runs backward, driven by the load
//! between, ends included       held by the friction of the meshes, ε = 0
//! ```
//!
//! With `M_1` < 0 the two bounds are exchanged. At each bound the acceleration on its side is 0 too. The
//! acceleration is therefore continuous in the load, and never rises with it.
//!
//! Without losses `1 + k = 1/u_H` and `u_2 = u_H·(1 − z_3/z_2)`, and `J_η` is the equivalent inertia.
//!
//! excavator-dynamics refers the load to the sun without its losses. The remaining driving force is then the
//! power that the meshes take.

use crate::Error;
use crate::energy::MovingBody;
use crate::equivalent_inertia::{Link, LinkName, Orbit, equivalent_inertia};
use crate::lagrange::{AppliedTorque, acceleration, generalized_force, link_acceleration};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_gears::willis;
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_train::{GROUND, Gearbox};
use epicyclic_units::Physical;
use uom::si::f64::{
    AngularAcceleration, AngularVelocity, Length, Mass, MomentOfInertia, Power, Torque, Velocity,
};

/// Gear set of a drive with its speeds, for which the solver is called once, here only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearSet {
    teeth: ToothNumbers,
    ratios: SpeedRatios,
}

/// Speeds of the links over that of the sun.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedRatios {
    /// Planet: `u_2 = z_1·(z_2 − z_3)/(z_2·(z_1 + z_3))`.
    pub planet: f64,
    /// Carrier: `u_H = z_1/(z_1 + z_3)`.
    pub carrier: f64,
}

impl GearSet {
    /// The gear set with these tooth numbers, its ring at rest.
    ///
    /// # Errors
    /// [`Error::Gearbox`] for teeth that make no planetary gear.
    pub fn new(teeth: ToothNumbers) -> Result<Self, Error> {
        let gearbox = gearbox(&teeth)?;
        let analysis = gearbox.analyze(GEAR)?;
        let carrier = gearbox.link("carrier").and_then(|link| analysis.speed(link));
        let planet = analysis.sets()[0].planets[0].and_then(|planet| planet.speed);
        let no_speed = || Error::NoSpeed { part: "the planet".into(), state: analysis.state().clone() };
        let (planet, carrier) = planet.zip(carrier).ok_or_else(no_speed)?;
        Ok(Self { teeth, ratios: SpeedRatios { planet, carrier } })
    }

    /// Teeth and number of planets.
    #[must_use]
    pub const fn teeth(&self) -> ToothNumbers {
        self.teeth
    }

    /// Speeds of the links over that of the sun.
    #[must_use]
    pub const fn ratios(&self) -> SpeedRatios {
        self.ratios
    }
}

/// Name of the only gear of a drive.
const GEAR: &str = "drive";

/// The drive as a gearbox: one set, ring in the housing.
fn gearbox(teeth: &ToothNumbers) -> Result<Gearbox, Error> {
    let members = ["sun", GROUND, "carrier"];
    let set = SetSpec::teeth("set", SetKind::Simple, members, teeth.sun.get(), teeth.ring.get())?
        .planet_teeth(teeth.planet, None)
        .planet_count(teeth.planets);
    let gearbox = Gearbox::builder("drive")
        .links(["sun", "carrier"])
        .set(set)
        .input("sun")
        .output("carrier")
        .gear(GEAR, [""; 0]);
    Ok(gearbox.build()?)
}

/// A simple planetary gear with its masses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanetaryDrive {
    /// Gear set of the drive.
    pub set: GearSet,
    /// Inertia of the driving shaft with the sun, `J_1`.
    pub sun_inertia: MomentOfInertia,
    /// Inertia of one planet about its own axis, `J_2`.
    pub planet_inertia: MomentOfInertia,
    /// Mass of one planet, `m`.
    pub planet_mass: Mass,
    /// Radius of the planets' centres, `r`.
    pub planet_radius: Length,
    /// Inertia of the carrier without planets, with what it drives, `J_H`.
    pub carrier_inertia: MomentOfInertia,
}

/// Accelerations of the links.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accelerations {
    /// Sun, `ε_1`.
    pub sun: AngularAcceleration,
    /// Planet, `ε_2`.
    pub planet: AngularAcceleration,
    /// Carrier, `ε_H`.
    pub carrier: AngularAcceleration,
}

/// Direction of rotation of a drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turning {
    /// The sun turns in the positive direction.
    Forward,
    /// The sun turns in the negative direction.
    Backward,
}

/// Motion of a drive from rest under constant torques, losses included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FromRest {
    /// The drive starts forward with this motion.
    Forward(LossyMotion),
    /// The friction of the meshes holds the drive: nothing accelerates. The division of the friction between
    /// the meshes is indeterminate.
    Held,
    /// The load turns the drive backward with this motion; accelerations are below 0.
    Backward(LossyMotion),
}

/// The drive under its torques, losses included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LossyMotion {
    /// Inertia that the driving torque feels, `J_η`.
    pub inertia: MomentOfInertia,
    /// Generalized force with the load referred to the sun through the losses, `M_1 − M_H/(1 + e_12·e_23·k)`.
    pub force: Torque,
    /// Accelerations of the links.
    pub accelerations: Accelerations,
    /// Torque of the housing on the ring, `R`.
    pub ring_torque: Torque,
    /// Torque of the sun on its meshes, `T_1`.
    pub sun_mesh_torque: Torque,
    /// Torque of the ring's teeth on all planets, `T_2`, about their own axes.
    pub planet_ring_torque: Torque,
}

impl PlanetaryDrive {
    /// The moving links in the order of the power, from which the equivalent inertia follows.
    #[must_use]
    pub fn links(&self) -> [Link; 3] {
        let ratios = self.set.ratios;
        let orbit = Orbit { mass: self.planet_mass, radius: self.planet_radius, speed_ratio: ratios.carrier };
        let planets = Link {
            count: self.set.teeth.planets,
            orbit: Some(orbit),
            ..Link::central(LinkName::Planets, self.planet_inertia, ratios.planet)
        };
        [
            Link::central(LinkName::Sun, self.sun_inertia, 1.0),
            planets,
            Link::central(LinkName::Carrier, self.carrier_inertia, ratios.carrier),
        ]
    }

    /// Equivalent inertia `J_pr`.
    ///
    /// ```text
    /// J_pr = J_1 + N·m·r²·(z_1/(z_1+z_3))² + N·J_2·(z_1(z_3−z_2)/(z_2(z_1+z_3)))² + J_H·(z_1/(z_1+z_3))²
    /// ```
    ///
    /// # Errors
    /// As [`Link::equivalent_inertia`].
    ///
    /// # Source
    /// excavator-dynamics, where the planets' mass term is printed with `(z_1 + z_2)²`, against its
    /// own equation of motion.
    pub fn equivalent_inertia(&self) -> Result<MomentOfInertia, Error> {
        equivalent_inertia(&self.links())
    }

    /// The bodies as they move at `speed` of the sun, their speeds from Willis' equation.
    ///
    /// # Errors
    /// [`Error::Gear`] for a gear set without a carrier speed.
    pub fn bodies(&self, speed: AngularVelocity) -> Result<Vec<MovingBody>, Error> {
        let set = self.set.teeth.basic_ratio();
        let speeds = willis::speeds(set, Some(speed), Some(AngularVelocity::from_si(0.0)), None)?;
        let planet_to_sun = self.set.teeth.planet.as_f64() / self.set.teeth.sun.as_f64();
        let planet = willis::planet_speed(planet_to_sun, speeds.sun, speeds.carrier)?;
        let orbital = Velocity::from_si(speeds.carrier.si() * self.planet_radius.si());
        let planet = MovingBody {
            inertia: self.planet_inertia,
            speed: planet.absolute,
            mass: self.planet_mass,
            centre_speed: orbital,
        };
        let mut bodies = vec![
            MovingBody::turning(self.sun_inertia, speeds.sun),
            MovingBody::turning(self.carrier_inertia, speeds.carrier),
        ];
        bodies.extend((0..self.set.teeth.planets).map(|_| planet));
        Ok(bodies)
    }

    /// Generalized force without losses, `Q = M_1 − M_H·z_1/(z_1 + z_3)`.
    #[must_use]
    pub fn generalized_force(&self, driving: Torque, load: Torque) -> Torque {
        generalized_force(&[
            AppliedTorque { torque: driving, speed_ratio: 1.0 },
            AppliedTorque { torque: -load, speed_ratio: self.set.ratios.carrier },
        ])
    }

    /// Accelerations of the links for one of the sun.
    #[must_use]
    pub fn accelerations(&self, sun: AngularAcceleration) -> Accelerations {
        let of = |ratio| link_acceleration(sun, ratio);
        Accelerations { sun, planet: of(self.set.ratios.planet), carrier: of(self.set.ratios.carrier) }
    }

    /// Accelerations under a driving torque on the sun and a load on the carrier, without losses.
    ///
    /// # Errors
    /// [`Error::NoInertia`], and as [`Link::equivalent_inertia`].
    pub fn motion(&self, driving: Torque, load: Torque) -> Result<Accelerations, Error> {
        let force = self.generalized_force(driving, load);
        Ok(self.accelerations(acceleration(force, self.equivalent_inertia()?)?))
    }

    /// Loads on the carrier that the friction of the meshes holds at rest against a driving torque, the least
    /// and the greatest: `M_1·(1 + η_0·k)` and `M_1·(1 + k/η_0)`, in ascending order. Without losses both are
    /// `M_1·(1 + k)`.
    #[must_use]
    pub fn held_loads(
        &self,
        driving: Torque,
        sun_planet: MeshEfficiency,
        planet_ring: MeshEfficiency,
    ) -> [Torque; 2] {
        let (z1, _, z3) = self.tooth_numbers();
        let eta0 = sun_planet.get() * planet_ring.get();
        let [forward, backward] = [eta0, 1.0 / eta0].map(|e| driving * (1.0 + e * z3 / z1));
        if forward <= backward { [forward, backward] } else { [backward, forward] }
    }

    /// Motion of the drive from rest: it starts forward, is held by the friction of its meshes, or runs
    /// backward.
    ///
    /// # Errors
    /// [`Error::NoInertia`], [`Error::SelfLocking`], and those of [`Link::equivalent_inertia`].
    pub fn from_rest(
        &self,
        driving: Torque,
        load: Torque,
        sun_planet: MeshEfficiency,
        planet_ring: MeshEfficiency,
    ) -> Result<FromRest, Error> {
        let [least, greatest] = self.held_loads(driving, sun_planet, planet_ring);
        let turning = match load {
            load if load < least => Turning::Forward,
            load if load > greatest => Turning::Backward,
            _ => return Ok(FromRest::Held),
        };
        let motion = self.motion_with_losses(driving, load, sun_planet, planet_ring, turning)?;
        let epsilon = motion.accelerations.sun.si();
        match turning {
            Turning::Forward if epsilon >= 0.0 => Ok(FromRest::Forward(motion)),
            Turning::Backward if epsilon <= 0.0 => Ok(FromRest::Backward(motion)),
            // Losses so large that the inertia of the planets outweighs all else.
            Turning::Forward | Turning::Backward => Err(Error::SelfLocking),
        }
    }

    /// Motion with the losses of the meshes, for a drive that turns in a given direction. A drive that turns
    /// against its acceleration slows down. [`from_rest`](Self::from_rest) gives the motion at rest.
    ///
    /// # Errors
    /// [`Error::NoInertia`], [`Error::SelfLocking`], and those of [`Link::equivalent_inertia`].
    pub fn motion_with_losses(
        &self,
        driving: Torque,
        load: Torque,
        sun_planet: MeshEfficiency,
        planet_ring: MeshEfficiency,
        turning: Turning,
    ) -> Result<LossyMotion, Error> {
        // Refuses impossible masses before any of them is used.
        self.equivalent_inertia()?;
        let (z1, z2, z3) = self.tooth_numbers();
        let ratios = self.set.ratios;
        let planets = f64::from(self.set.teeth.planets);
        let (j1, j2) = (self.sun_inertia.si(), planets * self.planet_inertia.si());
        let orbital = planets * self.planet_mass.si() * self.planet_radius.si().powi(2);
        let jh = self.carrier_inertia.si() + orbital;
        let (m1, mh) = (driving.si(), load.si());
        let (eta_12, eta_23) = (sun_planet.get(), planet_ring.get());

        // Four pairs of directions of the two mesh powers, of which one is consistent while `e_23·z_3/z_2` is
        // above 1.
        for (e_12, e_23) in
            [(eta_12, eta_23), (1.0 / eta_12, 1.0 / eta_23), (eta_12, 1.0 / eta_23), (1.0 / eta_12, eta_23)]
        {
            let arriving = 1.0 + e_12 * e_23 * z3 / z1;
            let j = j1 + (j2 * ratios.planet * (1.0 - e_23 * z3 / z2) + jh * ratios.carrier) / arriving;
            let force = m1 - mh / arriving;
            let epsilon = acceleration(Torque::from_si(force), MomentOfInertia::from_si(j))?.si();
            let t1 = m1 - j1 * epsilon;
            let t2 = j2 * ratios.planet * epsilon + e_12 * t1 * z2 / z1;
            let consistent = |torque: f64, e: f64, eta: f64| {
                let from_sun = match turning {
                    Turning::Forward => torque > 0.0,
                    Turning::Backward => torque < 0.0,
                };
                // A mesh without power, or without losses, has no direction to contradict.
                torque == 0.0 || eta == 1.0 || from_sun == (e < 1.0)
            };
            if consistent(t1, e_12, eta_12) && consistent(t2, e_23, eta_23) {
                return Ok(LossyMotion {
                    inertia: MomentOfInertia::from_si(j),
                    force: Torque::from_si(force),
                    accelerations: self.accelerations(AngularAcceleration::from_si(epsilon)),
                    ring_torque: Torque::from_si(e_23 * t2 * z3 / z2),
                    sun_mesh_torque: Torque::from_si(t1),
                    planet_ring_torque: Torque::from_si(t2),
                });
            }
        }
        Err(Error::SelfLocking)
    }

    /// Power that the meshes take at `speed` of the sun.
    ///
    /// Summed mesh by mesh, so that the balance of powers tests the motion.
    #[must_use]
    pub fn mesh_loss(
        &self,
        motion: &LossyMotion,
        speed: AngularVelocity,
        sun_planet: MeshEfficiency,
        planet_ring: MeshEfficiency,
    ) -> Power {
        let (z1, z2, _) = self.tooth_numbers();
        let relative = speed.si() * (1.0 - self.set.ratios.carrier);
        let lost = |into_mesh: f64, eta: MeshEfficiency| {
            // A driven mesh loses of what enters here; in a back-driven one this is what is left.
            let eta = eta.get();
            into_mesh.abs() * if into_mesh > 0.0 { 1.0 - eta } else { 1.0 / eta - 1.0 }
        };
        let from_sun = motion.sun_mesh_torque.si() * relative;
        let from_planets = motion.planet_ring_torque.si() * relative * z1 / z2;
        Power::from_si(lost(from_sun, sun_planet) + lost(from_planets, planet_ring))
    }

    fn tooth_numbers(&self) -> (f64, f64, f64) {
        (self.set.teeth.sun.as_f64(), self.set.teeth.planet.as_f64(), self.set.teeth.ring.as_f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::kinetic_energy;
    use crate::equivalent_inertia::Property;
    use crate::gearbox::{Masses, PlanetMass, PlanetMasses, moving_links};
    use epicyclic_gears::teeth::ToothCount;
    use epicyclic_units::Physical;
    use proptest::prelude::*;
    use uom::si::f64::{AngularVelocity, Length, Mass, MomentOfInertia, Torque};

    fn teeth(sun: u32, planet: u32, planets: u32) -> ToothNumbers {
        let z = |count| ToothCount::new(count).unwrap();
        ToothNumbers { sun: z(sun), planet: z(planet), ring: z(sun + 2 * planet), planets }
    }

    /// The excavator's drive with the source's printed masses and inertias.
    fn excavator() -> PlanetaryDrive {
        PlanetaryDrive {
            set: GearSet::new(teeth(20, 40, 4)).unwrap(),
            sun_inertia: MomentOfInertia::from_si(0.00818),
            planet_inertia: MomentOfInertia::from_si(0.3),
            planet_mass: Mass::from_si(31.5),
            planet_radius: Length::from_si(0.240),
            carrier_inertia: MomentOfInertia::from_si(0.144),
        }
    }

    fn eta(value: f64) -> MeshEfficiency {
        MeshEfficiency::new(value).unwrap()
    }

    #[test]
    fn the_excavator_accelerates_at_a_third_of_what_its_sum_says() {
        // By hand: 0.00818 + (4·31.5·0.24² + 0.144)/36 + 4·0.3/16.
        let by_hand = 0.00818 + (4.0 * 31.5 * 0.0576 + 0.144) / 36.0 + 0.075;
        let j = excavator().equivalent_inertia().unwrap().si();
        assert!((j - by_hand).abs() < 1e-15);
        let found = excavator().motion(Torque::from_si(521.8), Torque::from_si(2974.26)).unwrap();
        assert!((found.sun.si() - 26.09 / by_hand).abs() < 1e-9);
        assert!((found.planet.value / found.sun.value - -0.25).abs() < 1e-15);
    }

    #[test]
    fn at_full_load_the_losses_leave_nothing_to_accelerate() {
        let (e12, e23) = (eta(0.97), eta(0.98));
        let full = 521.8 * (1.0 + 5.0 * 0.97 * 0.98);
        let found = excavator()
            .motion_with_losses(Torque::from_si(521.8), Torque::from_si(full), e12, e23, Turning::Forward)
            .unwrap();
        assert!(found.accelerations.sun.si().abs() < 1e-9);
    }

    /// The excavator's drive, torque at rated power: by hand 521.54·(1 + 5·0.9506) and 521.54·(1 + 5/0.9506).
    #[test]
    fn the_meshes_hold_the_excavator_between_two_loads() {
        let (e12, e23) = (eta(0.97), eta(0.98));
        let (drive, driving) = (excavator(), Torque::from_si(521.538_5));
        let [least, greatest] = drive.held_loads(driving, e12, e23).map(Physical::si);
        assert!((least - 3000.41).abs() < 0.01 && (greatest - 3264.74).abs() < 0.01, "{least} {greatest}");
        let at = |load: f64| drive.from_rest(driving, Torque::from_si(load), e12, e23).unwrap();
        assert!(matches!(at(2999.0), FromRest::Forward(motion) if motion.force.si() > 0.0));
        for held in [3001.0, 3050.0, 3264.0] {
            assert_eq!(at(held), FromRest::Held);
        }
        let FromRest::Backward(motion) = at(3300.0) else { panic!("{:?}", at(3300.0)) };
        // 521.5385 − 3300/(1 + 5/0.9506)
        assert!((motion.force.si() - -5.632).abs() < 1e-3, "{}", motion.force.si());
        assert!(motion.accelerations.sun.si() < 0.0);
        // Turning forward it slows down under the same load, and faster: friction and load both oppose it.
        let forward =
            drive.motion_with_losses(driving, Torque::from_si(3300.0), e12, e23, Turning::Forward).unwrap();
        assert!((forward.force.si() - -52.076).abs() < 1e-3, "{}", forward.force.si());
    }

    #[test]
    fn a_drive_without_torque_is_held_by_nothing() {
        let (e12, e23) = (eta(0.97), eta(0.98));
        let at =
            |load: f64| excavator().from_rest(Torque::from_si(0.0), Torque::from_si(load), e12, e23).unwrap();
        assert!(matches!(at(-1.0), FromRest::Forward(_)));
        assert_eq!(at(0.0), FromRest::Held);
        assert!(matches!(at(1.0), FromRest::Backward(_)));
    }

    #[test]
    fn the_links_are_those_that_the_solver_moves() {
        let drive = excavator();
        let each = vec![PlanetMass {
            mass: drive.planet_mass,
            inertia: drive.planet_inertia,
            radius: drive.planet_radius,
        }];
        let masses = Masses {
            links: vec![("sun".into(), drive.sun_inertia), ("carrier".into(), drive.carrier_inertia)],
            planets: vec![("set".into(), PlanetMasses { count: 4, each })],
        };
        let [sun, carrier, planets]: [Link; 3] =
            moving_links(&gearbox(&drive.set.teeth()).unwrap(), GEAR, &masses).unwrap().try_into().unwrap();
        for (own, solved) in drive.links().into_iter().zip([sun, planets, carrier]) {
            assert_eq!(own, Link { name: own.name.clone(), ..solved });
        }
    }

    #[test]
    fn an_impossible_mass_is_refused() {
        let broken = PlanetaryDrive { planet_mass: Mass::from_si(f64::NAN), ..excavator() };
        let found = broken.motion_with_losses(
            Torque::from_si(1.0),
            Torque::from_si(1.0),
            eta(0.9),
            eta(0.9),
            Turning::Forward,
        );
        assert!(matches!(found, Err(Error::Impossible { what: Property::Mass, .. })));
    }

    prop_compose! {
        fn any_drive()(
            sun in 6..120_u32, planet in 6..120_u32, planets in 2..8_u32,
            j1 in 1e-4..2.0, j2 in 1e-4..2.0, jh in 1e-4..9.0, m in 0.01..60.0, r in 0.01..0.9,
        ) -> PlanetaryDrive {
            PlanetaryDrive {
                set: GearSet::new(teeth(sun, planet, planets)).unwrap(),
                sun_inertia: MomentOfInertia::from_si(j1),
                planet_inertia: MomentOfInertia::from_si(j2),
                planet_mass: Mass::from_si(m),
                planet_radius: Length::from_si(r),
                carrier_inertia: MomentOfInertia::from_si(jh),
            }
        }
    }

    proptest! {
        #[test]
        fn speed_ratios_follow_from_the_teeth(drive in any_drive()) {
            let (z1, z2, z3) = drive.tooth_numbers();
            let ratios = drive.set.ratios();
            prop_assert!((ratios.carrier - z1 / (z1 + z3)).abs() < 1e-14);
            let planet = z1 * (z2 - z3) / (z2 * (z1 + z3));
            prop_assert!((ratios.planet - planet).abs() < 1e-13 * planet.abs().max(1.0));
        }

        #[test]
        fn energy_of_all_links_is_that_of_the_equivalent_inertia(drive in any_drive(), omega in -300.0..300.0) {
            let bodies = drive.bodies(AngularVelocity::from_si(omega)).unwrap();
            let summed = kinetic_energy(&bodies).si();
            let equivalent = 0.5 * drive.equivalent_inertia().unwrap().si() * omega * omega;
            prop_assert!((summed - equivalent).abs() <= 1e-12 * equivalent.max(1e-12));
        }

        #[test]
        fn without_losses_both_equations_of_motion_agree(
            drive in any_drive(), driving in -900.0..900.0, load in -9000.0..9000.0,
        ) {
            let (driving, load, ideal) = (Torque::from_si(driving), Torque::from_si(load), MeshEfficiency::IDEAL);
            let plain = drive.motion(driving, load).unwrap();
            for turning in [Turning::Forward, Turning::Backward] {
            let found = drive.motion_with_losses(driving, load, ideal, ideal, turning).unwrap();
            let j = drive.equivalent_inertia().unwrap().si();
            prop_assert!((found.inertia.si() - j).abs() <= 1e-12 * j);
            let scale = (driving.si().abs() + load.si().abs()) / j;
            prop_assert!((found.accelerations.sun - plain.sun).si().abs() <= 1e-12 * scale);
            }
        }

        /// Held is where both meshes can pass the torques with the friction that they have, and nowhere else:
        /// the ring's torque follows from the balance of the whole, and some torque on the planets must suit
        /// both meshes.
        #[test]
        fn held_is_what_the_friction_of_both_meshes_can_hold(
            drive in any_drive(), driving in -900.0..900.0_f64, part in 0.5..1.5, e12 in 0.6..1.0, e23 in 0.6..1.0,
        ) {
            let (z1, z2, z3) = drive.tooth_numbers();
            let load = driving * (1.0 + part * z3 / z1);
            let between = |driven: f64, eta: f64| {
                let ends = [driven * eta, driven / eta];
                [ends[0].min(ends[1]), ends[0].max(ends[1])]
            };
            // Torques on the planets that the sun's mesh can give, and that the ring's mesh can take.
            let given = between(driving * z2 / z1, e12);
            let taken = between((load - driving) * z2 / z3, e23);
            let holds = given[0] <= taken[1] && taken[0] <= given[1];
            let clear = (given[0] - taken[1]).abs().min((taken[0] - given[1]).abs()) > 1e-9 * driving.abs();
            let found = drive.from_rest(Torque::from_si(driving), Torque::from_si(load), eta(e12), eta(e23)).unwrap();
            if clear {
                prop_assert_eq!(matches!(found, FromRest::Held), holds);
            }
        }

        #[test]
        fn more_load_never_accelerates_more_and_nothing_jumps(
            drive in any_drive(), driving in -900.0..900.0, loads in proptest::array::uniform2(-9000.0..9000.0_f64),
            e12 in 0.6..1.0, e23 in 0.6..1.0,
        ) {
            let (e12, e23) = (eta(e12), eta(e23));
            let epsilon = |load: f64| match drive.from_rest(Torque::from_si(driving), Torque::from_si(load), e12, e23).unwrap() {
                FromRest::Held => 0.0,
                FromRest::Forward(motion) | FromRest::Backward(motion) => motion.accelerations.sun.si(),
            };
            let [less, more] = [loads[0].min(loads[1]), loads[0].max(loads[1])];
            prop_assert!(epsilon(less) >= epsilon(more) - 1e-12 * epsilon(less).abs());
            // At the edges: a millionth of the load beside them gives a millionth of what the whole would.
            let j = drive.equivalent_inertia().unwrap().si();
            let ratios = drive.set.ratios();
            let [least, greatest] = drive.held_loads(Torque::from_si(driving), e12, e23).map(Physical::si);
            for (edge, outwards) in [(least, -1.0), (greatest, 1.0)] {
                let beside = 1e-6 * edge.abs();
                // Friction makes the inertia felt smaller, by far less than a hundredfold.
                let most = 100.0 * beside * ratios.carrier / j;
                prop_assert!(epsilon(edge + outwards * beside).abs() <= most);
                prop_assert_eq!(epsilon(edge - outwards * 1e-3 * (greatest - least)), 0.0);
            }
        }

        /// Backward, driven by the load, by the closed form: efficiencies inverted in both meshes.
        #[test]
        fn backward_motion_has_the_losses_inverted(
            drive in any_drive(), driving in 0.0..900.0, more in 1.0..2.0, e12 in 0.8..1.0, e23 in 0.8..1.0,
        ) {
            let (z1, z2, z3) = drive.tooth_numbers();
            let (k, u_h) = (z3 / z1, z1 / (z1 + z3));
            let load = more * driving * (1.0 + k / (e12 * e23));
            let found = drive.motion_with_losses(Torque::from_si(driving), Torque::from_si(load), eta(e12), eta(e23), Turning::Backward);
            let found = found.unwrap();
            // While no mesh power changes its direction: T_1 = M_1 − J_1·ε stays above 0, and T_2 with it.
            let planets = f64::from(drive.set.teeth().planets);
            let u_2 = z1 * (z2 - z3) / (z2 * (z1 + z3));
            let orbit = planets * drive.planet_mass.si() * drive.planet_radius.si().powi(2);
            let through = 1.0 + k / (e12 * e23);
            let j = drive.sun_inertia.si()
                + (planets * drive.planet_inertia.si() * u_2 * (1.0 - z3 / z2 / e23)
                    + (orbit + drive.carrier_inertia.si()) * u_h) / through;
            let by_hand = (driving - load / through) / j;
            prop_assert!((found.accelerations.sun.si() - by_hand).abs() <= 1e-11 * (driving + load) / j);
        }

        #[test]
        fn powers_balance_with_losses(
            drive in any_drive(), driving in -900.0..900.0, load in -9000.0..9000.0,
            e12 in 0.8..1.0, e23 in 0.8..1.0, omega in 1.0..300.0_f64, backward: bool,
        ) {
            let (turning, omega) =
                if backward { (Turning::Backward, -omega) } else { (Turning::Forward, omega) };
            let (e12, e23) = (eta(e12), eta(e23));
            let found = drive.motion_with_losses(Torque::from_si(driving), Torque::from_si(load), e12, e23, turning).unwrap();
            let ratios = drive.set.ratios();
            let epsilon = found.accelerations.sun.si();
            let stored = drive.equivalent_inertia().unwrap().si() * epsilon * omega;
            let supplied = driving * omega - load * omega * ratios.carrier;
            let lost = drive.mesh_loss(&found, AngularVelocity::from_si(omega), e12, e23).si();
            prop_assert!(lost >= 0.0);
            let scale = (driving.abs() + load.abs()) * omega.abs();
            prop_assert!((supplied - stored - lost).abs() <= 1e-11 * scale, "{} {} {}", supplied, stored, lost);
        }
    }
}
