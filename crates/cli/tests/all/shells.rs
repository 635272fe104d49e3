//! Completions, the manual page, and the schemas of files.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use crate::common;

use boon::{Compiler, Schemas};
use common::{examples, here, output, text};
use epicyclic_formats::Document;
use std::fs;
use std::io::Write as _;
use std::process::{Command, Stdio};

fn printed(args: &[&str]) -> String {
    let done = output(here().path(), args);
    assert!(done.status.success() && done.stderr.is_empty(), "{args:?} {done:?}");
    text(&done.stdout)
}

/// The commands that the help lists.
fn commands() -> Vec<String> {
    let help = printed(&["--help-all"]);
    let list = help.split("Commands:\n").nth(1).unwrap();
    let lines = list.lines().take_while(|line| !line.is_empty());
    let names = lines.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    names.map(|line| line.split_whitespace().next().unwrap().to_owned()).collect()
}

#[test]
fn completions_know_every_command_and_its_options() {
    let commands = commands();
    assert!(commands.len() >= 10, "{commands:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = printed(&["completions", shell]);
        for command in &commands {
            assert!(script.contains(command.as_str()), "{shell}: {command}");
        }
        for option in ["no-undercut", "all-structures", "mesh-load-factors"] {
            assert!(script.contains(option), "{shell}: {option}");
        }
    }
    let refused = output(here().path(), &["completions", "dos"]);
    assert_eq!(refused.status.code(), Some(2));
}

/// Bash completes a command with the script; without a bash the test does nothing.
#[test]
fn bash_completes_a_command() {
    let test = "\nCOMP_WORDS=(epicyclic sel); COMP_CWORD=1; _epicyclic epicyclic sel epicyclic; echo \"${COMPREPLY[*]}\"\n";
    let child = Command::new("bash").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let Ok(mut bash) = child else { return };
    bash.stdin.take().unwrap().write_all((printed(&["completions", "bash"]) + test).as_bytes()).unwrap();
    assert_eq!(text(&bash.wait_with_output().unwrap().stdout), "select\n");
}

#[test]
fn the_manual_page_has_a_section_for_every_command() {
    let page = printed(&["man"]);
    assert!(page.is_ascii());
    for command in commands().iter().filter(|command| *command != "help") {
        assert!(page.contains(&format!(".SH \"EPICYCLIC {}\"", command.to_uppercase())), "{command}");
    }
    for part in ["EPICYCLIC MACHINE SPEEDS", "\\-\\-all\\-structures", "Exit codes:"] {
        assert!(page.contains(part), "{part}");
    }
    // What groff objects to, where there is one.
    let mut groff = Command::new("groff");
    groff.args(["-man", "-ww", "-Tutf8"]).stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
    let Ok(mut groff) = groff.spawn() else { return };
    groff.stdin.take().unwrap().write_all(page.as_bytes()).unwrap();
    let done = groff.wait_with_output().unwrap();
    assert!(done.stderr.is_empty(), "{}", text(&done.stderr));
}

#[test]
fn the_examples_meet_their_schemas_and_faults_do_not() {
    for (of, files, fault) in [
        ("drive", &["minimal-drive.yaml", "xe215cll-drive.yaml"][..], ("power", "powers")),
        (
            "gearbox",
            &[
                "scheme-ii-3.yaml",
                "sized-gearbox.yaml",
                "closed-by-ordinary-train.yaml",
                "closed-by-planetary-gear.yaml",
            ],
            ("sun:", "suns:"),
        ),
        ("transmissions", &["real-transmissions.yaml"], ("z_s", "zs")),
    ] {
        let schema: serde_json::Value = serde_json::from_str(&printed(&["schema", of])).unwrap();
        let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
        compiler.add_resource("schema.json", schema).unwrap();
        let index = compiler.compile("schema.json", &mut schemas).unwrap();
        for file in files {
            let written = fs::read_to_string(examples().join(file)).unwrap();
            let json = |text: &str| {
                let document = Document::parse_one(file, text.as_bytes()).unwrap();
                serde_json::to_value(document.value()).unwrap()
            };
            let whole = json(&written);
            let meets = schemas.validate(&whole, index);
            assert!(meets.is_ok(), "{file}: {}", meets.unwrap_err());
            assert!(
                schemas.validate(&json(&written.replacen(fault.0, fault.1, 1)), index).is_err(),
                "{file}"
            );
        }
    }
}
