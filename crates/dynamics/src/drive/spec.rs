//! Specification of a drive.

use epicyclic_gears::bearing::{Bearing, Series};
use epicyclic_gears::carrier::{Arm, Hub};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::synthesis::{Bounds, Placement, ToothNumbers};
use epicyclic_units::Physical;
use std::fmt;
use std::ops::RangeInclusive;
use uom::si::f64::{AngularVelocity, Length, Mass, MassDensity, MomentOfInertia, Power, Pressure, Torque};

/// Specification of a drive.
///
/// [`DriveSpec::new`] needs five quantities; every other field has a default, stated at the field.
#[derive(Debug, Clone, PartialEq)]
pub struct DriveSpec {
    /// Power at the sun's shaft, `N_1`.
    pub power: Power,
    /// Speed of the sun, `ω_1`.
    pub speed: AngularVelocity,
    /// Ratio of the speeds of sun and carrier, `U = ω_1/ω_H`, with the ring at rest.
    pub ratio: f64,
    /// Permissible relative error of the ratio. Default 0.01.
    pub ratio_tolerance: f64,
    /// Tooth numbers. Default: searched within [`default_bounds`].
    pub teeth: TeethSpec,
    /// Efficiency of the mesh of sun and planet, `η_12`. Default 0.97, the source's.
    pub sun_planet_efficiency: MeshEfficiency,
    /// Efficiency of the mesh of planet and ring, `η_23`. Default 0.98, the source's.
    pub planet_ring_efficiency: MeshEfficiency,
    /// Efficiency of the bearings of a planet on its pin, `η_b`: they take their share of the power that the
    /// planet carries from mesh to mesh. Default 1.
    pub planet_bearing_efficiency: MeshEfficiency,
    /// Shape of sun, planets and ring.
    pub gear_set: GearSetSpec,
    /// Shafts and bearings.
    pub shafts: ShaftsSpec,
    /// The carrier. Default: neglected.
    pub carrier: CarrierSpec,
    /// Known masses and inertias of single parts. Default: none, their shapes decide.
    pub known: KnownParts,
    /// Inertia on the sun's shaft beside the sun: rotor of the motor, coupling. Default 0.
    pub motor_inertia: MomentOfInertia,
    /// Inertia of the driven machine, at the carrier. Default 0.
    pub machine_inertia: MomentOfInertia,
    /// Torque that the driven machine opposes to the carrier while the drive starts, `M_H`. Default: the
    /// torque that the drive delivers at its power, `T_1·U·η`.
    pub load: Option<Torque>,
    /// Torque on the sun while the drive starts, `M_1`. Default: `T_1 = N_1/ω_1`.
    pub driving_torque: Option<Torque>,
}

/// Tooth numbers, or where to seek them.
#[derive(Debug, Clone, PartialEq)]
pub enum TeethSpec {
    /// Given tooth numbers. If the planets touch each other, assemble at unequal angles only or miss the
    /// ratio, the drive is calculated nevertheless, with a [`Warning`](crate::drive::Warning).
    Given {
        /// The set.
        teeth: ToothNumbers,
        /// Placement of the planets: a set that needs unequal angles causes a warning unless they are
        /// allowed.
        placement: Placement,
        /// Least gap between the tip circles of adjacent planets, in modules; a smaller one is warned of.
        tip_gap: f64,
    },
    /// The set within the bounds whose ratio is nearest to the target; of equally near ones the one with most
    /// planets, then with the smallest ring, then with the smallest sun. The rack is always that of the gear
    /// set, not that of the bounds.
    Within(Bounds),
}

impl TeethSpec {
    /// Given tooth numbers, with planets at equal angles and tips that just clear.
    #[must_use]
    pub const fn given(teeth: ToothNumbers) -> Self {
        Self::Given { teeth, placement: Placement::Equal, tip_gap: 0.0 }
    }
}

/// Shape and material of sun, planets and ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearSetSpec {
    /// Module `m`.
    pub module: Length,
    /// Face width `b`.
    pub face_width: Length,
    /// Proportions of the teeth. Default: [`BasicRack::default`], `h_a*` 1, `c*` 0.25, 20°.
    pub rack: BasicRack,
    /// Density `ρ` of gears and carrier. Default 7850 kg/m³, steel.
    pub density: MassDensity,
    /// Bore of the sun. Default [`Bore::Shaft`]; the source's is [`Bore::Bearing`].
    pub sun_bore: Bore,
    /// Bore of a planet. Default [`Bore::BearingOrSolid`].
    pub planet_bore: Bore,
}

