//! Forces on the bearings and the pin of a planet: from the meshes and from its mass.
//!
//! The planet pins transmit the carrier torque, so the tangential force follows from the statics of the
//! carrier alone, with or without losses:
//!
//! ```text
//! F_t = |T_H|/(n·r_w)
//! F_r = Σ ±|T_i|·tan α/(n·r_i)        + a sun pushes the planet outwards, − a ring inwards
//! F_c = m·r_w·ω_H²
//! F   = √(F_t² + (F_r + F_c)²)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `T_H`, `T_i` | torques on the carrier and on central gear `i` | N·m |
//! | `n` | planets, all carrying alike | 1 |
//! | `r_w`, `r_i` | radius of the planets' centres, pitch radius of gear `i` | mm |
//! | `α` | working pressure angle | deg |
//! | `m` | mass of a planet with what turns about its pin | kg |
//! | `ω_H` | speed of the carrier | rad/s |
//!
//! # With losses
//!
//! The tangential force of a mesh follows from the torques that it exchanges, friction of the teeth included:
//!
//! ```text
//! F = |T_1 + T_2|/(n·a)        T_1, T_2 torques on both gears from outside the mesh, a centre distance
//! ```
//!
//! This holds because the moments of one force about two axes differ by the force times their distance. The
//! forces of a planet's meshes then add to `F_t` exactly.
//!
//! Strength is calculated from the nominal tooth force `T_i/(n·r_i)`, which applies the whole torque at the
//! pitch circle. It leaves out the torque of friction on the planet. Its sum over both meshes exceeds `F_t`
//! by a part of the order of the loss.
//!
//! A planet with two meshes, as in a simple set, passes on the torque `T_g` that it receives. Both forces
//! then follow from the torques on the central gears and from the division of the loss between the meshes
//! ([`two_mesh_forces`]); `F_r` is calculated from these forces. If a planet has more meshes, the loss of
//! each does not follow from the torques on the central gears, and `F_r` above is calculated from the nominal
//! forces.
//!
//! In a simple set without losses both meshes press with the same force `F`: the tangential parts add to
//! `2·F`, and the radial ones cancel. Left out: weight, helix angle, unequal load sharing among the planets
//! (mesh load factor `K_γ` > 1), and in a stepped planet the couple of its two planes.

use epicyclic_units::Physical;
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Mass, Torque};

use crate::checks::{acute_angle, not_negative, positive, positive_length, positive_mass};
use crate::geometry::GearKind;
use crate::quantity::Counted;
use crate::{Error, Quantity};

/// A central gear as a planet feels it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Push {
    /// A sun is external and pushes outwards, a ring internal and pushes inwards.
    pub kind: GearKind,
    /// Pitch radius `r_i`.
    pub pitch_radius: Length,
    /// Torque on the gear, `T_i`.
    pub torque: Torque,
}

/// Tangential force on the bearings of each planet, `|T_H|/(n·r_w)`.
///
/// # Errors
/// [`Error::TooFew`] without planets, [`Error::NotPositive`] for the radius, [`Error::Negative`] for a torque
/// that is not finite.
///
/// # Example
/// ```
/// use epicyclic_gears::planet_bearing;
/// use uom::si::f64::{Length, Torque};
/// use uom::si::{force::newton, length::millimeter, torque::newton_meter};
///
/// let radius = Length::new::<millimeter>(60.0);
/// let force = planet_bearing::tangential_force(Torque::new::<newton_meter>(-540.0), 3, radius)?;
/// assert!((force.get::<newton>() - 3000.0).abs() < 1e-9);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn tangential_force(
    carrier_torque: Torque,
    planets: u32,
    carrier_radius: Length,
) -> Result<Force, Error> {
    let count = count(planets)?;
    let radius_m = positive_length(Quantity::CarrierRadius, carrier_radius)?;
    Ok(Force::from_si(size(Quantity::CarrierTorque, carrier_torque.si(), "N·m")? / (count * radius_m)))
}

