//! Design of a planetary drive from power, speed and ratio to its starting time.

mod judged;
mod masses;
mod warning;

pub use masses::{CarrierMass, CarrierShape, GearMass, Masses};

use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::judgement::answer::Judgement;
use crate::shared::number::{maybe_si, plain, si};
use crate::shared::records::Fraction;
use epicyclic_dynamics::drive::{self as dynamics, Choice, DriveDesign, DriveSpec, Start};
use epicyclic_formats::{Document, Faults, Path, drive as file};
use epicyclic_gears::bearing;
use epicyclic_gears::geometry::ToothedGear;
use schemars::JsonSchema;
use serde::Serialize;

/// Planetary drive: the sun drives, the ring is fixed, the load is on the carrier.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Drive {
    /// Purpose of the drive; null if its file gives no title.
    pub title: Option<String>,
    /// Tooth numbers, planets and ratio.
    pub tooth_numbers: ToothNumbers,
    /// Efficiencies from the mesh losses alone.
    pub efficiencies: Efficiencies,
    /// Speeds, positive in the direction of the sun.
    pub speeds: Speeds,
    /// Torques at the nominal power.
    pub torques: Torques,
    /// Powers at the nominal speed.
    pub powers: Powers,
    /// Dimensions of sun, planets and ring.
    pub gear_set: GearSet,
    /// Forces at the nominal power, planets sharing the load evenly (mesh load factor 1).
    pub forces: Forces,
    /// Shafts by torsion, and their bearings.
    pub shafts: Shafts,
    /// Masses and inertias of the parts.
    pub masses: Masses,
    /// Equivalent inertia of all moving parts, referred to the sun's shaft.
    pub equivalent_inertia: EquivalentInertia,
    /// The start from rest under constant torques.
    pub start: Starting,
    /// Judgement of the drive by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the design.
    pub warnings: Vec<Warning>,
}

/// Tooth numbers, and how well they meet their conditions.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ToothNumbers {
    /// Tooth number of the sun, `z₁`.
    pub sun: u32,
    /// Tooth number of a planet, `z₂`.
    pub planet: u32,
    /// Tooth number of the ring, `z₃`.
    pub ring: u32,
    /// Number of planets, `N`.
    pub planets: u32,
    /// Maximum number of planets that clear each other at equal spacing.
    pub most_planets: u32,
    /// Whether the planets are equally spaced.
    pub equal_spacing: bool,
    /// Angle of each planet about the axis, in rad.
    pub planet_angles_rad: Vec<f64>,
    /// Clearance between the tips of the closest planets, in m; negative if they overlap.
    pub tip_gap_m: f64,
    /// Basic ratio `i₀ = −z₃/z₁`, speed of the sun over speed of the ring with the carrier at rest.
    pub basic_ratio: f64,
    /// Ratio `U`, speed of the sun over speed of the carrier.
    pub ratio: f64,
    /// Exact ratio `U` as a fraction.
    pub exact_ratio: Fraction,
    /// Relative deviation from the required ratio.
    pub ratio_error: f64,
}

/// Efficiencies from the mesh losses alone.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Efficiencies {
    /// Efficiency of the gear set with its carrier fixed, `η₀`.
    pub basic: f64,
    /// Efficiency of the drive, `η`.
    pub overall: f64,
}

/// Speeds, positive in the direction of the sun.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Speeds {
    /// Speed of the sun, `ω₁`, in rad/s.
    pub sun_rad_s: f64,
    /// Planet speed, `ω₂`, in rad/s.
    pub planet_rad_s: f64,
    /// Planet speed relative to the carrier, `ω₂ − ω_H`, in rad/s.
    pub planet_relative_rad_s: f64,
    /// Speed of the carrier, `ω_H`, in rad/s.
    pub carrier_rad_s: f64,
}

/// Torques at the nominal power.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Torques {
    /// Torque on the sun, `T₁`, in N·m.
    pub sun_n_m: f64,
    /// Torque on all planets together about their own axes, `T₂`, in N·m; it does not reach the planet pins.
    pub planets_n_m: f64,
    /// Torque delivered by the carrier, `T_H`, in N·m.
    pub carrier_n_m: f64,
    /// Torque of the housing on the ring, `T_H − T₁`, in N·m.
    pub ring_reaction_n_m: f64,
}

