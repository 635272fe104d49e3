//! Results of the design of a drive.

use super::part::Shaft;
use super::spec::{KnownPart, KnownParts};
use super::warning::Warning;
use crate::planetary::Accelerations;
use epicyclic_gears::bearing::Bearing;
use epicyclic_gears::carrier::Carrier;
use epicyclic_gears::geometry;
use epicyclic_gears::mass::GearBody;
use epicyclic_gears::simple_set::Fraction;
use epicyclic_gears::spacing::PlanetSpacing;
use epicyclic_gears::synthesis::ToothNumbers;
use epicyclic_units::Physical;
use uom::si::f64::{
    AngularVelocity, Energy, Force, Length, Mass, MomentOfInertia, Power, Pressure, Time, Torque,
};

/// A drive, calculated.
#[derive(Debug, Clone, PartialEq)]
pub struct DriveDesign {
    /// Tooth numbers and planets.
    pub teeth: TeethDesign,
    /// Efficiencies.
    pub efficiency: Efficiency,
    /// Speeds.
    pub speeds: Speeds,
    /// Torques at the nominal power.
    pub torques: Torques,
    /// Powers.
    pub powers: Powers,
    /// Sun, planets and ring.
    pub gear_set: GearSetGeometry,
    /// Forces at the nominal power.
    pub forces: Forces,
    /// Shafts and bearings.
    pub shafts: Shafts,
    /// Masses and inertias of the parts.
    pub masses: Masses,
    /// The inertia of all links referred to the sun's shaft.
    pub equivalent_inertia: EquivalentInertia,
    /// Equivalent inertia by the shapes alone; `None` if no mass or inertia of a part is known.
    pub inertia_of_shapes: Option<EquivalentInertia>,
    /// Torque on the sun while the drive starts, `M_1`.
    pub driving_torque: Torque,
    /// Torque on the carrier against it, `M_H`.
    pub load: Torque,
    /// The start, losses left out of the load referred to the sun's shaft, as in the source.
    pub without_losses: Motion,
    /// The start with the losses of the meshes.
    pub with_losses: Motion,
    /// Findings that need to be checked.
    pub warnings: Vec<Warning>,
}

/// The tooth numbers and how well they meet their conditions.
#[derive(Debug, Clone, PartialEq)]
pub struct TeethDesign {
    /// Tooth numbers and number of planets.
    pub numbers: ToothNumbers,
    /// Ratio `U = ω_1/ω_H = 1 + z_3/z_1`.
    pub ratio: f64,
    /// Ratio as a fraction.
    pub exact_ratio: Fraction,
    /// Relative error of the ratio.
    pub ratio_error: f64,
    /// Positions of the planets.
    pub spacing: PlanetSpacing,
    /// Limit of the number of planets by the clearance between them,
    /// `180°/arcsin((z_2 + 2·h_a*)/(z_1 + z_2))`: fewer planets clear each other. `None` where two already
    /// touch.
    pub clearance_limit: Option<f64>,
    /// The most equally spaced planets that clear each other.
    pub most_planets: u32,
    /// Gap between the tip circles of the two planets nearest to each other; negative where they overlap.
    pub tip_gap: Length,
}

/// Efficiencies by the losses of the meshes alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Efficiency {
    /// Efficiency of the gear set with the carrier fixed, `η_0 = η_12·η_23`.
    pub basic: f64,
    /// Efficiency of the drive, `η = (1 + k·η_0)/(1 + k)`.
    pub overall: f64,
}

/// Speeds, positive in the direction of the sun.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Speeds {
    /// Sun, `ω_1`.
    pub sun: AngularVelocity,
    /// Planet speed, `ω_2`.
    pub planet: AngularVelocity,
    /// Planet speed relative to the carrier, `ω_2 − ω_H`.
    pub planet_relative: AngularVelocity,
    /// Carrier, `ω_H`.
    pub carrier: AngularVelocity,
}

/// Torques at the nominal power.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torques {
    /// Torque on the sun, `T_1 = N_1/ω_1`.
    pub sun: Torque,
    /// Torque on all planets together about their own axes, `T_2 = T_1·η_12·z_2/z_1`. It is passed on to the
    /// ring and does not reach the planet pins.
    pub planets: Torque,
    /// Torque that the carrier delivers, `T_H = T_1·U·η`.
    pub carrier: Torque,
    /// Torque of the housing on the ring, `T_H − T_1`.
    pub ring_reaction: Torque,
}

