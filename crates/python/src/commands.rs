//! The commands and their options as data, for the functions of the package and their documentation.

use clap::{Arg, ArgAction, Command};
use pyo3::prelude::*;
use serde_json::{Value, json};

/// Commands of the program alone. A build of the whole workspace has those of the program in its library.
const OF_THE_PROGRAM: [&str; 4] = ["help", "serve", "completions", "man"];

/// Commands with answers, as JSON: name, text of the help, arguments.
#[pyfunction]
pub(crate) fn commands() -> String {
    let mut program = epicyclic::command_line();
    program.build();
    let mut found = vec![];
    collect(&program, &mut vec![], &mut found);
    Value::Array(found).to_string()
}

fn collect(command: &Command, path: &mut Vec<String>, found: &mut Vec<Value>) {
    for one in command
        .get_subcommands()
        .filter(|one| !OF_THE_PROGRAM.contains(&one.get_name()) && !one.is_hide_set())
    {
        path.push(one.get_name().to_owned());
        if !one.is_subcommand_required_set() {
            found.push(json!({
                "path": path,
                "about": text(one.get_long_about().or(one.get_about())),
                "after_help": text(one.get_after_help()),
                "arguments": one.get_arguments().filter(|arg| !arg.is_hide_set()).map(argument).collect::<Vec<_>>(),
            }));
        }
        collect(one, path, found);
        path.pop();
    }
}

fn argument(arg: &Arg) -> Value {
    let many = matches!(arg.get_action(), ArgAction::Append)
        || arg.get_num_args().is_some_and(|range| range.max_values() > 1);
    let choices: Vec<String> =
        arg.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
    json!({
        "id": arg.get_id().as_str(),
        "long": arg.get_long(),
        "is_flag": matches!(arg.get_action(), ArgAction::SetTrue),
        "is_many": many,
        "is_required": arg.is_required_set(),
        "delimiter": arg.get_value_delimiter(),
        "names": arg.get_value_names().unwrap_or_default().iter().map(ToString::to_string).collect::<Vec<_>>(),
        "choices": choices,
        "help": text(arg.get_long_help().or(arg.get_help())),
    })
}

fn text(styled: Option<&clap::builder::StyledStr>) -> String {
    styled.map(ToString::to_string).unwrap_or_default()
}