/// The hole in a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bore {
    /// The gear sits on its shaft: the hole has the shaft's diameter.
    Shaft,
    /// The bearing sits in the gear: the hole has the bearing's outside diameter.
    Bearing,
    /// The bearing sits in the gear if it fits; otherwise the gear is solid, with a warning.
    BearingOrSolid,
    /// Given diameter; 0 for a solid gear.
    Given(Length),
}

/// Shafts and bearings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftsSpec {
    /// Low allowable torsional stress `[τ]`. Default 20 MPa; 15…20 MPa is usual.
    pub allowable_stress: Pressure,
    /// Series from which bearings are taken. Default 300.
    pub bearing_series: Series,
    /// The sun's shaft.
    pub sun: ShaftSpec,
    /// The planet pin.
    pub planet: ShaftSpec,
    /// The carrier's shaft.
    pub carrier: ShaftSpec,
}

/// Given data of a shaft.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ShaftSpec {
    /// Diameter. Default: that of the given bearing, or else the next standard one that satisfies the
    /// formula.
    pub diameter: Option<Length>,
    /// Bearing. Default: the smallest of the series that goes on the shaft.
    pub bearing: Option<&'static Bearing>,
}

/// The carrier's shape, as far as its inertia needs it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CarrierSpec {
    /// Taken as massless, with a warning.
    Neglected,
    /// Inertia about the gearbox axis, without the planets.
    Inertia(MomentOfInertia),
    /// One arm for each planet, around a hub.
    Shape {
        /// One of the arms.
        arm: Arm,
        /// The hub.
        hub: Hub,
    },
}

/// Masses and inertias that are known of single parts, weighed or from a drawing; they replace those of the
/// shapes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct KnownParts {
    /// Known data of the sun.
    pub sun: KnownPart,
    /// Known data of one planet.
    pub planet: KnownPart,
    /// Known data of the carrier without planets.
    pub carrier: KnownPart,
}

/// Known mass and inertia of a part.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct KnownPart {
    /// Mass of the part.
    pub mass: Option<Mass>,
    /// Inertia of the part about its own axis, of the carrier about the axis of the gearbox.
    pub inertia: Option<MomentOfInertia>,
}

impl DriveSpec {
    /// Drive with the five required quantities and defaults for all others.
    #[must_use]
    pub fn new(power: Power, speed: AngularVelocity, ratio: f64, module: Length, face_width: Length) -> Self {
        let rack = BasicRack::default();
        Self {
            power,
            speed,
            ratio,
            ratio_tolerance: 0.01,
            teeth: TeethSpec::Within(default_bounds(rack)),
            sun_planet_efficiency: usual_efficiency(0.97),
            planet_ring_efficiency: usual_efficiency(0.98),
            planet_bearing_efficiency: MeshEfficiency::IDEAL,
            gear_set: GearSetSpec {
                module,
                face_width,
                rack,
                density: MassDensity::from_si(7850.0),
                sun_bore: Bore::Shaft,
                planet_bore: Bore::BearingOrSolid,
            },
            shafts: ShaftsSpec {
                allowable_stress: Pressure::from_mpa(20.0),
                bearing_series: Series::Medium300,
                sun: ShaftSpec::default(),
                planet: ShaftSpec::default(),
                carrier: ShaftSpec::default(),
            },
            carrier: CarrierSpec::Neglected,
            known: KnownParts::default(),
            motor_inertia: MomentOfInertia::default(),
            machine_inertia: MomentOfInertia::default(),
            load: None,
            driving_torque: None,
        }
    }
}

/// Default bounds for tooth numbers: [`Bounds::default`] without undercut gears.
///
/// If a flat pressure angle requires more than 200 teeth, sun and planet have exactly the fewest that are not
/// undercut.
#[must_use]
pub fn default_bounds(rack: BasicRack) -> Bounds {
    let usual = Bounds::default();
    let least = rack.least_teeth_without_undercut().max(1);
    // The upper end must not lie below `least`: an empty range would be refused.
    let external = |usual: &RangeInclusive<u32>| least..=least.max(*usual.end());
    Bounds { sun: external(&usual.sun), planet: external(&usual.planet), rack, ..usual }
}

fn usual_efficiency(eta: f64) -> MeshEfficiency {
    MeshEfficiency::new(eta).unwrap_or(MeshEfficiency::IDEAL)
}

/// Quantities of a drive that errors name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Given {
    /// Power at the sun's shaft.
    Power,
    /// Speed of the sun.
    Speed,
    /// Ratio of the speeds of sun and carrier.
    Ratio,
    /// Torque on the sun while the drive starts.
    DrivingTorque,
}

impl fmt::Display for Given {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Power => "power",
            Self::Speed => "speed",
            Self::Ratio => "ratio",
            Self::DrivingTorque => "driving torque",
        })
    }
}