/// Powers at the nominal speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Powers {
    /// Power into the sun, `N_1`.
    pub input: Power,
    /// Rolling power, relative to the carrier: `T_1·(ω_1 − ω_H)`. What they lose is lost of this.
    pub mesh: Power,
    /// Lost in the meshes and in the bearings of the planets.
    pub lost: Power,
    /// On the shafts of the planets as the source counts, see [`planet_power`](crate::loads::planet_power).
    pub planets: Power,
    /// Out of the carrier, `N_H = T_H·ω_H`.
    pub output: Power,
}

/// Sun, planets and ring with centre distance and face width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearSetGeometry {
    /// The sun.
    pub sun: geometry::ToothedGear,
    /// A planet.
    pub planet: geometry::ToothedGear,
    /// The ring.
    pub ring: geometry::ToothedGear,
    /// Centre distance `a_w`, the radius of the planets' orbit.
    pub centre_distance: Length,
    /// Face width `b`.
    pub face_width: Length,
}

/// Forces at the nominal power, mesh load factor `K_γ` = 1.
///
/// The forces are consistent: those of both meshes add to that of the planet bearings. They include the
/// friction of the teeth, which gives the planet a torque of its own. The nominal forces apply the whole
/// torque at the pitch circle. They would leave a planet out of balance by `1 − η` of a mesh. Their sum
/// exceeds the force of the planet bearings, by 1.7 % with efficiencies 0.97 and 0.98 at ratio 6.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forces {
    /// Tangential force at each mesh with the sun, `(T_1 + T_2)/(N·a_w)`.
    pub sun_mesh: Force,
    /// Tangential force at each mesh with the ring, `(T_3 − T_2)/(N·a_w)`, `T_3 = T_H − T_1`.
    pub ring_mesh: Force,
    /// Nominal tangential force of a tooth of the sun, for its strength: `2·T_1/(N·d_1)`.
    pub sun_nominal: Force,
    /// Nominal tangential force of a tooth of the ring: `2·T_3/(N·d_3)`.
    pub ring_nominal: Force,
    /// Tangential force on the bearings of each planet, from the carrier's torque: `T_H/(N·a_w)`.
    pub planet_bearing_tangential: Force,
    /// Radial force of the meshes on the bearings of each planet, outwards: `(F_sun − F_ring)·tan α`.
    pub planet_bearing_meshes: Force,
    /// The planet's centrifugal force on its bearings, outwards: `m·ω_H²·a_w`.
    pub planet_bearing_centrifugal: Force,
    /// Resultant of these forces; the tangential one is at right angles to both radial ones.
    pub planet_bearing: Force,
}

/// The three shafts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shafts {
    /// The sun's shaft.
    pub sun: ShaftDesign,
    /// The planet pin. It carries no torque: the source sizes it by torsion under `T_2` all the same,
    /// and so it is done here. Its real load is the bending by [`Forces::planet_bearing`].
    pub planet: ShaftDesign,
    /// The carrier's shaft.
    pub carrier: ShaftDesign,
}

/// A shaft by a low allowable torsional stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftDesign {
    /// The torque it is sized for.
    pub torque: Torque,
    /// Least diameter, `(16·T/(π·[τ]))^(1/3)`.
    pub needed: Length,
    /// The next standard diameter, and the smallest bearing that goes on it.
    pub standard: Choice,
    /// Choice that is used: the given one, else the standard one.
    pub used: Choice,
    /// Torsional stress of the shaft used.
    pub stress: Pressure,
}

/// A shaft's diameter and its bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choice {
    /// The shaft's diameter.
    pub diameter: Length,
    /// The bearing, where the table has one.
    pub bearing: Option<&'static Bearing>,
}

/// Masses and inertias of the parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Masses {
    /// The sun.
    pub sun: GearMass,
    /// One planet.
    pub planet: GearMass,
    /// The carrier's mass, where it or the shape is known.
    pub carrier: Option<Mass>,
    /// The carrier's inertia about the gearbox axis.
    pub carrier_inertia: MomentOfInertia,
    /// The carrier's shape, where it is known.
    pub carrier_shape: Option<Carrier>,
}

/// Flanges, splines and pockets are not in a shape; a real part has at most this many times its mass, or this
/// part of it.
const LIKE_SHAPE: f64 = 5.0;

