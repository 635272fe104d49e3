//! The book's pictures are what the program draws. `UPDATE_BOOK=1 cargo test -p epicyclic --test all
//! pictures` renews them.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use crate::common;

use common::{console, here, output, text};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The pictures that a command draws on standard output.
const DRAWN: &[(&str, &str)] = &[
    (
        "8hp-gear-3.svg",
        "draw examples/real-transmissions.yaml --transmission 8HP --gear 3 --power --efficiency 0.97",
    ),
    ("8hp-ladder.svg", "draw examples/real-transmissions.yaml --transmission 8HP --view ladder"),
    ("i.svg", "draw I"),
    ("i-speeds.svg", "draw I --k1 3 --gear 1 --view speeds"),
    ("ii-3.svg", "draw II-3"),
    ("ii-3-speeds.svg", "draw II-3 --ratio1 1.465 --ratio2 2.56 --gear 2 --view speeds"),
    ("ii-3-levers.svg", "draw II-3 --ratio1 1.465 --ratio2 2.56 --gear 2 --view levers"),
    ("iii-1.svg", "draw III-1"),
    ("sized-to-scale.svg", "draw examples/sized-gearbox.yaml --to-scale"),
    ("self-crossing-levers.svg", "draw examples/self-crossing.yaml --gear one --view levers"),
    ("unlisted-gear-2.svg", "draw D.T1.B+T2.B.T1 --ratio1 2.618 --ratio2 1.4623 --gear 2 --power"),
    (
        "losses-map.svg",
        "draw examples/drags.yaml --view map --gear slow --speeds 100rpm..3000rpm/30 --torques 1N·m..60N·m/30",
    ),
    ("motor-centrodes.svg", "draw examples/motor-5x3.yaml --view centrodes"),
    ("motor-construction.svg", "draw examples/motor-5x3.yaml --view construction"),
];

/// Pictures of a page: the page, and what the picture is called there.
const ON_PAGES: &[(&str, &str, &str)] = &[
    ("drive-gear-set.svg", "report examples/xe215cll-drive.yaml", "The gear set along its axis"),
    ("drive-efficiency.svg", "report examples/xe215cll-drive.yaml", "Efficiency over ratio"),
    ("drive-start.svg", "report examples/xe215cll-drive.yaml", "Start"),
];

/// Pictures drawn by commands that write files.
fn written() -> Vec<(&'static str, String)> {
    let folder = here();
    let run = |command: &str| {
        let words = console::words(command);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let done = output(folder.path(), &words);
        assert!(done.status.success(), "{command}: {}", text(&done.stderr));
    };
    let motor = "motor --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --l '80 mm' --angle '20 deg' --view chambers";
    run(&format!("{motor} --svg motor-chambers.svg"));
    run(
        "synthesize --ratios '3.059, 1.625, 1, 0.696, -2.294' --sets 2 --elements 5 --engaged 2 --class all-sparse \
         --limit 1 --save found.yaml",
    );
    run("draw found.yaml -o synthesized.svg");
    let fan = console::root().join("examples/vibration.yaml");
    let speeds = "--gear slow --speeds 0rpm..6000rpm/31";
    run(&format!(
        "vibrate {} {speeds} --campbell campbell.svg --shapes modes.svg -o modes.csv",
        fan.display()
    ));
    run(&format!(
        "vibrate {} --gear slow --speeds 500rpm..9000rpm/100 --transmission-error 3um,1um --damping 2% --response forces.svg -o forces.csv",
        fan.display()
    ));
    for file in
        ["shift-two-three.yaml", "real-transmissions.yaml", "tip-in.yaml", "run-down.yaml", "drags.yaml"]
    {
        fs::copy(console::root().join("examples").join(file), folder.path().join(file)).unwrap();
    }
    run("simulate shift-two-three.yaml -o shift-speeds.svg");
    run("simulate shift-two-three.yaml --view torques -o shift-torques.svg");
    run("simulate tip-in.yaml --view torques -o tip-in.svg");
    run("simulate run-down.yaml -o run-down.svg");
    let motor =
        "motor --stator 5 --rotor 3 --z3 55 --zs 10 --module 2mm --l 80mm --width 50mm --pressure 20MPa";
    run(&format!("{motor} --view forces --svg motor-forces.svg"));
    run(&format!("{motor} --ports 'part: 0.95' --view ports --svg motor-ports.svg"));
    let read = |name: &'static str| (name, fs::read_to_string(folder.path().join(name)).unwrap());
    [
        "campbell.svg",
        "forces.svg",
        "modes.svg",
        "motor-chambers.svg",
        "motor-forces.svg",
        "motor-ports.svg",
        "run-down.svg",
        "synthesized.svg",
        "shift-speeds.svg",
        "shift-torques.svg",
        "tip-in.svg",
    ]
    .map(read)
    .to_vec()
}

fn printed(command: &str) -> String {
    let words: Vec<&str> = command.split(' ').collect();
    let done = output(&console::root(), &words);
    assert!(done.status.success(), "{command}: {}", text(&done.stderr));
    text(&done.stdout)
}

/// Every picture: its file and what the program draws now.
fn pictures() -> Vec<(&'static str, String)> {
    let mut pictures = written();
    pictures.extend(DRAWN.iter().map(|(name, command)| (*name, printed(command))));
    for (name, command, label) in ON_PAGES {
        let page = printed(command);
        let start = page.find(&format!("<svg aria-label=\"{label}\"")).unwrap();
        let picture = page[start..].split_once("</svg>").unwrap().0;
        pictures.push((name, format!("{picture}</svg>")));
    }
    pictures
}

#[test]
fn the_books_pictures_are_what_the_program_draws() {
    let folder = console::root().join("docs/src/pictures");
    let pictures = pictures();
    let mut stale = Vec::new();
    for (name, drawn) in &pictures {
        let (path, drawn) = (folder.join(name), drawn.trim_end());
        if fs::read_to_string(&path).unwrap_or_default().trim_end() == drawn {
            continue;
        }
        if std::env::var_os("UPDATE_BOOK").is_some() {
            fs::write(&path, format!("{drawn}\n")).unwrap();
        } else {
            stale.push(*name);
        }
    }
    let renew =
        "renew them with `UPDATE_BOOK=1 cargo test -p epicyclic --test all pictures` and look at them";
    assert!(stale.is_empty(), "{stale:?} are drawn otherwise now: {renew}");
    let kept: BTreeSet<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let drawn: BTreeSet<String> = pictures.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(kept, drawn, "each picture of the book has a command");
}

#[test]
fn each_picture_is_shown() {
    let mut shown = String::new();
    read(&console::root().join("docs/src"), &mut shown);
    let names = DRAWN.iter().map(|(name, _)| name).chain(ON_PAGES.iter().map(|(name, ..)| name));
    for name in names.chain(&["campbell.svg", "modes.svg", "motor-chambers.svg", "synthesized.svg"]) {
        assert!(shown.contains(&format!("pictures/{name})")), "{name} is on no page of the book");
    }
}

fn read(folder: &Path, text: &mut String) {
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            read(&path, text);
        } else if path.extension().is_some_and(|ending| ending == "md") {
            text.push_str(&fs::read_to_string(&path).unwrap());
        }
    }
}
