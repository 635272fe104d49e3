//! The program from outside, for the tests of its commands.

#![allow(dead_code, reason = "each test file uses its part")]
#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

pub(crate) mod console;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_epicyclic");

pub(crate) fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

pub(crate) fn program(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(PROGRAM);
    command.args(args).current_dir(folder).env_remove("COLUMNS").stdin(Stdio::null());
    command
}

pub(crate) fn output(folder: &Path, args: &[&str]) -> Output {
    program(folder, args).output().unwrap()
}

/// Output of a command line, parted as a shell does.
pub(crate) fn run(folder: &Path, line: &str) -> Output {
    let words = console::words(line);
    output(folder, &words.iter().map(String::as_str).collect::<Vec<_>>())
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Output as a person sees it.
pub(crate) fn session(folder: &Path, args: &[&str]) -> String {
    let output = output(folder, args);
    let mut seen = format!("$ epicyclic {}\n{}", args.join(" "), text(&output.stdout));
    if !output.stderr.is_empty() {
        write!(seen, "stderr:\n{}", text(&output.stderr)).unwrap();
    }
    // Clap leaves spaces at the ends of empty lines.
    let lines: Vec<&str> = seen.lines().map(str::trim_end).collect();
    format!("{}\nexit: {}\n", lines.join("\n"), output.status.code().unwrap())
}

/// Several sessions of one folder.
pub(crate) fn sessions(folder: &Path, all: &[&[&str]]) -> String {
    all.iter().map(|args| session(folder, args)).collect::<Vec<_>>().join("\n")
}

/// Names of the files of a folder, sorted.
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// A change of a text as tables of cases have it: `old → new`, with `\\n` for a line break and `\\s` for a
/// space at an end.
pub(crate) fn change(written: &str) -> Option<(String, String)> {
    let (from, to) = written.split_once(" →")?;
    let plain = |text: &str| text.replace("\\n", "\n").replace("\\s", " ");
    Some((plain(from), plain(to.strip_prefix(' ').unwrap_or(to))))
}

/// File with a text, which it must have, replaced by another.
pub(crate) fn replaced(file: &str, from: &str, to: &str) -> String {
    assert!(file.contains(from), "{from}");
    file.replacen(from, to, 1)
}

pub(crate) fn here() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

/// Simulation of one hour of a vibrating motor.
pub(crate) const SHAKEN: &str = "\
scenario: shaken
gearbox: { gearbox: g, input: D, output: B, sets: [{ id: P, sun: D, ring: ground, carrier: B, k: 3 }] }
inertias: { D: 0.2 kg·m², B: 8 kg·m² }
torques: [{ id: motor, link: D, harmonic: { mean: 0 N·m, amplitude: 1 N·m, frequency: 50 Hz, phase: 0 deg } }]
duration: 1 h
sample_every: 60 s
";

/// Set whose ring has roots too sharp for the standard.
pub(crate) const SHARP: &str = "\
gearbox: sharp root
input: sun
output: arm
sets:
  - { id: P, sun: sun, ring: ground, carrier: arm, teeth: [12, 36], planet_teeth: [12], planets: 3, module: 4 mm, profile_shifts: [0, 0, 0],
      face_width: 40 mm, strength: { materials: [18CrNiMo7-6, 18CrNiMo7-6, 34CrNiMo6], flank_roughness: [4 µm, 4 µm, 6 µm],
      root_roughness: [16 µm, 16 µm, 20 µm], shaper: { teeth: 40, fillet: 0.2 }, ring_factors: { Y_delta_rel_T_stat: 1 },
      factors: { K_A: 1.25, K_v: 1.1, K_H_beta: 1.25, K_H_alpha: 1, K_F_alpha: 1 } } }
oil: { viscosity: 220 mm²/s }
life: 20000 h
gears: [{ name: only }]
";
