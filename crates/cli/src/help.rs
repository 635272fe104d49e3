//! Help in three lengths. `-h` is one screen, written by hand. `--help` adds the names of all other options.
//! `--help-all` explains every option as its request does.

use clap::{Arg, ArgAction, Command};
use std::ffi::OsString;
use std::fmt::Write as _;

/// Texts of one screen, each below the name of its command.
const TEXTS: &str = include_str!("help/short.txt");

/// Width of a screen.
const WIDTH: usize = 80;

/// Options that every command has.
const OF_ALL: [&str; 3] = ["help", "help-all", "version"];

/// The command line with the option for the whole help.
pub(crate) fn with_help_all(command: Command) -> Command {
    let all = Arg::new("help-all").long("help-all").action(ArgAction::HelpLong).global(true);
    command.arg(all.help("Print the whole help, with every option explained"))
}

/// The command with the help that a line asks for. The whole help stays as clap makes it.
pub(crate) fn asked(mut command: Command, line: &[OsString]) -> Command {
    let words: Vec<&str> = line.iter().skip(1).filter_map(|word| word.to_str()).collect();
    if words.contains(&"--help-all") {
        return command;
    }
    let is_middle = words.contains(&"--help") || words.first() == Some(&"help");
    // Headings and options that all commands share are known only then.
    command.build();
    let path = path(&command, &words);
    replaced(command, &path, &|own| {
        let name = if path.is_empty() { own.get_name().to_owned() } else { path.join(" ") };
        let short = short(&name)?;
        Some(match (is_middle, path.is_empty()) {
            (false, true) => existing(own, short),
            (true, true) => overview(own, short),
            (false, false) => format!("{short}\nNames of all options: --help; each explained: --help-all\n"),
            (true, false) => format!("{short}{}", others(own, &name, short)),
        })
    })
}

/// Names of the command and of those below it that a line names.
fn path<'a>(command: &Command, words: &[&'a str]) -> Vec<&'a str> {
    let (mut at, mut path) = (command, vec![]);
    for word in words.iter().filter(|word| !word.starts_with('-') && **word != "help") {
        // The first other word is a file or a value.
        let Some(below) = at.find_subcommand(word) else { break };
        path.push(*word);
        at = below;
    }
    path
}

/// A command whose subcommand at the end of a path has another help.
fn replaced(command: Command, path: &[&str], help: &dyn Fn(&Command) -> Option<String>) -> Command {
    match path {
        [] => match help(&command) {
            Some(text) => command.override_help(text),
            None => command,
        },
        [next, rest @ ..] => command.mut_subcommand(next, |below| replaced(below, rest, help)),
    }
}

/// The text of one screen of a command.
fn short(name: &str) -> Option<&'static str> {
    sections().find(|(of, _)| *of == name).map(|(_, text)| text)
}

fn sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    let all = TEXTS.strip_prefix("# ").unwrap_or(TEXTS).split("\n# ");
    all.filter_map(|section| section.split_once('\n'))
}

/// Name and commands of a group of the overview, without commands that this program lacks; `None` for other lines.
fn group<'a>(command: &Command, line: &'a str) -> Option<(&'a str, Vec<&'a str>)> {
    let mut words = line.strip_prefix("  ").filter(|line| !line.starts_with("epicyclic"))?.split_whitespace();
    let name = words.next()?;
    Some((name, words.filter(|word| command.find_subcommand(word).is_some()).collect()))
}

/// The overview without commands that this program was built without.
fn existing(command: &Command, short: &str) -> String {
    short.lines().fold(String::new(), |mut text, line| {
        let _ = match group(command, line) {
            Some((name, commands)) => writeln!(text, "  {name:<12} {}", commands.join("  ")),
            None => writeln!(text, "{line}"),
        };
        text
    })
}

/// The overview with a line on each command.
fn overview(command: &Command, text: &str) -> String {
    text.lines().filter(|line| !line.starts_with("A line on each")).fold(String::new(), |mut text, line| {
        let Some((name, commands)) = group(command, line) else {
            let _ = writeln!(text, "{line}");
            return text;
        };
        let _ = writeln!(text, "{name}");
        for name in commands {
            let first = short(name).and_then(|own| own.lines().next()).unwrap_or_default();
            let _ = writeln!(text, "  {name:<12} {}", first.trim_end_matches('.'));
        }
        text
    }) + "Exit codes, and more:   epicyclic --help-all\n"
}

