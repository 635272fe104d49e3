//! The command `motor`: a planetary hydromotor from its numbers to its drawings, and two searches for one.

use crate::desk::Call;
mod construction;
mod design;
mod files;
mod forms;
mod made;
mod satellites;
mod search;
mod sought;
mod steps;

use crate::failure::Failure;
use crate::imprint::{self, PageArgs};
use crate::input;
use crate::output::OutputArgs;
use epicyclic_answers as answers;
use epicyclic_answers::motor::Designed;
use epicyclic_answers::motor_forms::Crest;
use epicyclic_answers::report;
use epicyclic_drawing::Scene;
use epicyclic_formats::Path;
use epicyclic_hydromotor::profile::ToothForm;
use epicyclic_units::{Number, Quantity};
use epicyclic_views::page;
use std::path::PathBuf;
use uom::si::f64::{Angle, AngularVelocity, Length, Pressure};

/// A hydromotor with non-circular wheels and floating satellites: geometry that closes, working data, teeth, drawings.
///
/// A ring with N arches (the stator) and a sun with n lobes (the rotor), N + n round satellites between them
/// that roll on both. Without --zs the satellites that the other numbers admit are listed. The numbers leave
/// one distance free: --l, --a or --part choose it. With both --l and --a the rotor need not close; the
/// answer is then the construction of the arcs. Torque and flow are theoretical; --oil, --gaps and
/// --friction add losses, --ports the ports as they are made. Module: 0.001 to 1000 mm; width: 0.001 to 10
/// 000 mm; l: at most 100 times the stator's nominal radius m·Z₃/2. A rotor that reaches into the stator is
/// refused.
#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
#[command(override_usage = "\
epicyclic motor [OPTIONS] <FILE>
       epicyclic motor [OPTIONS] --stator <N> --rotor <N> --z3 <TEETH>
           --module <MODULE> [--zs <TEETH>]
       epicyclic motor search [OPTIONS]
       epicyclic motor forms [OPTIONS]")]
#[command(after_help = "\
Example:
  printf 'stator: 5\\nrotor: 3\\nz3: 55\\nzs: 10\\n' > motor.yaml
  printf 'module: 2 mm\\n' >> motor.yaml
  epicyclic motor motor.yaml --view teeth --svg teeth.svg
  epicyclic motor --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' \\
      --l '80 mm' --width '50 mm' --pressure '20 MPa' --speed '60 rpm'
  epicyclic motor --stator 5 --rotor 3 --z3 55 --module '2 mm'
  epicyclic motor --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' \\
      --l '80 mm' --a '31 mm' -o construction.svg
  epicyclic motor --stator 6 --rotor 4 --z3 66 --zs 10 --module '2 mm' \\
      --angle '30 deg' --view chambers --svg chambers.svg
  epicyclic motor --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' \\
      --view teeth --dxf teeth.dxf --csv centrodes.csv --format json
  epicyclic motor --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' \\
      --view dimensions -o dimensions.pdf
  epicyclic motor --stator 6 --rotor 4 --z3 66 --zs 10 --module '2 mm' \\
      --width '50 mm' --pressure '20 MPa' --speed '100 rpm' \\
      --oil 'viscosity: 46 mm²/s, density: 870 kg/m³, bulk_modulus: 1.4 GPa' \\
      --gaps 'satellites: 10 µm' --friction 0.05..0.1 --ports 'part: 0.9'
  epicyclic motor search --displacement '250 cm3/rev' --module '2 mm' \\
      --stator 5..6 --z3 ..66
  epicyclic motor forms --torque '600 N·m' --pressure '20 MPa' --module '2 mm' \\
      --stator 6 --z3 66 --zs 10 --addendum 0.75..0.85/3")]
pub(crate) struct Args {
    #[command(subcommand)]
    command: Option<Command>,

    #[command(flatten)]
    design: Design,
}

#[derive(Debug, clap::Subcommand)]
enum Command {
    Search(Box<search::Args>),
    Forms(Box<forms::Args>),
}

/// What describes a motor where no file does.
const OF_A_MOTOR: [&str; 12] =
    ["stator", "rotor", "z3", "z1", "zs", "module", "place", "width", "pressure", "speed", "Teeth", "Made"];

/// A motor and what is wanted of it.
#[derive(Debug, clap::Args)]
#[command(group = clap::ArgGroup::new("place").multiple(true))]
pub(crate) struct Design {
    /// File of a motor in YAML, in place of the options that describe one; - for standard input.
    #[arg(value_name = "FILE", conflicts_with_all = OF_A_MOTOR)]
    file: Option<PathBuf>,

    /// Lobes of the stator, N.
    #[arg(long, value_name = "N", required_unless_present = "file")]
    stator: Option<u32>,

    /// Lobes of the rotor, n: 1 to 3 fewer.
    #[arg(long, value_name = "N", required_unless_present = "file")]
    rotor: Option<u32>,

