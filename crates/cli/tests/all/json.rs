//! Every answer in JSON is valid by its own schema, and every key of a schema is written by some answer.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests, which clippy does not know for such"
)]

use crate::common;

use boon::{Compiler, Schemas};
use common::{examples, output};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Keys by command.
type Keys = BTreeMap<String, BTreeSet<String>>;

const WHEEL: &str = "0.76 m/s, 1.33 m/s, 1.95 m/s";

/// Sections with commands that together write all of their keys.
const RUNS: &[(&str, &[&str])] = &[
    ("teeth", &["teeth", "--ratio", "6", "--limit", "1"]),
    ("error", &["teeth", "--ratio", "24"]),
    ("error", &["teeth", "--ratio", "6", "--limit", "1", "--save", "no.yaml", "--nth", "999"]),
    ("error", &["analyze", "broken.yaml"]),
    ("select", &["select", "--speeds", WHEEL, "--same-direction"]),
    ("sheet", &["sheet", "every-gearbox-key.yaml"]),
    ("sheet", &["sheet", "bites.yaml"]),
    ("sheet", &["sheet", "wind-stage-helical.yaml"]),
    ("compare", &["compare", "ravigneaux.yaml", "simpson.yaml", "--power", "75 kW", "--speed", "1475 rpm"]),
    ("compare", &["compare", "ravigneaux.yaml", "simpson.yaml", "--torque", "500 N·m"]),
    ("drive", &["drive", "xe215cll-drive.yaml"]),
    ("drive", &["drive", "every-drive-key.yaml"]),
    ("analyze", &["analyze", "real-transmissions.yaml"]),
    ("analyze", &["analyze", "real-transmissions.yaml", "--transmission", "prius"]),
    ("analyze", &["analyze", "real-transmissions.yaml", "--transmission", "8HP", "--gear", "1"]),
    ("analyze", &["analyze", "real-transmissions.yaml", "--transmission", "8HP", "--all-combinations"]),
    ("analyze", &["analyze", "sized-gearbox.yaml", "--power", "75 kW", "--speed", "1475 rpm"]),
    (
        "analyze",
        &["analyze", "sized-gearbox.yaml", "--gear", "slow", "--power", "75 kW", "--speed", "1475 rpm"],
    ),
    ("analyze", &["analyze", "sized-gearbox.yaml", "--torque", "500 N·m"]),
    ("analyze", &["analyze", "ravigneaux.yaml", "--shifts", "--speed", "1475 rpm"]),
    ("analyze", &["analyze", "one-way.yaml", "--shifts"]),
    ("analyze", &["analyze", "real-transmissions.yaml", "--transmission", "prius", "--shifts"]),
    ("analyze", &["analyze", "one-way.yaml"]),
    ("analyze", &["analyze", "power-split.yaml"]),
    ("analyze", &["analyze", "power-split.yaml", "--gear", "drive", "--speed", "2000 rpm"]),
    ("analyze", &["analyze", "power-split.yaml", "--gear", "generator held", "--speeds", "engine=1000 rpm"]),
    ("analyze", &["analyze", "free.yaml"]),
    ("analyze", &["analyze", "redundant.yaml"]),
    ("analyze", &["analyze", "redundant.yaml", "--gear", "slow", "--torque", "500 N·m"]),
    ("analyze", &["analyze", "redundant.yaml", "--all-combinations"]),
    ("analyze", &["analyze", "wolfrom-self-locking.yaml", "--all-combinations"]),
    ("analyze", &["analyze", "wind-stage-helical.yaml", "--torque", "1 MN·m"]),
    ("analyze", &["analyze", "wind-stage-helical.yaml", "--gear", "only", "--torque", "1 MN·m"]),
    ("analyze", &["analyze", "apart.yaml"]),
    ("analyze", &["analyze", "apart.yaml", "--gear", "1"]),
    ("analyze", &["analyze", "free.yaml", "--gear", "free"]),
    (
        "analyze",
        &["analyze", "real-transmissions.yaml", "--transmission", "8HP", "--efficiency", "97 %", "--steps"],
    ),
    ("analyze", &["analyze", "power-split.yaml", "--formula"]),
    ("analyze", &["analyze", "redundant.yaml", "--steps"]),
    ("analyze", &["analyze", "thirteen.yaml", "--formula"]),
    ("analyze", &["analyze", "ravigneaux.yaml", "--gear", "2", "--formula"]),
    ("analyze", &["analyze", "patterns.yaml", "--gear", "slow"]),
    ("analyze", &["analyze", "ravigneaux.yaml"]),
    ("analyze", &["analyze", "ravigneaux.yaml", "--gear", "1"]),
    ("analyze", &["analyze", "wolfrom-self-locking.yaml", "--gear", "back"]),
    ("analyze", &["analyze", "power-split.yaml", "--gear", "drive"]),
    (
        "analyze",
        &[
            "analyze",
            "power-split.yaml",
            "--gear",
            "drive",
            "--map",
            "engine=1000rpm..2000rpm/2, ring=0rpm..500rpm/2",
            "--torques",
            "engine=10 N·m",
        ],
    ),
    ("teeth", &["teeth", "--ratio", "-1.6", "--double-planet", "--limit", "2"]),
    // With few teeth some sets are left out.
    (
        "teeth",
        &["teeth", "--ratio", "4", "--sun", "6..14", "--planet", "6..20", "--ring", "18..60", "--limit", "1"],
    ),
    (
        "teeth",
        &[
            "teeth",
            "--ratio=-1.6",
            "--tolerance=40%",
            "--double-planet",
            "--sun=8..16",
            "--planet=6..12",
            "--ring=20..44",
        ],
    ),
    ("teeth", &["teeth", "--ratio", "5.2", "--ring-offset", "1..3", "--limit", "2"]),
    (
        "strength",
        &["strength", "wind-stage.yaml", "--torque", "1000 kN·m", "--speed", "47.8 rpm", "--factors"],
    ),
    ("strength", &["strength", "wind-stage.yaml", "--power", "9 MW", "--speed", "47.8 rpm"]),
    ("strength", &["strength", "worn.yaml", "--factors"]),
    ("strength", &["strength", "wind-stage-helical.yaml"]),
    ("strength", &["strength", "every-gearbox-key.yaml"]),
    ("strength", &["strength", "sharp.yaml", "--torque", "500 N·m", "--speed", "1000 rpm"]),
    ("report", &["report", "sharp.yaml", "--torque", "500 N·m", "--speed", "1000 rpm"]),
    ("report", &["report", "unplaced.yaml", "--torque", "500 N·m", "--speed", "1000 rpm"]),
    ("strength", &["strength", "unplaced.yaml", "--torque", "500 N·m", "--speed", "1000 rpm"]),
    ("size", &["size", "travel-drive-duty.yaml", "--width-ratio", "1", "--most", "1"]),
    ("size", &["size", "held.yaml", "--most", "1"]),
    ("size", &["size", "many.yaml", "--most", "1", "--modules", "3 mm", "--face-widths", "30 mm"]),
    ("sheet", &["sheet", "unplaced.yaml"]),
    ("size", &["size", "travel-drive-duty.yaml", "--modules", "3 mm", "--face-widths", "20 mm, 30 mm"]),
    ("size", &["size", "weary.yaml", "--no-bearings", "--most", "1"]),
    ("size", &["size", "travel-drive-duty.yaml", "--modules", "1 mm", "--no-bearings"]),
    (
        "design",
        &["design", "--speeds=0.63 m/s, 1.0 m/s, 1.6 m/s", "--power=55 kW", "--input=1480 rpm", "--tries=1"],
    ),
    (
        "design",
        &[
            "design",
            "--speeds=0.63 m/s, 1.0 m/s, 1.6 m/s",
            "--power=55 kW",
            "--input=1480 rpm",
            "--planet-speed=3.1",
            "--modules=2.5 mm",
            "--face-widths=20 mm, 25 mm",
            "--tries=1",
            "--may-reverse",
        ],
    ),
    (
        "design",
        &[
            "design",
            "--ratios=3.9375",
            "--least-efficiency=0.98",
            "--power=75 kW",
            "--input=1475 rpm",
            "--tries=1",
        ],
    ),
    (
        "design",
        &[
            "design",
            "--speeds",
            "0.8 m/s, 3.15 m/s",
            "--circulation=90%",
            "--power",
            "75 kW",
            "--input",
            "1475 rpm",
            "--overload=2",
            "--may-reverse",
            "--tries",
            "2",
        ],
    ),
    (
        "design",
        &[
            "design",
            "--ratios",
            "3.5",
            "--power",
            "75 kW",
            "--input",
            "1475 rpm",
            "--basis",
            "held.yaml",
            "--tries",
            "2",
        ],
    ),
    (
        "design",
        &[
            "design",
            "--ratios",
            "3.5",
            "--power",
            "75 kW",
            "--input",
            "1475 rpm",
            "--basis",
            "weary.yaml",
            "--no-bearings",
            "--tries",
            "2",
        ],
    ),
    (
        "design",
        &[
            "design",
            "--ratios",
            "3.5",
            "--power",
            "75 kW",
            "--input",
            "1475 rpm",
            "--modules=2 mm",
            "--face-widths=10 mm",
            "--overload=2",
            "--tries",
            "2",
        ],
    ),
    (
        "design",
        &[
            "design",
            "--ratios",
            "3.5",
            "--power",
            "75 kW",
            "--input",
            "1475 rpm",
            "--modules=1.5 mm",
            "--face-widths=5 mm",
            "--overload=2",
            "--no-bearings",
            "--tries",
            "2",
        ],
    ),
    ("strength", &["strength", "lacks.yaml", "--torque", "2000 kN·m", "--speed", "47.8 rpm"]),
    ("simulate", &["simulate", "every-scenario-key.yaml"]),
    ("simulate", &["simulate", "short.yaml"]),
    (
        "simulate",
        &["simulate", "every-scenario-key.yaml", "--sweep", "shifts[0].overlap=0ms..150ms", "--steps", "2"],
    ),
    ("report", &["report", "short.yaml"]),
    (
        "simulate",
        &[
            "simulate",
            "every-scenario-key.yaml",
            "--sweep",
            "elements[B].static_ratio=0.9..1.2",
            "--steps",
            "2",
        ],
    ),
    ("report", &["report", "every-scenario-key.yaml"]),
    ("losses", &["losses", "drags.yaml", "--torque", "60 N·m", "--speed", "1475 rpm"]),
    ("losses", &["losses", "drags.yaml", "--power", "9 kW", "--speed", "1475 rpm"]),
    (
        "losses",
        &[
            "losses",
            "drags.yaml",
            "--torque",
            "60 N·m",
            "--speed",
            "1475 rpm",
            "--conductance",
            "12 W/K",
            "--allowed-rise",
            "60 K",
        ],
    ),
    ("losses", &["losses", "drags.yaml", "--load-torque", "150 N·m", "--speed", "1475 rpm"]),
    ("losses", &["losses", "every-gearbox-key.yaml", "--torque", "300 N·m", "--speed", "2000 rpm"]),
    (
        "losses",
        &[
            "losses",
            "drags.yaml",
            "--gear",
            "slow",
            "--speeds",
            "0rpm..3000rpm/2",
            "--torques",
            "5N·m..60N·m/2",
        ],
    ),
    ("losses", &["losses", "II-3", "--k1", "2", "--k2", "2", "--torque", "1 N·m", "--speed", "1 rpm"]),
    (
        "losses",
        &[
            "losses",
            "every-gearbox-key.yaml",
            "--gear",
            "1",
            "--speeds",
            "10rpm..300rpm/2",
            "--torques",
            "5N·m..60N·m/2",
        ],
    ),
    ("vibrate", &["vibrate", "vibration.yaml", "--speeds", "0rpm..6000rpm/3"]),
    (
        "vibrate",
        &[
            "vibrate",
            "vibration.yaml",
            "--speeds",
            "0rpm..6000rpm/3",
            "--transmission-error",
            "3um",
            "--damping",
            "2%",
        ],
    ),
    ("vibrate", &["vibrate", "every-gearbox-key.yaml"]),
    ("vibrate", &["vibrate", "two-stages.yaml", "--coupled"]),
    ("report", &["report", "two-stages.yaml", "--coupled"]),
    ("report", &["report", "wind-stage-helical.yaml", "--torque", "1 MN·m", "--speed", "9.6 rpm"]),
    ("report", &["report", "sun-held.yaml"]),
    ("vibrate", &["vibrate", "sun-held.yaml"]),
    ("compare", &["compare", "ravigneaux.yaml", "real-transmissions.yaml", "--transmission", "8HP"]),
    ("compare", &["compare", "II-3", "scheme-ii-3.yaml", "--ratio1", "1.5", "--ratio2", "2.56"]),
    ("select", &["select", "--speeds", WHEEL, "--power", "75 kW", "--input", "1475 rpm"]),
    ("select", &["select", "--speeds", "0.8 m/s, 3.15 m/s", "--circulation", "0.3"]),
    ("synthesize", &["synthesize", "--ratios", "2.56, 1.465", "--limit", "2"]),
    (
        "synthesize",
        &[
            "synthesize",
            "--ratios=2.56, 1.465",
            "--limit=1",
            "--teeth",
            "--sun=8..14",
            "--planet=6..20",
            "--ring=24..50",
        ],
    ),
    (
        "synthesize",
        &["synthesize", "--ratios", "2.56, 1.465, -2", "--limit", "1", "--shares", "1:30%, 2:70%"],
    ),
    (
        "synthesize",
        &["synthesize", "--ratios", "2.56, 1.465", "--tolerance", "5%", "--sets", "2", "--equal-k", "2"],
    ),
    (
        "synthesize",
        &[
            "synthesize",
            "--ratios",
            "2.56, 1.465",
            "--k",
            "2.2..4",
            "--tolerance",
            "5%",
            "--explain",
            "scheme-ii-3.yaml",
        ],
    ),
    (
        "synthesize",
        &[
            "synthesize",
            "--ratios",
            "2.56, 1.465, 1",
            "--teeth",
            "--ring",
            "60..90",
            "--explain",
            "scheme-ii-3.yaml",
        ],
    ),
    (
        "synthesize",
        &["synthesize", "--ratios", "4, 3", "--explain", "real-transmissions.yaml", "--transmission", "8HP"],
    ),
    (
        "synthesize",
        &[
            "synthesize",
            "--ratios",
            "3.059, 1.625, 1, 0.696, -2.294",
            "--engaged",
            "2",
            "--class",
            "all-sparse",
        ],
    ),
    (
        "synthesize",
        &[
            "synthesize",
            "--ratios",
            "2.56, 1.465",
            "--sets",
            "2",
            "--elements",
            "2",
            "--engaged",
            "1",
            "--double-planets",
            "1",
            "--teeth",
            "--ring",
            "60..90",
        ],
    ),
    ("synthesize", &["synthesize", "--ratios", "6, 1.5", "--sets", "2", "--elements", "2..3"]),
    (
        "synthesize",
        &[
            "synthesize",
            "--ratios",
            "2.7778, -2.2",
            "--sets",
            "2",
            "--elements",
            "2",
            "--engaged",
            "1",
            "--double-planets",
            "1",
            "--all-gearboxes",
        ],
    ),
    (
        "synthesize",
        &[
            "synthesize",
            "--ratios",
            "3.059±0.1%, 1.6..1.7, ?, 0.696, (-2.8)",
            "--sets",
            "2",
            "--elements",
            "5",
            "--engaged",
            "2",
            "--class",
            "all-sparse",
            "--k",
            "2.0615..2.4",
            "--drawable",
        ],
    ),
    (
        "select",
        &[
            "select",
            "--speeds",
            WHEEL,
            "--power",
            "75 kW",
            "--input",
            "1475 rpm",
            "--load-factor",
            "2 MPa",
            "--all-structures",
        ],
    ),
    (
        "select",
        &[
            "select",
            "--ratios",
            "0.6, 0.4",
            "--all-structures",
            "--planet-speed",
            "20",
            "--link-speed",
            "20",
            "--clutch-slip",
            "20",
        ],
    ),
    ("select", &["select", "--ratios", "2.5,1.5", "--same-direction", "--least-efficiency", "0.985"]),
    (
        "select",
        &[
            "select",
            "--ratios=2.56,1.465",
            "--all-structures",
            "--teeth",
            "--ring=..45",
            "--planet-speed=9",
            "--circulation=9",
            "--limit=80",
        ],
    ),
    (
        "select",
        &[
            "select",
            "--ratios=2.5,0.6",
            "--all-structures",
            "--allow-crossing",
            "--teeth",
            "--ring=..60",
            "--tolerance=3%",
            "--planet-speed=9",
            "--link-speed=9",
            "--circulation=9",
            "--clutch-slip=9",
            "--limit=2",
        ],
    ),
    (
        "select",
        &[
            "select",
            "--ratios=0.5,0.7",
            "--all-structures",
            "--teeth",
            "--ring=..60",
            "--tolerance=8%",
            "--planet-speed=99",
            "--link-speed=99",
            "--circulation=99",
            "--clutch-slip=99",
            "--limit=2",
        ],
    ),
    (
        "select",
        &[
            "select",
            "--ratios=3.9375",
            "--teeth",
            "--sun=6..20",
            "--planet=6..12",
            "--ring=12..60",
            "--limit=1",
        ],
    ),
    (
        "select",
        &["select", "--speeds", WHEEL, "--teeth", "--ring", "..60", "--limit", "2", "--circulation", "2"],
    ),
    (
        "select",
        &[
            "select",
            "--ratios",
            "6.1667",
            "--teeth",
            "--ring",
            "..93",
            "--ring-offset",
            "1..3",
            "--limit",
            "2",
        ],
    ),
    (
        "synthesize",
        &[
            "synthesize",
            "--ratios",
            "2.56, 1.465",
            "--sets",
            "2",
            "--teeth",
            "--ring",
            "..110",
            "--ring-offset",
            "1..2",
            "--limit",
            "1",
        ],
    ),
    (
        "select",
        &[
            "select",
            "--speeds",
            WHEEL,
            "--teeth",
            "--ring",
            "..60",
            "--limit",
            "2",
            "--torque",
            "500 N·m",
            "--input",
            "1475 rpm",
            "--load-factor",
            "2 MPa",
            "--ring-diameter",
            "1 m",
            "--least-module",
            "1 mm",
            "--greatest-module",
            "8 mm",
        ],
    ),
    (
        "select",
        &[
            "select",
            "--ratios",
            "3, 0.5",
            "--teeth",
            "--ring",
            "..60",
            "--limit",
            "40",
            "--all-structures",
            "--signs",
            "any",
            "--allow-crossing",
            "--planet-speed",
            "20",
            "--link-speed",
            "20",
            "--clutch-slip",
            "20",
            "--least-efficiency",
            "0",
            "--order",
            "error",
        ],
    ),
    ("schemes", &["schemes", "III-1", "--ratio1", "-2.56", "--ratio2", "-1.465"]),
    ("schemes", &["schemes"]),
    ("schemes", &["schemes", "II-3", "--ratio1", "1.465", "--ratio2", "2.56"]),
    ("machine list", &["machine", "list"]),
    ("machine speeds", &["machine", "speeds", WHEEL]),
    (
        "machine chain-cutter",
        &[
            "machine",
            "chain-cutter",
            "--pick-spacing",
            "40 cm",
            "--feed",
            "5 m/min",
            "--chip",
            "2.5 cm",
            "--force",
            "4 kN",
            "--other-forces",
            "5 kN, 6.5 kN",
        ],
    ),
    (
        "machine drum",
        &[
            "machine",
            "drum",
            "--diameter",
            "1.4 m",
            "--feed",
            "4 m/min",
            "--chip",
            "5 cm",
            "--picks",
            "2",
            "--force",
            "4 kN",
            "--other-forces",
            "5 kN",
        ],
    ),
    (
        "machine rotor",
        &[
            "machine",
            "rotor",
            "--boom-radius",
            "20 m",
            "--slewing",
            "0.02 rad/s",
            "--chip-width",
            "0.3 m",
            "--buckets",
            "8",
            "--boom-angle",
            "60 deg",
            "--wheel-radius",
            "3 m",
            "--release",
            "70 deg",
            "--chute",
            "95 deg, 110 deg",
            "--radius-ratio",
            "0.6",
        ],
    ),
    (
        "motor",
        &[
            "motor",
            "--stator",
            "5",
            "--rotor",
            "3",
            "--z3",
            "55",
            "--zs",
            "10",
            "--module",
            "2 mm",
            "--width",
            "50 mm",
            "--pressure",
            "20 MPa",
            "--speed",
            "60 rpm",
            "--addendum",
            "1",
        ],
    ),
    ("motor", &["motor", "--stator", "4", "--rotor", "3", "--z3", "44", "--zs", "5", "--module", "1 mm"]),
    // Tips without room: the place of the overlap is in the answer.
    (
        "motor",
        &[
            "motor",
            "--stator",
            "5",
            "--rotor",
            "3",
            "--z3",
            "55",
            "--zs",
            "10",
            "--module",
            "2 mm",
            "--clearance",
            "0.02",
        ],
    ),
    ("motor-satellites", &["motor", "--stator", "4", "--rotor", "1", "--z3", "40", "--module", "1 mm"]),
    ("motor-satellites", &["motor", "--stator", "5", "--rotor", "3", "--z3", "55", "--module", "2 mm"]),
    (
        "motor-construction",
        &[
            "motor", "--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", "2 mm", "--l",
            "80 mm", "--a", "31 mm",
        ],
    ),
    ("motor", &["motor", "--stator", "3", "--rotor", "1", "--z3", "108", "--zs", "26", "--module", "1 mm"]),
    (
        "motor",
        &[
            "motor", "--stator", "7", "--rotor", "5", "--z3", "84", "--zs", "11", "--module", "1 mm",
            "--cosine",
        ],
    ),
    (
        "motor",
        &[
            "motor",
            "--stator",
            "8",
            "--rotor",
            "6",
            "--z3",
            "88",
            "--zs",
            "10",
            "--module",
            "2 mm",
            "--cosine",
            "--second-harmonic",
            "0.002",
        ],
    ),
    // A port that is a kidney, and ports that join both pressures.
    (
        "motor",
        &[
            "motor",
            "--stator",
            "6",
            "--rotor",
            "4",
            "--z3",
            "66",
            "--zs",
            "10",
            "--module",
            "2 mm",
            "--l",
            "80 mm",
            "--width",
            "40 mm",
            "--pressure",
            "20 MPa",
            "--speed",
            "100 rpm",
            "--oil",
            "viscosity: 46 mm²/s, density: 870 kg/m³, bulk_modulus: 1.4 GPa",
            "--gaps",
            "satellites: 10 µm",
            "--friction",
            "0.05..0.1",
            "--material",
            "contact_limit: 2000 MPa, root_limit: 400 MPa",
            "--ports",
            "high: { angle: -15 deg, inner_radius: 48 mm, outer_radius: 56 mm, span: 18 deg }, discharge: 0.7, most_trapped: 1 MPa",
        ],
    ),
    (
        "motor",
        &[
            "motor",
            "--stator",
            "6",
            "--rotor",
            "4",
            "--z3",
            "66",
            "--zs",
            "10",
            "--module",
            "2 mm",
            "--l",
            "80 mm",
            "--width",
            "40 mm",
            "--pressure",
            "20 MPa",
            "--oil",
            "bulk_modulus: 1.4 GPa",
            "--ports",
            "part: 0.7, most_trapped: 1 MPa",
            "--friction",
            "0.1",
        ],
    ),
    (
        "motor search",
        &[
            "motor",
            "search",
            "--torque",
            "600 N·m",
            "--pressure",
            "20 MPa",
            "--speed",
            "60 rpm",
            "--module",
            "2 mm",
            "--stator",
            "5",
            "--z3",
            "55",
            "--zs",
            "10",
        ],
    ),
    (
        "motor search",
        &[
            "motor",
            "search",
            "--displacement",
            "250 cm3/rev",
            "--outer-diameter",
            "150 mm",
            "--ripple",
            "10 %",
            "--z3",
            "..66",
            "--zs",
            "2..20",
            "--places",
            "4",
            "--resolution",
            "0.2",
        ],
    ),
    (
        "motor search",
        &[
            "motor",
            "search",
            "--displacement",
            "250 cm3/rev",
            "--module",
            "2 mm",
            "--stator",
            "5",
            "--z3",
            "55",
            "--zs",
            "10",
            "--places",
            "4",
            "--objectives",
            "flank-ripple, least-torque",
        ],
    ),
    (
        "motor search",
        &[
            "motor",
            "search",
            "--displacement",
            "250 cm3/rev",
            "--module",
            "2 mm",
            "--stator",
            "5",
            "--z3",
            "55",
            "--zs",
            "10",
            "--places",
            "4",
            "--pressure-angle",
            "35 deg",
            "--addendum",
            "1.2",
            "--any-teeth",
        ],
    ),
    (
        "motor forms",
        &[
            "motor",
            "forms",
            "--torque",
            "600 N·m",
            "--pressure",
            "20 MPa",
            "--module",
            "2 mm",
            "--stator",
            "6",
            "--z3",
            "66",
            "--zs",
            "10",
            "--families",
            "arcs",
            "--shift",
            "0.1..0.3/3",
        ],
    ),
    (
        "motor forms",
        &[
            "motor",
            "forms",
            "--torque",
            "600 N·m",
            "--pressure",
            "20 MPa",
            "--speed",
            "60 rpm",
            "--module",
            "2 mm",
            "--stator",
            "6",
            "--z3",
            "66",
            "--zs",
            "10",
            "--places",
            "4",
            "--pressure-angle",
            "25 deg",
            "--addendum",
            "0.8",
            "--shift",
            "0.2",
            "--contact-limit",
            "1500 MPa",
            "--root-limit",
            "400 MPa",
        ],
    ),
    ("draw", &["draw", "unplaced.yaml", "--view", "teeth", "-o", "teeth.svg"]),
    ("draw", &["draw", "self-crossing.yaml", "--whole", "--same-side"]),
    ("draw", &["draw", "ravigneaux.yaml", "--gear", "1", "--power", "--to-scale", "-o", "flow.svg"]),
    ("draw", &["draw", "T2.B.T1+D.T1.B", "--k1", "2.5", "--k2", "1.618", "--dxf", "structure.dxf"]),
    ("draw", &["draw", "motor-5x3.yaml", "--view", "teeth"]),
    ("report", &["report", "every-drive-key.yaml"]),
    ("report", &["report", "xe215cll-drive.yaml"]),
    ("report", &["report", "motor-5x3.yaml"]),
    ("report", &["report", "cosine.yaml"]),
    ("report", &["report", "tips.yaml"]),
    ("report", &["report", "ported.yaml"]),
    ("report", &["report", "every-motor-key.yaml"]),
    ("report", &["report", "real-transmissions.yaml", "--transmission", "prius"]),
    ("report", &["report", "real-transmissions.yaml", "--transmission", "8HP"]),
    ("report", &["report", "sized-gearbox.yaml", "--power", "75 kW", "--speed", "1475 rpm"]),
    ("report", &["report", "sized-gearbox.yaml", "--torque", "500 N·m", "--speed", "1475 rpm"]),
    ("report", &["report", "wind-stage.yaml", "--power", "9 MW", "--speed", "47.8 rpm"]),
    ("report", &["report", "drags.yaml", "--torque", "100 N·m", "--speed", "1500 rpm"]),
    ("report", &["report", "every-gearbox-key.yaml", "--torque", "300 N·m", "--speed", "2000 rpm"]),
    ("report", &["report", "worn.yaml"]),
    ("report", &["report", "every-gearbox-key.yaml"]),
    ("report", &["report", "bites.yaml"]),
    ("report", &["report", "lacks.yaml", "--torque", "2000 kN·m", "--speed", "47.8 rpm"]),
    ("report", &["report", "redundant.yaml"]),
    ("report", &["report", "one-way.yaml"]),
    ("report", &["report", "power-split.yaml"]),
    ("report", &["report", "apart.yaml"]),
    ("report", &["report", "patterns.yaml"]),
    ("report", &["report", "ravigneaux.yaml"]),
    ("report", &["report", "wolfrom-self-locking.yaml"]),
    ("report", &["report", "self-crossing.yaml"]),
];

