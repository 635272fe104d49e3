//! Every key of a scenario.

use super::common::{examples, here, output, text};
use super::keys::{Changes, Key, after, check, key, paths, replaced};
use super::schema;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A gearbox of its own file: that of the example, and then with other teeth.
const BESIDE: Changes = &[("\ngearbox: #", "\ngearbox_file: box.yaml\nno: #")];
const OF_LIST: Changes = &[("\ngearbox: #", "\ngearbox_file: list.yaml\ntransmission: small\nno: #")];

const KEYS: &[Key] = &[
    key("scenario", "scenario: every", "scenario: each"),
    after(BESIDE, "gearbox_file", "gearbox_file: box.yaml", "gearbox_file: other.yaml"),
    after(OF_LIST, "transmission", "transmission: small", "transmission: large"),
    key("efficiency", "efficiency: 97 %", "efficiency: 95 %"),
    key("drags", "drags: true", "drags: false"),
    key("inertias", "fan: 0.3 kg·m²", "fan: 0.4 kg·m²"),
    after(
        &[(
            "planets: 3 }",
            "planets: 3 }\n    - { id: Q, sun: in, ring: sun_2, carrier: out, teeth: [20, 70], planet_teeth: [25] }",
        )],
        "planets.set",
        "set: P",
        "set: Q",
    ),
    key("bodies", "wheel: 3 kg·m²", "wheel: 4 kg·m²"),
    key("planets.count", "count: 3", "count: 4"),
    key("planets.each.inertia", "inertia: 1e-4 kg·m²", "inertia: 2e-3 kg·m²"),
    key("planets.each.mass", "mass: 0.3 kg", "mass: 0.9 kg"),
    key("planets.each.radius", "radius: 45 mm", "radius: 55 mm"),
    after(
        &[(
            "{ id: PTO, links: [out, pto] }",
            "{ id: PTO, links: [out, pto] }\n    - { id: OTP, links: [in, pto] }",
        )],
        "engaged",
        "engaged: [PTO]",
        "engaged: [OTP]",
    ),
    after(&[("to: \"2\"", "to: \"free\"")], "gear", "gear: \"1\"", "gear: \"2\""),
    key("start.input_speed", "input_speed: 1500 rpm", "input_speed: 1400 rpm"),
    key("start.speeds", "fan: 0 rpm", "fan: 20 rpm"),
    key("duration", "duration: 2 s", "duration: 1.9 s"),
    key("sample_every", "sample_every: 20 ms", "sample_every: 25 ms"),
    key("torques.id", "id: auxiliary", "id: pump"),
    key("torques.link", "id: auxiliary, link: in", "id: auxiliary, link: out"),
    key("torques.constant", "constant: -5 N·m", "constant: -6 N·m"),
    key("torques.over_time.times", "times: [0 s, 0.4 s, 0.6 s]", "times: [0 s, 0.3 s, 0.6 s]"),
    key("torques.over_time.torques", "-260 N·m", "-270 N·m"),
    after(
        &[(
            "over_time: { times: [0 s, 0.4 s, 0.6 s], torques: [-200 N·m, -200 N·m, -260 N·m] }",
            "over_time: { csv: grade.csv }",
        )],
        "torques.over_time.csv",
        "grade.csv",
        "steeper.csv",
    ),
    key(
        "torques.over_speed.speeds",
        "speeds: [0 rpm, 1500 rpm, 3000 rpm]",
        "speeds: [0 rpm, 1600 rpm, 3000 rpm]",
    ),
    key("torques.over_speed.torques", "180 N·m, 0 N·m", "190 N·m, 0 N·m"),
    after(
        &[(
            "over_speed: { speeds: [0 rpm, 1500 rpm, 3000 rpm], torques: [150 N·m, 180 N·m, 0 N·m] }",
            "over_speed: { csv: engine.csv }",
        )],
        "torques.over_speed.csv",
        "engine.csv",
        "stronger.csv",
    ),
    key("torques.linear.at_rest", "at_rest: 20 N·m", "at_rest: 25 N·m"),
    key("torques.linear.no_load", "no_load: 2000 rpm", "no_load: 1900 rpm"),
    key("torques.viscous.torque", "viscous: { torque: 2 N·m", "viscous: { torque: 3 N·m"),
    key("torques.viscous.at", "at: 100 rpm", "at: 110 rpm"),
    key("torques.quadratic.torque", "quadratic: { torque: 5 N·m", "quadratic: { torque: 6 N·m"),
    key("torques.quadratic.at", "at: 500 rpm", "at: 510 rpm"),
    key("torques.kloss.peak", "peak: 40 N·m", "peak: 41 N·m"),
    key("torques.kloss.peak_slip", "peak_slip: 0.2", "peak_slip: 0.3"),
    key("torques.kloss.synchronous", "synchronous: 500 rpm", "synchronous: 510 rpm"),
    key("torques.harmonic.mean", "mean: 1 N·m", "mean: 2 N·m"),
    key("torques.harmonic.amplitude", "amplitude: 10 N·m", "amplitude: 11 N·m"),
    key("torques.harmonic.frequency", "frequency: 8 Hz", "frequency: 9 Hz"),
    key("torques.harmonic.phase", "phase: 30 deg", "phase: 40 deg"),
    key("torques.constant_power.power", "power: -0.3 kW", "power: -0.2 kW"),
    key("torques.constant_power.limit", "limit: -5 N·m", "limit: -6 N·m"),
    key(
        "torques.throttle.closed.speeds",
        "closed: { speeds: [0 rpm, 3000 rpm]",
        "closed: { speeds: [0 rpm, 2900 rpm]",
    ),
    key("torques.throttle.closed.torques", "[0 N·m, -10 N·m]", "[0 N·m, -12 N·m]"),
    key(
        "torques.throttle.full.speeds",
        "full: { speeds: [0 rpm, 3000 rpm]",
        "full: { speeds: [0 rpm, 2900 rpm]",
    ),
    key("torques.throttle.full.torques", "[30 N·m, 10 N·m]", "[30 N·m, 12 N·m]"),
    after(
        &[(
            "closed: { speeds: [0 rpm, 3000 rpm], torques: [0 N·m, -10 N·m] }",
            "closed: { csv: engine.csv }",
        )],
        "torques.throttle.closed.csv",
        "engine.csv",
        "stronger.csv",
    ),
    after(
        &[("full: { speeds: [0 rpm, 3000 rpm], torques: [30 N·m, 10 N·m] }", "full: { csv: engine.csv }")],
        "torques.throttle.full.csv",
        "engine.csv",
        "stronger.csv",
    ),
    key("torques.throttle.times", "times: [0 s, 1 s]\n      openings", "times: [0 s, 0.8 s]\n      openings"),
    key("torques.throttle.openings", "openings: [0, 0.8]", "openings: [0, 0.7]"),
    key("torques.resistance", "resistance: 12 N·m", "resistance: 13 N·m"),
    after(
        &[(
            "{ id: W, links: [pto, winch] }",
            "{ id: W, links: [pto, winch] }\n    - { id: X, links: [out, fan] }",
        )],
        "elements.id",
        "id: F\n",
        "id: X\n",
    ),
    key("elements.holding", "holding: 400 N·m", "holding: 420 N·m"),
    key("elements.friction_over_slip.speeds", "speeds: [0 rpm, 300 rpm]", "speeds: [0 rpm, 400 rpm]"),
    key("elements.friction_over_slip.factors", "factors: [1, 0.9]", "factors: [1, 0.8]"),
    key("elements.dog.engage", "engage: [1.2 s]", "engage: [1.6 s]"),
    key("elements.dog.release", "release: [1.8 s]", "release: [1.7 s]"),
    key("elements.dog.largest_slip", "largest_slip: 400 rpm", "largest_slip: 395 rpm"),
    key("elements.capacity.times", "times: [0 s, 1 s]", "times: [0 s, 0.9 s]"),
    key("elements.capacity.torques", "torques: [0 N·m, 30 N·m]", "torques: [0 N·m, 35 N·m]"),
    after(
        &[("capacity: { times: [0 s, 1 s], torques: [0 N·m, 30 N·m] }", "capacity: { csv: capacity.csv }")],
        "elements.capacity.csv",
        "capacity.csv",
        "more.csv",
    ),
    key("elements.pressure.times", "times: [0.1 s, 0.2 s, 0.6 s]", "times: [0.1 s, 0.2 s, 0.7 s]"),
    key("elements.pressure.pressures", "1 bar, 5 bar", "1 bar, 6 bar"),
    after(
        &[
            ("times: [0.1 s, 0.2 s, 0.6 s] # or", "csv: pressure.csv # or"),
            ("      pressures: [4 bar, 1 bar, 5 bar]\n", ""),
        ],
        "elements.pressure.csv",
        "csv: pressure.csv",
        "csv: higher.csv",
    ),
    key("elements.pressure.fill_time", "fill_time: 50 ms", "fill_time: 60 ms"),
    key("elements.pressure.kiss_point", "kiss_point: 0.8 bar", "kiss_point: 0.9 bar"),
    key("elements.pressure.piston_area", "piston_area: 40 cm²", "piston_area: 41 cm²"),
    key("elements.pressure.mean_radius", "mean_radius: 60 mm", "mean_radius: 61 mm"),
    key("elements.pressure.surfaces", "surfaces: 4", "surfaces: 6"),
    key("elements.pressure.coefficient", "coefficient: 0.11", "coefficient: 0.12"),
    key("elements.static_ratio", "static_ratio: 1.2", "static_ratio: 1.3"),
    key("elements.friction_area", "friction_area: 200 cm²", "friction_area: 210 cm²"),
    key("elements.heat_capacity", "heat_capacity: 2 kJ/K", "heat_capacity: 3 kJ/K"),
    key("elements.conductance", "conductance: 30 W/K", "conductance: 3000 W/K"),
    key("shafts.id", "id: axle", "id: half axle"),
    key("shafts.links", "links: [out, wheel]", "links: [wheel, out]"),
    key("shafts.stiffness", "stiffness: 2 kN·m/rad", "stiffness: 2.1 kN·m/rad"),
    key("shafts.damping.torque", "damping: { torque: 6 N·m", "damping: { torque: 7 N·m"),
    key("shafts.damping.at", "at: 10 rpm }", "at: 11 rpm }"),
    key("shafts.backlash", "backlash: 1 deg", "backlash: 0.9 deg"),
    key("shafts.twist", "twist: 0.2 deg", "twist: 0.1 deg"),
    key("converters.id", "id: TC", "id: WTC"),
    key("converters.links", "links: [in, rotor]", "links: [out, rotor]"),
    key("converters.speed_ratios", "[0, 0.6, 0.85, 1]", "[0, 0.6, 0.8, 1]"),
    key("converters.torque_ratios", "[2, 1.3, 1, 1]", "[2, 1.2, 1, 1]"),
    key("converters.impeller_torques", "[20 N·m, 18 N·m,", "[20 N·m, 17 N·m,"),
    key("converters.impeller_speed", "impeller_speed: 1500 rpm", "impeller_speed: 1600 rpm"),
    key("shifts.at", "at: 0.5 s", "at: 0.55 s"),
    key("shifts.to", "to: \"2\"", "to: \"free\""),
    key("shifts.release", "release: 100 ms", "release: 110 ms"),
    key("shifts.apply", "apply: 300 ms", "apply: 310 ms"),
    key("shifts.overlap", "overlap: 150 ms", "overlap: 80 ms"),
    key("thresholds.id", "id: slow", "id: slower"),
    key("thresholds.link", "id: slow, link: in", "id: slow, link: drum"),
    key("thresholds.speed", "speed: 1000 rpm", "speed: 1010 rpm"),
];

