//! Files that command lines name: inputs and outputs.

use crate::command_line;
use epicyclic_commands::desk::apart::{READ, is_file};

fn collect(command: &clap::Command, found: &mut Vec<String>) {
    for arg in command.get_arguments().filter(|arg| is_file(arg)) {
        found.push(format!("{} {arg}", command.get_name()));
    }
    command.get_subcommands().for_each(|below| collect(below, found));
}

/// A new path argument fails here until `Files::of` knows whether its file is read or written.
#[test]
fn what_is_read_and_written_is_known_of_every_command() {
    let mut found = vec![];
    let mut program = command_line();
    program.build();
    collect(&program, &mut found);
    let is_read = |arg: &String| {
        !arg.contains("--") || READ.iter().any(|option| arg.contains(&format!(" --{option} ")))
    };
    let (mut read, mut options): (Vec<_>, Vec<_>) = found.into_iter().partition(is_read);
    read.sort();
    let arguments = [
        "analyze <FILE>",
        "compare <GEARBOX>...",
        "draw <FILE>",
        "drive <FILE>",
        "losses <FILE>",
        "motor [FILE]",
        "report <FILE>",
        "serve [FILE]",
        "sheet <FILE>",
        "simulate <FILE>",
        "size <FILE>",
        "strength <FILE>",
        "vibrate <FILE>",
    ];
    let of_sizes = ["design --basis <FILE>", "design --bearings <FILE>", "size --bearings <FILE>"];
    let of_synthesis = ["synthesize --explain <FILE>", "synthesize --merge <PART>..."];
    let mut expected = [&arguments[..], &of_sizes, &of_synthesis].concat();
    expected.sort_unstable();
    assert_eq!(read, expected);
    options.retain(|arg| !arg.ends_with(" --output <FILE>"));
    options.sort();
    let drawings = [
        "draw --dxf <FILE>",
        "draw --svg <FILE>",
        "vibrate --campbell <FILE>",
        "vibrate --response <FILE>",
        "vibrate --shapes <FILE>",
        "vibrate --torsional-campbell <FILE>",
        "motor --csv <FILE>",
        "motor --dxf <FILE>",
        "motor --svg <FILE>",
    ];
    let saved =
        ["select --save <FILE>", "size --save <FILE>", "synthesize --save <FILE>", "teeth --save <FILE>"];
    let of_search =
        ["search --csv <FILE>", "search --dxf <FILE>", "search --save <FILE>", "search --svg <FILE>"];
    let of_forms = ["forms --csv <FILE>", "forms --dxf <FILE>", "forms --save <FILE>", "forms --svg <FILE>"];
    let mut expected =
        [&drawings[..], &of_search, &of_forms, &saved, &["design --save <FILE>", "simulate --csv <FILE>"]]
            .concat();
    expected.sort_unstable();
    assert_eq!(options, expected);
}