/// Powers at the nominal speed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Powers {
    /// Power into the sun, `N₁`, in W.
    pub input_w: f64,
    /// Rolling power in W: power through the meshes, relative to the carrier.
    pub rolling_w: f64,
    /// Power lost in the meshes and in the planet bearings, in W.
    pub lost_w: f64,
    /// Power on the planet shafts by the source's formula `N₁·η₁₂·η_b`, in W: as if the carrier were at rest.
    pub planets_w: f64,
    /// Power out of the carrier, `N_H`, in W.
    pub output_w: f64,
}

/// Dimensions of sun, planets and ring.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearSet {
    /// Module `m`, in m.
    pub module_m: f64,
    /// Face width `b`, in m.
    pub face_width_m: f64,
    /// Centre distance `a_w` of sun and planet, the radius of the planets' orbit, in m.
    pub centre_distance_m: f64,
    /// Tooth number of an external gear below which the rack undercuts it, `2·h_a*/sin²α`.
    pub undercut_limit: f64,
    /// Least tooth number of an external gear that counts as not undercut, `z_min`.
    pub least_teeth_without_undercut: u32,
    /// Diameters of the sun.
    pub sun: Gear,
    /// Diameters of a planet.
    pub planet: Gear,
    /// Diameters of the ring.
    pub ring: Gear,
}

/// Diameters of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Gear {
    /// Pitch diameter `d`, in m.
    pub pitch_diameter_m: f64,
    /// Tip diameter `d_a`, in m.
    pub tip_diameter_m: f64,
    /// Root diameter `d_f`, in m.
    pub root_diameter_m: f64,
    /// Base diameter `d_b`, in m.
    pub base_diameter_m: f64,
}

/// Forces at the nominal power, planets sharing the load evenly.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Forces {
    /// Tangential force at each sun mesh in N, friction of the teeth included.
    pub sun_mesh_n: f64,
    /// Tangential force at each ring mesh in N, friction of the teeth included. Together with the force at
    /// the sun mesh it gives `planet_bearing_tangential_n`.
    pub ring_mesh_n: f64,
    /// Tangential force on the bearings of each planet in N, from the carrier torque.
    pub planet_bearing_tangential_n: f64,
    /// Radial force of both meshes on the bearings of each planet in N, outwards.
    pub planet_bearing_meshes_n: f64,
    /// Centrifugal force of a planet on its bearings in N, outwards.
    pub planet_bearing_centrifugal_n: f64,
    /// Resultant force on the bearings of each planet, in N.
    pub planet_bearing_n: f64,
    /// Nominal tangential tooth force of the sun for its strength, `2·T₁/(N·d₁)`, in N. It leaves out the
    /// friction torque on the planet, and so is larger than the force at the mesh.
    pub sun_nominal_n: f64,
    /// Nominal tangential tooth force of the ring for its strength, `2·T₃/(N·d₃)`, in N.
    pub ring_nominal_n: f64,
}

/// Shafts of the sun, the planets and the carrier.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Shafts {
    /// Shaft of the sun.
    pub sun: Shaft,
    /// Planet pin. A pin carries no torque, but the method sizes it by the torque on the planets. Its real
    /// load is bending by the force on the planet bearings.
    pub planet_pin: Shaft,
    /// Shaft of the carrier.
    pub carrier: Shaft,
}

/// Shaft sized by a low allowable torsional stress.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Shaft {
    /// Torque for which the shaft is sized, in N·m.
    pub torque_n_m: f64,
    /// Diameter required by the formula, in m.
    pub needed_diameter_m: f64,
    /// Next standard diameter, in m.
    pub standard_diameter_m: f64,
    /// Smallest bearing of the series for the standard diameter; null if none exists.
    pub standard_bearing: Option<Bearing>,
    /// Diameter used, in m: as given, or else the standard one.
    pub diameter_m: f64,
    /// Torsional stress at the diameter used, in Pa.
    pub stress_pa: f64,
    /// Bearing used; null if none exists.
    pub bearing: Option<Bearing>,
}

