//! The command `drive`: a planetary drive from its file to its starting time.

mod figures;

use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::report::Report;
use epicyclic_dynamics::Error;
use epicyclic_dynamics::drive::{DriveDesign, design};
use epicyclic_formats::{Document, Problem, drive};
use std::path::PathBuf;

/// A planetary drive from power, speed and ratio to its starting time.
///
/// Chooses the teeth (or takes those given), then calculates speeds, torques, diameters, shafts with their bearings,
/// masses, inertias, forces, the inertia reduced to the sun's shaft, and how the drive starts. The sun drives, the
/// ring rests, the load is on the carrier. Warnings are part of the answer; with --output they are shown here too.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  printf 'power: 30 kW\\nspeed: 1450 rpm\\nratio: 5\\n' > drive.yaml
  printf 'gear_set: { module: 5 mm, face_width: 50 mm }\\n' >> drive.yaml
  epicyclic drive drive.yaml

Keys of the file, all but the first four optional:
  power, speed, ratio
  wheels: module, face_width, addendum, clearance, pressure_angle, density,
          sun_bore, planet_bore (shaft, bearing, or a diameter)
  title
  ratio_tolerance
  teeth: sun, planet, ring, planets (a number or a range), spacing, tip_gap
  mesh_efficiency: sun_planet, planet_ring
  shafts: allowable_stress, bearing_series,
          sun, planet, carrier: { diameter, bearing }
  carrier: inertia, or arms: { length, width, thickness,
                               hole: { radius, from_outer_end } }
                    and hub: { outside_radius, inside_radius, width }
  attached: motor, machine (inertias)
  start: driving_torque, load")]
pub(crate) struct Args {
    /// The file that describes the drive, in YAML.
    #[arg(value_name = "FILE")]
    file: PathBuf,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let (title, design) = calculate(&input::document(&args.file)?)?;
    answer(title, &design).deliver(&args.output)
}

/// The title of a drive's file, and the drive.
pub(crate) fn calculate(document: &Document) -> Result<(Option<String>, DriveDesign), Failure> {
    let (file, spec) = drive::read(document)?;
    let design = design(&spec).map_err(|error| {
        let at = document.error(&drive::place(&error), Problem::Refused { message: error.to_string() });
        match error {
            Error::Gear(epicyclic_gears::Error::NoToothNumbers { .. }) => {
                Failure::NothingFound(at.to_string())
            }
            _ => Failure::Document(at),
        }
    })?;
    Ok((file.title, design))
}

/// What there is to say of it.
pub(crate) fn answer(title: Option<String>, design: &DriveDesign) -> Report {
    figures::report(title, design)
}
