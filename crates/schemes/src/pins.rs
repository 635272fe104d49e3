//! Forces on the bearings and pins of the planets of a gear: what is known of a row's size, and what follows from it.
//!
//! The forces themselves are those of [`epicyclic_gears::pin`]. They need the number of planets and the radius of
//! their centres; the radial part of the meshes needs the pitch radii besides, the centrifugal part a planet's mass.
//! What is missing is named, and the rest computed.
//!
//! ```text
//! simple row        r_w = m·(z_a + z_g)/2 or m·(z_a + z_b)/4    r_a = 2·r_w/(1 + k)    r_b = k·r_a
//! stepped planets   r_w = m·(z_1 ± z_g)/2    r_1 = r_w·z_1/(z_1 ± z_g)    r_2 = r_w·z_2/(z_2 ± z_f)
//! ```
//!
//! `+` at a sun, `−` at a ring; `m` is the module of the mesh with wheel 1. A radius that is given goes before the
//! one of module and teeth: shifted profiles move the planets.
//!
//! Left out: rows with two planets in mesh, whose forces hang on where these stand around each other; a planet that
//! two rows share; bevel planets.

use crate::Gearbox;
use crate::planet_set::PlanetSet;
use crate::set::{Gearing, SetKind, SetSpec};
use crate::units::{degrees, in_metres, kg_per_m3, kilograms, metres, rad_per_s};
use epicyclic_gears::geometry::{Toothing, Wheel};
use epicyclic_gears::life::{self, Rolling};
use epicyclic_gears::mass::{self, WheelBody};
use epicyclic_gears::pin::{self, Push};
use epicyclic_gears::{Error, ToothCount};
use std::fmt;
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Mass, MassDensity, Time, Torque};

/// What is known of the size of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetSize {
    /// Module of the mesh with wheel 1.
    pub module: Option<Length>,
    /// Radius `r_w` of the planets' centres; goes before that of module and teeth.
    pub carrier_radius: Option<Length>,
    /// Face width of a planet.
    pub face_width: Option<Length>,
    /// Bore of a planet; a solid planet where it is left out.
    pub planet_bore: Option<Length>,
    /// Mass of a planet with what turns about its pin; goes before that of its shape.
    pub planet_mass: Option<Mass>,
    /// Dynamic load rating of the bearings of one planet together, and what rolls in them.
    pub bearing: Option<(Force, Rolling)>,
    /// Density of the planets.
    pub density: MassDensity,
    /// Working pressure angle.
    pub pressure_angle: Angle,
}

impl Default for SetSize {
    /// Nothing but steel of 7850 kg/m³ and 20°.
    fn default() -> Self {
        Self {
            module: None,
            carrier_radius: None,
            face_width: None,
            planet_bore: None,
            planet_mass: None,
            bearing: None,
            density: kg_per_m3(7850.0),
            pressure_angle: degrees(20.0),
        }
    }
}

/// What is missing for a force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Lack {
    /// The number of planets.
    Planets,
    /// The radius of their centres.
    Radius,
    /// The teeth of a stepped row, for the pitch radii.
    Teeth,
    /// The mass of a planet.
    Mass,
    /// Rows of this kind are left out.
    Kind(SetKind),
    /// The planet is another row's too.
    SharedPlanet,
}

impl fmt::Display for Lack {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Planets => f.write_str("the number of planets is missing"),
            Self::Radius => {
                f.write_str("the module with the teeth, or the radius of the planets' centres, is missing")
            }
            Self::Teeth => f.write_str("the teeth are missing, and with them the radial force of the meshes"),
            Self::Mass => {
                f.write_str("the mass of a planet, or its face width, is missing for the centrifugal force")
            }
            Self::Kind(kind) => write!(f, "forces on planets are not computed for the kind {kind}"),
            Self::SharedPlanet => f.write_str("forces on a planet that two rows share are not computed"),
        }
    }
}

