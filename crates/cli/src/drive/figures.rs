//! The figures of a drive, by the names that the library gives them.

use epicyclic_dynamics::drive::{Choice, DriveDesign, GearMass, Motion, ShaftDesign, Start};
use epicyclic_formats::quantity::format::trimmed;
use epicyclic_formats::{Dimension, Physical};
use epicyclic_views::figure::{Figure, optional, quantity};
use epicyclic_views::report::{Part, Report, Row, Section};
use uom::si::f64::{AngularVelocity, Force, Length, MomentOfInertia, Time};

const GEARS: &[(&str, &str)] = &[("sun", "sun"), ("planet", "planet"), ("ring", "ring")];
const SHAFTS: &[(&str, &str)] =
    &[("sun", "sun's shaft"), ("planet", "planet's pin"), ("carrier", "carrier's shaft")];
const PARTS: &[(&str, &str)] = &[("sun", "sun"), ("planet", "planet"), ("carrier", "carrier")];
const MOTIONS: &[(&str, &str)] = &[("without_losses", "without losses"), ("with_losses", "with mesh losses")];

const PIN: &str = "A planet's pin carries no torque. The method sizes it by the torque on the planets all the same; \
                   check its bending by the force on it.";

const FORCES: &str = "The sum of both mesh forces is the tangential force on the pin: they hold the friction of the \
                      teeth. The nominal forces, for the strength of teeth, lay the whole torque on the pitch circle. \
                      They leave out the torque of friction on the planet, so they are larger and their sum is not the \
                      pin's force.";

/// The whole answer.
pub(super) fn report(title: Option<String>, design: &DriveDesign) -> Report {
    let section = |name, title, columns, rows| Part::Facts(Section { name, title, columns, rows, note: "" });
    Report {
        title,
        parts: vec![
            section("gear", "Gear", &[], gear(design)),
            section("speeds", "Speeds", &[], speeds(design)),
            section("torques", "Torques", &[], torques(design)),
            section("powers", "Powers", &[], powers(design)),
            section("wheels", "Wheels", GEARS, gears(design)),
            section("wheels", "Wheels together", &[], mesh(design)),
            Part::Facts(Section {
                name: "forces",
                title: "Forces, planets sharing evenly",
                columns: &[],
                rows: forces(design),
                note: FORCES,
            }),
            Part::Facts(Section {
                name: "shafts",
                title: "Shafts by torsion, and bearings",
                columns: SHAFTS,
                rows: shafts(design),
                note: PIN,
            }),
            section("masses", "Masses and inertias", PARTS, masses(design)),
            section("reduction", "Reduced to the sun's shaft", &[], equivalent_inertia(design)),
            section("start", "Start", &[], starting_torques(design)),
            section("start", "Motion from rest", MOTIONS, motions(design)),
        ],
        warnings: Some(warnings(design)),
    }
}

fn warnings(design: &DriveDesign) -> Vec<(&'static str, String)> {
    let of_design = design.warnings.iter().map(|warning| (warning.name(), warning.to_string()));
    // In balance is how every drive stands whose load is its nominal one; the outcome says so.
    let [least, greatest] = design.with_losses.held.map(|load| trimmed(load.si(), 5));
    let start = match design.with_losses.start {
        Start::After(_) | Start::InBalance => None,
        Start::Held => Some((
            "no-start",
            format!(
                "it does not start: with this driving torque the friction of the meshes holds loads from {least} to \
                 {greatest} N·m; the drive starts forward below them and runs backward above"
            ),
        )),
        Start::Backward(_) => Some((
            "runs-backward",
            format!(
                "the load turns the drive backward: with this driving torque the friction of the meshes holds no more \
                 than {greatest} N·m; it starts forward below {least} N·m"
            ),
        )),
    };
    of_design.chain(start).collect()
}

fn gear(design: &DriveDesign) -> Vec<Row> {
    let teeth = &design.teeth;
    let numbers = teeth.numbers;
    let angles = teeth.spacing.angles().into_iter().map(Physical::si).collect();
    vec![
        Row::new("sun", "teeth of the sun", "z₁", [Figure::Count(numbers.sun.get())]),
        Row::new("planet", "teeth of a planet", "z₂", [Figure::Count(numbers.planet.get())]),
        Row::new("ring", "teeth of the ring", "z₃", [Figure::Count(numbers.ring.get())]),
        Row::new("planets", "planets", "N", [Figure::Count(numbers.planets)]),
        Row::new(
            "most_planets",
            "planets that clear each other, at most",
            "",
            [Figure::Count(teeth.most_planets)],
        ),
        Row::new(
            "planet_angles",
            "angles of the planets",
            "",
            [Figure::List { si: angles, dimension: Dimension::Angle }],
        ),
        Row::new("tip_gap", "gap between their tips", "", [quantity(teeth.tip_gap)]),
        Row::new("ratio", "ratio", "U", [Figure::Number(teeth.ratio)]),
        Row::new("exact_ratio", "exactly", "", [Figure::Text(teeth.exact_ratio.to_string())]),
        Row::new("ratio_error", "off the wanted one by", "", [Figure::Share(teeth.ratio_error)]),
        Row::new(
            "stationary_efficiency",
            "efficiency, carrier at rest",
            "η₀",
            [Figure::Number(design.efficiency.basic)],
        ),
        Row::new("efficiency", "efficiency", "η", [Figure::Number(design.efficiency.overall)]),
    ]
}