/// A gear that nothing holds, and one whose losses bear themselves out in two ways.
const FREE: &str = "gearbox: free\ninput: D\noutput: B\nsets: [{ id: P, sun: D, ring: T1, carrier: B, k: 3 }]\n\
                    gears: [{ name: free }]\n";
const PATTERNS: &str = "gearbox: slow\ninput: H\noutput: a\ngrounds: [b]\nsets:\n  - { id: P, kind: stepped_rings, \
                        sun: a, ring: b, carrier: H, k: 0.99, efficiency: 97 % }\ngears: [{ name: slow }]\n";

/// A shift towards the smaller ratio in which a one-way clutch takes over.
const ONE_WAY: &str = "gearbox: one-way\ninput: D\noutput: B\nsets: [{ id: P, sun: D, ring: T1, carrier: B, k: 3 }]\nbrakes: [{ \
                       id: K1, link: T1 }]\nclutches: [{ id: F, one_way: [B, D] }]\ngears: [{ name: slow, engaged: [K1] }, { \
                       name: fast, engaged: [F] }]\n";

/// Two sets and two brakes that do the work of one.
const REDUNDANT: &str = "gearbox: redundant\ninput: D\noutput: B\nsets:\n  - { id: P1, sun: D, ring: T1, carrier: B, k: 3 }\n  \
                         - { id: P2, sun: D, ring: T1, carrier: B, k: 3 }\nbrakes:\n  - { id: K1, link: T1 }\n  - { id: \
                         K2, link: T1 }\ngears: [{ name: slow, engaged: [K1, K2] }]\n";