/// A planet on its pin, as far as it is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Pin {
    /// How many planets share the load, all alike.
    pub planets: Option<u32>,
    /// Radius `r_w` of their centres.
    pub radius: Option<Length>,
    /// The two central wheels: toothing and pitch radius.
    pub wheels: Option<[(Toothing, Length); 2]>,
    /// Mass of one planet.
    pub mass: Option<Mass>,
    /// Dynamic load rating of its bearings together, and what rolls in them.
    pub bearing: Option<(Force, Rolling)>,
    /// Working pressure angle.
    pub pressure_angle: Angle,
    /// What is missing.
    pub lacks: Vec<Lack>,
}

/// Forces on the bearing of each planet, as far as they follow.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PinForces {
    /// Tangential, of the meshes.
    pub tangential: Option<Force>,
    /// Radial, of the meshes, outwards positive.
    pub radial: Option<Force>,
    /// Centrifugal.
    pub centrifugal: Option<Force>,
    /// All together; `None` unless each is known.
    pub total: Option<Force>,
}

impl Gearbox {
    /// The planets of a row on their pins; `None` of a pair, which has none, and of a row that does not exist.
    ///
    /// # Errors
    /// [`Error::NotPositive`] and the like for a size that is none.
    #[must_use]
    pub fn pin(&self, row: usize, size: &SetSize) -> Option<Result<Pin, Error>> {
        let own = self.sets.get(row).filter(|set| !set.is_pair())?;
        Some(own.pin(size))
    }
}

impl PlanetSet {
    fn pin(&self, size: &SetSize) -> Result<Pin, Error> {
        size.check()?;
        let mut pin = Pin {
            planets: self.planet_count(),
            radius: None,
            wheels: None,
            mass: None,
            bearing: size.bearing,
            pressure_angle: size.pressure_angle,
            lacks: vec![],
        };
        let Some(spec) = self.short() else {
            pin.lacks.push(Lack::SharedPlanet);
            return Ok(pin);
        };
        let toothings = match spec.kind {
            SetKind::Simple | SetKind::SteppedSunRing => [Toothing::External, Toothing::Internal],
            SetKind::SteppedSuns => [Toothing::External; 2],
            SetKind::SteppedRings => [Toothing::Internal; 2],
            kind => {
                pin.lacks.push(Lack::Kind(kind));
                return Ok(pin);
            }
        };
        pin.radius = size.carrier_radius.or_else(|| spec.radius_of_teeth(size.module?, toothings[0]));
        pin.wheels = pin.radius.and_then(|radius| {
            let [first, second] = spec.pitch_radii(self.basic_ratio().get(), radius, toothings)?;
            Some([(toothings[0], first), (toothings[1], second)])
        });
        pin.mass = spec.planet_mass(self.basic_ratio().get(), size, pin.radius)?;
        let lacks = [
            (pin.planets.is_none(), Lack::Planets),
            (pin.radius.is_none(), Lack::Radius),
            (pin.radius.is_some() && pin.wheels.is_none(), Lack::Teeth),
            (pin.mass.is_none(), Lack::Mass),
        ];
        pin.lacks.extend(lacks.into_iter().filter(|(missing, _)| *missing).map(|(_, lack)| lack));
        Ok(pin)
    }
}

impl SetSpec {
    fn central_teeth(&self) -> Option<[f64; 2]> {
        match self.gearing {
            Gearing::Teeth(first, second) => Some([first.as_f64(), second.as_f64()]),
            Gearing::Parameter(_) => None,
        }
    }

    fn radius_of_teeth(&self, module: Length, toothing: Toothing) -> Option<Length> {
        let [first, second] = self.central_teeth()?;
        let in_modules = match self.planet {
            Some(planet) => between(first, planet.as_f64(), toothing) / 2.0,
            None if self.kind == SetKind::Simple => (first + second) / 4.0,
            None => return None,
        };
        (in_modules > 0.0).then(|| module * in_modules)
    }

