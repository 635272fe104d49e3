//! The program `epicyclic` as a library: planetary gear mechanisms by the words of a command line.
//!
//! [`call`] answers one command line. What it reads, writes and prints goes over a [`Desk`]: a terminal for the program, memory for a page
//! in a browser, both for other languages. The answers are the records of `epicyclic-answers`, with `--format json` as they are.
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
//! | `teeth` | the command `teeth`: tooth numbers for a ratio |
//! | `drive` | the command `drive`: a whole planetary drive from a file |
//! | `analyze` | the command `analyze`: every gear of any planetary gearbox |
//! | `compare` | the command `compare`: gearboxes side by side |
//! | `select` | the command `select`: the gearbox for given speeds |
//! | `synthesize` | the command `synthesize`: every gearbox that has a list of ratios |
//! | `shards` | `synthesize` in parts on many machines, and all parts together |
//! | `atlas` | the command `atlas`: all gearboxes of two and three sets as tables |
//! | `size` | how large a synthesis is, and which are refused |
//! | `schemes` | the command `schemes`: the catalogue of two and three speeds |
//! | `draw` | the command `draw`: schemes, speed diagrams, lever diagrams and ratio ladders as SVG and DXF |
//! | `drawing_file` | a drawing as SVG, DXF, PDF or PNG |
//! | `machine` | the command `machine`: speeds of mining machines |
//! | `page` | the command `report`: a page about a file |
//! | `design` | the command `design`: from speeds and power to a gearbox whose sizes hold |
//! | `strength` | the command `strength`: safeties of teeth by ISO 6336 |
//! | `sheet` | the command `sheet`: data sheets of gears |
//! | `sizing` | the command `size`: sizes of sets that hold over a duty |
//! | `losses` | the command `losses`: what heats a gearbox, and its efficiency over speed and torque |
//! | `simulate` | the command `simulate`: a gearbox in motion, by a scenario |
//! | `vibrate` | the command `vibrate`: natural frequencies, modes and resonances of sets |
//! | `schema` | the command `schema`: JSON Schemas of the files |
//! | `serve` | the command `serve`: the app in a browser |
//! | `completions`, `man` | the commands of these names, for shells and `man` |
//! | `motor` | the command `motor`: a hydromotor and its drawings |
//! | `lists` | options that take several values |
//! | `options` | the option that a refusal speaks of |
//! | `input` | files that are read |
//! | `imprint` | what the options say of a page |
//! | `output` | formats of an answer, and where it goes |
//! | `ratios` | lists of ratios as people write them |
//! | `progress` | how far a long search is, on a terminal |
//! | [`desk`] | what a call needs of the world around it |
//! | `failure` | what ends the program, and with which exit code |
//! | `usage` | refusals of a command line as answers |
//!
//! Exit codes: see `failure`.

mod analyze;
#[cfg(feature = "tables")]
mod atlas;
mod compare;
#[cfg(feature = "terminal")]
mod completions;
mod design;
pub mod desk;
mod draw;
mod drawing_file;
mod drive;
mod failure;
mod imprint;
mod input;
mod lists;
mod losses;
mod machine;
#[cfg(feature = "terminal")]
mod man;
mod motor;
mod named;
mod options;
mod output;
mod page;
mod profile_shift;
mod progress;
mod ratios;
#[cfg(test)]
mod robustness;
mod schema;
mod schemes;
mod select;
#[cfg(feature = "serve")]
mod serve;
#[cfg(feature = "tables")]
mod shards;
#[cfg(not(feature = "tables"))]
#[path = "no_shards.rs"]
mod shards;
mod sheet;
mod simulate;
mod size;
mod sizing;
mod strength;
mod synthesize;
mod teeth;
mod teeth_wanted;
mod usable;
mod usage;
mod vibrate;

use clap::{CommandFactory as _, FromArgMatches as _, Parser, Subcommand};
use desk::Call;
use desk::apart;
use std::ffi::OsString;