/// Thirteen sets in a row, each with its ring at rest: too many for a formula.
fn thirteen() -> String {
    let set = |place: u32| {
        format!("  - {{ id: P{place}, sun: n{place}, ring: ground, carrier: n{}, k: 3 }}\n", place + 1)
    };
    let sets: String = (1..=13).map(set).collect();
    format!("gearbox: thirteen\ninput: n1\noutput: n14\nsets:\n{sets}gears: [{{ name: only }}]\n")
}

/// Planets whose radii and mesh contradict each other.
const APART: &str = "gearbox: apart\ninput: s\noutput: r\ncompound_sets:\n  - id: set\n    carrier: c\n    suns: { s: 30 }\n    \
                     rings: { r: 72 }\n    planet_gears: { short: [18], long: [18] }\n    planets: 3\n    module: 2 mm\n    \
                     planet_sizes: { short: { carrier_radius: 90 mm }, long: { carrier_radius: 40 mm } }\n    meshes:\n      - { gears: [s, short] }\n      \
                     - { gears: [short, long] }\n      - { gears: [long, r] }\nbrakes: [{ id: K, link: c }]\ngears: [{ \
                     name: \"1\", engaged: [K] }]\n";

/// A motor by the cosine law, and one whose tips have no room, so that the answer has the place of the
/// overlap.
const COSINE: &str = "stator: 7\nrotor: 5\nz3: 84\nzs: 11\nmodule: 1 mm\nlaw: cosine\n";
/// A motor with a kidney at high and a hole at low pressure, and nothing said of its oil.
const PORTED: &str = "stator: 6\nrotor: 4\nz3: 66\nzs: 10\nmodule: 2 mm\nl: 80 mm\nfriction: 0.1\nports:\n  \
                      high: { angle: -15 deg, inner_radius: 48 mm, outer_radius: 56 mm, span: 12 deg }\n  \
                      low: { angle: 15 deg, diameter: 12 mm, pitch_radius: 52 mm }\n";