    fn pitch_radii(&self, i0: f64, radius: Length, toothings: [Toothing; 2]) -> Option<[Length; 2]> {
        if self.kind == SetKind::Simple {
            let k = -i0;
            let sun = radius * (2.0 / (1.0 + k));
            return Some([sun, sun * k]);
        }
        let central = self.central_teeth()?;
        let planets = [self.planet?.as_f64(), self.second_planet?.as_f64()];
        let of_wheel = |place: usize| {
            let apart = between(central[place], planets[place], toothings[place]);
            (apart > 0.0).then(|| radius * (central[place] / apart))
        };
        Some([of_wheel(0)?, of_wheel(1)?])
    }

    /// A stepped planet has two widths, so its mass is only ever given.
    fn planet_mass(&self, i0: f64, size: &SetSize, radius: Option<Length>) -> Result<Option<Mass>, Error> {
        if size.planet_mass.is_some() {
            return Ok(size.planet_mass);
        }
        let (Some(width), SetKind::Simple) = (size.face_width, self.kind) else { return Ok(None) };
        let bore = size.planet_bore.unwrap_or(metres(0.0));
        if let (Some(module), Some(teeth)) = (size.module, self.coaxial_planet()) {
            let body = WheelBody::external(&Wheel::external(module, teeth)?, width, bore, size.density)?;
            return Ok(Some(body.total().mass));
        }
        let Some(radius) = radius else { return Ok(None) };
        let k = -i0;
        let pitch_diameter = radius * (2.0 * (k - 1.0) / (k + 1.0));
        mass::ring(pitch_diameter, bore, width, size.density).map(|disc| Some(disc.mass))
    }

    /// The planet's teeth, given or by coaxiality.
    fn coaxial_planet(&self) -> Option<ToothCount> {
        let Gearing::Teeth(sun, ring) = self.gearing else { return None };
        let between = ring.get().saturating_sub(sun.get());
        self.planet.or_else(|| ToothCount::new(between / 2).ok().filter(|_| between.is_multiple_of(2)))
    }
}

/// Teeth of a wheel and its planet together, at a ring less the planet's.
fn between(wheel: f64, planet: f64, toothing: Toothing) -> f64 {
    match toothing {
        Toothing::External => wheel + planet,
        Toothing::Internal => wheel - planet,
    }
}

impl SetSize {
    fn check(&self) -> Result<(), Error> {
        let lengths = [
            ("module", self.module),
            ("radius of the planets' centres", self.carrier_radius),
            ("face width", self.face_width),
            ("bore of a planet", self.planet_bore),
        ];
        for (quantity, length) in lengths {
            if let Some(value_m) = length.map(in_metres)
                && !(value_m > 0.0 && value_m.is_finite())
            {
                return Err(Error::NotPositive { quantity, value: value_m * 1e3, unit: "mm" });
            }
        }
        if let Some(value) = self.planet_mass.map(kilograms)
            && !(value > 0.0 && value.is_finite())
        {
            return Err(Error::NotPositive { quantity: "mass of a planet", value, unit: "kg" });
        }
        if let Some((capacity, _)) = self.bearing {
            // The capacity's own limits.
            life::basic_rating_life(Rolling::Balls, capacity, capacity, AngularVelocity::default())?;
        }
        // The angle's own limits.
        pin::radial_force(&[], 1, self.pressure_angle)?;
        Ok(())
    }
}

impl Pin {
    /// The forces of these torques on sun, ring and carrier, at this speed of the carrier.
    ///
    /// # Errors
    /// Those of [`epicyclic_gears::pin`].
    pub fn forces(
        &self,
        torques: Option<[Torque; 3]>,
        carrier_speed: Option<AngularVelocity>,
    ) -> Result<PinForces, Error> {
        let mut forces = PinForces::default();
        let Some(radius) = self.radius else { return Ok(forces) };
        if let (Some(planets), Some([first, second, carrier])) = (self.planets, torques) {
            forces.tangential = Some(pin::tangential_force(carrier, planets, radius)?);
            if let Some([one, other]) = self.wheels {
                let push = |(toothing, pitch_radius), torque| Push { toothing, pitch_radius, torque };
                let wheels = [push(one, first), push(other, second)];
                forces.radial = Some(pin::radial_force(&wheels, planets, self.pressure_angle)?);
            }
        }
        forces.centrifugal = match (self.mass, carrier_speed) {
            (_, Some(speed)) if rad_per_s(speed) == 0.0 => Some(Force::default()),
            (Some(mass), Some(speed)) => Some(pin::centrifugal_force(mass, radius, speed)?),
            _ => None,
        };
        forces.total = forces
            .tangential
            .zip(forces.radial.zip(forces.centrifugal))
            .map(|(tangential, (radial, centrifugal))| pin::resultant(tangential, radial + centrifugal));
        Ok(forces)
    }

