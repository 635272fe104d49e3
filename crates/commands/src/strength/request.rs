//! The command `strength`: safeties of teeth by ISO 6336.

use crate::analyze::request::{Load, refuse};
use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::strength::answer::{self as answers, Wanted};
use std::path::PathBuf;

/// Strength of the teeth of simple sets by ISO 6336, method B: safeties of flanks and roots.
///
/// With --torque or --power and --speed the stresses, limits and safeties in each gear at this load for the required
/// life; without them damage, safety and life over the duty of the file, by Miner's rule. Torques are those without
/// losses; their direction does not matter. Sets that are not simple or lack data are named with what is missing.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  printf 'gearbox: hoist\\ninput: s\\noutput: h\\nlife: 20000 h\\n' > hoist.yaml
  printf 'oil: { viscosity: 220 mm2/s }\\nsets:\\n' >> hoist.yaml
  printf '  - id: P\\n    sun: s\\n    ring: r\\n    carrier: h\\n' >> hoist.yaml
  printf '    teeth: [24, 84]\\n    planet_teeth: [30]\\n' >> hoist.yaml
  printf '    planets: 3\\n    module: 3 mm\\n' >> hoist.yaml
  printf '    face_width: 40 mm\\n' >> hoist.yaml
  printf '    strength:\\n      materials: [18CrNiMo7-6, ' >> hoist.yaml
  printf '18CrNiMo7-6, 34CrNiMo6]\\n' >> hoist.yaml
  printf '      flank_roughness: [4 um, 4 um, 6 um]\\n' >> hoist.yaml
  printf '      root_roughness: [16 um, 16 um, 20 um]\\n' >> hoist.yaml
  printf '      shaper: { teeth: 30 }\\n' >> hoist.yaml
  printf '      factors: { K_A: 1.25, K_v: 1.05, K_H_beta: 1.2, ' >> hoist.yaml
  printf 'K_H_alpha: 1, K_F_alpha: 1 }\\n' >> hoist.yaml
  printf 'brakes: [{ id: B, link: r }]\\ngears: [{ name: \"1\", ' >> hoist.yaml
  printf 'engaged: [B] }]\\n' >> hoist.yaml
  epicyclic strength hoist.yaml --torque '300 N·m' --speed '1450 rpm'
  epicyclic strength hoist.yaml --torque '300 N·m' --speed '1450 rpm' --factors

Keys of the file beyond those of `epicyclic analyze`:
  sets: floating: sun, ring, carrier or none, for K_gamma
        strength: materials, flank_roughness, root_roughness (of sun, planets,
        ring), shaper: teeth, shift, fillet; and optionally planet_rim,
        ring_rim, factors, sun_mesh_factors, ring_mesh_factors, sun_factors,
        planet_factors, ring_factors, accuracy (deviations for K_v, K_H_alpha
        and K_F_alpha), accuracy_grade, pitting_allowed, long_life_factor
  materials: name, class, contact_limit, root_limit, and optionally hardness,
        strength, youngs_modulus
  oil: viscosity      life      required: flank, root
  duty: gear, share, torque, speed; the shares sum to 1")]
pub struct Args {
    /// The file, in YAML, or - for standard input.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    file: PathBuf,

    /// One gear at the load; all without.
    #[arg(long, value_name = "NAME")]
    gear: Option<String>,

    /// The factors of each mesh, with where each comes from; over a duty the least and greatest of its steps.
    #[arg(long)]
    factors: bool,

    #[command(flatten)]
    load: Load,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let document = input::document(call, &args.file)?;
    let subject = answers::subject(&document)?;
    let wanted = Wanted { gear: args.gear.clone(), input: args.load.input(), with_factors: args.factors };
    args.output.deliver(call, &answers::answer(&subject, &wanted).map_err(|error| refuse_of(error, args))?)
}

/// The option that a refusal speaks of.
fn refuse_of(error: Error, args: &Args) -> Failure {
    let option = match &error {
        Error::NoLoad => "--torque",
        Error::LoadWithoutSpeed => "--speed",
        Error::OfOnePoint if args.gear.is_some() => "--gear",
        Error::OfOnePoint => "--speed",
        _ => return refuse(error),
    };
    Failure::Option { option, message: error.to_string() }
}