    /// Teeth of the stator, Z₃: a whole number for each lobe.
    #[arg(long, value_name = "TEETH", required_unless_present = "file")]
    z3: Option<u32>,

    /// Teeth of the rotor, Z₁; they follow from the others and are checked where given.
    #[arg(long, value_name = "TEETH")]
    z1: Option<u32>,

    /// Teeth of a satellite, Z_s: fewer than (Z₃ − Z₁)/2. Without them all satellites are listed, each with
    /// a motor.
    #[arg(long, value_name = "TEETH")]
    zs: Option<u32>,

    /// Module of the teeth.
    #[arg(long, required_unless_present = "file", allow_hyphen_values = true)]
    module: Option<Quantity<Length>>,

    /// Distance l of the centres of the stator's arcs at the troughs from the axis. Default: the middle of the family.
    #[arg(long, group = "place", allow_hyphen_values = true)]
    l: Option<Quantity<Length>>,

    /// Instead of --l the distance a of the centres of the arcs at the crests. Together with --l:
    /// --construction of arcs that need not close.
    #[arg(long, group = "place", allow_hyphen_values = true)]
    a: Option<Quantity<Length>>,

    /// Instead of --l the part of the family, from 0 (arcs at the troughs vanish) to 1, even in 1/l.
    #[arg(long, value_name = "NUMBER", group = "place", conflicts_with_all = ["l", "a"], allow_negative_numbers = true)]
    part: Option<Number>,

    /// A rotor by the cosine law, and the stator conjugate to it: one motor, no family.
    #[arg(long, group = "place", conflicts_with_all = ["l", "a", "part"])]
    cosine: bool,

    /// Relative amplitude ε₂ of a second harmonic of the cosine law.
    #[arg(long, value_name = "NUMBER", requires = "cosine", allow_negative_numbers = true)]
    second_harmonic: Option<Number>,

    /// The construction of the arcs in place of the motor: system (1), how far the rotor is from closing,
    /// and formulas (2)-(8). Drawings show it.
    #[arg(long)]
    construction: bool,

    /// Width of the wheels, for displacement, torque and forces.
    #[arg(long, allow_hyphen_values = true)]
    width: Option<Quantity<Length>>,

    /// Pressure drop, high less low, for torque and forces.
    #[arg(long, requires = "width", allow_hyphen_values = true)]
    pressure: Option<Quantity<Pressure>>,

    /// Speed of the rotor, for flow and power.
    #[arg(long, requires = "width", allow_hyphen_values = true)]
    speed: Option<Quantity<AngularVelocity>>,

    /// Angle of the rotor from where one of its crests faces one of the stator's, for chambers, satellites and drawings. Default: that of the file, else 0 deg.
    #[arg(long, allow_hyphen_values = true)]
    angle: Option<Quantity<Angle>>,

    #[command(flatten)]
    teeth: Teeth,

    #[command(flatten)]
    made: made::Made,

    #[command(flatten)]
    files: Files,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    page: PageArgs,
}

/// Form of the teeth; lengths in modules.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Teeth, lengths in modules")]
struct Teeth {
    /// Pressure angle of the satellites.
    #[arg(long, default_value = "25 deg", allow_hyphen_values = true)]
    pressure_angle: Quantity<Angle>,

    /// Addendum h_a*.
    #[arg(long, value_name = "NUMBER", default_value = "0.85", allow_negative_numbers = true)]
    addendum: Number,

    /// Clearance c* of tips over roots.
    #[arg(long, value_name = "NUMBER", default_value = "0.25", allow_negative_numbers = true)]
    clearance: Number,

    /// Profile shift x of the satellites; the wheels have −x.
    #[arg(long, value_name = "NUMBER", default_value = "0.2", allow_negative_numbers = true)]
    shift: Number,

    /// Backlash j* along the pitch curves.
    #[arg(long, value_name = "NUMBER", default_value = "0.04", allow_negative_numbers = true)]
    backlash: Number,

    /// Radius ρ* of the rounded tips of the cutters.
    #[arg(long, value_name = "NUMBER", default_value = "0.1", allow_negative_numbers = true)]
    fillet: Number,

    /// What lies in the middle of the stator's crests: space, tooth.
    #[arg(long, value_name = "CREST", default_value = "space")]
    crest: Crest,
}

/// Drawings and curves.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Drawings and curves, each file written whole or not at all")]
struct Files {
    /// What is drawn into --svg, --dxf, or an --output that ends in .svg, .dxf, .pdf or .png. Default: the whole motor.
    #[arg(long, value_enum)]
    view: Option<View>,

    /// Pixels to an inch of a PNG image, 20 to 2400; an image has at most 100 million pixels. Default: 300.
    #[arg(long, value_name = "NUMBER", requires = "output")]
    dpi: Option<Number>,

    /// File for the drawing as an SVG image, one unit a millimetre.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,

    /// File for the drawing as DXF in millimetres, for CAD.
    #[arg(long, value_name = "FILE")]
    dxf: Option<PathBuf>,

