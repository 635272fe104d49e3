//! The program `epicyclic`: planetary gear mechanisms on the command line.
//!
//! | module | is |
//! |---|---|
//! | [`teeth`] | the command `teeth`: tooth numbers for a ratio |
//! | [`drive`] | the command `drive`: a whole planetary drive from a file |
//! | [`analyze`] | the command `analyze`: every gear of any planetary gearbox |
//! | [`select`] | the command `select`: the gearbox for given speeds |
//! | [`schemes`] | the command `schemes`: the catalogue of two and three speeds |
//! | [`draw`] | the command `draw`: schemes, speed plans, levers and ladders as SVG and DXF |
//! | [`machine`] | the command `machine`: speeds of mining machines |
//! | [`page`] | the command `report`: a page about a file |
//! | [`schema`] | the command `schema`: JSON Schemas of the files |
//! | [`completions`], [`man`] | the commands of these names, for shells and `man` |
//! | [`motor`] | the command `motor`: a hydromotor and its drawings |
//! | [`lists`] | options that take several values |
//! | [`options`] | the option that a refusal speaks of |
//! | [`report`], [`figure`] | answers of several parts, and their values, written three ways |
//! | [`input`] | files that are read |
//! | [`output`] | formats, and files written whole or not at all |
//! | [`progress`] | how far a long search is, on a terminal |
//! | [`failure`] | what ends the program, and with which exit code |
//!
//! Exit codes: see [`failure`].

mod analyze;
mod completions;
mod draw;
mod drive;
mod failure;
mod figure;
mod input;
mod lists;
mod machine;
mod man;
mod motor;
mod options;
mod output;
mod page;
mod progress;
mod report;
#[cfg(test)]
mod robustness;
mod schema;
mod schemes;
mod select;
mod teeth;

use clap::{CommandFactory as _, Parser, Subcommand};
use epicyclic_formats::quantity::find_unit;
use std::process::ExitCode;

/// Planetary gear mechanisms: tooth numbers, drives, gearboxes of several speeds, hydromotors.
#[derive(Parser)]
#[command(version, max_term_width = 80, after_help = failure::EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Teeth(teeth::Args),
    Drive(drive::Args),
    Analyze(analyze::Args),
    Select(Box<select::Args>),
    Schemes(schemes::Args),
    Machine(machine::Args),
    Motor(Box<motor::Args>),
    Draw(Box<draw::Args>),
    Report(page::Args),
    Schema(schema::Args),
    Completions(completions::Args),
    Man(man::Args),
}

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        // Help and version are answers, and may fail to be written like any.
        Err(asked) if !asked.use_stderr() => {
            return end(asked.print().map_err(failure::Failure::StandardOutput));
        }
        Err(wrong) => {
            let _ = wrong.print();
            if let Some(unit) = loose_unit(&wrong) {
                output::complain(&format!(
                    "\nA quantity is one word: put it in quotes, '2 {unit}', or leave out the blank, 2{unit}."
                ));
            }
            return ExitCode::from(failure::WRONG);
        }
    };
    end(run(cli.command))
}

/// A unit that stands by itself where an option or command is due: the shell parted it from its number.
fn loose_unit(error: &clap::Error) -> Option<&str> {
    use clap::error::{ContextKind, ContextValue};
    let kinds = [ContextKind::InvalidArg, ContextKind::InvalidSubcommand];
    let mut words = kinds.into_iter().filter_map(|kind| match error.get(kind) {
        Some(ContextValue::String(word)) => Some(word.as_str()),
        _ => None,
    });
    words.find(|word| find_unit(word).is_some())
}

fn run(command: Command) -> Result<(), failure::Failure> {
    match command {
        Command::Teeth(args) => teeth::run(&args),
        Command::Drive(args) => drive::run(&args),
        Command::Analyze(args) => analyze::run(&args),
        Command::Select(args) => select::run(&args),
        Command::Schemes(args) => schemes::run(&args),
        Command::Machine(args) => machine::run(&args),
        Command::Motor(args) => motor::run(&args),
        Command::Draw(args) => draw::run(&args),
        Command::Report(args) => page::run(&args),
        Command::Schema(args) => schema::run(&args),
        Command::Completions(args) => completions::run(&args, Cli::command()),
        Command::Man(args) => man::run(&args, Cli::command()),
    }
}

fn end(done: Result<(), failure::Failure>) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if !failure.is_quiet() {
                output::complain(&format!("error: {failure}"));
            }
            ExitCode::from(failure.code())
        }
    }
}
