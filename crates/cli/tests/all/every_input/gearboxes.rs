//! Every key of a gearbox's file and of a list of transmissions.

use super::common::{examples, here, output, text};
use super::keys::{self, Changes, paths, replaced};
use super::schema;
use std::fs;
use std::path::Path;

/// A key with another value, and what shows it: the options of a command.
type Key = keys::Key<&'static [&'static str]>;

const OVERVIEW: &[&str] = &[];
/// First gear at a speed and a torque, for forces on planets and what their bearings bear.
const FIRST: &[&str] = &["--gear", "1", "--speed", "2000 rpm", "--torque", "300 N·m"];
/// A gear through the rolling disc and the set with two planets.
const WINCH: &[&str] = &["--gear", "winch", "--speed", "2000 rpm", "--torque", "300 N·m"];
const CURVE: &[&str] = &["--gear", "curve"];
/// The strength of the auxiliary set, at a load and over the duty.
const STRENGTH: &[&str] =
    &["strength", "--gear", "auxiliary drive", "--torque", "4 kN·m", "--speed", "100 rpm"];
/// Losses of all gears, with their drags.
const LOSSES: &[&str] = &["losses", "--speed", "2000 rpm", "--torque", "300 N·m"];
const OVER_DUTY: &[&str] = &["strength"];
const SHEET: &[&str] = &["sheet"];
const VIBRATE: &[&str] = &["vibrate"];
/// The torsional vibration of two simple sets with what the file says of the whole gearbox.
const TRAIN: &[&str] = &["train"];
/// The coupled vibration of the whole gearbox in the plane.
const COUPLED: &[&str] = &["train", "--coupled"];
const TWO_SETS: &str = "\
gearbox: train
input: engine
output: wheels
links: [turbine]
sets:
  - { id: A, sun: engine, ring: ground, carrier: ring, teeth: [24, 84], planets: 4, module: 3 mm, face_width: 30 mm,
      vibration: { planet_bearing: 300 N/µm, carrier: { mass: 5 kg, inertia: 0.03 kg·m², support: 90 N/µm } } }
  - { id: B, sun: shaft, ring: ground, carrier: wheels, teeth: [24, 84], planets: 4, module: 3 mm, face_width: 30 mm,
      vibration: { planet_bearing: 300 N/µm, sun: { support: 0 N/µm }, carrier: { mass: 5 kg, inertia: 0.03 kg·m² } } }
ties: [[ring, shaft], [wheels, turbine]]
gears: [{ name: only }]
";
/// The auxiliary set with its sun held, or its carrier, in place of its ring.
const SUN_HELD: Changes = &[
    ("    sun: engine\n    ring: ground", "    sun: ground\n    ring: engine"),
    (", tangential_support: 2000 N/µm", ""),
    ("support: 30 N/µm", "support: 30 N/µm, tangential_support: 110 N/µm"),
];
const CARRIER_HELD: Changes = &[
    ("    ring: ground\n    carrier: auxiliary", "    ring: auxiliary\n    carrier: ground"),
    (", tangential_support: 2000 N/µm", ""),
    ("support: 300 N/µm", "support: 300 N/µm, tangential_support: 510 N/µm"),
];
/// The angles of the planets where old files have them.
const OLD_ANGLES: Changes = &[
    ("    planet_angles: [0 deg, 120 deg, 240 deg]", "    #"),
    (
        "      planet_bearing: 400",
        "      planet_angles: [0 deg, 120 deg, 240 deg]\n      planet_bearing: 400",
    ),
];
const WITH_WINCH: Changes =
    &[("\ngears:\n", "\ngears:\n  - { name: winch, engaged: [LU, PTO], output: winch }\n")];

const IN_FIRST: Changes = &[("  - { gear: auxiliary drive, share: 60 %", "  - { gear: \"1\", share: 60 %")];