const TIPS: &str = "stator: 5\nrotor: 3\nz3: 55\nzs: 10\nmodule: 2 mm\nteeth: { clearance: 0.02 }\n";

/// The wind stage with a duty that wears its roots, too.
fn worn() -> String {
    wind_stage().replace("torque: 1000 kN·m", "torque: 2500 kN·m")
}

/// The wind stage with tips of its sun that bite into its planets.
fn bites() -> String {
    wind_stage().replace("tip_alterations: [-0.0833333", "tip_alterations: [0.3")
}

/// The wind stage, and one after it without `K_v`.
fn lacks() -> String {
    let wind = wind_stage();
    let (set, _) = wind.split_once("  - id: stage\n").unwrap().1.split_once("oil:").unwrap();
    let other = set.replace("sun: next", "sun: last").replace("carrier: rotor", "carrier: next");
    let other = other.replace("K_v: 1.061, ", "");
    wind.replace("output: next", "output: last").replace("oil:", &format!("  - id: other\n{other}oil:"))
}

/// The travel drive with its planets and a rim given, loads that wear its teeth, and a set without
/// `strength`.
fn held() -> String {
    let drive = std::fs::read_to_string(examples().join("travel-drive-duty.yaml")).unwrap();
    let drive = drive
        .replace("    planet_teeth: [40]\n", "    planet_teeth: [40]\n    planets: 4\n    module: 4 mm\n");
    let drive = drive.replace("    strength: #", "    strength:\n      planet_rim: 12 mm #");
    let drive = drive.replace("output: track", "output: wheel");
    drive
        .replace("oil:", "  - { id: next, sun: track, ring: ground, carrier: wheel, teeth: [20, 100] }\noil:")
}