/// The names of all options that the text of one screen does not have, by their headings.
fn others(command: &Command, name: &str, short: &str) -> String {
    let mut known: Vec<&str> = names(short).collect();
    known.extend(short.contains("  -o ").then_some("output"));
    let mut groups: Vec<(&str, Vec<String>)> = vec![];
    for option in command.get_arguments().filter(|option| !option.is_hide_set()) {
        let Some(long) = option.get_long().filter(|long| !known.contains(long) && !OF_ALL.contains(long))
        else {
            continue;
        };
        let heading = option.get_help_heading().unwrap_or("Options");
        match groups.iter_mut().find(|(of, _)| *of == heading) {
            Some((_, all)) => all.push(format!("--{long}")),
            None => groups.push((heading, vec![format!("--{long}")])),
        }
    }
    let mut text = String::new();
    for (heading, options) in groups {
        let _ = write!(text, "\n{heading}\n ");
        let mut width = 1;
        for option in options {
            if width + 1 + option.len() > WIDTH {
                text.push_str("\n ");
                width = 1;
            }
            let _ = write!(text, " {option}");
            width += 1 + option.len();
        }
        text.push('\n');
    }
    format!("{text}\nEach option explained: epicyclic {name} --help-all\n")
}

/// Long options in a text, without their hyphens.
fn names(text: &str) -> impl Iterator<Item = &str> {
    let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'));
    words.filter_map(|word| word.strip_prefix("--")).filter(|name| !name.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn commands(command: &Command, above: &str, all: &mut Vec<(String, Command)>) {
        for below in command.get_subcommands().filter(|below| below.get_name() != "help") {
            let name = format!("{above} {}", below.get_name()).trim().to_owned();
            all.push((name.clone(), below.clone()));
            commands(below, &name, all);
        }
    }

    fn help(words: &str) -> String {
        let line: Vec<OsString> = format!("epicyclic {words}").split_whitespace().map(Into::into).collect();
        let error = crate::parsed(line).err().unwrap();
        error.render().to_string()
    }

    /// Short help fits a screen, names no option that its command lacks, and its examples can be typed.
    #[test]
    fn help_is_of_options_that_exist() {
        let mut program = crate::command_line();
        program.build();
        let mut all = vec![(String::new(), program.clone())];
        commands(&program, "", &mut all);
        let (mut seen, mut faults) = (0, vec![]);
        let mut check = |is_right: bool, fault: String| faults.extend((!is_right).then_some(fault));
        for (name, command) in &all {
            let [brief, middle] = ["-h", "--help"].map(|flag| help(&format!("{name} {flag}")));
            check(brief.lines().count() <= 24, format!("{name}: {}", brief.lines().count()));
            check(middle.lines().count() <= 48, format!("{name}: {}", middle.lines().count()));
            for line in brief.lines().chain(middle.lines()) {
                check(line.chars().count() <= WIDTH, format!("{name}: {line}"));
            }
            let Some(text) = short(if name.is_empty() { "epicyclic" } else { name }) else { continue };
            seen += 1;
            for option in names(text).filter(|option| !name.is_empty() && !OF_ALL.contains(option)) {
                let is_own = command.get_arguments().any(|own| own.get_long() == Some(option));
                let is_of_example =
                    text.lines().any(|line| line.starts_with("  epicyclic") && line.contains(option));
                check(is_own || is_of_example, format!("{name}: --{option}"));
            }
            let whole = text.replace("\\\n", " ");
            for example in whole.lines().filter_map(|line| line.strip_prefix("  epicyclic ")) {
                let words = shlex::split(example).unwrap();
                let line = std::iter::once("epicyclic".to_owned()).chain(words);
                check(crate::parsed(line.map(OsString::from)).is_ok(), format!("{name}: {example}"));
            }
            for option in command.get_arguments().filter(|own| !own.is_hide_set()).filter_map(Arg::get_long) {
                assert!(
                    OF_ALL.contains(&option) || option == "output" || middle.contains(&format!("--{option}")),
                    "{name}: {option}"
                );
            }
        }
        assert!(faults.is_empty(), "{}", faults.join("\n"));
        assert_eq!(seen, sections().count());
    }
}