/// Tangential force of a mesh at each of `planets` planets, friction of the teeth included:
/// `|T_1 + T_2|/(n·a)`.
///
/// The torques are those on the two gears from outside the mesh, of all planets together: of one direction in
/// an external mesh, of opposite directions in an internal one. That of a gear in mesh twice is what it hands
/// from one mesh to the other.
///
/// # Errors
/// [`Error::TooFew`] without planets, [`Error::NotPositive`] for the distance, [`Error::Negative`] for a
/// torque that is not finite.
///
/// # Example
/// ```
/// use epicyclic_gears::planet_bearing;
/// use uom::si::f64::{Length, Torque};
/// use uom::si::{force::newton, length::millimeter, torque::newton_meter};
///
/// // Pitch radii 20 and 40 mm: 100 N·m on the sun, 200 less 3 % arrive at the planets.
/// let n_m = Torque::new::<newton_meter>;
/// let force = planet_bearing::mesh_force(n_m(100.0), n_m(194.0), 4, Length::new::<millimeter>(60.0))?;
/// assert!((force.get::<newton>() - 1225.0).abs() < 1e-9); // nominal 1250 N
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn mesh_force(
    first: Torque,
    second: Torque,
    planets: u32,
    centre_distance: Length,
) -> Result<Force, Error> {
    let count = count(planets)?;
    let distance_m = positive_length(Quantity::CentreDistance, centre_distance)?;
    let sum_n_m = size(Quantity::MeshTorque, first.si() + second.si(), "N·m")?;
    Ok(Force::from_si(sum_n_m / (count * distance_m)))
}

/// Radial force of the meshes on a planet, outwards positive: `Σ ±|T_i|·tan α/(n·r_i)`.
///
/// # Errors
/// [`Error::TooFew`] without planets, [`Error::NotPositive`] for a radius, [`Error::Negative`] for a torque
/// that is not finite, [`Error::OutOfRange`] unless 0 < α < 90°.
pub fn radial_force(gears: &[Push], planets: u32, pressure_angle: Angle) -> Result<Force, Error> {
    let count = count(planets)?;
    acute_angle(Quantity::PressureAngle, pressure_angle)?;
    let mut meshes = Vec::with_capacity(gears.len());
    for gear in gears {
        let radius_m = positive_length(Quantity::PitchRadius, gear.pitch_radius)?;
        let torque_n_m = size(Quantity::CentralGearTorque, gear.torque.si(), "N·m")?;
        meshes.push((gear.kind, Force::from_si(torque_n_m / (count * radius_m)), pressure_angle));
    }
    radial_force_of(&meshes)
}

/// Tangential forces of the two meshes of each planet with central gears, friction of the teeth included.
///
/// ```text
/// ρ   = (|T_2|·r_g2/r_2)/(|T_1|·r_g1/r_1)        η_1·η_2 if power flows from gear 1 to gear 2, else inverse
/// T_g = |T_1|·(r_g1/r_1)·ρ^s                      torque that the planets take and hand on
/// F_1 = (|T_1| ± T_g)/(n·r_w)                     + external, − internal
/// F_2 = (|T_2| ± T_g)/(n·r_w)
/// ```
///
/// with `r_g = r_w − r` in an external mesh, `r − r_w` in an internal one, and `s` the first mesh's part of
/// the loss ([`share_of_loss`](crate::efficiency::MeshEfficiency::share_of_loss)). Where one of the torques
/// is 0, so is `T_g`.
///
/// # Errors
/// [`Error::TooFew`] without planets, [`Error::NotPositive`] for a radius, also that of a planet,
/// [`Error::Negative`] for a torque that is not finite.
///
/// # Example
/// ```
/// use epicyclic_gears::geometry::GearKind;
/// use epicyclic_gears::planet_bearing::{Push, two_mesh_forces};
/// use uom::si::f64::{Length, Torque};
/// use uom::si::{force::newton, length::millimeter, torque::newton_meter};
///
/// // Sun 40 mm, planets 80 mm, ring 200 mm; 3 % lost on the way to the planets, 2 % on the way to the ring.
/// let (mm, n_m) = (Length::new::<millimeter>, Torque::new::<newton_meter>);
/// let sun = Push { kind: GearKind::External, pitch_radius: mm(40.0), torque: n_m(100.0) };
/// let ring = Push { kind: GearKind::Internal, pitch_radius: mm(200.0), torque: n_m(475.3) };
/// let share = 0.97_f64.ln() / (0.97_f64 * 0.98).ln();
/// let [of_sun, of_ring] = two_mesh_forces(&[sun, ring], share, 4, mm(120.0))?;
/// assert!((of_sun.get::<newton>() - (100.0 + 194.0) / 0.48).abs() < 1e-9);
/// assert!((of_ring.get::<newton>() - (475.3 - 194.0) / 0.48).abs() < 1e-9);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn two_mesh_forces(
    gears: &[Push; 2],
    share: f64,
    planets: u32,
    carrier_radius: Length,
) -> Result<[Force; 2], Error> {
    let count = count(planets)?;
    let radius_m = positive_length(Quantity::CarrierRadius, carrier_radius)?;
    let mut torques_n_m = [0.0; 2];
    let mut levers = [0.0; 2];
    for ((gear, torque_n_m), lever) in gears.iter().zip(&mut torques_n_m).zip(&mut levers) {
        let gear_m = positive_length(Quantity::PitchRadius, gear.pitch_radius)?;
        let planet_m = match gear.kind {
            GearKind::External => radius_m - gear_m,
            GearKind::Internal => gear_m - radius_m,
        };
        *lever = positive(Quantity::PitchRadius, planet_m * 1e3, "mm")? * 1e-3 / gear_m;
        *torque_n_m = size(Quantity::CentralGearTorque, gear.torque.si(), "N·m")?;
    }
    let [first, second] = [0, 1].map(|mesh| torques_n_m[mesh] * levers[mesh]);
    let planet_n_m = if first > 0.0 && second > 0.0 { first * libm::pow(second / first, share) } else { 0.0 };
    let of_mesh = |mesh: usize| {
        let planet_n_m = match gears[mesh].kind {
            GearKind::External => planet_n_m,
            GearKind::Internal => -planet_n_m,
        };
        Force::from_si((torques_n_m[mesh] + planet_n_m).abs() / (count * radius_m))
    };
    Ok([of_mesh(0), of_mesh(1)])
}