/// The travel drive with another set, of more planets than the table of load sharing contains.
fn many() -> String {
    let drive = drive().replace("output: track", "output: wheel");
    let set = &drive[drive.find("  - id: final").unwrap()..drive.find("oil:").unwrap()];
    let second = set.replace("id: final", "id: next").replace("sun: motor", "sun: track");
    let second = second.replace("carrier: track", "carrier: wheel");
    let second = second.replace("planet_teeth: [40]", "planet_teeth: [40]\n    planets: 8");
    drive.replace("oil:", &format!("{second}oil:"))
}

fn drive() -> String {
    std::fs::read_to_string(examples().join("travel-drive-duty.yaml")).unwrap()
}

/// The fan drive with its sun held in one gear and its carrier in another, and a set without `vibration`.
fn members_held() -> String {
    let drive = std::fs::read_to_string(examples().join("vibration.yaml")).unwrap();
    let drive = drive.replace("support: 20 N/µm", "support: 20 N/µm, tangential_support: 50 N/µm");
    let drive = drive.replace("support: 250 N/µm", "support: 250 N/µm, tangential_support: 60 N/µm");
    let drive = drive.replace(", engaged: [K1] }", ", engaged: [K1], input: ring }");
    let held = "brakes:\n  - { id: K3, link: motor }\n  - { id: K4, link: fan }\n";
    let drive = drive.replace("brakes:\n", held);
    let drive = drive.replace(
        "gears:\n",
        "gears:\n  - { name: a, engaged: [K3], input: ring }\n  - { name: b, engaged: [K4], output: ring }\n",
    );
    let other = "  - { id: Q, sun: fan, ring: ground, carrier: after, k: 3 }\nties:";
    drive.replace("ties:", other)
}

