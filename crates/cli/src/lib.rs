//! Planetary gear mechanisms as a library: what the program `epicyclic` answers, as types.
//!
//! Each command is a module: its `Request` has the options of the command line as fields, and `answer` gives
//! the record that the program prints. Numbers of records are in SI units, and the names of keys end in the
//! unit.
//!
//! ```
//! use epicyclic::{Gearbox, losses};
//!
//! let text = "{ gearbox: one set, input: a, output: h, gears: [{ name: only }],
//!     sets: [{ id: P, sun: a, ring: ground, carrier: h, teeth: [20, 80], efficiency: 0.98 }] }";
//! let gearbox = Gearbox::parse("one-set.yaml", text.as_bytes())?;
//! let request = losses::Request {
//!     speed: Some("1475 rpm".parse()?),
//!     power: Some("75 kW".parse()?),
//!     ..losses::Request::default()
//! };
//! let found = request.answer(&gearbox)?;
//! // Of the power, 1 − 1/5 rolls through the meshes, and 2 % of it are lost there.
//! assert!((found.gears[0].loss_w - 75e3 * 0.8 * 0.02).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Where a request has many fields, [`request`] fills in those that are not named:
//!
//! ```
//! use epicyclic::{request, select};
//!
//! let request = select::Request { nth: 2, ..request(["--speeds", "0.8 m/s, 3.15 m/s"])? };
//! assert_eq!(request.answer()?.shown_in_full, Some(2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`to_json`] and [`AsReport`] write any answer as the program does. [`call`] answers a whole command line:
//! all input and output goes through a [`Desk`], a terminal for the program, memory for a page in a browser,
//! both for other languages.
//!
//! ```
//! use epicyclic::{Memory, call};
//!
//! let desk = Memory::default();
//! assert_eq!(call(["teeth", "--ratio", "6", "--limit", "1", "--format", "json"], &desk), 0);
//! let answer = String::from_utf8(desk.into_kept().answer).unwrap();
//! assert!(answer.starts_with("{\n  \"schema_version\": 1,\n  \"answer\": \"teeth\""));
//! ```
//!
//! | feature | adds |
//! |---|---|
//! | `terminal` | the program: progress and Ctrl-C on a terminal, `completions` and `man` |
//! | `tables` | Parquet tables: `atlas`, and `synthesize` in shards |
//! | `print` | drawings as PDF and PNG |
//! | `parallel` | searches on all threads |
//! | `serve`, `app` | the command `serve`; with the app in the program |
//!
//! | module | is |
//! |---|---|
//! | [`examples`] | an example of each command |
//! | [`desk`] | what a call needs of the world around it |
//! | `schema` | the command `schema`: JSON Schemas of the files and answers |
//! | `serve` | the command `serve`: the app in a browser |
//! | `completions`, `man` | the commands of these names, for shells and `man` |
//! | `usage` | refusals of a command line as answers |
//!
//! All other commands are folders of `epicyclic-commands`, re-exported here.
//!
//! Exit codes: see [`epicyclic_commands::failure`].

#[cfg(feature = "terminal")]
mod completions;
pub mod desk;
#[doc = include_str!("examples.md")]
pub mod examples {}
#[cfg(test)]
mod files;
mod help;
#[cfg(feature = "terminal")]
mod man;
#[cfg(test)]
mod robustness;
mod schema;
#[cfg(feature = "serve")]
mod serve;
mod usage;

use clap::error::ErrorKind;
use clap::{CommandFactory as _, FromArgMatches as _, Parser, Subcommand};
use epicyclic_commands as commands;
use epicyclic_commands::answer::write_json;
use epicyclic_commands::desk::{Call, apart};
use epicyclic_commands::failure;
pub use epicyclic_commands::failure::Failure;
use epicyclic_commands::output;
use std::ffi::OsString;

pub use desk::Desk;
pub use desk::memory::Memory;
pub use epicyclic_commands::answer::to_json;
pub use epicyclic_commands::failure::{INTERRUPTED, NOTHING_TO_SHOW};
pub use epicyclic_commands::shared::gearbox::Gearbox;
pub use epicyclic_commands::table::report::AsReport;
pub use epicyclic_commands::words::request;
pub use epicyclic_commands::{
    analyze, compare, design, draw, drive, losses, machine, motor, report, schemes, select, sheet, simulate,
    size, strength, synthesize, teeth, vibrate,
};
pub use epicyclic_units::Quantity;

/// Planetary gear mechanisms: tooth numbers, drives, gearboxes of several speeds, hydromotors.
#[derive(Parser)]
#[command(version, max_term_width = 80, after_help = failure::EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