/// Writes a scenario and its files into a folder.
fn with_files(folder: &Path, example: &str) {
    let start = example.find("gearbox: #").unwrap();
    let inline = &example[start..example.find("efficiency: 97").unwrap()];
    let own: String =
        inline.lines().skip(1).map(|line| format!("{}\n", line.strip_prefix("  ").unwrap())).collect();
    fs::write(folder.join("box.yaml"), &own).unwrap();
    fs::write(folder.join("other.yaml"), replaced(&own, "[20, 70]", "[22, 72]")).unwrap();
    let listed = |name: &str, ring: u32| {
        format!(
            "- name: {name}\n  sets: [{{ id: P, planet: simple, sun: S, ring: R, carrier: H, z_s: 20, z_r: {ring} }}]\n  \
             links: {{ in: [S], drum: [R], out: [H], pto: [], fan: [], winch: [], tool: [] }}\n  input: in\n  output: out\n  \
             shift_elements: {{ B: [drum, ground], C: [in, out], PTO: [out, pto], F: [pto, fan], W: [pto, winch], T: [pto, tool] }}\n  \
             gears: [{{ name: '1', engaged: [B], published_ratio: 4.5, printed_decimals: 1 }}, {{ name: '2', engaged: [C], published_ratio: 1.0, printed_decimals: 1 }}]\n"
        )
    };
    fs::write(
        folder.join("list.yaml"),
        format!("transmissions:\n{}{}", listed("small", 70), listed("large", 76)),
    )
    .unwrap();
    for (name, table) in [
        ("grade.csv", "s,N·m\n0,-200\n0.4,-200\n0.6,-260\n"),
        ("steeper.csv", "s,N·m\n0,-200\n0.4,-200\n0.6,-280\n"),
        ("engine.csv", "rpm,N·m\n0,150\n1500,180\n3000,0\n"),
        ("stronger.csv", "rpm,N·m\n0,150\n1500,200\n3000,0\n"),
        ("capacity.csv", "ms,N·m\n0,0\n1000,30\n"),
        ("more.csv", "ms,N·m\n0,0\n1000,35\n"),
        ("pressure.csv", "s,bar\n0.1,4\n0.2,1\n0.6,5\n"),
        ("higher.csv", "s,bar\n0.1,4\n0.2,1\n0.6,6\n"),
    ] {
        fs::write(folder.join(name), table).unwrap();
    }
}