fn wind_stage() -> String {
    std::fs::read_to_string(examples().join("wind-stage.yaml")).unwrap()
}

/// Two sets; for the second the file gives no number of planets.
fn unplaced() -> String {
    let set = common::SHARP.lines().skip(4).take(4).collect::<Vec<_>>().join("\n");
    let second = set.replace("id: P, sun: sun", "id: Q, sun: arm").replace("carrier: arm", "carrier: out");
    let second = second.replace("planets: 3, ", "");
    common::SHARP
        .replacen(&set, &format!("{set}\n{second}"), 1)
        .replacen("output: arm", "output: out", 1)
        .replace("shaper: { teeth: 40", "shaper: { teeth: 20")
}

fn folder() -> tempfile::TempDir {
    let folder = common::here();
    for file in std::fs::read_dir(examples()).unwrap() {
        let file = file.unwrap();
        std::fs::copy(file.path(), folder.path().join(file.file_name())).unwrap();
    }
    std::fs::write(folder.path().join("free.yaml"), FREE).unwrap();
    std::fs::write(folder.path().join("worn.yaml"), worn()).unwrap();
    std::fs::write(folder.path().join("sharp.yaml"), common::SHARP).unwrap();
    std::fs::write(folder.path().join("unplaced.yaml"), unplaced()).unwrap();
    std::fs::write(folder.path().join("many.yaml"), many()).unwrap();
    std::fs::write(folder.path().join("bites.yaml"), bites()).unwrap();
    std::fs::write(folder.path().join("lacks.yaml"), lacks()).unwrap();
    std::fs::write(folder.path().join("held.yaml"), held()).unwrap();
    let weary = drive().replace("flank: 1.0, root: 1.4", "flank: 0.4, root: 1.0");
    std::fs::write(folder.path().join("weary.yaml"), weary).unwrap();
    std::fs::write(folder.path().join("broken.yaml"), FREE.replace("k: 3", "k: 0.3")).unwrap();
    std::fs::write(folder.path().join("patterns.yaml"), PATTERNS).unwrap();
    std::fs::write(folder.path().join("one-way.yaml"), ONE_WAY).unwrap();
    std::fs::write(folder.path().join("redundant.yaml"), REDUNDANT).unwrap();
    std::fs::write(folder.path().join("apart.yaml"), APART).unwrap();
    std::fs::write(folder.path().join("sun-held.yaml"), members_held()).unwrap();
    std::fs::write(folder.path().join("thirteen.yaml"), thirteen()).unwrap();
    std::fs::write(folder.path().join("cosine.yaml"), COSINE).unwrap();
    let scenario = std::fs::read_to_string(examples().join("every-scenario-key.yaml")).unwrap();
    // It ends before its shift does.
    let short = scenario.replace("duration: 2 s", "duration: 0.7 s");
    std::fs::write(folder.path().join("short.yaml"), short).unwrap();
    std::fs::write(folder.path().join("tips.yaml"), TIPS).unwrap();
    std::fs::write(folder.path().join("ported.yaml"), PORTED).unwrap();
    folder
}

