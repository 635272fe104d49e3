//! The command `completions`: what a shell needs to complete this program's commands and options.

use clap_complete::Shell;
use epicyclic_commands::desk::Call;
use epicyclic_commands::failure::Failure;
use epicyclic_commands::output::Target;

/// Completions of commands and options for a shell.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  epicyclic completions bash -o epicyclic.bash

To be read at the start of the shell, for instance:
  bash        eval \"$(epicyclic completions bash)\" in ~/.bashrc
  zsh         -o ~/.zfunc/_epicyclic, a folder of fpath
  fish        -o ~/.config/fish/completions/epicyclic.fish
  powershell  epicyclic completions powershell | Out-String | Invoke-Expression
  elvish      eval (epicyclic completions elvish | slurp)")]
pub(crate) struct Args {
    /// The shell.
    #[arg(value_enum)]
    shell: Shell,

    #[command(flatten)]
    target: Target,
}

/// Runs the command for the program's whole command line.
pub(crate) fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let mut program = crate::command_line();
    let name = program.get_name().to_owned();
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut program, name, &mut script);
    args.target.write(call, &script)
}