/// Results for a scenario, or the reason why it is refused.
fn seen(folder: &Path, file: &str) -> Result<String, String> {
    let file = uncommented(file);
    fs::write(folder.join("scenario.yaml"), file).unwrap();
    let output = output(folder, &["simulate", "scenario.yaml", "--format", "json"]);
    if output.status.success() { Ok(text(&output.stdout)) } else { Err(text(&output.stderr)) }
}

/// The scenario without a part that was put aside as `no: # …` with what is below it.
fn uncommented(file: &str) -> String {
    let mut is_aside = false;
    let mut kept = String::new();
    for line in file.lines() {
        if line.starts_with("no: #") {
            is_aside = true;
        } else if !line.starts_with(' ') {
            is_aside = false;
        }
        if !is_aside && !line.starts_with("no_shifts") {
            kept += line;
            kept.push('\n');
        }
    }
    kept
}

#[test]
fn every_key_of_a_scenario_changes_its_answer() {
    let example = fs::read_to_string(examples().join("every-scenario-key.yaml")).unwrap();
    let folder = here();
    with_files(folder.path(), &example);
    check(&example, KEYS, |file, ()| seen(folder.path(), file));
}

#[test]
fn no_key_of_a_scenario_is_left_out() {
    // The keys of the gearbox are those of its own file.
    let all = schema("scenario").into_iter().filter(|path| !path.starts_with("gearbox."));
    assert_eq!(paths(KEYS), all.collect::<BTreeSet<_>>());
}