pub use desk::Desk;
pub use desk::memory::Memory;
pub use failure::{INTERRUPTED, NOTHING_TO_SHOW};

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
    Strength(strength::Args),
    Sheet(sheet::Args),
    Size(Box<sizing::Args>),
    Design(Box<design::Args>),
    Losses(losses::Args),
    Simulate(simulate::Args),
    Vibrate(vibrate::Args),
    Compare(compare::Args),
    Select(Box<select::Args>),
    Synthesize(Box<synthesize::Args>),
    #[cfg(feature = "tables")]
    Atlas(atlas::Args),
    Schemes(schemes::Args),
    Machine(machine::Args),
    Motor(Box<motor::Args>),
    Draw(Box<draw::Args>),
    Report(page::Args),
    Schema(schema::Args),
    #[cfg(feature = "serve")]
    Serve(serve::Args),
    #[cfg(feature = "terminal")]
    Completions(completions::Args),
    #[cfg(feature = "terminal")]
    Man(man::Args),
}

/// Answers a command line, of which the words after the name of the program are given, over a desk. The answer is the exit code, as the
/// help tells them.
///
/// # Errors
/// None: what is refused is told over the desk, where JSON is asked for as an answer, too.
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

/// The end of a call whose words are no command, or ask for help.
fn refused(call: &Call<'_>, error: clap::Error) -> u8 {
    // Help and version are answers, and may fail to be written like any.
    if !error.use_stderr() {
        return end(call, call.desk.usage(&error).map_err(failure::Failure::StandardOutput), false);
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

/// The commands with their options and what the help says of them, for those who offer them in another form.
#[must_use]
pub fn command_line() -> clap::Command {
    Cli::command()
}

fn end(call: &Call<'_>, done: Result<(), failure::Failure>, is_json: bool) -> u8 {
    match done {
        Ok(()) => 0,
        Err(failure) => {
            let failure = failure.unless_asked_to_end(call.goes_on());
            if is_json {
                output::in_place_of_an_answer(call, &failure.as_answer());
            } else if !call.has_answered() {
                // What fails here has been told already.
                let _ = call.record(&failure.as_answer());
            }
            if !failure.is_quiet() {
                call.complain(&format!("error: {}", failure.told()));
            }
            failure.code()
        }
    }
}

/// The command line, the files that it names, and whether JSON is due on standard output.
fn parsed<Word>(line: impl IntoIterator<Item = Word>) -> Result<(Cli, apart::Files, bool), clap::Error>
where
    Word: Into<OsString> + Clone,
{
    let mut command = Cli::command();
    let mut matches = command.try_get_matches_from_mut(line)?;
    let files = apart::Files::of(&command, &matches);
    let is_json = output::is_json_to_standard_output(&matches);
    let cli = Cli::from_arg_matches_mut(&mut matches).map_err(|error| error.format(&mut command))?;
    Ok((cli, files, is_json))
}

fn run(call: &Call<'_>, command: Command) -> Result<(), failure::Failure> {
    match command {
        Command::Teeth(args) => teeth::run(call, &args),
        Command::Drive(args) => drive::run(call, &args),
        Command::Analyze(args) => analyze::run(call, &args),
        Command::Strength(args) => strength::run(call, &args),
        Command::Sheet(args) => sheet::run(call, &args),
        Command::Size(args) => sizing::run(call, &args),
        Command::Design(args) => design::run(call, &args),
        Command::Losses(args) => losses::run(call, &args),
        Command::Simulate(args) => simulate::run(call, &args),
        Command::Vibrate(args) => vibrate::run(call, &args),
        Command::Compare(args) => compare::run(call, &args),
        Command::Select(args) => select::run(call, &args),
        Command::Synthesize(args) => synthesize::run(call, &args),
        #[cfg(feature = "tables")]
        Command::Atlas(args) => atlas::run(call, &args),
        Command::Schemes(args) => schemes::run(call, &args),
        Command::Machine(args) => machine::run(call, &args),
        Command::Motor(args) => motor::run(call, &args),
        Command::Draw(args) => draw::run(call, &args),
        Command::Report(args) => page::run(call, &args),
        Command::Schema(args) => schema::run(call, &args),
        #[cfg(feature = "serve")]
        Command::Serve(args) => serve::run(call, &args),
        #[cfg(feature = "terminal")]
        Command::Completions(args) => completions::run(call, &args, Cli::command()),
        #[cfg(feature = "terminal")]
        Command::Man(args) => man::run(call, &args, Cli::command()),
    }
}
