//! Every key of every file changes an answer: tables of keys in `keys/`, one for each kind of file.
//!
//! | line | means |
//! |---|---|
//! | `$ command` | the keys below change its answer |
//! | `= command` | they change it not; of several in a row, none of the answers |
//! | `! command` | it refuses them by their name |
//! | `key \| old → new` | the key, and changes of the text of the file: the last one gives the key another value, those before it make the key matter |
//! | `@name \| old → new` | changes that rows take by this name |
//!
//! In the texts `\n` is a line break and `\s` a space at an end.

use super::common::console::words;
use super::common::{change, examples, replaced, text};
use super::schema;
use epicyclic::{Memory, call};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

type Changes = Vec<(String, String)>;

/// What becomes of the answers to a file when a key has another value.
#[derive(Clone, Copy, PartialEq)]
enum Outcome {
    Changed,
    Same,
    Refused,
}

struct Row<'a> {
    line: &'a str,
    key: &'a str,
    outcome: Outcome,
    commands: Vec<&'a str>,
    changes: Changes,
}

fn rows(table: &str) -> Vec<Row<'_>> {
    let (mut named, mut rows) = (BTreeMap::<&str, Changes>::new(), vec![]);
    let (mut outcome, mut commands, mut is_heading) = (Outcome::Changed, vec![], false);
    for line in table.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some((sign @ ("$" | "=" | "!"), command)) = line.split_once(' ') {
            outcome = match sign {
                "$" => Outcome::Changed,
                "=" => Outcome::Same,
                _ => Outcome::Refused,
            };
            if !is_heading {
                commands.clear();
            }
            commands.push(command);
            is_heading = true;
            continue;
        }
        is_heading = false;
        let mut columns = line.split(" | ");
        let key = columns.next().unwrap();
        let mut row = vec![];
        for column in columns {
            match change(column) {
                Some(change) => row.push(change),
                None => row.extend_from_slice(&named[column]),
            }
        }
        if key.starts_with('@') {
            named.insert(key, row);
        } else {
            rows.push(Row { line, key, outcome, commands: commands.clone(), changes: row });
        }
    }
    rows
}