/// The list of all commands: what clap reads, and who answers.
macro_rules! commands {
    ($($(#[$condition:meta])* $name:ident: $command:ident $(:: $part:ident)*;)*) => {
        #[derive(Subcommand)]
        enum Command {
            $($(#[$condition])* $name(Box<$command$(::$part)*::Args>),)*
        }

        fn run(call: &Call<'_>, command: Command) -> Result<(), Failure> {
            match command {
                $($(#[$condition])* Command::$name(args) => $command$(::$part)*::run(call, &args),)*
            }
        }
    };
}

commands! {
    Teeth: commands::teeth::request;
    Drive: commands::drive::request;
    Analyze: commands::analyze::request;
    Strength: commands::strength::request;
    Sheet: commands::sheet::request;
    Size: commands::size::request;
    Design: commands::design::request;
    Losses: commands::losses::request;
    Simulate: commands::simulate::request;
    Vibrate: commands::vibrate::request;
    Compare: commands::compare::request;
    Select: commands::select::request;
    Synthesize: commands::synthesize::request;
    #[cfg(feature = "tables")]
    Atlas: commands::atlas::request;
    Schemes: commands::schemes::request;
    Machine: commands::machine::request;
    Motor: commands::motor::request;
    Draw: commands::draw::request;
    Report: commands::report::request;
    Init: commands::init::request;
    Schema: schema;
    #[cfg(feature = "serve")]
    Serve: serve;
    #[cfg(feature = "terminal")]
    Completions: completions;
    #[cfg(feature = "terminal")]
    Man: man;
}

/// Answers a command line, given by its words after the name of the program, through a desk. Returns the exit
/// code described in the help.
///
/// # Errors
/// No error is returned: refusals are reported through the desk, and as an answer too if JSON is requested.
pub fn call<Word: Into<OsString>>(words: impl IntoIterator<Item = Word>, desk: &dyn Desk) -> u8 {
    let words: Vec<OsString> = words.into_iter().map(Into::into).collect();
    let line = std::iter::once(OsString::from("epicyclic")).chain(words.iter().cloned());
    let (cli, files, is_json) = match parsed(line) {
        Ok(parsed) => parsed,
        Err(error) => return refused(&Call::new(desk, words, apart::Files::default()), error),
    };
    let call = Call::new(desk, words, files);
    end(&call, call.check_files().and_then(|()| run(&call, cli.command)), is_json)
}

/// Ends a call whose words are not a command, or ask for help.
fn refused(call: &Call<'_>, error: clap::Error) -> u8 {
    // Help and version are answers, and writing them may fail like any other.
    if !error.use_stderr() {
        return end(call, call.desk.usage(&error).map_err(Failure::StandardOutput), false);
    }
    let unit = usage::loose_unit(&error, &call.words);
    let error = usage::shown(error);
    if output::asks_for_json(&call.words) {
        output::in_place_of_an_answer(call, &usage::refused(&error));
    }
    let _ = call.desk.usage(&error);
    if let Some(unit) = unit {
        call.complain(&format!(
            "\nA quantity is one word: put it in quotes, '2 {unit}', or leave out the blank, 2{unit}."
        ));
    }
    failure::WRONG
}

/// Command line with all options and help texts, for programs that offer the commands in another form.
#[must_use]
pub fn command_line() -> clap::Command {
    help::with_help_all(Cli::command())
}

fn end(call: &Call<'_>, done: Result<(), Failure>, is_json: bool) -> u8 {
    match done {
        Ok(()) => 0,
        Err(failure) => {
            let failure = failure.unless_asked_to_end(call.goes_on());
            if is_json {
                output::in_place_of_an_answer(call, &failure.as_answer());
            } else if !call.has_answered() {
                // A failure to write the record has already been reported.
                let refused = failure.as_answer();
                let _ = call.record(&mut |out| write_json(&refused, out));
            }
            if !failure.is_quiet() {
                call.complain(&format!("error: {}", failure.told()));
            }
            failure.code()
        }
    }
}

/// Errors that are help.
const HELP: [ErrorKind; 2] = [ErrorKind::DisplayHelp, ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand];

/// Parsed command line, the files that it names, and whether JSON is requested on standard output.
fn parsed(line: impl IntoIterator<Item = OsString>) -> Result<(Cli, apart::Files, bool), clap::Error> {
    let line: Vec<OsString> = line.into_iter().collect();
    let mut command = command_line();
    let mut matches = match command.try_get_matches_from_mut(&line) {
        Err(error) if HELP.contains(&error.kind()) => {
            help::asked(command_line(), &line).try_get_matches_from(&line)?
        }
        matches => matches?,
    };
    let files = apart::Files::of(&command, &matches);
    let is_json = output::is_json_to_standard_output(&matches);
    let cli = Cli::from_arg_matches_mut(&mut matches).map_err(|error| error.format(&mut command))?;
    Ok((cli, files, is_json))
}
