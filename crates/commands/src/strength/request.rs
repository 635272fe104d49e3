//! The command `strength`: safeties of teeth by ISO 6336.

use crate::analyze::answer::pins::OF_PINS;
use crate::desk::Call;
use crate::error::Error;
use crate::failure::Failure;
use crate::input;
use crate::output::OutputArgs;
use crate::shared::gearbox::{Gearbox, alone};
use crate::shared::gearbox_choice::refuse;
use crate::shared::judgement::answer::Judgement;
use crate::shared::tooth_checks::answer::ToothChecks;
use crate::strength::answer::{self as answers, Strength};
use crate::strength::options::Request;
use epicyclic_judge::Rule;
use std::path::PathBuf;

/// Strength of the teeth of a gearbox by ISO 6336, method B: safeties of flanks and roots.
///
/// With --torque or --power and --speed the stresses, limits and safeties in each gear at this load for the
/// required life; without them damage, safety and life over the duty of the file, by Miner's rule. Torques
/// are those without losses; their direction does not matter. Sets that lack data are named with what is
/// missing.
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("examples.txt"))]
pub struct Args {
    /// The file, in YAML, or - for standard input.
    #[arg(value_name = "FILE", value_hint = clap::ValueHint::FilePath)]
    file: PathBuf,

    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    output: OutputArgs,
}

impl Request {
    /// Computes the strength at the load, or without one over the duty of the file.
    ///
    /// # Errors
    /// - [`Failure::Option`] for a gear or speed without a load, a load without a speed, a gear that the
    ///   gearbox does not have.
    /// - [`Failure::Answer`] if nothing can be rated, or with the place of invalid data in the file.
    pub fn answer(&self, gearbox: &Gearbox) -> Result<Strength, Failure> {
        self.judged(gearbox).map_err(|error| {
            let option = match &error {
                Error::LoadWithoutSpeed => "--speed",
                Error::OfOnePoint if self.gear.is_some() => "--gear",
                Error::OfOnePoint => "--speed",
                _ => return refuse(error),
            };
            Failure::of_option(option, &error)
        })
    }
}

impl Request {
    fn judged(&self, gearbox: &Gearbox) -> Result<Strength, Error> {
        // The judge looks at factors, whether they are asked for or not.
        let mut strength = answers::answer(gearbox, &Self { factors: true, ..self.clone() })?;
        strength.judgement = Judgement::of(gearbox, None, Some(&strength), None);
        let teeth = ToothChecks::of(gearbox.tooth_checks(), |_| true);
        // Safeties and lives have warnings of their own, and so have speeds of planets on bearings.
        let is_told = strength.warnings.iter().any(|warning| warning.name == "planet-speed");
        let of_pins = if is_told { &OF_PINS[..] } else { &[] };
        let own = [&[Rule::FlankSafety, Rule::RootSafety, Rule::BearingLife], of_pins].concat();
        let judged = strength.judgement.warnings(&own);
        strength.warnings.extend(teeth.warnings().chain(judged));
        if !self.factors {
            strength.at_point.iter_mut().for_each(|one| one.factors.clear());
            strength.over_duty.iter_mut().for_each(|one| one.factors.clear());
        }
        Ok(strength)
    }
}

/// Runs the command.
pub fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let Args { file, request, output } = args;
    let gearbox = alone(&input::document(call, file)?, "strength", "no modules, materials or loads")?;
    output.deliver(call, &request.answer(&gearbox)?)
}