/// Radial force of meshes of these tangential forces and working pressure angles on a planet, outwards
/// positive: `Σ ±F·tan α`.
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 < α < 90°.
pub fn radial_force_of(meshes: &[(GearKind, Force, Angle)]) -> Result<Force, Error> {
    let mut outwards_n = 0.0;
    for &(kind, mesh, angle) in meshes {
        let apart_n = mesh.si() * libm::tan(acute_angle(Quantity::PressureAngle, angle)?);
        outwards_n += match kind {
            GearKind::External => apart_n,
            GearKind::Internal => -apart_n,
        };
    }
    Ok(Force::from_si(outwards_n))
}

/// Force that keeps a planet on its circle, `m·r_w·ω_H²`; its bearing feels it outwards.
///
/// # Errors
/// [`Error::NotPositive`] for mass or radius, [`Error::Negative`] for a speed that is not finite.
///
/// # Example
/// ```
/// use epicyclic_gears::planet_bearing;
/// use uom::si::angular_velocity::radian_per_second;
/// use uom::si::f64::{AngularVelocity, Length, Mass};
/// use uom::si::{force::newton, length::millimeter, mass::kilogram};
///
/// let (mass, radius) = (Mass::new::<kilogram>(0.5), Length::new::<millimeter>(60.0));
/// let force =
///     planet_bearing::centrifugal_force(mass, radius, AngularVelocity::new::<radian_per_second>(100.0))?;
/// assert!((force.get::<newton>() - 300.0).abs() < 1e-9);
/// # Ok::<(), epicyclic_gears::Error>(())
/// ```
pub fn centrifugal_force(
    planet_mass: Mass,
    carrier_radius: Length,
    carrier_speed: AngularVelocity,
) -> Result<Force, Error> {
    let mass_kg = positive_mass(planet_mass)?;
    let radius_m = positive_length(Quantity::CarrierRadius, carrier_radius)?;
    let omega_rad_s = size(Quantity::CarrierSpeed, carrier_speed.si(), "rad/s")?;
    Ok(Force::from_si(mass_kg * radius_m * omega_rad_s.powi(2)))
}

/// Load of the bearing: the resultant of the tangential force and the sum of the radial forces.
#[must_use]
pub fn resultant(tangential: Force, radial: Force) -> Force {
    Force::from_si(libm::hypot(tangential.si(), radial.si()))
}

fn count(planets: u32) -> Result<f64, Error> {
    if planets == 0 {
        return Err(Error::TooFew { what: Counted::Planets, count: 0, at_least: 1 });
    }
    Ok(f64::from(planets))
}