const fn key(path: &'static str, from: &'static str, to: &'static str, look: &'static [&'static str]) -> Key {
    Key { path, first: &[], from, to, look }
}

/// The bearing of a planet over a duty in the one gear in which its set is loaded.
const fn of_long_planet(path: &'static str, from: &'static str, to: &'static str) -> Key {
    Key { path, first: IN_FIRST, from, to, look: OVER_DUTY }
}

const fn of_winch(path: &'static str, from: &'static str, to: &'static str) -> Key {
    Key { path, first: WITH_WINCH, from, to, look: WINCH }
}

const GEARBOX: &[Key] = &[
    key("gearbox", "gearbox: every key once", "gearbox: another", OVERVIEW),
    Key {
        path: "input",
        first: &[("links: [turbine]", "links: [turbine, engine]")],
        from: "\ninput: engine",
        to: "\ninput: shaft",
        look: OVERVIEW,
    },
    key("output", "\noutput: wheels", "\noutput: sun_3", OVERVIEW),
    key("links", "links: [turbine]", "links: [turbine, spare]", FIRST),
    key("compound_sets.id", "id: ravigneaux", "id: another", OVERVIEW),
    Key {
        path: "compound_sets.carrier",
        first: &[("links: [turbine]", "links: [turbine, eccentric]")],
        from: "carrier: eccentric",
        to: "carrier: turbine",
        look: FIRST,
    },
    key("compound_sets.suns", "small_sun: 30", "small_sun: 24", OVERVIEW),
    key("compound_sets.rings", "rings: { ring: 72 }", "rings: { ring: 78 }", OVERVIEW),
    Key {
        path: "compound_sets.proportional",
        first: &[("pinion: [10]", "pinion: []")],
        from: "proportional: false",
        to: "proportional: true",
        look: OVERVIEW,
    },
    key("compound_sets.planet_shafts", "{ pto: disc }", "{ winch: disc }", FIRST),
    key("compound_sets.planet_gears", "long: [18]", "long: [20]", FIRST),
    of_winch("compound_sets.planet_gears", "{ disc: [40] }", "{ disc: [38] }"),
    key("compound_sets.meshes.gears", "gears: [short, long]", "gears: [short, ring]", OVERVIEW),
    key(
        "compound_sets.meshes.efficiency",
        "[small_sun, short], efficiency: 0.98",
        "[small_sun, short], efficiency: 0.97",
        OVERVIEW,
    ),
    key("compound_sets.meshes.efficiency", "efficiency: 98 %", "efficiency: 97 %", OVERVIEW),
    key("compound_sets.meshes.behind", "behind: false", "behind: true", OVERVIEW),
    key("compound_sets.meshes.module", "module: 4 mm }", "module: 5 mm }", OVERVIEW),
    key("compound_sets.planets", "planets: 3 # how many of each", "planets: 4 # how many of each", OVERVIEW),
    Key {
        path: "compound_sets.spacing",
        first: &[("planets: 3 # how many of each", "planets: 5 # how many of each")],
        from: "spacing: equal # or",
        to: "spacing: least_unequal # or",
        look: OVERVIEW,
    },
    Key {
        path: "compound_sets.planet_angles",
        first: &[("spacing: equal # or", "planet_angles: [0 deg, 120 deg, 240 deg] # or")],
        from: "120 deg, 240 deg] # or",
        to: "121 deg, 240 deg] # or",
        look: OVERVIEW,
    },
    key("compound_sets.module", "module: 3 mm # of its", "module: 4 mm # of its", OVERVIEW),
    key("compound_sets.planet_sizes.face_widths", "face_widths: [40 mm]", "face_widths: [41 mm]", FIRST),
    key("compound_sets.planet_sizes.bore", "bore: 20 mm", "bore: 21 mm", FIRST),
    key("compound_sets.planet_sizes.load_rating", "load_rating: 25 kN", "load_rating: 26 kN", FIRST),
    key(
        "compound_sets.planet_sizes.bearing_rolling",
        "load_rating: 25 kN, bearing_rolling: rollers",
        "load_rating: 25 kN, bearing_rolling: balls",
        FIRST,
    ),
    of_long_planet(
        "compound_sets.planet_sizes.static_load_rating",
        "static_load_rating: 30 kN",
        "static_load_rating: 31 kN",
    ),
    of_long_planet("compound_sets.planet_sizes.fatigue_limit", "fatigue_limit: 3 kN", "fatigue_limit: 2 kN"),
    of_long_planet(
        "compound_sets.planet_sizes.bearing_diameter",
        "bearing_diameter: 26 mm",
        "bearing_diameter: 20 mm",
    ),
    of_long_planet("compound_sets.planet_sizes.load_sharing", "load_sharing: 1.1", "load_sharing: 1.2"),
    key("compound_sets.planet_sizes.mass", "mass: 0.4 kg", "mass: 0.5 kg", FIRST),
    key(
        "compound_sets.planet_sizes.carrier_radius",
        "carrier_radius: 72 mm",
        "carrier_radius: 73 mm",
        OVERVIEW,
    ),
    key("compound_sets.bevels_left", "{ left: 16 }", "{ left: 14 }", CURVE),
    key("compound_sets.bevels_right", "{ right: 16 }", "{ right: 14 }", CURVE),
    key("sets.id", "id: drop", "id: another", FIRST),
    key("sets.kind", "kind: external_pair", "kind: internal_pair", OVERVIEW),
    key("sets.sun", "sun: sun_3", "sun: turbine", OVERVIEW),
    Key {
        path: "sets.ring",
        first: &[("links: [turbine]", "links: [turbine, drum]")],
        from: "ring: drum",
        to: "ring: engine",
        look: OVERVIEW,
    },
    of_winch("sets.carrier", "carrier: ground", "carrier: shaft"),
    key("sets.teeth", "teeth: [40, 44]", "teeth: [40, 45]", OVERVIEW),
    of_winch("sets.planet_teeth", "planet_teeth: [15, 18]", "planet_teeth: [15, 19]"),
    key("sets.planets", "planets: 4", "planets: 5", OVERVIEW),
    key("sets.module", "module: 3 mm # with teeth", "module: 4 mm # with teeth", OVERVIEW),
    of_winch("sets.face_width", "face_width: 30 mm", "face_width: 31 mm"),
    of_winch("sets.planet_bore", "planet_bore: 18 mm", "planet_bore: 17 mm"),
    of_winch("sets.meshes", "meshes: [0.98, 0.98, 0.99]", "meshes: [0.98, 0.97, 0.99]"),
    key("sets.profile_shifts", "profile_shifts: [0.389,", "profile_shifts: [0.6,", OVERVIEW),
    key("sets.helix_angle", "helix_angle: 0 deg", "helix_angle: 8 deg", SHEET),
    key("sets.helix_angle", "helix_angle: 0 deg", "helix_angle: 8 deg", OVERVIEW),
    key("sets.helix_angle", "helix_angle: 0 deg", "helix_angle: 8 deg", STRENGTH),
    key(
        "sets.tip_alterations",
        "tip_alterations: [-0.0833, -0.0833",
        "tip_alterations: [0.3, -0.0833",
        OVERVIEW,
    ),
    key("sets.data_sheet.ball_diameters", "ball_diameters: [8 mm", "ball_diameters: [9 mm", SHEET),
    key("sets.data_sheet.thickness_allowances", "allowances: [[-90 µm", "allowances: [[-100 µm", SHEET),
    key("sets.data_sheet.centre_distance_deviations", "[-0.02 mm, 0.02 mm]", "[-0.02 mm, 0.03 mm]", SHEET),
    key("vibration.link_inertias", "engine: 0.15 kg·m²", "engine: 0.16 kg·m²", TRAIN),
    key("vibration.shafts.id", "id: middle shaft", "id: another", TRAIN),
    key("vibration.shafts.between", "between: [ring, shaft]", "between: [wheels, turbine]", TRAIN),
    key("vibration.shafts.stiffness", "stiffness: 30 kN·m/rad", "stiffness: 31 kN·m/rad", TRAIN),
    key("vibration.shafts.lateral_stiffness", "lateral_stiffness: 20", "lateral_stiffness: 21", COUPLED),
    key("vibration.speeds", "speeds: [500 rpm", "speeds: [600 rpm", TRAIN),
    key("vibration.harmonics", "harmonics: 2", "harmonics: 1", TRAIN),
    key("vibration.transmission_error", "error: [3 µm, 1 µm]", "error: [3 µm, 2 µm]", TRAIN),
    key("vibration.ring_transmission_error", "error: [2 µm]", "error: [1 µm]", TRAIN),
    key("vibration.damping", "damping: 2 %", "damping: 3 %", TRAIN),
    Key {
        path: "sets.vibration.planet_angles",
        first: OLD_ANGLES,
        from: "120 deg, 240 deg",
        to: "123.2432 deg, 240 deg",
        look: VIBRATE,
    },
    key("sets.planet_angles", "120 deg, 240 deg", "123.2432 deg, 240 deg", VIBRATE),
    key("sets.planet_angles", "120 deg, 240 deg", "121 deg, 240 deg", OVERVIEW),
    Key {
        path: "sets.spacing",
        first: &[("planets: 3 # how many, or", "planets: 4 # how many, or")],
        from: "spacing: equal # of the planets",
        to: "spacing: least_unequal # of the planets",
        look: OVERVIEW,
    },
    key("sets.floating", "floating: sun", "floating: none", STRENGTH),
    key("sets.vibration.planet_bearing", "planet_bearing: 400", "planet_bearing: 410", VIBRATE),
    key("sets.vibration.mesh_stiffness", "mesh_stiffness: [1200", "mesh_stiffness: [1300", VIBRATE),
    key("sets.vibration.pressure_angles", "pressure_angles: [24 deg", "pressure_angles: [25 deg", VIBRATE),
    key("sets.vibration.base_radii", "base_radii: [33 mm", "base_radii: [34 mm", VIBRATE),
    key("sets.vibration.sun.mass", "mass: 2.1 kg", "mass: 2.2 kg", VIBRATE),
    key("sets.vibration.sun.inertia", "inertia: 18 kg·cm²", "inertia: 19 kg·cm²", VIBRATE),
    Key {
        path: "sets.vibration.sun.rotary_mass",
        first: &[("inertia: 18 kg·cm²", "rotary_mass: 2 kg")],
        from: "rotary_mass: 2 kg",
        to: "rotary_mass: 2.1 kg",
        look: VIBRATE,
    },
    Key {
        path: "sets.vibration.sun.bore",
        first: &[("mass: 2.1 kg, inertia: 18 kg·cm²", "bore: 20 mm")],
        from: "sun: { bore: 20 mm",
        to: "sun: { bore: 22 mm",
        look: VIBRATE,
    },
    key("sets.vibration.sun.support", "support: 30 N/µm", "support: 31 N/µm", VIBRATE),
    Key {
        path: "sets.vibration.sun.tangential_support",
        first: SUN_HELD,
        from: "tangential_support: 110 N/µm",
        to: "tangential_support: 120 N/µm",
        look: VIBRATE,
    },
    Key {
        path: "sets.vibration.ring.mass",
        first: &[("outside_diameter: 440 mm", "mass: 30 kg, inertia: 1 kg·m²")],
        from: "mass: 30 kg",
        to: "mass: 31 kg",
        look: VIBRATE,
    },
    Key {
        path: "sets.vibration.ring.inertia",
        first: &[("outside_diameter: 440 mm", "mass: 30 kg, inertia: 1 kg·m²")],
        from: "inertia: 1 kg·m²",
        to: "inertia: 1.1 kg·m²",
        look: VIBRATE,
    },
    Key {
        path: "sets.vibration.ring.rotary_mass",
        first: &[("outside_diameter: 440 mm", "mass: 30 kg, rotary_mass: 25 kg")],
        from: "rotary_mass: 25 kg",
        to: "rotary_mass: 26 kg",
        look: VIBRATE,
    },
    key("sets.vibration.ring.outside_diameter", "diameter: 440 mm", "diameter: 445 mm", VIBRATE),
    key("sets.vibration.ring.support", "support: 900 N/µm", "support: 910 N/µm", VIBRATE),
    key(
        "sets.vibration.ring.tangential_support",
        "tangential_support: 2000",
        "tangential_support: 2100",
        VIBRATE,
    ),
    key("sets.vibration.carrier.mass", "mass: 40 kg", "mass: 41 kg", VIBRATE),
    key("sets.vibration.carrier.inertia", "inertia: 0.6 kg·m²", "inertia: 0.7 kg·m²", VIBRATE),
    Key {
        path: "sets.vibration.carrier.rotary_mass",
        first: &[("inertia: 0.6 kg·m²", "rotary_mass: 45 kg")],
        from: "rotary_mass: 45 kg",
        to: "rotary_mass: 46 kg",
        look: VIBRATE,
    },
    key("sets.vibration.carrier.support", "support: 300 N/µm", "support: 310 N/µm", VIBRATE),
    Key {
        path: "sets.vibration.carrier.tangential_support",
        first: CARRIER_HELD,
        from: "tangential_support: 510 N/µm",
        to: "tangential_support: 520 N/µm",
        look: VIBRATE,
    },
    key("sets.vibration.planet.rotary_mass", "rotary_mass: 6 kg", "rotary_mass: 6.1 kg", VIBRATE),
    Key {
        path: "sets.vibration.planet.inertia",
        first: &[("rotary_mass: 6 kg", "inertia: 0.03 kg·m²")],
        from: "inertia: 0.03 kg·m²",
        to: "inertia: 0.031 kg·m²",
        look: VIBRATE,
    },
    key("sets.friction", "friction: [0.037", "friction: [0.05", OVERVIEW),
    key("sets.strength.materials", "[18CrNiMo7-6, 18CrNiMo7-6", "[34CrNiMo6, 18CrNiMo7-6", STRENGTH),
    key("sets.strength.flank_roughness", "flank_roughness: [4 µm", "flank_roughness: [5 µm", STRENGTH),
    key("sets.strength.root_roughness", "root_roughness: [16 µm", "root_roughness: [12 µm", STRENGTH),
    key("sets.strength.shaper.teeth", "      shaper: { teeth: 30", "      shaper: { teeth: 25", STRENGTH),
    key("sets.strength.shaper.shift", "shift: 0, fillet", "shift: 0.1, fillet", STRENGTH),
    key("sets.strength.shaper.fillet", "shift: 0, fillet: 0.3 ", "shift: 0, fillet: 0.25 ", STRENGTH),
    Key {
        path: "sets.strength.shaper.addendum",
        first: &[
            ("      ring: { shaper:", "      # { shaper:"),
            ("shift: 0, fillet: 0.3 }", "shift: 0, fillet: 0.3, addendum: 1.25 }"),
        ],
        from: "fillet: 0.3, addendum: 1.25 }",
        to: "fillet: 0.3, addendum: 1.3 }",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.profile",
        first: &[("sun: { profile: A, form_fillet: 0.3 }", "sun: { profile: A }")],
        from: "sun: { profile: A",
        to: "sun: { profile: D",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.dedendum",
        first: &[(
            "sun: { profile: A, form_fillet: 0.3 }",
            "sun: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
        )],
        from: "sun: { dedendum: 1.25",
        to: "sun: { dedendum: 1.3",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.fillet",
        first: &[(
            "sun: { profile: A, form_fillet: 0.3 }",
            "sun: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
        )],
        from: "sun: { dedendum: 1.25, fillet: 0.38",
        to: "sun: { dedendum: 1.25, fillet: 0.35",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.protuberance",
        first: &[(
            "sun: { profile: A, form_fillet: 0.3 }",
            "sun: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
        )],
        from: "sun: { dedendum: 1.25, fillet: 0.38, protuberance: 0",
        to: "sun: { dedendum: 1.25, fillet: 0.38, protuberance: 0.1",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.stock",
        first: &[(
            "sun: { profile: A, form_fillet: 0.3 }",
            "sun: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
        )],
        from: "sun: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0",
        to: "sun: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0.05",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.form_fillet",
        first: &[("sun: { profile: A, form_fillet: 0.3 }", "sun: { form_fillet: 0.3 }")],
        from: "sun: { form_fillet: 0.3",
        to: "sun: { form_fillet: 0.2",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.shaper.teeth",
        first: &[(
            "sun: { profile: A, form_fillet: 0.3 }",
            "sun: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
        )],
        from: "sun: { shaper: { teeth: 30",
        to: "sun: { shaper: { teeth: 29",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.shaper.shift",
        first: &[(
            "sun: { profile: A, form_fillet: 0.3 }",
            "sun: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
        )],
        from: "sun: { shaper: { teeth: 30, shift: 0",
        to: "sun: { shaper: { teeth: 30, shift: 0.05",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.shaper.addendum",
        first: &[(
            "sun: { profile: A, form_fillet: 0.3 }",
            "sun: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
        )],
        from: "sun: { shaper: { teeth: 30, shift: 0, addendum: 1.25",
        to: "sun: { shaper: { teeth: 30, shift: 0, addendum: 1.2",
        look: SHEET,
    },
    Key {
        path: "sets.tools.sun.shaper.tip_radius",
        first: &[(
            "sun: { profile: A, form_fillet: 0.3 }",
            "sun: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
        )],
        from: "sun: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3",
        to: "sun: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.25",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.profile",
        first: &[(
            "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
            "planet: { profile: A }",
        )],
        from: "planet: { profile: A",
        to: "planet: { profile: D",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.dedendum",
        first: &[],
        from: "planet: { dedendum: 1.25",
        to: "planet: { dedendum: 1.3",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.fillet",
        first: &[],
        from: "planet: { dedendum: 1.25, fillet: 0.38",
        to: "planet: { dedendum: 1.25, fillet: 0.35",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.protuberance",
        first: &[],
        from: "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0",
        to: "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0.1",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.stock",
        first: &[],
        from: "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0",
        to: "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0.05",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.form_fillet",
        first: &[(
            "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
            "planet: { form_fillet: 0.3 }",
        )],
        from: "planet: { form_fillet: 0.3",
        to: "planet: { form_fillet: 0.2",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.shaper.teeth",
        first: &[(
            "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
            "planet: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
        )],
        from: "planet: { shaper: { teeth: 30",
        to: "planet: { shaper: { teeth: 29",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.shaper.shift",
        first: &[(
            "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
            "planet: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
        )],
        from: "planet: { shaper: { teeth: 30, shift: 0",
        to: "planet: { shaper: { teeth: 30, shift: 0.05",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.shaper.addendum",
        first: &[(
            "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
            "planet: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
        )],
        from: "planet: { shaper: { teeth: 30, shift: 0, addendum: 1.25",
        to: "planet: { shaper: { teeth: 30, shift: 0, addendum: 1.2",
        look: SHEET,
    },
    Key {
        path: "sets.tools.planet.shaper.tip_radius",
        first: &[(
            "planet: { dedendum: 1.25, fillet: 0.38, protuberance: 0, stock: 0 }",
            "planet: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
        )],
        from: "planet: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3",
        to: "planet: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.25",
        look: SHEET,
    },
    Key {
        path: "sets.tools.ring.profile",
        first: &[(
            "ring: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
            "ring: { profile: A }",
        )],
        from: "ring: { profile: A",
        to: "ring: { profile: D",
        look: SHEET,
    },
    Key {
        path: "sets.tools.ring.dedendum",
        first: &[(
            "ring: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
            "ring: { dedendum: 1.25 }",
        )],
        from: "ring: { dedendum: 1.25",
        to: "ring: { dedendum: 1.3",
        look: SHEET,
    },
    Key {
        path: "sets.tools.ring.fillet",
        first: &[
            (
                "ring: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
                "ring: { fillet: 0.38 }",
            ),
            ("shift: 0, fillet: 0.3 }", "shift: 0 }"),
        ],
        from: "ring: { fillet: 0.38",
        to: "ring: { fillet: 0.35",
        look: STRENGTH,
    },
    Key {
        path: "sets.tools.ring.form_fillet",
        first: &[(
            "ring: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3 } }",
            "ring: { form_fillet: 0.3 }",
        )],
        from: "ring: { form_fillet: 0.3",
        to: "ring: { form_fillet: 0.2",
        look: SHEET,
    },
    Key {
        path: "sets.tools.ring.shaper.teeth",
        first: &[],
        from: "ring: { shaper: { teeth: 30",
        to: "ring: { shaper: { teeth: 29",
        look: SHEET,
    },
    Key {
        path: "sets.tools.ring.shaper.shift",
        first: &[],
        from: "ring: { shaper: { teeth: 30, shift: 0",
        to: "ring: { shaper: { teeth: 30, shift: 0.05",
        look: SHEET,
    },
    Key {
        path: "sets.tools.ring.shaper.addendum",
        first: &[],
        from: "ring: { shaper: { teeth: 30, shift: 0, addendum: 1.25",
        to: "ring: { shaper: { teeth: 30, shift: 0, addendum: 1.2",
        look: SHEET,
    },
    Key {
        path: "sets.tools.ring.shaper.tip_radius",
        first: &[],
        from: "ring: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.3",
        to: "ring: { shaper: { teeth: 30, shift: 0, addendum: 1.25, tip_radius: 0.25",
        look: SHEET,
    },
    key("sets.strength.planet_rim", "planet_rim: 9 mm", "planet_rim: 8 mm", STRENGTH),
    key("sets.strength.ring_rim", "ring_rim: 10 mm", "ring_rim: 9 mm", STRENGTH),
    key("sets.strength.factors", "K_A: 1.25, K_H", "K_A: 1.5, K_H", STRENGTH),
    key("sets.strength.sun_mesh_factors", "K_H_beta: 1.3", "K_H_beta: 1.4", STRENGTH),
    key("sets.strength.ring_mesh_factors", "K_H_beta: 1.15", "K_H_beta: 1.2", STRENGTH),
    key("sets.strength.sun_factors", "{ Z_W: 1 }", "{ Z_W: 1.1 }", STRENGTH),
    key("sets.strength.planet_factors", "Y_M: 0.72", "Y_M: 0.75", STRENGTH),
    key("sets.strength.accuracy.pitch_deviations", "[8 µm, 9 µm, 11 µm]", "[8 µm, 10 µm, 11 µm]", STRENGTH),
    key(
        "sets.strength.accuracy.profile_deviations",
        "[9 µm, 10 µm, 12 µm]",
        "[9 µm, 11 µm, 12 µm]",
        STRENGTH,
    ),
    key("sets.strength.accuracy.tip_relief", "tip_relief: 20 µm", "tip_relief: 15 µm", STRENGTH),
    key("sets.strength.accuracy.sun_bore", "sun_bore: 30 mm", "sun_bore: 40 mm", STRENGTH),
    key("sets.strength.accuracy.blank_factor", "blank_factor: 0.95", "blank_factor: 0.9", STRENGTH),
    Key {
        path: "sets.strength.accuracy_grade",
        first: &[
            ("addendum: 1 #", "addendum: 1.25 #"),
            ("profile: A", "dedendum: 1.5, fillet: 0.2"),
            ("dedendum: 1.25, fillet: 0.38", "dedendum: 1.5, fillet: 0.2"),
            ("shift: 0, fillet: 0.3", "shift: 0, fillet: 0.1"),
        ],
        from: "accuracy_grade: 5",
        to: "accuracy_grade: 4",
        look: STRENGTH,
    },
    key("sets.strength.pitting_allowed", "pitting_allowed: false", "pitting_allowed: true", STRENGTH),
    key("sets.strength.long_life_factor", "long_life_factor: 0.9", "long_life_factor: 0.95", STRENGTH),
    key("sets.strength.ring_factors", "Y_delta_rel_T_stat: 1", "Y_delta_rel_T_stat: 1, Y_S: 2", STRENGTH),
    Key {
        path: "friction",
        first: &[("    friction: [0.037, 0.029]", "   ")],
        from: "\nfriction: 0.05",
        to: "\nfriction: 0.06",
        look: OVERVIEW,
    },
    key("drags.id", "id: seal", "id: another", LOSSES),
    key("drags.between", "between: [engine, ground]", "between: [wheels, ground]", LOSSES),
    key("drags.curve.speeds", "speeds: [0 rpm, 1000 rpm]", "speeds: [0 rpm, 3000 rpm]", LOSSES),
    key("drags.curve.torques", "torques: [1 N·m, 1.5 N·m]", "torques: [1 N·m, 2.5 N·m]", LOSSES),
    key("drags.curve.beyond", "beyond: constant # outside", "beyond: refused # outside", LOSSES),
    key(
        "brakes.drag.speeds",
        "speeds: [0 rpm, 500 rpm], torques: [0.5 N·m",
        "speeds: [0 rpm, 5000 rpm], torques: [0.5 N·m",
        LOSSES,
    ),
    key("brakes.drag.torques", "torques: [0.5 N·m, 2 N·m]", "torques: [0.5 N·m, 3 N·m]", LOSSES),
    key("brakes.drag.beyond", "2 N·m], beyond: constant", "2 N·m], beyond: refused", LOSSES),
    key(
        "clutches.drag.speeds",
        "speeds: [0 rpm, 500 rpm], torques: [0.4 N·m",
        "speeds: [0 rpm, 5000 rpm], torques: [0.4 N·m",
        LOSSES,
    ),
    key("clutches.drag.torques", "torques: [0.4 N·m, 1 N·m]", "torques: [0.4 N·m, 2 N·m]", LOSSES),
    key("clutches.drag.beyond", "1 N·m], beyond: constant", "1 N·m], beyond: refused", LOSSES),
    key(
        "materials.name",
        "ring steel] # of the program's table, or of `materials` below\n\nmaterials: # of one's own, for the strength of teeth\n  - name: ring steel",
        "other]\n\nmaterials:\n  - name: other",
        STRENGTH,
    ),
    key("materials.class", "class: through_hardened", "class: case_hardened", STRENGTH),
    key("materials.contact_limit", "contact_limit: 700 MPa", "contact_limit: 710 MPa", STRENGTH),
    key("materials.root_limit", "root_limit: 290 MPa", "root_limit: 300 MPa", STRENGTH),
    key("materials.hardness", "hardness: 240", "hardness: 300", STRENGTH),
    key("materials.strength", "strength: 1000 MPa", "strength: 900 MPa", STRENGTH),
    key("materials.youngs_modulus", "youngs_modulus: 206 GPa", "youngs_modulus: 200 GPa", STRENGTH),
    key("oil.viscosity", "viscosity: 220 mm²/s", "viscosity: 320 mm²/s", STRENGTH),
    key("life", "life: 20000 h", "life: 30000 h", STRENGTH),
    key("required.flank", "flank: 1.1", "flank: 1.2", STRENGTH),
    key("required.root", "root: 1.4", "root: 1.5", STRENGTH),
    key("duty.gear", "gear: \"1\", share", "gear: auxiliary drive, share", OVER_DUTY),
    Key {
        path: "duty.share",
        first: &[("share: 40 %", "share: 0.4")],
        from: "share: 60 %, torque: 4 kN·m, speed: 100 rpm }\n  - { gear: \"1\", share: 0.4",
        to: "share: 50 %, torque: 4 kN·m, speed: 100 rpm }\n  - { gear: \"1\", share: 0.5",
        look: OVER_DUTY,
    },
    key("overload.gear", "gear: auxiliary drive, torque: 9", "gear: \"1\", torque: 9", OVER_DUTY),
    key("overload.torque", "torque: 9 kN·m", "torque: 10 kN·m", OVER_DUTY),
    key("overload.required.flank", "flank: 1, root: 1.3", "flank: 1.1, root: 1.3", OVER_DUTY),
    key("overload.required.root", "flank: 1, root: 1.3", "flank: 1, root: 1.2", OVER_DUTY),
    key("duty.torque", "torque: 4 kN·m", "torque: 5 kN·m", OVER_DUTY),
    key("duty.speed", "torque: 4 kN·m, speed: 100 rpm", "torque: 4 kN·m, speed: 200 rpm", OVER_DUTY),
    key("sets.efficiency", "efficiency: 0.985", "efficiency: 0.98", OVERVIEW),
    key("sets.k", "k: 2.5", "k: 2.6", OVERVIEW),
    key("sets.carrier_radius", "carrier_radius: 90 mm", "carrier_radius: 91 mm", OVERVIEW),
    key("sets.planet_mass", "planet_mass: 2.4 kg", "planet_mass: 2.5 kg", FIRST),
    key("sets.static_load_rating", "static_load_rating: 65 kN", "static_load_rating: 66 kN", OVER_DUTY),
    key("sets.fatigue_limit", "fatigue_limit: 7 kN", "fatigue_limit: 5 kN", OVER_DUTY),
    key("sets.bearing_diameter", "bearing_diameter: 60 mm", "bearing_diameter: 40 mm", OVER_DUTY),
    key("oil.working_viscosity", "working_viscosity: 60", "working_viscosity: 20", OVER_DUTY),
    key("oil.contamination", "contamination: 0.5", "contamination: 0.2", OVER_DUTY),
    key("bearing_reliability", "bearing_reliability: 95 %", "bearing_reliability: 99 %", OVER_DUTY),
    key("sets.load_rating", "load_rating: 60 kN", "load_rating: 61 kN", FIRST),
    key("sets.bearing_rolling", "bearing_rolling: rollers # in", "bearing_rolling: balls # or", FIRST),
    Key {
        path: "brakes.id",
        first: &[("{ id: LR, link: carrier }", "{ id: LR, link: carrier }\n  - { id: B3, link: ring }")],
        from: "id: B3",
        to: "id: B4",
        look: FIRST,
    },
    key("brakes.link", "{ id: LR, link: carrier }", "{ id: LR, link: ring }", OVERVIEW),
    key("clutches.id", "id: PTO", "id: other", FIRST),
    key("clutches.links", "links: [turbine, small_sun]", "links: [turbine, large_sun]", OVERVIEW),
    key("clutches.one_way", "one_way: [carrier, ground]", "one_way: [ground, carrier]", &["--gear", "D1"]),
    key("density", "density: 7850 kg/m3", "density: 7800 kg/m3", FIRST),
    Key {
        path: "pressure_angle",
        first: &[("profile: A", "profile: C"), ("fillet: 0.38", "fillet: 0.3")],
        from: "pressure_angle: 20 deg",
        to: "pressure_angle: 25 deg",
        look: OVERVIEW,
    },
    key("addendum", "addendum: 1 ", "addendum: 0.8 ", OVERVIEW),
    key("grounds", "grounds: [drum]", "grounds: []", OVERVIEW),
    key("ties", "ties: [[ring, shaft]]", "ties: []", OVERVIEW),
    key("gears.name", "name: R,", "name: reverse,", OVERVIEW),
    key("gears.engaged", "engaged: [LU, REV, LR]", "engaged: [LU, REV]", OVERVIEW),
    key("gears.input", "input: shaft, output: wheels", "input: sun_3, output: wheels", OVERVIEW),
    key("gears.output", "output: wheels }", "output: winch }", OVERVIEW),
    key("gears.speeds", "left: 150 rpm", "left: 160 rpm", CURVE),
    key("gears.torques", "engine: 300 N·m", "engine: 310 N·m", CURVE),
];

/// Remarks, which nothing reads.
const NOTES: &[(&str, &str, &str)] = &[
    ("note", "note: \"any remark\"", "note: { of: [any, form] }"),
    ("compound_sets.note", "note: what nothing reads", "note: [1, 2]"),
    ("sets.note", "kind: external_pair", "kind: external_pair\n    note: [one, two]"),
];

/// A list with every key, each kind of set, one-way clutches, and gears that keep freedoms.
const LIST: &str = "\
transmissions:
- name: every key
  source: a test
  sets:
  - {id: simple, planet: simple, sun: S, ring: R, carrier: C, z_s: 30, z_r: 78, z_p: 24, n_p: 4, efficiency: 0.97}
  - {id: pair, planet: pair, gear_a: X, gear_b: Y, z_a: 54, z_b: 55, meshes: [0.985]}
  - {id: double, planet: double, sun: S2, ring: R2, carrier: C2, z_s: 30, z_r: 72, z_pa: 15, z_pb: 18, n_p: 3, meshes: [0.98, 0.97, 0.99]}
  compound_sets:
  - id: wheels
    carrier: W
    suns: {S4: 30}
    rings: {R4: 72}
    planet_shafts: {P4: outer}
    planet_gears: {inner: [18], outer: [20]}
    meshes:
    - {gears: [S4, inner], efficiency: 0.99}
    - {gears: [inner, outer], behind: false, module: 3 mm}
    - {gears: [outer, R4], module: 4 mm}
    planets: 3
    module: 3 mm
    planet_sizes:
      inner: {mass: 0.4 kg, load_rating: 25 kN, bearing_rolling: rollers, carrier_radius: 72 mm}
      outer: {face_widths: [20 mm], bore: 10 mm}
    note: a remark
  - id: bevels
    carrier: n_bevel
    bevels_left: {L5: 16}
    bevels_right: {R5: 18}
    proportional: false
    planet_gears: {pinion: [10]}
    meshes: [{gears: [L5, pinion]}, {gears: [R5, pinion]}]
  links:
    in: [S, S2, S4, L5]
    ground: [R]
    shaft: [C, X, C2]
    out: [Y]
    ring_2: [R2]
    free: [R4]
    wheel: [W]
    disc: [P4]
    n_bevel: [n_bevel]
    side: [R5]
  input: in
  output: out
  shift_elements: {B: [ring_2, ground], W: [wheel, ground], F: [free, ground], N: [n_bevel, ground]}
  one_way: {O: [free, ground]}
  gears:
  - {name: '1', engaged: [], published_ratio: -3.67, printed_decimals: 2, note: a remark}
  - {name: '2', engaged: [W], input: in, output: free, published_ratio: 2.40, printed_decimals: 2}
  - {name: '3', engaged: [N], output: side, published_ratio: -0.889, printed_decimals: 3, invert: true, unverified: true, rounding: truncated}
  - {name: '4', engaged: [], output: free, published_ratio: 1, printed_decimals: 0, speeds: {in: 2000 rpm, wheel: 150 rpm, side: 0 rpm}, torques: {in: 300 N·m}}
  note: a remark
note: a remark
";

/// List without the planet shaft, with which the number of pins would not determine the assembly.
const WITHOUT_DISC: Changes = &[
    ("    planet_shafts: {P4: outer}\n", ""),
    ("    disc: [P4]\n", ""),
    ("\n    planets: 3\n", "\n    planets: 5\n    spacing: equal\n"),
];
const LISTED: &[&str] = &["--gear", "2", "--speed", "2000 rpm", "--torque", "300 N·m"];
const FOURTH: &[&str] = &["--gear", "4"];

const TRANSMISSION: &[Key] = &[
    key("transmissions.name", "name: every key", "name: another", OVERVIEW),
    key("transmissions.source", "source: a test", "source: another", &["--format", "table"]),
    key("transmissions.sets.id", "id: simple", "id: another", OVERVIEW),
    key("transmissions.sets.planet", "planet: pair", "planet: internal_pair", OVERVIEW),
    key("transmissions.sets.sun", "sun: S2", "sun: R4", OVERVIEW),
    key("transmissions.sets.ring", "ring: R,", "ring: R4,", OVERVIEW),
    key("transmissions.sets.carrier", "carrier: C,", "carrier: R4,", OVERVIEW),
    key("transmissions.sets.z_s", "z_s: 30, z_r: 78", "z_s: 32, z_r: 78", OVERVIEW),
    key("transmissions.sets.z_r", "z_r: 78", "z_r: 80", OVERVIEW),
    key("transmissions.sets.z_p", "z_p: 24", "z_p: 23", OVERVIEW),
    key("transmissions.sets.n_p", "z_p: 24, n_p: 4", "z_p: 24, n_p: 5", OVERVIEW),
    Key {
        path: "transmissions.sets.spacing",
        first: &[("n_p: 4,", "n_p: 5, spacing: equal,")],
        from: "spacing: equal",
        to: "spacing: least_unequal",
        look: OVERVIEW,
    },
    Key {
        path: "transmissions.sets.planet_angles",
        first: &[("n_p: 4,", "planet_angles: [0 deg, 120 deg, 240 deg],")],
        from: "120 deg",
        to: "121 deg",
        look: OVERVIEW,
    },
    key("transmissions.sets.z_pa", "z_pa: 15", "z_pa: 16", OVERVIEW),
    key("transmissions.sets.z_pb", "z_pb: 18", "z_pb: 19", LISTED),
    key("transmissions.sets.gear_a", "gear_a: X", "gear_a: R4", OVERVIEW),
    key("transmissions.sets.gear_b", "gear_b: Y", "gear_b: R4", OVERVIEW),
    key("transmissions.sets.z_a", "z_a: 54", "z_a: 53", OVERVIEW),
    key("transmissions.sets.z_b", "z_b: 55", "z_b: 56", OVERVIEW),
    key("transmissions.sets.efficiency", "efficiency: 0.97}", "efficiency: 0.96}", OVERVIEW),
    key("transmissions.sets.meshes", "meshes: [0.985]", "meshes: [0.98]", OVERVIEW),
    key("transmissions.compound_sets.id", "id: wheels", "id: another", LISTED),
    key("transmissions.compound_sets.carrier", "carrier: W", "carrier: Y", OVERVIEW),
    key("transmissions.compound_sets.suns", "S4: 30", "S4: 29", OVERVIEW),
    key("transmissions.compound_sets.rings", "R4: 72", "R4: 71", OVERVIEW),
    Key {
        path: "transmissions.compound_sets.proportional",
        first: &[("pinion: [10]", "pinion: []")],
        from: "proportional: false",
        to: "proportional: true",
        look: OVERVIEW,
    },
    key("transmissions.compound_sets.planet_shafts", "P4: outer", "P4: inner", LISTED),
    key("transmissions.compound_sets.planet_gears", "outer: [20]", "outer: [21]", LISTED),
    key("transmissions.compound_sets.bevels_left", "L5: 16", "L5: 15", OVERVIEW),
    key("transmissions.compound_sets.bevels_right", "R5: 18", "R5: 17", OVERVIEW),
    key("transmissions.compound_sets.meshes.gears", "gears: [outer, R4]", "gears: [inner, R4]", OVERVIEW),
    key(
        "transmissions.compound_sets.meshes.efficiency",
        "inner], efficiency: 0.99",
        "inner], efficiency: 0.98",
        OVERVIEW,
    ),
    key("transmissions.compound_sets.meshes.behind", "behind: false", "behind: true", LISTED),
    key("transmissions.compound_sets.meshes.module", "R4], module: 4 mm", "R4], module: 5 mm", LISTED),
    key("transmissions.compound_sets.planets", "planets: 3", "planets: 4", LISTED),
    Key {
        path: "transmissions.compound_sets.spacing",
        first: WITHOUT_DISC,
        from: "spacing: equal",
        to: "spacing: least_unequal",
        look: OVERVIEW,
    },
    Key {
        path: "transmissions.compound_sets.planet_angles",
        first: &[("\n    planets: 3\n", "\n    planet_angles: [0 deg, 120 deg, 240 deg]\n")],
        from: "120 deg",
        to: "20 deg",
        look: OVERVIEW,
    },
    Key {
        path: "transmissions.compound_sets.module",
        first: &[
            (", carrier_radius: 72 mm", ""),
            ("behind: false, module: 3 mm", "behind: false"),
            ("R4], module: 4 mm", "R4]"),
        ],
        from: "\n    module: 3 mm",
        to: "\n    module: 5 mm",
        look: LISTED,
    },
    key("transmissions.compound_sets.planet_sizes.mass", "mass: 0.4 kg", "mass: 0.5 kg", LISTED),
    key(
        "transmissions.compound_sets.planet_sizes.load_rating",
        "load_rating: 25 kN",
        "load_rating: 26 kN",
        LISTED,
    ),
    key(
        "transmissions.compound_sets.planet_sizes.bearing_rolling",
        "rolling: rollers",
        "rolling: balls",
        LISTED,
    ),
    key(
        "transmissions.compound_sets.planet_sizes.carrier_radius",
        "carrier_radius: 72 mm",
        "carrier_radius: 73 mm",
        LISTED,
    ),
    key("transmissions.compound_sets.planet_sizes.face_widths", "[20 mm]", "[21 mm]", LISTED),
    key("transmissions.compound_sets.planet_sizes.bore", "bore: 10 mm", "bore: 11 mm", LISTED),
    key("transmissions.links", "out: [Y]", "exit: [Y]\n    out: [n_bevel_2]", OVERVIEW),
    key("transmissions.input", "\n  input: in", "\n  input: shaft", OVERVIEW),
    key("transmissions.output", "\n  output: out", "\n  output: side", OVERVIEW),
    key("transmissions.shift_elements", "B: [ring_2, ground]", "B: [ring_2, wheel]", LISTED),
    key("transmissions.one_way", "O: [free, ground]", "O: [ground, free]", LISTED),
    key("transmissions.gears.name", "name: '1'", "name: low", OVERVIEW),
    key("transmissions.gears.engaged", "engaged: [W]", "engaged: [F]", OVERVIEW),
    key("transmissions.gears.input", "input: in, output: free", "input: wheel, output: free", OVERVIEW),
    key("transmissions.gears.output", "output: side,", "output: shaft,", OVERVIEW),
    key("transmissions.gears.speeds", "wheel: 150 rpm", "wheel: 160 rpm", FOURTH),
    key("transmissions.gears.torques", "in: 300 N·m", "in: 310 N·m", FOURTH),
    key("transmissions.gears.published_ratio", "-3.67", "-3.66", OVERVIEW),
    key(
        "transmissions.gears.printed_decimals",
        "printed_decimals: 2, note",
        "printed_decimals: 4, note",
        OVERVIEW,
    ),
    key("transmissions.gears.rounding", ", rounding: truncated", "", OVERVIEW),
    key("transmissions.gears.invert", ", invert: true", "", OVERVIEW),
    key("transmissions.gears.unverified", ", unverified: true", "", OVERVIEW),
];

const NOTES_OF_LISTS: &[(&str, &str, &str)] = &[
    ("note", "\nnote: a remark", "\nnote: [another]"),
    ("transmissions.note", "\n  note: a remark", "\n  note: [another]"),
    ("transmissions.sets.note", "{id: simple,", "{id: simple, note: [another],"),
    ("transmissions.compound_sets.note", "\n    note: a remark", "\n    note: [another]"),
    ("transmissions.gears.note", ", note: a remark", ", note: [another]"),
];

/// Results for a file, or the reason why it is refused.
fn seen(folder: &Path, file: &str, more: &[&str]) -> Result<String, String> {
    let train = |block: &str| {
        let (block, _) = block.split_once("\n\n").unwrap();
        format!("{TWO_SETS}vibration:{block}\n")
    };
    let (file, more) = match more {
        ["train", more @ ..] => {
            let of_train = [VIBRATE, more].concat();
            (train(file.split_once("\nvibration:").unwrap().1), of_train)
        }
        _ => (file.to_owned(), more.to_vec()),
    };
    fs::write(folder.join("box.yaml"), file).unwrap();
    let (command, more) = match more.split_first() {
        Some((&command @ ("strength" | "losses" | "sheet" | "vibrate"), more)) => (command, more),
        _ => ("analyze", &more[..]),
    };
    let mut args = vec![command, "box.yaml"];
    if !more.contains(&"--format") {
        args.extend(["--format", "json"]);
    }
    args.extend(more);
    let output = output(folder, &args);
    if output.status.success() { Ok(text(&output.stdout)) } else { Err(text(&output.stderr)) }
}

/// Checks that each key changes the results, that no remark does, and that every path of the schema has a
/// key.
fn check(of: &str, file: &str, keys: &[Key], notes: &[(&str, &str, &str)]) {
    let folder = here();
    keys::check(file, keys, |file, look| seen(folder.path(), file, look));
    let gears: &[&[&str]] =
        if of == "gearbox" { &[OVERVIEW, FIRST, CURVE] } else { &[OVERVIEW, LISTED, FOURTH] };
    for (path, from, to) in notes {
        for look in gears {
            let after = seen(folder.path(), &replaced(file, from, to), look);
            assert!(
                after.is_ok() && seen(folder.path(), file, look) == after,
                "the remark {path} changes something"
            );
        }
    }
    let mut tried = paths(keys);
    tried.extend(notes.iter().map(|(path, ..)| (*path).to_owned()));
    if of == "gearbox" {
        for key in ["protuberance", "stock"] {
            let file = replaced(file, "ring: { shaper", &format!("ring: {{ {key}: 0, shaper"));
            let told = seen(folder.path(), &file, OVERVIEW).unwrap_err();
            assert!(told.contains(&format!("sets[3].tools.ring.{key}: ")), "{told}");
            tried.insert(format!("sets.tools.ring.{key}"));
        }
    }
    assert_eq!(tried, schema(of));
}

#[test]
fn every_key_of_a_gearbox_changes_its_answer() {
    let example = fs::read_to_string(examples().join("every-gearbox-key.yaml")).unwrap();
    check("gearbox", &example, GEARBOX, NOTES);
}

#[test]
fn every_key_of_a_list_of_transmissions_changes_its_answer() {
    check("transmissions", LIST, TRANSMISSION, NOTES_OF_LISTS);
}
