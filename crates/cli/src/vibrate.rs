//! The command `vibrate`: natural frequencies, modes and resonances of planet sets.

use crate::analyze::refuse;
use crate::desk::{Call, Content};
use crate::drawing_file;
use crate::failure::Failure;
use crate::input;
use crate::losses::Range;
use crate::output::OutputArgs;
use epicyclic_answers::Error;
use epicyclic_answers::vibration::{self as answers, Excitation, Vibration, Wanted};
use epicyclic_drawing::Scene;
use epicyclic_formats::Quantity as Given;
use epicyclic_views::vibration as views;
use std::path::{Path, PathBuf};
use uom::si::f64::{AngularVelocity, Length, Ratio};

/// Natural frequencies and modes of simple sets, and the speeds at which they resonate.
///
/// Each set is a planar model of Lin and Parker: sun, ring, carrier and planets on springs. With --speeds also what excites it
/// in each gear, which modes the phases of the planets let it excite, and the speeds of the input at which it meets them;
/// with --transmission-error the forces in the meshes.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  printf 'gearbox: hoist\\ninput: s\\noutput: h\\nsets:\\n' > hoist.yaml
  printf '  - id: P\\n    sun: s\\n    ring: ground\\n    carrier: h\\n' >> hoist.yaml
  printf '    teeth: [24, 84]\\n    planets: 4\\n' >> hoist.yaml
  printf '    module: 3 mm\\n    face_width: 40 mm\\n' >> hoist.yaml
  printf '    vibration:\\n      planet_bearing: 300 N/um\\n' >> hoist.yaml
  printf '      sun: { support: 0 N/um }\\n' >> hoist.yaml
  printf '      carrier: { mass: 9 kg, inertia: 0.05 kg·m2, ' >> hoist.yaml
  printf 'support: 200 N/um }\\n' >> hoist.yaml
  printf 'gears: [{ name: only }]\\n' >> hoist.yaml
  epicyclic vibrate hoist.yaml --shapes modes.svg
  epicyclic vibrate hoist.yaml --speeds 500rpm..9000rpm/10 --harmonics 2
  epicyclic vibrate hoist.yaml --speeds 500rpm..9000rpm/10 --campbell c.pdf
  epicyclic vibrate hoist.yaml --speeds 500rpm..9000rpm/100 \\
    --transmission-error 3um,1um --damping 3% --response forces.svg

Keys of the file beyond those of `epicyclic analyze`:
  sets: vibration: planet_bearing, mesh_stiffness, pressure_angles, base_radii;
        sun, ring, carrier, planet: mass, inertia or rotary_mass, support,
        tangential_support; sun: bore; ring: outside_diameter
  A centre without a support is held. Meshes without a stiffness have that of
  ISO 6336.")]
pub(crate) struct Args {
    /// The file, in YAML, or - for standard input.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    file: PathBuf,

    /// One gear; all without.
    #[arg(long, value_name = "NAME")]
    gear: Option<String>,

    /// One set; all without.
    #[arg(long, value_name = "NAME")]
    set: Option<String>,

    /// Resonances and frequencies over these speeds of the input: 500rpm..3000rpm/11, both ends and how many places.
    #[arg(long, value_name = "FROM..TO/PLACES", allow_hyphen_values = true)]
    speeds: Option<Range<AngularVelocity>>,

    /// How many harmonics of the meshes.
    #[arg(long, value_name = "COUNT", default_value_t = 3, requires = "speeds")]
    harmonics: u32,

    /// Transmission error of the meshes, harmonics from the first: 3um,1um. Tells the forces that it makes.
    #[arg(long, value_name = "AMPLITUDES", value_delimiter = ',', allow_hyphen_values = true, requires_all = ["speeds", "damping"])]
    transmission_error: Vec<Given<Length>>,

    /// The same of the ring's meshes, where it is another.
    #[arg(
        long,
        value_name = "AMPLITUDES",
        value_delimiter = ',',
        allow_hyphen_values = true,
        requires = "transmission_error"
    )]
    ring_transmission_error: Vec<Given<Length>>,

    /// Damping ratio of every mode, such as 0.03 or 3%.
    #[arg(long, value_name = "RATIO", allow_hyphen_values = true, requires = "transmission_error")]
    damping: Option<Given<Ratio>>,

    /// File for a picture of these forces of one set in one gear over the speed, as for --campbell.
    #[arg(long, value_name = "FILE", requires = "transmission_error")]
    response: Option<PathBuf>,

    /// File for a Campbell diagram of one set in one gear, by the end of its name: .dxf, .pdf, .png, otherwise SVG.
    #[arg(long, value_name = "FILE", requires = "speeds")]
    campbell: Option<PathBuf>,

    /// File for pictures of all modes of one set, seen along its axis, as for --campbell.
    #[arg(long, value_name = "FILE")]
    shapes: Option<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Runs the command.
