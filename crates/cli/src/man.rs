//! The command `man`: the manual page, with every command in it.

use clap_mangen::Man;
use epicyclic_commands::desk::Call;
use epicyclic_commands::failure::Failure;
use epicyclic_commands::output::Target;
use std::fmt::Write as _;
use std::io;

/// The manual page of the program and of all its commands.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example:
  epicyclic man -o epicyclic.1

`man ./epicyclic.1` shows it; in a folder such as ~/.local/share/man/man1 `man
epicyclic` finds it.")]
pub(crate) struct Args {
    #[command(flatten)]
    target: Target,
}

/// Runs the command for the program's whole command line.
pub(crate) fn run(call: &Call<'_>, args: &Args) -> Result<(), Failure> {
    let mut program = crate::command_line();
    program.build();
    let page = page(&program).map_err(|error| Failure::Format(error.to_string()))?;
    args.target.write(call, portable(&String::from_utf8_lossy(&page)).as_bytes())
}

/// Makes a page portable: every roff reads names of characters, but not all read the characters. The part
/// after the options gets a heading.
fn portable(page: &str) -> String {
    let mut text = String::new();
    for c in page.replace("SH EXTRA\n", "SH NOTES\n").replace("SS EXTRA\n", "SS NOTES\n").chars() {
        if c.is_ascii() {
            text.push(c);
        } else {
            let _ = write!(text, "\\[u{:04X}]", u32::from(c));
        }
    }
    text
}

fn page(program: &clap::Command) -> io::Result<Vec<u8>> {
    let man = Man::new(program.clone());
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    man.render_description_section(&mut page)?;
    man.render_options_section(&mut page)?;
    for command in program.get_subcommands() {
        append(command, program.get_name(), &mut page)?;
    }
    man.render_extra_section(&mut page)?;
    man.render_version_section(&mut page)?;
    Ok(page)
}

/// Appends a command and its subcommands, each as a section whose parts are subsections.
fn append(command: &clap::Command, above: &str, page: &mut Vec<u8>) -> io::Result<()> {
    if command.get_name() == "help" {
        return Ok(());
    }
    let name = format!("{above} {}", command.get_name());
    let man = Man::new(command.clone());
    let mut parts = Vec::new();
    man.render_synopsis_section(&mut parts)?;
    man.render_description_section(&mut parts)?;
    if command.get_arguments().next().is_some() {
        man.render_options_section(&mut parts)?;
    }
    if command.get_after_help().is_some() {
        man.render_extra_section(&mut parts)?;
    }
    page.extend(format!(".SH \"{}\"\n", name.to_uppercase()).bytes());
    for line in parts.split_inclusive(|byte| *byte == b'\n') {
        match line.strip_prefix(b".SH") {
            Some(heading) => page.extend([b".SS", heading].concat()),
            None => page.extend(line),
        }
    }
    for below in command.get_subcommands() {
        append(below, &name, page)?;
    }
    Ok(())
}