fn size(quantity: Quantity, value: f64, unit: &'static str) -> Result<f64, Error> {
    not_negative(quantity, value.abs(), unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::efficiency::{MeshEfficiency, torques};
    use crate::simple_set::{BasicRatio, Member, Mode};

    fn mm(value: f64) -> Length {
        Length::from_mm(value)
    }

    /// The force on the planet bearings from the two meshes and their geometry, as vectors, without statics
    /// of the carrier.
    #[test]
    fn the_carrier_and_the_two_meshes_tell_one_force() {
        let (k, radius_mm, planets) = (3.0, 60.0, 3);
        let sun_mm = 2.0 * radius_mm / (k + 1.0);
        let set = BasicRatio::new(-k).unwrap();
        let mode = Mode::new(Member::Sun, Member::Carrier).unwrap();
        let found = torques(set, MeshEfficiency::IDEAL, mode, Torque::from_si(100.0)).unwrap();
        let (sun, ring, carrier) = (found.sun, found.ring, found.carrier);
        // 2·F with F = T_a/(n·r_a).
        let of_mesh = 100.0 / (3.0 * sun_mm * 1e-3);
        let tangential = tangential_force(carrier, planets, mm(radius_mm)).unwrap().si();
        assert!((tangential / (2.0 * of_mesh) - 1.0).abs() < 1e-12);
        let gears = [
            Push { kind: GearKind::External, pitch_radius: mm(sun_mm), torque: sun },
            Push { kind: GearKind::Internal, pitch_radius: mm(k * sun_mm), torque: ring },
        ];
        let radial = radial_force(&gears, planets, Angle::from_degrees(20.0)).unwrap().si();
        assert!(radial.abs() < 1e-9 * of_mesh, "{radial}");
        let alone = radial_force(&gears[..1], planets, Angle::from_degrees(45.0)).unwrap().si();
        assert!((alone / of_mesh - 1.0).abs() < 1e-12);
        assert_eq!(resultant(Force::from_si(3.0), Force::from_si(-4.0)).si(), 5.0);
    }

    /// Forward and backward, the planet's torque is what the loss of each mesh leaves of the other side's.
    #[test]
    fn both_meshes_of_a_planet_know_the_torque_that_it_hands_on() {
        let [of_sun, of_ring] = [0.97, 0.98].map(|eta| MeshEfficiency::new(eta).unwrap());
        let share = MeshEfficiency::share_of_loss(of_sun, of_ring);
        let push = |kind, radius, torque_n_m| Push {
            kind,
            pitch_radius: mm(radius),
            torque: Torque::from_si(torque_n_m),
        };
        for (ring_n_m, planet_n_m) in [(475.3, 194.0), (500.0 / 0.9506, 200.0 / 0.97), (500.0, 200.0)] {
            let gears = [push(GearKind::External, 40.0, 100.0), push(GearKind::Internal, 200.0, ring_n_m)];
            let found = two_mesh_forces(&gears, share, 4, mm(120.0)).unwrap().map(Physical::si);
            let by_hand = [100.0 + planet_n_m, ring_n_m - planet_n_m].map(|sum| sum / 0.48);
            for (found, by_hand) in found.into_iter().zip(by_hand) {
                assert!((found / by_hand - 1.0).abs() < 1e-12, "{found} {by_hand}");
            }
            let [first, second] = gears;
            let turned = two_mesh_forces(&[second, first], 1.0 - share, 4, mm(120.0)).unwrap();
            assert!((turned[0].si() / found[1] - 1.0).abs() < 1e-12);
        }
        assert_eq!(MeshEfficiency::share_of_loss(MeshEfficiency::IDEAL, MeshEfficiency::IDEAL), 0.5);
        let beyond = push(GearKind::External, 130.0, 1.0);
        let refused = two_mesh_forces(&[beyond, beyond], 0.5, 4, mm(120.0)).unwrap_err();
        assert!(matches!(refused, Error::NotPositive { quantity: Quantity::PitchRadius, .. }));
    }

    #[test]
    fn refusals_name_value_and_bounds() {
        let refused = tangential_force(Torque::from_si(1.0), 0, mm(1.0)).unwrap_err();
        assert_eq!(refused.to_string(), "0 planets: at least 1 needed");
        let refused = tangential_force(Torque::from_si(f64::NAN), 3, mm(1.0)).unwrap_err();
        assert!(matches!(refused, Error::Negative { quantity: Quantity::CarrierTorque, .. }));
        let refused = tangential_force(Torque::from_si(1.0), 3, mm(0.0)).unwrap_err();
        assert!(matches!(refused, Error::NotPositive { .. }));
        let refused =
            centrifugal_force(Mass::from_si(-1.0), mm(1.0), AngularVelocity::from_si(1.0)).unwrap_err();
        assert!(matches!(refused, Error::NotPositive { quantity: Quantity::Mass, .. }));
        let refused = radial_force(&[], 3, Angle::from_degrees(90.0)).unwrap_err();
        assert!(matches!(refused, Error::OutOfRange { quantity: Quantity::PressureAngle, .. }));
    }
}
