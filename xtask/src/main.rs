//! `cargo xtask`: the project's own commands.

use clap::{Parser, Subcommand};
use std::process::ExitCode;
use xtask::{book, new_case, schema, tidy, verify};

/// Verification of the project against its source documents.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Verify(verify::Arguments),
    Schema(schema::Arguments),
    NewCase(new_case::Arguments),
    Tidy(tidy::Arguments),
    Book(book::Arguments),
}

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Schema(arguments) => schema::run(&arguments),
        Command::NewCase(arguments) => new_case::run(&arguments),
        Command::Tidy(arguments) => tidy::run(&arguments),
        Command::Book(arguments) => book::run(&arguments),
    };
    match result {
        Ok(code) => code,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}