/// Deep-groove ball bearing.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Bearing {
    /// Designation of the bearing by GOST; the international one has a 6 before it.
    pub designation: String,
    /// Bore `d`, in m.
    pub bore_m: f64,
    /// Outside diameter `D`, in m.
    pub outside_diameter_m: f64,
    /// Width `B`, in m.
    pub width_m: f64,
}

/// Equivalent inertia, referred to the sun's shaft, with its parts.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EquivalentInertia {
    /// Inertia of the sun in kg·m².
    pub sun_kg_m2: f64,
    /// Inertia of the motor and other parts on the sun's shaft, in kg·m².
    pub motor_kg_m2: f64,
    /// Equivalent inertia of the planets' masses on their orbit, in kg·m².
    pub planets_orbiting_kg_m2: f64,
    /// Equivalent inertia of the planets' own rotation, in kg·m².
    pub planets_turning_kg_m2: f64,
    /// Equivalent inertia of the carrier, in kg·m².
    pub carrier_kg_m2: f64,
    /// Equivalent inertia of the driven machine, in kg·m².
    pub machine_kg_m2: f64,
    /// Total equivalent inertia `J_pr`, in kg·m².
    pub total_kg_m2: f64,
    /// Kinetic energy at the nominal speed, `T`, in J.
    pub kinetic_energy_j: f64,
    /// Equivalent inertia and kinetic energy from the shapes alone; null if no mass or inertia of a part is
    /// given.
    pub of_shapes: Option<OfShapes>,
}

/// Equivalent inertia and kinetic energy from the shapes alone, instead of the given masses and inertias.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct OfShapes {
    /// Equivalent inertia in kg·m².
    pub total_kg_m2: f64,
    /// Kinetic energy at the nominal speed, in J.
    pub kinetic_energy_j: f64,
}

/// Start from rest under constant torques.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Starting {
    /// Torque on the sun, `M₁`, in N·m.
    pub driving_torque_n_m: f64,
    /// Load torque on the carrier against its motion, `M_H`, in N·m.
    pub load_n_m: f64,
    /// Motion without losses.
    pub without_losses: Motion,
    /// Motion with the mesh losses.
    pub with_losses: Motion,
}

/// Motion of the drive from rest.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Motion {
    /// Load in N·m below which the drive starts forward.
    pub held_from_n_m: f64,
    /// Load in N·m above which the drive runs backward; between both limits it stays at rest.
    pub held_to_n_m: f64,
    /// Generalized force at the sun's shaft with friction subtracted, `Q`, in N·m; 0 if the drive stays at
    /// rest.
    pub generalized_force_n_m: f64,
    /// Effective inertia at the sun's shaft during the start, in kg·m².
    pub inertia_kg_m2: f64,
    /// Acceleration of the sun in rad/s².
    pub acceleration_sun_rad_s2: f64,
    /// Acceleration of a planet in rad/s².
    pub acceleration_planet_rad_s2: f64,
    /// Acceleration of the carrier in rad/s².
    pub acceleration_carrier_rad_s2: f64,
    /// Outcome of the start.
    pub outcome: Outcome,
    /// Time to the nominal speed in s; null if the drive does not start.
    pub starting_time_s: Option<f64>,
}

/// Outcomes of a start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// The drive starts forward.
    Starts,
    /// Driving torque and load balance: the drive does not start.
    InBalance,
    /// The friction of the meshes holds the drive.
    Held,
    /// The load turns the drive backward.
    RunsBackward,
}

impl Answer for Drive {
    const NAME: &'static str = "drive";
}