/// Names and texts of the files that a command may read.
type Files = Vec<(&'static str, String)>;

/// Answer of a command in JSON, or the reason why it refuses. The call is one in memory, which answers as the
/// program does.
fn answered(files: Files, command: &str) -> Result<String, String> {
    let mut line = words(command);
    if !command.contains("--format") {
        line.extend(["--format", "json"].map(str::to_owned));
    }
    let files = files.into_iter().map(|(name, text)| (name.into(), text.into_bytes()));
    let desk = Memory::new(files.collect(), None);
    let code = call(line, &desk);
    let told = desk.into_kept();
    if code != 0 {
        return Err(told.messages.join("\n"));
    }
    let answer = text(&told.answer);
    if !command.starts_with("report") {
        return Ok(answer);
    }
    // It has the text of the file, too.
    let mut answer: Value = serde_json::from_str(&answer).unwrap();
    answer.as_object_mut().unwrap().remove("file");
    Ok(answer.to_string())
}

/// Checks the rows of a table, and that it has every key of the schema but those that another table has.
/// `files` are those of its commands, with the text of the changed one.
fn check(of: &str, table: &str, file: &str, elsewhere: &str, files: impl Fn(&str) -> Files) {
    let (mut before, mut faults, mut keys) = (BTreeMap::new(), vec![], BTreeSet::new());
    for Row { line, key, outcome, commands, changes } in rows(table) {
        keys.insert(key.to_owned());
        let ((from, to), first) = changes.split_last().unwrap();
        let plain = first.iter().fold(file.to_owned(), |file, (from, to)| replaced(&file, from, to));
        let changed = replaced(&plain, from, to);
        for command in commands {
            let after = answered(files(&changed), command);
            let before =
                before.entry((plain.clone(), command)).or_insert_with(|| answered(files(&plain), command));
            let fault = match (outcome, before, after) {
                (Outcome::Changed, Ok(before), Ok(after)) if *before == after => "changes nothing".to_owned(),
                (Outcome::Same, Ok(before), Ok(after)) if *before != after => "changes the answer".to_owned(),
                (Outcome::Refused, Ok(_), Err(told)) if names(&told, key) => continue,
                (Outcome::Refused, Ok(_), after) => format!("is to be refused by its name: {after:?}"),
                (_, Err(told), _) => format!("is refused before the change: {told}"),
                (_, _, Err(told)) => format!("is refused: {told}"),
                _ => continue,
            };
            faults.push(format!("`{line}` with `{command}` {fault}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let due = schema(of).into_iter().filter(|key| elsewhere.is_empty() || !key.starts_with(elsewhere));
    assert_eq!(keys, due.collect::<BTreeSet<_>>(), "the keys of the table, and those of the schema");
}

/// Whether a refusal names a key; it has the places of the entries of lists and the names of those of maps
/// besides.
fn names(told: &str, key: &str) -> bool {
    let is_place = |c: char| matches!(c, '[' | ']') || c.is_ascii_digit();
    told.replace(is_place, "").split(": ").any(|path| {
        let mut given = path.split('.');
        key.split('.').all(|part| given.any(|one| one == part))
    })
}

fn example(name: &str) -> String {
    fs::read_to_string(examples().join(name)).unwrap()
}

#[test]
fn every_key_of_a_drive_changes_its_answer() {
    let files = |file: &str| vec![("drive.yaml", file.to_owned())];
    check("drive", include_str!("keys/drive.txt"), &example("every-drive-key.yaml"), "", files);
}

/// A set given in full keeps what was asked of its spacing and its gap.
#[test]
fn every_key_of_teeth_given_in_full_changes_the_answer() {
    let given = [
        ("sun: 17..200", "sun: 23"),
        ("planet: 17..200", "planet: 40"),
        ("ring: 12..200", "ring: 103"),
        ("planets: 3..8", "planets: 4"),
    ];
    let before =
        given.into_iter().fold(example("every-drive-key.yaml"), |file, (from, to)| replaced(&file, from, to));
    let drive = |file: String| answered(vec![("drive.yaml", file)], "drive drive.yaml").unwrap();
    let plain = drive(before.clone());
    for (from, to) in [("spacing: equal", "spacing: least-unequal"), ("tip_gap: 0", "tip_gap: 2")] {
        assert!(plain != drive(replaced(&before, from, to)), "{to} changes nothing");
    }
}

#[test]
fn every_key_of_a_motor_changes_its_answer() {
    let files = |file: &str| vec![("motor.yaml", file.to_owned())];
    check("motor", include_str!("keys/motor.txt"), &example("every-motor-key.yaml"), "", files);
}

#[test]
fn every_key_of_a_gearbox_changes_its_answer() {
    let files = |file: &str| {
        // What the file says of its whole gearbox is seen of two simple sets.
        let (_, vibration) = file.split_once("\nvibration:").unwrap();
        let (vibration, _) = vibration.split_once("\n\n").unwrap();
        let train = format!("{}vibration:{vibration}\n", include_str!("keys/train.yaml"));
        vec![("box.yaml", file.to_owned()), ("train.yaml", train)]
    };
    check("gearbox", include_str!("keys/gearbox.txt"), &example("every-gearbox-key.yaml"), "", files);
}

#[test]
fn every_key_of_a_list_of_transmissions_changes_its_answer() {
    let files = |file: &str| vec![("box.yaml", file.to_owned())];
    let table = include_str!("keys/transmissions.txt");
    check("transmissions", table, include_str!("keys/list.yaml"), "", files);
}

#[test]
fn every_key_of_a_scenario_changes_its_answer() {
    let file = example("every-scenario-key.yaml");
    let files = |changed: &str| [beside(&file), vec![("scenario.yaml", uncommented(changed))]].concat();
    // The keys of the gearbox are those of its own file.
    check("scenario", include_str!("keys/scenario.txt"), &file, "gearbox.", files);
}

/// Files that a scenario names: its gearbox as a file, and with other teeth, in a list, and tables.
fn beside(scenario: &str) -> Files {
    let start = scenario.find("gearbox: #").unwrap();
    let inline = &scenario[start..scenario.find("efficiency: 97").unwrap()];
    let own: String =
        inline.lines().skip(1).map(|line| format!("{}\n", line.strip_prefix("  ").unwrap())).collect();
    let small = include_str!("keys/small.yaml");
    let large = small.replace("name: small", "name: large").replace("z_r: 70", "z_r: 76");
    let mut files = vec![
        ("other.yaml", replaced(&own, "[20, 70]", "[22, 72]")),
        ("box.yaml", own),
        ("list.yaml", format!("transmissions:\n{small}{large}")),
    ];
    let tables = [
        ("grade.csv", "s,N·m\n0,-200\n0.4,-200\n0.6,-260\n"),
        ("steeper.csv", "s,N·m\n0,-200\n0.4,-200\n0.6,-280\n"),
        ("engine.csv", "rpm,N·m\n0,150\n1500,180\n3000,0\n"),
        ("stronger.csv", "rpm,N·m\n0,150\n1500,200\n3000,0\n"),
        ("capacity.csv", "ms,N·m\n0,0\n1000,30\n"),
        ("more.csv", "ms,N·m\n0,0\n1000,35\n"),
        ("pressure.csv", "s,bar\n0.1,4\n0.2,1\n0.6,5\n"),
        ("higher.csv", "s,bar\n0.1,4\n0.2,1\n0.6,6\n"),
    ];
    files.extend(tables.map(|(name, text)| (name, text.to_owned())));
    files
}

/// The scenario without a part that was put aside as `no: # …` with what is below it.
fn uncommented(file: &str) -> String {
    let mut is_aside = false;
    let mut kept = String::new();
    for line in file.lines() {
        if line.starts_with("no: #") {
            is_aside = true;
        } else if !line.starts_with(' ') {
            is_aside = false;
        }
        if !is_aside && !line.starts_with("no_shifts") {
            kept += line;
            kept.push('\n');
        }
    }
    kept
}