    /// Basic rating life of the bearings under this force, at this speed of the planet on its carrier.
    ///
    /// # Errors
    /// Those of [`basic_rating_life`](life::basic_rating_life).
    pub fn life(&self, force: Force, planet_on_carrier: AngularVelocity) -> Result<Option<Time>, Error> {
        let Some((capacity, rolling)) = self.bearing else { return Ok(None) };
        life::basic_rating_life(rolling, capacity, force, planet_on_carrier)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::set::{MeshLoss, SetSpec};
    use crate::units::{angular_velocity, torque};
    use epicyclic_gears::efficiency::MeshEfficiency;
    use uom::si::{force::newton, length::millimeter, mass::kilogram};

    fn mm(value: f64) -> Length {
        Length::new::<millimeter>(value)
    }

    fn gearbox(row: SetSpec) -> Gearbox {
        Gearbox::builder("one row")
            .links(["a", "b", "H"])
            .set(row)
            .brake("K", "b")
            .input("a")
            .output("H")
            .gear("1", ["K"])
            .build()
            .unwrap()
    }

    fn teeth(count: u32) -> ToothCount {
        ToothCount::new(count).unwrap()
    }

    /// Sun 20, planet 20, ring 60, module 3 mm: r_w = 60 mm, r_a = 30 mm, r_b = 90 mm; 100 N·m on the sun.
    #[test]
    fn a_simple_row_by_hand() {
        let row = SetSpec::teeth("P", SetKind::Simple, ["a", "b", "H"], 20, 60).unwrap().planet_count(3);
        let gearbox = gearbox(row);
        let size = SetSize {
            module: Some(mm(3.0)),
            planet_mass: Some(Mass::new::<kilogram>(0.5)),
            ..SetSize::default()
        };
        let pin = gearbox.pin(0, &size).unwrap().unwrap();
        assert_eq!(pin.lacks, []);
        assert!((in_metres(pin.radius.unwrap()) - 0.06).abs() < 1e-15);
        let forces =
            pin.forces(Some([100.0, 300.0, -400.0].map(torque)), Some(angular_velocity(100.0))).unwrap();
        let newtons = |force: Option<Force>| force.unwrap().get::<newton>();
        // 400/(3·0.06) = 2·100/(3·0.03); 0.5·0.06·100².
        assert!((newtons(forces.tangential) - 20_000.0 / 9.0).abs() < 1e-9);
        assert!(newtons(forces.radial).abs() < 1e-9);
        assert!((newtons(forces.centrifugal) - 300.0).abs() < 1e-9);
        assert!((newtons(forces.total) - (20_000.0_f64 / 9.0).hypot(300.0)).abs() < 1e-9);
    }

    #[test]
    fn without_a_size_the_lacks_are_named() {
        let gearbox = gearbox(SetSpec::simple("P", ["a", "b", "H"], 3.0));
        let pin = gearbox.pin(0, &SetSize::default()).unwrap().unwrap();
        assert_eq!(pin.lacks, [Lack::Planets, Lack::Radius, Lack::Mass]);
        assert_eq!(pin.forces(Some([torque(1.0); 3]), None).unwrap(), PinForces::default());
        let refused = gearbox.pin(0, &SetSize { module: Some(mm(-1.0)), ..SetSize::default() }).unwrap();
        assert_eq!(refused.unwrap_err().to_string(), "module is -1 mm; it must be finite and above 0");
        let double = SetSpec::teeth("P", SetKind::DoublePlanet, ["a", "b", "H"], 20, 60).unwrap();
        let pin = self::gearbox(double).pin(0, &SetSize::default()).unwrap().unwrap();
        assert_eq!(pin.lacks, [Lack::Kind(SetKind::DoublePlanet)]);
    }

    #[test]
    fn teeth_and_parameter_give_the_same_planet() {
        let by_k = gearbox(SetSpec::simple("P", ["a", "b", "H"], 3.0).planet_count(3));
        let by_teeth =
            gearbox(SetSpec::teeth("P", SetKind::Simple, ["a", "b", "H"], 20, 60).unwrap().planet_count(3));
        let width = Some(mm(30.0));
        let size = SetSize { carrier_radius: Some(mm(60.0)), face_width: width, ..SetSize::default() };
        let one = by_k.pin(0, &size).unwrap().unwrap();
        let size = SetSize { module: Some(mm(3.0)), face_width: width, ..SetSize::default() };
        let other = by_teeth.pin(0, &size).unwrap().unwrap();
        assert_eq!(one.wheels, other.wheels);
        // A disc of the pitch diameter against a body to the root and half a tooth zone: within an eighth.
        let ratio = (one.mass.unwrap() / other.mass.unwrap()).value;
        assert!((ratio - 1.0).abs() < 0.125, "{ratio}");
    }

    /// The tangential force is that of the meshes too: F_1·r_1 and F_2·r_2 make up T_H, for each kind.
    #[test]
    fn stepped_planets_turn_about_the_axis_as_the_meshes_push_them() {
        for (kind, [z1, z2], [g, f]) in [
            (SetKind::SteppedSunRing, [20, 80], [40, 20]),
            (SetKind::SteppedSuns, [20, 30], [40, 30]),
            (SetKind::SteppedRings, [100, 90], [40, 30]),
        ] {
            let row = SetSpec::teeth("P", kind, ["a", "b", "H"], z1, z2).unwrap();
            let row = row.planet_teeth(teeth(g), Some(teeth(f))).planet_count(4);
            let gearbox = gearbox(row);
            let ideal = gearbox.analyze("1").unwrap().ideal().unwrap().members[0].clone().unwrap();
            let size = SetSize { module: Some(mm(2.0)), ..SetSize::default() };
            let pin = gearbox.pin(0, &size).unwrap().unwrap();
            assert_eq!(pin.lacks, [Lack::Mass], "{kind}");
            let [(_, r1), (_, r2)] = pin.wheels.unwrap();
            let radius = in_metres(pin.radius.unwrap());
            // No moment about the planet's own axis: the forces stand as the inverse steps.
            let (f1, f2) = (ideal[0] / (4.0 * in_metres(r1)), ideal[1] / (4.0 * in_metres(r2)));
            let force = pin
                .forces(Some(<[f64; 3]>::try_from(ideal.clone()).unwrap().map(torque)), None)
                .unwrap()
                .tangential
                .unwrap();
            assert!((force.get::<newton>() - (f1 + f2).abs()).abs() < 1e-9 * f1.abs(), "{kind}");
            assert!((f1 + f2 + ideal[2] / (4.0 * radius)).abs() < 1e-9 * f1.abs(), "{kind}");
        }
    }

    #[test]
    fn losses_leave_a_little_of_the_radial_forces() {
        let eta = MeshEfficiency::new(0.97).unwrap();
        let row = SetSpec::simple("P", ["a", "b", "H"], 3.0).with_loss(MeshLoss::Row(eta)).planet_count(3);
        let gearbox = gearbox(row);
        let members = gearbox.analyze("1").unwrap().driving().unwrap().members[0].clone().unwrap();
        let size = SetSize { carrier_radius: Some(mm(60.0)), ..SetSize::default() };
        let pin = gearbox.pin(0, &size).unwrap().unwrap();
        let forces = pin.forces(Some(<[f64; 3]>::try_from(members).unwrap().map(torque)), None).unwrap();
        let share = forces.radial.unwrap() / forces.tangential.unwrap();
        // F_a − F_b = 0.03·F_a of F_a + F_b.
        assert!((share.value - 20_f64.to_radians().tan() * 0.03 / 1.97).abs() < 1e-3, "{}", share.value);
    }
}