fn speeds(design: &DriveDesign) -> Vec<Row> {
    let speeds = &design.speeds;
    let row = |name, label, symbol, speed: AngularVelocity| Row {
        remark: format!("{} rad/s", trimmed(speed.si(), 5)),
        ..Row::new(name, label, symbol, [quantity(speed)])
    };
    vec![
        row("sun", "sun", "ω₁", speeds.sun),
        row("planet", "planet", "ω₂", speeds.planet),
        row("planet_relative", "planet on the carrier", "ω₂ − ω_H", speeds.planet_relative),
        row("carrier", "carrier", "ω_H", speeds.carrier),
    ]
}

fn torques(design: &DriveDesign) -> Vec<Row> {
    let torques = &design.torques;
    vec![
        Row::new("sun", "sun", "T₁", [quantity(torques.sun)]),
        Row::new("planets", "all planets about their axes", "T₂", [quantity(torques.planets)]),
        Row::new("carrier", "carrier, delivered", "T_H", [quantity(torques.carrier)]),
        Row::new("ring_reaction", "ring, held by the housing", "", [quantity(torques.ring_reaction)]),
    ]
}

fn powers(design: &DriveDesign) -> Vec<Row> {
    let powers = &design.powers;
    vec![
        Row::new("input", "into the sun", "N₁", [quantity(powers.input)]),
        Row::new("mesh", "through the meshes, seen from the carrier", "", [quantity(powers.mesh)]),
        Row::new("lost", "lost in the meshes", "", [quantity(powers.lost)]),
        Row::new("output", "out of the carrier", "N_H", [quantity(powers.output)]),
    ]
}

fn gears(design: &DriveDesign) -> Vec<Row> {
    let gears = [design.gear_set.sun, design.gear_set.planet, design.gear_set.ring];
    vec![
        Row::new("pitch_diameter", "pitch diameter", "d", gears.map(|gear| quantity(gear.pitch_diameter()))),
        Row::new("tip_diameter", "tip diameter", "d_a", gears.map(|gear| quantity(gear.tip_diameter()))),
        Row::new("root_diameter", "root diameter", "d_f", gears.map(|gear| quantity(gear.root_diameter()))),
        Row::new("base_diameter", "base diameter", "d_b", gears.map(|gear| quantity(gear.base_diameter()))),
    ]
}

fn mesh(design: &DriveDesign) -> Vec<Row> {
    let rack = design.gear_set.sun.rack();
    vec![
        Row {
            remark: format!("2·h_a*/sin²α = {}", trimmed(rack.undercut_limit(), 4)),
            ..Row::new(
                "least_teeth_without_undercut",
                "external teeth without undercut, at least",
                "z_min",
                [Figure::Count(rack.least_teeth_without_undercut())],
            )
        },
        Row::new("module", "module", "m", [quantity(design.gear_set.sun.module())]),
        Row::new("face_width", "face width", "b", [quantity(design.gear_set.face_width)]),
        Row::new("centre_distance", "centre distance", "a_w", [quantity(design.gear_set.centre_distance)]),
    ]
}

fn forces(design: &DriveDesign) -> Vec<Row> {
    let forces = &design.forces;
    let nominal = |name, label, nominal: Force, real: Force| Row {
        remark: format!("{:+.1} %", 100.0 * (nominal.si() / real.si() - 1.0)),
        ..Row::new(name, label, "", [quantity(nominal)])
    };
    vec![
        Row::new("sun_mesh", "tangential, at each mesh with the sun", "", [quantity(forces.sun_mesh)]),
        Row::new("ring_mesh", "tangential, at each mesh with the ring", "", [quantity(forces.ring_mesh)]),
        Row::new(
            "pin_tangential",
            "pin, from the carrier's torque",
            "",
            [quantity(forces.planet_bearing_tangential)],
        ),
        Row::new(
            "pin_meshes",
            "pin, radial of both meshes, outwards",
            "",
            [quantity(forces.planet_bearing_meshes)],
        ),
        Row::new("pin_centrifugal", "pin, centrifugal", "", [quantity(forces.planet_bearing_centrifugal)]),
        Row::new("pin", "pin, together", "", [quantity(forces.planet_bearing)]),
        nominal(
            "sun_nominal",
            "nominal, of a tooth of the sun, 2·T₁/(N·d₁)",
            forces.sun_nominal,
            forces.sun_mesh,
        ),
        nominal("ring_nominal", "nominal, of the ring, 2·T₃/(N·d₃)", forces.ring_nominal, forces.ring_mesh),
    ]
}

