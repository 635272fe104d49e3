//! A drive, as tables.

use crate::drive::answer::{Bearing, CarrierShape, Drive, Gear, GearMass, Motion, Outcome, Shaft};
use crate::shared::judgement::table as judgement;
use crate::table::figure::Figure;
use crate::table::quantities::{optional, quantity, remarked};
use crate::table::report::AsReport;
use crate::table::report::{Part, Report, Row, Section, warned};
use epicyclic_units::Dimension::{
    self, Angle, AngularAcceleration, AngularSpeed, Area, Energy, Force, Inertia, Length, Mass, Power,
    Pressure, Time, Torque, Volume,
};
use epicyclic_units::format::trimmed;

const GEARS: &[(&str, &str)] = &[("sun", "sun"), ("planet", "planet"), ("ring", "ring")];
const SHAFTS: &[(&str, &str)] =
    &[("sun", "sun's shaft"), ("planet_pin", "planet pin"), ("carrier", "carrier's shaft")];
const PARTS: &[(&str, &str)] = &[("sun", "sun"), ("planet", "planet"), ("carrier", "carrier")];
const MOTIONS: &[(&str, &str)] = &[("without_losses", "without losses"), ("with_losses", "with mesh losses")];

const PIN: &str = "A planet pin carries no torque. The method sizes it by the torque on the planets all the same; check \
                   its bending by the force on the planet bearings.";

const PLANETS: &str =
    "N₂ = N₁·η₁₂·η_b: excavator-dynamics sends the whole power through planets on a carrier at rest.";

const SOURCE: &str = "As excavator-dynamics, the source, counts: its formulas take the bore of a gear off twice, and the arms of the carrier for thin rods. \
                      Nothing else is calculated from these.";

const FORCES: &str = "The forces at both meshes, which hold the friction of the teeth, add to the tangential force on the \
                      planet bearings. The nominal forces, for the strength of teeth, lay the whole torque on the pitch \
                      circle. They leave out the torque of friction on the planet, so they are larger and do not add to \
                      the force on the bearings.";

impl AsReport for Drive {
    fn report(&self) -> Report {
        let section =
            |name, title, columns, rows| Part::Facts(Section { name, title, columns, rows, note: "" });
        let noted =
            |name, title, columns, rows, note| Part::Facts(Section { name, title, columns, rows, note });
        let mut parts = vec![
            section("tooth_numbers", "Tooth numbers", &[], tooth_numbers(self)),
            section("efficiencies", "Efficiencies", &[], efficiencies(self)),
            section("speeds", "Speeds", &[], speeds(self)),
            section("torques", "Torques", &[], torques(self)),
            noted("powers", "Powers", &[], powers(self), PLANETS),
            section("gear_set", "Gears", GEARS, gears(self)),
            section("gear_set", "Gear set", &[], gear_set(self)),
            noted("forces", "Forces, planets sharing evenly", &[], forces(self), FORCES),
            noted("shafts", "Shafts by torsion, and bearings", SHAFTS, shafts(self), PIN),
            noted("masses", "Masses and inertias", PARTS, masses(self), SOURCE),
        ];
        let shape = self.masses.carrier.shape.as_ref();
        parts.extend(shape.map(|shape| section("carrier", "Carrier by its shape", &[], carrier(shape))));
        parts.extend([
            section(
                "equivalent_inertia",
                "Equivalent inertia, referred to the sun's shaft",
                &[],
                equivalent_inertia(self),
            ),
            section("start", "Start", &[], starting_torques(self)),
            section("start", "Motion from rest", MOTIONS, motions(self)),
        ]);
        parts.extend(judgement::parts(&self.judgement));
        Report { title: self.title.clone(), parts, warnings: warned(&self.warnings) }
    }
}

/// A row of one quantity.
fn one(name: &'static str, label: &'static str, symbol: &'static str, dimension: Dimension, si: f64) -> Row {
    Row::new(name, label, symbol, [quantity(dimension, si)])
}

fn count(name: &'static str, label: &'static str, symbol: &'static str, count: u32) -> Row {
    Row::new(name, label, symbol, [Figure::Count(count)])
}

fn tooth_numbers(drive: &Drive) -> Vec<Row> {
    let numbers = &drive.tooth_numbers;
    let angles = Figure::List { si: numbers.planet_angles_rad.clone(), dimension: Angle };
    vec![
        count("sun", "teeth of the sun", "z₁", numbers.sun),
        count("planet", "teeth of a planet", "z₂", numbers.planet),
        count("ring", "teeth of the ring", "z₃", numbers.ring),
        count("planets", "planets", "N", numbers.planets),
        count("most_planets", "planets that clear each other, at most", "", numbers.most_planets),
        Row::new("planet_angles", "angles of the planets", "", [angles]),
        one("tip_gap", "clearance between planets", "", Length, numbers.tip_gap_m),
        Row::new("basic_ratio", "basic ratio, carrier at rest", "i₀", [Figure::Number(numbers.basic_ratio)]),
        Row::new("ratio", "ratio", "U", [Figure::Number(numbers.ratio)]),
        Row::new("exact_ratio", "exactly", "", [Figure::Text(numbers.exact_ratio.to_string())]),
        Row::new("ratio_error", "off the wanted one by", "", [Figure::Share(numbers.ratio_error)]),
    ]
}