fn collect(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    match value {
        Value::Object(entries) => {
            entries.iter().for_each(|(key, value)| collect(value, &below(key), found));
        }
        // An empty list gives no information about its entries.
        Value::Array(entries) => match entries.first() {
            None => {}
            Some(Value::Object(_)) => {
                entries.iter().for_each(|entry| collect(entry, &format!("{path}[]"), found));
            }
            Some(_) => _ = found.insert(path.to_owned()),
        },
        _ => _ = found.insert(path.to_owned()),
    }
}

/// The answers of all runs, by section.
fn answers() -> Vec<(&'static str, Value)> {
    let folder = folder();
    let answer = |(section, args): &(&'static str, &[&str])| {
        let done = output(folder.path(), &[args, &["--format", "json"][..]].concat());
        // A refusal is an answer, too.
        let is_refused = *section == "error" && done.status.code() == Some(2);
        assert!(is_refused || matches!(done.status.code(), Some(0 | 1)), "{args:?} {done:?}");
        (*section, serde_json::from_slice(&done.stdout).unwrap())
    };
    RUNS.iter().map(answer).collect()
}

fn written() -> Keys {
    let mut keys = Keys::new();
    for (section, json) in answers() {
        collect(&json, "", keys.entry(section.to_owned()).or_default());
    }
    keys
}

/// Schema of an answer as the program prints it.
fn schema(name: &str) -> Value {
    let done = output(Path::new("."), &["schema", &format!("answer-{name}")]);
    assert!(done.status.success(), "{name}: {done:?}");
    serde_json::from_slice(&done.stdout).unwrap()
}

