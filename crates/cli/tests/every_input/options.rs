//! Every option of every command, by the program's own list of them.

use super::common::{examples, output, text};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// An option, a command line where it matters, and what is added to it.
type Tried = (&'static str, &'static [&'static str], &'static [&'static str]);

const RATIO: &[&str] = &["--ratio", "6", "--format", "json"];
const SELECT: &[&str] = &["--ratios", "1.465, 2.56", "--format", "json"];
const SIZED: &[&str] =
    &["--ratios", "2.5", "--torque", "500 N·m", "--load-factor", "2 MPa", "--format", "json"];
const TEETH: &[&str] = &[
    "--ratios",
    "1.465, 2.56",
    "--teeth",
    "--ring",
    "50..60",
    "--sun",
    "18..30",
    "--planet",
    "..24",
    "--limit",
    "2",
    "--format",
    "json",
];
const SIZED_TEETH: &[&str] = &[
    "--ratios",
    "1.465, 2.56",
    "--teeth",
    "--ring",
    "50..60",
    "--sun",
    "18..30",
    "--planet",
    "..24",
    "--limit",
    "2",
    "--torque",
    "500 N·m",
    "--load-factor",
    "2 MPa",
    "--format",
    "json",
];
const BOX: &[&str] = &["every-gearbox-key.yaml", "--format", "json"];
const FIRST: &[&str] = &["every-gearbox-key.yaml", "--gear", "1", "--format", "json"];
const SPLIT: &[&str] = &["power-split.yaml", "--gear", "drive", "--format", "json"];
const SPEEDS: &[&str] = &[
    "power-split.yaml",
    "--gear",
    "drive",
    "--speeds",
    "engine=2000rpm, generator=1000rpm",
    "--format",
    "json",
];
const SCHEME: &[&str] = &["II-3", "--k1", "2.15", "--k2", "2.35", "--format", "json"];
const CHAIN: &[&str] =
    &["--pick-spacing", "20 cm", "--feed", "4 m/min", "--chip", "2 cm", "--format", "json"];
const CHAIN_FORCES: &[&str] = &[
    "--pick-spacing",
    "20 cm",
    "--feed",
    "4 m/min",
    "--chip",
    "2 cm",
    "--force",
    "4 kN",
    "--other-forces",
    "5 kN, 6.5 kN",
    "--format",
    "json",
];
const DRUM: &[&str] =
    &["--diameter", "1 m", "--feed", "4 m/min", "--chip", "2 cm", "--picks", "2", "--format", "json"];
const DRUM_FORCES: &[&str] = &[
    "--diameter",
    "1 m",
    "--feed",
    "4 m/min",
    "--chip",
    "2 cm",
    "--picks",
    "2",
    "--force",
    "4 kN",
    "--other-forces",
    "5 kN, 6.5 kN",
    "--format",
    "json",
];
const ROTOR: &[&str] = &[
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
    "--discharge",
    "0.3",
    "--format",
    "json",
];
const CHUTE: &[&str] = &[
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
    "--format",
    "json",
];
const MOTOR: &[&str] =
    &["--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", "2 mm", "--format", "json"];
const COSINE: &[&str] = &["--stator", "7", "--rotor", "5", "--z3", "84", "--zs", "11", "--module", "1 mm"];
const WIDE: &[&str] = &[
    "--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", "2 mm", "--width", "50 mm",
    "--format", "json",
];
const DRAWN: &[&str] = &[
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
    "--svg",
    "motor.svg",
    "--csv",
    "motor.csv",
];
const SEARCH: &[&str] = &[
    "--displacement",
    "250 cm3/rev",
    "--stator",
    "5",
    "--rotor",
    "3",
    "--z3",
    "55",
    "--zs",
    "9..10",
    "--module",
    "2 mm",
    "--places",
    "4",
    "--format",
    "json",
];
const WIDTH: &[&str] = &[
    "--displacement",
    "250 cm3/rev",
    "--stator",
    "5",
    "--rotor",
    "3",
    "--z3",
    "55",
    "--zs",
    "9..10",
    "--module",
    "2 mm, 2.5 mm",
    "--width",
    "40 mm",
    "--tolerance",
    "10 %",
    "--places",
    "4",
    "--format",
    "json",
];
const SOUGHT: &[&str] = &[
    "--displacement",
    "250 cm3/rev",
    "--stator",
    "5",
    "--rotor",
    "3",
    "--z3",
    "55",
    "--zs",
    "9..10",
    "--module",
    "2 mm",
    "--places",
    "4",
    "--svg",
    "motor.svg",
    "--csv",
    "motor.csv",
];
const TORQUE: &[&str] = &[
    "--torque",
    "600 N·m",
    "--pressure",
    "20 MPa",
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
    "--places",
    "4",
    "--format",
    "json",
];
const FLOW: &[&str] = &["II-3", "--ratio1", "1.465", "--ratio2", "2.56", "--gear", "2", "--power"];

/// Options of a command with the lines that show what each does. What is added to a line takes the place of what it has
/// of the same option.
const COMMANDS: &[(&str, &[Tried])] = &[
    (
        "teeth",
        &[
            ("--ratio", RATIO, &["--ratio", "5"]),
            ("--mode", RATIO, &["--mode", "Ha^b"]),
            ("--tolerance", RATIO, &["--tolerance", "2%"]),
            ("--planets", RATIO, &["--planets", "4"]),
            ("--sun", RATIO, &["--sun", "20.."]),
            ("--planet", RATIO, &["--planet", "40.."]),
            ("--ring", RATIO, &["--ring", "..100"]),
            ("--k", RATIO, &["--k", "5..5"]),
            ("--spacing", RATIO, &["--spacing", "least-unequal"]),
            ("--tip-gap", RATIO, &["--tip-gap", "1"]),
            ("--addendum", RATIO, &["--addendum", "0.8"]),
            ("--pressure-angle", RATIO, &["--pressure-angle", "14.5deg"]),
            ("--pressure-angle", &["--ratio", "6", "--no-undercut"], &["--pressure-angle", "25deg"]),
            ("--no-undercut", RATIO, &["--no-undercut"]),
            ("--limit", RATIO, &["--limit", "3"]),
            ("--format", RATIO, &["--format", "csv"]),
            ("--output", RATIO, &["--output", "sets.json"]),
        ],
    ),
    (
        "drive",
        &[
            ("--format", &["minimal-drive.yaml"], &["--format", "csv"]),
            ("--output", &["minimal-drive.yaml"], &["--output", "drive.txt"]),
        ],
    ),
    (
        "analyze",
        &[
            ("--transmission", &["real-transmissions.yaml"], &["--transmission", "8HP"]),
            ("--efficiency", &["real-transmissions.yaml", "--transmission", "8HP"], &["--efficiency", "97%"]),
            ("--gear", BOX, &["--gear", "1"]),
            ("--all-combinations", BOX, &["--all-combinations"]),
            ("--speeds", SPLIT, &["--speeds", "engine=2000rpm, generator=1000rpm"]),
            ("--torques", SPLIT, &["--torques", "engine=50 N·m"]),
            ("--torques", SPEEDS, &["--torques", "engine=50 N·m"]),
            (
                "--torques",
                &[
                    "power-split.yaml",
                    "--gear",
                    "drive",
                    "--map",
                    "engine=800rpm..4000rpm/3, generator=0rpm..5000rpm/2",
                ],
                &["--torques", "engine=50 N·m"],
            ),
            ("--map", SPLIT, &["--map", "engine=800rpm..4000rpm/3, generator=0rpm..5000rpm/2"]),
            ("--torque", FIRST, &["--torque", "500 N·m"]),
            ("--torque", BOX, &["--torque", "500 N·m"]),
            (
                "--power",
                &["every-gearbox-key.yaml", "--gear", "1", "--speed", "1475 rpm"],
                &["--power", "75 kW"],
            ),
            ("--power", &["every-gearbox-key.yaml", "--speed", "1475 rpm"], &["--power", "75 kW"]),
            ("--speed", FIRST, &["--speed", "1475 rpm"]),
            ("--speed", BOX, &["--speed", "1475 rpm"]),
            ("--input", FIRST, &["--input", "1475 rpm"]),
            ("--format", FIRST, &["--format", "csv"]),
            ("--output", FIRST, &["--output", "box.json"]),
        ],
    ),
    (
        "select",
        &[
            ("--speeds", &["--speeds", "0.8 m/s, 3.15 m/s"], &["--speeds", "1 m/s, 3.15 m/s"]),
            ("--ratios", SELECT, &["--ratios", "1.5, 2.56"]),
            ("--all-structures", SELECT, &["--all-structures"]),
            ("--teeth", &["--ratios", "1.465, 2.56"], &["--teeth", "--ring", "50..60", "--limit", "2"]),
            ("--limit", SELECT, &["--limit", "1"]),
            ("--order", &["--ratios", "1.465, 2.56", "--all-structures"], &["--order", "size"]),
            ("--tolerance", SELECT, &["--tolerance", "1%"]),
            ("--brakes", SELECT, &["--brakes", "as-given"]),
            ("--signs", SELECT, &["--signs", "any"]),
            ("--k", SELECT, &["--k", "1.7..4"]),
            ("--prefer", SELECT, &["--prefer", "2..3"]),
            ("--efficiency", SELECT, &["--efficiency", "95%"]),
            ("--least-efficiency", SELECT, &["--least-efficiency", "95%"]),
            ("--link-speed", SELECT, &["--link-speed", "1.5"]),
            ("--planet-speed", SELECT, &["--planet-speed", "1.5"]),
            ("--clutch-slip", SELECT, &["--clutch-slip", "1.5"]),
            ("--same-direction", SELECT, &["--same-direction"]),
            ("--allow-crossing", SELECT, &["--allow-crossing"]),
            ("--input", SELECT, &["--input", "1475 rpm"]),
            ("--power", &["--ratios", "2.5", "--input", "1475 rpm"], &["--power", "75 kW"]),
            ("--torque", SELECT, &["--torque", "500 N·m"]),
            ("--load-factor", &["--ratios", "2.5", "--torque", "500 N·m"], &["--load-factor", "2 MPa"]),
            ("--face-width-ratio", SIZED, &["--face-width-ratio", "0.5"]),
            ("--planets", SELECT, &["--planets", "4"]),
            ("--mesh-load-factors", SELECT, &["--mesh-load-factors", "1, 1.1, 1.1, 1.2, 1.2, 1.3, 1.4"]),
            ("--ring-diameter", SIZED_TEETH, &["--ring-diameter", "50 mm"]),
            ("--least-module", SIZED_TEETH, &["--least-module", "4 mm"]),
            ("--greatest-module", SIZED_TEETH, &["--greatest-module", "1 mm"]),
            ("--sun", TEETH, &["--sun", "26..30"]),
            ("--planet", TEETH, &["--planet", "18"]),
            ("--ring", TEETH, &["--ring", "57..60"]),
            ("--planet-count", TEETH, &["--planet-count", "4"]),
            ("--format", SELECT, &["--format", "csv"]),
            ("--output", SELECT, &["--output", "select.json"]),
        ],
    ),
    (
        "schemes",
        &[
            ("--k1", SCHEME, &["--k1", "2"]),
            ("--k2", SCHEME, &["--k2", "2"]),
            ("--ratio1", &["II-3", "--ratio1", "1.465", "--ratio2", "2.56"], &["--ratio1", "1.5"]),
            ("--ratio2", &["II-3", "--ratio1", "1.465", "--ratio2", "2.56"], &["--ratio2", "2.5"]),
            ("--efficiency", SCHEME, &["--efficiency", "95%"]),
            ("--k", &[], &["--k", "2..3"]),
            ("--k", &["II-3"], &["--k", "2..3"]),
            ("--k", SCHEME, &["--k", "2..3"]),
            ("--format", SCHEME, &["--format", "csv"]),
            ("--output", SCHEME, &["--output", "scheme.json"]),
        ],
    ),
    (
        "machine list",
        &[("--format", &[], &["--format", "csv"]), ("--output", &[], &["--output", "list.txt"])],
    ),
    (
        "machine speeds",
        &[
            ("--format", &["0.8 m/s, 3.15 m/s"], &["--format", "csv"]),
            ("--output", &["0.8 m/s, 3.15 m/s"], &["--output", "speeds.txt"]),
        ],
    ),
    (
        "machine chain-cutter",
        &[
            ("--pick-spacing", CHAIN, &["--pick-spacing", "25 cm"]),
            ("--feed", CHAIN, &["--feed", "5 m/min"]),
            ("--chip", CHAIN, &["--chip", "3 cm"]),
            ("--force", CHAIN_FORCES, &["--force", "4.5 kN"]),
            ("--other-forces", CHAIN_FORCES, &["--other-forces", "5 kN"]),
            ("--format", CHAIN, &["--format", "csv"]),
            ("--output", CHAIN, &["--output", "chain.json"]),
        ],
    ),
    (
        "machine drum",
        &[
            ("--diameter", DRUM, &["--diameter", "1.2 m"]),
            ("--feed", DRUM, &["--feed", "5 m/min"]),
            ("--chip", DRUM, &["--chip", "3 cm"]),
            ("--picks", DRUM, &["--picks", "3"]),
            ("--force", DRUM_FORCES, &["--force", "4.5 kN"]),
            ("--other-forces", DRUM_FORCES, &["--other-forces", "5 kN"]),
            ("--format", DRUM, &["--format", "csv"]),
            ("--output", DRUM, &["--output", "drum.json"]),
        ],
    ),
    (
        "machine rotor",
        &[
            ("--boom-radius", ROTOR, &["--boom-radius", "21 m"]),
            ("--slewing", ROTOR, &["--slewing", "0.03 rad/s"]),
            ("--chip-width", ROTOR, &["--chip-width", "0.4 m"]),
            ("--buckets", ROTOR, &["--buckets", "9"]),
            ("--boom-angle", ROTOR, &["--boom-angle", "50 deg"]),
            ("--wheel-radius", ROTOR, &["--wheel-radius", "4 m"]),
            ("--discharge", ROTOR, &["--discharge", "0.4"]),
            ("--release", CHUTE, &["--release", "60 deg"]),
            ("--chute", CHUTE, &["--chute", "95 deg, 105 deg"]),
            ("--radius-ratio", CHUTE, &["--radius-ratio", "0.7"]),
            ("--format", ROTOR, &["--format", "csv"]),
            ("--output", ROTOR, &["--output", "rotor.json"]),
        ],
    ),
    (
        "motor",
        &[
            (
                "--stator",
                &["--stator", "5", "--rotor", "3", "--z3", "60", "--zs", "10", "--module", "2 mm"],
                &["--stator", "6"],
            ),
            ("--rotor", MOTOR, &["--rotor", "2"]),
            ("--z3", MOTOR, &["--z3", "60"]),
            ("--z1", MOTOR, &["--z1", "30"]),
            ("--zs", MOTOR, &["--zs", "9"]),
            ("--module", MOTOR, &["--module", "2.5 mm"]),
            ("--l", MOTOR, &["--l", "80 mm"]),
            ("--a", MOTOR, &["--a", "30 mm"]),
            ("--part", MOTOR, &["--part", "0.4"]),
            ("--cosine", COSINE, &["--cosine"]),
            ("--width", MOTOR, &["--width", "50 mm"]),
            ("--pressure", WIDE, &["--pressure", "20 MPa"]),
            ("--speed", WIDE, &["--speed", "60 rpm"]),
            ("--angle", MOTOR, &["--angle", "20 deg"]),
            ("--angle", DRAWN, &["--angle", "20 deg"]),
            ("--pressure-angle", MOTOR, &["--pressure-angle", "20 deg"]),
            ("--addendum", MOTOR, &["--addendum", "0.8"]),
            ("--clearance", MOTOR, &["--clearance", "0.2"]),
            ("--shift", MOTOR, &["--shift", "0.1"]),
            ("--backlash", MOTOR, &["--backlash", "0.05"]),
            ("--fillet", MOTOR, &["--fillet", "0.12"]),
            ("--view", DRAWN, &["--view", "teeth"]),
            ("--svg", MOTOR, &["--svg", "motor.svg"]),
            ("--dxf", MOTOR, &["--dxf", "motor.dxf"]),
            ("--csv", MOTOR, &["--csv", "motor.csv"]),
            ("--points", DRAWN, &["--points", "50"]),
            ("--format", MOTOR, &["--format", "csv"]),
            ("--output", MOTOR, &["--output", "motor.json"]),
        ],
    ),
    (
        "motor search",
        &[
            ("--displacement", SEARCH, &["--displacement", "200 cm3/rev"]),
            ("--torque", TORQUE, &["--torque", "500 N·m"]),
            ("--pressure", TORQUE, &["--pressure", "15 MPa"]),
            ("--pressure", SEARCH, &["--pressure", "15 MPa"]),
            ("--speed", SEARCH, &["--speed", "60 rpm"]),
            ("--module", SEARCH, &["--module", "2.5 mm"]),
            (
                "--width",
                &[
                    "--displacement",
                    "250 cm3/rev",
                    "--stator",
                    "5",
                    "--rotor",
                    "3",
                    "--z3",
                    "55",
                    "--zs",
                    "10",
                    "--places",
                    "4",
                ],
                &["--width", "40 mm"],
            ),
            ("--tolerance", WIDTH, &["--tolerance", "0.1 %"]),
            (
                "--width-over-diameter",
                &[
                    "--displacement",
                    "250 cm3/rev",
                    "--stator",
                    "5",
                    "--rotor",
                    "3",
                    "--z3",
                    "55",
                    "--zs",
                    "10",
                    "--places",
                    "4",
                ],
                &["--width-over-diameter", "0.4"],
            ),
            ("--outer-diameter", SEARCH, &["--outer-diameter", "100 mm"]),
            ("--ripple", SEARCH, &["--ripple", "5 %"]),
            ("--stator", SEARCH, &["--stator", "6"]),
            ("--rotor", SEARCH, &["--rotor", "4"]),
            ("--z3", SEARCH, &["--z3", "50..55"]),
            ("--zs", SEARCH, &["--zs", "10"]),
            ("--divisor", SEARCH, &["--divisor", "common"]),
            ("--with-teeth", SEARCH, &["--with-teeth"]),
            ("--by", SEARCH, &["--by", "ripple"]),
            ("--places", SEARCH, &["--places", "6"]),
            ("--resolution", SEARCH, &["--resolution", "20 %"]),
            (
                "--every",
                &[
                    "--displacement",
                    "250 cm3/rev",
                    "--stator",
                    "5",
                    "--rotor",
                    "3",
                    "--z3",
                    "55",
                    "--zs",
                    "9..10",
                    "--places",
                    "4",
                ],
                &["--every"],
            ),
            ("--limit", SEARCH, &["--limit", "1"]),
            ("--design", SOUGHT, &["--design", "2"]),
            ("--angle", SOUGHT, &["--angle", "20 deg"]),
            ("--view", SOUGHT, &["--view", "centrodes"]),
            ("--svg", SEARCH, &["--svg", "motor.svg"]),
            ("--dxf", SEARCH, &["--dxf", "motor.dxf"]),
            ("--csv", SEARCH, &["--csv", "motor.csv"]),
            ("--points", SOUGHT, &["--points", "50"]),
            ("--format", SEARCH, &["--format", "csv"]),
            ("--output", SEARCH, &["--output", "motors.json"]),
        ],
    ),
    (
        "draw",
        &[
            ("--view", &["sized-gearbox.yaml"], &["--view", "ladder"]),
            ("--transmission", &["real-transmissions.yaml"], &["--transmission", "8HP"]),
            ("--gear", &["II-3", "--k1", "2.15", "--k2", "2.35"], &["--gear", "2"]),
            ("--power", &["II-3", "--k1", "2.15", "--k2", "2.35", "--gear", "2"], &["--power"]),
            ("--whole", &["II-3"], &["--whole"]),
            ("--same-side", &["II-3"], &["--same-side"]),
            ("--k1", &["II-3", "--k1", "2.15", "--k2", "2.35"], &["--k1", "2.5"]),
            ("--k2", &["II-3", "--k1", "2.15", "--k2", "2.35"], &["--k2", "2.5"]),
            ("--ratio1", FLOW, &["--ratio1", "1.5"]),
            ("--ratio2", FLOW, &["--ratio2", "2.5"]),
            ("--efficiency", FLOW, &["--efficiency", "90%"]),
            ("--title", &["II-3"], &["--title", "another"]),
            ("--output", &["II-3"], &["--output", "drawing.svg"]),
            ("--output", &["II-3"], &["--output", "drawing.dxf"]),
            ("--svg", &["II-3"], &["--svg", "drawing.svg"]),
            ("--dxf", &["II-3"], &["--dxf", "drawing.dxf"]),
            ("--format", &["II-3"], &["--format", "json"]),
        ],
    ),
    (
        "report",
        &[
            ("--transmission", &["real-transmissions.yaml"], &["--transmission", "TH400"]),
            (
                "--efficiency",
                &["real-transmissions.yaml", "--transmission", "TH400"],
                &["--efficiency", "97%"],
            ),
            ("--torque", &["scheme-ii-3.yaml"], &["--torque", "500 N·m"]),
            ("--power", &["scheme-ii-3.yaml", "--speed", "1475 rpm"], &["--power", "75 kW"]),
            ("--speed", &["scheme-ii-3.yaml"], &["--speed", "1475 rpm"]),
            ("--input", &["scheme-ii-3.yaml"], &["--input", "1475 rpm"]),
            ("--output", &["minimal-drive.yaml"], &["--output", "page.html"]),
            ("--format", &["minimal-drive.yaml"], &["--format", "json"]),
        ],
    ),
    ("schema", &[("--output", &["drive"], &["--output", "drive.json"])]),
    ("completions", &[("--output", &["bash"], &["--output", "here.bash"])]),
    ("man", &[("--output", &[], &["--output", "here.1"])]),
];

/// Options that change nothing where they stand, and what has to be written instead.
const REFUSED: &[(&str, &[&str], &str)] = &[
    ("analyze", &["real-transmissions.yaml", "--speed", "100 rpm"], "add --transmission"),
    ("analyze", &["real-transmissions.yaml", "--efficiency", "97%"], "add --transmission"),
    ("select", &["--ratios", "2.5", "--sun", "20"], "--teeth"),
    ("select", &["--ratios", "2.5", "--planet-count", "4"], "--teeth"),
    ("select", &["--ratios", "2.5", "--face-width-ratio", "0.5"], "--load-factor"),
    ("schemes", &["--efficiency", "90%"], "--k1"),
    ("schemes", &["II-3", "--efficiency", "90%"], "--k1"),
    (
        "motor",
        &["--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", "2 mm", "--view", "teeth"],
        "--svg",
    ),
    (
        "motor",
        &["--stator", "5", "--rotor", "3", "--z3", "55", "--zs", "10", "--module", "2 mm", "--points", "5"],
        "--csv",
    ),
    ("motor search", &["--displacement", "250 cm3/rev", "--z3", "55", "--view", "teeth"], "--svg"),
    (
        "motor search",
        &["--displacement", "250 cm3/rev", "--z3", "55", "--csv", "a.csv", "--angle", "5 deg"],
        "--svg",
    ),
    ("motor search", &["--displacement", "250 cm3/rev", "--z3", "55", "--design", "2"], "--csv"),
    (
        "motor search",
        &["--displacement", "250 cm3/rev", "--z3", "55", "--module", "2 mm", "--tolerance", "5%"],
        "--width",
    ),
    ("draw", &["sized-gearbox.yaml", "--efficiency", "97%"], "--power"),
];

/// What a call leaves: its exit code, its answer, the files it wrote.
type Left = (Option<i32>, String, BTreeMap<String, Vec<u8>>);

fn left(command: &str, args: &[&str]) -> (Left, String) {
    let folder = tempfile::tempdir().unwrap();
    for name in args.iter().filter(|arg| arg.ends_with(".yaml")) {
        fs::copy(examples().join(name), folder.path().join(name)).unwrap();
    }
    let line: Vec<&str> = command.split(' ').chain(args.iter().copied()).collect();
    let done = output(folder.path(), &line);
    let read = |path: &Path| fs::read(path).unwrap();
    let files = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().path());
    let files =
        files.map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), read(&path))).collect();
    ((done.status.code(), text(&done.stdout), files), text(&done.stderr))
}