fn efficiencies(drive: &Drive) -> Vec<Row> {
    let number = |value| [Figure::Number(value)];
    vec![
        Row::new("basic", "of the gear set, carrier fixed", "η₀", number(drive.efficiencies.basic)),
        Row::new("overall", "of the drive", "η", number(drive.efficiencies.overall)),
    ]
}

fn speeds(drive: &Drive) -> Vec<Row> {
    let speeds = &drive.speeds;
    let row = |name, label, symbol, speed: f64| {
        remarked(one(name, label, symbol, AngularSpeed, speed), format!("{} rad/s", trimmed(speed, 5)))
    };
    vec![
        row("sun", "sun", "ω₁", speeds.sun_rad_s),
        row("planet", "planet", "ω₂", speeds.planet_rad_s),
        row("planet_relative", "planet relative to the carrier", "ω₂ − ω_H", speeds.planet_relative_rad_s),
        row("carrier", "carrier", "ω_H", speeds.carrier_rad_s),
    ]
}

fn torques(drive: &Drive) -> Vec<Row> {
    let torques = &drive.torques;
    vec![
        one("sun", "sun", "T₁", Torque, torques.sun_n_m),
        one("planets", "all planets about their axes", "T₂", Torque, torques.planets_n_m),
        one("carrier", "carrier, delivered", "T_H", Torque, torques.carrier_n_m),
        one("ring_reaction", "ring, held by the housing", "", Torque, torques.ring_reaction_n_m),
    ]
}

fn powers(drive: &Drive) -> Vec<Row> {
    let powers = &drive.powers;
    vec![
        one("input", "into the sun", "N₁", Power, powers.input_w),
        one("rolling", "rolling power, relative to the carrier", "", Power, powers.rolling_w),
        one("lost", "lost in meshes and planet bearings", "", Power, powers.lost_w),
        one("planets", "planets, as the source counts", "N₂", Power, powers.planets_w),
        one("output", "out of the carrier", "N_H", Power, powers.output_w),
    ]
}

fn gears(drive: &Drive) -> Vec<Row> {
    let set = &drive.gear_set;
    let of = |figure: fn(&Gear) -> f64| {
        [&set.sun, &set.planet, &set.ring].map(|gear| quantity(Length, figure(gear)))
    };
    vec![
        Row::new("pitch_diameter", "pitch diameter", "d", of(|gear| gear.pitch_diameter_m)),
        Row::new("tip_diameter", "tip diameter", "d_a", of(|gear| gear.tip_diameter_m)),
        Row::new("root_diameter", "root diameter", "d_f", of(|gear| gear.root_diameter_m)),
        Row::new("base_diameter", "base diameter", "d_b", of(|gear| gear.base_diameter_m)),
    ]
}

fn gear_set(drive: &Drive) -> Vec<Row> {
    let set = &drive.gear_set;
    let least = count(
        "least_teeth_without_undercut",
        "external teeth without undercut, at least",
        "z_min",
        set.least_teeth_without_undercut,
    );
    vec![
        remarked(least, format!("2·h_a*/sin²α = {}", trimmed(set.undercut_limit, 4))),
        one("module", "module", "m", Length, set.module_m),
        one("face_width", "face width", "b", Length, set.face_width_m),
        one("centre_distance", "centre distance", "a_w", Length, set.centre_distance_m),
    ]
}

fn forces(drive: &Drive) -> Vec<Row> {
    let forces = &drive.forces;
    let row = |name, label, force| one(name, label, "", Force, force);
    let nominal = |name, label, nominal: f64, real: f64| {
        remarked(row(name, label, nominal), format!("{:+.1} %", 100.0 * (nominal / real - 1.0)))
    };
    vec![
        row("sun_mesh", "tangential, at each mesh with the sun", forces.sun_mesh_n),
        row("ring_mesh", "tangential, at each mesh with the ring", forces.ring_mesh_n),
        row(
            "planet_bearing_tangential",
            "planet bearings, from the carrier's torque",
            forces.planet_bearing_tangential_n,
        ),
        row(
            "planet_bearing_meshes",
            "planet bearings, radial of both meshes, outwards",
            forces.planet_bearing_meshes_n,
        ),
        row(
            "planet_bearing_centrifugal",
            "planet bearings, centrifugal",
            forces.planet_bearing_centrifugal_n,
        ),
        row("planet_bearing", "planet bearings, together", forces.planet_bearing_n),
        nominal(
            "sun_nominal",
            "nominal, of a tooth of the sun, 2·T₁/(N·d₁)",
            forces.sun_nominal_n,
            forces.sun_mesh_n,
        ),
        nominal(
            "ring_nominal",
            "nominal, of the ring, 2·T₃/(N·d₃)",
            forces.ring_nominal_n,
            forces.ring_mesh_n,
        ),
    ]
}

