//! The program `epicyclic`: planetary gear mechanisms on the command line.
//!
//! | module | is |
//! |---|---|
//! | [`terminal`] | a terminal and the disk |
//! | [`interrupt`] | Ctrl-C and SIGTERM |
//! | [`standard_output`] | whether standard output takes an answer |

mod interrupt;
mod standard_output;
mod terminal;

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(epicyclic::call(std::env::args_os().skip(1), &terminal::Terminal::new()))
}