/// A line with other options in place of its own.
fn with<'a>(line: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    let mut all = vec![];
    let mut words = line.iter();
    while let Some(word) = words.next() {
        if word.starts_with("--") && more.contains(word) {
            words.next();
        } else {
            all.push(*word);
        }
    }
    all.extend(more);
    all
}

/// The options of each command, as completions know them.
fn all_options() -> BTreeMap<String, BTreeSet<String>> {
    let (left, _) = left("completions", &["bash"]);
    let lines: Vec<&str> = left.1.lines().map(str::trim).collect();
    let mut all = BTreeMap::new();
    for pair in lines.windows(2) {
        let Some(path) = pair[0].strip_prefix("epicyclic__subcmd__").and_then(|path| path.strip_suffix(')'))
        else {
            continue;
        };
        let Some(opts) = pair[1].strip_prefix("opts=\"") else { continue };
        let options: BTreeSet<String> = opts
            .trim_end_matches('"')
            .split(' ')
            .filter(|word| word.starts_with("--") && *word != "--help")
            .map(str::to_owned)
            .collect();
        // A hyphen in a name is written as a level of its own.
        let name = path.replace("chain__subcmd__cutter", "chain-cutter").replace("__subcmd__", " ");
        if !options.is_empty() {
            all.insert(name, options);
        }
    }
    all
}