fn shafts(drive: &Drive) -> Vec<Row> {
    let shafts = [&drive.shafts.sun, &drive.shafts.planet_pin, &drive.shafts.carrier];
    let of = |dimension, figure: fn(&Shaft) -> f64| shafts.map(|shaft| quantity(dimension, figure(shaft)));
    let designation = |bearing: &Option<Bearing>| match bearing {
        Some(bearing) => Figure::Text(bearing.designation.clone()),
        None => Figure::None,
    };
    let size = |figure: fn(&Bearing) -> f64| {
        shafts.map(|shaft| optional(Length, shaft.bearing.as_ref().map(figure)))
    };
    vec![
        Row::new("torque", "torque", "T", of(Torque, |shaft| shaft.torque_n_m)),
        Row::new("needed_diameter", "diameter needed", "", of(Length, |shaft| shaft.needed_diameter_m)),
        Row::new(
            "standard_diameter",
            "next standard diameter",
            "",
            of(Length, |shaft| shaft.standard_diameter_m),
        ),
        Row::new(
            "standard_bearing",
            "bearing for it",
            "",
            shafts.map(|shaft| designation(&shaft.standard_bearing)),
        ),
        Row::new("diameter", "diameter used", "", of(Length, |shaft| shaft.diameter_m)),
        Row::new("stress", "its torsional stress", "τ", of(Pressure, |shaft| shaft.stress_pa)),
        Row::new("bearing", "bearing used", "", shafts.map(|shaft| designation(&shaft.bearing))),
        Row::new(
            "bearing_outside_diameter",
            "its outside diameter",
            "D",
            size(|bearing| bearing.outside_diameter_m),
        ),
        Row::new("bearing_width", "its width", "B", size(|bearing| bearing.width_m)),
    ]
}

fn masses(drive: &Drive) -> Vec<Row> {
    let masses = &drive.masses;
    let shape = masses.carrier.shape.as_ref();
    let gears =
        |figure: fn(&GearMass) -> f64| [Some(figure(&masses.sun)), Some(figure(&masses.planet)), None];
    let row = |name, label, symbol, dimension, values: [Option<f64>; 3]| {
        Row::new(name, label, symbol, values.map(|si| optional(dimension, si)))
    };
    let mut rows = vec![
        row("bore", "bore", "", Length, [Some(masses.sun.bore_m), Some(masses.planet.bore_m), None]),
        row("teeth_volume", "volume of the teeth", "", Volume, gears(|gear| gear.teeth_volume_m3)),
        row("body_volume", "volume of the body", "", Volume, gears(|gear| gear.body_volume_m3)),
        row(
            "mass",
            "mass",
            "m",
            Mass,
            [Some(masses.sun.mass_kg), Some(masses.planet.mass_kg), masses.carrier.mass_kg],
        ),
        row(
            "inertia",
            "inertia about its axis",
            "J",
            Inertia,
            [masses.sun.inertia_kg_m2, masses.planet.inertia_kg_m2, masses.carrier.inertia_kg_m2].map(Some),
        ),
        row(
            "source_inertia",
            "inertia as the source counts",
            "",
            Inertia,
            [
                masses.sun.source_inertia_kg_m2,
                masses.planet.source_inertia_kg_m2,
                shape.map(|shape| shape.source_inertia_kg_m2),
            ],
        ),
    ];
    if drive.equivalent_inertia.of_shapes.is_some() {
        rows.extend([
            row("shape_mass", "mass by its shape", "", Mass, {
                let [sun, planet, _] = gears(|gear| gear.shape_mass_kg);
                [sun, planet, shape.map(|shape| shape.mass_kg)]
            }),
            row("shape_inertia", "inertia by its shape", "", Inertia, {
                let [sun, planet, _] = gears(|gear| gear.shape_inertia_kg_m2);
                [sun, planet, shape.map(|shape| shape.inertia_kg_m2)]
            }),
        ]);
    }
    rows
}

