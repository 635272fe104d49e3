//! The program `epicyclic`: planetary gear mechanisms on the command line.
//!
//! | module | is |
//! |---|---|
//! | [`teeth`] | the command `teeth`: tooth numbers for a ratio |
//! | [`drive`] | the command `drive`: a whole planetary drive from a file |
//! | [`output`] | formats, and files written whole or not at all |
//! | [`failure`] | what ends the program, and with which exit code |
//!
//! Exit codes: 0 answered, 1 refused (bad input, no answer), 2 wrong usage.

mod drive;
mod failure;
mod output;
mod teeth;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Planetary gear mechanisms: tooth numbers, drives.
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
}

fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::Teeth(args) => teeth::run(&args),
        Command::Drive(args) => drive::run(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            output::complain(&format!("error: {failure}"));
            ExitCode::FAILURE
        }
    }
}