fn check(commands: &[&str]) {
    let mut faults = vec![];
    for (command, tried) in COMMANDS.iter().filter(|(command, _)| commands.contains(command)) {
        // Nothing found is an answer too; `--z1` is a check, and nothing but a refusal shows it.
        let mut seen: BTreeMap<&[&str], Left> = BTreeMap::new();
        for (option, line, more) in *tried {
            assert!(more.contains(option), "{command}: {option} is not in {more:?}");
            let before = seen.entry(line).or_insert_with(|| left(command, line).0);
            let (after, told) = left(command, &with(line, more));
            if *before == after {
                faults.push(format!("{command} {line:?}: {more:?} changes nothing: {told}"));
            } else if after.0 > Some(1) && *option != "--z1" {
                faults.push(format!("{command} {line:?}: {more:?} ends with {:?}: {told}", after.0));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_option_of_gearboxes_changes_the_answer() {
    check(&["teeth", "drive", "analyze", "schemes", "draw", "report", "schema", "completions", "man"]);
}

#[test]
fn every_option_of_machines_changes_the_answer() {
    check(&[
        "machine list",
        "machine speeds",
        "machine chain-cutter",
        "machine drum",
        "machine rotor",
        "select",
    ]);
}

#[test]
fn every_option_of_motors_changes_the_answer() {
    check(&["motor", "motor search"]);
}

#[test]
fn no_option_is_left_out() {
    let named =
        |(_, tried): &(&str, &[Tried])| tried.iter().map(|(option, ..)| (*option).to_owned()).collect();
    let tried: BTreeMap<String, BTreeSet<String>> =
        COMMANDS.iter().map(|command| (command.0.to_owned(), named(command))).collect();
    assert_eq!(tried, all_options());
}

#[test]
fn an_option_that_would_change_nothing_says_what_it_needs() {
    for (command, args, wanted) in REFUSED {
        let ((code, answer, _), told) = left(command, args);
        assert!(
            code == Some(2) && answer.is_empty() && told.contains(wanted),
            "{command} {args:?}: {code:?} {told}"
        );
    }
}