/// The steps from the arms and the hub to the carrier's inertia.
fn carrier(shape: &CarrierShape) -> Vec<Row> {
    vec![
        one("plate_area", "area of an arm, without its hole", "", Area, shape.plate_area_m2),
        one("hole_area", "area of its hole", "", Area, shape.hole_area_m2),
        one("arm_volume", "volume of an arm", "", Volume, shape.arm_volume_m3),
        one("arm_mass", "mass of an arm", "", Mass, shape.arm_mass_kg),
        one(
            "arm_centroid_from_outer_end",
            "its centroid from the outer end",
            "x_s",
            Length,
            shape.arm_centroid_from_outer_end_m,
        ),
        one("arm_centroid_radius", "its centroid from the axis", "x", Length, shape.arm_centroid_radius_m),
        one("arms_inertia", "inertia of all arms", "", Inertia, shape.arms_inertia_kg_m2),
        one("hub_volume", "volume of the hub", "", Volume, shape.hub_volume_m3),
        one("hub_mass", "mass of the hub", "", Mass, shape.hub_mass_kg),
        one("hub_inertia", "inertia of the hub", "", Inertia, shape.hub_inertia_kg_m2),
    ]
}

fn equivalent_inertia(drive: &Drive) -> Vec<Row> {
    let parts = &drive.equivalent_inertia;
    let row = |name, label, symbol, part: f64| {
        remarked(
            one(name, label, symbol, Inertia, part),
            format!("{:.1} %", 100.0 * part / parts.total_kg_m2),
        )
    };
    let mut rows = vec![
        row("sun", "sun", "", parts.sun_kg_m2),
        row("motor", "motor", "", parts.motor_kg_m2),
        row("planets_orbiting", "planets, on their orbit", "", parts.planets_orbiting_kg_m2),
        row("planets_turning", "planets, about their axes", "", parts.planets_turning_kg_m2),
        row("carrier", "carrier", "", parts.carrier_kg_m2),
        row("machine", "driven machine", "", parts.machine_kg_m2),
        row("total", "equivalent inertia", "J_pr", parts.total_kg_m2),
        one("kinetic_energy", "kinetic energy at full speed", "T", Energy, parts.kinetic_energy_j),
    ];
    if let Some(shapes) = &parts.of_shapes {
        let by = |ours: f64, shapes: f64| format!("{:+.1} %", 100.0 * (shapes / ours - 1.0));
        let total = one("shape_total", "equivalent inertia by the shapes", "", Inertia, shapes.total_kg_m2);
        rows.push(remarked(total, by(parts.total_kg_m2, shapes.total_kg_m2)));
        let energy =
            one("shape_kinetic_energy", "kinetic energy by the shapes", "", Energy, shapes.kinetic_energy_j);
        rows.push(remarked(energy, by(parts.kinetic_energy_j, shapes.kinetic_energy_j)));
    }
    rows
}

fn starting_torques(drive: &Drive) -> Vec<Row> {
    vec![
        one("driving_torque", "torque on the sun", "M₁", Torque, drive.start.driving_torque_n_m),
        one("load", "load on the carrier", "M_H", Torque, drive.start.load_n_m),
    ]
}

fn motions(drive: &Drive) -> Vec<Row> {
    let motions = [&drive.start.without_losses, &drive.start.with_losses];
    let of =
        |dimension, figure: fn(&Motion) -> f64| motions.map(|motion| quantity(dimension, figure(motion)));
    let outcome = |motion: &Motion| match motion.outcome {
        Outcome::Starts => Figure::answer("starts", "starts forward"),
        Outcome::InBalance => Figure::answer("in_balance", "in balance: does not start"),
        Outcome::Held => Figure::answer("held", "held by mesh friction"),
        Outcome::RunsBackward => Figure::answer("runs_backward", "runs backward"),
    };
    let acceleration = |name, label, symbol, figure: fn(&Motion) -> f64| {
        Row::new(name, label, symbol, of(AngularAcceleration, figure))
    };
    vec![
        Row::new("held_from", "forward at loads below", "", of(Torque, |motion| motion.held_from_n_m)),
        Row::new("held_to", "backward at loads above", "", of(Torque, |motion| motion.held_to_n_m)),
        Row::new(
            "generalized_force",
            "generalized force",
            "Q",
            of(Torque, |motion| motion.generalized_force_n_m),
        ),
        Row::new("inertia", "inertia felt by the sun", "J", of(Inertia, |motion| motion.inertia_kg_m2)),
        acceleration("acceleration_sun", "acceleration of the sun", "ε₁", |motion| {
            motion.acceleration_sun_rad_s2
        }),
        acceleration("acceleration_planet", "of a planet", "ε₂", |motion| {
            motion.acceleration_planet_rad_s2
        }),
        acceleration("acceleration_carrier", "of the carrier", "ε_H", |motion| {
            motion.acceleration_carrier_rad_s2
        }),
        Row::new("outcome", "outcome", "", motions.map(outcome)),
        Row::new(
            "starting_time",
            "time to full speed",
            "t",
            motions.map(|motion| optional(Time, motion.starting_time_s)),
        ),
    ]
}