    /// File for points of the centrodes with direction and curvature, in millimetres and degrees.
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,

    /// Points of each half-lobe in that file.
    #[arg(long, value_name = "NUMBER", requires = "csv", default_value_t = 100)]
    points: u32,
}

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum View {
    /// Stator, rotor, satellites, and how the arcs are constructed.
    Centrodes,
    /// Half a lobe of stator and rotor with the construction of the arcs, (1)-(8).
    Construction,
    /// Every tooth in mesh.
    Teeth,
    /// The motor in its housing with its ports.
    Motor,
    /// The chambers coloured by pressure.
    Chambers,
    /// Dimensions and a table of wheel data, for a drawing office.
    Dimensions,
    /// Forces on the satellites and on the rotor's bearing, with --width and --pressure.
    Forces,
    /// The ports as made, with --ports.
    Ports,
    /// Pressure in a chamber over its cycle, with --ports and the bulk modulus of --oil.
    Pressure,
    /// Contact stress of a satellite over its cycle, with --pressure.
    Stress,
    /// Total efficiency over speed and pressure, with --gaps, --oil and --friction.
    Efficiency,
}

/// Runs the command.
pub(crate) fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    match &args.command {
        Some(Command::Search(args)) => return search::run(call, args),
        Some(Command::Forms(args)) => return forms::run(call, args),
        None => {}
    }
    let Design { files, page: options, output, .. } = &args.design;
    options.only_of_a_page(output.is_page())?;
    let wanted = files::wanted(files, output);
    wanted.check(files)?;
    let Some(file) = &args.design.file else {
        if args.design.zs.is_none() {
            return satellites::run(call, &args.design);
        }
        if construction::is_asked(&args.design) {
            return construction::run(call, &args.design, &wanted, None);
        }
        let designed = design::read(&args.design)?;
        return deliver(call, &args.design, &wanted, None, &designed, &design::refuse);
    };
    let document = input::document(call, file)?;
    let in_file = |failure: Failure| failure.in_file(&document, &Path::root());
    let (title, mut designed) = answers::motor::of_file(&document).map_err(|error| in_file(error.into()))?;
    if construction::is_asked(&args.design) {
        return construction::run(call, &args.design, &wanted, Some(&designed)).map_err(in_file);
    }
    if let Some(angle) = &args.design.angle {
        designed.angle = angle.0;
    }
    let refuse = |error| design::refuse_of_file(error, args.design.angle.is_some());
    deliver(call, &args.design, &wanted, title, &designed, &refuse).map_err(in_file)
}

impl Design {
    /// Options of a closed motor that say nothing of its arcs or teeth, and whether each is given.
    fn beyond_the_arcs(&self) -> Vec<(&'static str, bool)> {
        let own = [
            ("--width", self.width.is_some()),
            ("--angle", self.angle.is_some()),
            ("--csv", self.files.csv.is_some()),
        ];
        own.into_iter().chain(self.made.given()).collect()
    }
}

impl Teeth {
    /// Its options, and whether each differs from its default.
    fn given(&self) -> [(&'static str, bool); 7] {
        let (given, usual) = (design::form(self), ToothForm::default());
        [
            ("--pressure-angle", given.pressure_angle != usual.pressure_angle),
            ("--addendum", given.addendum != usual.addendum),
            ("--clearance", given.clearance != usual.clearance),
            ("--shift", given.shift != usual.shift),
            ("--backlash", given.backlash != usual.backlash),
            ("--fillet", given.fillet != usual.fillet),
            ("--crest", given.crest != usual.crest),
        ]
    }
}

/// Refuses the first option that is given in vain.
fn refuse_given(
    options: impl IntoIterator<Item = (&'static str, bool)>,
    message: &str,
) -> Result<(), Failure> {
    match options.into_iter().find(|(_, is_given)| *is_given) {
        Some((option, _)) => Err(Failure::Option { option, message: message.to_owned() }),
        None => Ok(()),
    }
}

fn deliver(
    call: &Call<'_>,
    Design { files, page: options, output, .. }: &Design,
    wanted: &files::Wanted,
    title: Option<String>,
    designed: &Designed,
    refuse: &dyn Fn(answers::Error) -> Failure,
) -> Result<(), Failure> {
    let (files, output) = (files::content(files, wanted, designed, refuse)?, output.but_for_drawings());
    if output.is_page() {
        let report = report::motor::answer(title, designed).map_err(refuse)?;
        let sheet = page::motor::sheet(&report, designed, imprint::command(call));
        return output.deliver_page(call, files, &report.motor, sheet, &options.imprint());
    }
    let answer = answers::motor::answer(designed).map_err(refuse)?;
    output.deliver_with(call, files, &answer)
}

/// A motor as a drawing.
pub(crate) fn scene(view: View, designed: &Designed) -> Result<Scene, Failure> {
    files::scene(view, designed)
}
