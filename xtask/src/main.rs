//! `cargo xtask`: the project's own commands.

use clap::{Parser, Subcommand};
use std::process::ExitCode;
#[cfg(feature = "book")]
use xtask::book;
use xtask::{new_case, same, schema, tidy, verify};

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
    Same(same::Arguments),
    #[cfg(feature = "book")]
    Book(book::Arguments),
    #[cfg(not(feature = "book"))]
    Book(Anew),
}

/// Build the book as web pages.
#[cfg(not(feature = "book"))]
#[derive(Debug, clap::Args)]
#[command(disable_help_flag = true)]
struct Anew {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<std::ffi::OsString>,
}

#[cfg(not(feature = "book"))]
mod book {
    use std::process::{Command, ExitCode};

    /// Builds this program again, with the feature `book`, and runs `book` there: `cargo xtask` leaves the
    /// feature out.
    pub(super) fn run(anew: &super::Anew) -> Result<ExitCode, String> {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let status = Command::new(cargo)
            .args(["run", "--quiet", "--locked", "--package", "xtask", "--features", "book", "--", "book"])
            .args(&anew.arguments)
            .status()
            .map_err(|error| format!("cargo cannot be run: {error}"))?;
        Ok(status.code().and_then(|code| u8::try_from(code).ok()).map_or(ExitCode::FAILURE, ExitCode::from))
    }
}

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Schema(arguments) => schema::run(&arguments),
        Command::NewCase(arguments) => new_case::run(&arguments),
        Command::Tidy(arguments) => tidy::run(&arguments),
        Command::Same(arguments) => same::run(&arguments),
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