/// The drive of a specification.
///
/// # Errors
/// [`Error::Drive`].
///
/// # Example
/// ```
/// use epicyclic_commands::drive::answer::{Outcome, answer};
/// use epicyclic_dynamics::drive::DriveSpec;
/// use uom::si::angular_velocity::revolution_per_minute;
/// use uom::si::f64::{AngularVelocity, Length, Power};
/// use uom::si::{length::millimeter, power::kilowatt};
///
/// let mm = Length::new::<millimeter>;
/// let speed = AngularVelocity::new::<revolution_per_minute>(1950.0);
/// let spec = DriveSpec::new(Power::new::<kilowatt>(106.5), speed, 6.0, mm(8.0), mm(60.0));
/// let drive = answer(None, &spec)?;
/// assert!((drive.torques.sun_n_m - 521.5).abs() < 0.1);
/// assert_eq!(drive.start.with_losses.outcome, Outcome::InBalance);
/// # Ok::<(), epicyclic_commands::error::Error>(())
/// ```
pub fn answer(title: Option<String>, spec: &DriveSpec) -> Result<Drive, Error> {
    let design = dynamics::design(spec).map_err(|error| Error::Drive(Box::new(error)))?;
    Ok(Drive::of(title, spec, &design))
}

/// Designs the drive of a file.
///
/// # Errors
/// [`Error::Document`] with all independent faults at the keys that they are about; [`Error::Placed`] at
/// `ratio` if no teeth are found.
pub fn of_file(document: &Document) -> Result<Drive, Error> {
    let (file, spec) = file::read(document)?;
    let design = dynamics::design_all(&spec).map_err(|errors| {
        let mut faults = Faults::default();
        for error in &errors {
            faults.add(file::place(error), error.clone());
        }
        let at = faults.placed(document, &Path::root());
        match errors.into_iter().next().map(|first| Error::Drive(Box::new(first))) {
            // The question is sound.
            Some(why) if why.is_nothing_found() => Error::Placed { at: Box::new(at), why: Box::new(why) },
            _ => Error::Document(at),
        }
    })?;
    Ok(Drive::of(file.title, &spec, &design))
}

impl Drive {
    /// Converts a design into a record.
    #[must_use]
    pub fn of(title: Option<String>, spec: &DriveSpec, design: &DriveDesign) -> Self {
        let DriveDesign { speeds, torques, powers, forces, shafts, .. } = design;
        let parts = &design.equivalent_inertia;
        let mut drive = Self {
            title,
            tooth_numbers: ToothNumbers::of(&design.teeth),
            efficiencies: Efficiencies {
                basic: design.efficiency.basic,
                // Values of differences may end as −0.0, which `plain` turns to 0.0.
                overall: plain(design.efficiency.overall),
            },
            speeds: Speeds {
                sun_rad_s: si(speeds.sun),
                planet_rad_s: si(speeds.planet),
                planet_relative_rad_s: si(speeds.planet_relative),
                carrier_rad_s: si(speeds.carrier),
            },
            torques: Torques {
                sun_n_m: si(torques.sun),
                planets_n_m: si(torques.planets),
                carrier_n_m: si(torques.carrier),
                ring_reaction_n_m: si(torques.ring_reaction),
            },
            powers: Powers {
                input_w: si(powers.input),
                rolling_w: si(powers.mesh),
                lost_w: si(powers.lost),
                planets_w: si(powers.planets),
                output_w: si(powers.output),
            },
            gear_set: GearSet::of(&design.gear_set),
            forces: Forces {
                sun_mesh_n: si(forces.sun_mesh),
                ring_mesh_n: si(forces.ring_mesh),
                planet_bearing_tangential_n: si(forces.planet_bearing_tangential),
                planet_bearing_meshes_n: si(forces.planet_bearing_meshes),
                planet_bearing_centrifugal_n: si(forces.planet_bearing_centrifugal),
                planet_bearing_n: si(forces.planet_bearing),
                sun_nominal_n: si(forces.sun_nominal),
                ring_nominal_n: si(forces.ring_nominal),
            },
            shafts: Shafts {
                sun: Shaft::of(&shafts.sun),
                planet_pin: Shaft::of(&shafts.planet),
                carrier: Shaft::of(&shafts.carrier),
            },
            masses: Masses::of(design),
            equivalent_inertia: EquivalentInertia {
                sun_kg_m2: si(parts.sun),
                motor_kg_m2: si(parts.motor),
                planets_orbiting_kg_m2: si(parts.planets_orbiting),
                planets_turning_kg_m2: si(parts.planets_turning),
                carrier_kg_m2: si(parts.carrier),
                machine_kg_m2: si(parts.machine),
                total_kg_m2: si(parts.total),
                kinetic_energy_j: si(parts.kinetic_energy),
                of_shapes: design.inertia_of_shapes.as_ref().map(|shapes| OfShapes {
                    total_kg_m2: si(shapes.total),
                    kinetic_energy_j: si(shapes.kinetic_energy),
                }),
            },
            start: Starting {
                driving_torque_n_m: si(design.driving_torque),
                load_n_m: si(design.load),
                without_losses: Motion::of(&design.without_losses),
                with_losses: Motion::of(&design.with_losses),
            },
            judgement: Judgement::default(),
            warnings: warning::all(design),
        };
        judged::judge(&mut drive, spec);
        drive
    }
}