pub(crate) fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let document = input::document(call, &args.file)?;
    let subject = answers::subject(&document)?;
    let speeds = args.speeds.as_ref().map(|range| range.places("--speeds")).transpose()?;
    let excitation = args.damping.map(|damping| {
        let given = |all: &[Given<Length>]| -> Vec<Length> { all.iter().map(|one| one.0).collect() };
        let ring = if args.ring_transmission_error.is_empty() {
            &args.transmission_error
        } else {
            &args.ring_transmission_error
        };
        Excitation { sun: given(&args.transmission_error), ring: given(ring), damping_ratio: damping.0.value }
    });
    let wanted = Wanted {
        gear: args.gear.clone(),
        set: args.set.clone(),
        speeds,
        harmonics: args.harmonics,
        excitation,
    };
    let answer = answers::answer(&subject, &wanted).map_err(|error| match error {
        Error::NoSet { .. } => Failure::Option { option: "--set", message: error.to_string() },
        Error::Harmonics { .. } => Failure::Option { option: "--harmonics", message: error.to_string() },
        Error::DampingRatio { .. } => Failure::Option { option: "--damping", message: error.to_string() },
        Error::TransmissionError { .. } => {
            Failure::Option { option: "--transmission-error", message: error.to_string() }
        }
        error => refuse(error),
    })?;
    let mut files = vec![];
    if let Some(file) = &args.campbell {
        files.push(drawn(file, "--campbell", &campbell(&answer)?)?);
    }
    if let Some(file) = &args.response {
        files.push(drawn(file, "--response", &response(&answer)?)?);
    }
    if let Some(file) = &args.shapes {
        files.push(drawn(file, "--shapes", &shapes(&answer)?)?);
    }
    args.output.deliver_with(call, files, &answer)
}

/// A picture as a file.
fn drawn(file: &Path, option: &'static str, scene: &Scene) -> Result<Content, Failure> {
    let format = drawing_file::format_by_name(file, option)?;
    Ok((file.to_owned(), drawing_file::content(scene, format, None)?))
}

/// Refuses a picture of none.
fn none(option: &'static str) -> Failure {
    Failure::Option { option, message: "no set has modes to draw".to_owned() }
}

/// Refuses a picture of several.
fn only(option: &'static str, all: &[String]) -> Result<(), Failure> {
    if all.len() < 2 {
        return Ok(());
    }
    let message = format!("it is of one, by --set and --gear; there are {}", all.join(", "));
    Err(Failure::Option { option, message })
}

/// The Campbell diagram.
fn campbell(answer: &Vibration) -> Result<Scene, Failure> {
    let all = answer.campbell.iter().map(|one| format!("set {} in gear {}", one.set, one.gear));
    only("--campbell", &all.collect::<Vec<_>>())?;
    let picture = views::campbell(answer, 0).ok_or_else(|| none("--campbell"))?;
    Ok(picture.scene().map_err(epicyclic_pictures::Error::from)?)
}

/// The forces over the speed.
fn response(answer: &Vibration) -> Result<Scene, Failure> {
    let all = answer.responses.iter().map(|one| format!("set {} in gear {}", one.set, one.gear));
    only("--response", &all.collect::<Vec<_>>())?;
    let picture = views::response(answer, 0).ok_or_else(|| none("--response"))?;
    Ok(picture.scene().map_err(epicyclic_pictures::Error::from)?)
}

/// The modes along the axis.
fn shapes(answer: &Vibration) -> Result<Scene, Failure> {
    let all = answer.sets.iter().map(|one| format!("set {} in gear {}", one.set, one.gears.join(" and ")));
    only("--shapes", &all.collect::<Vec<_>>())?;
    let (title, modes) = views::shapes(answer, 0).ok_or_else(|| none("--shapes"))?;
    Ok(epicyclic_pictures::modes::scene(&title, &modes).map_err(epicyclic_pictures::Error::from)?)
}
