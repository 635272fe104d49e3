//! The command `schema`: JSON Schemas of the files that the program reads and of the answers that it gives.

use epicyclic_commands::analyze::answer::combinations::Combinations;
use epicyclic_commands::analyze::answer::formulas::Formulas;
use epicyclic_commands::analyze::answer::gear::OneGear;
use epicyclic_commands::analyze::answer::inputs::Inputs;
use epicyclic_commands::analyze::answer::inputs::map::Map;
use epicyclic_commands::analyze::answer::overview::Overview;
use epicyclic_commands::analyze::answer::shifts::Shifts;
use epicyclic_commands::answer::{schema, schema_of_file};
use epicyclic_commands::compare::answer::Comparison;
use epicyclic_commands::design::answer::Design;
use epicyclic_commands::design::answer::stages::Stages;
use epicyclic_commands::design::answer::transmission::Transmission;
use epicyclic_commands::desk::Call;
use epicyclic_commands::draw::answer::Drawing;
use epicyclic_commands::drive::answer::Drive;
use epicyclic_commands::failure::Failure;
use epicyclic_commands::losses::answer::{LossMap, Losses};
use epicyclic_commands::machine::answer::{ChainCutter, Drum, MachineSpeeds, Machines, Rotor};
use epicyclic_commands::motor::answer::Motor;
use epicyclic_commands::motor::construction::answer::MotorConstruction;
use epicyclic_commands::motor::forms::answer::MotorForms;
use epicyclic_commands::motor::satellites::answer::MotorSatellites;
use epicyclic_commands::motor::search::answer::MotorSearch;
use epicyclic_commands::output::{self, Target};
use epicyclic_commands::refused::Refused;
use epicyclic_commands::report::answer::Report;
use epicyclic_commands::schemes::answer::{Scheme, Schemes};
use epicyclic_commands::select::answer::Select;
use epicyclic_commands::select::answer::teeth::SelectTeeth;
use epicyclic_commands::shared::transmissions::answer::Transmissions;
use epicyclic_commands::sheet::answer::DataSheets;
use epicyclic_commands::simulate::answer::Simulation;
use epicyclic_commands::simulate::answer::sweep::Sweep;
use epicyclic_commands::size::answer::Size;
use epicyclic_commands::strength::answer::Strength;
use epicyclic_commands::synthesize::answer::Synthesis;
use epicyclic_commands::teeth::answer::Teeth;
use epicyclic_commands::teeth::answer::arranged::ArrangedSets;
use epicyclic_commands::teeth::answer::double_planet::DoublePlanetTeeth;
use epicyclic_commands::teeth::answer::shifted::ShiftedTeeth;
use epicyclic_commands::vibrate::answer::Vibration;
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
    /// The answer of `epicyclic teeth --kind` for all kinds but simple and double.
    AnswerTeethArranged,
    /// The answer of `epicyclic teeth --kind double-planet`.
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
    /// The answer of `epicyclic design` for one ratio.
    AnswerDesignStages,
    AnswerDesignTransmission,
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
        Of::AnswerTeethArranged => schema::<ArrangedSets>(),
        Of::AnswerTeethDoublePlanet => schema::<DoublePlanetTeeth>(),
        Of::AnswerTeethShifted => schema::<ShiftedTeeth>(),
        Of::AnswerSelect => schema::<Select>(),
        Of::AnswerSelectTeeth => schema::<SelectTeeth>(),
        Of::AnswerStrength => schema::<Strength>(),
        Of::AnswerSheet => schema::<DataSheets>(),
        Of::AnswerSize => schema::<Size>(),
        Of::AnswerDesign => schema::<Design>(),
        Of::AnswerDesignStages => schema::<Stages>(),
        Of::AnswerDesignTransmission => schema::<Transmission>(),
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