impl ToothNumbers {
    fn of(teeth: &dynamics::TeethDesign) -> Self {
        let numbers = teeth.numbers;
        Self {
            sun: numbers.sun.get(),
            planet: numbers.planet.get(),
            ring: numbers.ring.get(),
            planets: numbers.planets,
            most_planets: teeth.most_planets,
            equal_spacing: teeth.spacing.is_equal(),
            planet_angles_rad: teeth.spacing.angles().into_iter().map(si).collect(),
            tip_gap_m: si(teeth.tip_gap),
            basic_ratio: numbers.basic_ratio().get(),
            ratio: plain(teeth.ratio),
            exact_ratio: Fraction::of(teeth.exact_ratio),
            ratio_error: plain(teeth.ratio_error),
        }
    }
}

impl GearSet {
    fn of(set: &dynamics::GearSetGeometry) -> Self {
        let rack = set.sun.rack();
        Self {
            module_m: si(set.sun.module()),
            face_width_m: si(set.face_width),
            centre_distance_m: si(set.centre_distance),
            undercut_limit: rack.undercut_limit(),
            least_teeth_without_undercut: rack.least_teeth_without_undercut(),
            sun: Gear::of(&set.sun),
            planet: Gear::of(&set.planet),
            ring: Gear::of(&set.ring),
        }
    }
}

impl Gear {
    fn of(gear: &ToothedGear) -> Self {
        Self {
            pitch_diameter_m: si(gear.pitch_diameter()),
            tip_diameter_m: si(gear.tip_diameter()),
            root_diameter_m: si(gear.root_diameter()),
            base_diameter_m: si(gear.base_diameter()),
        }
    }
}

impl Shaft {
    fn of(shaft: &dynamics::ShaftDesign) -> Self {
        let bearing = |choice: &Choice| choice.bearing.map(Bearing::of);
        Self {
            torque_n_m: si(shaft.torque),
            needed_diameter_m: si(shaft.needed),
            standard_diameter_m: si(shaft.standard.diameter),
            standard_bearing: bearing(&shaft.standard),
            diameter_m: si(shaft.used.diameter),
            stress_pa: si(shaft.stress),
            bearing: bearing(&shaft.used),
        }
    }
}

impl Bearing {
    fn of(bearing: &bearing::Bearing) -> Self {
        Self {
            designation: bearing.designation.to_owned(),
            bore_m: si(bearing.bore),
            outside_diameter_m: si(bearing.outside_diameter),
            width_m: si(bearing.width),
        }
    }
}