/// Every key that a schema has, `[]` for the entries of a list and `*` for those of a map.
fn keys_of(schema: &Value, part: &Value, path: &str, found: &mut BTreeSet<String>) {
    if let Some(name) = part.get("$ref").and_then(Value::as_str) {
        let part = schema.pointer(name.strip_prefix('#').unwrap()).unwrap();
        return keys_of(schema, part, path, found);
    }
    for choices in ["anyOf", "oneOf", "allOf"] {
        for choice in part.get(choices).and_then(Value::as_array).into_iter().flatten() {
            keys_of(schema, choice, path, found);
        }
    }
    if let Some(entries) = part.get("items") {
        keys_of(schema, entries, &format!("{path}[]"), found);
    }
    if let Some(entries) = part.get("additionalProperties").filter(|entries| entries.is_object()) {
        keys_of(schema, entries, &format!("{path}.*"), found);
    }
    for (key, inner) in part.get("properties").and_then(Value::as_object).into_iter().flatten() {
        let path = format!("{path}.{key}");
        keys_of(schema, inner, &path, found);
        found.insert(path);
    }
}

/// Every key of an answer that has a value, in the words of [`keys_of`].
fn keys_with_values(schema: &BTreeSet<String>, value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Null => {}
        Value::Object(entries) => {
            for (key, inner) in entries {
                let named = format!("{path}.{key}");
                let path = if schema.contains(&named) { named } else { format!("{path}.*") };
                keys_with_values(schema, inner, &path, found);
            }
            found.insert(path.to_owned());
        }
        Value::Array(entries) => {
            entries.iter().for_each(|entry| keys_with_values(schema, entry, &format!("{path}[]"), found));
            if !entries.is_empty() {
                found.insert(path.to_owned());
            }
        }
        _ => _ = found.insert(path.to_owned()),
    }
}

#[test]
fn every_answer_is_one_by_its_schema_and_every_key_is_written() {
    let mut written: BTreeMap<String, (Value, BTreeSet<String>, BTreeSet<String>)> = BTreeMap::new();
    for (section, json) in answers() {
        let name = json["answer"].as_str().unwrap();
        let (schema, keys, found) = written.entry(name.to_owned()).or_insert_with(|| {
            let (schema, mut keys) = (schema(name), BTreeSet::new());
            keys_of(&schema, &schema, "", &mut keys);
            (schema, keys, BTreeSet::new())
        });
        let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
        compiler.add_resource("answer.json", schema.clone()).unwrap();
        let index = compiler.compile("answer.json", &mut schemas).unwrap();
        if let Err(error) = schemas.validate(&json, index) {
            panic!("{section}: {error:#}");
        }
        keys_with_values(keys, &json, "", found);
    }
    let mut faults = vec![];
    for (name, (_, keys, found)) in &written {
        // What these answer has all that the checks need, and keeps them.
        let is_whole = |key: &str| {
            let mut never = ["tooth_checks.not_checked", "checks[].message", "checks[].remedy"].into_iter();
            (name.starts_with("teeth") || name == "size") && never.any(|of| key.contains(of))
        };
        let missing: Vec<&String> = keys.difference(found).filter(|key| !is_whole(key)).collect();
        if !missing.is_empty() {
            faults.push(format!("{name}: no run here gives a value to {missing:?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The book names every warning that is met here.
#[test]
fn the_names_of_warnings_stand_in_the_book() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/reference/json.md");
    let page = std::fs::read_to_string(page).unwrap();
    let names: BTreeSet<String> = answers()
        .iter()
        .flat_map(|(_, json)| json["warnings"].as_array().into_iter().flatten())
        .map(|warning| warning["name"].as_str().unwrap().to_owned())
        .collect();
    assert!(names.len() > 8, "{names:?}");
    for name in names {
        assert!(page.contains(&format!("`{name}`")), "{name}");
    }
}

/// Standard output always has exactly one object.
#[test]
fn there_is_always_one_object() {
    let folder = folder();
    for (args, code, name) in [
        (&["teeth", "--ratio", "24"][..], 1, "no-tooth-numbers"),
        (&["teeth", "--ratio", "6", "--planets", "9"], 2, "planet-number"),
        (
            &["synthesize", "--ratios", "2.56, 1.465", "--sets", "1", "--elements", "2", "--engaged", "1"],
            1,
            "nothing-found",
        ),
        (
            &[
                "motor",
                "search",
                "--torque",
                "600 N·m",
                "--pressure",
                "20 MPa",
                "--stator",
                "5..6",
                "--z3",
                "55..66",
                "--outer-diameter",
                "10 mm",
            ],
            1,
            "no-motor",
        ),
        (&["analyze", "missing.yaml"], 3, "cannot-be-read"),
        (&["analyze", "ravigneaux.yaml", "--gear", "9"], 2, "no-gear"),
    ] {
        let done = output(folder.path(), &[args, &["--format", "json"]].concat());
        assert_eq!(done.status.code(), Some(code), "{args:?} {done:?}");
        let json: Value =
            serde_json::from_slice(&done.stdout).unwrap_or_else(|error| panic!("{args:?}: {error}"));
        if json["answer"] == "error" {
            assert_eq!((json["name"].as_str(), json["exit_code"].as_i64()), (Some(name), Some(code.into())));
        }
        let text = String::from_utf8(done.stderr).unwrap();
        assert!(text.contains("error: "), "{text}");
    }
    let to_file = output(folder.path(), &["teeth", "--ratio", "24", "-o", "no.json"]);
    assert!(to_file.stdout.is_empty() && !folder.path().join("no.json").exists());
}

/// Quantities have their unit in the key, and no key occurs both with and without a unit.
#[test]
fn a_key_keeps_its_unit_where_there_is_no_value() {
    const UNITS: [&str; 12] =
        ["_m_s", "_rad_s2", "_rad_s", "_rad", "_kg_m2", "_kg", "_n_m", "_n", "_w", "_pa", "_j", "_m"];
    for (section, keys) in written() {
        for key in &keys {
            let bare = UNITS.iter().find_map(|unit| key.strip_suffix(unit));
            assert!(!bare.is_some_and(|bare| keys.contains(bare)), "{section}: {key}");
        }
    }
}
