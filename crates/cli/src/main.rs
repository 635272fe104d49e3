//! The program `epicyclic`: planetary gear mechanisms on the command line.
//!
//! | module | is |
//! |---|---|
//! | [`teeth`] | the command `teeth`: tooth numbers for a ratio |
//! | [`drive`] | the command `drive`: a whole planetary drive from a file |
//! | [`analyze`] | the command `analyze`: every gear of any planetary gearbox |
//! | [`select`] | the command `select`: the gearbox for given speeds |
//! | [`schemes`] | the command `schemes`: the catalogue of two and three speeds |
//! | [`machine`] | the command `machine`: speeds of mining machines |
//! | [`motor`] | the command `motor`: a hydromotor and its drawings |
//! | [`lists`] | options that take several values |
//! | [`report`], [`figure`] | answers of several parts, and their values, written three ways |
//! | [`output`] | formats, and files written whole or not at all |
//! | [`failure`] | what ends the program, and with which exit code |
//!
//! Exit codes: 0 answered, 1 refused (bad input, no answer), 2 wrong usage.

mod analyze;
mod drive;
mod failure;
mod figure;
mod lists;
mod machine;
mod motor;
mod output;
mod report;
mod schemes;
mod select;
mod teeth;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Planetary gear mechanisms: tooth numbers, drives, gearboxes of several speeds, hydromotors.
#[derive(Parser)]
#[command(version, max_term_width = 80)]
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
}

fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::Teeth(args) => teeth::run(&args),
        Command::Drive(args) => drive::run(&args),
        Command::Analyze(args) => analyze::run(&args),
        Command::Select(args) => select::run(&args),
        Command::Schemes(args) => schemes::run(&args),
        Command::Machine(args) => machine::run(&args),
        Command::Motor(args) => motor::run(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            output::complain(&format!("error: {failure}"));
            ExitCode::FAILURE
        }
    }
}
