//! The command `schema`: JSON Schemas of the files that the program reads and of the answers that it gives.

use crate::desk::Call;
use crate::failure::Failure;
use crate::output::{self, Target};
use epicyclic_answers::analyze::combinations::Combinations;
use epicyclic_answers::analyze::formulas::Formulas;
use epicyclic_answers::analyze::gear::OneGear;
use epicyclic_answers::analyze::inputs::Inputs;
use epicyclic_answers::analyze::inputs::map::Map;
use epicyclic_answers::analyze::overview::Overview;
use epicyclic_answers::analyze::shifts::Shifts;
use epicyclic_answers::answer::{schema, schema_of_file};
use epicyclic_answers::compare::Comparison;
use epicyclic_answers::design::Design;
use epicyclic_answers::draw::Drawing;
use epicyclic_answers::drive::Drive;
use epicyclic_answers::losses::{LossMap, Losses};
use epicyclic_answers::machine::{ChainCutter, Drum, MachineSpeeds, Machines, Rotor};
use epicyclic_answers::motor::{Motor, MotorConstruction, MotorSatellites};
use epicyclic_answers::motor_forms::MotorForms;
use epicyclic_answers::motor_search::MotorSearch;
use epicyclic_answers::refused::Refused;
use epicyclic_answers::report::Report;
use epicyclic_answers::schemes::{Scheme, Schemes};
use epicyclic_answers::select::Select;
use epicyclic_answers::select::teeth::SelectTeeth;
use epicyclic_answers::sheet::DataSheets;
use epicyclic_answers::simulate::Simulation;
use epicyclic_answers::simulate::sweep::Sweep;
use epicyclic_answers::size::Size;
use epicyclic_answers::strength::Strength;
use epicyclic_answers::synthesize::Synthesis;
use epicyclic_answers::teeth::Teeth;
use epicyclic_answers::teeth::double_planet::DoublePlanetTeeth;
use epicyclic_answers::teeth::shifted::ShiftedTeeth;
use epicyclic_answers::transmissions::Transmissions;
use epicyclic_answers::vibration::Vibration;
use epicyclic_formats::drive::DriveFile;
use epicyclic_formats::gearbox::{GearboxFile, TransmissionsFile};
use epicyclic_formats::motor::MotorFile;
use epicyclic_formats::scenario::ScenarioFile;

/// The JSON Schema of a file that the program reads, or of an answer in JSON.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  epicyclic schema gearbox -o gearbox.schema.json

With the YAML language server a first line `# yaml-language-server:
$schema=gearbox.schema.json` then completes and checks the file.")]
pub(crate) struct Args {
    /// Which file or answer.
    #[arg(value_enum)]
    of: Of,

    #[command(flatten)]
    target: Target,
}

/// The files, then the answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Of {
    /// Of `epicyclic drive`.
    Drive,
    /// Of `epicyclic analyze`: a gearbox.
    Gearbox,
    /// Of `epicyclic analyze`: transmissions with published ratios.
    Transmissions,
    /// Of `epicyclic report`: a hydromotor.
    Motor,
    /// Of `epicyclic simulate`.
    Scenario,
    /// The answer of `epicyclic analyze`: all gears.
    AnswerAnalyze,
    /// The answer of `epicyclic analyze --gear`.
    AnswerAnalyzeGear,
    /// The answer of `epicyclic analyze --gear` with several inputs.
    AnswerAnalyzeInputs,
    /// The answer of `epicyclic analyze --map`.
    AnswerAnalyzeMap,
    /// The answer of `epicyclic analyze --all-combinations`.
    AnswerAnalyzeCombinations,
    /// The answer of `epicyclic analyze --shifts`.
    AnswerAnalyzeShifts,
    /// The answer of `epicyclic analyze --formula`, and with `--steps`.
    AnswerAnalyzeFormulas,
    /// The answer of `epicyclic analyze` on a list of transmissions.
    AnswerTransmissions,
    /// The answer of `epicyclic compare`.
    AnswerCompare,
    /// The answer of `epicyclic drive`.
    AnswerDrive,
    /// The answer of `epicyclic motor`.
    AnswerMotor,
    /// The answer of `epicyclic motor` without the teeth of a satellite: all satellites.
    AnswerMotorSatellites,
    /// The answer of `epicyclic motor --construction`, and of `--l` with `--a`.
    AnswerMotorConstruction,
    /// The answer of `epicyclic motor search`.
    AnswerMotorSearch,
    /// The answer of `epicyclic motor forms`.
    AnswerMotorForms,
    /// The answer of `epicyclic teeth`.
    AnswerTeeth,
    /// The answer of `epicyclic teeth --double-planet`.
    AnswerTeethDoublePlanet,
    /// The answer of `epicyclic teeth --ring-offset`.
    AnswerTeethShifted,
    /// The answer of `epicyclic select`.
    AnswerSelect,
    /// The answer of `epicyclic select --teeth`.
    AnswerSelectTeeth,
    /// The answer of `epicyclic strength`.
    AnswerStrength,
    /// The answer of `epicyclic sheet`.
    AnswerSheet,
    /// The answer of `epicyclic size`.
    AnswerSize,
    /// The answer of `epicyclic design`.
    AnswerDesign,
    /// The answer of `epicyclic losses`.
    AnswerLosses,
    /// The answer of `epicyclic losses` with a map.
    AnswerLossesMap,
    /// The answer of `epicyclic simulate`.
    AnswerSimulate,
    /// The answer of `epicyclic simulate --sweep`.
    AnswerSimulateSweep,
    /// The answer of `epicyclic vibrate`.
    AnswerVibrate,
    /// The answer of `epicyclic synthesize`.
    AnswerSynthesize,
    /// The answer of `epicyclic schemes`.
    AnswerSchemes,
    /// The answer of `epicyclic schemes` with a name.
    AnswerScheme,
    /// The answer of `epicyclic machine list`.
    AnswerMachines,
    /// The answer of `epicyclic machine speeds`.
    AnswerMachineSpeeds,
    /// The answer of `epicyclic machine chain-cutter`.
    AnswerMachineChainCutter,
    /// The answer of `epicyclic machine drum`.
    AnswerMachineDrum,
    /// The answer of `epicyclic machine rotor`.
    AnswerMachineRotor,
    /// The answer of `epicyclic draw`.
    AnswerDraw,
    /// The answer of `epicyclic report`.
    AnswerReport,
    /// In place of an answer: why there is none.
    AnswerError,
}