fn shafts(design: &DriveDesign) -> Vec<Row> {
    let shafts = [design.shafts.sun, design.shafts.planet, design.shafts.carrier];
    let of = |figure: fn(&ShaftDesign) -> Figure| shafts.map(|shaft| figure(&shaft));
    let bearing = |choice: &Choice| {
        choice.bearing.map_or(Figure::None, |bearing| Figure::Text(bearing.designation.to_owned()))
    };
    vec![
        Row::new("torque", "torque", "T", of(|shaft| quantity(shaft.torque))),
        Row::new("needed_diameter", "diameter needed", "", of(|shaft| quantity(shaft.needed))),
        Row::new(
            "standard_diameter",
            "next standard diameter",
            "",
            of(|shaft| quantity(shaft.standard.diameter)),
        ),
        Row::new("standard_bearing", "bearing for it", "", shafts.map(|shaft| bearing(&shaft.standard))),
        Row::new("diameter", "diameter used", "", of(|shaft| quantity(shaft.used.diameter))),
        Row::new("stress", "its torsional stress", "τ", of(|shaft| quantity(shaft.stress))),
        Row::new("bearing", "bearing used", "", shafts.map(|shaft| bearing(&shaft.used))),
        Row::new(
            "bearing_outside_diameter",
            "its outside diameter",
            "D",
            of(|shaft| optional(shaft.used.bearing.map(|bearing| bearing.outside_diameter))),
        ),
        Row::new(
            "bearing_width",
            "its width",
            "B",
            of(|shaft| optional(shaft.used.bearing.map(|bearing| bearing.width))),
        ),
    ]
}

fn masses(design: &DriveDesign) -> Vec<Row> {
    let masses = &design.masses;
    let gears = |figure: fn(&GearMass) -> Figure, carrier: Figure| {
        [figure(&masses.sun), figure(&masses.planet), carrier]
    };
    let carrier = optional(masses.carrier);
    vec![
        Row::new("bore", "bore", "", gears(|gear| quantity(gear.bore), optional::<Length>(None))),
        Row::new("mass", "mass", "m", gears(|gear| quantity(gear.body.total().mass), carrier)),
        Row::new(
            "inertia",
            "inertia about its axis",
            "J",
            gears(|gear| quantity(gear.body.total().polar_inertia), quantity(masses.carrier_inertia)),
        ),
    ]
}

fn equivalent_inertia(design: &DriveDesign) -> Vec<Row> {
    let parts = &design.equivalent_inertia;
    let row = |name, label, symbol, part: MomentOfInertia| Row {
        remark: format!("{:.1} %", 100.0 * part.si() / parts.total.si()),
        ..Row::new(name, label, symbol, [quantity(part)])
    };
    vec![
        row("sun", "sun", "", parts.sun),
        row("motor", "motor", "", parts.motor),
        row("planets_orbiting", "planets, on their orbit", "", parts.planets_orbiting),
        row("planets_turning", "planets, about their axes", "", parts.planets_turning),
        row("carrier", "carrier", "", parts.carrier),
        row("machine", "driven machine", "", parts.machine),
        row("reduced_inertia", "reduced inertia", "J_pr", parts.total),
        Row::new("kinetic_energy", "kinetic energy at full speed", "T", [quantity(parts.kinetic_energy)]),
    ]
}

fn starting_torques(design: &DriveDesign) -> Vec<Row> {
    vec![
        Row::new("driving_torque", "torque on the sun", "M₁", [quantity(design.driving_torque)]),
        Row::new("load", "load on the carrier", "M_H", [quantity(design.load)]),
    ]
}

fn motions(design: &DriveDesign) -> Vec<Row> {
    let motions = [design.without_losses, design.with_losses];
    let of = |figure: fn(&Motion) -> Figure| motions.map(|motion| figure(&motion));
    vec![
        Row::new("held_from", "forward at loads below", "", of(|motion| quantity(motion.held[0]))),
        Row::new("held_to", "backward at loads above", "", of(|motion| quantity(motion.held[1]))),
        Row::new(
            "generalized_force",
            "generalized force",
            "Q",
            of(|motion| quantity(motion.generalized_force)),
        ),
        Row::new("inertia", "inertia felt by the sun", "J", of(|motion| quantity(motion.inertia))),
        Row::new(
            "acceleration_sun",
            "acceleration of the sun",
            "ε₁",
            of(|motion| quantity(motion.accelerations.sun)),
        ),
        Row::new(
            "acceleration_planet",
            "of a planet",
            "ε₂",
            of(|motion| quantity(motion.accelerations.planet)),
        ),
        Row::new(
            "acceleration_carrier",
            "of the carrier",
            "ε_H",
            of(|motion| quantity(motion.accelerations.carrier)),
        ),
        Row::new(
            "outcome",
            "outcome",
            "",
            of(|motion| match motion.start {
                Start::After(_) => Figure::Answer("starts", "starts forward"),
                Start::InBalance => Figure::Answer("in-balance", "in balance: does not start"),
                Start::Held => Figure::Answer("held", "held by mesh friction"),
                Start::Backward(_) => Figure::Answer("runs-backward", "runs backward"),
            }),
        ),
        Row::new(
            "starting_time",
            "time to full speed",
            "t",
            of(|motion| match motion.start {
                Start::After(time) => quantity(time),
                Start::InBalance | Start::Held | Start::Backward(_) => optional::<Time>(None),
            }),
        ),
    ]
}