impl Motion {
    fn of(motion: &dynamics::Motion) -> Self {
        let (outcome, time) = match motion.start {
            Start::After(time) => (Outcome::Starts, Some(time)),
            Start::InBalance => (Outcome::InBalance, None),
            Start::Held => (Outcome::Held, None),
            // The time of a backward start is not that to the nominal speed, so it is left out.
            Start::Backward(_) => (Outcome::RunsBackward, None),
        };
        let [from, to] = motion.held;
        Self {
            held_from_n_m: si(from),
            held_to_n_m: si(to),
            generalized_force_n_m: si(motion.generalized_force),
            inertia_kg_m2: si(motion.inertia),
            acceleration_sun_rad_s2: si(motion.accelerations.sun),
            acceleration_planet_rad_s2: si(motion.accelerations.planet),
            acceleration_carrier_rad_s2: si(motion.accelerations.carrier),
            outcome,
            starting_time_s: maybe_si(time),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<Drive, Error> {
        of_file(&Document::parse_one("drive.yaml", text.as_bytes()).unwrap())
    }

    const GEAR_SET: &str = "gear_set: { module: 5 mm, face_width: 50 mm }\n";

    #[test]
    fn forces_at_both_meshes_add_to_that_on_the_planet_bearings() {
        let drive = of(&format!("power: 30 kW\nspeed: 1450 rpm\nratio: 5\n{GEAR_SET}")).unwrap();
        let forces = &drive.forces;
        let sum = forces.sun_mesh_n + forces.ring_mesh_n;
        assert!((sum / forces.planet_bearing_tangential_n - 1.0).abs() < 1e-12);
        assert_eq!(drive.tooth_numbers.exact_ratio, Fraction { numerator: 5, denominator: 1 });
        let parts = &drive.equivalent_inertia;
        let sum = parts.sun_kg_m2
            + parts.motor_kg_m2
            + parts.planets_orbiting_kg_m2
            + parts.planets_turning_kg_m2
            + parts.carrier_kg_m2
            + parts.machine_kg_m2;
        assert!((sum / parts.total_kg_m2 - 1.0).abs() < 1e-12);
        assert!(drive.warnings.iter().any(|warning| warning.name == "carrier-neglected"));
    }

    /// Energy, equivalent inertia and acceleration from the masses and inertias of the source agree with the
    /// sums written out.
    #[test]
    fn what_is_given_of_a_part_replaces_its_shape() {
        let text = std::fs::read_to_string("../../examples/xe215cll-drive-as-printed.yaml").unwrap();
        let drive = of(&text).unwrap();
        let inertia = &drive.equivalent_inertia;
        let due = 0.008_18 + 4.0 * 31.5 * 0.24 * 0.24 / 36.0 + 4.0 * 0.3 / 16.0 + 0.144 / 36.0;
        assert!((inertia.total_kg_m2 / due - 1.0).abs() < 1e-12 && (due - 0.288_78).abs() < 1e-9);
        assert!((inertia.kinetic_energy_j / (0.5 * due * 204.1 * 204.1) - 1.0).abs() < 1e-12);
        assert!((inertia.kinetic_energy_j - 6014.8).abs() < 0.05);
        let motion = &drive.start.without_losses;
        assert!((motion.acceleration_sun_rad_s2 / ((521.8 - 2974.26 / 6.0) / due) - 1.0).abs() < 1e-12);
        assert!((motion.acceleration_sun_rad_s2 - 90.35).abs() < 0.005);
        assert!((drive.powers.planets_w / 102_271.95 - 1.0).abs() < 1e-12);
        let shapes = inertia.of_shapes.as_ref().unwrap();
        let by_shape = |gear: &GearMass| (gear.shape_mass_kg, gear.shape_inertia_kg_m2);
        let (sun, (planet_kg, planet)) = (by_shape(&drive.masses.sun).1, by_shape(&drive.masses.planet));
        let carrier = drive.masses.carrier.shape.as_ref().unwrap().inertia_kg_m2;
        let of_shapes = sun + 4.0 * planet_kg * 0.24 * 0.24 / 36.0 + 4.0 * planet / 16.0 + carrier / 36.0;
        assert!((shapes.total_kg_m2 / of_shapes - 1.0).abs() < 1e-12);
        let (before, parts) = text.split_once("parts:").unwrap();
        let (_, after) = parts.split_once("\n\n").unwrap();
        let same = of(&format!("{before}{after}")).unwrap();
        assert_eq!(same.equivalent_inertia.of_shapes, None);
        assert!((same.equivalent_inertia.total_kg_m2 / of_shapes - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_ratio_that_no_teeth_have_is_told_at_its_key() {
        let error = of(&format!("power: 30 kW\nspeed: 1450 rpm\nratio: 60\n{GEAR_SET}")).unwrap_err();
        assert!(error.is_nothing_found());
        assert!(error.to_string().starts_with("drive.yaml:3:8: ratio: "), "{error}");
        let error = of(&format!("power: 0 kW\nspeed: 1450 rpm\nratio: 5\n{GEAR_SET}")).unwrap_err();
        assert!(!error.is_nothing_found());
        assert!(error.to_string().starts_with("drive.yaml:1:8: power: "), "{error}");
    }
}