/// Runs the command.
pub(crate) fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let schema = match args.of {
        Of::Drive => schema_of_file::<DriveFile>("drive"),
        Of::Gearbox => schema_of_file::<GearboxFile>("gearbox"),
        Of::Transmissions => schema_of_file::<TransmissionsFile>("transmissions"),
        Of::Motor => schema_of_file::<MotorFile>("motor"),
        Of::Scenario => schema_of_file::<ScenarioFile>("scenario"),
        Of::AnswerAnalyze => schema::<Overview>(),
        Of::AnswerAnalyzeGear => schema::<OneGear>(),
        Of::AnswerAnalyzeInputs => schema::<Inputs>(),
        Of::AnswerAnalyzeMap => schema::<Map>(),
        Of::AnswerAnalyzeCombinations => schema::<Combinations>(),
        Of::AnswerAnalyzeShifts => schema::<Shifts>(),
        Of::AnswerAnalyzeFormulas => schema::<Formulas>(),
        Of::AnswerTransmissions => schema::<Transmissions>(),
        Of::AnswerCompare => schema::<Comparison>(),
        Of::AnswerDrive => schema::<Drive>(),
        Of::AnswerMotor => schema::<Motor>(),
        Of::AnswerMotorSatellites => schema::<MotorSatellites>(),
        Of::AnswerMotorConstruction => schema::<MotorConstruction>(),
        Of::AnswerMotorSearch => schema::<MotorSearch>(),
        Of::AnswerMotorForms => schema::<MotorForms>(),
        Of::AnswerTeeth => schema::<Teeth>(),
        Of::AnswerTeethDoublePlanet => schema::<DoublePlanetTeeth>(),
        Of::AnswerTeethShifted => schema::<ShiftedTeeth>(),
        Of::AnswerSelect => schema::<Select>(),
        Of::AnswerSelectTeeth => schema::<SelectTeeth>(),
        Of::AnswerStrength => schema::<Strength>(),
        Of::AnswerSheet => schema::<DataSheets>(),
        Of::AnswerSize => schema::<Size>(),
        Of::AnswerDesign => schema::<Design>(),
        Of::AnswerLosses => schema::<Losses>(),
        Of::AnswerLossesMap => schema::<LossMap>(),
        Of::AnswerSimulate => schema::<Simulation>(),
        Of::AnswerSimulateSweep => schema::<Sweep>(),
        Of::AnswerVibrate => schema::<Vibration>(),
        Of::AnswerSynthesize => schema::<Synthesis>(),
        Of::AnswerSchemes => schema::<Schemes>(),
        Of::AnswerScheme => schema::<Scheme>(),
        Of::AnswerMachines => schema::<Machines>(),
        Of::AnswerMachineSpeeds => schema::<MachineSpeeds>(),
        Of::AnswerMachineChainCutter => schema::<ChainCutter>(),
        Of::AnswerMachineDrum => schema::<Drum>(),
        Of::AnswerMachineRotor => schema::<Rotor>(),
        Of::AnswerDraw => schema::<Drawing>(),
        Of::AnswerReport => schema::<Report>(),
        Of::AnswerError => schema::<Refused>(),
    };
    args.target.write(call, output::json(&schema)?.as_bytes())
}