impl Masses {
    /// Warns of known masses and inertias beyond [`LIKE_SHAPE`] of these shapes: a unit, a digit or the shape
    /// is wrong.
    pub(super) fn unlike(&self, known: &KnownParts) -> Vec<Warning> {
        // Without a shape the carrier's inertia is a given or neglected one, which is no measure for the
        // given figures.
        let carrier = self.carrier_shape.is_some().then_some(self.carrier_inertia);
        let all = [
            (Shaft::Sun, known.sun, Some(self.sun.mass), Some(self.sun.inertia)),
            (Shaft::Planet, known.planet, Some(self.planet.mass), Some(self.planet.inertia)),
            (Shaft::Carrier, known.carrier, self.carrier, carrier),
        ];
        let figures = all.into_iter().flat_map(|(part, known, mass, inertia)| {
            let figures = [
                (false, known.mass.map(Physical::si), mass.map(Physical::si)),
                (true, known.inertia.map(Physical::si), inertia.map(Physical::si)),
            ];
            figures.map(|(is_inertia, given, of_shape)| (part, is_inertia, given, of_shape))
        });
        let unlike = figures.filter_map(|(part, is_inertia, given, of_shape)| {
            let (given, of_shape) = given.zip(of_shape)?;
            let is_unlike = !(of_shape / LIKE_SHAPE..=of_shape * LIKE_SHAPE).contains(&given);
            is_unlike.then_some(Warning::PartUnlikeShape { part, is_inertia, given, of_shape })
        });
        unlike.collect()
    }

    /// Masses with those of the known parts replaced.
    #[must_use]
    pub(super) fn with(self, known: &KnownParts) -> Self {
        Self {
            sun: self.sun.with(known.sun),
            planet: self.planet.with(known.planet),
            carrier: known.carrier.mass.or(self.carrier),
            carrier_inertia: known.carrier.inertia.unwrap_or(self.carrier_inertia),
            carrier_shape: self.carrier_shape,
        }
    }
}

/// Mass of a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearMass {
    /// Diameter of the hole; 0 for none.
    pub bore: Length,
    /// Teeth and body by their shape.
    pub body: GearBody,
    /// The mass that is known of it, else that of its shape.
    pub mass: Mass,
    /// The inertia about its own axis that is known of it, else that of its shape.
    pub inertia: MomentOfInertia,
}

impl GearMass {
    fn with(self, known: KnownPart) -> Self {
        Self { mass: known.mass.unwrap_or(self.mass), inertia: known.inertia.unwrap_or(self.inertia), ..self }
    }
}

/// Equivalent inertia of all moving parts at the sun's shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EquivalentInertia {
    /// The sun, `J_1`.
    pub sun: MomentOfInertia,
    /// Other inertia on the sun's shaft.
    pub motor: MomentOfInertia,
    /// The planets' masses on their orbit, `N·m·a_w²·u_H²`.
    pub planets_orbiting: MomentOfInertia,
    /// The planets' own rotation, `N·J_2·u_2²`.
    pub planets_turning: MomentOfInertia,
    /// The carrier, `J_H·u_H²`.
    pub carrier: MomentOfInertia,
    /// The driven machine.
    pub machine: MomentOfInertia,
    /// The whole, `J_pr`.
    pub total: MomentOfInertia,
    /// Kinetic energy at the nominal speed, `T`, summed link by link.
    pub kinetic_energy: Energy,
}

/// Motion of the drive under the starting torques.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// The inertia that the driving torque feels: `J_pr`, or `J_η` with losses; where it is held, that of
    /// forward motion.
    pub inertia: MomentOfInertia,
    /// Generalized force from rest, friction taken off; 0 where it is held.
    pub generalized_force: Torque,
    /// Accelerations of the links from rest; 0 where it is held.
    pub accelerations: Accelerations,
    /// Loads on the carrier that keep it at rest, the least and the greatest: below it starts forward, above
    /// it runs backward. One load without losses.
    pub held: [Torque; 2],
    /// Whether and when it reaches its speed.
    pub start: Start,
}

/// Whether and when a drive reaches its speed from rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Start {
    /// Time after which the drive reaches its speed, both torques constant.
    After(Time),
    /// Never: driving torque and load balance. A drive that turns forward keeps turning, one at rest stays
    /// so.
    InBalance,
    /// Never: the friction of the meshes holds it. A drive that turns forward slows down and stays.
    Held,
    /// Never: the load turns it backward, with this generalized force at the sun's shaft.
    Backward(Torque),
}
